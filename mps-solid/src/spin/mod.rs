//! The rotation-aware scheme of Tavakoli et al. 2026 as they print it, with the factors put right.
//!
//! Every particle carries an angle `theta_i` and a spin `omega_i` besides its place and velocity. Pairs are
//! compared with the reference state turned by `theta_ij = (theta_i + theta_j)/2` (eqs. 28-30),
//!
//! ```text
//! d_ij = r_ij - R(theta_ij) r0_ij,    tr_i = (D/n_i) sum_j (d_ij . e_ij)/|r0_ij| W0_ij          (eqs. 34, 35)
//! du_i/dt  = (1/rho) sum_j [ lambda (tr_i + tr_j) e_ij/|r0_ij| + 4 mu d_ij/r0_ij^2 ] (D/n_i) W0_ij   (eqs. 37, 38)
//! I domega_i/dt = -m (mu/rho) (2 D/n_i) sum_j r_ij x (R_ij r0_ij)/r0_ij^2 W0_ij,   I = m l0^2/6    (eq. 39)
//! ```
//!
//! with the number density `n_i` of the neighbours a particle really has. Printed, eqs. 37 to 39 lack a factor of
//! two and eq. 39 the mass; eq. 35 takes the absolute value of a stretch that has to be signed.
//!
//! This is here to be compared with [`Solid`](crate::Solid), not to be used: it converges with first order only, and
//! because a pair divides by `n_i` from one end and by `n_j` from the other, it keeps neither momentum nor
//! energy at surfaces. [`Normalization::Shared`] is the same scheme as the gradient of one energy, which keeps both and is stiffer
//! still. The example `spin` measures both.
//! In two dimensions, as printed.

mod config;
mod forces;

pub use config::{Normalization, SpinConfig};

use crate::materials::Moduli;
use crate::preparation::{check_step, prepare};
use crate::{SolidError, SolidParticles};
use mps_kernel::{Kernel, ParticleStore, Real, Vector};
use mps_neighbors::{FrozenPairs, Parallel};

/// Energy of a [`SpinSolid`] \[J per metre of depth\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpinEnergy<T> {
    /// `sum_i m_i |u_i|^2/2 + I_i omega_i^2/2`.
    pub kinetic: T,
    /// `sum_i V_i [ lambda/2 tr_i^2 + mu (D/n_i) sum_j |d_ij|^2/r0_ij^2 W0_ij ]`.
    pub strain: T,
}

/// An elastic body whose particles spin.
#[derive(Clone, Debug)]
pub struct SpinSolid<T: Real> {
    particles: SolidParticles<T, 2>,
    angle: Vec<T>,
    spin: Vec<T>,
    torque: Vec<T>,
    trace: Vec<T>,
    inverse_density: Vec<T>,
    pairs: FrozenPairs<T, 2>,
    moduli: Moduli<T>,
    spacing: T,
    wave_speed: T,
    config: SpinConfig<T>,
}

impl<T: Real> SpinSolid<T> {
    /// Builds the body, see [`Solid::new`](crate::Solid::new).
    ///
    /// # Errors
    /// If there is no particle, a number is out of range, two particles coincide or one has no neighbour.
    pub fn new(
        mut particles: SolidParticles<T, 2>,
        spacing: Vector<T, 2>,
        density: T,
        moduli: Moduli<T>,
        kernel: impl Kernel<T>,
        config: SpinConfig<T>,
        parallel: &Parallel,
    ) -> Result<Self, SolidError> {
        config.validate()?;
        let pairs = prepare(&mut particles, &spacing, density, &kernel, config.radius_ratio)?;
        let len = particles.len();
        if let Some(i) = (0..len).find(|&i| pairs.row(i).is_empty()) {
            let position = particles.reference[i].iter().map(|x| x.to_double()).collect();
            return Err(SolidError::Alone { id: particles.id[i], position });
        }
        let density_of =
            |i| pairs.row(i).iter().fold(T::zero(), |n, pair| n + pair.over_r2 * pair.r0_ij.norm_squared());
        let zeros = vec![T::zero(); len];
        let mut solid = Self {
            inverse_density: (0..len).map(|i| T::one() / density_of(i)).collect(),
            angle: zeros.clone(),
            spin: zeros.clone(),
            torque: zeros.clone(),
            trace: zeros,
            pairs,
            moduli,
            spacing: (spacing.x * spacing.y).sqrt(),
            wave_speed: ((moduli.lambda + moduli.mu * T::of(2.0)) / density).sqrt(),
            config,
            particles,
        };
        solid.rates(parallel);
        Ok(solid)
    }

    /// Moves the body by `dt` \[s\] in `substeps` sub-steps of velocity Verlet under the external force on every particle
    /// \[N\] and gravity \[m/s^2\].
    ///
    /// # Errors
    /// If `dt`, `substeps` or the length of `force` is unusable, or a place is no longer finite.
    pub fn advance(
        &mut self,
        parallel: &Parallel,
        force: &[Vector<T, 2>],
        gravity: &Vector<T, 2>,
        dt: T,
        substeps: usize,
    ) -> Result<(), SolidError> {
        check_step(self.particles.len(), force, dt, substeps)?;
        let step = dt / T::of(substeps as f64);
        let half = step * T::of(0.5);
        for _ in 0..substeps {
            self.kick(parallel, force, gravity, half);
            self.drift(parallel, step);
            self.rates(parallel);
            self.kick(parallel, force, gravity, half);
        }
        match self.particles.position.iter().position(|x| !x.iter().all(|x| x.is_finite())) {
            Some(i) => {
                let position = self.particles.position[i].iter().map(|x| x.to_double()).collect();
                Err(SolidError::NotFinite { id: self.particles.id[i], position })
            }
            None => Ok(()),
        }
    }

    /// Largest sub-step \[s\], `cfl l0/(c_p + v)`.
    pub fn max_step(&self, parallel: &Parallel) -> T {
        let velocity = &self.particles.velocity;
        let fastest = parallel.max(velocity.len(), T::zero(), |i| velocity[i].norm_squared()).sqrt();
        self.config.cfl * self.spacing / (self.wave_speed + fastest)
    }

    /// The particles.
    pub fn particles(&self) -> &SolidParticles<T, 2> {
        &self.particles
    }

    /// Velocities to start from \[m/s\].
    pub fn velocities_mut(&mut self) -> &mut [Vector<T, 2>] {
        &mut self.particles.velocity
    }

    /// Angles by which the particles have turned \[rad\].
    pub fn angles(&self) -> &[T] {
        &self.angle
    }

    /// Spins \[rad/s\].
    pub fn spins(&self) -> &[T] {
        &self.spin
    }

    /// Moves every particle to `place(X)` and turns it by `angle` \[rad\].
    pub fn place(&mut self, parallel: &Parallel, place: impl Fn(&Vector<T, 2>) -> Vector<T, 2>, angle: T) {
        let SolidParticles { reference, position, .. } = &mut self.particles;
        position.iter_mut().zip(reference).for_each(|(x, reference)| *x = place(reference));
        self.angle.fill(angle);
        self.rates(parallel);
    }

    /// Spins to start from \[rad/s\].
    pub fn spins_mut(&mut self) -> &mut [T] {
        &mut self.spin
    }
}
