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
    /// If the bodies are not those that were added, an argument is unusable, bodies overlap before they were ever moved, a body cannot go on, or one has
    /// passed through another. All bodies are then as they were before the call.
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
        self.check_arguments(&external, dt, substeps)?;
        self.update(parallel, |body| bodies[body].positions())?;
        self.check_start()?;
        bodies.iter_mut().for_each(|body| body.remember());
        let step = dt / T::of(substeps as f64);
        let moved = (0..substeps).try_for_each(|_| self.substep(parallel, bodies, &external, gravity, step));
        if let Err(error) = moved {
            bodies.iter_mut().for_each(|body| body.go_back(parallel));
            // The forces go back as well. If even these positions are refused the next call says so again.
            return match self.update(parallel, |body| bodies[body].positions()) {
                Ok(()) | Err(_) => Err(error),
            };
        }
        self.begun = self.members.len();
        Ok(())
    }

    fn substep<'a>(
        &mut self,
        parallel: &Parallel,
        bodies: &mut [&mut dyn Elastic<T, D>],
        external: &impl Fn(usize) -> &'a [Vector<T, D>],
        gravity: &Vector<T, D>,
        step: T,
    ) -> Result<(), ContactError> {
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
        self.kick(parallel, bodies, step)
    }

    pub(super) fn check(&self, bodies: &[&mut dyn Elastic<T, D>]) -> Result<(), ContactError> {
        let (got, expected) = (bodies.len(), self.members.len());
        if got == expected { Ok(()) } else { Err(ContactError::Bodies { got, expected }) }
    }

    fn check_arguments<'a>(
        &self,
        external: &impl Fn(usize) -> &'a [Vector<T, D>],
        dt: T,
        substeps: usize,
    ) -> Result<(), ContactError> {
        if substeps == 0 {
            return Err(ContactError::Parameter { name: "substeps", must: "at least 1", value: 0.0 });
        }
        if !(dt.is_finite() && dt > T::zero()) {
            let value = dt.to_double();
            return Err(ContactError::Parameter { name: "dt", must: "positive and finite", value });
        }
        for (body, member) in self.members.iter().enumerate() {
            let (got, particles) = (external(body).len(), member.volume.len());
            if got != 0 && got != particles {
                return Err(ContactError::Length { body, name: "external force", got, particles });
            }
        }
        Ok(())
    }

    /// Bodies that have not been moved together yet must not overlap.
    fn check_start(&self) -> Result<(), ContactError> {
        for pairing in &self.pairings {
            let [body, other] = pairing.bodies();
            let largest = pairing.touch * self.config.initial_overlap;
            if other >= self.begun && pairing.overlap > largest {
                let (overlap, largest) = (pairing.overlap.to_double(), largest.to_double());
                return Err(ContactError::Overlap { body, other, overlap, largest });
            }
        }
        Ok(())
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
