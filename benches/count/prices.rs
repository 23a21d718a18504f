//! The tables of prices in `docs/performance.md`.

use crate::Failure;
use crate::check::{PROFILE, kept};
use mps_benches::counting::{Entry, Physics, Table, entries};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::Instant;

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/performance.md");
const BEGIN: &str = "<!-- written by `count prices` -->\n";
const END: &str = "<!-- end of what is written -->\n";
/// A measurement takes this long at least \[s\].
const LONG: f64 = 0.1;
/// The shortest of so many measurements counts: noise only adds.
const TRIES: usize = 4;

/// Writes the tables.
pub(crate) fn write() -> Result<(), Failure> {
    if PROFILE != "release" {
        return Err(format!("this is a {PROFILE} build: prices are those of a release build").into());
    }
    let prices =
        Prices { times: entries().iter().map(|e| (e.name.clone(), nanoseconds(e))).collect(), kept: kept()? };
    let page = std::fs::read_to_string(PAGE)?;
    let place = page.split_once(BEGIN).and_then(|(before, rest)| Some((before, rest.split_once(END)?.1)));
    let (before, after) = place.ok_or_else(|| format!("{PAGE} has no lines {BEGIN} and {END}"))?;
    let with = prices.kept.builds.get(PROFILE).map_or("no count", String::as_str);
    let text = format!(
        "Times: {}, one thread. Instructions: {with}.\n\n{}\n{}",
        processor(),
        prices.physics(),
        prices.parts()
    );
    std::fs::write(PAGE, format!("{before}{BEGIN}\n{text}\n{END}{after}"))?;
    println!("{PAGE} has new tables");
    Ok(())
}

/// Nanoseconds a particle and step.
fn nanoseconds(entry: &Entry) -> f64 {
    let mut subject = (entry.make)();
    let shortest = (0..TRIES).map(|_| {
        let (clock, mut steps) = (Clock::start(), 0_u32);
        while clock.seconds() < LONG {
            (subject.step)();
            steps += 1;
        }
        clock.seconds() / f64::from(steps)
    });
    shortest.fold(f64::INFINITY, f64::min) * 1e9 / subject.particles as f64
}

/// The time this thread has been given by a processor where the system tells it, else the time of the wall.
struct Clock {
    wall: Instant,
    given: Option<u64>,
}

impl Clock {
    fn start() -> Self {
        Self { wall: Instant::now(), given: Self::given() }
    }

    /// Nanoseconds, the first number of a line of the kernel.
    fn given() -> Option<u64> {
        std::fs::read_to_string("/proc/thread-self/schedstat").ok()?.split(' ').next()?.parse().ok()
    }

    fn seconds(&self) -> f64 {
        match (self.given, Self::given()) {
            (Some(before), Some(now)) => (now - before) as f64 * 1e-9,
            _ => self.wall.elapsed().as_secs_f64(),
        }
    }
}

fn processor() -> String {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model =
        cpu.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": ").map(|(_, name)| name));
    model.unwrap_or(std::env::consts::ARCH).to_owned()
}

struct Prices {
    /// Nanoseconds a particle and step, by subject.
    times: BTreeMap<String, f64>,
    kept: Table,
}

impl Prices {
    /// Time, instructions and bytes a particle of a subject.
    fn of(&self, name: &str) -> Option<[f64; 3]> {
        let row = self.kept.row(name)?;
        Some([*self.times.get(name)?, *row.instructions.get(PROFILE)?, row.bytes])
    }

    /// One row: a whole step, or what it costs more than its base.
    fn row(&self, label: &str, name: &str, base: Option<&str>) -> String {
        let mut line = format!("| {label} |");
        for prefix in ["2d/f64", "3d/f64"] {
            let whole = |name: &str| self.of(&format!("{prefix}/{name}"));
            let price = match (whole(name), base.map(whole)) {
                (Some(price), None) => price.map(|x| format!("{x:.0}")),
                (Some(price), Some(Some(base))) => [0, 1, 2].map(|k| format!("{:+.0}", price[k] - base[k])),
                _ => [const { String::new() }; 3],
            };
            let _ = write!(line, " {} |", price.join(" | "));
        }
        line + "\n"
    }

    fn physics(&self) -> String {
        let mut text =
            "| a particle and step | 2D ns | instructions | bytes | 3D ns | instructions | bytes |\n\
                        |---|---|---|---|---|---|---|\n"
                .to_owned();
        text += &self.row("pressure, continuity and gravity alone", "bare", None);
        for physics in Physics::ALL {
            text += &self.row(&format!("with {}", physics.name()), physics.name(), Some(physics.base()));
        }
        text += &self.row("with a scene that has no structure", "scene", Some("bare"));
        text + &self.row("what the elastic gate has, without the gate", "gate", None)
    }

    fn parts(&self) -> String {
        let mut text = "| a particle | 2D f64 ns | instructions | 2D f32 ns | instructions | 3D f64 ns | instructions |\n\
                        |---|---|---|---|---|---|---|\n"
            .to_owned();
        for (label, part) in [
            ("bare step", "bare"),
            ("step of the gate", "gate"),
            ("momentum half", "sweep/momentum"),
            ("both halves", "sweep/halves"),
            ("packing", "sweep/packing"),
            ("cells, order, permutation", "search/sort"),
            ("rows up to `3.3 l0`", "search/rows"),
            ("solid: forces", "solid/force"),
            ("solid: sub-step", "solid/sub-step"),
        ] {
            let _ = write!(text, "| {label} |");
            for prefix in ["2d/f64", "2d/f32", "3d/f64"] {
                let _ = match self.of(&format!("{prefix}/{part}")) {
                    Some([time, instructions, _]) => write!(text, " {time:.0} | {instructions:.0} |"),
                    None => write!(text, " | |"),
                };
            }
            text.push('\n');
        }
        text
    }
}
