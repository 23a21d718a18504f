//! The plots against the reference and summary.json.

use crate::observe::{Observer, Sample};
use crate::reference::{SOURCE, Swing};
use crate::setup::{Channel, Settings};
use mps_examples::harmonics::harmonic;
use mps_examples::series::extremes;
use mps_examples::{Failure, enter_compressibility, enter_results};
use mps_io::{CurvePlot, Metric, Summary};
use mps_kernel::Real;
use std::path::Path;

/// Share of the run at whose end results are read off: many periods of an oscillation, and of a steady flow many of the slow
/// swings that the noise of the particles stirs up.
const READ_SHARE: f64 = 0.5;

/// What is read off, its name and unit.
type Quantity = (&'static str, &'static str, fn(&Sample) -> f64, Swing);

fn quantities(settings: &Settings) -> Vec<Quantity> {
    let reference = settings.test.reference();
    let mut quantities: Vec<Quantity> = vec![
        ("drag", "N/m", |s| s.force[0], reference.drag),
        ("lift", "N/m", |s| s.force[1], reference.lift),
    ];
    if settings.test.rubber().is_some() {
        quantities.push(("ux", "m", |s| s.end[0], reference.ux));
        quantities.push(("uy", "m", |s| s.end[1], reference.uy));
    }
    quantities
}

/// Each quantity over time, with the band of the reference.
pub(crate) fn plots<T: Real>(dir: &Path, settings: &Settings, observer: &Observer<T>) -> Result<(), Failure> {
    let time: Vec<f64> = observer.samples.iter().map(|s| s.time).collect();
    for (name, unit, value, reference) in quantities(settings) {
        let values: Vec<f64> = observer.samples.iter().map(value).collect();
        let span = [0.0, settings.end_time];
        let title =
            format!("{}: {name}, l₀ = {} mm", settings.test.name().to_uppercase(), settings.spacing * 1e3);
        let mut plot = CurvePlot::new(&title, "time [s]", &format!("{name} [{unit}]"))
            .line("this run", &time, &values)
            .dashed(&format!("mean, {SOURCE}"), &span, &[reference.mean; 2]);
        if reference.amplitude > 0.0 {
            plot = plot.dashed("largest", &span, &[reference.mean + reference.amplitude; 2]).dashed(
                "smallest",
                &span,
                &[reference.mean - reference.amplitude; 2],
            );
        }
        plot.write_png(dir.join(format!("{name}.png")))?;
    }
    Ok(())
}

/// Settings and results, whether the run was completed or not.
pub(crate) fn summary<T: Real>(settings: &Settings, scene: &Channel<T>, observer: &Observer<T>) -> Summary {
    let mut summary = Summary::new("turek-hron", env!("CARGO_PKG_VERSION"));
    let config = scene.fluid().config();
    summary.set("test", settings.test.name());
    summary.set("spacing_m", settings.spacing);
    summary.set("end_time_s", settings.end_time);
    summary.set("particles_across", settings.across);
    summary.set("length_m", settings.length);
    summary.set("sound_speed_m_s", settings.sound_speed());
    summary.set("cfl", settings.cfl);
    summary.set("pressure_level_pa", settings.level());
    summary.set("density_diffusion", config.diffusion.delta().to_double());
    summary.set("radius_ratio", config.radius_ratio.to_double());
    summary.set("shifting_parts", settings.shifting);
    summary.set("density_relaxation", settings.relaxation);
    let boundary = scene.fluid().boundary();
    summary.particles.insert("fluid".into(), scene.fluid().particles().position.len() as u64);
    summary.particles.insert("wall".into(), boundary.reactive().start as u64);
    summary.particles.insert("structure".into(), boundary.reactive().len() as u64);

    let end = observer.samples.last().map_or(0.0, |s| s.time);
    let start = observer.samples.partition_point(|s| s.time < end * (1.0 - READ_SHARE));
    let read = &observer.samples[start..];
    let time: Vec<f64> = read.iter().map(|s| s.time).collect();
    for (name, unit, value, reference) in quantities(settings) {
        let values: Vec<f64> = read.iter().map(value).collect();
        let (known, elsewhere): (Vec<_>, Vec<_>) =
            results(settings, name, unit, &time, &values, &reference).into_iter().partition(|(_, metric)| {
                let periods =
                    time.last().zip(time.first()).map_or(0.0, |(a, b)| (a - b) * reference.frequency);
                metric.is_some() || settings.test.is_steady() || periods < 2.0
            });
        enter_results(&mut summary, known);
        let words = "no harmonic within a third of the frequency of the reference";
        summary.notes.extend(elsewhere.iter().map(|(name, _)| format!("{name}: {words}")));
    }
    let residual = Metric::new(scene.budget().residual.to_double(), "-");
    enter_results(&mut summary, [("interface_momentum_residual".to_owned(), Some(residual))]);
    enter_compressibility(&mut summary, scene.fluid());
    summary
}

/// Mean of what is steady; of what oscillates mean, amplitude and frequency of the harmonic near that of the reference, and the root mean
/// square of the rest.
fn results(
    settings: &Settings,
    name: &str,
    unit: &str,
    time: &[f64],
    values: &[f64],
    reference: &Swing,
) -> Vec<(String, Option<Metric>)> {
    let compared =
        |value: f64, unit: &str, reference: f64| Metric::new(value, unit).compared_with(reference, SOURCE);
    if settings.test.is_steady() {
        let mean = (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64);
        let spread = extremes(values).map(|[low, high]| Metric::new(high - low, unit));
        return vec![
            (format!("{name}_mean"), mean.map(|mean| compared(mean, unit, reference.mean))),
            (format!("{name}_spread"), spread),
        ];
    }
    let found = harmonic(time, values, reference.frequency);
    vec![
        (format!("{name}_mean"), found.map(|h| compared(h.mean, unit, reference.mean))),
        (format!("{name}_amplitude"), found.map(|h| compared(h.amplitude, unit, reference.amplitude))),
        (format!("{name}_frequency"), found.map(|h| compared(h.frequency, "Hz", reference.frequency))),
        (format!("{name}_rest"), found.map(|h| Metric::new(h.rest, unit))),
    ]
}
