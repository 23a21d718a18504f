//! Interface registration: which structure points form the surface, their normals, and which of
//! them touch the fluid (paper, section 2.2.6).

use crate::CouplingError;
use mps_fluid::surface::{DENSITY_LIMIT, GAP_LIMIT, has_gap};
use mps_kernel::weights::{Kernel, WendlandC2};
use mps_kernel::{Real, ReferenceDensity, Vector};
use mps_neighbors::{Cells, Open, Parallel, Rows};

/// A point touches the fluid if more than this many fluid particles are within the effective radius.
const WETTED_BY_MORE_THAN: usize = 2;
/// Radius of the surface search over the spacing of the structure.
const RADIUS_RATIO: f64 = 2.1;

/// Surface points of a structure and their outward normals.
#[derive(Debug)]
pub struct Interface<T: Real, const D: usize> {
    /// Whether the point belongs to the surface of the structure.
    pub surface: Vec<bool>,
    /// Outward unit normal of surface points, zero elsewhere.
    pub normal: Vec<Vector<T, D>>,
    /// Whether the surface point touches the fluid at present.
    pub wetted: Vec<bool>,
    /// Points the fluid sees: the surface and what lies within the effective radius of the fluid
    /// behind it. They are the walls and ghosts of the fluid.
    pub visible: Vec<u32>,
    pub(crate) rows: Rows,
    pub(crate) radius: T,
}

impl<T: Real, const D: usize> Interface<T, D> {
    /// Finds the surface of the undeformed structure: points with less than 0.95 of the number density
    /// of a full lattice and an angular gap of more than a quarter of the full angle between
    /// neighbours of their own structure.
    ///
    /// Material neighbours stay neighbours, so this is done once; normals follow the motion.
    ///
    /// # Errors
    /// If a position is not finite.
    pub fn register(
        parallel: &Parallel,
        positions: &[Vector<T, D>],
        spacing: T,
        fluid_radius: T,
    ) -> Result<Self, CouplingError> {
        let radius = spacing * T::of(RADIUS_RATIO);
        let mut cells = Cells::new();
        cells.build(parallel, &Open, positions, radius)?;
        let mut rows = Rows::default();
        rows.build_within(parallel, &Open, &cells, positions, radius)?;

        let len = positions.len();
        let density: Vec<T> = (0..len)
            .map(|i| {
                let weight =
                    |j: &u32| WendlandC2.weight((positions[*j as usize] - positions[i]).norm(), radius);
                rows.row(i).iter().map(weight).fold(T::zero(), |a, b| a + b)
            })
            .collect();
        // Of the lattice, not of the densest point: a plate two points thick has no inside to compare with.
        let lattice = ReferenceDensity::lattice::<_, D>(&WendlandC2, spacing, radius)?;
        let full = lattice.n0 * T::of(DENSITY_LIMIT);
        let surface: Vec<bool> = (0..len)
            .map(|i| {
                let around: Vec<_> =
                    rows.row(i).iter().map(|&j| positions[j as usize] - positions[i]).collect();
                let lean = around.iter().fold(Vector::zeros(), |a: Vector<T, D>, r| a + r);
                density[i] < full && has_gap(&around, &lean, GAP_LIMIT)
            })
            .collect();

        let at_surface: Vec<Vector<T, D>> = (0..len).filter(|&i| surface[i]).map(|i| positions[i]).collect();
        let mut near = Rows::default();
        cells.build(parallel, &Open, &at_surface, fluid_radius)?;
        near.build_between(parallel, &Open, &cells, positions, &at_surface, fluid_radius)?;
        let visible = (0..len as u32).filter(|&i| !near.row(i as usize).is_empty()).collect();

        let mut interface = Self {
            surface,
            normal: vec![Vector::zeros(); len],
            wetted: vec![false; len],
            visible,
            rows,
            radius,
        };
        interface.update_normals(parallel, positions);
        Ok(interface)
    }

    /// Normals of the deformed surface: against the weighted mean direction to the neighbours.
    pub fn update_normals(&mut self, parallel: &Parallel, positions: &[Vector<T, D>]) {
        let (rows, surface, radius) = (&self.rows, &self.surface, self.radius);
        parallel.update(self.normal.as_mut_slice(), |i, normal| {
            *normal = Vector::zeros();
            if !surface[i] {
                return;
            }
            for &j in rows.row(i) {
                let r_ij = positions[j as usize] - positions[i];
                *normal -= r_ij * WendlandC2.weight(r_ij.norm(), radius);
            }
            let length = normal.norm();
            if length > T::zero() {
                *normal /= length;
            }
        });
    }

    /// Marks the surface points with more than two fluid particles around them; `contacts(k)` is
    /// the number of fluid particles that see visible point `k`.
    pub fn update_wetted(&mut self, contacts: impl Fn(usize) -> usize) {
        for (k, &i) in self.visible.iter().enumerate() {
            let i = i as usize;
            self.wetted[i] = self.surface[i] && contacts(k) > WETTED_BY_MORE_THAN;
        }
    }

    /// Number of surface points that touch the fluid.
    pub fn wetted_count(&self) -> usize {
        self.wetted.iter().filter(|&&w| w).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plate_has_its_rim_as_surface_with_outward_normals() {
        let l0 = 0.1;
        let (nx, ny) = (12, 6);
        let points: Vec<Vector<f64, 2>> = (0..nx * ny)
            .map(|k| Vector::from([l0 * (0.5 + (k % nx) as f64), l0 * (0.5 + (k / nx) as f64)]))
            .collect();
        let interface = Interface::register(&Parallel::serial(), &points, l0, 3.0 * l0).unwrap();
        for (i, _) in points.iter().enumerate() {
            let (x, y) = (i % nx, i / nx);
            let rim = x == 0 || y == 0 || x == nx - 1 || y == ny - 1;
            assert_eq!(interface.surface[i], rim, "point {x}, {y}");
            if rim && x > 2 && x < nx - 3 {
                let outward = if y == 0 { -1.0 } else { 1.0 };
                approx::assert_relative_eq!(interface.normal[i][1], outward, epsilon = 1e-12);
            }
        }
        // Corners point along the diagonal.
        approx::assert_relative_eq!(interface.normal[0][0], -0.5_f64.sqrt(), epsilon = 1e-12);
    }

    /// Only the ends of a plate two points thick were once found.
    #[test]
    fn every_point_of_a_thin_plate_is_surface() {
        let l0 = 0.1;
        for layers in 1..=2 {
            let points: Vec<Vector<f64, 2>> = (0..12 * layers)
                .map(|k| Vector::from([l0 * (k / layers) as f64, l0 * (k % layers) as f64]))
                .collect();
            let interface = Interface::register(&Parallel::serial(), &points, l0, 3.0 * l0).unwrap();
            assert!(interface.surface.iter().all(|&s| s), "{layers} layers: {:?}", interface.surface);
            assert_eq!(interface.visible.len(), points.len());
        }
    }

    #[test]
    fn the_inside_of_a_thick_body_is_not_shown_to_the_fluid() {
        let l0 = 0.1;
        let n = 20;
        let points: Vec<Vector<f64, 2>> =
            (0..n * n).map(|k| Vector::from([l0 * (k % n) as f64, l0 * (k / n) as f64])).collect();
        let interface = Interface::register(&Parallel::serial(), &points, l0, 3.05 * l0).unwrap();
        let hidden = n * n - interface.visible.len();
        assert_eq!(hidden, (n - 8) * (n - 8), "four layers deep are visible");
    }
}
