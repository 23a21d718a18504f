//! Open boundaries: fluid that enters through inlets and leaves through outlets.
//!
//! An **inlet** is a stack of boundary points that travel with the prescribed speed. To the fluid it is a moving wall, with
//! all that walls guarantee: the pressure is free and has the slope that belongs to the acceleration of the inflow, the
//! work of the inflow is the compression it causes. A point that has crossed the plane of the inlet becomes a fluid
//! particle with the point's velocity, and the point goes back to the rear of its row; so the number of points stays.
//!
//! An **outlet** prescribes the pressure of the particles beyond its plane; their velocity is frozen, and some radii
//! behind the plane they are taken out.
//!
//! Sound would run to and fro between the two: the inlet reflects it as a wall, an outlet at constant pressure as an open end, and the
//! channel rings like an organ pipe at `c/(4 L)`. An absorbing outlet answers instead with `rho0 c` times the difference
//! between the mean speed at its plane and the one that belongs to the inflow, the pressure of a plane wave that goes on
//! (the characteristic of Lastiwka, Basa and Quinlan 2009, Int. J. Numer. Meth. Fluids 61:709, for the mean over the plane only, so that
//! vortices pass).
//!
//! Particles enter and leave only when neighbour rows are rebuilt, in the order of their arrays: the bits do not depend on the
//! number of threads.

mod boundaries;
mod drive;
mod hold;
mod inlet;
mod opening;
mod outlet;
mod passage;

pub(crate) use boundaries::OpenBoundaries;
pub use inlet::Inlet;
pub use opening::Opening;
pub use outlet::Outlet;
