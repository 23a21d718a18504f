//! Scene files: what is read is what was written, and no text makes a reader panic.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use mps_io::scene_file::{
    Clamp, Corners, InitialPressure, Material, Measure, OnFailure, OnMach, Packing, Profile, Region, Retry,
    SceneError, SceneFile, Side, Slip, Source, Viscosity, Watch, parse, reference, schema,
};
use proptest::prelude::*;

const SCENE: &str = r#"
title = "A gate between two waters"
end_time = 0.5
gravity = [0.0, -9.81]

[fluid]
spacing = 0.005
expected_speed = 2
viscosity = { laminar = 1e-6 }

[[fluid.bodies]]
region = { difference = [
    { box = { lower = [0.0, 0.0], upper = [0.4, 0.3] } },
    { circle = { center = [0.2, 0.1], radius = 0.05 } },
] }

[[fluid.bodies]]
region = { polygon = [[0.5, 0.0], [0.7, 0.0], [0.6, 0.2]] }
pressure = "none"
velocity = [0.0, -1.0]

[fluid.numerics]
diffusion = { filter = 0.2 }

[[walls]]
name = "tank"
shape = { line = [[0.0, 0.4], [0.0, 0.0], [1.0, 0.0]] }
fineness = 0.5
slip = "none"

[[solids]]
name = "gate"
region = { box = { lower = [0.42, 0.0], upper = [0.44, 0.3] } }
spacing = 0.005
density = 1100
material = { neo_hookean = { youngs_modulus = 1e7, poissons_ratio = 0.4 } }
clamp = { sides = ["top"] }

[[probes]]
name = "end of the gate"
measure = { displacement = { solid = "gate", at = [0.44, 0.0] } }

[output]
probe_interval = 1e-3
"#;

fn read(text: &str) -> Result<SceneFile, SceneError> {
    parse(&Source::new("scene.toml", text))
}

#[test]
fn a_scene_is_read_whole_and_written_so_that_it_is_read_again() {
    let scene = read(SCENE).unwrap();
    let fluid = scene.fluid.as_ref().unwrap();
    assert_eq!((fluid.sound(), fluid.density, fluid.numerics.radius), (20.0, 1000.0, 4.0));
    assert_eq!(fluid.viscosity, Viscosity::Laminar(1e-6));
    assert_eq!(fluid.bodies[0].pressure, InitialPressure::Hydrostatic);
    assert!(matches!(&fluid.bodies[0].region, Region::Difference(parts) if parts.len() == 2));
    assert_eq!((scene.walls[0].slip, scene.solids[0].slip), (Slip::None, Slip::Free));
    assert_eq!(scene.solids[0].clamp, Some(Clamp::Sides(vec![Side::Top])));
    assert!(matches!(scene.solids[0].material, Material::NeoHookean(e) if e.poissons_ratio == 0.4));
    assert!(matches!(&scene.probes[0].measure, Measure::Displacement(probe) if probe.solid == "gate"));
    assert_eq!(read(&scene.to_toml().unwrap()).unwrap(), scene);
}

/// What a channel has, in its shortest form: the rest is left to the defaults.
#[test]
fn openings_and_fixed_bodies_are_read_and_written() {
    let channel = r#"
title = "A channel"
end_time = 1.0
fluid = { spacing = 0.1, sound_speed = 10.0, bodies = [{ region = { box = { lower = [0.0, 0.0], upper = [2.0, 1.0] } } }], \
inlets = [{ opening = { lower = [0.0, 0.0], upper = [0.0, 1.0] }, toward = "right", mean_speed = 1.0 }], \
outlets = [{ opening = { lower = [2.0, 0.0], upper = [2.0, 1.0] }, toward = "right" }] }

[[fixed]]
name = "post"
region = { circle = { center = [1.0, 0.5], radius = 0.2 } }
packing = "rings"

[[probes]]
name = "drag"
measure = { force = { on = ["post"] } }
"#;
    let scene = read(&channel.replace("\\\n", "")).unwrap();
    let fluid = scene.fluid.as_ref().unwrap();
    assert_eq!((fluid.inlets[0].profile, fluid.inlets[0].ramp), (Profile::Uniform, 0.0));
    assert!(fluid.outlets[0].absorbing && fluid.outlets[0].pressure.is_none());
    assert_eq!((scene.fixed[0].packing.clone(), scene.fixed[0].spacing), (Packing::Rings, None));
    assert_eq!(read(&scene.to_toml().unwrap()).unwrap(), scene);
    let mean: f64 = (0..1000).map(|k| Profile::Parabola.at((f64::from(k) + 0.5) * 1e-3)).sum::<f64>() * 1e-3;
    assert!((mean - 1.0).abs() < 1e-6 && Profile::Parabola.at(0.5) == Profile::Parabola.largest());
}

#[test]
fn what_a_run_is_watched_for_is_read_and_written_and_refused_where_it_makes_no_sense() {
    assert_eq!(read(SCENE).unwrap().watch, Watch::default());
    let watch = "[watch]\ncollapse = 0.0\nenergy_rise = 0.5\nmach = 0.25\non_mach = \"stop\"\non_failure = { retry = { times = 2 } }\n\
                 region = { lower = [0.0, 0.0], upper = [1.0, 1.0] }\n";
    let scene = read(&[SCENE, watch].concat()).unwrap();
    let wanted = Watch {
        collapse: 0.0,
        energy_rise: Some(0.5),
        mach: 0.25,
        on_mach: OnMach::Stop,
        on_failure: OnFailure::Retry(Retry { steps: 200, times: 2 }),
        region: Some(Corners::between([0.0, 0.0], [1.0, 1.0])),
        ..Watch::default()
    };
    assert_eq!(scene.watch, wanted);
    assert_eq!(read(&scene.to_toml().unwrap()).unwrap(), scene);
    for (from, to, key) in [
        ("collapse = 0.0", "collapse = 0.9", "watch.collapse"),
        ("collapse = 0.0", "steps = 0", "watch.steps"),
        ("energy_rise = 0.5", "energy_rise = -0.5", "watch.energy_rise"),
        ("mach = 0.25", "mach = 0.0", "watch.mach"),
        ("times = 2", "times = 0", "watch.on_failure.retry.times"),
        ("upper = [1.0, 1.0]", "upper = [1.0, -1.0]", "watch.region"),
    ] {
        let text = [SCENE, &watch.replace(from, to)].concat();
        let Err(SceneError::Refused(problems)) = read(&text) else { panic!("{key} is not refused") };
        assert!(problems[0].key.starts_with(key), "{key}: {problems:?}");
    }
}

#[test]
fn walls_with_a_law_are_read_and_written_and_refused_where_it_does_not_hold() {
    let law = SCENE.replace("slip = \"none\"", "slip = \"law\"");
    let scene = read(&law).unwrap();
    assert_eq!((scene.walls[0].slip, scene.fluid.as_ref().unwrap().wall_viscosity), (Slip::Law, 1e-6));
    assert!(!scene.to_toml().unwrap().contains("wall_viscosity"), "the default is left out");
    let thick = law.replace("spacing = 0.005\nexpected", "spacing = 0.005\nwall_viscosity = 3e-6\nexpected");
    let scene = read(&thick).unwrap();
    assert_eq!(read(&scene.to_toml().unwrap()).unwrap(), scene);
    // The law holds up to a quarter of spacing times sound speed.
    let honey = thick.replace("3e-6", "0.03");
    let Err(SceneError::Refused(problems)) = read(&honey) else { panic!("honey is not refused") };
    assert_eq!(problems[0].key, "fluid.wall_viscosity");
    assert!(problems[0].to_string().contains("laminar"), "{}", problems[0]);
    assert!(read(&honey.replace("slip = \"law\"", "slip = \"free\"")).is_ok(), "nobody asks for it");
    let body = law.replace("[[solids]]\n", "[[solids]]\nslip = \"law\"\n");
    let Err(SceneError::Refused(problems)) = read(&body) else { panic!("a body is not refused") };
    assert_eq!(problems[0].key, "solids[0].slip");
}

#[test]
fn every_problem_is_found_at_once() {
    let text = SCENE.replace("end_time = 0.5", "end_time = 0").replace("density = 1100", "density = -1");
    let Err(SceneError::Refused(problems)) = read(&text) else { panic!("not refused") };
    let keys: Vec<_> = problems.iter().map(|problem| (problem.line, problem.key.as_str())).collect();
    assert_eq!(keys, [(3, "end_time"), (35, "solids[0].density")]);
}

#[test]
fn the_schema_knows_every_key_and_says_what_it_means() {
    let schema = schema();
    let fluid = &schema["$defs"]["Fluid"]["properties"];
    assert_eq!(fluid["spacing"]["description"], "Distance of the particles at the start (m)");
    assert_eq!(schema["additionalProperties"], false);
}

/// Words and numbers that are likely to reach the deeper rules.
const SPLINTERS: [&str; 16] = [
    "nan",
    "-inf",
    "1e999",
    "-1",
    "0",
    "1e300",
    "{",
    "]",
    "\"",
    "\n[",
    "= [",
    "box",
    "[[0.0], []]",
    "99999999999999999999",
    "\u{fc}",
    "'''",
];

proptest! {
    #[test]
    fn no_text_makes_the_reader_panic(
        cuts in prop::collection::vec((0..SCENE.len(), 0..12_usize, 0..SPLINTERS.len()), 1..6)
    ) {
        let mut text = SCENE.to_owned();
        for (start, length, splinter) in cuts {
            let from = start.min(text.len());
            let to = (from + length).min(text.len());
            if text.is_char_boundary(from) && text.is_char_boundary(to) {
                text.replace_range(from..to, SPLINTERS[splinter]);
            }
        }
        if let Err(error) = read(&text) {
            prop_assert!(error.to_string().starts_with("scene.toml:"), "{error}");
        }
    }
}

/// To bring the page up to date: `mps schema --reference`, between its two marks.
#[test]
fn the_page_about_scenes_has_every_key() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/scenes.md")).unwrap();
    let (_, rest) = page.split_once("<!-- reference -->\n").unwrap();
    let (written, _) = rest.split_once("<!-- end of reference -->").unwrap();
    assert_eq!(written.trim(), reference().trim());
}

#[test]
fn a_probe_that_has_the_name_of_a_numbered_column_is_refused() {
    let probe = |name: &str| {
        format!(
            "[[probes]]\nname = \"{name}\"\nmeasure = {{ displacement = {{ solid = \"gate\", at = [0.44, 0.0] }} }}\n\n[output]"
        )
    };
    let with = |name: &str| read(&SCENE.replace("[output]", &probe(name)));
    assert!(with("end of the gate 2 m").is_ok() && with("start 2").is_ok());
    let said = with("end of the gate 2").unwrap_err().to_string();
    assert!(said.contains("is \"end of the gate 2\": a column of the probe without the number"), "{said}");
}
