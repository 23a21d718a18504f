//! What crosses the interface: impulse, angular impulse and work, each from both sides, and how exactly the sides agree.

use mps_fluid::Push;
use mps_kernel::{Real, Tensor, Vector};

/// What structures have been handed since the start: the sums over all sub-steps, at the places where their points were then
/// (per metre of depth in 2D).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handed<T: Real, const D: usize> {
    /// Impulse \[N s\] and angular impulse about [`Budget::center`] \[N m s\].
    pub push: Push<T, D>,
    /// Work at the shared interface velocity \[J\].
    pub work: T,
    /// The part of the angular impulse that has no reaction in the fluid \[N m s\]: in its sub-steps a point moves off the lines of the
    /// start of the step, along which its pairs act (`docs/coupling.md`).
    pub off_line: Tensor<T, D>,
    /// Sum of the sizes of all impulses \[N s\] and of their moments \[N m s\]: what a defect is measured against.
    pub size: [T; 2],
}

impl<T: Real, const D: usize> Default for Handed<T, D> {
    fn default() -> Self {
        let zero = T::zero();
        Self { push: Push::default(), work: zero, off_line: Tensor::zeros(), size: [zero; 2] }
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

impl<T: Real, const D: usize> Handed<T, D> {
    pub(crate) fn book(&mut self, center: &Vector<T, D>, step: &SubStep<'_, T, D>) {
        // Added up before it goes to the sums since the start: beside those the share of a single point is lost in single precision.
        let mut sum = Self::default();
        let points = step.force.iter().zip(step.velocity).zip(step.position.iter().zip(step.start));
        for ((f, v), (end, start)) in points {
            let impulse = f * step.dt;
            // The force acts before the point moves.
            let place = end - v * step.dt;
            let push = Push::at(&(place - center), &impulse);
            sum.push += push;
            sum.work += impulse.dot(v);
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
    pub handed: Vec<Handed<T, D>>,
    /// What the fluid has received from the structures, summed on its own side of the pairs, while the books are kept.
    pub fluid: Option<Push<T, D>>,
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
    pub fn impulse(&self) -> Vector<T, D> {
        self.handed.iter().fold(Vector::zeros(), |sum, handed| sum + handed.push.force)
    }

    /// Work done on all structures \[J\].
    pub fn work(&self) -> T {
        self.handed.iter().fold(T::zero(), |sum, handed| sum + handed.work)
    }

    /// How far what the structures were handed and what the fluid received are apart; `None` unless the books are kept.
    pub fn closure(&self) -> Option<Closure<T>> {
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
pub struct Closure<T> {
    /// Of the momentum: what the structures were handed and the fluid received.
    pub momentum: T,
    /// Of the angular momentum, with the part that moves off the lines of the pairs taken for its cause.
    pub angular: T,
    /// That part itself: by how much the angular momentum of fluid and structures together has changed.
    pub off_line: T,
}

impl<T: Real> Closure<T> {
    /// Of all structures against the fluid.
    fn of<const D: usize>(fluid: &Push<T, D>, structures: &[Handed<T, D>]) -> Self {
        let (mut sum, mut off_line, mut size) = (*fluid, Tensor::<T, D>::zeros(), [T::zero(); 2]);
        for handed in structures {
            sum += handed.push;
            off_line += handed.off_line;
            size = [size[0] + handed.size[0], size[1] + handed.size[1]];
        }
        let over = |defect: T, size: T| if size > T::zero() { defect / size } else { defect };
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
        let mut handed = Handed::<f64, 2>::default();
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

    #[test]
    fn many_small_shares_are_not_lost_beside_what_was_handed_before() {
        const POINTS: usize = 1000;
        // Half of the last place of one: alone it would vanish beside it.
        let share = 0.4 * f32::EPSILON;
        let of = |count: usize, x: f32| {
            (vec![Vector::from([x, 0.0]); count], vec![Vector::from([1.0, 0.0]); count])
        };
        let places = vec![Vector::from([1.0, 1.0]); POINTS];
        let mut handed = Handed::<f32, 2>::default();
        for (force, velocity) in [of(1, 1.0), of(POINTS, share)] {
            let count = force.len();
            let step = SubStep {
                force: &force,
                velocity: &velocity,
                position: &places[..count],
                start: &places[..count],
                dt: 1.0,
            };
            handed.book(&Vector::zeros(), &step);
        }
        let gained = POINTS as f32 * share;
        let sums = [
            handed.push.force.x,
            handed.work,
            handed.push.moment[(0, 1)].abs(),
            handed.size[0],
            handed.size[1],
        ];
        for (sum, first) in sums.into_iter().zip([1.0, 1.0, 1.0, 1.0, handed.size[1] / (1.0 + gained)]) {
            assert!(((sum - first) / gained - 1.0).abs() < 0.01, "{sums:?}");
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
        let handed = Handed::<f64, 2> {
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
