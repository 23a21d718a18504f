//! The plots against the experiment and summary.json.

use crate::metrics::{
    arrival, band_fraction, first_peak, front_error, impact_mean, large_sensor_mean, measured_impact,
    pressure_noise,
};
use crate::observe::{Observer, Sample};
use crate::options::Options;
use crate::reference::{FRONT, LARGE_SENSOR, SENSORS, SOURCE};
use crate::sensors::HEIGHTS;
use crate::setup::{
    DamBreak, HEIGHT, LENGTH, OPENING_TIME, Release, Settings, TANK, TIME, Walls, sound_speed,
};
use mps_examples::{Cost, Failure, enter_compressibility, enter_results};
use mps_io::{CurvePlot, Metric, Summary};
use mps_kernel::{Kernel, Real};
use std::path::Path;

/// The front, and each sensor with the scatter of the experiments.
pub(crate) fn plot(dir: &Path, options: &Options, observer: &Observer) -> Result<(), Failure> {
    let end = options.end_time / TIME;
    let time: Vec<f64> = observer.samples.iter().map(|s| s.time).collect();
    let front: Vec<f64> = observer.samples.iter().map(|s| s.front).collect();
    let (t, x): (Vec<f64>, Vec<f64>) = FRONT.iter().copied().unzip();
    let spacing = options.spacing * 1e3;
    let wall = (TANK - LENGTH) / HEIGHT;
    CurvePlot::new(&format!("Front of the dam break, l₀ = {spacing} mm"), "t √(g/H) [–]", "x/H [–]")
        .line("this run", &time, &front)
        .points(SOURCE, &t, &x)
        .dashed("wall", &[0.0, 3.0], &[wall; 2])
        .x_range(0.0, end.clamp(0.1, 3.0))
        .y_range(0.0, 3.6)
        .write_png(dir.join("front.png"))?;

    energy_plot(options, observer, &time).write_png(dir.join("energy.png"))?;

    for (k, (sensor, height)) in SENSORS.iter().zip(HEIGHTS).enumerate() {
        let pressure: Vec<f64> = observer.samples.iter().map(|s| s.pressure[k]).collect();
        let column = |c: usize| sensor.points.iter().map(|p| p.0[c]).collect::<Vec<_>>();
        let title = format!("Pressure at sensor {}, z = {:.0} mm, l₀ = {spacing} mm", k + 1, height * 1e3);
        CurvePlot::new(&title, "t √(g/H) [–]", "p/(ρ g H) [–]")
            .band("experiment, 2.5 % to 97.5 % of the runs", &column(0), &column(2), &column(3))
            .line("this run", &time, &pressure)
            .dashed("experiment, median", &column(0), &column(1))
            // Into the view comes what the experiment covers; a short run shows what it has.
            .x_range(if end > 2.5 { 2.0 } else { 0.0 }, end.clamp(0.1, 7.05))
            .y_range(0.0, if k == 0 { 4.0 } else { 2.5 })
            .write_png(dir.join(format!("pressure_{}.png", k + 1)))?;
    }
    Ok(())
}

/// Settings, cost and results, whether the run was completed or not.
pub(crate) fn summary<T: Real, K: Kernel<T>>(
    options: &Options,
    settings: &Settings,
    dam: &DamBreak<T, K>,
    observer: &Observer,
    cost: &Cost,
    failure: Option<&Failure>,
) -> Summary {
    let mut summary = Summary::new("dam-break", env!("CARGO_PKG_VERSION"));
    let fluid = dam.fluid();
    summary.set("spacing_m", settings.spacing);
    summary.set("end_time_s", settings.end_time);
    let release = match settings.release {
        Release::Instant => "instant",
        Release::Lifted => "lifted",
    };
    summary.set("release", release);
    summary.set("sound_speed_m_s", sound_speed(settings));
    summary.set("cfl", settings.cfl);
    summary.set("density_diffusion_form", fluid.config().diffusion.name());
    summary.set("density_diffusion", fluid.config().diffusion.delta().to_double());
    summary.set("walls", if settings.walls == Walls::Law { "law" } else { "free" });
    summary.set("artificial_viscosity", settings.alpha);
    summary.set("keep_tension", options.keep_tension);
    summary.set("collisions", settings.collisions);
    summary.set("shifting_iterations", settings.shifting);
    summary.set("pressure_form", if options.corrected { "corrected" } else { "plain" });
    summary.set("weight", fluid.kernel().name());
    summary.set("radius_ratio", fluid.config().radius_ratio.to_double());
    summary.particles.insert("fluid".into(), cost.particles as u64);
    summary.particles.insert("wall".into(), fluid.boundary().len() as u64);
    cost.enter(&mut summary, &options.common, failure);
    let (known, switched_off): (Vec<_>, Vec<_>) = results(settings, observer)
        .into_iter()
        .partition(|(name, _)| observer.energy_open.is_some() || !is_of_the_books(name));
    enter_results(&mut summary, known);
    summary.notes.extend(switched_off.iter().map(|(name, _)| format!("{name}: switched off by --no-books")));
    enter_compressibility(&mut summary, fluid);
    summary
}

/// The parts of the energy and what each cause has taken.
fn energy_plot(options: &Options, observer: &Observer, time: &[f64]) -> CurvePlot {
    let title = format!("Energy of the dam break, l₀ = {} mm", options.spacing * 1e3);
    let mut plot = CurvePlot::new(&title, "t √(g/H) [–]", "energy over that at the start [–]");
    let column = |value: &dyn Fn(&Sample) -> f64| observer.samples.iter().map(value).collect::<Vec<_>>();
    for (k, name) in ["kinetic", "potential", "compression"].into_iter().enumerate() {
        plot = plot.line(name, time, &column(&|s| s.energy[k]));
    }
    for (k, name) in CAUSES.into_iter().enumerate() {
        // What has never acted is not drawn.
        let taken = column(&|s| -s.received[k]);
        if taken.iter().any(|e| e.abs() > 1e-4) {
            plot = plot.line(&format!("taken by {name}"), time, &taken);
        }
    }
    plot
}

/// What gives and takes energy, in the order of [`Sample::received`].
const CAUSES: [&str; 5] = ["viscosity", "diffusion", "collisions", "shifting", "walls"];

/// Whether a result is one of energy split by its causes.
fn is_of_the_books(name: &str) -> bool {
    name == "energy_closure" || name.starts_with("energy_by_")
}

/// Results by name; `None` where the run has not come so far.
fn results(settings: &Settings, observer: &Observer) -> Vec<(String, Option<Metric>)> {
    let samples = &observer.samples;
    let plain = |value: f64| Metric::new(value, "-");
    let ideal = |value: f64, source: &str| plain(value).compared_with(0.0, source);
    let mut results = vec![
        (
            "arrival_sensor1".to_owned(),
            arrival(samples, 0).map(|t| plain(t).compared_with(SENSORS[0].arrival, SOURCE)),
        ),
        (
            "peak_sensor1".to_owned(),
            first_peak(samples, 0).map(|p| plain(p).compared_with(SENSORS[0].peak, SOURCE)),
        ),
    ];
    let impact = impact_mean(samples, 0).zip(measured_impact(&SENSORS[0]));
    let impact = impact.map(|(found, measured)| plain(found).compared_with(measured, SOURCE));
    results.push(("impact_mean_sensor1".to_owned(), impact));
    for (k, sensor) in SENSORS.iter().enumerate() {
        let inside = band_fraction(samples, k, sensor.points);
        results.push((
            format!("band_fraction_sensor{}", k + 1),
            inside.map(|share| plain(share).compared_with(1.0, SOURCE)),
        ));
    }
    results.push((
        "large_sensor".to_owned(),
        large_sensor_mean(samples).map(|p| plain(p).compared_with(LARGE_SENSOR.0, LARGE_SENSOR.1)),
    ));
    let front = front_error(samples, if settings.release == Release::Instant { OPENING_TIME } else { 0.0 });
    let mut put = |name: &str, metric: Option<Metric>| results.push((name.to_owned(), metric));
    put("front_rms", front.map(|f| ideal(f.rms, SOURCE)));
    put("front_shift", front.map(|f| plain(f.shift)));
    put("front_rms_unshifted", front.map(|f| ideal(f.rms_unshifted, SOURCE)));
    put("front_error_paper1", front.map(|f| ideal(f.mean, SOURCE)));
    put("front_lead", front.map(|f| ideal(f.lead, SOURCE)));
    put("pressure_noise", pressure_noise(samples).map(|rms| ideal(rms, "no noise")));
    put("energy_closure", observer.energy_open.map(|open| ideal(open, "every change of energy has a cause")));
    put("energy_rise", Some(ideal(observer.energy_rise, "total energy never rises")));
    let last = samples.last().map_or([0.0; 5], |s| s.received);
    for (name, value) in CAUSES.iter().zip(last) {
        put(&format!("energy_by_{name}"), observer.energy_open.map(|_| plain(value)));
    }
    put("energy_dissipated", Some(plain(observer.dissipated())));
    put("particle_disorder", observer.disorder.map(|d| ideal(d, "a lattice")));
    put("volume_drift", observer.volume_drift.map(|drift| ideal(drift, "the volume is kept")));
    put("leaked_particles", Some(ideal(observer.leaked() as f64, "no leak")));
    results
}
