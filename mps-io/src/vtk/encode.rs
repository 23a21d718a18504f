//! A frame as arrays of little-endian numbers, the same for every form of file.

use mps_kernel::{Real, Tensor, Vector};

use super::cloud::{PointCloud, Values};

/// What the numbers of an array are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Float32,
    Float64,
    UInt32,
}

impl Kind {
    /// Bytes of a number.
    pub(super) fn size(self) -> usize {
        match self {
            Self::Float32 | Self::UInt32 => 4,
            Self::Float64 => 8,
        }
    }
}

/// One array: as many numbers a particle as it has components.
#[derive(Debug)]
pub(super) struct Array {
    pub(super) name: String,
    pub(super) kind: Kind,
    pub(super) components: usize,
    pub(super) bytes: Vec<u8>,
}

/// Positions and fields of one time.
#[derive(Debug)]
pub(super) struct Frame {
    /// Number of particles.
    pub(super) len: usize,
    pub(super) points: Array,
    pub(super) fields: Vec<Array>,
}

impl Frame {
    /// The chosen particles of a cloud; `f64` become `f32` if `single`.
    pub(super) fn of<T: Real, const D: usize>(cloud: &PointCloud<'_, T, D>, single: bool) -> Self {
        let pick = Pick { chosen: cloud.chosen, kind: real_kind::<T>(single) };
        let field = |(name, values): &(String, Values<'_, T, D>)| pick.values(name, values);
        Self {
            len: cloud.len(),
            points: pick.vectors("Points", cloud.positions),
            fields: cloud.fields.iter().map(field).collect(),
        }
    }
}

fn real_kind<T: Real>(single: bool) -> Kind {
    if single || size_of::<T>() == 4 { Kind::Float32 } else { Kind::Float64 }
}

/// Which particles are taken, and as what their reals are written.
#[derive(Clone, Copy)]
struct Pick<'a> {
    chosen: Option<&'a [u32]>,
    kind: Kind,
}

impl Pick<'_> {
    fn values<T: Real, const D: usize>(self, name: &str, values: &Values<'_, T, D>) -> Array {
        match values {
            Values::Scalar(values) => self.reals(name, values, |v| [*v]),
            Values::Vector(values) => self.vectors(name, values),
            Values::Tensor(values) => self.reals(name, values, |t: &Tensor<T, D>| -> [T; 9] {
                std::array::from_fn(|c| {
                    let (row, column) = (c / 3, c % 3);
                    if row < D && column < D { t[(row, column)] } else { T::zero() }
                })
            }),
            Values::Integer(values) => {
                let mut bytes = Vec::with_capacity(4 * values.len());
                self.each(values, |value| bytes.extend_from_slice(&value.to_le_bytes()));
                Array { name: name.to_owned(), kind: Kind::UInt32, components: 1, bytes }
            }
        }
    }

    /// Points or vectors, padded to three components: readers take a field of two for two unrelated scalars.
    fn vectors<T: Real, const D: usize>(self, name: &str, values: &[Vector<T, D>]) -> Array {
        self.reals(name, values, |v: &Vector<T, D>| -> [T; 3] {
            std::array::from_fn(|c| if c < D { v[c] } else { T::zero() })
        })
    }

    fn reals<V, T: Real, const C: usize>(
        self,
        name: &str,
        values: &[V],
        components: impl Fn(&V) -> [T; C],
    ) -> Array {
        let mut bytes = Vec::with_capacity(values.len() * C * self.kind.size());
        if self.kind == Kind::Float32 {
            self.each(values, |value| {
                let c = components(value).map(|c| (c.to_double() as f32).to_le_bytes());
                bytes.extend_from_slice(c.as_flattened());
            });
        } else {
            self.each(values, |value| {
                let c = components(value).map(|c| c.to_double().to_le_bytes());
                bytes.extend_from_slice(c.as_flattened());
            });
        }
        Array { name: name.to_owned(), kind: self.kind, components: C, bytes }
    }

    fn each<V>(self, values: &[V], visit: impl FnMut(&V)) {
        match self.chosen {
            None => values.iter().for_each(visit),
            Some(chosen) => chosen.iter().filter_map(|i| values.get(*i as usize)).for_each(visit),
        }
    }
}
