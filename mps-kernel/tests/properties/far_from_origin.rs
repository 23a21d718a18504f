//! Nothing depends on where the origin is, except through the rounding of the positions themselves.
//!
//! Positions near `L` are rounded to `u L` (`u` the rounding unit), but the difference of two of them is
//! exact. So every operator sees exactly the rounded places, and
//!
//! - a field that is linear in the *rounded places* has its exact gradient, as near the origin;
//! - a field computed from the far coordinates carries their size, and its gradient an error of
//!   `u L / spacing` times the condition number: 2e-7 for `L = 1e6`, spacing 1e-3, `f64`;
//! - in `f32`, `L = 1e6` and spacing 1 leave places to within 0.06, which works the same way; with
//!   spacing 1e-3 all places round to one or two, which is refused as degenerate, not NaN.

use crate::common::{Cloud, Noise, Scene, epsilon, scene};
use mps_kernel::operators::{Corrected, Gradient, Laplacian, NumberDensity};
use mps_kernel::{Real, Vector, apply};
use proptest::prelude::*;

/// A jittered block moved by about `1e6` along every axis.
fn far_block<T: Real, const D: usize>(scene: &Scene, side: usize) -> (Cloud<T, D>, Vector<T, D>) {
    let mut cloud = Cloud::<T, D>::jittered(scene, side);
    let mut noise = Noise(scene.seed ^ 0xFA);
    let origin = Vector::from_fn(|k, _| {
        let size = noise.between::<T>(0.9e6, 1.1e6);
        if k == 1 { -size } else { size }
    });
    for position in &mut cloud.at {
        *position += origin;
    }
    (cloud, origin)
}

/// The same places seen from nearby: the subtraction is exact.
fn seen_from<T: Real, const D: usize>(cloud: &Cloud<T, D>, origin: &Vector<T, D>) -> Cloud<T, D> {
    let mut near = cloud.clone();
    for position in &mut near.at {
        *position -= *origin;
    }
    near
}

fn same_to_the_last_bit<T: Real, const D: usize>(scene: &Scene, side: usize) -> Result<(), TestCaseError> {
    let (far, origin) = far_block::<T, D>(scene, side);
    let near = seen_from(&far, &origin);
    let mut noise = Noise(scene.seed ^ 0xFB);
    let (f, u) = (noise.numbers::<T>(far.at.len(), -1.0, 1.0), noise.vectors::<T, D>(far.at.len()));
    let gradient = Gradient { factor: far.factor() };
    let laplacian = Laplacian { factor: far.reference().laplacian_factor::<D>() };
    prop_assert_eq!(far.each(&NumberDensity, &f), near.each(&NumberDensity, &f));
    prop_assert_eq!(far.each(&gradient, &f), near.each(&gradient, &f));
    prop_assert_eq!(far.each(&laplacian, &u), near.each(&laplacian, &u));
    for i in 0..far.at.len() {
        prop_assert_eq!(far.correction(i), near.correction(i));
    }
    Ok(())
}

fn linear_fields<T: Real, const D: usize>(scene: &Scene, side: usize) -> Result<(), TestCaseError> {
    let (cloud, origin) = far_block::<T, D>(scene, side);
    let slope = Noise(scene.seed ^ 0xFC).direction::<T, D>();
    let spacing = cloud.spacing.to_double();
    let block = 2.0 * side as f64;
    let from_near: Vec<T> = cloud.at.iter().map(|x| slope.dot(&(x - origin))).collect();
    let from_far: Vec<T> = cloud.at.iter().map(|x| slope.dot(x)).collect();
    let gradient = Gradient { factor: cloud.factor() };
    for i in 0..cloud.at.len() {
        let correction = cloud.correction(i);
        let Corrected::Full(_) = correction else { continue };
        // 400: condition number times the closest distance, as in `gradient`.
        let error = (correction * apply(&gradient, &cloud, i, &from_near) - slope).norm().to_double();
        let tolerance = 400.0 * epsilon::<T>() * block;
        prop_assert!(error <= tolerance, "near field: off by {error:e}, allowed {tolerance:e}");
        let error = (correction * apply(&gradient, &cloud, i, &from_far) - slope).norm().to_double();
        let tolerance = 400.0 * epsilon::<T>() * (block + 2e6 / spacing);
        prop_assert!(error <= tolerance, "far field: off by {error:e}, allowed {tolerance:e}");
    }
    Ok(())
}

proptest! {
    #[test]
    fn operators_see_the_same_far_from_the_origin(scene in scene()) {
        for spacing in [1.0, 1e-3] {
            let scene = Scene { spacing, ..scene };
            same_to_the_last_bit::<f64, 2>(&scene, 6)?;
            same_to_the_last_bit::<f64, 3>(&scene, 4)?;
        }
        let scene = Scene { spacing: 1.0, ..scene };
        same_to_the_last_bit::<f32, 2>(&scene, 6)?;
        same_to_the_last_bit::<f32, 3>(&scene, 4)?;
    }

    #[test]
    fn linear_fields_keep_their_gradient_far_from_the_origin(scene in scene()) {
        for spacing in [1.0, 1e-3] {
            let scene = Scene { spacing, ..scene };
            linear_fields::<f64, 2>(&scene, 6)?;
            linear_fields::<f64, 3>(&scene, 4)?;
        }
        let scene = Scene { spacing: 1.0, ..scene };
        linear_fields::<f32, 2>(&scene, 6)?;
        linear_fields::<f32, 3>(&scene, 4)?;
    }

    #[test]
    fn places_that_round_together_are_degenerate(scene in scene()) {
        let (cloud, _) = far_block::<f32, 2>(&Scene { spacing: 1e-3, ..scene }, 6);
        let field = Noise(scene.seed).numbers::<f32>(cloud.at.len(), -1.0, 1.0);
        for (i, gradient) in cloud.each(&Gradient { factor: cloud.factor() }, &field).into_iter().enumerate() {
            prop_assert!(cloud.correction(i).is_degenerate());
            prop_assert!(gradient.iter().all(|g| g.is_finite()));
        }
    }
}
