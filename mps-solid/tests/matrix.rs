//! The stiffness matrix against differences of the forces, and its own consistency.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{Noise, block, deform};
use mps_kernel::{Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::Face;
use mps_solid::materials::{CorotationalHooke, NeoHookean, SaintVenantKirchhoff};
use mps_solid::matrix::{MatrixError, Stiffness};
use mps_solid::{ConstitutiveModel, Solid, SolidError};

const YOUNG: f64 = 2.0e6;

/// A smooth deformation of up to 20 % with noise; clamped particles move too, which the matrix must not mind.
fn shake<const D: usize, M: ConstitutiveModel<f64, D>>(solid: &mut Solid<f64, D, M>, size: f64) {
    let mut noise = Noise::new(3);
    deform(solid, |x| {
        let mut y = *x;
        y[0] += size * 2.0 * x[0] * x[1];
        y[1] -= size * 1.5 * x[0] * x[0];
        y + noise.vector::<f64, D>() * (size * 5e-4)
    });
}

/// `K u` for a random `u` is the slope of the forces along it.
fn is_the_slope_of_the_forces<const D: usize, M: ConstitutiveModel<f64, D>>(
    counts: [usize; D],
    clamp: &[Face],
    material: M,
    size: f64,
) {
    let mut solid = block(counts, clamp, material);
    shake(&mut solid, size);
    let stiffness = Stiffness::new(&solid).unwrap();
    let place = solid.positions().to_vec();
    let mut noise = Noise::new(7);
    for _ in 0..4 {
        let u: Vec<Vector<f64, D>> = (0..solid.len())
            .map(|i| if solid.particles().is_clamped(i) { Vector::zeros() } else { noise.vector() })
            .collect();
        let mut force_at = |step: f64| {
            for (x, (x0, u)) in solid.positions_mut().iter_mut().zip(place.iter().zip(&u)) {
                *x = x0 + u * step;
            }
            solid.refresh(&Parallel::serial()).unwrap();
            solid.particles().internal_forces().to_vec()
        };
        let step = 1e-6;
        let (there, back) = (force_at(step), force_at(-step));
        let product = stiffness.multiply(&u).unwrap();
        let scale = product.iter().map(|f| f.norm()).fold(0.0, f64::max);
        for i in 0..solid.len() {
            if solid.particles().is_clamped(i) {
                assert_eq!(product[i].norm(), 0.0);
            } else {
                let error = ((back[i] - there[i]) / (2.0 * step) - product[i]).norm();
                assert!(error < 1e-6 * scale, "particle {i}: {error} of {scale}");
            }
        }
    }
}

#[test]
fn matrix_is_the_slope_of_the_forces() {
    let clamp = [Face::lower(0)];
    for size in [0.0, 1.0] {
        is_the_slope_of_the_forces([6, 4], &[], CorotationalHooke::new(YOUNG, 0.4).unwrap(), size);
        is_the_slope_of_the_forces([7, 3], &clamp, SaintVenantKirchhoff::new(YOUNG, 0.0).unwrap(), size);
        is_the_slope_of_the_forces([7, 3], &clamp, NeoHookean::new(YOUNG, 0.49).unwrap(), size);
        is_the_slope_of_the_forces([5, 4, 3], &[], CorotationalHooke::new(YOUNG, -0.3).unwrap(), size);
        is_the_slope_of_the_forces([5, 3, 3], &clamp, NeoHookean::new(YOUNG, 0.4).unwrap(), size);
    }
}

#[test]
fn loads_and_displacements_belong_together() {
    let solid = block([9, 4, 3], &[Face::lower(0)], NeoHookean::new(YOUNG, 0.45).unwrap());
    let stiffness = Stiffness::new(&solid).unwrap();
    assert_eq!(stiffness.len(), 3 * 8 * 12);
    let mut noise = Noise::new(1);
    let force: Vec<Vector<f64, 3>> = (0..solid.len()).map(|_| noise.vector()).collect();
    let back = stiffness.multiply(&stiffness.solve(&force).unwrap()).unwrap();
    for i in (0..solid.len()).filter(|&i| !solid.particles().is_clamped(i)) {
        assert!((back[i] - force[i]).norm() < 1e-8, "{i}: {} is not {}", back[i], force[i]);
    }
}

/// A material whose stress has no energy.
struct Pump;

impl ConstitutiveModel<f64, 2> for Pump {
    type History = ();

    fn energy(&self, _: &Tensor<f64, 2>, (): &()) -> f64 {
        0.0
    }

    fn first_piola(&self, f: &Tensor<f64, 2>, history: &mut (), elapsed: f64) -> Tensor<f64, 2> {
        let hooke = CorotationalHooke::new(YOUNG, 0.3).unwrap();
        let mut stress = hooke.first_piola(f, history, elapsed);
        stress[(0, 0)] += 1e3 * f[(0, 1)];
        stress
    }

    fn first_lame_modulus(&self) -> f64 {
        YOUNG
    }

    fn shear_modulus(&self) -> f64 {
        YOUNG
    }

    fn name(&self) -> &'static str {
        "pump"
    }
}

#[test]
fn unusable_bodies_are_refused() {
    let hooke = CorotationalHooke::new(YOUNG, 0.3).unwrap();
    let free = block([6, 4], &[], hooke);
    let stiffness = Stiffness::new(&free).unwrap();
    let rest = vec![Vector::zeros(); free.len()];
    assert_eq!(stiffness.solve(&rest), Err(MatrixError::NotHeld { id: 0, motions: 3 }));
    let short = &rest[1..];
    assert!(matches!(stiffness.multiply(short), Err(MatrixError::Solid(SolidError::Length { .. }))));
    assert!(matches!(stiffness.lowest(0), Err(MatrixError::Count { asked: 0, freedoms: 48 })));
    assert!(matches!(stiffness.lowest(49), Err(MatrixError::Count { asked: 49, .. })));

    let all = [Face::lower(0), Face::upper(0)];
    assert!(matches!(Stiffness::new(&block([2, 4], &all, hooke)), Err(MatrixError::NothingMoves)));
    assert!(matches!(
        Stiffness::new(&block([6, 4], &[], Pump)),
        Err(MatrixError::NotSymmetric { material: "pump", id: 0, .. })
    ));

    let mut crushed = block([6, 4], &[], hooke);
    crushed.positions_mut().iter_mut().for_each(|x| x.x = -x.x);
    let broken = Stiffness::new(&crushed);
    assert!(matches!(broken, Err(MatrixError::Solid(SolidError::Inverted { id: 0, .. }))));
    crushed.positions_mut()[3].x = f64::NAN;
    assert!(matches!(Stiffness::new(&crushed), Err(MatrixError::Solid(_))));
}

/// Neo-Hookean with the viscous stress `F 2 eta dE/dt`.
struct Viscous(NeoHookean<f64>);

fn strain(f: &Tensor<f64, 2>) -> Tensor<f64, 2> {
    (f.transpose() * f - Tensor::identity()) * 0.5
}

fn written(t: &Tensor<f64, 2>) -> [f64; 4] {
    [t[0], t[1], t[2], t[3]]
}

impl ConstitutiveModel<f64, 2> for Viscous {
    /// Strain and its rate.
    type History = [[f64; 4]; 2];

    fn energy(&self, f: &Tensor<f64, 2>, _: &Self::History) -> f64 {
        self.0.energy(f, &())
    }

    fn first_piola(&self, f: &Tensor<f64, 2>, history: &mut Self::History, elapsed: f64) -> Tensor<f64, 2> {
        if elapsed > 0.0 {
            let rate = (strain(f) - Tensor::from_column_slice(&history[0])) / elapsed;
            *history = [written(&strain(f)), written(&rate)];
        }
        self.0.first_piola(f, &mut (), 0.0) + f * Tensor::from_column_slice(&history[1]) * (2e-4 * YOUNG)
    }

    fn settle(&self, f: &Tensor<f64, 2>, history: &mut Self::History) {
        *history = [written(&strain(f)), [0.0; 4]];
    }

    fn first_lame_modulus(&self) -> f64 {
        self.0.moduli.lambda
    }

    fn shear_modulus(&self) -> f64 {
        self.0.moduli.mu
    }

    fn name(&self) -> &'static str {
        "viscous"
    }
}

#[test]
fn a_viscous_body_that_moves_has_the_stiffness_of_its_twin_at_rest() {
    let serial = Parallel::serial();
    let mut moving = block([12, 4], &[Face::lower(0)], Viscous(NeoHookean::new(YOUNG, 0.3).unwrap()));
    let pressed: Vec<_> =
        moving.positions().iter().map(|x| Vector::<f64, 2>::new(-100.0 * x.x, 0.0)).collect();
    moving.velocities_mut().copy_from_slice(&pressed);
    let (none, dt) = (vec![Vector::zeros(); moving.len()], 0.02 * moving.max_step(&serial));
    for _ in 0..20 {
        moving.advance(&serial, &none, &Vector::zeros(), dt, 1).unwrap();
    }
    let mut resting = block([12, 4], &[Face::lower(0)], Viscous(NeoHookean::new(YOUNG, 0.3).unwrap()));
    resting.positions_mut().copy_from_slice(moving.positions());
    let lowest = |solid: &Solid<f64, 2, Viscous>| Stiffness::new(solid).unwrap().lowest(3).unwrap();
    let (a, b) = (lowest(&moving), lowest(&resting));
    assert!(moving.history().iter().any(|[_, rate]| rate.iter().any(|r| r.abs() > 1.0)), "it moves");
    for (a, b) in a.iter().zip(&b) {
        assert!((a.square / b.square - 1.0).abs() < 1e-9, "{} moving, {} at rest", a.square, b.square);
    }
}
