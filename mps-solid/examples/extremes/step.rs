//! The longest stable step over Poisson's ratio and thickness.

use crate::Outcome;
use crate::bodies::block;
use crate::border::border;
use mps_solid::materials::{CorotationalHooke, Moduli};
use mps_solid::matrix::Stiffness;

const RATIOS: [f64; 9] = [-0.4, -0.2, 0.0, 0.3, 0.4, 0.47, 0.49, 0.499, 0.4999];
/// Start velocity over the wave speed: nothing but the linear body is asked.
const SPEED: f64 = 1e-5;

pub(crate) fn table() -> Outcome<()> {
    println!(
        "\nlimit 2/omega_max in l0/c_p by the matrix / border of a free vibration over it / estimate at set-up over it\n"
    );
    println!("| nu | 16x2 | 16x3 | 16x4 | 12x2x2 | 10x3x3 | 8x4x4 |\n|---|---|---|---|---|---|---|");
    let mut worst = 0.0_f64;
    for nu in RATIOS {
        let cells = [
            cell([16, 2], nu)?,
            cell([16, 3], nu)?,
            cell([16, 4], nu)?,
            cell([12, 2, 2], nu)?,
            cell([10, 3, 3], nu)?,
            cell([8, 4, 4], nu)?,
        ];
        let text =
            cells.map(|[limit, border, estimate]| format!(" {limit:.3} / {border:.3} / {estimate:.3} |"));
        println!("| {nu} |{}", text.concat());
        worst = cells.iter().fold(worst, |worst, [_, border, _]| worst.max((border - 1.0).abs()));
    }
    println!("\nlargest distance of a border from the prediction: {:.2} %", 100.0 * worst);
    Ok(())
}

/// The limit of the largest frequency, the border and the estimate over it.
fn cell<const D: usize>(counts: [usize; D], nu: f64) -> Outcome<[f64; 3]> {
    let law = CorotationalHooke::from(Moduli::new((1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu), nu)?);
    let solid = block::<f64, D, _>(counts, [&[], &[]], law, 0.8)?;
    let limit = 2.0 / Stiffness::new(&solid)?.largest_frequency()?;
    Ok([limit, border(&solid, limit, SPEED)?, solid.stability_limit() / limit])
}
