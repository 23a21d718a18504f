//! Who enters and who leaves.

use super::OpenBoundaries;
use super::outlet::Reach;
use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::{FieldVisitor, Kernel, Neighborhood, ParticleStore, Pod, Real, Vector};
use mps_neighbors::Domain;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Lets particles in and out. Afterwards the neighbour rows have to be rebuilt.
    pub(crate) fn let_pass(&mut self) -> Option<u32> {
        let (depth, spacing) = (self.zone(), self.config.spacing);
        let open = self.open.as_mut()?;
        let before = self.particles.position.len();
        let gone = |place: &Vector<T, D>| {
            let is = |reach| open.outlets.iter().any(|outlet| outlet.reach(place, depth, spacing) == reach);
            is(Reach::Rim) && !is(Reach::Zone)
        };
        let keep: Vec<bool> = self.particles.position.iter().map(|place| !gone(place)).collect();
        let leaving = keep.iter().any(|kept| !kept);
        let first = open.next_id;
        let OpenBoundaries { inlets, next_id, .. } = &mut **open;
        for inlet in inlets.iter() {
            inlet.release(&mut self.boundary, |place, velocity| {
                self.particles.push(place, velocity, T::one(), T::zero(), *next_id);
                *next_id += 1;
            });
        }
        let born = self.particles.position.len() - before;
        if leaving {
            self.particles.for_each_field(&mut Keep(&keep));
            Keep(&keep).visit("packing", &mut self.rates.packing);
            Keep(&keep).visit("asymmetry", &mut self.rates.asymmetry);
        }
        let len = self.particles.position.len();
        open.passed[0] += born as u64;
        open.passed[1] += (before + born - len) as u64;
        self.rates.resize(len);
        Some(first)
    }

    /// Gives particles from `first` on, which have just entered, the density of their neighbours; reference density where there are none yet.
    pub(crate) fn welcome(&mut self, first: u32) {
        let newcomers: Vec<usize> =
            (0..self.particles.id.len()).filter(|i| self.particles.id[*i] >= first).collect();
        for i in newcomers {
            let (mut sum, mut weights) = (T::zero(), T::zero());
            self.view(&self.search.fluid).for_each(i, |pair| {
                if self.particles.id[pair.j] < first {
                    sum += pair.weight * self.particles.density[pair.j];
                    weights += pair.weight;
                }
            });
            if weights > T::zero() {
                self.particles.density[i] = sum / weights;
            }
        }
    }
}

/// Keeps the marked entries of every field, in their order; those beyond the marks as well.
struct Keep<'a>(&'a [bool]);

impl FieldVisitor for Keep<'_> {
    fn visit<F: Pod + Send + Sync>(&mut self, _name: &'static str, field: &mut Vec<F>) {
        let mut marks = self.0.iter();
        field.retain(|_| marks.next().is_none_or(|kept| *kept));
    }
}
