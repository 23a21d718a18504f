//! Scene files: everything a run is made of, as text.
//!
//! A [`SceneFile`] says which water, walls and bodies there are, with which numbers they are computed, what is
//! measured and what is written; it is read from TOML by [`read`] or [`parse`] and written by
//! [`SceneFile::to_toml`]. The types describe and know no physics; whoever builds the scene reports what it finds
//! wrong with the [`Source`], which knows the line of every key. All units are SI.
//!
//! | file | part |
//! |---|---|
//! | `scene` | the whole |
//! | `region`, `inside` | shapes, and what is inside them |
//! | `surface/*` | where the surface of a shape is nearest to a place |
//! | `outline/*` | shapes from files of their own |
//! | `fluid`, `openings`, `walls`, `solids`, `fixed` | what there is |
//! | `probes`, `output`, `choice`, `watch` | what is measured and written, and what a run is watched for |
//! | `source`, `suggest` | where a key is, and which one was meant |
//! | `reference` | a table of all keys |
//! | `check/*` | what is refused before anything is built |

mod check;
mod choice;
mod fixed;
mod fluid;
mod inside;
mod openings;
mod outline;
mod output;
mod probes;
mod reference;
mod region;
mod scene;
mod solids;
mod source;
mod suggest;
mod surface;
mod walls;
mod watch;

pub use choice::{Field, FieldForm, FieldPrecision, ProbeForm};
pub use fixed::{Fixed, Packing};
pub use fluid::{
    Body, Diffusion, Fluid, InitialPressure, Numerics, PressureForm, Tension, Viscosity, Weight,
};
pub use openings::{Inlet, Outlet, Profile};
pub use outline::Outline;
pub use output::Output;
pub use probes::{
    BudgetProbe, DisplacementProbe, ForceProbe, FrontProbe, LevelProbe, LineProbe, LineQuantity, Measure,
    PressureProbe, Probe, VelocityProbe, WallPressureProbe, Way,
};
pub use reference::reference;
pub use region::{Corners, Disc, Filling, HalfSpace, Point, Region, Tube};
pub use scene::{SceneFile, parse, read, schema};
pub use solids::{Clamp, Elasticity, InitialVelocity, Material, Side, Solid};
pub use source::{Problem, SceneError, Source};
pub use suggest::closest;
pub use surface::{Foot, Surface};
pub use walls::{Motion, Oscillation, Shape, Slip, Steady, Tank, Wall};
pub use watch::{OnFailure, OnMach, Retry, Watch};
