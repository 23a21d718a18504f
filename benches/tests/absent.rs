//! What is absent costs nothing: counted, not timed.
//!
//! Needs valgrind, hence not among the tests that run anywhere: `cargo test -p mps-benches --test absent -- --ignored`.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stderr,
    reason = "helpers of tests may fail the test"
)]

use mps_benches::counting::{Count, Entry, Lean, Physics, Recipe, available, entries, per_step};
use mps_benches::tank_with;
use mps_neighbors::Parallel;
use std::path::Path;

/// Instructions a step, whatever the number of particles, that may go into asking whether something is there.
const ASKING: f64 = 200.0;
/// Instructions a particle that the two sweeps of a bare fluid may take for what it has not, outside their loops over pairs. In space the gradient that
/// only the filter needs makes the step from neighbour to neighbour 80 bytes and not 64, which takes an instruction for each.
const OUTSIDE: [(&str, f64); 3] = [("2d/f64", 65.0), ("2d/f32", 65.0), ("3d/f64", 190.0)];

fn count(name: &str) -> Count {
    per_step(Path::new(env!("CARGO_BIN_EXE_count")), name).unwrap()
}

fn particles(name: &str) -> f64 {
    let found = entries().into_iter().find(|entry: &Entry| entry.name == name);
    (found.unwrap_or_else(|| panic!("nothing is called {name}")).make)().particles as f64
}

/// Without valgrind there is nothing to say, and that is said.
fn possible() -> bool {
    if !available() {
        eprintln!(
            "NOT COUNTED: there is no valgrind here (Debian: apt install valgrind). Nothing was tested."
        );
    }
    available()
}

/// No loop over particles passes through the files of something that is absent; where it is present, one does. (Viscosity and
/// diffusion are formulas of lanes, whose instructions belong to the files of the lanes: they are in the next test.)
#[test]
#[ignore = "needs valgrind"]
fn the_files_of_absent_physics_are_not_visited_particle_by_particle() {
    if !possible() {
        return;
    }
    for prefix in ["2d/f64", "3d/f64"] {
        let bare = count(&format!("{prefix}/bare"));
        for physics in Physics::ALL.into_iter().filter(|physics| !physics.sources().is_empty()) {
            let name = format!("{prefix}/{}", physics.name());
            let (absent, present) = (bare.of(physics.sources()), count(&name).of(physics.sources()));
            assert!(absent <= ASKING, "without {name} its files take {absent} instructions a step");
            assert!(
                present > 0.1 * particles(&name),
                "with {name} its files take {present} a step: are they its files?"
            );
        }
    }
}

/// Pair by pair the sweeps of a fluid that has nothing take the instructions of sweeps that have no place for anything: what they take
/// more is a number a particle, but for one instruction a pair in space. Of a release: the build of the tests leaves
/// the closures of the gathers as they are, and there the counts of both sides are held by the table.
#[test]
#[ignore = "needs valgrind"]
fn a_bare_fluid_takes_little_more_than_sweeps_without_a_place_for_more() {
    if !possible() {
        return;
    }
    for (prefix, outside) in OUTSIDE {
        let [bare, lean] = ["bare", "lean"].map(|name| count(&format!("{prefix}/{name}")).sweeps);
        assert!(lean > 0.0);
        let more = (bare - lean) / particles(&format!("{prefix}/bare"));
        let share = bare / lean - 1.0;
        eprintln!("{prefix}: {more:+.2} instructions a particle, {:+.2} %", 100.0 * share);
        if cfg!(debug_assertions) {
            assert!(share < 0.2, "{prefix}: what is absent takes {share} of the sweeps");
        } else {
            assert!(more < outside, "{prefix}: what is absent takes {more} instructions a particle");
        }
    }
}

/// The lean sweeps do the work of the library's: the same bits.
#[test]
fn lean_sweeps_find_the_accelerations_of_the_library() {
    let (recipe, parallel) = (Recipe(&[]), Parallel::serial());
    let mut fluid = tank_with::<f64, 2, ()>([40, 30], None, |config| recipe.configure(config), |_, _| ());
    fluid.begin_step(&parallel).unwrap();
    let mut lean = Lean::of(&fluid);
    lean.sweep(&parallel);
    assert_eq!(lean.acceleration(), fluid.acceleration());
    assert!(fluid.acceleration().iter().any(|a| a.norm() > 20.0), "nothing but gravity was compared");
}

/// A scene without structures takes the instructions of its fluid, and as many more a step, whatever the number of particles.
#[test]
#[ignore = "needs valgrind"]
fn a_scene_without_structures_is_its_fluid() {
    if !possible() {
        return;
    }
    for prefix in ["2d/f64", "3d/f64"] {
        let more = count(&format!("{prefix}/scene")).total - count(&format!("{prefix}/bare")).total;
        assert!(
            (0.0..ASKING).contains(&more),
            "{prefix}: a scene takes {more} instructions a step more than its fluid"
        );
    }
}

/// Three runs, the same number: so a difference is a difference of the program.
#[test]
#[ignore = "needs valgrind"]
fn counts_are_the_same_every_time() {
    if !possible() {
        return;
    }
    let first = count("2d/f64/gate");
    assert!(first.total > 1e6 && (1..3).all(|_| count("2d/f64/gate") == first));
}
