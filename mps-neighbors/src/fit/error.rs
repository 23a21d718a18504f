//! Shapes that cannot be filled, and what to do about it.

use crate::NeighborError;
use thiserror::Error;

/// Why no points were made of a shape.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FitError {
    /// The spacing is no positive finite number, or the box around the shape has no such sides.
    #[error(
        "spacing must be positive and finite and the box around the shape too, got {spacing} m: give the distance of the points in metres"
    )]
    Size {
        /// The refused spacing \[m\].
        spacing: f64,
    },
    /// More cells around the shape than can be counted.
    #[error(
        "the box around the shape has {cells:.1e} cells of {spacing:e} m: check that lengths are in metres, or give a larger spacing"
    )]
    TooMany {
        /// Cells of the box.
        cells: f64,
        /// Their width \[m\].
        spacing: f64,
    },
    /// The shape has less volume than half a cell, or no surface.
    #[error("the shape has no room for a point: enlarge it or give a spacing below {spacing:e} m")]
    Empty {
        /// The spacing that was asked for \[m\].
        spacing: f64,
    },
    /// Somewhere nothing is half a spacing deep.
    #[error(
        "the shape is too thin near {place}: a point there is {depth:.2} spacings inside its surface, not 0.5; make it thicker, or give a spacing below {spacing:.3e} m"
    )]
    TooThin {
        /// Where \[m\].
        place: String,
        /// The largest depth found there, over the spacing.
        depth: f64,
        /// The spacing that was asked for \[m\].
        spacing: f64,
    },
    /// Points that repel each other stay near each other.
    #[error(
        "the shape has no room for its points near {place}: two stay {distance:.2} spacings apart; make it thicker, or give a spacing below {spacing:.3e} m"
    )]
    TooClose {
        /// Where \[m\].
        place: String,
        /// Distance of the two over the spacing.
        distance: f64,
        /// The spacing that was asked for \[m\].
        spacing: f64,
    },
    /// Places that are not finite: the shape gives such.
    #[error(transparent)]
    Search(#[from] NeighborError),
}
