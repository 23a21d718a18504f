//! What a structure shows is looked at before anything is done with it: it may be of any make.

use crate::scene::Body;
use crate::{CouplingError, Inertia, Structure};
use mps_kernel::{Real, Vector};

/// Refuses a structure that cannot be added as number `index`: fields of different lengths, values that are none.
pub(crate) fn check_new<T: Real, const D: usize>(
    index: usize,
    structure: &dyn Structure<T, D>,
) -> Result<(), CouplingError> {
    let positions = structure.positions().len();
    let mut lengths = vec![("volumes", structure.volumes().len())];
    lengths.push(("mean velocities", structure.mean_velocities().len()));
    if let Inertia::Points(masses) = structure.inertia() {
        lengths.push(("masses", masses.len()));
    }
    if let Some((what, got)) = lengths.into_iter().find(|(_, got)| *got != positions) {
        return Err(CouplingError::Lengths { index, positions, what, got });
    }
    let unusable = |volume: &&T| !(**volume > T::zero() && volume.is_finite());
    if let Some(volume) = structure.volumes().iter().find(unusable) {
        return Err(CouplingError::Volume { index, volume: volume.to_double() });
    }
    check_motion(index, structure, 0.0)?;
    check_masses(index, structure)
}

/// Refuses points that have become more or fewer, and places and velocities that are no numbers, at the time `time` \[s\].
pub(crate) fn check_points<T: Real, const D: usize>(
    index: usize,
    body: &Body<T, D>,
    time: f64,
) -> Result<(), CouplingError> {
    let structure = &*body.structure;
    let before = body.force.len();
    let shown =
        [("positions", structure.positions().len()), ("mean velocities", structure.mean_velocities().len())];
    match shown.into_iter().find(|(_, now)| *now != before) {
        Some((what, now)) => Err(CouplingError::Points { index, time, what, before, now }),
        None => check_motion(index, structure, time),
    }
}

/// In one pass; what is wrong is looked for only if something is.
fn check_motion<T: Real, const D: usize>(
    index: usize,
    structure: &dyn Structure<T, D>,
    time: f64,
) -> Result<(), CouplingError> {
    let (positions, velocities) = (structure.positions(), structure.mean_velocities());
    // Zero times whatever is finite is zero, and anything else stays what it is in a sum.
    let nothing = positions
        .iter()
        .zip(velocities)
        .fold(Vector::<T, D>::zeros(), |sum, (r, v)| sum + r * T::zero() + v * T::zero());
    if nothing.iter().all(|x| *x == T::zero()) {
        return Ok(());
    }
    for (what, unit, values) in [("position", "m", positions), ("mean velocity", "m/s", velocities)] {
        let lost = |value: &Vector<T, D>| !value.iter().all(|x| x.is_finite());
        if let Some(point) = values.iter().position(lost) {
            let value = values[point].iter().map(|x| x.to_double()).collect();
            return Err(CouplingError::NoNumber { index, point, what, unit, value, time });
        }
    }
    Ok(())
}

/// Refuses masses that nothing can be divided by, and any other number of them than of points.
pub(crate) fn check_masses<T: Real, const D: usize>(
    index: usize,
    structure: &dyn Structure<T, D>,
) -> Result<(), CouplingError> {
    // What is held may be as heavy as it likes.
    let unusable = |mass: &T| !matches!(mass.partial_cmp(&T::zero()), Some(core::cmp::Ordering::Greater));
    match structure.inertia() {
        Inertia::Rigid(mass) if unusable(&mass) => {
            Err(CouplingError::Mass { index, point: None, mass: mass.to_double() })
        }
        Inertia::Points(masses) => {
            let positions = structure.positions().len();
            if masses.len() != positions {
                let (what, got) = ("masses", masses.len());
                return Err(CouplingError::Lengths { index, positions, what, got });
            }
            match masses.iter().position(unusable) {
                Some(point) => {
                    let mass = masses[point].to_double();
                    Err(CouplingError::Mass { index, point: Some(point), mass })
                }
                None => Ok(()),
            }
        }
        Inertia::Rigid(_) | Inertia::Unknown => Ok(()),
    }
}

/// Refuses a longest sub-step that is none \[s\].
pub(crate) fn check_limit<T: Real>(index: usize, limit: T) -> Result<(), CouplingError> {
    // Asked this way NaN is refused as well.
    if limit > T::zero() { Ok(()) } else { Err(CouplingError::Limit { index, limit: limit.to_double() }) }
}
