//! CSM1: the flag at rest under its own weight.

use crate::options::Options;
use crate::{Settings, WRITTEN, look, plots};
use mps_examples::solid::flag::{CSM1, Flag, RUBBER, SOURCE, end, flag, gravity};
use mps_examples::{Cost, Failure, conclude};
use mps_io::{CsvWriter, Metric, Progress};
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_solid::{MaterialPoint, Relaxation, Settled, SolidParticles};
use std::path::Path;
use std::time::Instant;

/// Steps between two rows of probes.csv.
const PROBE_EVERY: usize = 500;
/// The first answer is one with this many times the forces left: how much the last one differs from it shows what the
/// tolerance is worth.
const COARSER: f64 = 100.0;
/// Motion of the flag until the forces are balanced, about \[s\]: for the time left.
const USUAL: f64 = 4.0;

pub(crate) fn run<T: Real>(options: &Options, settings: &Settings, dir: &Path) -> Result<(), Failure> {
    let parallel = options.common.parallel()?;
    let mut flag = flag::<T>(settings.across, settings.clamp, &RUBBER, &parallel)?;
    let tip = flag.point(end())?;
    let table = CsvWriter::create(dir.join("probes.csv"), &["step [-]", "tip x [m]", "tip y [m]"])?;
    let dt = flag.max_step(&parallel).to_double();
    let mut watch = Watch { tip, table, progress: Progress::new(options.common.quiet, USUAL), dt, steps: 0 };
    let clock = Instant::now();
    let (settled, answers) = parallel.install(|| -> Result<_, Failure> {
    remove_leftovers(dir, WRITTEN)?;
        watch.settle(&mut flag, settings.tolerance * COARSER, &parallel)?;
        let coarser = watch.displacement(flag.particles());
        let settled = watch.settle(&mut flag, settings.tolerance, &parallel)?;
        Ok((settled, [coarser, watch.displacement(flag.particles())]))
    })?;
    let seconds = clock.elapsed().as_secs_f64();
    watch.progress.finish(watch.steps as f64 * dt, watch.steps);

    plots::middle_line(dir, settings, &flag)?;
    if !options.common.no_fields {
        Pictures::new(dir, look(options.test, settings))?.keep(&flag, 0.0, "rest")?;
    }
    let mut summary = options.summary(settings, &flag);
    summary.set("tolerance", settings.tolerance);
    let (threads, steps, particles) = (parallel.threads(), watch.steps, flag.len());
    // Nothing is simulated but the way to rest.
    Cost { threads, steps, seconds, simulated: steps as f64 * dt, particles }.enter(
        &mut summary,
        &options.common,
        None,
    );
    let mut put = |name: &str, metric| drop(summary.metrics.insert(name.to_owned(), metric));
    let [coarser, [x, y]] = answers;
    put("ux", Metric::new(x, "m").compared_with(CSM1[0], SOURCE));
    put("uy", Metric::new(y, "m").compared_with(CSM1[1], SOURCE));
    put("tolerance_effect", Metric::new(y / coarser[1] - 1.0, "-"));
    put("residual", Metric::new(settled.residual.to_double(), "-"));
    conclude(dir, &summary, &options.common, true)
}

/// Looks on while the flag comes to rest.
struct Watch<T: Real> {
    tip: MaterialPoint<T, 2>,
    table: CsvWriter,
    progress: Progress,
    dt: f64,
    steps: u64,
}

impl<T: Real> Watch<T> {
    fn settle(
        &mut self,
        flag: &mut Flag<T>,
        tolerance: f64,
        parallel: &Parallel,
    ) -> Result<Settled<T>, Failure> {
        let relaxation = Relaxation { tolerance: T::of(tolerance), max_steps: 10_000_000 };
        let mut written = Ok(());
        let settled = flag.relax(
            parallel,
            &gravity(),
            |particles, _| {
                if written.is_ok() {
                    written = self.look(particles);
                }
            },
            &relaxation,
        )?;
        written?;
        Ok(settled)
    }

    fn look(&mut self, particles: &SolidParticles<T, 2>) -> Result<(), Failure> {
        if self.steps.is_multiple_of(PROBE_EVERY as u64) {
            let [x, y] = self.displacement(particles);
            self.table.row(&[self.steps as f64, x, y])?;
            self.progress.update(
                self.steps as f64 * self.dt,
                self.steps,
                self.dt,
                format_args!("uy = {y:.4} m"),
            );
        }
        self.steps += 1;
        Ok(())
    }

    fn displacement(&self, particles: &SolidParticles<T, 2>) -> [f64; 2] {
        let moved: Vector<T, 2> = self.tip.value(particles.positions()) - self.tip.reference();
        moved.map(Real::to_double).into()
    }
}
