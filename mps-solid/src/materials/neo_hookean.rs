use super::{ConstitutiveModel, MaterialError, Moduli};
use mps_kernel::tensor::{cofactor, determinant};
use mps_kernel::{Real, Tensor};

/// The compressible neo-Hookean material.
///
/// ```text
/// w = mu/2 (tr(F^T F) - D) - mu ln J + lambda/2 ln(J)^2,    P = mu (F - F^-T) + lambda ln(J) F^-T,    J = det F
/// ```
///
/// The stress grows without bound as the volume goes to zero, so that a strongly compressed particle
/// pushes back. Source: Bonet and Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, eq. 6.27.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NeoHookean<T> {
    /// The elastic constants \[Pa\].
    pub moduli: Moduli<T>,
}

impl<T: Real> NeoHookean<T> {
    /// From Young's modulus \[Pa\] and Poisson's ratio \[-\].
    ///
    /// # Errors
    /// If no isotropic material has these constants, see [`MaterialError`].
    pub fn new(youngs_modulus: T, poisson_ratio: T) -> Result<Self, MaterialError> {
        Moduli::new(youngs_modulus, poisson_ratio).map(Self::from)
    }
}

impl<T> From<Moduli<T>> for NeoHookean<T> {
    fn from(moduli: Moduli<T>) -> Self {
        Self { moduli }
    }
}

impl<T: Real, const D: usize> ConstitutiveModel<T, D> for NeoHookean<T> {
    type History = ();

    #[inline]
    fn energy(&self, f: &Tensor<T, D>, _: &()) -> T {
        let Moduli { lambda, mu } = self.moduli;
        let half = T::of(0.5);
        let ln_j = determinant(f).ln();
        mu * (half * (f.norm_squared() - T::of(D as f64)) - ln_j) + lambda * half * ln_j * ln_j
    }

    #[inline]
    fn first_piola(&self, f: &Tensor<T, D>, (): &mut (), _: T) -> Tensor<T, D> {
        let Moduli { lambda, mu } = self.moduli;
        let j = determinant(f);
        // F^-T = cof F / det F
        f * mu + cofactor(f) * ((lambda * j.ln() - mu) / j)
    }

    fn first_lame_modulus(&self) -> T {
        self.moduli.lambda
    }

    fn shear_modulus(&self) -> T {
        self.moduli.mu
    }

    fn name(&self) -> &'static str {
        "neo-hookean"
    }
}
