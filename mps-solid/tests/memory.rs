//! Materials that remember, materials that give up, and what a search for the equilibrium leaves behind.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_kernel::tensor::determinant;
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::materials::NeoHookean;
use mps_solid::{ConstitutiveModel, Relaxation, Solid, SolidConfig, SolidError, SolidParticles};

type V = Vector<f64, 2>;

const YOUNG: f64 = 1e5;
const GRAVITY: V = V::new(0.0, -9.81);

/// Neo-Hookean with the viscous stress `F 2 eta dE/dt`, which gives up below a volume ratio.
#[derive(Clone)]
struct Sticky {
    base: NeoHookean<f64>,
    viscosity: f64,
    gives_up_below: f64,
}

fn sticky(viscosity: f64, gives_up_below: f64) -> Sticky {
    Sticky { base: NeoHookean::new(YOUNG, 0.3).unwrap(), viscosity, gives_up_below }
}

fn read(memory: &[f64; 4]) -> Tensor<f64, 2> {
    Tensor::from_column_slice(memory)
}

fn written(tensor: &Tensor<f64, 2>) -> [f64; 4] {
    [tensor[(0, 0)], tensor[(1, 0)], tensor[(0, 1)], tensor[(1, 1)]]
}

fn strain(f: &Tensor<f64, 2>) -> Tensor<f64, 2> {
    (f.transpose() * f - Tensor::identity()) * 0.5
}

impl ConstitutiveModel<f64, 2> for Sticky {
    /// Strain and its rate.
    type History = [[f64; 4]; 2];

    fn energy(&self, f: &Tensor<f64, 2>, _: &Self::History) -> f64 {
        self.base.energy(f, &())
    }

    fn first_piola(&self, f: &Tensor<f64, 2>, history: &mut Self::History, elapsed: f64) -> Tensor<f64, 2> {
        if elapsed > 0.0 {
            let rate = (strain(f) - read(&history[0])) / elapsed;
            *history = [written(&strain(f)), written(&rate)];
        }
        if determinant(f) < self.gives_up_below {
            return Tensor::from_element(f64::NAN);
        }
        self.base.first_piola(f, &mut (), 0.0) + f * read(&history[1]) * (2.0 * self.viscosity)
    }

    fn settle(&self, f: &Tensor<f64, 2>, history: &mut Self::History) {
        *history = [written(&strain(f)), [0.0; 4]];
    }

    fn first_lame_modulus(&self) -> f64 {
        ConstitutiveModel::<f64, 2>::first_lame_modulus(&self.base)
    }

    fn shear_modulus(&self) -> f64 {
        ConstitutiveModel::<f64, 2>::shear_modulus(&self.base)
    }

    fn name(&self) -> &'static str {
        "sticky"
    }
}

fn strip<M: ConstitutiveModel<f64, 2>>(material: M, clamp: &[Face]) -> Solid<f64, 2, M> {
    let strip = body::block(V::zeros(), V::new(0.1, 0.02), [21, 4], clamp).unwrap();
    let (config, serial) = (SolidConfig::default(), Parallel::serial());
    Solid::new(strip.particles, strip.spacing, 1000.0, material, WendlandC2, config, &serial).unwrap()
}

fn nothing(_: &SolidParticles<f64, 2>, _: &mut [V]) {}

fn fastest<M: ConstitutiveModel<f64, 2>>(solid: &Solid<f64, 2, M>) -> f64 {
    solid.velocities().iter().map(|u| u.norm()).fold(0.0, f64::max)
}

/// The strain under its own weight is not that of one sub-step.
#[test]
fn a_body_that_has_settled_stays_at_rest_whatever_its_material_remembers() {
    let serial = Parallel::serial();
    let mut solid = strip(sticky(20.0, 0.0), &[Face::lower(0)]);
    solid.relax(&serial, &GRAVITY, nothing, &Relaxation::default()).unwrap();
    let sag = solid.positions().iter().zip(solid.particles().reference_positions());
    assert!(sag.map(|(x, x0)| x0.y - x.y).fold(0.0, f64::max) > 1e-3, "it hangs");
    let (none, dt) = (vec![V::zeros(); solid.len()], solid.max_step(&serial));
    for _ in 0..20 {
        solid.advance(&serial, &none, &GRAVITY, dt, 1).unwrap();
        // What the tolerance of the search leaves; as a motion of one sub-step the strain throws it at 0.2 m/s.
        assert!(fastest(&solid) < 1e-3, "{}", fastest(&solid));
    }
}

#[test]
fn a_search_that_fails_leaves_the_body_at_rest_and_whole() {
    let serial = Parallel::serial();
    // Nothing holds it.
    let mut solid = strip(sticky(0.0, 0.0), &[]);
    let few = Relaxation { max_steps: 50, ..Relaxation::default() };
    let failed = solid.relax(&serial, &GRAVITY, nothing, &few);
    assert!(matches!(failed, Err(SolidError::NotSettled { steps: 50, .. })));
    assert!(fastest(&solid) == 0.0, "{}", fastest(&solid));
    // Pressed into itself by thousands of times its weight.
    let mut solid = strip(sticky(0.0, 0.0), &[Face::lower(0)]);
    let before = solid.positions().to_vec();
    let failed = solid.relax(&serial, &(GRAVITY * 1e7), nothing, &Relaxation::default());
    let broke = matches!(failed, Err(SolidError::Inverted { .. } | SolidError::NotFinite { .. }));
    assert!(broke, "{failed:?}");
    assert_eq!(solid.positions(), before);
    assert!(fastest(&solid) == 0.0);
}

/// With a single sub-step the stress is found last, and what follows of it is in the next step.
#[test]
fn a_stress_that_is_no_number_ends_the_step_and_takes_it_back() {
    let serial = Parallel::serial();
    let mut solid = strip(sticky(0.0, 0.95), &[Face::lower(0)]);
    solid.velocities_mut().fill(V::new(-2.0, 0.0));
    let (none, dt) = (vec![V::zeros(); solid.len()], solid.max_step(&serial));
    let failed = (0..500).find_map(|_| {
        let before = solid.positions().to_vec();
        let error = solid.advance(&serial, &none, &V::zeros(), dt, 1).err()?;
        assert_eq!(solid.positions(), before);
        Some(error)
    });
    assert!(matches!(failed, Some(SolidError::NotFinite { .. })), "{failed:?}");
    assert!(solid.positions().iter().all(|x| x.norm().is_finite()));
}

/// A falling body that is damped comes to `g/c`, whatever the sub-step.
#[test]
fn the_terminal_speed_is_that_of_the_damping_to_second_order() {
    let off = |substeps: usize| {
        let body = body::block(V::zeros(), V::repeat(1.0), [4, 4], &[]).unwrap();
        let config = SolidConfig { damping: 0.5, ..SolidConfig::default() };
        let (material, serial) = (NeoHookean::new(1.0, 0.3).unwrap(), Parallel::serial());
        let mut solid =
            Solid::new(body.particles, body.spacing, 1.0, material, WendlandC2, config, &serial).unwrap();
        let none = vec![V::zeros(); solid.len()];
        solid.advance(&serial, &none, &V::new(0.0, -1.0), 60.0, substeps).unwrap();
        (solid.velocities()[0].y / -2.0 - 1.0).abs()
    };
    let errors = [off(600), off(1200)];
    assert!(errors[0] < 3e-4 && errors[1] < 0.26 * errors[0], "{errors:?}");
}
