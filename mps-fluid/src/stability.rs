//! The border of stability of a step on the lattice (von Neumann's analysis).

use crate::Diffusion;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, LatticeWaves, Pair, Real, ReferenceDensity, Tensor, Vector};

/// Square of the slope below which a wave has none: it alternates along its axes \[-\].
const FLAT: f64 = 1e-12;

/// The largest Courant number `c dt/l0` with which no wave of the lattice grows.
///
/// A wave of velocity and density goes through `u' = u (1 - v) - i C kappa n`, `n' = n (1 - b) - i C kappa u'` in a step, with what viscosity,
/// `v = C v'`, and diffusion, `b = C delta sigma = C b'`, take of it. Both eigenvalues stay in the unit circle while `C^2 kappa^2 < (2 - v)(2 - b)`, hence
/// `C < 4/(v' + b' + sqrt((v' - b')^2 + 4 kappa^2))`. The stiffest wave of the diffusion alternates along every axis and has no slope
/// `kappa` at all: viscosity takes nothing of its border.
pub(crate) fn stable_courant_number<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>>(
    diffusion: Diffusion<T>,
    kernel: &K,
    reference: &ReferenceDensity<T>,
    viscosity: &V,
    sound_speed: T,
) -> T {
    let waves = LatticeWaves::<D>::new(kernel, reference);
    let time = (reference.spacing / sound_speed).to_double();
    let drags: Vec<_> = waves
        .neighbors()
        .iter()
        .map(|near| {
            let offset = near.offset.map(|x| T::of(x) * reference.spacing);
            (near.offset, drag(viscosity, &Pair::new(0, offset, kernel, reference.radius)) * time)
        })
        .collect();
    let stiffness = LatticeWaves::<D>::wave_vectors().fold(0.0_f64, |most, k| {
        let wave = waves.symbols(&k);
        let diffused = match diffusion {
            Diffusion::None => 0.0,
            Diffusion::Filter { delta } => delta.to_double() * wave.filter,
            Diffusion::Hydrostatic => wave.laplacian,
        };
        let mut slope = Vector::<f64, D>::zeros();
        let mut taken = Tensor::<f64, D>::zeros();
        for (near, (offset, drag)) in waves.neighbors().iter().zip(&drags) {
            let (sine, cosine) = k.dot(offset).sin_cos();
            slope += offset * (near.over_r2 * sine);
            taken += drag * (1.0 - cosine);
        }
        let viscous = along(&taken, &slope, wave.slope);
        most.max(viscous + diffused + ((viscous - diffused).powi(2) + 4.0 * wave.slope).sqrt())
    });
    T::of(4.0 / stiffness)
}

/// What a pair takes of a difference of velocities \[1/s\]: one column for each axis of the difference.
fn drag<T: Real, const D: usize, V: Viscosity<T, D>>(viscosity: &V, pair: &Pair<T, D>) -> Tensor<f64, D> {
    let mut drag = Tensor::<f64, D>::zeros();
    for axis in 0..D {
        let mut difference = Vector::<T, D>::zeros();
        difference[axis] = T::one();
        drag.set_column(axis, &viscosity.pair(pair, &Vector::zeros(), &difference).map(T::to_double));
    }
    drag
}

/// What viscosity takes of a velocity along the slope of the pressure, of which sound consists; of any velocity where the pressure has none, at most.
fn along<const D: usize>(taken: &Tensor<f64, D>, slope: &Vector<f64, D>, size: f64) -> f64 {
    if size > FLAT {
        return slope.dot(&(taken * slope)) / slope.norm_squared();
    }
    (0..D).map(|row| taken.row(row).abs().sum()).fold(0.0, f64::max)
}
