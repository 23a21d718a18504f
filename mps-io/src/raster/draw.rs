//! Discs, polygons and rectangles, anti-aliased where an edge is not on the pixel grid.

use super::image::Image;

/// A rectangle in pixels: `left <= x < right`, `top <= y < bottom`, y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rect {
    pub(crate) left: i64,
    pub(crate) top: i64,
    pub(crate) right: i64,
    pub(crate) bottom: i64,
}

impl Rect {
    pub(crate) fn width(&self) -> i64 {
        self.right - self.left
    }

    pub(crate) fn height(&self) -> i64 {
        self.bottom - self.top
    }
}

/// A filled disc about `(x, y)`, where the centre of the top left pixel is `(0.5, 0.5)`, clipped.
#[inline]
pub(crate) fn disc(image: &mut Image, clip: Rect, x: f32, y: f32, radius: f32, color: [u8; 3]) {
    let reach = radius + 0.5;
    let top = ((y - reach).floor() as i64).max(clip.top);
    let bottom = ((y + reach).ceil() as i64).min(clip.bottom);
    let solid = (radius - 0.5).max(0.0);
    for row in top..bottom {
        let dy = row as f32 + 0.5 - y;
        let outer = (reach * reach - dy * dy).max(0.0).sqrt();
        let inner = (solid * solid - dy * dy).max(0.0).sqrt();
        let from = ((x - outer).floor() as i64).max(clip.left);
        let to = ((x + outer).ceil() as i64).min(clip.right);
        // The solid middle of the row is filled without looking at the distance of each pixel.
        let (mut a, mut b) = ((x - inner).ceil() as i64, (x + inner).floor() as i64);
        if inner <= 0.0 || a >= b {
            (a, b) = (to, to);
        }
        let (a, b) = (a.clamp(from, to.max(from)), b.clamp(from, to.max(from)));
        for column in (from..a).chain(b..to) {
            let dx = column as f32 + 0.5 - x;
            let cover = (reach - (dx * dx + dy * dy).sqrt()).clamp(0.0, 1.0);
            image.blend(column, row, color, cover);
        }
        image.fill_row(row, a, b, color);
    }
}

/// A filled convex polygon with corners in order (either way round), clipped.
pub(crate) fn polygon(image: &mut Image, clip: Rect, corners: &[[f32; 2]], color: [u8; 3]) {
    let middle = [0, 1].map(|c| corners.iter().map(|p| p[c]).sum::<f32>() / corners.len().max(1) as f32);
    let lower = |c: usize| corners.iter().map(|p| p[c]).fold(f32::INFINITY, f32::min).floor() as i64 - 1;
    let upper = |c: usize| corners.iter().map(|p| p[c]).fold(f32::NEG_INFINITY, f32::max).ceil() as i64 + 1;
    // Each edge as a normal of length 1 that points away from the middle, and its distance.
    let edges: Vec<[f32; 3]> = (corners.iter().zip(corners.iter().cycle().skip(1)))
        .map(|(a, b)| {
            let (nx, ny) = (b[1] - a[1], a[0] - b[0]);
            let outwards = nx * (a[0] - middle[0]) + ny * (a[1] - middle[1]);
            let scale = outwards.signum() / nx.hypot(ny).max(1e-6);
            [nx * scale, ny * scale, (nx * a[0] + ny * a[1]) * scale]
        })
        .collect();
    for row in lower(1).max(clip.top)..upper(1).min(clip.bottom) {
        for column in lower(0).max(clip.left)..upper(0).min(clip.right) {
            let (x, y) = (column as f32 + 0.5, row as f32 + 0.5);
            let outside =
                edges.iter().map(|[nx, ny, d]| nx * x + ny * y - d).fold(f32::NEG_INFINITY, f32::max);
            let cover = (0.5 - outside).clamp(0.0, 1.0);
            if cover > 0.0 {
                image.blend(column, row, color, cover);
            }
        }
    }
}

/// A filled rectangle.
pub(crate) fn fill(image: &mut Image, rect: Rect, color: [u8; 3]) {
    for row in rect.top..rect.bottom {
        image.fill_row(row, rect.left, rect.right, color);
    }
}

/// The outline of a rectangle, `width` pixels, drawn outside of it.
pub(crate) fn frame(image: &mut Image, rect: Rect, width: i64, color: [u8; 3]) {
    let Rect { left, top, right, bottom } = rect;
    for (l, t, r, b) in [
        (left - width, top - width, right + width, top),
        (left - width, bottom, right + width, bottom + width),
        (left - width, top, left, bottom),
        (right, top, right + width, bottom),
    ] {
        fill(image, Rect { left: l, top: t, right: r, bottom: b }, color);
    }
}
