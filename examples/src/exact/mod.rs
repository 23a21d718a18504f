//! Exact problems of the fluid: tanks, channels, vortices, waves, drops. The program `validate` runs all of them at several resolutions,
//! the program `exact` one of the [`tunable`] ones with numerics of one's own.

mod case;
mod couette;
mod dam_break;
mod drop;
mod free_fall;
mod hydrostatic;
mod measures;
mod numerics;
mod poiseuille;
mod resting;
mod rotation;
mod scene;
mod sideways;
mod standing_wave;
mod taylor_green;
mod viscous_wave;

pub use case::{Case, Curve, Measure, Outcome, Pace, Plot, Target, Work, draw, observed_order};
pub use numerics::{Choice, Form, Numerics};

/// All of them with their own numerics, the cheapest first.
pub fn cases() -> Vec<Box<dyn Case>> {
    let choice = Choice::default;
    vec![
        Box::new(couette::Couette),
        Box::new(poiseuille::Poiseuille { choice: choice() }),
        Box::new(free_fall::FreeFall),
        Box::new(sideways::Sideways),
        Box::new(rotation::Rotation),
        Box::new(drop::Drop { choice: choice() }),
        Box::new(taylor_green::vortices(choice())),
        Box::new(taylor_green::stiff(choice())),
        Box::new(standing_wave::wave(choice())),
        Box::new(standing_wave::viscous(choice())),
        Box::new(hydrostatic::Hydrostatic::<2> { choice: choice() }),
        Box::new(resting::Resting),
        Box::new(hydrostatic::Hydrostatic::<3> { choice: choice() }),
        Box::new(dam_break::DamBreak3d),
    ]
}

/// Those whose numerics and precision can be chosen.
pub fn tunable(choice: &Choice) -> Vec<Box<dyn Case>> {
    let choice = || choice.clone();
    vec![
        Box::new(poiseuille::Poiseuille { choice: choice() }),
        Box::new(drop::Drop { choice: choice() }),
        Box::new(taylor_green::vortices(choice())),
        Box::new(standing_wave::wave(choice())),
        Box::new(hydrostatic::Hydrostatic::<2> { choice: choice() }),
    ]
}
