//! The tests, and what Turek and Hron found.

use clap::ValueEnum;
use mps_examples::solid::flag::Rubber;

/// Where the numbers are from.
pub(crate) const SOURCE: &str = "Turek and Hron 2006 (finite elements)";

/// The tests of the benchmark that have a fluid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Test {
    /// Rigid flag, mean inflow 0.2 m/s: steady
    Cfd1,
    /// Rigid flag, 1 m/s: steady, with thin boundary layers
    Cfd2,
    /// Rigid flag, 2 m/s: vortices leave the cylinder
    Cfd3,
    /// Elastic flag, 0.2 m/s: steady
    Fsi1,
    /// Elastic flag, 2 m/s: it flaps
    Fsi3,
}

/// A quantity of the reference: mean and amplitude; a frequency \[Hz\] where it oscillates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Swing {
    pub(crate) mean: f64,
    pub(crate) amplitude: f64,
    pub(crate) frequency: f64,
}

/// What is compared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reference {
    /// Displacement of the end A \[m\].
    pub(crate) ux: Swing,
    pub(crate) uy: Swing,
    /// Force on cylinder and flag \[N/m\].
    pub(crate) drag: Swing,
    pub(crate) lift: Swing,
}

const fn steady(mean: f64) -> Swing {
    Swing { mean, amplitude: 0.0, frequency: 0.0 }
}

const fn swing(mean: f64, amplitude: f64, frequency: f64) -> Swing {
    Swing { mean, amplitude, frequency }
}

impl Test {
    /// As in the flag and in summaries.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Cfd1 => "cfd1",
            Self::Cfd2 => "cfd2",
            Self::Cfd3 => "cfd3",
            Self::Fsi1 => "fsi1",
            Self::Fsi3 => "fsi3",
        }
    }

    /// Mean speed of the inflow \[m/s\].
    pub(crate) fn inflow(self) -> f64 {
        match self {
            Self::Cfd1 | Self::Fsi1 => 0.2,
            Self::Cfd2 => 1.0,
            Self::Cfd3 | Self::Fsi3 => 2.0,
        }
    }

    /// Whether the flow becomes steady.
    pub(crate) fn is_steady(self) -> bool {
        matches!(self, Self::Cfd1 | Self::Cfd2 | Self::Fsi1)
    }

    /// When the flow is what is compared \[s\].
    pub(crate) fn settled(self) -> f64 {
        match self {
            Self::Cfd1 | Self::Fsi1 => 10.0,
            Self::Cfd2 | Self::Cfd3 | Self::Fsi3 => 7.0,
        }
    }

    /// The flag, if it is elastic.
    pub(crate) fn rubber(self) -> Option<Rubber> {
        let soft = |young| Some(Rubber { density: 1000.0, young, poisson: 0.4 });
        match self {
            Self::Cfd1 | Self::Cfd2 | Self::Cfd3 => None,
            Self::Fsi1 => soft(1.4e6),
            Self::Fsi3 => soft(5.6e6),
        }
    }

    pub(crate) fn reference(self) -> Reference {
        match self {
            Self::Cfd1 => {
                Reference { ux: steady(0.0), uy: steady(0.0), drag: steady(14.29), lift: steady(1.119) }
            }
            Self::Cfd2 => {
                Reference { ux: steady(0.0), uy: steady(0.0), drag: steady(136.7), lift: steady(10.53) }
            }
            Self::Cfd3 => Reference {
                ux: steady(0.0),
                uy: steady(0.0),
                drag: swing(439.45, 5.6183, 4.3956),
                lift: swing(-11.893, 437.81, 4.3956),
            },
            Self::Fsi1 => Reference {
                ux: steady(2.27e-5),
                uy: steady(8.209e-4),
                drag: steady(14.295),
                lift: steady(0.7638),
            },
            Self::Fsi3 => Reference {
                ux: swing(-2.69e-3, 2.53e-3, 10.9),
                uy: swing(1.48e-3, 34.38e-3, 5.3),
                drag: swing(457.3, 22.66, 10.9),
                lift: swing(2.22, 149.78, 5.3),
            },
        }
    }
}
