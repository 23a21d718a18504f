//! Numbers read off a fluid.

use mps_fluid::FluidParticles;
use mps_kernel::{Real, Vector};

/// In double precision.
pub(crate) fn in_double<T: Real, const D: usize>(v: &Vector<T, D>) -> Vector<f64, D> {
    v.map(Real::to_double)
}

/// Root mean square over the particles of `found(i) - exact(r_i)`.
pub(crate) fn rms<T: Real, const D: usize>(
    particles: &FluidParticles<T, D>,
    found: impl Fn(usize) -> f64,
    exact: impl Fn(&Vector<f64, D>) -> f64,
) -> f64 {
    let square = |(i, r): (usize, &Vector<T, D>)| (found(i) - exact(&in_double(r))).powi(2);
    let sum: f64 = particles.position.iter().enumerate().map(square).sum();
    (sum / particles.position.len() as f64).sqrt()
}

/// Level of an open tank \[m\]: mean over columns two spacings wide of the highest particle, plus the
/// half spacing by which a surface lies above its particles.
pub(crate) fn level<T: Real, const D: usize>(particles: &FluidParticles<T, D>, width: f64, l0: f64) -> f64 {
    let columns = ((width / (2.0 * l0)).floor() as usize).max(1);
    let mut tops = vec![0.0_f64; columns.pow(D as u32 - 1)];
    for r in particles.position.iter().map(in_double) {
        let place = (0..D - 1).rev().fold(0, |place, axis| {
            let column = (r[axis] / width * columns as f64).max(0.0) as usize;
            place * columns + column.min(columns - 1)
        });
        tops[place] = tops[place].max(r[D - 1]);
    }
    tops.iter().sum::<f64>() / tops.len() as f64 + 0.5 * l0
}

/// `sum r x u` of plane particles over the sum of the sizes of its terms at most, and that sum.
pub(crate) fn angular_momentum<T: Real>(particles: &FluidParticles<T, 2>) -> f64 {
    states(particles).map(|(r, u)| r.x * u.y - r.y * u.x).sum()
}

/// Sum of the sizes of the terms of [`angular_momentum`].
pub(crate) fn angular_size<T: Real>(particles: &FluidParticles<T, 2>) -> f64 {
    states(particles).map(|(r, u)| r.norm() * u.norm()).sum()
}

/// Position and velocity of each particle.
pub(crate) fn states<T: Real>(
    particles: &FluidParticles<T, 2>,
) -> impl Iterator<Item = (Vector<f64, 2>, Vector<f64, 2>)> {
    particles.position.iter().zip(&particles.velocity).map(|(r, u)| (in_double(r), in_double(u)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_level_is_that_of_the_highest_particles() {
        let points = super::super::scene::lattice([0.0; 3], [4, 4, 6], 0.5);
        let particles = FluidParticles::<f64, 3>::at_rest(points);
        assert!((level(&particles, 2.0, 0.5) - 3.0).abs() < 1e-12);
    }
}
