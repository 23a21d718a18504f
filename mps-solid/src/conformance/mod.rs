//! Is this a material? Checks for every [`ConstitutiveModel`], those of this crate and yours.
//!
//! What the framework promises (momenta and energy kept, the same bits after a restart, sub-steps that
//! are stable) it can keep only with a material that is what the trait says. A wrong factor in a stress
//! rarely shows in a picture; here it is found and named. Put this into the tests of your material:
//!
//! ```
//! use mps_solid::{conformance::Conformance, materials::NearlyIncompressible};
//!
//! let rubber = NearlyIncompressible::new(1.0e6, 0.49)?;
//! Conformance::default().check::<2, _>(&rubber)?;
//! Conformance::default().check::<3, _>(&rubber)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Deformations are drawn at random, the same in every run. A model with a memory is led along paths of such
//! deformations, [`elapsed`](Conformance::elapsed) apart. All checks are in `f64`: differences of `f32` show nothing.

mod elasticity;
mod error;
mod mechanics;
mod memory;
mod pulse;
mod samples;
mod verdict;

pub use error::{Check, ConformanceError};
pub use pulse::measured_wave_speed;

use crate::ConstitutiveModel;
use samples::Samples;
use verdict::Verdict;

/// How a material is examined. The defaults suit a rubber; `check` does everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conformance {
    /// Number of deformations, or of paths, for every check \[-\]. Default 32.
    pub samples: usize,
    /// Largest entry of `U - I` in the random deformations `F = R U` \[-\], between 0 and 2. Default 0.2. Take
    /// less for a material that is meant for small strains only.
    pub strain: f64,
    /// Allowed relative deviation \[-\]. Default 1e-6; differences are taken so that a smooth model stays
    /// a hundred times below.
    pub tolerance: f64,
    /// Time between the states of a path \[s\], for models with a memory. Default 1e-3.
    pub elapsed: f64,
    /// Whether the material is the same in all directions. Default true. If not,
    /// [`Check::Isotropy`], [`Check::Moduli`] and [`Check::WaveSpeed`] are left out.
    pub isotropic: bool,
    /// Allowed relative deviation of [`wave_speed`](ConstitutiveModel::wave_speed) from that of a pulse
    /// \[-\]. Default 0.005; the pulse itself is accurate to 1e-4.
    pub wave_tolerance: f64,
    /// Another number draws other deformations. Default 1.
    pub seed: u64,
}

impl Default for Conformance {
    fn default() -> Self {
        Self {
            samples: 32,
            strain: 0.2,
            tolerance: 1e-6,
            elapsed: 1e-3,
            isotropic: true,
            wave_tolerance: 0.005,
            seed: 1,
        }
    }
}

impl Conformance {
    /// The checks that apply, in the order in which [`check`](Self::check) makes them: each may rely on
    /// those before it.
    pub fn checks(&self) -> impl Iterator<Item = Check> {
        let isotropic = self.isotropic;
        Check::ALL.into_iter().filter(move |check| isotropic || !check.needs_isotropy())
    }

    /// Makes all checks.
    ///
    /// # Errors
    /// The first deviation: which check, where, by how much, and what is probably wrong.
    pub fn check<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
    ) -> Result<(), ConformanceError> {
        self.checks().try_for_each(|check| self.only(check, material))
    }

    /// Makes one check.
    ///
    /// # Errors
    /// The first deviation found by this check, or a setting that is out of range.
    pub fn only<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        check: Check,
        material: &M,
    ) -> Result<(), ConformanceError> {
        self.validate()?;
        let verdict = Verdict { check, material: material.name(), tolerance: self.tolerance };
        match check {
            Check::Restart => self.restart(material, &verdict),
            Check::ElapsedZero => self.elapsed_zero(material, &verdict),
            Check::Settle => self.settle(material, &verdict),
            Check::EnergyGradient => self.energy_gradient(material, &verdict),
            Check::Objectivity => self.objectivity(material, &verdict),
            Check::StressSymmetry => self.stress_symmetry(material, &verdict),
            Check::Rest => self.rest(material, &verdict),
            Check::TangentSymmetry => self.tangent_symmetry(material, &verdict),
            Check::Isotropy => self.isotropy(material, &verdict),
            Check::Moduli => self.moduli(material, &verdict),
            Check::WaveSpeed => self.wave_speed(material, &verdict),
        }
    }

    fn samples(&self) -> Samples {
        Samples::new(self.seed, self.strain)
    }

    fn validate(&self) -> Result<(), ConformanceError> {
        let positive = "positive and finite";
        let settings = [
            ("samples", "at least 1", self.samples as f64, 1.0, f64::MAX),
            ("strain", "positive and at most 2 (usual: 0.2)", self.strain, f64::MIN_POSITIVE, 2.0),
            ("tolerance", positive, self.tolerance, f64::MIN_POSITIVE, f64::MAX),
            ("elapsed", positive, self.elapsed, f64::MIN_POSITIVE, f64::MAX),
            ("wave_tolerance", positive, self.wave_tolerance, f64::MIN_POSITIVE, f64::MAX),
        ];
        for (name, must, value, low, high) in settings {
            // Written so that NaN is refused too.
            if !(value >= low && value <= high) {
                return Err(ConformanceError::Setting { name, must, value });
            }
        }
        Ok(())
    }
}
