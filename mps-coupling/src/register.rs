//! Interface registration: which structure points form the surface, their normals, and which of
//! them touch the fluid (paper, section 2.2.6). One code for the plane and for space: only the gap between neighbours is measured
//! in another way, as an angle or as a cone ([`has_gap`]).

use crate::CouplingError;
use mps_fluid::surface::{DENSITY_LIMIT, GAP_LIMIT, has_gap};
use mps_kernel::weights::{Kernel, WendlandC2};
use mps_kernel::{Real, ReferenceDensity, Vector};
use mps_neighbors::{Cells, Open, Parallel, Rows};

/// A point touches the fluid if more than this many fluid particles are within the effective radius.
const WETTED_BY_MORE_THAN: usize = 2;
/// Radius of the surface search over the spacing of the structure.
const RADIUS_RATIO: f64 = 2.1;
/// Number density over that of the lattice beyond which the spacing is wrong. Bodies whose particles have been fitted to their outline stay below.
const CROWDED: f64 = 1.3;
/// Neighbours whose mean direction is a smaller share of their mean distance stand on all sides alike; the rest is round-off.
const NO_SIDE: f64 = 1e-3;

/// Surface points of a structure and their outward normals.
#[derive(Debug)]
pub struct Interface<T: Real, const D: usize> {
    /// Whether the point belongs to the surface of the structure.
    pub surface: Vec<bool>,
    /// Outward unit normal of surface points, zero elsewhere and where both sides are outward (a sheet of single points).
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
    /// of a full lattice and a gap between neighbours of their own structure of more than a quarter of the full angle, in
    /// space of the full solid angle. Points behind an inner edge have none.
    ///
    /// `spacing` is the distance between neighbouring points along each axis \[m\]: density and gap are those of the lattice that is drawn
    /// out to the largest of them, or the points of a denser axis would take the place of those that are missing beyond a face.
    ///
    /// Material neighbours stay neighbours, so this is done once; normals follow the motion.
    ///
    /// # Errors
    /// If a position is not finite, or the points lie much closer than the spacing says.
    pub fn register(
        parallel: &Parallel,
        positions: &[Vector<T, D>],
        spacing: &Vector<T, D>,
        fluid_radius: T,
    ) -> Result<Self, CouplingError> {
        let largest = spacing.max();
        let radius = largest * T::of(RADIUS_RATIO);
        // With equal spacings the factors are exactly one.
        let stretch = spacing.map(|along| largest / along);
        let drawn: Vec<_> = positions.iter().map(|r| r.component_mul(&stretch)).collect();
        let mut cells = Cells::new();
        cells.build(parallel, &Open, &drawn, radius)?;
        let mut rows = Rows::default();
        rows.build_within(parallel, &Open, &cells, &drawn, radius)?;

        let len = positions.len();
        let density: Vec<T> = (0..len)
            .map(|i| {
                let weight = |j: &u32| WendlandC2.weight((drawn[*j as usize] - drawn[i]).norm(), radius);
                rows.row(i).iter().map(weight).fold(T::zero(), |a, b| a + b)
            })
            .collect();
        // Of the lattice, not of the densest point: a plate two points thick has no inside to compare with.
        let lattice = ReferenceDensity::lattice::<_, D>(&WendlandC2, largest, radius)?;
        let densest = density.iter().fold(T::zero(), |most, n| most.max(*n)) / lattice.n0;
        if densest > T::of(CROWDED) {
            let spacing = spacing.iter().map(|l| l.to_double()).collect();
            return Err(CouplingError::Crowded { spacing, density: densest.to_double() });
        }
        let full = lattice.n0 * T::of(DENSITY_LIMIT);
        let surface: Vec<bool> = (0..len)
            .map(|i| {
                let around: Vec<_> = rows.row(i).iter().map(|&j| drawn[j as usize] - drawn[i]).collect();
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
            let mut size = T::zero();
            for &j in rows.row(i) {
                let r_ij = positions[j as usize] - positions[i];
                let distance = r_ij.norm();
                let weight = WendlandC2.weight(distance, radius);
                *normal -= r_ij * weight;
                size += distance * weight;
            }
            let length = normal.norm();
            *normal = if length > size * T::of(NO_SIDE) { *normal / length } else { Vector::zeros() };
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
