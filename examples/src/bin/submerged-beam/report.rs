//! The plot against the reference and summary.json.

use crate::run::Sample;
use mps_examples::series::extremes;
use mps_examples::submerged::{
    DIFFERENCE, GRAVITY, LENGTH, NONLINEAR, POISSON, SOURCE, Settings, THICKNESS, Tank, WATER, YOUNG,
};
use mps_examples::{Failure, enter_results};
use mps_io::{CurvePlot, Metric, Summary};
use mps_kernel::Real;
use std::path::Path;

/// Share of the run at whose end results are read off.
const READ: f64 = 0.2;

/// The deflection of the end over time.
pub(crate) fn plot(dir: &Path, settings: &Settings, samples: &[Sample]) -> Result<(), Failure> {
    let time: Vec<f64> = samples.iter().map(|s| s.time).collect();
    let deflection: Vec<f64> = samples.iter().map(|s| 1e3 * s.deflection).collect();
    let span = [0.0, time.last().copied().unwrap_or(0.0)];
    let title = format!(
        "Beam of {} kg/m³ in water, {} particles across, l₀ = {} mm",
        settings.density,
        settings.across,
        settings.spacing * 1e3
    );
    CurvePlot::new(&title, "time [s]", "deflection of the end [mm]")
        .line("this run", &time, &deflection)
        .dashed(&format!("linear, {SOURCE}"), &span, &[1e3 * settings.linear(); 2])
        .write_png(dir.join("deflection.png"))?;
    Ok(())
}

/// Settings and results, whether the run was completed or not. `dry`: deflection of the same solid without water \[m\], or why it is not known.
pub(crate) fn summary<T: Real>(
    settings: &Settings,
    scene: &Tank<T>,
    samples: &[Sample],
    dry: Result<f64, &str>,
) -> Summary {
    let mut summary = Summary::new("submerged-beam", env!("CARGO_PKG_VERSION"));
    summary.set("spacing_m", settings.spacing);
    summary.set("particles_across", settings.across);
    summary.set("density_kg_m3", settings.density);
    summary.set("youngs_modulus_pa", YOUNG);
    summary.set("poissons_ratio", POISSON);
    summary.set("gravity_m_s2", GRAVITY);
    summary.set("sound_speed_m_s", settings.sound_speed());
    summary.set("cfl", settings.cfl);
    summary.set("radius_ratio", settings.radius);
    summary.set("density_diffusion", settings.diffusion);
    summary.set("viscosity_m2_s", settings.viscosity);
    summary.set("damping_1_s", settings.damping);
    let boundary = scene.fluid().boundary();
    summary.particles.insert("fluid".into(), scene.fluid().particles().position.len() as u64);
    summary.particles.insert("wall".into(), boundary.reactive().start as u64);
    summary.particles.insert("structure".into(), boundary.reactive().len() as u64);

    let end = samples.last().map_or(0.0, |s| s.time);
    let read = &samples[samples.partition_point(|s| s.time < end * (1.0 - READ))..];
    let mean = |value: fn(&Sample) -> f64| read.iter().map(value).sum::<f64>() / read.len() as f64;
    let deflections: Vec<f64> = read.iter().map(|s| s.deflection).collect();
    let spread = extremes(&deflections).map(|[low, high]| Metric::new(high - low, "m"));
    let deflection = mean(|s| s.deflection);
    let linear = Metric::new(deflection, "m").compared_with(settings.linear(), &format!("{SOURCE}, linear"));
    let nonlinear = NONLINEAR * (settings.density - WATER).abs() / DIFFERENCE;
    match dry {
        Ok(dry) => {
            let alone =
                Metric::new(dry, "m").compared_with(nonlinear, &format!("{SOURCE}, Saint Venant-Kirchhoff"));
            let coupling = Metric::new(deflection, "m").compared_with(dry, "the same solid without water");
            summary.metrics.insert("tip_deflection_dry".to_owned(), alone);
            summary.metrics.insert("tip_deflection_against_dry".to_owned(), coupling);
        }
        Err(reason) => {
            for name in ["tip_deflection_dry", "tip_deflection_against_dry"] {
                summary.notes.push(format!("{name}: {reason}"));
            }
        }
    }
    let displaced = WATER * GRAVITY * LENGTH * THICKNESS;
    let lift = Metric::new(mean(|s| s.lift), "N/m").compared_with(displaced, "Archimedes");
    let residual = Metric::new(scene.budget().residual.to_double(), "-");
    enter_results(
        &mut summary,
        [
            ("tip_deflection".to_owned(), Some(linear)),
            ("tip_deflection_spread".to_owned(), spread),
            ("lift".to_owned(), Some(lift)),
            ("interface_momentum_residual".to_owned(), Some(residual)),
        ],
    );
    summary
}
