//! What a fluid loses in a uniform strain, full and cut off by a free surface: `CentralLaplacian`.

use crate::common::{Cloud, Weight};
use mps_kernel::operators::CentralLaplacian;
use mps_kernel::{Neighborhood, PairOperator, Tensor, Vector};

/// Layers of the slab; its middle is further than any radius from its surfaces.
const LAYERS: usize = 11;

/// Loss of one particle, `-sum_j (u_j - u_i) . a_ij/2`, of the column through the middle of a slab between free surfaces, bottom up, in the
/// flow `strain r`; with and without completion.
fn losses<const D: usize>(weight: Weight, ratio: f64, strain: Tensor<f64, D>) -> (Vec<f64>, Vec<f64>) {
    let cloud = Cloud::<f64, D>::lattice(weight, 1.0, ratio, LAYERS);
    let flow: Vec<_> = cloud.at.iter().map(|r| strain * r).collect();
    let operator = CentralLaplacian { factor: 2.0 * (D as f64 + 2.0) * cloud.factor() };
    let n0 = cloud.reference().n0;
    // The column reaches along the last axis; the sides of the block are far from it.
    let column: Vec<usize> =
        (0..cloud.at.len()).filter(|&i| (0..D - 1).all(|axis| cloud.at[i][axis] == 0.0)).collect();
    assert_eq!(column.len(), LAYERS);
    let measured = column.into_iter().map(|i| {
        let (mut loss, mut weights) = (0.0, 0.0);
        cloud.for_each(i, |pair| {
            let mut force = Vector::zeros();
            operator.add(&mut force, &flow[i], &flow[pair.j], pair);
            loss += 0.5 * force.dot(&(flow[pair.j] - flow[i]));
            weights += pair.weight;
        });
        (loss, loss * CentralLaplacian::completion(weights / n0))
    });
    measured.unzip()
}

/// What is missing of the loss along one surface, as the thickness of a layer without any, over the radius.
fn missing(losses: &[f64], ratio: f64) -> f64 {
    let full = losses[LAYERS / 2];
    losses[..LAYERS / 2].iter().map(|loss| 1.0 - loss / full).sum::<f64>() / ratio
}

/// Stretch across the surface and, turned by 45 degrees in the plane of first and last axis, shear along it.
fn strains<const D: usize>() -> [Tensor<f64, D>; 2] {
    let (mut stretch, mut shear) = (Tensor::zeros(), Tensor::zeros());
    stretch[(0, 0)] = 1.0;
    stretch[(D - 1, D - 1)] = -1.0;
    shear[(0, D - 1)] = 1.0;
    shear[(D - 1, 0)] = 1.0;
    [stretch, shear]
}

/// Inside, the mean over both strains is that of all directions on a square lattice: `2 E : E = 4`, to round-off. On a
/// cubic one it is that of these two directions only.
#[test]
fn a_full_neighbourhood_loses_what_a_viscous_fluid_does() {
    for weight in Weight::ALL {
        let [stretch, shear] = strains::<2>().map(|strain| losses(weight, 3.0, strain).0[LAYERS / 2]);
        assert!((0.5 * (stretch + shear) / 4.0 - 1.0).abs() < 1e-12, "{weight:?}: {stretch}, {shear}");
    }
    for strain in strains::<3>() {
        let loss = losses(Weight::WendlandGradient, 4.0, strain).0[LAYERS / 2];
        assert!((loss / 4.0 - 1.0).abs() < 0.03, "{loss}");
    }
}

#[test]
fn completion_leaves_a_full_neighbourhood_alone() {
    for weight in Weight::ALL {
        for strain in strains::<2>() {
            let (plain, whole) = losses(weight, 3.0, strain);
            let middle = LAYERS / 2;
            assert!((whole[middle] / plain[middle] - 1.0).abs() < 1e-14);
        }
    }
}

/// Uncompleted, the loss is missing in a layer of a sixth of the radius. What stays after completion is the lack of isotropy of
/// the missing cap: of opposite sign for the two strains, so that their mean is right to 0.2 % of the radius in 2D, to 3.5 % in 3D.
#[test]
fn completion_restores_the_loss_along_a_free_surface() {
    let flat = strains::<2>().map(|strain| losses(Weight::WendlandGradient, 4.0, strain));
    let plain = flat.each_ref().map(|(plain, _)| missing(plain, 4.0));
    let whole = flat.each_ref().map(|(_, whole)| missing(whole, 4.0));
    assert!((0.5 * (plain[0] + plain[1]) - 1.0 / 6.0).abs() < 0.015, "{plain:?}");
    assert!((whole[0] + whole[1]).abs() < 0.004 && whole.iter().all(|layer| layer.abs() < 0.04), "{whole:?}");

    let solid = strains::<3>().map(|strain| losses(Weight::WendlandGradient, 4.0, strain));
    for (plain, whole) in &solid {
        assert!(missing(plain, 4.0) > 0.13 && missing(whole, 4.0).abs() < 0.07, "{}", missing(whole, 4.0));
    }
    let mean = 0.5 * (missing(&solid[0].1, 4.0) + missing(&solid[1].1, 4.0));
    assert!(mean.abs() < 0.035, "{mean}");
}

/// Exactly half a neighbourhood, on either side of a particle, has exactly half the loss, whatever the strain and the weight.
#[test]
fn half_a_neighbourhood_has_half_the_loss_in_any_strain() {
    let strain = Tensor::<f64, 2>::new(0.3, 1.7, -0.4, -0.3);
    let up = Vector::from([0.21, 0.98]);
    for weight in Weight::ALL {
        let cloud = Cloud::<f64, 2>::lattice(weight, 1.0, 3.0, LAYERS);
        let operator = CentralLaplacian { factor: 1.0 };
        let (mut half, mut full, mut weights) = (0.0, 0.0, [0.0; 2]);
        cloud.for_each(cloud.middle(), |pair| {
            let force = operator.pair(&Vector::zeros(), &(strain * pair.r_ij), pair);
            let loss = force.dot(&(strain * pair.r_ij));
            let above = up.dot(&pair.r_ij) > 0.0;
            half += if above { loss } else { 0.0 };
            full += loss;
            weights[usize::from(above)] += pair.weight;
        });
        let k = weights[1] / (weights[0] + weights[1]);
        assert!((half * CentralLaplacian::completion(k) / full - 1.0).abs() < 1e-12, "{weight:?}");
    }
}

#[test]
fn spray_is_completed_no_more_than_fourfold() {
    for k in [0.0, 0.01, 0.25] {
        assert_eq!(CentralLaplacian::completion(k), 4.0);
    }
}
