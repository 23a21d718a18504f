//! The map: where every border is. The two sides are re-run by `--quick` and its test.

use crate::border::Known;
use crate::border::Known::{Between, Holds};

/// Borders with a value at which the scene is fine and one at which it is broken.
const MAP: &[(&str, Known)] = &[
    ("courant-rational", Between(1.0, 3.0)),
    ("courant-smooth", Between(1.0, 3.0)),
    ("courant-corrected", Between(1.0, 3.0)),
    ("courant-3d", Between(1.0, 3.0)),
    ("courant-diffused", Between(0.5, 3.0)),
    ("courant-diffused-smooth", Between(0.5, 3.0)),
    ("diffusion", Between(0.1, 1.9)),
    ("sound-damping", Between(0.1, 1.9)),
    ("viscous-laminar", Between(0.125, 2.0)),
    ("viscous-compact", Between(0.125, 2.0)),
    ("viscous-wendland", Between(0.125, 2.0)),
    ("viscous-artificial", Between(0.125, 2.0)),
    ("solid-courant", Between(0.5, 1.5)),
    ("solid-courant-rubber", Between(0.5, 1.5)),
    ("solid-courant-3d", Between(0.5, 1.5)),
    ("poisson-even", Between(0.2, 0.001)),
    ("poisson-odd", Between(0.1, 0.0001)),
    ("thickness-hooke", Between(8.0, 1.0)),
    ("thickness-rubber", Between(8.0, 2.0)),
    ("long-particles", Between(1.0, 8.0)),
    ("light-body", Between(1.0, 0.01)),
    ("light-body-told", Between(1.0, 0.001)),
    ("density-ratio", Holds(&[0.05, 1.0, 50.0])),
    ("soft-body", Between(100.0, 1.0)),
    ("stiff-body", Between(1e3, 1e9)),
    ("mach", Between(0.1, 0.5)),
    ("spacing", Between(12.0, 2.0)),
    ("disorder", Between(0.01, 0.5)),
    ("gravity", Holds(&[0.0, 0.01, 100.0])),
    ("gravity-alone", Between(1.0, 25.0)),
    ("aspect", Between(1.0, 64.0)),
    ("rest", Holds(&[100.0])),
    ("small-and-large", Holds(&[1e-9, 1e9])),
    ("impact", Between(0.1, 1.0)),
    ("clustered", Holds(&[0.5, 0.1, 1e-3, 0.0])),
    ("isolated", Holds(&[1.0, 4.0])),
    ("far-f32", Between(1.0, 1e7)),
    ("far-f64", Between(1.0, 1e16)),
    ("slow-f32", Between(0.1, 1e-4)),
    ("small-f32", Between(0.1, 1e-30)),
    ("large-f32", Between(0.1, 1e30)),
];

/// Where the border is.
pub(crate) fn known(name: &str) -> Option<Known> {
    MAP.iter().find(|(other, _)| *other == name).map(|(_, known)| *known)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_map_and_the_scenes_are_of_the_same_borders() {
        let scenes: Vec<_> = crate::borders().iter().map(|border| border.name).collect();
        let map: Vec<_> = MAP.iter().map(|(name, _)| *name).collect();
        assert_eq!(scenes, map);
    }
}
