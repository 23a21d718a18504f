//! Walls that move as they are told.

use super::vector;
use core::ops::Range;
use mps_fluid::Boundary;
use mps_io::scene_file::{Motion, Oscillation, Steady};
use mps_kernel::{Real, Vector};

/// A wall and its motion.
#[derive(Clone, Debug)]
pub(super) struct Mover<T: Real, const D: usize> {
    motion: Motion,
    /// Its points among those of the boundary.
    range: Range<usize>,
    /// Velocity in the present step \[m/s\].
    velocity: Vector<T, D>,
}

impl<T: Real, const D: usize> Mover<T, D> {
    pub(super) fn new(motion: &Motion, range: Range<usize>) -> Self {
        Self { motion: motion.clone(), range, velocity: Vector::zeros() }
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
                [vector(velocity) * if moves { T::one() } else { T::zero() }, Vector::zeros()]
            }
            Motion::Oscillation(Oscillation { amplitude, period }) => {
                let omega = core::f64::consts::TAU / period;
                let amplitude: Vector<T, D> = vector(amplitude);
                let speed = 0.5 * omega * (omega * (time + 0.5 * last)).sin();
                let change = 0.5 * omega * omega * (omega * time).cos();
                [amplitude * T::of(speed), amplitude * T::of(change)]
            }
        };
        self.velocity = velocity;
        boundary.velocity[self.range.clone()].fill(velocity);
        boundary.acceleration[self.range.clone()].fill(acceleration);
    }

    /// After a step of `dt` \[s\]: the places.
    pub(super) fn move_on(&self, boundary: &mut Boundary<T, D>, dt: T) {
        let by = self.velocity * dt;
        boundary.position[self.range.clone()].iter_mut().for_each(|r| *r += by);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mps_fluid::Slip;

    type Plane = Vector<f64, 2>;

    /// Where a wall that starts at the origin is after steps of uneven length until `end` \[s\].
    fn place(motion: &Motion, end: f64) -> Plane {
        let mut boundary = Boundary::default();
        boundary.add_wall(&[Plane::zeros(); 3], Slip::Free);
        let mut mover = Mover::new(motion, 1..2);
        let (mut time, mut last, mut k) = (0.0, 0.0, 0_u32);
        while time < end {
            mover.show(&mut boundary, time, last);
            last = (1e-3 + 2e-4 * f64::from(k % 5)).min(end - time);
            mover.move_on(&mut boundary, last);
            (time, k) = (time + last, k + 1);
        }
        assert_eq!([boundary.position[0], boundary.position[2]], [Plane::zeros(); 2]);
        boundary.position[1]
    }

    #[test]
    fn walls_are_where_they_were_told_to_be() {
        let steady = Motion::Steady(Steady { velocity: vec![0.5, -2.0], until: Some(0.3) });
        // The last step begins before the end and is taken whole.
        assert!((place(&steady, 1.0) - Plane::from([0.15, -0.6])).norm() < 2e-3 * 2.1);
        let wave = Motion::Oscillation(Oscillation { amplitude: vec![0.2, 0.0], period: 0.8 });
        for (time, x) in [(0.2, 0.1), (0.4, 0.2), (0.6, 0.1), (0.8, 0.0), (4.0, 0.0)] {
            assert!((place(&wave, time) - Plane::from([x, 0.0])).norm() < 2e-4, "{time}");
        }
    }
}
