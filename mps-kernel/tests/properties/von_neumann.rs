//! Von Neumann analysis of the density filter on the infinite lattice.
//!
//! The filter turns a wave `exp(i k.x)` into `s(k) exp(i k.x)`. With the slope `G(k)` that the gradient
//! sees, `grad exp(i k.x) = i G exp(i k.x)`, and `(n0/D) |G|^2 <= sum_j sin^2(k.r) W/r^2` (Cauchy-Schwarz),
//!
//! ```text
//! s(k) = (2D/n0) [ (n0/D) |G|^2 / 2 - sum_j (1 - cos k.r) W/r^2 ] <= -(D/n0) sum_j (1 - cos k.r)^2 W/r^2,
//! ```
//!
//! below zero for every wave the lattice can carry, and of fourth order in `k` for long ones.

use crate::common::{Cloud, Weight};
use mps_kernel::operators::{DiffusionFilter, Gradient};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, LatticeWaves, Neighborhood, ReferenceDensity, Vector, apply};

/// `s(k)` through the operators of the crate, and the bound above. The spacing is one.
fn symbol<const D: usize>(cloud: &Cloud<f64, D>, k: &Vector<f64, D>) -> (f64, f64) {
    let (i, factor) = (cloud.middle(), cloud.factor());
    // The gradient at the origin of sin(k.x) is G; that of cos(k.x) is -G sin(k.x), everywhere.
    let sine: Vec<f64> = cloud.at.iter().map(|x| k.dot(x).sin()).collect();
    let slope = apply(&Gradient { factor }, cloud, i, &sine);
    let wave: Vec<_> = cloud.at.iter().map(|x| (k.dot(x).cos(), slope * -k.dot(x).sin())).collect();
    let filter = DiffusionFilter { factor: 2.0 * factor };
    let mut bound = 0.0;
    cloud.for_each(i, |pair| bound -= factor * (1.0 - k.dot(&pair.r_ij).cos()).powi(2) * pair.over_r2);
    (apply(&filter, cloud, i, &wave), bound)
}

/// One full neighbourhood, with the particles out of reach left away.
fn star<const D: usize>(weight: Weight, ratio: f64) -> Cloud<f64, D> {
    let mut cloud = Cloud::<f64, D>::lattice(weight, 1.0, ratio, 2 * ratio.ceil() as usize + 1);
    let re = cloud.re;
    cloud.at.retain(|x| x.norm() < re);
    cloud
}

/// Checks every wave of a grid over the Brillouin zone, up to the sign of `k`. Returns the strongest
/// damping, in units of the spacing.
fn scan<const D: usize>(weight: Weight, ratio: f64, steps: usize) -> f64 {
    let cloud = star::<D>(weight, ratio);
    let side = 2 * steps + 1;
    let mut strongest: f64 = 0.0;
    for index in 0..side.pow(D as u32).div_ceil(2) {
        let mut rest = index;
        let k = Vector::<f64, D>::from_fn(|_, _| {
            let step = (rest % side) as f64 - steps as f64;
            rest /= side;
            std::f64::consts::PI * step / steps as f64
        });
        let (found, bound) = symbol(&cloud, &k);
        let case = || format!("{D}D {weight:?} {ratio} l0, k = {:?}", k.as_slice());
        assert!(found <= bound + 1e-13, "{}: {found:e} exceeds {bound:e}", case());
        let wave_number = k.norm();
        if wave_number == 0.0 {
            assert_eq!(found, 0.0);
        } else {
            // Fourth order at the long end and by no means weak at the short end.
            let least = 1e-2 * wave_number.powi(4) / (1.0 + wave_number.powi(4));
            assert!(found < -least, "{}: {found:e} hardly damps", case());
        }
        strongest = strongest.max(-found);
    }
    strongest
}

#[test]
fn every_wave_is_damped_in_the_plane() {
    for weight in Weight::ALL {
        for ratio in [1.5, 1.6, 2.1, 2.6, 3.0, 4.0] {
            let strongest = scan::<2>(weight, ratio, 32);
            // An explicit step is stable while step x strength < 2.
            assert!(strongest < 16.0, "{weight:?} {ratio}: {strongest}");
        }
    }
}

#[test]
fn every_wave_is_damped_in_space() {
    for weight in Weight::ALL {
        for ratio in [1.5, 2.1, 3.0] {
            let strongest = scan::<3>(weight, ratio, 12);
            assert!(strongest < 24.0, "{weight:?} {ratio}: {strongest}");
        }
    }
}

/// The strongest damping of the paper's choice, which bounds an explicit step: at the corner of the
/// Brillouin zone, where signs alternate along every axis. The numbers were computed elsewhere.
#[test]
fn strongest_damping_of_the_rational_weight() {
    let plane = scan::<2>(Weight::Rational, 3.0, 16);
    assert!((plane - 3.915_744_386_22).abs() < 1e-9, "{plane}");
    let space = scan::<3>(Weight::Rational, 3.0, 8);
    assert!((space - 3.847_233_089_86).abs() < 1e-9, "{space}");
}

/// Halving a long wave's number divides its damping by sixteen: no second-order part is left.
#[test]
fn long_waves_are_damped_to_fourth_order() {
    for weight in Weight::ALL {
        let (plane, space) = (star::<2>(weight, 3.0), star::<3>(weight, 3.0));
        for angle in [0.0, 0.3, 0.785] {
            let k = Vector::from([0.04 * f64::cos(angle), 0.04 * f64::sin(angle)]);
            let ratio = symbol(&plane, &k).0 / symbol(&plane, &(k / 2.0)).0;
            assert!((ratio - 16.0).abs() < 0.05, "{weight:?}: {ratio}");
            let k = Vector::from([k[0], k[1] * 0.6, k[1] * 0.8]);
            let ratio = symbol(&space, &k).0 / symbol(&space, &(k / 2.0)).0;
            assert!((ratio - 16.0).abs() < 0.05, "{weight:?}: {ratio}");
        }
    }
}

/// Without the gradients the same sum is a plain Laplacian: second order, and it drains a column.
#[test]
fn without_gradients_long_waves_are_damped_to_second_order() {
    let cloud = star::<2>(Weight::Rational, 3.0);
    let damping = |size: f64| {
        let wave: Vec<_> = cloud.at.iter().map(|x| ((size * x[0]).cos(), Vector::zeros())).collect();
        apply(&DiffusionFilter { factor: 2.0 * cloud.factor() }, &cloud, cloud.middle(), &wave)
    };
    let ratio = damping(0.04) / damping(0.02);
    assert!((ratio - 4.0).abs() < 0.01, "{ratio}");
}

/// The largest symbols on the coarse grid of [`LatticeWaves::grid`] are those of all waves.
fn coarse_grid_is_enough<const D: usize, K: Kernel<f64>>(kernel: &K, weight: Weight, ratio: f64) {
    let reference = ReferenceDensity::lattice::<K, D>(kernel, 0.01, 0.01 * ratio).unwrap();
    let found =
        LatticeWaves::<D>::new(kernel, &reference).grid().fold(0.0_f64, |most, wave| most.max(wave.filter));
    let strongest = scan::<D>(weight, ratio, if D == 2 { 50 } else { 11 });
    assert!((found / strongest - 1.0).abs() < 0.01, "{D}D {weight:?} {ratio}: {found} of {strongest}");
}

#[test]
fn a_coarse_grid_finds_the_strongest_damping() {
    for ratio in [1.5, 2.1, 2.5, 3.0, 4.0, 5.5] {
        coarse_grid_is_enough::<2, _>(&Rational, Weight::Rational, ratio);
        coarse_grid_is_enough::<2, _>(&WendlandGradient, Weight::WendlandGradient, ratio);
    }
    for ratio in [1.5, 3.0] {
        coarse_grid_is_enough::<3, _>(&Rational, Weight::Rational, ratio);
        coarse_grid_is_enough::<3, _>(&WendlandGradient, Weight::WendlandGradient, ratio);
    }
}

/// Long waves have the derivatives of the continuum, in single precision as well.
#[test]
fn long_waves_have_the_symbols_of_derivatives() {
    let reference = ReferenceDensity::lattice::<_, 3>(&Rational, 0.01_f32, 0.03).unwrap();
    let waves = LatticeWaves::<3>::new(&Rational, &reference);
    let k = Vector::from([0.02, -0.01, 0.03]);
    let wave = waves.symbols(&k);
    let k2 = k.norm_squared();
    for symbol in [wave.slope, wave.laplacian] {
        assert!((symbol / k2 - 1.0).abs() < 1e-3, "{symbol} for {k2}");
    }
    assert!(wave.filter < 1e-3 * k2, "{wave:?}");
}
