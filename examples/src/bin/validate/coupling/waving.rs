//! A plate that waves between two layers of viscous water: its frequency and its decay.

use super::layer::Layered;
use core::f64::consts::PI;
use mps_coupling::Scene;
use mps_examples::basin::lattice;
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_examples::series::zeros;
use mps_examples::{Failure, Waving};
use mps_fluid::{
    Boundary, CompactViscosity, Diffusion, Fluid, FluidConfig, FluidParticles, PressureForm, Shifting, Slip,
    Tension,
};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Parallel, PeriodicBox};

pub(crate) struct WavingPlate;

/// Length of the wave, thickness of the plate \[m\].
const LENGTH: f64 = 0.5;
const THICKNESS: f64 = 0.02;
/// Depth of either layer \[m\], its density \[kg/m^3\] and viscosity \[m^2/s\].
const DEPTH: f64 = 0.2;
const RHO: f64 = 1000.0;
const VISCOSITY: f64 = 1e-3;
/// Frequency without viscosity \[rad/s\].
const OMEGA: f64 = 34.0;
/// Amplitude at the start \[m\]: linear, a tenth of the thickness.
const AMPLITUDE: f64 = 2e-3;
/// Speed of sound \[m/s\] and level of the pressure \[Pa\]: those of the channel.
const SOUND: f64 = 40.0;
const LEVEL: f64 = 8000.0;
const LAW: &str = "analytic: linearised Navier-Stokes equations";

/// The plate, with the stiffness that belongs to the frequency.
fn plate() -> Layered {
    let k = 2.0 * PI / LENGTH;
    let free = Layered {
        k,
        depth: DEPTH,
        density: RHO,
        viscosity: VISCOSITY,
        mass: RHO * THICKNESS,
        stiffness: 0.0,
    };
    Layered { stiffness: OMEGA * OMEGA * (free.mass + 2.0 * free.added()), ..free }
}

/// Water with the numerics of the channel of Turek and Hron, moving as a potential flow does beside the plate.
fn water(l0: f64) -> (FluidConfig<f64, 2>, FluidParticles<f64, 2>) {
    let mut config = FluidConfig::water(l0, SOUND);
    config.radius_ratio = 3.0;
    config.cfl = 1.0;
    config.tension = Tension::Keep;
    config.collisions = None;
    config.background_pressure = LEVEL;
    config.pressure_form = PressureForm::Corrected;
    config.diffusion = Diffusion::filter(0.5);
    config.shifting = Some(Shifting { iterations: 1, ..Shifting::default() });
    config.density_relaxation = 0.01;
    let counts = [LENGTH, DEPTH].map(|length| (length / l0).round() as usize);
    let mut places: Vec<Vector<f64, 2>> = lattice([0.0, 0.5 * THICKNESS], counts, l0);
    places.extend(lattice([0.0, -0.5 * THICKNESS - DEPTH], counts, l0));
    let mut particles = FluidParticles::at_rest(places);
    let k = plate().k;
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        let to_wall = k * (DEPTH + 0.5 * THICKNESS - r.y.abs());
        let (along, across) = (to_wall.cosh() * r.y.signum(), to_wall.sinh());
        let shares = Vector::from([along * (k * r.x).sin(), across * (k * r.x).cos()]);
        *u = shares * (AMPLITUDE * OMEGA / (k * DEPTH).sinh());
    }
    (config, particles)
}

impl Case for WavingPlate {
    fn name(&self) -> &'static str {
        "waving-plate"
    }

    fn about(&self) -> &'static str {
        "A plate with water on both sides that moves as a standing wave of its own stiffness: 0.5 m long, 0.02 m thick, layers of 0.2 m between walls \
         without slip, viscosity 1e-3 m^2/s, endless along the plate. The water weighs sixteen times as much as the plate, and has the numerics of the channel \
         of Turek and Hron. Frequency and decay over three half periods, behind the first, in which its layers form."
    }

    fn resolution(&self) -> &'static str {
        "particles per depth"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![20], vec![20, 40, 80])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let l0 = DEPTH / n as f64;
        let (config, particles) = water(l0);
        let layers = 4;
        let columns = (LENGTH / l0).round() as usize;
        let mut walls = Boundary::default();
        for y in [0.5 * THICKNESS + DEPTH, -0.5 * THICKNESS - DEPTH - layers as f64 * l0] {
            walls.add_wall(&lattice([0.0, y], [columns, layers], l0), Slip::None);
        }
        let domain = PeriodicBox::new(Vector::zeros(), [Some(LENGTH), None])?;
        let viscosity = |reference: &_| CompactViscosity::new::<2>(VISCOSITY, reference);
        let mut scene =
            Scene::new(Fluid::new(config, WendlandGradient, viscosity, domain, particles, walls)?);
        let exact = plate();
        let across = (THICKNESS / l0).round() as usize;
        let rest = lattice([0.0, -0.5 * THICKNESS], [columns, across], l0);
        let mut waving = Waving::new(rest, l0, RHO, exact.k, exact.stiffness / exact.mass);
        waving.v = AMPLITUDE * OMEGA;
        scene.add_structure(parallel, Box::new(waving), Slip::None)?;
        let root = exact.root();
        let (mut time, mut place) = (Vec::new(), Vec::new());
        while scene.fluid().time() * root.im < 4.3 * PI {
            scene.step(parallel, f64::INFINITY)?;
            let plate = scene.structure(0).and_then(|body| body.as_any().downcast_ref::<Waving>());
            time.push(scene.fluid().time());
            place.push(plate.ok_or("the scene has no plate")?.q);
        }
        // The start is a passage of zero that is not among them.
        let zeros = zeros(&time, &place);
        let (Some(first), Some(last)) = (zeros.first(), zeros.get(3)) else {
            return Err("the plate does not swing".into());
        };
        let largest = |from: f64, to: f64| {
            let inside = time.iter().zip(&place).filter(|(t, _)| (from..to).contains(t));
            inside.map(|(_, q)| q.abs()).fold(0.0, f64::max)
        };
        let swings: Vec<f64> = zeros.windows(2).take(3).map(|pair| largest(pair[0], pair[1])).collect();
        let frequency = 3.0 * PI / (last - first);
        let decay = (swings[0] / swings[2]).ln() / (2.0 * PI / frequency);
        let measures = vec![
            Measure::new("frequency", "rad/s", frequency, root.im, LAW),
            Measure::new("decay", "1/s", decay, -root.re, LAW),
        ];
        Ok(Outcome::new(measures, Vec::new()))
    }
}
