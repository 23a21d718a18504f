//! Von Neumann's analysis of the lattice: what the sums over neighbours make of a plane wave, with the spacing and the speed of sound as units.
//!
//! A wave `exp(i k.r)` of the density and of the velocity along `kappa` goes in one step of the length `C` (the Courant number) through
//!
//! ```text
//! u' = u - i C |kappa| n,   n' = n (1 - b) - i C |kappa| u',
//! kappa = (D/n0) sum r W/r^2 sin k.r        gradient and divergence
//! b = delta C^2 sigma                       density diffusion (eqs. 19, 20),
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
use mps_kernel::{Kernel, ReferenceDensity, Vector};

/// The numbers of a wave.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wave {
    /// `|kappa|^2`.
    slope: f64,
    /// `sigma`.
    filter: f64,
}

/// What keeps a wave within bounds, or does not.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Step {
    /// Courant number `c dt/l0`.
    pub(crate) courant: f64,
    /// `delta` of the density diffusion.
    pub(crate) delta: f64,
}

impl Wave {
    fn is_stable(&self, step: Step) -> bool {
        let a = step.courant.powi(2) * self.slope;
        let b = step.delta * step.courant.powi(2) * self.filter;
        a + 2.0 * b < 4.0 && (1.0 - b).abs() <= 1.0
    }
}

/// A neighbour on the lattice.
pub(crate) struct Neighbour<const D: usize> {
    /// Where it is.
    pub(crate) offset: Vector<f64, D>,
    /// `W`.
    pub(crate) weight: f64,
    /// `W/r^2`.
    pub(crate) over_r2: f64,
}

/// All neighbours, and `n0`.
pub(crate) fn neighbours<const D: usize, K: Kernel<f64>>(
    kernel: &K,
    radius: f64,
) -> Result<(Vec<Neighbour<D>>, f64), Failure> {
    let n0 = ReferenceDensity::lattice::<K, D>(kernel, 1.0, radius)?.n0;
    let reach = radius.ceil() as usize;
    let offsets = lattice([-(reach as f64) - 0.5; D], [2 * reach + 1; D], 1.0);
    let near = offsets.into_iter().filter(|r: &Vector<f64, D>| r.norm() > 0.5 && r.norm() < radius);
    let weigh = |offset: Vector<f64, D>| {
        let (weight, over_r2) = kernel.weight_and_over_r2(offset.norm_squared(), radius);
        Neighbour { offset, weight, over_r2 }
    };
    Ok((near.map(weigh).collect(), n0))
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
) -> Result<Vec<Wave>, Failure> {
    let (neighbours, n0) = neighbours::<D, K>(kernel, radius)?;
    let factor = D as f64 / n0;
    let wave = |k: Vector<f64, D>| {
        let mut kappa = Vector::<f64, D>::zeros();
        let mut sum = 0.0;
        for Neighbour { offset: r, over_r2, .. } in &neighbours {
            kappa += r * (factor * over_r2 * k.dot(r).sin());
            sum += 2.0 * factor * over_r2 * (1.0 - k.dot(r).cos());
        }
        let slope = kappa.norm_squared();
        Wave { slope, filter: sum - slope }
    };
    Ok(vectors(side).map(wave).collect())
}

/// The value up to which all waves are stable, between 0 and 100.
pub(crate) fn border(waves: &[Wave], step: impl Fn(f64) -> Step) -> f64 {
    let (mut stable, mut unstable) = (0.0, 100.0);
    for _ in 0..60 {
        let middle = 0.5 * (stable + unstable);
        if waves.iter().all(|wave| wave.is_stable(step(middle))) {
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
