//! Counts everything and holds it against the table, or writes the table.

use crate::{Failure, memory};
use mps_benches::counting::{Row, Table, available, differences, entries, instruction_set, per_step};
use std::path::Path;

/// The table in the repository.
pub(crate) const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/counts.csv");
/// The profile this program was built with.
pub(crate) const PROFILE: &str = env!("MPS_PROFILE");
const RUSTC: &str = env!("MPS_RUSTC");

/// The table as it is kept.
pub(crate) fn kept() -> Result<Table, Failure> {
    let text = std::fs::read_to_string(TABLE).map_err(|error| format!("could not read {TABLE}: {error}"))?;
    Ok(Table::parse(&text)?)
}

/// Fails if a count differs from the one that is kept.
pub(crate) fn check() -> Result<(), Failure> {
    if !available() {
        println!(
            "NOT COUNTED: there is no valgrind here (Debian: apt install valgrind). Nothing was checked."
        );
        return Ok(());
    }
    let (kept, now) = (kept()?, count()?);
    let found = differences(&kept, &now, PROFILE);
    found.iter().for_each(|difference| println!("{difference}"));
    let (before, with) = (kept.builds.get(PROFILE), now.builds.get(PROFILE));
    if before != with {
        println!(
            "NOT HELD: {TABLE} was counted with {before:?}, this is {with:?}. {} of {} counts differ by more than 2 %. To \
             go on with this compiler, run `count store` where nothing else has changed, and commit the table by itself.",
            found.len(),
            now.rows.len(),
        );
        return Ok(());
    }
    if found.is_empty() {
        println!("{} counts are within 2 % of {TABLE}", now.rows.len());
        return Ok(());
    }
    let advice = "a rise wants a reason or a remedy, and either way `count store` with this profile writes the new counts";
    Err(format!("{} counts differ by more than 2 % from {TABLE}: {advice}", found.len()).into())
}

/// Writes the counts of this profile into the table.
pub(crate) fn store() -> Result<(), Failure> {
    let mut table = count()?;
    if Path::new(TABLE).exists() {
        let kept = kept()?;
        for (profile, with) in kept.builds {
            table.builds.entry(profile).or_insert(with);
        }
        for (name, row) in &mut table.rows {
            let before = kept.rows.iter().find(|(kept, _)| kept == name);
            for (profile, count) in before.iter().flat_map(|(_, row)| &row.instructions) {
                row.instructions.entry(profile.clone()).or_insert(*count);
            }
        }
    }
    std::fs::write(TABLE, table.text())?;
    println!("{} counts written to {TABLE}", table.rows.len());
    Ok(())
}

/// Counts everything, with the instructions of this profile alone.
fn count() -> Result<Table, Failure> {
    let program = std::env::current_exe()?;
    let mut table = Table::default();
    let with = format!("{RUSTC}, {}", instruction_set(&program)?);
    table.builds.insert(PROFILE.to_owned(), with);
    for entry in entries() {
        let before = memory::held();
        let subject = (entry.make)();
        let particles = subject.particles as f64;
        let bytes = (memory::held() - before) as f64 / particles;
        drop(subject);
        let count = per_step(&program, &entry.name)?.total / particles;
        let row = Row { instructions: [(PROFILE.to_owned(), count)].into(), bytes };
        table.rows.push((entry.name, row));
    }
    Ok(table)
}
