//! The longest stable time step.

use crate::compressibility::deviation;
use crate::terms::Viscosity;
use crate::{Compressibility, Fluid, FluidConfig, FluidError};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::{Domain, Parallel};

/// What the length of a step follows from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Limit {
    /// The way of sound and of the fastest particle or boundary point, `l0/(v_max + c)`.
    #[default]
    Sound,
    /// Viscosity, `l0^2/(8 nu)`.
    Viscosity,
    /// The largest acceleration, `sqrt(l0/a_max)`.
    Acceleration,
    /// The stiffest wave of the lattice, which density diffusion and viscosity make stiffer: 0.98 of
    /// [`Fluid::stable_courant_number`](crate::Fluid::stable_courant_number) times `l0/c`.
    Diffusion,
}

impl Limit {
    /// Name for reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sound => "sound",
            Self::Viscosity => "viscosity",
            Self::Acceleration => "acceleration",
            Self::Diffusion => "diffusion",
        }
    }
}

/// The limits of a step \[s\], infinite where there is none. The Courant number is in all of them but that of the diffusion, which is a border
/// of stability whatever the Courant number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLimits<T> {
    /// By sound and the fastest particle or boundary point.
    pub sound: T,
    /// By viscosity.
    pub viscosity: T,
    /// By the largest acceleration.
    pub acceleration: T,
    /// By density diffusion and viscosity together, and sound.
    pub diffusion: T,
}

impl<T: Real> StepLimits<T> {
    /// The limit that acts, and the length of the step \[s\].
    pub fn shortest(&self) -> (Limit, T) {
        let mut shortest = (Limit::Sound, self.sound);
        for (limit, dt) in [
            (Limit::Viscosity, self.viscosity),
            (Limit::Acceleration, self.acceleration),
            (Limit::Diffusion, self.diffusion),
        ] {
            if dt < shortest.1 {
                shortest = (limit, dt);
            }
        }
        shortest
    }
}

/// Speed over sound speed beyond which the run is given up: nothing physical gets there.
const ESCAPED: f64 = 20.0;

/// Part of the largest stable Courant number that is used.
const SAFETY: f64 = 0.98;

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// `dt = C min(l0/(v_max + c), l0^2/(8 nu))` (eq. 46), `sqrt(l0/a_max)` for sudden forces, and what the density diffusion bears.
    pub(crate) fn stable_step(&mut self, parallel: &Parallel) -> Result<T, FluidError> {
        let (u, a, n) = (&self.particles.velocity, &self.rates.acceleration, &self.particles.density);
        let loosest = self.loosest();
        // Keeps a NaN once it has met one, so that it cannot hide behind a comparison.
        let largest = |x: T, y: T| if x > y || x.partial_cmp(&x).is_none() { x } else { y };
        let (v2, a2, density) = parallel.fold(
            u.len(),
            (T::zero(), T::zero(), T::zero()),
            &|i| (u[i].norm_squared(), a[i].norm_squared(), deviation(n[i], loosest)),
            &|x, y| (largest(x.0, y.0), largest(x.1, y.1), largest(x.2, y.2)),
        );
        // Before the fluid: a wall that is no number spoils the particles next to it.
        let wall = self.boundary_speed(parallel);
        if !wall.is_finite() {
            self.boundary.check_points()?;
        }
        if !(v2.is_finite() && a2.is_finite() && density.is_finite()) {
            return Err(self.find_not_finite());
        }
        let v = v2.sqrt();
        self.compressibility = Compressibility { mach: v / self.config.sound_speed, density };
        self.compressibility_seen = self.compressibility_seen.larger(&self.compressibility);
        let (limit, dt) = self.step_limits(v.max(wall), a2.sqrt()).shortest();
        self.limit = limit;
        if v > self.config.sound_speed * T::of(ESCAPED) {
            return Err(self.find_fastest(dt));
        }
        Ok(dt)
    }

    /// The largest speed of a boundary point \[m/s\].
    pub(crate) fn boundary_speed(&self, parallel: &Parallel) -> T {
        let u = &self.boundary.velocity;
        // Not `max`, which would hide what is no number.
        let sum = |x: T, y: T| if x > y || x.partial_cmp(&x).is_none() { x } else { y };
        parallel.fold(u.len(), T::zero(), &|a| u[a].norm_squared(), &sum).sqrt()
    }

    /// The limits at the largest speed \[m/s\] and the largest acceleration \[m/s^2\].
    pub(crate) fn step_limits(&self, v: T, a: T) -> StepLimits<T> {
        let (l0, c, none) = (self.config.spacing, self.config.sound_speed, T::of(f64::INFINITY));
        let nu = self.viscosity.kinematic();
        // 1/8 keeps explicit diffusion on this stencil inside its stability limit.
        let viscosity = if nu > T::zero() { l0 * l0 * T::of(0.125) / nu } else { none };
        let acceleration = if a > T::zero() { (l0 / a).sqrt() } else { none };
        let cfl = self.config.cfl;
        StepLimits {
            sound: l0 / (v + c) * cfl,
            viscosity: viscosity * cfl,
            acceleration: acceleration * cfl,
            diffusion: self.stable_courant * T::of(SAFETY) * l0 / c,
        }
    }

    /// The limits at the present velocities and the accelerations of the last step.
    pub fn limits(&self) -> StepLimits<T> {
        let most = |vectors: &[Vector<T, D>]| vectors.iter().fold(T::zero(), |most, x| most.max(x.norm()));
        let speed = most(&self.particles.velocity).max(most(&self.boundary.velocity));
        self.step_limits(speed, most(&self.rates.acceleration))
    }

    /// The largest Courant number `c dt/l0` with which no wave on the lattice grows, which depends on weight, radius, density diffusion and
    /// viscosity \[-\]. Steps stay 2 % below it, whatever [`FluidConfig::cfl`] asks for.
    pub fn stable_courant_number(&self) -> T {
        self.stable_courant
    }

    /// What the length of the last step that has begun followed from.
    pub fn limit(&self) -> Limit {
        self.limit
    }

    /// Sets the Courant number, from the next step on: to pass a difficult moment with shorter steps.
    ///
    /// # Errors
    /// If it is out of range.
    pub fn set_courant_number(&mut self, cfl: T) -> Result<(), FluidError> {
        let config = FluidConfig { cfl, ..self.config.clone() };
        config.validate()?;
        self.config = config;
        Ok(())
    }

    fn find_not_finite(&self) -> FluidError {
        let particles = &self.particles;
        let len = particles.position.len();
        // The state first: accelerations are spoilt by the state of a neighbour.
        let state = (0..len).flat_map(|i| {
            let speed = particles.velocity[i].norm();
            [("density", particles.density[i]), ("pressure", particles.pressure[i]), ("speed", speed)]
                .map(|(quantity, value)| (i, quantity, value))
        });
        let acceleration = (0..len).map(|i| (i, "acceleration", self.rates.acceleration[i].norm()));
        if let Some((i, quantity, value)) = state.chain(acceleration).find(|(.., x)| !x.is_finite()) {
            return FluidError::NotFinite {
                id: particles.id[i],
                quantity,
                value: value.to_double(),
                position: particles.position[i].iter().map(|x| x.to_double()).collect(),
                time: self.time.now().to_double(),
                step: self.steps,
            };
        }
        self.find_fastest(T::zero())
    }

    fn find_fastest(&self, dt: T) -> FluidError {
        let particles = &self.particles;
        let mut fastest = (T::zero(), 0);
        for (u, id) in particles.velocity.iter().zip(&particles.id) {
            if u.norm() > fastest.0 {
                fastest = (u.norm(), *id);
            }
        }
        FluidError::TimeStep {
            dt: dt.to_double(),
            time: self.time.now().to_double(),
            id: fastest.1,
            speed: fastest.0.to_double(),
        }
    }
}
