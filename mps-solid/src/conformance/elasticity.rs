//! What an isotropic material reports about itself.

use super::samples::slope;
use super::{Conformance, ConformanceError, Verdict};
use crate::ConstitutiveModel;
use mps_kernel::Tensor;

/// Density of the bar \[kg/m^3\]. Speeds go with its root, whatever it is.
const DENSITY: f64 = 1000.0;

impl Conformance {
    pub(super) fn isotropy<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let mut samples = self.samples();
        let history = M::History::default();
        for _ in 0..self.samples {
            let (f, q) = (samples.deformation::<D>(), samples.rotation::<D>());
            let turned = f * q;
            let energy = material.energy(&f, &history);
            let value = material.energy(&turned, &history);
            verdict.equal("w(F Q) against w(F)", &turned, value, energy, energy.abs())?;
        }
        Ok(())
    }

    pub(super) fn moduli<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let (lambda, mu) = (material.first_lame_modulus(), material.shear_modulus());
        let mut samples = self.samples();
        for _ in 0..self.samples {
            let gradient = samples.tensor::<D>();
            let strain = (gradient + gradient.transpose()) * 0.5;
            let hooke = Tensor::identity() * (lambda * strain.trace()) + strain * (2.0 * mu);
            let history = M::History::default();
            let at = |step: f64| Tensor::identity() + gradient * step;
            let stress = slope(|step| material.first_piola(&at(step), &mut { history }, 0.0));
            let name = "lambda tr(e) I + 2 mu e with the moduli reported, against the stress";
            verdict.equal_tensors(name, &at(1.0), &hooke, &stress)?;
        }
        Ok(())
    }

    pub(super) fn wave_speed<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let expected = super::measured_wave_speed(material, DENSITY)?;
        let verdict = Verdict { tolerance: self.wave_tolerance, ..*verdict };
        let value = material.wave_speed(DENSITY);
        verdict.equal(
            "the wave speed for 1000 kg/m^3",
            &Tensor::<f64, D>::identity(),
            value,
            expected,
            expected,
        )
    }
}
