//! The interface inside a step: how the pressure answers while a structure takes its sub-steps.
//!
//! A structure vibrates faster than the fluid steps. A fluid force held over the whole step would lag
//! behind that motion by half a step and feed every mode the fluid acts on as a spring, at the rate
//! `kappa dt/4` (`kappa`: stiffness of the compressed fluid per mass of structure). So the particles
//! that see the structure are compressed by its motion as it goes:
//!
//! `dp_i = - rho0 c^2 (2 D/n0) sum_a V_a (u_a - u_i) . e_ia W_ia/r dt_S`
//!
//! with geometry and fluid velocity of the start of the step: the boundary's part of eq. 23. The
//! structure feels `p_i + dp_i` in every sub-step, the fluid the mean of it over the step, pair by
//! pair the same impulse. The pressure is that of the start of the sub-step, so the structure has to be kicked by it
//! before it moves; held over the sub-step it would lag once more (`docs/coupling.md`). At the end the continuity equation, closed with the structure's mean
//! velocity, finds the same compression.
//!
//! Shear by viscosity follows in the same way: `K_ia (u_a - u_i)` is linear in the velocity of the point, and `K_ia` times what has changed of it since the
//! start of the step goes to both sides. Held over the step, the drag on a vibration comes half a period late and drives it.

mod spring;

use crate::boundary::Shear;
use crate::eos::EquationOfState;
use crate::terms::Viscosity;
use crate::{Fluid, Push, Tension};
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Tensor, Vector};
use mps_neighbors::{Domain, Parallel};

/// One pair across the interface: the other side's index and `V_a e_ia W_ia/r` \[1/m\].
#[derive(Clone, Copy, Debug)]
struct Link<T: Real, const D: usize> {
    other: u32,
    vector: Vector<T, D>,
}

/// The pairs across the interface in the present step, from both sides.
#[derive(Clone, Debug, Default)]
pub(crate) struct Exchange<T: Real, const D: usize> {
    /// Fluid particles that see a structure.
    wetted: Vec<u32>,
    /// For each of them, where its links begin; one more entry than `wetted`.
    wetted_start: Vec<u32>,
    wetted_links: Vec<Link<T, D>>,
    /// For each reactive point, where its links begin; one more entry than points.
    point_start: Vec<u32>,
    point_links: Vec<Link<T, D>>,
    /// Place of a fluid particle in `wetted`; meaningful for those only.
    place: Vec<u32>,
    /// Sum of the lengths of a wetted particle's links \[1/m\].
    reach: Vec<T>,
    /// Pressure before clipping and its rise since the start of the step \[Pa\].
    raw: Vec<T>,
    rise: Vec<T>,
    /// Effective change of pressure in the present sub-step, and its sum over the step \[Pa\].
    change: Vec<T>,
    sum: Vec<T>,
    substeps: usize,
    /// `K_ia` of every link of both lists \[1/s\]; empty without shear.
    wetted_drag: Vec<Tensor<T, D>>,
    point_drag: Vec<Tensor<T, D>>,
    /// Velocities of the points that the forces of the step were found with, and the sum over the sub-steps of what they differed by
    /// \[m/s\].
    shown: Vec<Vector<T, D>>,
    slide: Vec<Vector<T, D>>,
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Collects the pairs across the interface at the start of a step.
    pub(crate) fn prepare_exchange(&mut self) {
        let reactive = self.boundary.reactive();
        let mut exchange = core::mem::take(&mut self.exchange);
        exchange.clear();
        if !reactive.is_empty() {
            let sheared = self.boundary.shear[reactive.clone()]
                .iter()
                .any(|shear| matches!(shear, Shear::Wall | Shear::Fluid));
            let sheared = sheared && self.viscosity.kinematic() > T::zero();
            self.link_wetted(&mut exchange, sheared);
            self.link_points(&mut exchange, sheared);
            if sheared {
                exchange.shown.extend_from_slice(&self.boundary.velocity[reactive.clone()]);
                exchange.slide.resize(reactive.len(), Vector::zeros());
            }
        }
        self.exchange = exchange;
    }

    fn link_wetted(&self, exchange: &mut Exchange<T, D>, sheared: bool) {
        let reactive = self.boundary.reactive();
        let view = self.boundary_view();
        exchange.place.resize(self.particles.position.len(), 0);
        for i in 0..self.particles.position.len() {
            // Rows ascend, and structures come after the walls.
            if self.search.boundary.row(i).last().is_none_or(|&a| (a as usize) < reactive.start) {
                continue;
            }
            let before = exchange.wetted_links.len();
            view.for_each(i, |pair| {
                if pair.j >= reactive.start && pair.weight > T::zero() {
                    let vector = self.corrected(i, pair.gradient_vector() * self.boundary.volume[pair.j]);
                    let other = (pair.j - reactive.start) as u32;
                    exchange.wetted_links.push(Link { other, vector });
                    if sheared {
                        exchange.wetted_drag.push(self.drag_of(i, pair));
                    }
                }
            });
            if exchange.wetted_links.len() > before {
                exchange.place[i] = exchange.wetted.len() as u32;
                exchange.wetted.push(i as u32);
                exchange.wetted_start.push(before as u32);
                exchange.raw.push(self.eos.pressure(self.particles.density[i]));
                let links = &exchange.wetted_links[before..];
                exchange.reach.push(links.iter().fold(T::zero(), |size, link| size + link.vector.norm()));
            }
        }
        let wetted = exchange.wetted.len();
        exchange.wetted_start.push(exchange.wetted_links.len() as u32);
        for field in [&mut exchange.rise, &mut exchange.change, &mut exchange.sum] {
            field.resize(wetted, T::zero());
        }
    }

    fn link_points(&self, exchange: &mut Exchange<T, D>, sheared: bool) {
        let view =
            mps_neighbors::RowView { points: &self.boundary.position, ..self.view(&self.search.reaction) };
        for a in self.boundary.reactive() {
            exchange.point_start.push(exchange.point_links.len() as u32);
            view.for_each(a, |pair| {
                if pair.weight > T::zero() {
                    // Seen from the point, r_ai = -r_ia.
                    let vector = self.corrected(pair.j, -pair.gradient_vector() * self.boundary.volume[a]);
                    let other = exchange.place[pair.j];
                    exchange.point_links.push(Link { other, vector });
                    if sheared {
                        let seen = Pair { j: a, r_ij: -pair.r_ij, ..*pair };
                        exchange.point_drag.push(self.drag_of(pair.j, &seen));
                    }
                }
            });
        }
        exchange.point_start.push(exchange.point_links.len() as u32);
    }

    /// `K_ia` of a pair seen from fluid particle `i` \[1/s\]: its shear is this times the difference of the velocities.
    fn drag_of(&self, i: usize, pair: &Pair<T, D>) -> Tensor<T, D> {
        let share = self.wall_shear().share(i, pair);
        let mut drag = Tensor::<T, D>::zeros();
        for axis in 0..D {
            let mut along = Vector::<T, D>::zeros();
            along[axis] = share;
            drag.set_column(axis, &self.viscosity.pair(pair, &Vector::zeros(), &along));
        }
        drag
    }

    /// Force \[N\] on reactive point `a` in the present sub-step: that of the start of the step and
    /// the change of pressure since. Zero for points of walls, whose forces are not found, and for points that there are not.
    pub fn force_on(&self, a: usize) -> Vector<T, D> {
        let exchange = &self.exchange;
        let Some(k) = self.reactive_number(a) else { return Vector::zeros() };
        let mut sum = Vector::zeros();
        if exchange.point_start.len() > k + 1 {
            let links = exchange.point_start[k] as usize..exchange.point_start[k + 1] as usize;
            for link in &exchange.point_links[links] {
                sum += link.vector * exchange.change[link.other as usize];
            }
        }
        let factor = T::of(2.0) * self.reference.gradient_factor::<D>() * self.config.particle_volume();
        self.boundary.force.get(a).map_or(Vector::zeros(), |force| force + sum * factor - self.shear_on(a, k))
    }

    /// Number of boundary point `a` among the reactive ones, if it is one.
    fn reactive_number(&self, a: usize) -> Option<usize> {
        let reactive = self.boundary.reactive();
        reactive.contains(&a).then(|| a - reactive.start)
    }

    /// What the shear on reactive point `a`, number `k`, has changed by since the start of the step, as a force on the fluid \[N\].
    fn shear_on(&self, a: usize, k: usize) -> Vector<T, D> {
        let Some(shown) = self.exchange.shown.get(k) else { return Vector::zeros() };
        let change = self.boundary.velocity[a] - shown;
        let links = self.exchange.point_start[k] as usize..self.exchange.point_start[k + 1] as usize;
        let drag =
            self.exchange.point_drag[links].iter().fold(Vector::zeros(), |sum, drag| sum + drag * change);
        drag * self.config.particle_mass()
    }

    /// Takes note of the velocities that the structures have at the start of a sub-step, which are those of their boundary points now: the
    /// forces of the sub-step follow them, and so will the reaction.
    pub fn follow_shear(&mut self) {
        let Exchange { shown, slide, .. } = &mut self.exchange;
        let velocity = &self.boundary.velocity[self.boundary.reactive().start..];
        for ((slide, shown), now) in slide.iter_mut().zip(&*shown).zip(velocity) {
            *slide += now - shown;
        }
    }

    /// Compresses the particles at the interface by the motion of the structures over a sub-step of
    /// `dt` \[s\], whose mean velocities are those of the reactive boundary points.
    pub fn compress_interface(&mut self, parallel: &Parallel, dt: T) {
        let Exchange { wetted, wetted_start, wetted_links, raw, rise, change, sum, substeps, .. } =
            &mut self.exchange;
        *substeps += 1;
        let (wetted, starts, links, raw) = (&*wetted, &*wetted_start, &*wetted_links, &*raw);
        let (u, p) = (&self.particles.velocity, &self.particles.pressure);
        let first = self.boundary.reactive().start;
        let velocity = &self.boundary.velocity[first..];
        let config = &self.config;
        let stiffness = config.density * config.sound_speed * config.sound_speed;
        let factor = -stiffness * T::of(2.0) * self.reference.gradient_factor::<D>() * dt;
        let clip = config.tension == Tension::Clip;
        let fields = (rise.as_mut_slice(), change.as_mut_slice(), sum.as_mut_slice());
        parallel.update(fields, |k, (rise, change, sum)| {
            let i = wetted[k] as usize;
            *sum += *change;
            let mut rate = T::zero();
            for link in &links[starts[k] as usize..starts[k + 1] as usize] {
                rate += (velocity[link.other as usize] - u[i]).dot(&link.vector);
            }
            *rise += factor * rate;
            let pressure = raw[k] + *rise;
            *change = if clip { pressure.max(T::zero()) } else { pressure } - p[i];
        });
    }

    /// Adds the mean change of pressure over the sub-steps to the accelerations of the fluid: the
    /// reaction to what the structures have felt.
    pub(crate) fn finish_exchange(&mut self) {
        for k in 0..self.exchange.answered() {
            let [pressure, shear] = self.reaction_since(k);
            let acceleration = &mut self.rates.acceleration[self.exchange.wetted[k] as usize];
            *acceleration += pressure;
            *acceleration += shear;
        }
    }

    /// Acceleration of wetted particle number `k` by what pressure and shear have each changed by since the start of the step, mean over the
    /// sub-steps \[m/s^2\].
    fn reaction_since(&self, k: usize) -> [Vector<T, D>; 2] {
        let exchange = &self.exchange;
        let substeps = T::of(exchange.substeps as f64);
        let factor = -T::of(2.0) * self.reference.gradient_factor::<D>() / (self.config.density * substeps);
        let links = exchange.wetted_start[k] as usize..exchange.wetted_start[k + 1] as usize;
        let sum = exchange.wetted_links[links.clone()].iter().fold(Vector::zeros(), |sum, l| sum + l.vector);
        let pressure = sum * (exchange.sum[k] * factor);
        if exchange.slide.is_empty() {
            return [pressure, Vector::zeros()];
        }
        let pairs = exchange.wetted_links[links.clone()].iter().zip(&exchange.wetted_drag[links]);
        let shear =
            pairs.fold(Vector::zeros(), |sum, (link, drag)| sum + drag * exchange.slide[link.other as usize]);
        [pressure, shear / substeps]
    }

    /// The velocity of boundary point `a` with which the shear of the step was found \[m/s\].
    pub(crate) fn shown_velocity(&self, a: usize) -> Vector<T, D> {
        let shown = a.checked_sub(self.boundary.reactive.start).and_then(|k| self.exchange.shown.get(k));
        shown.copied().unwrap_or(self.boundary.velocity[a])
    }

    /// Acceleration of particle `i` by what the structures have changed since the start of the step \[m/s^2\]: zero before the first sub-step.
    pub(crate) fn answer_to(&self, i: usize) -> Vector<T, D> {
        let wetted = &self.exchange.wetted[..self.exchange.answered()];
        // They were collected in ascending order.
        wetted.binary_search(&(i as u32)).map_or(Vector::zeros(), |k| {
            let [pressure, shear] = self.reaction_since(k);
            pressure + shear
        })
    }

    /// What the structures have done to the fluid in the sub-steps so far beyond [`push_by_structures`](Fluid::push_by_structures), mean
    /// over the sub-steps, about `center` \[m\].
    pub fn push_since(&self, center: &Vector<T, D>) -> Push<T, D> {
        let mass = self.config.particle_mass();
        (0..self.exchange.answered()).fold(Push::default(), |sum, k| {
            let arm = self.particles.position[self.exchange.wetted[k] as usize] - center;
            let [pressure, shear] = self.reaction_since(k);
            sum + Push::at(&arm, &((pressure + shear) * mass))
        })
    }

    /// Power \[W\] of the mean change of pressure over the sub-steps at the mean velocities of the structures.
    pub(crate) fn exchange_work(&self) -> T {
        let exchange = &self.exchange;
        if exchange.substeps == 0 {
            return T::zero();
        }
        let factor = -T::of(2.0) * self.reference.gradient_factor::<D>() * self.config.particle_volume()
            / T::of(exchange.substeps as f64);
        let velocity = &self.boundary.velocity[self.boundary.reactive().start..];
        (0..exchange.wetted.len()).fold(T::zero(), |power, k| {
            let links = exchange.wetted_start[k] as usize..exchange.wetted_start[k + 1] as usize;
            let carried: T = exchange.wetted_links[links]
                .iter()
                .fold(T::zero(), |sum, l| sum + l.vector.dot(&velocity[l.other as usize]));
            power + carried * exchange.sum[k] * factor
        })
    }
}

impl<T: Real, const D: usize> Exchange<T, D> {
    /// Number of particles that have an answer: none before the first sub-step.
    fn answered(&self) -> usize {
        if self.substeps == 0 { 0 } else { self.wetted.len() }
    }

    fn clear(&mut self) {
        self.wetted.clear();
        self.wetted_start.clear();
        self.wetted_links.clear();
        self.reach.clear();
        self.point_start.clear();
        self.point_links.clear();
        for field in [&mut self.raw, &mut self.rise, &mut self.change, &mut self.sum] {
            field.clear();
        }
        for field in [&mut self.wetted_drag, &mut self.point_drag] {
            field.clear();
        }
        for field in [&mut self.shown, &mut self.slide] {
            field.clear();
        }
        self.substeps = 0;
    }
}
