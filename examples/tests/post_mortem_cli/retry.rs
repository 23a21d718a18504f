//! Runs that go back from a failure and try shorter steps.

use super::*;

/// What a run says of the failures from which it has gone back.
pub(crate) fn retries(dir: &Path) -> Vec<String> {
    let notes = Summary::read(dir.join("summary.json")).unwrap().notes;
    notes.into_iter().filter(|note| note.starts_with("retry ")).collect()
}

/// The table has no time twice, although the run has gone back.
pub(crate) fn assert_in_order(dir: &Path) {
    let table = CsvTable::read(dir.join("probes.csv")).unwrap();
    assert!(table.columns[0].is_sorted_by(|a, b| a < b));
}

#[test]
fn a_run_passes_with_shorter_steps_what_stops_it_otherwise() {
    let scene = water("passed", &unstable("1.0"), "");
    broken("not-passed", &scene, &[]);
    let dir = fresh("post-mortem", "passed");
    let run = ["run", scene.to_str().unwrap(), "--on-failure", "retry", "--quiet", "--threads", "1"];
    let output = execute(MPS, &dir, &run);
    assert!(output.status.success(), "{}", words(&output.stderr));
    let tries = retries(&dir);
    assert!(!tries.is_empty() && tries.len() <= 3, "{tries:?}");
    assert!(tries[0].contains("with 0.5 of the Courant number"), "{tries:?}");
    assert_eq!(Summary::read(dir.join("summary.json")).unwrap().status, "completed");
    assert!(!dir.join("post-mortem").exists());
    assert_in_order(&dir);
    // The run says what it is, and is the same again on any number of threads.
    let again = fresh("post-mortem", "passed-again");
    let scene = dir.join("scene.toml");
    let output = execute(MPS, &again, &["run", scene.to_str().unwrap(), "--quiet", "--threads", "2"]);
    assert!(output.status.success(), "{}", words(&output.stderr));
    let [one, other] = [&dir, &again].map(|dir| std::fs::read(dir.join("probes.csv")).unwrap());
    assert!(one == other && retries(&again) == tries);
}

/// The fluid takes shorter steps than this Courant number asks for, and half of it would be the same steps again.
#[test]
fn a_retry_halves_the_steps_that_were_taken() {
    let scene = water("capped", &unstable("2.0"), "");
    let dir = fresh("post-mortem", "capped");
    let run = ["run", scene.to_str().unwrap(), "--on-failure", "retry", "--quiet", "--threads", "1"];
    execute(MPS, &dir, &run);
    let failures: Vec<_> =
        retries(&dir).iter().map(|note| note.split_once("after: ").unwrap().1.to_owned()).collect();
    assert!(!failures.is_empty() && failures.windows(2).all(|pair| pair[0] != pair[1]), "{failures:?}");
}

/// Shorter steps are part of the state: a run that is stopped while it makes them makes them when it is resumed.
#[test]
fn a_run_that_goes_on_within_shorter_steps_has_the_same_bits() {
    let retry = "[watch]\non_failure = { retry = { steps = 1000000, times = 3 } }\n";
    let scene = water("slow", &unstable("1.1"), retry);
    let run = |name: &str, more: &[&str]| {
        let dir = fresh("post-mortem", name);
        let arguments = ["run", scene.to_str().unwrap(), "--no-fields", "--quiet", "--threads", "1"];
        let output = execute(MPS, &dir, &[&arguments[..], more].concat());
        assert!(output.status.success(), "{}", words(&output.stderr));
        dir
    };
    let (whole, parts) = (run("slow-whole", &[]), run("slow-parts", &["--end-time", "0.4"]));
    let tries = retries(&parts);
    assert!(!tries.is_empty(), "the first part has gone back");
    let resume = ["--end-time", "0.5", "--quiet", "--threads", "2"];
    let output = Command::new(MPS).arg("resume").arg(&parts).args(resume).output().unwrap();
    assert!(output.status.success(), "{}", words(&output.stderr));
    assert_eq!(
        (retries(&whole), retries(&parts)),
        (tries.clone(), tries),
        "nothing fails in the second part"
    );
    let [one, other] = [&whole, &parts].map(|dir| std::fs::read(dir.join("probes.csv")).unwrap());
    assert!(one == other);
}

#[test]
fn a_run_that_cannot_be_passed_gives_up_after_its_tries() {
    // Steps of a quarter have not collapsed: they are shorter on purpose.
    let retry = "collapse = 0.3\non_failure = { retry = { steps = 40, times = 2 } }\n";
    let scene = water("given-up", CALM, &[REGION, retry].concat());
    let (dir, said) = broken("given-up", &scene, &[]);
    assert!(said.contains("has left the region"), "{said}");
    let tries = retries(&dir);
    assert_eq!(tries.len(), 2, "{tries:?}");
    assert!(tries[0].contains("with 0.5 of the Courant number"), "{tries:?}");
    assert!(tries[1].contains("with 0.25 of the Courant number"), "{tries:?}");
    assert!(tries[1].contains("has left the region"), "{tries:?}");
    assert_in_order(&dir);
    comes_again(&dir, &said);
    // The flag of the run outdoes the scene.
    let (dir, _) = broken("not-tried", &scene, &["--on-failure", "stop"]);
    assert!(retries(&dir).is_empty());
}
