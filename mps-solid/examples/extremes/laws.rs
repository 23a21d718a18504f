//! The four laws behind one type, and where the material itself gives way.

use core::f64::consts::PI;
use mps_kernel::{Real, Tensor};
use mps_solid::ConstitutiveModel;
use mps_solid::materials::{
    CorotationalHooke, MaterialError, NearlyIncompressible, NeoHookean, SaintVenantKirchhoff,
};

#[derive(Clone, Copy, Debug)]
pub(crate) enum Law<T> {
    Hooke(CorotationalHooke<T>),
    Venant(SaintVenantKirchhoff<T>),
    Neo(NeoHookean<T>),
    Rubber(NearlyIncompressible<T>),
}

/// All four with the wave speed 1 for the density 1.
pub(crate) fn all<T: Real>(nu: f64) -> Result<[Law<T>; 4], MaterialError> {
    let e = T::of((1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu));
    let nu = T::of(nu);
    Ok([
        Law::Hooke(CorotationalHooke::new(e, nu)?),
        Law::Venant(SaintVenantKirchhoff::new(e, nu)?),
        Law::Neo(NeoHookean::new(e, nu)?),
        Law::Rubber(NearlyIncompressible::new(e, nu)?),
    ])
}

/// `$law` as the material inside.
macro_rules! inside {
    ($law:expr, $material:ident => $value:expr) => {
        match $law {
            Law::Hooke($material) => $value,
            Law::Venant($material) => $value,
            Law::Neo($material) => $value,
            Law::Rubber($material) => $value,
        }
    };
}

impl<T: Real, const D: usize> ConstitutiveModel<T, D> for Law<T> {
    type History = ();

    fn energy(&self, f: &Tensor<T, D>, history: &()) -> T {
        inside!(self, law => law.energy(f, history))
    }

    fn first_piola(&self, f: &Tensor<T, D>, history: &mut (), elapsed: T) -> Tensor<T, D> {
        inside!(self, law => law.first_piola(f, history, elapsed))
    }

    fn first_lame_modulus(&self) -> T {
        inside!(self, law => ConstitutiveModel::<T, D>::first_lame_modulus(law))
    }

    fn shear_modulus(&self) -> T {
        inside!(self, law => ConstitutiveModel::<T, D>::shear_modulus(law))
    }

    fn name(&self) -> &'static str {
        inside!(self, law => ConstitutiveModel::<T, D>::name(law))
    }
}

impl Law<f64> {
    /// First Piola-Kirchhoff stress.
    pub(crate) fn stress(&self, f: &Tensor<f64, 2>) -> Tensor<f64, 2> {
        self.first_piola(f, &mut (), 0.0)
    }

    /// The stretch across at which no force acts across, under the stretch `along`; `None` where there is none above
    /// 0.005: the material is flattened.
    pub(crate) fn stretch_across(&self, along: f64) -> Option<f64> {
        let force = |across: f64| self.stress(&Tensor::<f64, 2>::new(along, 0.0, 0.0, across))[(1, 1)];
        let (mut low, mut high) = (0.005, 10.0);
        if force(low) > 0.0 || force(high) < 0.0 {
            return None;
        }
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if force(middle) < 0.0 { low = middle } else { high = middle }
        }
        Some(high)
    }

    /// Smallest eigenvalue of the acoustic tensor `Q_ik = dP_ij/dF_kl n_j n_l` over all directions `n`, over
    /// `lambda + 2 mu`. Where it is not positive no field of small waves can keep the material in place (the condition
    /// of Legendre and Hadamard).
    pub(crate) fn stiffest_least(&self, f: &Tensor<f64, 2>) -> f64 {
        let step = 1e-5;
        let least = |angle: f64| {
            let n = [angle.cos(), angle.sin()];
            let column = |k: usize| {
                let mut turn = Tensor::<f64, 2>::zeros();
                turn[(k, 0)] = n[0] * step;
                turn[(k, 1)] = n[1] * step;
                let change = (self.stress(&(f + turn)) - self.stress(&(f - turn))) / (2.0 * step);
                [change[(0, 0)] * n[0] + change[(0, 1)] * n[1], change[(1, 0)] * n[0] + change[(1, 1)] * n[1]]
            };
            let ([a, b], [_, d]) = (column(0), column(1));
            0.5 * (a + d) - (0.25 * (a - d).powi(2) + b * b).sqrt()
        };
        (0..180).map(|k| least(PI * f64::from(k) / 180.0)).fold(f64::INFINITY, f64::min)
    }
}
