//! A structure of another make that goes wrong while it runs is named, with the point and the value, and the scene is broken from then on.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{Piston, lattice};
use mps_coupling::{CouplingError, Inertia, Scene, Structure, StructureEnergy};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::{Open, Parallel};
use std::any::Any;
use std::error::Error;

const L0: f64 = 0.01;
/// Points of the structure.
const POINTS: usize = 32;

/// What goes wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    FewerPositions,
    MorePositions,
    FewerVelocities,
    MoreVelocities,
    LostPosition,
    LostVelocity,
    EndlessVelocity,
    FewerMasses,
    Mass(f64),
    RigidMass(f64),
    Limit(f64),
}

/// A piston that goes wrong from its third sub-step on.
struct Foreign {
    piston: Piston,
    masses: Vec<f64>,
    fault: Fault,
    advances: usize,
}

impl Foreign {
    fn new(fault: Fault) -> Self {
        let piston = Piston::new(lattice([0.0, 8.0 * L0], [8, 4], L0), L0, 1.0, 0.0);
        Self { piston, masses: vec![1.0 / POINTS as f64; POINTS], fault, advances: 0 }
    }

    fn spoil(&mut self) {
        let Self { piston, masses, .. } = self;
        match self.fault {
            Fault::FewerPositions => piston.position.truncate(POINTS - 1),
            Fault::MorePositions => piston.position.resize(POINTS + 1, Vector::zeros()),
            Fault::FewerVelocities => piston.mean.truncate(POINTS - 1),
            Fault::MoreVelocities => piston.mean.resize(POINTS + 1, Vector::zeros()),
            Fault::LostPosition => piston.position[7].x = f64::NAN,
            Fault::LostVelocity => piston.mean[7].y = f64::NAN,
            Fault::EndlessVelocity => piston.mean[7].y = f64::INFINITY,
            Fault::FewerMasses => masses.truncate(POINTS - 1),
            Fault::Mass(mass) => masses[7] = mass,
            Fault::RigidMass(_) | Fault::Limit(_) => {}
        }
    }
}

impl Structure<f64, 2> for Foreign {
    fn positions(&self) -> &[Vector<f64, 2>] {
        self.piston.positions()
    }

    fn mean_velocities(&self) -> &[Vector<f64, 2>] {
        self.piston.mean_velocities()
    }

    fn volumes(&self) -> &[f64] {
        self.piston.volumes()
    }

    fn spacing(&self) -> f64 {
        L0
    }

    fn max_step(&self, _: &Parallel) -> f64 {
        match self.fault {
            Fault::Limit(limit) if self.advances >= 3 => limit,
            _ => f64::INFINITY,
        }
    }

    fn inertia(&self) -> Inertia<'_, f64> {
        match self.fault {
            Fault::FewerMasses | Fault::Mass(_) => Inertia::Points(&self.masses),
            Fault::RigidMass(mass) if self.advances >= 3 => Inertia::Rigid(mass),
            _ => Inertia::Unknown,
        }
    }

    fn advance(
        &mut self,
        parallel: &Parallel,
        force: &[Vector<f64, 2>],
        gravity: &Vector<f64, 2>,
        dt: f64,
        substeps: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        self.piston.advance(parallel, force, gravity, dt, substeps)?;
        self.advances += 1;
        if self.advances >= 3 {
            self.spoil();
        }
        Ok(())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn energy(&self, parallel: &Parallel, gravity: &Vector<f64, 2>) -> StructureEnergy<f64> {
        self.piston.energy(parallel, gravity)
    }
}

/// A good piston far away, and the one with the fault on water at rest: structure 1.
fn scene(fault: Fault) -> Scene<f64, 2> {
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [8, 8], L0));
    let config = FluidConfig::water(L0, 10.0);
    let fluid = Fluid::new(config, Rational, |_| (), Open, particles, Boundary::default()).unwrap();
    let mut scene = Scene::new(fluid);
    let far = Piston::new(lattice([1.0, 1.0], [4, 4], L0), L0, 1.0, 0.0);
    for structure in [Box::new(far) as Box<dyn Structure<f64, 2>>, Box::new(Foreign::new(fault))] {
        scene.add_structure(&Parallel::serial(), structure, Slip::Free).unwrap();
    }
    scene.min_substeps = 2;
    scene
}

/// The error of the first step that fails; the steps before are good, and after it there is none.
fn failure(fault: Fault) -> CouplingError {
    let parallel = Parallel::serial();
    let mut scene = scene(fault);
    for step in 0..40 {
        let Err(error) = scene.step(&parallel, f64::INFINITY) else { continue };
        assert!((1..=2).contains(&step), "{fault:?} in step {step}");
        assert!(scene.budget().work().is_finite(), "{fault:?}: work of {} J", scene.budget().work());
        let again = scene.step(&parallel, f64::INFINITY).unwrap_err();
        assert!(matches!(again, CouplingError::Broken { .. }), "{fault:?}: {again}");
        // What is left can be looked at.
        scene.update_interfaces(&parallel);
        assert!(scene.interface_border(1).is_some() && scene.interface_border(2).is_none());
        return error;
    }
    panic!("{fault:?} was not found in 40 steps");
}

#[test]
fn every_fault_is_an_error_that_names_the_structure_and_what_to_do() {
    for (fault, words) in [
        (Fault::FewerPositions, ["structure 1 shows 31 positions", "has 32 points", "never change"]),
        (Fault::MorePositions, ["structure 1 shows 33 positions", "has 32 points", "never change"]),
        (Fault::FewerVelocities, ["structure 1 shows 31 mean velocities", "has 32 points", "never change"]),
        (Fault::MoreVelocities, ["structure 1 shows 33 mean velocities", "has 32 points", "never change"]),
        (Fault::LostPosition, ["point 7 of structure 1", "position [NaN", "`advance`"]),
        (Fault::LostVelocity, ["point 7 of structure 1", "mean velocity [0.0, NaN] m/s", "`advance`"]),
        (Fault::EndlessVelocity, ["point 7 of structure 1", "inf] m/s", "`advance`"]),
        (Fault::FewerMasses, ["structure 1", "32 positions but 31 masses", "one of each"]),
        (Fault::Mass(f64::NAN), ["point 7 of structure 1", "NaN kg", "greater than zero"]),
        (Fault::Mass(0.0), ["point 7 of structure 1", "0e0 kg", "greater than zero"]),
        (Fault::RigidMass(0.0), ["the whole of structure 1", "0e0 kg", "greater than zero"]),
        (Fault::RigidMass(f64::NAN), ["the whole of structure 1", "NaN kg", "greater than zero"]),
        (Fault::RigidMass(-1.0), ["the whole of structure 1", "-1e0 kg", "greater than zero"]),
        (Fault::Limit(-1.0), ["structure 1", "at most -1e0 s", "longer than zero"]),
        (Fault::Limit(f64::NAN), ["structure 1", "at most NaN s", "longer than zero"]),
    ] {
        let message = failure(fault).to_string();
        for words in words {
            assert!(message.contains(words), "{fault:?}: {message}");
        }
    }
}

/// The same before the first step, where the scene stays whole.
#[test]
fn masses_and_velocities_that_are_none_are_refused_with_the_structure() {
    let refused = |spoil: fn(&mut Piston)| {
        let mut scene = scene(Fault::Limit(1.0));
        let mut piston = Piston::new(lattice([2.0, 2.0], [4, 4], L0), L0, 1.0, 0.0);
        spoil(&mut piston);
        let added = scene.add_structure(&Parallel::serial(), Box::new(piston), Slip::Free);
        scene.step(&Parallel::serial(), f64::INFINITY).unwrap();
        added.unwrap_err()
    };
    let velocity = refused(|piston| piston.mean[2].x = f64::INFINITY);
    assert!(matches!(velocity, CouplingError::NoNumber { index: 2, point: 2, .. }), "{velocity}");
    let mass = refused(|piston| (piston.open, piston.mass) = (true, 0.0));
    assert!(matches!(mass, CouplingError::Mass { index: 2, point: None, .. }), "{mass}");
}
