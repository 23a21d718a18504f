//! Several pairs side by side in a vector register.
//!
//! The number of lanes is fixed for each scalar, whatever the processor: a machine without registers
//! of that width takes two narrower ones, and the bits of every sum stay the same. Multiplication and
//! addition are never fused, for the same reason.

use crate::{Number, Real};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use fearless_simd::{Select, Simd, SimdBase, SimdFloat, f32x8, f64x4};

/// A [`Number`] that holds one value for each of several neighbours.
///
/// `S` stands for the instructions the processor has; a value of it is handed to every sweep.
pub trait Lanes<T: Real, S: Simd>: Number<T> {
    /// Number of lanes.
    const COUNT: usize;

    /// The same value in every lane.
    fn splat(simd: S, value: T) -> Self;

    /// `value(k)` in lane `k`.
    fn gather(simd: S, value: impl FnMut(usize) -> T) -> Self;

    /// One in the first `count` lanes, zero in the others.
    fn first(simd: S, count: usize) -> Self;

    /// Sum over the lanes, always in the same order.
    fn sum(self) -> T;
}

macro_rules! lanes {
    ($name:ident, $vector:ident, $real:ty, $count:literal) => {
        #[doc = concat!(stringify!($count), " values of type `", stringify!($real), "` side by side.")]
        #[derive(Clone, Copy, Debug)]
        #[repr(transparent)]
        pub struct $name<S: Simd>($vector<S>);

        impl<S: Simd> Lanes<$real, S> for $name<S> {
            const COUNT: usize = $count;

            #[inline(always)]
            fn splat(simd: S, value: $real) -> Self {
                Self($vector::splat(simd, value))
            }

            #[inline(always)]
            fn gather(simd: S, value: impl FnMut(usize) -> $real) -> Self {
                Self($vector::from_fn(simd, value))
            }

            #[inline(always)]
            fn first(simd: S, count: usize) -> Self {
                // A window into ones followed by zeros.
                const WINDOW: [$real; 2 * $count] = {
                    let mut window = [0.0; 2 * $count];
                    let mut k = 0;
                    while k < $count {
                        window[k] = 1.0;
                        k += 1;
                    }
                    window
                };
                let from = $count - count.min($count);
                Self($vector::from_slice(simd, &WINDOW[from..from + $count]))
            }

            #[inline(always)]
            fn sum(self) -> $real {
                let lanes = self.0.as_slice();
                let (mut values, mut half) = ([0.0; $count], $count / 2);
                values.copy_from_slice(lanes);
                while half > 0 {
                    for k in 0..half {
                        values[k] += values[k + half];
                    }
                    half /= 2;
                }
                values[0]
            }
        }

        impl<S: Simd> Number<$real> for $name<S> {
            #[inline(always)]
            fn root(self) -> Self {
                Self(self.0.sqrt())
            }

            #[inline(always)]
            fn dividing(self, numerator: $real) -> Self {
                Self($vector::splat(self.0.simd, numerator) / self.0)
            }

            #[inline(always)]
            fn exponential(self) -> Self {
                Self($vector::from_fn(self.0.simd, |k| self.0[k].exp()))
            }

            #[inline(always)]
            fn nearest(self) -> Self {
                Self(self.0.round_ties_even())
            }

            #[inline(always)]
            fn at_least(self, floor: $real) -> Self {
                Self(self.0.max(floor))
            }

            #[inline(always)]
            fn at_most(self, ceiling: $real) -> Self {
                Self(self.0.min(ceiling))
            }

            #[inline(always)]
            fn where_below(self, key: Self, limit: $real) -> Self {
                let limit = $vector::splat(self.0.simd, limit);
                let zero = $vector::splat(self.0.simd, 0.0);
                Self(key.0.simd_lt(limit).select(self.0, zero))
            }
        }

        impl<S: Simd> PartialEq for $name<S> {
            #[inline(always)]
            fn eq(&self, other: &Self) -> bool {
                self.0.as_slice() == other.0.as_slice()
            }
        }

        impl<S: Simd> Neg for $name<S> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        lanes!(@operator $name, $real, Add, add, AddAssign, add_assign);
        lanes!(@operator $name, $real, Sub, sub, SubAssign, sub_assign);
        lanes!(@operator $name, $real, Mul, mul, MulAssign, mul_assign);
        lanes!(@operator $name, $real, Div, div, DivAssign, div_assign);
    };
    (@operator $name:ident, $real:ty, $trait:ident, $method:ident, $assign:ident, $assign_method:ident) => {
        impl<S: Simd> $trait for $name<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($trait::$method(self.0, other.0))
            }
        }

        impl<S: Simd> $trait<$real> for $name<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: $real) -> Self {
                Self($trait::$method(self.0, other))
            }
        }

        impl<S: Simd> $assign for $name<S> {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    };
}

lanes!(F64Lanes, f64x4, f64, 4);
lanes!(F32Lanes, f32x8, f32, 8);
