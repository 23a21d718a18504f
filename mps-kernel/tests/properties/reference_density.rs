//! `n0` and `lambda0` against sums computed elsewhere in 40 decimal digits, and what is refused.

use crate::common::{Cloud, Scene, Weight, close, epsilon, scene};
use mps_kernel::operators::NumberDensity;
use mps_kernel::{Kernel, Number, Real, ReferenceDensity, ReferenceDensityError, apply};
use proptest::prelude::*;

/// Dimension, radius over spacing, weight, neighbours, `n0`, `lambda0 / l0^2`.
#[rustfmt::skip]
#[allow(clippy::excessive_precision, reason = "columns of equal width")]
const TABLE: [(usize, f64, Weight, usize, f64, f64); 20] = [
    (2, 1.6, Weight::Rational,     8,   2.925_483_399_593_904,  1.179_622_758_982_959),
    (2, 1.6, Weight::WendlandC2,   8,   0.280_153_573_980_123,  1.011_772_490_292_617),
    (2, 2.1, Weight::Rational,    12,   6.539_696_961_966_999,  1.388_350_863_463_116),
    (2, 2.1, Weight::Gaussian,    12,   0.588_349_691_770_904,  1.120_572_345_756_070),
    (2, 3.0, Weight::Rational,    24,  17.461_048_353_356_846,  2.323_876_486_924_995),
    (2, 3.0, Weight::WendlandC2,  24,   3.059_961_448_911_959,  1.647_550_827_012_821),
    (2, 3.0, Weight::Spiky,       24,   2.056_963_965_196_600,  1.762_703_282_701_648),
    (2, 3.0, Weight::Gaussian,    24,   2.141_366_879_691_451,  1.460_517_096_120_100),
    (2, 4.0, Weight::Rational,    44,  35.609_222_789_951_608,  3.707_100_067_665_280),
    (2, 4.0, Weight::WendlandC2,  44,   6.189_441_770_317_743,  2.576_840_815_293_776),
    (3, 1.6, Weight::Rational,    18,   5.176_450_198_781_712,  1.304_542_715_228_427),
    (3, 1.6, Weight::Spiky,       18,   0.335_193_504_575_508,  1.056_048_981_615_261),
    (3, 2.1, Weight::Rational,    32,  14.418_575_408_286_710,  1.701_737_837_765_673),
    (3, 2.1, Weight::WendlandC2,  32,   1.848_739_168_023_464,  1.307_986_086_063_112),
    (3, 3.0, Weight::Rational,    92,  48.633_428_434_019_693,  3.036_274_528_304_237),
    (3, 3.0, Weight::WendlandC2,  92,   7.103_755_973_386_193,  2.041_663_634_035_195),
    (3, 3.0, Weight::Spiky,       92,   4.923_185_595_559_889,  2.216_566_541_736_486),
    (3, 3.0, Weight::Gaussian,    92,   4.564_716_757_896_197,  1.815_553_346_248_395),
    (3, 4.0, Weight::Rational,   250, 123.991_564_702_138_499,  5.211_991_228_301_513),
    (3, 4.0, Weight::Gaussian,   250,  12.192_020_651_669_781,  2.876_720_206_040_530),
];

fn lattice<T: Real>(
    dimension: usize,
    weight: Weight,
    spacing: f64,
    radius: f64,
) -> Result<ReferenceDensity<T>, ReferenceDensityError> {
    let (spacing, radius) = (T::of(spacing), T::of(radius));
    match dimension {
        2 => ReferenceDensity::lattice::<_, 2>(&weight, spacing, radius),
        _ => ReferenceDensity::lattice::<_, 3>(&weight, spacing, radius),
    }
}

fn matches_table<T: Real>(spacing: f64) -> Result<(), TestCaseError> {
    for (dimension, ratio, weight, neighbors, n0, lambda0) in TABLE {
        // As a caller writes it: the product may be rounded past a lattice distance or short of it.
        let found = lattice::<T>(dimension, weight, spacing, ratio * spacing)?;
        prop_assert_eq!(found.neighbors, neighbors, "{}D, {:?}, {} l0", dimension, weight, ratio);
        // A hundred roundings, each moved by q dW/dq <= 40 W for these weights.
        let tolerance = 300.0 * epsilon::<T>();
        close("n0", found.n0.to_double(), n0, tolerance * n0)?;
        let found_lambda0 = found.lambda0.to_double() / (spacing * spacing);
        close("lambda0", found_lambda0, lambda0, tolerance * lambda0)?;
        let d = dimension as f64;
        let factor = if dimension == 2 {
            (found.gradient_factor::<2>(), found.laplacian_factor::<2>())
        } else {
            (found.gradient_factor::<3>(), found.laplacian_factor::<3>())
        };
        close("D / n0", factor.0.to_double(), d / n0, tolerance * d / n0)?;
        let laplacian = 2.0 * d / (n0 * lambda0 * spacing * spacing);
        close("2 D / (n0 lambda0)", factor.1.to_double(), laplacian, 2.0 * tolerance * laplacian)?;
    }
    Ok(())
}

/// `n0` is what an interior particle of the lattice finds (eq. 13), a corner particle finds less.
fn is_the_density_of_the_interior<T: Real, const D: usize>(scene: &Scene) -> Result<(), TestCaseError> {
    // On the rim of the cut Gaussian rounding decides who counts.
    let on_rim = scene.weight == Weight::Gaussian && scene.ratio == 3.0;
    let ratio = if on_rim { 3.1 } else { scene.ratio };
    let cloud = Cloud::<T, D>::lattice(scene.weight, scene.spacing, ratio, 9);
    let n0 = cloud.reference().n0.to_double();
    let density = |i| apply(&NumberDensity, &cloud, i, &cloud.at).to_double();
    close("density inside", density(cloud.middle()), n0, 300.0 * epsilon::<T>() * n0)?;
    prop_assert!(density(0) < 0.6 * n0);
    Ok(())
}

proptest! {
    #[test]
    fn density_of_a_full_neighbourhood_is_n0(scene in scene()) {
        is_the_density_of_the_interior::<f64, 2>(&scene)?;
        is_the_density_of_the_interior::<f64, 3>(&scene)?;
        is_the_density_of_the_interior::<f32, 2>(&scene)?;
        is_the_density_of_the_interior::<f32, 3>(&scene)?;
    }

    #[test]
    fn sums_match_the_table_at_every_spacing(exponent in -6.0..4.0f64, thousandths in 1..2000_u32) {
        for spacing in [f64::powf(10.0, exponent), f64::from(thousandths) * 1e-3] {
            matches_table::<f64>(spacing)?;
            matches_table::<f32>(spacing)?;
        }
    }

    #[test]
    fn bad_spacing_is_refused(size in 0.0..1e300f64, radius in 0.0..1e300f64) {
        for spacing in [-size, 0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let refused = lattice::<f64>(2, Weight::Rational, spacing, radius);
            prop_assert!(matches!(refused, Err(ReferenceDensityError::Spacing(_))), "{refused:?}");
        }
    }

    #[test]
    fn bad_radius_is_refused(spacing in 1e-6..1e3f64, ratio in prop_oneof![-10.0..1.199f64, 15.01..1e9f64]) {
        for radius in [ratio * spacing, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0] {
            let refused = lattice::<f64>(3, Weight::Spiky, spacing, radius);
            prop_assert!(matches!(refused, Err(ReferenceDensityError::Radius { .. })), "{refused:?}");
        }
    }
}

/// On a fine lattice the sums become integrals: `n0 -> int W dV / l0^D` and
/// `n0 lambda0 -> int r^2 W dV / l0^D`, up to the term of the particle itself.
#[test]
fn sums_tend_to_the_integrals() {
    let pi = std::f64::consts::PI;
    let ratio = 14.9_f64;
    // What the missing particle itself amounts to: W(0), or for 1/r the constant by which the sum over
    // the square or the cubic lattice falls short of the integral (the Madelung-type constants).
    let (plane, space) = (3.900_264_9 * ratio - 1.0, 2.837_297_5 * ratio - 1.0);
    // Integrals of W / re^D and of r^2 W / re^(D + 2), by hand.
    #[rustfmt::skip]
    let cases = [
        (2, Weight::Rational,   plane, pi,              pi / 6.0),
        (2, Weight::WendlandC2, 1.0,   pi / 7.0,        5.0 * pi / 252.0),
        (2, Weight::Spiky,      1.0,   pi / 10.0,       pi / 70.0),
        (3, Weight::Rational,   space, 2.0 * pi / 3.0,  pi / 5.0),
        (3, Weight::WendlandC2, 1.0,   2.0 * pi / 21.0, 2.0 * pi / 105.0),
        (3, Weight::Spiky,      1.0,   pi / 15.0,       pi / 70.0),
    ];
    for (dimension, weight, own, zeroth, second) in cases {
        let found = lattice::<f64>(dimension, weight, 1.0, ratio).unwrap();
        let sum = (found.n0 + own) / ratio.powi(dimension as i32);
        assert!((sum / zeroth - 1.0).abs() < 1e-3, "{dimension}D {weight:?}: {sum}, {zeroth}");
        let moment = found.n0 * found.lambda0 / ratio.powi(dimension as i32 + 2);
        assert!((moment / second - 1.0).abs() < 1e-3, "{dimension}D {weight:?}: {moment}, {second}");
    }
}

/// A spacing whose square leaves the range of the scalar must not end in NaN.
#[test]
fn sums_out_of_range_are_refused() {
    let tiny = lattice::<f64>(2, Weight::Rational, 1e-200, 3e-200);
    assert!(matches!(tiny, Err(ReferenceDensityError::Sum { .. })), "{tiny:?}");
    let tiny = lattice::<f32>(3, Weight::WendlandC2, 1e-25, 3e-25);
    assert!(matches!(tiny, Err(ReferenceDensityError::Sum { .. })), "{tiny:?}");
    // Here only the second moment overflows.
    let large = lattice::<f64>(2, Weight::Rational, 3e153, 9e153);
    assert!(matches!(large, Err(ReferenceDensityError::Sum { .. })), "{large:?}");
    let huge = lattice::<f32>(2, Weight::Rational, 1e25, 3e25);
    assert!(matches!(huge, Err(ReferenceDensityError::Sum { .. })), "{huge:?}");
}

/// A weight written elsewhere that is nowhere positive.
#[derive(Clone, Copy)]
struct Nothing;

impl Kernel<f64> for Nothing {
    fn weight<N: Number<f64>>(&self, r: N, _re: f64) -> N {
        r * 0.0
    }

    fn name(&self) -> &'static str {
        "nothing"
    }
}

#[test]
fn a_weight_without_weight_is_refused() {
    let refused = ReferenceDensity::lattice::<_, 2>(&Nothing, 0.1, 0.3);
    assert_eq!(refused, Err(ReferenceDensityError::Sum { sum: 0.0, spacing: 0.1 }));
}

/// The messages name the value, the unit and what to do.
#[test]
fn refusals_say_what_to_do() {
    let spacing = lattice::<f64>(2, Weight::Rational, -0.5, 1.0).unwrap_err().to_string();
    assert!(spacing.contains("-0.5 m") && spacing.contains("positive"), "{spacing}");
    let radius = lattice::<f64>(2, Weight::Rational, 0.5, 0.25).unwrap_err().to_string();
    assert!(radius.contains("0.25 m") && radius.contains("0.5 m") && radius.contains("2.1 to 4"), "{radius}");
}
