//! Viscous accelerations: none, laminar, artificial, or several added up.

use mps_kernel::by_axis;
use mps_kernel::operators::Laplacian;
use mps_kernel::small::{accumulate, components, difference, dot, scale};
use mps_kernel::{Number, Pair, Real, ReferenceDensity, Vector};

/// A viscous pair acceleration. `()` is an inviscid fluid and costs nothing; a tuple adds two.
pub trait Viscosity<T: Real, const D: usize>: Copy + Send + Sync {
    /// Adds the acceleration of `i` \[m/s^2\] by neighbour `j`, from their velocities \[m/s\].
    /// Must be antisymmetric in `i` and `j`, so that momentum is kept, and `#[inline(always)]`. Where a structure without slip is near it is taken
    /// to be linear in the difference of the velocities: it is followed so through the sub-steps of the structure.
    fn add<N: Number<T>, J>(
        &self,
        sum: &mut Vector<N, D>,
        pair: &Pair<N, D, J>,
        ui: &Vector<T, D>,
        uj: &Vector<N, D>,
    );

    /// The acceleration of a single pair.
    #[inline(always)]
    fn pair(&self, pair: &Pair<T, D>, ui: &Vector<T, D>, uj: &Vector<T, D>) -> Vector<T, D> {
        let mut sum = Vector::zeros();
        self.add(&mut sum, pair, ui, uj);
        sum
    }

    /// Kinematic viscosity \[m^2/s\] that limits the time step.
    fn kinematic(&self) -> T;
}

impl<T: Real, const D: usize> Viscosity<T, D> for () {
    #[inline(always)]
    fn add<N: Number<T>, J>(
        &self,
        _sum: &mut Vector<N, D>,
        _pair: &Pair<N, D, J>,
        _ui: &Vector<T, D>,
        _uj: &Vector<N, D>,
    ) {
    }

    fn kinematic(&self) -> T {
        T::zero()
    }
}

impl<T: Real, const D: usize, A: Viscosity<T, D>, B: Viscosity<T, D>> Viscosity<T, D> for (A, B) {
    #[inline(always)]
    fn add<N: Number<T>, J>(
        &self,
        sum: &mut Vector<N, D>,
        pair: &Pair<N, D, J>,
        ui: &Vector<T, D>,
        uj: &Vector<N, D>,
    ) {
        self.0.add(sum, pair, ui, uj);
        self.1.add(sum, pair, ui, uj);
    }

    fn kinematic(&self) -> T {
        self.0.kinematic() + self.1.kinematic()
    }
}

/// `(mu/rho0) (2 D/(n0 lambda0)) (u_j - u_i) W_ij` (eqs. 18, 25).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaminarViscosity<T> {
    kinematic: T,
    factor: T,
}

impl<T: Real> LaminarViscosity<T> {
    /// For the kinematic viscosity `mu/rho0` \[m^2/s\] on the given lattice.
    pub fn new<const D: usize>(kinematic: T, reference: &ReferenceDensity<T>) -> Self {
        Self { kinematic, factor: kinematic * reference.laplacian_factor::<D>() }
    }
}

impl<T: Real, const D: usize> Viscosity<T, D> for LaminarViscosity<T> {
    #[inline(always)]
    fn add<N: Number<T>, J>(
        &self,
        sum: &mut Vector<N, D>,
        pair: &Pair<N, D, J>,
        ui: &Vector<T, D>,
        uj: &Vector<N, D>,
    ) {
        let shear = Laplacian::pair(ui, uj, pair);
        let shear = components(&shear);
        accumulate(sum, &by_axis!(axis => shear[axis] * self.factor));
    }

    fn kinematic(&self) -> T {
        self.kinematic
    }
}

/// `alpha c l0 (D/n0) ((u_j - u_i) . r_ij/r^2) e_ij W_ij/r`: acts along the line of the pair.
///
/// The artificial viscosity of Monaghan 1994 without its switch, written with the weight of this
/// method: it keeps angular momentum too, and amounts to a kinematic viscosity of
/// `alpha c l0 / (2 (D + 2))`. It vanishes with the spacing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArtificialViscosity<T> {
    kinematic: T,
    factor: T,
}

impl<T: Real> ArtificialViscosity<T> {
    /// For the dimensionless strength `alpha` (0.01 to 0.1) and the sound speed \[m/s\].
    pub fn new<const D: usize>(alpha: T, sound_speed: T, reference: &ReferenceDensity<T>) -> Self {
        let strength = alpha * sound_speed * reference.spacing;
        Self {
            kinematic: strength / T::of(2.0 * (D as f64 + 2.0)),
            factor: strength * reference.gradient_factor::<D>(),
        }
    }
}

impl<T: Real, const D: usize> Viscosity<T, D> for ArtificialViscosity<T> {
    #[inline(always)]
    fn add<N: Number<T>, J>(
        &self,
        sum: &mut Vector<N, D>,
        pair: &Pair<N, D, J>,
        ui: &Vector<T, D>,
        uj: &Vector<N, D>,
    ) {
        // The quotient is the one the rational weight forms: the compiler divides once.
        let approach = dot(&difference(uj, ui), &pair.r_ij) * pair.r2.dividing(T::one());
        accumulate(sum, &scale(&pair.r_ij, approach * self.factor * pair.over_r2));
    }

    fn kinematic(&self) -> T {
        self.kinematic
    }
}

#[cfg(test)]
mod tests {
    use super::super::CompactViscosity;
    use super::*;
    use approx::assert_relative_eq;
    use mps_kernel::Neighborhood;
    use mps_kernel::weights::Rational;

    const L0: f64 = 0.1;

    fn reference() -> ReferenceDensity<f64> {
        ReferenceDensity::lattice::<_, 2>(&Rational, L0, 3.0 * L0).unwrap()
    }

    fn pair(r_ij: [f64; 2]) -> Pair<f64, 2> {
        Pair::new(0, r_ij.into(), &Rational, 3.0 * L0)
    }

    fn check(viscosity: impl Viscosity<f64, 2>) {
        for (r, u, v) in [
            ([0.1, 0.02], [1.0, -2.0], [0.3, 0.7]),
            ([-0.05, 0.2], [-1.0, 0.0], [3.0, 0.1]),
            ([1e-9, 0.0], [1.0, 1.0], [-1.0, 2.0]),
        ] {
            let (u, v) = (Vector::from(u), Vector::from(v));
            let there = viscosity.pair(&pair(r), &u, &v);
            let back = viscosity.pair(&pair(r.map(|x| -x)), &v, &u);
            assert_eq!(there, -back, "antisymmetric to the last bit");
            // The pair gains u . there + v . back.
            assert!((u - v).dot(&there) <= 0.0, "takes energy");
            assert_eq!(viscosity.pair(&pair(r), &u, &u).norm(), 0.0, "nothing without shear");
        }
    }

    #[test]
    fn pairs_keep_momentum_and_lose_energy() {
        let laminar = LaminarViscosity::new::<2>(1e-3, &reference());
        let artificial = ArtificialViscosity::new::<2>(0.05, 10.0, &reference());
        check(());
        check(laminar);
        check(CompactViscosity::new::<2>(1e-3, &reference()));
        check(artificial);
        check((laminar, artificial));
    }

    #[test]
    fn artificial_viscosity_acts_along_the_line_of_the_pair() {
        let artificial = ArtificialViscosity::new::<2>(0.05, 10.0, &reference());
        let (u, v) = (Vector::from([1.0, -2.0]), Vector::from([0.3, 0.7]));
        let a = artificial.pair(&pair([0.1, 0.02]), &u, &v);
        assert_relative_eq!(a.x * 0.02, a.y * 0.1, max_relative = 1e-12);
        // A rotation of the pair about its middle is not resisted.
        let spin = artificial.pair(&pair([0.1, 0.0]), &Vector::from([0.0, -1.0]), &Vector::from([0.0, 1.0]));
        assert_eq!(spin.norm(), 0.0);
    }

    /// The lattice around one particle at the origin.
    struct Lattice(Vec<Vector<f64, 2>>);

    impl Neighborhood<f64, 2> for Lattice {
        fn len(&self) -> usize {
            1
        }
        fn for_each(&self, _i: usize, mut visit: impl FnMut(&Pair<f64, 2>)) {
            for (j, r) in self.0.iter().enumerate().filter(|(_, r)| r.norm() > 0.0) {
                visit(&Pair::new(j, *r, &Rational, 3.0 * L0));
            }
        }
    }

    /// Acceleration at the origin of the shear flow `u = (y^2/2, 0)`, for which `nu laplace u = nu`.
    fn in_shear(viscosity: impl Viscosity<f64, 2>) -> f64 {
        let points: Vec<_> =
            (0..49).map(|k| Vector::from([f64::from(k % 7) - 3.0, f64::from(k / 7) - 3.0]) * L0).collect();
        let mut sum = Vector::<f64, 2>::zeros();
        Lattice(points.clone()).for_each(0, |pair| {
            let u = Vector::from([0.5 * points[pair.j].y.powi(2), 0.0]);
            sum += viscosity.pair(pair, &Vector::zeros(), &u);
        });
        sum.x
    }

    #[test]
    fn all_amount_to_the_kinematic_viscosity_they_claim() {
        let laminar = LaminarViscosity::new::<2>(1e-3, &reference());
        assert_relative_eq!(in_shear(laminar), 1e-3, max_relative = 1e-12);
        assert_eq!(Viscosity::<f64, 2>::kinematic(&laminar), 1e-3);
        let compact = CompactViscosity::new::<2>(1e-3, &reference());
        assert_relative_eq!(in_shear(compact), 1e-3, max_relative = 1e-12);
        assert_eq!(Viscosity::<f64, 2>::kinematic(&compact), 1e-3);
        let artificial = ArtificialViscosity::new::<2>(0.05, 10.0, &reference());
        let nu = Viscosity::<f64, 2>::kinematic(&artificial);
        assert_relative_eq!(nu, 0.05 * 10.0 * L0 / 8.0, max_relative = 1e-12);
        // The average over directions is taken over the few of a lattice.
        assert_relative_eq!(in_shear(artificial), nu, max_relative = 0.3);
        assert_relative_eq!(in_shear((laminar, artificial)), 1e-3 + in_shear(artificial));
    }
}
