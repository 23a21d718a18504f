//! The pressure in a column of water at the moment its gate is gone.

/// Pressure over `rho g` \[m\] at (`x`, `y`) \[m\] from the lower left corner of a column of this `height` and `length`
/// \[m\], at the moment its right side is let go: harmonic, zero on both open faces, and with the slopes of a fluid at
/// rest on the bed and the back wall.
///
/// Started with the pressure it had behind the gate, the water would first have to become rid of the difference as
/// sound of up to `rho g H`, which rings in the tank until the end.
pub fn released_column(height: f64, length: f64, x: f64, y: f64) -> f64 {
    const TERMS: u32 = 400;
    let series: f64 = (0..TERMS)
        .map(|n| {
            let m = std::f64::consts::PI * f64::from(2 * n + 1);
            let k = m / (2.0 * height);
            // cosh(k x)/cosh(k L), which would overflow
            let ratio =
                ((k * (x - length)).exp() + (-k * (x + length)).exp()) / (1.0 + (-2.0 * k * length).exp());
            8.0 * height / (m * m) * (k * y).cos() * ratio
        })
        .sum();
    height - y - series
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pressure_when_released_is_harmonic_and_vanishes_where_the_column_is_open() {
        let (height, length, step) = (0.6, 1.2, 1e-3);
        let p = |x: f64, y: f64| released_column(height, length, x, y);
        for (x, y) in [(0.3, 0.2), (0.9, 0.4), (1.1, 0.1)] {
            let laplace = p(x + step, y) + p(x - step, y) + p(x, y + step) + p(x, y - step) - 4.0 * p(x, y);
            assert!(laplace.abs() < 1e-7 * height, "{laplace}");
            assert!(p(x, height).abs() < 1e-9 * height && p(length, y).abs() < 2e-4 * height);
            // Slopes of rest on the bed and none across the back wall.
            let slope = (p(x, step) - p(x, 0.0)) / step;
            assert!((slope + 1.0).abs() < 5e-3, "{slope}");
            assert!((p(step, y) - p(0.0, y)).abs() < 1e-4 * height);
        }
        // Far from the gate it is that of the column at rest.
        let weight = height - 0.1;
        assert!((p(0.0, 0.1) / weight - 1.0).abs() < 0.1);
    }
}
