//! Numbers for people.

/// A number with so many `digits` behind the point, or, where what it belongs to is so small that they would not tell much, with a
/// power of ten: whatever is of the size of `scale`.
///
/// ```
/// assert_eq!(mps_io::number(0.0123, 4, 1.0), "0.0123");
/// assert_eq!(mps_io::number(1.23e-5, 4, 2e-5), "1.2300e-5");
/// ```
pub fn number(x: f64, digits: usize, scale: f64) -> String {
    let small = scale != 0.0 && scale.abs() < 10.0_f64.powi(1 - digits as i32);
    if small && x != 0.0 { format!("{x:.digits$e}") } else { format!("{x:.digits$}") }
}
