//! Reordering moves every field, and nothing else.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail the test")]

mod common;

use common::{Store, jittered};
use mps_kernel::{FieldVisitor, ParticleStore, Vector};
use mps_neighbors::{Cells, NeighborError, Open, Parallel, Permutation, state_hash};
use proptest::prelude::*;

fn order(n: usize) -> impl Strategy<Value = Vec<u32>> {
    Just((0..n as u32).collect::<Vec<_>>()).prop_shuffle()
}

/// The order that undoes `order`.
fn inverse(order: &[u32]) -> Vec<u32> {
    let mut inverse = vec![0; order.len()];
    for (k, &i) in order.iter().enumerate() {
        inverse[i as usize] = k as u32;
    }
    inverse
}

proptest! {
    #[test]
    fn every_field_moves_and_comes_back(order in (0usize..1500).prop_flat_map(order), threads in 1usize..4) {
        let before = Store::at((0..order.len()).map(|i| Vector::<f64, 3>::repeat(i as f64)).collect());
        let (mut store, mut permutation) = (before.clone(), Permutation::default());
        let parallel = Parallel::new(threads).unwrap();
        parallel.install(|| permutation.apply(&mut store, &order)).unwrap();
        for (k, &i) in order.iter().enumerate() {
            let i = i as usize;
            prop_assert_eq!(store.position[k], before.position[i]);
            prop_assert_eq!(store.velocity[k], before.velocity[i]);
            prop_assert_eq!(store.density[k], before.density[i]);
            prop_assert_eq!(store.small[k], before.small[i]);
            prop_assert_eq!(store.id[k], before.id[i]);
            prop_assert_eq!(store.flag[k], before.flag[i]);
        }
        permutation.apply(&mut store, &inverse(&order)).unwrap();
        prop_assert_eq!(state_hash(&mut store), state_hash(&mut before.clone()));
        prop_assert_eq!(store, before);
    }
}

#[test]
fn cells_give_a_permutation() {
    let points = jittered::<2>(50, 9);
    let mut cells = Cells::new();
    cells.build(&Parallel::serial(), &Open, &points, 3.3).unwrap();
    let mut order = cells.order().to_vec();
    assert!(!order.is_sorted());
    order.sort_unstable();
    assert!(order.iter().enumerate().all(|(k, &i)| k as u32 == i));
}

#[test]
fn wrong_orders_move_nothing() {
    let before = Store::<2>::at(vec![Vector::zeros(); 3]);
    let mut store = before.clone();
    let mut permutation = Permutation::default();
    assert_eq!(
        permutation.apply(&mut store, &[0, 2, 2]),
        Err(NeighborError::NoPermutation { entry: 2, particle: 2 })
    );
    assert_eq!(
        permutation.apply(&mut store, &[0, 3, 1]),
        Err(NeighborError::NoPermutation { entry: 1, particle: 3 })
    );
    assert_eq!(
        permutation.apply(&mut store, &[1, 0]),
        Err(NeighborError::Length { field: "position", expected: 2, found: 3 })
    );
    assert_eq!(store, before);
    store.small.pop();
    assert_eq!(
        permutation.apply(&mut store, &[2, 1, 0]),
        Err(NeighborError::Length { field: "small", expected: 3, found: 2 })
    );
    assert_eq!(store.id, before.id, "the fields before the wrong one have not moved either");
}

#[test]
fn the_hash_sees_every_bit_and_where_it_is() {
    let store = Store::<2>::at(jittered(5, 1));
    let hash = |change: &dyn Fn(&mut Store<2>)| {
        let mut changed = store.clone();
        change(&mut changed);
        state_hash(&mut changed)
    };
    let same = hash(&|_| ());
    assert_eq!(same, hash(&|_| ()));
    assert_ne!(same, hash(&|s| s.position[7][1] = s.position[7][1].next_up()));
    assert_ne!(same, hash(&|s| s.density[0] = -s.density[0]));
    assert_ne!(same, hash(&|s| s.flag[24] ^= 1));
    assert_ne!(same, hash(&|s| s.id.swap(3, 4)));
    assert_ne!(same, hash(&|s| std::mem::swap(&mut s.position, &mut s.velocity)));
}

/// Two fields of bytes.
struct Named([(&'static str, Vec<u8>); 2]);

impl ParticleStore for Named {
    fn len(&self) -> usize {
        self.0[0].1.len()
    }

    fn for_each_field(&mut self, visitor: &mut impl FieldVisitor) {
        for (name, field) in &mut self.0 {
            visitor.visit(name, field);
        }
    }
}

#[test]
fn the_hash_tells_fields_apart() {
    let hash = |a, b, cut: usize| {
        let bytes = [1, 2, 3, 4, 5];
        state_hash(&mut Named([(a, bytes[..cut].to_vec()), (b, bytes[cut..].to_vec())]))
    };
    let same = hash("a", "b", 2);
    assert_eq!(same, hash("a", "b", 2));
    assert_ne!(same, hash("a", "b", 3), "an entry has changed sides");
    assert_ne!(same, hash("a", "c", 2), "a field has another name");
}
