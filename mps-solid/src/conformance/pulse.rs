//! The speed of a pulse in a bar.
//!
//! Particles in the middle of a long bar are set moving along it, in the shape of a Gaussian. The pulse
//! parts into two that run to both ends; the place of the right one is its centre of momentum. The
//! waves of a lattice are dispersive, short ones are slower, but the first moment of a signal moves with the
//! speed of the infinitely long wave, whatever its shape, so that a few hundred particles will do.
//!
//! The fastest wave needs uniaxial strain: the bar must not become thinner where it is stretched. So
//! a force on every particle cancels the internal one across the bar. Known at the start of a step it leaves no
//! drift across; what the new forces add at the end of the step is set back to zero.

use super::ConformanceError;
use crate::body::block;
use crate::{ConstitutiveModel, Solid, SolidConfig, SolidError};
use mps_kernel::{Tensor, Vector, weights::WendlandC2};
use mps_neighbors::Parallel;

/// Particles along and across the bar, a metre apart.
const LENGTH: usize = 160;
const ACROSS: usize = 3;
/// Standard deviation of the pulse \[m\].
const WIDTH: f64 = 4.0;
/// Velocity of the pulse over (spacing / stable sub-step), about the wave speed: small strains.
const SIZE: f64 = 1e-4;
/// Where the pulse is timed, measured from the middle \[m\]: first apart from its twin, at last not yet reflected.
const GATES: [f64; 2] = [20.0, 55.0];
/// Most sub-steps: ten times what a pulse with the speed of the stable sub-step needs.
const STEPS: usize = 2000;

/// The speed of a longitudinal wave in uniaxial strain \[m/s\], measured: a small pulse travels along a bar of
/// this material with the `density` \[kg/m^3\], its history held as in the undeformed state.
///
/// # Errors
/// If the bar cannot be built or moved, or the pulse never arrives.
pub fn measured_wave_speed<const D: usize, M: ConstitutiveModel<f64, D>>(
    material: &M,
    density: f64,
) -> Result<f64, ConformanceError> {
    let parallel = Parallel::serial();
    let counts: [usize; D] = core::array::from_fn(|axis| if axis == 0 { LENGTH } else { ACROSS });
    let upper = Vector::<f64, D>::from_fn(|axis, _| counts[axis] as f64);
    let bar = block(Vector::zeros(), upper, counts, &[])?;
    let config = SolidConfig::default();
    let held = Held(material);
    let mut solid = Solid::new(bar.particles, bar.spacing, density, held, WendlandC2, config, &parallel)?;

    // Not the wave speed that the material reports: that one is in question.
    let dt = 0.5 * solid.stability_limit();
    let middle = 0.5 * LENGTH as f64;
    let from_middle: Vec<f64> = solid.positions().iter().map(|x| x[0] - middle).collect();
    for (u, x) in solid.velocities_mut().iter_mut().zip(&from_middle) {
        u[0] = SIZE / dt * (-0.5 * (x / WIDTH).powi(2)).exp();
    }
    let mut across = vec![Vector::zeros(); solid.len()];
    let mut arrivals = Vec::with_capacity(GATES.len());
    let (mut time, mut before) = (0.0, place(&solid, &from_middle));
    for _ in 0..STEPS {
        for (force, inner) in across.iter_mut().zip(solid.particles().internal_forces()) {
            *force = Vector::from_fn(|axis, _| if axis == 0 { 0.0 } else { -inner[axis] });
        }
        solid.advance(&parallel, &across, &Vector::zeros(), dt, 1)?;
        for u in solid.velocities_mut() {
            *u = Vector::from_fn(|axis, _| if axis == 0 { u[0] } else { 0.0 });
        }
        let here = place(&solid, &from_middle);
        let gate = GATES[arrivals.len()];
        if here >= gate {
            arrivals.push(time + dt * (gate - before) / (here - before));
        }
        if let [first, last] = arrivals[..] {
            return Ok((GATES[1] - GATES[0]) / (last - first));
        }
        (time, before) = (time + dt, here);
    }
    let must =
        "the speed of a wave: the pulse has not arrived, so that small strains have no restoring stress";
    Err(SolidError::Parameter { name: "the stress", must, value: before }.into())
}

/// Centre of momentum of the right half \[m from the middle\].
fn place<const D: usize, M: ConstitutiveModel<f64, D>>(
    solid: &Solid<f64, D, Held<'_, M>>,
    from_middle: &[f64],
) -> f64 {
    let right = from_middle.iter().zip(solid.velocities()).filter(|(x, _)| **x > 0.0);
    let (moment, momentum) = right.fold((0.0, 0.0), |(m, p), (x, u)| (m + x * u[0], p + u[0]));
    moment / momentum
}

/// A material without its memory: what it answers at once.
struct Held<'a, M>(&'a M);

impl<const D: usize, M: ConstitutiveModel<f64, D>> ConstitutiveModel<f64, D> for Held<'_, M> {
    type History = ();

    fn energy(&self, f: &Tensor<f64, D>, _: &()) -> f64 {
        self.0.energy(f, &M::History::default())
    }

    fn first_piola(&self, f: &Tensor<f64, D>, (): &mut (), _: f64) -> Tensor<f64, D> {
        self.0.first_piola(f, &mut M::History::default(), 0.0)
    }

    fn first_lame_modulus(&self) -> f64 {
        self.0.first_lame_modulus()
    }

    fn shear_modulus(&self) -> f64 {
        self.0.shear_modulus()
    }

    fn wave_speed(&self, density: f64) -> f64 {
        self.0.wave_speed(density)
    }

    fn name(&self) -> &'static str {
        self.0.name()
    }
}
