//! The coefficient of the non-affine energy, derived from what the midpoint rule leaves out.
//!
//! One strain per particle cannot see how the strain varies *inside* its cell. The energy that is lost
//! is known for the motion that matters in a thin body, cylindrical bending. With curvature `k` along
//! axis `a` and the strain varying along axis `b`,
//!
//! ```text
//! u_a = k x_a x_b,   u_b = -k/2 (x_a^2 + nu' x_b^2),   nu' = lambda/(lambda + 2 mu)
//! ```
//!
//! is an exact solution (no stress across), its strain energy per volume is `E'/2 k^2 x_b^2` with the
//! plane-strain modulus `E' = 4 mu (lambda + mu)/(lambda + 2 mu) = E/(1 - nu^2)`, and a particle at
//! `x_b` misses
//!
//! ```text
//! E'/2 k^2 <(x_b - x_b,i)^2> = E' k^2 l_b^2 / 24      [J/m^3]
//! ```
//!
//! the second moment of its cell. In a beam of `N` particles across, that is `1/N^2` of the stiffness.
//!
//! The same motion has a non-affine part: `F_i` reproduces the linear part of the displacement exactly
//! and gets nothing from the quadratic part on a symmetric neighbourhood, so that
//! `r_ij - F_i r0_ij = k h(r0_ij)` with `h_a = r_a r_b`, `h_b = -(r_a^2 + nu' r_b^2)/2`. The energy
//!
//! ```text
//! kappa sum_j w_ij |r_ij - F_i r0_ij|^2      [J/m^3],   w_ij = W_ij/|r0_ij|^2
//! ```
//!
//! (which also removes the zero-energy modes of a central difference) restores the missing part when
//!
//! ```text
//! kappa = (E' l_b^2 / 24) / sum_j w_ij |h(r0_ij)|^2
//! ```
//!
//! with the sum over one complete lattice neighbourhood. Every pair is counted from both of its ends, as
//! in the energy. Numerator and denominator are summed over all pairs of axes, which changes nothing
//! on a square or cubic lattice. (In 3D this is the bending of a plate; a slender bar would ask for 9 %
//! less at `nu = 0.4`.) In the usual writing `kappa = hg mu 2/n0` this is `hg = 0.32` for
//! `nu = 0` and `0.37` for `nu = 0.4` (Wendland weight, radius 1.6), but nothing is tuned: weight,
//! radius, lattice, Poisson's ratio and dimension all enter through the sum.
//!
//! The lattice value is used for every particle, at a surface too (a global, not a local normalisation):
//! the sum is carried almost entirely by the two neighbours *along* the beam, and those a particle at
//! the surface has as well. The penalty is measured against the particle's own `F`, so a rotation
//! costs nothing.

use crate::{ConstitutiveModel, SolidError};
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::FrozenPairs;

/// `kappa` \[Pa\] of the module's last formula.
///
/// `spacing` is the particle distance along each axis \[m\], `radius` the effective radius in spacings.
///
/// # Errors
/// If the spacing or the radius is not positive and finite.
pub fn bending_coefficient<T, const D: usize, M, K>(
    material: &M,
    kernel: &K,
    spacing: &Vector<T, D>,
    radius: T,
) -> Result<T, SolidError>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    let (lambda, mu) = (material.first_lame_modulus(), material.shear_modulus());
    let half = T::of(0.5);
    let stretch = lambda + mu * T::of(2.0);
    let plane_modulus = mu * T::of(4.0) * (lambda + mu) / stretch;
    let poisson = lambda / stretch;

    let (lattice, center) = lattice_around(spacing, radius);
    let pairs = FrozenPairs::build(&lattice, spacing, kernel, radius)?;
    let (mut missing, mut caught) = (T::zero(), T::zero());
    for a in 0..D {
        for b in (0..D).filter(|&b| b != a) {
            missing += plane_modulus * spacing[b] * spacing[b] / T::of(24.0);
            for pair in pairs.row(center) {
                let (along, across) = (pair.r0_ij[a], pair.r0_ij[b]);
                let h_a = along * across;
                let h_b = (along * along + poisson * across * across) * half;
                caught += pair.over_r2 * (h_a * h_a + h_b * h_b);
            }
        }
    }
    Ok(missing / caught)
}

/// Lattice points far enough around the one whose index is returned.
fn lattice_around<T: Real, const D: usize>(spacing: &Vector<T, D>, radius: T) -> (Vec<Vector<T, D>>, usize) {
    let reach = radius.to_double().ceil() as usize;
    let side = 2 * reach + 1;
    let points: Vec<_> = (0..side.pow(D as u32))
        .map(|index| {
            let mut rest = index;
            spacing.map(|l| {
                let step = (rest % side) as f64 - reach as f64;
                rest /= side;
                l * T::of(step)
            })
        })
        .collect();
    let center = points.len() / 2;
    (points, center)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::materials::CorotationalHooke;
    use approx::assert_relative_eq;
    use mps_kernel::{ReferenceDensity, weights::WendlandC2};

    /// `hg` of `kappa = hg mu 2/n0` on the square lattice of spacing 1.
    fn hg(nu: f64) -> f64 {
        let material = CorotationalHooke::new(1.0, nu).unwrap();
        let n0 = ReferenceDensity::lattice::<_, 2>(&WendlandC2, 1.0, 1.6).unwrap().n0;
        let kappa = bending_coefficient(&material, &WendlandC2, &Vector::<f64, 2>::repeat(1.0), 1.6).unwrap();
        kappa * n0 / (2.0 * material.moduli.mu)
    }

    #[test]
    fn coefficient_by_hand_for_nearest_neighbours() {
        // Radius below sqrt(2): four neighbours with weight w. sum_j w |h|^2 = 2 w/4 (1 + nu'^2).
        let radius = 1.4;
        let nu = 0.25;
        let material = CorotationalHooke::new(3.0, nu).unwrap();
        let (w, _) = Kernel::<f64>::weight_and_over_r2(&WendlandC2, 1.0, radius);
        let poisson: f64 = nu / (1.0 - nu);
        let by_hand = 3.0 / (1.0 - nu * nu) / 24.0 / (0.5 * w * (1.0 + poisson * poisson));
        let kappa =
            bending_coefficient(&material, &WendlandC2, &Vector::<f64, 2>::repeat(1.0), radius).unwrap();
        assert_relative_eq!(kappa, by_hand, max_relative = 1e-12);
    }

    #[test]
    fn documented_values() {
        assert_relative_eq!(hg(0.0), 0.319, max_relative = 0.01);
        assert_relative_eq!(hg(0.4), 0.370, max_relative = 0.01);
    }

    #[test]
    fn coefficient_does_not_depend_on_the_unit_of_length() {
        let material = CorotationalHooke::new(7.8e6, 0.47).unwrap();
        let of =
            |l: f64| bending_coefficient(&material, &WendlandC2, &Vector::<f64, 3>::repeat(l), 1.6).unwrap();
        assert_relative_eq!(of(1.0), of(1e-3), max_relative = 1e-10);
    }
}
