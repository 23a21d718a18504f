//! PNG files are read back by the `png` crate: stills, films, curve plots.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on should fail")]

mod common;

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use common::{directory, listing};
use mps_io::{ColorMap, CurvePlot, FieldPicture, Film, Image, OutputError, View};
use mps_kernel::Vector;
use proptest::prelude::*;

type Reader = png::Reader<BufReader<File>>;

fn open(path: &Path) -> Reader {
    png::Decoder::new(BufReader::new(File::open(path).unwrap())).read_info().unwrap()
}

/// A frame of a film: a disc that moves to the right.
fn frame(k: u32) -> Image {
    let at = [Vector::<f64, 2>::new(0.1 + 0.1 * f64::from(k), 0.5)];
    FieldPicture::new(400, View::new([0.0, 0.0], [2.0, 1.0]))
        .title("film")
        .time(0.1 * f64::from(k))
        .layer(&at, 0.1, &[f64::from(k)], (0.0, 10.0), ColorMap::Plasma, "value")
        .render()
        .unwrap()
}

/// All frames as a browser shows them, each patch laid over the frame before.
fn play(path: &Path) -> (u32, Vec<Vec<u8>>) {
    let mut reader = open(path);
    let (width, height) = reader.info().size();
    let count = reader.info().animation_control().unwrap().num_frames;
    let mut shown = vec![0; 3 * (width * height) as usize];
    let mut frames = Vec::new();
    for _ in 0..count {
        let mut patch = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut patch).unwrap();
        let control = *reader.info().frame_control().unwrap();
        assert_eq!((control.delay_num, control.delay_den), (1, 25));
        for row in 0..control.height {
            let bytes = 3 * control.width as usize;
            let from = row as usize * bytes;
            let to = 3 * ((control.y_offset + row) * width + control.x_offset) as usize;
            shown[to..to + bytes].copy_from_slice(&patch[from..from + bytes]);
        }
        frames.push(shown.clone());
    }
    (count, frames)
}

#[test]
fn a_still_comes_back_as_it_was() {
    let dir = directory("still");
    let image = frame(3);
    image.write_png(dir.join("still.png")).unwrap();
    let mut reader = open(&dir.join("still.png"));
    assert_eq!(reader.info().size(), (image.width(), image.height()));
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    assert_eq!(pixels, image.rgb());
    assert_eq!(listing(&dir), ["still.png"]);
}

/// The film is complete after every frame: a killed run leaves what it has drawn.
#[test]
fn a_film_can_be_played_after_every_frame() {
    let path = directory("film").join("film.png");
    let mut film = Film::create(&path, 25).unwrap();
    let mut drawn = Vec::new();
    for k in 0..8 {
        // Every third frame is the same as the one before.
        let image = frame(k - u32::from(k % 3 == 2));
        film.push(&image).unwrap();
        drawn.push(image.rgb().to_vec());
        let (count, frames) = play(&path);
        assert_eq!((count, film.frames()), (k + 1, k + 1));
        assert!(frames == drawn, "frame {k}");
    }
}

/// What was filmed after the marks were taken is cut off, and the film can be played at once.
#[test]
fn a_film_goes_on_where_it_was() {
    let path = directory("resumed").join("film.png");
    let mut film = Film::create(&path, 25).unwrap();
    let images: Vec<Image> = (0..5).map(frame).collect();
    let drawn: Vec<Vec<u8>> = images.iter().map(|image| image.rgb().to_vec()).collect();
    images[..2].iter().for_each(|image| film.push(image).unwrap());
    let marks = film.marks();
    images[2..].iter().for_each(|image| film.push(image).unwrap());
    drop(film);
    let mut film = Film::resume(&path, 25, marks).unwrap();
    assert!(play(&path).1 == drawn[..2]);
    images[2..].iter().for_each(|image| film.push(image).unwrap());
    assert!(play(&path).1 == drawn);
    std::fs::write(&path, b"short").unwrap();
    let error = Film::resume(&path, 25, marks).err().unwrap();
    assert!(error.to_string().contains("it is shorter than it was"), "{error}");
}

#[test]
fn only_the_changed_part_is_stored() {
    let path = directory("patch").join("film.png");
    let mut film = Film::create(&path, 25).unwrap();
    film.push(&frame(0)).unwrap();
    let one = std::fs::metadata(&path).unwrap().len();
    for _ in 0..10 {
        film.push(&frame(0)).unwrap();
    }
    let many = std::fs::metadata(&path).unwrap().len();
    assert!(many < one + 10 * 200, "{one} {many}");
}

#[test]
fn a_frame_of_another_size_is_refused() {
    let path = directory("size").join("film.png");
    let mut film = Film::create(&path, 25).unwrap();
    film.push(&frame(0)).unwrap();
    let error = film.push(&Image::new(10, 20)).unwrap_err();
    assert!(error.to_string().contains("a frame of 10 x 20 pixels in a film of 400 x"), "{error}");
    film.push(&frame(1)).unwrap();
    assert_eq!(play(&path).0, 2);
}

/// Pale inside, white outside, and the curve on it keeps its colour.
#[test]
fn a_band_lies_behind_the_curves_and_stretches_the_axis() {
    let x = [0.0, 1.0];
    let image = CurvePlot::new("", "x", "y")
        .line("run", &x, &[2.0; 2])
        .band("scatter", &x, &[1.0; 2], &[3.0; 2])
        .y_range(0.0, 4.0)
        .render()
        .unwrap();
    let middle = image.width() / 2 + 7;
    let column: Vec<[u8; 3]> = (0..image.height()).map(|y| image.pixel(middle, y).unwrap()).collect();
    let pale = |c: &&[u8; 3]| c[0] == c[1] && c[1] == c[2] && (190..226).contains(&c[0]);
    let shaded = column.iter().filter(pale).count() as f64 / f64::from(image.height());
    assert!((0.3..0.5).contains(&shaded), "half of the axis is shaded, {shaded} of the height");
    assert!(column.contains(&[0, 114, 178]), "the line is on top");

    let free = CurvePlot::new("", "x", "y").band("scatter", &x, &[1.0; 2], &[900.0; 2]);
    assert!(free.clone().render().is_ok());
    let uneven = free.band("uneven", &x, &[1.0; 2], &[900.0]).render().unwrap_err().to_string();
    assert!(uneven.contains("uneven"), "{uneven}");
}

#[test]
fn curves_have_their_colours_and_markers_their_places() {
    let x: Vec<f64> = (0..50).map(f64::from).collect();
    let flat = |y: f64| vec![y; 50];
    let plot = CurvePlot::new("t", "x", "y")
        .y_range(0.0, 4.0)
        .line("first", &x, &flat(1.0))
        .line("second", &x, &flat(2.0))
        .dashed("third", &x, &flat(3.0));
    let image = plot.clone().render().unwrap();
    let middle = image.width() / 2;
    let column: Vec<[u8; 3]> = (0..image.height()).map(|y| image.pixel(middle, y).unwrap()).collect();
    let row = |color| column.iter().position(|c| *c == color);
    let (first, second) = (row([0, 114, 178]).unwrap(), row([213, 94, 0]).unwrap());
    assert!(second < first, "y points upwards");
    // The dashed line covers part of its row, the solid ones all of theirs.
    let share = |y: usize, color| {
        let hits = (0..image.width()).filter(|x| image.pixel(*x, y as u32) == Some(color)).count();
        hits as f64 / f64::from(image.width())
    };
    assert!(share(first + 1, [0, 114, 178]) > 0.85);
    let third = (0..image.height() as usize).map(|y| share(y, [0, 158, 115])).fold(0.0, f64::max);
    assert!((0.3..0.75).contains(&third), "{third}");
    // A marker between the two lines: a black ring around a white centre, half way up.
    let marked = plot.points("experiment", &[24.5], &[1.5]).render().unwrap();
    let (top, bottom) = (second as u32 + 6, first as u32 - 6);
    let changed: Vec<(u32, u32)> = (top..bottom)
        .flat_map(|y| (0..image.width()).map(move |x| (x, y)))
        .filter(|(x, y)| marked.pixel(*x, *y) != image.pixel(*x, *y))
        .collect();
    let (up, down) = (changed.first().unwrap().1, changed.last().unwrap().1);
    let (left, right) =
        (changed.iter().map(|c| c.0).min().unwrap(), changed.iter().map(|c| c.0).max().unwrap());
    assert!((up + down).abs_diff((first + second) as u32) <= 4, "{up} {down} {first} {second}");
    assert!((right - left).abs_diff(down - up) <= 2 && (8..30).contains(&(right - left)));
    assert_eq!(marked.pixel((left + right) / 2, (up + down) / 2), Some([255; 3]));
    assert!(changed.iter().any(|(x, y)| marked.pixel(*x, *y) == Some([30, 30, 30])));
}

#[test]
fn plots_that_cannot_be_drawn_say_why() {
    let error = CurvePlot::new("empty", "x", "y").render().unwrap_err().to_string();
    assert!(error.contains("cannot draw empty: no curve has a finite point"), "{error}");
    let nothing = CurvePlot::new("log", "x", "y").log_y().line("a", &[1.0], &[-1.0]).render();
    assert!(matches!(nothing, Err(OutputError::Picture { .. })));
    let error = CurvePlot::new("t", "x", "y").line("front", &[1.0, 2.0], &[1.0]).render().unwrap_err();
    assert!(matches!(error, OutputError::FieldLength { expected: 2, found: 1, .. }));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever the numbers, a plot is drawn or refused; nothing panics or takes for ever.
    #[test]
    fn any_numbers_can_be_plotted(
        bits in prop::collection::vec((any::<f64>(), any::<f64>()), 1..40),
        logarithmic: bool,
        range in prop::option::of((any::<f64>(), any::<f64>())),
    ) {
        let (x, y): (Vec<f64>, Vec<f64>) = bits.into_iter().unzip();
        let mut plot = CurvePlot::new("any", "x", "y").size(300, 200).line("a", &x, &y).points("b", &y, &x);
        plot = plot.dashed("c", &x, &x);
        if logarithmic {
            plot = plot.log_x().log_y();
        }
        if let Some((low, high)) = range {
            plot = plot.x_range(low, high).y_range(high, low);
        }
        if let Ok(image) = plot.render() {
            prop_assert_eq!((image.width(), image.height()), (300, 200));
        }
    }

    /// The same for fields of particles.
    #[test]
    fn any_field_can_be_drawn(
        points in prop::collection::vec((any::<f64>(), any::<f64>(), any::<f64>()), 1..40),
        lower: [f64; 2],
        extent in (1e-6..1e6f64, 1e-6..1e6f64),
        range: (f64, f64),
        bars in 0..5usize,
        text in 1.0..300.0f64,
    ) {
        let at: Vec<Vector<f64, 2>> = points.iter().map(|p| Vector::<f64, 2>::new(p.0, p.1)).collect();
        let values: Vec<f64> = points.iter().map(|p| p.2).collect();
        let view = View::new(lower, [lower[0] + extent.0, lower[1] + extent.1]);
        let mut picture = FieldPicture::new(200, view)
            .text_size(text)
            .layer(&at, 0.1 * extent.0, &values, range, ColorMap::Viridis, "any")
            .line(&[lower, [points[0].0, points[0].1]], [0; 3]);
        for _ in 0..bars {
            picture = picture.layer(&at, 0.1, &values, (0.0, 1e9), ColorMap::Blues, "a long label of a bar [kg/m³]");
        }
        if let Ok(image) = picture.render() {
            prop_assert_eq!(image.width(), 200);
        }
    }
}
