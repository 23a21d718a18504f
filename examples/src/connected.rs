//! How far water reaches that hangs together: spray does not count.

/// Empty space that ends the water, over the spacing.
pub const GAP: f64 = 2.5;

/// End \[m\] of the particles of spacing `l0` \[m\] at `along` \[m\] that follow `start` \[m\], a particle's place, without
/// a gap: half a spacing behind the last one.
pub fn connected(mut along: Vec<f64>, start: f64, l0: f64) -> f64 {
    along.sort_unstable_by(f64::total_cmp);
    let mut end = start;
    for x in along {
        if x > end + GAP * l0 {
            break;
        }
        end = x;
    }
    end + 0.5 * l0
}
