//! An image with the letters and the text size used on it.

use super::INK;
use super::draw::{Rect, fill};
use super::image::Image;
use super::text::{Anchor, Letters, Text};

pub(crate) struct Canvas<'a> {
    pub(crate) image: Image,
    pub(crate) letters: &'a Letters,
    /// Height of a line of text in pixels; all other lengths follow from it.
    pub(crate) size: f32,
}

impl Canvas<'_> {
    /// `lines` times the text size, in whole pixels.
    pub(crate) fn pixels(&self, lines: f64) -> i64 {
        (lines * f64::from(self.size)).round() as i64
    }

    /// Thickness of frames and ticks.
    pub(crate) fn hairline(&self) -> i64 {
        ((self.size / 14.0).round() as i64).max(1)
    }

    /// Text of the usual size.
    pub(crate) fn text(&mut self, text: &str, at: [f32; 2], anchor: Anchor) {
        let size = self.size;
        self.letters.draw(&mut self.image, &Text { text, size, at, anchor, upwards: false }, INK);
    }

    /// Text of another size, made smaller still where it would be longer than `available` pixels.
    pub(crate) fn fitted(&mut self, text: Text, available: f32) {
        let size = self.letters.fit(text.text, text.size, available);
        self.letters.draw(&mut self.image, &Text { size, ..text }, INK);
    }

    /// A tick below `(at, from)`.
    pub(crate) fn tick_down(&mut self, at: f32, from: i64, length: i64) {
        let (left, right) = self.about(at);
        fill(&mut self.image, Rect { left, right, top: from, bottom: from + length }, INK);
    }

    /// A tick to the right of `(from, at)`.
    pub(crate) fn tick_right(&mut self, at: f32, from: i64, length: i64) {
        let (top, bottom) = self.about(at);
        fill(&mut self.image, Rect { left: from, right: from + length, top, bottom }, INK);
    }

    /// The pixels of a hairline centred at `at`.
    fn about(&self, at: f32) -> (i64, i64) {
        let stroke = self.hairline();
        let start = (at - 0.5 * stroke as f32).round() as i64;
        (start, start + stroke)
    }
}
