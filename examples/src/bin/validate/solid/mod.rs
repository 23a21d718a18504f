//! The cases of the solid alone.

mod bar;
mod cantilever;
mod csm1;
mod csm3;
mod momentum;
mod patch;
mod rotation;
mod scene;
mod spin;
mod stretch;
mod weight;

use mps_examples::exact::Case;

/// All of them, the cheapest first.
pub(crate) fn cases() -> Vec<Box<dyn Case>> {
    vec![
        Box::new(rotation::Rotation),
        Box::new(patch::Patch),
        Box::new(momentum::Momentum),
        Box::new(bar::Bar),
        Box::new(stretch::Stretch),
        Box::new(weight::Weight),
        Box::new(spin::Spin),
        Box::new(cantilever::Cantilever),
        Box::new(csm1::Csm1),
        Box::new(csm3::Csm3),
    ]
}
