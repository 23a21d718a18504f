//! What can be wrong with the input of a search, and what to do about it.

use thiserror::Error;

/// Why neighbours could not be searched, or particles not be reordered.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum NeighborError {
    /// A coordinate is NaN or infinite: the simulation has blown up earlier.
    #[error(
        "particle {particle} has coordinate {axis} = {value} m: positions must be finite; try a smaller time step"
    )]
    NotFinite {
        /// Index of the particle.
        particle: usize,
        /// 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// The refused coordinate \[m\].
        value: f64,
    },
    /// A particle is so many periods away that its place in the box is lost in rounding.
    #[error(
        "particle {particle} has coordinate {axis} = {value} m, too many periods of {length} m away: wrap positions into the box"
    )]
    TooFar {
        /// Index of the particle.
        particle: usize,
        /// 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// The refused coordinate \[m\].
        value: f64,
        /// Length of the period \[m\].
        length: f64,
    },
    /// The cell size is not a positive finite number.
    #[error("cell size must be positive and finite, got {0} m: give the search radius plus skin")]
    Size(f64),
    /// The length of a periodic axis is not a positive finite number.
    #[error("period of axis {axis} must be positive and finite, got {length} m from {lower} m on")]
    Period {
        /// 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// Lower end of the box \[m\].
        lower: f64,
        /// The refused length \[m\].
        length: f64,
    },
    /// A particle would see two images of the same neighbour.
    #[error(
        "period {length} m of axis {axis} is shorter than twice the cell size {size} m: enlarge the box or reduce the radius"
    )]
    ShortPeriod {
        /// 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// Length of the period \[m\].
        length: f64,
        /// Cell size \[m\].
        size: f64,
    },
    /// Indices are 32 bits wide.
    #[error("{0} particles are more than 32-bit indices can name: split the set")]
    TooMany(usize),
    /// The search reaches beyond the neighbouring cells.
    #[error(
        "reach {reach} m is not between 0 and the cell size {size} m: build the cells with the larger one"
    )]
    Reach {
        /// The refused reach \[m\].
        reach: f64,
        /// Size the cells were built with \[m\].
        size: f64,
    },
    /// The cells describe other positions or another domain than the ones handed to the search.
    #[error(
        "cells were built from other positions (first difference at particle {particle}): build them again"
    )]
    Stale {
        /// First particle that differs.
        particle: usize,
    },
    /// The cells were built for other periods.
    #[error("cells were built for a domain with other periods: build them again")]
    OtherDomain,
    /// A field does not have one entry per particle.
    #[error("field `{field}` has {found} entries, the order has {expected}: nothing was moved")]
    Length {
        /// Name of the field.
        field: &'static str,
        /// Entries of the order.
        expected: usize,
        /// Entries of the field.
        found: usize,
    },
    /// An order names a particle twice or one that does not exist.
    #[error("the order is no permutation: entry {entry} names particle {particle}; nothing was moved")]
    NoPermutation {
        /// Position in the order.
        entry: usize,
        /// Particle named there.
        particle: u32,
    },
    /// A row names a particle beyond the set it is said to point to.
    #[error("row {row} names particle {particle} of a set of {targets}: the rows belong to another set")]
    NoTarget {
        /// Row that holds the entry.
        row: usize,
        /// Particle named there.
        particle: u32,
        /// Size of the set.
        targets: usize,
    },
}
