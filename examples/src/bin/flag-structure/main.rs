//! The structural tests CSM1 and CSM3 of Turek and Hron (2006): an elastic flag behind a rigid cylinder sinks under its
//! own weight, to rest or for ever.

mod csm1;
mod csm3;
mod describe;
mod options;
mod plots;

use clap::Parser;
use mps_examples::scene::print_scene;
use mps_examples::solid::Look;
use mps_examples::solid::flag::{CYLINDER, Clamp, END, RADIUS};
use mps_examples::{Failure, Precision, exit_code};
use mps_io::View;
use mps_kernel::Real;
use options::{Options, Test};
use std::process::ExitCode;

/// What a run writes beside its table and its log, which it begins anew in any case (`remove_leftovers`).
const WRITTEN: &[&str] = &[
    "summary.json",
    "ux.png",
    "uy.png",
    "energy.png",
    "middle_line.png",
    "film.png",
    "stress_rest.png",
    "stress_lowest.png",
    "stress_highest.png",
    "stress_wreck.png",
    "fields/body.pvd",
];

fn main() -> ExitCode {
    let options = Options::parse();
    exit_code(match options.common.precision {
        Precision::F32 => run::<f32>(&options),
        Precision::F64 => run::<f64>(&options),
    })
}

fn run<T: Real>(options: &Options) -> Result<(), Failure> {
    let settings = options.settings()?;
    if options.print_scene {
        return print_scene("flag-structure", describe::scene(options.test, &settings)?, &options.common);
    }
    let dir = options.common.output(&format!("flag-structure-{}", options.test.name()))?;
    match options.test {
        Test::Csm1 => csm1::run::<T>(options, &settings, &dir),
        Test::Csm3 => csm3::run::<T>(options, &settings, &dir),
    }
}

/// What a run is made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    /// Particles across the flag.
    pub(crate) across: usize,
    /// Where the flag is held.
    pub(crate) clamp: Clamp,
    /// Simulated time of CSM3 \[s\].
    pub(crate) end_time: f64,
    /// Forces that may be left in CSM1, over the load.
    pub(crate) tolerance: f64,
}

/// Flag and cylinder.
fn look(test: Test, settings: &Settings) -> Look {
    let circle = |k: u32| {
        let angle = f64::from(k).to_radians();
        [CYLINDER[0] + RADIUS * angle.cos(), CYLINDER[1] + RADIUS * angle.sin()]
    };
    Look {
        title: format!("{}, {} particles across", test.title(), settings.across),
        view: View::new([CYLINDER[0] - RADIUS - 0.02, 0.04], [END[0] + 0.03, END[1] + 0.07]),
        outline: (0..=360).map(circle).collect(),
        stress: 40.0,
        frame: 0.05,
        stills: Vec::new(),
    }
}
