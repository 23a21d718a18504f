//! Elastic bodies from their description.

use super::fitted::fill_as;
use super::lattice::Place;
use super::{Law, vector};
use crate::Failure;
use crate::solid::begin_at;
use crate::solid::plate::first_mode;
use mps_io::scene_file::{
    Clamp, Corners, Disc, Filling, InitialVelocity, Region, Side, Solid as Description,
};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_neighbors::fit::FitError;
use mps_solid::body::{Body, Face, block, counts};
use mps_solid::materials::Ambient;
use mps_solid::{Solid, SolidConfig, SolidError, SolidParticles};
use thiserror::Error;

/// An elastic body of a scene.
type Made<T, const D: usize> = Solid<T, D, Ambient<Law<T>, T>>;

/// Why no body was made of a region.
#[derive(Debug, Error)]
pub(super) enum BodyError {
    /// Numbers of which no rows can be made.
    #[error(transparent)]
    Rows(#[from] SolidError),
    /// A surface that particles cannot follow.
    #[error(transparent)]
    Fit(#[from] FitError),
}

/// The particles of a body and their distance along each axis \[m\].
///
/// A box that is free or held on sides is a block of `mps-solid`, which puts the first row of a held side exactly on
/// it; everything else is a lattice, or fitted to its surface, and its particles in the clamp are held.
///
/// # Errors
/// If a box is too thin for rows, or a region for particles that follow its surface.
pub(super) fn particles<T: Real, const D: usize>(
    solid: &Description,
    parallel: &Parallel,
) -> Result<(SolidParticles<T, D>, Vector<T, D>), BodyError> {
    if let (Filling::Lattice, Region::Box(corners)) = (solid.packing, &solid.region) {
        match &solid.clamp {
            None => return Ok(whole(stretched(corners, solid.spacing, &[])?)),
            Some(Clamp::Sides(sides)) => {
                let faces: Vec<Face> = sides.iter().copied().map(face).collect();
                return Ok(whole(stretched(corners, solid.spacing, &faces)?));
            }
            Some(Clamp::Disc(disc)) => return Ok(rows(corners, disc, solid.spacing)?),
            Some(Clamp::Region(_)) => {}
        }
    }
    let mut particles = SolidParticles::new();
    let (places, volume) = fill_as::<D>(solid.packing, &solid.region, solid.spacing, parallel)?;
    let margin = 1e-6 * solid.spacing;
    for place in places {
        let held = match &solid.clamp {
            Some(Clamp::Region(region)) => region.contains(&place, margin),
            _ => false,
        };
        particles.push(vector(&place), T::of(volume), held);
    }
    Ok((particles, Vector::repeat(T::of(solid.spacing))))
}

/// A box whose spacing is fitted to it, with its first particles exactly on the faces.
fn stretched<T: Real, const D: usize>(
    Corners { lower, upper }: &Corners,
    spacing: f64,
    faces: &[Face],
) -> Result<Body<T, D>, SolidError> {
    let (lower, upper) = (vector(lower), vector(upper));
    // As many as fit, not the two at least that `counts` gives: a thin body is to be refused.
    let mut counts = counts(&lower, &upper, T::of(spacing), faces);
    for axis in 0..D {
        let cells = ((upper[axis] - lower[axis]) / T::of(spacing)).to_double();
        counts[axis] = if cells < 1.5 { 1 } else { counts[axis] };
    }
    block(lower, upper, counts, faces)
}

fn whole<T: Real, const D: usize>(block: Body<T, D>) -> (SolidParticles<T, D>, Vector<T, D>) {
    (block.particles, block.spacing)
}

/// A box whose rows begin on a disc at its left end, and are held there.
pub(super) fn rows<T: Real, const D: usize>(
    corners: &Corners,
    disc: &Disc,
    spacing: f64,
) -> Result<(SolidParticles<T, D>, Vector<T, D>), SolidError> {
    let block = stretched(corners, spacing, &[face(Side::Left)])?;
    let (lower, upper) = (vector(&corners.lower), vector(&corners.upper));
    // The check has let pass discs that reach all rows.
    let start = |y: f64| disc.right_of(y).unwrap_or(corners.lower[0]);
    Ok((begin_at(&block, &lower, &upper, start), block.spacing))
}

fn face(side: Side) -> Face {
    if side.is_upper() { Face::upper(side.axis()) } else { Face::lower(side.axis()) }
}

/// The body of these particles, to be asked for its points. What follows a surface is not made once more.
///
/// # Errors
/// As [`body`].
pub(super) fn drawn<const D: usize>(
    description: &Description,
    points: &[(Place<D>, bool)],
    parallel: &Parallel,
) -> Result<Made<f64, D>, Failure> {
    let (particles, spacing) = if description.packing == Filling::Lattice {
        particles(description, parallel)?
    } else {
        let mut particles = SolidParticles::new();
        points.iter().for_each(|(place, held)| {
            particles.push(vector(place), description.spacing.powi(D as i32), *held)
        });
        (particles, Vector::repeat(description.spacing))
    };
    at_rest(description, particles, spacing, 0.0, parallel)
}

fn at_rest<T: Real, const D: usize>(
    description: &Description,
    particles: SolidParticles<T, D>,
    spacing: Vector<T, D>,
    background: f64,
    parallel: &Parallel,
) -> Result<Made<T, D>, Failure> {
    let pressure = T::of(description.ambient_pressure.unwrap_or(background));
    Ok(Solid::new(
        particles,
        spacing,
        T::of(description.density),
        Ambient { material: Law::new(&description.material)?, pressure },
        WendlandC2,
        SolidConfig { damping: T::of(description.damping), ..SolidConfig::default() },
        parallel,
    )?)
}

/// The body with its velocities at the start, in a fluid of this background pressure \[Pa\].
pub(super) fn body<T: Real, const D: usize>(
    description: &Description,
    background: f64,
    parallel: &Parallel,
) -> Result<Made<T, D>, Failure> {
    let (particles, spacing) = particles(description, parallel)?;
    let held: Vec<bool> = (0..particles.ids().len()).map(|i| particles.is_clamped(i)).collect();
    let mut solid = at_rest(description, particles, spacing, background, parallel)?;
    let Some(velocity) = &description.velocity else { return Ok(solid) };
    let start: Vec<Vector<T, D>> = match velocity {
        InitialVelocity::Uniform(velocity) => vec![vector(velocity); held.len()],
        InitialVelocity::FirstMode(tip) => {
            let Some(Corners { lower, upper }) = description.region.bounds() else { return Ok(solid) };
            let along = |x: &Vector<T, D>| (x[0].to_double() - lower[0]) / (upper[0] - lower[0]);
            let speed = |x| {
                let bending = T::of(tip * first_mode(along(x)));
                Vector::from_fn(|axis, _| if axis == 1 { bending } else { T::zero() })
            };
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
