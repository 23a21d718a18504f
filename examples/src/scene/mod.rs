//! From a scene file to a run.
//!
//! | file | what it does |
//! |---|---|
//! | `lattice`, `fitted`, `line` | points that fill regions, follow their surfaces, and lie along walls |
//! | `layout` | all points of a scene, before any physics |
//! | `law`, `viscosity` | materials and viscosities by name |
//! | `water`, `start`, `openings`, `bodies`, `fixed`, `movers` | fluid and its pressure at the start, where it enters and leaves, elastic and rigid bodies, moved walls |
//! | `world` | what is stepped: fluid with bodies, or bodies alone |
//! | `clearance`, `diagnosis` | what is wrong with a scene that can be seen before it runs |
//! | `probes`, `columns`, `water_probes`, `interface_probes`, `observer`, `fields`, `slice`, `field_files`, `report`, `units` | what is measured, written, and said |
//! | `dimension`, `examined` | from the number of dimensions in a file to that in the code; a scene that was examined |
//! | `run`, `watched` | the run, with all that watches it |
//! | `watch/*` | what a run is watched for, its post-mortem, and how it is tried again |
//! | `keeper`, `resume`, `leftovers`, `lock` | its checkpoints, how it goes on from one, what an earlier run has left, and that no other one runs there |
//! | `plan`, `disk` | what a run will cost, and whether there is room for it |
//! | `table`, `plot`, `harmonics`, `converge` | the probes of runs made before: their plots, what oscillates in them, how far they are apart |
//! | `print` | the scene that a program describes instead of running it |

mod bodies;
mod clearance;
mod columns;
mod converge;
mod diagnosis;
mod dimension;
mod disk;
mod examined;
mod field_files;
mod fields;
mod fitted;
mod fixed;
mod harmonics;
mod interface_probes;
mod keeper;
mod lattice;
mod law;
mod layout;
mod leftovers;
mod line;
mod lock;
mod movers;
mod observer;
mod openings;
mod plan;
mod plot;
mod price;
mod print;
mod probes;
mod report;
mod resume;
mod run;
mod slice;
mod start;
mod table;
mod units;
mod viscosity;
mod watch;
mod watched;
mod water;
mod water_probes;
mod world;

pub use converge::converge;
pub use diagnosis::Diagnosis;
pub use examined::Examined;
pub use fixed::FixedPoints;
pub use harmonics::{Window, harmonics};
pub(crate) use keeper::is_stopped;
pub use law::Law;
pub use layout::Layout;
pub use openings::Behind;
pub use plot::{Drawing, plot};
pub use print::{form_of, print_scene};
pub use resume::resume;
pub use viscosity::Viscous;
pub use world::World;

use diagnosis::diagnose;

use mps_kernel::{Real, Vector};

/// Places as vectors of the number type of the run.
fn vectors<T: Real, const D: usize>(places: &[lattice::Place<D>]) -> Vec<Vector<T, D>> {
    places.iter().map(|place| vector(place)).collect()
}

/// The number type of a run for a point of a scene file, whose dimension has been checked.
fn vector<T: Real, const D: usize>(point: &[f64]) -> Vector<T, D> {
    Vector::from_fn(|axis, _| T::of(point.get(axis).copied().unwrap_or(0.0)))
}
