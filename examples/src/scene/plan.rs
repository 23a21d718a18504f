//! What a run will be and cost, measured by its first steps.

use super::disk::{field_bytes, field_frames};
use super::{Diagnosis, Layout, World};
use crate::{Common, Failure, Precision};
use mps_io::scene_file::{Diffusion, PressureForm, SceneFile, Viscosity, Weight};
use mps_kernel::weights::{Rational, WendlandC2, WendlandGradient};
use mps_kernel::{Kernel, Real};
use mps_neighbors::Parallel;
use std::fmt::Write;
use std::time::Instant;

/// Steps before the clock is started: memory is fetched, caches are filled.
const WARM: usize = 3;
/// Steps that are measured.
const MEASURED: u32 = 20;
/// The plan of a scene that has been found good, as text.
///
/// # Errors
/// If the scene cannot be built or breaks in its first steps.
pub fn plan(
    scene: &SceneFile,
    layout: &Layout,
    diagnosis: &Diagnosis,
    common: &Common,
) -> Result<String, Failure> {
    match common.precision {
        Precision::F32 => with_weight::<f32>(scene, layout, diagnosis, common),
        Precision::F64 => with_weight::<f64>(scene, layout, diagnosis, common),
    }
}

fn with_weight<T: Real>(
    scene: &SceneFile,
    layout: &Layout,
    diagnosis: &Diagnosis,
    common: &Common,
) -> Result<String, Failure> {
    match scene.fluid.as_ref().map(|fluid| fluid.numerics.weight) {
        Some(Weight::Rational) => whole::<T, _>(scene, layout, diagnosis, common, Rational),
        Some(Weight::Wendland) => whole::<T, _>(scene, layout, diagnosis, common, WendlandC2),
        Some(Weight::Smooth) | None => whole::<T, _>(scene, layout, diagnosis, common, WendlandGradient),
    }
}

fn whole<T: Real, K: Kernel<T>>(
    scene: &SceneFile,
    layout: &Layout,
    diagnosis: &Diagnosis,
    common: &Common,
    weight: K,
) -> Result<String, Failure> {
    let parallel = common.parallel()?;
    let mut world = World::<T, K>::new(scene, layout, weight, &parallel)?;
    let mut text = String::new();
    particles(&mut text, scene, layout, diagnosis);
    physics(&mut text, scene);
    let measured = parallel.install(|| measure(&mut world, &parallel))?;
    steps(&mut text, scene, &world, diagnosis, &measured, &parallel);
    cost(&mut text, scene, layout, &measured, parallel.threads());
    Ok(text)
}

/// What the first steps have shown.
struct Measured {
    /// Mean length of a step \[s\].
    dt: f64,
    /// Seconds that one second of simulated time takes.
    pace: f64,
}

fn measure<T: Real, K: Kernel<T>>(world: &mut World<T, K>, parallel: &Parallel) -> Result<Measured, Failure> {
    for _ in 0..WARM {
        world.step(parallel)?;
    }
    let (begin, first, clock) = (world.time(), world.steps(), Instant::now());
    for _ in 0..MEASURED {
        world.step(parallel)?;
    }
    let simulated = world.time() - begin;
    let seconds = clock.elapsed().as_secs_f64();
    Ok(Measured { dt: simulated / (world.steps() - first) as f64, pace: seconds / simulated })
}

// Writing into a String cannot fail, here and below.
fn particles(text: &mut String, scene: &SceneFile, layout: &Layout, diagnosis: &Diagnosis) {
    let (fluid, walls, solids) = (layout.fluid_len(), layout.walls_len(), layout.solids_len());
    let fixed = if scene.fixed.is_empty() {
        String::new()
    } else {
        format!(", {} of fixed bodies", layout.fixed_len())
    };
    let _ = writeln!(text, "particles      {fluid} of fluid, {walls} of walls, {solids} of bodies{fixed}");
    for (solid, across) in scene.solids.iter().zip(&diagnosis.across) {
        let _ = writeln!(text, "               {across:.1} across the thinnest side of {}", solid.name);
    }
}

fn physics(text: &mut String, scene: &SceneFile) {
    let (mut on, mut off) = (Vec::new(), Vec::new());
    let mut say =
        |active: bool, what: &str| if active { on.push(what.to_owned()) } else { off.push(what.to_owned()) };
    say(scene.gravity.iter().any(|g| *g != 0.0), "gravity");
    say(!scene.solids.is_empty(), "elastic bodies");
    say(scene.walls.iter().any(|wall| wall.motion.is_some()), "moving walls");
    if let Some(fluid) = &scene.fluid {
        let numerics = &fluid.numerics;
        say(matches!(fluid.viscosity, Viscosity::Artificial(alpha) if alpha > 0.0), "artificial viscosity");
        let laminar = matches!(fluid.viscosity, Viscosity::Laminar(nu) | Viscosity::Compact(nu) if nu > 0.0);
        say(laminar, "laminar viscosity");
        say(numerics.diffusion != Diffusion::None, "density diffusion");
        say(numerics.collisions, "collisions (DPC)");
        say(numerics.shifting > 0, "shifting (icPS)");
        say(numerics.background_pressure > 0.0, "background pressure");
        say(numerics.pressure_form == PressureForm::Corrected, "corrected sums");
        say(numerics.density_relaxation > 0.0, "density relaxation");
        say(!scene.fixed.is_empty(), "fixed bodies");
        say(!(fluid.inlets.is_empty() && fluid.outlets.is_empty()), "inlets and outlets");
    } else {
        say(false, "fluid");
    }
    for absent in ["contact of bodies", "surface tension", "turbulence model"] {
        say(false, absent);
    }
    let _ = writeln!(text, "active         {}", on.join(", "));
    let _ = writeln!(text, "absent         {}", off.join(", "));
}

fn steps<T: Real, K: Kernel<T>>(
    text: &mut String,
    scene: &SceneFile,
    world: &World<T, K>,
    diagnosis: &Diagnosis,
    measured: &Measured,
    parallel: &Parallel,
) {
    if let Some(mach) = diagnosis.mach {
        let _ =
            writeln!(text, "Mach number    {mach:.2} expected, density within {:.1} %", 100.0 * mach * mach);
    }
    if let Some(fluid) = world.fluid() {
        let (limit, dt) = fluid.limits().shortest();
        let _ = writeln!(text, "fluid step     {:.3e} s, limited by {}", dt.to_double(), limit.name());
    }
    for (k, solid) in scene.solids.iter().enumerate() {
        let Some(body) = world.solid(k) else { continue };
        let limit = body.max_step(parallel).to_double();
        let _ = writeln!(text, "solid step     {limit:.3e} s of {}, limited by its stiffness", solid.name);
    }
    if world.fluid().is_some() && !scene.solids.is_empty() {
        let _ = writeln!(text, "sub-steps      {} of the bodies in a step of the fluid", world.substeps());
    }
    let count = scene.end_time / measured.dt;
    let _ = writeln!(text, "steps          {count:.0} of about {:.3e} s", measured.dt);
}

fn cost(text: &mut String, scene: &SceneFile, layout: &Layout, measured: &Measured, threads: usize) {
    let _ = writeln!(
        text,
        "fields         {:.0} frames, at most {:.1} MB before compression",
        field_frames(scene),
        field_bytes(scene, layout) * 1e-6
    );
    if let Some(bytes) = mps_io::peak_memory_bytes() {
        let _ = writeln!(text, "memory         {:.0} MB", bytes as f64 * 1e-6);
    }
    let seconds = scene.end_time * measured.pace;
    let _ = writeln!(
        text,
        "wall time      about {} on {threads} threads, from {MEASURED} steps at the start",
        duration(seconds)
    );
}

/// A duration in the unit one would say it in.
fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 120.0 => format!("{s:.1} s"),
        s if s < 7200.0 => format!("{:.0} minutes", s / 60.0),
        s => format!("{:.1} hours", s / 3600.0),
    }
}
