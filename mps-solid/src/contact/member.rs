//! What contact keeps of a body.

use super::bonds::Bonds;
use super::{ContactError, Shape};
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;

/// Largest ratio of the spacings along two axes. The surface is taken half a mean spacing outside of the outermost particles, on every side:
/// with this it is off by a thirtieth of a spacing.
const UNEVEN: f64 = 1.125;

#[derive(Clone, Debug)]
pub(crate) struct Member<T: Real, const D: usize> {
    /// If it may meet itself.
    pub(crate) bonds: Option<Bonds>,
    pub(crate) volume: Vec<T>,
    pub(crate) spacing: T,
    pub(crate) modulus: T,
    /// The smallest of its particles \[kg/m^D\].
    pub(crate) density: T,
    /// Forces of contact \[N\].
    pub(crate) force: Vec<Vector<T, D>>,
    /// Whether one of them is not zero.
    pub(crate) pushed: bool,
    /// Corners of the box around its particles.
    bounds: [Vector<T, D>; 2],
}

impl<T: Real, const D: usize> Member<T, D> {
    /// Copies `shape` of body number `body`, which may meet itself if `folds`.
    pub(crate) fn new(shape: &Shape<'_, T, D>, body: usize, folds: bool) -> Result<Self, ContactError> {
        let particles = shape.reference.len();
        for (name, got) in [("volume", shape.volume.len()), ("mass", shape.mass.len())] {
            if got != particles {
                return Err(ContactError::Length { body, name, got, particles });
            }
        }
        let check = |name, value: T| {
            let value = value.to_double();
            // Written so that NaN is refused too.
            if value > 0.0 && value.is_finite() {
                Ok(())
            } else {
                Err(ContactError::Shape { body, name, value })
            }
        };
        shape.spacing.iter().try_for_each(|l| check("spacing", *l))?;
        let ratio = (shape.spacing.max() / shape.spacing.min()).to_double();
        if ratio > UNEVEN {
            return Err(ContactError::Uneven { body, ratio, largest: UNEVEN });
        }
        check("modulus", shape.modulus)?;
        let mut density = None;
        for (volume, mass) in shape.volume.iter().zip(shape.mass) {
            check("volume of a particle", *volume)?;
            check("mass of a particle", *mass)?;
            let this = *mass / *volume;
            density = Some(density.map_or(this, |least: T| least.min(this)));
        }
        Ok(Self {
            bonds: if folds { Some(Bonds::new(shape, body)?) } else { None },
            volume: shape.volume.to_vec(),
            // As for the reference pairs.
            spacing: shape.spacing.iter().fold(T::one(), |all, l| all * *l).powf(T::of(1.0 / D as f64)),
            modulus: shape.modulus,
            density: density.unwrap_or(T::one()),
            force: vec![Vector::zeros(); particles],
            pushed: false,
            bounds: [Vector::zeros(), Vector::zeros()],
        })
    }

    /// Finds the box around the particles.
    pub(crate) fn bound(&mut self, parallel: &Parallel, positions: &[Vector<T, D>]) {
        let Some(first) = positions.first() else { return };
        self.bounds = parallel.fold(
            positions.len(),
            [*first; 2],
            &|i: usize| [positions[i]; 2],
            &|a: [Vector<T, D>; 2], b: [Vector<T, D>; 2]| [a[0].inf(&b[0]), a[1].sup(&b[1])],
        );
    }

    /// Width of the gap between the boxes along the axis where it is widest \[m\], negative if they overlap.
    pub(crate) fn gap(&self, other: &Self) -> T {
        let [[lower, upper], [other_lower, other_upper]] = [&self.bounds, &other.bounds];
        let mut widest = lower[0] - other_upper[0];
        for axis in 0..D {
            widest = widest.max(lower[axis] - other_upper[axis]).max(other_lower[axis] - upper[axis]);
        }
        widest
    }

    /// Forgets the forces.
    pub(crate) fn rest(&mut self) {
        if self.pushed {
            self.force.fill(Vector::zeros());
            self.pushed = false;
        }
    }
}
