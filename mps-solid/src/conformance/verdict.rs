//! Comparing, and saying where a comparison fails.

use super::{Check, ConformanceError};
use mps_kernel::Tensor;

/// On whose behalf is compared.
pub(super) struct Verdict {
    pub(super) check: Check,
    pub(super) material: &'static str,
    /// Allowed deviation in units of the scale that a comparison gives.
    pub(super) tolerance: f64,
}

impl Verdict {
    /// `value` is `expected` within the tolerance times `scale`.
    pub(super) fn equal<const D: usize>(
        &self,
        quantity: &str,
        f: &Tensor<f64, D>,
        value: f64,
        expected: f64,
        scale: f64,
    ) -> Result<(), ConformanceError> {
        let tolerance = self.tolerance * scale;
        // Written so that NaN fails. Equal numbers pass even where the scale is zero.
        if value == expected || (value - expected).abs() <= tolerance {
            return Ok(());
        }
        Err(ConformanceError::Violated {
            check: self.check,
            material: self.material,
            quantity: quantity.to_owned(),
            deformation: f.row_iter().map(|row| row.iter().copied().collect()).collect(),
            value,
            expected,
            tolerance,
        })
    }

    /// The same for every entry, on the scale of the larger of both tensors.
    pub(super) fn equal_tensors<const D: usize>(
        &self,
        quantity: &str,
        f: &Tensor<f64, D>,
        value: &Tensor<f64, D>,
        expected: &Tensor<f64, D>,
    ) -> Result<(), ConformanceError> {
        let scale = value.norm().max(expected.norm());
        for a in 0..D {
            for b in 0..D {
                let entry = format!("entry ({a}, {b}) of {quantity}");
                self.equal(&entry, f, value[(a, b)], expected[(a, b)], scale)?;
            }
        }
        Ok(())
    }
}
