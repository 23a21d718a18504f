//! The pressure of the fluid at the start.

use crate::released_column;
use mps_fluid::FluidConfig;
use mps_io::scene_file::{Body, Corners, InitialPressure, Region};
use mps_kernel::{Real, Vector};

/// Pressure of the particles of a body above the background \[Pa\] at the start.
pub(super) fn pressures<T: Real, const D: usize>(
    body: &Body,
    config: &FluidConfig<T, D>,
    places: &[Vector<T, D>],
) -> Vec<T> {
    let none = || vec![T::zero(); places.len()];
    let g = config.gravity.norm();
    let Some(corners) = body.region.bounds() else { return none() };
    let Corners { lower, upper } = &corners;
    match body.pressure {
        InitialPressure::None => none(),
        _ if g == T::zero() => none(),
        InitialPressure::Hydrostatic => {
            let up = -config.gravity / g;
            let top = highest(body, &corners, &up, config.spacing, places);
            places.iter().map(|r| config.density * g * (top - up.dot(r))).collect()
        }
        InitialPressure::ReleasedColumn => {
            let pressure = |r: &Vector<T, D>| {
                let [x, y] = [0, 1].map(|axis| r[axis].to_double() - lower[axis]);
                let [length, height] = [0, 1].map(|axis| upper[axis] - lower[axis]);
                config.density * g * T::of(released_column(height, length, x, y))
            };
            places.iter().map(pressure).collect()
        }
    }
}

/// Height of the surface of a body of fluid \[m\].
///
/// A box reaches up to its highest corner. The box around any other region may have nothing at its corner, or be that of what was
/// there before a part was taken away: there the highest particles know better, half a spacing below the surface.
fn highest<T: Real, const D: usize>(
    body: &Body,
    Corners { lower, upper }: &Corners,
    up: &Vector<T, D>,
    spacing: T,
    places: &[Vector<T, D>],
) -> T {
    let corner: Vector<T, D> =
        Vector::from_fn(|axis, _| T::of(if up[axis] > T::zero() { upper[axis] } else { lower[axis] }));
    let corner = up.dot(&corner);
    if matches!(body.region, Region::Box(_)) {
        return corner;
    }
    let highest = places.iter().map(|r| up.dot(r)).reduce(|a, b| if b > a { b } else { a });
    match highest.map(|height| height + T::of(0.5) * spacing) {
        Some(surface) if surface < corner => surface,
        _ => corner,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::super::lattice::fill;
    use super::super::vectors;
    use super::super::water::config;
    use super::*;
    use mps_io::scene_file::{Source, parse};

    /// Smallest and largest pressure at the start \[Pa\] over that of a spacing, of a body with this region.
    fn range(region: &str, gravity: &str) -> [f64; 2] {
        let text = format!(
            "title = \"water\"\nend_time = 1.0\ngravity = {gravity}\n[fluid]\nspacing = 1e-2\nexpected_speed = 2.0\n\
             [[fluid.bodies]]\nregion = {region}\n"
        );
        let scene = parse(&Source::new("scene.toml", text)).unwrap();
        let fluid = scene.fluid.as_ref().unwrap();
        let config = config::<f64, 2>(fluid, &scene.gravity);
        let body = &fluid.bodies[0];
        let found = pressures(body, &config, &vectors(&fill::<2>(&body.region, fluid.spacing)));
        let unit = config.density * config.gravity.norm() * config.spacing;
        [found.iter().copied().fold(f64::INFINITY, f64::min), found.iter().copied().fold(0.0, f64::max)]
            .map(|pressure| pressure / unit)
    }

    #[test]
    fn water_that_was_cut_is_at_rest_below_its_own_surface() {
        let whole = "{ box = { lower = [0.0, 0.0], upper = [0.2, 0.2] } }";
        let down = "[0.0, -9.81]";
        for taken in [
            "{ half_space = { through = [0.0, 0.1], toward = [0.0, 1.0] } }",
            "{ box = { lower = [0.0, 0.1], upper = [0.2, 0.2] } }",
        ] {
            let [low, high] = range(&format!("{{ difference = [{whole}, {taken}] }}"), down);
            assert!((low - 0.5).abs() < 1e-9 && (high - 9.5).abs() < 1e-9, "{low} {high}");
        }
        let [low, high] = range(whole, down);
        assert!((low - 0.5).abs() < 1e-9 && (high - 19.5).abs() < 1e-9, "{low} {high}");
        // Of a disc the corner of its box is no water: gravity that is inclined sees the disc.
        let disc = "{ circle = { center = [0.1, 0.1], radius = 0.1 } }";
        let [low, high] = range(disc, "[6.0, -6.0]");
        assert!((0.0..0.6).contains(&low) && high < 20.5, "{low} {high}");
    }
}
