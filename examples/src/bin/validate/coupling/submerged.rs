//! A beam in water, bent by its buoyancy: the case of the program `submerged-beam`.

use mps_examples::exact::{Case, Curve, Measure, Outcome, Pace, Plot};
use mps_examples::submerged::{self, LENGTH, SOURCE, Settings, THICKNESS, WATER, deflection};
use mps_examples::{Failure, Watch};
use mps_io::CurvePlot;
use mps_kernel::Real;
use mps_neighbors::Parallel;

pub(crate) struct Submerged;

/// Share of the run at whose end results are read off.
const READ: f64 = 0.2;

impl Case for Submerged {
    fn name(&self) -> &'static str {
        "submerged-beam"
    }

    fn about(&self) -> &'static str {
        "A beam 0.35 m x 0.02 m of 500 kg/m3 (E = 1.4 MPa, nu = 0.4), clamped on the plane of its left end 0.1 m below the surface of water \
         under g = 1 m/s2, let go straight. Means of the last fifth of 15 s (quick: 12 s). The water has half as many particles as the beam \
         across its thickness, but at least two; nu = 1e-4 m2/s; the beam's velocity is damped by 40 1/s on its way to rest."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![4], vec![2, 4, 8])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let spacing = THICKNESS / (n / 2).max(2) as f64;
        let settings = Settings::usual(n, spacing, 500.0);
        let mut scene = submerged::build::<f64>(&settings, parallel)?;
        let end = submerged::end(submerged::rubber(&scene).ok_or("the scene has no beam")?)?;
        let until = pace.choose(12.0, 15.0);
        let (mut time, mut moved) = (Vec::new(), Vec::new());
        let mut impulse = 0.0;
        while scene.fluid().time() < until {
            scene.step(parallel, f64::INFINITY)?;
            if time.last().is_none_or(|last| scene.fluid().time() > last + 0.02) {
                time.push(scene.fluid().time());
                moved.push(deflection(&scene, &end, &settings));
                if scene.fluid().time() < (1.0 - READ) * until {
                    impulse = scene.budget().impulse()[1];
                }
            }
        }
        let from = time.partition_point(|t| *t < (1.0 - READ) * until);
        let since = scene.fluid().time() - time[from.saturating_sub(1)];
        let mean = moved[from..].iter().sum::<f64>() / (moved.len() - from) as f64;
        let lift = (scene.budget().impulse()[1] - impulse) / since;
        let displaced = WATER * submerged::GRAVITY * LENGTH * THICKNESS;
        let dry = submerged::dry_deflection::<f64>(&settings, parallel, &Watch::nobody())?;
        let y = moved.iter().map(|x| 1e3 * x).collect();
        Ok(Outcome {
            measures: vec![
                Measure::new("deflection of the end", "m", mean, settings.linear(), SOURCE).within(0.02, 8),
                Measure::new("over the same solid without water", "m", mean, dry, "the same solid at rest")
                    .within(0.02, 4),
                Measure::new("lift", "N/m", lift, displaced, "Archimedes"),
                Measure::new("action and reaction", "-", scene.budget().residual.to_double(), 0.0, "Newton")
                    .within(1e-12, 2),
            ],
            curves: vec![Curve { plot: "deflection", name: format!("{n} across"), x: time, y }],
            ..Outcome::default()
        })
    }

    fn plots(&self) -> Vec<Plot> {
        let exact = 1e3 * submerged::LINEAR;
        let axes = CurvePlot::new("Beam in water", "time [s]", "deflection of the end [mm]").dashed(
            "finite elements",
            &[0.0, 15.0],
            &[exact; 2],
        );
        vec![Plot { name: "deflection", axes }]
    }
}
