//! Blocks stretched to three and four times, and compressed to three tenths of, their length by supports that move slowly.

use crate::Outcome;
use crate::bodies::{Sides, block, serial};
use crate::border::border;
use crate::collapse::{Block, deformed, is_stable, uniform};
use crate::laws::{self, Law};
use core::f64::consts::PI;
use mps_kernel::Vector;
use mps_solid::matrix::Stiffness;
use mps_solid::{ConstitutiveModel, Placement, Relaxation, SolidError};

const COUNTS: [usize; 2] = [12, 6];
const NU: f64 = 0.3;
/// How long the supports take for the way, in times of a wave along the block.
const SLOW: f64 = 100.0;

const STRETCHES: [f64; 4] = [3.0, 4.0, 0.7, 0.3];

pub(crate) fn table() -> Outcome<()> {
    println!("\nnu = {NU}, {COUNTS:?} particles, the supports take {SLOW} times the time of a wave");
    println!(
        "limit of the uniform state over that at rest; largest cfl of 0.8, 0.4 ... 0.05 that survives / what happens with 0.8 of the limit measured on the way\n"
    );
    let heads = STRETCHES.map(|stretch| format!(" {stretch} |"));
    println!("| law | sides |{}\n|---|---|---|---|---|---|", heads.concat());
    let mut worst = Worst::default();
    for law in laws::all::<f64>(NU)? {
        for sides in [Sides::Held, Sides::Free, Sides::Clamped] {
            let mut line = format!("| {} | {} |", ConstitutiveModel::<f64, 2>::name(&law), sides.name());
            for stretch in STRETCHES {
                let (state, stable) = state(&law, sides, stretch, &mut worst)?;
                let fixed = [0.8, 0.4, 0.2, 0.1, 0.05]
                    .into_iter()
                    .find_map(|cfl| pull(&law, sides, stretch, cfl, false).ok().map(|_| format!("{cfl}")));
                let fixed = fixed.unwrap_or("none".to_owned());
                let measured = match pull(&law, sides, stretch, 0.8, true) {
                    Ok(kept) if stable || kept.left < GIVEN_BACK => {
                        worst.energy = worst.energy.max(kept.swing);
                        worst.left = worst.left.max(kept.left);
                        "kept".to_owned()
                    }
                    Ok(kept) if kept.left > 1.0 => "folds, energy not kept".to_owned(),
                    Ok(kept) => format!("folds, {:.0} % left shaking", 100.0 * kept.left),
                    Err(SolidError::Inverted { id, .. }) => format!("particle {id} inverted"),
                    Err(other) => other.to_string(),
                };
                line += &format!(" {state}; {fixed} / {measured} |");
            }
            println!("{line}");
        }
    }
    println!(
        "\nof stable uniform states: border from its prediction {:.2} %, estimate {:.2} %",
        100.0 * worst.border,
        100.0 * worst.estimate
    );
    println!(
        "of what is kept: energy changes by {:.0e} while the supports stand, {:.0e} of it is left when they are back",
        worst.energy, worst.left
    );
    Ok(())
}

/// Share of the energy left when the supports are back from which on a block has left its state on the way.
const GIVEN_BACK: f64 = 1e-4;

/// The largest of what should be zero.
#[derive(Default)]
struct Worst {
    border: f64,
    estimate: f64,
    energy: f64,
    left: f64,
}

/// What becomes of the uniform state, and whether it is stable.
fn state(law: &Law<f64>, sides: Sides, stretch: f64, worst: &mut Worst) -> Outcome<(String, bool)> {
    let Some(f) = uniform(law, sides, stretch) else {
        return Ok((if sides == Sides::Clamped { "-" } else { "flat" }.to_owned(), false));
    };
    let rest = block(COUNTS, sides.faces(), *law, 0.8)?;
    let at_rest = 2.0 / Stiffness::new(&rest)?.largest_frequency()?;
    let mut solid = deformed(&rest, &f)?;
    if !is_stable(&solid)? {
        return Ok(("unstable".to_owned(), false));
    }
    // At the corners the uniform stress is not quite in equilibrium.
    solid.remeasure_stability(&serial())?;
    let exact = Relaxation { tolerance: 1e-9, ..Relaxation::default() };
    solid.relax(&serial(), &Vector::zeros(), |_, _| (), &exact)?;
    let predicted = 2.0 / Stiffness::new(&solid)?.largest_frequency()?;
    worst.border = worst.border.max((border(&solid, predicted, 1e-6)? - 1.0).abs());
    worst.estimate = worst.estimate.max((solid.remeasure_stability(&serial())? / predicted - 1.0).abs());
    Ok((format!("{:.2}", predicted / at_rest), true))
}

/// What a block keeps.
struct Kept {
    /// Largest change of the energy while the supports stand at the end of their way, over the energy.
    swing: f64,
    /// Energy left when they are back, over that at the end of the way.
    left: f64,
}

/// There, a rest, and back. Where `remeasure` is wanted, the limit is measured a hundred times on the way, and a part of
/// the way that fails is gone again with shorter steps.
fn pull(law: &Law<f64>, sides: Sides, stretch: f64, cfl: f64, remeasure: bool) -> Result<Kept, SolidError> {
    let Ok(mut solid): Result<Block, _> = block(COUNTS, sides.faces(), *law, cfl) else {
        return Err(SolidError::Empty);
    };
    let length = COUNTS[0] as f64 - 1.0;
    let way = SLOW * length;
    let shift = move |time: f64| {
        let part = (if time < 2.0 * way { time } else { 3.0 * way - time } / way).clamp(0.0, 1.0);
        Placement::shifted(Vector::<f64, 2>::new(
            (stretch - 1.0) * length * 0.5 * (1.0 - (PI * part).cos()),
            0.0,
        ))
    };
    solid.move_supports(|x| x.x > 0.0, shift)?;
    let (rest, zero, serial) = (vec![Vector::zeros(); solid.len()], Vector::zeros(), serial());
    let rounds = 300;
    let interval = way / f64::from(rounds / 3);
    let (mut start, mut swing) = (0.0, 0.0_f64);
    for round in 1..=rounds {
        if remeasure {
            solid.remeasure_stability(&serial)?;
        }
        let substeps = (interval / solid.max_step(&serial)).ceil() as usize;
        let mut done = solid.advance(&serial, &rest, &zero, interval, substeps);
        for k in 1..=3 {
            if remeasure && done.is_err() {
                done = solid.advance(&serial, &rest, &zero, interval, substeps << k);
            }
        }
        done?;
        let energy = solid.energy(&serial, &zero).total();
        if round == rounds / 3 {
            start = energy;
        } else if (rounds / 3..=2 * rounds / 3).contains(&round) {
            swing = swing.max((energy / start - 1.0).abs());
        }
    }
    Ok(Kept { swing, left: solid.energy(&serial, &zero).total() / start })
}
