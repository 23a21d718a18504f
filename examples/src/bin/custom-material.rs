//! How to add a material: a rubber of Mooney and Rivlin that damps its own vibrations.
//!
//! 1. Write down the energy `w(F)` and the stress `P = dw/dF`: [`MooneyRivlin`].
//! 2. Let the kit of conformance look for mistakes: [`Conformance::check`], here at the start of the program,
//!    in a project of your own in a test.
//! 3. Give it to a [`Solid`] like any other material: [`swing`].
//!
//! The program lets a clamped strip fall under its own weight, once without and once with damping.

use clap::Parser;
use mps_examples::{Due, Failure, Refused, closing_words, report_failure};
use mps_io::{CsvWriter, CurvePlot, Metric, Progress, Summary};
use mps_kernel::{Tensor, Vector, tensor::cofactor, tensor::determinant, weights::WendlandC2};
use mps_neighbors::Parallel;
use mps_solid::body::{self, Face};
use mps_solid::{ConstitutiveModel, Solid, SolidConfig, conformance::Conformance};
use std::path::PathBuf;
use std::process::ExitCode;

/// Compressible Mooney-Rivlin rubber with a viscous stress of Kelvin and Voigt.
///
/// ```text
/// w = c1 (I1 - 3) + c2 (I2 - 3) + l/2 (J - 1)^2 - 2 (c1 + 2 c2) ln J
/// P = F [2 c1 I + 2 c2 (I1 I - C) + 2 eta dE/dt] + [l J (J - 1) - 2 (c1 + 2 c2)] F^-T
/// ```
///
/// with `C = F^T F`, `E = (C - I)/2`, `J = det F`, and `I1`, `I2` of the deformation in space: in plane strain the third
/// stretch is 1. Energy: Ciarlet and Geymonat 1982 (C. R. Acad. Sci. Paris II 295, 423), here with `(J - 1)^2` for the volume.
/// The rate is that of `E`, which does not notice a rotation; that of `F` would damp a rigid body that turns.
#[derive(Clone, Copy, Debug)]
struct MooneyRivlin {
    /// `c1`, `c2` \[Pa\]: the shear modulus is `2 (c1 + c2)`.
    c: [f64; 2],
    /// `l` \[Pa\]: Lame's first modulus is `l + 4 c2`.
    l: f64,
    /// `eta` \[Pa s\].
    viscosity: f64,
}

/// A tensor as a history keeps it: plain numbers, zero to begin with, room for 2D and 3D.
type Memory = [[f64; 3]; 3];

fn remember<const D: usize>(tensor: &Tensor<f64, D>) -> Memory {
    core::array::from_fn(|a| core::array::from_fn(|b| if a.max(b) < D { tensor[(a, b)] } else { 0.0 }))
}

fn recall<const D: usize>(memory: &Memory) -> Tensor<f64, D> {
    Tensor::from_fn(|a, b| memory[a][b])
}

impl<const D: usize> ConstitutiveModel<f64, D> for MooneyRivlin {
    /// The strain `E` and its rate. An elastic material would write `()` here and leave out all of `history`.
    type History = [Memory; 2];

    fn energy(&self, f: &Tensor<f64, D>, _: &Self::History) -> f64 {
        let ([c1, c2], c, j) = (self.c, f.transpose() * f, determinant(f));
        let third = 3.0 - D as f64;
        let i1 = c.trace() + third;
        let i2 = 0.5 * (i1 * i1 - c.norm_squared() - third);
        c1 * (i1 - 3.0) + c2 * (i2 - 3.0) + 0.5 * self.l * (j - 1.0).powi(2) - 2.0 * (c1 + 2.0 * c2) * j.ln()
    }

    fn first_piola(&self, f: &Tensor<f64, D>, history: &mut Self::History, elapsed: f64) -> Tensor<f64, D> {
        let ([c1, c2], c, j) = (self.c, f.transpose() * f, determinant(f));
        // Nothing has moved when nothing has elapsed: the last rate is asked for again.
        if elapsed > 0.0 {
            let strain = (c - Tensor::identity()) * 0.5;
            let rate = (strain - recall(&history[0])) / elapsed;
            *history = [remember(&strain), remember(&rate)];
        }
        let i1 = c.trace() + 3.0 - D as f64;
        let elastic = Tensor::identity() * (2.0 * (c1 + c2 * i1)) - c * (2.0 * c2);
        let viscous = recall(&history[1]) * (2.0 * self.viscosity);
        // F^-T = cof F / J
        f * (elastic + viscous) + cofactor(f) * (self.l * (j - 1.0) - 2.0 * (c1 + 2.0 * c2) / j)
    }

    /// At rest: this strain, and no rate.
    fn settle(&self, f: &Tensor<f64, D>, history: &mut Self::History) {
        let strain = (f.transpose() * f - Tensor::identity()) * 0.5;
        *history = [remember(&strain), Memory::default()];
    }

    fn first_lame_modulus(&self) -> f64 {
        self.l + 4.0 * self.c[1]
    }

    fn shear_modulus(&self) -> f64 {
        2.0 * (self.c[0] + self.c[1])
    }

    fn name(&self) -> &'static str {
        "mooney-rivlin-kelvin-voigt"
    }
}

/// What viscosity leaves of the stable sub-step, `0 < factor <= 1`.
///
/// The limit that the body measures is that of the elastic forces, `2/omega` with its highest frequency. The
/// viscous ones are made of the motion of the last sub-step; an eigenmode then obeys
/// `x'' - 2 x + x' + (omega dt)^2 x + c dt (x - x') = 0` (`x''`, `x`, `x'`: three states in a row), which decays if
/// `(omega dt)^2 + 2 c dt < 4`. The highest mode is a pressure wave: `c = tau omega^2`, `tau = 2 eta/(lambda + 2 mu)`.
/// With `q = tau/limit` that is `dt < limit (sqrt(1 + q^2) - q)`: for a strong viscosity `limit^2/(2 tau)`, four times
/// as many steps for half the spacing. Measured on blocks in 2D and 3D with Poisson's ratios from 0.14 to 0.495 the border lies
/// between 0.93 and 1.4 of this; [`SolidConfig::cfl`] keeps to 0.8.
fn viscous_factor(material: &MooneyRivlin, limit: f64) -> f64 {
    let modulus = material.l + 4.0 * material.c[1] + 4.0 * (material.c[0] + material.c[1]);
    let q = 2.0 * material.viscosity / modulus / limit;
    // The same as sqrt(1 + q^2) - q, without the difference of two large numbers.
    1.0 / ((1.0 + q * q).sqrt() + q)
}

/// A clamped strip of rubber swings under its own weight, without and with damping.
#[derive(Parser, Clone, Debug)]
#[command(version)]
struct Options {
    /// Simulated time (s)
    #[arg(long, value_name = "S", default_value_t = 3.0)]
    end_time: f64,
    /// Viscosity of the damped strip [Pa s]
    #[arg(long, value_name = "ETA", default_value_t = 1000.0)]
    viscosity: f64,
    /// Directory for the results; created if missing
    #[arg(long, value_name = "DIR", default_value = "out/custom-material")]
    out: PathBuf,
    /// No progress, no closing words
    #[arg(long)]
    quiet: bool,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            report_failure(&failure);
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Failure> {
    let Options { end_time, viscosity, .. } = *options;
    let remedy = "give seconds, more than 0 and at most 100";
    Refused::unless(end_time > 0.0 && end_time <= 100.0, "--end-time", end_time, remedy)?;
    let remedy = "give pascal seconds, 0 to 1e4 (1000 damps within a few swings)";
    Refused::unless((0.0..=1e4).contains(&viscosity), "--viscosity", viscosity, remedy)?;
    mps_io::prepare_output(&options.out)?;

    // Shear modulus 0.1 MPa, bulk modulus about 1 MPa: a very soft rubber.
    let elastic = MooneyRivlin { c: [4.0e4, 1.0e4], l: 9.0e5, viscosity: 0.0 };
    let damped = MooneyRivlin { viscosity, ..elastic };
    for material in [&elastic, &damped] {
        Conformance::default().check::<2, _>(material)?;
        Conformance::default().check::<3, _>(material)?;
    }

    let mut summary = Summary::new("custom-material", env!("CARGO_PKG_VERSION"));
    summary.set("viscosity_pa_s", viscosity);
    let free = swing(elastic, options, "undamped", &mut summary)?;
    let slowed = swing(damped, options, "damped", &mut summary)?;
    CurvePlot::new("A strip of rubber under its own weight", "time [s]", "height of the tip [m]")
        .line("elastic", &free[0], &free[1])
        .line(&format!("damped, η = {viscosity} Pa s"), &slowed[0], &slowed[1])
        .write_png(options.out.join("tip.png"))?;
    summary.write(&options.out)?;
    if !options.quiet {
        closing_words(&options.out, &summary);
    }
    Ok(())
}

/// Lets the strip go and returns the times \[s\] and the heights of the tip \[m\], which are also in `<name>.csv`.
fn swing(
    material: MooneyRivlin,
    options: &Options,
    name: &str,
    summary: &mut Summary,
) -> Result<[Vec<f64>; 2], Failure> {
    let parallel = Parallel::serial();
    let strip = body::block(Vector::zeros(), Vector::<f64, 2>::new(0.12, 0.02), [19, 3], &[Face::lower(0)])?;
    let config = SolidConfig::default();
    let mut solid =
        Solid::new(strip.particles, strip.spacing, 1100.0, material, WendlandC2, config, &parallel)?;
    let factor = viscous_factor(&material, solid.stability_limit());
    let (no_load, gravity) = (vec![Vector::zeros(); solid.len()], Vector::<f64, 2>::new(0.0, -9.81));
    // The middle one of the last three particles.
    let tip = solid.len() - 2;
    let start = solid.positions()[tip].y;

    let columns = ["time [s]", "tip y [m]", "energy [J/m]"];
    let mut table = CsvWriter::create(options.out.join(format!("{name}.csv")), &columns)?;
    let mut progress = Progress::new(options.quiet, options.end_time);
    let mut due = Due::every(1e-3);
    let (mut time, mut steps, mut energy, mut curve) = (0.0, 0, 0.0, [Vec::new(), Vec::new()]);
    while time < options.end_time {
        if due.is_due(time) {
            // Kinetic, stored and potential, together zero at the start.
            energy = solid.energy(&parallel, &gravity).total();
            let y = solid.positions()[tip].y - start;
            table.row(&[time, y, energy])?;
            curve[0].push(time);
            curve[1].push(y);
        }
        let dt = factor * solid.max_step(&parallel);
        solid.advance(&parallel, &no_load, &gravity, 20.0 * dt, 20)?;
        (time, steps) = (time + 20.0 * dt, steps + 20);
        progress.update(time, steps, dt, name);
    }
    progress.finish(time, steps);

    let late = &curve[1][curve[1].len() * 9 / 10..];
    let least = |part: &[f64]| part.iter().copied().fold(f64::INFINITY, f64::min);
    let most = late.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    for (what, value, unit) in [
        ("deepest", least(&curve[1]), "m"),
        ("swing_at_the_end", most - least(late), "m"),
        ("energy_at_the_end", energy, "J/m"),
        ("sub_steps", steps as f64, "-"),
    ] {
        summary.metrics.insert(format!("{name}_{what}"), Metric::new(value, unit));
    }
    Ok(curve)
}
