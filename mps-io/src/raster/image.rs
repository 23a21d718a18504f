//! A picture in memory and its PNG file.

use std::path::Path;

use crate::OutputError;
use crate::directory::write_atomically;

/// A picture of 8-bit red, green and blue, rows from the top.
#[derive(Clone, PartialEq, Eq)]
pub struct Image {
    width: u32,
    height: u32,
    rgb: Vec<u8>,
}

impl Image {
    /// A white picture.
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, rgb: vec![255; 3 * width as usize * height as usize] }
    }

    /// Width in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The bytes red, green, blue of each pixel, row by row from the top left.
    pub fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// The colour of a pixel, counted from the top left; `None` outside.
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        let at = self.index(i64::from(x), i64::from(y))?;
        Some([self.rgb[at], self.rgb[at + 1], self.rgb[at + 2]])
    }

    /// Writes the picture as PNG, whole or not at all.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write_png(&self, path: impl AsRef<Path>) -> Result<(), OutputError> {
        let path = path.as_ref();
        let bytes = encode(self.width, self.height, &self.rgb)
            .map_err(|error| OutputError::Encode { path: path.to_path_buf(), reason: error.to_string() })?;
        write_atomically(path, |file| std::io::Write::write_all(file, &bytes))
    }

    /// Covers a pixel with `color`, `opacity` from 0 (nothing) to 1. Outside nothing happens.
    #[inline]
    pub(crate) fn blend(&mut self, x: i64, y: i64, color: [u8; 3], opacity: f32) {
        let Some(at) = self.index(x, y) else { return };
        let share = (opacity * 256.0) as i32;
        for (old, new) in self.rgb[at..at + 3].iter_mut().zip(color) {
            let old_value = i32::from(*old);
            *old = (old_value + (((i32::from(new) - old_value) * share) >> 8)) as u8;
        }
    }

    /// Pixels `from..to` of row `y`, clipped to the picture, in one colour.
    pub(crate) fn fill_row(&mut self, y: i64, from: i64, to: i64, color: [u8; 3]) {
        let (from, to) = (from.max(0), to.min(i64::from(self.width)));
        if from >= to || y < 0 || y >= i64::from(self.height) {
            return;
        }
        let row = y as usize * self.width as usize;
        let pixels = 3 * (row + from as usize)..3 * (row + to as usize);
        for pixel in self.rgb[pixels].as_chunks_mut::<3>().0 {
            *pixel = color;
        }
    }

    #[inline]
    fn index(&self, x: i64, y: i64) -> Option<usize> {
        let inside = (0..i64::from(self.width)).contains(&x) && (0..i64::from(self.height)).contains(&y);
        inside.then(|| 3 * (y as usize * self.width as usize + x as usize))
    }
}

impl std::fmt::Debug for Image {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Image({} x {})", self.width, self.height)
    }
}

/// A complete PNG file.
pub(crate) fn encode(width: u32, height: u32, rgb: &[u8]) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(rgb)?;
    writer.finish()?;
    Ok(bytes)
}
