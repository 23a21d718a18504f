//! What single and double precision can hold: distance from the origin, units of length, and slow changes of the density.

use crate::border::{Border, Breaks};
use crate::tank::{Tank, USUAL};

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "far-f32",
        parameter: "distance from the origin in spacings, f32",
        measure: "error of the pressure at rest over rho g H",
        bound: 0.02,
        scene: |x| Tank { shift: x, ..USUAL }.pressure_error::<f32>(),
        predicted: None,
        whole: false,
        breaks: Breaks::Error,
        mechanism: "positions are rounded to this number times 6e-8 spacings: disorder at the start, and steps that are lost later",
        remedy: "put the origin into the middle of the scene; f64 for more than some thousand spacings",
    };
    vec![
        base,
        Border {
            name: "far-f64",
            parameter: "distance from the origin in spacings, f64",
            scene: |x| Tank { shift: x, ..USUAL }.pressure_error::<f64>(),
            mechanism: "as before, times 1.1e-16",
            remedy: "none needed",
            ..base
        },
        Border {
            name: "slow-f32",
            parameter: "sqrt(g H) over the speed of sound, f32",
            bound: 0.03,
            scene: |x| Tank { mach: x, duration: 0.1, ..USUAL }.pressure_error::<f32>(),
            mechanism: "the density is 1 and a part in 1/M^2: its last bit is 6e-8/M^2 of rho g H, and smaller changes are lost",
            remedy: "f64, or a speed of sound of not more than a hundred times the largest speed",
            ..base
        },
        Border {
            name: "small-f32",
            parameter: "spacing in m, f32",
            scene: |x| Tank { spacing: x, duration: 0.5, ..USUAL }.pressure_error::<f32>(),
            breaks: Breaks::Refusal,
            mechanism: "squares of lengths and their inverses leave the range of the numbers",
            remedy: "other units; the error says so",
            ..base
        },
        Border {
            name: "large-f32",
            parameter: "spacing in m, f32",
            scene: |x| Tank { spacing: x, duration: 0.5, ..USUAL }.pressure_error::<f32>(),
            breaks: Breaks::Refusal,
            mechanism: "as before",
            remedy: "other units; the error says so",
            ..base
        },
    ]
}
