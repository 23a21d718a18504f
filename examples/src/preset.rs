//! `--preset`: settings that are worth their cost, found by the program `trade` (`docs/trade.md`).

use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Args, Command, Parser, ValueEnum};
use std::ffi::OsString;

/// The flag; flatten it into the parser of a program that has presets.
#[derive(Args, Clone, Copy, Debug)]
pub struct PresetFlag {
    /// Settings from the measured trade of speed for accuracy (docs/trade.md); flags that are given as well count
    #[arg(long, value_enum)]
    preset: Option<Preset>,
}

/// How much accuracy is to be paid for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Preset {
    /// The cheapest that is still of use: for trying things out
    Fast,
    /// The least that is within the tolerances of the case, or as near as it comes
    Balanced,
    /// As good as what is compared with can tell, or as can be paid for
    Accurate,
}

/// Flags, without their dashes, and their values.
pub type Settings = &'static [(&'static str, &'static str)];

/// Parses the command line of a program whose presets stand for these settings. What the user gives beside a preset counts
/// instead of its part of it.
pub fn parse_with_presets<P: Parser>(settings: impl Fn(Preset) -> Settings) -> P {
    P::parse_from(expanded(&P::command(), std::env::args_os().collect(), settings))
}

/// The arguments with those of the preset among them, if there is one.
fn expanded(command: &Command, given: Vec<OsString>, settings: impl Fn(Preset) -> Settings) -> Vec<OsString> {
    // What is wrong with them is told by the parser that reads them next.
    let Ok(matches) = command.clone().try_get_matches_from(&given) else { return given };
    let Some(preset) = matches.get_one::<Preset>("preset") else { return given };
    let own = settings(*preset).iter().filter(|(flag, _)| !is_given(command, &matches, flag));
    let own = own.map(|(flag, value)| OsString::from(format!("--{flag}={value}")));
    // Behind the name of the program.
    given.iter().take(1).cloned().chain(own).chain(given.iter().skip(1).cloned()).collect()
}

/// Whether the user has given a flag, or one that excludes it.
fn is_given(command: &Command, matches: &ArgMatches, flag: &str) -> bool {
    let given = |id: &str| matches.value_source(id) == Some(ValueSource::CommandLine);
    let Some(arg) = command.get_arguments().find(|arg| arg.get_long() == Some(flag)) else { return false };
    // Either of two flags may be the one that says that they exclude each other.
    let excludes = |one: &Arg, other: &Arg| {
        command.get_arg_conflicts_with(one).iter().any(|excluded| excluded.get_id() == other.get_id())
    };
    command.get_arguments().any(|other| {
        let same = other.get_id() == arg.get_id();
        given(other.get_id().as_str()) && (same || excludes(arg, other) || excludes(other, arg))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[derive(Parser)]
    struct Options {
        #[arg(long, default_value_t = 1.0)]
        sound_ratio: f64,
        #[arg(long, conflicts_with = "spacing")]
        across: Option<u32>,
        #[arg(long)]
        spacing: Option<f64>,
        #[arg(long, conflicts_with = "across")]
        all: bool,
        #[command(flatten)]
        preset: PresetFlag,
    }

    fn settings(preset: Preset) -> Settings {
        match preset {
            Preset::Fast => &[("sound-ratio", "5"), ("across", "4")],
            _ => &[],
        }
    }

    fn parsed(arguments: &[&str]) -> (f64, Option<u32>, Option<f64>, Option<Preset>) {
        let given = ["program"].iter().chain(arguments).map(OsString::from).collect();
        let options = Options::parse_from(expanded(&Options::command(), given, settings));
        (options.sound_ratio, options.across, options.spacing, options.preset.preset)
    }

    #[test]
    fn what_is_given_beside_a_preset_counts() {
        let fast = Some(Preset::Fast);
        assert_eq!(parsed(&[]), (1.0, None, None, None));
        assert_eq!(parsed(&["--preset", "fast"]), (5.0, Some(4), None, fast));
        assert_eq!(parsed(&["--preset", "accurate"]), (1.0, None, None, Some(Preset::Accurate)));
        assert_eq!(parsed(&["--sound-ratio", "7", "--preset", "fast"]), (7.0, Some(4), None, fast));
        // A default that is asked for by name is asked for.
        assert_eq!(parsed(&["--sound-ratio", "1", "--preset=fast"]), (1.0, Some(4), None, fast));
        // One that excludes a part of the preset.
        assert_eq!(parsed(&["--spacing", "2", "--preset", "fast"]), (5.0, None, Some(2.0), fast));
        assert_eq!(parsed(&["--all", "--preset", "fast"]), (5.0, None, None, fast));
    }
}
