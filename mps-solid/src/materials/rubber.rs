use super::{ConstitutiveModel, MaterialError, Moduli};
use mps_kernel::tensor::{cofactor, determinant};
use mps_kernel::{Real, Tensor};

/// Rubber that hardly changes its volume: neo-Hookean in shape, a stiff spring in volume.
///
/// ```text
/// w = mu/2 (J^(-2/3) I1 - 3) + K/2 [(J^2 - 1)/2 - ln J],    I1 = tr(F^T F) + 3 - D,    J = det F
/// P = mu J^(-2/3) (F - I1/3 F^-T) + K/2 (J^2 - 1) F^-T
/// ```
///
/// The first term sees the change of shape only (in 2D the third stretch is 1, plane strain), the second
/// the change of volume only, so that each modulus can be measured alone. The pressure
/// grows without bound as the volume goes to zero. Source: Simo and Hughes, Computational Inelasticity, eq. 9.2.3.
///
/// A stiff volume costs time: the stable sub-step falls with `sqrt(K/mu)`. `K/mu = 50` (`nu = 0.49`) is
/// incompressible enough for most loads on a thin body; use an odd number of particles across
/// (`docs/solid.md`, section 4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearlyIncompressible<T> {
    /// Shear modulus `mu` \[Pa\].
    pub shear: T,
    /// Bulk modulus `K` \[Pa\].
    pub bulk: T,
}

impl<T: Real> NearlyIncompressible<T> {
    /// From Young's modulus \[Pa\] and Poisson's ratio \[-\] of the undeformed material.
    ///
    /// # Errors
    /// If no isotropic material has these constants, see [`MaterialError`].
    pub fn new(youngs_modulus: T, poisson_ratio: T) -> Result<Self, MaterialError> {
        Moduli::new(youngs_modulus, poisson_ratio).map(Self::from)
    }

    /// From the shear modulus `mu` and the bulk modulus `K` \[Pa\].
    ///
    /// # Errors
    /// If one of them is not positive and finite.
    pub fn from_shear_and_bulk(shear: T, bulk: T) -> Result<Self, MaterialError> {
        // The check is that of the moduli; keeping K itself loses no digits for K much larger than mu.
        Moduli::from_bulk_and_shear(bulk, shear).map(|_| Self { shear, bulk })
    }
}

impl<T: Real> From<Moduli<T>> for NearlyIncompressible<T> {
    fn from(moduli: Moduli<T>) -> Self {
        Self { shear: moduli.mu, bulk: moduli.lambda + moduli.mu * T::of(2.0 / 3.0) }
    }
}

/// `J^(-2/3)`.
#[inline]
fn unit_volume<T: Real>(j: T) -> T {
    let root = j.cbrt();
    T::one() / (root * root)
}

/// `I1` of the deformation in space.
#[inline]
fn first_invariant<T: Real, const D: usize>(f: &Tensor<T, D>) -> T {
    f.norm_squared() + T::of(3.0 - D as f64)
}

impl<T: Real, const D: usize> ConstitutiveModel<T, D> for NearlyIncompressible<T> {
    type History = ();

    #[inline]
    fn energy(&self, f: &Tensor<T, D>, _: &()) -> T {
        let (half, j) = (T::of(0.5), determinant(f));
        let shape = unit_volume(j) * first_invariant(f) - T::of(3.0);
        let volume = (j * j - T::one()) * half - j.ln();
        (self.shear * shape + self.bulk * volume) * half
    }

    #[inline]
    fn first_piola(&self, f: &Tensor<T, D>, (): &mut (), _: T) -> Tensor<T, D> {
        let j = determinant(f);
        let shape = self.shear * unit_volume(j);
        let pressure = self.bulk * T::of(0.5) * (j * j - T::one());
        // F^-T = cof F / J
        f * shape + cofactor(f) * ((pressure - shape * first_invariant(f) / T::of(3.0)) / j)
    }

    fn first_lame_modulus(&self) -> T {
        self.bulk - self.shear * T::of(2.0 / 3.0)
    }

    fn shear_modulus(&self) -> T {
        self.shear
    }

    fn name(&self) -> &'static str {
        "nearly-incompressible"
    }
}
