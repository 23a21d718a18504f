//! Walls that move as they are told.

use super::vector;
use core::ops::Range;
use mps_fluid::Boundary;
use mps_io::scene_file::{Motion, Oscillation, Steady};
use mps_kernel::{Real, Vector};

/// A wall and its motion.
#[derive(Clone, Debug)]
pub(super) struct Mover<T: Real> {
    motion: Motion,
    /// Its points among those of the boundary.
    range: Range<usize>,
    /// Velocity in the present step \[m/s\].
    velocity: Vector<T, 2>,
}

impl<T: Real> Mover<T> {
    pub(super) fn new(motion: &Motion, range: Range<usize>) -> Self {
        Self { motion: motion.clone(), range, velocity: Vector::zeros() }
    }

    /// Before a step from `time` \[s\] on: velocity and acceleration that the fluid is shown. The step is expected to be as
    /// long as the `last` one \[s\], and has the velocity of its middle.
    pub(super) fn show(&mut self, boundary: &mut Boundary<T, 2>, time: f64, last: f64) {
        let [velocity, acceleration] = match &self.motion {
            Motion::Steady(Steady { velocity, until }) => {
                let moves = until.is_none_or(|until| time < until);
                [vector(velocity) * if moves { T::one() } else { T::zero() }, Vector::zeros()]
            }
            Motion::Oscillation(Oscillation { amplitude, period }) => {
                let omega = core::f64::consts::TAU / period;
                let amplitude: Vector<T, 2> = vector(amplitude);
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
    pub(super) fn move_on(&self, boundary: &mut Boundary<T, 2>, dt: T) {
        let by = self.velocity * dt;
        boundary.position[self.range.clone()].iter_mut().for_each(|r| *r += by);
    }
}
