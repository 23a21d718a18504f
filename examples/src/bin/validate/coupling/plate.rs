//! An elastic bottom of a tank, in the plane and in space: how far it sags under the water.

use mps_coupling::{ElasticBody, Scene};
use mps_examples::Failure;
use mps_examples::basin::{RADIUS_RATIO, lattice, press, water};
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_fluid::{ArtificialViscosity, Boundary, Fluid, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::{WendlandC2, WendlandGradient};
use mps_neighbors::{Open, Parallel};
use mps_solid::body::{Face, block, counts};
use mps_solid::materials::SaintVenantKirchhoff;
use mps_solid::{Relaxation, Solid, SolidConfig};

/// A strip of a long plate, in the plane.
pub(crate) struct Plate;
/// A square plate, in space.
pub(crate) struct Square;

/// Thickness of the plate \[m\].
const THICKNESS: f64 = 0.1;
const RHO: f64 = 1000.0;
const GRAVITY: f64 = 9.81;
const YOUNG: f64 = 1e8;
const POISSON: f64 = 0.4;
/// Damping of the plate on its way to rest \[1/s\].
const DAMPING: f64 = 100.0;
const THEORY: &str = "analytic: Timoshenko, clamped at both ends, plane strain";

type Bottom<const D: usize> = Solid<f64, D, SaintVenantKirchhoff<f64>>;
type Tank<const D: usize> = Scene<f64, D, WendlandGradient, ArtificialViscosity<f64>>;

/// Length of the plate along every side, and depth of the water \[m\].
#[derive(Clone, Copy)]
struct Size {
    length: f64,
    depth: f64,
}

const STRIP: Size = Size { length: 1.0, depth: 0.5 };
const SQUARE: Size = Size { length: 0.5, depth: 0.25 };

/// Sag of the middle by bending and shear, under water and its own weight \[m\].
fn exact() -> f64 {
    let Size { length, depth } = STRIP;
    let load = RHO * GRAVITY * (depth + THICKNESS);
    let bending = YOUNG * THICKNESS.powi(3) / (12.0 * (1.0 - POISSON * POISSON));
    // Shear coefficient of the rectangle, 5/6.
    let shear = 5.0 / 6.0 * YOUNG / (2.0 * (1.0 + POISSON)) * THICKNESS;
    load * (length.powi(4) / (384.0 * bending) + length.powi(2) / (8.0 * shear))
}

impl Case for Plate {
    fn name(&self) -> &'static str {
        "plate"
    }

    fn about(&self) -> &'static str {
        "The bottom of a tank 1 m wide is an elastic plate 0.1 m thick (E = 100 MPa, nu = 0.4, 1000 kg/m3), clamped at both ends and let go under \
         0.5 m of water. Sag of its middle, mean of the last 0.1 s of 0.6 s; plate and water of one spacing, artificial viscosity 0.1, the \
         plate's velocity damped by 100 1/s. The theory of beams has an error of its own of some percent at ten times the thickness; what the coupling adds is the \
         difference to the same solid under the same load without water."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![4], vec![4, 6, 8])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let [wet, dry] = [sag::<2>(STRIP, n, parallel)?, dry_sag::<2>(STRIP, n, parallel)?];
        Ok(Outcome {
            measures: vec![
                Measure::new("sag", "m", wet, exact(), THEORY),
                Measure::new(OVER_DRY, "m", wet, dry, "the same solid at rest").within(0.01, 4),
            ],
            ..Outcome::default()
        })
    }
}

impl Case for Square {
    fn name(&self) -> &'static str {
        "square-plate"
    }

    fn about(&self) -> &'static str {
        "The same in space: the bottom of a tank 0.5 m wide and deep is a square plate, clamped along all four edges, under 0.25 m of water."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![2], vec![2, 4])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let [wet, dry] = [sag::<3>(SQUARE, n, parallel)?, dry_sag::<3>(SQUARE, n, parallel)?];
        let measure = Measure::new(OVER_DRY, "m", wet, dry, "the same solid at rest");
        Ok(Outcome::new(vec![measure], Vec::new()))
    }
}

const OVER_DRY: &str = "over the same solid without water";

/// Height of the middle of the plate at rest less its present one \[m\].
fn below<const D: usize>(plate: &Bottom<D>, size: Size) -> Result<f64, Failure> {
    let middle = Vector::from_fn(|axis, _| if axis == D - 1 { -0.5 * THICKNESS } else { 0.5 * size.length });
    let middle = plate.point(middle)?;
    Ok(middle.reference()[D - 1] - middle.value(plate.positions())[D - 1])
}

/// Under the weight of the water spread over the body, at rest \[m\].
fn dry_sag<const D: usize>(size: Size, n: usize, parallel: &Parallel) -> Result<f64, Failure> {
    let mut plate = bottom::<D>(size, n, parallel)?;
    let load = upwards(-GRAVITY * (1.0 + size.depth / THICKNESS));
    plate.relax(parallel, &load, |_, _| (), &Relaxation::default())?;
    below(&plate, size)
}

/// Under the water, mean of the last 0.1 s of 0.6 s \[m\].
fn sag<const D: usize>(size: Size, n: usize, parallel: &Parallel) -> Result<f64, Failure> {
    let mut scene = tank::<D>(size, n, parallel)?;
    let (mut sum, mut samples) = (0.0, 0.0);
    while scene.fluid().time() < 0.6 {
        scene.step(parallel, f64::INFINITY)?;
        if scene.fluid().time() > 0.5 {
            let plate = scene.structure(0).and_then(|body| {
                body.as_any().downcast_ref::<ElasticBody<f64, D, SaintVenantKirchhoff<f64>>>()
            });
            sum += below(plate.ok_or("the scene has no plate")?.solid(), size)?;
            samples += 1.0;
        }
    }
    Ok(sum / samples)
}

/// A vector along the last axis.
fn upwards<const D: usize>(value: f64) -> Vector<f64, D> {
    Vector::from_fn(|axis, _| if axis == D - 1 { value } else { 0.0 })
}

fn bottom<const D: usize>(size: Size, n: usize, parallel: &Parallel) -> Result<Bottom<D>, Failure> {
    let clamp: Vec<_> = (0..D - 1).flat_map(|axis| [Face::lower(axis), Face::upper(axis)]).collect();
    let (lower, mut upper) = (upwards(-THICKNESS), Vector::repeat(size.length));
    upper[D - 1] = 0.0;
    let mut counts = counts(&lower, &upper, THICKNESS / n as f64, &clamp);
    counts[D - 1] = n;
    let body = block(lower, upper, counts, &clamp)?;
    let material = SaintVenantKirchhoff::new(YOUNG, POISSON)?;
    let config = SolidConfig { damping: DAMPING, ..SolidConfig::default() };
    Ok(Solid::new(body.particles, body.spacing, RHO, material, WendlandC2, config, parallel)?)
}

fn tank<const D: usize>(size: Size, n: usize, parallel: &Parallel) -> Result<Tank<D>, Failure> {
    let l0 = THICKNESS / n as f64;
    let mut config = water(l0, 10.0 * (GRAVITY * size.depth).sqrt());
    config.gravity = upwards(-GRAVITY);
    let [columns, rows] = [size.length, size.depth].map(|edge| (edge / l0).round() as usize);
    let mut water = [columns; D];
    water[D - 1] = rows;
    let mut particles = FluidParticles::at_rest(lattice([0.0; D], water, l0));
    press(&mut particles, &config, |r| RHO * GRAVITY * (size.depth - r[D - 1]));
    // Walls of points at half the spacing all around, and nothing but the plate below.
    let layers = RADIUS_RATIO as usize;
    let mut around = [2 * (columns + 2 * layers); D];
    around[D - 1] = 2 * (rows + 2 * layers);
    let outside = |r: &Vector<f64, D>| (0..D - 1).any(|axis| r[axis] < 0.0 || r[axis] > size.length);
    let walls = lattice([-(layers as f64) * l0; D], around, 0.5 * l0);
    let walls: Vec<Vector<f64, D>> = walls.into_iter().filter(outside).collect();
    let mut boundary = Boundary::default();
    boundary.add_fine_wall(&walls, 0.5_f64.powi(D as i32), Slip::Free);
    let c = config.sound_speed;
    let viscosity = |reference: &_| ArtificialViscosity::new::<D>(0.1, c, reference);
    let fluid = Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary)?;
    let mut scene = Scene::new(fluid);
    scene.add_structure(parallel, Box::new(ElasticBody::new(bottom(size, n, parallel)?)), Slip::Free)?;
    Ok(scene)
}
