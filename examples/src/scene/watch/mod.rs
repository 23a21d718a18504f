//! What a run is watched for, and what is left of one that fails.
//!
//! | file | what it does |
//! |---|---|
//! | `particle` | the particle that a failure is about |
//! | `measure` | what is looked at after every step, in one visit of all particles |
//! | `ring` | the last steps |
//! | `alarm` | what is wrong with a state although the step had no error |
//! | `pace` | shorter steps after a failure, and when they end |
//! | `remarks` | what is to be said about a run that goes on |
//! | `guard` | all of this together, and the last good states |
//! | `post_mortem` | what is found out about a failure, and where it is written |
//! | `report`, `table`, `picture` | its words, their tables, and the place of the failure |

mod alarm;
mod guard;
mod measure;
mod pace;
mod particle;
mod picture;
mod post_mortem;
mod remarks;
mod report;
mod ring;
mod table;

pub(super) use guard::{Good, Guard, Setbacks};
pub(super) use post_mortem::{Dissected, PostMortem};
