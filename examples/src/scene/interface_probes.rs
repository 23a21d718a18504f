//! What the fluid does to bodies.

use super::World;
use super::lattice::Place;
use crate::Failure;
use mps_kernel::{Kernel, Real, Vector};

/// Impulse \[N s/m\] along x and y, angular impulse about the origin \[N s\] and work \[J/m\] that structures have been handed since
/// the start.
pub(super) fn handed<T: Real, K: Kernel<T>>(world: &World<T, K>, structures: &[usize]) -> [f64; 4] {
    let all = structures.iter().filter_map(|body| world.coupled()?.budget().handed.get(*body));
    all.fold([0.0; 4], |sum, handed| {
        let (force, moment) = (handed.push.force, handed.push.moment[(0, 1)]);
        let one = [force[0], force[1], moment, handed.work].map(Real::to_double);
        std::array::from_fn(|k| sum[k] + one[k])
    })
}

/// A part of the surface of a body at rest.
pub(super) struct WallPart {
    body: usize,
    /// Numbers of the points of the body behind it.
    points: Vec<usize>,
    /// Into the fluid.
    normal: Place,
    /// Its length \[m\].
    length: f64,
}

impl WallPart {
    /// Between two points \[m\], with the fluid on the left.
    ///
    /// # Errors
    /// If there is nothing of the body behind it.
    pub(super) fn new<T: Real, K: Kernel<T>>(
        world: &World<T, K>,
        body: usize,
        from: Place,
        to: Place,
    ) -> Result<Self, Failure> {
        let (along, length) = unit([to[0] - from[0], to[1] - from[1]]);
        let normal = [-along[1], along[0]];
        let scene = world.coupled();
        let depth = scene.map_or(0.0, |scene| {
            let config = scene.fluid().config();
            (config.radius_ratio * config.spacing).to_double()
        });
        let positions =
            scene.and_then(|scene| scene.structure(body)).map_or(&[][..], |body| body.positions());
        let behind = |r: &Vector<T, 2>| {
            let arm = [r[0].to_double() - from[0], r[1].to_double() - from[1]];
            let (s, out) = (dot(arm, along), dot(arm, normal));
            // Points on the surface are behind it whatever the rounding; each end belongs to one of the parts it divides.
            (0.0..length).contains(&s) && (-depth..1e-6 * depth).contains(&out)
        };
        let points: Vec<_> =
            positions.iter().enumerate().filter(|(_, r)| behind(r)).map(|(k, _)| k).collect();
        if points.is_empty() {
            let line = format!("from {from:?} to {to:?}");
            return Err(format!(
                "the wall {line} has no point of its body behind it: give a line on the surface, with the fluid on its left"
            )
            .into());
        }
        Ok(Self { body, points, normal, length })
    }

    /// Mean pressure on it in the last step \[Pa\].
    pub(super) fn pressure<T: Real, K: Kernel<T>>(&self, world: &World<T, K>) -> f64 {
        let forces = world.coupled().and_then(|scene| scene.forces(self.body)).unwrap_or_default();
        let load =
            |k: &usize| forces.get(*k).map_or(0.0, |f| dot([f[0], f[1]].map(Real::to_double), self.normal));
        -self.points.iter().map(load).sum::<f64>() / self.length
    }
}

fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The direction of a vector, and its length.
fn unit(a: Place) -> (Place, f64) {
    let length = dot(a, a).sqrt();
    (a.map(|x| x / length), length)
}
