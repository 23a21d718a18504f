//! Puts title, legend, axes and curves together.

use super::CurvePlot;
use super::legend::{Legend, ROW};
use super::scale::Scale;
use super::series::{Curve, Drawn};
use crate::OutputError;
use crate::raster::axes::{self, Axis, EDGE, bottom_margin, left_margin, named};
use crate::raster::canvas::Canvas;
use crate::raster::draw::Rect;
use crate::raster::image::Image;
use crate::raster::text::{Anchor, Letters, Text};

pub(super) fn render(plot: &CurvePlot) -> Result<Image, OutputError> {
    for curve in &plot.curves {
        let edges = [Some(&curve.y), (curve.drawn == Drawn::Band).then_some(&curve.upper)];
        for values in edges.into_iter().flatten() {
            if curve.x.len() != values.len() {
                let (field, expected, found) = (curve.name.clone(), curve.x.len(), values.len());
                return Err(OutputError::FieldLength { field, expected, found });
            }
        }
    }
    let letters = Letters::new()?;
    let (width, height) = plot.size;
    let size = (f64::from(width) / 58.0).round().max(10.0);
    let image = Image::new(width, height);
    let mut canvas = Canvas { image, letters: &letters, size: size as f32 };

    let x = scale(plot, 0, (f64::from(width) / (4.5 * size)) as usize)?;
    let y = scale(plot, 1, (f64::from(height) / (3.2 * size)) as usize)?;
    let left = left_margin(&y.ticks.labels, size, &letters);
    let right = f64::from(width) - (EDGE + 1.0) * size;
    let legend = Legend::new(&plot.curves, size, right - left, &letters);
    let title = if plot.title.is_empty() { EDGE * size } else { (EDGE + 1.6) * size };
    let top = title + (0.5 + ROW * legend.rows as f64) * size;
    let bottom = f64::from(height) - bottom_margin(size) - EDGE * size;
    let rect = Rect {
        left: left.round() as i64,
        top: top.round() as i64,
        right: (right.round() as i64).max(left.round() as i64 + 8),
        bottom: (bottom.round() as i64).max(top.round() as i64 + 8),
    };

    let across = |value: f64| Some(rect.left as f32 + (x.share(value)? * rect.width() as f64) as f32);
    let up = |value: f64| Some(rect.bottom as f32 - (y.share(value)? * rect.height() as f64) as f32);
    let at = |values: &[f64], map: &dyn Fn(f64) -> Option<f32>| -> Vec<f32> {
        values.iter().filter_map(|value| map(*value)).collect()
    };
    let (x_ticks, y_ticks) = (at(&x.ticks.values, &across), at(&y.ticks.values, &up));
    axes::grid(&mut canvas, rect, &x_ticks, &y_ticks);
    let pixels = |x: &[f64], y: &[f64]| -> Vec<Option<[f32; 2]>> {
        x.iter().zip(y).map(|(x, y)| Some([across(*x)?, up(*y)?])).collect()
    };
    for band in plot.curves.iter().filter(|curve| curve.drawn == Drawn::Band) {
        band.shade(&mut canvas, rect, &pixels(&band.x, &band.y), &pixels(&band.x, &band.upper));
    }
    let draw = |canvas: &mut Canvas, markers: bool| {
        let drawn = |curve: &&Curve| match curve.drawn {
            Drawn::Line | Drawn::Dashed => !markers,
            Drawn::Points => markers,
            Drawn::Band => false,
        };
        for curve in plot.curves.iter().filter(drawn) {
            curve.draw(canvas, rect, &pixels(&curve.x, &curve.y));
        }
    };
    // Lines end at the frame; markers on the frame cover it.
    draw(&mut canvas, false);
    let names = [named(&plot.labels[0], &x.ticks), named(&plot.labels[1], &y.ticks)];
    let across = Axis { at: x_ticks, minor: at(&x.minor, &across), labels: &x.ticks.labels, name: &names[0] };
    let up = Axis { at: y_ticks, minor: at(&y.minor, &up), labels: &y.ticks.labels, name: &names[1] };
    axes::draw(&mut canvas, rect, &across, &up);
    draw(&mut canvas, true);

    legend.draw(&mut canvas, &plot.curves, rect.left as f64, title);
    let size = 1.2 * canvas.size;
    let at = [rect.left as f32, (title - 0.45 * f64::from(canvas.size)) as f32];
    let heading = Text { text: &plot.title, size, at, anchor: Anchor::Start, upwards: false };
    canvas.fitted(heading, rect.width() as f32);
    Ok(canvas.image)
}

/// The scale of the x axis (0) or the y axis (1).
fn scale(plot: &CurvePlot, axis: usize, most: usize) -> Result<Scale, OutputError> {
    let of = |curve: &'_ Curve| match axis {
        0 => [curve.x.clone(), Vec::new()],
        _ => [curve.y.clone(), curve.upper.clone()],
    };
    let values = plot.curves.iter().flat_map(of).flatten();
    // Time fills the width; heights keep off the frame.
    let margin = if axis == 0 && !plot.logarithmic[0] { 0.0 } else { 0.04 };
    Scale::new(values, plot.ranges[axis], plot.logarithmic[axis], margin, most.clamp(3, 11)).ok_or_else(
        || OutputError::Picture {
            what: plot.title.clone(),
            reason: "no curve has a finite point (a positive one on a logarithmic axis). \
                     Check that the series are filled before the plot is written"
                .to_owned(),
        },
    )
}
