//! What is refused before anything is built: numbers without sense, shapes without inside, names nobody has.

mod fixed;
mod openings;
mod output;
mod phases;
mod probes;
mod regions;
mod walls;
mod watch;
mod whole;

use super::scene::SceneFile;
use super::source::{Problem, SceneError, Source};
use toml::de::DeValue;

/// Cells of a lattice beyond which a region is refused: of plane fluid they take 7 GB (docs/performance.md).
const MOST_CELLS: f64 = 1e7;

/// Collects what is wrong.
struct Checker<'a> {
    source: &'a Source,
    dimension: usize,
    problems: Vec<Problem>,
}

impl Checker<'_> {
    /// Refuses `key` unless `good`.
    fn unless(&mut self, good: bool, key: &str, what: impl Into<String>, remedy: impl Into<String>) {
        if !good {
            self.problems.push(self.source.problem(key, what, remedy));
        }
    }

    /// Refuses what is not above zero.
    fn positive(&mut self, value: f64, key: &str, remedy: &str) {
        self.unless(value > 0.0, key, format!("is {value}"), remedy);
    }

    /// Refuses what is not within the range, its ends included.
    fn within(&mut self, value: f64, [low, high]: [f64; 2], key: &str, remedy: &str) {
        self.unless(value >= low && value <= high, key, format!("is {value}"), remedy);
    }

    /// Refuses what there is not in as many dimensions as the scene has.
    fn only_in(&mut self, dimension: usize, key: &str, remedy: &str) -> bool {
        let (good, has) = (self.dimension == dimension, self.dimension);
        let what = format!("exists in {dimension} dimensions only, and the scene has {has}");
        self.unless(good, key, what, remedy);
        good
    }

    /// Refuses what has not one number per dimension.
    fn point(&mut self, point: &[f64], key: &str) -> bool {
        let (found, wanted) = (point.len(), self.dimension);
        let good = found == wanted;
        self.unless(good, key, format!("has {found} of {wanted} numbers"), "give one number per dimension");
        good
    }

    /// As [`point`](Self::point), and may be left out.
    fn vector(&mut self, vector: &[f64], key: &str) {
        if !vector.is_empty() {
            self.point(vector, key);
        }
    }
}

/// Refuses a scene that cannot be run.
pub(super) fn check(scene: &SceneFile, source: &Source) -> Result<(), SceneError> {
    let mut checker = Checker { source, dimension: scene.dimension, problems: not_finite(source) };
    // What follows compares numbers, and may take them to be some.
    if checker.problems.is_empty() {
        checker.whole(scene);
    }
    if checker.problems.is_empty() { Ok(()) } else { Err(SceneError::Refused(checker.problems)) }
}

/// TOML knows `nan` and `inf`, and 1e999 is read as infinity.
fn not_finite(source: &Source) -> Vec<Problem> {
    let mut problems = Vec::new();
    source.walk(|key, value| {
        if let DeValue::Float(number) = value.get_ref()
            && !number.as_str().replace('_', "").parse().is_ok_and(f64::is_finite)
        {
            let what = format!("is {}", number.as_str());
            problems.push(source.problem_at(value.span(), key, what, "give a finite number"));
        }
    });
    problems
}
