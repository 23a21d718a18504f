//! Text in a picture: one embedded font, so that pictures look the same on every machine.

use std::sync::OnceLock;

use ab_glyph::{Font, FontRef, PxScale, ScaleFont, point};

use super::image::Image;
use crate::OutputError;

/// Where the given point lies in the text.
#[derive(Clone, Copy)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// A line of text and where it stands.
#[derive(Clone, Copy)]
pub(crate) struct Text<'a> {
    pub(crate) text: &'a str,
    /// Distance between lines in pixels, about 1.6 times the height of a capital.
    pub(crate) size: f32,
    /// A point of the baseline: the one told by `anchor`.
    pub(crate) at: [f32; 2],
    pub(crate) anchor: Anchor,
    /// Turned a quarter to the left, running upwards.
    pub(crate) upwards: bool,
}

/// DejaVu Sans: it has Greek letters, superscripts and mathematical signs.
pub(crate) struct Letters {
    font: &'static FontRef<'static>,
}

impl Letters {
    pub(crate) fn new() -> Result<Self, OutputError> {
        static FONT: OnceLock<Option<FontRef<'static>>> = OnceLock::new();
        match FONT.get_or_init(|| FontRef::try_from_slice(dejavu::sans::regular()).ok()) {
            Some(font) => Ok(Self { font }),
            None => Err(OutputError::Picture {
                what: "text".to_owned(),
                reason: "the font built into the program is damaged; build the program again".to_owned(),
            }),
        }
    }

    /// Width of `text` in pixels.
    pub(crate) fn width(&self, text: &str, size: f32) -> f32 {
        let mut width = 0.0;
        self.place(text, size, |_, x, advance| width = x + advance);
        width
    }

    /// The largest size up to `size` at which `text` fits into `available` pixels.
    pub(crate) fn fit(&self, text: &str, size: f32, available: f32) -> f32 {
        let width = self.width(text, size);
        if width > available && available > 0.0 { size * available / width } else { size }
    }

    /// Writes the text in one colour.
    pub(crate) fn draw(&self, image: &mut Image, text: &Text, color: [u8; 3]) {
        let Text { text, size, at: [x, y], anchor, upwards } = *text;
        let back = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * self.width(text, size),
            Anchor::End => self.width(text, size),
        };
        let font = self.font;
        self.place(text, size, |letter, along, _| {
            let along = along - back;
            // Glyphs are rasterised upright and turned pixel by pixel: exact for a quarter turn when
            // the fraction of the position is turned with them.
            let (gx, gy) = if upwards { (along - y, x) } else { (along + x, y) };
            let glyph = font.glyph_id(letter).with_scale_and_position(PxScale::from(size), point(gx, gy));
            let Some(outline) = font.outline_glyph(glyph) else { return };
            let corner = outline.px_bounds().min;
            outline.draw(|column, row, cover| {
                let (px, py) = (corner.x as i64 + i64::from(column), corner.y as i64 + i64::from(row));
                let (px, py) = if upwards { (py, -px - 1) } else { (px, py) };
                image.blend(px, py, color, cover.clamp(0.0, 1.0));
            });
        });
    }

    /// Calls `visit(letter, x, advance)` for each letter from the left, with kerning.
    fn place(&self, text: &str, size: f32, mut visit: impl FnMut(char, f32, f32)) {
        let scaled = self.font.as_scaled(PxScale::from(size));
        let (mut x, mut previous) = (0.0, None);
        for letter in text.chars() {
            let id = scaled.glyph_id(letter);
            if let Some(previous) = previous {
                x += scaled.kern(previous, id);
            }
            let advance = scaled.h_advance(id);
            visit(letter, x, advance);
            x += advance;
            previous = Some(id);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(upwards: bool, anchor: Anchor) -> Image {
        let mut image = Image::new(101, 101);
        let text = Text { text: "Pa ρ⁻³", size: 20.0, at: [50.0, 50.0], anchor, upwards };
        Letters::new().unwrap().draw(&mut image, &text, [0; 3]);
        image
    }

    /// A quarter turn to the left about the corner point (50, 50) takes pixel (x, y) to (y, 99 - x).
    #[test]
    fn turned_text_is_the_same_text_turned() {
        for anchor in [Anchor::Start, Anchor::Middle, Anchor::End] {
            let (lying, turned) = (drawn(false, anchor), drawn(true, anchor));
            let mut dark = 0;
            for (x, y) in (0..100).flat_map(|x| (0..100).map(move |y| (x, y))) {
                let pixel = lying.pixel(x, y).unwrap();
                assert_eq!(Some(pixel), turned.pixel(y, 99 - x), "{x} {y}");
                dark += u32::from(pixel[0] < 100);
            }
            assert!(dark > 50, "{dark}");
        }
    }

    #[test]
    fn anchors_and_widths_agree() {
        let letters = Letters::new().unwrap();
        let width = letters.width("Pa ρ⁻³", 20.0);
        let first = |image: &Image| {
            (0..101u32).find(|x| (0..101).any(|y| image.pixel(*x, y).unwrap()[0] < 128)).unwrap()
        };
        let (start, end) = (first(&drawn(false, Anchor::Start)), first(&drawn(false, Anchor::End)));
        assert!(((start - end) as f32 - width).abs() <= 1.5, "{start} {end} {width}");
        let half = letters.fit("Pa ρ⁻³", 20.0, 0.5 * width);
        assert!((letters.width("Pa ρ⁻³", half) - 0.5 * width).abs() < 0.5);
    }

    /// Everything labels may need is in the font: no letter is drawn as an empty box.
    #[test]
    fn greek_and_mathematics_are_in_the_font() {
        let letters = Letters::new().unwrap();
        for letter in "αβγδεζηθλμνξπρστφχψωΓΔΘΛΠΣΦΨΩ∇∂√∞≈≤≥±×·−–→∝∫⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺₀₁₂₃ₓ°".chars()
        {
            assert_ne!(letters.font.glyph_id(letter).0, 0, "{letter}");
        }
    }
}
