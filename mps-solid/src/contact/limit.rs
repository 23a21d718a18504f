//! The largest stable sub-step of bodies in contact.

use super::{Contact, ContactError, Elastic};
use mps_kernel::Real;
use mps_neighbors::Parallel;

impl<T: Real, const D: usize> Contact<T, D> {
    /// Largest stable sub-step in the current state \[s\], with the safety factors of the bodies and of contact.
    ///
    /// Where particles of two bodies, or of one that is folded, are near, `1/dt^2` is the sum of that of the body and that of
    /// contact, which bounds the largest frequency of the whole. Finds the forces too, as [`update`](Self::update) does.
    ///
    /// # Errors
    /// If the bodies are not those that were added, one has no usable step of its own, a position is not finite, or one surface has passed
    /// through another.
    pub fn max_step(
        &mut self,
        parallel: &Parallel,
        bodies: &[&mut dyn Elastic<T, D>],
    ) -> Result<T, ContactError> {
        self.check(bodies)?;
        let mut alone = T::of(f64::from(f32::MAX));
        for (body, elastic) in bodies.iter().enumerate() {
            let step = elastic.max_step(parallel);
            let value = step.to_double();
            // Written so that NaN is refused too.
            if !(value > 0.0 && value.is_finite()) {
                return Err(ContactError::Step { body, value });
            }
            alone = alone.min(step);
        }
        self.update(parallel, |body| bodies[body].positions())?;
        let mut rate2 = T::zero();
        for pairing in &self.pairings {
            let places = pairing.bodies().map(|body| bodies[body].positions());
            if pairing.is_near(parallel, places) {
                rate2 = rate2.max(pairing.rate2);
            }
        }
        let together = T::one() / (alone * alone) + rate2 / (T::of(4.0) * self.config.cfl * self.config.cfl);
        Ok(T::one() / together.sqrt())
    }
}
