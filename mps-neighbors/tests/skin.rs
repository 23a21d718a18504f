//! While the skin has not expired, no pair within the radius is missing.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Shape, brute_between, brute_within, cloud, plain, seeds};
use mps_kernel::{Real, Vector};
use mps_neighbors::{Cells, Domain, Open, Parallel, PeriodicBox, Rows, Skin};
use proptest::prelude::*;

/// Moves every point by up to `most` in a random direction, most of them by nearly `most`.
fn moved<T: Real, const D: usize>(points: &[Vector<T, D>], most: f64, seed: u64) -> Vec<Vector<T, D>> {
    let mut random = common::Random(seed);
    points
        .iter()
        .map(|p| {
            let direction = Vector::<f64, D>::from_fn(|_, _| random.next() - 0.5).normalize();
            let length = most * random.next().sqrt().sqrt();
            p + direction.map(|x| T::of(x * length))
        })
        .collect()
}

fn contains_all(rows: &Rows, expected: &[Vec<u32>]) {
    for (i, row) in plain(rows).iter().enumerate() {
        for j in &expected[i] {
            assert!(row.contains(j), "pair {i}, {j} is missing");
        }
    }
}

fn check<T: Real, const D: usize>(
    domain: impl Domain<T, D>,
    a: &[[f64; 3]],
    b: &[[f64; 3]],
    skin: f64,
    seed: u64,
) {
    let parallel = Parallel::serial();
    let (fluid, wall) = (cloud::<T, D>(a, Shape::Uniform, 0.0), cloud::<T, D>(b, Shape::Uniform, 0.0));
    let (radius, reach) = (T::one(), T::of(1.0 + skin));
    let (mut cells, mut within, mut between) = (Cells::new(), Rows::default(), Rows::default());
    cells.build(&parallel, &domain, &fluid, reach).unwrap();
    within.build_within(&parallel, &domain, &cells, &fluid, reach).unwrap();
    between.build_between(&parallel, &domain, &cells, &wall, &fluid, reach).unwrap();
    let mut rule = Skin::new(T::of(skin));
    rule.renew(&[&fluid, &wall]);
    // A little less than half a skin: nothing expires. Both sets move, towards each other as well.
    let (fluid, wall) = (moved(&fluid, 0.4995 * skin, seed), moved(&wall, 0.4995 * skin, seed + 1));
    let wrap = |points: &[Vector<T, D>]| points.iter().map(|&p| domain.wrap(p)).collect::<Vec<_>>();
    let (fluid, wall) = (wrap(&fluid), wrap(&wall));
    assert!(!rule.expired(&parallel, &domain, &[&fluid, &wall]));
    contains_all(&within, &brute_within(domain, &fluid, radius));
    contains_all(&between, &brute_between(domain, &wall, &fluid, radius));
}

proptest! {
    #[test]
    fn no_pair_is_missed(a in seeds(), b in seeds(), skin in 0.05..0.6, seed: u64) {
        check::<f64, 2>(Open, &a, &b, skin, seed >> 1);
        check::<f64, 3>(Open, &a, &b, skin, seed >> 1);
        let around = PeriodicBox::new(Vector::<f32, 2>::zeros(), [Some(8.0), None]).unwrap();
        check::<f32, 2>(around, &a, &b, skin, seed >> 1);
    }
}

#[test]
fn expires_when_it_should() {
    let parallel = Parallel::new(2).unwrap();
    let points = common::jittered::<2>(40, 2);
    let mut skin = Skin::new(0.2);
    let expired = |skin: &Skin<f64, 2>, points: &[Vector<f64, 2>]| skin.expired(&parallel, &Open, &[points]);
    assert!(expired(&skin, &points), "nothing was built yet");
    assert!(expired(&skin, &[]), "not even rows without particles");
    skin.renew(&[&points]);
    assert!(!expired(&skin, &points));
    assert!(expired(&skin, &points[1..]), "fewer particles");
    assert!(skin.expired(&parallel, &Open, &[&points, &points]), "more sets");
    for particle in [0, 399, 400, 1599] {
        let mut one = points.clone();
        one[particle][1] += 0.0999;
        assert!(!expired(&skin, &one));
        one[particle][1] += 0.0002;
        assert!(expired(&skin, &one), "particle {particle} has moved");
        one[particle][1] = f64::NAN;
        assert!(expired(&skin, &one), "particle {particle} is nowhere");
    }
    skin.expire();
    assert!(expired(&skin, &points));
}

/// A particle that leaves on one side and enters on the other has not crossed the box.
#[test]
fn wrapping_is_no_movement() {
    let domain = PeriodicBox::new(Vector::<f64, 2>::zeros(), [Some(4.0), None]).unwrap();
    let mut skin = Skin::new(0.2);
    skin.renew(&[&[Vector::<f64, 2>::new(3.98, 0.0)]]);
    let after = domain.wrap(Vector::<f64, 2>::new(4.05, 0.0));
    assert!(after[0] < 0.1);
    assert!(!skin.expired(&Parallel::serial(), &domain, &[&[after]]));
    assert!(skin.expired(&Parallel::serial(), &Open, &[&[after]]));
}
