//! A run with everything that watches it.

use mps_examples::submerged::{CLEARANCE, LENGTH, Settings, THICKNESS, Tank, deflection, end, rubber};
use mps_examples::{Due, Failure, Recorded};
use mps_io::{ColorMap, CsvWriter, FieldOptions, FieldPicture, FieldWriter, PointCloud, View};
use mps_kernel::Real;
use mps_neighbors::Parallel;
use mps_solid::MaterialPoint;
use std::fmt;
use std::path::{Path, PathBuf};

/// Time between two rows of probes.csv, and between two frames of the fields \[s\].
pub(crate) const PROBE: f64 = 0.02;
pub(crate) const FIELD: f64 = 0.5;
/// Columns of `probes.csv`.
const COLUMNS: &[&str] = &[
    "time [s]",
    "deflection [m]",
    "force of the water x [N/m]",
    "force of the water y [N/m]",
    "fluid kinetic [J/m]",
    "beam kinetic [J/m]",
    "beam strain [J/m]",
    "largest speed [m/s]",
    "time step [s]",
    "sub-steps [-]",
];

/// One row of the record.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// \[s\].
    pub(crate) time: f64,
    /// Of the end, the way it is pushed \[m\].
    pub(crate) deflection: f64,
    /// Upward force of the water on the beam, mean since the last row \[N/m\].
    pub(crate) lift: f64,
}

/// Tank, record, and what is written and when.
pub(crate) struct Run<'a, T: Real> {
    scene: &'a mut Tank<T>,
    settings: &'a Settings,
    parallel: &'a Parallel,
    end: MaterialPoint<T, 2>,
    csv: CsvWriter,
    fields: Option<Fields>,
    impulse: [f64; 2],
    samples: Vec<Sample>,
    probe: Due,
    field: Due,
}

impl<'a, T: Real> Run<'a, T> {
    pub(crate) fn new(
        dir: &Path,
        scene: &'a mut Tank<T>,
        settings: &'a Settings,
        parallel: &'a Parallel,
        no_fields: bool,
    ) -> Result<Self, Failure> {
        let end = end(rubber(scene).ok_or("the scene has no beam")?)?;
        let csv = CsvWriter::create(dir.join("probes.csv"), COLUMNS)?;
        let fields = if no_fields { None } else { Some(Fields::new(dir)?) };
        let (probe, field) = (Due::every(PROBE), Due::every(FIELD));
        let samples = Vec::new();
        Ok(Self { scene, settings, parallel, end, csv, fields, impulse: [0.0; 2], samples, probe, field })
    }

    pub(crate) fn into_samples(self) -> Vec<Sample> {
        self.samples
    }

    fn write_row(&mut self, dt: f64) -> Result<(), Failure> {
        let time = self.time();
        let impulse: [f64; 2] = self.scene.budget().impulse().map(Real::to_double).into();
        let since = self.samples.last().map_or(f64::INFINITY, |sample| time - sample.time);
        let force = [0, 1].map(|axis| (impulse[axis] - self.impulse[axis]) / since);
        self.impulse = impulse;
        let deflection = deflection(self.scene, &self.end, self.settings);
        self.samples.push(Sample { time, deflection, lift: force[1] });
        let (fluid, beam) = self.scene.energy(self.parallel);
        let velocity = &self.scene.fluid().particles().velocity;
        let fastest = velocity.iter().map(|u| u.norm().to_double()).fold(0.0, f64::max);
        let [kinetic, beam_kinetic, strain] = [fluid.kinetic, beam.kinetic, beam.strain].map(Real::to_double);
        let substeps = self.scene.substeps() as f64;
        self.csv.row(&[
            time,
            deflection,
            force[0],
            force[1],
            kinetic,
            beam_kinetic,
            strain,
            fastest,
            dt,
            substeps,
        ])?;
        Ok(())
    }
}

impl<T: Real> Recorded for Run<'_, T> {
    fn time(&self) -> f64 {
        self.scene.fluid().time().to_double()
    }

    fn steps(&self) -> u64 {
        self.scene.fluid().steps()
    }

    fn look(&mut self, dt: f64, last: bool) -> Result<(), Failure> {
        let time = self.time();
        if self.probe.is_due(time) || last {
            self.write_row(dt)?;
        }
        let due = self.field.is_due(time) || last;
        if let Some(fields) = self.fields.as_mut().filter(|_| due) {
            fields.write(self.scene, last)?;
        }
        Ok(())
    }

    fn step(&mut self) -> Result<f64, Failure> {
        Ok(self.scene.step(self.parallel, T::of(f64::INFINITY))?.to_double())
    }

    fn keep_wreck(&mut self) -> Result<(), Failure> {
        match &mut self.fields {
            Some(fields) => fields.write(self.scene, true),
            None => Ok(()),
        }
    }

    fn remark(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let deflection = self.samples.last().map_or(0.0, |sample| sample.deflection);
        write!(f, "{} sub-steps, deflection {:.2} mm", self.scene.substeps(), 1e3 * deflection)
    }
}

/// Fields for ParaView and the picture of the end.
struct Fields {
    dir: PathBuf,
    water: FieldWriter,
    beam: FieldWriter,
}

impl Fields {
    fn new(dir: &Path) -> Result<Self, Failure> {
        let fields = dir.join("fields");
        let writer = |name| FieldWriter::new(&fields, name, FieldOptions::default());
        Ok(Self { dir: dir.to_path_buf(), water: writer("water")?, beam: writer("beam")? })
    }

    fn write<T: Real>(&mut self, scene: &Tank<T>, picture: bool) -> Result<(), Failure> {
        let time = scene.fluid().time().to_double();
        let (particles, l0) = (scene.fluid().particles(), scene.fluid().config().spacing.to_double());
        let cloud = PointCloud::new(&particles.position)
            .vector("velocity", &particles.velocity)
            .scalar("pressure", &particles.pressure);
        self.water.write(time, &cloud)?;
        let (Some(beam), Some(forces)) = (scene.structure(0), scene.forces(0)) else { return Ok(()) };
        let cloud = PointCloud::new(beam.positions())
            .vector("velocity", beam.mean_velocities())
            .vector("force of the fluid", forces);
        self.beam.write(time, &cloud)?;
        if picture {
            let view = View::new([-0.02, -0.02], [LENGTH + 0.17, 2.0 * CLEARANCE + THICKNESS + 0.03]);
            let pressures = mps_io::value_range(&particles.pressure);
            FieldPicture::new(1200, view)
                .title("Beam in water")
                .time(time)
                .layer(
                    &particles.position,
                    0.6 * l0,
                    &particles.pressure,
                    pressures,
                    ColorMap::Viridis,
                    "pressure [Pa]",
                )
                .plain(beam.positions(), 0.6 * beam.spacing().to_double(), [60, 60, 60])
                .render()?
                .write_png(self.dir.join("snapshot.png"))?;
        }
        Ok(())
    }
}
