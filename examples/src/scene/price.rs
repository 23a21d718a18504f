//! What each physics costs, by the table of counts that is kept with the benchmarks.

use std::fmt::Write;

/// Counted in a small tank, see `docs/performance.md`; its columns are subject, instructions of a build for tests and of a release, and bytes.
const TABLE: &str = include_str!("../../../benches/counts.csv");
/// What has nothing but pressure, continuity and gravity.
const BARE: &str = "bare";

/// What a particle costs in one step.
#[derive(Clone, Copy, Debug)]
struct Price {
    instructions: f64,
    bytes: f64,
}

/// Physics by the name they have in the table, and the name there of what they are counted on top of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Priced(pub(super) &'static str, pub(super) &'static str);

impl Priced {
    /// What a fluid has for itself.
    pub(super) const fn alone(name: &'static str) -> Self {
        Self(name, BARE)
    }
}

fn price(dimension: usize, name: &str) -> Option<Price> {
    let kind = if dimension == 3 { "3d/f64/" } else { "2d/f64/" };
    let fields = |line: &'static str| {
        let mut fields = line.strip_prefix(kind)?.strip_prefix(name)?.strip_prefix(',')?.split(',').skip(1);
        Some(Price { instructions: fields.next()?.parse().ok()?, bytes: fields.next()?.parse().ok()? })
    };
    TABLE.lines().find_map(fields)
}

/// The price of a fluid with these in this dimension, one a line.
pub(super) fn prices(dimension: usize, active: &[(&str, Priced)]) -> String {
    let mut text = String::new();
    let Some(bare) = price(dimension, BARE) else { return text };
    // Writing into a String cannot fail.
    let _ = writeln!(
        text,
        "price          by the table (f64, rational weight, radius 3, docs/performance.md), a particle of fluid and step: {:.0} instructions and {:.0} bytes for the bare fluid",
        bare.instructions, bare.bytes
    );
    for (what, Priced(name, base)) in active {
        if let (Some(with), Some(without)) = (price(dimension, name), price(dimension, base)) {
            let (instructions, bytes) =
                (with.instructions - without.instructions, with.bytes - without.bytes);
            let each = if *name == "shifting" { ", each part" } else { "" };
            let _ = writeln!(
                text,
                "               {instructions:+.0} instructions, {bytes:+.0} bytes: {what}{each}"
            );
        }
    }
    let _ = writeln!(text, "               what is absent takes none in the loops over pairs");
    text
}

#[cfg(test)]
mod tests {
    use super::{Priced, TABLE, price, prices};

    #[test]
    fn every_price_of_a_plan_is_in_the_table() {
        for name in [
            "bare",
            "walls",
            "no-slip",
            "wall-law",
            "walls+laminar-viscosity",
            "artificial-viscosity",
            "laminar-viscosity",
            "filter-diffusion",
            "hydrostatic-diffusion",
            "collisions",
            "shifting",
            "corrected-sums",
            "density-relaxation",
            "openings",
            "scene",
            "structure",
        ] {
            for dimension in [2, 3] {
                assert!(
                    price(dimension, name)
                        .is_some_and(|price| price.instructions > 100.0 && price.bytes > 100.0),
                    "{name} in {dimension}D"
                );
            }
        }
        // By position, so that another order must not pass unnoticed.
        assert!(TABLE.lines().any(|line| line == "subject,debug,release,bytes"));
        let text = prices(2, &[("collisions (DPC)", Priced::alone("collisions"))]);
        assert!(text.lines().count() == 3 && text.contains(" bytes: collisions (DPC)\n"), "{text}");
    }
}
