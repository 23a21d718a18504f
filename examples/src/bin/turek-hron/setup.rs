//! Fluid, bodies and numerics of case 3.

use crate::geometry::{self, HEIGHT};
use crate::reference::Test;
use mps_coupling::{ElasticBody, Fixed, Scene};
use mps_examples::Failure;
use mps_examples::solid::flag::{Clamp, RUBBER, THICKNESS, flag_of};
use mps_fluid::{
    Boundary, CompactViscosity, Diffusion, Fluid, FluidConfig, FluidParticles, Inlet, Opening, Outlet,
    PressureForm, Shifting, Slip, Tension,
};
use mps_kernel::weights::WendlandGradient;
use mps_kernel::{Real, Vector};
use mps_neighbors::{Open, Parallel};
use mps_solid::materials::{Ambient, SaintVenantKirchhoff};

/// Kinematic viscosity of the fluid \[m^2/s\].
pub(crate) const VISCOSITY: f64 = 1e-3;
/// Its density \[kg/m^3\].
pub(crate) const DENSITY: f64 = 1000.0;
/// Time in which the inflow comes up to speed \[s\].
pub(crate) const RAMP: f64 = 2.0;
/// The cylinder's place among the structures.
pub(crate) const CYLINDER: usize = 0;
/// The flag's.
pub(crate) const FLAG: usize = 1;

/// The channel.
pub(crate) type Channel<T> = Scene<T, 2, WendlandGradient, CompactViscosity<T>>;
/// The elastic flag.
pub(crate) type Flag<T> = ElasticBody<T, 2, Ambient<SaintVenantKirchhoff<T>, T>>;

/// Everything the command line can change.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    pub(crate) test: Test,
    /// Spacing of the fluid particles \[m\].
    pub(crate) spacing: f64,
    /// Particles across the flag.
    pub(crate) across: usize,
    /// Simulated time \[s\].
    pub(crate) end_time: f64,
    /// Length of the channel \[m\].
    pub(crate) length: f64,
    /// Numerical sound speed over twice the mean inflow.
    pub(crate) sound_ratio: f64,
    /// Courant number of the fluid.
    pub(crate) cfl: f64,
    /// Effective radius over spacing.
    pub(crate) radius: f64,
    /// Level of the pressure over `rho u^2` of the mean inflow.
    pub(crate) level: f64,
    /// Strength of the density diffusion, 0 for none.
    pub(crate) diffusion: f64,
    /// Parts of the particle shifting in a step, 0 for none.
    pub(crate) shifting: u32,
    /// Share of the difference to the packing by which a density changes while sound passes a spacing.
    pub(crate) relaxation: f64,
}

impl Settings {
    /// Layers of points in a wall.
    pub(crate) fn layers(&self) -> usize {
        self.radius.ceil() as usize + 1
    }

    /// Numerical sound speed \[m/s\]. Beside the cylinder the flow is about twice as fast as on average.
    pub(crate) fn sound_speed(&self) -> f64 {
        self.sound_ratio * 2.0 * self.test.inflow()
    }

    /// The time in which the inflow passes the diameter of the cylinder \[s\].
    pub(crate) fn passage(&self) -> f64 {
        0.1 / self.test.inflow()
    }

    /// Level of the pressure \[Pa\]: that beyond the outlet. High enough that no vortex pulls.
    pub(crate) fn level(&self) -> f64 {
        self.level * DENSITY * self.test.inflow().powi(2)
    }
}

/// The channel full of water at rest, cylinder and flag in it.
pub(crate) fn build<T: Real>(settings: &Settings, parallel: &Parallel) -> Result<Channel<T>, Failure> {
    let mut scene = Scene::new(water(settings)?);
    let (places, areas) = geometry::cylinder(settings);
    let cylinder = Fixed::new(places, areas, T::of(settings.spacing));
    scene.add_structure(parallel, Box::new(cylinder), Slip::None)?;
    let rubber = settings.test.rubber().unwrap_or(RUBBER);
    let material = Ambient {
        material: SaintVenantKirchhoff::new(T::of(rubber.young), T::of(rubber.poisson))?,
        pressure: T::of(settings.level()),
    };
    let flag = flag_of::<T, _>(settings.across, Clamp::Arc, rubber.density, material, parallel)?;
    if settings.test.rubber().is_some() {
        scene.add_structure(parallel, Box::new(ElasticBody::new(flag)), Slip::None)?;
    } else {
        let spacing = T::of(THICKNESS / settings.across as f64);
        let rigid = Fixed::new(flag.positions().to_vec(), flag.volumes().to_vec(), spacing);
        scene.add_structure(parallel, Box::new(rigid), Slip::None)?;
    }
    Ok(scene)
}

fn water<T: Real>(
    settings: &Settings,
) -> Result<Fluid<T, 2, WendlandGradient, CompactViscosity<T>>, Failure> {
    let mut config = FluidConfig::water(T::of(settings.spacing), T::of(settings.sound_speed()));
    config.radius_ratio = T::of(settings.radius);
    config.cfl = T::of(settings.cfl);
    config.tension = Tension::Keep;
    config.collisions = None;
    let level = T::of(settings.level());
    config.background_pressure = level;
    config.pressure_form = PressureForm::Corrected;
    config.diffusion = Diffusion::filter(settings.diffusion);
    config.shifting =
        (settings.shifting > 0).then(|| Shifting { iterations: settings.shifting, ..Shifting::default() });
    config.density_relaxation = T::of(settings.relaxation);
    let particles = FluidParticles::at_rest(geometry::water(settings));
    let mut boundary = Boundary::default();
    boundary.add_wall(&geometry::walls(settings), Slip::None);
    let viscosity = |reference: &_| CompactViscosity::new::<2>(T::of(VISCOSITY), reference);
    let mut fluid = Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary)?;
    let mean = settings.test.inflow();
    fluid.add_inlet(Inlet::new(across_the_channel(0.0), move |place: &Vector<T, 2>, time: T| {
        T::of(inflow(mean, place[1].to_double(), time.to_double()))
    }))?;
    let outlet = Outlet::absorbing(across_the_channel(settings.length));
    fluid.add_outlet(Outlet { pressure: level, ..outlet })?;
    Ok(fluid)
}

/// Speed \[m/s\] at height `y` \[m\]: a parabola, with a smooth start (Turek and Hron 2006).
fn inflow(mean: f64, y: f64, time: f64) -> f64 {
    let ramp = if time < RAMP { 0.5 * (1.0 - (core::f64::consts::PI * time / RAMP).cos()) } else { 1.0 };
    ramp * 1.5 * mean * 4.0 * y * (HEIGHT - y) / (HEIGHT * HEIGHT)
}

fn across_the_channel<T: Real>(at: f64) -> Opening<T, 2> {
    Opening {
        axis: 0,
        at: T::of(at),
        forward: true,
        lower: Vector::zeros(),
        upper: Vector::from([T::zero(), T::of(HEIGHT)]),
    }
}
