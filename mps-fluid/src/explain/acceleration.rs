//! The terms of the momentum sweep.

use crate::Fluid;
use crate::terms::Viscosity;
use mps_kernel::operators::ConservativeGradient;
use mps_kernel::{Kernel, Neighborhood, Pair, Real, Vector};
use mps_neighbors::Domain;

/// The terms of an acceleration \[m/s^2\] (eqs. 18, 24, 25); their sum is what moves the particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationTerms<T: Real, const D: usize> {
    /// Pressure between fluid particles.
    pub pressure: Vector<T, D>,
    /// Pressure of the walls, with the guard that keeps spray out.
    pub wall_pressure: Vector<T, D>,
    /// Pressure of the structures, likewise.
    pub structure_pressure: Vector<T, D>,
    /// Viscosity between fluid particles.
    pub viscosity: Vector<T, D>,
    /// Shear of walls without slip or with a law of the wall.
    pub wall_shear: Vector<T, D>,
    /// Shear of structures, likewise.
    pub structure_shear: Vector<T, D>,
    /// Gravity.
    pub gravity: Vector<T, D>,
    /// What pressure and shear of the structures have changed by in their sub-steps so far.
    pub substeps: Vector<T, D>,
    /// From outside ([`Fluid::add_acceleration`]) and by outlets; round-off without them.
    pub outside: Vector<T, D>,
}

impl<T: Real, const D: usize> AccelerationTerms<T, D> {
    /// All terms with their names.
    pub fn terms(&self) -> [(&'static str, Vector<T, D>); 9] {
        [
            ("pressure", self.pressure),
            ("pressure of walls", self.wall_pressure),
            ("pressure of structures", self.structure_pressure),
            ("viscosity", self.viscosity),
            ("shear of walls", self.wall_shear),
            ("shear of structures", self.structure_shear),
            ("gravity", self.gravity),
            ("sub-steps of structures", self.substeps),
            ("from outside", self.outside),
        ]
    }

    /// Sum of all terms.
    pub fn total(&self) -> Vector<T, D> {
        self.terms().iter().fold(Vector::zeros(), |sum, (_, term)| sum + term)
    }
}

/// Who a neighbour is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Other {
    /// The fluid particle with this number.
    Fluid(u32),
    /// The boundary point with this index, of a wall.
    Wall(usize),
    /// The boundary point with this index, of a structure.
    Structure(usize),
}

/// A neighbour as the particle sees it, and what it does to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neighbor<T: Real, const D: usize> {
    /// Who it is.
    pub other: Other,
    /// How far away \[m\].
    pub distance: T,
    /// Where, seen from the particle \[m\].
    pub offset: Vector<T, D>,
    /// Velocity \[m/s\].
    pub velocity: Vector<T, D>,
    /// Density ratio, of a boundary point the one it shows \[-\].
    pub density: T,
    /// Pressure, likewise \[Pa\].
    pub pressure: T,
    /// Acceleration of the particle by the pressure of the pair \[m/s^2\].
    pub push: Vector<T, D>,
    /// Acceleration of the particle by the shear of the pair \[m/s^2\].
    pub shear: Vector<T, D>,
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    pub(super) fn acceleration_terms(&self, i: usize) -> (AccelerationTerms<T, D>, Vec<Neighbor<T, D>>) {
        let mut neighbors = self.pushed_by_fluid(i);
        neighbors.extend(self.pushed_by_boundary(i));
        let zero = Vector::zeros();
        let mut terms = AccelerationTerms {
            pressure: zero,
            wall_pressure: zero,
            structure_pressure: zero,
            viscosity: zero,
            wall_shear: zero,
            structure_shear: zero,
            gravity: self.config.gravity,
            substeps: zero,
            outside: zero,
        };
        for Neighbor { other, push, shear, .. } in &neighbors {
            let (pressure, viscous) = match other {
                Other::Fluid(_) => (&mut terms.pressure, &mut terms.viscosity),
                Other::Wall(_) => (&mut terms.wall_pressure, &mut terms.wall_shear),
                Other::Structure(_) => (&mut terms.structure_pressure, &mut terms.structure_shear),
            };
            *pressure += push;
            *viscous += shear;
        }
        terms.outside = self.rates.acceleration[i] - terms.total();
        // Not in the accelerations yet: they are given the answer at the end of the step.
        terms.substeps = self.answer_to(i);
        (terms, neighbors)
    }

    /// `-(D/n0)/rho0` \[m^3/kg\], what sums of pressures are multiplied by.
    fn pressure_factor(&self) -> T {
        -self.reference.gradient_factor::<D>() / self.config.density
    }

    fn pushed_by_fluid(&self, i: usize) -> Vec<Neighbor<T, D>> {
        let (state, own) = (&self.rates.state, &self.rates.state[i]);
        let push = |pair: &Pair<T, D>| {
            let (other, direction) = (&state[pair.j], pair.gradient_vector());
            match (self.rates.stress.get(i), self.rates.stress.get(pair.j)) {
                (Some(mine), Some(theirs)) => (theirs * own.density + mine * other.density) * direction,
                _ => {
                    let sum = ConservativeGradient::pair_pressure(
                        own.share,
                        own.density,
                        other.share,
                        other.density,
                    );
                    direction * sum
                }
            }
        };
        let mut neighbors = Vec::new();
        self.view(&self.search.fluid).for_each(i, |pair| {
            // Those of the skin are too far away to act.
            if pair.distance() < self.reference.radius || !pair.r2.is_finite() {
                let other = &state[pair.j];
                neighbors.push(Neighbor {
                    other: Other::Fluid(self.particles.id[pair.j]),
                    distance: pair.distance(),
                    offset: pair.r_ij,
                    velocity: other.velocity,
                    density: other.density,
                    pressure: self.particles.pressure[pair.j],
                    push: push(pair) * self.pressure_factor(),
                    shear: self.viscosity.pair(pair, &own.velocity, &other.velocity),
                });
            }
        });
        neighbors
    }

    fn pushed_by_boundary(&self, i: usize) -> Vec<Neighbor<T, D>> {
        let mut neighbors = Vec::new();
        if self.boundary.is_empty() {
            return neighbors;
        }
        let (wall, wall_shear, boundary) = (self.wall_pair(), self.wall_shear(), &self.boundary);
        let (own, pi) = (&self.rates.state[i], self.particles.pressure[i]);
        self.boundary_view().for_each(i, |pair| {
            let a = pair.j;
            if pair.distance() < self.reference.radius || !pair.r2.is_finite() {
                let (pressure, density) = wall.state(pi, own.density, &boundary.acceleration[a], &pair.r_ij);
                let sum = self.corrected(i, wall.pressure_sum(pi, own, boundary, pair));
                let velocity = self.shown_velocity(a);
                let shear = wall_shear.pair(&self.viscosity, i, pair, &own.velocity, &velocity);
                let structure = boundary.reactive.contains(&a);
                neighbors.push(Neighbor {
                    other: if structure { Other::Structure(a) } else { Other::Wall(a) },
                    distance: pair.distance(),
                    offset: pair.r_ij,
                    velocity,
                    density,
                    pressure,
                    push: sum * self.pressure_factor(),
                    shear: shear.unwrap_or(Vector::zeros()),
                });
            }
        });
        neighbors
    }
}
