use mps_kernel::Real;
use thiserror::Error;

/// The two constants of isotropic linear elasticity, as Lame's moduli \[Pa\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moduli<T> {
    /// First modulus `lambda` \[Pa\].
    pub lambda: T,
    /// Shear modulus `mu` \[Pa\].
    pub mu: T,
}

/// Why no material exists with the given constants.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum MaterialError {
    /// Young's modulus is not positive and finite.
    #[error("Young's modulus must be positive and finite, got {0} Pa (rubber: about 1e7, steel: 2e11)")]
    YoungsModulus(f64),
    /// Poisson's ratio is outside the open interval (-1, 0.5).
    #[error(
        "Poisson's ratio must lie between -1 and 0.5 (both excluded), got {0}: for an almost incompressible material use 0.47 to 0.49"
    )]
    PoissonRatio(f64),
    /// The bulk or the shear modulus is not positive and finite.
    #[error("bulk and shear modulus must be positive and finite, got K = {bulk} Pa and G = {shear} Pa")]
    BulkAndShear {
        /// The bulk modulus \[Pa\].
        bulk: f64,
        /// The shear modulus \[Pa\].
        shear: f64,
    },
}

impl<T: Real> Moduli<T> {
    /// From Young's modulus \[Pa\] and Poisson's ratio \[-\] (three-dimensional values, in 2D too).
    ///
    /// # Errors
    /// If `E` is not positive and finite or `nu` is not inside `(-1, 0.5)`.
    pub fn new(youngs_modulus: T, poisson_ratio: T) -> Result<Self, MaterialError> {
        let (e, nu) = (youngs_modulus.to_double(), poisson_ratio.to_double());
        if !(e.is_finite() && e > 0.0) {
            return Err(MaterialError::YoungsModulus(e));
        }
        if !(nu > -1.0 && nu < 0.5) {
            return Err(MaterialError::PoissonRatio(nu));
        }
        Ok(Self {
            lambda: T::of(e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu))),
            mu: T::of(e / (2.0 * (1.0 + nu))),
        })
    }

    /// From the bulk modulus `K` and the shear modulus `G` \[Pa\]: `lambda = K - 2 G/3`.
    ///
    /// # Errors
    /// If one of them is not positive and finite.
    pub fn from_bulk_and_shear(bulk: T, shear: T) -> Result<Self, MaterialError> {
        let (k, g) = (bulk.to_double(), shear.to_double());
        if !(k.is_finite() && k > 0.0 && g.is_finite() && g > 0.0) {
            return Err(MaterialError::BulkAndShear { bulk: k, shear: g });
        }
        Ok(Self { lambda: T::of(k - 2.0 / 3.0 * g), mu: shear })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn the_two_ways_in_agree() {
        // Gray, Monaghan and Swift 2001: K = 3.25 MPa, G = 0.715 MPa.
        let a = Moduli::from_bulk_and_shear(3.25e6, 0.715e6).unwrap();
        let (k, g) = (3.25e6, 0.715e6);
        let b =
            Moduli::new(9.0 * k * g / (3.0 * k + g), (3.0 * k - 2.0 * g) / (2.0 * (3.0 * k + g))).unwrap();
        assert_relative_eq!(a.lambda, b.lambda, max_relative = 1e-12);
        assert_relative_eq!(a.mu, b.mu, max_relative = 1e-12);
    }

    #[test]
    fn impossible_constants_are_refused() {
        for e in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(Moduli::new(e, 0.3), Err(MaterialError::YoungsModulus(_))), "{e}");
        }
        for nu in [0.5, -1.0, 0.7, f64::NAN] {
            assert!(matches!(Moduli::new(1.0, nu), Err(MaterialError::PoissonRatio(_))), "{nu}");
        }
        assert!(Moduli::from_bulk_and_shear(f64::NAN, 1.0).is_err());
    }
}
