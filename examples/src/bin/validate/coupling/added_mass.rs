//! A plate on a spring with water on it: the frequency by the mass of the water.

use core::f64::consts::FRAC_PI_2;
use mps_coupling::Scene;
use mps_examples::basin::{RADIUS_RATIO, lattice, water};
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_examples::series::zeros;
use mps_examples::{Failure, Piston};
use mps_fluid::{Boundary, Fluid, FluidParticles, Slip, Tension};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Parallel, PeriodicBox};

pub(crate) struct AddedMass;

/// Depth of the water \[m\], its density \[kg/m^3\] and the speed of sound in it \[m/s\].
const DEPTH: f64 = 1.0;
const RHO: f64 = 1000.0;
const SOUND: f64 = 10.0;
/// Columns of particles between the ends of the period.
const COLUMNS: usize = 10;
/// Mass of the plate per area \[kg/m^2\]: a tenth of the water's.
const MASS: f64 = 0.1 * RHO * DEPTH;
/// Phase of the sound over the depth, `omega H/c`: small, the water moves as one mass but for a few percent.
const PHASE: f64 = 0.3;
/// Speed of the plate at the start \[m/s\]. The problem is linear; so slow that water under tension does not clump meanwhile.
const SPEED: f64 = 1e-6 * SOUND;
const LAW: &str = "analytic: m w^2 + rho c w tan(w H/c) = k";

/// Stiffness per area that belongs to the frequency \[N/m^3\].
fn stiffness() -> f64 {
    let omega = PHASE * SOUND / DEPTH;
    MASS * omega * omega + RHO * SOUND * omega * PHASE.tan()
}

impl Case for AddedMass {
    fn name(&self) -> &'static str {
        "added-mass"
    }

    fn about(&self) -> &'static str {
        "A rigid plate on a spring below a column of water with a free surface, endless sideways, without gravity and viscosity; the water weighs \
         ten times as much as the plate. Frequency over one period of the slowest mode, with which it starts; the sound is so fast that \
         the water adds its mass and 3 % more."
    }

    fn resolution(&self) -> &'static str {
        "particles per depth"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![10], vec![10, 20, 40])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let l0 = DEPTH / n as f64;
        let mut config = water(l0, SOUND);
        config.tension = Tension::Keep;
        let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [COLUMNS, n], l0));
        // The mode itself: a push of the plate alone would send sound up and down.
        for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
            let phase: f64 = PHASE * (1.0 - r.y / DEPTH);
            u.y = SPEED * phase.cos() / PHASE.cos();
        }
        let width = COLUMNS as f64 * l0;
        let domain = PeriodicBox::new(Vector::zeros(), [Some(width), None])?;
        let fluid = Fluid::new(config, WendlandGradient, |_| (), domain, particles, Boundary::default())?;
        let mut scene = Scene::new(fluid);
        let layers = RADIUS_RATIO as usize + 1;
        let places = lattice([0.0, -(layers as f64) * l0], [COLUMNS, layers], l0);
        let mut plate = Piston::new(places, l0, MASS * width);
        (plate.stiffness, plate.v) = (stiffness() * width, SPEED);
        scene.add_structure(parallel, Box::new(plate), Slip::Free)?;
        let omega = PHASE * SOUND / DEPTH;
        let (mut time, mut place) = (Vec::new(), Vec::new());
        // Four passages of zero, three half periods; the first is at the start.
        while scene.fluid().time() * omega < 2.0 * FRAC_PI_2 * 3.2 {
            scene.step(parallel, f64::INFINITY)?;
            let plate = scene.structure(0).and_then(|body| body.as_any().downcast_ref::<Piston>());
            time.push(scene.fluid().time());
            place.push(plate.ok_or("the scene has no plate")?.y);
        }
        let zeros = zeros(&time, &place);
        let (Some(first), Some(last)) = (zeros.first(), zeros.get(2)) else {
            return Err("the plate does not swing".into());
        };
        let found = 4.0 * FRAC_PI_2 / (last - first);
        let frequency = Measure::new("frequency", "rad/s", found, omega, LAW);
        Ok(Outcome::new(vec![frequency.within(0.01, 10)], Vec::new()))
    }
}
