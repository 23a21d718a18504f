//! What a fluid refuses to begin with, by the name of the field and the number of the particle or point.

use crate::terms::Viscosity;
use crate::{Boundary, Fluid, FluidError, FluidParticles};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Domain;

impl<T: Real, const D: usize> FluidParticles<T, D> {
    /// Refuses fields of another length than the positions.
    pub(crate) fn check_lengths(&self) -> Result<(), FluidError> {
        let particles = self.position.len();
        for (field, len) in [
            ("velocity", self.velocity.len()),
            ("density", self.density.len()),
            ("pressure", self.pressure.len()),
            ("id", self.id.len()),
        ] {
            if len != particles {
                return Err(FluidError::FieldLength { field, len, particles });
            }
        }
        Ok(())
    }
}

impl<T: Real, const D: usize> Boundary<T, D> {
    /// Refuses fields of another length than the positions.
    pub(crate) fn check_lengths(&self) -> Result<(), FluidError> {
        let points = self.position.len();
        for (field, len) in [
            ("velocity", self.velocity.len()),
            ("acceleration", self.acceleration.len()),
            ("volume", self.volume.len()),
            ("shear", self.shear.len()),
            ("force", self.force.len()),
            // The last of the points that receive the reaction.
            ("position", self.reactive.end.max(points)),
        ] {
            if len != points {
                return Err(FluidError::BoundaryLength { field, len, points });
            }
        }
        Ok(())
    }

    /// Refuses points that are nowhere or show the fluid nothing, or something that is no number.
    pub(crate) fn check_points(&self) -> Result<(), FluidError> {
        for (point, &volume) in self.volume.iter().enumerate() {
            let refuse = |quantity, value: T, hint| {
                Err(FluidError::BoundaryPoint { point, quantity, value: value.to_double(), hint })
            };
            // NaN is not greater either.
            if !(volume > T::zero() && volume.is_finite()) {
                return refuse(
                    "volume",
                    volume,
                    "it is that over the volume of a fluid particle, and has to be positive",
                );
            }
            for (quantity, vector) in [
                ("position", &self.position[point]),
                ("velocity", &self.velocity[point]),
                ("acceleration", &self.acceleration[point]),
            ] {
                if let Some(value) = not_finite(vector) {
                    return refuse(quantity, value, "it has to be a finite number");
                }
            }
        }
        Ok(())
    }
}

/// The first component that is no finite number.
fn not_finite<T: Real, const D: usize>(vector: &Vector<T, D>) -> Option<T> {
    vector.iter().copied().find(|x| !x.is_finite())
}

impl<T: Real, const D: usize, K: Kernel<T>, V: Viscosity<T, D>, P: Domain<T, D>> Fluid<T, D, K, V, P> {
    /// Refuses fields whose number of entries has been changed from outside: the loops of a step rely on them. Costs a few comparisons.
    pub(crate) fn check_lengths(&self) -> Result<(), FluidError> {
        let (len, particles) = (self.particles.position.len(), self.rates.state.len());
        if len != particles {
            return Err(FluidError::FieldLength { field: "position", len, particles });
        }
        self.particles.check_lengths()?;
        self.boundary.check_lengths()
    }
}
