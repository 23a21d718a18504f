//! Drawing on pixels: discs, strokes, markers, text and axes, shared by field pictures and plots.
//!
//! A few hundred lines instead of a plotting library: it draws a hundred thousand discs between two
//! time steps, both kinds of picture look alike, and it builds in seconds.

pub(crate) mod axes;
pub(crate) mod canvas;
pub(crate) mod draw;
pub(crate) mod image;
pub(crate) mod stroke;
pub(crate) mod text;
pub(crate) mod ticks;

/// Colour of text, ticks and frames.
pub(crate) const INK: [u8; 3] = [30, 30, 30];
