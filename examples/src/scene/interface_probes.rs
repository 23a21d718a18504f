//! What the fluid does to bodies.

use super::World;
use super::lattice::Place;
use super::units::planes;
use crate::Failure;
use mps_kernel::{Kernel, Real};

/// Impulse per dimension, angular impulse about the origin, one number per plane things turn in, and work that structures have
/// been handed since the start: \[N s\], \[N m s\] and \[J\], in two dimensions per metre of depth.
pub(super) fn handed<T: Real, const D: usize, K: Kernel<T>>(
    world: &World<T, D, K>,
    structures: &[usize],
) -> Vec<f64> {
    let mut sum = vec![0.0; D + planes::<D>().len() + 1];
    for handed in structures.iter().filter_map(|body| world.coupled()?.budget().handed.get(*body)) {
        let moments = planes::<D>().iter().map(|plane| handed.push.moment[*plane]);
        let one = handed.push.force.iter().copied().chain(moments).chain([handed.work]);
        sum.iter_mut().zip(one).for_each(|(sum, one)| *sum += one.to_double());
    }
    sum
}

/// What is wrong with a part of a surface, and what to do.
pub(super) const NOTHING_BEHIND: &str = "has no point of its body behind it";
pub(super) const ON_THE_SURFACE: &str = "give a line on the surface, with the fluid on its left";

/// A part of the surface of a body at rest, in two dimensions.
pub(super) struct WallPart {
    body: usize,
    /// Numbers of the points of the body behind it.
    points: Vec<usize>,
    /// Into the fluid.
    normal: Place<2>,
    /// Its length \[m\].
    length: f64,
}

impl WallPart {
    /// Between two points \[m\], with the fluid on the left.
    ///
    /// # Errors
    /// If there is nothing of the body behind it.
    pub(super) fn new<T: Real, const D: usize, K: Kernel<T>>(
        world: &World<T, D, K>,
        body: usize,
        from: Place<2>,
        to: Place<2>,
    ) -> Result<Self, Failure> {
        let scene = world.coupled();
        let depth = scene.map_or(0.0, |scene| {
            let config = scene.fluid().config();
            (config.radius_ratio * config.spacing).to_double()
        });
        let positions =
            scene.and_then(|scene| scene.structure(body)).map_or(&[][..], |body| body.positions());
        let places = positions.iter().map(|r| [r[0].to_double(), r[1].to_double()]);
        let points = behind(places, [from, to], depth);
        if points.is_empty() {
            let line = format!("from {from:?} to {to:?}");
            return Err(format!("the wall {line} {NOTHING_BEHIND}: {ON_THE_SURFACE}").into());
        }
        let (along, length) = unit([to[0] - from[0], to[1] - from[1]]);
        Ok(Self { body, points, normal: [-along[1], along[0]], length })
    }

    /// Mean pressure on it in the last step \[Pa\].
    pub(super) fn pressure<T: Real, const D: usize, K: Kernel<T>>(&self, world: &World<T, D, K>) -> f64 {
        let forces = world.coupled().and_then(|scene| scene.forces(self.body)).unwrap_or_default();
        let load =
            |k: &usize| forces.get(*k).map_or(0.0, |f| dot([f[0], f[1]].map(Real::to_double), self.normal));
        -self.points.iter().map(load).sum::<f64>() / self.length
    }
}

/// Numbers of the places behind a line between two points that is walked with the fluid on the left, up to `depth` \[m\] deep.
pub(super) fn behind(
    places: impl Iterator<Item = Place<2>>,
    [from, to]: [Place<2>; 2],
    depth: f64,
) -> Vec<usize> {
    let (along, length) = unit([to[0] - from[0], to[1] - from[1]]);
    let normal = [-along[1], along[0]];
    let is_behind = |place: &Place<2>| {
        let arm = [place[0] - from[0], place[1] - from[1]];
        let (s, out) = (dot(arm, along), dot(arm, normal));
        // Points on the surface are behind it whatever the rounding; each end belongs to one of the parts it divides.
        (0.0..length).contains(&s) && (-depth..1e-6 * depth).contains(&out)
    };
    places.enumerate().filter(|(_, place)| is_behind(place)).map(|(k, _)| k).collect()
}

fn dot(a: Place<2>, b: Place<2>) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The direction of a vector, and its length.
fn unit(a: Place<2>) -> (Place<2>, f64) {
    let length = dot(a, a).sqrt();
    (a.map(|x| x / length), length)
}
