//! Bodies made of particles on a lattice.

use crate::{MaterialPoint, SolidError, SolidParticles, Surface};
use mps_kernel::{Real, Vector};

/// Particles and the distance between them along each axis.
#[derive(Clone, Debug)]
pub struct Body<T: Real, const D: usize> {
    /// The particles, at rest in the undeformed state.
    pub particles: SolidParticles<T, D>,
    /// Particle distance along each axis \[m\].
    pub spacing: Vector<T, D>,
    lower: Vector<T, D>,
    upper: Vector<T, D>,
    counts: [usize; D],
    /// Distance in the list of two particles next to each other along each axis.
    strides: [usize; D],
    clamped: Vec<Face>,
    sliding: Vec<Face>,
}

impl<T: Real, const D: usize> Body<T, D> {
    /// A free face as a surface to put loads on: a point in the middle of the outer side of every particle along
    /// it. Loads are spread over the outer two rows as the linear continuation of a field from them says (3/2 and
    /// -1/2): what meets a uniform stress exactly everywhere but at edges, where it is off for the last two rows.
    ///
    /// # Errors
    /// If the face is clamped or does not exist.
    pub fn face(&self, face: Face) -> Result<Surface<T, D>, SolidError> {
        face.check::<D>()?;
        if self.clamped.contains(&face) || self.sliding.contains(&face) {
            return Err(SolidError::ClampedFace { axis: face.axis, upper: face.upper });
        }
        let axis = face.axis;
        let (end, out) =
            if face.upper { (self.upper[axis], T::one()) } else { (self.lower[axis], -T::one()) };
        let stride = self.strides[axis];
        let row = if face.upper { self.counts[axis] - 1 } else { 0 };
        let on_face = |&i: &usize| i / stride % self.counts[axis] == row;
        let point = |i: usize| {
            let inner = if face.upper { i - stride } else { i + stride };
            let mut place = self.particles.reference[i];
            place[axis] = end;
            let mut area = Vector::zeros();
            area[axis] = out * self.particles.volume[i] / self.spacing[axis];
            let weights = vec![(i as u32, T::of(1.5)), (inner as u32, T::of(-0.5))];
            (MaterialPoint::new(place, weights), area)
        };
        Ok(Surface::new((0..self.particles.reference.len()).filter(on_face).map(point).collect()))
    }

    /// Lets the particles on a clamped face slide along it: held along its normal only, unless they lie on
    /// another clamped face. What a plane of symmetry or a roller does. Where two such faces meet both normals are
    /// held, in whatever order the faces were named.
    ///
    /// # Errors
    /// If the face was not clamped when the block was made: only then does a row of particles lie on it.
    pub fn slide(&mut self, face: Face) -> Result<(), SolidError> {
        face.check::<D>()?;
        if self.sliding.contains(&face) {
            return Ok(());
        }
        if !self.clamped.contains(&face) {
            return Err(SolidError::FreeFace { axis: face.axis, upper: face.upper });
        }
        self.clamped.retain(|other| *other != face);
        self.sliding.push(face);
        let Self { particles, clamped, sliding, lower, upper, .. } = self;
        let on = |x: &Vector<T, D>, face: &Face| {
            x[face.axis] == if face.upper { upper[face.axis] } else { lower[face.axis] }
        };
        for i in 0..particles.reference.len() {
            let x = particles.reference[i];
            if on(&x, &face) && !clamped.iter().any(|other| on(&x, other)) {
                let normal = |axis| sliding.iter().any(|other| other.axis == axis && on(&x, other));
                (0..D).filter(|&axis| !normal(axis)).for_each(|axis| particles.hold(i, axis, false));
            }
        }
        Ok(())
    }
}

/// One of the `2 D` faces of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// Axis the face is normal to.
    pub axis: usize,
    /// Whether it is the face at the upper end of the axis.
    pub upper: bool,
}

impl Face {
    /// The face at the lower end of `axis`.
    pub const fn lower(axis: usize) -> Self {
        Self { axis, upper: false }
    }

    /// The face at the upper end of `axis`.
    pub const fn upper(axis: usize) -> Self {
        Self { axis, upper: true }
    }

    fn check<const D: usize>(self) -> Result<(), SolidError> {
        let axis = self.axis;
        if axis < D { Ok(()) } else { Err(SolidError::NoSuchFace { axis, dimensions: D }) }
    }
}

/// Fills the box from `lower` to `upper` \[m\] with `counts` particles along each axis.
///
/// Along a free axis the particles sit in the middle of their cells: `length / count` apart, half of it
/// from both faces. On a face in `clamp` the first row sits exactly **on** the face, never moves and has
/// half a cell's volume; the other rows follow at full spacing. No neighbourhood then reaches through
/// the clamp plane, which is what spoils the curvature at the root of a beam when clamped layers are put
/// behind it (measured at 10 particles across: 3.5 % in the period instead of 0.4 %). A row on the face
/// counts half towards the length, so the spacing is `length / (count - 1/2)` with one clamped end and
/// `length / (count - 1)` with two. The volumes always add up to that of the box.
///
/// The axis with the fewest particles runs fastest, so that neighbours are near in memory.
///
/// Other bodies must not touch a clamped face, nor one that slides: [`contact`](crate::contact) takes the surface of a body half a
/// spacing outside its outermost particles. What they shall touch is a [`wall`].
///
/// # Errors
/// If an edge is not longer than zero or has fewer than 2 particles, or a face in `clamp` does not exist.
pub fn block<T: Real, const D: usize>(
    lower: Vector<T, D>,
    upper: Vector<T, D>,
    counts: [usize; D],
    clamp: &[Face],
) -> Result<Body<T, D>, SolidError> {
    clamp.iter().try_for_each(|face| face.check::<D>())?;
    let half = T::of(0.5);
    let is_clamped = |axis, upper| clamp.contains(&Face { axis, upper });
    let mut spacing = Vector::zeros();
    let mut cell = T::one();
    for axis in 0..D {
        let length = upper[axis] - lower[axis];
        let count = counts[axis];
        if !(length.is_finite() && length > T::zero() && count >= 2) {
            return Err(SolidError::Block { axis, count, length: length.to_double() });
        }
        spacing[axis] = length / T::of(cells(count, axis, clamp));
        cell *= spacing[axis];
    }
    let mut fastest_first: Vec<usize> = (0..D).collect();
    fastest_first.sort_by_key(|&axis| counts[axis]);

    let mut strides = [1; D];
    fastest_first.windows(2).for_each(|pair| strides[pair[1]] = strides[pair[0]] * counts[pair[0]]);

    let mut particles = SolidParticles::new();
    for index in 0..counts.iter().product() {
        let mut rest = index;
        let mut place = lower;
        let mut volume = cell;
        let mut on_clamp = false;
        for &axis in &fastest_first {
            let k = rest % counts[axis];
            rest /= counts[axis];
            let at_clamp =
                (k == 0 && is_clamped(axis, false)) || (k + 1 == counts[axis] && is_clamped(axis, true));
            let offset = if is_clamped(axis, false) { T::zero() } else { half };
            place[axis] += spacing[axis] * (T::of(k as f64) + offset);
            if at_clamp {
                volume *= half;
                on_clamp = true;
                place[axis] = if k == 0 { lower[axis] } else { upper[axis] };
            }
        }
        particles.push(place, volume, on_clamp);
    }
    Ok(Body {
        particles,
        spacing,
        lower,
        upper,
        counts,
        strides,
        clamped: clamp.to_vec(),
        sliding: Vec::new(),
    })
}

/// A rigid wall for other bodies to touch: the box from `lower` to `upper` \[m\] filled with `counts` particles along each axis, all of
/// them held. They sit in the middle of their cells on every side, so that its surface is where it is drawn. Two layers are
/// enough. Its material says how much it gives way where it is touched; [`Solid::move_supports`](crate::Solid::move_supports) moves it.
///
/// # Errors
/// If an edge is not longer than zero or has fewer than 2 particles.
pub fn wall<T: Real, const D: usize>(
    lower: Vector<T, D>,
    upper: Vector<T, D>,
    counts: [usize; D],
) -> Result<Body<T, D>, SolidError> {
    let mut wall = block(lower, upper, counts, &[])?;
    for i in 0..wall.particles.reference.len() {
        (0..D).for_each(|axis| wall.particles.hold(i, axis, true));
    }
    Ok(wall)
}

/// The numbers of particles that bring the spacing of every axis closest to `spacing` \[m\], for
/// [`block`] (at least 2).
pub fn counts<T: Real, const D: usize>(
    lower: &Vector<T, D>,
    upper: &Vector<T, D>,
    spacing: T,
    clamp: &[Face],
) -> [usize; D] {
    core::array::from_fn(|axis| {
        let cells = (upper[axis] - lower[axis]).to_double() / spacing.to_double();
        let on_faces = clamp.iter().filter(|face| face.axis == axis).count() as f64;
        // Whole lengths between a held and a free face are halfway between two numbers: up, whatever the last bit says. A float that is
        // negative or NaN becomes 0 here.
        ((cells + 0.5 * on_faces + 1e-3).round() as usize).max(2)
    })
}

/// How many spacings `count` particles fill: a row on a clamped face fills half of one.
fn cells(count: usize, axis: usize, clamp: &[Face]) -> f64 {
    let on_face = |upper| if clamp.contains(&Face { axis, upper }) { 0.5 } else { 0.0 };
    count as f64 - on_face(false) - on_face(true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use mps_kernel::ParticleStore;

    #[test]
    fn clamped_row_lies_on_the_face_with_half_the_volume() {
        let upper = Vector::<f64, 2>::new(2.0, 0.5);
        let clamp = [Face::lower(0)];
        let counts = counts(&Vector::zeros(), &upper, 0.125, &clamp);
        assert_eq!(counts, [17, 4]);
        let body = block(Vector::zeros(), upper, counts, &clamp).unwrap();
        let particles = &body.particles;
        assert_eq!(particles.len(), 68);
        for i in 0..68 {
            let on_face = particles.reference[i].x == 0.0;
            assert_eq!(on_face, particles.is_clamped(i));
            let cells = if on_face { 0.5 } else { 1.0 };
            assert_relative_eq!(particles.volume[i], cells * body.spacing.x * body.spacing.y);
        }
        assert_relative_eq!(particles.volume.iter().sum::<f64>(), 1.0, max_relative = 1e-14);
        let end = particles.reference.iter().map(|x| x.x).fold(0.0, f64::max);
        assert_relative_eq!(end, 2.0 - body.spacing.x / 2.0, max_relative = 1e-14);
    }

    #[test]
    fn both_ends_may_be_clamped_and_corners_get_a_quarter() {
        let clamp = [Face::lower(0), Face::upper(0), Face::upper(1)];
        let body = block(Vector::<f64, 2>::zeros(), Vector::repeat(1.0), [5, 3], &clamp).unwrap();
        assert_relative_eq!(body.particles.volume.iter().sum::<f64>(), 1.0, max_relative = 1e-14);
        let x: Vec<_> = body.particles.reference.iter().map(|x| x.x).collect();
        assert_relative_eq!(x.iter().copied().fold(0.0, f64::max), 1.0, max_relative = 1e-14);
    }

    #[test]
    fn where_two_rollers_meet_both_normals_are_held() {
        let faces = [Face::lower(0), Face::lower(1)];
        for order in [[0, 1], [1, 0]] {
            let mut body = block(Vector::<f64, 2>::zeros(), Vector::repeat(1.0), [4, 4], &faces).unwrap();
            order.iter().for_each(|&k| body.slide(faces[k]).unwrap());
            for (i, x) in body.particles.reference.iter().enumerate() {
                for axis in 0..2 {
                    assert_eq!(body.particles.is_held(i, axis), x[axis] == 0.0, "{x} along {axis}");
                }
            }
        }
    }

    #[test]
    fn the_rows_of_whole_lengths_do_not_hang_on_the_last_bit() {
        for clamp in [&[][..], &[Face::lower(0)], &[Face::lower(0), Face::upper(0)]] {
            for cells in 3..300_u32 {
                let length = 1e-3 * f64::from(cells);
                let rows = (cells + clamp.len().div_ceil(2) as u32) as usize;
                for start in [0.0, 0.2, 0.7] {
                    let (lower, upper) = (Vector::<f64, 2>::repeat(start), Vector::repeat(start + length));
                    assert_eq!(counts(&lower, &upper, 1e-3, clamp)[0], rows, "{cells} at {start}");
                    let single = |x: Vector<f64, 2>| x.map(|x| x as f32);
                    assert_eq!(
                        counts(&single(lower), &single(upper), 1e-3, clamp)[0],
                        rows,
                        "{cells} at {start}"
                    );
                }
            }
        }
    }

    #[test]
    fn faces_that_are_free_or_do_not_exist_cannot_be_held() {
        let whole = |clamp: &[Face]| block(Vector::<f64, 2>::zeros(), Vector::repeat(1.0), [4, 4], clamp);
        let mut body = whole(&[Face::lower(0)]).unwrap();
        assert!(matches!(body.slide(Face::upper(0)), Err(SolidError::FreeFace { axis: 0, upper: true })));
        assert!(matches!(body.slide(Face::lower(2)), Err(SolidError::NoSuchFace { axis: 2, .. })));
        assert!(matches!(body.face(Face::lower(2)), Err(SolidError::NoSuchFace { .. })));
        assert!(matches!(whole(&[Face::upper(2)]), Err(SolidError::NoSuchFace { .. })));
        // Nothing but the face itself has changed.
        assert!(body.slide(Face::lower(0)).is_ok() && body.slide(Face::lower(0)).is_ok());
    }

    #[test]
    fn thin_and_empty_blocks_are_refused() {
        let corner = Vector::<f64, 2>::new(1.0, 1.0);
        assert!(matches!(
            block(Vector::zeros(), corner, [5, 1], &[]),
            Err(SolidError::Block { axis: 1, count: 1, .. })
        ));
        assert!(block(corner, corner, [5, 5], &[]).is_err());
        assert!(block(Vector::zeros(), Vector::<f64, 2>::new(f64::NAN, 1.0), [5, 5], &[]).is_err());
    }
}
