//! Why a particle of a solid moves as it does: its deformation, its stress, and every pair that pulls at it.
//!
//! The sweeps keep only sums; here they are formed once more for one particle, from its present deformation and the memories of
//! material that are there. A run that does not ask pays nothing.

use crate::momentum::{InnerStress, pair_force};
use crate::{ConstitutiveModel, Solid};
use mps_kernel::tensor::{determinant, largest_eigenvalue};
use mps_kernel::{Kernel, Real, Tensor, Vector};

/// What acts inside the body on one of its particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation<T: Real, const D: usize> {
    /// Number of the particle in the order of creation.
    pub id: u32,
    /// Position \[m\].
    pub position: Vector<T, D>,
    /// Position in the undeformed body \[m\].
    pub reference: Vector<T, D>,
    /// Velocity \[m/s\].
    pub velocity: Vector<T, D>,
    /// Mass \[kg, per metre of depth in 2D\].
    pub mass: T,
    /// Deformation gradient `F` \[-\].
    pub deformation: Tensor<T, D>,
    /// Its determinant: volume over reference volume \[-\].
    pub volume_ratio: T,
    /// Largest and smallest principal stretch \[-\]; the smallest one from the largest of the inverse.
    pub stretches: [T; 2],
    /// First Piola-Kirchhoff stress `P` \[Pa\].
    pub stress: Tensor<T, D>,
    /// Its reference neighbours.
    pub pairs: Vec<PairExplanation<T, D>>,
}

/// One reference pair, seen from the particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairExplanation<T: Real, const D: usize> {
    /// Number of the neighbour.
    pub id: u32,
    /// Where it is, seen from the particle \[m\].
    pub offset: Vector<T, D>,
    /// Distance over that in the undeformed body \[-\].
    pub stretch: T,
    /// What it does to the particle \[N, per metre of depth in 2D\].
    pub force: Vector<T, D>,
}

impl<T: Real, const D: usize> Explanation<T, D> {
    /// Sum of the forces of all pairs \[N, per metre of depth in 2D\].
    pub fn force(&self) -> Vector<T, D> {
        self.pairs.iter().fold(Vector::zeros(), |sum, pair| sum + pair.force)
    }
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// What acts on particle `i`, its index, in the present state; `None` where there is no such particle. After an
    /// [`advance`](Self::advance) that failed this is the state before it.
    pub fn explain(&self, i: usize) -> Option<Explanation<T, D>> {
        let particles = &self.particles;
        particles.deformation.get(i)?;
        // Of the positions there are: the stored one may be of before somebody has set them.
        let deformation = self.deformation_of(i);
        let mine = self.inner_of(i);
        let pair = |pair: &mps_neighbors::FrozenPair<T, D>| {
            let j = pair.j as usize;
            let offset = particles.position[j] - particles.position[i];
            PairExplanation {
                id: particles.id[j],
                offset,
                stretch: offset.norm() / pair.r0_ij.norm(),
                force: pair_force(pair, &offset, &mine, &self.inner_of(j)),
            }
        };
        let square = deformation.transpose() * deformation;
        // A deformation that cannot be undone has flattened the particle.
        let inverse =
            square.try_inverse().map_or(T::zero(), |inverse| T::one() / largest_eigenvalue(&inverse).sqrt());
        Some(Explanation {
            id: particles.id[i],
            position: particles.position[i],
            reference: particles.reference[i],
            velocity: particles.velocity[i],
            mass: particles.mass[i],
            deformation,
            volume_ratio: determinant(&deformation),
            stretches: [largest_eigenvalue(&square).sqrt(), inverse],
            stress: self.stress_of(i),
            pairs: self.pairs.row(i).iter().map(pair).collect(),
        })
    }

    /// The stress of the present deformation, without ageing.
    fn stress_of(&self, i: usize) -> Tensor<T, D> {
        let mut history = self.history[i];
        self.material.first_piola(&self.deformation_of(i), &mut history, T::zero())
    }

    fn inner_of(&self, i: usize) -> InnerStress<T, D> {
        let deformation = self.deformation_of(i);
        let volume = self.particles.volume[i];
        InnerStress::new(&self.stress_of(i), &deformation, &self.correction[i], volume, self.kappa)
    }
}
