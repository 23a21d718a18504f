//! The plot against the experiment and summary.json.

use crate::beside::Earlier;
use crate::observe::Observer;
use crate::options::Options;
use crate::reference::EXPERIMENT;
use crate::setup::{FreeEnd, GateScene, Settings, sound_speed};
use mps_examples::{Cost, Failure, enter_compressibility};
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
    let largest = |d: &dyn Fn(&FreeEnd) -> f64| {
        observer.end.iter().fold((0.0, 0.0), |best, (t, e)| if d(e) > best.0 { (d(e), *t) } else { best })
    };
    let (x, x_time) = largest(&|e| e.corner[0]);
    let (y, _) = largest(&|e| e.corner[1]);
    let (middle_x, _) = largest(&|e| e.middle[0]);
    let (middle_y, _) = largest(&|e| e.middle[1]);
    let mut put = |name: &str, metric: Metric| summary.metrics.insert(name.to_owned(), metric);
    put("gate_x_max", Metric::new(x, "m").compared_with(published.x, published.source));
    put("gate_y_max", Metric::new(y, "m").compared_with(published.y, published.source));
    put("gate_middle_x_max", Metric::new(middle_x, "m"));
    put("gate_middle_y_max", Metric::new(middle_y, "m"));
    put(
        "gate_x_max_time",
        Metric::new(x_time, "s").compared_with(0.16, "Antoci, Gallati, Sibilla 2007 (experiment)"),
    );
    put("gate_x_rms_experiment", Metric::new(rms_against_experiment(&observer.end), "m"));
    put("interface_momentum_residual", Metric::new(scene.budget().residual.to_double(), "-"));
    put("leaked_particles", Metric::new(observer.leaked() as f64, "-").compared_with(0.0, "no leak"));
    put(
        "energy_closure",
        Metric::new(observer.energy_rise, "-").compared_with(0.0, "total energy never rises"),
    );
    put("energy_dissipated", Metric::new(observer.dissipated(), "-"));
    if let Some(bytes) = summary.peak_memory_bytes {
        let all = cost.particles + boundary.len();
        let share = Metric::new(bytes as f64 / all as f64, "B");
        summary.metrics.insert("peak_memory_per_particle".to_owned(), share);
    }
    enter_compressibility(&mut summary, scene.fluid());
    summary
}

/// Root mean square distance of the x displacement from the experiment's points reached \[m\].
fn rms_against_experiment(end: &[(f64, FreeEnd)]) -> f64 {
    let mut sum = 0.0;
    let mut count = 0;
    for &(t, x, _) in EXPERIMENT {
        let after = end.partition_point(|e| e.0 < t);
        let (Some(a), Some(b)) = (after.checked_sub(1).and_then(|k| end.get(k)), end.get(after)) else {
            continue;
        };
        let run = a.1.corner[0] + (b.1.corner[0] - a.1.corner[0]) * (t - a.0) / (b.0 - a.0);
        sum += (run - x) * (run - x);
        count += 1;
    }
    (sum / f64::from(count.max(1))).sqrt()
}
