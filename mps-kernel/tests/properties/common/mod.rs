//! Particle sets with an all-pairs neighbour search, and the random scenes they are built from.

mod cloud;
mod scene;

pub(crate) use cloud::Cloud;
pub(crate) use scene::{Noise, Scene, Weight, scene};

use proptest::prelude::*;

/// Fails unless `|found - expected| <= tolerance`; NaN fails.
pub(crate) fn close(what: &str, found: f64, expected: f64, tolerance: f64) -> Result<(), TestCaseError> {
    let error = (found - expected).abs();
    prop_assert!(
        error <= tolerance,
        "{what}: found {found:e}, expected {expected:e}, off by {error:e}, allowed {tolerance:e}"
    );
    Ok(())
}

/// Rounding unit of a scalar, as `f64`.
pub(crate) fn epsilon<T: mps_kernel::Real>() -> f64 {
    T::default_epsilon().to_double()
}
