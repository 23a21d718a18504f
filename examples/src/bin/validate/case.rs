//! What a case is: a problem with a known solution, run at several resolutions.

use mps_examples::Failure;
use mps_io::CurvePlot;
use mps_neighbors::Parallel;

/// A problem with a known solution.
pub(crate) trait Case: Sync {
    /// Name on the command line, in the tables and of the pictures.
    fn name(&self) -> &'static str;

    /// The problem and its parameters, in a few sentences.
    fn about(&self) -> &'static str;

    /// What a resolution counts: "particles per depth".
    fn resolution(&self) -> &'static str;

    /// The resolutions, coarsest first.
    fn resolutions(&self, pace: Pace) -> Vec<usize>;

    /// Simulates at one resolution and measures.
    fn run(&self, resolution: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure>;

    /// Axes and exact curves of the pictures the outcomes have curves for.
    fn plots(&self) -> Vec<Plot> {
        Vec::new()
    }
}

/// How long a case may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pace {
    /// Coarse and short, for every change.
    Quick,
    /// What the targets are stated for.
    Full,
}

impl Pace {
    pub(crate) fn choose<A>(self, quick: A, full: A) -> A {
        match self {
            Self::Quick => quick,
            Self::Full => full,
        }
    }
}

/// What a run has measured.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outcome {
    pub(crate) measures: Vec<Measure>,
    pub(crate) curves: Vec<Curve>,
}

/// One measured number and what it should be.
#[derive(Clone, Debug)]
pub(crate) struct Measure {
    pub(crate) metric: &'static str,
    pub(crate) unit: &'static str,
    pub(crate) value: f64,
    pub(crate) exact: f64,
    /// Formula or publication.
    pub(crate) source: &'static str,
    pub(crate) target: Option<Target>,
}

/// The largest error allowed from a resolution on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    pub(crate) error: f64,
    pub(crate) from: usize,
}

/// One line of a picture.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    /// Which picture of [`Case::plots`].
    pub(crate) plot: &'static str,
    pub(crate) name: String,
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
}

/// A picture before the runs are drawn into it.
pub(crate) struct Plot {
    pub(crate) name: &'static str,
    pub(crate) axes: CurvePlot,
}

impl Measure {
    /// A number whose exact value is `exact` by `source`.
    pub(crate) fn new(
        metric: &'static str,
        unit: &'static str,
        value: f64,
        exact: f64,
        source: &'static str,
    ) -> Self {
        Self { metric, unit, value, exact, source, target: None }
    }

    /// With the largest error allowed at `from` and finer.
    pub(crate) fn within(self, error: f64, from: usize) -> Self {
        Self { target: Some(Target { error, from }), ..self }
    }

    /// Relative to the exact value; the value itself if that is zero.
    pub(crate) fn error(&self) -> f64 {
        let scale = if self.exact == 0.0 { 1.0 } else { self.exact.abs() };
        (self.value - self.exact) / scale
    }
}

/// `p` of `error ~ l0^p` between two resolutions; `None` where an error is too close to zero to tell.
pub(crate) fn observed_order(coarse: (usize, f64), fine: (usize, f64)) -> Option<f64> {
    let order = (coarse.1 / fine.1).abs().ln() / (fine.0 as f64 / coarse.0 as f64).ln();
    (order.is_finite() && fine.1.abs() > 1e-12).then_some(order)
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
