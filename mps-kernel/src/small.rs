//! Arithmetic of small vectors and tensors, of scalars and of lanes.
//!
//! What nalgebra does for scalars, written so that it is inlined whatever instructions the caller is
//! compiled for: a call per pair, which generic loops and closures leave behind in such code, costs more
//! than the pair. For the same reason [`by_axis!`](crate::by_axis) and [`by_axes!`](crate::by_axes) are macros.

use crate::{Number, Tensor, Vector};
use core::ops::{Add, Mul};
use nalgebra::ArrayStorage;

/// The vector with the components `by_axis!(axis => component)`.
///
/// ```
/// use mps_kernel::{Vector, by_axis};
/// let a: Vector<f64, 3> = by_axis!(axis => 2.0 * axis as f64);
/// assert_eq!(a, Vector::<f64, 3>::new(0.0, 2.0, 4.0));
/// ```
#[macro_export]
macro_rules! by_axis {
    ($axis:ident => $component:expr) => {{
        let mut components = {
            let $axis = 0_usize;
            [$component; _]
        };
        for k in 1..components.len() {
            let $axis = k;
            components[k] = $component;
        }
        $crate::small::vector(components)
    }};
}

/// The tensor with the components `by_axes!((row, column) => component)`.
///
/// ```
/// use mps_kernel::{Tensor, by_axes};
/// let a: Tensor<f64, 2> = by_axes!((row, column) => (10 * row + column) as f64);
/// assert_eq!(a, Tensor::<f64, 2>::new(0.0, 1.0, 10.0, 11.0));
/// ```
#[macro_export]
macro_rules! by_axes {
    (($row:ident, $column:ident) => $component:expr) => {{
        let mut components = {
            let ($row, $column) = (0_usize, 0_usize);
            $crate::small::square($component)
        };
        for k in 0..components.len() {
            for l in 0..components.len() {
                let ($row, $column) = (l, k);
                components[k][l] = $component;
            }
        }
        $crate::small::tensor(components)
    }};
}

/// The vector with these components.
#[inline(always)]
pub fn vector<N, const D: usize>(components: [N; D]) -> Vector<N, D> {
    Vector::from_array_storage(ArrayStorage([components]))
}

/// The tensor with these columns.
#[inline(always)]
pub fn tensor<N, const D: usize>(columns: [[N; D]; D]) -> Tensor<N, D> {
    Tensor::from_array_storage(ArrayStorage(columns))
}

/// As many columns as rows of the same value.
#[inline(always)]
pub fn square<N: Copy, const D: usize>(value: N) -> [[N; D]; D] {
    [[value; D]; D]
}

/// The components of a vector.
#[inline(always)]
pub fn components<N, const D: usize>(a: &Vector<N, D>) -> &[N; D] {
    &a.data.0[0]
}

/// The columns of a tensor.
#[inline(always)]
pub fn columns<N, const D: usize>(a: &Tensor<N, D>) -> &[[N; D]; D] {
    &a.data.0
}

/// `a . b`.
#[inline(always)]
pub fn dot<N: Number<T>, T, const D: usize>(a: &Vector<N, D>, b: &Vector<N, D>) -> N {
    let (a, b) = (components(a), components(b));
    let mut sum = a[0] * b[0];
    for axis in 1..D {
        sum += a[axis] * b[axis];
    }
    sum
}

/// `a - b`, where all lanes of `a` are compared with the one `b`.
#[inline(always)]
pub fn difference<N: Number<T>, T: Copy, const D: usize>(a: &Vector<N, D>, b: &Vector<T, D>) -> Vector<N, D> {
    let (a, b) = (components(a), components(b));
    by_axis!(axis => a[axis] - b[axis])
}

/// `a s`.
#[inline(always)]
pub fn scale<N: Number<T>, T, const D: usize>(a: &Vector<N, D>, s: N) -> Vector<N, D> {
    let a = components(a);
    by_axis!(axis => a[axis] * s)
}

/// `a (x) b`, the tensor with components `a_i b_j`.
#[inline(always)]
pub fn outer<N: Number<T>, T, const D: usize>(a: &Vector<N, D>, b: &Vector<N, D>) -> Tensor<N, D> {
    let (a, b) = (components(a), components(b));
    by_axes!((row, column) => a[row] * b[column])
}

/// `a v`, of a tensor of lanes or of the one tensor of the particle that looks.
#[inline(always)]
pub fn transform<N, M, const D: usize>(a: &Tensor<M, D>, v: &Vector<N, D>) -> Vector<N, D>
where
    N: Copy + Add<Output = N> + Mul<M, Output = N>,
    M: Copy,
{
    let (a, v) = (columns(a), components(v));
    let mut sum = [v[0] * a[0][0]; D];
    for row in 0..D {
        sum[row] = v[0] * a[0][row];
        for column in 1..D {
            sum[row] = sum[row] + v[column] * a[column][row];
        }
    }
    vector(sum)
}

/// `sum += a`.
#[inline(always)]
pub fn accumulate<N: Number<T>, T, const D: usize>(sum: &mut Vector<N, D>, a: &Vector<N, D>) {
    let (sum, a) = (&mut sum.data.0[0], components(a));
    for axis in 0..D {
        sum[axis] += a[axis];
    }
}

/// `sum += a (x) b`, where it is known to be symmetric: on and above the diagonal only. [`symmetric`] completes the sum.
#[inline(always)]
pub fn accumulate_symmetric<N: Number<T>, T, const D: usize>(
    sum: &mut Tensor<N, D>,
    a: &Vector<N, D>,
    b: &Vector<N, D>,
) {
    let (sum, a, b) = (&mut sum.data.0, components(a), components(b));
    for column in 0..D {
        for row in 0..column + 1 {
            sum[column][row] += a[row] * b[column];
        }
    }
}

/// The symmetric tensor with what `upper` has on and above the diagonal.
#[inline(always)]
pub fn symmetric<N: Copy, const D: usize>(upper: &Tensor<N, D>) -> Tensor<N, D> {
    let upper = columns(upper);
    by_axes!((row, column) => upper[if row > column { row } else { column }][if row > column { column } else { row }])
}

/// `sum += a`, of tensors.
#[inline(always)]
pub fn accumulate_tensor<N: Number<T>, T, const D: usize>(sum: &mut Tensor<N, D>, a: &Tensor<N, D>) {
    let (sum, a) = (&mut sum.data.0, columns(a));
    for column in 0..D {
        for row in 0..D {
            sum[column][row] += a[column][row];
        }
    }
}
