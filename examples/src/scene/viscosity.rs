//! The viscosity of a scene file.

use mps_fluid::{ArtificialViscosity, CompactViscosity, LaminarViscosity, Viscosity};
use mps_io::scene_file;
use mps_kernel::{Number, Pair, Real, ReferenceDensity, Vector};

/// One of the viscosities that scene files know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Viscous<T> {
    /// None.
    None,
    /// Artificial viscosity.
    Artificial(ArtificialViscosity<T>),
    /// Laminar viscosity.
    Laminar(LaminarViscosity<T>),
    /// Laminar viscosity between near neighbours.
    Compact(CompactViscosity<T>),
}

impl<T: Real> Viscous<T> {
    /// From its description, for a fluid of this sound speed \[m/s\] on the given lattice.
    pub fn new<const D: usize>(
        viscosity: &scene_file::Viscosity,
        sound: T,
        reference: &ReferenceDensity<T>,
    ) -> Self {
        match *viscosity {
            scene_file::Viscosity::None => Self::None,
            scene_file::Viscosity::Artificial(alpha) => {
                Self::Artificial(ArtificialViscosity::new::<D>(T::of(alpha), sound, reference))
            }
            scene_file::Viscosity::Laminar(nu) => {
                Self::Laminar(LaminarViscosity::new::<D>(T::of(nu), reference))
            }
            scene_file::Viscosity::Compact(nu) => {
                Self::Compact(CompactViscosity::new::<D>(T::of(nu), reference))
            }
        }
    }
}

impl<T: Real, const D: usize> Viscosity<T, D> for Viscous<T> {
    #[inline(always)]
    fn add<N: Number<T>, J>(
        &self,
        sum: &mut Vector<N, D>,
        pair: &Pair<N, D, J>,
        ui: &Vector<T, D>,
        uj: &Vector<N, D>,
    ) {
        match self {
            Self::None => {}
            Self::Artificial(viscosity) => viscosity.add(sum, pair, ui, uj),
            Self::Laminar(viscosity) => viscosity.add(sum, pair, ui, uj),
            Self::Compact(viscosity) => viscosity.add(sum, pair, ui, uj),
        }
    }

    fn kinematic(&self) -> T {
        match self {
            Self::None => T::zero(),
            Self::Artificial(viscosity) => Viscosity::<T, D>::kinematic(viscosity),
            Self::Laminar(viscosity) => Viscosity::<T, D>::kinematic(viscosity),
            Self::Compact(viscosity) => Viscosity::<T, D>::kinematic(viscosity),
        }
    }
}
