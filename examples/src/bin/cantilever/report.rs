//! The plots against beam theory and finite elements, and summary.json.

use crate::options::Options;
use core::f64::consts::TAU;
use mps_examples::solid::plate::{
    AMPLITUDE, BULK, DENSITY, ELEMENTS, LENGTH, PERIOD, SHEAR, TIP_SPEED, beam_frequency, sound_speed, swing,
    unit_of_time,
};
use mps_examples::solid::{Motion, Sample};
use mps_examples::{Cost, Failure, enter_results};
use mps_io::{CurvePlot, Metric, Summary};
use mps_kernel::Real;
use mps_solid::ConstitutiveModel;
use std::path::Path;

/// Tip and energies over time.
pub(crate) fn plot(dir: &Path, across: usize, samples: &[Sample]) -> Result<(), Failure> {
    let time: Vec<f64> = samples.iter().map(|s| s.time / unit_of_time()).collect();
    let column = |value: &dyn Fn(&Sample) -> f64| samples.iter().map(value).collect::<Vec<_>>();
    let curve = |value: &dyn Fn(f64) -> f64| time.iter().map(|t| value(*t)).collect::<Vec<_>>();
    let beam = beam_frequency() * unit_of_time();
    let title = |what: &str| format!("{what}, {across} particles across");
    CurvePlot::new(&title("Tip of the vibrating plate"), "t c/L [–]", "deflection u/L [–]")
        .line("this run", &time, &column(&|s| s.tip[1] / LENGTH))
        .dashed("Euler-Bernoulli, plane strain", &time, &curve(&|t| TIP_SPEED / beam * (beam * t).sin()))
        .dashed(
            "harmonic with the period and amplitude of the finite elements",
            &time,
            &curve(&|t| AMPLITUDE * (TAU / PERIOD * t).sin()),
        )
        .write_png(dir.join("tip.png"))?;

    let start = samples.first().map_or(1.0, |s| s.energy.total());
    CurvePlot::new(&title("Energy of the vibrating plate"), "t c/L [–]", "energy over that at the start [–]")
        .line("kinetic", &time, &column(&|s| s.energy.kinetic / start))
        .line("strain", &time, &column(&|s| (s.energy.strain + s.energy.bending) / start))
        .line("total", &time, &column(&|s| s.energy.total() / start))
        .write_png(dir.join("energy.png"))?;
    CurvePlot::new(&title("Energy of the vibrating plate"), "t c/L [–]", "change of the total energy [–]")
        .line("total", &time, &column(&|s| s.energy.total() / start - 1.0))
        .write_png(dir.join("energy_error.png"))?;
    Ok(())
}

/// Settings, cost and results, whether the run was completed or not.
pub(crate) fn summary<T: Real, M: ConstitutiveModel<T, 2>>(
    options: &Options,
    across: usize,
    motion: &Motion<T, M>,
    cost: &Cost,
    failure: Option<&Failure>,
) -> Summary {
    let mut summary = Summary::new("cantilever", env!("CARGO_PKG_VERSION"));
    let solid = motion.solid();
    summary.set("particles_across", across);
    summary.set("spacing_m", solid.spacing().max().to_double());
    summary.set("end_time_s", options.end_time());
    summary.set("material", solid.material().name());
    summary.set("density_kg_m3", DENSITY);
    summary.set("bulk_modulus_pa", BULK);
    summary.set("shear_modulus_pa", SHEAR);
    summary.set("tip_speed_over_sound_speed", TIP_SPEED);
    summary.set("sound_speed_m_s", sound_speed());
    summary.set("substep_s", motion.substep());
    summary.set("radius_ratio", solid.config().radius_ratio.to_double());
    summary.set("cfl", solid.config().cfl.to_double());
    summary.particles.insert("solid".into(), solid.len() as u64);
    cost.enter(&mut summary, &options.common, failure);
    let results = results(motion.samples());
    enter_results(&mut summary, results.map(|(name, metric)| (name.to_owned(), metric)));
    summary
}

/// Results by name; `None` where the run has not come so far.
fn results(samples: &[Sample]) -> [(&'static str, Option<Metric>); 4] {
    // One extreme is no amplitude: the second comes after three quarters of a period.
    let swing = swing(samples);
    let amplitude =
        swing.filter(|[period, _]| samples.last().is_some_and(|s| s.time > 0.8 * period * unit_of_time()));
    let start = samples.first().map_or(1.0, |s| s.energy.total());
    let change = |s: &Sample| s.energy.total() / start - 1.0;
    let drift = samples.iter().map(|s| change(s).abs()).fold(0.0, f64::max);
    let kept = |value: f64| Metric::new(value, "-").compared_with(0.0, "the energy is kept");
    [
        ("period", swing.map(|[t, _]| Metric::new(t, "-").compared_with(PERIOD, ELEMENTS))),
        ("amplitude", amplitude.map(|[_, a]| Metric::new(a, "-").compared_with(AMPLITUDE, ELEMENTS))),
        ("energy_drift", Some(kept(drift))),
        ("energy_trend", trend(samples, change).map(kept)),
    ]
}

/// Mean over the last period less that over the first; `None` if there are not two.
fn trend(samples: &[Sample], value: impl Fn(&Sample) -> f64) -> Option<f64> {
    let period = PERIOD * unit_of_time();
    let end = samples.last()?.time;
    if end < 2.0 * period {
        return None;
    }
    let mean = |part: &[Sample]| part.iter().map(&value).sum::<f64>() / part.len() as f64;
    let first = samples.partition_point(|s| s.time < period);
    let last = samples.partition_point(|s| s.time <= end - period);
    Some(mean(&samples[last..]) - mean(&samples[..first]))
}
