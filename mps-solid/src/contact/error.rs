//! What can go wrong with bodies in contact, and what to do about it.

use crate::SolidError;
use mps_neighbors::NeighborError;
use thiserror::Error;

/// Why bodies could not be put into contact or moved.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ContactError {
    /// A parameter is out of range.
    #[error("{name} must be {must}, got {value}")]
    Parameter {
        /// Which one.
        name: &'static str,
        /// What it must be.
        must: &'static str,
        /// What it was.
        value: f64,
    },
    /// A body has an unusable spacing, modulus, mass or volume.
    #[error("the {name} of body {body} must be positive and finite, got {value}")]
    Shape {
        /// Number of the body.
        body: usize,
        /// What is wrong with it.
        name: &'static str,
        /// The value.
        value: f64,
    },
    /// The surface of a body is not where contact takes it.
    #[error(
        "the spacings of body {body} along the axes differ by a factor of {ratio}, contact takes {largest} at most: build the body with numbers of particles that make its cells more nearly square (body::counts does)"
    )]
    Uneven {
        /// Number of the body.
        body: usize,
        /// Largest spacing over the smallest.
        ratio: f64,
        /// What is allowed.
        largest: f64,
    },
    /// A body has no usable step.
    #[error(
        "the largest sub-step of body {body} is {value} s: it must be positive and finite; look at its velocities and its material"
    )]
    Step {
        /// Number of the body.
        body: usize,
        /// What it gave \[s\].
        value: f64,
    },
    /// Bodies overlap before they have moved.
    #[error(
        "bodies {body} and {other} overlap by {overlap} m at the start, {largest} m are allowed: it would be turned into speed; draw them apart (the surface lies half a spacing outside the outermost particles, so a face that was clamped or slides and has its particles on it reaches half a spacing farther than drawn: use body::wall for a rigid wall), or raise ContactConfig::initial_overlap if they come from a saved state under pressure"
    )]
    Overlap {
        /// Number of the one body.
        body: usize,
        /// Number of the other (the same one where it meets itself).
        other: usize,
        /// Overlap \[m\].
        overlap: f64,
        /// What is allowed \[m\].
        largest: f64,
    },
    /// Other bodies are moved than were put into contact.
    #[error(
        "{got} bodies were given, but {expected} were put into contact: hand over all, in the same order"
    )]
    Bodies {
        /// Bodies given.
        got: usize,
        /// Bodies added.
        expected: usize,
    },
    /// The number of entries of a body is not that of its particles.
    #[error("{name} of body {body} has {got} entries, but the body has {particles} particles")]
    Length {
        /// Number of the body.
        body: usize,
        /// What was given.
        name: &'static str,
        /// Its length.
        got: usize,
        /// Particles of the body.
        particles: usize,
    },
    /// The surfaces of two bodies, or of one that is folded, have passed through one another.
    #[error(
        "particle {particle} of body {body} is {overlap} m deep in body {other} (nearest there: particle {neighbor}), more than the {deepest} m contact can push back from: if they overlap at the start, draw them apart (and use body::wall instead of a clamped or sliding face that is touched: its particles lie on it); otherwise the bodies are as they were before Contact::advance was called: call it again with half the sub-step (ContactConfig::cfl), then with a lower load or speed: it takes a pressure of about half the modulus lambda + 2 mu"
    )]
    Passed {
        /// Index of the particle.
        particle: usize,
        /// Number of its body.
        body: usize,
        /// Number of the body it is in (the same one where it is folded).
        other: usize,
        /// Index of the nearest particle of that body.
        neighbor: usize,
        /// Overlap \[m\].
        overlap: f64,
        /// Largest overlap allowed \[m\].
        deepest: f64,
    },
    /// The search refused the positions, for example because one is NaN.
    #[error("search between bodies {body} and {other}: {source}")]
    Search {
        /// Number of the one body.
        body: usize,
        /// Number of the other.
        other: usize,
        /// What was wrong.
        source: NeighborError,
    },
    /// A body cannot go on.
    #[error("body {body}: {source}")]
    Body {
        /// Number of the body.
        body: usize,
        /// Why.
        source: SolidError,
    },
}
