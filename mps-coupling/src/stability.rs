//! How long sub-steps may be for the compressed fluid at the surface of a structure.
//!
//! Within a step the fluid answers the motion of a structure as a spring `K` ([`Fluid::interface_stiffness`]), which the structure does not
//! know of when it names its own limit. Together they are stable while `h^2 (omega^2 + lambda) < 4`, with the largest `lambda` of `K` over the
//! inertia, `omega` the largest frequency of the structure. Solids of `mps-solid` stay at 0.8 of their own border,
//! `(h omega/2)^2 <= 0.64`, which leaves `(h/2)^2 lambda <= 0.36` for the fluid.
//!
//! The velocity of the fluid is held over the step besides, and a free body that swings by more than half a turn on that spring meanwhile
//! grows, whatever its sub-steps. Nothing is done about that: shorter steps cure it without a spring of its own and feed others with one. Both
//! are measured in `docs/coupling.md`, and concern bodies far lighter than a layer of fluid particles.

use crate::scene::Body;
use crate::{Inertia, Scene};
use mps_fluid::{Fluid, Viscosity};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Domain;

/// Share of [`Scene::interface_border`] that a sub-step may take.
const MARGIN: f64 = 0.6;

impl<T: Real, const D: usize> Body<T, D> {
    /// Bound of `lambda`, the square of the frequency on the spring of the fluid \[1/s^2\]; zero if the inertia is unknown.
    fn rate<K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(&self, fluid: &Fluid<T, D, K, V, P>) -> T {
        let points = self.range.clone().zip(&self.interface.visible);
        match self.structure.inertia() {
            Inertia::Unknown => T::zero(),
            Inertia::Rigid(mass) => fluid.interface_stiffness_of(&self.range) / mass,
            Inertia::Points(masses) => points.fold(T::zero(), |most, (a, &i)| {
                // Masses are looked at before a step (`guard.rs`), but anybody may ask for the border.
                let mass = masses.get(i as usize).copied().unwrap_or(T::of(f64::NAN));
                let rate = fluid.interface_stiffness(a) / mass;
                // Not `max`, which would hide a rate that is no number.
                if rate < most { most } else { rate }
            }),
        }
    }

    /// `2/sqrt(lambda)` \[s\].
    fn border<K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>>(&self, fluid: &Fluid<T, D, K, V, P>) -> T {
        T::of(2.0) / self.rate(fluid).sqrt()
    }
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Scene<T, D, K, V, P> {
    /// Where the spring of the fluid at the surface of structure number `index` ends the stability of a sub-step, `2/sqrt(lambda)` \[s\], as
    /// of the last step; infinite where no fluid is or the structure does not say its [`Inertia`].
    ///
    /// Sub-steps are not longer than 0.6 of it, besides the structure's own limit and [`min_substeps`](Self::min_substeps). As
    /// estimates of the rule of the fluid over a body of mass `m`: its stiffness on the fluid alone is `4 m / border^2`, and
    /// `m (step / border)^2` is the mass that a body would need to take the step with a single sub-step.
    pub fn interface_border(&self, index: usize) -> Option<T> {
        self.bodies.get(index).map(|body| body.border(&self.fluid))
    }

    /// Longest sub-step that the fluid leaves a body \[s\].
    pub(crate) fn longest_substep(&self, body: &Body<T, D>) -> T {
        body.border(&self.fluid) * T::of(MARGIN)
    }
}
