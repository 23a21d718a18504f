//! An elastic bottom of a tank: how far it sags under the water.

use crate::case::{Case, Measure, Outcome, Pace};
use mps_coupling::{ElasticBody, Scene};
use mps_examples::Failure;
use mps_examples::basin::{RADIUS_RATIO, lattice, press, water};
use mps_fluid::{ArtificialViscosity, Boundary, Fluid, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::{WendlandC2, WendlandGradient};
use mps_neighbors::{Open, Parallel};
use mps_solid::body::{Face, block, counts};
use mps_solid::materials::SaintVenantKirchhoff;
use mps_solid::{Relaxation, Solid, SolidConfig};

pub(crate) struct Plate;

/// Length and thickness of the plate, depth of the water \[m\].
const LENGTH: f64 = 1.0;
const THICKNESS: f64 = 0.1;
const DEPTH: f64 = 0.5;
const RHO: f64 = 1000.0;
const GRAVITY: f64 = 9.81;
const YOUNG: f64 = 1e8;
const POISSON: f64 = 0.4;
/// Damping of the plate on its way to rest \[1/s\].
const DAMPING: f64 = 100.0;
const THEORY: &str = "analytic: Timoshenko, clamped at both ends, plane strain";

type Bottom = Solid<f64, 2, SaintVenantKirchhoff<f64>>;

/// Sag of the middle by bending and shear, under water and its own weight \[m\].
fn exact() -> f64 {
    let load = RHO * GRAVITY * (DEPTH + THICKNESS);
    let bending = YOUNG * THICKNESS.powi(3) / (12.0 * (1.0 - POISSON * POISSON));
    // Shear coefficient of the rectangle, 5/6.
    let shear = 5.0 / 6.0 * YOUNG / (2.0 * (1.0 + POISSON)) * THICKNESS;
    load * (LENGTH.powi(4) / (384.0 * bending) + LENGTH.powi(2) / (8.0 * shear))
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
        let dry = {
            let mut plate = bottom(n, parallel)?;
            let middle = plate.point(Vector::from([0.5 * LENGTH, -0.5 * THICKNESS]))?;
            let load = Vector::from([0.0, -GRAVITY * (1.0 + DEPTH / THICKNESS)]);
            plate.relax(parallel, &load, |_, _| (), &Relaxation::default())?;
            middle.reference().y - middle.value(plate.positions()).y
        };
        let mut scene = tank(n, parallel)?;
        let (mut sum, mut samples) = (0.0, 0.0);
        while scene.fluid().time() < 0.6 {
            scene.step(parallel, f64::INFINITY)?;
            if scene.fluid().time() > 0.5 {
                let plate = scene.structure(0).and_then(|body| {
                    body.as_any().downcast_ref::<ElasticBody<f64, 2, SaintVenantKirchhoff<f64>>>()
                });
                let plate = plate.ok_or("the scene has no plate")?.solid();
                let middle = plate.point(Vector::from([0.5 * LENGTH, -0.5 * THICKNESS]))?;
                sum += middle.reference().y - middle.value(plate.positions()).y;
                samples += 1.0;
            }
        }
        let sag = sum / samples;
        Ok(Outcome {
            measures: vec![
                Measure::new("sag", "m", sag, exact(), THEORY),
                Measure::new("over the same solid without water", "m", sag, dry, "the same solid at rest")
                    .within(0.01, 4),
            ],
            curves: Vec::new(),
        })
    }
}

fn bottom(n: usize, parallel: &Parallel) -> Result<Bottom, Failure> {
    let clamp = [Face::lower(0), Face::upper(0)];
    let (lower, upper) = (Vector::from([0.0, -THICKNESS]), Vector::from([LENGTH, 0.0]));
    let mut counts = counts(&lower, &upper, THICKNESS / n as f64, &clamp);
    counts[1] = n;
    let body = block(lower, upper, counts, &clamp)?;
    let material = SaintVenantKirchhoff::new(YOUNG, POISSON)?;
    let config = SolidConfig { damping: DAMPING, ..SolidConfig::default() };
    Ok(Solid::new(body.particles, body.spacing, RHO, material, WendlandC2, config, parallel)?)
}

type Tank = Scene<f64, 2, WendlandGradient, ArtificialViscosity<f64>>;

fn tank(n: usize, parallel: &Parallel) -> Result<Tank, Failure> {
    let l0 = THICKNESS / n as f64;
    let mut config = water(l0, 10.0 * (GRAVITY * DEPTH).sqrt());
    config.gravity = Vector::from([0.0, -GRAVITY]);
    let [columns, rows] = [LENGTH, DEPTH].map(|edge| (edge / l0).round() as usize);
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [columns, rows], l0));
    press(&mut particles, &config, |r| RHO * GRAVITY * (DEPTH - r.y));
    // Two walls, of points at half the spacing, and nothing but the plate below.
    let layers = RADIUS_RATIO as usize;
    let side = |x: f64| {
        let height = 2 * (rows + 2 * layers);
        lattice([x, -(layers as f64) * l0], [2 * layers, height], 0.5 * l0)
    };
    let mut walls: Vec<Vector<f64, 2>> = side(-(layers as f64) * l0);
    walls.extend(side(LENGTH));
    let mut boundary = Boundary::default();
    boundary.add_fine_wall(&walls, 0.25, Slip::Free);
    let c = config.sound_speed;
    let viscosity = |reference: &_| ArtificialViscosity::new::<2>(0.1, c, reference);
    let fluid = Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary)?;
    let mut scene = Scene::new(fluid);
    scene.add_structure(parallel, Box::new(ElasticBody::new(bottom(n, parallel)?)), Slip::Free)?;
    Ok(scene)
}
