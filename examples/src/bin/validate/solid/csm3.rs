//! CSM3 of Turek and Hron: the flag swings.

use mps_examples::exact::{Case, Curve, Measure, Outcome, Pace, Plot};
use mps_examples::series::oscillation;
use mps_examples::solid::Motion;
use mps_examples::solid::flag::{CSM3, Clamp, RUBBER, SOURCE, end, flag, gravity};
use mps_examples::{Failure, Watch, record};
use mps_io::CurvePlot;
use mps_neighbors::Parallel;

pub(crate) struct Csm3;

impl Case for Csm3 {
    fn name(&self) -> &'static str {
        "csm3"
    }

    fn about(&self) -> &'static str {
        "The same flag let go from its undeformed state, without damping, for 10 s (3 s in the quick run). Mean and amplitude are those of the last period; the \
         frequency is that of the upward passages of the mean over the whole time."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![4], vec![4, 8, 16])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let solid = flag::<f64>(n, Clamp::Arc, &RUBBER, parallel)?;
        let mut motion = Motion::new(solid, end(), gravity(), 1.0 / CSM3[1][2] / 400.0, parallel)?;
        record(&mut motion, pace.choose(3.0, 10.0), &Watch::nobody(), &mut 0.0)?;
        let samples = motion.samples();
        let time: Vec<f64> = samples.iter().map(|s| s.time).collect();
        let allowed = if n < 16 { 0.01 } else { 0.003 };
        let mut measures = Vec::new();
        let names =
            [["ux, mean", "ux, amplitude", "ux, frequency"], ["uy, mean", "uy, amplitude", "uy, frequency"]];
        for (axis, names) in names.into_iter().enumerate() {
            let tip: Vec<f64> = samples.iter().map(|s| s.tip[axis]).collect();
            let found = oscillation(&time, &tip)
                .map_or([f64::NAN; 3], |found| [found.mean, found.amplitude, 1.0 / found.period]);
            for (k, name) in names.into_iter().enumerate() {
                let unit = if k == 2 { "Hz" } else { "m" };
                measures.push(Measure::new(name, unit, found[k], CSM3[axis][k], SOURCE).within(allowed, 8));
            }
        }
        let given = samples.iter().map(|s| -s.energy.potential).fold(0.0, f64::max);
        let energy = samples.iter().map(|s| s.energy.total().abs()).fold(0.0, f64::max) / given;
        let kept = "analytic: conserved";
        measures.push(Measure::new("energy, largest change", "that given by gravity", energy, 0.0, kept));
        let y = samples.iter().map(|s| 1e3 * s.tip[1]).collect();
        let curves = vec![Curve { plot: "uy", name: format!("{n} across"), x: time, y }];
        Ok(Outcome::new(measures, curves))
    }

    fn plots(&self) -> Vec<Plot> {
        let [mean, amplitude, _] = CSM3[1].map(|v| 1e3 * v);
        let axes = CurvePlot::new("CSM3", "time [s]", "uy of the end [mm]");
        let axes = axes
            .dashed("largest and smallest, Turek and Hron 2006", &[0.0, 10.0], &[mean + amplitude; 2])
            .dashed("", &[0.0, 10.0], &[mean - amplitude; 2]);
        vec![Plot { name: "uy", axes }]
    }
}
