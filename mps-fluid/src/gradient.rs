//! The gradient of the velocity, measured on request.

use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::operators::{Corrected, MomentMatrix, invert_moment};
use mps_kernel::small::outer;
use mps_kernel::{Kernel, Neighborhood, Real, Tensor, Vector};
use mps_neighbors::{Domain, Parallel};

/// Below this measure of the moment matrix a particle has too few neighbours for a gradient.
const DEGENERATE: f64 = 0.05;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Gradient of the velocity \[1/s\] of every particle, corrected by the moment matrix of its fluid neighbours (eqs. 21, 22): entry
    /// `(a, b)` is the derivative of component `a` along axis `b`. Zero for spray. The neighbours are those of the last step.
    pub fn velocity_gradient(&self, parallel: &Parallel, gradient: &mut Vec<Tensor<T, D>>) {
        gradient.resize(self.particles.position.len(), Tensor::zeros());
        let velocity = &self.particles.velocity;
        let known = self.search.fluid.len() == velocity.len();
        let view = self.view(&self.search.fluid);
        let factor = self.reference.gradient_factor::<D>();
        parallel.update(gradient.as_mut_slice(), |i, gradient| {
            let (mut slope, mut moment) = (Tensor::<T, D>::zeros(), Tensor::<T, D>::zeros());
            if known {
                view.for_each(i, |pair| {
                    slope += outer(&(velocity[pair.j] - velocity[i]), &pair.gradient_vector());
                    moment += MomentMatrix::<T>::pair(pair);
                });
            }
            let corrected: Corrected<T, D> = invert_moment(&(moment * factor), T::of(DEGENERATE));
            let row = |component: usize| -> Vector<T, D> {
                corrected.corrected_or_zero(&(slope.row(component).transpose() * factor))
            };
            for component in 0..D {
                gradient.set_row(component, &row(component).transpose());
            }
        });
    }
}
