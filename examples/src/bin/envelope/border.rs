//! What a border is: a small scene with one number to turn, and what counts as broken.

use mps_examples::Failure;

/// A number of the method or of a scene that cannot be turned for ever.
#[derive(Clone, Copy)]
pub(crate) struct Border {
    /// Name on the command line and in the tables.
    pub(crate) name: &'static str,
    /// What is turned, with its unit.
    pub(crate) parameter: &'static str,
    /// What the scene measures, with its unit.
    pub(crate) measure: &'static str,
    /// Largest measure that is fine. A run that ends with an error is broken too.
    pub(crate) bound: f64,
    /// The scene at one value of the parameter.
    pub(crate) scene: fn(f64) -> Result<f64, Failure>,
    /// Where theory has the border.
    pub(crate) predicted: Option<fn() -> Result<f64, Failure>>,
    /// Whether the parameter counts something.
    pub(crate) whole: bool,
    /// How it breaks.
    pub(crate) breaks: Breaks,
    /// Why.
    pub(crate) mechanism: &'static str,
    /// What to do.
    pub(crate) remedy: &'static str,
}

/// The ways to break.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Breaks {
    /// What was small grows without bound.
    BlowUp,
    /// Fluid passes a wall.
    Leak,
    /// A body is too stiff.
    Locking,
    /// A result is wrong by more than the bound.
    Error,
    /// The library says that it cannot be done.
    Refusal,
    /// It does not, within the range that was looked at.
    Nothing,
}

impl Breaks {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::BlowUp => "blow-up",
            Self::Leak => "leak",
            Self::Locking => "locking",
            Self::Error => "error",
            Self::Refusal => "refusal",
            Self::Nothing => "does not break",
        }
    }
}

/// Where a border is known to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Known {
    /// Fine at the first value, broken at the second.
    Between(f64, f64),
    /// Fine at all of these values, the ends of what was asked for among them.
    Holds(&'static [f64]),
    /// Fine at all of the first values; and at the second ones, which take too long to be run by `--quick`.
    Lasts(&'static [f64], &'static [f64]),
}

/// A run of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Trial {
    /// Value of the parameter.
    pub(crate) value: f64,
    /// What was measured, or the words with which the run has ended.
    pub(crate) measure: Result<f64, String>,
}

impl Border {
    /// Runs the scene at a value.
    pub(crate) fn run(&self, value: f64) -> Trial {
        Trial { value, measure: (self.scene)(value).map_err(|failure| failure.to_string()) }
    }

    /// Whether a run is fine. What is no number is not.
    pub(crate) fn is_fine(&self, trial: &Trial) -> bool {
        trial.measure.as_ref().is_ok_and(|measure| *measure <= self.bound)
    }

    /// The outcome of a run in words.
    pub(crate) fn words(&self, trial: &Trial) -> String {
        match &trial.measure {
            Err(failure) => format!("ends: {failure}"),
            Ok(measure) => {
                let verdict = if self.is_fine(trial) { "fine" } else { "broken" };
                format!("{verdict}: {} {measure:.3e}, allowed {:.1e}", self.measure, self.bound)
            }
        }
    }
}
