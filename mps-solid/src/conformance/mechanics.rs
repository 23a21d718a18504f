//! What every material owes to mechanics.

use super::samples::slope;
use super::{Conformance, ConformanceError, Verdict};
use crate::ConstitutiveModel;
use mps_kernel::Tensor;

impl Conformance {
    pub(super) fn energy_gradient<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        self.at_rest(material, |f, history| {
            let mut slopes = Tensor::zeros();
            for k in 0..D * D {
                slopes[k] = slope(|step| material.energy(&moved(f, k, step), history));
            }
            let stress = material.first_piola(f, &mut { *history }, 0.0);
            verdict.equal_tensors("P against dw/dF", f, &stress, &slopes)
        })
    }

    pub(super) fn tangent_symmetry<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        self.at_rest(material, |f, history| {
            let slopes: Vec<Tensor<f64, D>> = (0..D * D)
                .map(|k| slope(|step| material.first_piola(&moved(f, k, step), &mut { *history }, 0.0)))
                .collect();
            let scale = slopes.iter().map(|slope| slope.norm()).fold(0.0, f64::max);
            let tangent = |k: usize, l: usize| slopes[k][l];
            for k in 0..D * D {
                for l in 0..k {
                    // Entry k of a tensor is in row k mod D.
                    let name = format!("dP_({}, {}) / dF_({}, {})", k % D, k / D, l % D, l / D);
                    verdict.equal(&name, f, tangent(l, k), tangent(k, l), scale)?;
                }
            }
            Ok(())
        })
    }

    /// Calls `examine` with deformations and histories in which nothing moves any more: that of the
    /// undeformed state, and one that came along a path and was held.
    fn at_rest<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        examine: impl Fn(&Tensor<f64, D>, &M::History) -> Result<(), ConformanceError>,
    ) -> Result<(), ConformanceError> {
        let mut samples = self.samples();
        for _ in 0..self.samples {
            let path = samples.path::<D>();
            let last = &path[path.len() - 1];
            let mut history = M::History::default();
            examine(last, &history)?;
            for f in path.iter().chain([last, last]) {
                material.first_piola(f, &mut history, self.elapsed);
            }
            examine(last, &history)?;
        }
        Ok(())
    }

    pub(super) fn objectivity<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let mut samples = self.samples();
        for _ in 0..self.samples {
            let path = samples.path::<D>();
            // With elapsed = 0 as well: a viscous stress must not hide an elastic one.
            for elapsed in [0.0, self.elapsed] {
                let (mut here, mut there) = (M::History::default(), M::History::default());
                for f in &path {
                    let q = samples.rotation::<D>();
                    let turned = q * f;
                    let stress = material.first_piola(f, &mut here, elapsed);
                    let value = material.first_piola(&turned, &mut there, elapsed);
                    verdict.equal_tensors("P(Q F) against Q P(F)", &turned, &value, &(q * stress))?;
                    let (energy, value) = (material.energy(f, &here), material.energy(&turned, &there));
                    verdict.equal("w(Q F) against w(F)", &turned, value, energy, energy.abs())?;
                }
            }
        }
        Ok(())
    }

    pub(super) fn stress_symmetry<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let mut samples = self.samples();
        for _ in 0..self.samples {
            let path = samples.path::<D>();
            for elapsed in [0.0, self.elapsed] {
                let mut history = M::History::default();
                for f in &path {
                    let kirchhoff = material.first_piola(f, &mut history, elapsed) * f.transpose();
                    verdict.equal_tensors("P F^T against F P^T", f, &kirchhoff, &kirchhoff.transpose())?;
                }
            }
        }
        Ok(())
    }

    pub(super) fn rest<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let mut samples = self.samples();
        let history = M::History::default();
        let (mut energy, mut stress) = (0.0_f64, 0.0_f64);
        for _ in 0..self.samples {
            let f = samples.deformation::<D>();
            energy = energy.max(material.energy(&f, &history).abs());
            stress = stress.max(material.first_piola(&f, &mut { history }, 0.0).norm());
        }
        for k in 0..self.samples {
            let r = if k == 0 { Tensor::identity() } else { samples.rotation::<D>() };
            verdict.equal("w of a rotation", &r, material.energy(&r, &history), 0.0, energy)?;
            for elapsed in [0.0, self.elapsed] {
                let size = material.first_piola(&r, &mut { history }, elapsed).norm();
                verdict.equal("|P| of a rotation", &r, size, 0.0, stress)?;
            }
        }
        Ok(())
    }
}

/// `f` with entry `k` (column by column) moved by `step`.
fn moved<const D: usize>(f: &Tensor<f64, D>, k: usize, step: f64) -> Tensor<f64, D> {
    let mut there = *f;
    there[k] += step;
    there
}
