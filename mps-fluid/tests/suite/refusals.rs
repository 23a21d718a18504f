//! What a fluid is made of is checked before anything moves, by the name of the field and the number of the point.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{lattice, tank_walls};
use mps_fluid::{
    ArtificialViscosity, Boundary, Fluid, FluidConfig, FluidError, FluidParticles, LaminarViscosity, Slip,
    Viscosity,
};
use mps_kernel::weights::Rational;
use mps_kernel::{ReferenceDensity, Vector};
use mps_neighbors::{Open, Parallel};

type Water = Fluid<f64, 2, Rational>;

fn walls() -> Boundary<f64, 2> {
    let mut boundary = Boundary::default();
    boundary.add_wall(&tank_walls::<f64, 2>([4, 4], 6, 0.01), Slip::Free).unwrap();
    boundary
}

fn water(boundary: Boundary<f64, 2>) -> Result<Water, FluidError> {
    let particles = FluidParticles::at_rest(lattice([0.0; 2], [4, 4], 0.01));
    Fluid::new(FluidConfig::water(0.01, 10.0), Rational, |_| (), Open, particles, boundary)
}

#[test]
fn a_boundary_with_fields_of_different_length_is_refused() {
    type Spoil = fn(&mut Boundary<f64, 2>);
    let cases: [(&str, Spoil); 6] = [
        ("volume", |b| {
            b.add_structure(&[Vector::zeros(); 3], [1.0].into_iter(), Slip::Free);
        }),
        ("velocity", |b| b.position.push(Vector::zeros())),
        ("velocity", |b| b.velocity.clear()),
        ("acceleration", |b| b.acceleration.truncate(1)),
        ("shear", |b| b.shear.truncate(1)),
        ("force", |b| b.force.truncate(1)),
    ];
    for (name, spoil) in cases {
        let mut boundary = walls();
        spoil(&mut boundary);
        let points = boundary.len();
        let refused = water(boundary).unwrap_err();
        assert!(
            matches!(refused, FluidError::BoundaryLength { field, points: n, .. } if field == name && n == points),
            "{name}: {refused}"
        );
        // What is added later as well.
        let mut fluid = water(walls()).unwrap();
        spoil(fluid.boundary_mut());
        assert_eq!(fluid.begin_step(&Parallel::serial()).unwrap_err().to_string(), refused.to_string());
    }
}

#[test]
fn a_wall_behind_a_structure_is_not_left_out_without_a_word() {
    let late = |boundary: &mut Boundary<f64, 2>| {
        boundary.add_structure(&[Vector::from([0.2, 0.2])], [1.0].into_iter(), Slip::Free);
        let before = boundary.len();
        assert_eq!(boundary.add_wall(&[Vector::from([0.3, 0.2])], Slip::Free), None);
        assert_eq!(boundary.len(), before);
    };
    let mut boundary = walls();
    late(&mut boundary);
    assert!(matches!(water(boundary), Err(FluidError::WallTooLate)));
    let mut fluid = water(walls()).unwrap();
    late(fluid.boundary_mut());
    assert!(matches!(fluid.begin_step(&Parallel::serial()), Err(FluidError::WallTooLate)));
}

#[test]
fn points_without_a_volume_or_a_place_are_refused_by_number() {
    type Spoil = fn(&mut Boundary<f64, 2>, f64);
    let vectors: [(&str, Spoil); 3] = [
        ("position", |b, x| b.position[7].y = x),
        ("velocity", |b, x| b.velocity[7].x = x),
        ("acceleration", |b, x| b.acceleration[7].y = x),
    ];
    let not_numbers = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let refuse = |name: &str, spoil: Spoil, value: f64| {
        let mut boundary = walls();
        spoil(&mut boundary, value);
        let refused = water(boundary).unwrap_err().to_string();
        assert!(refused.contains("point 7") && refused.contains(name), "{name} = {value}: {refused}");
    };
    for value in not_numbers {
        vectors.iter().for_each(|(name, spoil)| refuse(name, *spoil, value));
    }
    for value in [0.0, -1.0].into_iter().chain(not_numbers) {
        refuse("volume", |b, x| b.volume[7] = x, value);
    }
    // A structure that comes after the fluid.
    let mut fluid = water(walls()).unwrap();
    let added = fluid.boundary_mut().add_structure(&[Vector::zeros()], [0.0].into_iter(), Slip::Free);
    let refused = fluid.begin_step(&Parallel::serial()).unwrap_err();
    assert!(matches!(refused, FluidError::BoundaryPoint { point, .. } if point == added.start), "{refused}");
}

#[test]
fn particles_that_are_nowhere_or_nothing_are_refused_by_number() {
    type Spoil = fn(&mut FluidParticles<f64, 2>, f64);
    let not_numbers = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let refuse = |name: &str, spoil: Spoil, value: f64| {
        let mut particles = FluidParticles::at_rest(lattice([0.0; 2], [4, 4], 0.01));
        // By number, whatever their place.
        particles.id.reverse();
        spoil(&mut particles, value);
        let config = FluidConfig::water(0.01, 10.0);
        let refused: Result<Water, _> = Fluid::new(config, Rational, |_| (), Open, particles, walls());
        let refused = refused.unwrap_err().to_string();
        assert!(refused.contains("particle 10 ") && refused.contains(name), "{name} = {value}: {refused}");
    };
    for value in not_numbers {
        refuse("position", |p, x| p.position[5].x = x, value);
        refuse("velocity", |p, x| p.velocity[5].y = x, value);
    }
    for value in [0.0, -1.0, 0.09].into_iter().chain(not_numbers) {
        refuse("density", |p, x| p.density[5] = x, value);
    }
}

#[test]
fn a_viscosity_that_is_none_is_refused() {
    fn with<V: Viscosity<f64, 2>>(viscosity: impl FnOnce(&ReferenceDensity<f64>) -> V) -> String {
        let particles = FluidParticles::at_rest(lattice([0.0; 2], [4, 4], 0.01));
        let config = FluidConfig::water(0.01, 10.0);
        let refused = Fluid::new(config, Rational, viscosity, Open, particles, Boundary::default());
        refused.map_or_else(|error| error.to_string(), |_| "accepted".to_owned())
    }
    for value in [-1e-3, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let laminar = with(|r| LaminarViscosity::new::<2>(value, r));
        assert!(laminar.contains("`viscosity`"), "{value}: {laminar}");
        let artificial = with(|r| ArtificialViscosity::new::<2>(value, 10.0, r));
        assert!(artificial.contains("`viscosity`"), "{value}: {artificial}");
        let both =
            with(|r| (LaminarViscosity::new::<2>(1e-6, r), ArtificialViscosity::new::<2>(value, 10.0, r)));
        assert!(both.contains("`viscosity`"), "{value}: {both}");
    }
    assert_eq!(with(|r| LaminarViscosity::new::<2>(0.0, r)), "accepted");
}
