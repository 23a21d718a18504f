//! The numbers a user may choose.

use crate::SolidError;
use mps_kernel::Real;

/// Which number density a pair is divided by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normalization {
    /// That of the particle whose rate is summed, as printed.
    #[default]
    Own,
    /// Half from either end: the forces are then the gradient of an energy.
    Shared,
}

/// Parameters of the printed scheme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinConfig<T> {
    /// Effective radius in spacings \[-\]. Default 3, the paper's.
    pub radius_ratio: T,
    /// Sub-step in units of `l0/(c_p + v)` \[-\]. Default 0.4. With the default radius the border is at 0.56 for Poisson's
    /// ratio 0, 0.75 for 0.3 and 0.98 for 0.4 (`docs/solid.md`, section 11).
    pub cfl: T,
    /// Which number density a pair is divided by.
    pub normalization: Normalization,
}

impl<T: Real> Default for SpinConfig<T> {
    fn default() -> Self {
        Self { radius_ratio: T::of(3.0), cfl: T::of(0.4), normalization: Normalization::Own }
    }
}

impl<T: Real> SpinConfig<T> {
    /// Checks every field.
    ///
    /// # Errors
    /// [`SolidError::Parameter`] with the name, the value and the allowed range of the first bad field.
    pub fn validate(&self) -> Result<(), SolidError> {
        let refuse = |name, must, value: T| SolidError::Parameter { name, must, value: value.to_double() };
        let (radius, cfl) = (self.radius_ratio.to_double(), self.cfl.to_double());
        // Written so that NaN is refused too.
        if !(1.2..=6.0).contains(&radius) {
            return Err(refuse("radius_ratio", "between 1.2 and 6 spacings (usual: 3)", self.radius_ratio));
        }
        if !(cfl > 0.0 && cfl <= 1.0) {
            return Err(refuse("cfl", "positive and at most 1 (usual: 0.4)", self.cfl));
        }
        Ok(())
    }
}
