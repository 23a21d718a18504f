//! How the surface of a body looks from a particle of another one.
//!
//! The field `c(x) = sum_j V_j (1 - |x - x_j|^2/R^2)^3` of a half space of particles, averaged along its surface, is
//! a sum over the layers behind a distance `g` from the outermost one,
//!
//! ```text
//! c(g) = sum_m l C (R^2 - (g + m l)^2)^p / R^6,     p = 3 + (D - 1)/2
//! ```
//!
//! with `C` the integral of `(1 - t^2)^3` over the unit ball of the surface: 32/35 in 2D, `pi/4` in 3D. What is left
//! of the lattice along the surface is a wave with the Fourier transform of the same function, a Bessel function of
//! order `p` of `2 pi sqrt(R^2 - g^2)/l`. `R` is chosen so that this is zero where surfaces touch.

use mps_kernel::Real;

/// Second zero of the Bessel function of order 3, 7/2 and 4 over `2 pi`. From the first one on the wave vanishes
/// where surfaces touch; at the second one it also stays small under pressure, and with equal spacings one layer is
/// seen only, so that thin bodies look like thick ones.
const WIDTH: [f64; 3] = [1.553_4, 1.657_945, 1.761_003];

/// `C` of the module.
const INTEGRAL: [f64; 3] = [1.0, 32.0 / 35.0, core::f64::consts::FRAC_PI_4];

/// Distance of the outermost layers of touching bodies with these spacings \[m\]: half of each.
pub(crate) fn contact_distance(spacings: [f64; 2]) -> f64 {
    0.5 * (spacings[0] + spacings[1])
}

/// Radius of the field \[m\].
pub(crate) fn radius<const D: usize>(spacings: [f64; 2]) -> f64 {
    contact_distance(spacings).hypot(WIDTH[D - 1] * spacings[0].max(spacings[1]))
}

/// A body seen from outside.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Facing<T> {
    /// `1/R^2` \[1/m^2\].
    pub(crate) over_r2: T,
    /// The field where surfaces touch \[m^D\].
    threshold: T,
    /// `-1/(dc/dg)` there \[1/m^(D-1)\].
    pub(crate) over_slope: T,
    /// The overlap beyond which a particle is about to pass the outermost layer \[m\].
    pub(crate) deepest: T,
    /// Stiffness under pressure over that at first touch, at most \[-\].
    pub(crate) stiffening: f64,
}

impl<T: Real> Facing<T> {
    /// The body with the first of the `spacings`, from a particle of the other one; `deep` layers of it are seen.
    pub(crate) fn new<const D: usize>(spacings: [f64; 2], deep: usize) -> Self {
        let (touch, radius) = (contact_distance(spacings), radius::<D>(spacings));
        let field = |g: f64| half_space::<D>(spacings[0], radius, g, deep);
        let (threshold, slope) = field(touch);
        let depth = |g: f64| (field(g).0 - threshold) / slope;
        // Pressure over the stiffness, from the energy depth^2/2.
        let pressure = |g: f64| depth(g) * field(g).1 / slope;
        let samples = 32;
        let step = 0.5 * touch / f64::from(samples);
        let tangent = |k: i32| {
            let g = touch - step * f64::from(k);
            (pressure(g - step) - pressure(g)) / step
        };
        Self {
            over_r2: T::of(1.0 / (radius * radius)),
            threshold: T::of(threshold),
            over_slope: T::of(1.0 / slope),
            deepest: T::of(depth(0.5 * touch)),
            stiffening: (0..samples).map(tangent).fold(1.0, f64::max),
        }
    }

    /// `1 - r^2/R^2`, whose third power is the weight.
    #[inline(always)]
    pub(crate) fn nearness(&self, r2: T) -> T {
        (T::one() - r2 * self.over_r2).max(T::zero())
    }

    /// Overlap \[m\] where the field is `sum`.
    #[inline(always)]
    pub(crate) fn depth(&self, sum: T) -> T {
        ((sum - self.threshold) * self.over_slope).max(T::zero())
    }
}

/// `c(g)` and `-dc/dg` of the module, of `deep` layers at most.
fn half_space<const D: usize>(spacing: f64, radius: f64, g: f64, deep: usize) -> (f64, f64) {
    let power = 3.0 + 0.5 * (D as f64 - 1.0);
    let factor = spacing * INTEGRAL[D - 1] / radius.powi(6);
    let layers = ((radius - g) / spacing).ceil().max(1.0) as usize;
    let layers = layers.min(deep);
    let (mut value, mut slope) = (0.0, 0.0);
    for m in 0..layers {
        let away = g + spacing * m as f64;
        let left = (radius * radius - away * away).max(0.0);
        value += factor * left.powf(power);
        slope += factor * 2.0 * power * away * left.powf(power - 1.0);
    }
    (value, slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Field of a lattice at the height `g` above its outermost layer, at `t` along it.
    fn lattice<const D: usize>(radius: f64, g: f64, t: [f64; 2]) -> f64 {
        let along = |axis: usize| if axis + 1 < D { -4..=4 } else { 0..=0 };
        let mut sum = 0.0;
        for m in 0..4 {
            for a in along(0) {
                for b in along(1) {
                    let r = [g + f64::from(m), t[0] + f64::from(a), t[1] + f64::from(b)];
                    let r2: f64 = r.iter().map(|x| x * x).sum();
                    sum += (1.0 - r2 / (radius * radius)).max(0.0).powi(3);
                }
            }
        }
        sum
    }

    /// Largest variation of the height of the surface along it over the spacing, with the overlap `depth`.
    fn corrugation<const D: usize>(depth: f64) -> f64 {
        let radius = radius::<D>([1.0, 1.0]);
        let (mean, slope) = half_space::<D>(1.0, radius, 1.0 - depth, usize::MAX);
        let mut worst = 0.0_f64;
        for a in 0..=10 {
            for b in 0..=10 {
                let t = [0.05 * f64::from(a), if D == 3 { 0.05 * f64::from(b) } else { 0.0 }];
                worst = worst.max((lattice::<D>(radius, 1.0 - depth, t) - mean).abs() / slope);
            }
        }
        worst
    }

    /// A pair force between particles one spacing apart would have 0.134 (2D) and 0.293 (3D).
    #[test]
    fn surfaces_are_smooth() {
        let plane = [0.0, 0.05, 0.1, 0.2].map(corrugation::<2>);
        let space = [0.0, 0.05, 0.1, 0.2].map(corrugation::<3>);
        eprintln!(
            "corrugation in spacings at overlaps 0, 0.05, 0.1, 0.2: {plane:.5?} in 2D, {space:.5?} in 3D"
        );
        assert!(plane[0] < 0.0005 && plane[1] < 0.002 && plane[3] < 0.007, "{plane:?}");
        assert!(space[0] < 0.003 && space[1] < 0.005 && space[3] < 0.01, "{space:?}");
    }

    #[test]
    fn stiffness_hardly_depends_on_the_pressure() {
        for spacings in [[1.0, 1.0], [1.0, 2.0], [2.0, 1.0], [4.0, 1.0]] {
            for deep in [1, usize::MAX] {
                let plane = Facing::<f64>::new::<2>(spacings, deep);
                let space = Facing::<f64>::new::<3>(spacings, deep);
                eprintln!("{spacings:?}: {plane:?} {space:?}");
                assert!(plane.stiffening < 2.0 && space.stiffening < 2.0, "{spacings:?} {plane:?} {space:?}");
            }
        }
    }
}
