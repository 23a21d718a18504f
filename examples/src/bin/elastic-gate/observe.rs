//! What is watched while the gate opens: its free end, the energies, and every way out for the water.

use crate::setup::{FreeEnd, GATE_THICKNESS, GateScene, RESERVOIR_WIDTH, WALL_HEIGHT, WATER_DEPTH, free_end};
use mps_examples::Failure;
use mps_io::CsvWriter;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Parallel;
use std::path::Path;

/// Columns of `probes.csv`.
const COLUMNS: &[&str] = &[
    "time [s]",
    "gate corner x [m]",
    "gate corner y [m]",
    "gate middle x [m]",
    "gate middle y [m]",
    "water level at half width [m]",
    "energy [J/m]",
    "fluid kinetic [J/m]",
    "fluid potential [J/m]",
    "fluid compression [J/m]",
    "gate kinetic [J/m]",
    "gate strain [J/m]",
    "gate potential [J/m]",
    "work on gate [J/m]",
    "time step [s]",
    "sub-steps [-]",
    "wetted gate points [-]",
    "impulse on gate x [N s/m]",
    "impulse on gate y [N s/m]",
    "angular impulse on gate about the origin [N s]",
    "of it off the lines of the pairs [N s]",
];

/// The record of a run.
pub(crate) struct Observer<T: Real> {
    csv: CsvWriter,
    across: usize,
    reference: Vec<Vector<T, 2>>,
    /// Time \[s\] and displacements of the free end \[m\].
    pub(crate) end: Vec<(f64, FreeEnd)>,
    /// Potential energy of the water at the start \[J/m\].
    energy_scale: f64,
    lowest_energy: f64,
    /// Largest rise of the total energy above an earlier value, over the energy the water can give.
    pub(crate) energy_rise: f64,
    /// Total energy at the start \[J/m\].
    first_energy: Option<f64>,
    /// Which side of the gate each particle was on, by identity; 2 once it has leaked.
    side: Vec<u8>,
}

const UPSTREAM: u8 = 0;
const DOWNSTREAM: u8 = 1;
const LEAKED: u8 = 2;

impl<T: Real> Observer<T> {
    pub(crate) fn new<K: Kernel<T>>(
        dir: &Path,
        scene: &GateScene<T, K>,
        across: usize,
        parallel: &Parallel,
    ) -> Result<Self, Failure> {
        let particles = scene.fluid().particles().position.len();
        let potential = scene.energy(parallel).0.potential.to_double();
        Ok(Self {
            csv: CsvWriter::create(dir.join("probes.csv"), COLUMNS)?,
            across,
            reference: gate_positions(scene).to_vec(),
            end: Vec::new(),
            energy_scale: potential,
            lowest_energy: f64::INFINITY,
            energy_rise: 0.0,
            first_energy: None,
            side: vec![UPSTREAM; particles],
        })
    }

    /// Called every few steps: energy and leaks, which must not be missed between two rows.
    pub(crate) fn watch<K: Kernel<T>>(&mut self, scene: &GateScene<T, K>, parallel: &Parallel) {
        let (fluid, gate) = scene.energy(parallel);
        let total = fluid.total().to_double() + gate.total().to_double();
        self.first_energy.get_or_insert(total);
        // At the first look the lowest energy is infinite and the rise negative.
        self.energy_rise = self.energy_rise.max((total - self.lowest_energy) / self.energy_scale);
        self.lowest_energy = self.lowest_energy.min(total);
        self.watch_leaks(scene);
    }

    /// Writes a row of `probes.csv`.
    pub(crate) fn record<K: Kernel<T>>(
        &mut self,
        scene: &mut GateScene<T, K>,
        parallel: &Parallel,
        dt: f64,
    ) -> Result<(), Failure> {
        scene.update_interfaces(parallel);
        let time = scene.fluid().time().to_double();
        let end = free_end(gate_positions(scene), &self.reference, self.across);
        self.end.push((time, end));
        let (fluid, gate) = scene.energy(parallel);
        let handed = scene.budget().handed.first().copied().unwrap_or_default();
        let wetted = scene.interface(0).map_or(0, |interface| interface.wetted_count());
        self.csv.row(&[
            time,
            end.corner[0],
            end.corner[1],
            end.middle[0],
            end.middle[1],
            water_level(scene),
            fluid.total().to_double() + gate.total().to_double(),
            fluid.kinetic.to_double(),
            fluid.potential.to_double(),
            fluid.compression.to_double(),
            gate.kinetic.to_double(),
            gate.strain.to_double(),
            gate.potential.to_double(),
            scene.budget().work().to_double(),
            dt,
            scene.substeps() as f64,
            wetted as f64,
            handed.push.force.x.to_double(),
            handed.push.force.y.to_double(),
            handed.push.moment[(0, 1)].to_double(),
            handed.off_line[(0, 1)].to_double(),
        ])?;
        Ok(())
    }

    /// Particles that have left otherwise than through the opening.
    pub(crate) fn leaked(&self) -> usize {
        self.side.iter().filter(|&&s| s == LEAKED).count()
    }

    /// Energy lost since the start over the energy the water can give.
    pub(crate) fn dissipated(&self) -> f64 {
        self.first_energy.map_or(0.0, |first| (first - self.lowest_energy) / self.energy_scale)
    }

    /// A particle has leaked if it is behind the left wall, below the floor, or has come to the other
    /// side of the middle line of gate and wall while above the free end by more than a particle.
    fn watch_leaks<K: Kernel<T>>(&mut self, scene: &GateScene<T, K>) {
        let l0 = scene.fluid().config().spacing.to_double();
        let line = middle_line(gate_positions(scene), self.across);
        let lowest = line[0][1];
        let particles = scene.fluid().particles();
        for (r, &id) in particles.position.iter().zip(&particles.id) {
            let side = &mut self.side[id as usize];
            let (x, y) = (r[0].to_double(), r[1].to_double());
            if x < -0.5 * l0 || y < -0.5 * l0 {
                *side = LEAKED;
            }
            if *side == LEAKED || y > WALL_HEIGHT {
                continue;
            }
            let now = if x > line_at(&line, y) { DOWNSTREAM } else { UPSTREAM };
            if now != *side && y > lowest + l0 {
                *side = LEAKED;
            } else {
                *side = now;
            }
        }
    }
}

/// Positions of the gate's particles.
pub(crate) fn gate_positions<T: Real, K: Kernel<T>>(scene: &GateScene<T, K>) -> &[Vector<T, 2>] {
    scene.structure(0).map_or(&[], |gate| gate.positions())
}

/// Middle of each row of the gate, from the free end up.
fn middle_line<T: Real>(positions: &[Vector<T, 2>], across: usize) -> Vec<[f64; 2]> {
    let middle = |row: &[Vector<T, 2>]| {
        let sum = row.iter().fold([0.0; 2], |s, r| [s[0] + r[0].to_double(), s[1] + r[1].to_double()]);
        [sum[0] / across as f64, sum[1] / across as f64]
    };
    positions.chunks_exact(across).map(middle).collect()
}

/// Where the middle line of gate and wall is at height `y`.
fn line_at(line: &[[f64; 2]], y: f64) -> f64 {
    let above = line.partition_point(|p| p[1] < y);
    match (above.checked_sub(1).and_then(|k| line.get(k)), line.get(above)) {
        (Some(a), Some(b)) => a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]),
        (None, Some(end)) => end[0],
        _ => RESERVOIR_WIDTH + 0.5 * GATE_THICKNESS,
    }
}

/// Highest water within two spacings of the middle of the reservoir that hangs together with what
/// is below it: spray does not count \[m\].
fn water_level<T: Real, K: Kernel<T>>(scene: &GateScene<T, K>) -> f64 {
    let l0 = scene.fluid().config().spacing.to_double();
    let near = |r: &&Vector<T, 2>| (r[0].to_double() - 0.5 * RESERVOIR_WIDTH).abs() < 2.0 * l0;
    let mut heights: Vec<f64> =
        scene.fluid().particles().position.iter().filter(near).map(|r| r[1].to_double()).collect();
    heights.sort_unstable_by(f64::total_cmp);
    let mut level = 0.0;
    for height in heights {
        if height > level + 2.5 * l0 || height > 2.0 * WATER_DEPTH {
            break;
        }
        level = height;
    }
    level + 0.5 * l0
}
