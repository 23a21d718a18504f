//! The run as a scene file.

use crate::options::{Material, Options};
use crate::{FRAMES, SAMPLES};
use mps_examples::Refused;
use mps_examples::solid::plate::{
    BULK, DENSITY, LENGTH, PERIOD, SHEAR, THICKNESS, TIP_SPEED, sound_speed, unit_of_time,
};
use mps_io::scene_file::{
    self, Clamp, Corners, DisplacementProbe, Elasticity, Filling, InitialVelocity, Measure, Output, Probe,
    Region, SceneFile, Side, Slip, Solid,
};
use mps_solid::SolidConfig;

/// The scene of the plate with so many particles across.
///
/// # Errors
/// If it is to be run at several resolutions, or with numerics of its own.
pub(crate) fn scene(options: &Options, across: usize) -> Result<SceneFile, Refused> {
    let remedy = "a scene is one run: leave it out, and give --across";
    Refused::unless(!options.convergence, "--convergence", "given", remedy)?;
    let remedy = "a scene has the usual numerics of a body: leave --radius and --cfl out";
    let usual = options.config::<f64>() == SolidConfig::default();
    Refused::unless(usual, "--radius or --cfl", "given", remedy)?;
    let period = PERIOD * unit_of_time();
    let plate = Solid {
        name: "plate".into(),
        region: Region::between([0.0, 0.0], [LENGTH, THICKNESS]),
        spacing: THICKNESS / across as f64,
        packing: Filling::Lattice,
        density: DENSITY,
        material: material(options.material),
        clamp: Some(Clamp::Sides(vec![Side::Left])),
        slip: Slip::Free,
        ambient_pressure: None,
        velocity: Some(InitialVelocity::FirstMode(TIP_SPEED * sound_speed())),
    };
    let tip = DisplacementProbe { solid: "plate".into(), at: vec![LENGTH, 0.5 * THICKNESS] };
    Ok(SceneFile {
        title: format!("Vibrating plate, {across} particles across"),
        end_time: options.end_time(),
        solids: vec![plate],
        probes: vec![Probe { name: "tip".into(), measure: Measure::Displacement(tip) }],
        output: Output {
            probe_interval: Some(period / SAMPLES),
            frame_interval: Some(period / FRAMES),
            view: Some(Corners::between([-0.01, -0.04], [LENGTH + 0.01, THICKNESS + 0.04])),
            strain_scale: Some(0.05),
            ..Output::default()
        },
        ..SceneFile::default()
    })
}

fn material(law: Material) -> scene_file::Material {
    // Of the bulk modulus and the shear modulus.
    let constants = Elasticity {
        youngs_modulus: 9.0 * BULK * SHEAR / (3.0 * BULK + SHEAR),
        poissons_ratio: (3.0 * BULK - 2.0 * SHEAR) / (2.0 * (3.0 * BULK + SHEAR)),
    };
    match law {
        Material::Corotational => scene_file::Material::Corotational(constants),
        Material::SaintVenant => scene_file::Material::SaintVenant(constants),
        Material::NeoHookean => scene_file::Material::NeoHookean(constants),
    }
}
