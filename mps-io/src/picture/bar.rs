//! The colour bar of a layer.

use super::colormap::ColorMap;
use super::layout::BarLayout;
use crate::raster::INK;
use crate::raster::axes::{CAPITAL, GAP, TICK, named};
use crate::raster::canvas::Canvas;
use crate::raster::draw::{Rect, fill, frame};
use crate::raster::text::{Anchor, Text};

/// A colour bar beside or below the axes.
pub(super) struct Bar {
    pub(super) map: ColorMap,
    pub(super) range: (f64, f64),
    pub(super) label: String,
}

impl Bar {
    pub(super) fn draw(&self, canvas: &mut Canvas, place: &BarLayout) {
        let rect = place.rect;
        let length = if place.upright { rect.height() } else { rect.width() };
        for k in 0..length {
            let color = self.map.color((k as f64 + 0.5) / length as f64);
            let strip = if place.upright {
                Rect { top: rect.bottom - 1 - k, bottom: rect.bottom - k, ..rect }
            } else {
                Rect { left: rect.left + k, right: rect.left + k + 1, ..rect }
            };
            fill(&mut canvas.image, strip, color);
        }
        let stroke = canvas.hairline();
        frame(&mut canvas.image, rect, stroke, INK);
        self.draw_ticks(canvas, place, length);
        let label = named(&self.label, &place.ticks);
        let (x, y) = (0.5 * (rect.left + rect.right) as f32, 0.5 * (rect.top + rect.bottom) as f32);
        let at = if place.upright { [place.label, y] } else { [x, place.label] };
        let text =
            Text { text: &label, size: canvas.size, at, anchor: Anchor::Middle, upwards: place.upright };
        canvas.fitted(text, length as f32);
    }

    fn draw_ticks(&self, canvas: &mut Canvas, place: &BarLayout, length: i64) {
        let rect = place.rect;
        let (tick, gap, capital) = (canvas.pixels(TICK), canvas.pixels(GAP), CAPITAL as f32 * canvas.size);
        for (value, label) in place.ticks.values.iter().zip(&place.ticks.labels) {
            let share = (value - self.range.0) / (self.range.1 - self.range.0);
            let along = (share * length as f64) as f32;
            if place.upright {
                let y = rect.bottom as f32 - along;
                canvas.tick_right(y, rect.right, tick);
                canvas.text(label, [(rect.right + tick + gap) as f32, y + 0.5 * capital], Anchor::Start);
            } else {
                let x = rect.left as f32 + along;
                canvas.tick_down(x, rect.bottom, tick);
                canvas.text(label, [x, (rect.bottom + tick + gap) as f32 + capital], Anchor::Middle);
            }
        }
    }
}
