//! The simple surfaces that a region is bounded by.

use super::super::region::{Corners, Disc, HalfSpace, Point, Region, Tube};
use super::piece::Piece;
use super::{Place, place};

/// The surfaces of all simple shapes of a region, each with the number of its shape.
pub(super) fn pieces(region: &Region) -> Vec<(usize, Piece)> {
    let mut shapes = Vec::new();
    simple(region, &mut shapes);
    shapes
        .iter()
        .enumerate()
        .flat_map(|(shape, region)| of(region).into_iter().map(move |piece| (shape, piece)))
        .collect()
}

/// The simple shapes that a region is made of.
fn simple<'a>(region: &'a Region, shapes: &mut Vec<&'a Region>) {
    match region {
        Region::Union(parts) | Region::Difference(parts) => {
            parts.iter().for_each(|part| simple(part, shapes))
        }
        _ => shapes.push(region),
    }
}

/// The surface of a simple shape.
fn of(region: &Region) -> Vec<Piece> {
    match region {
        Region::Box(corners) => faces(corners),
        Region::Circle(Disc { center, radius }) | Region::Ball(Disc { center, radius }) => {
            vec![Piece::Round { center: place(center), radius: *radius }]
        }
        Region::Cylinder(Tube { from, to, radius }) => {
            let ends = [from, to].map(|end| place(end));
            let along = (ends[1] - ends[0]).normalize();
            let radius = *radius;
            let end = |middle| Piece::End { middle, along, radius };
            vec![Piece::Mantle { ends, radius }, end(ends[0]), end(ends[1])]
        }
        Region::HalfSpace(HalfSpace { through, toward }) => {
            vec![Piece::Plane { through: place(through), across: place(toward).normalize() }]
        }
        Region::Polygon(corners) => sides(corners),
        Region::Outline(outline) => {
            let triangles = outline.triangles().iter().copied().map(Piece::Triangle);
            sides(outline.corners()).into_iter().chain(triangles).collect()
        }
        // Taken apart before.
        Region::Union(_) | Region::Difference(_) => Vec::new(),
    }
}

/// The sides of a box.
fn faces(Corners { lower, upper }: &Corners) -> Vec<Piece> {
    let (low, high): (Place, Place) = (place(lower), place(upper));
    let face = |axis: usize, end: f64| {
        let (mut lower, mut upper) = (low, high);
        (lower[axis], upper[axis]) = (end, end);
        Piece::Face { lower, upper }
    };
    (0..lower.len().min(3)).flat_map(|axis| [face(axis, low[axis]), face(axis, high[axis])]).collect()
}

/// The sides of a polygon.
fn sides(corners: &[Point]) -> Vec<Piece> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| Piece::Side([place(a), place(b)])).collect()
}
