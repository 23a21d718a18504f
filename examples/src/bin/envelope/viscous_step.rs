//! How long a step may be with viscosity: noise in the same box, with sound so slow that it does not matter.
//!
//! A wave of the velocity is multiplied by `1 - nu dt L(k)` in a step, with the symbol of the Laplacian `L`; it is stable while `nu dt L < 2`.

use crate::border::{Border, Breaks};
use crate::fluid_step::{growth, undamped};
use crate::waves::{lattice_of, vectors};
use mps_examples::Failure;
use mps_fluid::{ArtificialViscosity, CompactViscosity, LaminarViscosity};
use mps_kernel::weights::{Rational, WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, LatticeNeighbor, Tensor, Vector};

/// Spacings that sound goes in a step.
const SOUND: f64 = 1e-3;
const SIDE: usize = 16;

/// `2/L` of the steepest wave, for a Laplacian `(4/n0) sum (u_j - u_i) w` with the `w` of a neighbour and of `lambda0`.
fn laplacian<K: Kernel<f64>>(
    kernel: &K,
    radius: f64,
    weight: fn(&LatticeNeighbor<2>, f64) -> f64,
) -> Result<f64, Failure> {
    let lattice = lattice_of::<2, K>(kernel, radius)?;
    let (n0, lambda0) = (lattice.n0(), lattice.lambda0());
    let symbol = |k: Vector<f64, 2>| {
        let part =
            |near: &LatticeNeighbor<2>| 4.0 / n0 * weight(near, lambda0) * (1.0 - k.dot(&near.offset).cos());
        lattice.neighbors().iter().map(part).sum::<f64>()
    };
    Ok(2.0 / vectors(SIDE).map(symbol).fold(0.0, f64::max))
}

/// The same for viscosity along the line of the pair: its symbol is a tensor, and `nu` is an eighth of its strength.
fn along_pairs<K: Kernel<f64>>(kernel: &K, radius: f64) -> Result<f64, Failure> {
    let lattice = lattice_of::<2, K>(kernel, radius)?;
    let n0 = lattice.n0();
    let symbol = |k: Vector<f64, 2>| {
        let sum = lattice.neighbors().iter().fold(Tensor::<f64, 2>::zeros(), |sum, near| {
            let r = &near.offset;
            sum + r * r.transpose() * (2.0 / n0 * near.over_r2 / r.norm_squared() * (1.0 - k.dot(r).cos()))
        });
        sum.symmetric_eigenvalues().max()
    };
    Ok(2.0 / (8.0 * vectors(SIDE).map(symbol).fold(0.0, f64::max)))
}

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "viscous-laminar",
        parameter: "nu dt/l0^2",
        measure: "noise over that at the start",
        bound: 1e3,
        scene: |x| growth(undamped::<2>(SOUND, 3.0), Rational, |r| LaminarViscosity::new::<2>(x, r), 1.0),
        predicted: Some(|| laplacian(&Rational, 3.0, |near, lambda0| near.weight / lambda0)),
        whole: false,
        breaks: Breaks::BlowUp,
        mechanism: "explicit viscosity takes more than twice the difference between neighbours in a step",
        remedy: "none needed: the fluid keeps nu dt/l0^2 below cfl/8 by itself; the scene does not ask it",
    };
    vec![
        base,
        Border {
            name: "viscous-compact",
            scene: |x| {
                growth(undamped::<2>(SOUND, 3.0), WendlandGradient, |r| CompactViscosity::new::<2>(x, r), 1.0)
            },
            predicted: Some(|| laplacian(&WendlandGradient, 3.0, |near, _| near.over_r2)),
            ..base
        },
        Border {
            name: "viscous-wendland",
            scene: |x| {
                growth(undamped::<2>(SOUND, 3.0), WendlandC2, |r| LaminarViscosity::new::<2>(x, r), 1.0)
            },
            predicted: Some(|| laplacian(&WendlandC2, 3.0, |near, lambda0| near.weight / lambda0)),
            ..base
        },
        Border {
            name: "viscous-artificial",
            scene: |x| {
                // nu = alpha c l0/8
                let alpha = 8.0 * x / SOUND;
                growth(
                    undamped::<2>(SOUND, 4.0),
                    WendlandGradient,
                    |r| ArtificialViscosity::new::<2>(alpha, SOUND, r),
                    1.0,
                )
            },
            predicted: Some(|| along_pairs(&WendlandGradient, 4.0)),
            ..base
        },
    ]
}
