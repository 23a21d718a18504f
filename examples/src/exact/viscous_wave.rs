//! The standing wave of the linearised Navier-Stokes equations.
//!
//! Velocity `grad phi + (d psi/dy, -d psi/dx)` with `phi = A cosh(k y) cos(k x)` and `psi = B sinh(m y) sin(k x)`, all times `exp(s t)`; the bottom at
//! `y = 0` slides freely, and vorticity diffuses: `m^2 = k^2 + s/nu`. No shear stress at the surface `y = H`, a normal stress in balance with
//! gravity, and a surface that moves with the fluid leave
//!
//! `(s + 2 nu k^2)^2 + g k tanh(k H) = 4 nu^2 k^3 m tanh(k H) coth(m H)`
//!
//! (Lamb 1932, Hydrodynamics, art. 349, for deep water; for any depth Antuono and Colagrossi 2013, Wave Motion 50, 197-209).
//! Without the right side the energy decays with `4 nu k^2`, the loss of the potential flow. But the surface bears no shear, so that the shear of the potential flow
//! is absent from a layer `sqrt(2 nu/omega)` thick, and the decay is slower by `tanh(k H) sqrt(nu k^2/(2 omega))` to first order.

use nalgebra::Complex;

/// Linear standing wave in a tank of a viscous fluid.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ViscousWave {
    /// Wave number \[1/m\].
    pub(crate) k: f64,
    /// Depth \[m\].
    pub(crate) depth: f64,
    /// Acceleration of gravity \[m/s^2\].
    pub(crate) gravity: f64,
    /// Kinematic viscosity \[m^2/s\].
    pub(crate) viscosity: f64,
}

impl ViscousWave {
    /// Square of the frequency without viscosity \[1/s^2\].
    fn stiffness(&self) -> f64 {
        self.gravity * self.k * (self.k * self.depth).tanh()
    }

    /// `m` \[1/m\].
    fn decay_into_the_depth(&self, s: Complex<f64>) -> Complex<f64> {
        (s / self.viscosity + self.k * self.k).sqrt()
    }

    /// The root `s` \[1/s\]: the amplitude decays with `-re s` and swings with `im s`.
    pub(crate) fn root(&self) -> Complex<f64> {
        let &Self { k, depth, viscosity: nu, .. } = self;
        let drag = 2.0 * nu * k * k;
        let mut s = Complex::new(-drag, self.stiffness().sqrt());
        // The right side is small; each round gains a digit or two.
        for _ in 0..100 {
            let m = self.decay_into_the_depth(s);
            // coth(m H), where tanh would overflow in a thin layer.
            let bottom = (m * (-2.0 * depth)).exp();
            let layer =
                m * (bottom + 1.0) / (-bottom + 1.0) * (4.0 * nu * nu * k.powi(3) * (k * depth).tanh());
            s = (layer - self.stiffness()).sqrt() - drag;
        }
        s
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    fn wave(re: f64) -> ViscousWave {
        let gravity = 9.81_f64;
        ViscousWave { k: PI, depth: 1.0, gravity, viscosity: gravity.sqrt() / re }
    }

    #[test]
    fn with_little_viscosity_it_is_the_potential_wave_with_the_loss_of_its_layer() {
        for (re, rest) in [(1e6, 1e-4), (1e8, 1e-6)] {
            let wave = wave(re);
            let (s, omega) = (wave.root(), wave.stiffness().sqrt());
            let potential = 2.0 * wave.viscosity * wave.k * wave.k;
            let layer = (potential / omega / 4.0).sqrt();
            assert!((s.im / omega - 1.0).abs() < 1e-4);
            assert!((-s.re / potential - 1.0 + layer).abs() < rest, "{}", -s.re / potential);
        }
    }

    /// The conditions at the surface with derivatives by differences of the fields.
    #[test]
    fn the_root_belongs_to_a_flow_whose_surface_bears_no_stress() {
        for re in [50.0, 250.0] {
            let wave = wave(re);
            let (s, nu, k, depth) = (wave.root(), wave.viscosity, wave.k, wave.depth);
            assert!(s.re < 0.0 && s.im > 0.0);
            let m = wave.decay_into_the_depth(s);
            // phi and psi without their factors in x; B so that the surface bears no shear.
            let phi = |y: f64| Complex::from((k * y).cosh());
            let b = (k * depth).sinh() * 2.0 * k * k / ((m * m + k * k) * (m * depth).sinh());
            let psi = |y: f64| b * (m * y).sinh();
            let h = 1e-4;
            let slope = |f: &dyn Fn(f64) -> Complex<f64>, y: f64| (f(y + h) - f(y - h)) / (2.0 * h);
            let (u, v) = (|y: f64| slope(&psi, y) - phi(y) * k, |y: f64| slope(&phi, y) - psi(y) * k);
            let size = v(depth).norm() * k;
            assert!((slope(&u, depth) - v(depth) * k).norm() < 1e-5 * size, "shear stress");
            // Pressure -s phi - g eta and the surface's height eta = v/s.
            let normal = phi(depth) * s + v(depth) / s * wave.gravity + slope(&v, depth) * (2.0 * nu);
            assert!(normal.norm() < 1e-5 * (phi(depth) * s).norm(), "normal stress: {normal}");
            let bend = (psi(0.5 + h) - psi(0.5) * 2.0 + psi(0.5 - h)) / (h * h);
            let diffused = (bend - psi(0.5) * k * k) * nu;
            assert!((diffused - psi(0.5) * s).norm() < 1e-5 * (psi(0.5) * s).norm(), "diffusion");
        }
    }
}
