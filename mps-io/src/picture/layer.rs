//! What is drawn inside the axes: particles coloured by a value, plain particles, lines.

use mps_kernel::{Real, Vector};

use super::colormap::ColorMap;

/// The part of space in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Lower left corner (m).
    pub lower: [f64; 2],
    /// Upper right corner (m).
    pub upper: [f64; 2],
    /// Which coordinates go to the right and up: `[0, 1]` for x and y; `[0, 2]` for x and z, seen
    /// from the side of negative y. Default: `[0, 1]`.
    pub axes: [usize; 2],
}

impl View {
    /// x to the right, y up, between two corners (m).
    pub fn new(lower: [f64; 2], upper: [f64; 2]) -> Self {
        Self { lower, upper, axes: [0, 1] }
    }

    /// The same corners with other coordinates to the right and up.
    pub fn with_axes(self, axes: [usize; 2]) -> Self {
        Self { axes, ..self }
    }

    /// The smallest view of x and y with all `positions` and `margin` (m) around them.
    pub fn containing<T: Real, const D: usize>(positions: &[Vector<T, D>], margin: f64) -> Self {
        let (mut lower, mut upper) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for position in positions {
            for (k, coordinate) in position.iter().take(2).enumerate() {
                let x = coordinate.to_double();
                if x.is_finite() {
                    lower[k] = lower[k].min(x - margin);
                    upper[k] = upper[k].max(x + margin);
                }
            }
        }
        Self::new(lower, upper)
    }

    /// Width and height in metres.
    pub(super) fn extent(&self) -> [f64; 2] {
        [self.upper[0] - self.lower[0], self.upper[1] - self.lower[1]]
    }

    /// The coordinate that points at the viewer, and its sign: larger products are nearer.
    fn depth(&self) -> (usize, f64) {
        let [right, up] = self.axes;
        let third = 3usize.saturating_sub(right + up);
        (third, if (right + 1) % 3 == up { 1.0 } else { -1.0 })
    }
}

/// Smallest and largest finite value, a range for colours; `(0, 1)` if there is none.
///
/// For films prefer a range fixed in advance: colours then mean the same in all frames.
pub fn value_range<T: Real>(values: &[T]) -> (f64, f64) {
    let finite = || values.iter().map(|v| v.to_double()).filter(|v| v.is_finite());
    let (low, high) = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
    if low > high { (0.0, 1.0) } else { (low, high) }
}

/// A particle ready for drawing.
#[derive(Clone, Copy)]
pub(super) struct Dot {
    /// Coordinates in the view (m).
    pub(super) at: [f64; 2],
    depth: f32,
    pub(super) color: [u8; 3],
}

/// Something drawn inside the axes; later layers cover earlier ones.
pub(super) enum Layer {
    Dots { dots: Vec<Dot>, radius: f64 },
    Line { points: Vec<[f64; 2]>, color: [u8; 3] },
}

/// Colour of particles whose value is not a number: it must be noticed.
pub(super) const NOT_A_NUMBER: [u8; 3] = [255, 0, 255];

/// Projects particles; in 3D the farthest come first, so that the nearest cover them.
pub(super) fn dots<T: Real, const D: usize>(
    view: &View,
    positions: &[Vector<T, D>],
    color: impl Fn(usize) -> [u8; 3],
) -> Vec<Dot> {
    let [right, up] = view.axes;
    let (third, sign) = view.depth();
    let mut dots: Vec<Dot> = (positions.iter().enumerate())
        .map(|(k, x)| {
            let depth = if D > 2 { (sign * x[third].to_double()) as f32 } else { 0.0 };
            Dot { at: [x[right].to_double(), x[up].to_double()], depth, color: color(k) }
        })
        .collect();
    if D > 2 {
        dots.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    }
    dots
}

/// The colour function of values on a range.
pub(super) fn colors<T: Real>(values: &[T], range: (f64, f64), map: ColorMap) -> impl Fn(usize) -> [u8; 3] {
    let table = map.table();
    let scale = 255.0 / (range.1 - range.0);
    move |k| match values.get(k).map(|v| v.to_double()) {
        Some(value) if !value.is_nan() => {
            // A cast of an infinite or negative float saturates: out of range takes the end colour.
            table[((value - range.0) * scale).round().clamp(0.0, 255.0) as usize]
        }
        _ => NOT_A_NUMBER,
    }
}
