//! How far a fluid is from incompressible: what the speed of sound has been chosen for, watched while it runs.

use crate::eos::EquationOfState;
use crate::terms::Viscosity;
use crate::{Fluid, Tension};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Domain;

/// What an incompressible fluid would have none of. The density goes with the square of the Mach number: 0.1 and 1 % are usual.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Compressibility<T> {
    /// Largest speed of a particle over the speed of sound \[-\].
    pub mach: T,
    /// Largest difference of a density ratio `n/n0` from 1 that makes a pressure \[-\]: with [`Tension::Clip`](crate::Tension::Clip)
    /// of compression alone, unless a background pressure is there to be lost.
    pub density: T,
}

impl<T: Real> Compressibility<T> {
    /// The larger one of each.
    pub(crate) fn larger(&self, other: &Self) -> Self {
        Self { mach: self.mach.max(other.mach), density: self.density.max(other.density) }
    }
}

/// Difference of a density ratio from 1 as far as it makes a pressure: below `loosest` there is none. A part of [`Compressibility`].
#[inline(always)]
pub(crate) fn deviation<T: Real>(density: T, loosest: T) -> T {
    (bounded(density, loosest) - T::one()).abs()
}

/// The density ratio, or `loosest` below that. What is no number stays so, which `max` would hide.
#[inline(always)]
pub(crate) fn bounded<T: Real>(density: T, loosest: T) -> T {
    if density < loosest { loosest } else { density }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// How compressible the fluid was when the last step began; zero before the first.
    pub fn compressibility(&self) -> Compressibility<T> {
        self.compressibility
    }

    /// The largest values of [`compressibility`](Self::compressibility) in all steps so far, those before a restart as well.
    pub fn largest_compressibility(&self) -> Compressibility<T> {
        self.compressibility_seen
    }

    /// The density ratio at which the pressure has fallen to zero, and below which it stays there \[-\]: 1 without a background pressure; zero
    /// for a fluid that bears tension.
    pub(crate) fn loosest(&self) -> T {
        match self.config.tension {
            Tension::Clip => self.eos.density(T::zero()),
            Tension::Keep => T::zero(),
        }
    }
}
