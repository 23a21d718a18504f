//! Bodies that several programs move: the plate of case 1 and the flag of Turek and Hron, and how the motion of a
//! body on its own is recorded.

pub mod flag;
mod motion;
mod pictures;
pub mod plate;
mod rest;
mod rows;

pub use motion::{Motion, Sample};
pub use pictures::{Look, Pictures};
pub use rest::settle;
pub use rows::begin_at;
