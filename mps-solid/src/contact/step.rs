//! Moving bodies together.

use super::{Contact, ContactError, Elastic};
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;

impl<T: Real, const D: usize> Contact<T, D> {
    /// Moves all bodies by `dt` \[s\] in `substeps` equal sub-steps under contact, the `external` force on every
    /// particle of body number 0, 1, ... \[N\], held constant (an empty slice for none), and gravity \[m/s^2\].
    ///
    /// A sub-step is half a kick by contact, a sub-step of every body, and the other half by the new
    /// contact forces: symplectic and second order, like those of the bodies.
    ///
    /// # Errors
    /// If the bodies are not those that were added, an argument is unusable, a body cannot go on, or one has passed
    /// through another.
    pub fn advance<'a>(
        &mut self,
        parallel: &Parallel,
        bodies: &mut [&mut dyn Elastic<T, D>],
        external: impl Fn(usize) -> &'a [Vector<T, D>],
        gravity: &Vector<T, D>,
        dt: T,
        substeps: usize,
    ) -> Result<(), ContactError> {
        self.check(bodies)?;
        if substeps == 0 {
            return Err(ContactError::Parameter { name: "substeps", must: "at least 1", value: 0.0 });
        }
        let step = dt / T::of(substeps as f64);
        self.update(parallel, |body| bodies[body].positions())?;
        for _ in 0..substeps {
            self.kick(parallel, bodies, step)?;
            for (body, elastic) in bodies.iter_mut().enumerate() {
                let len = self.members[body].volume.len();
                let given = external(body);
                let force = if given.is_empty() { &self.no_force[..len] } else { given };
                elastic
                    .advance(parallel, force, gravity, step)
                    .map_err(|source| ContactError::Body { body, source })?;
            }
            self.update(parallel, |body| bodies[body].positions())?;
            self.kick(parallel, bodies, step)?;
        }
        Ok(())
    }

    /// Largest stable sub-step in the current state \[s\], with the safety factors of the bodies and of contact.
    ///
    /// Where bodies may touch before they are searched again, `1/dt^2` is the sum of that of the body and that of
    /// contact, which bounds the largest frequency of the whole.
    ///
    /// # Errors
    /// If the bodies are not those that were added.
    pub fn max_step(
        &self,
        parallel: &Parallel,
        bodies: &[&mut dyn Elastic<T, D>],
    ) -> Result<T, ContactError> {
        self.check(bodies)?;
        let most = T::of(f64::from(f32::MAX));
        let alone = bodies.iter().fold(most, |least, body| least.min(body.max_step(parallel)));
        let near = self.pairings.iter().filter(|pairing| pairing.is_near() || !self.updated);
        let rate2 = near.fold(T::zero(), |most, pairing| most.max(pairing.rate2));
        let together = T::one() / (alone * alone) + rate2 / (T::of(4.0) * self.config.cfl * self.config.cfl);
        Ok(T::one() / together.sqrt())
    }

    fn check(&self, bodies: &[&mut dyn Elastic<T, D>]) -> Result<(), ContactError> {
        let (got, expected) = (bodies.len(), self.members.len());
        if got == expected { Ok(()) } else { Err(ContactError::Bodies { got, expected }) }
    }

    /// Half a kick of `step` \[s\].
    fn kick(
        &self,
        parallel: &Parallel,
        bodies: &mut [&mut dyn Elastic<T, D>],
        step: T,
    ) -> Result<(), ContactError> {
        let half = step * T::of(0.5);
        for (body, (elastic, member)) in bodies.iter_mut().zip(&self.members).enumerate() {
            if member.pushed {
                elastic
                    .kick(parallel, &member.force, half)
                    .map_err(|source| ContactError::Body { body, source })?;
            }
        }
        Ok(())
    }
}
