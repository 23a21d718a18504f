//! Where the axes, the title and the colour bars go.

use super::bar::Bar;
use super::layer::View;
use crate::raster::axes::{CAPITAL, EDGE, GAP, TICK, bottom_margin, left_margin, widest};
use crate::raster::draw::Rect;
use crate::raster::text::Letters;
use crate::raster::ticks::Ticks;

/// Geometry of one picture in pixels; it depends on the view, the bars and the text size only, so
/// all frames of a film agree.
#[derive(Debug)]
pub(super) struct Layout {
    pub(super) height: u32,
    /// Inside of the axes.
    pub(super) plot: Rect,
    /// Pixels per metre.
    pub(super) scale: f64,
    pub(super) ticks: [Ticks; 2],
    /// Baseline of the title.
    pub(super) title: f32,
    pub(super) bars: Vec<BarLayout>,
}

#[derive(Debug)]
pub(super) struct BarLayout {
    pub(super) rect: Rect,
    pub(super) ticks: Ticks,
    /// Whether the bar stands beside the axes; else it lies below.
    pub(super) upright: bool,
    /// Baseline of the label: y of a lying bar, x of an upright one.
    pub(super) label: f32,
}

/// Thickness of a bar and distance between bars, in units of the text size.
const BAR: f64 = 0.9;
const APART: f64 = 1.2;
const LABEL: f64 = 1.1;

impl Layout {
    pub(super) fn new(
        width: u32,
        size: f64,
        view: &View,
        bars: &[Bar],
        titled: bool,
        letters: &Letters,
    ) -> Self {
        let [dx, dy] = view.extent();
        // Wide scenes keep their width when the bars lie below; tall ones their height beside.
        let upright = dx < 1.5 * dy;
        // The y ticks are needed for the margin before the height is known; measure many.
        let left = left_margin(&Ticks::new(view.lower[1], view.upper[1], 9).labels, size, letters);
        let top = size * if titled { EDGE + 1.9 } else { EDGE + 0.2 };
        let beside: f64 =
            if upright { bars.iter().map(|bar| upright_width(bar, size, letters)).sum() } else { 0.0 };

        // The last label of an axis or a lying bar sticks out by half its width.
        let lying = bars.iter().filter(|_| !upright).map(|bar| bar.range);
        let last = std::iter::once((view.lower[0], view.upper[0])).chain(lying);
        let last = last.map(|(low, high)| widest(&Ticks::new(low, high, 9).labels, size, letters));
        let right = last.fold(size * (EDGE + 0.8), |right, width| right.max(0.5 * width + 0.4 * size));
        let available = (f64::from(width) - left - beside - right).max(16.0);
        // No picture is much taller than wide: a tower is drawn smaller instead.
        let scale = (available / dx).min(1.1 * f64::from(width) / dy);
        let (w, h) = ((dx * scale).round().max(1.0), (dy * scale).round().max(1.0));
        let left = (left + (0.5 * (available - w)).max(0.0)).round() as i64;
        let top = top.round() as i64;
        let plot = Rect { left, top, right: left + w as i64, bottom: top + h as i64 };

        let ticks = [
            Ticks::new(view.lower[0], view.upper[0], ((w / (4.0 * size)) as usize).clamp(2, 11)),
            Ticks::new(view.lower[1], view.upper[1], ((h / (1.8 * size)) as usize).clamp(2, 9)),
        ];
        let mut below = plot.bottom as f64 + bottom_margin(size);
        let bars = if upright {
            beside_the_axes(bars, plot, size, letters)
        } else {
            let lying = below_the_axes(bars, plot, below + 0.7 * size, size, letters);
            below = lying.iter().map(|bar| f64::from(bar.label) + 0.25 * size).fold(below, f64::max);
            lying
        };
        let height = (below + EDGE * size).ceil() as u32;
        let title = (f64::from(plot.top as i32) - 0.6 * size) as f32;
        Self { height, plot, scale, ticks, title, bars }
    }
}

/// From the axes, or the bar before, to the end of the label.
fn upright_width(bar: &Bar, size: f64, letters: &Letters) -> f64 {
    let labels = Ticks::new(bar.range.0, bar.range.1, 9).labels;
    (APART + BAR + TICK + GAP + GAP + LABEL) * size + widest(&labels, size, letters)
}

fn beside_the_axes(bars: &[Bar], plot: Rect, size: f64, letters: &Letters) -> Vec<BarLayout> {
    let mut end = plot.right as f64;
    let place = |bar: &Bar| {
        let from = end + APART * size;
        end += upright_width(bar, size, letters);
        let most = ((plot.height() as f64 / (2.4 * size)) as usize).clamp(2, 9);
        BarLayout {
            rect: Rect { left: from as i64, right: (from + BAR * size) as i64, ..plot },
            ticks: Ticks::new(bar.range.0, bar.range.1, most),
            upright: true,
            label: (end - 0.25 * size) as f32,
        }
    };
    bars.iter().map(place).collect()
}

fn below_the_axes(bars: &[Bar], plot: Rect, top: f64, size: f64, letters: &Letters) -> Vec<BarLayout> {
    // Labels stick out by half their width on both sides of a bar.
    let labels = |bar: &Bar| widest(&Ticks::new(bar.range.0, bar.range.1, 7).labels, size, letters);
    let label = bars.iter().map(labels).fold(0.0, f64::max);
    let apart = (1.5 * size).max(label + size);
    let count = bars.len().max(1) as f64;
    let length = ((plot.width() as f64 - apart * (count - 1.0)) / count).max(4.0);
    let most = ((length / (label + 1.5 * size)) as usize + 1).clamp(2, 9);
    let place = |(k, bar): (usize, &Bar)| {
        let from = plot.left as f64 + k as f64 * (length + apart);
        let rect = Rect {
            left: from.round() as i64,
            top: top as i64,
            right: (from + length).round() as i64,
            bottom: (top + BAR * size) as i64,
        };
        let label = (top + (BAR + TICK + GAP + CAPITAL + 0.35 + LABEL - 0.25) * size) as f32;
        BarLayout { rect, ticks: Ticks::new(bar.range.0, bar.range.1, most), upright: false, label }
    };
    bars.iter().enumerate().map(place).collect()
}
