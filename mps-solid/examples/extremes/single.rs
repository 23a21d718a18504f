//! Single precision beside double.

use crate::Outcome;
use crate::bodies::{block, serial};
use crate::border::border;
use core::f64::consts::PI;
use mps_kernel::{Real, Vector};
use mps_solid::Solid;
use mps_solid::materials::{CorotationalHooke, Moduli};

pub(crate) fn table() -> Outcome<()> {
    println!("\n16x4, free, 4000 sub-steps: f32 against f64\n");
    println!(
        "| nu | limit, f32 over f64 | border f64 | border f32 | energy f64 | energy f32 | largest difference of the places, in spacings |"
    );
    println!("|---|---|---|---|---|---|---|");
    for nu in [-0.4, 0.0, 0.3, 0.47, 0.499, 0.4999] {
        let double = swing::<f64>(nu, None)?;
        let single = swing::<f32>(nu, Some(0.8 * double.limit))?;
        let apart = double.places.iter().zip(&single.places).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        println!(
            "| {nu} | {:.5} | {:.3} | {:.3} | {:.1e} | {:.1e} | {:.1e} |",
            single.limit / double.limit,
            double.border,
            single.border * single.limit / double.limit,
            double.swing,
            single.swing,
            apart,
        );
    }
    Ok(())
}

struct Swing {
    limit: f64,
    border: f64,
    /// Largest change of the energy over the start.
    swing: f64,
    places: Vec<Vector<f64, 2>>,
}

/// A free strip that starts bending, for 4000 sub-steps of `dt`.
fn swing<T: Real>(nu: f64, dt: Option<f64>) -> Outcome<Swing> {
    let modulus = (1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu);
    let law = CorotationalHooke::from(Moduli::new(T::of(modulus), T::of(nu))?);
    let mut solid = block::<T, 2, _>([16, 4], [&[], &[]], law, 0.8)?;
    let limit = solid.stability_limit().to_double();
    let border = border(&solid, limit, 1e-3)?;
    let bent = |x: &Vector<T, 2>| T::of(1e-3 * (PI * x[0].to_double() / 16.0).sin());
    let start: Vec<T> = solid.positions().iter().map(bent).collect();
    for (u, speed) in solid.velocities_mut().iter_mut().zip(start) {
        u[1] = speed;
    }
    let (rest, zero, serial) = (vec![Vector::zeros(); solid.len()], Vector::zeros(), serial());
    let dt = dt.unwrap_or(0.8 * limit);
    let energy = |solid: &Solid<T, 2, _>| solid.energy(&serial, &zero).total().to_double();
    let (energy0, mut most) = (energy(&solid), 0.0_f64);
    for _ in 0..100 {
        solid.advance(&serial, &rest, &zero, T::of(40.0 * dt), 40)?;
        most = most.max((energy(&solid) / energy0 - 1.0).abs());
    }
    let places = solid.positions().iter().map(|x| x.map(Real::to_double)).collect();
    Ok(Swing { limit, border, swing: most, places })
}
