//! The numbers that define a fluid and its numerics.

use crate::FluidError;
use crate::eos::Tait;
use crate::regularize::{Dpc, Shifting};
use mps_kernel::{Real, Vector};

/// How pressures below zero are treated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tension {
    /// Negative pressure becomes zero: flows with a free surface, which tear under suction.
    #[default]
    Clip,
    /// Negative pressure is kept: internal flows without a free surface.
    Keep,
}

/// How differences of the number density between neighbours are smoothed (`Dm` of eq. 18).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Diffusion<T> {
    /// Not at all: cheapest, and noisy.
    None,
    /// The filter of fourth order of eqs. 19 and 20, which leaves linear and quadratic fields alone.
    Filter {
        /// Coefficient `delta` of `delta c l0` (Antuono et al. 2010; eq. 19 has `delta c^2 dt`, which is this at a Courant number of 1 and
        /// vanishes with the step). The larger, the shorter a step may be; 0.5 leaves Courant numbers up to 0.6 to 2.3, by weight and radius.
        delta: T,
    },
    /// `l0/(rho0 c)` times the Laplacian of the pressure less its hydrostatic part (Amaro et al. 2022, eq. 20, whose `dt` is `l0/c` here): without
    /// a coefficient, and without the gradient and moment matrix the filter needs.
    Hydrostatic,
}

impl<T: Real> Diffusion<T> {
    /// The filter of the strength `delta` \[-\], or none unless that is positive.
    pub fn filter(delta: f64) -> Self {
        if delta > 0.0 { Self::Filter { delta: T::of(delta) } } else { Self::None }
    }

    /// Coefficient `delta` of the filter \[-\], 0 for the others.
    pub fn delta(&self) -> T {
        match *self {
            Self::Filter { delta } => delta,
            Self::None | Self::Hydrostatic => T::zero(),
        }
    }

    /// Name for summaries.
    pub fn name(&self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Filter { .. } => "filter",
            Self::Hydrostatic => "hydrostatic",
        }
    }
}

/// How the pressure gradient and the divergence treat an uneven neighbourhood.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PressureForm {
    /// Plain sums (eqs. 23, 24). With a weight that peaks at zero distance, as the paper's, a strained arrangement of
    /// particles resists shear with a modulus in proportion to its pressure; with
    /// [`WendlandGradient`](mps_kernel::weights::WendlandGradient) ten times less and better.
    #[default]
    Plain,
    /// Corrected by each particle's moment matrix: no such resistance, one more sweep a step. Flows
    /// that stir need [`Shifting`] with it, and violent ones tear all the same: a dam break gains energy and
    /// leaks with it (`docs/dam-break.md`). For smooth flows so far.
    Corrected,
}

/// Properties and numerical parameters of the fluid.
#[derive(Clone, Debug, PartialEq)]
pub struct FluidConfig<T: Real, const D: usize> {
    /// Spacing `l0` of the particles \[m\].
    pub spacing: T,
    /// Effective radius over spacing, `re/l0`. Default 3 (paper, section 2.2.1).
    pub radius_ratio: T,
    /// Reference density `rho0` \[kg/m^3\]. Default 1000.
    pub density: T,
    /// Numerical sound speed `c` \[m/s\]: about ten times the largest expected velocity, so that
    /// the density stays within 1 %.
    pub sound_speed: T,
    /// Acceleration of gravity \[m/s^2\]. Default zero.
    pub gravity: Vector<T, D>,
    /// Diffusion of the density. Default [`Diffusion::Filter`] with 0.5.
    pub diffusion: Diffusion<T>,
    /// Courant number of eq. 46. Default 0.5; the paper's 0.1 costs five times as much, see docs. What density diffusion and viscosity bear
    /// is not exceeded: [`Fluid::stable_courant_number`](crate::Fluid::stable_courant_number).
    pub cfl: T,
    /// Treatment of negative pressure. Default [`Tension::Clip`].
    pub tension: Tension,
    /// Pressure at reference density \[Pa\]. Default zero. Fluid that fills its domain has no pressure of its own, only differences;
    /// a level above the largest suction keeps it together, and its particles even. Structures feel it as well.
    pub background_pressure: T,
    /// Form of the pressure gradient and of the divergence. Default [`PressureForm::Plain`].
    pub pressure_form: PressureForm,
    /// Pairwise collisions; `None` switches them off.
    pub collisions: Option<Dpc<T>>,
    /// Particle shifting; `None` switches it off.
    pub shifting: Option<Shifting<T>>,
    /// How fast the number density of the equation of state returns to the [packing](crate::Fluid::packing) of the particles: by this
    /// share of their difference in the time sound takes for a spacing. Default zero: not at all. The density follows the velocities,
    /// the packing also the shifting and the errors of both, so that the two may drift apart in a flow that stirs for long. 0.01 is slow beside sound and fast beside the flow; more feeds noise (`examples/effective_viscosity.rs`); with 0.05 vortices burst. For fluid that fills
    /// its domain: at a free surface the packing is low and the density is not, so it needs [`Tension::Keep`].
    pub density_relaxation: T,
    /// Kinematic viscosity \[m^2/s\] in the law of walls with [`Slip::Law`](crate::Slip::Law). Default 1e-6, that of water; it has no other effect.
    pub wall_viscosity: T,
    /// Neighbour rows reach this much beyond `re`, over `l0`; they are rebuilt when a particle has
    /// moved half of it. Costs or saves time only. Default 0.2.
    pub skin_ratio: T,
}

impl<T: Real, const D: usize> FluidConfig<T, D> {
    /// Water with the paper's parameters for the given spacing \[m\] and sound speed \[m/s\].
    pub fn water(spacing: T, sound_speed: T) -> Self {
        Self {
            spacing,
            radius_ratio: T::of(3.0),
            density: T::of(1000.0),
            sound_speed,
            gravity: Vector::zeros(),
            diffusion: Diffusion::Filter { delta: T::of(0.5) },
            cfl: T::of(0.5),
            tension: Tension::Clip,
            background_pressure: T::zero(),
            pressure_form: PressureForm::Plain,
            collisions: Some(Dpc::default()),
            shifting: None,
            density_relaxation: T::zero(),
            wall_viscosity: T::of(1e-6),
            skin_ratio: T::of(0.2),
        }
    }

    /// The equation of state.
    pub fn equation_of_state(&self) -> Tait<T> {
        Tait::new(self.density, self.sound_speed).with_level(self.background_pressure)
    }

    /// Effective radius `re` \[m\].
    pub fn radius(&self) -> T {
        self.radius_ratio * self.spacing
    }

    /// Mass of a particle \[kg\] (per metre of depth in 2D).
    pub fn particle_mass(&self) -> T {
        self.density * self.particle_volume()
    }

    /// Volume of a particle `l0^D` \[m^D\].
    pub fn particle_volume(&self) -> T {
        self.spacing.powi(D as i32)
    }

    /// Refuses values no simulation can be run with.
    ///
    /// # Errors
    /// Names the parameter, its value and what is allowed.
    pub fn validate(&self) -> Result<(), FluidError> {
        let check = |name: &'static str, value: T, low: f64, high: f64, hint: &'static str| {
            let value = value.to_double();
            if value.is_finite() && value >= low && value <= high {
                Ok(())
            } else {
                Err(FluidError::Parameter { name, value, low, high, hint })
            }
        };
        let tiny = f64::MIN_POSITIVE;
        let huge = f64::MAX;
        check("spacing", self.spacing, tiny, huge, "the distance between particles in metres")?;
        check("radius_ratio", self.radius_ratio, 1.5, 6.0, "effective radius over spacing, usually 3")?;
        check("density", self.density, tiny, huge, "in kg/m3")?;
        check("sound_speed", self.sound_speed, tiny, huge, "about ten times the largest velocity, in m/s")?;
        check(
            "diffusion",
            self.diffusion.delta(),
            0.0,
            2.0,
            "the coefficient delta of the density diffusion",
        )?;
        check("cfl", self.cfl, tiny, 2.0, "the Courant number, usually 0.1 to 1")?;
        check("skin_ratio", self.skin_ratio, 0.0, 3.0, "the reach of the neighbour rows beyond re, over l0")?;
        check(
            "background_pressure",
            self.background_pressure,
            0.0,
            huge,
            "the pressure at reference density in Pa, 0 with a free surface",
        )?;
        let most = if self.tension == Tension::Keep { 0.03 } else { 0.0 };
        let hint = "0.01 where fluid fills its domain and may be under tension, 0 with a free surface";
        check("density_relaxation", self.density_relaxation, 0.0, most, hint)?;
        check(
            "wall_viscosity",
            self.wall_viscosity,
            0.0,
            huge,
            "of the law of the wall in m2/s, of water 1e-6",
        )?;
        for &component in self.gravity.iter() {
            check("gravity", component, -huge, huge, "in m/s2")?;
        }
        if let Some(dpc) = &self.collisions {
            check("collisions.repulsion", dpc.repulsion, 0.0, 1.0, "usually 0 to 0.2")?;
            check("collisions.restitution", dpc.restitution, 0.0, 1.0, "0 sticks, 1 bounces")?;
            check("collisions.ceiling", dpc.ceiling, 0.0, 1.0, "in rho0 c^2, usually 0.02")?;
        }
        if let Some(shifting) = &self.shifting {
            check("shifting.strength", shifting.strength, 0.0, 10.0, "the factor A_F, usually 1 to 6")?;
            check(
                "shifting.iterations",
                T::of(f64::from(shifting.iterations)),
                1.0,
                100.0,
                "k of icPS, 5 in the paper",
            )?;
        }
        Ok(())
    }
}
