//! What is watched: drag, lift, the end of the flag, pressure along the channel.

use crate::setup::{Channel, FLAG, Flag};
use mps_examples::Failure;
use mps_examples::solid::flag::end;
use mps_io::CsvWriter;
use mps_kernel::{Real, Vector};
use mps_neighbors::Parallel;
use mps_solid::MaterialPoint;
use std::path::Path;

/// Columns of `probes.csv`.
const COLUMNS: &[&str] = &[
    "time [s]",
    "end x [m]",
    "end y [m]",
    "drag [N/m]",
    "lift [N/m]",
    "mean pressure beyond the level [Pa]",
    "mean speed [m/s]",
    "largest speed [m/s]",
    "fluid particles [-]",
    "flag kinetic [J/m]",
    "flag strain [J/m]",
    "work on flag [J/m]",
    "time step [s]",
    "sub-steps [-]",
    "impulse on flag x [N s/m]",
    "impulse on flag y [N s/m]",
    "angular impulse on flag about the origin [N s]",
    "of it off the lines of the pairs [N s]",
];

/// One row of the record.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// \[s\].
    pub(crate) time: f64,
    /// Displacement of the end A \[m\].
    pub(crate) end: [f64; 2],
    /// Force of the fluid on cylinder and flag, mean since the last row \[N/m\].
    pub(crate) force: [f64; 2],
}

/// The record of a run.
pub(crate) struct Observer<T: Real> {
    csv: CsvWriter,
    end: Option<MaterialPoint<T, 2>>,
    impulse: [f64; 2],
    /// Level of the pressure \[Pa\].
    level: f64,
    pub(crate) samples: Vec<Sample>,
}

impl<T: Real> Observer<T> {
    pub(crate) fn new(dir: &Path, level: f64, scene: &Channel<T>) -> Result<Self, Failure> {
        let end = elastic(scene).map(|flag| flag.solid().point(end())).transpose()?;
        let csv = CsvWriter::create(dir.join("probes.csv"), COLUMNS)?;
        Ok(Self { csv, end, impulse: [0.0; 2], level, samples: Vec::new() })
    }

    /// Drag in the last row \[N/m\].
    pub(crate) fn drag(&self) -> f64 {
        self.samples.last().map_or(0.0, |sample| sample.force[0])
    }

    /// Writes a row of `probes.csv`.
    pub(crate) fn record(&mut self, scene: &Channel<T>, parallel: &Parallel, dt: f64) -> Result<(), Failure> {
        let time = scene.fluid().time().to_double();
        let displacement = match (elastic(scene), &self.end) {
            (Some(flag), Some(end)) => {
                (end.value(flag.solid().positions()) - end.reference()).map(Real::to_double)
            }
            _ => Vector::zeros(),
        };
        let impulse: [f64; 2] = scene.budget().impulse().map(Real::to_double).into();
        let since = self.samples.last().map_or(f64::INFINITY, |sample| time - sample.time);
        let force = [0, 1].map(|axis| (impulse[axis] - self.impulse[axis]) / since);
        self.impulse = impulse;
        self.samples.push(Sample { time, end: displacement.into(), force });

        let particles = scene.fluid().particles();
        let count = particles.position.len() as f64;
        let none = (T::zero(), T::zero(), T::zero());
        let (pressure, speed, largest) = parallel.fold(
            particles.position.len(),
            none,
            &|i| (particles.pressure[i], particles.velocity[i][0], particles.velocity[i].norm()),
            &|a, b| (a.0 + b.0, a.1 + b.1, a.2.max(b.2)),
        );
        let (_, bodies) = scene.energy(parallel);
        let flag = scene.budget().handed.get(FLAG).copied().unwrap_or_default();
        self.csv.row(&[
            time,
            displacement[0],
            displacement[1],
            force[0],
            force[1],
            pressure.to_double() / count - self.level,
            speed.to_double() / count,
            largest.to_double(),
            count,
            bodies.kinetic.to_double(),
            bodies.strain.to_double(),
            scene.budget().work().to_double(),
            dt,
            scene.substeps() as f64,
            flag.push.force.x.to_double(),
            flag.push.force.y.to_double(),
            flag.push.moment[(0, 1)].to_double(),
            flag.off_line[(0, 1)].to_double(),
        ])?;
        Ok(())
    }
}

/// The flag, if it is elastic.
pub(crate) fn elastic<T: Real>(scene: &Channel<T>) -> Option<&Flag<T>> {
    scene.structure(FLAG)?.as_any().downcast_ref()
}
