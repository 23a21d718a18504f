//! Blocks whose rows begin on a line that is not straight.

use mps_kernel::{Real, Vector};
use mps_solid::SolidParticles;
use mps_solid::body::Body;

/// The particles of a block from `lower` to `upper` whose rows along x are stretched, each by itself, until the one at the height `y` \[m\] begins at
/// `start(y)` \[m\]. The right end stays; volumes are stretched as well.
pub fn begin_at<T: Real, const D: usize>(
    block: &Body<T, D>,
    lower: &Vector<T, D>,
    upper: &Vector<T, D>,
    start: impl Fn(f64) -> f64,
) -> SolidParticles<T, D> {
    let (left, right) = (lower[0].to_double(), upper[0].to_double());
    let (reference, volumes) = (block.particles.reference_positions(), block.particles.volumes());
    let mut particles = SolidParticles::new();
    for (i, x) in reference.iter().enumerate() {
        let stretch = T::of((right - start(x[1].to_double())) / (right - left));
        let mut place = *x;
        place[0] = upper[0] - (upper[0] - x[0]) * stretch;
        particles.push(place, volumes[i] * stretch, block.particles.is_clamped(i));
    }
    particles
}
