//! Whether supports hold a body against moving and turning as a whole: a question about the supports alone, that no
//! eigenvalue answers (the softest bending of a slender body is as near to zero as the rounding of a rigid motion).

use super::MatrixError;
use crate::{ConstitutiveModel, Solid};
use mps_kernel::Vector;
use nalgebra::DMatrix;

/// Smallest over largest eigenvalue of what the supports take of the rigid motions, below which one is free.
const FREE: f64 = 1e-10;

/// Checks every part of the body that reference pairs join.
///
/// # Errors
/// [`MatrixError::NotHeld`] with the first part that can move.
pub(super) fn check_supports<const D: usize, M, K>(solid: &Solid<f64, D, M, K>) -> Result<(), MatrixError>
where
    M: ConstitutiveModel<f64, D>,
{
    let mut seen = vec![false; solid.particles.position.len()];
    let mut part = Vec::new();
    for first in 0..seen.len() {
        if seen[first] {
            continue;
        }
        part.clear();
        part.push(first);
        seen[first] = true;
        let mut next = 0;
        while let Some(&i) = part.get(next) {
            for pair in solid.pairs.row(i) {
                let j = pair.j as usize;
                if !seen[j] {
                    seen[j] = true;
                    part.push(j);
                }
            }
            next += 1;
        }
        let motions = free_motions(solid, &part);
        if motions > 0 {
            return Err(MatrixError::NotHeld { id: solid.particles.id[first], motions });
        }
    }
    Ok(())
}

/// How many of the rigid motions of these particles their supports leave free.
fn free_motions<const D: usize, M, K>(solid: &Solid<f64, D, M, K>, part: &[usize]) -> usize
where
    M: ConstitutiveModel<f64, D>,
{
    let particles = &solid.particles;
    let planes: Vec<(usize, usize)> = (0..D).flat_map(|a| (a + 1..D).map(move |b| (a, b))).collect();
    let motions = D + planes.len();
    let held: Vec<usize> = part.iter().copied().filter(|&i| particles.held[i] != 0).collect();
    if held.is_empty() {
        return motions;
    }
    let number = held.len() as f64;
    let center: Vector<f64, D> = held.iter().map(|&i| particles.position[i]).sum::<Vector<f64, D>>() / number;
    let spread = held.iter().map(|&i| (particles.position[i] - center).norm_squared()).sum::<f64>() / number;
    // Turning is measured by what it moves the supports by. A single particle is turned about itself.
    let arm = if spread > 0.0 { spread.sqrt() } else { 1.0 };
    let mut taken = DMatrix::<f64>::zeros(motions, motions);
    for &i in &held {
        let r = (particles.position[i] - center) / arm;
        for axis in (0..D).filter(|&axis| particles.is_held(i, axis)) {
            let along = |motion: usize| match planes.get(motion.wrapping_sub(D)) {
                None => f64::from(u8::from(motion == axis)),
                Some(&(a, b)) if axis == a => -r[b],
                Some(&(a, b)) if axis == b => r[a],
                Some(_) => 0.0,
            };
            for p in 0..motions {
                for q in 0..motions {
                    taken[(p, q)] += along(p) * along(q);
                }
            }
        }
    }
    let values = taken.symmetric_eigenvalues();
    let largest = values.iter().copied().fold(0.0, f64::max);
    values.iter().filter(|value| **value <= FREE * largest).count()
}
