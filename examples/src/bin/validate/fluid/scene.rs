//! What the cases are built of: tanks and channels.

use mps_examples::Failure;
pub(crate) use mps_examples::basin::{lattice, press, walls, water};
use mps_fluid::{
    Boundary, Fluid, FluidConfig, FluidParticles, LaminarViscosity, PressureForm, Shifting, Slip, Tension,
    Viscosity,
};
use mps_kernel::weights::{WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, ReferenceDensity, Vector};
use mps_neighbors::{Domain, Open, Parallel, PeriodicBox};

/// Acceleration of gravity \[m/s^2\].
pub(crate) const GRAVITY: f64 = 9.81;
/// Density of the fluid \[kg/m^3\].
pub(crate) const RHO: f64 = 1000.0;
/// Layers of points of the walls of a channel, as deep as the effective radius.
const CHANNEL_LAYERS: usize = 3;

/// A fluid of any case; with the smooth weight unless `K` says otherwise.
pub(crate) type Water<const D: usize, V = (), P = Open, K = WendlandGradient> = Fluid<f64, D, K, V, P>;

/// Viscous fluid without a free surface, in a domain with a period.
///
/// With the weight of Wendland the viscosity is the same on a lattice and among stirred particles: its
/// measure, `sum W r^2`, is 0.2 % larger there. With the rational weight and the same radius it is
/// 4.5 % larger, and no resolution takes that away.
pub(crate) type InnerWater = Water<2, LaminarViscosity<f64>, PeriodicBox<f64, 2>, WendlandC2>;

/// A tank of `counts` particles, open at the top, at rest with hydrostatic pressure.
pub(crate) fn tank<const D: usize, V: Viscosity<f64, D>>(
    counts: [usize; D],
    config: FluidConfig<f64, D>,
    viscosity: impl FnOnce(&ReferenceDensity<f64>) -> V,
) -> Result<Water<D, V>, Failure> {
    let l0 = config.spacing;
    let depth = counts[D - 1] as f64 * l0;
    let mut particles = FluidParticles::at_rest(lattice([0.0; D], counts, l0));
    let weight = -config.density * config.gravity[D - 1];
    press(&mut particles, &config, |r| weight * (depth - r[D - 1]));
    let boundary = walls(counts, Some(counts[D - 1] / 2), l0);
    Ok(Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary)?)
}

/// Fluid that fills its domain, as all cases have it: under tension as well as under pressure, which takes corrected
/// sums and shifting to keep the particles even.
pub(crate) fn inner_water(l0: f64, sound_speed: f64) -> FluidConfig<f64, 2> {
    let mut config = FluidConfig::water(l0, sound_speed);
    config.tension = Tension::Keep;
    config.pressure_form = PressureForm::Corrected;
    config.collisions = None;
    config.shifting = Some(Shifting::default());
    config
}

/// Water under gravity with a sound speed of ten times `sqrt(g H)`.
pub(crate) fn heavy_water<const D: usize>(l0: f64, depth: f64) -> FluidConfig<f64, D> {
    let mut config = water(l0, 10.0 * (GRAVITY * depth).sqrt());
    config.gravity[D - 1] = -GRAVITY;
    config
}

/// Width of a channel \[m\], from wall to wall.
pub(crate) const WIDTH: f64 = 1.0;
/// Kinematic viscosity in a channel \[m^2/s\].
pub(crate) const NU: f64 = 0.1;

/// Viscous fluid at rest between walls without slip at `y = 0` and `y = WIDTH`, periodic along x.
/// The upper wall moves with `speed`, a body force accelerates the fluid by `push`.
pub(crate) fn channel(across: usize, speed: f64, push: f64) -> Result<InnerWater, Failure> {
    let columns = 10;
    let l0 = WIDTH / across as f64;
    let mut config = inner_water(l0, 10.0);
    config.gravity[0] = push;
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [columns, across], l0));
    let mut boundary = Boundary::default();
    boundary
        .add_wall(&lattice([0.0, -(CHANNEL_LAYERS as f64) * l0], [columns, CHANNEL_LAYERS], l0), Slip::None);
    if let Some(upper) = boundary.add_wall(&lattice([0.0, WIDTH], [columns, CHANNEL_LAYERS], l0), Slip::None)
    {
        boundary.velocity[upper].fill(Vector::from([speed, 0.0]));
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(columns as f64 * l0), None])?;
    let viscosity = |r: &_| LaminarViscosity::new::<2>(NU, r);
    Ok(Fluid::new(config, WendlandC2, viscosity, domain, particles, boundary)?)
}

/// Steps to `end` \[s\] and looks before every step and at the end.
pub(crate) fn advance<const D: usize, K, V, P>(
    fluid: &mut Water<D, V, P, K>,
    parallel: &Parallel,
    end: f64,
    mut look: impl FnMut(&Water<D, V, P, K>),
) -> Result<(), Failure>
where
    K: Kernel<f64>,
    V: Viscosity<f64, D>,
    P: Domain<f64, D>,
{
    while fluid.time() < end {
        look(fluid);
        fluid.step(parallel)?;
    }
    look(fluid);
    Ok(())
}

/// Steps to `end` \[s\] in the central field `-omega^2 r` around the origin.
pub(crate) fn advance_in_central_field<V: Viscosity<f64, 2>>(
    fluid: &mut Water<2, V>,
    parallel: &Parallel,
    omega: f64,
    end: f64,
    mut look: impl FnMut(&Water<2, V>),
) -> Result<(), Failure> {
    while fluid.time() < end {
        look(fluid);
        let dt = fluid.begin_step(parallel)?;
        fluid.add_acceleration(parallel, |r| r * -(omega * omega));
        fluid.finish_step(parallel, dt);
    }
    look(fluid);
    Ok(())
}
