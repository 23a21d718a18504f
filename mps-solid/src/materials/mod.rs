//! Constitutive models: strain energy and the stress derived from it, one material a file.
//!
//! | material | energy per reference volume | use |
//! |---|---|---|
//! | [`CorotationalHooke`] | `lambda/2 tr(U-I)^2 + mu abs(U-I)^2` | large rotation, small strain: the law of Tavakoli et al. 2026 |
//! | [`SaintVenantKirchhoff`] | `lambda/2 tr(E)^2 + mu abs(E)^2` | the same, and the usual choice of benchmarks |
//! | [`NeoHookean`] | `mu/2 (tr C - D) - mu ln J + lambda/2 ln(J)^2` | large strain; resists compression to a point |
//! | [`NearlyIncompressible`] | `mu/2 (J^(-2/3) I1 - 3) + K/2 [(J^2-1)/2 - ln J]` | rubber: shape and volume cost apart |
//!
//! All four agree to first order with Hooke's law. In 2D they describe plane strain: the third stretch
//! is 1 (it drops out of every formula but the last, whose `I1 = tr C + 3 - D` contains it).
//!
//! A material of your own is one implementation of [`ConstitutiveModel`]; [`conformance`](crate::conformance)
//! finds what is wrong with it, and the program `custom-material` of the examples shows how it is done.

mod ambient;
mod corotational;
mod moduli;
mod neo_hookean;
mod rubber;
mod saint_venant;

pub use ambient::Ambient;
pub use corotational::CorotationalHooke;
pub use moduli::{MaterialError, Moduli};
pub use neo_hookean::NeoHookean;
pub use rubber::NearlyIncompressible;
pub use saint_venant::SaintVenantKirchhoff;

use mps_kernel::{Pod, Real, Tensor};

/// A material: what a deformation costs and which stress it causes.
///
/// The stress must be the derivative of the energy, `P = dw/dF`, and both must not notice a rotation:
/// `w(Q F) = w(F)`, `P(Q F) = Q P(F)`. Conservation of momentum and energy rests on it.
pub trait ConstitutiveModel<T: Real, const D: usize>: Send + Sync {
    /// What a particle of this material remembers, `()` for an elastic one (takes no memory).
    type History: Pod + Default + Send + Sync;

    /// Strain energy `w` per reference volume \[J/m^3\] for the deformation gradient `f`, `det f > 0`.
    fn energy(&self, f: &Tensor<T, D>, history: &Self::History) -> T;

    /// First Piola-Kirchhoff stress `P = dw/dF` \[Pa\], `det f > 0`; may update the history.
    ///
    /// `elapsed` is the time since the history was last updated \[s\]: the sub-step, or zero when the
    /// stress of an unchanged state is asked for again. A model with a memory must then neither
    /// change it nor divide by it, and give the stress that it gave before: a part that depends on a rate is
    /// made of the rate in the history. Otherwise looking at a body would change its motion.
    fn first_piola(&self, f: &Tensor<T, D>, history: &mut Self::History, elapsed: T) -> Tensor<T, D>;

    /// Lets the history be that of a body at rest with the deformation gradient `f`: asked for where a body is brought to its static
    /// equilibrium, in no time, before the search and after it. A material that remembers where it was, to know how fast it moves, must
    /// forget the way here; one that hardens with what it has been through may leave it as it is, as this does unless it is replaced.
    fn settle(&self, _f: &Tensor<T, D>, _history: &mut Self::History) {}

    /// Lame's first modulus `lambda` of the undeformed material \[Pa\].
    fn first_lame_modulus(&self) -> T;

    /// Shear modulus `mu` of the undeformed material \[Pa\].
    fn shear_modulus(&self) -> T;

    /// Fastest small-strain wave `c_p = sqrt((lambda + 2 mu)/rho)` \[m/s\] for the density `rho` \[kg/m^3\].
    fn wave_speed(&self, density: T) -> T {
        ((self.first_lame_modulus() + self.shear_modulus() * T::of(2.0)) / density).sqrt()
    }

    /// Name for summaries and plots.
    fn name(&self) -> &'static str;
}
