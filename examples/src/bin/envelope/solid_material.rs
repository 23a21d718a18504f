//! Which bodies the solid can bend: Poisson's ratio, particles across, and the shape of the particles.

use crate::bending::Beam;
use crate::border::{Border, Breaks};

/// Rubber of the elastic gate.
const RUBBER: f64 = 0.4;
/// The square particle.
const SQUARE: f64 = 1.0;

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "poisson-even",
        parameter: "1/2 - nu, 4 particles across",
        measure: "error of the deflection",
        bound: 0.05,
        scene: |x| Ok(Beam { across: 4, poisson: 0.5 - x, aspect: SQUARE }.error()?.abs()),
        predicted: None,
        whole: false,
        breaks: Breaks::Locking,
        mechanism: "a particle has one volume change for all its surroundings: with an even number across, bending has to change the volume of \
                    the outer rows, which an incompressible material does not allow",
        remedy: "an odd number of particles across",
    };
    vec![
        base,
        Border {
            name: "poisson-odd",
            parameter: "1/2 - nu, 5 particles across",
            scene: |x| Ok(Beam { across: 5, poisson: 0.5 - x, aspect: SQUARE }.error()?.abs()),
            breaks: Breaks::Nothing,
            mechanism: "the middle row takes part in no change of volume",
            remedy: "none needed",
            ..base
        },
        Border {
            name: "thickness-hooke",
            parameter: "particles across, nu = 0",
            scene: |n| Ok(Beam { across: n as usize, poisson: 0.0, aspect: SQUARE }.error()?.abs()),
            whole: true,
            breaks: Breaks::Refusal,
            mechanism: "one particle across has no neighbour to measure a bending strain with",
            remedy: "2 particles across at least; the error says so",
            ..base
        },
        Border {
            name: "thickness-rubber",
            parameter: "particles across, nu = 0.4",
            scene: |n| Ok(Beam { across: n as usize, poisson: RUBBER, aspect: SQUARE }.error()?.abs()),
            whole: true,
            mechanism: "two rows across cannot contract and expand by themselves: they are too stiff by 1/(1 - nu)^2 and more",
            remedy: "3 particles across at least",
            ..base
        },
        Border {
            name: "long-particles",
            parameter: "length over height of a particle, nu = 0.4, 5 across",
            scene: |x| Ok(Beam { across: 5, poisson: RUBBER, aspect: x }.error()?.abs()),
            breaks: Breaks::Error,
            mechanism: "the radius follows the longer side, and the sums reach over more rows across",
            remedy: "particles that are nearly square",
            ..base
        },
    ]
}
