//! Pictures are checked pixel by pixel: known particles, colour bars, borders, wrong input.

use mps_kernel::Vector;

use super::field::FieldPicture;
use super::{ColorMap, Image, View, value_range};
use crate::OutputError;

const MAPS: [ColorMap; 8] = [
    ColorMap::Viridis,
    ColorMap::Cividis,
    ColorMap::Plasma,
    ColorMap::Inferno,
    ColorMap::Blues,
    ColorMap::OrangeRed,
    ColorMap::BlueRed,
    ColorMap::Turbo,
];

/// Brightness as the eye sees it, from 0 to 255.
fn brightness([r, g, b]: [u8; 3]) -> f64 {
    0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
}

fn pixel(image: &Image, [x, y]: [f64; 2]) -> [u8; 3] {
    image.pixel(x as u32, y as u32).unwrap()
}

/// Particles take one of 256 colours: equal to the exact one within a step.
fn alike(found: [u8; 3], expected: [u8; 3]) -> bool {
    found.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= 2)
}

/// Five particles in a row with the values 0, 1, 2, 3, 4 on a range from 0 to 4.
fn row(view: View) -> FieldPicture {
    let at: Vec<Vector<f64, 2>> =
        (0..5).map(|k| Vector::<f64, 2>::new(0.2 + 0.4 * f64::from(k), 0.5)).collect();
    let values: Vec<f64> = (0..5).map(f64::from).collect();
    FieldPicture::new(700, view).title("row").time(1.5).layer(
        &at,
        0.1,
        &values,
        (0.0, 4.0),
        ColorMap::Viridis,
        "value [-]",
    )
}

#[test]
fn particles_have_the_colour_of_their_value() {
    // Colour bar below and beside.
    for view in [View::new([0.0, 0.0], [2.0, 1.0]), View::new([0.0, -0.5], [2.0, 1.5])] {
        for k in 0..5 {
            let picture = row(view);
            let at = picture.pixel_of([0.2 + 0.4 * f64::from(k), 0.5]).unwrap();
            let image = picture.render().unwrap();
            let (found, expected) = (pixel(&image, at), ColorMap::Viridis.color(f64::from(k) / 4.0));
            assert!(alike(found, expected), "particle {k}: {found:?}, not {expected:?}");
            // White between the particles.
            let between = row(view).pixel_of([0.4 + 0.4 * f64::from(k), 0.62]).unwrap();
            assert_eq!(pixel(&image, between), [255; 3], "beside particle {k}");
        }
    }
}

#[test]
fn the_radius_is_to_scale() {
    let view = View::new([0.0, 0.0], [2.0, 1.0]);
    let image = row(view).render().unwrap();
    let [left, _] = row(view).pixel_of([0.9, 0.5]).unwrap();
    let [right, y] = row(view).pixel_of([1.1, 0.5]).unwrap();
    let color = ColorMap::Viridis.color(0.5);
    for x in (left as u32 + 1)..right as u32 {
        assert!(alike(pixel(&image, [f64::from(x), y]), color), "{x} of {left}..{right}");
    }
    for x in [left - 2.0, right + 2.0] {
        assert_eq!(pixel(&image, [x, y]), [255; 3]);
    }
}

#[test]
fn axes_have_the_same_scale() {
    for (dx, dy) in [(4.0, 1.0), (1.0, 1.0), (0.2, 3.0)] {
        let picture = FieldPicture::new(800, View::new([0.0, 0.0], [dx, dy]));
        let [x0, y0] = picture.pixel_of([0.0, 0.0]).unwrap();
        let [x1, y1] = picture.pixel_of([dx, dy]).unwrap();
        let (across, up) = ((x1 - x0) / dx, (y0 - y1) / dy);
        assert!((across / up - 1.0).abs() < 0.01, "{across} {up}");
        let image = picture.render().unwrap();
        assert!(image.width() == 800 && image.height() < 1000);
    }
}

/// Along the bar the brightness rises without a step back, from the colour of one end to the other.
#[test]
fn the_colour_bar_is_monotone_and_complete() {
    for view in [View::new([0.0, 0.0], [2.0, 1.0]), View::new([0.0, -0.5], [2.0, 1.5])] {
        let letters = crate::raster::text::Letters::new().unwrap();
        let picture = row(view);
        let bar = picture.layout(&letters).bars.pop().unwrap();
        let image = picture.render().unwrap();
        let rect = bar.rect;
        let colors: Vec<[u8; 3]> = if bar.upright {
            let x = ((rect.left + rect.right) / 2) as u32;
            (rect.top..rect.bottom).rev().map(|y| image.pixel(x, y as u32).unwrap()).collect()
        } else {
            let y = ((rect.top + rect.bottom) / 2) as u32;
            (rect.left..rect.right).map(|x| image.pixel(x as u32, y).unwrap()).collect()
        };
        assert!(colors.len() > 200);
        assert!(colors.is_sorted_by(|a, b| brightness(*a) <= brightness(*b) + 0.6));
        assert_eq!(colors.first(), Some(&ColorMap::Viridis.color(0.5 / colors.len() as f64)));
        assert!(brightness(*colors.last().unwrap()) > 200.0);
        // The tick of the value 2 is in the middle.
        let middle = bar.ticks.values.iter().position(|v| *v == 2.0);
        assert!(middle.is_some(), "{:?}", bar.ticks);
    }
}

#[test]
fn colour_maps_change_everywhere_and_sequential_ones_only_in_one_direction() {
    for map in MAPS {
        let colors: Vec<[u8; 3]> = (0..=64).map(|k| map.color(f64::from(k) / 64.0)).collect();
        assert!(colors.windows(2).all(|pair| pair[0] != pair[1]), "{map:?}");
        let rising = colors.is_sorted_by(|a, b| brightness(*a) <= brightness(*b) + 0.6);
        let falling = colors.is_sorted_by(|a, b| brightness(*a) >= brightness(*b) - 0.6);
        let sequential = !matches!(map, ColorMap::BlueRed | ColorMap::Turbo);
        assert_eq!(rising || falling, sequential, "{map:?}");
        assert_eq!((map.color(-3.0), map.color(7.0)), (map.color(0.0), map.color(1.0)));
    }
}

#[test]
fn values_outside_the_range_and_not_a_number() {
    let at: Vec<Vector<f32, 2>> = (0..5).map(|k| Vector::<f32, 2>::new(0.2 + 0.4 * k as f32, 0.5)).collect();
    let values = [-10.0, 10.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    let make = || {
        FieldPicture::new(500, View::new([0.0, 0.0], [2.0, 1.0])).layer(
            &at,
            0.1,
            &values,
            (0.0, 4.0),
            ColorMap::Viridis,
            "",
        )
    };
    let image = make().render().unwrap();
    let (low, high) = (ColorMap::Viridis.color(0.0), ColorMap::Viridis.color(1.0));
    for (k, color) in [low, high, [255, 0, 255], high, low].into_iter().enumerate() {
        let at = make().pixel_of([0.2 + 0.4 * k as f64, 0.5]).unwrap();
        assert_eq!(pixel(&image, at), color, "value {}", values[k]);
    }
}

#[test]
fn later_layers_cover_earlier_ones_and_near_particles_far_ones() {
    let view = View::new([-1.0, -1.0], [1.0, 1.0]);
    let here = [Vector::<f64, 2>::zeros()];
    let make = || FieldPicture::new(300, view).plain(&here, 0.5, [1, 2, 3]).plain(&here, 0.3, [7, 8, 9]);
    let center = make().pixel_of([0.0, 0.0]).unwrap();
    assert_eq!(pixel(&make().render().unwrap(), center), [7, 8, 9]);

    // Seen along z the largest z is near; in the view of x and z the smallest y.
    let both = [Vector::<f64, 3>::new(0.0, -0.5, 0.5), Vector::<f64, 3>::new(0.0, 0.5, -0.5)];
    for (positions, axes, near) in [
        (both, [0, 1], 0),
        ([both[1], both[0]], [0, 1], 1),
        (both, [0, 2], 0),
        ([both[1], both[0]], [0, 2], 1),
    ] {
        let picture = FieldPicture::new(300, view.with_axes(axes)).layer(
            &positions,
            0.9,
            &[0.0, 1.0],
            (0.0, 1.0),
            ColorMap::Viridis,
            "",
        );
        let center = picture.pixel_of([0.0, 0.0]).unwrap();
        let color = pixel(&picture.render().unwrap(), center);
        assert_eq!(color, ColorMap::Viridis.color(f64::from(near)), "{axes:?} {near}");
    }
}

#[test]
fn nothing_is_drawn_outside_the_axes() {
    let view = View::new([0.0, 0.0], [1.0, 1.0]);
    let far = [
        Vector::<f64, 2>::new(-0.2, 0.5),
        Vector::<f64, 2>::new(0.5, 1.04),
        Vector::<f64, 2>::new(1e300, f64::NAN),
        Vector::<f64, 2>::new(f64::INFINITY, 0.0),
    ];
    let bare = FieldPicture::new(300, view).render().unwrap();
    let filled = FieldPicture::new(300, view)
        .plain(&far, 0.1, [255, 0, 0])
        .line(&[[-5.0, 0.25], [5.0, 0.25]], [255, 0, 0])
        .render()
        .unwrap();
    let picture = FieldPicture::new(300, view);
    let ([left, bottom], [right, top]) =
        (picture.pixel_of([0.0, 0.0]).unwrap(), picture.pixel_of([1.0, 1.0]).unwrap());
    let mut inside = 0;
    for y in 0..bare.height() {
        for x in 0..bare.width() {
            if bare.pixel(x, y) != filled.pixel(x, y) {
                let (x, y) = (f64::from(x), f64::from(y));
                assert!(x >= left && x < right && y >= top && y < bottom, "{x} {y}");
                inside += 1;
            }
        }
    }
    assert!(inside > 100, "the line and the disc on the upper edge are seen: {inside}");
}

#[test]
fn wrong_input_is_told_by_render() {
    let view = View::new([0.0, 0.0], [1.0, 1.0]);
    let at = [Vector::<f64, 2>::zeros()];
    let layer = |values: &[f64], range| {
        FieldPicture::new(300, view).layer(&at, 0.1, values, range, ColorMap::Turbo, "pressure")
    };
    assert!(matches!(
        layer(&[], (0.0, 1.0)).render(),
        Err(OutputError::FieldLength { expected: 1, found: 0, .. })
    ));
    for (picture, part) in [
        (layer(&[1.0], (0.0, f64::NAN)), "the range (0.0, NaN) of 'pressure' is not finite"),
        (FieldPicture::new(300, View::new([0.0, 0.0], [1.0, 0.0])), "has no area"),
        (FieldPicture::new(300, View::containing::<f64, 2>(&[], 0.1)), "has no area"),
        (FieldPicture::new(10, view), "a width of 10 pixels"),
        (FieldPicture::new(300, view).plain(&at, 0.0, [0; 3]), "particles of radius 0 m"),
        (FieldPicture::new(300, view.with_axes([0, 2])).plain(&at, 0.1, [0; 3]), "are not two of the 2"),
        (FieldPicture::new(300, view.with_axes([1, 1])).plain(&at, 0.1, [0; 3]), "are not two of the 2"),
    ] {
        let error = picture.render().unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn a_constant_field_is_drawn_in_the_middle_of_its_map() {
    let at = [Vector::<f64, 2>::new(0.5, 0.5)];
    let view = View::containing(&at, 0.5);
    assert_eq!(value_range(&[2.0, f64::NAN, 2.0]), (2.0, 2.0));
    let make = || FieldPicture::new(300, view).layer(&at, 0.2, &[2.0], (2.0, 2.0), ColorMap::Viridis, "p");
    let center = make().pixel_of([0.5, 0.5]).unwrap();
    let color = pixel(&make().render().unwrap(), center);
    assert!(brightness(color) > 90.0 && brightness(color) < 150.0, "{color:?}");
}

/// Frames of a film must not change their size with the time or the values.
#[test]
fn the_size_does_not_depend_on_time_and_values() {
    let view = View::new([0.0, 0.0], [2.0, 1.0]);
    let size = |time: f64, value: f64| {
        let at = [Vector::<f64, 2>::new(value, 0.5)];
        let image = FieldPicture::new(640, view)
            .title("film")
            .time(time)
            .layer(&at, 0.1, &[value], (0.0, 1.0), ColorMap::Blues, "p [Pa]")
            .render()
            .unwrap();
        (image.width(), image.height())
    };
    assert_eq!(size(0.0, 0.1), size(1234.5, 7e9));
}
