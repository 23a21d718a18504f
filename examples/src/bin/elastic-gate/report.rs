//! The plot against the experiment and summary.json.

use crate::beside::Earlier;
use crate::observe::Observer;
use crate::options::Options;
use crate::reference::{EXPERIMENT, EXPERIMENT_MAXIMUM, EXPERIMENT_MAXIMUM_TIME};
use crate::setup::{FreeEnd, GateScene, Settings, sound_speed};
use mps_examples::{Cost, Failure, enter_compressibility, enter_results};
use mps_io::{CurvePlot, Metric, Summary};
use mps_kernel::{Kernel, Real};
use std::path::Path;

/// Displacement of the free end over time, with the experiment's points and the published maximum.
pub(crate) fn plot<T: Real>(
    dir: &Path,
    options: &Options,
    observer: &Observer<T>,
    earlier: &[Earlier],
) -> Result<(), Failure> {
    let column = |f: &dyn Fn(&(f64, FreeEnd)) -> f64| observer.end.iter().map(f).collect::<Vec<_>>();
    let time = column(&|e| e.0);
    let (x, y) = (column(&|e| e.1.corner[0] * 1e3), column(&|e| e.1.corner[1] * 1e3));
    let measured = |f: &dyn Fn(&(f64, f64, f64)) -> f64| EXPERIMENT.iter().map(f).collect::<Vec<_>>();
    let (te, xe, ye) = (measured(&|e| e.0), measured(&|e| e.1 * 1e3), measured(&|e| e.2 * 1e3));
    let published = options.material.published();
    let rubber = options.material.rubber();
    let title = format!(
        "Free end of the elastic gate: {:.0} kg/m³, {:.1} MPa, ν = {:.2}, l₀ = {:.2} mm",
        rubber.density,
        rubber.youngs_modulus * 1e-6,
        rubber.poissons_ratio,
        options.spacing * 1e3
    );
    let span = [0.0, options.end_time.max(0.36)];
    let mut curves = CurvePlot::new(&title, "time [s]", "displacement [mm]")
        .line("x of the outer corner, this run", &time, &x)
        .line("y of the outer corner, this run", &time, &y);
    for run in earlier {
        curves = curves.line(&format!("x, {}", run.label), &run.time, &run.x).line(
            &format!("y, {}", run.label),
            &run.time,
            &run.y,
        );
    }
    curves
        .points("x, Antoci et al. 2007 (experiment)", &te, &xe)
        .points("y, Antoci et al. 2007 (experiment)", &te, &ye)
        .dashed(&format!("x maximum, {}", published.source), &span, &[published.x * 1e3; 2])
        .dashed(&format!("y maximum, {}", published.source), &span, &[published.y * 1e3; 2])
        .write_png(dir.join("gate.png"))?;
    Ok(())
}

/// Settings, cost and results, whether the run was completed or not.
pub(crate) fn summary<T: Real, K: Kernel<T>>(
    options: &Options,
    settings: &Settings,
    scene: &GateScene<T, K>,
    observer: &Observer<T>,
    cost: &Cost,
    failure: Option<&Failure>,
) -> Summary {
    let mut summary = Summary::new("elastic-gate", env!("CARGO_PKG_VERSION"));
    summary.set("spacing_m", settings.spacing);
    summary.set("end_time_s", settings.end_time);
    summary.set("material", options.material.name());
    summary.set("gate_density_kg_m3", settings.rubber.density);
    summary.set("gate_youngs_modulus_pa", settings.rubber.youngs_modulus);
    summary.set("gate_poissons_ratio", settings.rubber.poissons_ratio);
    summary.set("particles_across_gate", settings.across);
    summary.set("sound_speed_m_s", sound_speed(settings));
    summary.set("cfl", settings.cfl);
    summary.set("artificial_viscosity", settings.alpha);
    summary.set("shifting_parts", settings.shifting);
    summary.set("pressure_form", if options.corrected { "corrected" } else { "plain" });
    summary.set("density_diffusion", scene.fluid().config().diffusion.delta().to_double());
    summary.set("weight", scene.fluid().kernel().name());
    summary.set("collisions", settings.collisions);
    summary.set("min_substeps", settings.min_substeps);
    summary.set("radius_ratio", scene.fluid().config().radius_ratio.to_double());
    let boundary = scene.fluid().boundary();
    summary.particles.insert("fluid".into(), cost.particles as u64);
    summary.particles.insert("wall".into(), boundary.reactive().start as u64);
    summary.particles.insert("structure".into(), boundary.reactive().len() as u64);
    cost.enter(&mut summary, &options.common, failure);

    let published = options.material.published();
    let x = largest(&observer.end, |e| e.corner[0]);
    let of_maximum = |displacement: fn(&FreeEnd) -> f64| {
        largest(&observer.end, displacement).map(|(value, _)| Metric::new(value, "m"))
    };
    let time = x.map(|(_, time)| {
        Metric::new(time, "s").compared_with(EXPERIMENT_MAXIMUM_TIME, EXPERIMENT_MAXIMUM.source)
    });
    let rms = rms_against_experiment(&observer.end).map(|rms| Metric::new(rms, "m"));
    let results = [
        ("gate_x_max", of_maximum(|e| e.corner[0]).map(|m| m.compared_with(published.x, published.source))),
        ("gate_y_max", of_maximum(|e| e.corner[1]).map(|m| m.compared_with(published.y, published.source))),
        ("gate_middle_x_max", of_maximum(|e| e.middle[0])),
        ("gate_middle_y_max", of_maximum(|e| e.middle[1])),
        ("gate_x_max_time", time),
        ("gate_x_rms_experiment", rms),
    ];
    enter_results(&mut summary, results.map(|(name, metric)| (name.to_owned(), metric)));
    let mut put = |name: &str, metric: Metric| summary.metrics.insert(name.to_owned(), metric);
    put("interface_momentum_residual", Metric::new(scene.budget().residual.to_double(), "-"));
    put("leaked_particles", Metric::new(observer.leaked() as f64, "-").compared_with(0.0, "no leak"));
    put("energy_rise", Metric::new(observer.energy_rise, "-").compared_with(0.0, "total energy never rises"));
    put("energy_dissipated", Metric::new(observer.dissipated(), "-"));
    if let Some(bytes) = summary.peak_memory_bytes {
        let all = cost.particles + boundary.len();
        let share = Metric::new(bytes as f64 / all as f64, "B");
        summary.metrics.insert("peak_memory_per_particle".to_owned(), share);
    }
    enter_compressibility(&mut summary, scene.fluid());
    summary
}

/// How long a displacement has to stay below its largest value for that to be a maximum \[s\]: an eighth of the way there. Before, the gate
/// is still opening.
const PASSED: f64 = 0.02;

/// Largest value \[m\] of a displacement, and when \[s\]; `None` if the run has not passed it.
fn largest(end: &[(f64, FreeEnd)], displacement: impl Fn(&FreeEnd) -> f64) -> Option<(f64, f64)> {
    let (last, _) = end.last()?;
    let values = end.iter().map(|(time, end)| (displacement(end), *time));
    let (value, time) = values.fold((0.0, 0.0), |best, next| if next.0 > best.0 { next } else { best });
    (last - time >= PASSED && value > 0.0).then_some((value, time))
}

/// Root mean square distance of the x displacement from the experiment's points \[m\]; `None` if the run has not come to the last of them.
fn rms_against_experiment(end: &[(f64, FreeEnd)]) -> Option<f64> {
    let mut sum = 0.0;
    for &(t, x, _) in EXPERIMENT {
        let after = end.partition_point(|e| e.0 < t);
        let (a, b) = (end.get(after.checked_sub(1)?)?, end.get(after)?);
        let run = a.1.corner[0] + (b.1.corner[0] - a.1.corner[0]) * (t - a.0) / (b.0 - a.0);
        sum += (run - x) * (run - x);
    }
    Some((sum / EXPERIMENT.len() as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gate that opens by as much as in the experiment until 0.16 s and then closes.
    fn run(until: f64) -> Vec<(f64, FreeEnd)> {
        let end = |t: f64| FreeEnd { corner: [0.0464 * (10.0 * t).sin(), 0.0], ..FreeEnd::default() };
        (0..=1000).map(|k| f64::from(k) * 1e-3).filter(|t| *t <= until).map(|t| (t, end(t))).collect()
    }

    #[test]
    fn a_maximum_is_one_that_has_been_passed() {
        let x = |until: f64| largest(&run(until), |e| e.corner[0]);
        assert!(
            x(0.02).is_none() && x(0.15).is_none() && x(0.16).is_none() && largest(&[], |_| 1.0).is_none()
        );
        let (value, time) = x(0.2).unwrap();
        assert!((value - 0.0464).abs() < 1e-5 && (time - 0.157).abs() < 1e-9, "{value} at {time}");
        // It does not move up at all.
        assert!(largest(&run(0.4), |e| e.corner[1]).is_none());
    }

    #[test]
    fn the_distance_from_the_experiment_is_that_from_all_its_points() {
        assert_eq!(rms_against_experiment(&run(0.02)), None);
        assert_eq!(rms_against_experiment(&run(0.3)), None);
        assert!(rms_against_experiment(&run(0.4)).is_some_and(|rms| rms > 0.0));
    }
}
