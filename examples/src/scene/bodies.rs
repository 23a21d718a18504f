//! Elastic bodies from their description.

use super::lattice::fill;
use super::{Law, vector};
use crate::Failure;
use crate::solid::plate::first_mode;
use mps_io::scene_file::{Clamp, Corners, InitialVelocity, Region, Side, Solid as Description};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::{Face, block, counts};
use mps_solid::{Solid, SolidConfig, SolidError, SolidParticles};

/// The particles of a body and their distance along each axis \[m\].
///
/// A box that is free or held on sides is a block of `mps-solid`, which puts the first row of a held side exactly on
/// it; everything else is a lattice whose particles in the clamp are held.
pub(super) fn particles<T: Real>(
    solid: &Description,
) -> Result<(SolidParticles<T, 2>, Vector<T, 2>), SolidError> {
    if let (Region::Box(Corners { lower, upper }), None | Some(Clamp::Sides(_))) =
        (&solid.region, &solid.clamp)
    {
        let faces: Vec<Face> = match &solid.clamp {
            Some(Clamp::Sides(sides)) => sides.iter().copied().map(face).collect(),
            _ => Vec::new(),
        };
        let (lower, upper) = (vector(lower), vector(upper));
        // As many as fit, not the two at least that `counts` gives: a thin body is to be refused.
        let mut counts = counts(&lower, &upper, T::of(solid.spacing), &faces);
        for axis in 0..2 {
            let cells = ((upper[axis] - lower[axis]) / T::of(solid.spacing)).to_double();
            counts[axis] = if cells < 1.5 { 1 } else { counts[axis] };
        }
        let body = block(lower, upper, counts, &faces)?;
        return Ok((body.particles, body.spacing));
    }
    let mut particles = SolidParticles::new();
    let volume = T::of(solid.spacing * solid.spacing);
    let margin = 1e-6 * solid.spacing;
    for place in fill(&solid.region, solid.spacing) {
        let held = match &solid.clamp {
            Some(Clamp::Region(region)) => region.contains(&place, margin),
            _ => false,
        };
        particles.push(vector(&place), volume, held);
    }
    Ok((particles, Vector::repeat(T::of(solid.spacing))))
}

fn face(side: Side) -> Face {
    match side {
        Side::Left => Face::lower(0),
        Side::Right => Face::upper(0),
        Side::Bottom => Face::lower(1),
        Side::Top => Face::upper(1),
    }
}

/// The body with its velocities at the start.
pub(super) fn body<T: Real>(
    description: &Description,
    parallel: &Parallel,
) -> Result<Solid<T, 2, Law<T>>, Failure> {
    let (particles, spacing) = particles(description)?;
    let held: Vec<bool> = (0..particles.ids().len()).map(|i| particles.is_clamped(i)).collect();
    let mut solid = Solid::new(
        particles,
        spacing,
        T::of(description.density),
        Law::new(&description.material)?,
        WendlandC2,
        SolidConfig::default(),
        parallel,
    )?;
    let Some(velocity) = &description.velocity else { return Ok(solid) };
    let start: Vec<Vector<T, 2>> = match velocity {
        InitialVelocity::Uniform(velocity) => vec![vector(velocity); held.len()],
        InitialVelocity::FirstMode(tip) => {
            let Some(Corners { lower, upper }) = description.region.bounds() else { return Ok(solid) };
            let along = |x: &Vector<T, 2>| (x[0].to_double() - lower[0]) / (upper[0] - lower[0]);
            let speed = |x| Vector::from([T::zero(), T::of(tip * first_mode(along(x)))]);
            solid.positions().iter().map(speed).collect()
        }
    };
    for ((u, start), held) in solid.velocities_mut().iter_mut().zip(start).zip(held) {
        if !held {
            *u = start;
        }
    }
    Ok(solid)
}
