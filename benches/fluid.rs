//! The fluid: both halves of a step, whole steps, and what each option adds.
//!
//! Steps are so short that nothing moves: the rows stay, and every step does the same work. What
//! finding the rows costs is in `rows.rs`, what it adds to a flow in `coupled.rs`.

#![allow(missing_docs, clippy::expect_used)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use mps_benches::{Features, PLANE, SPACE, Water, pools, short, tank};
use mps_kernel::Real;
use mps_neighbors::Parallel;
use std::time::{Duration, Instant};

/// Length of a step \[s\]: far below what would move a particle by half a skin in a whole benchmark.
const NO_TIME: f64 = 1e-12;

/// What the gate has, and the shifting of the paper.
const SHIFTED: Features = Features { shifting: 5, ..Features::GATE };

fn step<T: Real, const D: usize>(water: &mut Water<T, D>, parallel: &Parallel) {
    water.begin_step(parallel).expect("a finite state");
    water.finish_step(parallel, T::of(NO_TIME));
}

/// What the second half takes in so many steps.
fn second_halves<T: Real, const D: usize>(
    water: &mut Water<T, D>,
    parallel: &Parallel,
    times: u64,
) -> Duration {
    let mut taken = Duration::ZERO;
    for _ in 0..times {
        water.begin_step(parallel).expect("a finite state");
        let now = Instant::now();
        water.finish_step(parallel, T::of(NO_TIME));
        taken += now.elapsed();
    }
    taken
}

/// The momentum half and the density half without collisions, whole steps with them, and with shifting as well; inside the pool, as the time
/// loop of a program is.
fn halves<T: Real, const D: usize>(criterion: &mut Criterion, cells: [usize; D], name: &str) {
    let mut group = criterion.benchmark_group(format!("fluid/{name}"));
    for parallel in pools() {
        let threads = parallel.threads();
        let mut water = tank::<T, D>(cells, Features { collisions: false, ..Features::GATE });
        step(&mut water, &parallel);
        // Pairs a second, to be held against the limit.
        group.throughput(Throughput::Elements(water.pairs() as u64));
        group.bench_function(BenchmarkId::new("momentum", threads), |bencher| {
            parallel.install(|| bencher.iter(|| water.begin_step(&parallel)));
        });
        group.bench_function(BenchmarkId::new("density", threads), |bencher| {
            // The second half has its turn only behind the first.
            parallel.install(|| bencher.iter_custom(|times| second_halves(&mut water, &parallel, times)));
        });
        // Particle steps a second.
        group.throughput(Throughput::Elements(cells.iter().product::<usize>() as u64));
        for (whole, features) in [("step", Features::GATE), ("shifted_step", SHIFTED)] {
            let mut water = tank::<T, D>(cells, features);
            step(&mut water, &parallel);
            group.bench_function(BenchmarkId::new(whole, threads), |bencher| {
                parallel.install(|| bencher.iter(|| step(&mut water, &parallel)));
            });
            assert_eq!(water.rebuilds(), 1, "the steps were meant to leave the rows alone");
        }
    }
}

/// What an option costs, and that its absence is free.
fn options(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("fluid/options/2d/f64");
    group.throughput(Throughput::Elements(PLANE.iter().product::<usize>() as u64));
    let parallel = Parallel::serial();
    let gate = Features::GATE;
    for (name, features) in [
        ("gate", gate),
        ("without_collisions", Features { collisions: false, ..gate }),
        ("without_diffusion", Features { diffusion: false, ..gate }),
        ("without_walls", Features { walls: false, ..gate }),
        ("bare", Features { collisions: false, diffusion: false, walls: false, shifting: 0 }),
        ("with_shifting_1", Features { shifting: 1, ..gate }),
        ("with_shifting_5", Features { shifting: 5, ..gate }),
    ] {
        let mut water = tank::<f64, 2>(PLANE, features);
        step(&mut water, &parallel);
        group.bench_function(name, |bencher| bencher.iter(|| step(&mut water, &parallel)));
    }
}

fn all(criterion: &mut Criterion) {
    halves::<f64, 2>(criterion, PLANE, "2d/f64");
    halves::<f32, 2>(criterion, PLANE, "2d/f32");
    halves::<f64, 3>(criterion, SPACE, "3d/f64");
    options(criterion);
}

criterion_group! { name = group; config = short(); targets = all }
criterion_main!(group);
