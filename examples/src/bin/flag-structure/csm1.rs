//! CSM1: the flag at rest under its own weight.

use crate::options::Options;
use crate::{Settings, WRITTEN, look, plots};
use mps_examples::solid::flag::{CSM1, Flag, RUBBER, SOURCE, end, flag, gravity};
use mps_examples::solid::{Pictures, settle};
use mps_examples::{Cost, Failure, Stopped, Watch, conclude, enter_results, remove_leftovers};
use mps_io::{CsvWriter, Metric, Progress};
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_solid::{MaterialPoint, Relaxation, Settled, SolidParticles};
use std::path::Path;
use std::time::Instant;

/// Steps between two rows of probes.csv.
const PROBE_EVERY: usize = 500;
/// Steps, each of some microseconds, between two looks whether somebody wants the end.
const ASK_EVERY: u64 = 64;
/// The first answer is one with this many times the forces left: how much the last one differs from it shows what the
/// tolerance is worth.
const COARSER: f64 = 100.0;
/// The most that may be left of the load in the first answer: with all of it nothing would be answered.
const COARSEST: f64 = 0.5;
/// Motion of the flag until the forces are balanced, about \[s\]: for the time left.
const USUAL: f64 = 4.0;

pub(crate) fn run<T: Real>(options: &Options, settings: &Settings, dir: &Path) -> Result<(), Failure> {
    let parallel = options.common.parallel()?;
    let mut flag = flag::<T>(settings.across, settings.clamp, &RUBBER, &parallel)?;
    let tip = flag.point(end())?;
    remove_leftovers(dir, WRITTEN)?;
    let table = CsvWriter::create(dir.join("probes.csv"), &["step [-]", "tip x [m]", "tip y [m]"])?;
    let dt = flag.max_step(&parallel).to_double();
    let watch = Watch::begin(dir, &options.common)?;
    let progress = Progress::new(options.common.quiet, USUAL);
    let mut way = Way { tip, table, watch, progress, dt, steps: 0 };
    let coarser = (settings.tolerance * COARSER).min(COARSEST);
    let (clock, mut answers) = (Instant::now(), Vec::new());
    let done = parallel.install(|| -> Result<(), Failure> {
        for tolerance in [coarser, settings.tolerance] {
            let settled = way.settle(&mut flag, tolerance, &parallel)?;
            answers.push((way.displacement(flag.particles()), settled.residual.to_double()));
        }
        Ok(())
    });
    let seconds = clock.elapsed().as_secs_f64();
    way.progress.finish(way.steps as f64 * dt, way.steps);
    match &done {
        Ok(()) => tracing::info!(steps = way.steps, seconds, "completed"),
        Err(failure) if failure.is::<Stopped>() => tracing::warn!(steps = way.steps, seconds, "{failure}"),
        Err(failure) => tracing::error!(steps = way.steps, seconds, "{failure}"),
    }

    // Whatever happened, what has been computed is kept.
    if done.is_ok() {
        plots::middle_line(dir, settings, &flag)?;
        if !options.common.no_fields {
            Pictures::new(dir, look(options.test, settings))?.keep(&flag, 0.0, "rest")?;
        }
    }
    let mut summary = options.summary(settings, &flag);
    summary.set("tolerance", settings.tolerance);
    let (threads, steps, particles) = (parallel.threads(), way.steps, flag.len());
    // Nothing is simulated but the way to rest.
    Cost { threads, steps, seconds, simulated: steps as f64 * dt, particles }.enter(
        &mut summary,
        &options.common,
        done.as_ref().err(),
    );
    enter_results(&mut summary, results(&answers));
    conclude(dir, &summary, &options.common, done.is_ok())?;
    done
}

/// Of the two answers, as far as they are there: displacement of the end \[m\] and what was left of the load.
fn results(answers: &[([f64; 2], f64)]) -> [(String, Option<Metric>); 4] {
    let (coarser, last) = (answers.first(), answers.get(1));
    let compared =
        |axis: usize| last.map(|(end, _)| Metric::new(end[axis], "m").compared_with(CSM1[axis], SOURCE));
    let effect = last.zip(coarser).map(|(last, coarser)| Metric::new(last.0[1] / coarser.0[1] - 1.0, "-"));
    [
        ("ux".to_owned(), compared(0)),
        ("uy".to_owned(), compared(1)),
        ("tolerance_effect".to_owned(), effect),
        ("residual".to_owned(), last.map(|(_, residual)| Metric::new(*residual, "-"))),
    ]
}

/// Looks on while the flag comes to rest.
struct Way<T: Real> {
    tip: MaterialPoint<T, 2>,
    table: CsvWriter,
    watch: Watch,
    progress: Progress,
    dt: f64,
    steps: u64,
}

impl<T: Real> Way<T> {
    fn settle(
        &mut self,
        flag: &mut Flag<T>,
        tolerance: f64,
        parallel: &Parallel,
    ) -> Result<Settled<T>, Failure> {
        let relaxation = Relaxation { tolerance: T::of(tolerance), max_steps: 10_000_000 };
        settle(flag, parallel, &gravity(), &relaxation, |particles| self.look(particles))
    }

    fn look(&mut self, particles: &SolidParticles<T, 2>) -> Result<(), Failure> {
        let time = self.steps as f64 * self.dt;
        if self.steps.is_multiple_of(PROBE_EVERY as u64) {
            let [x, y] = self.displacement(particles);
            self.table.row(&[self.steps as f64, x, y])?;
            self.progress.update(time, self.steps, self.dt, format_args!("uy = {y:.4} m"));
        }
        let asked = self.steps.is_multiple_of(ASK_EVERY);
        self.steps += 1;
        if asked { self.watch.stopped(time).map_or(Ok(()), Err) } else { Ok(()) }
    }

    fn displacement(&self, particles: &SolidParticles<T, 2>) -> [f64; 2] {
        let moved: Vector<T, 2> = self.tip.value(particles.positions()) - self.tip.reference();
        moved.map(Real::to_double).into()
    }
}
