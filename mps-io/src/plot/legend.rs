//! The legend: one or more rows above the axes, where no curve can run.

use super::series::{Curve, Drawn};
use crate::raster::axes::CAPITAL;
use crate::raster::canvas::Canvas;
use crate::raster::draw::Rect;
use crate::raster::stroke::Stroke;
use crate::raster::text::{Anchor, Letters};

/// Lengths in units of the text size.
const SAMPLE: f64 = 2.2;
const GAP: f64 = 0.5;
const APART: f64 = 1.6;
pub(super) const ROW: f64 = 1.45;

/// Where each entry stands: row and pixels from the left.
pub(super) struct Legend {
    places: Vec<(usize, f64)>,
    pub(super) rows: usize,
}

impl Legend {
    /// Entries from left to right; one that would pass `width` pixels starts the next row.
    pub(super) fn new(curves: &[Curve], size: f64, width: f64, letters: &Letters) -> Self {
        let (mut row, mut x) = (0, 0.0);
        let place = |curve: &Curve| {
            let length = (SAMPLE + GAP) * size + f64::from(letters.width(&curve.name, size as f32));
            if x > 0.0 && x + length > width {
                (row, x) = (row + 1, 0.0);
            }
            let at = (row, x);
            x += length + APART * size;
            at
        };
        let places: Vec<(usize, f64)> = curves.iter().map(place).collect();
        let rows = places.last().map_or(0, |(row, _)| row + 1);
        Self { places, rows }
    }

    /// Draws the entries with the top of the first row at `(left, top)`.
    pub(super) fn draw(&self, canvas: &mut Canvas, curves: &[Curve], left: f64, top: f64) {
        let size = f64::from(canvas.size);
        for (curve, (row, x)) in curves.iter().zip(&self.places) {
            let (from, middle) = ((left + x) as f32, (top + (*row as f64 + 0.5) * ROW * size) as f32);
            let to = from + (SAMPLE * size) as f32;
            if curve.drawn == Drawn::Points {
                curve.marker(canvas, [0.5 * (from + to), middle]);
            } else if curve.drawn == Drawn::Band {
                let half = 0.35 * canvas.size;
                let edge = |y: f32| [Some([from, y]), Some([to, y])];
                let all = Rect {
                    left: 0,
                    top: 0,
                    right: i64::from(canvas.image.width()),
                    bottom: i64::from(canvas.image.height()),
                };
                curve.shade(canvas, all, &edge(middle + half), &edge(middle - half));
            } else {
                let reach = size as i64;
                let clip = Rect {
                    left: from as i64 - reach,
                    right: to as i64 + reach,
                    top: middle as i64 - reach,
                    bottom: middle as i64 + reach,
                };
                let mut stroke = Stroke::new(clip, 0.13 * canvas.size);
                let line = [[from, middle], [to, middle]];
                if curve.drawn == Drawn::Dashed {
                    stroke.dashes(&line, 0.65 * canvas.size, 0.4 * canvas.size);
                } else {
                    stroke.polyline(&line);
                }
                stroke.paint(&mut canvas.image, curve.color());
            }
            let baseline = middle + (0.5 * CAPITAL * size) as f32;
            canvas.text(&curve.name, [to + (GAP * size) as f32, baseline], Anchor::Start);
        }
    }
}
