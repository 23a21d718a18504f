//! Positions and named fields: what one frame holds.

use mps_kernel::{Real, Tensor, Vector};

/// Values of one field, borrowed from the simulation.
pub(super) enum Values<'a, T: Real, const D: usize> {
    Scalar(&'a [T]),
    Vector(&'a [Vector<T, D>]),
    Tensor(&'a [Tensor<T, D>]),
    Integer(&'a [u32]),
}

impl<T: Real, const D: usize> Values<'_, T, D> {
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Scalar(values) => values.len(),
            Self::Vector(values) => values.len(),
            Self::Tensor(values) => values.len(),
            Self::Integer(values) => values.len(),
        }
    }
}

/// Particles with their fields at one time, borrowed and not copied.
///
/// ```
/// use mps_io::vtk::PointCloud;
/// use mps_kernel::Vector;
/// let positions = [Vector::<f64, 2>::new(0.0, 0.0), Vector::<f64, 2>::new(0.1, 0.0)];
/// let velocity = [Vector::<f64, 2>::new(1.0, 0.0); 2];
/// let cloud = PointCloud::new(&positions)
///     .scalar("pressure", &[0.0, 12.5])
///     .vector("velocity", &velocity)
///     .integer("kind", &[0, 1]);
/// assert_eq!(cloud.len(), 2);
/// ```
pub struct PointCloud<'a, T: Real, const D: usize> {
    pub(super) positions: &'a [Vector<T, D>],
    pub(super) fields: Vec<(String, Values<'a, T, D>)>,
    /// Numbers of those that are written; all if `None`.
    pub(super) chosen: Option<&'a [u32]>,
}

impl<'a, T: Real, const D: usize> PointCloud<'a, T, D> {
    /// A cloud of particles at `positions` (m), without fields yet.
    pub fn new(positions: &'a [Vector<T, D>]) -> Self {
        Self { positions, fields: Vec::new(), chosen: None }
    }

    /// Adds a number for each particle, in SI units.
    pub fn scalar(self, name: &str, values: &'a [T]) -> Self {
        self.field(name, Values::Scalar(values))
    }

    /// Adds a vector for each particle; in the file it has three components, in 2D the last is 0.
    pub fn vector(self, name: &str, values: &'a [Vector<T, D>]) -> Self {
        self.field(name, Values::Vector(values))
    }

    /// Adds a tensor for each particle; in the file it has nine components, row by row, those
    /// outside `D x D` are 0.
    pub fn tensor(self, name: &str, values: &'a [Tensor<T, D>]) -> Self {
        self.field(name, Values::Tensor(values))
    }

    /// Adds a whole number for each particle: an identity, a kind, a flag.
    pub fn integer(self, name: &str, values: &'a [u32]) -> Self {
        self.field(name, Values::Integer(values))
    }

    /// Writes only the particles with these numbers, in this order; all for `None`. Fields have a value for every particle all the same.
    pub fn only(mut self, chosen: Option<&'a [u32]>) -> Self {
        self.chosen = chosen;
        self
    }

    /// Number of particles that are written.
    pub fn len(&self) -> usize {
        self.chosen.map_or(self.positions.len(), <[u32]>::len)
    }

    /// Whether none is written.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn field(mut self, name: &str, values: Values<'a, T, D>) -> Self {
        self.fields.push((name.to_owned(), values));
        self
    }
}
