//! A body that is at rest under a pressure from all sides.

use super::ConstitutiveModel;
use mps_kernel::tensor::{cofactor, determinant};
use mps_kernel::{Real, Tensor};

/// A material whose undeformed state is the one under an ambient pressure `p0`: `w(F) - p0 (J - 1)`, hence `P(F) - p0 cof F`.
///
/// A structure in a fluid is drawn as it is in the fluid, not as it would be in a vacuum. Where the pressure of the fluid has a
/// level `p0` of its own (an internal flow is kept under pressure, so that it does not tear), the structure carries that level and would
/// shrink by it. With this material the level is in balance inside, and what deforms the body is the pressure beyond it. Force and reaction at the
/// interface remain exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ambient<M, T> {
    /// The material.
    pub material: M,
    /// The pressure `p0` \[Pa\].
    pub pressure: T,
}

impl<T: Real, const D: usize, M: ConstitutiveModel<T, D>> ConstitutiveModel<T, D> for Ambient<M, T> {
    type History = M::History;

    fn energy(&self, f: &Tensor<T, D>, history: &Self::History) -> T {
        self.material.energy(f, history) - self.pressure * (determinant(f) - T::one())
    }

    fn first_piola(&self, f: &Tensor<T, D>, history: &mut Self::History, elapsed: T) -> Tensor<T, D> {
        self.material.first_piola(f, history, elapsed) - cofactor(f) * self.pressure
    }

    fn first_lame_modulus(&self) -> T {
        self.material.first_lame_modulus()
    }

    fn shear_modulus(&self) -> T {
        self.material.shear_modulus()
    }

    fn wave_speed(&self, density: T) -> T {
        self.material.wave_speed(density)
    }

    fn settle(&self, f: &Tensor<T, D>, history: &mut Self::History) {
        self.material.settle(f, history);
    }

    fn name(&self) -> &'static str {
        self.material.name()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body;
    use crate::materials::NeoHookean;
    use crate::{Solid, SolidConfig};
    use mps_kernel::Vector;
    use mps_kernel::weights::WendlandC2;
    use mps_neighbors::Parallel;

    /// The stress is the derivative of the energy, and under the pressure from all sides nothing moves.
    #[test]
    fn a_body_under_its_ambient_pressure_stays_as_it_is() {
        let material = Ambient { material: NeoHookean::new(1e6, 0.3).unwrap(), pressure: 1e4 };
        let f = Tensor::<f64, 2>::from([[1.1, 0.2], [-0.1, 0.9]]);
        let stress = ConstitutiveModel::<f64, 2>::first_piola(&material, &f, &mut (), 0.0);
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let energy = |h: f64| {
                let mut moved = f;
                moved[(row, column)] += h;
                material.energy(&moved, &())
            };
            let slope = (energy(1e-6) - energy(-1e-6)) / 2e-6;
            approx::assert_relative_eq!(slope, stress[(row, column)], max_relative = 1e-7, epsilon = 1e-2);
        }

        let parallel = Parallel::serial();
        let square = body::block(Vector::from([0.0; 2]), Vector::from([1.0; 2]), [8, 8], &[]).unwrap();
        let faces = [(0, false), (0, true), (1, false), (1, true)].map(|(axis, upper)| {
            let face = if upper { body::Face::upper(axis) } else { body::Face::lower(axis) };
            square.face(face).unwrap()
        });
        let mut solid = Solid::new(
            square.particles,
            square.spacing,
            1000.0,
            material,
            WendlandC2,
            SolidConfig::default(),
            &parallel,
        )
        .unwrap();
        let mut forces = vec![Vector::zeros(); solid.len()];
        for face in &faces {
            face.add_pressure(1e4, solid.particles(), &mut forces);
        }
        let start = solid.positions().to_vec();
        let dt = solid.max_step(&parallel);
        solid.advance(&parallel, &forces, &Vector::zeros(), dt * 200.0, 200).unwrap();
        let moved = solid.positions().iter().zip(&start).map(|(r, r0)| (r - r0).norm()).fold(0.0, f64::max);
        // Without it the sides would move by about p/E, 1e-2; a pressure acts at the surface and the stress from the outer rows on.
        assert!(moved < 5e-4, "{moved}");
    }
}
