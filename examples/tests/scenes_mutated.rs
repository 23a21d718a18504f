//! Whatever becomes of the text of a scene, it is read and examined, or refused, without a panic.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_examples::scene::Examined;
use mps_io::scene_file::{Source, parse};
use proptest::prelude::*;

const SCENES: [&str; 6] = [
    include_str!("../scenes/dam-break-3d.toml"),
    include_str!("../scenes/two-reservoirs.toml"),
    include_str!("../scenes/heavy-beam.toml"),
    include_str!("../scenes/falling-drop.toml"),
    include_str!("../scenes/turek-hron.toml"),
    include_str!("../scenes/turek-hron-rigid.toml"),
];

/// What a number may become.
const NUMBERS: [&str; 12] =
    ["0", "-1", "1e-2", "0.05", "0.4", "3", "1e3", "-0.2", "nan", "1e300", "\"a\"", "[0.1, 0.2]"];

/// Replaces the `which`-th number of a text.
fn replace_number(text: &str, which: usize, by: &str) -> String {
    let numeric = |c: char| c.is_ascii_digit() || ".-e".contains(c);
    let starts: Vec<usize> = text
        .char_indices()
        .filter(|&(at, c)| {
            let before = text[..at].chars().next_back().unwrap_or(' ');
            (c.is_ascii_digit() || c == '-') && " [".contains(before)
        })
        .map(|(at, _)| at)
        .collect();
    let start = starts[which % starts.len()];
    let end = text[start..].find(|c| !numeric(c)).map_or(text.len(), |length| start + length);
    format!("{}{by}{}", &text[..start], &text[end..])
}

/// `PROPTEST_CASES` if it is set.
fn cases(usual: u32) -> u32 {
    std::env::var("PROPTEST_CASES").map_or(usual, |cases| cases.parse().unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(200), ..ProptestConfig::default() })]
    #[test]
    fn a_scene_with_other_numbers_is_good_or_refused(
        scene in 0..SCENES.len(), changes in prop::collection::vec((0..60_usize, 0..NUMBERS.len()), 1..4)
    ) {
        let mut text = SCENES[scene].to_owned();
        for (which, number) in changes {
            text = replace_number(&text, which, NUMBERS[number]);
        }
        let source = Source::new("scene.toml", text);
        if let Ok(scene) = parse(&source)
            && let Ok(examined) = Examined::new(scene, &source)
        {
            let found = examined.diagnosis();
            for problem in found.refusals.iter().chain(&found.warnings) {
                prop_assert!(problem.line > 0 && !problem.remedy.is_empty());
            }
        }
    }
}
