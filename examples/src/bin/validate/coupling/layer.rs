//! A plate that waves between two layers of a viscous fluid: the linearised Navier-Stokes equations.
//!
//! The plate moves as `V exp(s t) cos(k x)` across itself and not along. A layer of depth `H` between it and a wall, both without slip, has
//! the velocity `v = f(y) cos(k x)` across, `u = -f'(y)/k sin(k x)` along, with `(D^2 - k^2)(D^2 - m^2) f = 0`, `m^2 = k^2 + s/nu`, hence
//!
//! ```text
//! f = a exp(-k y) + b exp(k (y - H)) + c exp(-m y) + d exp(m (y - H)),    f(0) = V, f'(0) = f(H) = f'(H) = 0
//! ```
//!
//! The momentum along the plate gives the pressure on it, `p = rho nu f'''(0)/k^2 cos(k x)`; there is no viscous normal stress on a wall
//! without slip. Both layers push alike, and with the mass `M` and the stiffness `K` of the plate per area
//!
//! ```text
//! M s^2 + 2 s rho nu f'''(0)/(V k^2) + K = 0
//! ```
//!
//! Without viscosity a layer adds the mass `rho/(k tanh(k H))`.

use nalgebra::{Complex, Matrix4, Vector4};

type C = Complex<f64>;

/// The plate and its layers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layered {
    /// Wave number \[1/m\].
    pub(crate) k: f64,
    /// Depth of either layer \[m\].
    pub(crate) depth: f64,
    /// Density of the fluid \[kg/m^3\].
    pub(crate) density: f64,
    /// Its kinematic viscosity \[m^2/s\].
    pub(crate) viscosity: f64,
    /// Mass of the plate per area \[kg/m^2\].
    pub(crate) mass: f64,
    /// Its stiffness per area \[N/m^3\].
    pub(crate) stiffness: f64,
}

impl Layered {
    /// What one layer adds to the mass without viscosity \[kg/m^2\].
    pub(crate) fn added(&self) -> f64 {
        self.density / (self.k * (self.k * self.depth).tanh())
    }

    /// Frequency without viscosity \[1/s\].
    pub(crate) fn potential(&self) -> f64 {
        (self.stiffness / (self.mass + 2.0 * self.added())).sqrt()
    }

    /// The four exponents of `f` and its coefficients for `V = 1`.
    fn profile(&self, s: C) -> ([(C, C); 4], Vector4<C>) {
        let Self { k, depth, viscosity, .. } = *self;
        let m = (s / viscosity + k * k).sqrt();
        let (k, zero) = (C::from(k), C::from(0.0));
        let terms = [(-k, zero), (k, -k * depth), (-m, zero), (m, -m * depth)];
        let [near, far] = [0.0, depth];
        let rows = [(near, 0), (near, 1), (far, 0), (far, 1)];
        let matrix = Matrix4::from_fn(|row, column| {
            let (y, order) = rows[row];
            derivative(terms[column], y, order)
        });
        let given = Vector4::from([1.0, 0.0, 0.0, 0.0].map(C::from));
        // The four functions differ unless there is no fluid between the walls.
        (terms, matrix.lu().solve(&given).unwrap_or_else(|| Vector4::repeat(C::from(f64::NAN))))
    }

    /// Pressure of one layer on the plate over its velocity \[kg/(m^2 s)\].
    fn impedance(&self, s: C) -> C {
        let (terms, factors) = self.profile(s);
        let third: C =
            terms.iter().zip(&factors).map(|(term, factor)| factor * derivative(*term, 0.0, 3)).sum();
        third * (self.density * self.viscosity / (self.k * self.k))
    }

    /// The root `s` \[1/s\] near the frequency without viscosity: the amplitude decays with `-re s` and swings with `im s`.
    pub(crate) fn root(&self) -> C {
        let missing = |s: C| s * s * self.mass + s * self.impedance(s) * 2.0 + self.stiffness;
        let omega = self.potential();
        let (mut before, mut now) = (C::new(-0.001 * omega, omega), C::new(-0.02 * omega, 0.97 * omega));
        // The secant, until it has nothing left to gain.
        for _ in 0..60 {
            let (was, is) = (missing(before), missing(now));
            if is == was {
                break;
            }
            (before, now) = (now, now - is * (now - before) / (is - was));
        }
        now
    }
}

/// Derivative of `exp(m y + o)` of some order.
fn derivative((m, offset): (C, C), y: f64, order: u8) -> C {
    (m * y + offset).exp() * m.powi(i32::from(order))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plate(viscosity: f64) -> Layered {
        Layered { k: 12.6, depth: 0.2, density: 1000.0, viscosity, mass: 20.0, stiffness: 2e5 }
    }

    #[test]
    fn with_little_viscosity_it_is_the_potential_flow_with_its_layers() {
        for viscosity in [1e-8, 1e-6] {
            let plate = plate(viscosity);
            let (s, omega) = (plate.root(), plate.potential());
            // The potential flow would slide along plate and wall; where it slides with the amplitude u, its layer takes the power
            // rho u^2/2 sqrt(nu omega/2) an area (Landau and Lifshitz, Fluid Mechanics, section 24).
            let (kh, added) = (plate.k * plate.depth, plate.added());
            let slide = 1.0 / kh.tanh().powi(2) + 1.0 / kh.sinh().powi(2);
            let rate =
                plate.density * slide * (0.5 * viscosity * omega).sqrt() / 2.0 / (0.5 * plate.mass + added);
            assert!((s.im / omega - 1.0).abs() < 0.02, "{s}");
            assert!((-s.re / rate - 1.0).abs() < 0.02, "{s} for {rate}");
        }
    }

    /// The equations along and across with derivatives by differences.
    #[test]
    fn the_profile_solves_the_equations_and_clings_to_the_walls() {
        let plate = plate(1e-3);
        let s = plate.root();
        let (terms, factors) = plate.profile(s);
        let f = |y: f64, order: u8| -> C {
            terms.iter().zip(&factors).map(|(term, factor)| factor * derivative(*term, y, order)).sum()
        };
        let near = |a: C, b: C, what: &str| assert!((a - b).norm() < 1e-9, "{what}: {a}, {b}");
        near(f(0.0, 0), C::from(1.0), "moves with the plate");
        near(f(0.0, 1) / plate.k, C::from(0.0), "clings to the plate");
        near(f(plate.depth, 0), C::from(0.0), "stops at the wall");
        near(f(plate.depth, 1) / plate.k, C::from(0.0), "clings to the wall");
        // Pressure by the momentum along; its slope by the momentum across: rho s v = -dp/dy + rho nu (v'' - k^2 v).
        let (k2, nu) = (plate.k * plate.k, plate.viscosity);
        let pressure = |y: f64| ((f(y, 3) - f(y, 1) * k2) * nu - f(y, 1) * s) / k2;
        let (y, h) = (0.013, 1e-6);
        let slope = (pressure(y + h) - pressure(y - h)) / (2.0 * h);
        let across = (f(y, 2) - f(y, 0) * k2) * nu - f(y, 0) * s;
        assert!((slope - across).norm() < 1e-6 * across.norm(), "{slope}, {across}");
    }
}
