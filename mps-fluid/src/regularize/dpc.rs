//! Dynamic pairwise particle collision (DPC).
//!
//! Jandaghian, Krimi, Zarrati, Shakibaeinia 2021 (J. Comput. Phys. 434:110202): pairs closer than
//! `l0` that approach exchange momentum along their line, pairs that part are pushed by a bounded
//! background pressure:
//!
//! `du_i = sum_j k_ij a_ij (u_ij . e_ij) e_ij - (dt/rho_i) sum_j phi_ij (2 V_j/(V_i+V_j)) pb_ij/|r_ij| e_ij`
//!
//! with `a_ij = (1 + e) m_j/(m_i + m_j)`, here `(1 + e)/2`. The restitution `e` is written out here: `e = 1` is the
//! factor 2 of the printed formula, a fully overlapping pair then bounces elastically; with
//! `e = 0`, the default, it sticks, which dissipates less for the weak overlaps of a regular flow
//! and never overshoots.
//!
//! **The printed exchange is that of a time in which sound passes a spacing**: a step does the share `min(1, c dt/l0)` of it, with the length of
//! the step before. Exchanged in every step, as printed, a flow computed with half the step has twice the collisions, and no limit for
//! short steps (`docs/dam-break.md`).
//!
//! **The push is off by default**: it acts on pairs that part and no others, so that all it can do is give energy (`docs/dam-break.md`).
//!
//! All pairs act at once. Where several neighbours push the same particle the sum of their
//! coefficients is limited to one (`s_ij = min(s_i, s_j)`, `s_i = 1/max(1, sum_j k_ij a_ij)`),
//! which bounds the spectrum of the exchange matrix by 2: the collision part cannot create kinetic
//! energy. Momentum is kept pair by pair.
//!
//! Only fluid particles collide. The pair pressure keeps them out of boundaries; a collision held
//! over a whole fluid step was measured to feed the vibration of a light structure.

use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// Parameters of the collisions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dpc<T> {
    /// Coefficient of restitution `e` \[-\]: 0 sticks, 1 bounces. Default 0.
    pub restitution: T,
    /// `lambda`: background pressure over the pressure of the pair \[-\]. Default 0: pairs that part are not pushed. The push acts on them alone,
    /// so that it gives energy whenever it does anything; 0.1 is usual in print.
    pub repulsion: T,
    /// Largest background pressure over `lambda rho0 c^2` \[-\]. Default 0.02, twice the stagnation
    /// pressure at Mach 0.1.
    pub ceiling: T,
}

impl<T: Real> Default for Dpc<T> {
    fn default() -> Self {
        Self { restitution: T::zero(), repulsion: T::zero(), ceiling: T::of(0.02) }
    }
}

/// One pair inside the collision range.
struct Contact<T: Real, const D: usize> {
    e_ij: Vector<T, D>,
    distance: T,
    /// `k_ij a_ij` if the pair approaches, else 0.
    share: T,
    /// `chi_ij` if the pair parts, else 0.
    parting: T,
    approach: T,
}

impl<T: Real> Dpc<T> {
    /// `None` unless the pair is closer than `l0`.
    #[inline]
    fn contact<const D: usize>(
        &self,
        l0: T,
        r_ij: &Vector<T, D>,
        u_ij: &Vector<T, D>,
    ) -> Option<Contact<T, D>> {
        let r2 = r_ij.norm_squared();
        // Coincident particles have no line to exchange momentum along.
        if !(r2 < l0 * l0 && r2 > T::zero()) {
            return None;
        }
        let distance = r2.sqrt();
        let e_ij = r_ij / distance;
        let approach = u_ij.dot(&e_ij);
        // chi = sqrt(w(r)/w(l0/2)) with the rational weight of radius l0, for which w(l0/2) = 1.
        let chi = (l0 / distance.max(l0 * T::of(0.05)) - T::one()).sqrt();
        let (share, parting) = if approach < T::zero() {
            let k = if distance < l0 * T::of(0.5) { T::one() } else { chi };
            (k * (T::one() + self.restitution) * T::of(0.5), T::zero())
        } else {
            (T::zero(), chi)
        };
        // Pairs that part exchange nothing, not even a NaN one of them may carry.
        Some(Contact { e_ij, distance, share, parting, approach: approach.min(T::zero()) })
    }

    fn background_pressure(&self, sum: T, stiffness: T) -> T {
        (self.repulsion * sum.abs()).min(self.repulsion * self.ceiling * stiffness)
    }
}

/// Corrects the velocities of the fluid.
pub(crate) fn collide<T, const D: usize, K, V, P>(fluid: &mut Fluid<T, D, K, V, P>, parallel: &Parallel)
where
    T: Real,
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    let Some(dpc) = fluid.config.collisions else { return };
    let mut correction = core::mem::take(&mut fluid.rates.correction);
    correction.resize(fluid.particles.position.len(), Vector::zeros());
    let mut scale = core::mem::take(&mut fluid.rates.density_rate);
    let exchange = Exchange { fluid: &*fluid, dpc };
    parallel.update((correction.as_mut_slice(), scale.as_mut_slice()), |i, (du, load)| {
        (*du, *load) = exchange.change(i, None);
    });
    let heaviest = parallel.max(scale.len(), T::zero(), |i| scale[i]);
    if heaviest > T::one() {
        // Rare: some particle is pushed from several sides at once.
        parallel.update(scale.as_mut_slice(), |_, load| *load = T::one() / load.max(T::one()));
        let scale = &scale;
        parallel.update(correction.as_mut_slice(), |i, du| *du = exchange.change(i, Some(scale)).0);
    }
    parallel.update(fluid.particles.velocity.as_mut_slice(), |i, u| *u += correction[i]);

    fluid.rates.correction = correction;
    fluid.rates.density_rate = scale;
}

/// The close pairs of the fluid.
struct Exchange<'a, T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> {
    fluid: &'a Fluid<T, D, K, V, P>,
    dpc: Dpc<T>,
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Exchange<'_, T, D, K, V, P> {
    #[inline]
    fn contact(&self, i: usize, j: usize) -> Option<Contact<T, D>> {
        let particles = &self.fluid.particles;
        let r_ij = self.fluid.domain.separation(&particles.position[i], &particles.position[j]);
        let u_ij = particles.velocity[j] - particles.velocity[i];
        self.dpc.contact(self.fluid.config.spacing, &r_ij, &u_ij)
    }

    /// Velocity change of particle `i` \[m/s\] with the limits `scale`, and its load `sum k_ij a_ij c dt/l0`.
    fn change(&self, i: usize, scale: Option<&[T]>) -> (Vector<T, D>, T) {
        let config = &self.fluid.config;
        let p = &self.fluid.particles.pressure;
        let stiffness = config.density * config.sound_speed * config.sound_speed;
        let per_pressure = self.fluid.last_dt / config.density;
        // The share of the exchange that is due in a step.
        let passed = (config.sound_speed * self.fluid.last_dt / config.spacing).min(T::one());
        let mut change = Vector::zeros();
        let mut load = T::zero();
        for &j in self.fluid.search.close.row(i) {
            let j = j as usize;
            let Some(contact) = self.contact(i, j) else { continue };
            let limit = scale.map_or(T::one(), |s| s[i].min(s[j]));
            let background = contact.parting * self.dpc.background_pressure(p[i] + p[j], stiffness);
            let push = per_pressure * background / contact.distance;
            let share = contact.share * passed;
            change += contact.e_ij * (share * limit * contact.approach - push);
            load += share;
        }
        (change, load)
    }
}
