//! Which components of the displacements are unknowns, and in which order.

use crate::{SolidError, SolidParticles};
use mps_kernel::Vector;

/// Whether particle `i` can move along `axis`: the only place where this module asks what is held.
fn moves<const D: usize>(particles: &SolidParticles<f64, D>, i: usize, axis: usize) -> bool {
    !particles.is_held(i, axis)
}

/// The degrees of freedom that move: particle by particle, axis by axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Freedoms<const D: usize> {
    /// Number of the unknown of every particle and axis.
    number: Vec<[Option<usize>; D]>,
    /// Particle and axis of every unknown.
    place: Vec<(usize, usize)>,
}

impl<const D: usize> Freedoms<D> {
    pub(super) fn new(particles: &SolidParticles<f64, D>) -> Self {
        let mut place = Vec::new();
        let mut number = vec![[None; D]; particles.ids().len()];
        for (i, numbers) in number.iter_mut().enumerate() {
            for (axis, number) in
                numbers.iter_mut().enumerate().filter(|(axis, _)| moves(particles, i, *axis))
            {
                *number = Some(place.len());
                place.push((i, axis));
            }
        }
        Self { number, place }
    }

    /// How many unknowns there are.
    pub(super) fn len(&self) -> usize {
        self.place.len()
    }

    /// How many particles there are.
    pub(super) fn particles(&self) -> usize {
        self.number.len()
    }

    /// The unknowns of particle `i` as (axis, number), ascending.
    pub(super) fn of(&self, i: usize) -> impl Iterator<Item = (usize, usize)> {
        self.number[i].iter().enumerate().filter_map(|(axis, number)| Some((axis, (*number)?)))
    }

    /// The first unknown of particle `i`, if it has one.
    pub(super) fn first(&self, i: usize) -> Option<usize> {
        self.number[i].iter().copied().flatten().next()
    }

    /// `value(particle, axis)` of every unknown.
    pub(super) fn gather(&self, value: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        self.place.iter().map(|&(i, axis)| value(i, axis)).collect()
    }

    /// The unknowns as a vector per particle, zero where nothing moves.
    pub(super) fn scatter(&self, values: impl Iterator<Item = f64>) -> Vec<Vector<f64, D>> {
        let mut vectors = vec![Vector::zeros(); self.number.len()];
        for (&(i, axis), value) in self.place.iter().zip(values) {
            vectors[i][axis] = value;
        }
        vectors
    }

    /// # Errors
    /// [`SolidError::Length`] if there is not one entry for every particle.
    pub(super) fn check(&self, name: &'static str, vectors: &[Vector<f64, D>]) -> Result<(), SolidError> {
        let (got, particles) = (vectors.len(), self.number.len());
        if got == particles { Ok(()) } else { Err(SolidError::Length { name, got, particles }) }
    }
}
