//! The cases of fluid and structure together.

mod added_mass;
mod exchange;
mod layer;
mod plate;
mod submerged;
mod waving;

use mps_examples::exact::Case;

/// All of them, the cheapest first.
pub(crate) fn cases() -> Vec<Box<dyn Case>> {
    vec![
        Box::new(exchange::Exchange),
        Box::new(added_mass::AddedMass),
        Box::new(plate::Plate),
        Box::new(waving::WavingPlate),
        Box::new(plate::Square),
        Box::new(submerged::Submerged),
    ]
}
