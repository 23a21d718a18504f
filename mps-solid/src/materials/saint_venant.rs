use super::{ConstitutiveModel, MaterialError, Moduli};
use mps_kernel::tensor::green_lagrange;
use mps_kernel::{Real, Tensor};

/// Hooke's law between the Green-Lagrange strain and the second Piola-Kirchhoff stress.
///
/// ```text
/// w = lambda/2 tr(E)^2 + mu |E|^2,    P = F [lambda tr(E) I + 2 mu E],    E = (F^T F - I)/2
/// ```
///
/// Softens under strong compression (it does not resist being flattened to nothing): for small strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SaintVenantKirchhoff<T> {
    /// The elastic constants \[Pa\].
    pub moduli: Moduli<T>,
}

impl<T: Real> SaintVenantKirchhoff<T> {
    /// From Young's modulus \[Pa\] and Poisson's ratio \[-\].
    ///
    /// # Errors
    /// If no isotropic material has these constants, see [`MaterialError`].
    pub fn new(youngs_modulus: T, poisson_ratio: T) -> Result<Self, MaterialError> {
        Moduli::new(youngs_modulus, poisson_ratio).map(Self::from)
    }
}

impl<T> From<Moduli<T>> for SaintVenantKirchhoff<T> {
    fn from(moduli: Moduli<T>) -> Self {
        Self { moduli }
    }
}

impl<T: Real, const D: usize> ConstitutiveModel<T, D> for SaintVenantKirchhoff<T> {
    type History = ();

    #[inline]
    fn energy(&self, f: &Tensor<T, D>, _: &()) -> T {
        let Moduli { lambda, mu } = self.moduli;
        let e = green_lagrange(f);
        let trace = e.trace();
        lambda * T::of(0.5) * trace * trace + mu * e.norm_squared()
    }

    #[inline]
    fn first_piola(&self, f: &Tensor<T, D>, (): &mut (), _: T) -> Tensor<T, D> {
        let Moduli { lambda, mu } = self.moduli;
        let e = green_lagrange(f);
        f * (Tensor::identity() * (lambda * e.trace()) + e * (mu * T::of(2.0)))
    }

    fn first_lame_modulus(&self) -> T {
        self.moduli.lambda
    }

    fn shear_modulus(&self) -> T {
        self.moduli.mu
    }

    fn name(&self) -> &'static str {
        "saint-venant-kirchhoff"
    }
}
