//! How far a fluid is from incompressible: what the speed of sound has been chosen for, watched while it runs.

use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real};
use mps_neighbors::Domain;

/// What an incompressible fluid would have none of. The density goes with the square of the Mach number: 0.1 and 1 % are usual.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Compressibility<T> {
    /// Largest speed of a particle over the speed of sound \[-\].
    pub mach: T,
    /// Largest difference of a density ratio `n/n0` from 1 that makes a pressure \[-\]: of compression alone with
    /// [`Tension::Clip`](crate::Tension::Clip).
    pub density: T,
}

impl<T: Real> Compressibility<T> {
    /// The larger one of each.
    pub(crate) fn larger(&self, other: &Self) -> Self {
        Self { mach: self.mach.max(other.mach), density: self.density.max(other.density) }
    }
}

/// Difference of a density ratio from 1, if it makes a pressure; a part of [`Compressibility`].
#[inline(always)]
pub(crate) fn deviation<T: Real>(density: T, clip: bool) -> T {
    let compression = density - T::one();
    if clip { compression.max(T::zero()) } else { compression.abs() }
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
}
