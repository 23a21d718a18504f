//! The run as a scene file.

use crate::run::{FIELD, PROBE};
use mps_examples::basin::{FINE, RADIUS_RATIO};
use mps_examples::submerged::{
    BEYOND, CLEARANCE, GRAVITY, LENGTH, POISSON, Settings, THICKNESS, WATER, YOUNG,
};
use mps_io::scene_file::{
    Body, Clamp, Diffusion, DisplacementProbe, Elasticity, Fluid, ForceProbe, InitialPressure, Material,
    Measure, Numerics, Output, Probe, Region, SceneFile, Side, Slip, Solid, Viscosity, Wall,
};

/// The scene of these settings, which ends at `end_time` \[s\].
pub(crate) fn scene(settings: &Settings, end_time: f64) -> SceneFile {
    let end = DisplacementProbe { solid: "beam".into(), at: vec![LENGTH, CLEARANCE + 0.5 * THICKNESS] };
    let force = Measure::Force(ForceProbe { on: vec!["beam".into()] });
    SceneFile {
        title: format!("Beam of {} kg/m3 in water, {} particles across", settings.density, settings.across),
        end_time,
        gravity: vec![0.0, -GRAVITY],
        fluid: Some(water(settings)),
        walls: walls(settings),
        solids: vec![beam(settings)],
        probes: vec![
            Probe { name: "end".into(), measure: Measure::Displacement(end) },
            Probe { name: "water on beam".into(), measure: force },
        ],
        output: Output { probe_interval: Some(PROBE), field_interval: Some(FIELD), ..Output::default() },
        ..SceneFile::default()
    }
}

fn place() -> Region {
    Region::between([0.0, CLEARANCE], [LENGTH, CLEARANCE + THICKNESS])
}

fn water(settings: &Settings) -> Fluid {
    let tank = Region::between([0.0, 0.0], [LENGTH + BEYOND, Settings::depth()]);
    let body = Body::new(Region::Difference(vec![tank, place()]), InitialPressure::Hydrostatic);
    let viscosity = settings.viscosity;
    Fluid {
        density: WATER,
        sound_speed: Some(settings.sound_speed()),
        viscosity: if viscosity > 0.0 { Viscosity::Laminar(viscosity) } else { Viscosity::None },
        numerics: Numerics {
            radius: settings.radius,
            cfl: settings.cfl,
            diffusion: Diffusion::Filter(settings.diffusion),
            collisions: false,
            ..Numerics::default()
        },
        ..Fluid::new(settings.spacing, vec![body])
    }
}

/// A tank, open above.
fn walls(settings: &Settings) -> Vec<Wall> {
    let depth = RADIUS_RATIO * settings.spacing;
    let (width, top) = (LENGTH + BEYOND, settings.top());
    let wall = |name: &str, lower, upper| Wall {
        fineness: 1.0 / FINE as f64,
        ..Wall::filling(name, Region::between(lower, upper), Slip::Free)
    };
    vec![
        wall("floor", [-depth, -depth], [width + depth, 0.0]),
        wall("left wall", [-depth, 0.0], [0.0, top]),
        wall("right wall", [width, 0.0], [width + depth, top]),
    ]
}

fn beam(settings: &Settings) -> Solid {
    let material = Material::SaintVenant(Elasticity { youngs_modulus: YOUNG, poissons_ratio: POISSON });
    Solid {
        clamp: Some(Clamp::Sides(vec![Side::Left])),
        slip: Slip::None,
        damping: settings.damping,
        ..Solid::new("beam", place(), THICKNESS / settings.across as f64, settings.density, material)
    }
}
