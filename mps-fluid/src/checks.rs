//! What a fluid refuses to begin with, by the name of the field and the number of the particle or point.

use crate::terms::Viscosity;
use crate::{Boundary, Fluid, FluidError, FluidParticles};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Domain;

/// The least density ratio, in every step: far below any of a connected fluid, it keeps the ratios `n_i/n_j` of spray finite.
pub(crate) const THINNEST: f64 = 0.1;

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

    /// Refuses particles that are nowhere, or have a motion or a density that is no number or too small a density.
    pub(crate) fn check_values(&self) -> Result<(), FluidError> {
        for (i, &density) in self.density.iter().enumerate() {
            let refuse = |quantity, value: T, hint| {
                Err(FluidError::Initial { id: self.id[i], quantity, value: value.to_double(), hint })
            };
            // NaN is not larger either. `>=`, as that is where every step ends.
            if !(density >= T::of(THINNEST) && density.is_finite()) {
                return refuse(
                    "density",
                    density,
                    "it is that over the reference density, at least 0.1, and 1 at rest",
                );
            }
            for (quantity, vector) in [("position", &self.position[i]), ("velocity", &self.velocity[i])] {
                if let Some(value) = not_finite(vector) {
                    return refuse(quantity, value, "it has to be a finite number");
                }
            }
        }
        Ok(())
    }
}

/// The kinematic viscosity \[m^2/s\], if it is one.
pub(crate) fn check_viscosity<T: Real>(value: T) -> Result<(), FluidError> {
    let (value, high) = (value.to_double(), f64::MAX);
    if value >= 0.0 && value <= high {
        return Ok(());
    }
    let hint = "kinematic, in m2/s; of the artificial one it is alpha c l0/(2 (D + 2))";
    Err(FluidError::Parameter { name: "viscosity", value, low: 0.0, high, hint })
}

impl<T: Real, const D: usize> Boundary<T, D> {
    /// Refuses fields of another length than the positions, and to be without a wall that was to be added.
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
        if self.too_late { Err(FluidError::WallTooLate) } else { Ok(()) }
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
