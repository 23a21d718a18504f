//! Parts of a scene, and when two of them touch.

use super::super::Layout;
use super::super::lattice::Place;
use mps_io::number;
use mps_io::scene_file::{Packing, SceneFile};

/// Points of two parts in contact are half the sum of their spacings apart. Less than this share of it, and one is
/// inside the other: a square lattice leaves no place that is farther from its points than 0.71 of its spacing, a cubic one
/// none farther than 0.87.
pub(super) const fn overlap<const D: usize>() -> f64 {
    if D == 2 { 0.72 } else { 0.88 }
}

/// More than this multiple, and there is a gap; rounding to whole cells makes up to 1.5.
pub(super) const GAP: f64 = 1.55;

/// A part of the scene with its key, points and spacing.
pub(super) struct Part<'a, const D: usize> {
    pub(super) key: String,
    pub(super) places: Vec<Place<D>>,
    pub(super) spacing: f64,
    pub(super) name: &'a str,
    /// Whether its points follow its surface, where those of a lattice have steps.
    pub(super) fitted: bool,
}

impl<'a, const D: usize> Part<'a, D> {
    /// The walls of a scene whose fluid has the spacing `l0` \[m\].
    pub(super) fn walls(scene: &'a SceneFile, layout: &Layout<D>, l0: f64) -> impl Iterator<Item = Self> {
        scene.walls.iter().zip(&layout.walls).enumerate().map(move |(k, (wall, points))| Part {
            key: format!("walls[{k}].shape"),
            places: points.iter().flat_map(|part| part.places.iter().copied()).collect(),
            spacing: wall.fineness * l0,
            name: &wall.name,
            fitted: false,
        })
    }

    /// The fixed bodies of a scene.
    pub(super) fn fixed(scene: &'a SceneFile, layout: &Layout<D>) -> impl Iterator<Item = Self> {
        scene.fixed.iter().zip(&layout.fixed).enumerate().map(|(k, (body, points))| Part {
            key: format!("fixed[{k}].region"),
            places: points.places.clone(),
            spacing: points.spacing,
            name: &body.name,
            fitted: body.packing == Packing::Fitted,
        })
    }
}

impl<const D: usize> Part<'_, D> {
    /// Whether it touches fluid at this place.
    pub(super) fn is_near(&self, place: &Place<D>, l0: f64) -> bool {
        let reach = GAP * 0.5 * (self.spacing + l0);
        self.places.iter().any(|point| apart(point, place) < reach)
    }
}

/// Distance of two places \[m\].
fn apart<const D: usize>(a: &Place<D>, b: &Place<D>) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// A place in words.
pub(super) fn words<const D: usize>(place: &Place<D>) -> String {
    // A place in a scene of a millimetre needs more digits.
    let scale = 0.1 * place.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    format!("({})", place.map(|x| number(x, 4, scale)).join(", "))
}

#[cfg(test)]
mod tests {
    use super::words;

    #[test]
    fn places_of_small_scenes_are_told_apart() {
        assert_eq!(words(&[0.2, 0.0035]), "(0.2000, 0.0035)");
        assert_eq!(words(&[2e-6, -3.5e-7, 0.0]), "(2.0000e-6, -3.5000e-7, 0.0000)");
    }
}
