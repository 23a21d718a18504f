//! Particles that are too close to another, and particles that are alone.

use crate::border::{Border, Breaks};
use crate::tank::{Tank, USUAL};
use mps_examples::Failure;
use mps_kernel::Vector;

/// One more particle in the middle of the tank at this distance, in spacings, from another one: largest speed over that of sound.
fn pair(distance: f64) -> Result<f64, Failure> {
    let l0 = USUAL.spacing;
    let mut fluid = USUAL.build::<f64>(|points| {
        let middle = points[points.len() / 2 + USUAL.counts[0] / 2];
        points.push(middle + Vector::from([0.8, 0.6]) * (distance * l0));
    })?;
    let mut fastest = 0.0_f64;
    USUAL.advance(&mut fluid, 1.0, |fluid| {
        fastest = fluid.particles().velocity.iter().fold(fastest, |most, u| most.max(u.norm()));
    })?;
    Ok(fastest / USUAL.sound())
}

/// A particle at this height, in depths, above the surface: how far it is from where it would be in free fall just before it meets the
/// water again, in spacings.
fn alone(height: f64) -> Result<f64, Failure> {
    let Tank { spacing: l0, gravity, .. } = USUAL;
    let start = USUAL.depth() * (1.0 + height);
    let mut fluid = USUAL.build::<f64>(|points| points.push(Vector::from([0.5 * USUAL.depth(), start])))?;
    let id = fluid.particles().id.iter().max().copied().ok_or("the tank is empty")?;
    let (mut off, reach) = (0.0_f64, 5.0 * l0);
    USUAL.advance(&mut fluid, 0.9 * (2.0 * height).sqrt(), |fluid| {
        let (particles, time) = (fluid.particles(), fluid.time());
        let exact = start - 0.5 * gravity * time * time;
        if exact > USUAL.depth() + reach
            && let Some(i) = particles.id.iter().position(|other| *other == id)
        {
            off = off.max((particles.position[i].y - exact).abs() / l0);
        }
    })?;
    Ok(off)
}

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "clustered",
        parameter: "distance of a particle too many from another in spacings",
        measure: "largest speed over that of sound",
        bound: 1.0,
        scene: pair,
        predicted: None,
        whole: false,
        breaks: Breaks::Nothing,
        mechanism: "weights are bounded at a tenth of a spacing, and two particles in one place push each other in no direction",
        remedy: "none needed",
    };
    vec![
        base,
        Border {
            name: "isolated",
            parameter: "height of a single particle above the water in depths",
            measure: "distance from free fall in spacings",
            bound: 0.1,
            scene: alone,
            mechanism: "without neighbours there is nothing but gravity",
            ..base
        },
    ]
}
