//! From numbers to positions along an axis, linear or logarithmic.

use crate::raster::ticks::{Ticks, superscripts};

/// One axis: its range and its ticks.
#[derive(Debug)]
pub(super) struct Scale {
    /// Ends of the axis; of the decimal logarithm, if logarithmic.
    low: f64,
    high: f64,
    logarithmic: bool,
    pub(super) ticks: Ticks,
    /// Ticks without a label.
    pub(super) minor: Vec<f64>,
}

impl Scale {
    /// A scale for `values` with a `margin` beyond them (a fraction of the span), or for `range` if it
    /// is given, with at most `most` labels.
    pub(super) fn new(
        values: impl Iterator<Item = f64>,
        range: Option<(f64, f64)>,
        logarithmic: bool,
        margin: f64,
        most: usize,
    ) -> Option<Self> {
        let usable = |x: &f64| x.is_finite() && x.abs() < 1e290 && (!logarithmic || *x > 1e-290);
        let fixed = range.filter(|(low, high)| usable(low) && usable(high) && low < high);
        let (low, high) = match fixed {
            Some(range) => range,
            None => values
                .filter(usable)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x))),
        };
        if low > high {
            return None;
        }
        let ends = if logarithmic { (low.log10(), high.log10()) } else { (low, high) };
        let (low, high) = if fixed.is_some() { ends } else { with_margin(ends, logarithmic, margin) };
        let (low, high) = if fixed.is_some() || logarithmic { (low, high) } else { snapped(low, high, most) };
        let (ticks, minor) = match logarithmic {
            true => decades(low, high, most),
            false => (Ticks::new(low, high, most), Vec::new()),
        };
        Some(Self { low, high, logarithmic, ticks, minor })
    }

    /// Where `value` lies: 0 at the lower end, 1 at the upper; `None` if it cannot be drawn.
    pub(super) fn share(&self, value: f64) -> Option<f64> {
        let value = if self.logarithmic { value.log10() } else { value };
        let share = (value - self.low) / (self.high - self.low);
        // Far outside points keep the direction of their line and stay harmless as pixels.
        share.is_finite().then(|| share.clamp(-1e3, 1e3))
    }
}

/// Ends with a little room beyond the data. Zero is an end by itself: distances start there.
fn with_margin((low, high): (f64, f64), logarithmic: bool, margin: f64) -> (f64, f64) {
    let span = high - low;
    if span <= 1e-12 * high.abs().max(low.abs()) {
        let half = if logarithmic || high == 0.0 { 0.5 } else { 0.5 * high.abs() };
        return (low - half, high + half);
    }
    let bare = |end: f64| end == 0.0 && !logarithmic;
    let low = if bare(low) { low } else { low - margin * span };
    let high = if bare(high) { high } else { high + margin * span };
    (low, high)
}

/// An end that all but reaches the next tick is moved there: a run to 1 s stops at 0.9999 s.
fn snapped(low: f64, high: f64, most: usize) -> (f64, f64) {
    let span = high - low;
    let ticks = Ticks::new(low, high, most).values;
    let [.., before, last] = ticks[..] else { return (low, high) };
    let step = last - before;
    let next = last + step;
    let previous = ticks[0] - step;
    (
        if low - previous < 0.012 * span { previous } else { low },
        if next - high < 0.012 * span { next } else { high },
    )
}

/// Ticks at powers of ten, on short ranges also at 2 and 5; those between go without label.
fn decades(low: f64, high: f64, most: usize) -> (Ticks, Vec<f64>) {
    let (first, last) = (low.floor() as i32, high.ceil() as i32);
    let inside = |x: &f64| (low - 1e-9..=high + 1e-9).contains(&x.log10());
    // Written as text and read again: 3e-3 and not 0.0030000000000000001.
    let number = |digit: u32, power: i32| format!("{digit}e{power}").parse::<f64>().unwrap_or(f64::NAN);
    let every = |digits: &'static [u32], stride: usize| -> Vec<(u32, i32)> {
        (first..=last)
            .step_by(stride)
            .flat_map(|power| digits.iter().map(move |digit| (*digit, power)))
            .filter(|(digit, power)| inside(&number(*digit, *power)))
            .collect()
    };
    let short = every(&[1, 2, 5], 1);
    let labelled = if short.len() <= most.min(7) {
        short
    } else {
        let stride = every(&[1], 1).len().div_ceil(most.max(1)).max(1);
        every(&[1], stride)
    };
    let label = |(digit, power): &(u32, i32)| {
        let value = number(*digit, *power);
        if (1e-3..1e5).contains(&value) && high - low < 4.0 {
            format!("{value}")
        } else if *digit == 1 {
            format!("10{}", superscripts(*power))
        } else {
            format!("{digit}×10{}", superscripts(*power))
        }
    };
    let ticks = Ticks {
        values: labelled.iter().map(|(digit, power)| number(*digit, *power)).collect(),
        labels: labelled.iter().map(label).collect(),
        exponent: 0,
    };
    let minor = if last - first <= 8 {
        every(&[1, 2, 3, 4, 5, 6, 7, 8, 9], 1).iter().map(|(d, p)| number(*d, *p)).collect()
    } else {
        Vec::new()
    };
    (ticks, minor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_ends_hold_the_data() {
        let scale = Scale::new([0.0, 0.37, 1.93].into_iter(), None, false, 0.04, 6).unwrap();
        assert_eq!(scale.ticks.labels, ["0.0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(scale.share(0.0), Some(0.0));
        assert!(scale.share(1.93).unwrap() < 1.0);
        let fixed = Scale::new([0.5].into_iter(), Some((0.0, 2.0)), false, 0.04, 6).unwrap();
        assert_eq!(fixed.share(0.5), Some(0.25));
    }

    #[test]
    fn an_end_just_before_a_tick_moves_to_it() {
        let scale = Scale::new([0.0, 0.9999].into_iter(), None, false, 0.0, 6).unwrap();
        assert!((scale.share(1.0).unwrap() - 1.0).abs() < 1e-12);
        assert_eq!(scale.ticks.labels.last().unwrap(), "1.0");
        let scale = Scale::new([0.0, 0.95].into_iter(), None, false, 0.0, 6).unwrap();
        assert_eq!(scale.share(0.95), Some(1.0));
    }

    #[test]
    fn logarithmic_ticks() {
        let scale = Scale::new([0.004, 0.02].into_iter(), None, true, 0.0, 7).unwrap();
        assert_eq!(scale.ticks.labels, ["0.005", "0.01", "0.02"]);
        let scale = Scale::new([1e-9, 1.0].into_iter(), None, true, 0.0, 11).unwrap();
        assert_eq!(scale.ticks.labels.first().map(String::as_str), Some("10⁻⁹"));
        assert_eq!(scale.ticks.labels.len(), 10);
        assert_eq!(scale.share(-1.0), None);
    }

    #[test]
    fn nothing_to_scale() {
        assert!(Scale::new([f64::NAN].into_iter(), None, false, 0.0, 5).is_none());
        assert!(Scale::new([-1.0, 0.0].into_iter(), None, true, 0.0, 5).is_none());
        // A fixed range that is none is ignored.
        assert!(Scale::new([1.0].into_iter(), Some((2.0, 1.0)), false, 0.0, 5).is_some());
    }
}
