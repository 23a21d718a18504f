//! Support, sign, monotony and the two forms of every weight.

use crate::common::{Noise, Weight, close, epsilon};
use mps_kernel::weights::closest;
use mps_kernel::{Kernel, Pair, Real, Vector};
use proptest::prelude::*;

fn radius() -> impl Strategy<Value = f64> {
    (-4.0..3.0).prop_map(|exponent| f64::powf(10.0, exponent))
}

/// The formulas of the table in `weights`, written once more.
fn formula(weight: Weight, q: f64) -> f64 {
    match weight {
        Weight::Rational => 1.0 / q - 1.0,
        Weight::WendlandC2 => (1.0 - q).powi(4) * (4.0 * q + 1.0),
        Weight::WendlandGradient => q * q * (1.0 - q).powi(3),
        Weight::Spiky => (1.0 - q).powi(3),
        Weight::Gaussian => (-9.0 * q * q).exp(),
    }
}

fn zero_outside<T: Real>(weight: Weight, re: f64, stretch: f64) -> Result<(), TestCaseError> {
    let re = T::of(re);
    let none = (T::zero(), T::zero());
    // The border is where a neighbour list draws it: r2 >= re * re as rounded.
    prop_assert_eq!(weight.weight(re, re), T::zero());
    prop_assert_eq!(weight.weight_and_over_r2(re * re, re), none);
    let outside = (re * T::of(1.0 + stretch)).max(re);
    prop_assert_eq!(weight.weight(outside, re), T::zero());
    prop_assert_eq!(weight.weight_and_over_r2(outside * outside, re), none);
    Ok(())
}

fn follows_formula<T: Real>(weight: Weight, re: f64, q: f64) -> Result<(), TestCaseError> {
    let re = T::of(re);
    let r = re * T::of(q);
    let q = r.to_double() / re.to_double();
    let expected = formula(weight, q);
    // The rational weight subtracts one from re/r, the others raise rounded numbers to powers.
    let tolerance = 32.0 * epsilon::<T>() * (1.0 + expected);
    let plain = weight.weight(r, re);
    close("weight", plain.to_double(), expected, tolerance)?;
    prop_assert!(plain > T::zero());

    let (squared, over_r2) = weight.weight_and_over_r2(r * r, re);
    close("weight from the square", squared.to_double(), plain.to_double(), tolerance)?;
    prop_assert!(squared >= T::zero());
    let ratio = squared.to_double() / (r * r).to_double();
    close("weight over r2", over_r2.to_double(), ratio, 2.0 * epsilon::<T>() * ratio)
}

fn decreases<T: Real>(weight: Weight, re: f64, a: f64, b: f64) -> Result<(), TestCaseError> {
    let re = T::of(re);
    let (near, far) = (re * T::of(a.min(b)), re * T::of(a.max(b)));
    let slack = T::default_epsilon() * T::of(4.0);
    let of_square = |r: T| weight.weight_and_over_r2(r * r, re);
    prop_assert!(of_square(far).1 <= of_square(near).1 * (T::one() + slack));
    // Strictly, where two distances differ by more than rounding.
    let (short, long) = (re * T::of(0.98 * a), re * T::of(0.98 * a + 0.02));
    prop_assert!(of_square(long).1 < of_square(short).1);
    // The one that is zero where the particle itself is has its largest value at 0.4.
    if weight != Weight::WendlandGradient {
        prop_assert!(of_square(far).0 <= of_square(near).0 * (T::one() + slack));
        prop_assert!(weight.weight(long, re) < weight.weight(short, re));
    }
    Ok(())
}

fn bounded_when_close<T: Real, const D: usize>(
    weight: Weight,
    re: f64,
    part: f64,
    seed: u64,
) -> Result<(), TestCaseError> {
    let re = T::of(re);
    let direction = Noise(seed).direction::<T, D>();
    prop_assert!((closest(re).to_double() / re.to_double() * 30.0 - 1.0).abs() < 4.0 * epsilon::<T>());
    let at_limit = weight.weight_and_over_r2(closest(re) * closest(re), re);
    for r_ij in [Vector::<T, D>::zeros(), direction * (closest(re) * T::of(part))] {
        let pair = Pair::new(7, r_ij, &weight, re);
        prop_assert_eq!((pair.weight, pair.over_r2), at_limit);
        prop_assert!(pair.weight > T::zero() && pair.weight.is_finite());
        prop_assert!(pair.over_r2.is_finite() && pair.distance() > T::zero());
        // The pull of a pair never exceeds what it is at the limit, and fades with the distance.
        let limit = (at_limit.1 * closest(re)).to_double();
        let pull = pair.gradient_vector().norm().to_double();
        prop_assert!(pull <= limit * (1.0 + 8.0 * epsilon::<T>()));
        if r_ij == Vector::<T, D>::zeros() {
            prop_assert_eq!(pull, 0.0);
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn weights_vanish_at_and_beyond_the_radius(re in radius(), exponent in -17.0..3.0f64) {
        for weight in Weight::ALL {
            zero_outside::<f64>(weight, re, f64::powf(10.0, exponent))?;
            zero_outside::<f32>(weight, re, f64::powf(10.0, exponent))?;
        }
    }

    #[test]
    fn both_forms_follow_the_formula(re in radius(), q in 0.033..0.999f64) {
        for weight in Weight::ALL {
            follows_formula::<f64>(weight, re, q)?;
            follows_formula::<f32>(weight, re, q)?;
        }
    }

    #[test]
    fn weights_decrease(re in radius(), a in 0.033..1.0f64, b in 0.033..1.2f64) {
        for weight in Weight::ALL {
            decreases::<f64>(weight, re, a, b)?;
            decreases::<f32>(weight, re, a, b)?;
        }
    }

    #[test]
    fn particles_that_meet_pull_with_a_bounded_weight(re in radius(), part in 0.0..0.99f64, seed: u64) {
        for weight in Weight::ALL {
            bounded_when_close::<f64, 2>(weight, re, part, seed)?;
            bounded_when_close::<f64, 3>(weight, re, part, seed)?;
            bounded_when_close::<f32, 2>(weight, re, part, seed)?;
            bounded_when_close::<f32, 3>(weight, re, part, seed)?;
        }
    }
}

#[test]
fn names_tell_the_weights_apart() {
    let names: std::collections::BTreeSet<_> = Weight::ALL.iter().map(Kernel::<f64>::name).collect();
    assert_eq!(names.len(), Weight::ALL.len());
}
