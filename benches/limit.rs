//! The limit: one gradient over compressed rows, written by hand on plain slices and registers.
//!
//! No formula shared with anybody, no option: what a sweep over pairs costs at least if every pair loads
//! its neighbour through an index and evaluates the rational weight, with the vector registers of the
//! processor and, for comparison, one pair at a time. The sweeps of the fluid do more per pair, so their
//! rate of pairs lies below this one; by how much is in `docs/performance.md`.

#![allow(missing_docs)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use fearless_simd::{Simd, SimdBase, SimdFloat, f32x8, f64x4};
use mps_benches::{PLANE, RADIUS_RATIO, SKIN_RATIO, SPACE, SPACING, disordered, noise, pools, short};
use mps_kernel::{Real, Vector};
use mps_neighbors::{Cells, Open, Parallel, Rows, Sweep};
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

/// Positions, a field and the rows, all plain slices.
struct Scene<'a, F, const D: usize> {
    points: &'a [[F; D]],
    field: &'a [F],
    rows: &'a Compressed,
    re2: F,
}

macro_rules! limit {
    ($name:ident, $real:ty, $vector:ident, $lanes:literal, $dim:literal, $cells:expr) => {
        impl<'b> Sweep<&'b mut [[$real; $dim]]> for Scene<'_, $real, $dim> {
            #[inline(always)]
            fn visit<S: Simd>(&self, simd: S, i: usize, gradient: &'b mut [$real; $dim]) {
                const L: usize = $lanes;
                let (points, field, from, value) = (self.points, self.field, self.points[i], self.field[i]);
                let zero = $vector::splat(simd, 0.0);
                let (one, re2) = ($vector::splat(simd, 1.0), $vector::splat(simd, self.re2));
                let mut sum = [zero; $dim];
                let row = &self.rows.indices[self.rows.starts[i]..self.rows.starts[i + 1]];
                let (packs, rest) = row.as_chunks::<L>();
                // The last pack is filled up with the particle itself, whose difference is zero.
                let mut last = [i as u32; L];
                last[..rest.len()].copy_from_slice(rest);
                let ends = if rest.is_empty() { &[][..] } else { core::slice::from_ref(&last) };
                for pack in packs.iter().chain(ends) {
                    let mut r = [zero; $dim];
                    let mut r2 = zero;
                    for axis in 0..$dim {
                        r[axis] = $vector::from_fn(simd, |k| points[pack[k] as usize][axis]) - from[axis];
                        r2 += r[axis] * r[axis];
                    }
                    let inverse = one / r2.max($vector::splat(simd, 1e-30));
                    let weight = ((re2 * inverse).sqrt() - 1.0).max(zero);
                    let other = $vector::from_fn(simd, |k| field[pack[k] as usize]);
                    let factor = (other - value) * weight * inverse;
                    for axis in 0..$dim {
                        sum[axis] += factor * r[axis];
                    }
                }
                *gradient = sum.map(|lanes| lanes.as_slice().iter().sum());
            }
        }

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
                        let mut once = || {
                            let (points, field) = (black_box(&points[..]), black_box(&field[..]));
                            let scene = Scene { points, field, rows: &rows, re2 };
                            parallel.sweep(gradient.as_mut_slice(), &scene);
                        };
                        parallel.install(|| bencher.iter(&mut once));
                    });
                }
                let serial = Parallel::serial();
                group.bench_function(BenchmarkId::new(what, "one pair at a time"), |bencher| {
                    bencher.iter(|| {
                        let (points, field) = (black_box(&points[..]), black_box(&field[..]));
                        serial.update(gradient.as_mut_slice(), |i, gradient| {
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
    };
}

limit!(plane_f64, f64, f64x4, 4, 2, PLANE);
limit!(plane_f32, f32, f32x8, 8, 2, PLANE);
limit!(space_f64, f64, f64x4, 4, 3, SPACE);

criterion_group! { name = limit; config = short(); targets = plane_f64, plane_f32, space_f64 }
criterion_main!(limit);
