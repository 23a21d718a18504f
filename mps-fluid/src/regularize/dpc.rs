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
use crate::gather::Gather;
use crate::terms::Viscosity;
use fearless_simd::Simd;
use mps_kernel::small::{accumulate, components, difference, dot, scale, vector};
use mps_kernel::weights::Rational;
use mps_kernel::{Kernel, Lanes, Number, Real, Vector, by_axis};
use mps_neighbors::{Domain, Parallel, RowView, Sweep};

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

/// `w(l0/20)`: bounds `chi_ij` where the push would grow without limit.
const NEAREST: f64 = 19.0;

/// Corrects the velocities of the fluid.
pub(crate) fn collide<T, const D: usize, K, V, P>(fluid: &mut Fluid<T, D, K, V, P>, parallel: &Parallel)
where
    T: Real,
    K: Kernel<T>,
    V: Viscosity<T, D>,
    P: Domain<T, D>,
{
    let Some(dpc) = fluid.config.collisions else { return };
    let mut change = core::mem::take(&mut fluid.rates.correction);
    change.resize(fluid.particles.position.len(), Vector::zeros());
    let mut load = core::mem::take(&mut fluid.rates.density_rate);
    if dpc.repulsion > T::zero() {
        exchange(&Exchange::<_, D, _, true>::new(fluid, dpc), parallel, &mut change, &mut load);
    } else {
        exchange(&Exchange::<_, D, _, false>::new(fluid, dpc), parallel, &mut change, &mut load);
    }
    parallel.update(fluid.particles.velocity.as_mut_slice(), |i, u| *u += change[i]);
    fluid.rates.correction = change;
    fluid.rates.density_rate = load;
}

/// Changes of all velocities \[m/s\]; `load` is overwritten.
fn exchange<T: Real, const D: usize, P: Domain<T, D>, const PUSHED: bool>(
    exchange: &Exchange<'_, T, D, P, PUSHED>,
    parallel: &Parallel,
    change: &mut [Vector<T, D>],
    load: &mut [T],
) {
    parallel.sweep((&mut *change, &mut *load), exchange);
    let heaviest = parallel.max(load.len(), T::zero(), |i| load[i]);
    if heaviest > T::one() {
        // Rare: some particle is pushed from several sides at once.
        parallel.update(&mut *load, |_, load| *load = T::one() / load.max(T::one()));
        parallel.sweep(change, &Limited { exchange, limit: load });
    }
}

/// The close pairs of the fluid, and what they exchange in a step.
struct Exchange<'a, T: Real, const D: usize, P, const PUSHED: bool> {
    /// With the rational weight of radius `l0`, whose root is `chi_ij = sqrt(w(r)/w(l0/2))`, as `w(l0/2) = 1`.
    close: RowView<'a, T, D, Rational, P>,
    velocity: &'a [Vector<T, D>],
    pressure: &'a [T],
    /// `a_ij` times the share of the exchange that is due in a step.
    share: T,
    /// Square of the distance below which two particles are in the same place, and have no line to exchange momentum along \[m^2\].
    coincident: T,
    /// `lambda dt/rho0`.
    push: T,
    /// Largest sum of two pressures that the push follows \[Pa\].
    ceiling: T,
}

impl<'a, T: Real, const D: usize, P: Domain<T, D>, const PUSHED: bool> Exchange<'a, T, D, P, PUSHED> {
    fn new<K: Kernel<T>, V: Viscosity<T, D>>(fluid: &'a Fluid<T, D, K, V, P>, dpc: Dpc<T>) -> Self {
        let (config, particles) = (&fluid.config, &fluid.particles);
        let RowView { rows, points, targets, domain, .. } = fluid.view(&fluid.search.close);
        let passed = (config.sound_speed * fluid.last_dt / config.spacing).min(T::one());
        Self {
            close: RowView { rows, points, targets, domain, kernel: Rational, radius: config.spacing },
            velocity: &particles.velocity,
            pressure: &particles.pressure,
            share: (T::one() + dpc.restitution) * T::of(0.5) * passed,
            coincident: config.spacing * config.spacing * T::of(1e-20),
            push: dpc.repulsion * fluid.last_dt / config.density,
            ceiling: dpc.ceiling * config.density * config.sound_speed * config.sound_speed,
        }
    }

    /// Velocity change of particle `i` \[m/s\] and its load `sum k_ij a_ij c dt/l0`, with the exchange of each pair times what
    /// `limit` has for it.
    #[inline(always)]
    fn change<S: Simd>(
        &self,
        simd: S,
        i: usize,
        limit: impl Fn(&[usize]) -> T::Lanes<S>,
    ) -> (Vector<T, D>, T) {
        let zero = T::Lanes::splat(simd, T::zero());
        let (mut change, mut load) = (vector([zero; D]), zero);
        for pair in self.close.packs(simd, i) {
            let j = pair.j.as_ref();
            let other = Gather { simd, j, from: self.velocity };
            let approach = dot(&difference(&other.vector(|u| u), &self.velocity[i]), &pair.r_ij);
            // Whatever a neighbour out of range carries, infinity and NaN included.
            let approach = approach.where_below(-pair.weight, T::zero());
            // Not the bounded distance of the pair: closer pairs exchange no less.
            let inverse_r2 = dot(&pair.r_ij, &pair.r_ij).at_least(self.coincident).dividing(T::one());
            let share = pair.weight.at_most(T::one()).root() * self.share;
            load += share.where_below(approach, T::zero());
            // Chosen last: pairs that part exchange nothing, not even a NaN.
            let mut along = (share * limit(j) * approach * inverse_r2).where_below(approach, T::zero());
            if PUSHED {
                let sum = other.of(self.pressure).scalar(|p| *p) + self.pressure[i];
                let background = (sum.at_least(T::zero()) - sum.at_most(T::zero())).at_most(self.ceiling);
                let chi = pair.weight.at_most(T::of(NEAREST)).root();
                let push = chi * background * inverse_r2 * self.push;
                along -= push - push.where_below(approach, T::zero());
            }
            accumulate(&mut change, &scale(&pair.r_ij, along));
        }
        (by_axis!(axis => components(&change)[axis].sum()), load.sum())
    }
}

impl<'b, T: Real, const D: usize, P: Domain<T, D>, const PUSHED: bool>
    Sweep<(&'b mut [Vector<T, D>], &'b mut [T])> for Exchange<'_, T, D, P, PUSHED>
{
    #[inline(always)]
    fn visit<S: Simd>(&self, simd: S, i: usize, (change, load): (&'b mut Vector<T, D>, &'b mut T)) {
        (*change, *load) = self.change(simd, i, |_| T::Lanes::splat(simd, T::one()));
    }
}

/// The exchange with `s_ij`.
struct Limited<'a, 'b, T: Real, const D: usize, P, const PUSHED: bool> {
    exchange: &'a Exchange<'b, T, D, P, PUSHED>,
    /// `s_i`.
    limit: &'a [T],
}

impl<'b, T: Real, const D: usize, P: Domain<T, D>, const PUSHED: bool> Sweep<&'b mut [Vector<T, D>]>
    for Limited<'_, '_, T, D, P, PUSHED>
{
    #[inline(always)]
    fn visit<S: Simd>(&self, simd: S, i: usize, change: &'b mut Vector<T, D>) {
        let limit = |j: &[usize]| T::Lanes::gather(simd, |lane| self.limit[j[lane]]).at_most(self.limit[i]);
        *change = self.exchange.change(simd, i, limit).0;
    }
}
