//! Parameters no simulation can be run with are refused by name.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_fluid::{
    Boundary, Diffusion, Dpc, Fluid, FluidConfig, FluidError, FluidParticles, Shifting, Tension,
};
use mps_kernel::Vector;
use mps_kernel::weights::Rational;
use mps_neighbors::Open;

type Config = FluidConfig<f64, 2>;

fn good() -> Config {
    let mut config = Config::water(0.01, 10.0);
    config.shifting = Some(Shifting::default());
    config
}

fn refused(change: impl FnOnce(&mut Config)) -> String {
    let mut config = good();
    change(&mut config);
    match config.validate() {
        Err(error @ FluidError::Parameter { .. }) => error.to_string(),
        other => format!("not refused: {other:?}"),
    }
}

#[test]
fn the_defaults_are_accepted() {
    good().validate().unwrap();
    FluidConfig::<f32, 3>::water(0.01, 10.0).validate().unwrap();
}

/// Name of a parameter, how it is set, and values out of its range.
type Case = (&'static str, fn(&mut Config, f64), &'static [f64]);

#[test]
fn bad_numbers_are_refused_by_name() {
    let cases: [Case; 14] = [
        ("spacing", |c, x| c.spacing = x, &[0.0, -0.01]),
        ("radius_ratio", |c, x| c.radius_ratio = x, &[0.0, 1.0, 60.0, -3.0]),
        ("density", |c, x| c.density = x, &[0.0, -1000.0]),
        ("sound_speed", |c, x| c.sound_speed = x, &[0.0, -10.0]),
        ("gravity", |c, x| c.gravity[1] = x, &[]),
        ("diffusion", |c, x| c.diffusion = Diffusion::Filter { delta: x }, &[-0.1, 3.0]),
        ("cfl", |c, x| c.cfl = x, &[0.0, -0.5, 10.0]),
        ("density_relaxation", |c, x| c.density_relaxation = x, &[-0.1, 0.01, 0.05]),
        ("background_pressure", |c, x| c.background_pressure = x, &[-1.0, -1e-9]),
        ("wall_viscosity", |c, x| c.wall_viscosity = x, &[-1e-6]),
        ("skin_ratio", |c, x| c.skin_ratio = x, &[-0.1, 10.0]),
        ("repulsion", |c, x| c.collisions = Some(Dpc { repulsion: x, ..Dpc::default() }), &[-0.1, 2.0]),
        ("restitution", |c, x| c.collisions = Some(Dpc { restitution: x, ..Dpc::default() }), &[-0.1, 2.0]),
        ("strength", |c, x| c.shifting = Some(Shifting { strength: x, iterations: 5 }), &[-1.0, 1000.0]),
    ];
    for (name, set, values) in cases {
        for &value in values.iter().chain(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]) {
            let message = refused(|config| set(config, value));
            assert!(message.contains(name), "{name} = {value}: {message}");
        }
    }
}

#[test]
fn a_density_that_follows_the_packing_needs_a_fluid_under_tension() {
    let mut config = good();
    config.density_relaxation = 0.01;
    config.tension = Tension::Keep;
    config.validate().unwrap();
}

#[test]
fn a_ceiling_that_is_no_number_is_refused() {
    for ceiling in [f64::NAN, -1.0, f64::INFINITY] {
        let message = refused(|c| c.collisions = Some(Dpc { ceiling, ..Dpc::default() }));
        assert!(message.contains("ceiling"), "{message}");
    }
}

#[test]
fn shifting_needs_at_least_one_iteration() {
    for iterations in [0, 1000] {
        let message = refused(|c| c.shifting = Some(Shifting { strength: 2.0, iterations }));
        assert!(message.contains("iterations"), "{message}");
    }
}

#[test]
fn the_fluid_itself_refuses_a_bad_parameter_and_fields_of_different_length() {
    let build =
        |config, particles| Fluid::new(config, Rational, |_| (), Open, particles, Boundary::default());
    let particles = FluidParticles::at_rest(vec![Vector::<f64, 2>::zeros(); 3]);
    let bad = Config { cfl: f64::NAN, ..good() };
    assert!(matches!(build(bad, particles.clone()), Err(FluidError::Parameter { name: "cfl", .. })));

    let mut short = particles.clone();
    short.velocity.pop();
    let expected = FluidError::FieldLength { field: "velocity", len: 2, particles: 3 };
    assert_eq!(build(good(), short).unwrap_err().to_string(), expected.to_string());
    let mut long = particles;
    long.id.push(7);
    assert!(matches!(build(good(), long), Err(FluidError::FieldLength { field: "id", len: 4, .. })));
}

#[test]
fn walls_come_before_structures() {
    use mps_fluid::Slip;
    let mut boundary = Boundary::<f64, 2>::default();
    assert!(boundary.is_empty());
    assert_eq!(boundary.add_wall(&[Vector::zeros(); 4], Slip::Free), Some(0..4));
    assert_eq!(boundary.reactive(), 4..4);
    assert_eq!(boundary.add_structure(&[Vector::zeros(); 2], [0.25, 0.5].into_iter(), Slip::None), 4..6);
    assert_eq!(boundary.add_structure(&[Vector::zeros()], [1.0].into_iter(), Slip::Free), 6..7);
    assert_eq!(boundary.add_wall(&[Vector::zeros()], Slip::Free), None);
    assert_eq!((boundary.len(), boundary.reactive()), (7, 4..7));
    assert_eq!(boundary.volume, [1.0, 1.0, 1.0, 1.0, 0.25, 0.5, 1.0]);
    use mps_fluid::Shear::{Free, Wall};
    assert_eq!(boundary.shear, [Free, Free, Free, Free, Wall, Wall, Free]);
    assert_eq!(boundary.force.len(), 7);
}
