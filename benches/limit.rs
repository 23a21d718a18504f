//! The limit: one gradient over compressed rows, written by hand on plain slices.
//!
//! No trait, no vector type, no option: what a sweep over pairs costs at least if every pair loads
//! its neighbour through an index and evaluates the rational weight. The sweeps of the fluid do more
//! per pair, so their rate of pairs lies below this one; by how much is in `docs/performance.md`.

#![allow(missing_docs)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use mps_benches::{PLANE, RADIUS_RATIO, SKIN_RATIO, SPACE, SPACING, disordered, noise, pools, short};
use mps_kernel::{Real, Vector};
use mps_neighbors::{Cells, Open, Parallel, Rows};
use std::hint::black_box;

/// Rows as two plain arrays: those of `i` are `indices[starts[i]..starts[i + 1]]`.
struct Compressed {
    starts: Vec<usize>,
    indices: Vec<u32>,
}

fn compressed<T: Real, const D: usize>(points: &[Vector<T, D>], reach: f64) -> Compressed {
    let (serial, mut cells, mut rows) = (Parallel::serial(), Cells::new(), Rows::default());
    let reach = T::of(reach);
    let built = cells
        .build(&serial, &Open, points, reach)
        .and_then(|()| rows.build_within(&serial, &Open, &cells, points, reach));
    assert!(built.is_ok());
    let mut starts = vec![0];
    let mut indices = Vec::with_capacity(rows.pairs());
    for i in 0..points.len() {
        indices.extend_from_slice(rows.row(i));
        starts.push(indices.len());
    }
    Compressed { starts, indices }
}

macro_rules! limit {
    ($name:ident, $real:ty, $dim:literal, $cells:expr) => {
        fn $name(criterion: &mut Criterion) {
            type Point = [$real; $dim];
            let points: Vec<Point> =
                disordered::<$real, $dim>($cells).into_iter().map(|p| p.into()).collect();
            let field: Vec<$real> = (0..points.len()).map(|i| noise(i) as $real).collect();
            let re2 = ((RADIUS_RATIO * SPACING) * (RADIUS_RATIO * SPACING)) as $real;
            let group = format!("limit/{}d/{}", $dim, stringify!($real));
            let mut group = criterion.benchmark_group(group);
            for (reach, what) in [(RADIUS_RATIO, "radius"), (RADIUS_RATIO + SKIN_RATIO, "skin")] {
                let points_as_vectors: Vec<Vector<$real, $dim>> = points.iter().map(|&p| p.into()).collect();
                let rows = compressed(&points_as_vectors, reach * SPACING);
                let mut gradient: Vec<Point> = vec![[0.0; $dim]; points.len()];
                group.throughput(Throughput::Elements(rows.indices.len() as u64));
                for parallel in pools() {
                    group.bench_function(BenchmarkId::new(what, parallel.threads()), |bencher| {
                        bencher.iter(|| {
                            let (points, field) = (black_box(&points[..]), black_box(&field[..]));
                            parallel.update(gradient.as_mut_slice(), |i, gradient| {
                                let (from, value) = (points[i], field[i]);
                                let mut sum = [0.0; $dim];
                                for &j in &rows.indices[rows.starts[i]..rows.starts[i + 1]] {
                                    let (to, other) = (points[j as usize], field[j as usize]);
                                    let mut r = [0.0; $dim];
                                    let mut r2: $real = 0.0;
                                    for axis in 0..$dim {
                                        r[axis] = to[axis] - from[axis];
                                        r2 += r[axis] * r[axis];
                                    }
                                    let inverse = 1.0 / r2;
                                    let weight = ((re2 * inverse).sqrt() - 1.0).max(0.0);
                                    let factor = (other - value) * weight * inverse;
                                    for axis in 0..$dim {
                                        sum[axis] += factor * r[axis];
                                    }
                                }
                                *gradient = sum;
                            });
                        });
                    });
                }
            }
        }
    };
}

limit!(plane_f64, f64, 2, PLANE);
limit!(plane_f32, f32, 2, PLANE);
limit!(space_f64, f64, 3, SPACE);

criterion_group! { name = limit; config = short(); targets = plane_f64, plane_f32, space_f64 }
criterion_main!(limit);
