//! What has to be known of a shape.

use mps_kernel::Vector;

/// Where the surface is nearest to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest<const D: usize> {
    /// The point of the surface \[m\].
    pub foot: Vector<f64, D>,
    /// How deep the place is inside \[m\]; negative outside.
    pub depth: f64,
}

/// A bounded part of space whose surface can be found.
///
/// ```
/// use mps_kernel::Vector;
/// use mps_neighbors::Parallel;
/// use mps_neighbors::fit::{Nearest, Shape, fit};
///
/// /// A disc around the origin.
/// struct Disc(f64);
///
/// impl Shape<2> for Disc {
///     fn bounds(&self) -> [Vector<f64, 2>; 2] {
///         [-self.0, self.0].map(Vector::repeat)
///     }
///     fn nearest(&self, place: &Vector<f64, 2>) -> Option<Nearest<2>> {
///         let foot = place.try_normalize(0.0).unwrap_or(Vector::x()) * self.0;
///         Some(Nearest { foot, depth: self.0 - place.norm() })
///     }
/// }
///
/// let points = fit(&Disc(1.0), 0.1, &Parallel::serial())?;
/// let outermost = points.places.iter().map(|place| place.norm()).fold(0.0, f64::max);
/// assert_eq!(points.places.len(), 314);
/// assert!((outermost - 0.95).abs() < 1e-9);
/// # Ok::<(), mps_neighbors::fit::FitError>(())
/// ```
pub trait Shape<const D: usize>: Sync {
    /// Two opposite corners of a box around it, the one with the smallest coordinates first \[m\].
    fn bounds(&self) -> [Vector<f64, D>; 2];

    /// Where the surface is nearest; `None` if there is none.
    fn nearest(&self, place: &Vector<f64, D>) -> Option<Nearest<D>>;
}

/// How far beside a place on the surface the depth is asked for, over a length of the size of the spacing.
const PROBE: f64 = 0.05;
/// Most often that a place is put back: in a corner of 20 degrees every two times bring it nearer by an eighth.
const CORNER: usize = 60;
/// What may be missing of a depth, as a share.
const MISSING: f64 = 1e-4;

/// To the inside, across the surface at its point nearest to a place, of length one; `None` where no way leads inside.
pub(super) fn inward<const D: usize>(
    shape: &impl Shape<D>,
    place: &Vector<f64, D>,
    nearest: &Nearest<D>,
    length: f64,
) -> Option<Vector<f64, D>> {
    if nearest.depth.abs() > 1e-6 * length {
        return ((place - nearest.foot) * nearest.depth.signum()).try_normalize(0.0);
    }
    let depth = |axis: usize, step: f64| {
        let mut beside = *place;
        beside[axis] += step;
        shape.nearest(&beside).map_or(0.0, |nearest| nearest.depth)
    };
    let step = PROBE * length;
    let slope: Vector<f64, D> = Vector::from_fn(|axis, _| depth(axis, step) - depth(axis, -step));
    slope.try_normalize(1e-3 * step)
}

/// The place itself if it is at least `least` \[m\] deep, or one at that depth near it; with its depth \[m\].
pub(super) fn at_depth<const D: usize>(
    shape: &impl Shape<D>,
    mut place: Vector<f64, D>,
    least: f64,
) -> (Vector<f64, D>, f64) {
    let mut depth = f64::INFINITY;
    // Off one side of a corner, a place may come too near to the other one.
    for _ in 0..CORNER {
        let Some(nearest) = shape.nearest(&place) else { return (place, 0.0) };
        depth = nearest.depth;
        if depth >= least * (1.0 - MISSING) {
            break;
        }
        let Some(inward) = inward(shape, &place, &nearest, least) else { break };
        place += inward * (least - depth);
    }
    (place, depth)
}
