//! Bodies that touch, and what they keep.

use approx::assert_relative_eq;
use core::f64::consts::PI;
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Real, Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::body;
use mps_solid::contact::{Contact, ContactConfig, Elastic};
use mps_solid::materials::{Moduli, NeoHookean};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig, SolidParticles};

pub(crate) type V = Vector<f64, 2>;

pub(crate) fn solid<T: Real, const D: usize, M: ConstitutiveModel<T, D>>(
    particles: SolidParticles<T, D>,
    spacing: Vector<T, D>,
    material: M,
    config: SolidConfig<T>,
) -> Solid<T, D, M> {
    let serial = Parallel::serial();
    Solid::new(particles, spacing, T::of(1000.0), material, WendlandC2, config, &serial).unwrap()
}

/// A block of `counts` particles `l` apart from the corner `lower`.
pub(crate) fn block<const D: usize, M: ConstitutiveModel<f64, D>>(
    lower: Vector<f64, D>,
    counts: [usize; D],
    l: f64,
    material: M,
) -> Solid<f64, D, M> {
    let upper = lower + Vector::from_fn(|axis, _| l * counts[axis] as f64);
    let block = body::block(lower, upper, counts, &[]).unwrap();
    solid(block.particles, block.spacing, material, SolidConfig::default())
}

/// The rubber of the rings of Swegle: K = 3.25 MPa, G = 0.715 MPa.
pub(crate) fn rubber() -> NeoHookean<f64> {
    NeoHookean { moduli: Moduli::from_bulk_and_shear(3.25e6, 0.715e6).unwrap() }
}

/// A ring of layers of particles, `number` in each; its volumes add up to its area.
pub(crate) fn ring_particles(
    center: V,
    radii: [f64; 2],
    layers: usize,
    number: usize,
) -> SolidParticles<f64, 2> {
    let mut particles = SolidParticles::new();
    let width = (radii[1] - radii[0]) / layers as f64;
    for k in 0..number {
        // Not the same on the left and the right, above and below.
        let angle = 2.0 * PI * (k as f64 + 0.3) / number as f64;
        for layer in 0..layers {
            let r = radii[0] + width * (layer as f64 + 0.5);
            let place = center + V::new(angle.cos(), angle.sin()) * r;
            particles.push(place, 2.0 * PI * r * width / number as f64, false);
        }
    }
    particles
}

pub(crate) fn ring(center: V, layers: usize) -> Solid<f64, 2, NeoHookean<f64>> {
    let l = 0.01 / layers as f64;
    let number = (2.0 * PI * 0.035 / l).round() as usize;
    let particles = ring_particles(center, [0.03, 0.04], layers, number);
    let area: f64 = particles.volumes().iter().sum();
    assert_relative_eq!(area, PI * (0.04 * 0.04 - 0.03 * 0.03), max_relative = 1e-12);
    solid(particles, V::repeat(l), rubber(), SolidConfig::default())
}

pub(crate) fn contact<T: Real, const D: usize>(bodies: &[&dyn Elastic<T, D>]) -> Contact<T, D> {
    let mut contact = Contact::new(ContactConfig::default()).unwrap();
    for (number, body) in bodies.iter().enumerate() {
        assert_eq!(contact.add(&body.shape()).unwrap(), number);
    }
    contact
}

pub(crate) fn none<'a, const D: usize>(_: usize) -> &'a [Vector<f64, D>] {
    &[]
}

pub(crate) fn kept<const D: usize, M: ConstitutiveModel<f64, D>>(
    bodies: &[&Solid<f64, D, M>],
) -> (Vector<f64, D>, Tensor<f64, D>) {
    let serial = Parallel::serial();
    let momentum = bodies.iter().map(|body| body.momentum(&serial)).sum();
    let spin = bodies.iter().map(|body| body.angular_momentum(&serial, &Vector::zeros())).sum();
    (momentum, spin)
}

pub(crate) fn total<const D: usize, M: ConstitutiveModel<f64, D>>(
    bodies: &[&Solid<f64, D, M>],
    contact: &Contact<f64, D>,
) -> f64 {
    let of = |body: &&Solid<f64, D, M>| body.energy(&Parallel::serial(), &Vector::zeros()).total();
    bodies.iter().map(of).sum::<f64>() + contact.energy()
}

pub(crate) fn mean(vectors: &[V]) -> V {
    vectors.iter().sum::<V>() / vectors.len() as f64
}
