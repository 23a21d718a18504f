//! The numbers a user may choose.

use crate::SolidError;
use mps_kernel::Real;

/// Parameters of the solid's discretisation. The defaults are meant to be left alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidConfig<T> {
    /// Effective radius of the reference neighbourhood in units of the particle spacing \[-\].
    ///
    /// Default 1.6: the nearest and the diagonal neighbours, 8 in 2D and 18 in 3D. Smaller is better
    /// here (unlike in the fluid): a large neighbourhood smears the strain across a thin body. Between
    /// 1.45 and 1.7 nothing but the weights changes; at 2.1 the error is three to four times larger.
    pub radius_ratio: T,
    /// Sub-step as a fraction of the stability limit of the body \[-\].
    ///
    /// Default 0.8. The limit is measured when the solid is built (see `docs/solid.md`), so that the
    /// number means the same for every material, dimension and thickness. For large strain, where the material is
    /// stiffer than at rest, [measure again](crate::Solid::remeasure_stability) or lower it: rubber at four times its
    /// length needs 0.2.
    pub cfl: T,
    /// Multiple of the derived bending correction \[-\], see [`stabilization`](crate::stabilization).
    ///
    /// Default 1, the value that follows from the lattice, the weight and the material. It is not a
    /// tuning parameter: 0 switches the correction off, for studies; zero-energy modes then appear.
    pub bending_correction: T,
    /// Damping `c` of every velocity, `du/dt = ... - c u` \[1/s\].
    ///
    /// Default 0: the energy is kept. For static answers prefer [`Solid::relax`](crate::Solid::relax),
    /// which finds it by itself; for a physical damping of the material write it into a
    /// [`ConstitutiveModel`](crate::ConstitutiveModel).
    pub damping: T,
}

impl<T: Real> Default for SolidConfig<T> {
    fn default() -> Self {
        Self { radius_ratio: T::of(1.6), cfl: T::of(0.8), bending_correction: T::one(), damping: T::zero() }
    }
}

impl<T: Real> SolidConfig<T> {
    /// Checks every field.
    ///
    /// # Errors
    /// [`SolidError::Parameter`] with the name, the value and the allowed range of the first bad field.
    pub fn validate(&self) -> Result<(), SolidError> {
        let check = |name, must, value: T, low: f64, high: f64| {
            let value = value.to_double();
            // Written so that NaN is refused too.
            if value >= low && value <= high {
                Ok(())
            } else {
                Err(SolidError::Parameter { name, must, value })
            }
        };
        check("radius_ratio", "between 1.2 and 6 spacings (usual: 1.6)", self.radius_ratio, 1.2, 6.0)?;
        check("cfl", "positive and at most 1 (usual: 0.8)", self.cfl, f64::MIN_POSITIVE, 1.0)?;
        check("bending_correction", "between 0 and 100 (usual: 1)", self.bending_correction, 0.0, 100.0)?;
        check("damping", "zero or positive and finite, in 1/s", self.damping, 0.0, f64::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_is_checked() {
        let good = SolidConfig::<f64>::default();
        assert!(good.validate().is_ok());
        for bad in [
            SolidConfig { radius_ratio: 1.0, ..good },
            SolidConfig { radius_ratio: f64::NAN, ..good },
            SolidConfig { cfl: 0.0, ..good },
            SolidConfig { cfl: f64::NAN, ..good },
            SolidConfig { bending_correction: -1.0, ..good },
            SolidConfig { damping: -1.0, ..good },
            SolidConfig { damping: f64::INFINITY, ..good },
        ] {
            assert!(matches!(bad.validate(), Err(SolidError::Parameter { .. })), "{bad:?}");
        }
    }
}
