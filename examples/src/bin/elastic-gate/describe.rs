//! The run as a scene file.

use crate::options::Options;
use crate::setup::{
    GATE_LENGTH, GATE_THICKNESS, GRAVITY, RESERVOIR_WIDTH, Settings, WALL_HEIGHT, WATER_DEPTH, run_out,
    sound_speed, wall_depth,
};
use crate::{FIELD_INTERVAL, FRAME_INTERVAL, PROBE_INTERVAL, SNAPSHOT_INTERVAL};
use mps_examples::Refused;
use mps_examples::scene::form_of;
use mps_io::scene_file::{
    Body, Clamp, Corners, Diffusion, DisplacementProbe, Elasticity, Fluid, InitialPressure, Material,
    Measure, Numerics, Output, Probe, Region, SceneFile, Side, Slip, Solid, Viscosity, Wall,
};

/// The scene of these settings.
///
/// # Errors
/// If earlier runs are to be drawn beside it, or it has sub-steps that stability does not ask for.
pub(crate) fn scene(options: &Options, settings: &Settings) -> Result<SceneFile, Refused> {
    let alone = options.beside.is_empty();
    let remedy = "a scene knows nothing of other runs: leave it out of --print-scene";
    Refused::unless(alone, "--beside", "given", remedy)?;
    let remedy = "a scene takes as many as stability asks for: leave it out of --print-scene";
    Refused::unless(settings.min_substeps == 1, "--min-substeps", settings.min_substeps, remedy)?;
    Ok(SceneFile {
        title: format!("Dam break through an elastic gate, {}", options.material.name()),
        end_time: settings.end_time,
        gravity: vec![0.0, -GRAVITY],
        fluid: Some(fluid(options, settings)),
        walls: walls(settings),
        solids: vec![gate(settings)],
        probes: vec![
            displacement("gate corner", [RESERVOIR_WIDTH + GATE_THICKNESS, 0.0]),
            displacement("gate middle", [RESERVOIR_WIDTH + 0.5 * GATE_THICKNESS, 0.0]),
        ],
        output: Output {
            probe_interval: Some(PROBE_INTERVAL),
            frame_interval: Some(FRAME_INTERVAL),
            field_interval: Some(FIELD_INTERVAL),
            picture_interval: Some(SNAPSHOT_INTERVAL),
            view: Some(Corners::between([-6e-3, -6e-3], [2.6 * RESERVOIR_WIDTH, WALL_HEIGHT - 18e-3])),
            strain_scale: Some(0.15),
            ..Output::default()
        },
        ..SceneFile::default()
    })
}

fn fluid(options: &Options, settings: &Settings) -> Fluid {
    let numerics = Numerics {
        weight: options.weight.in_a_scene(),
        radius: settings.radius,
        diffusion: Diffusion::Filter(settings.diffusion),
        collisions: settings.collisions,
        shifting: settings.shifting,
        cfl: settings.cfl,
        pressure_form: form_of(settings.pressure_form),
        ..Numerics::default()
    };
    let body =
        Body::new(Region::between([0.0, 0.0], [RESERVOIR_WIDTH, WATER_DEPTH]), InitialPressure::Hydrostatic);
    Fluid {
        sound_speed: Some(sound_speed(settings)),
        viscosity: Viscosity::Artificial(settings.alpha),
        numerics,
        ..Fluid::new(settings.spacing, vec![body])
    }
}

fn walls(settings: &Settings) -> Vec<Wall> {
    let depth = wall_depth(settings);
    let right = RESERVOIR_WIDTH + GATE_THICKNESS + run_out(settings);
    let hanger = [RESERVOIR_WIDTH + GATE_THICKNESS.max(depth), WALL_HEIGHT];
    let wall = |name: &str, region| Wall::filling(name, region, Slip::Free);
    vec![
        wall("left wall", Region::between([-depth, 0.0], [0.0, WALL_HEIGHT])),
        wall("floor", Region::between([-depth, -depth], [right, 0.0])),
        wall("wall above the gate", Region::between([RESERVOIR_WIDTH, GATE_LENGTH], hanger)),
    ]
}

fn gate(settings: &Settings) -> Solid {
    let right = RESERVOIR_WIDTH + GATE_THICKNESS;
    let region = Region::between([RESERVOIR_WIDTH, 0.0], [right, GATE_LENGTH]);
    let material = Material::Corotational(Elasticity {
        youngs_modulus: settings.rubber.youngs_modulus,
        poissons_ratio: settings.rubber.poissons_ratio,
    });
    let spacing = GATE_THICKNESS / settings.across as f64;
    Solid {
        clamp: Some(Clamp::Sides(vec![Side::Top])),
        ..Solid::new("gate", region, spacing, settings.rubber.density, material)
    }
}

fn displacement(name: &str, at: [f64; 2]) -> Probe {
    let measure = Measure::Displacement(DisplacementProbe { solid: "gate".into(), at: at.into() });
    Probe { name: name.into(), measure }
}
