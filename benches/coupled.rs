//! Whole coupled steps of the elastic gate, with their sub-steps of the structure and the
//! rebuilding of rows as the flow asks for it.

#![allow(missing_docs, clippy::expect_used)]

use criterion::{BenchmarkId, Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use mps_benches::{gate_scene, pools, short};
use std::time::{Duration, Instant};

/// Steps after which the scene starts anew, so that every run sees the same stretch of the flow.
const STEPS: u64 = 100;

fn coupled(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("coupled");
    group.sampling_mode(SamplingMode::Flat);
    for (name, l0) in [("2.5mm", 2.5e-3), ("1.25mm", 1.25e-3)] {
        let particles = gate_scene(l0).fluid().particles().position.len() as u64;
        group.throughput(Throughput::Elements(particles));
        for parallel in pools() {
            group.bench_function(BenchmarkId::new(name, parallel.threads()), |bencher| {
                bencher.iter_custom(|steps| {
                    let mut spent = Duration::ZERO;
                    let mut left = steps;
                    while left > 0 {
                        let mut scene = gate_scene(l0);
                        let run = left.min(STEPS);
                        spent += parallel.install(|| {
                            scene.step(&parallel, 1.0).expect("a first step");
                            let start = Instant::now();
                            for _ in 0..run {
                                scene.step(&parallel, 1.0).expect("a stable step");
                            }
                            start.elapsed()
                        });
                        left -= run;
                    }
                    spent
                });
            });
        }
    }
}

criterion_group! { name = group; config = short(); targets = coupled }
criterion_main!(group);
