//! CSM3 as a scene file.

use crate::csm3::{FRAMES, PERIOD, SAMPLES};
use crate::options::Test;
use crate::{Settings, look};
use mps_examples::Refused;
use mps_examples::solid::flag::{self, CYLINDER, END, GRAVITY, RADIUS, RUBBER, THICKNESS};
use mps_io::scene_file::{
    Clamp, Corners, Disc, DisplacementProbe, Elasticity, Material, Measure, Output, Probe, Region, SceneFile,
    Side, Solid,
};

/// The scene of these settings.
///
/// # Errors
/// If it is the flag at rest: the run of a scene is a motion.
pub(crate) fn scene(test: Test, settings: &Settings) -> Result<SceneFile, Refused> {
    let remedy = "a scene moves and does not look for rest: give --test csm3, and the flag `damping` in what is printed";
    Refused::unless(test == Test::Csm3, "--test", test.name(), remedy)?;
    let [lower, upper] = flag::corners();
    let material =
        Material::SaintVenant(Elasticity { youngs_modulus: RUBBER.young, poissons_ratio: RUBBER.poisson });
    let clamp = match settings.clamp {
        flag::Clamp::Arc => Clamp::Disc(Disc { center: CYLINDER.into(), radius: RADIUS }),
        flag::Clamp::Plane => Clamp::Sides(vec![Side::Left]),
    };
    let flag = Solid {
        clamp: Some(clamp),
        ..Solid::new(
            "flag",
            Region::between(lower, upper),
            THICKNESS / settings.across as f64,
            RUBBER.density,
            material,
        )
    };
    let tip = DisplacementProbe { solid: "flag".into(), at: END.into() };
    let look = look(test, settings);
    Ok(SceneFile {
        title: look.title,
        end_time: settings.end_time,
        gravity: GRAVITY.into(),
        solids: vec![flag],
        probes: vec![Probe { name: "tip".into(), measure: Measure::Displacement(tip) }],
        output: Output {
            probe_interval: Some(PERIOD / SAMPLES),
            frame_interval: Some(PERIOD / FRAMES),
            view: Some(Corners::between(look.view.lower, look.view.upper)),
            strain_scale: Some(0.05),
            ..Output::default()
        },
        ..SceneFile::default()
    })
}
