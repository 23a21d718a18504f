//! Water with a free surface: sound, gravity, resolution, disorder, shape, patience, and a block thrown at a wall.

use crate::border::{Border, Breaks};
use crate::tank::{CUBE, Tank, USUAL};
use mps_examples::Failure;
use mps_examples::basin::{lattice, walls, water};
use mps_fluid::{ArtificialViscosity, Dpc, Fluid, FluidParticles};
use mps_kernel::Vector;
use mps_kernel::weights::WendlandGradient;
use mps_neighbors::{Open, Parallel};

/// Side of the block and spacings between it and the sides of the closed box it is thrown in.
const BLOCK: usize = 10;
/// That of a cube.
const CUBED: usize = 4;
const ROOM: usize = 4;

/// Particles that have left the box after a block has been thrown at its right wall with this part of the speed of sound.
///
/// # Errors
/// If the fluid cannot go on.
pub(crate) fn thrown<const D: usize>(mach: f64, side: usize) -> Result<f64, Failure> {
    let room = side + ROOM;
    let parallel = Parallel::serial();
    let mut config = water::<f64, D>(1.0, 1.0);
    config.collisions = Some(Dpc::default());
    let mut corner = [0.5 * ROOM as f64; D];
    corner[0] = ROOM as f64 - 1.0;
    let mut particles = FluidParticles::at_rest(lattice(corner, [side; D], 1.0));
    particles.velocity.fill(Vector::from_fn(|axis, _| if axis == 0 { mach } else { 0.0 }));
    let viscosity = |r: &_| ArtificialViscosity::new::<D>(0.02, 1.0, r);
    let boundary = walls([room; D], None, 1.0);
    let mut fluid = Fluid::new(config, WendlandGradient, viscosity, Open, particles, boundary)?;
    // There and back.
    while fluid.time() < 2.0 * room as f64 / mach {
        fluid.step(&parallel)?;
    }
    let out = |r: &&Vector<f64, D>| r.iter().any(|x| !(0.0..=room as f64).contains(x));
    Ok(fluid.particles().position.iter().filter(out).count() as f64)
}

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "mach",
        parameter: "sqrt(g H) over the speed of sound",
        measure: "error of the pressure at rest over rho g H",
        bound: 0.03,
        scene: |x| Tank { mach: x, ..USUAL }.pressure_error::<f64>(),
        predicted: None,
        whole: false,
        breaks: Breaks::Error,
        mechanism: "the sums of the upper rows lack the neighbours above the surface: half a spacing of pressure is uncertain",
        remedy: "ten particles per depth at least",
    };
    vec![
        Border {
            breaks: Breaks::BlowUp,
            mechanism: "water at rest bears sound that is slower than its own fall; in the end the bottom is compressed so far that its particles \
                        meet. What moves asks for more: the pressure of a flow errs with the square of this number",
            remedy: "a speed of sound of ten times the largest speed",
            ..base
        },
        Border {
            name: "spacing",
            parameter: "particles per depth",
            scene: |n| Tank { counts: [n as usize; 2], ..USUAL }.pressure_error::<f64>(),
            whole: true,
            ..base
        },
        Border {
            name: "disorder",
            parameter: "displacement of the particles at the start in spacings",
            scene: |x| Tank { noise: x, ..USUAL }.pressure_error::<f64>(),
            mechanism: "plain sums over disordered neighbours make forces in proportion to the pressure; the water finds an order with another density",
            remedy: "start on a lattice, or let the water settle",
            ..base
        },
        Border {
            name: "gravity",
            parameter: "gravity over 9.81 m/s2, speed of sound in proportion to its root",
            scene: |x| Tank { gravity: 9.81 * x, ..USUAL }.pressure_error::<f64>(),
            breaks: Breaks::Nothing,
            mechanism: "the scene is the same in other units; without gravity the pressure stays zero",
            remedy: "none needed",
            ..base
        },
        Border {
            name: "aspect",
            parameter: "width over depth, 128 particles",
            scene: |x| {
                let rows = (128.0 / x).sqrt().round();
                Tank { counts: [(128.0 / rows).round() as usize, rows as usize], ..USUAL }
                    .pressure_error::<f64>()
            },
            mechanism: "wide: too few particles per depth",
            remedy: "ten particles per depth at least; narrow tanks are no trouble",
            ..base
        },
        Border {
            name: "rest",
            parameter: "time at rest over sqrt(H/g)",
            scene: |x| Tank { counts: [8, 8], duration: x, ..USUAL }.pressure_error::<f64>(),
            breaks: Breaks::Nothing,
            mechanism: "nothing accumulates",
            remedy: "none needed",
            ..base
        },
        Border {
            name: "small-and-large",
            parameter: "spacing in m",
            scene: |x| Tank { spacing: x, ..USUAL }.pressure_error::<f64>(),
            breaks: Breaks::Nothing,
            mechanism: "nothing but the range of the numbers knows the unit of length",
            remedy: "none needed",
            ..base
        },
        Border {
            name: "impact",
            parameter: "speed of a block of water over that of sound",
            measure: "particles beyond the walls",
            bound: 0.0,
            scene: |mach| thrown::<2>(mach, BLOCK),
            breaks: Breaks::Leak,
            mechanism: "the water comes closer to the points of the wall than the guard can stop",
            remedy: "a speed of sound of ten times the largest speed",
            ..base
        },
        Border {
            name: "impact-3d",
            parameter: "speed of a cube of water over that of sound",
            measure: "particles beyond the walls",
            bound: 0.0,
            scene: |mach| thrown::<3>(mach, CUBED),
            breaks: Breaks::Leak,
            mechanism: "as in the plane",
            remedy: "a speed of sound of ten times the largest speed",
            ..base
        },
        Border {
            name: "mach-3d",
            parameter: "sqrt(g H) over the speed of sound, in space",
            bound: 0.1,
            scene: |x| Tank { mach: x, duration: 3.0, ..CUBE }.pressure_error::<f64>(),
            breaks: Breaks::BlowUp,
            mechanism: "as in the plane",
            remedy: "a speed of sound of ten times the largest speed",
            ..base
        },
        Border {
            name: "spacing-3d",
            parameter: "particles per depth, in space",
            scene: |n| Tank { counts: [n as usize; 3], ..CUBE }.pressure_error::<f64>(),
            whole: true,
            mechanism: "as in the plane",
            ..base
        },
        Border {
            name: "disorder-3d",
            parameter: "displacement of the particles at the start in spacings, in space",
            scene: |x| Tank { noise: x, duration: 0.5, ..CUBE }.pressure_error::<f64>(),
            mechanism: "as in the plane",
            remedy: "start on a lattice, or let the water settle",
            ..base
        },
    ]
}
