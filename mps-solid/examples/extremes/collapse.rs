//! How far a block may be compressed and stretched before it leaves the uniform state.

use crate::Outcome;
use crate::bodies::{Sides, block, serial};
use crate::laws::{self, Law};
use mps_kernel::{Tensor, Vector};
use mps_solid::matrix::Stiffness;
use mps_solid::{ConstitutiveModel, Solid};

pub(crate) type Block = Solid<f64, 2, Law<f64>>;

/// Stretches looked at: down to this one in steps of a hundredth, up to that one in steps of a twentieth.
const SMALLEST: f64 = 0.1;
const LARGEST: f64 = 4.0;

pub(crate) fn table() -> Outcome<()> {
    for nu in [0.3, 0.45] {
        println!(
            "\nnu = {nu}: stretch at which the material loses its ellipticity or is flat / lowest omega^2 of 12x6 / of 24x12 passes zero\n"
        );
        println!("| law | sides | compressed | stretched |\n|---|---|---|---|");
        for law in laws::all::<f64>(nu)? {
            for sides in Sides::UNIFORM {
                let limits = |down: bool| -> Outcome<String> {
                    let material = last(down, |stretch| Ok(is_elliptic(&law, sides, stretch)))?;
                    let coarse = body(&law, sides, [12, 6], down)?;
                    let fine = body(&law, sides, [24, 12], down)?;
                    Ok(format!("{} / {} / {}", text(material), text(coarse), text(fine)))
                };
                let name = ConstitutiveModel::<f64, 2>::name(&law);
                println!("| {name} | {} | {} | {} |", sides.name(), limits(true)?, limits(false)?);
            }
        }
    }
    Ok(())
}

fn text(limit: Option<f64>) -> String {
    limit.map_or("none".to_owned(), |stretch| format!("{stretch:.3}"))
}

/// The uniform deformation; `None` where there is none, or the material is flattened.
pub(crate) fn uniform(law: &Law<f64>, sides: Sides, stretch: f64) -> Option<Tensor<f64, 2>> {
    let across = match sides {
        Sides::Held => Some(1.0),
        Sides::Free => law.stretch_across(stretch),
        Sides::Clamped => None,
    };
    across.map(|across| Tensor::<f64, 2>::new(stretch, 0.0, 0.0, across))
}

fn is_elliptic(law: &Law<f64>, sides: Sides, stretch: f64) -> bool {
    uniform(law, sides, stretch).is_some_and(|f| law.stiffest_least(&f) > 0.0)
}

/// The block in the uniform state.
pub(crate) fn deformed(block: &Block, f: &Tensor<f64, 2>) -> Outcome<Block> {
    let mut solid = block.clone();
    let places: Vec<Vector<f64, 2>> = solid.particles().reference_positions().iter().map(|x| f * x).collect();
    solid.positions_mut().copy_from_slice(&places);
    solid.refresh(&serial())?;
    Ok(solid)
}

/// Whether the uniform state of a block is stable.
pub(crate) fn is_stable(solid: &Block) -> Outcome<bool> {
    Ok(Stiffness::new(solid)?.lowest(1)?[0].square > 0.0)
}

fn body(law: &Law<f64>, sides: Sides, counts: [usize; 2], down: bool) -> Outcome<Option<f64>> {
    let block = block(counts, sides.faces(), *law, 0.8)?;
    last(down, |stretch| match uniform(law, sides, stretch) {
        Some(f) => is_stable(&deformed(&block, &f)?),
        None => Ok(false),
    })
}

/// The last stretch, away from 1, at which `holds`; `None` if it does up to the end.
fn last(down: bool, holds: impl Fn(f64) -> Outcome<bool>) -> Outcome<Option<f64>> {
    let (end, step) = if down { (SMALLEST, -0.01) } else { (LARGEST, 0.05) };
    let steps = ((end - 1.0) / step).round() as usize;
    for k in 1..=steps {
        if !holds(1.0 + step * k as f64)? {
            let (mut good, mut bad) = (1.0 + step * (k - 1) as f64, 1.0 + step * k as f64);
            for _ in 0..8 {
                let middle = 0.5 * (good + bad);
                if holds(middle)? { good = middle } else { bad = middle }
            }
            return Ok(Some(good));
        }
    }
    Ok(None)
}
