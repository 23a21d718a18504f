//! The map: where every border is. The two sides are re-run by `--quick` and its test.

use crate::border::Known;
use crate::border::Known::{Between, Holds, Lasts};

/// Borders with a value at which the scene is fine and one at which it is broken, or values at which it is fine.
const MAP: &[(&str, Known)] = &[
    ("courant-rational", Between(2.47, 2.51)),
    ("courant-smooth", Between(3.505, 3.56)),
    ("courant-corrected", Between(2.65, 2.69)),
    ("courant-3d", Between(2.535, 2.575)),
    ("courant-diffused", Between(1.014, 1.03)),
    ("courant-diffused-smooth", Between(2.33, 2.37)),
    ("diffusion", Between(0.507, 0.515)),
    ("courant-asked", Holds(&[1.0, 2.0])),
    ("viscous-laminar", Between(0.938, 0.953)),
    ("viscous-compact", Between(0.683, 0.694)),
    ("viscous-wendland", Between(0.6325, 0.6427)),
    ("viscous-artificial", Between(0.4622, 0.4696)),
    ("solid-courant", Between(0.985, 1.01)),
    ("solid-courant-rubber", Between(0.985, 1.01)),
    ("solid-courant-3d", Between(0.985, 1.01)),
    ("poisson-even", Between(0.04, 0.035)),
    ("poisson-odd", Holds(&[0.1, 0.001, 0.0001])),
    ("thickness-hooke", Between(2.0, 1.0)),
    ("thickness-rubber", Between(3.0, 2.0)),
    ("long-particles", Between(1.4, 1.5)),
    ("contact-speed", Between(0.5, 0.7)),
    ("contact-speed-3d", Between(0.5, 0.7)),
    ("contact-corner", Between(0.55, 0.7)),
    ("contact-stiffness", Holds(&[1.0, 1e4])),
    ("contact-spacing", Holds(&[1.0, 8.0])),
    ("contact-thin", Between(2.0, 1.0)),
    ("light-body", Between(0.052, 0.049)),
    ("light-body-told", Between(0.03, 0.024)),
    ("density-ratio", Holds(&[0.05, 1.0, 50.0])),
    ("soft-body", Between(9.0, 8.5)),
    ("stiff-body", Between(1.1e9, 1.6e9)),
    ("few-in-stream", Between(2.0, 1.0)),
    ("few-in-stream-3d", Between(2.0, 1.0)),
    ("mach", Between(1.7, 3.0)),
    ("spacing", Between(7.0, 6.0)),
    ("disorder", Between(0.1, 0.15)),
    ("gravity", Holds(&[0.0, 100.0])),
    ("aspect", Between(2.0, 4.0)),
    // 3,200 and 100,800 steps.
    ("rest", Lasts(&[20.0], &[630.0])),
    ("small-and-large", Holds(&[1e-9, 1e9])),
    ("impact", Between(0.6, 0.7)),
    ("impact-3d", Between(0.5, 0.7)),
    ("mach-3d", Between(2.0, 3.0)),
    ("spacing-3d", Between(7.0, 6.0)),
    ("disorder-3d", Between(0.1, 0.15)),
    // 4,500 and 45,000 steps; 450 at 10.
    ("reynolds", Lasts(&[10.0, 1.0, 0.1, 0.01], &[100.0, 1000.0])),
    ("through-flow", Between(0.7, 1.2)),
    ("through-flow-channel", Holds(&[0.1, 2.0])),
    ("few", Holds(&[1.0, 2.0, 3.0])),
    ("few-3d", Holds(&[1.0, 2.0, 3.0])),
    ("clustered", Holds(&[0.1, 0.0])),
    ("isolated", Holds(&[1.0])),
    ("far-f32", Between(5e3, 1e4)),
    ("far-f64", Between(3e12, 1e13)),
    ("slow-f32", Between(0.003, 0.001)),
    ("small-f32", Between(1e-19, 1e-23)),
    ("large-f32", Between(1e18, 1e20)),
];

/// Where the border is.
pub(crate) fn known(name: &str) -> Option<Known> {
    MAP.iter().find(|(other, _)| *other == name).map(|(_, known)| *known)
}

/// A border of the map that none of these scenes is of.
pub(crate) fn without_scene(scenes: &[&str]) -> Option<&'static str> {
    MAP.iter().map(|(name, _)| *name).find(|name| !scenes.contains(name))
}
