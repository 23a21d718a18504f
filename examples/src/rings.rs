//! Points in rings.

use core::f64::consts::TAU;

/// Points in concentric rings inside a circle of this `radius` \[m\], about `spacing` \[m\] apart, the outermost ring half a spacing inside,
/// as many rings as `layers` or as there is room for; with the area of each point \[m^2\]. The surface they stand for is round, where
/// that of a lattice has steps.
pub fn rings(center: [f64; 2], radius: f64, spacing: f64, layers: usize) -> (Vec<[f64; 2]>, Vec<f64>) {
    let (mut places, mut areas) = (Vec::new(), Vec::new());
    for layer in 0..layers {
        let radius = radius - (layer as f64 + 0.5) * spacing;
        if radius <= 0.0 {
            break;
        }
        let around = TAU * radius;
        let count = (around / spacing).round().max(1.0);
        for k in 0..count as usize {
            let angle = TAU * (k as f64 + 0.5) / count;
            places.push([center[0] + radius * angle.cos(), center[1] + radius * angle.sin()]);
            areas.push(around * spacing / count);
        }
    }
    (places, areas)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_have_the_area_of_the_disc_and_their_outermost_points_one_distance_from_its_surface() {
        let (places, areas) = rings([0.3, -0.2], 1.0, 0.1, 100);
        assert!((areas.iter().sum::<f64>() / core::f64::consts::PI - 1.0).abs() < 1e-12);
        let off = |p: &[f64; 2]| (p[0] - 0.3).hypot(p[1] + 0.2);
        let outermost = places.iter().filter(|p| off(p) > 0.9);
        assert_eq!(outermost.clone().count(), 60);
        assert!(outermost.into_iter().all(|p| (off(p) - 0.95).abs() < 1e-12));
        let (few, _) = rings([0.3, -0.2], 1.0, 0.1, 2);
        assert!(few.iter().all(|p| off(p) > 0.8) && few[..] == places[..few.len()]);
    }
}
