//! The two sweeps of a fluid that has nothing but pressure, continuity and gravity, written without a place for anything else.
//!
//! What the sweeps of the library cost beyond these, in a fluid that has nothing else, is the price of what is absent.
//! The pair formulas are those of the library, and so are the results, bit for bit (`tests/absent.rs`).

use crate::Fluid;
use fearless_simd::Simd;
use mps_kernel::operators::{ConservativeGradient, Divergence};
use mps_kernel::small::{accumulate, components, scale, vector};
use mps_kernel::weights::Rational;
use mps_kernel::{Lanes, Real, Vector, by_axis};
use mps_neighbors::{Cells, Open, Parallel, Placed, RowView, Rows, Sweep};

/// What a sweep reads of a neighbour, side by side as in the library.
#[derive(Clone, Copy)]
#[repr(align(16))]
struct State<T: Real, const D: usize> {
    position: Vector<T, D>,
    velocity: Vector<T, D>,
    density: T,
    share: T,
}

impl<T: Real, const D: usize> Placed<T, D> for State<T, D> {
    #[inline(always)]
    fn place(&self) -> &Vector<T, D> {
        &self.position
    }
}

/// A fluid at an instant.
pub struct Lean<T: Real, const D: usize> {
    state: Vec<State<T, D>>,
    position: Vec<Vector<T, D>>,
    acceleration: Vec<Vector<T, D>>,
    rate: Vec<T>,
    rows: Rows,
    radius: T,
    gravity: Vector<T, D>,
    /// `D/n0`.
    factor: T,
    rho0: T,
}

impl<T: Real, const D: usize> Lean<T, D> {
    /// The particles of a fluid in their present order, which may be that of space or not.
    pub fn of(fluid: &Fluid<T, D>) -> Self {
        let (config, particles, serial) = (fluid.config(), fluid.particles(), Parallel::serial());
        let (mut cells, mut rows) = (Cells::new(), Rows::default());
        let reach = config.radius() + config.skin_ratio * config.spacing;
        cells.build(&serial, &Open, &particles.position, reach).expect("finite positions");
        rows.build_within(&serial, &Open, &cells, &particles.position, reach).expect("finite positions");
        let state = |i: usize| {
            let (density, pressure) = (particles.density[i], particles.pressure[i]);
            let (position, velocity) = (particles.position[i], particles.velocity[i]);
            State { position, velocity, density, share: pressure / density }
        };
        let len = particles.position.len();
        Self {
            state: (0..len).map(state).collect(),
            position: particles.position.clone(),
            acceleration: vec![Vector::zeros(); len],
            rate: vec![T::zero(); len],
            rows,
            radius: fluid.reference().radius,
            gravity: config.gravity,
            factor: fluid.reference().gradient_factor::<D>(),
            rho0: config.density,
        }
    }

    /// Number of particles.
    pub fn particles(&self) -> usize {
        self.position.len()
    }

    /// Accelerations \[m/s^2\] found by [`sweep`](Self::sweep).
    pub fn acceleration(&self) -> &[Vector<T, D>] {
        &self.acceleration
    }

    /// Finds accelerations and rates of the density.
    pub fn sweep(&mut self, parallel: &Parallel) {
        let Self { state, position, acceleration, rate, rows, radius, gravity, factor, rho0 } = self;
        let neighbors = RowView {
            rows,
            points: position,
            targets: position,
            kernel: Rational,
            radius: *radius,
            domain: Open,
        };
        let (state, factor) = (state.as_slice(), *factor);
        let momentum = Momentum { neighbors, state, gravity: *gravity, pressure_factor: -factor / *rho0 };
        parallel.sweep(acceleration.as_mut_slice(), &momentum);
        parallel.sweep(rate.as_mut_slice(), &Continuity { neighbors, state, factor });
    }
}

struct Momentum<'a, T: Real, const D: usize> {
    neighbors: RowView<'a, T, D, Rational>,
    state: &'a [State<T, D>],
    gravity: Vector<T, D>,
    pressure_factor: T,
}

impl<'b, T: Real, const D: usize> Sweep<&'b mut [Vector<T, D>]> for Momentum<'_, T, D> {
    #[inline(always)]
    fn visit<S: Simd>(&self, simd: S, i: usize, acceleration: &'b mut Vector<T, D>) {
        let own = self.state[i];
        let mut pressed = vector([T::Lanes::splat(simd, T::zero()); D]);
        for pair in self.neighbors.packs_of(simd, i, self.state) {
            let j = pair.j.as_ref();
            let density = T::Lanes::gather(simd, |lane| self.state[j[lane]].density);
            let share = T::Lanes::gather(simd, |lane| self.state[j[lane]].share);
            let pressure = ConservativeGradient::pair_pressure(own.share, own.density, share, density);
            accumulate(&mut pressed, &scale(&pair.gradient_vector(), pressure));
        }
        let pressed: Vector<T, D> = by_axis!(axis => components(&pressed)[axis].sum());
        *acceleration = pressed * self.pressure_factor + self.gravity;
    }
}

struct Continuity<'a, T: Real, const D: usize> {
    neighbors: RowView<'a, T, D, Rational>,
    state: &'a [State<T, D>],
    factor: T,
}

impl<'b, T: Real, const D: usize> Sweep<&'b mut [T]> for Continuity<'_, T, D> {
    #[inline(always)]
    fn visit<S: Simd>(&self, simd: S, i: usize, rate: &'b mut T) {
        let own = self.state[i];
        let mut inflow = T::Lanes::splat(simd, T::zero());
        for pair in self.neighbors.packs_of(simd, i, self.state) {
            let j = pair.j.as_ref();
            let density = T::Lanes::gather(simd, |lane| self.state[j[lane]].density);
            let velocity: Vector<T::Lanes<S>, D> = by_axis!(axis => T::Lanes::gather(simd, |lane| components(&self.state[j[lane]].velocity)[axis]));
            inflow -= density * Divergence::pair(&own.velocity, &velocity, &pair);
        }
        *rate = inflow.sum() * self.factor;
    }
}
