use super::{Noise, Scene, Weight};
use mps_kernel::operators::{Corrected, Gradient, MomentMatrix, invert_moment};
use mps_kernel::{Neighborhood, Pair, PairOperator, Real, ReferenceDensity, Vector, apply};

/// Particles that look at every other particle to find their neighbours.
#[derive(Clone, Debug)]
pub(crate) struct Cloud<T: Real, const D: usize> {
    pub(crate) at: Vec<Vector<T, D>>,
    pub(crate) weight: Weight,
    pub(crate) spacing: T,
    pub(crate) re: T,
}

impl<T: Real, const D: usize> Neighborhood<T, D> for Cloud<T, D> {
    fn len(&self) -> usize {
        self.at.len()
    }

    fn for_each(&self, i: usize, mut visit: impl FnMut(&Pair<T, D>)) {
        for j in (0..self.at.len()).filter(|&j| j != i) {
            let r_ij = self.at[j] - self.at[i];
            if r_ij.norm_squared() < self.re * self.re {
                visit(&Pair::new(j, r_ij, &self.weight, self.re));
            }
        }
    }
}

impl<T: Real, const D: usize> Cloud<T, D> {
    pub(crate) fn new(at: Vec<Vector<T, D>>, weight: Weight, spacing: f64, ratio: f64) -> Self {
        Self { at, weight, spacing: T::of(spacing), re: T::of(spacing * ratio) }
    }

    /// A block of `side^D` lattice points; the middle one of an odd side lies at the origin.
    pub(crate) fn lattice(weight: Weight, spacing: f64, ratio: f64, side: usize) -> Self {
        let half = (side / 2) as f64;
        let at = (0..side.pow(D as u32)).map(|index| {
            let mut rest = index;
            Vector::from_fn(|_, _| {
                let step = (rest % side) as f64 - half;
                rest /= side;
                T::of(spacing) * T::of(step)
            })
        });
        Self::new(at.collect(), weight, spacing, ratio)
    }

    /// The lattice block with every particle moved by the scene's jitter: most of its particles lie
    /// at a face, an edge or a corner.
    pub(crate) fn jittered(scene: &Scene, side: usize) -> Self {
        let mut cloud = Self::lattice(scene.weight, scene.spacing, scene.ratio, side);
        let mut noise = Noise(scene.seed);
        for position in &mut cloud.at {
            *position += noise.vector() * T::of(scene.jitter * scene.spacing);
        }
        cloud
    }

    /// As many particles as the lattice block would have, anywhere in its volume.
    pub(crate) fn scattered(scene: &Scene, side: usize) -> Self {
        let half = T::of(scene.spacing * side as f64 / 2.0);
        let mut noise = Noise(scene.seed);
        let at = (0..side.pow(D as u32)).map(|_| noise.vector() * half).collect();
        Self::new(at, scene.weight, scene.spacing, scene.ratio)
    }

    /// Index of the particle at the origin of an odd lattice block.
    pub(crate) fn middle(&self) -> usize {
        self.at.len() / 2
    }

    pub(crate) fn reference(&self) -> ReferenceDensity<T> {
        ReferenceDensity::lattice::<_, D>(&self.weight, self.spacing, self.re).unwrap()
    }

    /// `D / n0`.
    pub(crate) fn factor(&self) -> T {
        self.reference().gradient_factor::<D>()
    }

    pub(crate) fn correction(&self, i: usize) -> Corrected<T, D> {
        // The field is not looked at.
        let moment = apply(&MomentMatrix { factor: self.factor() }, self, i, &self.at);
        invert_moment(&moment, T::of(0.05))
    }

    /// `operator` evaluated at every particle.
    pub(crate) fn each<F: Copy, O: PairOperator<T, D, F>>(
        &self,
        operator: &O,
        field: &[F],
    ) -> Vec<O::Output> {
        (0..self.at.len()).map(|i| apply(operator, self, i, field)).collect()
    }

    /// The corrected gradients (eqs. 21, 22) of a field, or `None` if any neighbourhood is degenerate.
    pub(crate) fn corrected_gradients(&self, field: &[T]) -> Option<Vec<Vector<T, D>>> {
        let gradients = self.each(&Gradient { factor: self.factor() }, field);
        let corrected = gradients.into_iter().enumerate().map(|(i, gradient)| match self.correction(i) {
            Corrected::Full(matrix) => Some(matrix * gradient),
            Corrected::Degenerate => None,
        });
        corrected.collect()
    }

    /// Every directed pair `(i, pair)`.
    pub(crate) fn pairs(&self) -> Vec<(usize, Pair<T, D>)> {
        let mut pairs = Vec::new();
        for i in 0..self.at.len() {
            self.for_each(i, |pair| pairs.push((i, *pair)));
        }
        pairs
    }
}
