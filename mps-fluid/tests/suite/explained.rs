//! The terms by which a particle is explained are those that the sweeps have summed up.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{Noise, lattice, tank_walls, water};
use mps_fluid::explain::{Explanation, Other};
use mps_fluid::{
    Boundary, Diffusion, Fluid, FluidConfig, FluidError, FluidParticles, LaminarViscosity, Limit,
    PressureForm, Shifting, Slip, Tension,
};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Open, Parallel};

type Water<const D: usize> = Fluid<f64, D, WendlandGradient, LaminarViscosity<f64>>;

const L0: f64 = 0.01;

/// A shaken tank to whose walls the fluid sticks, with a block of points in the middle that feel it.
fn tank<const D: usize>(count: usize, config: FluidConfig<f64, D>) -> Water<D> {
    let mut noise = Noise::new(3);
    let inside = |r: &Vector<f64, D>| r.iter().all(|x| (x / L0 - 0.5 * count as f64).abs() < 2.0);
    let all = lattice::<f64, D>([0.0; D], [count; D], L0);
    let (block, mut points): (Vec<_>, Vec<_>) = all.into_iter().partition(inside);
    points.iter_mut().for_each(|r| *r += noise.vector::<f64, D>(0.1 * L0));
    let mut particles = FluidParticles::at_rest(points);
    for (u, n) in particles.velocity.iter_mut().zip(&mut particles.density) {
        *u = noise.vector(0.3);
        *n += 0.01 * noise.next();
    }
    let mut boundary = Boundary::default();
    boundary.add_wall(&tank_walls::<f64, D>([count; D], count + 2, L0), Slip::None).unwrap();
    boundary.add_structure(&block, core::iter::repeat(1.0), Slip::None);
    let viscosity = |r: &_| LaminarViscosity::new::<D>(1e-3, r);
    Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary).unwrap()
}

fn config<const D: usize>(pressure_form: PressureForm, diffusion: Diffusion<f64>) -> FluidConfig<f64, D> {
    FluidConfig { pressure_form, diffusion, tension: Tension::Keep, ..water(L0, 0.1) }
}

/// All particles are explained, and some see walls and some the block.
fn explain_all<const D: usize>(fluid: &Water<D>, dt: f64) -> Vec<Explanation<f64, D>> {
    let all: Vec<_> = (0..fluid.particles().id.len()).map(|i| fluid.explain(i, dt).unwrap()).collect();
    assert!(all.iter().any(|e| e.acceleration.wall_shear.norm() > 0.0));
    assert!(all.iter().any(|e| e.acceleration.structure_shear.norm() > 0.0));
    assert!(all.iter().any(|e| e.acceleration.structure_pressure.norm() > 0.0));
    all
}

/// Terms of a step add up to what the sweeps have found, before and after sub-steps of the structure.
fn adds_up<const D: usize>(count: usize, config: FluidConfig<f64, D>) {
    let parallel = Parallel::serial();
    let mut fluid = tank::<D>(count, config);
    let dt = fluid.begin_step(&parallel).unwrap();
    for (e, swept) in explain_all(&fluid, dt).iter().zip(fluid.acceleration()) {
        let size: f64 = e.acceleration.terms().iter().map(|(_, term)| term.norm()).sum();
        assert!((e.acceleration.total() - swept).norm() < 1e-13 * size);
        assert!(e.acceleration.outside.norm() < 1e-13 * size, "{:?}", e.acceleration);
    }
    // The block moves in two sub-steps.
    let block = fluid.boundary().reactive();
    for speed in [0.2, -0.1] {
        fluid.boundary_mut().velocity[block.clone()].fill(Vector::from_element(speed));
        fluid.follow_shear();
        fluid.compress_interface(&parallel, 0.5 * dt);
    }
    let all = explain_all(&fluid, dt);
    assert!(all.iter().any(|e| e.acceleration.substeps.norm() > 1.0));
    let before = fluid.particles().clone();
    fluid.finish_step(&parallel, dt);
    for (i, e) in all.iter().enumerate() {
        let size: f64 = e.acceleration.terms().iter().map(|(_, term)| term.norm()).sum();
        let kick = fluid.particles().velocity[i] - before.velocity[i];
        // The velocities are rounded, too.
        assert!((e.acceleration.total() * dt - kick).norm() < 1e-13 * (size * dt + 1.0));
        let size: f64 = e.density_rate.terms().iter().map(|(_, term)| term.abs()).sum();
        let change = fluid.particles().density[i] - before.density[i];
        assert!((e.density_rate.total() * dt - change).abs() < 1e-13 * (size * dt + 1.0));
    }
    let seen = |term: fn(&Explanation<f64, D>) -> f64| all.iter().any(|e| term(e).abs() > 1.0);
    assert!(seen(|e| e.density_rate.walls) && seen(|e| e.density_rate.structures));
    assert!(seen(|e| e.density_rate.diffusion));
}

#[test]
fn the_terms_add_up_to_the_acceleration_and_the_density_rate_of_the_sweeps() {
    for form in [PressureForm::Plain, PressureForm::Corrected] {
        for diffusion in [Diffusion::Filter { delta: 0.5 }, Diffusion::Hydrostatic] {
            adds_up::<2>(14, config(form, diffusion));
            adds_up::<3>(8, config(form, diffusion));
        }
    }
}

/// That sums are right does not say that every pair is: what `j` does to `i`, `i` does to `j`, and all that the block does, it receives.
#[test]
fn every_pair_is_opposite_and_equal() {
    for form in [PressureForm::Plain, PressureForm::Corrected] {
        let mut fluid = tank::<2>(14, config(form, Diffusion::Hydrostatic));
        let dt = fluid.begin_step(&Parallel::serial()).unwrap();
        let all = explain_all(&fluid, dt);
        let of = |id: u32| all.iter().find(|e| e.id == id).unwrap();
        let mut pairs = 0;
        for e in &all {
            for there in &e.neighbors {
                let Other::Fluid(id) = there.other else { continue };
                let back = of(id).neighbors.iter().find(|back| back.other == Other::Fluid(e.id)).unwrap();
                assert!((there.push + back.push).norm() <= 1e-14 * there.push.norm());
                assert_eq!(there.shear, -back.shear);
                pairs += 1;
            }
            assert!(e.neighbors.is_sorted_by(|a, b| a.distance <= b.distance));
        }
        assert!(pairs > 2000);
        let on_fluid: Vector<f64, 2> =
            all.iter().map(|e| e.acceleration.structure_pressure + e.acceleration.structure_shear).sum();
        let on_block: Vector<f64, 2> = fluid.boundary().force[fluid.boundary().reactive()].iter().sum();
        assert!((on_fluid * fluid.config().particle_mass() + on_block).norm() < 1e-12 * on_block.norm());
    }
}

#[test]
fn what_comes_from_outside_is_a_term_of_its_own() {
    let parallel = Parallel::serial();
    let mut fluid = tank::<2>(10, config(PressureForm::Plain, Diffusion::Hydrostatic));
    let dt = fluid.begin_step(&parallel).unwrap();
    fluid.add_acceleration(&parallel, |r| Vector::from([3.0, r.y]));
    for e in explain_all(&fluid, dt) {
        let field = Vector::from([3.0, e.position.y]);
        assert!((e.acceleration.outside - field).norm() < 1e-9, "{:?}", e.acceleration);
    }
}

#[test]
fn shift_collisions_and_relaxation_are_told_to_those_who_asked_before() {
    let parallel = Parallel::serial();
    let form = PressureForm::Corrected;
    let config = FluidConfig {
        shifting: Some(Shifting::default()),
        density_relaxation: 0.01,
        ..config(form, Diffusion::Hydrostatic)
    };
    let mut fluid = tank::<2>(14, config);
    fluid.step(&parallel).unwrap();
    let dt = fluid.begin_step(&parallel).unwrap();
    assert_eq!(fluid.explain(0, dt).unwrap().changes, None);
    fluid.finish_step(&parallel, dt);
    fluid.remember_changes();
    let before = fluid.particles().clone();
    let dt = fluid.begin_step(&parallel).unwrap();
    let mut seen = [0.0_f64; 3];
    for i in 0..before.id.len() {
        let e = fluid.explain(i, dt).unwrap();
        let k = before.id.iter().position(|id| *id == e.id).unwrap();
        let changes = e.changes.unwrap();
        assert!((changes.shift - (e.position - before.position[k])).norm() < 1e-16);
        assert_eq!(changes.collision, e.velocity - before.velocity[k]);
        assert_eq!(changes.relaxation, e.density - before.density[k]);
        let sizes = [changes.shift.norm(), changes.collision.norm(), changes.relaxation.abs()];
        seen.iter_mut().zip(sizes).for_each(|(seen, size)| *seen = seen.max(size));
    }
    assert!(seen[0] > 1e-4 * L0 && seen[1] > 1e-3 && seen[2] > 1e-5, "{seen:?}");
}

#[test]
fn a_step_names_its_limit_and_who_sets_it() {
    let parallel = Parallel::serial();
    let still = |fluid: &mut Water<2>| {
        fluid.particles_mut().velocity.fill(Vector::zeros());
        fluid.particles_mut().density.fill(1.0);
    };
    let config = || FluidConfig { collisions: None, ..config(PressureForm::Plain, Diffusion::None) };
    let mut fluid = tank::<2>(10, config());
    still(&mut fluid);
    fluid.particles_mut().velocity[17].x = 2.0;
    let dt = fluid.begin_step(&parallel).unwrap();
    let step = fluid.explain_step().unwrap();
    assert_eq!((step.limit, step.fastest, fluid.limit()), (Limit::Sound, (17, 2.0), Limit::Sound));
    assert_eq!(step.limits.shortest(), (Limit::Sound, dt));

    let mut fluid = tank::<2>(10, config());
    still(&mut fluid);
    // Twice the density at one place.
    fluid.particles_mut().density[31] = 2.0;
    let dt = fluid.begin_step(&parallel).unwrap();
    let step = fluid.explain_step().unwrap();
    assert_eq!((step.limit, fluid.limit()), (Limit::Acceleration, Limit::Acceleration));
    assert_eq!(step.limits.acceleration, dt);
    // It pushes its neighbours, all of which are within the radius of 31.
    let i = fluid.particles().id.iter().position(|id| *id == step.most_accelerated.0).unwrap();
    assert!(fluid.explain(i, dt).unwrap().neighbors.iter().any(|n| n.other == Other::Fluid(31)));
}

#[test]
fn a_particle_is_explained_after_the_step_that_broke_and_not_between_steps() {
    let parallel = Parallel::serial();
    let mut fluid = tank::<2>(10, config(PressureForm::Plain, Diffusion::Hydrostatic));
    assert!(fluid.explain(0, 1e-4).is_none() && fluid.explain_step().is_none());
    fluid.step(&parallel).unwrap();
    assert!(fluid.explain(0, 1e-4).is_none() && fluid.explain_step().is_none());
    fluid.particles_mut().density[5] = f64::NAN;
    let named = fluid.particles().id[5];
    let FluidError::NotFinite { id, quantity: "density", .. } = fluid.begin_step(&parallel).unwrap_err()
    else {
        unreachable!("the density is no number");
    };
    let i = fluid.particles().id.iter().position(|other| *other == id).unwrap();
    assert_eq!(id, named);
    let e = fluid.explain(i, 1e-4).unwrap();
    assert!(e.density.is_nan() && e.acceleration.pressure.norm().is_nan() && !e.neighbors.is_empty());
    assert_eq!(e.acceleration.gravity, fluid.config().gravity);
    assert!(!fluid.explain_step().unwrap().most_accelerated.1.is_finite());
    assert!(fluid.explain(usize::MAX, 1e-4).is_none());
}

#[test]
fn the_courant_number_can_be_changed_between_steps() {
    let parallel = Parallel::serial();
    let run = |cfl: f64| {
        let mut fluid = tank::<2>(10, config(PressureForm::Plain, Diffusion::Hydrostatic));
        fluid.set_courant_number(cfl).unwrap();
        fluid.begin_step(&parallel).unwrap()
    };
    assert_eq!(run(0.25) * 2.0, run(0.5));
    let mut fluid = tank::<2>(10, config(PressureForm::Plain, Diffusion::Hydrostatic));
    assert!(matches!(fluid.set_courant_number(3.0), Err(FluidError::Parameter { name: "cfl", .. })));
    assert_eq!(fluid.config().cfl, 0.5);
}

/// Whoever asks for a point of a wall, or for one that there is not, hears that nothing is known of it.
#[test]
fn forces_and_stiffnesses_of_points_that_receive_none_are_zero() {
    let parallel = Parallel::serial();
    let mut fluid = tank::<2>(14, config(PressureForm::Plain, Diffusion::Hydrostatic));
    let (block, len) = (fluid.boundary().reactive(), fluid.boundary().len());
    for step in 0..2 {
        for a in (0..len + 3).chain([usize::MAX]) {
            let (force, stiffness) = (fluid.force_on(a), fluid.interface_stiffness(a));
            assert!(force.norm().is_finite() && stiffness.is_finite());
            if !block.contains(&a) {
                assert_eq!((force, stiffness), (Vector::zeros(), 0.0), "{a} in step {step}");
            }
        }
        let seen =
            block.clone().any(|a| fluid.interface_stiffness(a) > 0.0 && fluid.force_on(a).norm() > 0.0);
        assert_eq!(seen, step > 0);
        fluid.begin_step(&parallel).unwrap();
    }
}
