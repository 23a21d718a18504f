//! The longest step, for every Poisson's ratio and thickness, in both precisions.

use crate::scene::{block, moduli, stays};
use mps_kernel::Real;
use mps_solid::materials::CorotationalHooke;

fn has_its_border_at_the_limit<T: Real, const D: usize>(counts: [usize; D], nu: f64, speed: f64) {
    let solid = block::<T, D, _>(counts, &[], CorotationalHooke::from(moduli(nu)), 1.0, 0.8);
    let limit = solid.stability_limit();
    assert!(stays(&solid, limit * T::of(0.98), speed), "below the limit of {counts:?}, nu {nu}");
    assert!(!stays(&solid, limit * T::of(1.02), speed), "above the limit of {counts:?}, nu {nu}");
}

#[test]
fn the_step_may_come_within_two_per_cent_of_the_predicted_limit() {
    for nu in [-0.4, -0.2, 0.0, 0.3, 0.4, 0.47, 0.49, 0.499, 0.4999] {
        for rows in [2, 3, 4] {
            has_its_border_at_the_limit::<f64, 2>([16, rows], nu, 1e-5);
        }
    }
    for nu in [-0.4, 0.3, 0.4999] {
        has_its_border_at_the_limit::<f64, 3>([8, 2, 2], nu, 1e-5);
        has_its_border_at_the_limit::<f32, 2>([16, 4], nu, 1e-3);
    }
}
