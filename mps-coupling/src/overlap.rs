//! Water that a structure has been drawn into.

use crate::{CouplingError, Structure};
use mps_kernel::weights::WendlandC2;
use mps_kernel::{Kernel, Real, ReferenceDensity, Vector};
use mps_neighbors::{Cells, Open, Parallel, Rows};

/// A particle of the fluid nearer to a point than this share of the smaller spacing cannot be beside it.
const INSIDE: f64 = 1.0 / 3.0;
/// How much of its surroundings, two spacings of the structure wide, is the structure's for a particle that is inside: with any offset 0.95 and
/// more, in the middle of a plate of two layers 0.8. Beside a plane it is a sixth, in a hole as wide as the particle half.
const FILLED: f64 = 0.7;
/// And a particle as far away as half the sum of the spacings is not inside, were the hole around it ever so narrow.
const BESIDE: f64 = 0.9;
/// Radius of the surroundings over the spacing of the structure.
const RADIUS_RATIO: f64 = 2.1;

/// Refuses structure number `index` if particles of the fluid, `fluid` with their `spacing` \[m\], are inside it.
///
/// A lattice in a lattice is not always close to its points: shifted by half a spacing along all axes it is 0.71 of it away from them,
/// in space 0.87. Hence the second question, how much of the surroundings of a particle the structure fills. Images of periodic domains are
/// not looked for.
pub(crate) fn check_water<T: Real, const D: usize>(
    parallel: &Parallel,
    index: usize,
    structure: &dyn Structure<T, D>,
    fluid: &[Vector<T, D>],
    spacing: T,
) -> Result<(), CouplingError> {
    let (points, volumes, along) = (structure.positions(), structure.volumes(), structure.spacings());
    let (largest, smallest) = (along.max(), along.min());
    let radius = largest * T::of(RADIUS_RATIO);
    let close = spacing.min(smallest) * T::of(INSIDE);
    let beside = (spacing + largest) * T::of(0.5 * BESIDE);
    let reach = radius.max(beside);
    let mut cells = Cells::new();
    cells.build(parallel, &Open, points, reach)?;
    let mut rows = Rows::default();
    rows.build_between(parallel, &Open, &cells, fluid, points, reach)?;

    let lattice = ReferenceDensity::lattice::<_, D>(&WendlandC2, largest, radius)?;
    // The particle itself is one of the lattice.
    let all = (lattice.n0 + T::one()) * largest.powi(D as i32);
    for (i, place) in fluid.iter().enumerate() {
        let row = rows.row(i);
        let (mut distance, mut taken) = (reach, T::zero());
        for &j in row {
            let apart = (points[j as usize] - place).norm();
            distance = distance.min(apart);
            taken += volumes[j as usize] * WendlandC2.weight(apart, radius);
        }
        if distance < close || distance < beside && taken > all * T::of(FILLED) {
            let [distance, spacing] = [distance, spacing].map(T::to_double);
            let place = place.iter().map(|x| x.to_double()).collect();
            return Err(CouplingError::InWater { index, place, distance, spacing });
        }
    }
    Ok(())
}
