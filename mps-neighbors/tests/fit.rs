//! Points that follow the surface of a shape: how many, how far apart, how deep, how evenly.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use core::f64::consts::{PI, TAU};
use mps_kernel::Vector;
use mps_kernel::weights::{Kernel, WendlandC2};
use mps_neighbors::Parallel;
use mps_neighbors::fit::{FitError, Fitted, Nearest, Shape, fit};
use proptest::prelude::*;

type Place<const D: usize> = Vector<f64, D>;

/// What straight sides enclose.
struct Polygon(Vec<Place<2>>);

impl Polygon {
    fn new<const N: usize>(corners: [[f64; 2]; N]) -> Self {
        Self(corners.map(Place::from).to_vec())
    }

    /// Turned about the origin by an angle.
    fn turned(mut self, angle: f64) -> Self {
        let (s, c) = angle.sin_cos();
        self.0.iter_mut().for_each(|p| *p = Place::<2>::new(c * p.x - s * p.y, s * p.x + c * p.y));
        self
    }

    /// Corners on an ellipse at these angles.
    fn on_ellipse(a: f64, b: f64, angles: impl Iterator<Item = f64>) -> Self {
        Self(angles.map(|t| Place::<2>::new(a * t.cos(), b * t.sin())).collect())
    }

    fn sides(&self) -> impl Iterator<Item = (&Place<2>, &Place<2>)> {
        self.0.iter().zip(self.0.iter().cycle().skip(1))
    }

    fn area(&self) -> f64 {
        self.sides().map(|(a, b)| 0.5 * (a.x * b.y - a.y * b.x)).sum()
    }
}

impl Shape<2> for Polygon {
    fn bounds(&self) -> [Place<2>; 2] {
        let around =
            |pick: fn(&Place<2>, &Place<2>) -> Place<2>| self.0.iter().fold(self.0[0], |a, b| pick(&a, b));
        [around(Place::inf), around(Place::sup)]
    }

    fn nearest(&self, r: &Place<2>) -> Option<Nearest<2>> {
        let foot = |(a, b): (&Place<2>, &Place<2>)| {
            let along = b - a;
            a + along * ((r - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0)
        };
        let foot = self.sides().map(foot).min_by(|p, q| (p - r).norm().total_cmp(&(q - r).norm()))?;
        let crossed = |(a, b): &(&Place<2>, &Place<2>)| {
            (a.y > r.y) != (b.y > r.y) && r.x < a.x + (b.x - a.x) * (r.y - a.y) / (b.y - a.y)
        };
        let inside = self.sides().filter(crossed).count() % 2 == 1;
        let distance = (foot - r).norm();
        Some(Nearest { foot, depth: if inside { distance } else { -distance } })
    }
}

/// What is between two distances from the origin, the first of which may be zero.
struct Shell([f64; 2]);

impl<const D: usize> Shape<D> for Shell {
    fn bounds(&self) -> [Place<D>; 2] {
        [-self.0[1], self.0[1]].map(Place::repeat)
    }

    fn nearest(&self, r: &Place<D>) -> Option<Nearest<D>> {
        let [inner, outer] = self.0;
        let radius = if r.norm() < 0.5 * (inner + outer) && inner > 0.0 { inner } else { outer };
        let foot = r.try_normalize(0.0).unwrap_or(Place::repeat((D as f64).sqrt().recip())) * radius;
        let off = if inner > 0.0 { r.norm() - inner } else { f64::INFINITY };
        Some(Nearest { foot, depth: off.min(outer - r.norm()) })
    }
}

const SPACING: f64 = 0.05;

/// Sum of weights at each point, over that of the lattice.
fn packing<const D: usize>(places: &[Place<D>], of: usize, spacing: f64) -> f64 {
    let weight = |off: &Place<D>| Kernel::<f64>::weight(&WendlandC2, off.norm() / spacing, 3.0_f64);
    let sum: f64 = places.iter().map(|place| weight(&(place - places[of]))).sum();
    let cell = |mut k: usize| {
        Place::<D>::from_fn(|_, _| {
            let here = k % 7;
            k /= 7;
            spacing * (here as f64 - 3.0)
        })
    };
    sum / (0..7_usize.pow(D as u32)).map(|k| weight(&cell(k))).sum::<f64>()
}

/// What is promised of every shape; returns the points.
///
/// `gap` is how far the surface may be from the nearest point, in spacings: 0.5 straight before one, 0.71 between two of them, and
/// more at the tip of a corner.
fn assert_fits<const D: usize>(name: &str, shape: &impl Shape<D>, volume: f64, gap: f64) -> Fitted<D> {
    let fitted = fit(shape, SPACING, &Parallel::serial()).unwrap();
    let Fitted { places, volume: each, .. } = &fitted;
    let (cell, count) = (SPACING.powi(D as i32), places.len());
    assert!((count as f64 * cell / volume - 1.0).abs() < 0.01, "{name}: {count} points");
    assert!((count as f64 * each / volume - 1.0).abs() < 0.005, "{name}: {each} each");
    let (mut nearest_pair, mut lonely, mut even) = (f64::INFINITY, 0.0_f64, [f64::INFINITY, 0.0]);
    for (i, place) in places.iter().enumerate() {
        let depth = shape.nearest(place).unwrap().depth / SPACING;
        assert!(depth > 0.499, "{name}: {place} is {depth} deep");
        assert!(!(0.52..0.95).contains(&depth) || gap > 0.8, "{name}: {place} is {depth} deep");
        let others = places.iter().enumerate().filter(|(j, _)| *j != i);
        let near = others.map(|(_, other)| (other - place).norm() / SPACING).fold(f64::INFINITY, f64::min);
        (nearest_pair, lonely) = (nearest_pair.min(near), lonely.max(near));
        if depth > 3.0 {
            let here = packing(places, i, SPACING);
            even = [even[0].min(here), even[1].max(here)];
        }
    }
    // Of polygons at random one in many has two at 0.799.
    let least = if gap > 1.0 { 0.75 } else { 0.8 };
    assert!(nearest_pair > least && lonely < 1.2, "{name}: neighbours at {nearest_pair} to {lonely}");
    assert!(even[0] > 0.96 && even[1] < 1.04, "{name}: packing {even:?}");
    // The feet of the points are spread over the surface; beyond each the surface has a point half a spacing behind it.
    let [lower, upper] = shape.bounds();
    let counts = (upper - lower).map(|side| (3.0 * side / SPACING) as usize);
    for mut k in 0..counts.iter().product() {
        let probe = Place::<D>::from_fn(|axis, _| {
            let here = k % counts[axis];
            k /= counts[axis];
            lower[axis] + SPACING * (here as f64 + 0.41) / 3.0
        });
        let Nearest { foot, depth } = shape.nearest(&probe).unwrap();
        if depth.abs() < SPACING {
            let near =
                places.iter().map(|place| (place - foot).norm() / SPACING).fold(f64::INFINITY, f64::min);
            assert!(near < gap, "{name}: {foot} of the surface is {near} from the next point");
        }
    }
    fitted
}

#[test]
fn boxes_of_whole_cells_are_the_lattice() {
    let fitted =
        assert_fits("box", &Polygon::new([[0.1, 0.2], [1.1, 0.2], [1.1, 0.7], [0.1, 0.7]]), 0.5, 0.71);
    assert_eq!(fitted.places.len(), 200);
    for (k, place) in fitted.places.iter().enumerate() {
        let cell = Place::<2>::new(0.125 + 0.05 * (k % 20) as f64, 0.225 + 0.05 * (k / 20) as f64);
        assert!((place - cell).norm() < 1e-12, "{place} and {cell}");
    }
}

#[test]
fn straight_and_round_surfaces_have_points_half_a_spacing_behind_them() {
    let upright = || Polygon::new([[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.0, 0.5]]);
    assert_fits("inclined box", &upright().turned(0.5), 0.5, 0.8);
    assert_fits(
        "a box of no whole cells",
        &Polygon::new([[0.0, 0.0], [1.03, 0.0], [1.03, 0.52], [0.0, 0.52]]),
        0.5356,
        0.8,
    );
    let disc: Fitted<2> = assert_fits("disc", &Shell([0.0, 0.5]), PI * 0.25, 0.75);
    assert_eq!(disc.places.len(), 314);
    let ring: Fitted<2> = assert_fits("ring", &Shell([0.3, 0.7]), PI * 0.4, 0.75);
    assert_eq!(ring.places.len(), (PI * 0.4 / 0.0025).round() as usize);
    let ellipse = Polygon::on_ellipse(0.8, 0.4, (0..180).map(|k| TAU * f64::from(k) / 180.0)).turned(0.4);
    let area = ellipse.area();
    assert_fits("ellipse", &ellipse, area, 0.8);
}

#[test]
fn corners_are_filled_as_well_as_points_can() {
    let angle = Polygon::new([[0.0, 0.0], [1.0, 0.0], [1.0, 0.4], [0.4, 0.4], [0.4, 1.0], [0.0, 1.0]]);
    assert_fits("an L", &angle, 0.64, 0.9);
    assert_fits("an inclined L", &Polygon(angle.0.clone()).turned(0.3), 0.64, 0.9);
    // The tips of 53 and 49 degrees are 1.1 and 1.2 spacings from a point that is half a spacing from both sides.
    assert_fits("triangle", &Polygon::new([[0.0, 0.0], [1.0, 0.0], [0.3, 0.8]]), 0.4, 1.5);
}

#[test]
fn a_ball_is_filled() {
    let ball: Fitted<3> = assert_fits("ball", &Shell([0.0, 0.35]), 4.0 / 3.0 * PI * 0.35_f64.powi(3), 0.95);
    assert_eq!(ball.places.len(), 1437);
}

#[test]
fn the_bits_do_not_depend_on_the_number_of_threads() {
    let ellipse = Polygon::on_ellipse(1.0, 0.7, (0..90).map(|k| TAU * f64::from(k) / 90.0));
    let once = fit(&ellipse, 0.03, &Parallel::serial()).unwrap();
    assert!(once.places.len() > 2000);
    for threads in [2, 3] {
        assert_eq!(fit(&ellipse, 0.03, &Parallel::new(threads).unwrap()).unwrap(), once, "{threads} threads");
    }
}

#[test]
fn shapes_without_room_are_told_with_place_and_remedy() {
    let plate = |thickness: f64| Polygon::new([[0.0, 0.0], [1.0, 0.0], [1.0, thickness], [0.0, thickness]]);
    let refused = |shape: &Polygon, spacing: f64| fit(shape, spacing, &Parallel::serial()).unwrap_err();
    let thin = refused(&plate(0.03), SPACING);
    let words = thin.to_string();
    assert!(matches!(thin, FitError::TooThin { depth, .. } if depth < 0.301), "{words}");
    assert!(
        words.starts_with("the shape is too thin near (")
            && words.ends_with("give a spacing below 5.000e-2 m"),
        "{words}"
    );
    assert!(matches!(
        refused(&Polygon::new([[0.0, 0.0], [0.01, 0.0], [0.0, 0.01]]), SPACING),
        FitError::Empty { .. }
    ));
    for spacing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(refused(&plate(0.5), spacing), FitError::Size { .. }), "{spacing}");
    }
    assert!(matches!(refused(&plate(0.5), 1e-6), FitError::TooMany { .. }));
    // One row is enough.
    assert!(fit(&plate(0.05), SPACING, &Parallel::serial()).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Corners on an ellipse make convex polygons; the least angle here is 39 degrees.
    #[test]
    fn any_convex_polygon_is_filled(
        jitter in proptest::collection::vec(-0.25_f64..0.25, 5..9), b in 0.6_f64..1.0, turn in 0.0_f64..TAU
    ) {
        let n = jitter.len() as f64;
        let angles = jitter.iter().enumerate().map(|(k, off)| TAU * (k as f64 + off) / n);
        let polygon = Polygon::on_ellipse(0.7, 0.7 * b, angles).turned(turn);
        let area = polygon.area();
        assert_fits("polygon", &polygon, area, 1.5);
    }
}
