//! A clamped beam in a tank of water at rest, heavier or lighter than the water.
//!
//! The tank is open. Its free surface sets the level of the pressure, and water may rise and fall as the beam moves; under
//! a lid the level would follow from how well the lattice fills the tank, times the stiffness of the fluid.

use crate::solid::settle;
use crate::{Failure, Watch, basin};
use mps_coupling::{ElasticBody, Scene};
use mps_fluid::{Diffusion, Fluid, FluidParticles, LaminarViscosity, Slip};
use mps_kernel::weights::{WendlandC2, WendlandGradient};
use mps_kernel::{Real, Vector};
use mps_neighbors::{Open, Parallel};
use mps_solid::body::{self, Face};
use mps_solid::materials::SaintVenantKirchhoff;
use mps_solid::{MaterialPoint, Relaxation, Solid, SolidConfig};

/// Length of the beam \[m\].
pub const LENGTH: f64 = 0.35;
/// Its thickness \[m\].
pub const THICKNESS: f64 = 0.02;
/// Young's modulus \[Pa\].
pub const YOUNG: f64 = 1.4e6;
/// Poisson's ratio, in plane strain.
pub const POISSON: f64 = 0.4;
/// Density of the water \[kg/m^3\].
pub const WATER: f64 = 1000.0;
/// Acceleration of gravity \[m/s^2\].
pub const GRAVITY: f64 = 1.0;
/// Water below the beam, and above it \[m\].
pub const CLEARANCE: f64 = 0.1;
/// Water beyond its free end \[m\].
pub const BEYOND: f64 = 0.15;
/// Deflection of the end at a difference of the densities of [`DIFFERENCE`], linear elasticity \[m\].
pub const LINEAR: f64 = 0.016_852_05;
/// The same with the nonlinear strain of Saint Venant and Kirchhoff \[m\].
pub const NONLINEAR: f64 = 0.016_821_3;
/// The difference of the densities that both belong to \[kg/m^3\].
pub const DIFFERENCE: f64 = 500.0;
/// Where both are from.
pub const SOURCE: &str = "quadratic finite elements, plane strain, 140 x 8";

/// The solid of the beam.
pub type Rubber<T> = Solid<T, 2, SaintVenantKirchhoff<T>>;
/// The beam in the scene.
pub type Beam<T> = ElasticBody<T, 2, SaintVenantKirchhoff<T>>;
/// The tank.
pub type Tank<T> = Scene<T, 2, WendlandGradient, LaminarViscosity<T>>;

/// Everything that can be chosen.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Spacing of the water's particles \[m\]: half the thickness of the beam is a whole number of it.
    pub spacing: f64,
    /// Particles across the beam.
    pub across: usize,
    /// Density of the beam \[kg/m^3\].
    pub density: f64,
    /// Numerical sound speed over `sqrt(g H)`.
    pub sound_ratio: f64,
    /// Courant number of the water.
    pub cfl: f64,
    /// Effective radius over spacing.
    pub radius: f64,
    /// Strength of the density diffusion \[-\]; zero for none.
    pub diffusion: f64,
    /// Kinematic viscosity of the water \[m^2/s\].
    pub viscosity: f64,
    /// Damping of the beam's velocity \[1/s\] (`SolidConfig::damping`): nothing at rest, so it changes the way there and not the answer.
    pub damping: f64,
}

/// Kinematic viscosity of the water unless another is chosen \[m^2/s\]. Ten times as much and the last tenth of the way takes half a minute.
pub const VISCOSITY: f64 = 1e-4;
/// Strength of the density diffusion unless another is chosen \[-\], that of all water.
pub const DIFFUSION: f64 = 0.5;
/// Damping of the beam unless another is chosen \[1/s\].
pub const DAMPING: f64 = 40.0;

impl Settings {
    /// The usual numerics for a beam of `across` particles and `density` \[kg/m^3\] in water of the given spacing \[m\].
    pub fn usual(across: usize, spacing: f64, density: f64) -> Self {
        let (sound_ratio, cfl, diffusion) = (10.0, 0.5, DIFFUSION);
        let (radius, viscosity, damping) = (Self::widest(spacing), VISCOSITY, DAMPING);
        Self { spacing, across, density, sound_ratio, cfl, radius, diffusion, viscosity, damping }
    }

    /// The widest radius over `spacing` \[m\] of the usual ones that a plate as thick as the beam keeps apart: one more than its layers
    /// (`mps-fluid/tests/suite/plates.rs`).
    pub fn widest(spacing: f64) -> f64 {
        basin::RADIUS_RATIO.min((THICKNESS / spacing).round() + 1.0)
    }

    /// Depth of the water \[m\].
    pub fn depth() -> f64 {
        2.0 * CLEARANCE + THICKNESS
    }

    /// Rows of the water's particles that the side walls stand above it.
    fn rows_above(&self) -> usize {
        (Self::depth() / self.spacing).round() as usize / 4
    }

    /// Upper end of the side walls \[m\].
    pub fn top(&self) -> f64 {
        Self::depth() + self.rows_above() as f64 * self.spacing
    }

    /// Numerical sound speed \[m/s\].
    pub fn sound_speed(&self) -> f64 {
        self.sound_ratio * (GRAVITY * Self::depth()).sqrt()
    }

    /// 1 if the beam rises, -1 if it sinks.
    pub fn direction(&self) -> f64 {
        if self.density < WATER { 1.0 } else { -1.0 }
    }

    /// What linear elasticity says of the deflection \[m\], which is in proportion to the difference of the densities.
    pub fn linear(&self) -> f64 {
        LINEAR * (self.density - WATER).abs() / DIFFERENCE
    }
}

/// The tank full of water at rest, the beam straight, everything let go at `t = 0`.
///
/// # Errors
/// If the numbers make no scene.
pub fn build<T: Real>(settings: &Settings, parallel: &Parallel) -> Result<Tank<T>, Failure> {
    let mut scene = Scene::new(water(settings)?);
    let beam = ElasticBody::new(beam::<T>(settings, parallel)?);
    scene.add_structure(parallel, Box::new(beam), Slip::None)?;
    Ok(scene)
}

/// How far the end of the beam has moved the way it is pushed \[m\]; zero if the scene has no beam.
pub fn deflection<T: Real>(scene: &Tank<T>, end: &MaterialPoint<T, 2>, settings: &Settings) -> f64 {
    rubber(scene).map_or(0.0, |solid| moved(solid, end, settings))
}

/// The beam's solid.
pub fn rubber<T: Real>(scene: &Tank<T>) -> Option<&Rubber<T>> {
    Some(scene.structure(0)?.as_any().downcast_ref::<Beam<T>>()?.solid())
}

/// The middle of the free end.
///
/// # Errors
/// If the solid is not that of the beam.
pub fn end<T: Real>(solid: &Rubber<T>) -> Result<MaterialPoint<T, 2>, Failure> {
    Ok(solid.point(Vector::from([LENGTH, CLEARANCE + 0.5 * THICKNESS].map(T::of)))?)
}

/// Deflection of the same solid at rest without the water, under the weight less the buoyancy \[m\]: what is left of the
/// difference to it is the coupling's. `watch` shows how far it is, and may end it.
///
/// # Errors
/// If it does not come to rest, or is asked to end before.
pub fn dry_deflection<T: Real>(
    settings: &Settings,
    parallel: &Parallel,
    watch: &Watch,
) -> Result<f64, Failure> {
    let net = GRAVITY * (WATER / settings.density - 1.0);
    if net == 0.0 {
        // Straight. What is left of the forces is measured against the load, and there is none.
        return Ok(0.0);
    }
    let mut solid = beam::<T>(settings, parallel)?;
    let end = end(&solid)?;
    let dt = solid.max_step(parallel).to_double();
    // About as long as it takes: some periods, which grow with the root of the mass.
    let mut progress = watch.progress(4.0 * (settings.density / WATER).sqrt());
    let mut steps = 0;
    let net = Vector::from([0.0, net].map(T::of));
    settle(&mut solid, parallel, &net, &Relaxation::default(), |_| {
        let time = steps as f64 * dt;
        progress.update(time, steps, dt, "the same beam without water");
        steps += 1;
        // A step takes some microseconds: not in each.
        if steps % 64 == 1 { watch.stopped(time).map_or(Ok(()), Err) } else { Ok(()) }
    })?;
    progress.finish(steps as f64 * dt, steps);
    Ok(moved(&solid, &end, settings))
}

fn moved<T: Real>(solid: &Rubber<T>, end: &MaterialPoint<T, 2>, settings: &Settings) -> f64 {
    settings.direction() * (end.value(solid.positions()) - end.reference())[1].to_double()
}

fn water<T: Real>(
    settings: &Settings,
) -> Result<Fluid<T, 2, WendlandGradient, LaminarViscosity<T>>, Failure> {
    let l0 = settings.spacing;
    let mut config = basin::water(l0, settings.sound_speed());
    config.radius_ratio = T::of(settings.radius);
    config.cfl = T::of(settings.cfl);
    config.diffusion = Diffusion::filter(settings.diffusion);
    config.gravity = Vector::from([0.0, -GRAVITY].map(T::of));
    let counts = [LENGTH + BEYOND, Settings::depth()].map(|edge| (edge / l0).round() as usize);
    let in_beam = |r: &Vector<T, 2>| {
        let [x, y] = [r[0].to_double(), r[1].to_double() - CLEARANCE];
        x < LENGTH && y > 0.0 && y < THICKNESS
    };
    let places = basin::lattice([0.0; 2], counts, l0).into_iter().filter(|r| !in_beam(r)).collect();
    let mut particles = FluidParticles::at_rest(places);
    basin::press(&mut particles, &config, |r| T::of(WATER * GRAVITY) * (T::of(Settings::depth()) - r[1]));
    let walls = basin::walls(counts, Some(settings.rows_above()), l0);
    let viscosity = |reference: &_| LaminarViscosity::new::<2>(T::of(settings.viscosity), reference);
    Ok(Fluid::new(config, WendlandGradient, viscosity, Open, particles, walls)?)
}

fn beam<T: Real>(settings: &Settings, parallel: &Parallel) -> Result<Rubber<T>, Failure> {
    let clamp = [Face::lower(0)];
    let lower = Vector::from([0.0, CLEARANCE].map(T::of));
    let upper = Vector::from([LENGTH, CLEARANCE + THICKNESS].map(T::of));
    let mut counts = body::counts(&lower, &upper, T::of(THICKNESS / settings.across as f64), &clamp);
    counts[1] = settings.across;
    let block = body::block(lower, upper, counts, &clamp)?;
    let material = SaintVenantKirchhoff::new(T::of(YOUNG), T::of(POISSON))?;
    let config = SolidConfig { damping: T::of(settings.damping), ..SolidConfig::default() };
    let density = T::of(settings.density);
    Ok(Solid::new(block.particles, block.spacing, density, material, WendlandC2, config, parallel)?)
}
