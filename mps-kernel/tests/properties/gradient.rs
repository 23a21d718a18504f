//! The corrected gradient (eqs. 21, 22) is exact for linear fields on any neighbourhood that spans
//! the space: in the interior, at faces, edges and corners, with every weight.

use crate::common::{Cloud, Noise, Scene, epsilon, scene};
use mps_kernel::operators::{Corrected, Gradient};
use mps_kernel::{Real, Vector, apply};
use proptest::prelude::*;

/// Checks every particle whose neighbourhood is not degenerate; returns how many those are.
///
/// The guard bounds the condition number by 40, and a difference of two field values is rounded to
/// the size of the field; over the distance to the nearest neighbour that counts, a tenth of a
/// spacing, this makes 40 x 10 rounding units of the field per spacing.
fn exact_for_linear<T: Real, const D: usize>(cloud: &Cloud<T, D>, seed: u64) -> Result<usize, TestCaseError> {
    let mut noise = Noise(seed ^ 0xA5);
    let (slope, offset) = (noise.direction::<T, D>(), noise.between::<T>(-3.0, 3.0) * cloud.spacing);
    let field: Vec<T> = cloud.at.iter().map(|x| slope.dot(x) + offset).collect();
    let size = field.iter().fold(0.0, |size: f64, f| size.max(f.to_double().abs()));
    let tolerance = 400.0 * epsilon::<T>() * size / cloud.spacing.to_double();

    let gradient = Gradient { factor: cloud.factor() };
    let mut full = 0;
    for i in 0..cloud.at.len() {
        let correction = cloud.correction(i);
        if let Corrected::Full(_) = correction {
            full += 1;
            let error = (correction * apply(&gradient, cloud, i, &field) - slope).norm().to_double();
            prop_assert!(error <= tolerance, "particle {i}: off by {error:e}, allowed {tolerance:e}");
        }
    }
    Ok(full)
}

fn on_blocks<T: Real, const D: usize>(scene: &Scene, side: usize) -> Result<(), TestCaseError> {
    let cloud = Cloud::<T, D>::jittered(scene, side);
    let full = exact_for_linear(&cloud, scene.seed)?;
    // Nothing of a block with little disorder is degenerate, its corners included; with the shortest
    // radius and the most disorder half of it may be.
    let least = if scene.jitter < 0.1 { cloud.at.len() } else { cloud.at.len() / 4 };
    prop_assert!(full >= least, "only {full} of {} neighbourhoods were full", cloud.at.len());
    Ok(())
}

fn on_random_points<T: Real, const D: usize>(scene: &Scene, side: usize) -> Result<(), TestCaseError> {
    let full = exact_for_linear(&Cloud::<T, D>::scattered(scene, side), scene.seed)?;
    prop_assert!(full > 0);
    Ok(())
}

proptest! {
    #[test]
    fn corrected_gradient_is_exact_for_linear_fields_on_blocks(scene in scene()) {
        on_blocks::<f64, 2>(&scene, 7)?;
        on_blocks::<f64, 3>(&scene, 4)?;
        on_blocks::<f32, 2>(&scene, 7)?;
        on_blocks::<f32, 3>(&scene, 4)?;
    }

    #[test]
    fn corrected_gradient_is_exact_for_linear_fields_on_random_points(scene in scene()) {
        on_random_points::<f64, 2>(&scene, 8)?;
        on_random_points::<f64, 3>(&scene, 5)?;
        on_random_points::<f32, 2>(&scene, 8)?;
        on_random_points::<f32, 3>(&scene, 5)?;
    }
}

/// Without the correction a gradient at a wall is off by half: the tests above see the correction.
#[test]
fn plain_gradient_is_wrong_at_a_boundary() {
    for weight in crate::common::Weight::ALL {
        let cloud = Cloud::<f64, 2>::lattice(weight, 0.1, 3.1, 9);
        let field: Vec<f64> = cloud.at.iter().map(|x| x[0]).collect();
        let at_left_face = 4 * 9;
        let plain = apply(&Gradient { factor: cloud.factor() }, &cloud, at_left_face, &field);
        assert!((plain[0] - 0.5).abs() < 1e-12, "{plain}");
        let corrected = cloud.correction(at_left_face) * plain;
        assert!((corrected - Vector::from([1.0, 0.0])).norm() < 1e-12, "{corrected}");
    }
}
