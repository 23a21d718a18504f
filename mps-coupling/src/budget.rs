//! What crosses the interface: impulse and work, and how exactly the two sides agree.

use mps_kernel::{Real, Vector};

/// Sums over all steps so far (per metre of depth in 2D).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget<T: Real, const D: usize> {
    /// Impulse handed to the structures \[N s\].
    pub impulse: Vector<T, D>,
    /// Work done on the structures at the shared interface velocity \[J\].
    pub work: T,
    /// Largest relative difference found between the force on the structures and its reaction on
    /// the fluid, each summed on its own side.
    pub residual: T,
    /// How often the two sides have been compared.
    pub audits: u64,
}

impl<T: Real, const D: usize> Default for Budget<T, D> {
    fn default() -> Self {
        Self { impulse: Vector::zeros(), work: T::zero(), residual: T::zero(), audits: 0 }
    }
}

impl<T: Real, const D: usize> Budget<T, D> {
    /// Books one step.
    pub(crate) fn book(&mut self, force: &[Vector<T, D>], velocity: &[Vector<T, D>], dt: T) {
        for (f, v) in force.iter().zip(velocity) {
            self.impulse += f * dt;
            self.work += f.dot(v) * dt;
        }
    }

    /// Compares the force gathered by the structures with the force on the fluid, relative to the
    /// sum of the forces' absolute values.
    pub(crate) fn audit(&mut self, on_structures: &[Vector<T, D>], on_fluid: Vector<T, D>) {
        let (mut sum, mut size) = (Vector::<T, D>::zeros(), T::zero());
        for f in on_structures {
            sum += f;
            size += f.norm();
        }
        if size > T::zero() {
            self.residual = self.residual.max((sum + on_fluid).norm() / size);
        }
        self.audits += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impulse_and_work_add_up() {
        let mut budget = Budget::<f64, 2>::default();
        let force = [Vector::from([1.0, 0.0]), Vector::from([0.0, 2.0])];
        let velocity = [Vector::from([3.0, 9.0]), Vector::from([9.0, -1.0])];
        budget.book(&force, &velocity, 0.5);
        budget.book(&force, &velocity, 0.5);
        assert_eq!((budget.impulse, budget.work), (Vector::from([1.0, 2.0]), 1.0));
    }

    #[test]
    fn an_audit_keeps_the_worst_residual_relative_to_the_forces() {
        let mut budget = Budget::<f64, 2>::default();
        let pushed = [Vector::from([3.0, 0.0]), Vector::from([-1.0, 0.0])];
        budget.audit(&pushed, Vector::from([-2.0, 0.0]));
        assert_eq!(budget.residual, 0.0);
        budget.audit(&pushed, Vector::from([-2.0, 0.4]));
        assert!((budget.residual - 0.1).abs() < 1e-15);
        budget.audit(&pushed, Vector::from([-2.0, 0.0]));
        budget.audit(&[Vector::zeros()], Vector::zeros());
        assert!((budget.residual - 0.1).abs() < 1e-15 && budget.audits == 4);
    }
}
