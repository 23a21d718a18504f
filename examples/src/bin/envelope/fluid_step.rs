//! How long a step of the fluid may be: noise in a periodic box, with steps of the scene's own choice.

use crate::border::{Border, Breaks};
use crate::waves::{Step, border, waves};
use mps_examples::basin::lattice;
use mps_examples::{Failure, Noise};
use mps_fluid::{Boundary, Diffusion, Fluid, FluidConfig, FluidParticles, PressureForm, Tension, Viscosity};
use mps_kernel::weights::{Rational, WendlandGradient};
use mps_kernel::{Kernel, ReferenceDensity, Vector};
use mps_neighbors::{Parallel, PeriodicBox};

/// Particles along a side of the box: in the plane, and in space.
const SIDE: usize = 16;
const SIDE_3D: usize = 8;
/// Steps of a trial in the plane and in space. One percent beyond the border a wave of sound grows by 30 % a step, one of diffusion or viscosity by 2 %.
const STEPS: usize = 1000;
const STEPS_3D: usize = 300;
/// Size of the noise, of the velocities over the speed of sound and of the densities: nothing but linear waves.
const NOISE: f64 = 1e-9;

/// Fluid that fills its domain, without diffusion, with the spacing and the speed of sound as units.
pub(crate) fn undamped<const D: usize>(sound_speed: f64, radius: f64) -> FluidConfig<f64, D> {
    let mut config = FluidConfig::water(1.0, sound_speed);
    config.radius_ratio = radius;
    config.tension = Tension::Keep;
    config.diffusion = Diffusion::None;
    config.collisions = None;
    config
}

/// Noise on a lattice, in steps of `dt` or else of the fluid's own choice: its largest size ever over the one at the start.
pub(crate) fn growth<const D: usize, K: Kernel<f64>, V: Viscosity<f64, D>>(
    config: FluidConfig<f64, D>,
    kernel: K,
    viscosity: impl FnOnce(&ReferenceDensity<f64>) -> V,
    dt: impl Into<Option<f64>>,
) -> Result<f64, Failure> {
    let dt = dt.into();
    let (side, steps) = if D == 2 { (SIDE, STEPS) } else { (SIDE_3D, STEPS_3D) };
    let sound = config.sound_speed;
    let mut noise = Noise::default();
    let mut particles = FluidParticles::at_rest(lattice([0.0; D], [side; D], 1.0));
    for (u, n) in particles.velocity.iter_mut().zip(&mut particles.density) {
        *u = noise.vector() * (NOISE * sound);
        // The diffusion acts on waves that no velocity can make.
        *n += NOISE * noise.number();
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(side as f64); D])?;
    let mut fluid = Fluid::new(config, kernel, viscosity, domain, particles, Boundary::default())?;
    let (parallel, mut largest) = (Parallel::serial(), 1.0_f64);
    let start = size(fluid.particles(), sound);
    for _ in 0..steps {
        let longest = fluid.begin_step(&parallel)?;
        fluid.finish_step(&parallel, dt.unwrap_or(longest));
        largest = largest.max(size(fluid.particles(), sound) / start);
    }
    Ok(largest)
}

/// Largest speed over that of sound, or difference of a density from 1.
fn size<const D: usize>(particles: &FluidParticles<f64, D>, sound: f64) -> f64 {
    let both = particles.velocity.iter().zip(&particles.density);
    both.fold(0.0, |most: f64, (u, n)| most.max(u.norm() / sound).max((n - 1.0).abs()))
}

/// A step by its Courant number, of a fluid with this diffusion.
fn sound<const D: usize, K: Kernel<f64>>(
    kernel: K,
    radius: f64,
    form: PressureForm,
    step: Step,
) -> Result<f64, Failure> {
    let mut config = undamped::<D>(1.0, radius);
    config.pressure_form = form;
    if step.delta > 0.0 {
        config.diffusion = Diffusion::Filter { delta: step.delta };
    }
    growth(config, kernel, |_| (), step.courant)
}

fn bare(courant: f64) -> Step {
    Step { courant, ..Step::default() }
}

/// With the diffusion every scene has by default.
fn usual(courant: f64) -> Step {
    Step { courant, delta: 0.5 }
}

/// Diffusion alone is turned, at the Courant number 1.
fn diffused(delta: f64) -> Step {
    Step { courant: 1.0, delta }
}

/// The steps of the fluid itself, which is asked for a Courant number.
fn asked(courant: f64) -> Result<f64, Failure> {
    let mut config = undamped::<2>(1.0, 3.0);
    (config.diffusion, config.cfl) = (Diffusion::Filter { delta: 0.5 }, courant);
    growth(config, Rational, |_| (), None)
}

const CAPPED: &str =
    "none needed: the fluid keeps 2 % below this border by itself; the scene does not ask it";
const GROWTH: &str = "noise over that at the start";

pub(crate) fn borders() -> Vec<Border> {
    use PressureForm::{Corrected, Plain};
    let base = Border {
        name: "",
        parameter: "Courant number c dt/l0",
        measure: GROWTH,
        bound: 1e3,
        scene: |x| sound::<2, _>(Rational, 3.0, Plain, bare(x)),
        predicted: None,
        whole: false,
        breaks: Breaks::BlowUp,
        mechanism: "the steepest wave of the lattice turns by more than half a turn in a step, 2/(kappa l0)",
        remedy: "cfl of at most 1; the default is 0.5",
    };
    vec![
        Border {
            name: "courant-rational",
            predicted: Some(|| Ok(border(&waves::<2, _>(&Rational, 3.0, SIDE)?, bare))),
            ..base
        },
        Border {
            name: "courant-smooth",
            scene: |x| sound::<2, _>(WendlandGradient, 4.0, Plain, bare(x)),
            predicted: Some(|| Ok(border(&waves::<2, _>(&WendlandGradient, 4.0, SIDE)?, bare))),
            ..base
        },
        Border {
            name: "courant-corrected",
            scene: |x| sound::<2, _>(WendlandGradient, 3.0, Corrected, bare(x)),
            predicted: Some(|| Ok(border(&waves::<2, _>(&WendlandGradient, 3.0, SIDE)?, bare))),
            ..base
        },
        Border {
            name: "courant-3d",
            scene: |x| sound::<3, _>(Rational, 3.0, Plain, bare(x)),
            predicted: Some(|| Ok(border(&waves::<3, _>(&Rational, 3.0, SIDE_3D)?, bare))),
            ..base
        },
        Border {
            name: "courant-diffused",
            scene: |x| sound::<2, _>(Rational, 3.0, Plain, usual(x)),
            predicted: Some(|| Ok(border(&waves::<2, _>(&Rational, 3.0, SIDE)?, usual))),
            remedy: CAPPED,
            mechanism: "the diffusion of the density, delta 0.5, takes more than twice the difference between neighbours in a step: \
                        c dt/l0 < 2/(delta sigma) for the wave that alternates along both axes",
            ..base
        },
        Border {
            name: "courant-diffused-smooth",
            scene: |x| sound::<2, _>(WendlandGradient, 4.0, Plain, usual(x)),
            predicted: Some(|| Ok(border(&waves::<2, _>(&WendlandGradient, 4.0, SIDE)?, usual))),
            remedy: CAPPED,
            mechanism: "as before, with the weight and radius of free surfaces",
            ..base
        },
        Border {
            name: "diffusion",
            parameter: "delta of the density diffusion",
            scene: |x| sound::<2, _>(Rational, 3.0, Plain, diffused(x)),
            predicted: Some(|| Ok(border(&waves::<2, _>(&Rational, 3.0, SIDE)?, diffused))),
            mechanism: "at the Courant number 1 the default of 0.5 is next to the border; it goes with 1/cfl",
            remedy: CAPPED,
            ..base
        },
        Border {
            name: "courant-asked",
            parameter: "Courant number that is asked for, delta 0.5",
            scene: asked,
            predicted: None,
            breaks: Breaks::Nothing,
            mechanism: "the fluid takes 0.98 of the border of courant-diffused at most, however much is asked for",
            remedy: "none needed",
            ..base
        },
    ]
}
