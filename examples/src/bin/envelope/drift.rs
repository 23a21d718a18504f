//! Bodies of a few particles in a flow that fills its domain.

use crate::border::{Border, Breaks};
use mps_coupling::{ElasticBody, Scene};
use mps_examples::Failure;
use mps_examples::basin::lattice;
use mps_fluid::{
    Boundary, Fluid, FluidConfig, FluidParticles, LaminarViscosity, PressureForm, Shifting, Slip, Tension,
};
use mps_kernel::Vector;
use mps_kernel::weights::{WendlandC2, WendlandGradient};
use mps_neighbors::{Parallel, PeriodicBox};
use mps_solid::body::block;
use mps_solid::materials::{Ambient, NeoHookean};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig};

/// Speed of the stream over that of sound; the spacing, the density and the speed are one.
const MACH: f64 = 0.1;
/// Pressure of the stream over `rho u^2`, as in the channel.
const LEVEL: f64 = 2.0;
/// Particles of water between a body and its image in the next period.
const ROOM: usize = 6;
/// Kinematic viscosity over speed times spacing: the stream takes the body along in the time that it needs to pass it.
const VISCOSITY: f64 = 1.0;
/// How often the stream passes the box.
const PASSAGES: f64 = 2.0;

type Rubber<const D: usize> = ElasticBody<f64, D, Ambient<NeoHookean<f64>, f64>>;

/// A block of `side` particles of rubber a side, as heavy as the water, is let go in a stream through a periodic box: how far its mean speed is off that of all
/// together, over that of the stream, while the stream passes its box a second time. Friction takes it along (without, it would lag for ever, as any body that is let go at once in a
/// perfect fluid); a body that the water does not feel stays behind.
fn left_behind<const D: usize>(side: usize) -> Result<f64, Failure>
where
    NeoHookean<f64>: ConstitutiveModel<f64, D>,
{
    let parallel = Parallel::serial();
    let config = FluidConfig {
        density: 1.0,
        background_pressure: LEVEL,
        tension: Tension::Keep,
        pressure_form: PressureForm::Corrected,
        shifting: Some(Shifting::default()),
        collisions: None,
        ..FluidConfig::<f64, D>::water(1.0, 1.0 / MACH)
    };
    let width = side + ROOM;
    let (near, far) = (0.5 * ROOM as f64, 0.5 * ROOM as f64 + side as f64);
    let outside = |r: &Vector<f64, D>| r.iter().any(|x| !(near..far).contains(x));
    let mut particles =
        FluidParticles::at_rest(lattice([0.0; D], [width; D], 1.0).into_iter().filter(outside).collect());
    let stream = Vector::from_fn(|axis, _| if axis == 0 { 1.0 } else { 0.0 });
    particles.velocity.fill(stream);
    let domain = PeriodicBox::new(Vector::zeros(), [Some(width as f64); D])?;
    let viscosity = |r: &_| LaminarViscosity::new::<D>(VISCOSITY, r);
    let fluid = Fluid::new(config, WendlandGradient, viscosity, domain, particles, Boundary::default())?;
    let mut scene = Scene::new(fluid);
    let body = block(Vector::from([near; D]), Vector::from([far; D]), [side; D], &[])?;
    // Sound in it is about as fast as in the water.
    let material = Ambient { material: NeoHookean::new(75.0, 0.3)?, pressure: LEVEL };
    let config = SolidConfig::<f64>::default();
    let body = Solid::new(body.particles, body.spacing, 1.0, material, WendlandC2, config, &parallel)?;
    scene.add_structure(&parallel, Box::new(ElasticBody::new(body)), Slip::None)?;
    let (end, together) = (PASSAGES * width as f64, 1.0 - (side as f64 / width as f64).powi(D as i32));
    let (mut way, mut time) = (Vector::zeros(), 0.0);
    while scene.fluid().time() < end {
        let dt = scene.step(&parallel, f64::INFINITY)?;
        if scene.fluid().time() > 0.5 * end {
            let body = scene.structure(0).and_then(|body| body.as_any().downcast_ref::<Rubber<D>>());
            let velocities = body.ok_or("the scene has no body")?.solid().velocities();
            way += velocities.iter().sum::<Vector<f64, D>>() * (dt / velocities.len() as f64);
            time += dt;
        }
    }
    Ok((way / time - stream * together).norm())
}

pub(crate) fn borders() -> Vec<Border> {
    let base = Border {
        name: "few-in-stream",
        parameter: "particles along a side of a block of rubber that is let go in a stream with a tenth of the speed of sound",
        measure: "difference of its mean speed from that of all together, over that of the stream",
        bound: 0.02,
        scene: |n| left_behind::<2>(n as usize),
        predicted: None,
        whole: true,
        breaks: Breaks::Refusal,
        mechanism: "a single particle has no neighbour to measure a strain with; two a side are a body and an obstacle",
        remedy: "2 particles across at least; the error says so. A single particle can be a Structure of one's own",
    };
    vec![
        base,
        Border {
            name: "few-in-stream-3d",
            parameter: "the same in space",
            scene: |n| left_behind::<3>(n as usize),
            ..base
        },
    ]
}
