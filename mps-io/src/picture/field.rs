//! The picture of particle fields: layers, axes, title, colour bars.

use crate::number;
use mps_kernel::{Real, Vector};

use super::bar::Bar;
use super::colormap::ColorMap;
use super::layer::{Layer, View, colors, dots};
use super::layout::Layout;
use crate::OutputError;
use crate::raster::axes::{self, Axis, named};
use crate::raster::canvas::Canvas;
use crate::raster::draw::disc;
use crate::raster::image::Image;
use crate::raster::stroke::Stroke;
use crate::raster::text::{Anchor, Letters, Text};

/// Particles coloured by their values, with equal axes in metres and a colour bar for each layer.
///
/// ```
/// use mps_io::picture::{ColorMap, FieldPicture, View};
/// use mps_kernel::Vector;
/// let water = [Vector::<f64, 2>::new(0.05, 0.05), Vector::<f64, 2>::new(0.15, 0.05)];
/// let image = FieldPicture::new(640, View::new([0.0, 0.0], [0.4, 0.2]))
///     .title("Two particles")
///     .time(0.25)
///     .layer(&water, 0.05, &[10.0, 500.0], (0.0, 1000.0), ColorMap::Viridis, "pressure [Pa]")
///     .render()?;
/// assert_eq!(image.width(), 640);
/// # Ok::<(), mps_io::OutputError>(())
/// ```
pub struct FieldPicture {
    width: u32,
    view: View,
    text: f64,
    title: String,
    time: Option<f64>,
    layers: Vec<Layer>,
    bars: Vec<Bar>,
    /// The first wrong input; reported by `render`, so that the builder reads without `?`.
    problem: Option<OutputError>,
}

impl FieldPicture {
    /// An empty picture, `width` pixels wide; the height follows from the view, because both axes
    /// have the same scale.
    pub fn new(width: u32, view: View) -> Self {
        let text = (f64::from(width) / 58.0).round().max(11.0);
        let (title, layers, bars) = (String::new(), Vec::new(), Vec::new());
        let mut picture = Self { width, view, text, title, time: None, layers, bars, problem: None };
        let [dx, dy] = view.extent();
        if !(dx > 0.0 && dy > 0.0 && dx.is_finite() && dy.is_finite()) {
            picture
                .reject(format!("the view {view:?} has no area; its upper corner must lie above the lower"));
        } else if !(100..=16_384).contains(&width) {
            picture.reject(format!("a width of {width} pixels; choose 100 to 16384"));
        }
        picture
    }

    /// The title, above the axes on the left.
    pub fn title(mut self, title: &str) -> Self {
        title.clone_into(&mut self.title);
        self
    }

    /// The simulated time (s), above the axes on the right.
    pub fn time(mut self, seconds: f64) -> Self {
        self.time = Some(seconds);
        self
    }

    /// Height of a line of text in pixels. Default: 1/58 of the width, at least 11.
    pub fn text_size(mut self, pixels: f64) -> Self {
        self.text = if pixels.is_finite() { pixels.clamp(6.0, 200.0) } else { self.text };
        self
    }

    /// Particles as discs of `radius` (m) coloured by `values` over `range`, with a colour bar.
    ///
    /// Half the particle distance makes discs that touch, 0.7 of it closes all gaps. Values outside
    /// the range take the colour of its end, NaN is magenta. Later layers cover earlier ones.
    pub fn layer<T: Real, const D: usize>(
        mut self,
        positions: &[Vector<T, D>],
        radius: f64,
        values: &[T],
        range: (f64, f64),
        map: ColorMap,
        label: &str,
    ) -> Self {
        if values.len() != positions.len() {
            let (expected, found) = (positions.len(), values.len());
            self.problem.get_or_insert(OutputError::FieldLength { field: label.to_owned(), expected, found });
        }
        if !(range.0.is_finite() && range.1.is_finite()) {
            self.reject(format!("the range {range:?} of '{label}' is not finite"));
        }
        // A constant field has a range of no width: widen it, so that the bar still has two ends.
        let range = if range.1 > range.0 { range } else { widened(range.0) };
        self.bars.push(Bar { map, range, label: label.to_owned() });
        self.dots(positions, radius, colors(values, range, map))
    }

    /// Particles as discs of `radius` (m) in one colour (red, green, blue): walls, outlines.
    pub fn plain<T: Real, const D: usize>(
        self,
        positions: &[Vector<T, D>],
        radius: f64,
        color: [u8; 3],
    ) -> Self {
        self.dots(positions, radius, |_| color)
    }

    /// A line through `points` (m) in coordinates of the view: a gate, a tank, a measured outline.
    pub fn line(mut self, points: &[[f64; 2]], color: [u8; 3]) -> Self {
        self.layers.push(Layer::Line { points: points.to_vec(), color });
        self
    }

    /// Draws everything.
    ///
    /// # Errors
    /// The view has no area, a layer has not one value for each particle, or a range is not finite.
    pub fn render(mut self) -> Result<Image, OutputError> {
        if let Some(problem) = self.problem.take() {
            return Err(problem);
        }
        let letters = Letters::new()?;
        let layout = self.layout(&letters);
        let image = Image::new(self.width, layout.height);
        let mut canvas = Canvas { image, letters: &letters, size: self.text as f32 };
        for layer in &self.layers {
            self.draw_layer(&mut canvas.image, &layout, layer);
        }
        self.draw_axes(&mut canvas, &layout);
        for (bar, place) in self.bars.iter().zip(&layout.bars) {
            bar.draw(&mut canvas, place);
        }
        self.draw_title(&mut canvas, &layout);
        Ok(canvas.image)
    }

    /// Where the point `at` (m) of the view lies in the picture: pixels from the top left.
    ///
    /// Call it when all layers are added: colour bars take room.
    pub fn pixel_of(&self, at: [f64; 2]) -> Result<[f64; 2], OutputError> {
        let layout = self.layout(&Letters::new()?);
        Ok(self.project(&layout, at).map(f64::from))
    }

    pub(super) fn layout(&self, letters: &Letters) -> Layout {
        let titled = !self.title.is_empty() || self.time.is_some();
        Layout::new(self.width, self.text, &self.view, &self.bars, titled, letters)
    }

    fn project(&self, layout: &Layout, at: [f64; 2]) -> [f32; 2] {
        let x = layout.plot.left as f64 + (at[0] - self.view.lower[0]) * layout.scale;
        let y = layout.plot.bottom as f64 - (at[1] - self.view.lower[1]) * layout.scale;
        [x as f32, y as f32]
    }

    fn dots<T: Real, const D: usize>(
        mut self,
        positions: &[Vector<T, D>],
        radius: f64,
        color: impl Fn(usize) -> [u8; 3],
    ) -> Self {
        let [right, up] = self.view.axes;
        if right >= D || up >= D || right == up {
            self.reject(format!("the axes {:?} are not two of the {D} coordinates", self.view.axes));
        } else if !(radius > 0.0 && radius.is_finite()) {
            self.reject(format!("particles of radius {radius} m; give half the particle distance"));
        } else {
            let dots = dots(&self.view, positions, color);
            self.layers.push(Layer::Dots { dots, radius });
        }
        self
    }

    fn reject(&mut self, reason: String) {
        let what = if self.title.is_empty() { "the picture" } else { &self.title };
        self.problem.get_or_insert(OutputError::Picture { what: what.to_owned(), reason });
    }

    fn draw_layer(&self, image: &mut Image, layout: &Layout, layer: &Layer) {
        match layer {
            Layer::Dots { dots, radius } => {
                // Smaller than this a particle would fade into the paper.
                let radius = ((radius * layout.scale) as f32).max(0.7);
                for dot in dots {
                    let [x, y] = self.project(layout, dot.at);
                    if x.is_finite() && y.is_finite() {
                        disc(image, layout.plot, x, y, radius, dot.color);
                    }
                }
            }
            Layer::Line { points, color } => {
                let points: Vec<[f32; 2]> = points.iter().map(|at| self.project(layout, *at)).collect();
                let mut stroke = Stroke::new(layout.plot, (0.1 * self.text) as f32);
                stroke.polyline(&points);
                stroke.paint(image, *color);
            }
        }
    }

    fn draw_axes(&self, canvas: &mut Canvas, layout: &Layout) {
        let [across, up] = &layout.ticks;
        let name = |k: usize| ["x [m]", "y [m]", "z [m]"].get(self.view.axes[k]).copied().unwrap_or("");
        let names = [named(name(0), across), named(name(1), up)];
        let x = across.values.iter().map(|x| self.project(layout, [*x, 0.0])[0]).collect();
        let y = up.values.iter().map(|y| self.project(layout, [0.0, *y])[1]).collect();
        let across = Axis { at: x, minor: Vec::new(), labels: &across.labels, name: &names[0] };
        let up = Axis { at: y, minor: Vec::new(), labels: &up.labels, name: &names[1] };
        axes::draw(canvas, layout.plot, &across, &up);
    }

    fn draw_title(&self, canvas: &mut Canvas, layout: &Layout) {
        let size = 1.2 * canvas.size;
        let (left, right) = (layout.plot.left as f32, layout.plot.right as f32);
        let time = self.time.map_or(String::new(), |t| format!("t = {} s", number(t, 3, 10.0 * t)));
        let taken = if time.is_empty() { 0.0 } else { canvas.letters.width(&time, size) + size };
        let at = |x| [x, layout.title];
        let title = Text { text: &self.title, size, at: at(left), anchor: Anchor::Start, upwards: false };
        canvas.fitted(title, right - left - taken);
        canvas.fitted(Text { text: &time, at: at(right), anchor: Anchor::End, ..title }, right - left);
    }
}

fn widened(value: f64) -> (f64, f64) {
    let half = if value == 0.0 { 1.0 } else { 0.5 * value.abs() };
    (value - half, value + half)
}
