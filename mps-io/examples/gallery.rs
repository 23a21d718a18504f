//! Sample pictures, to look at after a change of the drawing code:
//! `cargo run --release -p mps-io --example gallery -- out/gallery`
#![allow(clippy::print_stdout, reason = "an example talks to its user")]

use std::path::Path;
use std::time::Instant;

use mps_io::{
    ColorMap, CurvePlot, FieldOptions, FieldPicture, FieldWriter, Film, OutputError, PointCloud, View,
    prepare_output,
};
use mps_kernel::Vector;

fn main() -> Result<(), OutputError> {
    let dir = std::env::args().nth(1).unwrap_or_else(|| "out/gallery".to_owned());
    let dir = Path::new(&dir);
    prepare_output(dir)?;
    curves(dir)?;
    convergence(dir)?;
    signal(dir)?;
    fields(dir)?;
    sphere(dir)?;
    film(dir)?;
    vtk(dir)
}

/// A result, a theory and experiments.
fn curves(dir: &Path) -> Result<(), OutputError> {
    let t: Vec<f64> = (0..200).map(|k| f64::from(k) * 0.02).collect();
    let front =
        |factor: f64| -> Vec<f64> { t.iter().map(|t| 1.0 + factor * t * t / (1.0 + 0.12 * t * t)).collect() };
    let te: Vec<f64> = (0..14).map(|k| f64::from(k) * 0.27).collect();
    let ze: Vec<f64> =
        te.iter().map(|t| 1.0 + 0.43 * t * t / (1.0 + 0.12 * t * t) + 0.05 * (9.0 * t).sin()).collect();
    let zf: Vec<f64> = ze.iter().map(|z| 1.02 * z + 0.03).collect();
    CurvePlot::new("Dam break: position of the front", "t √(2g/a)  [–]", "front Z/a  [–]")
        .line("MPS, l₀ = 5 mm", &t, &front(0.45))
        .line("MPS, l₀ = 10 mm", &t, &front(0.50))
        .dashed("shallow water, ρ c² → ∞", &t, &front(0.58))
        .points("Martin & Moyce (1952), 2¼ in", &te, &ze)
        .points("Koshizuka & Oka (1996)", &te, &zf)
        .write_png(dir.join("curves.png"))
}

/// Logarithmic axes.
fn convergence(dir: &Path) -> Result<(), OutputError> {
    let l0 = [0.02, 0.01, 0.005, 0.0025];
    CurvePlot::new("Convergence of the tip displacement", "particle distance l₀ [m]", "relative error [–]")
        .dashed("second order", &[0.02, 0.0025], &[0.08, 0.08 / 64.0])
        .line("first order", &[0.02, 0.0025], &[0.09, 0.09 / 8.0])
        .points("MPS", &l0, &[0.081, 0.022, 0.0049, 0.0013])
        .log_x()
        .log_y()
        .write_png(dir.join("convergence.png"))
}

/// A noisy pressure with large numbers and a gap.
fn signal(dir: &Path) -> Result<(), OutputError> {
    let t: Vec<f64> = (0..100_000).map(|k| f64::from(k) * 1e-5).collect();
    let noise = |k: f64| (k * 12.9898).sin() * 43_758.545_3 % 1.0;
    let p: Vec<f64> = (t.iter().enumerate())
        .map(|(k, t)| {
            let hit = 2.4e5 * (-(t - 0.3) / 0.15).exp();
            let level = if *t < 0.3 { 0.0 } else { hit };
            if (0.6..0.62).contains(t) { f64::NAN } else { level + 2e4 * noise(k as f64) }
        })
        .collect();
    let start = Instant::now();
    CurvePlot::new("Pressure at sensor P2", "time [s]", "pressure [Pa]")
        .line("100 000 samples", &t, &p)
        .write_png(dir.join("signal.png"))?;
    println!("signal of 100000 samples: {:?}", start.elapsed());
    Ok(())
}

/// Water against an elastic plate at `time`: positions and pressures, positions and strains.
struct Scene {
    l0: f64,
    water: Vec<Vector<f64, 2>>,
    pressure: Vec<f64>,
    plate: Vec<Vector<f64, 2>>,
    strain: Vec<f64>,
    wall: Vec<Vector<f64, 2>>,
}

fn scene(time: f64) -> Scene {
    let l0 = 0.003;
    let grid = |n: i32, m: i32| (0..n).flat_map(move |i| (0..m).map(move |j| (f64::from(i), f64::from(j))));
    let (mut water, mut pressure) = (Vec::new(), Vec::new());
    for (i, j) in grid(200, 100) {
        let (x, y) = ((i + 0.5) * l0, (j + 0.5) * l0);
        let surface = 0.20 + 0.06 * (9.0 * x - 12.0 * time).cos();
        if y < surface {
            water.push(Vector::<f64, 2>::new(x, y));
            pressure.push(9810.0 * (surface - y));
        }
    }
    let (mut plate, mut strain) = (Vec::new(), Vec::new());
    let bend = 0.08 * (12.0 * time).sin();
    for (i, j) in grid(8, 60) {
        let s = j / 60.0;
        plate.push(Vector::<f64, 2>::new(0.30 + (i - 3.5) * l0 + bend * s * s, (j + 0.5) * l0));
        strain.push((i - 3.5) / 3.5 * bend / 80.0 * (1.0 - s));
    }
    let wall = grid(206, 3).map(|(i, j)| Vector::<f64, 2>::new((i - 2.5) * l0, -(j + 0.5) * l0)).collect();
    Scene { l0, water, pressure, plate, strain, wall }
}

fn picture(scene: &Scene, width: u32, view: View, time: f64) -> FieldPicture {
    let Scene { l0, water, pressure, plate, strain, wall } = scene;
    FieldPicture::new(width, view)
        .title("Waves on an elastic plate")
        .time(time)
        .plain(wall, 0.7 * l0, [170, 170, 170])
        .layer(water, 0.7 * l0, pressure, (0.0, 2500.0), ColorMap::Viridis, "pressure [Pa]")
        .layer(plate, 0.7 * l0, strain, (-1e-3, 1e-3), ColorMap::BlueRed, "strain ε [–]")
}

/// Wide, square and tall views of the same scene.
fn fields(dir: &Path) -> Result<(), OutputError> {
    let time = 0.123;
    let scene = scene(time);
    let particles = scene.water.len() + scene.plate.len() + scene.wall.len();
    let start = Instant::now();
    let wide = picture(&scene, 1200, View::new([-0.01, -0.01], [0.61, 0.32]), time).render()?;
    println!("{particles} particles rendered: {:?}", start.elapsed());
    let start = Instant::now();
    wide.write_png(dir.join("field_wide.png"))?;
    println!("written as PNG: {:?}", start.elapsed());
    let view = View::new([0.1, -0.01], [0.42, 0.29]);
    picture(&scene, 1000, view, time)
        .line(&[[0.2, 0.0], [0.2, 0.27], [0.25, 0.27]], [200, 30, 30])
        .render()?
        .write_png(dir.join("field_square.png"))?;
    picture(&scene, 600, View::new([0.27, 0.0], [0.37, 0.3]), time)
        .render()?
        .write_png(dir.join("field_tall.png"))
}

/// Three dimensions seen from the side: near particles cover far ones.
fn sphere(dir: &Path) -> Result<(), OutputError> {
    let mut ball = Vec::new();
    for k in 0..20_000 {
        let z = 1.0 - 2.0 * (f64::from(k) + 0.5) / 20_000.0;
        let (angle, r) = (f64::from(k) * 2.399_963, (1.0 - z * z).sqrt());
        ball.push(Vector::<f64, 3>::new(r * angle.cos(), r * angle.sin(), z));
    }
    let speed: Vec<f64> = ball.iter().map(|x| 1e-5 * (3.0 * x[0]).sin() * (3.0 * x[1]).cos()).collect();
    let view = View::new([-1.1, -1.1], [1.1, 1.1]).with_axes([0, 2]);
    FieldPicture::new(900, view)
        .title("A sphere of 20 000 particles, seen along y")
        .layer(&ball, 0.012, &speed, (-1e-5, 1e-5), ColorMap::Plasma, "velocity v_y [m/s]")
        .render()?
        .write_png(dir.join("sphere.png"))
}

/// Two seconds of film.
fn film(dir: &Path) -> Result<(), OutputError> {
    let view = View::new([-0.01, -0.01], [0.61, 0.32]);
    let mut film = Film::create(dir.join("film.png"), 25)?;
    let start = Instant::now();
    for frame in 0..50 {
        let time = f64::from(frame) * 0.02;
        film.push(&picture(&scene(time), 900, view, time).render()?)?;
    }
    println!("50 frames: {:?}", start.elapsed());
    Ok(())
}

/// A million particles for ParaView.
fn vtk(dir: &Path) -> Result<(), OutputError> {
    let n = 1_000_000;
    let at =
        |k: i32| Vector::<f64, 3>::new(f64::from(k % 100), f64::from(k / 100 % 100), f64::from(k / 10_000));
    // Particles on the move are nowhere on a lattice, which would compress too well.
    let stir = |k: i32, c: f64| (f64::from(k) * (12.9898 + c)).sin() * 43_758.545_3 % 1.0;
    let jitter = |k: i32| 0.3 * Vector::<f64, 3>::new(stir(k, 0.0), stir(k, 1.0), stir(k, 2.0));
    let positions: Vec<Vector<f64, 3>> = (0..n).map(|k| 0.01 * (at(k) + jitter(k))).collect();
    let velocity: Vec<Vector<f64, 3>> = positions
        .iter()
        .map(|x| Vector::<f64, 3>::new((9.0 * x[1]).sin(), (7.0 * x[0]).cos(), 0.0))
        .collect();
    let pressure: Vec<f64> =
        positions.iter().map(|x| 9810.0 * (1.0 - x[2]) + 10.0 * (99.0 * x[0]).sin()).collect();
    let kind: Vec<u32> = (0..n as u32).map(|k| u32::from(k % 100 == 0)).collect();
    let cloud = PointCloud::new(&positions)
        .scalar("pressure [Pa]", &pressure)
        .vector("velocity [m/s]", &velocity)
        .integer("kind", &kind);
    for compress in [true, false] {
        let name = if compress { "million_compressed" } else { "million_raw" };
        let mut writer = FieldWriter::new(dir, name, FieldOptions { compress, ..FieldOptions::default() })?;
        for frame in 0..2 {
            let start = Instant::now();
            let path = writer.write(0.5 * f64::from(frame), &cloud)?;
            let time = start.elapsed();
            let size = std::fs::metadata(&path).map_or(0, |data| data.len());
            println!("{n} particles, compressed {compress}: {time:?}, {:.1} MB", size as f64 / 1e6);
        }
    }
    Ok(())
}
