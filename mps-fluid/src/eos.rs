//! Equations of state: pressure as an explicit function of the number density.

use mps_kernel::Real;

/// Pressure and stored energy of a weakly compressible fluid.
pub trait EquationOfState<T: Real>: Copy + Send + Sync {
    /// Pressure \[Pa\] at density ratio `n/n0` \[-\].
    fn pressure(&self, density: T) -> T;
    /// Density ratio \[-\] at pressure \[Pa\].
    fn density(&self, pressure: T) -> T;
    /// Energy of compression per reference volume \[J/m^3\]: `integral of p/n dn` from `n = n0`.
    fn energy(&self, density: T) -> T;
    /// Sound speed at reference density \[m/s\].
    fn sound_speed(&self) -> T;
}

/// Tait's equation with exponent 7 (eq. 26): `p = rho0 c^2/7 ((n/n0)^7 - 1)`, and a level added to it if wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tait<T> {
    sound_speed: T,
    /// `rho0 c^2 / 7` \[Pa\].
    stiffness: T,
    /// Pressure at `n = n0` \[Pa\].
    level: T,
}

impl<T: Real> Tait<T> {
    /// For the reference density \[kg/m^3\] and the (numerical) sound speed \[m/s\].
    pub fn new(density: T, sound_speed: T) -> Self {
        Self { sound_speed, stiffness: density * sound_speed * sound_speed / T::of(7.0), level: T::zero() }
    }

    /// The same with the pressure `level` \[Pa\] at reference density.
    pub fn with_level(self, level: T) -> Self {
        Self { level, ..self }
    }
}

impl<T: Real> EquationOfState<T> for Tait<T> {
    #[inline(always)]
    fn pressure(&self, density: T) -> T {
        let n3 = density * density * density;
        self.level + self.stiffness * (n3 * n3 * density - T::one())
    }

    fn density(&self, pressure: T) -> T {
        (T::one() + (pressure - self.level) / self.stiffness).max(T::zero()).powf(T::of(1.0 / 7.0))
    }

    fn energy(&self, density: T) -> T {
        self.stiffness * ((density.powi(7) - T::one()) / T::of(7.0) - density.ln())
            + self.level * density.ln()
    }

    fn sound_speed(&self) -> T {
        self.sound_speed
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn the_stored_energy_is_the_work_of_the_pressure() {
        let eos = Tait::new(1000.0_f64, 15.0).with_level(2000.0);
        for n in [0.97, 1.0, 1.003, 1.02] {
            let h = 1e-5;
            let slope = (eos.energy(n + h) - eos.energy(n - h)) / (2.0 * h);
            assert_relative_eq!(slope, eos.pressure(n) / n, max_relative = 1e-6, epsilon = 1e-2);
        }
    }

    #[test]
    fn density_inverts_pressure_and_the_slope_is_the_sound_speed() {
        let eos = Tait::new(1000.0_f64, 15.0).with_level(2000.0);
        assert_eq!(eos.pressure(1.0), 2000.0);
        for n in [0.95, 1.0, 1.05] {
            assert_relative_eq!(eos.density(eos.pressure(n)), n, max_relative = 1e-12);
        }
        let slope = (eos.pressure(1.0 + 1e-6) - eos.pressure(1.0 - 1e-6)) / 2e-6;
        assert_relative_eq!(slope, 1000.0 * 15.0 * 15.0, max_relative = 1e-6);
    }
}
