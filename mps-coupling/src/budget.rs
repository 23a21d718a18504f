//! What crosses the interface: impulse, angular impulse and work, each from both sides, and how exactly the sides agree.

use mps_fluid::Push;
use mps_kernel::{Real, Tensor, Vector};

/// What structures have been handed since the start: the sums over all sub-steps, at the places where their points were then
/// (per metre of depth in 2D). In double precision whatever the scene has: in single precision equal shares are lost in the sums after
/// some million sub-steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handed<const D: usize> {
    /// Impulse \[N s\] and angular impulse about [`Budget::center`] \[N m s\].
    pub push: Push<f64, D>,
    /// Work at the shared interface velocity \[J\].
    pub work: f64,
    /// The part of the angular impulse that has no reaction in the fluid \[N m s\]: in its sub-steps a point moves off the lines of the
    /// start of the step, along which its pairs act (`docs/coupling.md`).
    pub off_line: Tensor<f64, D>,
    /// Sum of the sizes of all impulses \[N s\] and of their moments \[N m s\]: what a defect is measured against.
    pub size: [f64; 2],
}

impl<const D: usize> Default for Handed<D> {
    fn default() -> Self {
        Self { push: Push::default(), work: 0.0, off_line: Tensor::zeros(), size: [0.0; 2] }
    }
}

/// One sub-step of a structure, seen point by point.
pub(crate) struct SubStep<'a, T: Real, const D: usize> {
    pub(crate) force: &'a [Vector<T, D>],
    /// Mean velocities over the sub-step.
    pub(crate) velocity: &'a [Vector<T, D>],
    /// Positions at its end, and at the start of the step of the fluid.
    pub(crate) position: &'a [Vector<T, D>],
    pub(crate) start: &'a [Vector<T, D>],
    pub(crate) dt: T,
}

impl<const D: usize> Handed<D> {
    pub(crate) fn book<T: Real>(&mut self, center: &Vector<T, D>, step: &SubStep<'_, T, D>) {
        let double = |vector: &Vector<T, D>| vector.map(T::to_double);
        let (center, dt) = (double(center), step.dt.to_double());
        let mut sum = Self::default();
        let points = step.force.iter().zip(step.velocity).zip(step.position.iter().zip(step.start));
        for ((f, v), (end, start)) in points {
            let (v, start) = (double(v), double(start));
            let impulse = double(f) * dt;
            // The force acts before the point moves.
            let place = double(end) - v * dt;
            let push = Push::at(&(place - center), &impulse);
            sum.push += push;
            sum.work += impulse.dot(&v);
            sum.off_line += Push::at(&(place - start), &impulse).moment;
            sum.size[0] += impulse.norm();
            sum.size[1] += push.moment.norm();
        }
        self.push += sum.push;
        self.work += sum.work;
        self.off_line += sum.off_line;
        self.size[0] += sum.size[0];
        self.size[1] += sum.size[1];
    }
}

/// Sums over all steps and structures so far (per metre of depth in 2D).
#[derive(Clone, Debug, PartialEq)]
pub struct Budget<T: Real, const D: usize> {
    /// The point that moments are taken about \[m\]: the origin, or that of [`Scene::keep_books`](crate::Scene::keep_books).
    pub center: Vector<T, D>,
    /// What each structure has been handed.
    pub handed: Vec<Handed<D>>,
    /// What the fluid has received from the structures, summed on its own side of the pairs, while the books are kept.
    pub fluid: Option<Push<f64, D>>,
    /// Largest relative difference found between the force on the structures and its reaction on
    /// the fluid, each summed on its own side.
    pub residual: T,
    /// How often the two sides have been compared.
    pub audits: u64,
}

impl<T: Real, const D: usize> Default for Budget<T, D> {
    fn default() -> Self {
        Self { center: Vector::zeros(), handed: Vec::new(), fluid: None, residual: T::zero(), audits: 0 }
    }
}

impl<T: Real, const D: usize> Budget<T, D> {
    /// Impulse handed to all structures \[N s\].
    pub fn impulse(&self) -> Vector<f64, D> {
        self.handed.iter().fold(Vector::zeros(), |sum, handed| sum + handed.push.force)
    }

    /// Work done on all structures \[J\].
    pub fn work(&self) -> f64 {
        self.handed.iter().fold(0.0, |sum, handed| sum + handed.work)
    }

    /// How far what the structures were handed and what the fluid received are apart; `None` unless the books are kept.
    pub fn closure(&self) -> Option<Closure> {
        Some(Closure::of(&self.fluid?, &self.handed))
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

/// How far the two sides of the interface are apart, over what has crossed it; zero but for round-off where nothing is lost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Closure {
    /// Of the momentum: what the structures were handed and the fluid received.
    pub momentum: f64,
    /// Of the angular momentum, with the part that moves off the lines of the pairs taken for its cause.
    pub angular: f64,
    /// That part itself: by how much the angular momentum of fluid and structures together has changed.
    pub off_line: f64,
}

impl Closure {
    /// Of all structures against the fluid.
    fn of<const D: usize>(fluid: &Push<f64, D>, structures: &[Handed<D>]) -> Self {
        let (mut sum, mut off_line, mut size) = (*fluid, Tensor::<f64, D>::zeros(), [0.0; 2]);
        for handed in structures {
            sum += handed.push;
            off_line += handed.off_line;
            size = [size[0] + handed.size[0], size[1] + handed.size[1]];
        }
        let over = |defect: f64, size: f64| if size > 0.0 { defect / size } else { defect };
        Self {
            momentum: over(sum.force.norm(), size[0]),
            angular: over((sum.moment - off_line).norm(), size[1]),
            off_line: over(off_line.norm(), size[1]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impulse_moment_and_work_add_up() {
        let mut handed = Handed::<2>::default();
        let force = [Vector::from([1.0, 0.0]), Vector::from([0.0, 2.0])];
        let velocity = [Vector::from([3.0, 9.0]), Vector::from([9.0, -1.0])];
        // Both begin the sub-step at (1, 1) and the step at the origin.
        let position = velocity.map(|v: Vector<f64, 2>| Vector::from([1.0, 1.0]) + v * 0.5);
        let start = [Vector::zeros(); 2];
        let step =
            SubStep { force: &force, velocity: &velocity, position: &position, start: &start, dt: 0.5 };
        handed.book(&Vector::from([0.0, 0.5]), &step);
        handed.book(&Vector::from([0.0, 0.5]), &step);
        assert_eq!((handed.push.force, handed.work), (Vector::from([1.0, 2.0]), 1.0));
        assert_eq!((handed.push.moment[(0, 1)], handed.push.moment[(1, 0)]), (1.5, -1.5));
        assert_eq!((handed.off_line[(0, 1)], handed.size[0]), (1.0, 3.0));
    }

    /// A tenth is no number of single precision, and in its sums a million of them are a hundredth off.
    #[test]
    fn a_million_equal_shares_are_a_million_times_one() {
        const TIMES: u32 = 1_000_000;
        let share = [Vector::<f32, 2>::from([0.1, 0.0])];
        let place = [Vector::<f32, 2>::from([1.0, 1.0])];
        let step = SubStep { force: &share, velocity: &share, position: &place, start: &place, dt: 1.0 };
        let mut handed = Handed::<2>::default();
        (0..TIMES).for_each(|_| handed.book(&Vector::zeros(), &step));
        let whole = f64::from(TIMES) * f64::from(0.1_f32);
        let sums = [handed.push.force.x, handed.size[0], handed.work * 10.0, -handed.push.moment[(0, 1)]];
        for sum in sums {
            assert!((sum / whole - 1.0).abs() < 1e-6, "{sums:?}");
        }
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

    #[test]
    fn what_is_lost_between_the_sides_is_seen() {
        let handed = Handed::<2> {
            push: Push::at(&Vector::from([2.0, 0.0]), &Vector::from([0.0, 1.0])),
            size: [1.0, 4.0],
            ..Handed::default()
        };
        let closure = |arm: f64, force: f64| {
            let fluid = Push::at(&Vector::from([arm, 0.0]), &Vector::from([0.0, force]));
            let Closure { momentum, angular, .. } = Closure::of(&fluid, &[handed]);
            [momentum, angular]
        };
        assert_eq!(closure(2.0, -1.0), [0.0, 0.0]);
        assert_eq!(closure(4.0, -0.5), [0.5, 0.0]);
        assert!(closure(1.0, -1.0)[0] == 0.0 && closure(1.0, -1.0)[1] > 0.3);
    }
}
