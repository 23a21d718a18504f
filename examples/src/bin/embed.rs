//! Embedding: a body that is not ours floats in our water, and our water obeys a time loop that is not ours.
//!
//! Two things are shown, in one file. [`Raft`] is a rigid body as another simulator might have it, with a centre, an angle and
//! their velocities; the trait [`Structure`] is all it takes to put it into a flow. [`advance`] is the loop of a host that
//! thinks in frames of a fixed length, into which the steps of the scene are fitted.
//!
//! The raft is let go too high or too low and comes to rest where it displaces its own mass: the exact answer. Let go inclined (`--lean`) it rights
//! itself, if the torque of the water has the right sign.

use clap::Parser;
use mps_coupling::{Scene, Structure, StructureEnergy};
use mps_examples::{
    Common, Cost, Due, Failure, Precision, Recorded, Refused, Watch, basin, conclude, enter_results,
    exit_code, record,
};
use mps_fluid::{ArtificialViscosity, Fluid, FluidParticles, Slip};
use mps_io::{CsvWriter, CurvePlot, Metric, Summary};
use mps_kernel::weights::WendlandGradient;
use mps_kernel::{Real, Vector};
use mps_neighbors::{Open, Parallel};
use std::any::Any;
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

/// Width and depth of the water \[m\].
const WATER: [f64; 2] = [0.8, 0.4];
/// Width and height of the raft \[m\].
const RAFT: [f64; 2] = [0.24, 0.12];
/// How deep the raft is in the water when it is let go \[m\].
const START: f64 = 0.04;
const GRAVITY: f64 = 9.81;
/// Density of the water \[kg/m^3\].
const RHO: f64 = 1000.0;
/// Strength of the artificial viscosity: calms the water within seconds.
const ALPHA: f64 = 0.2;
/// Share of the run at whose end results are read off.
const READ: f64 = 0.2;

/// A raft of another simulator floats in water, inside the time loop of that simulator.
///
/// The raft, 0.24 m wide and 0.12 m high, is let go with a draught of 0.04 m. Writes probes.csv, a plot of the draught,
/// and summary.json.
#[derive(Parser, Clone, Debug)]
#[command(version, rename_all = "kebab-case", allow_negative_numbers = true)]
struct Options {
    /// Spacing of the particles (m): 0.04 m has to be a whole number of it
    #[arg(long, value_name = "M", default_value_t = 0.01)]
    spacing: f64,
    /// Density of the raft (kg/m3)
    #[arg(long, value_name = "RHO", default_value_t = 600.0)]
    density: f64,
    /// Angle by which the raft is turned when it is let go (rad), anticlockwise
    #[arg(long, value_name = "RAD", default_value_t = 0.0)]
    lean: f64,
    /// Length of a frame of the host (s)
    #[arg(long, value_name = "S", default_value_t = 0.01)]
    frame: f64,
    /// Simulated time (s)
    #[arg(long, value_name = "S", default_value_t = 8.0)]
    end_time: f64,
    #[command(flatten)]
    common: Common,
}

impl Options {
    fn check(&self) -> Result<(), Refused> {
        let cells = START / self.spacing;
        let whole = (2e-4..=START).contains(&self.spacing) && (cells - cells.round()).abs() < 1e-6;
        let even = "give a spacing of which 0.04 m is a whole number: 0.02, 0.01, 0.005, ...";
        Refused::unless(whole, "--spacing", self.spacing, even)?;
        let floats = "the raft has to float: give 200 to 900 kg/m3";
        Refused::unless((200.0..=900.0).contains(&self.density), "--density", self.density, floats)?;
        let upright =
            "give the angle in rad, -0.2 to 0.2: the raft has to reach out of the water with its edge";
        Refused::unless(self.lean.abs() <= 0.2, "--lean", self.lean, upright)?;
        let short = "give the length of a frame in seconds, at most 1, e.g. 0.01";
        Refused::unless((1e-5..=1.0).contains(&self.frame), "--frame", self.frame, short)?;
        let long = "give the simulated time in seconds, at least a frame and at most 1000";
        Refused::unless((self.frame..=1000.0).contains(&self.end_time), "--end-time", self.end_time, long)?;
        self.common.check()
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// The body of another simulator
// ---------------------------------------------------------------------------------------------------------------------

/// A rigid body in the plane. The scene sees points that move with it.
struct Raft<T: Real> {
    mass: T,
    inertia: T,
    centre: Vector<T, 2>,
    angle: T,
    velocity: Vector<T, 2>,
    spin: T,
    /// The points as drawn, from the centre.
    drawn: Vec<Vector<T, 2>>,
    // What the trait shows.
    positions: Vec<Vector<T, 2>>,
    mean_velocities: Vec<Vector<T, 2>>,
    volumes: Vec<T>,
    spacing: T,
}

impl<T: Real> Raft<T> {
    /// A rectangle of points about its `centre`, turned by `angle`.
    fn new(centre: [f64; 2], angle: f64, density: f64, l0: f64) -> Self {
        let drawn =
            basin::lattice(RAFT.map(|edge| -0.5 * edge), RAFT.map(|edge| (edge / l0).round() as usize), l0);
        let (centre, angle) = (Vector::from(centre.map(T::of)), T::of(angle));
        let positions: Vec<_> = drawn.iter().map(|r| centre + turned(r, angle)).collect();
        let mass = density * RAFT[0] * RAFT[1];
        let len = positions.len();
        Self {
            mass: T::of(mass),
            inertia: T::of(mass * (RAFT[0] * RAFT[0] + RAFT[1] * RAFT[1]) / 12.0),
            centre,
            angle,
            velocity: Vector::zeros(),
            spin: T::zero(),
            drawn,
            positions,
            mean_velocities: vec![Vector::zeros(); len],
            volumes: vec![T::of(l0 * l0); len],
            spacing: T::of(l0),
        }
    }
}

/// `r`, turned by `angle`.
fn turned<T: Real>(r: &Vector<T, 2>, angle: T) -> Vector<T, 2> {
    let (sine, cosine) = angle.sin_cos();
    Vector::from([cosine * r[0] - sine * r[1], sine * r[0] + cosine * r[1]])
}

impl<T: Real> Structure<T, 2> for Raft<T> {
    fn positions(&self) -> &[Vector<T, 2>] {
        &self.positions
    }

    fn mean_velocities(&self) -> &[Vector<T, 2>] {
        &self.mean_velocities
    }

    fn volumes(&self) -> &[T] {
        &self.volumes
    }

    fn spacing(&self) -> T {
        self.spacing
    }

    fn max_step(&self, _: &Parallel) -> T {
        // Nothing in a rigid body vibrates.
        T::of(f64::INFINITY)
    }

    fn advance(
        &mut self,
        _: &Parallel,
        force: &[Vector<T, 2>],
        gravity: &Vector<T, 2>,
        dt: T,
        _: usize,
    ) -> Result<(), Box<dyn Error + Send + Sync>> {
        let (mut push, mut torque) = (Vector::<T, 2>::zeros(), T::zero());
        for (f, r) in force.iter().zip(&self.positions) {
            let arm = r - self.centre;
            push += f;
            torque += arm[0] * f[1] - arm[1] * f[0];
        }
        // The impulse first, then the motion: the contract of the trait. One step does, whatever the number of sub-steps.
        self.velocity += (push / self.mass + gravity) * dt;
        self.spin += torque / self.inertia * dt;
        self.centre += self.velocity * dt;
        self.angle += self.spin * dt;
        let fields = self.positions.iter_mut().zip(&mut self.mean_velocities);
        for ((place, mean), drawn) in fields.zip(&self.drawn) {
            let now = self.centre + turned(drawn, self.angle);
            *mean = (now - *place) / dt;
            *place = now;
        }
        Ok(())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn energy(&self, _: &Parallel, gravity: &Vector<T, 2>) -> StructureEnergy<T> {
        let half = T::of(0.5);
        StructureEnergy {
            kinetic: half * (self.mass * self.velocity.norm_squared() + self.inertia * self.spin * self.spin),
            strain: T::zero(),
            potential: -self.mass * gravity.dot(&self.centre),
        }
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// The time loop of another simulator
// ---------------------------------------------------------------------------------------------------------------------

/// Water and raft.
type Pond<T> = Scene<T, 2, WendlandGradient, ArtificialViscosity<T>>;

/// Brings the scene forward by exactly `frame` \[s\], in as many steps as it needs.
///
/// The last two are of one length, so that no crumb is left at the end of a frame: velocities are displacements over the
/// length of a step, and over a step of nothing but round-off they would be noise.
fn advance<T: Real>(scene: &mut Pond<T>, parallel: &Parallel, frame: f64) -> Result<(), Failure> {
    let (mut left, mut last) = (frame, f64::INFINITY);
    while left > 1e-6 * frame {
        let longest = if left > last && left < 2.0 * last { 0.5 * left } else { left };
        last = scene.step(parallel, T::of(longest))?.to_double();
        left -= last;
    }
    Ok(())
}

/// Water at rest with the raft in it.
fn pond<T: Real>(options: &Options, parallel: &Parallel) -> Result<Pond<T>, Failure> {
    let l0 = options.spacing;
    let mut config = basin::water(l0, 10.0 * (GRAVITY * WATER[1]).sqrt());
    config.gravity = Vector::from([0.0, -GRAVITY].map(T::of));
    let counts = WATER.map(|edge| (edge / l0).round() as usize);
    let centre = [0.5 * WATER[0], WATER[1] - START + 0.5 * RAFT[1]];
    // With a margin: half a spacing from the raft its water begins, and a particle much closer would be in it.
    let in_raft = |r: &Vector<T, 2>| {
        let from_centre = Vector::from([0, 1].map(|axis| r[axis].to_double() - centre[axis]));
        let r = turned(&from_centre, -options.lean);
        [0, 1].iter().all(|&axis| r[axis].abs() < 0.5 * RAFT[axis] + 0.25 * l0)
    };
    let places = basin::lattice([0.0; 2], counts, l0).into_iter().filter(|r| !in_raft(r)).collect();
    let mut particles = FluidParticles::at_rest(places);
    basin::press(&mut particles, &config, |r| T::of(RHO * GRAVITY) * (T::of(WATER[1]) - r[1]));
    let (c, walls) = (config.sound_speed, basin::walls(counts, Some(counts[1] / 2), l0));
    let viscosity = |reference: &_| ArtificialViscosity::new::<2>(T::of(ALPHA), c, reference);
    let fluid = Fluid::new(config, WendlandGradient, viscosity, Open, particles, walls)?;
    let mut scene = Scene::new(fluid);
    let raft = Raft::<T>::new(centre, options.lean, options.density, l0);
    scene.add_structure(parallel, Box::new(raft), Slip::Free)?;
    Ok(scene)
}

/// Draught \[m\], from the place of the raft and the volume of the water, which both are exact; and the roll \[rad\].
fn floats<T: Real>(scene: &Pond<T>) -> [f64; 2] {
    let Some(raft) = scene.structure(0).and_then(|body| body.as_any().downcast_ref::<Raft<T>>()) else {
        return [f64::NAN; 2];
    };
    // Level of the water: W level = water + RAFT[0] (level - bottom), upright.
    let fluid = scene.fluid();
    let water = fluid.particles().position.len() as f64 * fluid.config().particle_volume().to_double();
    let bottom = raft.centre[1].to_double() - 0.5 * RAFT[1];
    let level = (water - RAFT[0] * bottom) / (WATER[0] - RAFT[0]);
    [level - bottom, raft.angle.to_double()]
}

/// The host: its frames, and what it looks at.
struct Host<'a, T: Real> {
    scene: &'a mut Pond<T>,
    parallel: &'a Parallel,
    frame: f64,
    frames: u64,
    csv: CsvWriter,
    probe: Due,
    /// Time \[s\], draught \[m\] and roll \[rad\].
    samples: Vec<[f64; 3]>,
}

impl<T: Real> Recorded for Host<'_, T> {
    fn time(&self) -> f64 {
        self.frames as f64 * self.frame
    }

    fn steps(&self) -> u64 {
        self.frames
    }

    fn look(&mut self, _: f64, last: bool) -> Result<(), Failure> {
        let time = self.time();
        if self.probe.is_due(time) || last {
            let [draught, roll] = floats(self.scene);
            self.samples.push([time, draught, roll]);
            let inner = self.scene.fluid().time().to_double();
            self.csv.row(&[time, inner, self.scene.fluid().steps() as f64, draught, roll])?;
        }
        Ok(())
    }

    fn step(&mut self) -> Result<f64, Failure> {
        advance(self.scene, self.parallel, self.frame)?;
        self.frames += 1;
        Ok(self.frame)
    }

    fn keep_wreck(&mut self) -> Result<(), Failure> {
        Ok(())
    }
}

fn main() -> ExitCode {
    let options = Options::parse();
    exit_code(match options.common.precision {
        Precision::F32 => run::<f32>(&options),
        Precision::F64 => run::<f64>(&options),
    })
}

fn run<T: Real>(options: &Options) -> Result<(), Failure> {
    options.check()?;
    let parallel = options.common.parallel()?;
    let dir = options.common.output("embed")?;
    let mut scene = pond::<T>(options, &parallel)?;
    let columns = [
        "time of the host [s]",
        "time of the water [s]",
        "steps of the water [-]",
        "draught [m]",
        "roll [rad]",
    ];
    let csv = CsvWriter::create(dir.join("probes.csv"), &columns)?;
    let (frame, probe) = (options.frame, Due::every(0.02_f64.max(options.frame)));
    let mut host =
        Host { scene: &mut scene, parallel: &parallel, frame, frames: 0, csv, probe, samples: Vec::new() };
    let (watch, mut seconds) = (Watch::begin(&dir, &options.common)?, 0.0);
    // Inside the pool the loops of a step need no hand-over between threads.
    let done = parallel.install(|| record(&mut host, options.end_time, &watch, &mut seconds));

    // Whatever happened, what has been computed is kept.
    let (samples, simulated) = (core::mem::take(&mut host.samples), host.time());
    let exact = options.density / RHO * RAFT[1];
    plot(&dir, options, &samples, exact)?;
    let particles = scene.fluid().particles().position.len();
    let mut summary = Summary::new("embed", env!("CARGO_PKG_VERSION"));
    summary.set("spacing_m", options.spacing);
    summary.set("raft_density_kg_m3", options.density);
    summary.set("lean_rad", options.lean);
    summary.set("frame_s", options.frame);
    summary.set("end_time_s", options.end_time);
    summary.particles.insert("fluid".into(), particles as u64);
    let (threads, steps) = (parallel.threads(), scene.fluid().steps());
    let cost = Cost { threads, steps, seconds, simulated, particles };
    cost.enter(&mut summary, &options.common, done.as_ref().err());
    let read: Vec<_> = samples.iter().filter(|s| s[0] >= (1.0 - READ) * options.end_time).collect();
    let mean =
        |k: usize| (!read.is_empty()).then(|| read.iter().map(|s| s[k]).sum::<f64>() / read.len() as f64);
    let draught = mean(1).map(|d| Metric::new(d, "m").compared_with(exact, "Archimedes"));
    let roll = mean(2).map(|angle| Metric::new(angle, "rad").compared_with(0.0, "symmetry"));
    let apart = Metric::new(scene.fluid().time().to_double() - simulated, "s")
        .compared_with(0.0, "the water keeps the time of the host");
    let residual = Metric::new(scene.budget().residual.to_double(), "-");
    enter_results(
        &mut summary,
        [
            ("draught".to_owned(), draught),
            ("roll".to_owned(), roll),
            ("clocks_apart".to_owned(), Some(apart)),
            ("interface_momentum_residual".to_owned(), Some(residual)),
        ],
    );
    conclude(&dir, &summary, &options.common, done.is_ok())?;
    done
}

fn plot(dir: &Path, options: &Options, samples: &[[f64; 3]], exact: f64) -> Result<(), Failure> {
    let column = |k: usize| samples.iter().map(|s| s[k]).collect::<Vec<_>>();
    let title = format!("Raft of {} kg/m³, l₀ = {} mm", options.density, options.spacing * 1e3);
    CurvePlot::new(&title, "time [s]", "draught [m]")
        .line("this run", &column(0), &column(1))
        .dashed("Archimedes", &[0.0, options.end_time], &[exact; 2])
        .write_png(dir.join("draught.png"))?;
    Ok(())
}
