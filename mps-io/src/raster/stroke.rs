//! Lines, solid and dashed.
//!
//! A curve is first collected as coverage, each pixel keeping the largest value of any segment, and
//! then painted at once. Painting segment by segment would darken the soft edge again and again where
//! short segments follow each other, until the curve looks jagged.

use super::draw::Rect;
use super::image::Image;

/// Coverage from 0 to 1 of the pixels of a rectangle.
pub(crate) struct Stroke {
    clip: Rect,
    cover: Vec<f32>,
    width: f32,
}

impl Stroke {
    /// No line yet; lines will be `width` pixels wide and clipped to `clip`.
    pub(crate) fn new(clip: Rect, width: f32) -> Self {
        let pixels = (clip.width().max(0) * clip.height().max(0)) as usize;
        Self { clip, cover: vec![0.0; pixels], width }
    }

    /// A straight line with round ends.
    pub(crate) fn segment(&mut self, from: [f32; 2], to: [f32; 2]) {
        let Rect { left, top, right, bottom } = self.clip;
        let half = 0.5 * self.width;
        let reach = half + 1.0;
        let along = [to[0] - from[0], to[1] - from[1]];
        let length_squared = along[0] * along[0] + along[1] * along[1];
        let first = ((from[1].min(to[1]) - reach).floor() as i64).max(top);
        let last = ((from[1].max(to[1]) + reach).ceil() as i64).min(bottom);
        for row in first..last {
            // The part of the segment that can reach this row, and from it the columns.
            let (mut near, mut far) = (0.0f32, 1.0f32);
            if along[1] != 0.0 {
                let a = (row as f32 - reach - from[1]) / along[1];
                let b = (row as f32 + 1.0 + reach - from[1]) / along[1];
                (near, far) = (a.min(b).clamp(0.0, 1.0), a.max(b).clamp(0.0, 1.0));
            }
            let (a, b) = (from[0] + near * along[0], from[0] + far * along[0]);
            let begin = ((a.min(b) - reach).floor() as i64).max(left);
            let end = ((a.max(b) + reach).ceil() as i64).min(right);
            for column in begin..end {
                let d = [column as f32 + 0.5 - from[0], row as f32 + 0.5 - from[1]];
                let dot = d[0] * along[0] + d[1] * along[1];
                let s = if length_squared > 0.0 { (dot / length_squared).clamp(0.0, 1.0) } else { 0.0 };
                let off = [d[0] - s * along[0], d[1] - s * along[1]];
                let cover = half + 0.5 - (off[0] * off[0] + off[1] * off[1]).sqrt();
                let pixel = &mut self.cover[((row - top) * (right - left) + column - left) as usize];
                *pixel = pixel.max(cover.min(1.0));
            }
        }
    }

    /// A line through `points`.
    pub(crate) fn polyline(&mut self, points: &[[f32; 2]]) {
        points.windows(2).for_each(|pair| self.segment(pair[0], pair[1]));
    }

    /// A line through `points`, drawn for `on` pixels, then not for `off`, and so on.
    pub(crate) fn dashes(&mut self, points: &[[f32; 2]], on: f32, off: f32) {
        let (mut drawing, mut left) = (true, on);
        for pair in points.windows(2) {
            let (mut from, to) = (pair[0], pair[1]);
            loop {
                let length = (to[0] - from[0]).hypot(to[1] - from[1]);
                if length <= left || length.is_nan() {
                    if drawing {
                        self.segment(from, to);
                    }
                    left -= length;
                    break;
                }
                let s = left / length;
                let stop = [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])];
                if drawing {
                    self.segment(from, stop);
                }
                from = stop;
                drawing = !drawing;
                left = if drawing { on } else { off };
            }
        }
    }

    /// Covers the pixels of `image` with `color`.
    pub(crate) fn paint(&self, image: &mut Image, color: [u8; 3]) {
        let Rect { left, top, right, .. } = self.clip;
        let columns = (right - left).max(1) as usize;
        for (row, covers) in self.cover.chunks_exact(columns).enumerate() {
            for (column, cover) in covers.iter().enumerate().filter(|(_, cover)| **cover > 0.0) {
                image.blend(left + column as i64, top + row as i64, color, *cover);
            }
        }
    }
}
