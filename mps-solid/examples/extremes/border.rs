//! The longest step with which a free vibration stays bounded.

use crate::Outcome;
use crate::bodies::{Noise, serial};
use mps_kernel::{Real, Vector};
use mps_solid::{ConstitutiveModel, Solid};

/// Sub-steps of a trial, and the growth of the kinetic energy that counts as a blow-up: two thousandths above the border a
/// mode grows by `exp(2 sqrt(2 0.002) 2000)`, well below it by less than the number of modes over the distance.
const STEPS: usize = 2000;
const BLOWN: f64 = 1e4;

/// Whether the body stays bounded from random velocities of the size `speed` under steps of `dt`.
pub(crate) fn holds<T: Real, const D: usize, M: ConstitutiveModel<T, D> + Clone>(
    solid: &Solid<T, D, M>,
    dt: T,
    speed: f64,
) -> bool {
    let mut solid = solid.clone();
    let mut noise = Noise::new();
    let size = solid.wave_speed() * T::of(speed);
    for u in solid.velocities_mut() {
        *u = noise.vector::<T, D>() * size;
    }
    let rest = vec![Vector::zeros(); solid.len()];
    let zero = Vector::zeros();
    let most = solid.energy(&serial(), &zero).kinetic * T::of(BLOWN);
    let chunk = 20;
    for _ in 0..STEPS / chunk {
        if solid.advance(&serial(), &rest, &zero, dt * T::of(chunk as f64), chunk).is_err() {
            return false;
        }
        // NaN is not below the limit.
        if !solid.energy(&serial(), &zero).kinetic.partial_cmp(&most).is_some_and(|order| order.is_lt()) {
            return false;
        }
    }
    true
}

/// The border over `predicted`, between 0.5 and 2, to 0.0007.
pub(crate) fn border<T: Real, const D: usize, M: ConstitutiveModel<T, D> + Clone>(
    solid: &Solid<T, D, M>,
    predicted: f64,
    speed: f64,
) -> Outcome<f64> {
    let at = |ratio: f64| holds(solid, T::of(ratio * predicted), speed);
    let (mut low, mut high) = (0.5, 2.0);
    if !at(low) || at(high) {
        return Err(format!("the border is not between {low} and {high} of {predicted}").into());
    }
    for _ in 0..11 {
        let middle = 0.5 * (low + high);
        if at(middle) { low = middle } else { high = middle }
    }
    Ok(low)
}
