//! Case 1 of the paper: a plate that swings.

use core::f64::consts::TAU;
use mps_examples::exact::{Case, Curve, Measure, Outcome, Pace, Plot};
use mps_examples::solid::Motion;
use mps_examples::solid::plate::{
    AMPLITUDE, ELEMENTS, LENGTH, PERIOD_EXTRAPOLATED, moduli, plate, swing, unit_of_time,
};
use mps_examples::{Failure, Watch, record};
use mps_io::CurvePlot;
use mps_neighbors::Parallel;
use mps_solid::SolidConfig;
use mps_solid::materials::CorotationalHooke;

pub(crate) struct Cantilever;

impl Case for Cantilever {
    fn name(&self) -> &'static str {
        "cantilever"
    }

    fn about(&self) -> &'static str {
        "Case 1 of Tavakoli et al. 2026: a plate 0.2 m x 0.02 m, K = 3.25 MPa, G = 0.715 MPa, with the velocities of its first mode, 0.01 c_s at the \
         tip, 3.2 periods (1.6 in the quick run), corotational. Energy: largest change, 400 looks a period."
    }

    fn resolution(&self) -> &'static str {
        "particles across"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![5], vec![5, 10, 20])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        let (solid, tip) =
            plate(n, CorotationalHooke::<f64>::from(moduli()?), SolidConfig::default(), parallel)?;
        let period = PERIOD_EXTRAPOLATED * unit_of_time();
        let mut motion = Motion::new(solid, tip, mps_kernel::Vector::zeros(), period / 400.0, parallel)?;
        record(&mut motion, pace.choose(1.6, 3.2) * period, &Watch::nobody(), &mut 0.0)?;
        let samples = motion.samples();
        let time: Vec<f64> = samples.iter().map(|s| s.time).collect();
        let tip: Vec<f64> = samples.iter().map(|s| s.tip[1]).collect();
        let [found, amplitude] = swing(samples).unwrap_or([f64::NAN; 2]);
        let start = samples.first().map_or(f64::NAN, |s| s.energy.total());
        let energy = samples.iter().map(|s| (s.energy.total() / start - 1.0).abs()).fold(0.0, f64::max);
        let measures = vec![
            Measure::new("period", "L/c_s", found, PERIOD_EXTRAPOLATED, ELEMENTS).within(0.01, 5),
            Measure::new("amplitude", "L", amplitude, AMPLITUDE, ELEMENTS).within(0.01, 5),
            Measure::new("energy, largest change", "E0", energy, 0.0, "analytic: conserved").within(1e-4, 5),
        ];
        let x = time.iter().map(|t| t / unit_of_time()).collect();
        let y = tip.iter().map(|u| u / LENGTH).collect();
        let curves = vec![Curve { plot: "tip", name: format!("{n} across"), x, y }];
        Ok(Outcome::new(measures, curves))
    }

    fn plots(&self) -> Vec<Plot> {
        let time: Vec<f64> = (0..=480).map(|k| f64::from(k) * 0.5).collect();
        let harmonic: Vec<f64> =
            time.iter().map(|t| AMPLITUDE * (TAU * t / PERIOD_EXTRAPOLATED).sin()).collect();
        let name = "harmonic with period and amplitude of finite elements";
        let axes = CurvePlot::new("Vibrating plate", "t c/L [-]", "deflection of the tip u/L [-]");
        vec![Plot { name: "tip", axes: axes.dashed(name, &time, &harmonic) }]
    }
}
