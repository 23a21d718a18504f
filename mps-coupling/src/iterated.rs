//! Sub-steps repeated until the fluid moves as it was supposed to.

use crate::{CouplingError, Passage, Passed, Scheme};
use mps_kernel::{Real, Vector};

/// The sub-steps are repeated until the velocities that the fluid at the interface is supposed to have are those it gets at the
/// end of the step, with the relaxation of Aitken.
///
/// For light structures in heavy fluid: held at its start, the velocity of the fluid feeds modes in which the fluid is the
/// greater mass and the structure the spring (`docs/coupling.md`). A pass costs the sub-steps of the structures and no sweep over the
/// fluid. How fast it converges depends on the stiffness and the mass of the *fluid* at the interface alone, and that
/// ratio is bounded by the Courant number: unlike with an incompressible fluid there is no density of the structure at
/// which it fails.
#[derive(Clone, Debug, PartialEq)]
pub struct Iterated<T: Real, const D: usize> {
    /// Residual at which the velocities count as found \[-\]. Default 1e-6.
    pub tolerance: T,
    /// Passes at most; the residual left is reported ([`Scene::passed`](crate::Scene::passed)). Default 20.
    pub most: u32,
    found: Vec<Vector<T, D>>,
    /// Found minus supposed, in this pass and in the one before.
    miss: Vec<Vector<T, D>>,
    last_miss: Vec<Vector<T, D>>,
}

impl<T: Real, const D: usize> Default for Iterated<T, D> {
    fn default() -> Self {
        Self { tolerance: T::of(1e-6), most: 20, found: Vec::new(), miss: Vec::new(), last_miss: Vec::new() }
    }
}

impl<T: Real, const D: usize> Iterated<T, D> {
    /// Compares, and returns the residual.
    fn compare(&mut self, passage: &mut dyn Passage<T, D>) -> T {
        core::mem::swap(&mut self.miss, &mut self.last_miss);
        passage.found(&mut self.found);
        self.miss.clear();
        self.miss
            .extend(self.found.iter().zip(&*passage.supposed()).map(|(found, supposed)| found - supposed));
        let size = |field: &[Vector<T, D>]| field.iter().fold(T::zero(), |sum, u| sum + u.norm_squared());
        let (miss, found) = (size(&self.miss), size(&self.found));
        if miss > T::zero() { (miss / found).sqrt() } else { T::zero() }
    }

    /// Aitken's factor from the one before: the secant through the last two misses, as if all of them shrank alike
    /// (Irons and Tuck 1969; Kuettler and Wall 2008, eq. 44).
    fn relaxation(&self, before: T) -> T {
        let (mut along, mut size) = (T::zero(), T::zero());
        for (miss, last) in self.miss.iter().zip(&self.last_miss) {
            let change = miss - last;
            along += last.dot(&change);
            size += change.norm_squared();
        }
        if size > T::zero() { -before * along / size } else { before }
    }
}

impl<T: Real, const D: usize> Scheme<T, D> for Iterated<T, D> {
    fn pass(&mut self, passage: &mut dyn Passage<T, D>) -> Result<Passed<T>, CouplingError> {
        passage.keep()?;
        let mut factor = T::one();
        let mut passes = 1;
        loop {
            passage.advance()?;
            let residual = self.compare(passage);
            if residual <= self.tolerance || passes >= self.most {
                return Ok(Passed { passes, residual });
            }
            if passes > 1 {
                factor = self.relaxation(factor);
            }
            for (supposed, miss) in passage.supposed().iter_mut().zip(&self.miss) {
                *supposed += miss * factor;
            }
            passage.go_back()?;
            passes += 1;
        }
    }
}
