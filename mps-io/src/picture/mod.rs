//! Pictures of particle fields and films made of them.

mod bar;
mod colormap;
mod field;
mod film;
mod layer;
mod layout;
#[cfg(test)]
mod tests;

pub use crate::raster::image::Image;
pub use colormap::ColorMap;
pub use field::FieldPicture;
pub use film::Film;
pub use layer::{View, value_range};
