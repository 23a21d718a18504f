//! The solid and its step.

use crate::kinematics::{corrections, deformation_gradient};
use crate::momentum::InnerStress;
use crate::preparation::{check_material, check_step, prepare};
use crate::stabilization::bending_coefficient;
use crate::supports::{Motion, Placement};
use crate::undo::Before;
use crate::{ConstitutiveModel, SolidConfig, SolidError, SolidParticles};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Clock, Kernel, ParticleStore, Real, Tensor, Vector};
use mps_neighbors::{FrozenPairs, Parallel};

/// An elastic body of particles.
///
/// `M` is the material, `K` the weight of the reference pairs.
#[derive(Clone, Debug)]
pub struct Solid<T, const D: usize, M, K = WendlandC2>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
{
    pub(crate) particles: SolidParticles<T, D>,
    pub(crate) history: Vec<M::History>,
    pub(crate) material: M,
    pub(crate) pairs: FrozenPairs<T, D>,
    pub(crate) correction: Vec<Tensor<T, D>>,
    pub(crate) kappa: T,
    pub(crate) kernel: K,
    pub(crate) config: SolidConfig<T>,
    pub(crate) spacing: Vector<T, D>,
    pub(crate) wave_speed: T,
    pub(crate) stability_limit: T,
    pub(crate) mean_velocity: Vec<Vector<T, D>>,
    /// What of the way of each particle is less than the last place of its position \[m\].
    pub(crate) remainder: Vec<Vector<T, D>>,
    pub(crate) time: Clock<T>,
    pub(crate) motions: Vec<Motion<T, D>>,
    pub(crate) placements: Vec<Placement<T, D>>,
    /// Forces and deformations do not belong to the positions (someone has written to the store).
    pub(crate) stale: bool,
    // Working space of a step.
    pub(crate) inner: Vec<InnerStress<T, D>>,
    pub(crate) before: Before<T, D, M::History>,
    pub(crate) remembered: Before<T, D, M::History>,
    pub(crate) next: Vec<Vector<T, D>>,
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// Builds the body: reference pairs, corrections, masses.
    ///
    /// `spacing` is the particle distance along each axis \[m\], `density` the mass per reference volume
    /// \[kg/m^3\].
    ///
    /// # Errors
    /// If there is no particle, a number is out of range, the moduli of the material are those of none, two particles coincide or the body is thinner
    /// than two particles somewhere.
    pub fn new(
        mut particles: SolidParticles<T, D>,
        spacing: Vector<T, D>,
        density: T,
        material: M,
        kernel: K,
        config: SolidConfig<T>,
        parallel: &Parallel,
    ) -> Result<Self, SolidError> {
        config.validate()?;
        let pairs = prepare(&mut particles, &spacing, density, &kernel, config.radius_ratio)?;
        check_material(&material, density)?;
        let len = particles.len();
        let correction = corrections(&particles, &pairs)?;
        let kappa = bending_coefficient(&material, &kernel, &spacing, config.radius_ratio)?
            * config.bending_correction;
        let no_stress = InnerStress { a: Tensor::zeros(), spring: T::zero() };
        let mut solid = Self {
            history: vec![M::History::default(); len],
            wave_speed: material.wave_speed(density),
            stability_limit: T::zero(),
            mean_velocity: vec![Vector::zeros(); len],
            remainder: vec![Vector::zeros(); len],
            time: Clock::default(),
            motions: Vec::new(),
            placements: Vec::new(),
            inner: vec![no_stress; len],
            before: Before::with_room(len),
            remembered: Before::with_room(0),
            next: particles.position.clone(),
            stale: true,
            particles,
            material,
            pairs,
            correction,
            kappa,
            kernel,
            config,
            spacing,
        };
        solid.remeasure_stability(parallel)?;
        Ok(solid)
    }

    /// Moves the body by `dt` \[s\] in `substeps` equal sub-steps under the external force on every
    /// particle \[N\], held constant, and gravity \[m/s^2\].
    ///
    /// A sub-step is velocity Verlet: half a kick, drift, forces, half a kick; the two half kicks
    /// between sub-steps are one. It is symplectic and second order. `dt / substeps` should not exceed
    /// [`max_step`](Self::max_step); this is not enforced, so that the border can be studied.
    ///
    /// # Errors
    /// If `dt`, `substeps` or the length of `force` is unusable, or if a particle is turned inside out or stops being
    /// finite. The error then has the particle and its place, and the body is as it was before the call, so that a
    /// caller may write it out, or try again with shorter sub-steps or a smaller load.
    pub fn advance(
        &mut self,
        parallel: &Parallel,
        force: &[Vector<T, D>],
        gravity: &Vector<T, D>,
        dt: T,
        substeps: usize,
    ) -> Result<(), SolidError> {
        check_step(self.len(), force, dt, substeps)?;
        if self.stale {
            self.refresh(parallel)?;
        }
        self.keep();
        match self.move_by(parallel, force, gravity, dt, substeps) {
            Ok(()) => Ok(()),
            Err(error) => Err(self.take_back(parallel, error)),
        }
    }

    fn move_by(
        &mut self,
        parallel: &Parallel,
        force: &[Vector<T, D>],
        gravity: &Vector<T, D>,
        dt: T,
        substeps: usize,
    ) -> Result<(), SolidError> {
        let step = dt / T::of(substeps as f64);
        let half = step * T::of(0.5);
        let begin = self.time;
        let go = |solid: &mut Self, substep: usize| {
            solid.time = begin.after(step * T::of(substep as f64));
            solid.place_supports(solid.time.now());
        };
        go(self, 1);
        self.kick_and_drift(parallel, force, gravity, half, step);
        for substep in 1..substeps {
            self.stress(parallel, step)?;
            go(self, substep + 1);
            self.force_kick_and_drift(parallel, force, gravity, step);
        }
        self.stress(parallel, step)?;
        self.forces(parallel);
        self.kick_and_drift(parallel, force, gravity, half, T::zero());

        let (position, remainder, before) = (&self.particles.position, &self.remainder, &self.before);
        parallel.update(self.mean_velocity.as_mut_slice(), |i, mean| {
            *mean = (position[i] - before.position[i] + (remainder[i] - before.remainder[i])) / dt;
        });
        Ok(())
    }

    /// Changes velocities by the impulse `force dt` \[N s\] on every particle, all at once.
    ///
    /// For a force that depends on the position of the body and is known at the start of a sub-step only:
    /// given before [`advance`](Self::advance) it is one more kick of the symplectic step, while the same
    /// force held over the sub-step would lag behind the motion and feed vibrations.
    ///
    /// # Errors
    /// If `dt` or the length of `force` is unusable.
    pub fn kick(&mut self, parallel: &Parallel, force: &[Vector<T, D>], dt: T) -> Result<(), SolidError> {
        check_step(self.len(), force, dt, 1)?;
        let mut velocity = core::mem::take(&mut self.particles.velocity);
        let particles = &self.particles;
        parallel.update(velocity.as_mut_slice(), |i, u| {
            *u += particles.only_free(i, force[i] * (dt / particles.mass[i]));
        });
        self.particles.velocity = velocity;
        Ok(())
    }

    /// Brings deformations and internal forces up to date with positions that were set from outside.
    /// [`advance`](Self::advance) does so by itself.
    ///
    /// # Errors
    /// If a particle is turned inside out or not finite.
    pub fn refresh(&mut self, parallel: &Parallel) -> Result<(), SolidError> {
        self.stress(parallel, T::zero())?;
        self.forces(parallel);
        self.stale = false;
        Ok(())
    }

    /// `F_i` of the current positions, computed anew.
    pub(crate) fn deformation_of(&self, i: usize) -> Tensor<T, D> {
        deformation_gradient(self.pairs.row(i), &self.correction[i], i, &self.particles.position)
    }
}
