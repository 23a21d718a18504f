//! What a case is: a problem with a known solution, run at several resolutions.

use crate::{Failure, Refused};
use mps_fluid::{Fluid, Viscosity};
use mps_io::{CurvePlot, Metric};
use mps_kernel::{Kernel, Real};
use mps_neighbors::{Domain, Parallel};
use std::path::Path;

/// A problem with a known solution.
pub trait Case: Sync {
    /// Name on the command line, in the tables and of the pictures.
    fn name(&self) -> &'static str;

    /// The problem and its parameters, in a few sentences.
    fn about(&self) -> &'static str;

    /// What a resolution counts: "particles per depth".
    fn resolution(&self) -> &'static str;

    /// The resolutions, coarsest first.
    fn resolutions(&self, pace: Pace) -> Vec<usize>;

    /// Refuses a resolution at which it is not the problem it says.
    ///
    /// # Errors
    /// If it is not: what to give.
    fn check(&self, _resolution: usize) -> Result<(), Refused> {
        Ok(())
    }

    /// Simulates at one resolution and measures.
    ///
    /// # Errors
    /// If the problem cannot be built with its numerics, or the simulation breaks off.
    fn run(&self, resolution: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure>;

    /// Axes and exact curves of the pictures the outcomes have curves for.
    fn plots(&self) -> Vec<Plot> {
        Vec::new()
    }
}

/// How long a case may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// Coarse and short, for every change.
    Quick,
    /// What the targets are stated for.
    Full,
}

impl Pace {
    /// One of two, by the pace.
    pub fn choose<A>(self, quick: A, full: A) -> A {
        match self {
            Self::Quick => quick,
            Self::Full => full,
        }
    }
}

/// What a run has measured.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Numbers and what they should be.
    pub measures: Vec<Measure>,
    /// Lines of the pictures.
    pub curves: Vec<Curve>,
    /// How much has been computed, of cases that say so.
    pub work: Work,
}

/// How much a run has computed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Particles of the fluid.
    pub particles: usize,
    /// Time steps.
    pub steps: u64,
    /// Simulated time \[s\].
    pub simulated: f64,
}

/// One measured number and what it should be.
#[derive(Clone, Debug)]
pub struct Measure {
    /// Its name.
    pub metric: &'static str,
    /// Its unit, in letters of the problem where it has one.
    pub unit: &'static str,
    /// What the run has.
    pub value: f64,
    /// What it should be, in the same unit.
    pub exact: f64,
    /// Formula or publication.
    pub source: &'static str,
    /// What is asked of it, if anything.
    pub target: Option<Target>,
}

/// The largest error allowed from a resolution on.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// As [`Measure::error`], without its sign.
    pub error: f64,
    /// The coarsest resolution it is asked of.
    pub from: usize,
}

/// One line of a picture.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Which picture of [`Case::plots`].
    pub plot: &'static str,
    /// In the legend.
    pub name: String,
    /// Abscissae.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<f64>,
}

/// A picture before the runs are drawn into it.
pub struct Plot {
    /// Its name, after that of the case.
    pub name: &'static str,
    /// Labels and exact curves.
    pub axes: CurvePlot,
}

impl Outcome {
    /// What has been measured, by a case that does not say how much it has computed.
    pub fn new(measures: Vec<Measure>, curves: Vec<Curve>) -> Self {
        Self { measures, curves, work: Work::default() }
    }

    /// With how much this fluid has computed.
    pub(super) fn of<T, const D: usize, K, V, P>(self, fluid: &Fluid<T, D, K, V, P>) -> Self
    where
        T: Real,
        K: Kernel<T>,
        V: Viscosity<T, D>,
        P: Domain<T, D>,
    {
        let (particles, steps) = (fluid.particles().position.len(), fluid.steps());
        Self { work: Work { particles, steps, simulated: fluid.time().to_double() }, ..self }
    }
}

impl Measure {
    /// A number whose exact value is `exact` by `source`.
    pub fn new(
        metric: &'static str,
        unit: &'static str,
        value: f64,
        exact: f64,
        source: &'static str,
    ) -> Self {
        Self { metric, unit, value, exact, source, target: None }
    }

    /// With the largest error allowed at `from` and finer.
    pub fn within(self, error: f64, from: usize) -> Self {
        Self { target: Some(Target { error, from }), ..self }
    }

    /// As summaries have it.
    pub fn metric(&self) -> Metric {
        Metric::new(self.value, self.unit).compared_with(self.exact, self.source)
    }

    /// Relative to the exact value; the value itself if that is zero.
    pub fn error(&self) -> f64 {
        let scale = if self.exact == 0.0 { 1.0 } else { self.exact.abs() };
        (self.value - self.exact) / scale
    }
}

/// `p` of `error ~ l0^p` between two resolutions; `None` where an error is too close to zero to tell.
pub fn observed_order(coarse: (usize, f64), fine: (usize, f64)) -> Option<f64> {
    let order = (coarse.1 / fine.1).abs().ln() / (fine.0 as f64 / coarse.0 as f64).ln();
    (order.is_finite() && fine.1.abs() > 1e-12).then_some(order)
}

/// Draws the curves of all outcomes over the exact ones, into `CASE-PLOT.png` each.
///
/// # Errors
/// If a picture cannot be written.
pub fn draw(case: &dyn Case, outcomes: &[&Outcome], out: &Path) -> Result<(), Failure> {
    for plot in case.plots() {
        let curves = outcomes.iter().flat_map(|outcome| &outcome.curves);
        let draw = |axes: CurvePlot, curve: &Curve| axes.line(&curve.name, &curve.x, &curve.y);
        let axes = curves.filter(|curve| curve.plot == plot.name).fold(plot.axes, draw);
        axes.write_png(out.join(format!("{}-{}.png", case.name(), plot.name)))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_the_power_of_the_spacing() {
        let error = |n: usize| 3.0 * (n as f64).powf(-1.7);
        let order = observed_order((20, error(20)), (50, -error(50))).unwrap();
        assert!((order - 1.7).abs() < 1e-12);
        assert_eq!(observed_order((10, 1e-3), (20, 0.0)), None);
    }

    #[test]
    fn errors_are_relative_unless_the_exact_value_is_zero() {
        assert_eq!(Measure::new("", "", 1.5, -1.0, "").error(), 2.5);
        assert_eq!(Measure::new("", "", -1e-3, 0.0, "").error(), -1e-3);
    }
}
