//! How long a sub-step of the solid may be: noise in a free block, with sub-steps of the scene's own choice.

use crate::border::{Border, Breaks};
use mps_examples::{Failure, Noise};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::Parallel;
use mps_solid::materials::CorotationalHooke;
use mps_solid::{Solid, SolidConfig, body};

/// Sub-steps of a trial, and how many of them are one call.
const STEPS: usize = 2000;
const CHUNK: usize = 20;
/// Speed of the noise over that of the fastest wave.
const SPEED: f64 = 1e-6;

/// A block with the spacing as the unit of length and the modulus as that of stress.
fn block<const D: usize>(
    counts: [usize; D],
    poisson: f64,
) -> Result<Solid<f64, D, CorotationalHooke<f64>>, Failure> {
    let upper = Vector::from(counts.map(|n| n as f64));
    let block = body::block(Vector::zeros(), upper, counts, &[])?;
    let material = CorotationalHooke::new(1.0, poisson)?;
    let config = SolidConfig::default();
    Ok(Solid::new(block.particles, block.spacing, 1.0, material, WendlandC2, config, &Parallel::serial())?)
}

/// Kinetic energy over that at the start, at the end of the trial.
fn growth<const D: usize>(counts: [usize; D], poisson: f64, share: f64) -> Result<f64, Failure> {
    let parallel = Parallel::serial();
    let mut solid = block(counts, poisson)?;
    let (mut noise, speed) = (Noise::default(), SPEED * solid.wave_speed());
    solid.velocities_mut().iter_mut().for_each(|u| *u = noise.vector() * speed);
    let (rest, zero) = (vec![Vector::zeros(); solid.len()], Vector::zeros());
    let start = solid.energy(&parallel, &zero).kinetic;
    let dt = share * solid.stability_limit();
    for _ in 0..STEPS / CHUNK {
        solid.advance(&parallel, &rest, &zero, dt * CHUNK as f64, CHUNK)?;
    }
    Ok(solid.energy(&parallel, &zero).kinetic / start)
}

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "solid-courant",
        parameter: "sub-step over the 2/omega_max the solid has measured",
        measure: "kinetic energy over that at the start",
        bound: 1e4,
        scene: |x| growth([16, 4], 0.4, x),
        predicted: Some(|| Ok(1.0)),
        whole: false,
        breaks: Breaks::BlowUp,
        mechanism: "the highest mode of the body turns by more than half a turn in a sub-step, 2/omega_max",
        remedy: "none needed: the solid measures its 2/omega_max and takes 0.8 of it; the scene does not ask it",
    };
    vec![
        base,
        Border { name: "solid-courant-rubber", scene: |x| growth([16, 4], 0.49, x), ..base },
        Border { name: "solid-courant-3d", scene: |x| growth([6, 3, 3], 0.3, x), ..base },
    ]
}
