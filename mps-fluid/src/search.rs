//! The neighbour rows of the fluid and when they are rebuilt.

use crate::rates::Rates;
use crate::{Boundary, FluidConfig, FluidError, FluidParticles};
use mps_kernel::{Real, Transfer, Vector};
use mps_neighbors::{Cells, Domain, NeighborError, Parallel, Permutation, Rows, Skin};

/// Rows fluid -> fluid, fluid -> boundary and structure -> fluid, valid until somebody has moved
/// half a skin.
#[derive(Debug)]
pub(crate) struct Search<T: Real, const D: usize> {
    /// Neighbours within the effective radius.
    pub(crate) fluid: Rows,
    /// Boundary points within the effective radius; empty without a boundary.
    pub(crate) boundary: Rows,
    /// For each reactive boundary point, the fluid particles that see it.
    pub(crate) reaction: Rows,
    /// Neighbours within one spacing, for collisions; empty if those are off.
    pub(crate) close: Rows,
    cells: Cells<T, D>,
    boundary_cells: Cells<T, D>,
    permutation: Permutation,
    skin: Skin<T, D>,
    reach: T,
    close_reach: Option<T>,
    /// Number of rebuilds so far.
    pub(crate) rebuilds: u64,
}

impl<T: Real, const D: usize> Search<T, D> {
    pub(crate) fn new(config: &FluidConfig<T, D>) -> Self {
        let skin = config.skin_ratio * config.spacing;
        // Shifting moves particles between the check and the sweeps; its bound is kept in reserve, and rows reach as far even without a skin.
        let reserve = match config.shifting {
            Some(_) => T::of(2.0) * crate::regularize::largest_shift(config.spacing),
            None => T::zero(),
        };
        Self {
            fluid: Rows::default(),
            boundary: Rows::default(),
            reaction: Rows::default(),
            close: Rows::default(),
            cells: Cells::new(),
            boundary_cells: Cells::new(),
            permutation: Permutation::default(),
            skin: Skin::new((skin - reserve).max(T::zero())),
            reach: config.radius() + skin.max(reserve),
            close_reach: config.collisions.map(|_| config.spacing + skin.max(reserve)),
            rebuilds: 0,
        }
    }

    /// Whether somebody has moved so far that a pair could be missing.
    pub(crate) fn expired<P: Domain<T, D>>(
        &self,
        parallel: &Parallel,
        domain: &P,
        particles: &FluidParticles<T, D>,
        boundary: &Boundary<T, D>,
    ) -> bool {
        self.skin.expired(parallel, domain, &[&particles.position, &boundary.position])
    }

    /// Whether there are rows, and of as many particles and boundary points.
    pub(crate) fn is_of(&self, particles: &FluidParticles<T, D>, boundary: &Boundary<T, D>) -> bool {
        let now = [particles.position.len(), boundary.position.len()];
        self.skin.built_from().is_some_and(|sets| sets.iter().map(Vec::len).eq(now))
    }

    /// Puts the particles into spatial order, with what has been measured of them, and builds all rows anew.
    pub(crate) fn rebuild<P: Domain<T, D>>(
        &mut self,
        parallel: &Parallel,
        domain: &P,
        particles: &mut FluidParticles<T, D>,
        rates: &mut Rates<T, D>,
        boundary: &Boundary<T, D>,
    ) -> Result<(), FluidError> {
        self.cells.build(parallel, domain, &particles.position, self.reach)?;
        self.permutation.apply(particles, self.cells.order())?;
        rates.reorder(&mut self.permutation, self.cells.order())?;
        self.cells.settle();
        self.find_rows(parallel, domain, &particles.position, &boundary.position, boundary)?;
        self.skin.renew(&[&particles.position, &boundary.position]);
        self.rebuilds += 1;
        Ok(())
    }

    /// Rows of the particles at `points`, for which the cells are built, among themselves and among boundary points at `walls`.
    fn find_rows<P: Domain<T, D>>(
        &mut self,
        parallel: &Parallel,
        domain: &P,
        points: &[Vector<T, D>],
        walls: &[Vector<T, D>],
        boundary: &Boundary<T, D>,
    ) -> Result<(), NeighborError> {
        self.fluid.build_within(parallel, domain, &self.cells, points, self.reach)?;
        if let Some(reach) = self.close_reach {
            self.close.build_within(parallel, domain, &self.cells, points, reach)?;
        }
        if !walls.is_empty() {
            self.boundary_cells.build(parallel, domain, walls, self.reach)?;
            self.boundary.build_between(parallel, domain, &self.boundary_cells, points, walls, self.reach)?;
            if !boundary.reactive().is_empty() {
                self.reaction.transpose_of(&self.boundary, walls.len())?;
            }
        }
        Ok(())
    }

    /// Saves or restores where everybody was when the rows were built, and builds the same rows again.
    pub(crate) fn transfer<P: Domain<T, D>>(
        &mut self,
        parallel: &Parallel,
        domain: &P,
        boundary: &Boundary<T, D>,
        transfer: &mut Transfer<'_>,
    ) {
        // The rows follow from the skin; cells and permutation are working space.
        let Self {
            fluid: _,
            boundary: _,
            reaction: _,
            close: _,
            cells: _,
            boundary_cells: _,
            permutation: _,
            skin,
            reach: _,
            close_reach: _,
            rebuilds,
        } = self;
        transfer.within("skin", |transfer| skin.transfer(transfer));
        transfer.value("rebuilds", rebuilds);
        if transfer.is_restoring()
            && transfer.is_good()
            && let Err(error) = self.rebuild_from_skin(parallel, domain, boundary)
        {
            transfer.refuse(error);
        }
    }

    fn rebuild_from_skin<P: Domain<T, D>>(
        &mut self,
        parallel: &Parallel,
        domain: &P,
        boundary: &Boundary<T, D>,
    ) -> Result<(), NeighborError> {
        // Taken out for as long as the rows are built.
        let skin = self.skin.clone();
        if let Some([points, walls]) = skin.built_from() {
            self.cells.build(parallel, domain, points, self.reach)?;
            self.find_rows(parallel, domain, points, walls, boundary)?;
        }
        Ok(())
    }
}
