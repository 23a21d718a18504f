//! Bodies that are too light, too stiff or too soft for the water on them.

use crate::border::{Border, Breaks};
use core::f64::consts::PI;
use mps_coupling::{ElasticBody, Scene};
use mps_examples::basin::{lattice, press};
use mps_examples::{Failure, Piston};
use mps_fluid::{Boundary, Fluid, FluidConfig, FluidParticles, Slip, Tension};
use mps_kernel::Vector;
use mps_kernel::weights::{Rational, WendlandC2};
use mps_neighbors::{Parallel, PeriodicBox};
use mps_solid::body::{Face, block};
use mps_solid::materials::SaintVenantKirchhoff;
use mps_solid::{Solid, SolidConfig};

/// Spacing \[m\], speed of sound \[m/s\], Courant number, and density of the water \[kg/m^3\].
const L0: f64 = 0.01;
const SOUND: f64 = 10.0;
const CFL: f64 = 0.5;
const RHO: f64 = 1000.0;
/// Columns of the water between the ends of the period; rows of particles of a body.
const COLUMNS: usize = 10;
const THICK: usize = 4;
const WIDTH: f64 = COLUMNS as f64 * L0;

type Column = Scene<f64, 2, Rational, (), PeriodicBox<f64, 2>>;

/// A column of water, endless sideways, `rows` high, on a floor or on nothing yet.
fn column(config: FluidConfig<f64, 2>, rows: usize, floor: bool) -> Result<Column, Failure> {
    let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [COLUMNS, rows], L0));
    let weight = -config.density * config.gravity.y;
    press(&mut particles, &config, |r| weight * (rows as f64 * L0 - r.y));
    let mut boundary = Boundary::default();
    if floor {
        boundary.add_wall(&lattice([0.0, -3.0 * L0], [COLUMNS, 3], L0), Slip::Free);
    }
    let domain = PeriodicBox::new(Vector::zeros(), [Some(WIDTH), None])?;
    Ok(Scene::new(Fluid::new(config, Rational, |_| (), domain, particles, boundary)?))
}

/// The column of `mps-coupling/tests/piston.rs`: a piston of so many layers of water particles closes it and gets a push.
fn under_piston(layers: f64, tells_mass: bool) -> Result<Column, Failure> {
    const ROWS: usize = 20;
    let mut config = FluidConfig::water(L0, SOUND);
    config.tension = Tension::Keep;
    config.cfl = CFL;
    let mut scene = column(config, ROWS, true)?;
    let places = lattice([0.0, ROWS as f64 * L0], [COLUMNS, THICK], L0);
    let mut piston = Piston::new(places, L0, layers * RHO * L0 * WIDTH);
    (piston.v, piston.tells_mass) = (1e-3, tells_mass);
    scene.add_structure(&Parallel::serial(), Box::new(piston), Slip::Free)?;
    Ok(scene)
}

/// Largest total energy over that at the start, in a hundred steps.
fn pushed(layers: f64, tells_mass: bool) -> Result<f64, Failure> {
    let parallel = Parallel::serial();
    let mut scene = under_piston(layers, tells_mass)?;
    let total = |scene: &Column| {
        let (fluid, piston) = scene.energy(&parallel);
        fluid.total() + piston.total()
    };
    let (start, mut largest) = (total(&scene), 1.0_f64);
    for _ in 0..100 {
        scene.step(&parallel, f64::INFINITY)?;
        largest = largest.max(total(&scene) / start);
    }
    Ok(largest)
}

/// Layers at which the step of the water is so many times the border of the interface.
fn layers_at(times: f64) -> Result<f64, Failure> {
    let mut scene = under_piston(1.0, true)?;
    let dt = scene.step(&Parallel::serial(), f64::INFINITY)?;
    let border = scene.interface_border(0).ok_or("the scene has no piston")?;
    Ok((dt / border / times).powi(2))
}

/// Rows of water on the bed.
const DEPTH: usize = 10;
const GRAVITY: f64 = 9.81;

type Bed = Solid<f64, 2, SaintVenantKirchhoff<f64>>;

/// A bed of rubber under water, held at its underside and on rollers sideways: it can only be pressed flat. Its modulus of
/// uniaxial strain `lambda + 2 mu` is so many times the pressure of the water on it.
fn bed(stiffness: f64) -> Result<Column, Failure> {
    let depth = DEPTH as f64 * L0;
    let mut config = FluidConfig::<f64, 2>::water(L0, 10.0 * (GRAVITY * depth).sqrt());
    config.gravity.y = -GRAVITY;
    let mut scene = column(config, DEPTH, false)?;
    let sides = [Face::lower(0), Face::upper(0)];
    let held = [sides[0], sides[1], Face::lower(1)];
    let lower = Vector::from([0.0, -(THICK as f64) * L0]);
    let mut body = block(lower, Vector::from([WIDTH, 0.0]), [COLUMNS + 1, THICK], &held)?;
    sides.into_iter().try_for_each(|side| body.slide(side))?;
    // For nu = 1/4 the modulus is 6/5 of Young's.
    let material = SaintVenantKirchhoff::new(stiffness * RHO * GRAVITY * depth / 1.2, 0.25)?;
    let (config, parallel) = (SolidConfig::default(), Parallel::serial());
    let bed = Solid::new(body.particles, body.spacing, RHO, material, WendlandC2, config, &parallel)?;
    scene.add_structure(&parallel, Box::new(ElasticBody::new(bed)), Slip::Free)?;
    Ok(scene)
}

fn rubber(scene: &Column) -> Result<&Bed, Failure> {
    let body = scene.structure(0).and_then(|body| body.as_any().downcast_ref::<ElasticBody<f64, 2, _>>());
    Ok(body.ok_or("the scene has no bed")?.solid())
}

/// Largest part of its thickness by which the bed is pressed flat in so many steps.
fn flattened(stiffness: f64, steps: usize) -> Result<f64, Failure> {
    let parallel = Parallel::serial();
    let mut scene = bed(stiffness)?;
    let mut most = 0.0_f64;
    for _ in 0..steps {
        scene.step(&parallel, f64::INFINITY)?;
        let lowered = |solid: &Bed| {
            let pairs = solid.positions().iter().zip(solid.particles().reference_positions());
            pairs.fold(0.0_f64, |most, (now, before)| most.max(before.y - now.y))
        };
        most = most.max(lowered(rubber(&scene)?) / (THICK as f64 * L0));
    }
    Ok(most)
}

/// Stiffness at which a step takes as many sub-steps as a scene allows.
fn stiffest() -> Result<f64, Failure> {
    const TRIED: f64 = 1e3;
    let parallel = Parallel::serial();
    let mut scene = bed(TRIED)?;
    let dt = scene.step(&parallel, f64::INFINITY)?;
    let substeps = dt / rubber(&scene)?.max_step(&parallel);
    Ok(TRIED * (scene.max_substeps as f64 / substeps).powi(2))
}

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "light-body",
        parameter: "mass of a body in layers of water particles, which it does not tell",
        measure: "largest energy over that at the start",
        bound: 1e4,
        scene: |x| pushed(x, false),
        predicted: Some(|| layers_at(1.0)),
        whole: false,
        breaks: Breaks::BlowUp,
        mechanism: "the compressed water at the surface is a spring that the body's own limit does not know of",
        remedy: "implement Structure::inertia: the scene then takes the sub-steps it needs; or Scene::min_substeps",
    };
    vec![
        base,
        Border {
            name: "light-body-told",
            parameter: "the same of a body that tells its mass",
            bound: 5.0,
            scene: |x| pushed(x, true),
            predicted: Some(|| layers_at(0.5 * PI)),
            mechanism: "the velocity of the water is held over its step, and the body turns by more than half a turn on that spring meanwhile: it grows slowly, a hundredfold in a hundred steps",
            remedy: "a smaller cfl: the border goes with its square",
            ..base
        },
        Border {
            name: "density-ratio",
            parameter: "density of a body, four particles thick, over that of water",
            scene: |x| pushed(x * THICK as f64, true),
            predicted: None,
            breaks: Breaks::Nothing,
            mechanism: "there is no border in the density of a body that is as thick as it has to be for its interface",
            remedy: "none needed",
            ..base
        },
        Border {
            name: "soft-body",
            parameter: "modulus lambda + 2 mu of a bed over the pressure of the water on it",
            measure: "part of its thickness by which it is pressed flat",
            bound: 0.75,
            scene: |x| flattened(x, 400),
            predicted: Some(|| Ok(6.75 * (1.0 + 0.5 * THICK as f64 / DEPTH as f64))),
            breaks: Breaks::Refusal,
            mechanism: "the law of Saint Venant and Kirchhoff gives way: a load p that is let go at once is carried by M/8 (1 - l)(1 + l)^2, \
                        at most 0.148 M at the stretch l = 1/3. Half the bed's own weight counts as well",
            remedy: "NeoHookean or NearlyIncompressible, which do not; the error says so",
            ..base
        },
        Border {
            name: "stiff-body",
            parameter: "modulus lambda + 2 mu of a bed over the pressure of the water on it",
            measure: "part of its thickness by which it is pressed flat",
            bound: 0.75,
            scene: |x| flattened(x, 3),
            predicted: Some(stiffest),
            breaks: Breaks::Refusal,
            mechanism: "the sub-steps in a step go with the root of the modulus, and reach Scene::max_substeps",
            remedy: "raise max_substeps and accept the cost, or fewer particles across; the error says so",
            ..base
        },
    ]
}
