//! The two sweeps of contact: overlaps of the particles, then the forces.

use super::ContactError;
use super::member::Member;
use super::pairing::Pairing;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;

impl<T: Real, const D: usize> Pairing<T, D> {
    /// Overlaps and energy at the current positions.
    pub(crate) fn overlap(
        &mut self,
        parallel: &Parallel,
        members: &[Member<T, D>],
        positions: [&[Vector<T, D>]; 2],
    ) -> Result<(), ContactError> {
        (self.energy, self.overlap) = (T::zero(), T::zero());
        let last = self.sides.len() - 1;
        let half_stiffness = self.stiffness * T::of(0.5);
        for s in 0..=last {
            let other = self.sides[last - s].body;
            let side = &mut self.sides[s];
            let (here, there) = (positions[s], positions[last - s]);
            let (own, seen) = (&members[side.body], &members[other]);
            let (facing, candidates) = (&side.facing, &side.candidates);
            let scale = half_stiffness / own.spacing;
            parallel.update(side.found.as_mut_slice(), |k, found| {
                let (i, row) = candidates.row(k);
                let x = here[i];
                let sum = row.iter().fold(T::zero(), |sum, &j| {
                    let near = facing.nearness((there[j as usize] - x).norm_squared());
                    sum + seen.volume[j as usize] * (near * near * near)
                });
                let depth = facing.depth(sum);
                *found = (own.volume[i] * scale * depth * facing.over_slope, depth);
            });
            for (&i, found) in candidates.particles().iter().zip(&side.found) {
                side.push[i as usize] = found.0;
            }
            let half_slope = T::of(0.5) / facing.over_slope;
            // One after the other: candidates that are too far to matter must not change the order of the sum.
            let (mut energy, mut overlap, mut at) = (T::zero(), T::zero(), 0);
            for (k, &(push, depth)) in side.found.iter().enumerate() {
                energy += push * depth * half_slope;
                if depth > overlap {
                    (overlap, at) = (depth, k);
                }
            }
            self.energy += energy;
            self.overlap = self.overlap.max(overlap);
            if overlap > facing.deepest {
                let (particle, row) = candidates.row(at);
                return Err(passed(
                    [side.body, other],
                    particle,
                    row,
                    [here, there],
                    [overlap, facing.deepest],
                ));
            }
        }
        Ok(())
    }

    /// Adds the forces to those of the members. Each is the exact gradient of the energy,
    /// `f_ij = (p_i V_j + p_j V_i) 6/R^2 (1 - r^2/R^2)^2 r_ji`, and bit by bit the opposite of `f_ji`.
    pub(crate) fn push(
        &mut self,
        parallel: &Parallel,
        members: &mut [Member<T, D>],
        positions: [&[Vector<T, D>]; 2],
    ) {
        if self.overlap == T::zero() {
            return;
        }
        let last = self.sides.len() - 1;
        for s in 0..=last {
            let mut force = core::mem::take(&mut self.sides[s].force);
            let (side, other) = (&self.sides[s], &self.sides[last - s]);
            let (here, there) = (positions[s], positions[last - s]);
            let (volume, seen) = (&members[side.body].volume, &members[other.body].volume);
            let (facing, candidates) = (&side.facing, &side.candidates);
            let factor = facing.over_r2 * T::of(6.0);
            parallel.update(force.as_mut_slice(), |k, force| {
                let (i, row) = candidates.row(k);
                let (x, push, own) = (here[i], side.push[i], volume[i]);
                *force = Vector::zeros();
                for &j in row {
                    let j = j as usize;
                    let both = push * seen[j] + other.push[j] * own;
                    if both > T::zero() {
                        let r_ji = x - there[j];
                        let near = facing.nearness(r_ji.norm_squared());
                        *force += r_ji * (both * (near * near) * factor);
                    }
                }
            });
            let member = &mut members[side.body];
            member.pushed = true;
            for (&i, force) in candidates.particles().iter().zip(&force) {
                member.force[i as usize] += force;
            }
            self.sides[s].force = force;
        }
    }
}

#[cold]
fn passed<T: Real, const D: usize>(
    [body, other]: [usize; 2],
    particle: usize,
    row: &[u32],
    [here, there]: [&[Vector<T, D>]; 2],
    [overlap, deepest]: [T; 2],
) -> ContactError {
    let away = |j: u32| (there[j as usize] - here[particle]).norm_squared();
    let neighbor = row.iter().copied().reduce(|a, b| if away(b) < away(a) { b } else { a });
    ContactError::Passed {
        particle,
        body,
        other,
        neighbor: neighbor.map_or(particle, |j| j as usize),
        overlap: overlap.to_double(),
        deepest: deepest.to_double(),
    }
}
