//! The plots against the reference, and the settings of both tests in the summary.

use crate::Settings;
use crate::options::Options;
use core::f64::consts::TAU;
use mps_examples::Failure;
use mps_examples::solid::Sample;
use mps_examples::solid::flag::{CSM1, CSM3, DENSITY, END, Flag, GRAVITY, LENGTH, POISSON, SOURCE, YOUNG};
use mps_io::{CurvePlot, Summary};
use mps_kernel::{Real, Vector};
use std::path::Path;

/// Displacements of the end and energies over time.
pub(crate) fn motion(dir: &Path, settings: &Settings, samples: &[Sample]) -> Result<(), Failure> {
    let time: Vec<f64> = samples.iter().map(|s| s.time).collect();
    let column = |value: &dyn Fn(&Sample) -> f64| samples.iter().map(value).collect::<Vec<_>>();
    let title = |what: &str| format!("CSM3: {what}, {} particles across", settings.across);
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        let [mean, amplitude, frequency] = CSM3[axis];
        // It starts at its upper end.
        let harmonic: Vec<f64> =
            time.iter().map(|t| 1e3 * (mean + amplitude * (TAU * frequency * t).cos())).collect();
        let label = format!("displacement u{name} of A [mm]");
        CurvePlot::new(&title(&format!("u{name} of the end")), "time [s]", &label)
            .line("this run", &time, &column(&|s| 1e3 * s.tip[axis]))
            .dashed(&format!("harmonic with mean, amplitude and frequency of {SOURCE}"), &time, &harmonic)
            .write_png(dir.join(format!("u{name}.png")))?;
    }
    CurvePlot::new(&title("energy"), "time [s]", "energy [J/m]")
        .line("kinetic", &time, &column(&|s| s.energy.kinetic))
        .line("strain", &time, &column(&|s| s.energy.strain + s.energy.bending))
        .line("potential", &time, &column(&|s| s.energy.potential))
        .line("total", &time, &column(&|s| s.energy.total()))
        .write_png(dir.join("energy.png"))?;
    Ok(())
}

/// The middle line at rest, with the end of the reference.
pub(crate) fn middle_line<T: Real>(dir: &Path, settings: &Settings, flag: &Flag<T>) -> Result<(), Failure> {
    const POINTS: u32 = 100;
    let (mut x, mut y) = (Vec::new(), Vec::new());
    for k in 0..=POINTS {
        let along = END[0] - LENGTH * (1.0 - f64::from(k) / f64::from(POINTS));
        let place = flag.point(Vector::from([along, END[1]].map(T::of)))?.value(flag.positions());
        x.push(place[0].to_double());
        y.push(place[1].to_double());
    }
    let title = format!("CSM1: middle line at rest, {} particles across", settings.across);
    CurvePlot::new(&title, "x [m]", "y [m]")
        .line("this run", &x, &y)
        .dashed("undeformed", &[END[0] - LENGTH, END[0]], &[END[1]; 2])
        .points(&format!("A, {SOURCE}"), &[END[0] + CSM1[0]], &[END[1] + CSM1[1]])
        .write_png(dir.join("middle_line.png"))?;
    Ok(())
}

impl Options {
    /// A summary with the settings of both tests.
    pub(crate) fn summary<T: Real>(&self, settings: &Settings, flag: &Flag<T>) -> Summary {
        let mut summary = Summary::new("flag-structure", env!("CARGO_PKG_VERSION"));
        summary.set("test", self.test.name());
        summary.set("particles_across", settings.across);
        summary.set("spacing_m", flag.spacing().max().to_double());
        summary.set("clamp", settings.clamp.name());
        summary.set("density_kg_m3", DENSITY);
        summary.set("youngs_modulus_pa", YOUNG);
        summary.set("poissons_ratio", POISSON);
        summary.set("gravity_m_s2", GRAVITY);
        summary.set("radius_ratio", flag.config().radius_ratio.to_double());
        summary.particles.insert("solid".into(), flag.len() as u64);
        summary
    }
}
