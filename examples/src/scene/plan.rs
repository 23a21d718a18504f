//! What a run will be and cost, measured by its first steps.

use super::disk::{field_bytes, field_frames};
use super::fields::shown;
use super::price::{Priced, prices};
use super::slice::Slice;
use super::{Diagnosis, Layout, World};
use crate::{Common, Failure, Precision};
use mps_io::scene_file::{Diffusion, PressureForm, SceneFile, Slip, Viscosity, Weight};
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
pub(super) fn plan<const D: usize>(
    scene: &SceneFile,
    layout: &Layout<D>,
    diagnosis: &Diagnosis,
    common: &Common,
) -> Result<String, Failure> {
    match common.precision {
        Precision::F32 => with_weight::<f32, D>(scene, layout, diagnosis, common),
        Precision::F64 => with_weight::<f64, D>(scene, layout, diagnosis, common),
    }
}

fn with_weight<T: Real, const D: usize>(
    scene: &SceneFile,
    layout: &Layout<D>,
    diagnosis: &Diagnosis,
    common: &Common,
) -> Result<String, Failure> {
    match scene.fluid.as_ref().map(|fluid| fluid.numerics.weight) {
        Some(Weight::Rational) => whole::<T, D, _>(scene, layout, diagnosis, common, Rational),
        Some(Weight::Wendland) => whole::<T, D, _>(scene, layout, diagnosis, common, WendlandC2),
        Some(Weight::Smooth) | None => whole::<T, D, _>(scene, layout, diagnosis, common, WendlandGradient),
    }
}

fn whole<T: Real, const D: usize, K: Kernel<T>>(
    scene: &SceneFile,
    layout: &Layout<D>,
    diagnosis: &Diagnosis,
    common: &Common,
    weight: K,
) -> Result<String, Failure> {
    let parallel = common.parallel()?;
    let mut world = World::<T, D, K>::new(scene, layout, weight, &parallel)?;
    let mut text = String::new();
    particles(&mut text, scene, layout, diagnosis);
    physics(&mut text, scene);
    let measured = parallel.install(|| measure(&mut world, scene.end_time, &parallel))?;
    steps(&mut text, scene, &world, diagnosis, &measured, &parallel);
    pictures(&mut text, scene, &world);
    cost(&mut text, scene, layout, &measured, parallel.threads());
    Ok(text)
}

/// What the first steps have shown.
struct Measured {
    /// Mean length of a step \[s\].
    dt: f64,
    /// Seconds that one second of simulated time takes.
    pace: f64,
    /// Seconds that one step takes.
    step: f64,
    /// How many steps that was.
    count: u32,
}

fn measure<T: Real, const D: usize, K: Kernel<T>>(
    world: &mut World<T, D, K>,
    end: f64,
    parallel: &Parallel,
) -> Result<Measured, Failure> {
    // A step of bodies alone is a row, which may be as long as the run.
    for _ in 0..WARM {
        if world.time() < 0.1 * end {
            world.step(parallel)?;
        }
    }
    let (begin, first, clock) = (world.time(), world.steps(), Instant::now());
    let mut count = 0;
    while count < MEASURED && (count == 0 || world.time() < end) {
        world.step(parallel)?;
        count += 1;
    }
    let simulated = world.time() - begin;
    let seconds = clock.elapsed().as_secs_f64();
    let steps = (world.steps() - first) as f64;
    Ok(Measured { dt: simulated / steps, pace: seconds / simulated, step: seconds / steps, count })
}

// Writing into a String cannot fail, here and below.
fn particles<const D: usize>(
    text: &mut String,
    scene: &SceneFile,
    layout: &Layout<D>,
    diagnosis: &Diagnosis,
) {
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

/// What a scene may have, whether it has it, and its price if it is one a particle of fluid.
fn listed(scene: &SceneFile) -> Vec<(bool, &'static str, Option<Priced>)> {
    let alone = |name| Some(Priced::alone(name));
    let mut all = vec![
        (scene.gravity.iter().any(|g| *g != 0.0), "gravity", None),
        (!scene.solids.is_empty(), "elastic bodies", Some(Priced("structure", "scene"))),
        (!scene.walls.is_empty(), "walls", alone("walls")),
        (scene.walls.iter().any(|wall| wall.motion.is_some()), "moving walls", None),
    ];
    if let Some(fluid) = &scene.fluid {
        let numerics = &fluid.numerics;
        let artificial = matches!(fluid.viscosity, Viscosity::Artificial(alpha) if alpha > 0.0);
        let laminar = matches!(fluid.viscosity, Viscosity::Laminar(nu) | Viscosity::Compact(nu) if nu > 0.0);
        let slips = scene.walls.iter().map(|wall| wall.slip).chain(scene.fixed.iter().map(|body| body.slip));
        let slips: Vec<_> = slips.chain(scene.solids.iter().map(|solid| solid.slip)).collect();
        let (sticky, law) = (slips.contains(&Slip::None), slips.contains(&Slip::Law));
        let diffusion = match numerics.diffusion {
            Diffusion::Hydrostatic => "hydrostatic-diffusion",
            _ => "filter-diffusion",
        };
        let diffuses = !matches!(numerics.diffusion, Diffusion::None | Diffusion::Filter(0.0));
        let open = !(fluid.inlets.is_empty() && fluid.outlets.is_empty());
        all.extend([
            (artificial, "artificial viscosity", alone("artificial-viscosity")),
            (laminar, "laminar viscosity", alone("laminar-viscosity")),
            (
                (artificial || laminar) && sticky,
                "walls without slip",
                Some(Priced("no-slip", "walls+laminar-viscosity")),
            ),
            (law, "law of the wall", Some(Priced("wall-law", "walls"))),
            (diffuses, "density diffusion", alone(diffusion)),
            (numerics.collisions, "collisions (DPC)", alone("collisions")),
            (numerics.shifting > 0, "shifting (icPS)", alone("shifting")),
            (numerics.background_pressure > 0.0, "background pressure", None),
            (numerics.pressure_form == PressureForm::Corrected, "corrected sums", alone("corrected-sums")),
            (numerics.density_relaxation > 0.0, "density relaxation", alone("density-relaxation")),
            (!scene.fixed.is_empty(), "fixed bodies", None),
            (open, "inlets and outlets", alone("openings")),
        ]);
    } else {
        all.push((false, "fluid", None));
    }
    all.extend(
        ["contact of bodies", "surface tension", "turbulence model"].map(|absent| (false, absent, None)),
    );
    all
}

fn physics(text: &mut String, scene: &SceneFile) {
    let all = listed(scene);
    for (title, wanted) in [("active", true), ("absent", false)] {
        let names: Vec<_> = all.iter().filter(|(on, ..)| *on == wanted).map(|(_, what, _)| *what).collect();
        let _ = writeln!(text, "{title:14} {}", names.join(", "));
    }
    if scene.fluid.is_some() {
        let active = all.iter().filter(|(on, ..)| *on);
        let priced: Vec<_> = active.filter_map(|(_, what, price)| Some((*what, (*price)?))).collect();
        text.push_str(&prices(scene.dimension, &priced));
    }
}

fn steps<T: Real, const D: usize, K: Kernel<T>>(
    text: &mut String,
    scene: &SceneFile,
    world: &World<T, D, K>,
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

/// What pictures and film show, where that is not everything.
fn pictures<T: Real, const D: usize, K: Kernel<T>>(
    text: &mut String,
    scene: &SceneFile,
    world: &World<T, D, K>,
) {
    if D == 3 {
        let (_, Slice { z }) = shown(scene, world);
        let _ = writeln!(text, "pictures       the particles near the plane z = {z:.4} m");
    }
}

fn cost<const D: usize>(
    text: &mut String,
    scene: &SceneFile,
    layout: &Layout<D>,
    measured: &Measured,
    threads: usize,
) {
    let _ = writeln!(
        text,
        "fields         {:.0} frames, at most {:.1} MB before compression",
        field_frames(scene),
        field_bytes(scene, layout) * 1e-6
    );
    if let Some(bytes) = mps_io::peak_memory_bytes() {
        let _ = writeln!(text, "memory         {:.0} MB", bytes as f64 * 1e-6);
    }
    if scene.fluid.is_some() {
        let nanoseconds = measured.step * 1e9 / layout.fluid_len() as f64;
        let _ = writeln!(
            text,
            "step           {nanoseconds:.0} ns a particle of fluid, measured here with {threads} threads"
        );
    }
    let seconds = scene.end_time * measured.pace;
    let _ = writeln!(
        text,
        "wall time      about {} on {threads} threads, from {} steps at the start",
        duration(seconds),
        measured.count
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::{Priced, listed};
    use mps_io::scene_file::{Source, parse};

    const TANK: &str = include_str!("../../scenes/hydrostatic-tank.toml");

    /// The price of walls without slip, if the tank has it with this viscosity and walls of this slip.
    fn friction(viscosity: &str, slip: &str) -> Option<Priced> {
        let text = TANK
            .replace("[[fluid.bodies]]", &format!("viscosity = {viscosity}\n[[fluid.bodies]]"))
            .replace("fineness = 0.5", &format!("fineness = 0.5\nslip = \"{slip}\""));
        let scene = parse(&Source::new("tank.toml", text)).unwrap();
        let (on, _, price) =
            listed(&scene).into_iter().find(|(_, what, _)| *what == "walls without slip").unwrap();
        price.filter(|_| on)
    }

    #[test]
    fn walls_without_slip_are_listed_with_whatever_viscosity_they_act_through() {
        for viscosity in ["{ artificial = 0.1 }", "{ laminar = 1e-3 }", "{ compact = 1e-3 }"] {
            assert!(friction(viscosity, "none").is_some(), "{viscosity}");
            assert!(friction(viscosity, "free").is_none(), "{viscosity}");
        }
        assert!(friction("{ artificial = 0.0 }", "none").is_none());
    }
}
