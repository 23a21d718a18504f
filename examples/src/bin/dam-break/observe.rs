//! What is watched while the water runs: front, levels, pressures, energies, and every way out.

use crate::outline::{front, levels};
use crate::sensors::{large_sensor, pressures};
use crate::setup::{DamBreak, HEIGHT, PRESSURE, TANK, TIME};
use mps_examples::Failure;
use mps_fluid::FluidEnergy;
use mps_fluid::surface::Surface;
use mps_io::CsvWriter;
use mps_kernel::{Kernel, Real, Vector};
use mps_neighbors::Parallel;
use std::path::Path;

/// Columns of `probes.csv`.
const COLUMNS: &[&str] = &[
    "time [s]",
    "t sqrt(g/H) [-]",
    "front x/H [-]",
    "p1/(rho g H) [-]",
    "p2/(rho g H) [-]",
    "p3/(rho g H) [-]",
    "p4/(rho g H) [-]",
    "p(70 to 160 mm)/(rho g H) [-]",
    "level 1 h/H [-]",
    "level 2 h/H [-]",
    "level 3 h/H [-]",
    "level 4 h/H [-]",
    "energy [J/m]",
    "kinetic [J/m]",
    "potential [J/m]",
    "compression [J/m]",
    "by viscosity [J/m]",
    "by diffusion [J/m]",
    "by collisions [J/m]",
    "by shifting [J/m]",
    "by walls [J/m]",
    "time step [s]",
];

/// One row of the record, without dimension.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// `t sqrt(g/H)`.
    pub(crate) time: f64,
    /// Distance of the front from the gate, `x/H`.
    pub(crate) front: f64,
    /// `p/(rho g H)` of each sensor.
    pub(crate) pressure: [f64; 4],
    /// The same of the large sensor of another experiment.
    pub(crate) large: f64,
    /// Energy over that of the water at the start: kinetic, potential and compression.
    pub(crate) energy: [f64; 3],
    /// Energy received since the start in the same unit: from viscosity, diffusion, collisions, shifting, walls.
    pub(crate) received: [f64; 5],
}

/// The record of a run.
pub(crate) struct Observer {
    csv: CsvWriter,
    pub(crate) samples: Vec<Sample>,
    /// Potential energy of the water at the start \[J/m\].
    energy_scale: f64,
    first_energy: f64,
    /// Largest part of the change of the energy that no cause explains, over the energy the water can give; `None`
    /// without books.
    pub(crate) energy_open: Option<f64>,
    lowest_energy: f64,
    /// Largest rise of the total energy above an earlier value, over the energy the water can give.
    pub(crate) energy_rise: f64,
    /// Whether each particle, by identity, has ever been outside of the tank.
    leaked: Vec<bool>,
    /// Packing inside the water at the start.
    first_packing: f64,
    /// Growth of the volume of the water from start to end.
    pub(crate) volume_drift: Option<f64>,
    /// Spread of the distance to the nearest neighbour inside the water at the end, over the spacing.
    pub(crate) disorder: Option<f64>,
}

impl Observer {
    pub(crate) fn new<T: Real, K: Kernel<T>>(
        dir: &Path,
        dam: &mut DamBreak<T, K>,
        parallel: &Parallel,
    ) -> Result<Self, Failure> {
        let energy = dam.fluid().energy(parallel);
        Ok(Self {
            csv: CsvWriter::create(dir.join("probes.csv"), COLUMNS)?,
            samples: Vec::new(),
            energy_scale: energy.potential.to_double(),
            first_energy: energy.total().to_double(),
            energy_open: dam.fluid().budget().map(|_| 0.0),
            lowest_energy: energy.total().to_double(),
            energy_rise: 0.0,
            leaked: vec![false; dam.fluid().particles().position.len()],
            first_packing: inner_packing(dam, parallel)?,
            volume_drift: None,
            disorder: None,
        })
    }

    /// Called every few steps: energy and leaks, which must not be missed between two rows.
    pub(crate) fn watch<T: Real, K: Kernel<T>>(&mut self, dam: &DamBreak<T, K>, parallel: &Parallel) {
        let total = dam.fluid().energy(parallel).total().to_double();
        self.energy_rise = self.energy_rise.max((total - self.lowest_energy) / self.energy_scale);
        self.lowest_energy = self.lowest_energy.min(total);
        if let (Some(largest), Some(budget)) = (&mut self.energy_open, dam.fluid().budget()) {
            let open = (total - self.first_energy - budget.total().to_double()).abs() / self.energy_scale;
            *largest = largest.max(open);
        }
        let particles = dam.fluid().particles();
        let out = -0.5 * dam.fluid().config().spacing.to_double();
        for (r, &id) in particles.position.iter().zip(&particles.id) {
            let (x, y) = (r[0].to_double(), r[1].to_double());
            self.leaked[id as usize] |= x < out || y < out || TANK - x < out;
        }
    }

    /// Writes a row of `probes.csv`.
    pub(crate) fn record<T: Real, K: Kernel<T>>(
        &mut self,
        dam: &DamBreak<T, K>,
        parallel: &Parallel,
        dt: f64,
    ) -> Result<(), Failure> {
        let fluid = dam.fluid();
        let (particles, l0) = (fluid.particles(), fluid.config().spacing.to_double());
        let seconds = fluid.time().to_double();
        let energy = fluid.energy(parallel);
        let FluidEnergy { kinetic, potential, compression } = energy;
        let parts = [kinetic, potential, compression].map(|e| e.to_double());
        let budget = fluid.budget().unwrap_or_default();
        let received =
            [budget.viscosity, budget.diffusion, budget.collisions, budget.shifting, budget.boundary]
                .map(|e| e.to_double());
        let sample = Sample {
            time: seconds / TIME,
            front: front(&particles.position, l0) / HEIGHT,
            pressure: pressures(fluid.boundary(), l0).map(|p| p / PRESSURE),
            large: large_sensor(fluid.boundary(), l0) / PRESSURE,
            energy: parts.map(|e| e / self.energy_scale),
            received: received.map(|e| e / self.energy_scale),
        };
        self.samples.push(sample);
        let [p1, p2, p3, p4] = sample.pressure;
        let [h1, h2, h3, h4] = levels(&particles.position, l0).map(|h| h / HEIGHT);
        let mut row = vec![seconds, sample.time, sample.front, p1, p2, p3, p4, sample.large, h1, h2, h3, h4];
        row.push(energy.total().to_double());
        row.extend(parts.iter().chain(&received));
        row.push(dt);
        self.csv.row(&row)?;
        Ok(())
    }

    /// Called at the end of a completed run.
    pub(crate) fn finish<T: Real, K: Kernel<T>>(
        &mut self,
        dam: &mut DamBreak<T, K>,
        parallel: &Parallel,
    ) -> Result<(), Failure> {
        self.volume_drift = Some(self.first_packing / inner_packing(dam, parallel)? - 1.0);
        let l0 = dam.fluid().config().spacing.to_double();
        let inner = inner(dam, parallel)?;
        let places: Vec<_> =
            inner.iter().map(|&i| dam.fluid().particles().position[i].map(Real::to_double)).collect();
        self.disorder = Some(spread_of_nearest(places) / l0);
        Ok(())
    }

    /// Particles that have been outside of the tank.
    pub(crate) fn leaked(&self) -> usize {
        self.leaked.iter().filter(|leaked| **leaked).count()
    }

    /// Energy lost since the start over the energy the water can give.
    pub(crate) fn dissipated(&self) -> f64 {
        (self.first_energy - self.lowest_energy) / self.energy_scale
    }
}

/// Particles that are not at the surface.
fn inner<T: Real, K: Kernel<T>>(
    dam: &mut DamBreak<T, K>,
    parallel: &Parallel,
) -> Result<Vec<usize>, Failure> {
    let mut surface = Vec::new();
    dam.fluid_mut().classify_surface(parallel, &mut surface)?;
    Ok((0..surface.len()).filter(|&i| surface[i] == Surface::Inner).collect())
}

/// Median of the packing (sum of weights over that of the lattice) of the particles that are not at the
/// surface. A volume that grows shows as a packing that falls.
fn inner_packing<T: Real, K: Kernel<T>>(
    dam: &mut DamBreak<T, K>,
    parallel: &Parallel,
) -> Result<f64, Failure> {
    let inner = inner(dam, parallel)?;
    let mut packing: Vec<f64> = inner.iter().map(|&i| dam.fluid().packing()[i].to_double()).collect();
    packing.sort_unstable_by(f64::total_cmp);
    Ok(packing.get(packing.len() / 2).copied().unwrap_or(1.0))
}

/// Standard deviation of the distance to the nearest neighbour: 0 on a lattice.
fn spread_of_nearest(mut places: Vec<Vector<f64, 2>>) -> f64 {
    places.sort_unstable_by(|a, b| a.x.total_cmp(&b.x));
    let nearest = |i: usize| {
        let near = |nearest: f64, j: usize| nearest.min((places[j] - places[i]).norm());
        // Beyond the nearest so far along x there is nothing nearer.
        let mut found = f64::INFINITY;
        for j in (0..i).rev() {
            if places[i].x - places[j].x > found {
                break;
            }
            found = near(found, j);
        }
        for j in i + 1..places.len() {
            if places[j].x - places[i].x > found {
                break;
            }
            found = near(found, j);
        }
        found
    };
    let distances: Vec<f64> = (0..places.len()).map(nearest).filter(|d| d.is_finite()).collect();
    let count = distances.len().max(1) as f64;
    let mean = distances.iter().sum::<f64>() / count;
    (distances.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / count).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lattice_has_no_disorder_and_a_disturbed_one_has() {
        let lattice = |size: f64| {
            let place =
                |k: usize| Vector::from([(k % 9) as f64 + size * ((k * k) as f64).sin(), (k / 9) as f64]);
            spread_of_nearest((0..81).map(place).collect())
        };
        assert!(lattice(0.0) < 1e-12);
        assert!((0.01..0.1).contains(&lattice(0.1)), "{}", lattice(0.1));
    }
}
