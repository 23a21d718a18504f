//! Bodies and noise that several cases have.

use mps_examples::Failure;
pub(crate) use mps_examples::Noise;
use mps_kernel::Vector;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::Parallel;
use mps_solid::body::Body;
use mps_solid::{ConstitutiveModel, Solid, SolidConfig, SolidParticles};

pub(crate) type V = Vector<f64, 2>;

/// Density of bodies whose own does not matter \[kg/m^3\].
pub(crate) const RHO: f64 = 1000.0;
/// Young's modulus of such bodies \[Pa\].
pub(crate) const YOUNG: f64 = 1e6;

/// A block as a solid with the default settings.
pub(crate) fn solid<M: ConstitutiveModel<f64, 2>>(
    body: &Body<f64, 2>,
    density: f64,
    material: M,
    parallel: &Parallel,
) -> Result<Solid<f64, 2, M>, Failure> {
    let (particles, config) = (body.particles.clone(), SolidConfig::default());
    Ok(Solid::new(particles, body.spacing, density, material, WendlandC2, config, parallel)?)
}

/// A free square of side 1 m, `n` by `n` particles, each displaced by up to `noise` spacings along each axis, with volumes
/// that differ by as much.
pub(crate) fn square<M: ConstitutiveModel<f64, 2>>(
    n: usize,
    noise: f64,
    material: M,
    parallel: &Parallel,
) -> Result<Solid<f64, 2, M>, Failure> {
    let l0 = 1.0 / n as f64;
    let mut random = Noise::default();
    let mut particles = SolidParticles::new();
    for k in 0..n * n {
        let cell = V::new((k / n) as f64 + 0.5, (k % n) as f64 + 0.5);
        let volume = l0 * l0 * (1.0 + noise * random.number());
        particles.push((cell + random.vector::<2>() * noise) * l0, volume, false);
    }
    let config = SolidConfig::default();
    Ok(Solid::new(particles, V::repeat(l0), RHO, material, WendlandC2, config, parallel)?)
}

/// Moves every particle to `place(X)` and brings the forces up to date.
pub(crate) fn deform<M: ConstitutiveModel<f64, 2>>(
    solid: &mut Solid<f64, 2, M>,
    place: impl Fn(&V) -> V,
    parallel: &Parallel,
) -> Result<(), Failure> {
    let places: Vec<V> = solid.particles().reference_positions().iter().map(place).collect();
    solid.positions_mut().copy_from_slice(&places);
    Ok(solid.refresh(parallel)?)
}
