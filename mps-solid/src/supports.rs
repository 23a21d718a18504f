//! Supports: particles that are held, slide, or are moved by somebody else.
//!
//! Each axis of a particle is free or held. What is held stays where it is, or follows a
//! [`Placement`] in time ([`Solid::move_supports`]). A face that is held along its normal only is a
//! plane of symmetry or a roller ([`Body::slide`](crate::body::Body::slide)).

use crate::{ConstitutiveModel, Solid, SolidError, SolidParticles};
use core::fmt;
use mps_kernel::{Kernel, Real, Tensor, Vector};
use std::sync::Arc;

/// Where a rigid support has brought the points of the undeformed body: `x = c + R (X - c) + d`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement<T: Real, const D: usize> {
    /// Rotation `R` about the centre.
    pub rotation: Tensor<T, D>,
    /// The centre `c` \[m\].
    pub center: Vector<T, D>,
    /// The shift `d` \[m\].
    pub shift: Vector<T, D>,
}

impl<T: Real, const D: usize> Placement<T, D> {
    /// Without rotation.
    pub fn shifted(shift: Vector<T, D>) -> Self {
        Self { rotation: Tensor::identity(), center: Vector::zeros(), shift }
    }

    /// Turned by `angle` \[rad\] about `center`, from the first axis towards the second.
    pub fn turned(angle: T, center: Vector<T, D>) -> Self {
        let mut rotation = Tensor::identity();
        let (sin, cos) = (angle.sin(), angle.cos());
        (rotation[(0, 0)], rotation[(0, 1)]) = (cos, -sin);
        (rotation[(1, 0)], rotation[(1, 1)]) = (sin, cos);
        Self { rotation, center, shift: Vector::zeros() }
    }

    /// The place of the point that was at `reference` \[m\].
    #[inline]
    pub fn of(&self, reference: &Vector<T, D>) -> Vector<T, D> {
        self.center + self.rotation * (reference - self.center) + self.shift
    }
}

/// A placement as a function of the time \[s\].
#[derive(Clone)]
pub(crate) struct Motion<T: Real, const D: usize>(Arc<dyn Fn(T) -> Placement<T, D> + Send + Sync>);

impl<T: Real, const D: usize> fmt::Debug for Motion<T, D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Motion")
    }
}

/// What the loops read of the supports.
#[derive(Clone, Copy)]
pub(crate) struct Held<'a, T: Real, const D: usize> {
    pub(crate) reference: &'a [Vector<T, D>],
    pub(crate) axes: &'a [u8],
    pub(crate) group: &'a [u8],
    /// Of every group but the first, which is that of particles at rest.
    pub(crate) placements: &'a [Placement<T, D>],
}

impl<T: Real, const D: usize> Held<'_, T, D> {
    /// Place and velocity of a particle with held axes after `drift` seconds, from those it would have if
    /// it were free. `x` and `u` are what they were. A kick without a drift leaves a support its speed.
    #[inline]
    pub(crate) fn hold(
        &self,
        i: usize,
        (x, u): (&Vector<T, D>, &Vector<T, D>),
        mut free: (Vector<T, D>, Vector<T, D>),
        drift: T,
    ) -> (Vector<T, D>, Vector<T, D>) {
        let group = self.group[i] as usize;
        let target = if group == 0 { *x } else { self.placements[group - 1].of(&self.reference[i]) };
        let moves = group != 0 && drift > T::zero();
        for axis in (0..D).filter(|axis| self.axes[i] & (1 << axis) != 0) {
            free.0[axis] = if moves { target[axis] } else { x[axis] };
            free.1[axis] = match group {
                0 => T::zero(),
                _ if moves => (target[axis] - x[axis]) / drift,
                _ => u[axis],
            };
        }
        free
    }

    /// `vector` without its components along the held axes of particle `i`.
    pub(crate) fn of_free_axes(&self, i: usize, vector: Vector<T, D>) -> Vector<T, D> {
        Vector::from_fn(|axis, _| if self.axes[i] & (1 << axis) == 0 { vector[axis] } else { T::zero() })
    }
}

impl<T, const D: usize, M, K> Solid<T, D, M, K>
where
    T: Real,
    M: ConstitutiveModel<T, D>,
    K: Kernel<T>,
{
    /// Lets the held axes of the chosen particles follow `motion`, a function of [`time`](Self::time)
    /// \[s\], instead of standing still. `choose` is asked with the reference position \[m\].
    ///
    /// # Errors
    /// If no held particle is chosen, if the motion does not begin where the particles are (ramp it up
    /// from there), or with the 256th motion of a body.
    pub fn move_supports(
        &mut self,
        choose: impl Fn(&Vector<T, D>) -> bool,
        motion: impl Fn(T) -> Placement<T, D> + Send + Sync + 'static,
    ) -> Result<(), SolidError> {
        let start = motion(self.time.now());
        let SolidParticles { reference, position, held, group, id, .. } = &mut self.particles;
        let number =
            u8::try_from(self.motions.len() + 1).map_err(|_| SolidError::Motion { problem: "too many" })?;
        let chosen: Vec<usize> = (0..id.len()).filter(|&i| held[i] != 0 && choose(&reference[i])).collect();
        if chosen.is_empty() {
            return Err(SolidError::Motion {
                problem: "moves no particle that is held: choose other points",
            });
        }
        let reach = self.spacing.max() * T::of(1e-3);
        for &i in &chosen {
            let away = start.of(&reference[i]) - position[i];
            let held = held[i];
            // Written so that NaN is refused too.
            if !(0..D).all(|axis| held & (1 << axis) == 0 || away[axis].abs() <= reach) {
                return Err(SolidError::Motion {
                    problem: "begins away from the particles: let it be the identity at the start",
                });
            }
        }
        chosen.iter().for_each(|&i| group[i] = number);
        self.motions.push(Motion(Arc::new(motion)));
        self.placements.push(start);
        Ok(())
    }

    /// Brings the placements to the time `when` \[s\].
    pub(crate) fn place_supports(&mut self, when: T) {
        for (placement, motion) in self.placements.iter_mut().zip(&self.motions) {
            *placement = (motion.0)(when);
        }
    }
}
