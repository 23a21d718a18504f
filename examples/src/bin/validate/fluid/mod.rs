//! The cases of the fluid alone.

mod couette;
mod dam_break;
mod drop;
mod free_fall;
mod hydrostatic;
mod measures;
mod poiseuille;
mod resting;
mod rotation;
mod scene;
mod sideways;
mod standing_wave;
mod taylor_green;
mod viscous_wave;

use crate::case::Case;

/// All of them, the cheapest first.
pub(crate) fn cases() -> Vec<Box<dyn Case>> {
    vec![
        Box::new(couette::Couette),
        Box::new(poiseuille::Poiseuille),
        Box::new(free_fall::FreeFall),
        Box::new(sideways::Sideways),
        Box::new(rotation::Rotation),
        Box::new(drop::Drop),
        Box::new(taylor_green::VORTICES),
        Box::new(taylor_green::STIFF),
        Box::new(standing_wave::WAVE),
        Box::new(standing_wave::VISCOUS),
        Box::new(hydrostatic::Hydrostatic::<2>),
        Box::new(resting::Resting),
        Box::new(hydrostatic::Hydrostatic::<3>),
        Box::new(dam_break::DamBreak3d),
    ]
}
