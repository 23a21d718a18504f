//! What a run is watched for.

use super::super::watch::{OnFailure, Watch};
use super::Checker;

/// Steps beyond which what is remembered is too much to read, or to go back.
const MOST_STEPS: f64 = 1e4;
/// Failures beyond which halved steps are of no use: a millionth of the usual.
const MOST_TIMES: f64 = 20.0;

impl Checker<'_> {
    pub(super) fn watch(&mut self, watch: &Watch) {
        let Watch { steps, collapse, energy_rise, mach, on_failure, on_mach: _, region } = watch;
        self.within(f64::from(*steps), [1.0, MOST_STEPS], "watch.steps", "give 1 to 10000 steps, usually 50");
        let remedy = "give a share from 0 to 0.5, usually 0.01, or 0 for not watched";
        self.within(*collapse, [0.0, 0.5], "watch.collapse", remedy);
        let remedy = "give the largest rise in a step (J, in two dimensions J/m), or leave it out";
        self.positive(energy_rise.unwrap_or(1.0), "watch.energy_rise", remedy);
        self.positive(*mach, "watch.mach", "give a speed over that of sound, usually 0.3");
        if let Some(region) = region {
            self.corners(region, "watch.region");
        }
        if let OnFailure::Retry(retry) = on_failure {
            for (name, value, most) in [("steps", retry.steps, 1e6), ("times", retry.times, MOST_TIMES)] {
                let (key, value) = (format!("watch.on_failure.retry.{name}"), f64::from(value));
                self.within(value, [1.0, most], &key, &format!("give a whole number from 1 to {most}"));
            }
        }
    }
}
