//! A blob of fluid alone in space keeps its momenta and never gains energy.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{BLOB, blob};
use mps_fluid::{
    ArtificialViscosity, Boundary, Dpc, Fluid, FluidConfig, LaminarViscosity, Tension, Viscosity,
};
use mps_kernel::weights::Rational;
use mps_kernel::{Tensor, Vector};
use mps_neighbors::{Domain, Parallel, PeriodicBox};

type Blob<V, const D: usize> = Fluid<f64, D, Rational, V>;

fn config<const D: usize>() -> FluidConfig<f64, D> {
    FluidConfig::water(BLOB.0, BLOB.1)
}

/// `sum r x q` as an antisymmetric tensor, and the sum of the sizes of its terms.
fn moment<const D: usize>(r: &[Vector<f64, D>], q: &[Vector<f64, D>]) -> (Tensor<f64, D>, f64) {
    let (mut sum, mut size) = (Tensor::zeros(), 0.0);
    for (r, q) in r.iter().zip(q) {
        sum += r * q.transpose() - q * r.transpose();
        size += r.norm() * q.norm();
    }
    (sum, size)
}

fn keeps_linear_momentum<V: Viscosity<f64, D>, const D: usize>(mut fluid: Blob<V, D>) {
    let parallel = Parallel::serial();
    let start = fluid.momentum(&parallel);
    let mass = fluid.config().particle_mass();
    let size: f64 = fluid.particles().velocity.iter().map(|u| mass * u.norm()).sum();
    for _ in 0..100 {
        fluid.step(&parallel).unwrap();
    }
    let change = (fluid.momentum(&parallel) - start).norm() / size;
    assert!(change < 1e-12, "{change:e}");
    assert!(fluid.rebuilds() > 3, "the particles have mixed");
}

#[test]
fn linear_momentum_is_kept_through_diffusion_viscosity_and_collisions() {
    let bouncing = Some(Dpc { restitution: 1.0, repulsion: 0.2, ..Dpc::default() });
    for tension in [Tension::Clip, Tension::Keep] {
        for collisions in [None, Some(Dpc::default()), bouncing] {
            let config = FluidConfig { tension, collisions, ..config::<2>() };
            keeps_linear_momentum(blob(20, 0.5, config, |r| {
                (ArtificialViscosity::new::<2>(0.05, BLOB.1, r), LaminarViscosity::new::<2>(1e-4, r))
            }));
        }
    }
    keeps_linear_momentum(blob(8, 0.5, config::<3>(), |r| ArtificialViscosity::new::<3>(0.05, BLOB.1, r)));
}

/// Torque of the accelerations of one step over the sum of the sizes of its terms.
fn torque<V: Viscosity<f64, D>, const D: usize>(mut fluid: Blob<V, D>) -> f64 {
    fluid.begin_step(&Parallel::serial()).unwrap();
    let (sum, size) = moment(&fluid.particles().position, fluid.acceleration());
    sum.norm() / size
}

#[test]
fn forces_along_the_line_of_a_pair_exert_no_torque() {
    let artificial = torque(blob(20, 0.5, config::<2>(), |r| ArtificialViscosity::new::<2>(0.05, BLOB.1, r)));
    assert!(artificial < 1e-14, "{artificial:e}");
    let solid = torque(blob(8, 0.5, config::<3>(), |r| ArtificialViscosity::new::<3>(0.05, BLOB.1, r)));
    assert!(solid < 1e-14, "{solid:e}");
    // The measure is able to see one: the laminar operator does not act along the line of the pair.
    let laminar = torque(blob(20, 0.5, config::<2>(), |r| LaminarViscosity::new::<2>(1e-3, r)));
    assert!(laminar > 1e-6, "{laminar:e}");
}

#[test]
fn collisions_keep_angular_momentum() {
    let parallel = Parallel::serial();
    let collisions = Some(Dpc { restitution: 1.0, repulsion: 0.2, ceiling: 0.02 });
    let mut fluid = blob::<2, ()>(20, 1.0, FluidConfig { collisions, ..config() }, |_| ());
    fluid.step(&parallel).unwrap();
    let (before, velocities) = {
        let p = fluid.particles();
        (moment(&p.position, &p.velocity), p.velocity.iter().map(Vector::norm_squared).sum::<f64>())
    };
    // Nothing but collisions happens at the beginning of a step.
    fluid.begin_step(&parallel).unwrap();
    let p = fluid.particles();
    let after = moment(&p.position, &p.velocity);
    assert!((after.0 - before.0).norm() / before.1 < 1e-14);
    let changed = p.velocity.iter().map(Vector::norm_squared).sum::<f64>();
    assert!((changed - velocities).abs() > 1e-3 * velocities, "particles did collide");
}

/// Largest rise of kinetic and compression energy above its smallest value so far, and the last
/// value, both over that of the start.
fn energies<V: Viscosity<f64, 2>, P: Domain<f64, 2>>(
    mut fluid: Fluid<f64, 2, Rational, V, P>,
    steps: usize,
) -> (f64, f64) {
    let parallel = Parallel::serial();
    let start = fluid.energy(&parallel).total();
    let (mut least, mut rise, mut last) = (1.0_f64, 0.0_f64, 1.0);
    for _ in 0..steps {
        fluid.step(&parallel).unwrap();
        last = fluid.energy(&parallel).total() / start;
        rise = rise.max(last - least);
        least = least.min(last);
    }
    (rise, last)
}

const STICKY: Option<Dpc<f64>> = Some(Dpc { restitution: 0.0, repulsion: 0.0, ceiling: 0.02 });

fn config_with(collisions: Option<Dpc<f64>>, cfl: f64) -> FluidConfig<f64, 2> {
    FluidConfig { collisions, cfl, ..config() }
}

#[test]
fn energy_of_motion_and_compression_never_rises() {
    for (collisions, cfl) in [(None, 0.5), (STICKY, 0.5), (STICKY, 0.1)] {
        let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.05, BLOB.1, r);
        let (rise, last) = energies(blob(20, 0.5, config_with(collisions, cfl), viscosity), 400);
        assert!(rise < 1e-12 && last < 0.9, "viscous, {collisions:?}, cfl {cfl}: {rise:e}, end {last}");
    }
    // Without viscosity collisions alone stop pairs that meet fast, for which they need the time of sound: only the step makes energy.
    let [coarse, fine] = [(0.25, 800), (0.05, 4000)]
        .map(|(cfl, steps)| energies(blob::<2, ()>(20, 0.5, config_with(STICKY, cfl), |_| ()), steps));
    assert!(coarse.0 < 5e-3 && coarse.1 < 0.9, "inviscid: {coarse:?}");
    assert!(fine.0 < 0.1 * coarse.0 && fine.1 < 0.9, "inviscid, short steps: {fine:?}");
}

/// Particles that meet in a fluid without viscosity and collisions are stopped by pressure alone, in
/// less than a time step: the symplectic step keeps energy there only as far as it resolves it.
#[test]
fn with_neither_viscosity_nor_collisions_only_the_time_step_makes_energy() {
    let rise = |cfl| energies(blob::<2, ()>(20, 0.5, config_with(None, cfl), |_| ()), 400).0;
    let (coarse, fine) = (rise(0.25), rise(0.05));
    assert!(coarse < 0.1 && fine < 0.1 * coarse, "{coarse:e} and {fine:e}");
}

/// The same in a periodic box, with the tension that an internal flow keeps.
#[test]
fn energy_never_rises_in_a_closed_flow_either() {
    let domain = PeriodicBox::new(Vector::zeros(), [Some(20.0 * BLOB.0); 2]).unwrap();
    for (collisions, cfl) in [(None, 0.5), (None, 0.1), (STICKY, 0.5)] {
        let config = FluidConfig { tension: Tension::Keep, ..config_with(collisions, cfl) };
        let particles = blob::<2, ()>(20, 0.3, config.clone(), |_| ()).particles().clone();
        let viscosity = |r: &_| ArtificialViscosity::new::<2>(0.05, BLOB.1, r);
        let boundary = Boundary::default();
        let fluid = Fluid::new(config, Rational, viscosity, domain, particles, boundary).unwrap();
        let (rise, last) = energies(fluid, 400);
        assert!(rise < 1e-12 && last < 0.9, "{collisions:?}, cfl {cfl}: {rise:e}, end {last}");
    }
}
