//! What a step that fails costs: nothing.

use crate::scene::{SIDES, V, block, moduli};
use mps_neighbors::Parallel;
use mps_solid::materials::NeoHookean;
use mps_solid::{Placement, SolidError};

/// The supports jump through the body: the particle is named, and the body is as it was before that call.
#[test]
fn an_inversion_names_the_particle_and_loses_nothing() {
    let serial = Parallel::serial();
    let mut solid = block::<f64, 2, _>([8, 4], &SIDES, NeoHookean::from(moduli(0.3)), 1.0, 0.5);
    let jump = |t: f64| if t < 5.0 { -0.01 * t } else { -6.0 };
    solid.move_supports(|x| x.x > 6.9, move |t| Placement::shifted(V::new(jump(t), 0.0))).unwrap();
    let (rest, zero) = (vec![V::zeros(); solid.len()], V::zeros());
    solid.advance(&serial, &rest, &zero, 4.8, 20).unwrap();
    let before = solid.clone();
    let error = solid.advance(&serial, &rest, &zero, 0.4, 2).unwrap_err();
    let SolidError::Inverted { id, determinant, .. } = error else { panic!("{error}") };
    assert!(before.particles().reference_positions()[id as usize].x > 4.0, "{id}");
    assert!(determinant < 0.0, "{determinant}");
    assert_eq!(solid.positions(), before.positions());
    assert_eq!(solid.velocities(), before.velocities());
    assert_eq!(solid.time(), before.time());
    assert_eq!(solid.particles().deformations(), before.particles().deformations());
    assert_eq!(solid.particles().internal_forces(), before.particles().internal_forces());
    // And it goes on from there as if nothing had happened.
    let mut twin = before;
    for body in [&mut solid, &mut twin] {
        body.advance(&serial, &rest, &zero, 0.1, 1).unwrap();
    }
    assert_eq!(solid.positions(), twin.positions());
}

/// A body thrown against its support with too long a step fails; with shorter ones it goes on from the same state.
#[test]
fn what_failed_can_be_tried_again_with_shorter_steps() {
    let serial = Parallel::serial();
    let mut solid = block::<f64, 2, _>([8, 4], &SIDES[..1], NeoHookean::from(moduli(0.3)), 1.0, 0.8);
    let thrown: Vec<V> =
        solid.positions().iter().map(|x| V::new(if x.x > 0.0 { -0.4 } else { 0.0 }, 0.1)).collect();
    solid.velocities_mut().copy_from_slice(&thrown);
    let energy0 = solid.energy(&serial, &V::zeros()).total();
    let rest = vec![V::zeros(); solid.len()];
    let dt = 20.0 * solid.stability_limit();
    assert!(solid.advance(&serial, &rest, &V::zeros(), dt, 5).is_err());
    solid.advance(&serial, &rest, &V::zeros(), dt, 200).unwrap();
    let energy = solid.energy(&serial, &V::zeros()).total();
    assert!((energy / energy0 - 1.0).abs() < 0.01, "{energy} of {energy0}");
}
