//! The frame around a picture with its ticks and labels.

use super::canvas::Canvas;
use super::draw::{Rect, fill, frame};
use super::text::{Anchor, Letters, Text};
use super::{INK, ticks::Ticks};

/// Lengths in units of the text size.
pub(crate) const TICK: f64 = 0.3;
pub(crate) const GAP: f64 = 0.25;
/// Height of digits and capitals; labels are centred by it.
pub(crate) const CAPITAL: f64 = 0.63;
const LINE: f64 = 1.15;
/// Free border of every picture.
pub(crate) const EDGE: f64 = 0.7;

const GRID: [u8; 3] = [226, 226, 226];

/// One axis: where its ticks are in pixels, and its name.
pub(crate) struct Axis<'a> {
    pub(crate) at: Vec<f32>,
    /// Shorter ticks without label.
    pub(crate) minor: Vec<f32>,
    pub(crate) labels: &'a [String],
    pub(crate) name: &'a str,
}

/// Pixels left of the axes: the turned name, the widest label and the tick.
pub(crate) fn left_margin(labels: &[String], size: f64, letters: &Letters) -> f64 {
    (EDGE + LINE + GAP + GAP + TICK) * size + widest(labels, size, letters)
}

/// Pixels below the axes, without the free border: tick, label and name.
pub(crate) fn bottom_margin(size: f64) -> f64 {
    (TICK + GAP + CAPITAL + 0.35 + LINE) * size
}

/// Width of the widest label in pixels.
pub(crate) fn widest(labels: &[String], size: f64, letters: &Letters) -> f64 {
    labels.iter().map(|label| f64::from(letters.width(label, size as f32))).fold(0.0, f64::max)
}

/// The name of an axis with the common factor of its labels.
pub(crate) fn named(name: &str, ticks: &Ticks) -> String {
    format!("{name}{}", ticks.factor())
}

/// Light lines, one pixel wide, through the ticks: drawn before the data.
pub(crate) fn grid(canvas: &mut Canvas, rect: Rect, across: &[f32], up: &[f32]) {
    for x in across {
        let left = (x.floor() as i64).clamp(rect.left, rect.right - 1);
        fill(&mut canvas.image, Rect { left, right: left + 1, ..rect }, GRID);
    }
    for y in up {
        let top = (y.floor() as i64).clamp(rect.top, rect.bottom - 1);
        fill(&mut canvas.image, Rect { top, bottom: top + 1, ..rect }, GRID);
    }
}

/// Frame, ticks, labels and names: drawn after the data.
pub(crate) fn draw(canvas: &mut Canvas, rect: Rect, across: &Axis, up: &Axis) {
    let (tick, gap, size) = (canvas.pixels(TICK), canvas.pixels(GAP), canvas.size);
    let (stroke, capital) = (canvas.hairline(), CAPITAL as f32 * size);
    frame(&mut canvas.image, rect, stroke, INK);
    across.minor.iter().for_each(|x| canvas.tick_down(*x, rect.bottom, (tick + 1) / 2));
    up.minor.iter().for_each(|y| canvas.tick_right(*y, rect.left - (tick + 1) / 2, (tick + 1) / 2));
    for (x, label) in across.at.iter().zip(across.labels) {
        canvas.tick_down(*x, rect.bottom, tick);
        canvas.text(label, [*x, (rect.bottom + tick + gap) as f32 + capital], Anchor::Middle);
    }
    for (y, label) in up.at.iter().zip(up.labels) {
        canvas.tick_right(*y, rect.left - tick, tick);
        canvas.text(label, [(rect.left - tick - gap) as f32, y + 0.5 * capital], Anchor::End);
    }
    let (x, y) = (0.5 * (rect.left + rect.right) as f32, 0.5 * (rect.top + rect.bottom) as f32);
    let below = rect.bottom as f32 + (bottom_margin(f64::from(size)) as f32) - 0.25 * size;
    let beside = rect.left as f32
        - (TICK + GAP + GAP + 0.25) as f32 * size
        - widest(up.labels, f64::from(size), canvas.letters) as f32;
    let name = |text, at, upwards| Text { text, size, at, anchor: Anchor::Middle, upwards };
    canvas.fitted(name(across.name, [x, below], false), rect.width() as f32);
    canvas.fitted(name(up.name, [beside, y], true), rect.height() as f32);
}
