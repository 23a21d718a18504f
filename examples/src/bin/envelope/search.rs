//! Between which values a border is.

use crate::border::{Border, Known, Trial};

/// The search ends when the two sides differ by less than this share.
const WIDTH: f64 = 0.01;

/// What was found.
pub(crate) struct Found {
    /// The value nearest to the border at which the scene is fine; where there is no border, all that were tried.
    pub(crate) fine: Vec<Trial>,
    /// The value nearest to it at which the scene is broken.
    pub(crate) broken: Option<Trial>,
    /// Whether both sides are as they are written down.
    pub(crate) as_known: bool,
}

/// Runs the values that are written down, and nothing else.
pub(crate) fn check(border: &Border, known: Known) -> Found {
    match known {
        Known::Holds(values) | Known::Lasts(values, _) => holds(border, values),
        Known::Between(fine, broken) => {
            let (fine, broken) = (border.run(fine), border.run(broken));
            let as_known = border.is_fine(&fine) && !border.is_fine(&broken);
            Found { fine: vec![fine], broken: Some(broken), as_known }
        }
    }
}

/// Runs values at which all is fine.
fn holds(border: &Border, values: &[f64]) -> Found {
    let fine: Vec<_> = values.iter().map(|value| border.run(*value)).collect();
    let as_known = fine.iter().all(|trial| border.is_fine(trial));
    Found { fine, broken: None, as_known }
}

/// Halves the distance between the two sides, in the logarithm, until they are within 1 % or next to each other; where there is no
/// border, runs also what takes long.
pub(crate) fn locate(border: &Border, known: Known) -> Found {
    if let Known::Lasts(values, long) = known {
        return holds(border, &[values, long].concat());
    }
    let mut found = check(border, known);
    if !found.as_known {
        return found;
    }
    while let (Some(fine), Some(broken)) = (found.fine.last(), &found.broken) {
        let Some(middle) = between(border, fine.value, broken.value) else { break };
        let trial = border.run(middle);
        if border.is_fine(&trial) {
            found.fine = vec![trial];
        } else {
            found.broken = Some(trial);
        }
    }
    found
}

/// The value to try next; `None` if the sides are close enough.
fn between(border: &Border, fine: f64, broken: f64) -> Option<f64> {
    let middle = (fine * broken).sqrt();
    if border.whole {
        let middle = middle.round();
        (middle != fine && middle != broken).then_some(middle)
    } else {
        ((fine / broken).ln().abs() > WIDTH).then_some(middle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::border::Breaks;
    use mps_examples::Failure;

    fn border(scene: fn(f64) -> Result<f64, Failure>, whole: bool) -> Border {
        Border {
            name: "test",
            parameter: "x",
            measure: "y",
            bound: 1.0,
            scene,
            predicted: None,
            whole,
            breaks: Breaks::Error,
            mechanism: "",
            remedy: "",
        }
    }

    #[test]
    fn the_border_is_between_the_two_sides() {
        let found = locate(&border(|x| Ok(x / 2.0), false), Known::Between(1.0, 10.0));
        let (fine, broken) = (found.fine[0].value, found.broken.unwrap().value);
        assert!(found.as_known && fine <= 2.0 && broken > 2.0 && broken / fine < 1.011, "{fine} {broken}");
    }

    #[test]
    fn a_failure_and_what_is_no_number_are_broken() {
        let fails = |x: f64| if x > 3.5 { Err("too much".into()) } else { Ok(0.0) };
        let found = locate(&border(fails, true), Known::Between(1.0, 8.0));
        assert_eq!((found.fine[0].value, found.broken.unwrap().value), (3.0, 4.0));
        let found =
            locate(&border(|x| Ok(if x < 3.5 { f64::NAN } else { 0.0 }), true), Known::Between(8.0, 1.0));
        assert_eq!((found.fine[0].value, found.broken.unwrap().value), (4.0, 3.0));
    }

    #[test]
    fn what_takes_long_is_left_to_the_search() {
        let border = border(|x| Ok(x / 2.0), false);
        let tried = |found: Found| found.fine.iter().map(|trial| trial.value).collect::<Vec<_>>();
        assert_eq!(tried(check(&border, Known::Lasts(&[1.0], &[1.5]))), [1.0]);
        assert_eq!(tried(locate(&border, Known::Lasts(&[1.0], &[1.5]))), [1.0, 1.5]);
        assert!(!locate(&border, Known::Lasts(&[1.0], &[3.0])).as_known);
    }

    #[test]
    fn a_border_that_has_moved_is_noticed() {
        for known in [Known::Between(3.0, 10.0), Known::Between(0.5, 1.0), Known::Holds(&[1.0, 3.0])] {
            assert!(!locate(&border(|x| Ok(x / 2.0), false), known).as_known, "{known:?}");
        }
    }
}
