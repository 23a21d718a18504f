//! The numbers a user may choose.

use super::ContactError;
use mps_kernel::Real;

/// Parameters of contact. There is none of the physics: the stiffness follows from the materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactConfig<T> {
    /// Whether bodies feel themselves where they fold. Default true.
    pub self_contact: bool,
    /// Sub-step as a fraction of the stability limit of contact \[-\]. Default 0.8.
    pub cfl: T,
    /// How much farther than the reach of contact is searched, in spacings \[-\]. Only the cost depends on it.
    /// Default 0.5.
    pub skin: T,
    /// Largest overlap with which bodies may begin to move, in spacings \[-\]. Default 0.1. What they are drawn into each other is
    /// turned into speed without it. Bodies that go on from a saved state under a pressure of more than a tenth of their modulus need more.
    pub initial_overlap: T,
}

impl<T: Real> Default for ContactConfig<T> {
    fn default() -> Self {
        Self { self_contact: true, cfl: T::of(0.8), skin: T::of(0.5), initial_overlap: T::of(0.1) }
    }
}

impl<T: Real> ContactConfig<T> {
    /// Checks every field.
    ///
    /// # Errors
    /// [`ContactError::Parameter`] with the first bad field.
    pub fn validate(&self) -> Result<(), ContactError> {
        let check = |name, must, value: T, low: f64, high: f64| {
            let value = value.to_double();
            // Written so that NaN is refused too.
            if value >= low && value <= high {
                Ok(())
            } else {
                Err(ContactError::Parameter { name, must, value })
            }
        };
        check("cfl", "positive and at most 1 (usual: 0.8)", self.cfl, f64::MIN_POSITIVE, 1.0)?;
        check("skin", "between 0 and 10 spacings (usual: 0.5)", self.skin, 0.0, 10.0)?;
        check("initial_overlap", "between 0 and 1 spacing (usual: 0.1)", self.initial_overlap, 0.0, 1.0)
    }
}
