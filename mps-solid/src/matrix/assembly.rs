//! The second derivative of the energy, particle by particle.
//!
//! The energy of particle `i` depends on the positions `x_k` of itself and its reference neighbours, and
//! its deformation gradient is linear in them:
//!
//! ```text
//! F_i = sum_k x_k (x) g_k,    g_j = w_ij C_i r0_ij,    g_i = -sum_j g_j
//! ```
//!
//! With the normal equation of that fit (see [`kinematics`](crate::kinematics)) the non-affine energy is
//! `kappa V_i [sum_j w_ij |r_ij|^2 - F_i C_i^-1 : F_i]`, a quadratic form. Hence the block of the particles
//! `k` and `l` in the second derivative of `E_i`, without approximation but that of the material's tangent `A_i`:
//!
//! ```text
//! K_kl,ac = V_i sum_bd g_k,b A_i,(ab)(cd) g_l,d
//!         + 2 kappa V_i delta_ac [ sum_j w_ij (e_j - e_i)_k (e_j - e_i)_l - g_k . C_i^-1 g_l ]
//! ```

use super::MatrixError;
use super::freedoms::Freedoms;
use super::tangent::tangent;
use crate::{ConstitutiveModel, Solid};
use mps_kernel::{Kernel, Vector};
use mps_neighbors::FrozenPairs;

/// A compressed sparse matrix, symmetric, with both triangles: column `c` has its rows, ascending, and
/// values at `starts[c]..starts[c + 1]`.
#[derive(Clone, Debug)]
pub(super) struct Sparse {
    pub(super) starts: Vec<usize>,
    pub(super) rows: Vec<usize>,
    pub(super) values: Vec<f64>,
}

impl Sparse {
    /// The pattern of a body, with zeros: two particles meet in the energy of any that has both in its
    /// row, so the neighbours of neighbours count.
    pub(super) fn pattern<const D: usize>(pairs: &FrozenPairs<f64, D>, freedoms: &Freedoms<D>) -> Self {
        let (mut starts, mut rows) = (vec![0], Vec::new());
        let mut near = Vec::new();
        for k in 0..freedoms.particles() {
            near.clear();
            for i in cluster(pairs, k) {
                near.extend(cluster(pairs, i));
            }
            near.sort_unstable();
            near.dedup();
            for _ in freedoms.of(k) {
                rows.extend(near.iter().flat_map(|&l| freedoms.of(l).map(|(_, number)| number)));
                starts.push(rows.len());
            }
        }
        let values = vec![0.0; rows.len()];
        Self { starts, rows, values }
    }

    /// Adds `block(a, c)` to the entries of particles `k` (rows) and `l` (columns).
    fn add<const D: usize>(
        &mut self,
        freedoms: &Freedoms<D>,
        k: usize,
        l: usize,
        block: impl Fn(usize, usize) -> f64,
    ) {
        let Some(first) = freedoms.first(k) else { return };
        for (c, column) in freedoms.of(l) {
            let range = self.starts[column]..self.starts[column + 1];
            // The unknowns of a particle are neighbours in every column that has them.
            let at = range.start + self.rows[range].partition_point(|&row| row < first);
            for (a, row) in freedoms.of(k) {
                self.values[at + row - first] += block(a, c);
            }
        }
    }

    /// Entries of column `c` as (row, value).
    pub(super) fn column(&self, c: usize) -> impl Iterator<Item = (usize, f64)> {
        let range = self.starts[c]..self.starts[c + 1];
        self.rows[range.clone()].iter().copied().zip(self.values[range].iter().copied())
    }
}

/// Particle `i` and its reference neighbours.
fn cluster<const D: usize>(pairs: &FrozenPairs<f64, D>, i: usize) -> impl Iterator<Item = usize> {
    core::iter::once(i).chain(pairs.row(i).iter().map(|pair| pair.j as usize))
}

/// Writes the second derivative of the energy at the current positions into the values of `matrix`.
///
/// # Errors
/// If a particle is turned inside out or not finite, or the material's stress has no energy.
pub(super) fn assemble<const D: usize, M, K>(
    solid: &Solid<f64, D, M, K>,
    freedoms: &Freedoms<D>,
    matrix: &mut Sparse,
) -> Result<(), MatrixError>
where
    M: ConstitutiveModel<f64, D>,
    K: Kernel<f64>,
{
    matrix.values.fill(0.0);
    for i in 0..solid.len() {
        let a = tangent(solid, i)?;
        let volume = solid.particles.volume[i];
        let spring = 2.0 * solid.kappa * volume;
        let members = members(solid, i);
        for (p, k) in members.iter().enumerate() {
            // V g_k A, a D x D x D array: what is left is to contract it with g_l.
            let stress = |a_row: usize, c: usize, d: usize| {
                (0..D).map(|b| k.g[b] * a[(a_row * D + b, c * D + d)]).sum::<f64>() * volume
            };
            let mut half = [[[0.0; D]; D]; D];
            for (a_row, plane) in half.iter_mut().enumerate() {
                for (c, line) in plane.iter_mut().enumerate() {
                    for (d, entry) in line.iter_mut().enumerate() {
                        *entry = stress(a_row, c, d);
                    }
                }
            }
            for (q, l) in members.iter().enumerate() {
                let springs = match (p, q) {
                    (0, 0) => members[1..].iter().map(|j| j.weight).sum(),
                    (0, _) => -l.weight,
                    (_, 0) => -k.weight,
                    _ if p == q => k.weight,
                    _ => 0.0,
                };
                let scalar = spring * (springs - k.g.dot(&l.moment));
                matrix.add(freedoms, k.particle, l.particle, |a_row, c| {
                    let tangent: f64 = (0..D).map(|d| half[a_row][c][d] * l.g[d]).sum();
                    if a_row == c { tangent + scalar } else { tangent }
                });
            }
        }
    }
    Ok(())
}

/// How one particle enters the deformation gradient of another: the first is that one itself.
struct Member<const D: usize> {
    particle: usize,
    /// `g_k`.
    g: Vector<f64, D>,
    /// `C_i^-1 g_k`.
    moment: Vector<f64, D>,
    /// `w_ik`, zero for `i` itself.
    weight: f64,
}

fn members<const D: usize, M, K>(solid: &Solid<f64, D, M, K>, i: usize) -> Vec<Member<D>>
where
    M: ConstitutiveModel<f64, D>,
{
    let own = Member { particle: i, g: Vector::zeros(), moment: Vector::zeros(), weight: 0.0 };
    let mut members = vec![own];
    for pair in solid.pairs.row(i) {
        let moment = pair.r0_ij * pair.over_r2;
        let g = solid.correction[i] * moment;
        members[0].g -= g;
        members[0].moment -= moment;
        members.push(Member { particle: pair.j as usize, g, moment, weight: pair.over_r2 });
    }
    members
}
