//! Flow between two walls from rest, exactly.

use core::f64::consts::PI;

/// `u/u_max` \[-\] of plane Poiseuille flow at the height `y/L` and the time `nu t/L^2` after a force along the walls has set in:
/// `4 y (1 - y) - sum over odd n of 32/(pi n)^3 sin(n pi y) exp(-n^2 pi^2 t)` (Morris, Fox and Zhu 1997, in these units).
pub fn from_rest(y: f64, time: f64) -> f64 {
    let term = |n: i32| {
        let k = f64::from(2 * n + 1) * PI;
        32.0 / k.powi(3) * (k * y).sin() * (-k * k * time).exp()
    };
    4.0 * y * (1.0 - y) - (0..100).map(term).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::from_rest;

    #[test]
    fn the_series_solves_the_problem() {
        for time in [0.02, 0.1, 0.5] {
            assert!(from_rest(0.0, time).abs() < 1e-12 && from_rest(1.0, time).abs() < 1e-12);
            let h = 1e-3;
            let by_time = (from_rest(0.3, time + 1e-5) - from_rest(0.3, time - 1e-5)) / 2e-5;
            let bend =
                (from_rest(0.3 + h, time) - 2.0 * from_rest(0.3, time) + from_rest(0.3 - h, time)) / (h * h);
            assert!((by_time - (bend + 8.0)).abs() < 1e-4, "{by_time} and {}", bend + 8.0);
        }
        assert!(from_rest(0.4, 0.0).abs() < 1e-5, "at rest first");
        assert!((from_rest(0.5, 0.225) - 0.88798413).abs() < 1e-8);
    }
}
