//! Rigid bodies at rest from their description.

use super::bodies::{BodyError, rows};
use super::fitted::fill_as;
use super::lattice::Place;
use super::{vector, vectors};
use crate::rings;
use mps_coupling::Fixed;
use mps_io::scene_file::{Disc, Filling, Fixed as Description, Fluid, Packing, Region};
use mps_kernel::Real;
use mps_neighbors::Parallel;

/// Points of a rigid body.
#[derive(Clone, Debug)]
pub struct FixedPoints<const D: usize> {
    /// Places \[m\].
    pub places: Vec<Place<D>>,
    /// Volume of each \[m^3\], in two dimensions \[m^2\].
    pub volumes: Vec<f64>,
    /// Their distance \[m\].
    pub spacing: f64,
}

impl<const D: usize> FixedPoints<D> {
    /// The points of a body in a fluid.
    ///
    /// # Errors
    /// If rows cannot be made of the numbers, or the region is too thin for points that follow its surface.
    pub(super) fn new(body: &Description, fluid: &Fluid, parallel: &Parallel) -> Result<Self, BodyError> {
        let spacing = body.spacing.unwrap_or(fluid.spacing);
        let (places, volumes) = match (&body.packing, &body.region) {
            (Packing::Rings, Region::Circle(Disc { center, radius })) => {
                // One more than the fluid reaches, whatever the rounding.
                let reach = fluid.numerics.radius * fluid.spacing / spacing;
                let layers = (reach - 1e-6).ceil() as usize + 1;
                let (places, areas) = rings(vector::<f64, 2>(center).into(), *radius, spacing, layers);
                (places.iter().map(|place| vector::<f64, D>(place).into()).collect(), areas)
            }
            (Packing::Rows(disc), Region::Box(corners)) => {
                let (particles, _) = rows::<f64, D>(corners, disc, spacing)?;
                let places = particles.reference_positions().iter().map(|x| (*x).into()).collect();
                (places, particles.volumes().to_vec())
            }
            // What rings and rows are of has been checked.
            (packing, region) => {
                let filling = if *packing == Packing::Fitted { Filling::Fitted } else { Filling::Lattice };
                let (places, volume) = fill_as(filling, region, spacing, parallel)?;
                let volumes = vec![volume; places.len()];
                (places, volumes)
            }
        };
        Ok(Self { places, volumes, spacing })
    }

    /// The body in a scene.
    pub(super) fn body<T: Real>(&self) -> Fixed<T, D> {
        let volumes = self.volumes.iter().map(|volume| T::of(*volume)).collect();
        Fixed::new(vectors(&self.places), volumes, T::of(self.spacing))
    }
}
