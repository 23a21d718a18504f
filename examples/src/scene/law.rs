//! The material of a scene file.

use mps_io::scene_file::{Elasticity, Material};
use mps_kernel::{Real, Tensor};
use mps_solid::ConstitutiveModel;
use mps_solid::materials::{
    CorotationalHooke, MaterialError, NearlyIncompressible, NeoHookean, SaintVenantKirchhoff,
};

/// One of the materials that scene files know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law<T> {
    /// Hooke's law in the frame that turns with the material.
    Corotational(CorotationalHooke<T>),
    /// That of Saint Venant and Kirchhoff.
    SaintVenant(SaintVenantKirchhoff<T>),
    /// The compressible neo-Hookean law.
    NeoHookean(NeoHookean<T>),
    /// Rubber that hardly changes its volume.
    NearlyIncompressible(NearlyIncompressible<T>),
}

impl<T: Real> Law<T> {
    /// From its description.
    ///
    /// # Errors
    /// If no isotropic material has these constants.
    pub fn new(material: &Material) -> Result<Self, MaterialError> {
        let Elasticity { youngs_modulus, poissons_ratio } = material.elasticity();
        let (e, nu) = (T::of(youngs_modulus), T::of(poissons_ratio));
        Ok(match material {
            Material::Corotational(_) => Self::Corotational(CorotationalHooke::new(e, nu)?),
            Material::SaintVenant(_) => Self::SaintVenant(SaintVenantKirchhoff::new(e, nu)?),
            Material::NeoHookean(_) => Self::NeoHookean(NeoHookean::new(e, nu)?),
            Material::NearlyIncompressible(_) => {
                Self::NearlyIncompressible(NearlyIncompressible::new(e, nu)?)
            }
        })
    }
}

/// Asks the law that it is.
macro_rules! ask {
    ($law:expr, $model:ident => $answer:expr) => {
        match $law {
            Law::Corotational($model) => $answer,
            Law::SaintVenant($model) => $answer,
            Law::NeoHookean($model) => $answer,
            Law::NearlyIncompressible($model) => $answer,
        }
    };
}

impl<T: Real, const D: usize> ConstitutiveModel<T, D> for Law<T> {
    type History = ();

    #[inline]
    fn energy(&self, f: &Tensor<T, D>, history: &()) -> T {
        ask!(self, model => model.energy(f, history))
    }

    #[inline]
    fn first_piola(&self, f: &Tensor<T, D>, history: &mut (), elapsed: T) -> Tensor<T, D> {
        ask!(self, model => model.first_piola(f, history, elapsed))
    }

    fn first_lame_modulus(&self) -> T {
        ask!(self, model => ConstitutiveModel::<T, D>::first_lame_modulus(model))
    }

    fn shear_modulus(&self) -> T {
        ask!(self, model => ConstitutiveModel::<T, D>::shear_modulus(model))
    }

    fn name(&self) -> &'static str {
        ask!(self, model => ConstitutiveModel::<T, D>::name(model))
    }
}
