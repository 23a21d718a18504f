//! An open tank of water at rest, in either precision, anywhere in space, and with whatever is done to it.

use mps_examples::basin::{lattice, press, walls, water};
use mps_examples::{Failure, Noise};
use mps_fluid::{ArtificialViscosity, Fluid, FluidParticles};
use mps_kernel::weights::WendlandGradient;
use mps_kernel::{Real, Vector};
use mps_neighbors::{Open, Parallel};

/// Water with a free surface.
pub(crate) type Water<T, const D: usize> = Fluid<T, D, WendlandGradient, ArtificialViscosity<T>>;

/// What a tank is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tank<const D: usize> {
    /// Particles along and, last, up.
    pub(crate) counts: [usize; D],
    /// Spacing \[m\].
    pub(crate) spacing: f64,
    /// Gravity \[m/s^2\].
    pub(crate) gravity: f64,
    /// `sqrt(g H)` over the speed of sound; or, without gravity, of what gravity would be 9.81.
    pub(crate) mach: f64,
    /// Where its corner is, in spacings along both axes.
    pub(crate) shift: f64,
    /// How far every particle is displaced at most along each axis, in spacings.
    pub(crate) noise: f64,
    /// How long it is left alone, over `sqrt(H/g)`.
    pub(crate) duration: f64,
}

/// A tank a dozen particles deep and wide, left alone while sound passes it sixty times. The spacing is no power of two, so that nothing
/// is exact by chance.
pub(crate) const USUAL: Tank<2> =
    Tank { counts: [12, 12], spacing: 0.07, gravity: 9.81, mach: 0.1, shift: 0.0, noise: 0.0, duration: 3.0 };

/// One in space.
pub(crate) const CUBE: Tank<3> = Tank {
    counts: [6, 6, 8],
    spacing: 0.07,
    gravity: 9.81,
    mach: 0.1,
    shift: 0.0,
    noise: 0.0,
    duration: 1.0,
};

impl<const D: usize> Tank<D> {
    /// Depth \[m\].
    pub(crate) fn depth(&self) -> f64 {
        self.counts[D - 1] as f64 * self.spacing
    }

    /// `sqrt(H/g)` \[s\].
    pub(crate) fn unit_of_time(&self) -> f64 {
        (self.depth() / if self.gravity == 0.0 { USUAL.gravity } else { self.gravity }).sqrt()
    }

    /// Speed of sound \[m/s\].
    pub(crate) fn sound(&self) -> f64 {
        self.depth() / self.unit_of_time() / self.mach
    }

    /// The water with hydrostatic pressure; `more` may add particles to its lattice or move them \[m\].
    ///
    /// # Errors
    /// If the fluid refuses the numbers.
    pub(crate) fn build<T: Real>(
        &self,
        more: impl FnOnce(&mut Vec<Vector<T, D>>),
    ) -> Result<Water<T, D>, Failure> {
        let l0 = self.spacing;
        let mut config = water::<T, D>(l0, self.sound());
        config.gravity[D - 1] = T::of(-self.gravity);
        let mut noise = Noise::default();
        let mut points: Vec<Vector<T, D>> = lattice([0.0; D], self.counts, l0);
        for r in &mut points {
            *r += noise.vector::<D>().map(|x| T::of(x * self.noise * l0));
        }
        more(&mut points);
        let mut particles = FluidParticles::at_rest(points);
        let (weight, depth) = (T::of(self.gravity) * config.density, T::of(self.depth()));
        press(&mut particles, &config, |r| weight * (depth - r[D - 1]).max(T::zero()));
        let mut boundary = walls(self.counts, Some(self.counts[D - 1] / 2), l0);
        // Rounded once, at the place where the point comes to be.
        let shift = |r: &mut Vector<T, D>| *r = r.map(|x| T::of(x.to_double() + self.shift * l0));
        particles.position.iter_mut().chain(&mut boundary.position).for_each(shift);
        let c = config.sound_speed;
        let viscosity = |r: &_| ArtificialViscosity::new::<D>(T::of(0.02), c, r);
        Ok(Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary)?)
    }

    /// Leaves the tank alone.
    ///
    /// # Errors
    /// If the fluid cannot go on.
    pub(crate) fn rest<T: Real>(&self) -> Result<Water<T, D>, Failure> {
        let mut fluid = self.build::<T>(|_| ())?;
        self.advance(&mut fluid, self.duration, |_| ())?;
        Ok(fluid)
    }

    /// Steps for so many units of time and looks after every one.
    ///
    /// # Errors
    /// If the fluid cannot go on.
    pub(crate) fn advance<T: Real>(
        &self,
        fluid: &mut Water<T, D>,
        duration: f64,
        mut look: impl FnMut(&Water<T, D>),
    ) -> Result<(), Failure> {
        let parallel = Parallel::serial();
        while fluid.time().to_double() < duration * self.unit_of_time() {
            fluid.step(&parallel)?;
            look(fluid);
        }
        Ok(())
    }

    /// Error of the pressure after the rest: root mean square over the particles, over `rho g H` (without gravity over what that would be).
    ///
    /// # Errors
    /// If the fluid cannot go on.
    pub(crate) fn pressure_error<T: Real>(&self) -> Result<f64, Failure> {
        let fluid = self.rest::<T>()?;
        let (particles, rho) = (fluid.particles(), fluid.config().density.to_double());
        let scale = rho * (self.depth() / self.unit_of_time()).powi(2);
        let share = self.gravity * rho / scale;
        let square = |(r, p): (&Vector<T, D>, &T)| {
            let depth = self.depth() + self.shift * self.spacing - r[D - 1].to_double();
            (p.to_double() / scale - share * depth).powi(2)
        };
        let sum: f64 = particles.position.iter().zip(&particles.pressure).map(square).sum();
        Ok((sum / particles.position.len() as f64).sqrt())
    }
}
