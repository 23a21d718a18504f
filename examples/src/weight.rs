//! The weights of the fluid that programs let their users choose.

use clap::ValueEnum;
use mps_io::scene_file;

/// Which weight the sums over neighbours have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Weight {
    /// Gradient of Wendland's function: sums of a strained arrangement stay those of a fluid
    Smooth,
    /// That of the paper, re/r - 1: a strained arrangement resists shear in proportion to its pressure
    Rational,
}

impl Weight {
    /// Effective radius over the spacing unless another is chosen.
    pub fn radius(self) -> f64 {
        match self {
            Self::Smooth => 4.0,
            Self::Rational => 3.0,
        }
    }

    /// As scene files say it.
    pub fn in_a_scene(self) -> scene_file::Weight {
        match self {
            Self::Smooth => scene_file::Weight::Smooth,
            Self::Rational => scene_file::Weight::Rational,
        }
    }
}
