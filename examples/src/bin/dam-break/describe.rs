//! The run as a scene file.

use crate::options::Options;
use crate::setup::{
    DENSITY, GRAVITY, HEIGHT, LENGTH, PRESSURE, Release, Settings, Smoothing, TANK, WALL_HEIGHT,
    WALL_SPACING, WALL_VISCOSITY, Walls, bed_length, sound_speed, wall_depth,
};
use crate::{FRAME_INTERVAL, PROBE_INTERVAL};
use mps_examples::Refused;
use mps_examples::scene::form_of;
use mps_io::scene_file::{
    Body, Corners, Diffusion, Fixed, Fluid, FrontProbe, InitialPressure, LevelProbe, Measure, Numerics,
    Output, Packing, PressureProbe, Probe, Region, SceneFile, Slip, Tension, Viscosity, Wall, Way,
};

/// The scene of these settings. The far wall, whose load the program measures, is a fixed body.
///
/// # Errors
/// If the gate is to be lifted, or several runs are asked for.
pub(crate) fn scene(options: &Options, settings: &Settings) -> Result<SceneFile, Refused> {
    let instant = settings.release == Release::Instant;
    let remedy = "a scene cannot put the gate away when it is above the water: give instant";
    Refused::unless(instant, "--release", "lifted", remedy)?;
    let remedy = "a scene is one run: leave it out, and give the flags of the run you mean";
    Refused::unless(!options.stabilisers, "--stabilisers", "given", remedy)?;
    let l0 = settings.spacing;
    let probe = |name: &str, measure| Probe { name: name.into(), measure };
    let front = FrontProbe { start: vec![LENGTH, 0.0], height: 0.1 * HEIGHT, toward: Way::Right };
    Ok(SceneFile {
        title: format!("Dam break, {} mm", l0 * 1e3),
        end_time: settings.end_time,
        gravity: vec![0.0, -GRAVITY],
        fluid: Some(fluid(options, settings)),
        walls: walls(settings),
        fixed: vec![far_wall(settings)],
        probes: vec![
            probe("front", Measure::Front(front)),
            probe(
                "pressure on the far wall",
                Measure::Pressure(PressureProbe { at: vec![TANK, 0.01 * HEIGHT] }),
            ),
            probe("level at the back", Measure::Level(LevelProbe { foot: vec![0.5 * LENGTH, 0.0] })),
        ],
        output: Output {
            probe_interval: Some(PROBE_INTERVAL),
            frame_interval: Some(FRAME_INTERVAL),
            field_interval: Some(FRAME_INTERVAL),
            view: Some(Corners::between([-0.03, -0.03], [TANK + 0.03, 2.0 * HEIGHT])),
            pressure_scale: Some(PRESSURE),
            ..Output::default()
        },
        ..SceneFile::default()
    })
}

fn fluid(options: &Options, settings: &Settings) -> Fluid {
    let numerics = Numerics {
        weight: options.weight.in_a_scene(),
        radius: settings.radius,
        diffusion: match settings.diffusion {
            Smoothing::Filter(delta) => Diffusion::Filter(delta),
            Smoothing::Hydrostatic => Diffusion::Hydrostatic,
        },
        collisions: settings.collisions,
        shifting: settings.shifting,
        cfl: settings.cfl,
        tension: match settings.tension {
            mps_fluid::Tension::Clip => Tension::Clip,
            mps_fluid::Tension::Keep => Tension::Keep,
        },
        pressure_form: form_of(settings.pressure_form),
        ..Numerics::default()
    };
    let column = Body::new(Region::between([0.0, 0.0], [LENGTH, HEIGHT]), InitialPressure::ReleasedColumn);
    let mut water = Fluid::new(settings.spacing, vec![column]);
    if settings.walls == Walls::Law {
        water.wall_viscosity = WALL_VISCOSITY;
    }
    Fluid {
        density: DENSITY,
        sound_speed: Some(sound_speed(settings)),
        viscosity: Viscosity::Artificial(settings.alpha),
        numerics,
        ..water
    }
}

fn slip(settings: &Settings) -> Slip {
    match settings.walls {
        Walls::Law => Slip::Law,
        Walls::Free => Slip::Free,
    }
}

fn walls(settings: &Settings) -> Vec<Wall> {
    let depth = wall_depth(settings);
    let from = TANK - bed_length(settings.spacing, depth);
    let wall =
        |name: &str, region| Wall { fineness: WALL_SPACING, ..Wall::filling(name, region, slip(settings)) };
    vec![
        wall("back", Region::between([-depth, 0.0], [0.0, WALL_HEIGHT])),
        wall("bed", Region::between([from, -depth], [TANK, 0.0])),
    ]
}

fn far_wall(settings: &Settings) -> Fixed {
    let depth = wall_depth(settings);
    Fixed {
        name: "far wall".into(),
        region: Region::between([TANK, -depth], [TANK + depth, WALL_HEIGHT]),
        spacing: Some(WALL_SPACING * settings.spacing),
        packing: Packing::Lattice,
        slip: slip(settings),
    }
}
