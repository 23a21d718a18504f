//! Water in a basin: lattices, walls all around, the pressure of rest. With the numerics that all water with a free
//! surface has here (`docs/validation.md`): a smooth weight with a radius of 4 spacings, walls of points at half the
//! spacing, no collisions.

use mps_fluid::{Boundary, EquationOfState, FluidConfig, FluidParticles, Slip};
use mps_kernel::{Real, Vector};

/// Effective radius of water with a free surface, over the spacing.
pub const RADIUS_RATIO: f64 = 4.0;
/// Points of a wall along a spacing: smooth to water that slides by.
pub const FINE: usize = 2;
/// Layers of points of a wall, as deep as the effective radius.
const LAYERS: usize = FINE * RADIUS_RATIO as usize;

/// Centres of `counts` cells of a lattice from `corner` on \[m\].
pub fn lattice<T: Real, const D: usize>(corner: [f64; D], counts: [usize; D], l0: f64) -> Vec<Vector<T, D>> {
    (0..counts.iter().product())
        .map(|index: usize| {
            let mut rest = index;
            Vector::from_fn(|axis, _| {
                let step = rest % counts[axis];
                rest /= counts[axis];
                T::of(corner[axis] + (step as f64 + 0.5) * l0)
            })
        })
        .collect()
}

/// Walls all around a box of `counts` particles at the origin. `top`: spacings the side walls stand above
/// the box, which is then open; `None` closes it.
pub fn walls<T: Real, const D: usize>(counts: [usize; D], top: Option<usize>, l0: f64) -> Boundary<T, D> {
    let counts = counts.map(|n| n * FINE);
    let (top, l0) = (top.map(|n| n * FINE), l0 / FINE as f64);
    let mut around = counts.map(|n| n + 2 * LAYERS);
    around[D - 1] = counts[D - 1] + LAYERS + top.unwrap_or(LAYERS);
    let inside = |p: &Vector<T, D>| {
        let within = |axis: usize| p[axis] > T::zero() && p[axis] < T::of(counts[axis] as f64 * l0);
        (0..D - 1).all(within) && p[D - 1] > T::zero() && (top.is_some() || within(D - 1))
    };
    let points = lattice([-(LAYERS as f64) * l0; D], around, l0);
    let points: Vec<_> = points.into_iter().filter(|p| !inside(p)).collect();
    let mut boundary = Boundary::default();
    boundary.add_fine_wall(&points, T::of((FINE as f64).powi(-(D as i32))), Slip::Free);
    boundary
}

/// Sets the densities that give the pressure `p` \[Pa\] of the place.
pub fn press<T: Real, const D: usize>(
    particles: &mut FluidParticles<T, D>,
    config: &FluidConfig<T, D>,
    p: impl Fn(&Vector<T, D>) -> T,
) {
    let eos = config.equation_of_state();
    for (n, r) in particles.density.iter_mut().zip(&particles.position) {
        *n = eos.density(p(r));
    }
}

/// Water with a free surface, of the given spacing \[m\] and sound speed \[m/s\]. Without collisions, which would act as a
/// strong viscosity.
pub fn water<T: Real, const D: usize>(l0: f64, sound_speed: f64) -> FluidConfig<T, D> {
    let mut config = FluidConfig::water(T::of(l0), T::of(sound_speed));
    config.radius_ratio = T::of(RADIUS_RATIO);
    config.collisions = None;
    config
}
