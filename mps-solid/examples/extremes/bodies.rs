//! Blocks with unit spacing.

use crate::Outcome;
use mps_kernel::{Real, Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

pub(crate) fn serial() -> Parallel {
    Parallel::serial()
}

/// A block with unit spacing and density 1, held at faces some of which slide.
pub(crate) fn block<T: Real, const D: usize, M: ConstitutiveModel<T, D>>(
    counts: [usize; D],
    [held, sliding]: [&[Face]; 2],
    material: M,
    cfl: f64,
) -> Outcome<Solid<T, D, M>> {
    let upper = Vector::<T, D>::from_fn(|axis, _| {
        let on_faces = held.iter().filter(|face| face.axis == axis).count();
        T::of(counts[axis] as f64 - 0.5 * on_faces as f64)
    });
    let mut block = body::block(Vector::zeros(), upper, counts, held)?;
    sliding.iter().try_for_each(|&face| block.slide(face))?;
    let config = SolidConfig { cfl: T::of(cfl), ..SolidConfig::default() };
    Ok(Solid::new(block.particles, block.spacing, T::one(), material, WendlandC2, config, &serial())?)
}

/// What holds a block that is stretched along the first axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sides {
    /// Rollers all around: uniaxial strain.
    Held,
    /// Rollers at both ends and on the plane of symmetry, the other side free: uniaxial stress.
    Free,
    /// Both ends clamped, both sides free: what a machine for tension does.
    Clamped,
}

impl Sides {
    /// Those that leave the deformation uniform.
    pub(crate) const UNIFORM: [Self; 2] = [Self::Held, Self::Free];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Held => "held",
            Self::Free => "free",
            Self::Clamped => "free, ends clamped",
        }
    }

    /// The faces that are held, and those of them that slide.
    pub(crate) fn faces(self) -> [&'static [Face]; 2] {
        const ALL: [Face; 4] = [Face::lower(0), Face::upper(0), Face::lower(1), Face::upper(1)];
        match self {
            Self::Held => [&ALL, &ALL],
            Self::Free => [&ALL[..3], &ALL[..3]],
            Self::Clamped => [&ALL[..2], &[]],
        }
    }
}

/// Reproducible noise in [-0.5, 0.5).
pub(crate) struct Noise(u64);

impl Noise {
    pub(crate) fn new() -> Self {
        Self(1)
    }

    pub(crate) fn vector<T: Real, const D: usize>(&mut self) -> Vector<T, D> {
        Vector::from_fn(|_, _| {
            // Knuth's linear congruential generator, upper bits.
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            T::of((self.0 >> 40) as f64 / (1_u64 << 24) as f64 - 0.5)
        })
    }
}
