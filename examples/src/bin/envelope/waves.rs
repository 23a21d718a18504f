//! Von Neumann's analysis of the lattice: what the sums over neighbours make of a plane wave, with the spacing and the speed of sound as units.
//!
//! A wave `exp(i k.r)` of the density and of the velocity along `kappa` goes in one step of the length `C` (the Courant number) through
//!
//! ```text
//! u' = u - i C |kappa| n,   n' = n (1 - b) - i C |kappa| u',
//! kappa = (D/n0) sum r W/r^2 sin k.r        gradient and divergence
//! b = delta C sigma                         density diffusion (eqs. 19, 20),
//! sigma = (2D/n0) sum W/r^2 (1 - cos k.r) - |kappa|^2
//! ```
//!
//! with the trace `2 - b - C^2 kappa^2` and the determinant `1 - b`. Both eigenvalues are inside the unit circle while the
//! determinant is and `C^2 kappa^2 + 2 b < 4`. Without diffusion that is `C < 2/kappa`.
//!
//! On the lattice the corrected sums are the plain ones: the moment matrix is the identity.

use core::f64::consts::TAU;
use mps_examples::Failure;
use mps_examples::basin::lattice;
use mps_kernel::{Kernel, LatticeWaves, ReferenceDensity, Vector, WaveSymbols};

/// What keeps a wave within bounds, or does not.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Step {
    /// Courant number `c dt/l0`.
    pub(crate) courant: f64,
    /// `delta` of the density diffusion.
    pub(crate) delta: f64,
}

fn is_stable(wave: &WaveSymbols, step: Step) -> bool {
    let a = step.courant.powi(2) * wave.slope;
    let b = step.delta * step.courant * wave.filter;
    a + 2.0 * b < 4.0 && (1.0 - b).abs() <= 1.0
}

/// The lattice with this radius in spacings.
pub(crate) fn lattice_of<const D: usize, K: Kernel<f64>>(
    kernel: &K,
    radius: f64,
) -> Result<LatticeWaves<D>, Failure> {
    Ok(LatticeWaves::new(kernel, &ReferenceDensity::lattice::<K, D>(kernel, 1.0, radius)?))
}

/// The wave vectors that fit a periodic box of `side` spacings, but zero.
pub(crate) fn vectors<const D: usize>(side: usize) -> impl Iterator<Item = Vector<f64, D>> {
    let whole = lattice::<f64, D>([-0.5; D], [side; D], 1.0);
    whole.into_iter().skip(1).map(move |m| m * (TAU / side as f64))
}

/// All waves of the box.
pub(crate) fn waves<const D: usize, K: Kernel<f64>>(
    kernel: &K,
    radius: f64,
    side: usize,
) -> Result<Vec<WaveSymbols>, Failure> {
    let lattice = lattice_of::<D, K>(kernel, radius)?;
    Ok(vectors(side).map(|k| lattice.symbols(&k)).collect())
}

/// The value up to which all waves are stable, between 0 and 100.
pub(crate) fn border(waves: &[WaveSymbols], step: impl Fn(f64) -> Step) -> f64 {
    let (mut stable, mut unstable) = (0.0, 100.0);
    for _ in 0..60 {
        let middle = 0.5 * (stable + unstable);
        if waves.iter().all(|wave| is_stable(wave, step(middle))) {
            stable = middle
        } else {
            unstable = middle
        }
    }
    stable
}

#[cfg(test)]
mod tests {
    use super::*;
    use mps_kernel::weights::Rational;

    /// The number that `mps-kernel` gives for the filter, and the slope of long waves.
    #[test]
    fn the_symbols_are_those_of_the_operators() {
        let waves = waves::<2, _>(&Rational, 3.0, 64).unwrap();
        let strongest = waves.iter().fold(0.0_f64, |most, wave| most.max(wave.filter));
        assert!((strongest - 3.916).abs() < 5e-4, "{strongest}");
        let k2 = (TAU / 64.0_f64).powi(2);
        assert!((waves[0].slope / k2 - 1.0).abs() < 0.05, "{}", waves[0].slope / k2);
    }

    #[test]
    fn without_diffusion_the_border_is_two_over_the_steepest_slope() {
        let waves = waves::<2, _>(&Rational, 3.0, 16).unwrap();
        let steepest = waves.iter().fold(0.0_f64, |most, wave| most.max(wave.slope)).sqrt();
        let border = border(&waves, |courant| Step { courant, ..Step::default() });
        assert!((border * steepest / 2.0 - 1.0).abs() < 1e-9, "{border}");
    }
}
