//! Clouds of points that have broken searches before, and the rows they should give.
#![allow(dead_code, unreachable_pub, reason = "every test file uses another part")]

use mps_kernel::weights::WendlandC2;
use mps_kernel::{FieldVisitor, Neighborhood, ParticleStore, Real, Vector};
use mps_neighbors::{BruteForce, Domain, Rows};
use proptest::prelude::*;

/// Small linear congruential generator: numbers in [0, 1).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Uniform,
    Clustered,
    Diagonal,
    AlongX,
    AlongLast,
    Coincident,
    /// Neighbours at exactly the reach, on the edges of cells.
    Lattice,
    /// Couples scattered over so much space that far apart cells must share buckets.
    Sparse,
    /// One particle that many metres away.
    Flyer(f64),
}

pub fn shape() -> impl Strategy<Value = Shape> {
    use Shape::*;
    proptest::sample::select(vec![
        Uniform,
        Clustered,
        Diagonal,
        AlongX,
        AlongLast,
        Coincident,
        Lattice,
        Sparse,
        Flyer(1e6),
        Flyer(-1e6),
        Flyer(1e12),
        Flyer(-1e12),
    ])
}

/// Numbers in [0, 1)^3 from which [`cloud`] makes points.
pub fn seeds() -> impl Strategy<Value = Vec<[f64; 3]>> {
    proptest::collection::vec(proptest::array::uniform3(0.0..1.0), 0..160)
}

/// Points over some eight metres, shifted by `offset`.
pub fn cloud<T: Real, const D: usize>(seeds: &[[f64; 3]], shape: Shape, offset: f64) -> Vec<Vector<T, D>> {
    let point = |(i, s): (usize, &[f64; 3])| {
        Vector::from_fn(|axis, _| {
            let x = match shape {
                Shape::Uniform => 8.0 * s[axis],
                Shape::Clustered => 8.0 * s[axis].powi(4),
                Shape::Diagonal => 8.0 * s[0],
                Shape::AlongX => 30.0 * s[0] * f64::from(axis == 0),
                Shape::AlongLast => 30.0 * s[0] * f64::from(axis == D - 1),
                Shape::Coincident => (3.0 * s[axis]).floor(),
                Shape::Lattice => (6.0 * s[axis]).floor(),
                Shape::Sparse => 300.0 * seeds[i / 2][axis] + s[(axis + 1) % 3],
                Shape::Flyer(far) => 8.0 * s[axis] + if i == 3 { far } else { 0.0 },
            };
            T::of(x + offset)
        })
    };
    seeds.iter().enumerate().map(point).collect()
}

/// Rows by trying all pairs.
pub fn brute_within<T: Real, const D: usize>(
    domain: impl Domain<T, D>,
    points: &[Vector<T, D>],
    reach: T,
) -> Vec<Vec<u32>> {
    collect(&BruteForce::within(domain, points, WendlandC2, reach))
}

/// Rows by trying all pairs of two sets.
pub fn brute_between<T: Real, const D: usize>(
    domain: impl Domain<T, D>,
    points: &[Vector<T, D>],
    targets: &[Vector<T, D>],
    reach: T,
) -> Vec<Vec<u32>> {
    collect(&BruteForce::between(domain, points, targets, WendlandC2, reach))
}

fn collect<T: Real, const D: usize>(neighborhood: &impl Neighborhood<T, D>) -> Vec<Vec<u32>> {
    (0..neighborhood.len())
        .map(|i| {
            let mut row = Vec::new();
            neighborhood.for_each(i, |pair| row.push(pair.j as u32));
            row
        })
        .collect()
}

/// Rows as plain vectors.
pub fn plain(rows: &Rows) -> Vec<Vec<u32>> {
    (0..rows.len()).map(|i| rows.row(i).to_vec()).collect()
}

/// A phase with fields of several types and sizes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Store<const D: usize> {
    pub position: Vec<Vector<f64, D>>,
    pub velocity: Vec<Vector<f64, D>>,
    pub density: Vec<f64>,
    pub small: Vec<f32>,
    pub id: Vec<u32>,
    pub flag: Vec<u8>,
}

impl<const D: usize> Store<D> {
    /// Particles at `position` whose other fields can be told apart.
    pub fn at(position: Vec<Vector<f64, D>>) -> Self {
        let n = position.len();
        Self {
            velocity: (0..n).map(|i| Vector::repeat(i as f64 * 0.5)).collect(),
            density: (0..n).map(|i| 1000.0 + i as f64).collect(),
            small: (0..n).map(|i| i as f32 * 0.25).collect(),
            id: (0..n as u32).collect(),
            flag: (0..n).map(|i| (i % 251) as u8).collect(),
            position,
        }
    }
}

impl<const D: usize> ParticleStore for Store<D> {
    fn len(&self) -> usize {
        self.id.len()
    }

    fn for_each_field(&mut self, visitor: &mut impl FieldVisitor) {
        visitor.visit("position", &mut self.position);
        visitor.visit("velocity", &mut self.velocity);
        visitor.visit("density", &mut self.density);
        visitor.visit("small", &mut self.small);
        visitor.visit("id", &mut self.id);
        visitor.visit("flag", &mut self.flag);
    }
}

/// A square or cube of a lattice of spacing 1 with every particle moved by up to 0.2, shuffled.
pub fn jittered<const D: usize>(side: usize, seed: u64) -> Vec<Vector<f64, D>> {
    let mut random = Random(seed);
    let mut points: Vec<Vector<f64, D>> = (0..side.pow(D as u32))
        .map(|index| {
            let mut rest = index;
            Vector::from_fn(|_, _| {
                let x = (rest % side) as f64;
                rest /= side;
                x + 0.4 * (random.next() - 0.5)
            })
        })
        .collect();
    for i in (1..points.len()).rev() {
        points.swap(i, (random.next() * (i + 1) as f64) as usize);
    }
    points
}
