//! The solid: forces and sub-steps of the gate and of a large block.

#![allow(missing_docs, clippy::expect_used)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use mps_benches::{gate, pools, rubber, short};
use mps_kernel::Vector;

/// Sub-steps in one call, as in a coupled step.
const SUBSTEPS: usize = 10;

fn solid(criterion: &mut Criterion) {
    let bodies = [("gate_4x63", gate(4)), ("block_100x100", rubber([0.0; 2], [0.1; 2], [100, 100]))];
    let mut group = criterion.benchmark_group("solid");
    for (name, body) in &bodies {
        let particles = body.len() as u64;
        let gravity = Vector::<f64, 2>::new(0.0, -9.81);
        let no_load = vec![Vector::<f64, 2>::zeros(); body.len()];
        for parallel in pools() {
            let mut body = body.clone();
            let dt = body.max_step(&parallel);
            group.throughput(Throughput::Elements(particles));
            group.bench_function(BenchmarkId::new(format!("{name}/force"), parallel.threads()), |bencher| {
                parallel.install(|| bencher.iter(|| body.refresh(&parallel)));
            });
            group.throughput(Throughput::Elements(particles * SUBSTEPS as u64));
            let id = BenchmarkId::new(format!("{name}/substep"), parallel.threads());
            group.bench_function(id, |bencher| {
                let mut advance = || {
                    body.advance(&parallel, &no_load, &gravity, dt * SUBSTEPS as f64, SUBSTEPS)
                        .expect("a stable step");
                };
                parallel.install(|| bencher.iter(&mut advance));
            });
        }
    }
}

criterion_group! { name = group; config = short(); targets = solid }
criterion_main!(group);
