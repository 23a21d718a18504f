//! What crosses the interface: momentum, angular momentum and energy of a block in a stirred blob of fluid, alone in space.

use mps_coupling::{ElasticBody, Scene};
use mps_examples::Failure;
use mps_examples::basin::{lattice, water};
use mps_examples::exact::{Case, Measure, Outcome, Pace};
use mps_fluid::{Boundary, Diffusion, Fluid, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::{WendlandC2, WendlandGradient};
use mps_neighbors::{Open, Parallel};
use mps_solid::body::block;
use mps_solid::materials::SaintVenantKirchhoff;
use mps_solid::{Solid, SolidConfig};

pub(crate) struct Exchange;

/// Spacing \[m\] and speed of sound \[m/s\].
const L0: f64 = 0.01;
const SOUND: f64 = 10.0;
/// Spin at the start \[1/s\], with a stretch of the same rate along the diagonal.
const RATE: f64 = 1.0;
/// Until when \[s\]: four passages of sound through the blob.
const END: f64 = 0.1;

type Blob = Scene<f64, 2, WendlandGradient>;
type Block = ElasticBody<f64, 2, SaintVenantKirchhoff<f64>>;

impl Case for Exchange {
    fn name(&self) -> &'static str {
        "exchange"
    }

    fn about(&self) -> &'static str {
        "A rubber block of 8 x 8 particles in the middle of a blob of 24 x 24 without viscosity, diffusion and gravity; the fluid spins \
         about the block and passes it. Largest change of the sums over both within four passages of sound. Pairs exchange \
         opposite forces, but in sub-steps along the line of the start of the step: angular momentum and energy are kept but for the time step."
    }

    fn resolution(&self) -> &'static str {
        "steps in l0/c"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![4], vec![2, 4, 8])
    }

    fn run(&self, n: usize, _: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let mut scene = blob(1.0 / n as f64, parallel)?;
        let start = sums(&scene, parallel)?;
        // About a point off the middle.
        scene.keep_books(Vector::from([0.3, -0.2]));
        let mut changes = [0.0_f64; 3];
        while scene.fluid().time() < END {
            scene.step(parallel, f64::INFINITY)?;
            let now = sums(&scene, parallel)?;
            let change = |k: usize| (now[k] - start[k]).abs();
            let momentum = change(0).hypot(change(1)) / start[4];
            let relative = [momentum, change(2) / start[2].abs(), change(3) / start[3]];
            changes.iter_mut().zip(relative).for_each(|(most, now)| *most = most.max(now));
        }
        let [momentum, angular, energy] = changes;
        let kept = "analytic: kept";
        let residual = scene.budget().residual;
        let closure = scene.budget().closure().unwrap_or_default();
        Ok(Outcome {
            measures: vec![
                Measure::new("action and reaction", "-", residual, 0.0, "Newton").within(1e-12, 2),
                Measure::new("momentum, largest change", "sum m u", momentum, 0.0, kept).within(1e-12, 2),
                Measure::new("angular momentum, largest change", "L0", angular, 0.0, kept),
                Measure::new("energy, largest change", "E0", energy, 0.0, kept),
                Measure::new("books, momentum", "sum |f| dt", closure.momentum, 0.0, "Newton")
                    .within(1e-12, 2),
                Measure::new("books, angular momentum", "sum |r x f| dt", closure.angular, 0.0, "Newton")
                    .within(1e-12, 2),
                Measure::new(
                    "books, off the lines of the pairs",
                    "sum |r x f| dt",
                    closure.off_line,
                    0.0,
                    kept,
                ),
            ],
            ..Outcome::default()
        })
    }
}

fn blob(cfl: f64, parallel: &Parallel) -> Result<Blob, Failure> {
    let inside = |r: &Vector<f64, 2>| r.iter().all(|x| x.abs() < 4.0 * L0);
    let places = lattice([-12.0 * L0; 2], [24, 24], L0).into_iter().filter(|r| !inside(r)).collect();
    let mut particles = FluidParticles::at_rest(places);
    for (u, r) in particles.velocity.iter_mut().zip(&particles.position) {
        *u = Vector::from([RATE * 0.1 - RATE * r.y, RATE * r.x]);
    }
    particles.density.fill(1.005);
    let mut config = water(L0, SOUND);
    config.cfl = cfl;
    config.diffusion = Diffusion::None;
    let fluid = Fluid::new(config, WendlandGradient, |_| (), Open, particles, Boundary::default())?;
    let mut scene = Scene::new(fluid);
    scene.audit_interval = 1;
    let body = block(Vector::repeat(-4.0 * L0), Vector::repeat(4.0 * L0), [8, 8], &[])?;
    let material = SaintVenantKirchhoff::new(1e6, 0.4)?;
    let config = SolidConfig::default();
    let solid = Solid::new(body.particles, body.spacing, 1000.0, material, WendlandC2, config, parallel)?;
    scene.add_structure(parallel, Box::new(Block::new(solid)), Slip::Free)?;
    Ok(scene)
}

/// Momentum, angular momentum, energy, and the sum of the sizes of all momenta.
fn sums(scene: &Blob, parallel: &Parallel) -> Result<[f64; 5], Failure> {
    let block = scene.structure(0).and_then(|body| body.as_any().downcast_ref::<Block>());
    let block = block.ok_or("the scene has no block")?.solid().particles();
    let (fluid, mass) = (scene.fluid().particles(), scene.fluid().config().particle_mass());
    let of_fluid = fluid.position.iter().zip(&fluid.velocity).map(|(r, u)| (r, *u * mass));
    let of_block = block.positions().iter().zip(block.velocities()).zip(block.masses());
    let all = of_fluid.chain(of_block.map(|((r, u), m)| (r, u * *m)));
    let (water, rubber) = scene.energy(parallel);
    let mut sums = [0.0, 0.0, 0.0, water.total() + rubber.total(), 0.0];
    for (r, p) in all {
        sums[0] += p.x;
        sums[1] += p.y;
        sums[2] += r.x * p.y - r.y * p.x;
        sums[4] += p.norm();
    }
    Ok(sums)
}
