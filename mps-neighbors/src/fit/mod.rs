//! Points that fill a shape and follow its surface.
//!
//! | file | what it does |
//! |---|---|
//! | `shape` | what has to be known of a shape |
//! | `seeds` | volume of a shape, and as many cells of a lattice as it has |
//! | `repulsion` | what a point feels of others and of the surface |
//! | `settle` | moves points until they rest |
//! | `error` | shapes that cannot be filled |
//!
//! After Zhu, Zhang and Hu (2021), "A CAD-compatible body-fitted particle generator for arbitrarily complex geometry and
//! its application to wave-structure interaction", and Colagrossi, Bouscasse, Antuono and Marrone (2012), "Particle packing
//! algorithm for SPH schemes": points repel each other, and what comes nearer than half a spacing to the surface is put
//! back there.

mod error;
mod repulsion;
mod seeds;
mod settle;
mod shape;

pub use error::FitError;
pub use settle::fit;
pub use shape::{Nearest, Shape};

use mps_kernel::Vector;

/// Points of a shape, each of which stands for the same volume.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted<const D: usize> {
    /// Places \[m\].
    pub places: Vec<Vector<f64, D>>,
    /// Volume of each \[m^D\]: all together have that of the shape.
    pub volume: f64,
    /// How often all points were moved.
    pub sweeps: usize,
}
