//! Finding the neighbours: cells, spatial order, rows. Nanoseconds a particle are the reciprocal of
//! the throughput.

#![allow(missing_docs, clippy::expect_used)]

use criterion::{BatchSize, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use mps_benches::{PLANE, RADIUS_RATIO, SKIN_RATIO, SPACE, SPACING, disordered, noise, pools, short};
use mps_fluid::FluidParticles;
use mps_kernel::{Real, Vector};
use mps_neighbors::{Cells, Open, Permutation, Rows};

/// As [`disordered`], in an order that has nothing to do with space.
fn shuffled<T: Real, const D: usize>(cells: [usize; D]) -> Vec<Vector<T, D>> {
    let mut points: Vec<_> = disordered::<T, D>(cells).into_iter().enumerate().collect();
    points.sort_by(|(i, _), (j, _)| noise(*i).total_cmp(&noise(*j)));
    points.into_iter().map(|(_, point)| point).collect()
}

fn rows<T: Real, const D: usize>(criterion: &mut Criterion, cells_per_axis: [usize; D], name: &str) {
    let reach = T::of((RADIUS_RATIO + SKIN_RATIO) * SPACING);
    let shuffled = FluidParticles::at_rest(shuffled::<T, D>(cells_per_axis));
    let mut group = criterion.benchmark_group(format!("rows/{name}"));
    group.throughput(Throughput::Elements(shuffled.position.len() as u64));
    for parallel in pools() {
        let threads = parallel.threads();
        let (mut cells, mut rows) = (Cells::new(), Rows::default());
        let mut permutation = Permutation::default();
        let mut ordered = shuffled.clone();
        let mut sort = |cells: &mut Cells<T, D>, particles: &mut FluidParticles<T, D>| {
            cells.build(&parallel, &Open, &particles.position, reach).expect("finite positions");
            permutation.apply(particles, cells.order()).expect("an order");
        };
        sort(&mut cells, &mut ordered);

        group.bench_function(BenchmarkId::new("sort_shuffled", threads), |bencher| {
            bencher.iter_batched_ref(
                || shuffled.clone(),
                |particles| parallel.install(|| sort(&mut cells, particles)),
                BatchSize::LargeInput,
            );
        });
        group.bench_function(BenchmarkId::new("sort_ordered", threads), |bencher| {
            bencher.iter(|| parallel.install(|| sort(&mut cells, &mut ordered)));
        });
        cells.build(&parallel, &Open, &ordered.position, reach).expect("finite positions");
        group.bench_function(BenchmarkId::new("build_within", threads), |bencher| {
            let mut build = || rows.build_within(&parallel, &Open, &cells, &ordered.position, reach);
            parallel.install(|| bencher.iter(&mut build));
        });
    }
}

fn all(criterion: &mut Criterion) {
    rows::<f64, 2>(criterion, PLANE, "2d/f64");
    rows::<f32, 2>(criterion, PLANE, "2d/f32");
    rows::<f64, 3>(criterion, SPACE, "3d/f64");
}

criterion_group! { name = group; config = short(); targets = all }
criterion_main!(group);
