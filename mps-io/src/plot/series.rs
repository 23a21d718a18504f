//! One curve: its points in pixels, as a line, as markers or as a band.

use super::band::shade;
use crate::raster::canvas::Canvas;
use crate::raster::draw::{Rect, polygon};
use crate::raster::stroke::Stroke;

/// Colours that differ for every kind of colour vision (Okabe and Ito), the darkest first.
const LINES: [[u8; 3]; 6] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [86, 180, 233], [230, 159, 0]];
/// Markers start with black, the colour of measurements.
const POINTS: [[u8; 3]; 6] =
    [[30, 30, 30], [150, 60, 20], [90, 90, 150], [120, 120, 120], [0, 110, 80], [160, 80, 130]];

/// Bands are pale shades of these.
const BANDS: [[u8; 3]; 3] = [[30, 30, 30], [0, 114, 178], [213, 94, 0]];

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Drawn {
    Line,
    Dashed,
    Points,
    Band,
}

impl Drawn {
    /// Colours to choose from.
    pub(super) fn palette(self) -> &'static [[u8; 3]] {
        match self {
            Self::Line | Self::Dashed => &LINES,
            Self::Points => &POINTS,
            Self::Band => &BANDS,
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) name: String,
    pub(super) drawn: Drawn,
    /// Number of lines (of markers, of bands) before this one: it tells the colour and the shape.
    pub(super) order: usize,
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    /// Upper edge of a band, whose lower edge is `y`; empty for all others.
    pub(super) upper: Vec<f64>,
}

impl Curve {
    pub(super) fn color(&self) -> [u8; 3] {
        let colors = self.drawn.palette();
        colors[self.order % colors.len()]
    }

    /// Draws the curve through `points` in pixels; `None` interrupts a line.
    pub(super) fn draw(&self, canvas: &mut Canvas, clip: Rect, points: &[Option<[f32; 2]>]) {
        if self.drawn == Drawn::Points {
            for at in points.iter().flatten().filter(|at| inside(clip, **at)) {
                // Markers on the frame are drawn whole: half a marker looks like another shape.
                self.marker(canvas, *at);
            }
            return;
        }
        let size = canvas.size;
        let mut stroke = Stroke::new(clip, 0.13 * size);
        for piece in points.split(Option::is_none) {
            let piece: Vec<[f32; 2]> = thinned(piece.iter().flatten().copied());
            if self.drawn == Drawn::Dashed {
                stroke.dashes(&piece, 0.65 * size, 0.4 * size);
            } else {
                stroke.polyline(&piece);
            }
        }
        stroke.paint(&mut canvas.image, self.color());
    }

    /// Shades the band between two edges in pixels.
    pub(super) fn shade(
        &self,
        canvas: &mut Canvas,
        clip: Rect,
        lower: &[Option<[f32; 2]>],
        upper: &[Option<[f32; 2]>],
    ) {
        shade(&mut canvas.image, clip, lower, upper, self.color());
    }

    /// One hollow marker: a line drawn beneath is seen to pass through or by.
    pub(super) fn marker(&self, canvas: &mut Canvas, at: [f32; 2]) {
        let radius = 0.3 * canvas.size;
        let clip = Rect {
            left: 0,
            top: 0,
            right: i64::from(canvas.image.width()),
            bottom: i64::from(canvas.image.height()),
        };
        // Number of corners, the angle of the first in turns, and a size that looks equal.
        let (corners, turn, scale) =
            [(24, 0.0, 1.0), (4, 0.125, 1.2), (3, 0.75, 1.3), (4, 0.0, 1.3), (3, 0.25, 1.3), (6, 0.0, 1.1)]
                [self.order % 6];
        let shape = |radius: f32| -> Vec<[f32; 2]> {
            let corner = |k| {
                let angle = (turn + k as f32 / corners as f32) * std::f32::consts::TAU;
                [at[0] + radius * angle.cos(), at[1] + radius * angle.sin()]
            };
            (0..corners).map(corner).collect()
        };
        // The inside of a polygon of n corners is nearer to its edges than to its corners.
        let thickness = 0.1 * canvas.size / (std::f32::consts::PI / corners as f32).cos();
        polygon(&mut canvas.image, clip, &shape(scale * radius), self.color());
        polygon(&mut canvas.image, clip, &shape(scale * radius - thickness), [255; 3]);
    }
}

fn inside(clip: Rect, [x, y]: [f32; 2]) -> bool {
    // Half a pixel of grace for points on the frame.
    let (x, y) = (f64::from(x), f64::from(y));
    (clip.left as f64 - 0.5..=clip.right as f64 + 0.5).contains(&x)
        && (clip.top as f64 - 0.5..=clip.bottom as f64 + 0.5).contains(&y)
}

/// Of consecutive points in one column of pixels only the first, lowest, highest and last are kept: a
/// pressure signal of a million samples looks the same and is drawn at once.
fn thinned(points: impl Iterator<Item = [f32; 2]>) -> Vec<[f32; 2]> {
    let mut kept: Vec<[f32; 2]> = Vec::new();
    let mut column: Vec<[f32; 2]> = Vec::new();
    let flush = |column: &mut Vec<[f32; 2]>, kept: &mut Vec<[f32; 2]>| {
        let by_height = |a: &usize, b: &usize| column[*a][1].total_cmp(&column[*b][1]);
        let mut keep = vec![0, column.len().saturating_sub(1)];
        keep.extend((0..column.len()).min_by(by_height));
        keep.extend((0..column.len()).max_by(by_height));
        keep.sort_unstable();
        keep.dedup();
        kept.extend(keep.into_iter().filter_map(|k| column.get(k)));
        column.clear();
    };
    for point in points {
        if column.first().is_some_and(|first| first[0].floor() != point[0].floor()) {
            flush(&mut column, &mut kept);
        }
        column.push(point);
    }
    flush(&mut column, &mut kept);
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_every_peak() {
        let signal = (0..100_000).map(|k| [k as f32 * 1e-3, if k == 54_321 { 900.0 } else { 10.0 }]);
        let kept = thinned(signal);
        assert!(kept.len() <= 400, "{}", kept.len());
        assert_eq!(kept.iter().filter(|point| point[1] == 900.0).count(), 1);
        assert!(kept.is_sorted_by(|a, b| a[0] <= b[0]));
    }

    #[test]
    fn thinning_keeps_few_points_as_they_are() {
        let points = [[0.2, 1.0], [5.0, 2.0], [5.5, 0.0], [9.0, 1.0]];
        assert_eq!(thinned(points.into_iter()), points);
        assert!(thinned(std::iter::empty()).is_empty());
    }
}
