//! What pictures show of a scene in three dimensions: the particles near a plane across z.

use mps_kernel::{Real, Vector};

/// How far from the plane particles are shown, in spacings: between two layers of a lattice both are.
const NEAR: f64 = 0.6;

/// A plane across z; in two dimensions everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slice {
    /// Where it is \[m\].
    pub(super) z: f64,
}

impl Slice {
    /// Numbers of the positions that are shown, of particles this far apart \[m\].
    pub(super) fn of<T: Real, const D: usize>(self, positions: &[Vector<T, D>], spacing: f64) -> Vec<usize> {
        let is_near = |z: &T| (z.to_double() - self.z).abs() <= NEAR * spacing;
        let shown = |k: &usize| positions[*k].get(2).is_none_or(is_near);
        (0..positions.len()).filter(shown).collect()
    }
}

/// The values with these numbers.
pub(super) fn pick<V: Copy>(values: &[V], numbers: &[usize]) -> Vec<V> {
    numbers.iter().filter_map(|k| values.get(*k).copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slice_between_two_layers_shows_both_and_in_two_dimensions_everything() {
        let layers: Vec<Vector<f64, 3>> =
            (0..6).map(|k| Vector::from([0.0, 0.0, 0.1 * f64::from(k)])).collect();
        assert_eq!(Slice { z: 0.25 }.of(&layers, 0.1), [2, 3]);
        assert_eq!(Slice { z: 0.2 }.of(&layers, 0.1), [2]);
        assert_eq!(pick(&[7, 8, 9], &[2, 0]), [9, 7]);
        assert_eq!(Slice { z: 9.0 }.of(&[Vector::<f64, 2>::zeros(); 2], 0.1), [0, 1]);
    }
}
