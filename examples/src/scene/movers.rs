//! Walls that move as they are told.

use super::vector;
use core::ops::Range;
use mps_fluid::Boundary;
use mps_io::scene_file::{Motion, Oscillation, Steady};
use mps_kernel::{Real, Transfer, Vector};

/// A wall and its motion.
#[derive(Clone, Debug)]
pub(super) struct Mover<T: Real, const D: usize> {
    motion: Motion,
    /// Its points among those of the boundary.
    range: Range<usize>,
    /// Where they are at the start \[m\].
    start: Vec<Vector<T, D>>,
    /// Velocity in the present step \[m/s\].
    velocity: Vector<f64, D>,
    /// How far it has been moved \[m\]: what a step moves may be less than single precision tells places apart.
    moved: Vector<f64, D>,
}

impl<T: Real, const D: usize> Mover<T, D> {
    /// A wall whose points of the boundary have these numbers.
    pub(super) fn new(motion: &Motion, boundary: &Boundary<T, D>, range: Range<usize>) -> Self {
        let start = boundary.position[range.clone()].to_vec();
        Self { motion: motion.clone(), range, start, velocity: Vector::zeros(), moved: Vector::zeros() }
    }

    /// Saves or restores how far it has been moved.
    pub(super) fn transfer(&mut self, transfer: &mut Transfer<'_>) {
        let Self { motion: _, range: _, start: _, velocity: _, moved } = self;
        transfer.array("moved", moved.as_mut_slice());
    }

    /// Its points among those of the boundary.
    pub(super) fn range(&self) -> Range<usize> {
        self.range.clone()
    }

    /// Before a step from `time` \[s\] on: velocity and acceleration that the fluid is shown. The step is expected to be as
    /// long as the `last` one \[s\], and has the velocity of its middle.
    pub(super) fn show(&mut self, boundary: &mut Boundary<T, D>, time: f64, last: f64) {
        let [velocity, acceleration] = match &self.motion {
            Motion::Steady(Steady { velocity, until }) => {
                let moves = until.is_none_or(|until| time < until);
                [vector(velocity) * if moves { 1.0 } else { 0.0 }, Vector::zeros()]
            }
            Motion::Oscillation(Oscillation { amplitude, period }) => {
                let omega = core::f64::consts::TAU / period;
                let amplitude: Vector<f64, D> = vector(amplitude);
                let speed = 0.5 * omega * (omega * (time + 0.5 * last)).sin();
                let change = 0.5 * omega * omega * (omega * time).cos();
                [amplitude * speed, amplitude * change]
            }
        };
        self.velocity = velocity;
        boundary.velocity[self.range.clone()].fill(velocity.map(T::of));
        boundary.acceleration[self.range.clone()].fill(acceleration.map(T::of));
    }

    /// After a step of `dt` \[s\]: the places.
    pub(super) fn move_on(&mut self, boundary: &mut Boundary<T, D>, dt: T) {
        self.moved += self.velocity * dt.to_double();
        for (r, start) in boundary.position[self.range.clone()].iter_mut().zip(&self.start) {
            *r = (start.map(Real::to_double) + self.moved).map(T::of);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mps_fluid::Slip;

    type Plane = Vector<f64, 2>;

    /// How far a wall that starts at `x` \[m\] is moved by steps of uneven length, a hundred of which take `time` \[s\], until `end` \[s\].
    fn moved<T: Real>(motion: &Motion, x: f64, [time, end]: [f64; 2]) -> Plane {
        let mut boundary = Boundary::default();
        let start: Vector<T, 2> = Vector::from([T::of(x), T::zero()]);
        boundary.add_wall(&[start; 3], Slip::Free);
        let mut mover = Mover::new(motion, &boundary, 1..2);
        let (unit, mut now, mut last, mut k) = (time / 140.0, 0.0, 0.0, 0_u32);
        while now < end {
            mover.show(&mut boundary, now, last);
            last = (unit * (1.0 + 0.2 * f64::from(k % 5))).min(end - now);
            mover.move_on(&mut boundary, T::of(last));
            (now, k) = (now + last, k + 1);
        }
        assert_eq!([boundary.position[0], boundary.position[2]], [start; 2]);
        (boundary.position[1] - start).map(Real::to_double)
    }

    #[test]
    fn walls_are_where_they_were_told_to_be() {
        let steady = Motion::Steady(Steady { velocity: vec![0.5, -2.0], until: Some(0.3) });
        // The last step begins before the end and is taken whole.
        let place = |motion: &Motion, end: f64| moved::<f64>(motion, 0.0, [0.14, end]);
        assert!((place(&steady, 1.0) - Plane::from([0.15, -0.6])).norm() < 2e-3 * 2.1);
        let wave = Motion::Oscillation(Oscillation { amplitude: vec![0.2, 0.0], period: 0.8 });
        for (time, x) in [(0.2, 0.1), (0.4, 0.2), (0.6, 0.1), (0.8, 0.0), (4.0, 0.0)] {
            assert!((place(&wave, time) - Plane::from([x, 0.0])).norm() < 2e-4, "{time}");
        }
    }

    /// Far from the origin a step of a slow wall is less than the numbers of single precision tell apart.
    #[test]
    fn slow_walls_keep_their_pace_in_single_precision() {
        let steady = Motion::Steady(Steady { velocity: vec![2e-3, 0.0], until: None });
        for x in [0.0, 1.5, 3.0] {
            let moved = moved::<f32>(&steady, x, [5e-3, 1.0])[0];
            assert!((moved / 2e-3 - 1.0).abs() < 1e-3, "{x} {moved}");
        }
    }
}
