//! A solid that was saved and restored into a twin goes on with the bits of one that was not, with what its material remembers and the
//! clock of its supports.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::block;
use mps_kernel::{State, StateError, Tensor, Vector};
use mps_neighbors::Parallel;
use mps_solid::body::Face;
use mps_solid::materials::NeoHookean;
use mps_solid::{ConstitutiveModel, Placement, Solid};

/// Softens with its age, in which the time since the last visit is counted: a visit too many changes it.
struct Ageing(NeoHookean<f64>);

impl ConstitutiveModel<f64, 2> for Ageing {
    type History = [f64; 2];

    fn energy(&self, f: &Tensor<f64, 2>, [age, _]: &[f64; 2]) -> f64 {
        self.0.energy(f, &()) / (1.0 + age)
    }

    fn first_piola(&self, f: &Tensor<f64, 2>, [age, visits]: &mut [f64; 2], elapsed: f64) -> Tensor<f64, 2> {
        *age += 50.0 * elapsed;
        *visits += 1.0;
        self.0.first_piola(f, &mut (), elapsed) / (1.0 + *age + 1e-4 * *visits)
    }

    fn first_lame_modulus(&self) -> f64 {
        self.0.moduli.lambda
    }

    fn shear_modulus(&self) -> f64 {
        self.0.moduli.mu
    }

    fn name(&self) -> &'static str {
        "ageing"
    }
}

fn shaken(counts: [usize; 2]) -> Solid<f64, 2, Ageing> {
    let mut solid = block(counts, &[Face::lower(0)], Ageing(NeoHookean::new(1e6, 0.3).unwrap()));
    let shake = |t: f64| Placement::shifted(Vector::<f64, 2>::new(0.0, 2e-3 * (400.0 * t).sin()));
    solid.move_supports(|x| x.x == 0.0, shake).unwrap();
    solid
}

fn save(solid: &mut Solid<f64, 2, Ageing>) -> State {
    State::save(|transfer| solid.transfer(transfer)).unwrap()
}

fn advance(solid: &mut Solid<f64, 2, Ageing>, parallel: &Parallel) {
    let rest = vec![Vector::zeros(); solid.len()];
    let dt = solid.max_step(parallel);
    solid.advance(parallel, &rest, &Vector::<f64, 2>::new(0.0, -9.81), 3.0 * dt, 3).unwrap();
}

#[test]
fn a_shaken_body_that_ages_goes_on_with_the_same_bits() {
    let serial = Parallel::serial();
    let mut solid = shaken([200, 6]);
    let mut states = vec![save(&mut solid)];
    for step in 0..20 {
        if step == 12 {
            solid.remeasure_stability(&serial).unwrap();
        }
        advance(&mut solid, &serial);
        states.push(save(&mut solid));
    }
    assert!(solid.history().iter().all(|[age, visits]| *age > 0.0 && *visits > 0.0));
    // Before the first step, before and after the new limit of its step, before the last one.
    for (k, moment) in [0, 1, 13, 19].into_iter().enumerate() {
        let parallel = Parallel::new(1 + k % 3).unwrap();
        let mut twin = shaken([200, 6]);
        states[moment].restore(|transfer| twin.transfer(transfer)).unwrap();
        assert!(save(&mut twin) == states[moment]);
        for step in moment..20 {
            if step == 12 {
                twin.remeasure_stability(&parallel).unwrap();
            }
            advance(&mut twin, &parallel);
            assert!(save(&mut twin) == states[step + 1], "saved at {moment}, differs after step {step}");
        }
    }
}

#[test]
fn positions_that_were_set_and_not_yet_felt_are_saved_as_such() {
    let serial = Parallel::serial();
    let mut solid = shaken([20, 6]);
    advance(&mut solid, &serial);
    solid.positions_mut().iter_mut().for_each(|x| x.x *= 1.01);
    let state = save(&mut solid);
    let mut twin = shaken([20, 6]);
    state.restore(|transfer| twin.transfer(transfer)).unwrap();
    advance(&mut solid, &serial);
    advance(&mut twin, &serial);
    assert!(save(&mut twin) == save(&mut solid));
}

#[test]
fn a_state_of_another_body_is_refused() {
    let (mut solid, mut thinner) = (shaken([20, 6]), shaken([20, 5]));
    let state = save(&mut solid);
    let other = state.restore(|transfer| thinner.transfer(transfer)).unwrap_err();
    let section = "particles/reference_position".to_owned();
    assert_eq!(other, StateError::Length { section, expected: thinner.len(), found: solid.len() });
    let mut still = block([20, 6], &[Face::lower(0)], Ageing(NeoHookean::new(1e6, 0.3).unwrap()));
    let unmoved = state.restore(|transfer| still.transfer(transfer)).unwrap_err();
    assert!(unmoved.to_string().contains("has 1 for 'moved supports' and here are 0"), "{unmoved}");
}
