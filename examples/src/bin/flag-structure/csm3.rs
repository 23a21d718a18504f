//! CSM3: the flag is let go and swings for ever.

use crate::options::Options;
use crate::{Settings, WRITTEN, look, plots};
use mps_examples::series::{Oscillation, oscillation};
use mps_examples::solid::flag::{CSM3, CSM3_FIRST, CSM3_FIRST_END, RUBBER, SOURCE, end, flag, gravity};
use mps_examples::solid::{Motion, Pictures, Sample};
use mps_examples::{Failure, Watch, conclude, enter_results, record, remove_leftovers};
use mps_io::{Metric, Summary};
use mps_kernel::Real;
use std::path::Path;

/// Rows of probes.csv in a period of the reference.
pub(crate) const SAMPLES: f64 = 400.0;
/// Frames of the film in a period.
pub(crate) const FRAMES: f64 = 20.0;
/// The period of the reference \[s\].
pub(crate) const PERIOD: f64 = 1.0 / CSM3[1][2];

pub(crate) fn run<T: Real>(options: &Options, settings: &Settings, dir: &Path) -> Result<(), Failure> {
    let parallel = options.common.parallel()?;
    let flag = flag::<T>(settings.across, settings.clamp, &RUBBER, &parallel)?;
    let mut look = look(options.test, settings);
    (look.frame, look.stills) = (PERIOD / FRAMES, vec![("lowest", 0.5 * PERIOD), ("highest", PERIOD)]);
    remove_leftovers(dir, WRITTEN)?;
    let pictures = if options.common.no_fields { None } else { Some(Pictures::new(dir, look)?) };
    let mut motion = Motion::new(flag, end(), gravity(), PERIOD / SAMPLES, &parallel)?
        .with_table(dir)?
        .with_pictures(pictures);
    let (until, watch, mut seconds) = (settings.end_time, Watch::begin(dir, &options.common)?, 0.0);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| record(&mut motion, until, &watch, &mut seconds));

    // Whatever happened, what has been computed is kept.
    plots::motion(dir, settings, motion.samples())?;
    let mut summary = options.summary(settings, motion.solid());
    summary.set("end_time_s", settings.end_time);
    summary.set("substep_s", motion.substep());
    motion.cost(seconds).enter(&mut summary, &options.common, done.as_ref().err());
    enter(&mut summary, motion.samples());
    conclude(dir, &summary, &options.common, done.is_ok())?;
    done
}

/// Mean, amplitude and frequency of both components, and what became of the energy.
fn enter(summary: &mut Summary, samples: &[Sample]) {
    let time: Vec<f64> = samples.iter().map(|s| s.time).collect();
    for (axis, name) in ["ux", "uy"].into_iter().enumerate() {
        let tip: Vec<f64> = samples.iter().map(|s| s.tip[axis]).collect();
        let found = oscillation(&time, &tip);
        let number = |unit: &str, k: usize, value: fn(&Oscillation) -> f64| {
            found.as_ref().map(|found| Metric::new(value(found), unit).compared_with(CSM3[axis][k], SOURCE))
        };
        let early = time.partition_point(|t| *t < CSM3_FIRST_END);
        let first = oscillation(&time[..early], &tip[..early]);
        let of_first = |k: usize, value: fn(&Oscillation) -> f64| {
            let source = "first swing of the series of Turek and Hron 2006";
            first.as_ref().map(|o| Metric::new(value(o), "m").compared_with(CSM3_FIRST[axis][k], source))
        };
        enter_results(
            summary,
            [
                (format!("{name}_mean_first"), of_first(0, |o| o.mean)),
                (format!("{name}_amplitude_first"), of_first(1, |o| o.amplitude)),
                (format!("{name}_mean"), number("m", 0, |o| o.mean)),
                (format!("{name}_amplitude"), number("m", 1, |o| o.amplitude)),
                (format!("{name}_frequency"), number("Hz", 2, |o| 1.0 / o.period)),
            ],
        );
    }
    // The energy is zero at the start; what moves is what gravity gives on the way down.
    let given = samples.iter().map(|s| -s.energy.potential).fold(0.0, f64::max);
    let start = samples.first().map_or(0.0, |s| s.energy.total());
    let drift = samples.iter().map(|s| (s.energy.total() - start).abs()).fold(0.0, f64::max) / given;
    let kept = Metric::new(drift, "-").compared_with(0.0, "the energy is kept");
    enter_results(summary, [("energy_drift".to_owned(), drift.is_finite().then_some(kept))]);
}
