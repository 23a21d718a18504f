//! What every body is checked for before it is built and before it moves.

use crate::{ConstitutiveModel, SolidError, SolidParticles};
use mps_kernel::{Kernel, ParticleStore, Real, Vector};
use mps_neighbors::FrozenPairs;

/// Checks the particles, gives them their masses for the `density` \[kg/m^3\] and finds the reference pairs of a lattice
/// with the `spacing` \[m\].
///
/// # Errors
/// If there is no particle, the density or a volume is not positive and finite, two particles coincide or one is not
/// finite.
pub(crate) fn prepare<T: Real, const D: usize>(
    particles: &mut SolidParticles<T, D>,
    spacing: &Vector<T, D>,
    density: T,
    kernel: &impl Kernel<T>,
    radius_ratio: T,
) -> Result<FrozenPairs<T, D>, SolidError> {
    let value = density.to_double();
    if !(value.is_finite() && value > 0.0) {
        return Err(SolidError::Parameter { name: "density", must: "positive and finite", value });
    }
    if particles.is_empty() {
        return Err(SolidError::Empty);
    }
    for i in 0..particles.len() {
        let volume = particles.volume[i];
        if !(volume.is_finite() && volume > T::zero()) {
            return Err(SolidError::Volume { id: particles.id[i], volume: volume.to_double() });
        }
        particles.mass[i] = volume * density;
    }
    Ok(FrozenPairs::build(&particles.reference, spacing, kernel, radius_ratio)?)
}

/// Checks that the undeformed body resists every strain, by the moduli that the material reports, and that its waves have a speed.
///
/// # Errors
/// With the name of what is not positive and finite.
pub(crate) fn check_material<T: Real, const D: usize>(
    material: &impl ConstitutiveModel<T, D>,
    density: T,
) -> Result<(), SolidError> {
    let (lambda, mu) = (material.first_lame_modulus().to_double(), material.shear_modulus().to_double());
    let positive = [
        ("the shear modulus of the material", mu),
        (
            "lambda + 2 mu/D of the material, its resistance to a change of volume,",
            lambda + 2.0 * mu / D as f64,
        ),
        ("the wave speed of the material", material.wave_speed(density).to_double()),
    ];
    for (name, value) in positive {
        // Written so that NaN is refused too.
        if !(value > 0.0 && value.is_finite()) {
            return Err(SolidError::Parameter { name, must: "positive and finite", value });
        }
    }
    Ok(())
}

/// Checks the arguments of a step of a body of so many particles.
///
/// # Errors
/// If there is not one force for every particle, `dt` is not positive and finite, or there is no sub-step.
pub(crate) fn check_step<T: Real, const D: usize>(
    particles: usize,
    force: &[Vector<T, D>],
    dt: T,
    substeps: usize,
) -> Result<(), SolidError> {
    if force.len() != particles {
        return Err(SolidError::Length { name: "force", got: force.len(), particles });
    }
    if !(dt.is_finite() && dt > T::zero()) {
        let value = dt.to_double();
        return Err(SolidError::Parameter { name: "dt", must: "positive and finite", value });
    }
    if substeps == 0 {
        return Err(SolidError::Parameter { name: "substeps", must: "at least 1", value: 0.0 });
    }
    Ok(())
}
