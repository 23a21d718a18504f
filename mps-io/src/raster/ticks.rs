//! Round numbers along an axis or a colour bar.

/// Positions and texts of the ticks on a range.
#[derive(Debug, PartialEq)]
pub(crate) struct Ticks {
    pub(crate) values: Vec<f64>,
    pub(crate) labels: Vec<String>,
    /// Labels are in units of `10^exponent`; a multiple of 3, 0 if plain.
    pub(crate) exponent: i32,
}

impl Ticks {
    /// At most `most` ticks at multiples of 1, 2 or 5 times a power of ten within `[low, high]`.
    pub(crate) fn new(low: f64, high: f64, most: usize) -> Self {
        let span = high - low;
        let largest = low.abs().max(high.abs());
        // False also for NaN, and where neighbouring labels would be the same number.
        let usable = span > 1e-10 * largest && (1e-290..1e300).contains(&largest);
        if !usable || most == 0 {
            return Self { values: Vec::new(), labels: Vec::new(), exponent: 0 };
        }
        let power = 10f64.powf((span / most as f64).log10().floor());
        let steps = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0].map(|c| c * power);
        let fits = |step: &f64| multiples(low, high, *step).len() <= most;
        let chosen = steps.iter().position(fits).unwrap_or(steps.len() - 1);
        let (mut step, mut values) = (steps[chosen], multiples(low, high, steps[chosen]));
        if values.len() < 2 && most >= 2 && chosen > 0 {
            // One number tells no scale: take the outermost two of the next finer step.
            step = steps[chosen - 1];
            let finer = multiples(low, high, step);
            values = finer.first().into_iter().chain(finer.last()).copied().collect();
        }
        let exponent = exponent(largest);
        let unit = 10f64.powi(exponent);
        let decimals = (-(step / unit * 1.000_001).log10().floor()).clamp(0.0, 12.0) as usize;
        let labels = values.iter().map(|v| label(v / unit, decimals)).collect();
        Self { values, labels, exponent }
    }

    /// What to add to the label of the axis, for instance `" (×10³)"`; empty if plain.
    pub(crate) fn factor(&self) -> String {
        if self.exponent == 0 {
            return String::new();
        }
        format!(" (×10{})", superscripts(self.exponent))
    }
}

/// The multiples of `step` in `[low, high]`.
fn multiples(low: f64, high: f64, step: f64) -> Vec<f64> {
    // A range end that misses a multiple by rounding still gets its tick.
    let slack = 1e-9 * (high - low) / step;
    let (first, last) = ((low / step - slack).ceil(), (high / step + slack).floor());
    // No more than 1000 whatever the rounding does far from zero.
    (0..1000).map(|k| first + f64::from(k)).take_while(|k| *k <= last).map(|k| k * step).collect()
}

/// Numbers from 0.01 to 99999 are written plainly.
fn exponent(largest: f64) -> i32 {
    if (1e-2..1e5).contains(&largest) || largest == 0.0 {
        return 0;
    }
    3 * ((largest.log10() / 3.0).floor() as i32)
}

fn label(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    // No "-0.0", and the real minus sign, which is as wide as the digits.
    if text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.')) {
        return format!("{:.decimals$}", 0.0);
    }
    text.replace('-', "−")
}

/// `-3` as `⁻³`.
pub(crate) fn superscripts(number: i32) -> String {
    number.to_string().chars().map(superscript).collect()
}

fn superscript(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => digit.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(digit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_numbers_within_the_range() {
        let ticks = Ticks::new(0.0, 1.0, 6);
        assert_eq!(ticks.labels, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        let ticks = Ticks::new(-0.15, 0.15, 8);
        assert_eq!(ticks.labels, ["−0.15", "−0.10", "−0.05", "0.00", "0.05", "0.10", "0.15"]);
    }

    #[test]
    fn large_and_small_numbers_share_a_factor() {
        let ticks = Ticks::new(0.0, 2.0e6, 6);
        assert_eq!((ticks.exponent, ticks.factor().as_str()), (6, " (×10⁶)"));
        assert_eq!(ticks.labels, ["0.0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(Ticks::new(0.0, 4.0e-5, 5).factor(), " (×10⁻⁶)");
    }

    #[test]
    fn never_more_than_asked_for_and_never_outside() {
        for most in 1..12 {
            for k in 0..400 {
                let low = -3.0 + 0.037 * f64::from(k);
                let high = low + 10f64.powf(-4.0 + 0.023 * f64::from(k));
                let ticks = Ticks::new(low, high, most);
                assert!(ticks.values.len() <= most, "{low} {high} {most}: {ticks:?}");
                let slack = 1e-6 * (high - low);
                assert!(ticks.values.iter().all(|v| *v >= low - slack && *v <= high + slack));
                if most >= 2 {
                    assert!(ticks.values.len() >= 2, "{low} {high} {most}: {ticks:?}");
                }
                let mut unique = ticks.labels.clone();
                unique.dedup();
                assert_eq!(unique.len(), ticks.labels.len(), "{low} {high}: {ticks:?}");
            }
        }
    }

    #[test]
    fn ranges_that_are_none_have_no_ticks() {
        for (low, high) in
            [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::INFINITY), (-f64::MAX, f64::MAX)]
        {
            assert!(Ticks::new(low, high, 5).values.is_empty());
        }
    }
}
