//! What the cases are built of: tanks and channels.

use super::numerics::Numerics;
pub(crate) use crate::basin::{lattice, press, walls, water};
use crate::scene::Viscous;
use crate::{Failure, Watch};
use mps_fluid::{
    Boundary, Fluid, FluidConfig, FluidParticles, PressureForm, Shifting, Slip, Tension, Viscosity,
};
use mps_io::scene_file;
use mps_kernel::weights::WendlandGradient;
use mps_kernel::{Kernel, Real, ReferenceDensity, Vector};
use mps_neighbors::{Domain, Open, Parallel, PeriodicBox};

/// Acceleration of gravity \[m/s^2\].
pub(crate) const GRAVITY: f64 = 9.81;
/// Density of the fluid \[kg/m^3\].
pub(crate) const RHO: f64 = 1000.0;
/// Numerical sound speed over the speed of a problem, unless it needs another.
pub(crate) const SOUND: f64 = 10.0;

/// A fluid of any case; with the smooth weight unless `K` says otherwise.
pub(crate) type Water<const D: usize, V = (), P = Open, K = WendlandGradient> = Fluid<f64, D, K, V, P>;

/// Viscous fluid without a free surface, in a domain with a period.
///
/// With the weight of Wendland the viscosity is the same on a lattice and among stirred particles: its
/// measure, `sum W r^2`, is 0.2 % larger there. With the rational weight and the same radius it is
/// 4.5 % larger, and no resolution takes that away.
pub(crate) type InnerWater<T, K> = Fluid<T, 2, K, Viscous<T>, PeriodicBox<T, 2>>;

/// A tank of `counts` particles, open at the top, at rest with hydrostatic pressure.
pub(crate) fn tank<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>>(
    counts: [usize; D],
    config: FluidConfig<T, D>,
    weight: K,
    viscosity: impl FnOnce(&ReferenceDensity<T>) -> V,
) -> Result<Fluid<T, D, K, V>, Failure> {
    let l0 = config.spacing.to_double();
    let depth = T::of(counts[D - 1] as f64 * l0);
    let mut particles = FluidParticles::at_rest(lattice([0.0; D], counts, l0));
    let heaviness = -config.density * config.gravity[D - 1];
    press(&mut particles, &config, |r| heaviness * (depth - r[D - 1]));
    let boundary = walls(counts, Some(counts[D - 1] / 2), l0);
    Ok(Fluid::new(config, weight, viscosity, Open, particles, boundary)?)
}

/// Fluid that fills its domain, as all cases have it: under tension as well as under pressure, which takes corrected
/// sums and shifting to keep the particles even.
pub(crate) fn inner_water<T: Real>(l0: f64, sound_speed: f64) -> FluidConfig<T, 2> {
    let mut config = FluidConfig::water(T::of(l0), T::of(sound_speed));
    config.tension = Tension::Keep;
    config.pressure_form = PressureForm::Corrected;
    config.collisions = None;
    config.shifting = Some(Shifting::default());
    config
}

/// Water under gravity with a sound speed of `sound` times `sqrt(g H)`.
pub(crate) fn heavy_water<T: Real, const D: usize>(l0: f64, depth: f64, sound: f64) -> FluidConfig<T, D> {
    let mut config = water(l0, sound * (GRAVITY * depth).sqrt());
    config.gravity[D - 1] = T::of(-GRAVITY);
    config
}

/// Width of a channel \[m\], from wall to wall.
pub(crate) const WIDTH: f64 = 1.0;
/// Kinematic viscosity in a channel \[m^2/s\].
pub(crate) const NU: f64 = 0.1;

/// Viscous fluid at rest between walls without slip at `y = 0` and `y = WIDTH`, periodic along x.
/// The upper wall moves with `speed`, a body force accelerates the fluid by `push`.
pub(crate) fn channel<T: Real, K: Kernel<T>>(
    across: usize,
    speed: f64,
    push: f64,
    weight: K,
    numerics: &Numerics,
) -> Result<InnerWater<T, K>, Failure> {
    let columns = 10;
    let l0 = WIDTH / across as f64;
    // Largest speed of all channels: 1 m/s.
    let mut config = inner_water(l0, numerics.sound_ratio.unwrap_or(SOUND));
    config.gravity[0] = T::of(push);
    numerics.apply(&mut config);
    // As deep as the effective radius.
    let layers = config.radius_ratio.to_double().ceil() as usize;
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [columns, across], l0));
    let mut boundary = Boundary::default();
    boundary.add_wall(&lattice([0.0, -(layers as f64) * l0], [columns, layers], l0), Slip::None);
    if let Some(upper) = boundary.add_wall(&lattice([0.0, WIDTH], [columns, layers], l0), Slip::None) {
        boundary.velocity[upper].fill(Vector::from([T::of(speed), T::zero()]));
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(T::of(columns as f64 * l0)), None])?;
    let own = scene_file::Viscosity::Laminar(NU);
    let described = config.clone();
    let viscosity = |r: &_| numerics.viscous(own, &described, r);
    Ok(Fluid::new(config, weight, viscosity, domain, particles, boundary)?)
}

/// Steps to `end` \[s\] and looks before every step and at the end, unless `watch` is asked for the end before.
pub(crate) fn advance<T, const D: usize, K, V, P>(
    fluid: &mut Fluid<T, D, K, V, P>,
    parallel: &Parallel,
    watch: &Watch,
    end: f64,
    mut look: impl FnMut(&Fluid<T, D, K, V, P>),
) -> Result<(), Failure>
where
    T: Real,
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    while fluid.time().to_double() < end {
        look(fluid);
        asked(fluid.time(), watch)?;
        fluid.step(parallel)?;
    }
    look(fluid);
    Ok(())
}

/// Ends a run at this time \[s\] whose end has been asked for.
fn asked(time: impl Real, watch: &Watch) -> Result<(), Failure> {
    watch.stopped(time.to_double()).map_or(Ok(()), Err)
}

/// As [`advance`], in the central field `-omega^2 r` around the origin.
pub(crate) fn advance_in_central_field<T: Real, K: Kernel<T>, V: Viscosity<T, 2>>(
    fluid: &mut Fluid<T, 2, K, V>,
    parallel: &Parallel,
    watch: &Watch,
    omega: f64,
    end: f64,
    mut look: impl FnMut(&Fluid<T, 2, K, V>),
) -> Result<(), Failure> {
    let stiffness = T::of(-(omega * omega));
    while fluid.time().to_double() < end {
        look(fluid);
        asked(fluid.time(), watch)?;
        let dt = fluid.begin_step(parallel)?;
        fluid.add_acceleration(parallel, |r| r * stiffness);
        fluid.finish_step(parallel, dt);
    }
    look(fluid);
    Ok(())
}
