//! Flows: viscous fluid between two walls however slow or swift, and a few particles thrown at a wall.

use crate::border::{Border, Breaks};
use crate::water::thrown;
use mps_examples::Failure;
use mps_examples::basin::lattice;
use mps_examples::poiseuille::from_rest;
use mps_fluid::{
    Boundary, Fluid, FluidConfig, FluidParticles, LaminarViscosity, Limit, PressureForm, Shifting, Slip,
    Tension,
};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandC2;
use mps_neighbors::{Parallel, PeriodicBox};

/// Particles across the channel, and along its period.
const ACROSS: usize = 10;

/// Error of the profile over its largest speed when a flow from rest between two walls has come to nine tenths of it. Width, largest speed and
/// density are one. Fails if not the limit has acted that is to act.
fn poiseuille(reynolds: f64) -> Result<f64, Failure> {
    let parallel = Parallel::serial();
    let (l0, nu) = (1.0 / ACROSS as f64, 1.0 / reynolds);
    let config = FluidConfig {
        gravity: Vector::from([8.0 * nu, 0.0]),
        tension: Tension::Keep,
        pressure_form: PressureForm::Corrected,
        collisions: None,
        shifting: Some(Shifting::default()),
        ..FluidConfig::water(l0, 10.0)
    };
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [ACROSS; 2], l0));
    let mut boundary = Boundary::default();
    for y in [-3.0 * l0, 1.0] {
        boundary.add_wall(&lattice([0.0, y], [ACROSS, 3], l0), Slip::None);
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(1.0), None])?;
    let viscosity = |r: &_| LaminarViscosity::new::<2>(nu, r);
    let mut fluid = Fluid::new(config, WendlandC2, viscosity, domain, particles, boundary)?;
    while fluid.time() * nu < 0.225 {
        fluid.step(&parallel)?;
    }
    // nu dt/l0^2 is an eighth of the Courant number or c dt/l0 the whole: they meet at Re = 8/(l0 c) = 8.
    let expected = if reynolds < 7.0 { Limit::Viscosity } else { Limit::Sound };
    if fluid.limit() != expected {
        return Err(
            format!("the step is limited by {}, not {}", fluid.limit().name(), expected.name()).into()
        );
    }
    let (particles, now) = (fluid.particles(), fluid.time() * nu);
    let square =
        |(r, u): (&Vector<f64, 2>, &Vector<f64, 2>)| (u.x - from_rest(r.y, now)).powi(2) + u.y.powi(2);
    let sum: f64 = particles.position.iter().zip(&particles.velocity).map(square).sum();
    Ok((sum / particles.position.len() as f64).sqrt())
}

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "reynolds",
        parameter: "Reynolds number of a flow between two walls, 10 particles across",
        measure: "error of the profile over the largest speed",
        bound: 0.02,
        scene: poiseuille,
        predicted: None,
        whole: false,
        breaks: Breaks::Nothing,
        mechanism: "below 8 viscosity limits the step and sound does not: the flow is the same at any; above, corrected sums have no viscosity of their own to speak of",
        remedy: "none needed; below 8 the speed of sound costs nothing",
    };
    vec![
        base,
        Border {
            name: "few",
            parameter: "particles along a side of a block that is thrown at a wall, with a tenth of the speed of sound",
            measure: "particles beyond the walls",
            bound: 0.0,
            scene: |n| thrown::<2>(0.1, n as usize),
            whole: true,
            mechanism: "a wall stops a single particle as well",
            remedy: "none needed",
            ..base
        },
        Border {
            name: "few-3d",
            parameter: "the same in space",
            measure: "particles beyond the walls",
            bound: 0.0,
            scene: |n| thrown::<3>(0.1, n as usize),
            whole: true,
            mechanism: "a wall stops a single particle as well",
            remedy: "none needed",
            ..base
        },
    ]
}
