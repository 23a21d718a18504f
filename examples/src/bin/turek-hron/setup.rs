//! Fluid, bodies and numerics of case 3.

use crate::geometry::{self, HEIGHT};
use crate::reference::Test;
use mps_coupling::{ElasticBody, Fixed, Scene};
use mps_examples::Failure;
use mps_examples::solid::flag::{Clamp, Rubber, THICKNESS, flag};
use mps_fluid::{
    Boundary, Fluid, FluidConfig, FluidParticles, Inlet, LaminarViscosity, Opening, Outlet, PressureForm,
    Shifting, Slip, Tension,
};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Real, Vector};
use mps_neighbors::{Open, Parallel};
use mps_solid::materials::SaintVenantKirchhoff;

/// Kinematic viscosity of the fluid \[m^2/s\].
const VISCOSITY: f64 = 1e-3;
/// Time in which the inflow comes up to speed \[s\].
const RAMP: f64 = 2.0;
/// The cylinder's place among the structures.
pub(crate) const CYLINDER: usize = 0;
/// The flag's.
pub(crate) const FLAG: usize = 1;

/// The channel.
pub(crate) type Channel<T> = Scene<T, 2, WendlandC2, LaminarViscosity<T>>;
/// The elastic flag.
pub(crate) type Flag<T> = ElasticBody<T, 2, SaintVenantKirchhoff<T>>;

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
    /// Strength of the shifting.
    pub(crate) shifting: f64,
    /// Parts of the shifting in a step.
    pub(crate) parts: u32,
}

impl Settings {
    /// Effective radius over spacing.
    pub(crate) const RADIUS: f64 = 3.0;

    /// Layers of points in a wall.
    pub(crate) fn layers(&self) -> usize {
        Self::RADIUS.ceil() as usize + 1
    }

    /// Numerical sound speed \[m/s\]. Beside the cylinder the flow is about twice as fast as on average.
    pub(crate) fn sound_speed(&self) -> f64 {
        self.sound_ratio * 2.0 * self.test.inflow()
    }
}

/// The channel full of water at rest, cylinder and flag in it.
pub(crate) fn build<T: Real>(settings: &Settings, parallel: &Parallel) -> Result<Channel<T>, Failure> {
    let mut scene = Scene::new(water(settings)?);
    let (places, areas) = geometry::cylinder(settings);
    let cylinder = Fixed::new(places, areas, T::of(settings.spacing));
    scene.add_structure(parallel, Box::new(cylinder), Slip::None)?;
    let rubber = settings.test.rubber();
    let rigid = Rubber { density: 1000.0, young: 1.0e6, poisson: 0.4 };
    let flag = flag::<T>(settings.across, Clamp::Arc, &rubber.unwrap_or(rigid), parallel)?;
    if rubber.is_some() {
        scene.add_structure(parallel, Box::new(ElasticBody::new(flag)), Slip::None)?;
    } else {
        let spacing = T::of(THICKNESS / settings.across as f64);
        let rigid = Fixed::new(flag.positions().to_vec(), flag.volumes().to_vec(), spacing);
        scene.add_structure(parallel, Box::new(rigid), Slip::None)?;
    }
    Ok(scene)
}

fn water<T: Real>(settings: &Settings) -> Result<Fluid<T, 2, WendlandC2, LaminarViscosity<T>>, Failure> {
    let mut config = FluidConfig::water(T::of(settings.spacing), T::of(settings.sound_speed()));
    config.radius_ratio = T::of(Settings::RADIUS);
    config.cfl = T::of(settings.cfl);
    config.tension = Tension::Keep;
    config.pressure_form = PressureForm::Corrected;
    config.collisions = None;
    config.shifting = (settings.parts > 0)
        .then(|| Shifting { strength: T::of(settings.shifting), iterations: settings.parts });
    let particles = FluidParticles::at_rest(geometry::water(settings));
    let mut boundary = Boundary::default();
    boundary.add_wall(&geometry::walls(settings), Slip::None);
    let viscosity = |reference: &_| LaminarViscosity::new::<2>(T::of(VISCOSITY), reference);
    let mut fluid = Fluid::new(config, WendlandC2, viscosity, Open, particles, boundary)?;
    let mean = settings.test.inflow();
    fluid.add_inlet(Inlet::new(across_the_channel(0.0), move |place: &Vector<T, 2>, time: T| {
        T::of(inflow(mean, place[1].to_double(), time.to_double()))
    }))?;
    fluid.add_outlet(Outlet::absorbing(across_the_channel(settings.length)))?;
    Ok(fluid)
}

/// Speed \[m/s\] at height `y` \[m\].
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
