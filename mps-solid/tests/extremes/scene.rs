//! Blocks with unit spacing, and whether they stay bounded.

use crate::common::Noise;
use mps_kernel::{Real, Vector, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::Moduli;
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

pub(crate) type V = Vector<f64, 2>;

/// All four faces: rollers that hold a block in uniaxial strain.
pub(crate) const SIDES: [Face; 4] = [Face::lower(0), Face::upper(0), Face::lower(1), Face::upper(1)];

/// Constants for which `lambda + 2 mu` is 1.
pub(crate) fn moduli<T: Real>(nu: f64) -> Moduli<T> {
    Moduli::new(T::of((1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu)), T::of(nu)).unwrap()
}

/// A block with unit spacing that slides along its held faces.
pub(crate) fn block<T: Real, const D: usize, M: ConstitutiveModel<T, D>>(
    counts: [usize; D],
    rollers: &[Face],
    material: M,
    density: f64,
    cfl: f64,
) -> Solid<T, D, M> {
    let on = |axis| rollers.iter().filter(|face| face.axis == axis).count() as f64;
    let upper = Vector::<T, D>::from_fn(|axis, _| T::of(counts[axis] as f64 - 0.5 * on(axis)));
    let mut block = body::block(Vector::zeros(), upper, counts, rollers).unwrap();
    rollers.iter().for_each(|&face| block.slide(face).unwrap());
    let config = SolidConfig { cfl: T::of(cfl), ..SolidConfig::default() };
    let serial = Parallel::serial();
    Solid::new(block.particles, block.spacing, T::of(density), material, WendlandC2, config, &serial).unwrap()
}

/// Whether the energy stays bounded from random velocities of the size `speed` over the wave speed.
pub(crate) fn stays<T: Real, const D: usize, M: ConstitutiveModel<T, D> + Clone>(
    solid: &Solid<T, D, M>,
    dt: T,
    speed: f64,
) -> bool {
    let (mut solid, serial, mut noise) = (solid.clone(), Parallel::serial(), Noise::new(1));
    let size = solid.wave_speed() * T::of(speed);
    solid.velocities_mut().iter_mut().for_each(|u| *u = noise.vector::<T, D>() * size);
    let (rest, zero) = (vec![Vector::zeros(); solid.len()], Vector::zeros());
    let start = solid.energy(&serial, &zero).kinetic.to_double();
    (0..20).all(|_| {
        let done = solid.advance(&serial, &rest, &zero, dt * T::of(50.0), 50);
        done.is_ok() && solid.energy(&serial, &zero).kinetic.to_double() < 1e4 * start
    })
}
