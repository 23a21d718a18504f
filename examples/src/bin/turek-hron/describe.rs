//! The run as a scene file.

use crate::geometry::HEIGHT;
use crate::setup::{DENSITY, RAMP, Settings, VISCOSITY};
use mps_examples::solid::flag::{CYLINDER, END, RADIUS, Rubber, THICKNESS, corners};
use mps_io::scene_file::{
    Body, Clamp, Corners, Diffusion, Disc, DisplacementProbe, Elasticity, Fixed, Fluid, ForceProbe,
    InitialPressure, Inlet, Material, Measure, Numerics, Outlet, Output, Packing, PressureForm, Probe,
    Profile, Region, SceneFile, Side, Slip, Solid, Tension, Viscosity, Wall,
};

/// The scene of these settings.
pub(crate) fn scene(settings: &Settings) -> SceneFile {
    let rubber = settings.test.rubber();
    let passage = settings.passage();
    let force = Measure::Force(ForceProbe { on: vec!["cylinder".into(), "flag".into()] });
    let mut scene = SceneFile {
        title: format!(
            "{}: {} mm",
            settings.test.name().to_uppercase(),
            (settings.spacing * 1e5).round() / 1e2
        ),
        end_time: settings.end_time,
        fluid: Some(fluid(settings)),
        walls: walls(settings),
        fixed: vec![Fixed {
            name: "cylinder".into(),
            region: Region::Circle(disc(RADIUS)),
            spacing: None,
            packing: Packing::Rings,
            slip: Slip::None,
        }],
        probes: vec![Probe { name: "drag and lift".into(), measure: force }],
        output: Output {
            probe_interval: Some(0.02 * passage),
            frame_interval: Some(0.4 * passage),
            field_interval: Some(4.0 * passage),
            view: Some(Corners::between([-0.02, -0.02], [1.5, HEIGHT + 0.02])),
            pressure_scale: Some(2.0 * settings.level()).filter(|scale| *scale > 0.0),
            ..Output::default()
        },
        ..SceneFile::default()
    };
    match rubber {
        Some(rubber) => {
            scene.solids.push(elastic(settings, rubber));
            let end = DisplacementProbe { solid: "flag".into(), at: END.into() };
            scene.probes.push(Probe { name: "end".into(), measure: Measure::Displacement(end) });
        }
        None => scene.fixed.push(Fixed {
            name: "flag".into(),
            region: flag(),
            spacing: Some(THICKNESS / settings.across as f64),
            packing: Packing::Rows(disc(RADIUS)),
            slip: Slip::None,
        }),
    }
    scene
}

fn disc(radius: f64) -> Disc {
    Disc { center: CYLINDER.into(), radius }
}

fn flag() -> Region {
    let [lower, upper] = corners();
    Region::between(lower, upper)
}

fn elastic(settings: &Settings, rubber: Rubber) -> Solid {
    let material =
        Material::SaintVenant(Elasticity { youngs_modulus: rubber.young, poissons_ratio: rubber.poisson });
    Solid {
        clamp: Some(Clamp::Disc(disc(RADIUS))),
        slip: Slip::None,
        ..Solid::new("flag", flag(), THICKNESS / settings.across as f64, rubber.density, material)
    }
}

fn fluid(settings: &Settings) -> Fluid {
    let half = 0.5 * THICKNESS;
    let water = Region::Difference(vec![
        Region::between([0.0, 0.0], [settings.length, HEIGHT]),
        Region::Circle(disc(RADIUS + 0.3 * settings.spacing)),
        Region::between([CYLINDER[0], END[1] - half], [END[0], END[1] + half]),
    ]);
    let across = |at: f64| Corners::between([at, 0.0], [at, HEIGHT]);
    Fluid {
        density: DENSITY,
        sound_speed: Some(settings.sound_speed()),
        viscosity: Viscosity::Compact(VISCOSITY),
        numerics: Numerics {
            radius: settings.radius,
            cfl: settings.cfl,
            tension: Tension::Keep,
            collisions: false,
            background_pressure: settings.level(),
            pressure_form: PressureForm::Corrected,
            diffusion: Diffusion::Filter(settings.diffusion),
            shifting: settings.shifting,
            density_relaxation: settings.relaxation,
            ..Numerics::default()
        },
        inlets: vec![Inlet {
            opening: across(0.0),
            toward: Side::Right,
            mean_speed: settings.test.inflow(),
            profile: Profile::Parabola,
            ramp: RAMP,
        }],
        outlets: vec![Outlet {
            opening: across(settings.length),
            toward: Side::Right,
            pressure: None,
            absorbing: true,
        }],
        ..Fluid::new(settings.spacing, vec![Body::new(water, InitialPressure::None)])
    }
}

fn walls(settings: &Settings) -> Vec<Wall> {
    let l0 = settings.spacing;
    let reach = settings.layers() as f64 * l0;
    let (from, to) = (-reach - l0, settings.length + 3.0 * reach);
    let wall =
        |name: &str, low, high| Wall::filling(name, Region::between([from, low], [to, high]), Slip::None);
    vec![wall("floor", -reach, 0.0), wall("ceiling", HEIGHT, HEIGHT + reach)]
}
