//! How far the moment matrix of a strained lattice is from the identity: how far the plain sums are from
//! a fluid's.
//!
//! The plain pressure gradient (eq. 24) of a particle acts through its moment matrix. On the upright lattice it is the
//! identity; if isochoric strain changes it, a pressure `p` exerts shear stress `p (M - I)`, at any resolution, and the
//! fluid is a soft solid. The sum over a lattice is a quadrature of an isotropic integral, so this is
//! a matter of how smooth the summand is.

use crate::common::{Cloud, Weight};
use mps_kernel::operators::MomentMatrix;
use mps_kernel::{Vector, apply};

/// Shear stress over pressure and strain of a square lattice stretched by `1 + strain` along an axis and
/// pressed together along the other: `(M_yy - M_xx)/(4 strain)`.
fn stiffness(weight: Weight, ratio: f64, strain: f64) -> f64 {
    let upright = Cloud::<f64, 2>::lattice(weight, 1.0, ratio, 21);
    let middle = upright.middle();
    let moment = |at: Vec<Vector<f64, 2>>| {
        let cloud = Cloud::new(at, weight, 1.0, ratio);
        apply(&MomentMatrix { factor: 1.0 }, &cloud, middle, &vec![(); cloud.at.len()])
    };
    let stretch = Vector::from([1.0 + strain, 1.0 / (1.0 + strain)]);
    let strained = moment(upright.at.iter().map(|r| r.component_mul(&stretch)).collect());
    let scale = moment(upright.at)[(0, 0)];
    (strained[(1, 1)] - strained[(0, 0)]) / (4.0 * strain * scale)
}

#[test]
fn sums_of_a_smooth_gradient_resist_shear_ten_times_less() {
    for (ratio, smooth) in [(3.0, 0.03), (3.5, 0.015), (4.0, 0.012)] {
        let found = stiffness(Weight::WendlandGradient, ratio, 0.05);
        assert!(found.abs() < smooth, "re = {ratio} l0: {found}");
        for peaked in [Weight::Rational, Weight::WendlandC2, Weight::Spiky] {
            let found = stiffness(peaked, ratio, 0.05);
            assert!(found > 10.0 * smooth, "{peaked:?}, re = {ratio} l0: {found}");
        }
    }
}

#[test]
fn a_column_twice_as_long_and_half_as_wide_is_still_a_fluid() {
    // Over a strain of ln 2 the mean stiffness.
    assert!(stiffness(Weight::WendlandGradient, 4.0, 1.0).abs() < 0.02);
    assert!(stiffness(Weight::Rational, 4.0, 1.0) > 0.25);
}
