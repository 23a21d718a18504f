//! What the sums over neighbours make of a plane wave on the reference lattice (von Neumann's analysis).

use crate::reference_density::{is_within, lattice_offsets};
use crate::{Kernel, Real, ReferenceDensity, Vector};
use core::f64::consts::PI;

/// The symbols of the operators for one wave `exp(i k.r)`, with the spacing as the unit of length \[-\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WaveSymbols {
    /// `|kappa|^2`: gradient and divergence (eqs. 23, 24) turn the wave into `i kappa` times itself,
    /// `kappa = (D/n0) sum r W/r^2 sin k.r`.
    pub slope: f64,
    /// `(2D/n0) sum W/r^2 (1 - cos k.r) - |kappa|^2`: minus what
    /// [`DiffusionFilter`](crate::operators::DiffusionFilter) (eq. 20) turns it into.
    pub filter: f64,
    /// `(2D/(n0 lambda0)) sum W (1 - cos k.r)`: minus the Laplacian of eq. 16, which is that of
    /// [`HydrostaticDiffusion`](crate::operators::HydrostaticDiffusion) as well.
    pub laplacian: f64,
}

/// A neighbour on the lattice, with the spacing as the unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LatticeNeighbor<const D: usize> {
    /// Where it is \[-\].
    pub offset: Vector<f64, D>,
    /// Its weight `W` \[-\].
    pub weight: f64,
    /// `W/r^2` \[-\].
    pub over_r2: f64,
}

/// The reference lattice as waves see it.
///
/// On it the corrected sums are the plain ones: the moment matrix is the identity.
#[derive(Clone, Debug)]
pub struct LatticeWaves<const D: usize> {
    neighbors: Vec<LatticeNeighbor<D>>,
    n0: f64,
    lambda0: f64,
}

/// Wave vectors of [`LatticeWaves::grid`] along an axis, but zero.
const GRID: usize = 8;

impl<const D: usize> LatticeWaves<D> {
    /// The lattice that a reference density belongs to.
    pub fn new<T: Real, K: Kernel<T>>(kernel: &K, reference: &ReferenceDensity<T>) -> Self {
        let (l0, re) = (reference.spacing, reference.radius);
        let neighbors = lattice_offsets::<T, D>(l0, re)
            .filter(|offset| is_within(offset, re))
            .map(|offset| {
                let (weight, _) = kernel.weight_and_over_r2(offset.norm_squared(), re);
                let weight = weight.to_double();
                let offset = offset.map(|x| (x / l0).to_double().round());
                LatticeNeighbor { offset, weight, over_r2: weight / offset.norm_squared() }
            })
            .collect();
        let unit = l0.to_double();
        let lambda0 = reference.lambda0.to_double() / unit / unit;
        Self { neighbors, n0: reference.n0.to_double(), lambda0 }
    }

    /// All neighbours of a particle.
    pub fn neighbors(&self) -> &[LatticeNeighbor<D>] {
        &self.neighbors
    }

    /// Particle number density of the lattice \[-\].
    pub fn n0(&self) -> f64 {
        self.n0
    }

    /// `lambda0` \[-\].
    pub fn lambda0(&self) -> f64 {
        self.lambda0
    }

    /// What becomes of a wave with the wave vector `k` (per spacing).
    pub fn symbols(&self, k: &Vector<f64, D>) -> WaveSymbols {
        let factor = D as f64 / self.n0;
        let mut kappa = Vector::<f64, D>::zeros();
        let (mut curvature, mut laplacian) = (0.0, 0.0);
        for near in &self.neighbors {
            let (sine, cosine) = k.dot(&near.offset).sin_cos();
            kappa += near.offset * (factor * near.over_r2 * sine);
            curvature += near.over_r2 * (1.0 - cosine);
            laplacian += near.weight * (1.0 - cosine);
        }
        let slope = kappa.norm_squared();
        WaveSymbols {
            slope,
            filter: 2.0 * factor * curvature - slope,
            laplacian: 2.0 * factor / self.lambda0 * laplacian,
        }
    }

    /// Wave vectors times the spacing \[-\], from the longest wave to those whose sign alternates: enough for the largest of a symbol, to 1 %. Those that the
    /// symmetry of the lattice makes alike are there once.
    pub fn wave_vectors() -> impl Iterator<Item = Vector<f64, D>> {
        let side = GRID + 1;
        (1..side.pow(D as u32)).filter_map(move |index| {
            let mut rest = index;
            let step = Vector::<usize, D>::from_fn(|_, _| {
                let step = rest % side;
                rest /= side;
                step
            });
            step.as_slice().is_sorted().then(|| step.map(|step| PI * step as f64 / GRID as f64))
        })
    }

    /// The symbols of these waves.
    pub fn grid(&self) -> impl Iterator<Item = WaveSymbols> {
        Self::wave_vectors().map(|k| self.symbols(&k))
    }
}
