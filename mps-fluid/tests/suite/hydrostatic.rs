//! A tank at rest comes to rest again, with the hydrostatic pressure.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

use crate::common::{pressure_error, tank, water};
use mps_fluid::{ArtificialViscosity, Dpc};
use mps_neighbors::Parallel;

/// The upright lattice the tank is filled with is not the arrangement of least energy: within half a
/// second its rows give way and half a percent of the potential energy becomes motion. The particles
/// then do not freeze but go on creeping past each other. So what is asked for is that this motion
/// dies away, that nothing but the creeping is left (root mean square below 1.5 % of `sqrt(g H)`, that is
/// 2e-4 of the potential energy) and that total energy falls on the way. It does so up to 5e-5: the
/// hydrostatic difference shown by the walls does some work that no energy accounts for (2e-5 while collisions and diffusion were acts of each step).
#[test]
fn a_tank_settles_and_keeps_its_pressure_and_its_level() {
    let parallel = Parallel::all_cores().unwrap();
    let (l0, n) = (0.0125, 32);
    let depth = l0 * n as f64;
    for collisions in [None, Some(Dpc::default())] {
        let mut config = water::<f64, 2>(l0, depth);
        config.collisions = collisions;
        let c = config.sound_speed;
        let mut fluid = tank([n, n], config, |r| ArtificialViscosity::new::<2>(0.02, c, r));
        let start = fluid.energy(&parallel);
        let (mut early, mut late, mut late_error) = (0.0_f64, 0.0_f64, 0.0_f64);
        let (mut least, mut rise) = (start.total(), 0.0_f64);
        while fluid.time() < 2.0 {
            fluid.step(&parallel).unwrap();
            let energy = fluid.energy(&parallel);
            rise = rise.max(energy.total() - least);
            least = least.min(energy.total());
            if fluid.time() < 1.0 {
                early = early.max(energy.kinetic / start.potential);
            } else if fluid.time() > 1.8 {
                late = late.max(energy.kinetic / start.potential);
                late_error = late_error.max(pressure_error(&fluid, depth));
            }
        }
        let end = fluid.energy(&parallel).potential / start.potential;
        let top = fluid.particles().position.iter().map(|r| r[1]).fold(0.0, f64::max) + 0.5 * l0;
        assert!(late < 2e-4, "kinetic energy {late:e}");
        assert!(late < 0.2 * early, "kinetic energy {early:e}, later {late:e}");
        assert!(late_error < 0.06, "pressure error {late_error}");
        assert!((end - 1.0).abs() < 0.01, "potential energy {end}");
        assert!((top / depth - 1.0).abs() < 0.04, "level {}", top / depth);
        assert!(rise < 8e-5 * start.total(), "total energy rises by {rise:e} J of {} J", start.total());
    }
}
