//! Flow through open boundaries: how fast it may be against sound.

use crate::border::{Border, Breaks};
use mps_examples::basin::lattice;
use mps_examples::{Failure, Noise};
use mps_fluid::{
    Boundary, Fluid, FluidConfig, FluidParticles, Inlet, Opening, Outlet, PressureForm, Shifting, Tension,
};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Parallel, PeriodicBox};

/// Particles along the channel and across it.
const COUNTS: [usize; 2] = [15, 8];
/// How often the channel is filled anew.
const PASSAGES: f64 = 4.0;
/// Largest disorder of places, in spacings, and of velocities, over that of the plug.
const DISORDER: f64 = 0.1;
/// Pressure of the channel over `rho u^2`.
const LEVEL: f64 = 2.0;

/// A plug that is disturbed at the start and passes from an inlet to an outlet, with the number of Mach `mach`: what is left of the disturbance of its
/// velocities (root mean square) when its fluid has long gone, over what it was. Nothing holds the plug up, its sides are periodic.
/// Spacing, density and speed of the plug are one.
fn plug(mach: f64, change: impl Fn(&mut FluidConfig<f64, 2>)) -> Result<f64, Failure> {
    let parallel = Parallel::serial();
    let mut config = FluidConfig {
        density: 1.0,
        background_pressure: LEVEL,
        tension: Tension::Keep,
        collisions: None,
        ..FluidConfig::water(1.0, 1.0 / mach)
    };
    change(&mut config);
    let [length, width] = COUNTS.map(|count| count as f64);
    let opening = |at| Opening {
        axis: 0,
        at,
        forward: true,
        lower: Vector::zeros(),
        upper: Vector::from([0.0, width]),
    };
    let mut noise = Noise::default();
    let mut disturbed = |v: Vector<f64, 2>| v + noise.vector() * DISORDER;
    let mut particles =
        FluidParticles::at_rest(lattice([0.0; 2], COUNTS, 1.0).into_iter().map(&mut disturbed).collect());
    particles.velocity.fill_with(|| disturbed(Vector::from([1.0, 0.0])));
    let before = disturbance(&particles);
    let domain = PeriodicBox::new(Vector::zeros(), [None, Some(width)])?;
    let mut fluid = Fluid::new(config, WendlandGradient, |_: &_| (), domain, particles, Boundary::default())?;
    fluid.add_inlet(Inlet::new(opening(0.0), |_, _| 1.0))?;
    fluid.add_outlet(Outlet { pressure: LEVEL, ..Outlet::absorbing(opening(length)) })?;
    while fluid.time() < PASSAGES * length {
        fluid.step(&parallel)?;
    }
    Ok(disturbance(fluid.particles()) / before)
}

/// Root mean square of what velocities are off that of the plug.
fn disturbance(particles: &FluidParticles<f64, 2>) -> f64 {
    let off = |u: &Vector<f64, 2>| (u - Vector::from([1.0, 0.0])).norm_squared();
    (particles.velocity.iter().map(off).sum::<f64>() / particles.velocity.len() as f64).sqrt()
}

pub(crate) fn borders() -> Vec<Border> {
    let plain = Border {
        name: "through-flow",
        parameter: "speed of a plug that passes from an inlet to an outlet, over that of sound",
        measure: "what is left of a disturbance after four passages",
        bound: 0.2,
        scene: |mach| plug(mach, |_| {}),
        predicted: Some(|| Ok(1.0)),
        whole: false,
        breaks: Breaks::Error,
        mechanism: "presumably sound, which goes upstream with c - u and stands still at 1: what the outlet answers to a disturbance stays before it",
        remedy: "a speed of sound of ten times the largest speed",
    };
    vec![
        plain,
        Border {
            name: "through-flow-channel",
            parameter: "the same with corrected sums and shifting, as in the channel",
            scene: |mach| {
                plug(mach, |config| {
                    config.pressure_form = PressureForm::Corrected;
                    config.shifting = Some(Shifting::default());
                })
            },
            predicted: None,
            breaks: Breaks::Nothing,
            mechanism: "presumably corrected sums make no noise that sound would have to carry away",
            remedy: "none needed",
            ..plain
        },
    ]
}
