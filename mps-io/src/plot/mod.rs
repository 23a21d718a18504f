//! Curves as PNG: results as lines, experiments as markers, their scatter as a shaded band.

mod band;
mod legend;
mod render;
mod scale;
mod series;

use std::path::Path;

use crate::OutputError;
use crate::raster::image::Image;
use series::{Curve, Drawn};

/// A plot of curves with axes, a grid and a legend above the axes, where it covers no data.
///
/// Names and labels may hold Greek letters, superscripts and mathematical signs.
///
/// ```
/// use mps_io::CurvePlot;
/// let (t, z) = ([0.0, 0.1, 0.2], [1.0, 1.2, 1.9]);
/// let image = CurvePlot::new("Dam break", "t √(2g/a) [-]", "front Z/a [-]")
///     .line("MPS", &t, &z)
///     .points("experiment", &t, &[1.0, 1.3, 1.8])
///     .render()?;
/// assert_eq!(image.width(), 1200);
/// # Ok::<(), mps_io::OutputError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurvePlot {
    title: String,
    labels: [String; 2],
    curves: Vec<Curve>,
    ranges: [Option<(f64, f64)>; 2],
    logarithmic: [bool; 2],
    size: (u32, u32),
}

impl CurvePlot {
    /// An empty plot of 1200 x 760 pixels. Put the units into the labels: `"time [s]"`.
    pub fn new(title: &str, x_label: &str, y_label: &str) -> Self {
        Self {
            title: title.to_owned(),
            labels: [x_label.to_owned(), y_label.to_owned()],
            curves: Vec::new(),
            ranges: [None; 2],
            logarithmic: [false; 2],
            size: (1200, 760),
        }
    }

    /// Adds a curve; a point that is not finite interrupts it.
    pub fn line(self, name: &str, x: &[f64], y: &[f64]) -> Self {
        self.curve(name, Drawn::Line, x, y)
    }

    /// Adds a dashed curve: theory, another program, a limit.
    pub fn dashed(self, name: &str, x: &[f64], y: &[f64]) -> Self {
        self.curve(name, Drawn::Dashed, x, y)
    }

    /// Adds markers: experiments, single runs.
    pub fn points(self, name: &str, x: &[f64], y: &[f64]) -> Self {
        self.curve(name, Drawn::Points, x, y)
    }

    /// Adds a shaded area from `low` to `high`: scatter, tolerance. Lines and markers cover it.
    pub fn band(mut self, name: &str, x: &[f64], low: &[f64], high: &[f64]) -> Self {
        self = self.curve(name, Drawn::Band, x, low);
        if let Some(band) = self.curves.last_mut() {
            band.upper = high.to_vec();
        }
        self
    }

    /// Fixes the ends of the x axis; without it they follow from the data.
    pub fn x_range(mut self, low: f64, high: f64) -> Self {
        self.ranges[0] = Some((low, high));
        self
    }

    /// Fixes the ends of the y axis; without it they follow from the data.
    pub fn y_range(mut self, low: f64, high: f64) -> Self {
        self.ranges[1] = Some((low, high));
        self
    }

    /// Makes the x axis logarithmic; points at or below zero are left out.
    pub fn log_x(mut self) -> Self {
        self.logarithmic[0] = true;
        self
    }

    /// Makes the y axis logarithmic; points at or below zero are left out.
    pub fn log_y(mut self) -> Self {
        self.logarithmic[1] = true;
        self
    }

    /// Width and height in pixels, at least 200 x 150; the text grows with the width.
    pub fn size(mut self, width: u32, height: u32) -> Self {
        self.size = (width.clamp(200, 16_384), height.clamp(150, 16_384));
        self
    }

    /// Draws the plot.
    ///
    /// # Errors
    /// A curve has not one y for each x, or there is nothing finite to draw.
    pub fn render(&self) -> Result<Image, OutputError> {
        render::render(self)
    }

    /// Draws the plot and writes it as PNG.
    ///
    /// # Errors
    /// Those of [`render`](Self::render), or the file cannot be written.
    pub fn write_png(&self, path: impl AsRef<Path>) -> Result<(), OutputError> {
        self.render()?.write_png(path)
    }

    fn curve(mut self, name: &str, drawn: Drawn, x: &[f64], y: &[f64]) -> Self {
        let order = self.curves.iter().filter(|curve| curve.drawn.palette() == drawn.palette()).count();
        let (name, x, y) = (name.to_owned(), x.to_vec(), y.to_vec());
        self.curves.push(Curve { name, drawn, order, x, y, upper: Vec::new() });
        self
    }
}
