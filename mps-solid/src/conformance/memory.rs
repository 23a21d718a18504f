//! What a model remembers: all of it in the history, and nothing changed by looking.

use super::{Conformance, ConformanceError, Verdict};
use crate::ConstitutiveModel;
use bytemuck::{bytes_of, pod_read_unaligned};
use mps_kernel::Tensor;

/// For how many times `elapsed` a path is held until it counts as being at rest.
const HELD: usize = 1000;

impl Conformance {
    pub(super) fn elapsed_zero<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let mut samples = self.samples();
        for _ in 0..self.samples {
            let mut history = M::History::default();
            let path = samples.path::<D>();
            // The undeformed history is asked for a state far away, as in the set-up of a body ...
            ask_again(material, &path[0], &mut history, verdict)?;
            for f in &path {
                let stress = material.first_piola(f, &mut history, self.elapsed);
                // ... and every history for its own.
                let again = ask_again(material, f, &mut history, verdict)?;
                verdict.equal_tensors("P, asked for again", f, &again, &stress)?;
            }
        }
        Ok(())
    }

    /// What a material remembers that went along a path.
    fn history_after<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        path: &[Tensor<f64, D>],
    ) -> M::History {
        let mut history = M::History::default();
        for f in path {
            material.first_piola(f, &mut history, self.elapsed);
        }
        history
    }

    pub(super) fn settle<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let mut samples = self.samples();
        for _ in 0..self.samples {
            let path = samples.path::<D>();
            let last = &path[path.len() - 1];
            let mut history = self.history_after(material, &path);
            let mut held = history;
            for _ in 0..HELD {
                material.first_piola(last, &mut held, self.elapsed);
            }
            let expected = material.first_piola(last, &mut held, 0.0);
            material.settle(last, &mut history);
            let stress = ask_again(material, last, &mut history, verdict)?;
            verdict.equal_tensors("P after settle, against that of a path held", last, &stress, &expected)?;
        }
        Ok(())
    }

    pub(super) fn restart<const D: usize, M: ConstitutiveModel<f64, D>>(
        &self,
        material: &M,
        verdict: &Verdict,
    ) -> Result<(), ConformanceError> {
        let mut samples = self.samples();
        for _ in 0..self.samples {
            let path = samples.path::<D>();
            let (before, after) = path.split_at(path.len() / 2);
            let mut history = self.history_after(material, before);
            let saved = bytes_of(&history).to_vec();
            let stresses: Vec<_> =
                after.iter().map(|f| material.first_piola(f, &mut history, self.elapsed)).collect();

            let mut restored: M::History = pod_read_unaligned(&saved);
            for (f, expected) in after.iter().zip(&stresses) {
                let stress = material.first_piola(f, &mut restored, self.elapsed);
                same_bits("P after a restart", f, &stress, expected, verdict)?;
            }
            let last = &path[path.len() - 1];
            same_bytes("the history after a restart", last, &restored, &history, verdict)?;
        }
        Ok(())
    }
}

/// The stress with `elapsed = 0`, which must leave the history as it is.
fn ask_again<const D: usize, M: ConstitutiveModel<f64, D>>(
    material: &M,
    f: &Tensor<f64, D>,
    history: &mut M::History,
    verdict: &Verdict,
) -> Result<Tensor<f64, D>, ConformanceError> {
    let before = *history;
    let stress = material.first_piola(f, history, 0.0);
    same_bytes("the history, asked with elapsed = 0", f, history, &before, verdict)?;
    let finite = stress.iter().all(|entry| entry.is_finite());
    verdict.equal("|P| with elapsed = 0 (finite: 1)", f, if finite { 1.0 } else { f64::NAN }, 1.0, 0.0)?;
    Ok(stress)
}

fn same_bits<const D: usize>(
    quantity: &str,
    f: &Tensor<f64, D>,
    value: &Tensor<f64, D>,
    expected: &Tensor<f64, D>,
    verdict: &Verdict,
) -> Result<(), ConformanceError> {
    let differs = value.iter().zip(expected.iter()).find(|(a, b)| a.to_bits() != b.to_bits());
    match differs {
        // Bits are meant, so no deviation is allowed.
        Some((value, expected)) => verdict.equal(quantity, f, *value, *expected, 0.0),
        None => Ok(()),
    }
}

fn same_bytes<const D: usize, H: mps_kernel::Pod>(
    quantity: &str,
    f: &Tensor<f64, D>,
    value: &H,
    expected: &H,
    verdict: &Verdict,
) -> Result<(), ConformanceError> {
    let differs = bytes_of(value).iter().zip(bytes_of(expected)).enumerate().find(|(_, (a, b))| a != b);
    match differs {
        Some((at, (value, expected))) => {
            let quantity = format!("byte {at} of {quantity}");
            verdict.equal(&quantity, f, f64::from(*value), f64::from(*expected), 0.0)
        }
        None => Ok(()),
    }
}
