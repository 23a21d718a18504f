//! A free plate that spins for a hundred turns.

use super::scene::{V, YOUNG, square};
use mps_examples::Failure;
use mps_examples::exact::{Case, Curve, Measure, Outcome, Pace, Plot};
use mps_io::CurvePlot;
use mps_neighbors::Parallel;
use mps_solid::materials::CorotationalHooke;

pub(crate) struct Spin;

/// Speed of the middle of a side, over the speed of sound.
const SPEED: f64 = 0.01;
const LAW: &str = "analytic: conserved";

impl Case for Spin {
    fn name(&self) -> &'static str {
        "spin"
    }

    fn about(&self) -> &'static str {
        "A free square that starts to spin from the undeformed state, corotational with nu = 0.4; the middle of a side moves with 0.01 c_p. 100 turns (10 \
         in the quick run), during which it breathes. Largest changes, with 20 looks a turn."
    }

    fn resolution(&self) -> &'static str {
        "particles per side"
    }

    fn resolutions(&self, pace: Pace) -> Vec<usize> {
        pace.choose(vec![8], vec![8, 16])
    }

    fn run(&self, n: usize, pace: Pace, parallel: &Parallel) -> Result<Outcome, Failure> {
        const LOOKS: usize = 20;
        let mut solid = square(n, 0.0, CorotationalHooke::new(YOUNG, 0.4)?, parallel)?;
        let centre = V::repeat(0.5);
        let rate = SPEED * solid.wave_speed() / 0.5;
        let places: Vec<V> = solid.positions().iter().map(|x| x - centre).collect();
        for (u, r) in solid.velocities_mut().iter_mut().zip(places) {
            *u = V::new(-r.y, r.x) * rate;
        }
        let (rest, zero) = (vec![V::zeros(); solid.len()], V::zeros());
        let moment = |solid: &mps_solid::Solid<f64, 2, CorotationalHooke<f64>>| {
            solid.angular_momentum(parallel, &centre)[(0, 1)]
        };
        let (turn0, energy0) = (moment(&solid), solid.energy(parallel, &zero).total());
        let interval = core::f64::consts::TAU / rate / LOOKS as f64;
        let substeps = (interval / solid.max_step(parallel)).ceil() as usize;
        let (mut turn, mut energy) = (0.0_f64, 0.0_f64);
        let (mut turns, mut change) = (Vec::new(), Vec::new());
        for look in 1..=LOOKS * pace.choose(10, 100) {
            solid.advance(parallel, &rest, &zero, interval, substeps)?;
            turn = turn.max((moment(&solid) / turn0 - 1.0).abs());
            let now = solid.energy(parallel, &zero).total() / energy0 - 1.0;
            energy = energy.max(now.abs());
            turns.push(look as f64 / LOOKS as f64);
            change.push(now);
        }
        let measures = vec![
            Measure::new("angular momentum, largest change", "-", turn, 0.0, LAW).within(1e-12, 0),
            Measure::new("energy, largest change", "E0", energy, 0.0, LAW).within(1e-6, 0),
        ];
        let curves = vec![Curve { plot: "energy", name: format!("{n} per side"), x: turns, y: change }];
        Ok(Outcome::new(measures, curves))
    }

    fn plots(&self) -> Vec<Plot> {
        let axes = CurvePlot::new("Spinning plate", "turns [-]", "change of the energy [E₀]");
        vec![Plot { name: "energy", axes: axes.dashed("exact", &[0.0, 10.0], &[0.0; 2]) }]
    }
}
