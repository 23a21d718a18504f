//! What the fluid sees of anything solid: points with a volume and a motion.
//!
//! A boundary point shows each fluid particle a state of its own, pair by pair: the pressure of
//! that particle plus the hydrostatic difference, its density by the equation of state, and the
//! point's velocity. Nothing is extrapolated to the point, so the two sides of a thin plate cannot
//! mix, and the force of the pair on the structure is the pair's force on the fluid with the other
//! sign. Walls are a layer of points at half a spacing behind the surface and layers ("ghosts")
//! behind it as deep as the effective radius.
//!
//! Fluid that slides over a wall feels its points one by one. With the spacing of the fluid this is a
//! roughness that makes noise in the pressure; points at half of it, each with a quarter of the volume
//! in 2D ([`Boundary::add_fine_wall`]), are as good as smooth (`tests/suite/sliding.rs`).

use core::ops::Range;
use mps_kernel::{Real, Vector};

/// How the fluid moves along a boundary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Slip {
    /// No shear force.
    #[default]
    Free,
    /// The fluid's viscosity acts against the boundary: at the surface, half a spacing before the first points, the fluid moves with it.
    None,
    /// A turbulent boundary layer too steep for particles to resolve: the shear stress of a [`WallLaw`](crate::WallLaw) with
    /// [`FluidConfig::wall_viscosity`](crate::FluidConfig::wall_viscosity), whatever the viscosity of the fluid.
    /// On a structure it is held over the sub-steps.
    Law,
}

/// What viscosity makes of a boundary point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shear {
    /// Nothing (free slip).
    #[default]
    Free,
    /// Fluid that flows with the velocity of the point.
    Fluid,
    /// A wall to which the fluid sticks.
    Wall,
    /// Nothing: the shear of the wall follows from a [`WallLaw`](crate::WallLaw).
    Law,
}

/// Walls and wetted structures as one set of points, never reordered. Points are added by [`add_wall`](Self::add_wall) and its sisters, which keep
/// all fields of one length; [`Fluid::new`](crate::Fluid::new) and [`begin_step`](crate::Fluid::begin_step) refuse other ones.
#[derive(Clone, Debug)]
pub struct Boundary<T: Real, const D: usize> {
    /// Position \[m\].
    pub position: Vec<Vector<T, D>>,
    /// Velocity \[m/s\]: over a step, displacement over time step.
    pub velocity: Vec<Vector<T, D>>,
    /// Acceleration \[m/s^2\], for the pressure gradient normal to the boundary.
    pub acceleration: Vec<Vector<T, D>>,
    /// Volume of the point over that of a fluid particle \[-\].
    pub volume: Vec<T>,
    /// What viscosity makes of the point.
    pub shear: Vec<Shear>,
    /// Force of the fluid on the point \[N\], of the reactive points only.
    pub force: Vec<Vector<T, D>>,
    pub(crate) reactive: Range<usize>,
    /// A wall came after a structure and was left out.
    pub(crate) too_late: bool,
}

impl<T: Real, const D: usize> Default for Boundary<T, D> {
    fn default() -> Self {
        Self {
            position: Vec::new(),
            velocity: Vec::new(),
            acceleration: Vec::new(),
            volume: Vec::new(),
            shear: Vec::new(),
            force: Vec::new(),
            reactive: 0..0,
            too_late: false,
        }
    }
}

impl<T: Real, const D: usize> Boundary<T, D> {
    /// Number of points.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there is no boundary at all.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// Points that receive the reaction of the fluid.
    pub fn reactive(&self) -> Range<usize> {
        self.reactive.clone()
    }

    /// Adds the points of a wall that is moved from outside or not at all; each has the volume of
    /// a fluid particle. Walls come before structures.
    ///
    /// Returns the range of the new points, or `None` if a structure has been added before: nothing has been added then, and the fluid refuses to begin or to go on.
    pub fn add_wall(&mut self, points: &[Vector<T, D>], slip: Slip) -> Option<Range<usize>> {
        self.add_fine_wall(points, T::one(), slip)
    }

    /// As [`add_wall`](Self::add_wall), of points that lie closer than the particles of the fluid:
    /// each has the `volume` of this many of them, `1/2^D` at half the spacing. A volume that is not positive is refused by the fluid.
    pub fn add_fine_wall(&mut self, points: &[Vector<T, D>], volume: T, slip: Slip) -> Option<Range<usize>> {
        if !self.reactive.is_empty() {
            self.too_late = true;
            return None;
        }
        let range = self.extend(points, slip);
        self.volume.resize(range.end, volume);
        self.reactive = range.end..range.end;
        Some(range)
    }

    /// Adds the points of a structure that receives the reaction, with their volumes relative to a
    /// fluid particle, one a point. Too few of them, or one that is not positive, are refused by the fluid.
    ///
    /// Returns the range of the new points: they are found nowhere else.
    pub fn add_structure(
        &mut self,
        points: &[Vector<T, D>],
        volume: impl Iterator<Item = T>,
        slip: Slip,
    ) -> Range<usize> {
        let range = self.extend(points, slip);
        self.volume.extend(volume.take(range.len()));
        self.reactive.end = range.end;
        range
    }

    fn extend(&mut self, points: &[Vector<T, D>], slip: Slip) -> Range<usize> {
        let start = self.len();
        let end = start + points.len();
        self.position.extend_from_slice(points);
        self.velocity.resize(end, Vector::zeros());
        self.acceleration.resize(end, Vector::zeros());
        self.force.resize(end, Vector::zeros());
        let shear = match slip {
            Slip::Free => Shear::Free,
            Slip::None => Shear::Wall,
            Slip::Law => Shear::Law,
        };
        self.shear.resize(end, shear);
        start..end
    }
}
