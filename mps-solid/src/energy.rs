//! What a solid keeps: energy, momentum and angular momentum.

use crate::momentum::InnerStress;
use crate::{ConstitutiveModel, Solid};
use core::ops::Add;
use mps_kernel::{Kernel, Real, Tensor, Vector};
use mps_neighbors::Parallel;

/// The energy of a solid \[J, per metre of depth in 2D\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolidEnergy<T> {
    /// `sum_i m_i |u_i|^2 / 2`.
    pub kinetic: T,
    /// `sum_i V_i w(F_i)`, the strain energy at the particles.
    pub strain: T,
    /// The strain energy inside the particles' cells, see [`stabilization`](crate::stabilization).
    pub bending: T,
    /// `-sum_i m_i g . (x_i - X_i)`, zero in the undeformed state.
    pub potential: T,
}

impl<T: Real> SolidEnergy<T> {
    /// The sum that a free vibration keeps.
    pub fn total(&self) -> T {
        self.kinetic + self.strain + self.bending + self.potential
    }
}

impl<T: Real> Add for SolidEnergy<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            kinetic: self.kinetic + other.kinetic,
            strain: self.strain + other.strain,
            bending: self.bending + other.bending,
            potential: self.potential + other.potential,
        }
    }
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// The energy of the current state; `gravity` is the acceleration \[m/s^2\] of the potential.
    pub fn energy(&self, parallel: &Parallel, gravity: &Vector<T, D>) -> SolidEnergy<T> {
        let particles = &self.particles;
        parallel.sum(self.len(), |i| {
            let (x, m) = (&particles.position[i], particles.mass[i]);
            let row = self.pairs.row(i);
            let f = self.deformation_of(i);
            let non_affine = row.iter().fold(T::zero(), |sum, pair| {
                let h_ij = particles.position[pair.j as usize] - x - f * pair.r0_ij;
                sum + pair.over_r2 * h_ij.norm_squared()
            });
            SolidEnergy {
                kinetic: m * T::of(0.5) * particles.velocity[i].norm_squared(),
                strain: particles.volume[i] * self.material.energy(&f, &self.history[i]),
                bending: particles.volume[i] * self.kappa * non_affine,
                potential: -m * gravity.dot(&(x - particles.reference[i])),
            }
        })
    }

    /// Linear momentum \[kg m/s\].
    pub fn momentum(&self, parallel: &Parallel) -> Vector<T, D> {
        self.sum(parallel, Vector::zeros(), |i| self.particles.velocity[i] * self.particles.mass[i])
    }

    /// Angular momentum about `center` \[kg m^2/s\], as the antisymmetric tensor
    /// `L_ab = sum_i m_i (r_a u_b - r_b u_a)`: in 2D `L_01` is the usual scalar, in 3D
    /// `(L_12, L_20, L_01)` the usual vector.
    pub fn angular_momentum(&self, parallel: &Parallel, center: &Vector<T, D>) -> Tensor<T, D> {
        self.sum(parallel, Tensor::zeros(), |i| {
            let r = self.particles.position[i] - center;
            let p = self.particles.velocity[i] * self.particles.mass[i];
            Tensor::from_fn(|a, b| r[a] * p[b] - r[b] * p[a])
        })
    }

    fn sum<A: Copy + Send + Sync + Add<Output = A>>(
        &self,
        parallel: &Parallel,
        zero: A,
        value: impl Fn(usize) -> A + Sync,
    ) -> A {
        parallel.fold(self.len(), zero, &value, &|a, b| a + b)
    }

    /// Largest pair force between `i` and its neighbours plus the reverse force: exactly zero.
    /// For checks of the reaction principle.
    pub fn reaction_defect(&self, i: usize) -> T {
        let inner = |i: usize| self.inner_stress_of(i);
        let mut worst = T::zero();
        for pair in self.pairs.row(i) {
            let j = pair.j as usize;
            let r_ij = self.particles.position[j] - self.particles.position[i];
            for back in self.pairs.row(j).iter().filter(|back| back.j as usize == i) {
                let there = crate::momentum::pair_force(pair, &r_ij, &inner(i), &inner(j));
                let again = crate::momentum::pair_force(back, &-r_ij, &inner(j), &inner(i));
                worst = worst.max((there + again).norm());
            }
        }
        worst
    }

    fn inner_stress_of(&self, i: usize) -> InnerStress<T, D> {
        let f = self.deformation_of(i);
        let mut history = self.history[i];
        let stress = self.material.first_piola(&f, &mut history, T::zero());
        InnerStress::new(&stress, &f, &self.correction[i], self.particles.volume[i], self.kappa)
    }
}
