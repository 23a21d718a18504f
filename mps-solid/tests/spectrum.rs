//! The stiffness matrix of small bodies by differences of the forces: zero-energy modes, and the largest
//! eigenfrequency. What needs no feature; more bodies, and disturbed ones, are in `zero_modes.rs`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail the test")]

mod common;

use common::{block, deform};
use mps_kernel::Vector;
use mps_solid::Solid;
use mps_solid::materials::CorotationalHooke;
use nalgebra::{DMatrix, SymmetricEigen};

/// `omega^2` of all modes \[1/s^2\], ascending, by differences of the forces.
fn squared_frequencies<const D: usize>(solid: &mut Solid<f64, D, CorotationalHooke<f64>>) -> Vec<f64> {
    let moving: Vec<usize> = (0..solid.len()).filter(|&i| !solid.particles().is_clamped(i)).collect();
    let size = moving.len() * D;
    let step = 1e-4 * solid.spacing().min();
    let mut matrix = DMatrix::zeros(size, size);
    for column in 0..size {
        let mut force_at = |shift: f64| {
            let mut k = 0;
            deform(solid, |x| {
                let mut x = *x;
                if k == moving[column / D] {
                    x[column % D] += shift;
                }
                k += 1;
                x
            });
            solid.particles().internal_forces().to_vec()
        };
        let (there, back) = (force_at(step), force_at(-step));
        for row in 0..size {
            let (i, axis) = (moving[row / D], row % D);
            let scale = (solid.masses()[i] * solid.masses()[moving[column / D]]).sqrt();
            matrix[(row, column)] = (back[i][axis] - there[i][axis]) / (2.0 * step * scale);
        }
    }
    let asymmetry = (&matrix - matrix.transpose()).norm() / matrix.norm();
    assert!(asymmetry < 1e-6, "the stiffness of an energy is symmetric, this one misses by {asymmetry}");
    let symmetric = (&matrix + matrix.transpose()) * 0.5;
    let mut squares: Vec<f64> = SymmetricEigen::new(symmetric).eigenvalues.iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    squares
}

fn has_only_rigid_zero_modes<const D: usize>(counts: [usize; D], nu: f64) {
    let rigid = D * (D + 1) / 2;
    let mut solid = block(counts, &[], CorotationalHooke::new(2.0e6, nu).unwrap());
    let squares = squared_frequencies(&mut solid);
    let largest = squares[squares.len() - 1];
    for square in &squares[..rigid] {
        assert!(square.abs() < 1e-7 * largest, "rigid mode {square:e} of {largest:e} for {counts:?}");
    }
    // The slowest elastic mode is bending; nothing spurious lies between it and zero.
    let long = counts.iter().max().copied().unwrap_or(1) as f64;
    let slowest = squares[rigid] / largest;
    assert!(slowest > 0.05 / long.powi(4), "slowest elastic mode {slowest:e} for {counts:?}");
    // The estimate made at set-up approaches the largest frequency from below.
    let ratio = solid.stability_limit() * largest.sqrt() / 2.0;
    assert!((0.9999..1.02).contains(&ratio), "stability limit off by {ratio} for {counts:?}, nu {nu}");
}

#[test]
fn free_patch_has_three_zero_modes_in_the_plane() {
    for counts in [[6, 6], [12, 2], [2, 2]] {
        for nu in [0.0, 0.47] {
            has_only_rigid_zero_modes(counts, nu);
        }
    }
}

#[test]
fn free_patch_has_six_zero_modes_in_space() {
    for counts in [[6, 2, 2], [5, 4, 2]] {
        for nu in [0.0, 0.4] {
            has_only_rigid_zero_modes(counts, nu);
        }
    }
}

/// A central difference cannot see a displacement that alternates from particle to particle; the
/// non-affine energy can, and it alone holds such a mode.
#[test]
fn alternating_displacement_is_held_by_the_bending_energy() {
    let mut solid = block([9, 9], &[], CorotationalHooke::new(2.0e6, 0.3).unwrap());
    let spacing = *solid.spacing();
    let amplitude = 1e-3 * spacing.x;
    let parity = |x: f64, l: f64| (x / l - 0.5).round();
    deform(&mut solid, |x| {
        let step = parity(x.x, spacing.x) + parity(x.y, spacing.y);
        x + Vector::<f64, 2>::new(amplitude, 0.0) * if step % 2.0 == 0.0 { 1.0 } else { -1.0 }
    });
    let center = 4 * 9 + 4;
    let strain = (solid.particles().deformations()[center] - nalgebra::Matrix2::identity()).norm();
    assert!(strain < 1e-12, "{strain}");
    let force = solid.particles().internal_forces()[center].norm();
    // About kappa V 2 w (2 amplitude) for each of the four nearest neighbours, twice.
    let scale = solid.bending_coefficient() * solid.volumes()[center] / spacing.x.powi(2) * amplitude;
    assert!(force > 0.5 * scale, "{force} against {scale}");
}
