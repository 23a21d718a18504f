//! The same for bodies alone, whose step is a row of the table.

use super::retry::{assert_in_order, retries};
use super::*;

/// A bar of this material that is held at its left end and thrown with this speed (m/s) against it, alone.
fn bar(name: &str, material: &str, speed: &str, watch: &str) -> PathBuf {
    let text = format!(
        r#"title = "A bar that is thrown"
end_time = 0.03

[[solids]]
name = "bar"
region = {{ box = {{ lower = [0.0, 0.0], upper = [0.1, 0.02] }} }}
spacing = 5e-3
density = 1000
material = {{ {material} = {{ youngs_modulus = 1e6, poissons_ratio = 0.3 }} }}
clamp = {{ sides = ["left"] }}
velocity = {{ uniform = [{speed}, 0.0] }}

[output]
probe_interval = 1e-3

[watch]
{watch}
"#
    );
    file(name, &text)
}

/// A body is turned inside out by a sub-step that is too long for the speed it has, and its material would have held.
#[test]
fn bodies_alone_pass_with_shorter_sub_steps_what_stops_them_otherwise() {
    let retry = "steps = 1\non_failure = { retry = { steps = 10, times = 3 } }";
    let scene = bar("thrown", "neo_hookean", "30.0", retry);
    let (dir, said) = broken("thrown-stopped", &scene, &["--on-failure", "stop"]);
    assert!(said.contains("is turned inside out (det F = -"), "{said}");
    assert!(report(&dir).contains("There is no fluid."));
    comes_again(&dir, &said);
    let passed = |name: &str, threads: &str| {
        let dir = fresh("post-mortem", name);
        let output = execute(MPS, &dir, &["run", scene.to_str().unwrap(), "--quiet", "--threads", threads]);
        assert!(output.status.success(), "{}", words(&output.stderr));
        dir
    };
    let (one, other) = (passed("thrown", "1"), passed("thrown-again", "2"));
    let tries = retries(&one);
    assert!(!tries.is_empty() && tries.len() <= 3, "{tries:?}");
    assert!(tries[0].contains("with 0.5 of the sub-step"), "{tries:?}");
    assert_in_order(&one);
    // Shorter where it failed, and of the usual length again from ten rows behind the failure on.
    let table = CsvTable::read(one.join("probes.csv")).unwrap();
    let steps = &table.column("time step [s]").unwrap()[1..];
    let (usual, shortest) = (steps[0], steps.iter().copied().fold(f64::INFINITY, f64::min));
    let wanted = usual * 0.5_f64.powi(tries.len() as i32);
    assert!((shortest / wanted - 1.0).abs() < 1e-12, "{shortest} for {wanted}");
    let last = tries.last().unwrap();
    let until: usize = number_behind(last, "until step ").parse().unwrap();
    let failed: f64 =
        last.split("structure 0 at t = ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert_eq!(until, (failed / 1e-3).round() as usize + 1 + 10, "{last}");
    assert!(steps[until - 1] < usual && steps[until..].iter().all(|step| *step == usual), "{steps:?}");
    assert!(steps.len() > until);
    let [a, b] = [&one, &other].map(|dir| std::fs::read(dir.join("probes.csv")).unwrap());
    assert!(a == b && retries(&other) == tries);
}

/// This material does not resist being turned inside out, in however short a step.
#[test]
fn bodies_alone_that_no_step_can_save_are_given_up_after_the_tries() {
    let scene = bar("crushed", "saint_venant", "10.0", "steps = 1");
    let (dir, said) = broken("crushed", &scene, &["--on-failure", "retry"]);
    assert!(said.contains("is turned inside out") && said.contains("try NeoHookean"), "{said}");
    let tries = retries(&dir);
    for (k, share) in ["0.5", "0.25", "0.125"].iter().enumerate() {
        assert!(tries[k].contains(&format!("with {share} of the sub-step")), "{tries:?}");
    }
    assert_eq!(tries.len(), 3);
    comes_again(&dir, &said);
}

/// The plot of energies that have not changed yet could not be drawn, which was told instead of the failure.
#[test]
fn a_failure_in_the_first_step_is_told() {
    let (dir, said) = broken("at-once", &bar("at-once", "saint_venant", "40.0", ""), &[]);
    assert!(said.contains("structure 0 at t = 0e0 s: particle "), "{said}");
    let summary = Summary::read(dir.join("summary.json")).unwrap();
    assert!(summary.status.contains("is turned inside out"), "{}", summary.status);
    comes_again(&dir, &said);
}
