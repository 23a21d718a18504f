//! A shaded area between two curves: the scatter of measurements.

use crate::raster::draw::Rect;
use crate::raster::image::Image;

/// Share of the colour of the measurements in the shade: lines and markers on it stay readable.
const OPACITY: f32 = 0.2;

/// Shades each column of pixels of `clip` between the curves through `lower` and `upper`, which have
/// the same abscissae, not decreasing; `None` interrupts the band.
pub(super) fn shade(
    image: &mut Image,
    clip: Rect,
    lower: &[Option<[f32; 2]>],
    upper: &[Option<[f32; 2]>],
    color: [u8; 3],
) {
    for (low, up) in lower.windows(2).zip(upper.windows(2)) {
        let ([Some(a), Some(b)], [Some(c), Some(d)]) = (low, up) else { continue };
        // A column belongs to the piece that holds its middle, so that none is shaded twice.
        let first = ((a[0] - 0.5).ceil() as i64).max(clip.left);
        let last = ((b[0] - 0.5).ceil() as i64).min(clip.right);
        for column in first..last {
            let share = (column as f32 + 0.5 - a[0]) / (b[0] - a[0]);
            let ends = [a[1] + share * (b[1] - a[1]), c[1] + share * (d[1] - c[1])];
            let (top, bottom) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            let rows = (top.floor() as i64).max(clip.top)..(bottom.ceil() as i64).min(clip.bottom);
            for row in rows {
                let cover = (bottom.min(row as f32 + 1.0) - top.max(row as f32)).clamp(0.0, 1.0);
                image.blend(column, row, color, OPACITY * cover);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_is_shaded_once_and_a_gap_stays_white() {
        let mut image = Image::new(40, 20);
        let clip = Rect { left: 0, right: 40, top: 0, bottom: 20 };
        let curve = |y: f32| -> Vec<Option<[f32; 2]>> {
            [0.0, 3.3, 9.5, 20.0].iter().map(|&x| Some([x, y])).chain([None, Some([30.0, y])]).collect()
        };
        shade(&mut image, clip, &curve(15.0), &curve(5.0), [0; 3]);
        let shaded = image.pixel(1, 10).unwrap();
        assert!(shaded[0] < 220, "{shaded:?}");
        for x in 0..40 {
            for y in 0..20 {
                let expected = if x < 20 && (5..15).contains(&y) { shaded } else { [255; 3] };
                assert_eq!(image.pixel(x, y).unwrap(), expected, "{x} {y}");
            }
        }
    }
}
