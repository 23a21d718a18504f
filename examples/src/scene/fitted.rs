//! Regions filled with particles that follow their surfaces.

use super::lattice::{Place, fill};
use super::vector;
use mps_io::scene_file::{Corners, Filling, Region, Surface};
use mps_kernel::Vector;
use mps_neighbors::Parallel;
use mps_neighbors::fit::{FitError, Nearest, Shape, fit};

/// Places of particles \[m\] and the volume of each \[m^D\].
pub(super) type Filled<const D: usize> = (Vec<Place<D>>, f64);

/// A region as a shape that can be filled.
struct Bounded<'a> {
    surface: Surface<'a>,
    corners: Corners,
}

impl<const D: usize> Shape<D> for Bounded<'_> {
    fn bounds(&self) -> [Vector<f64, D>; 2] {
        [vector(&self.corners.lower), vector(&self.corners.upper)]
    }

    fn nearest(&self, place: &Vector<f64, D>) -> Option<Nearest<D>> {
        let foot = self.surface.nearest(place.as_slice())?;
        Some(Nearest { foot: vector(&foot.place), depth: foot.depth })
    }
}

/// Fills a region in this way with particles of a `spacing` \[m\].
///
/// # Errors
/// If a region is too thin or too small for particles that follow its surface.
pub(super) fn fill_as<const D: usize>(
    filling: Filling,
    region: &Region,
    spacing: f64,
    parallel: &Parallel,
) -> Result<Filled<D>, FitError> {
    match filling {
        Filling::Lattice => Ok((fill(region, spacing), spacing.powi(D as i32))),
        Filling::Fitted => fitted(region, spacing, parallel),
    }
}

/// Fills a region with particles the outermost of which lie half a spacing inside its surface.
///
/// # Errors
/// As [`fit`].
fn fitted<const D: usize>(region: &Region, spacing: f64, parallel: &Parallel) -> Result<Filled<D>, FitError> {
    let (Some(surface), Some(corners)) = (region.surface(), region.bounds()) else {
        return Err(FitError::Empty { spacing });
    };
    let filled = fit(&Bounded { surface, corners }, spacing, parallel)?;
    Ok((filled.places.into_iter().map(Place::from).collect(), filled.volume))
}
