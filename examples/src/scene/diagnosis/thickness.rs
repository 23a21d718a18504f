//! Parts too thin to part the fluid on their two sides, and bodies too thin for their particles.

use super::super::Layout;
use super::super::lattice::Place;
use super::Diagnosis;
use mps_io::scene_file::{Corners, Disc, Fluid, Region, SceneFile, Shape, Source, Weight};

/// Particles across a body that give its bending stiffness to some percent.
const ACROSS: f64 = 3.5;
/// Something thinner than this many spacings of the fluid is refused where more are needed: each side feels the other strongly. What is
/// round and made of straight pieces is a little thinner than its two spacings.
const THIN: f64 = 1.9;
/// Most particles of a body that are asked how deep they are.
const SAMPLES: usize = 200;
/// Most steps to the deepest place of a body, and how exactly it is found, over the spacing.
const STEPS: usize = 100;
const EXACT: f64 = 1e-3;

/// Spacings that something has to be thick to part this fluid: what smooth weights let its two sides see of each other is too much
/// for the density, peaked ones hardly see beyond the next particle.
fn needed(fluid: &Fluid) -> f64 {
    match fluid.numerics.weight {
        Weight::Rational => 1.0,
        Weight::Smooth | Weight::Wendland => (fluid.numerics.radius - 1.0).max(1.0),
    }
}

/// Walls and bodies with fluid on both sides.
pub(super) fn thickness<const D: usize>(
    scene: &SceneFile,
    source: &Source,
    layout: &Layout<D>,
    found: &mut Diagnosis,
) {
    let solids: Vec<f64> = scene
        .solids
        .iter()
        .zip(&layout.solids)
        .map(|(solid, points)| {
            let places: Vec<Place<D>> = points.iter().map(|(place, _)| *place).collect();
            thick(&solid.region, &places, solid.spacing)
        })
        .collect();
    if let Some(fluid) = &scene.fluid {
        let l0 = fluid.spacing;
        let mut parts = Vec::new();
        for (k, (wall, points)) in scene.walls.iter().zip(&layout.walls).enumerate() {
            if let (Shape::Region(region), Some(points)) = (&wall.shape, points.first()) {
                let thin = thick(region, &points.places, wall.fineness * l0);
                parts.push((thin, format!("walls[{k}].shape.region")));
            }
        }
        parts.extend(solids.iter().enumerate().map(|(k, thin)| (*thin, format!("solids[{k}].region"))));
        for (k, (body, points)) in scene.fixed.iter().zip(&layout.fixed).enumerate() {
            let thin = thick(&body.region, &points.places, points.spacing);
            parts.push((thin, format!("fixed[{k}].region")));
        }
        for (thin, key) in parts {
            parting(fluid, thin, &key, source, found);
        }
    }
    for (k, (solid, thin)) in scene.solids.iter().zip(solids).enumerate() {
        let across = thin / solid.spacing;
        found.across.push(across);
        if across < ACROSS {
            let what = format!("makes {across:.1} particles across the thinnest side");
            let remedy = format!(
                "give at most {:.3e}: 4 across are usual, 8 for errors below a percent",
                solid.spacing * across / 4.0
            );
            found.warnings.push(source.problem(&format!("solids[{k}].spacing"), what, remedy));
        }
    }
}

/// Says what is too thin \[m\] to part the fluid.
fn parting(fluid: &Fluid, thin: f64, key: &str, source: &Source, found: &mut Diagnosis) {
    let (l0, need) = (fluid.spacing, needed(fluid));
    let below = |spacings: f64| thin < spacings * l0 * (1.0 - 1e-9);
    if below(need) {
        let what = format!("is {:.2} particles of the fluid thick and needs at least {need}", thin / l0);
        let remedy = format!("make it thicker, or give fluid.spacing at most {:.3e}", thin / need);
        let problem = source.problem(key, what, remedy);
        let list = if below(need.min(THIN)) { &mut found.refusals } else { &mut found.warnings };
        list.push(problem);
    }
}

/// How thick a region is across, where it is thickest \[m\]: twice as deep as its deepest place, whichever way it lies.
/// `places` are its particles, a `spacing` \[m\] apart.
fn thick<const D: usize>(region: &Region, places: &[Place<D>], spacing: f64) -> f64 {
    match region {
        Region::Circle(Disc { radius, .. }) | Region::Ball(Disc { radius, .. }) => 2.0 * radius,
        Region::Box(_) => shortest_side(region),
        _ => deepest(region, places, spacing).map_or_else(|| shortest_side(region), |depth| 2.0 * depth),
    }
}

/// Length of the shortest side of the box around a region \[m\].
fn shortest_side(region: &Region) -> f64 {
    let Some(Corners { lower, upper }) = region.bounds() else { return 0.0 };
    lower.iter().zip(&upper).map(|(low, high)| high - low).fold(f64::INFINITY, f64::min)
}

/// How deep the deepest place of a region is \[m\]: from the deepest particle on uphill, as long as it gets deeper.
fn deepest<const D: usize>(region: &Region, places: &[Place<D>], spacing: f64) -> Option<f64> {
    let surface = region.surface()?;
    let depth = |place: Place<D>| Some((surface.nearest(&place)?.depth, place));
    let deeper = |a: &(f64, Place<D>), b: &(f64, Place<D>)| a.0.total_cmp(&b.0);
    let sampled = places.iter().step_by(places.len() / SAMPLES + 1);
    let mut best = sampled.filter_map(|place| depth(*place)).max_by(deeper)?;
    let mut step = spacing;
    for _ in 0..STEPS {
        let around = directions::<D>()
            .filter_map(|way| depth(core::array::from_fn(|axis| best.1[axis] + step * way[axis])));
        match around.max_by(deeper) {
            Some(next) if next.0 > best.0 => best = next,
            _ if step < EXACT * spacing => break,
            _ => step *= 0.5,
        }
    }
    Some(best.0)
}

/// To all neighbours of a cell, those at its corners included.
fn directions<const D: usize>() -> impl Iterator<Item = [f64; D]> {
    (0..3_i32.pow(D as u32)).map(|mut k| {
        core::array::from_fn(|_| {
            let here = f64::from(k % 3 - 1);
            k /= 3;
            here
        })
    })
}

#[cfg(test)]
mod tests {
    use super::super::super::lattice::fill;
    use super::*;
    use mps_io::scene_file::Tube;

    fn thick_of<const D: usize>(region: &Region, spacing: f64) -> f64 {
        thick(region, &fill::<D>(region, spacing), spacing)
    }

    #[test]
    fn a_plate_is_as_thick_however_it_lies() {
        for degrees in [0.0_f64, 7.0, 30.0, 45.0] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let corners = [[0.0, 0.0], [0.2, 0.0], [0.2, 0.02], [0.0, 0.02]];
            let turned = corners.map(|[x, y]| vec![cosine * x - sine * y, sine * x + cosine * y]);
            for spacing in [5e-3, 1e-2] {
                let found = thick_of::<2>(&Region::Polygon(turned.to_vec()), spacing);
                assert!((found / 0.02 - 1.0).abs() < 2e-3, "{degrees} {spacing} {found}");
            }
        }
    }

    #[test]
    fn what_is_left_of_a_cut_is_as_thick_as_it_is() {
        let whole = Region::between([0.0, 0.0], [0.2, 0.1]);
        let half = Region::Difference(vec![whole.clone(), Region::between([0.0, 0.02], [0.2, 0.1])]);
        assert!((thick_of::<2>(&half, 4e-3) / 0.02 - 1.0).abs() < 2e-3);
        let tube = Tube { from: vec![0.0, 0.0, 0.0], to: vec![0.1, 0.08, 0.05], radius: 0.02 };
        assert!((thick_of::<3>(&Region::Cylinder(tube), 5e-3) / 0.04 - 1.0).abs() < 5e-3);
    }
}
