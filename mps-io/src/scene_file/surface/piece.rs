//! Simple surfaces, and their points that are nearest to a place. In two dimensions the third coordinate is zero.

use super::super::outline::Triangle;
use super::Place;

/// A part of the surface of a simple shape \[m\].
#[derive(Clone, Debug)]
pub(super) enum Piece {
    /// A straight side.
    Side([Place; 2]),
    /// The side of a box across an axis.
    Face { lower: Place, upper: Place },
    /// A circle or a sphere.
    Round { center: Place, radius: f64 },
    /// The round part of a cylinder.
    Mantle { ends: [Place; 2], radius: f64 },
    /// A flat end of a cylinder, by its middle and a vector of length one along the cylinder.
    End { middle: Place, along: Place, radius: f64 },
    /// A plane, by a point and a vector of length one across.
    Plane { through: Place, across: Place },
    /// A part of a surface from a file.
    Triangle(Triangle),
}

impl Piece {
    /// Its point nearest to a place.
    pub(super) fn foot(&self, r: &Place) -> Place {
        match self {
            Self::Side(ends) => on_line(ends, r),
            Self::Face { lower, upper } => r.sup(lower).inf(upper),
            Self::Round { center, radius } => center + unit(&(r - center), &Place::x()) * *radius,
            Self::Mantle { ends, radius } => {
                let middle = on_line(ends, r);
                let along = unit(&(ends[1] - ends[0]), &Place::x());
                let off = r - ends[0];
                middle + unit(&(off - along * along.dot(&off)), &across(&along)) * *radius
            }
            Self::End { middle, along, radius } => {
                let off = r - middle;
                let flat = off - along * along.dot(&off);
                let length = flat.norm();
                middle + if length > *radius { flat * (radius / length) } else { flat }
            }
            Self::Plane { through, across } => r - across * across.dot(&(r - through)),
            Self::Triangle(triangle) => triangle.foot(r),
        }
    }
}

/// The point of a line between two ends that is nearest to a place.
fn on_line([a, b]: &[Place; 2], r: &Place) -> Place {
    let along = b - a;
    let share = (r - a).dot(&along) / along.norm_squared();
    a + along * if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
}

/// A vector of length one along `v`, or the other one if `v` has no length.
fn unit(v: &Place, other: &Place) -> Place {
    v.try_normalize(0.0).unwrap_or(*other)
}

/// Some vector of length one across another one.
fn across(along: &Place) -> Place {
    let least = Place::ith(along.iamin(), 1.0);
    unit(&along.cross(&least), &Place::y())
}
