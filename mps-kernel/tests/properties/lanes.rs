//! Lanes compute what scalars compute, lane by lane and to the last bit, with any instructions.

use crate::common::{Noise, Weight, scene};
use fearless_simd::{Level, Simd, dispatch};
use mps_kernel::operators::{ConservativeGradient, DiffusionFilter, Divergence, Gradient, Laplacian};
use mps_kernel::small::components;
use mps_kernel::{Lanes, Number, Pair, Real, Vector, by_axis};
use proptest::prelude::*;

/// Everything the fluid computes of one pair.
fn formulas<T: Real, N: Number<T>, J>(
    own: &(T, Vector<T, 2>),
    other: &(N, Vector<N, 2>),
    pair: &Pair<N, 2, J>,
) -> [N; 9] {
    let ((f, u), (g, v)) = (own, other);
    let gradient = Gradient::pair(*f, *g, pair);
    let laplacian = Laplacian::pair(u, v, pair);
    [
        pair.weight,
        pair.over_r2,
        components(&gradient)[0],
        components(&gradient)[1],
        components(&laplacian)[0],
        components(&laplacian)[1],
        Divergence::pair(u, v, pair),
        DiffusionFilter::pair(*f, u, *g, v, pair),
        ConservativeGradient::pair_pressure(*f, T::of(1.01), *g, *g + T::of(3.0)),
    ]
}

/// The same for as many neighbours as there are lanes, and each of them alone.
#[inline(always)]
fn compare<T: Real, S: Simd>(simd: S, weight: Weight, re: T, seed: u64) -> Result<(), TestCaseError> {
    let count = T::Lanes::<S>::COUNT;
    let mut noise = Noise(seed);
    let mut next = || noise.between::<T>(-1.0, 1.0);
    let own = (next(), Vector::from([next(), next()]));
    let numbers: Vec<[T; 5]> = (0..count).map(|_| core::array::from_fn(|_| next())).collect();
    let lane = |component: usize| T::Lanes::<S>::gather(simd, |k| numbers[k][component]);
    let lanes = formulas(
        &own,
        &(lane(0), by_axis!(axis => lane(1 + axis))),
        &Pair::new((), by_axis!(axis => lane(3 + axis) * re), &weight, re),
    );
    for (k, &[g, vx, vy, x, y]) in numbers.iter().enumerate() {
        let pair = Pair::new(k, Vector::from([x * re, y * re]), &weight, re);
        let alone = formulas(&own, &(g, Vector::from([vx, vy])), &pair);
        for (formula, (lanes, alone)) in lanes.iter().zip(alone).enumerate() {
            let mask = T::Lanes::<S>::gather(simd, |l| if l == k { T::one() } else { T::zero() });
            // The sum picks one lane; the others are finite.
            prop_assert_eq!((*lanes * mask).sum(), alone, "formula {}, lane {}", formula, k);
        }
    }
    Ok(())
}

fn sums<T: Real, S: Simd>(simd: S) {
    let count = T::Lanes::<S>::COUNT;
    let lanes = T::Lanes::<S>::gather(simd, |k| T::of((k + 1) as f64));
    assert_eq!(lanes.sum(), T::of((count * (count + 1) / 2) as f64));
    for used in 0..=count + 1 {
        assert_eq!(T::Lanes::<S>::first(simd, used).sum(), T::of(used.min(count) as f64));
    }
    let cut = lanes.where_below(lanes, T::of(2.5)).at_least(T::of(1.5));
    let expected = 1.5 + 2.0 + 1.5 * (count - 2) as f64;
    assert_eq!(cut.sum(), T::of(expected));
    assert_eq!(lanes.at_most(T::of(1.5)).sum(), T::of(1.0 + 1.5 * (count - 1) as f64));
    assert_eq!((lanes * T::of(0.5)).nearest().sum(), T::of((0..count).map(|k| nearest(k + 1)).sum()));
}

/// Half of `k`, rounded to the even neighbour where it lies in the middle.
fn nearest(k: usize) -> f64 {
    (k as f64 / 2.0).round_ties_even()
}

proptest! {
    #[test]
    fn lanes_compute_what_scalars_compute(scene in scene(), seed: u64) {
        for level in [Level::new(), Level::baseline()] {
            dispatch!(level, simd => compare::<f64, _>(simd, scene.weight, scene.spacing, seed))?;
            dispatch!(level, simd => compare::<f32, _>(simd, scene.weight, scene.spacing as f32, seed))?;
        }
    }
}

#[test]
fn lanes_are_summed_masked_cut_and_rounded() {
    for level in [Level::new(), Level::baseline()] {
        dispatch!(level, simd => sums::<f64, _>(simd));
        dispatch!(level, simd => sums::<f32, _>(simd));
    }
}
