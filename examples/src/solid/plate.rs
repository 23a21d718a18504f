//! Case 1 of Tavakoli, Shakibaeinia and Bouaanani (2026): a plate clamped at its left end and let swing, after Gray,
//! Monaghan and Swift (2001).

use super::Sample;
use crate::Failure;
use crate::series::{extremes, zeros};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::{MaterialError, Moduli};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

/// Length of the plate \[m\].
pub const LENGTH: f64 = 0.2;
/// Its thickness \[m\].
pub const THICKNESS: f64 = 0.02;
/// Density \[kg/m^3\].
pub const DENSITY: f64 = 1000.0;
/// Bulk modulus \[Pa\].
pub const BULK: f64 = 3.25e6;
/// Shear modulus \[Pa\].
pub const SHEAR: f64 = 0.715e6;
/// Speed of the tip at the start, over the speed of sound.
pub const TIP_SPEED: f64 = 0.01;
/// Period over `L/c_s`: quadratic finite elements in plane strain with a rigid clamp, mesh 160 x 16.
pub const PERIOD: f64 = 72.76;
/// The same, extrapolated from the meshes 80 x 8, 160 x 16 and 240 x 24: what orders are measured against.
pub const PERIOD_EXTRAPOLATED: f64 = 72.78;
/// Amplitude over `L` in a geometrically nonlinear run of the finite elements.
pub const AMPLITUDE: f64 = 0.1148;
/// Where both are from.
pub const ELEMENTS: &str = "quadratic finite elements, plane strain, rigid clamp";
/// First root of `cos k cosh k = -1`.
const ROOT: f64 = 1.875_104_07;

/// Speed of sound `sqrt(K/rho)` \[m/s\].
pub fn sound_speed() -> f64 {
    (BULK / DENSITY).sqrt()
}

/// Unit of time `L/c_s` \[s\].
pub fn unit_of_time() -> f64 {
    LENGTH / sound_speed()
}

/// The elastic constants.
///
/// # Errors
/// Never: they are those of a material.
pub fn moduli<T: Real>() -> Result<Moduli<T>, MaterialError> {
    Moduli::from_bulk_and_shear(T::of(BULK), T::of(SHEAR))
}

/// Angular frequency \[1/s\] of the beam of Euler and Bernoulli, in plane strain.
pub fn beam_frequency() -> f64 {
    // E/(1 - nu^2) = 4 G (K + G/3)/(K + 4 G/3)
    let stiffness = 4.0 * SHEAR * (BULK + SHEAR / 3.0) / (BULK + 4.0 * SHEAR / 3.0);
    (ROOT / LENGTH).powi(2) * THICKNESS * (stiffness / (12.0 * DENSITY)).sqrt()
}

/// Velocity along the plate at the start, over that of the tip: eq. 51 of the paper, with its root.
pub fn first_mode(x: f64) -> f64 {
    let kl: f64 = 1.875;
    let f = |x: f64| {
        (kl.cos() + kl.cosh()) * ((kl * x).cosh() - (kl * x).cos())
            + (kl.sin() - kl.sinh()) * ((kl * x).sinh() - (kl * x).sin())
    };
    f(x) / f(1.0)
}

/// The plate with its velocities at the start (eq. 50), and the middle of its free end.
///
/// # Errors
/// If the numbers do not make a body, or the configuration is none.
pub fn plate<T: Real, M: ConstitutiveModel<T, 2>>(
    across: usize,
    material: M,
    config: SolidConfig<T>,
    parallel: &Parallel,
) -> Result<(Solid<T, 2, M>, Vector<T, 2>), Failure> {
    let clamp = [Face::lower(0)];
    let (lower, upper) = (Vector::zeros(), Vector::from([LENGTH, THICKNESS].map(T::of)));
    let mut counts = body::counts(&lower, &upper, T::of(THICKNESS / across as f64), &clamp);
    counts[1] = across;
    let plate = body::block(lower, upper, counts, &clamp)?;
    let mut solid =
        Solid::new(plate.particles, plate.spacing, T::of(DENSITY), material, WendlandC2, config, parallel)?;
    let speed = TIP_SPEED * sound_speed();
    let along: Vec<f64> = solid.positions().iter().map(|x| x[0].to_double() / LENGTH).collect();
    for (u, x) in solid.velocities_mut().iter_mut().zip(along) {
        u[1] = T::of(speed * first_mode(x));
    }
    Ok((solid, Vector::from([LENGTH, 0.5 * THICKNESS].map(T::of))))
}

/// Period over `L/c_s` and amplitude over `L` of the deflection of the tip; `None` before half a period.
pub fn swing(samples: &[Sample]) -> Option<[f64; 2]> {
    let time: Vec<f64> = samples.iter().map(|s| s.time).collect();
    let tip: Vec<f64> = samples.iter().map(|s| s.tip[1]).collect();
    // The start, where the deflection is zero up to rounding, counts whole.
    let zeros = zeros(time.get(1..)?, &tip[1..]);
    let period = 2.0 * zeros.last()? / zeros.len() as f64;
    let [low, high] = extremes(&tip)?;
    Some([period / unit_of_time(), 0.5 * (high - low) / LENGTH])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_beam_has_the_period_in_the_literature() {
        let period = core::f64::consts::TAU / beam_frequency() / unit_of_time();
        assert!((period - 72.438).abs() < 1e-3, "{period}");
        let root = ROOT.cos() * ROOT.cosh() + 1.0;
        assert!(root.abs() < 1e-6, "{root}");
    }
}
