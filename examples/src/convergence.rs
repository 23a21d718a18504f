//! How far the curves of a series of runs are apart, and of what order they converge.

/// Times at which two curves are compared.
const TIMES: usize = 2000;

/// A curve over time, in ascending order of its times.
#[derive(Clone, Copy, Debug)]
pub struct Curve<'a> {
    /// \[s\].
    pub time: &'a [f64],
    /// In any unit.
    pub value: &'a [f64],
}

impl Curve<'_> {
    /// The value at `t` by linear interpolation, that of the nearer end outside.
    fn at(&self, t: f64) -> f64 {
        let k = self.time.partition_point(|time| *time < t).clamp(1, self.time.len() - 1);
        let share = (t - self.time[k - 1]) / (self.time[k] - self.time[k - 1]);
        self.value[k - 1] + (self.value[k] - self.value[k - 1]) * share.clamp(0.0, 1.0)
    }
}

/// Root mean square distance of two curves between two times \[s\], of which both have rows. `None` if a curve has fewer than two,
/// or not a value at each of its times.
pub fn distance(a: &Curve<'_>, b: &Curve<'_>, [from, to]: [f64; 2]) -> Option<f64> {
    if [a, b].iter().any(|curve| curve.time.len() < 2 || curve.time.len() != curve.value.len()) {
        return None;
    }
    let times = (0..TIMES).map(|k| from + (to - from) * (k as f64 + 0.5) / TIMES as f64);
    let squares: f64 = times.map(|t| (a.at(t) - b.at(t)).powi(2)).sum();
    Some((squares / TIMES as f64).sqrt())
}

/// The order `p` of an error `h^p` for which three runs with the spacings `h`, of which each is finer than the one before, are as far apart as
/// `distances`: from the first to the second, and from the second to the third. Negative if they diverge; `None` if spacings or distances
/// allow no order.
pub fn order(h: [f64; 3], distances: [f64; 2]) -> Option<f64> {
    /// Nothing converges faster or diverges faster than that.
    const STEEPEST: f64 = 20.0;
    let descending = h[0] > h[1] && h[1] > h[2] && h[2] > 0.0;
    let apart = distances.iter().all(|d| d.is_finite() && *d > 0.0);
    if !(descending && apart) {
        return None;
    }
    let [coarser, finer] = [(h[0] / h[1]).ln(), (h[2] / h[1]).ln()];
    // (h0^p - h1^p)/(h1^p - h2^p), which grows with p.
    let ratio = |p: f64| match p {
        0.0 => coarser / -finer,
        p => (p * coarser).exp_m1() / -(p * finer).exp_m1(),
    };
    let found = distances[0] / distances[1];
    if !(ratio(-STEEPEST)..ratio(STEEPEST)).contains(&found) {
        return None;
    }
    let [mut low, mut high] = [-STEEPEST, STEEPEST];
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if ratio(middle) < found { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sampled(rows: usize, f: impl Fn(f64) -> f64) -> [Vec<f64>; 2] {
        let time: Vec<f64> = (0..rows).map(|k| k as f64 / (rows - 1) as f64).collect();
        let value = time.iter().map(|t| f(*t)).collect();
        [time, value]
    }

    #[test]
    fn curves_with_other_times_are_as_far_apart_as_they_are() {
        let [[ta, a], [tb, b]] = [sampled(101, |t| 3.0 * t), sampled(38, |t| 3.0 * t + 0.5)];
        let (a, b) = (Curve { time: &ta, value: &a }, Curve { time: &tb, value: &b });
        assert!((distance(&a, &b, [0.0, 1.0]).unwrap() - 0.5).abs() < 1e-12);
        let [tc, c] = sampled(3, |t| 3.0 * t + 2.0 * (t - 0.5));
        // A line through zero in the middle: rms of 2 (t - 1/2).
        let c = Curve { time: &tc, value: &c };
        assert!((distance(&a, &c, [0.0, 1.0]).unwrap() - 1.0 / 3f64.sqrt()).abs() < 1e-6);
        assert_eq!(distance(&a, &Curve { time: &ta[..1], value: &a.value[..1] }, [0.0, 1.0]), None);
        assert_eq!(distance(&a, &Curve { time: &ta, value: &a.value[..100] }, [0.0, 1.0]), None);
    }

    proptest! {
        #[test]
        fn the_order_of_an_error_is_found(
            p in -3.0_f64..6.0,
            coarser in 1.1_f64..3.0,
            finer in 1.1_f64..3.0,
            size in 1e-6_f64..10.0,
        ) {
            let h = [coarser, 1.0, 1.0 / finer];
            let error = h.map(|h| size * h.powf(p));
            let apart = [(error[0] - error[1]).abs(), (error[1] - error[2]).abs()];
            // At order zero there is no distance to speak of.
            prop_assume!(p.abs() > 1e-3);
            let found = order(h, apart).unwrap();
            prop_assert!((found - p).abs() < 1e-6, "{found} for {p}");
        }
    }

    #[test]
    fn no_order_is_claimed_where_there_is_none() {
        assert_eq!(order([2.0, 1.0, 1.0], [1.0, 0.5]), None);
        assert_eq!(order([1.0, 2.0, 4.0], [1.0, 0.5]), None);
        assert_eq!(order([4.0, 2.0, 1.0], [1.0, 0.0]), None);
        assert_eq!(order([4.0, 2.0, 1.0], [f64::NAN, 1.0]), None);
        // A ratio of one is no error that shrinks or grows: order zero.
        assert!(order([4.0, 2.0, 1.0], [1.0, 1.0]).unwrap().abs() < 1e-9);
    }
}
