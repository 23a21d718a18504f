use super::{ConstitutiveModel, MaterialError, Moduli};
use mps_kernel::tensor::polar_rotation;
use mps_kernel::{Real, Tensor};

/// Hooke's law in the frame that rotates with the material.
///
/// With the polar decomposition `F = R U` and the Biot strain `U - I`,
///
/// ```text
/// w = lambda/2 tr(U - I)^2 + mu |U - I|^2,    P = R [lambda tr(U - I) I + 2 mu (U - I)]
/// ```
///
/// Source: eqs. 27-32 of Tavakoli et al. 2026, where `R` is a rotation carried by every particle; here it
/// is the rotation of the deformation gradient, the one that minimises the energy (Chao et al. 2010).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CorotationalHooke<T> {
    /// The elastic constants \[Pa\].
    pub moduli: Moduli<T>,
}

impl<T: Real> CorotationalHooke<T> {
    /// From Young's modulus \[Pa\] and Poisson's ratio \[-\].
    ///
    /// # Errors
    /// If no isotropic material has these constants, see [`MaterialError`].
    pub fn new(youngs_modulus: T, poisson_ratio: T) -> Result<Self, MaterialError> {
        Moduli::new(youngs_modulus, poisson_ratio).map(Self::from)
    }
}

impl<T> From<Moduli<T>> for CorotationalHooke<T> {
    fn from(moduli: Moduli<T>) -> Self {
        Self { moduli }
    }
}

impl<T: Real, const D: usize> ConstitutiveModel<T, D> for CorotationalHooke<T> {
    type History = ();

    #[inline]
    fn energy(&self, f: &Tensor<T, D>, _: &()) -> T {
        let Some(r) = polar_rotation(f) else { return T::of(f64::NAN) };
        let Moduli { lambda, mu } = self.moduli;
        // |U - I| = |F - R| and tr(U - I) = R : F - D.
        let trace = r.dot(f) - T::of(D as f64);
        lambda * T::of(0.5) * trace * trace + mu * (f - r).norm_squared()
    }

    #[inline]
    fn first_piola(&self, f: &Tensor<T, D>, (): &mut (), _: T) -> Tensor<T, D> {
        let Some(r) = polar_rotation(f) else { return Tensor::repeat(T::of(f64::NAN)) };
        let Moduli { lambda, mu } = self.moduli;
        let trace = r.dot(f) - T::of(D as f64);
        r * (lambda * trace) + (f - r) * (mu * T::of(2.0))
    }

    fn first_lame_modulus(&self) -> T {
        self.moduli.lambda
    }

    fn shear_modulus(&self) -> T {
        self.moduli.mu
    }

    fn name(&self) -> &'static str {
        "corotational-hooke"
    }
}
