//! What a pair formula is written for: one number, or several side by side.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// One scalar `T`, or the same quantity of several pairs in the lanes of a vector register.
///
/// Weights and operators are written once, for any `Number`: a scalar takes part as itself, the sweeps
/// of a solver hand over [`Lanes`](crate::Lanes) and get several pairs for one. What belongs to the
/// particle that looks stays a scalar `T` in both cases, hence the arithmetic between the two.
pub trait Number<T>:
    Copy
    + Debug
    + PartialEq
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + Add<T, Output = Self>
    + Sub<T, Output = Self>
    + Mul<T, Output = Self>
    + Div<T, Output = Self>
{
    /// Square root.
    fn root(self) -> Self;

    /// `numerator / self`.
    fn dividing(self, numerator: T) -> Self;

    /// `e` to the power of the value.
    fn exponential(self) -> Self;

    /// Rounded to the nearest whole number, halves to the even one.
    fn nearest(self) -> Self;

    /// The value, or `floor` where it is not above it.
    ///
    /// One instruction, hence what becomes of NaN is the processor's: that of x86 makes it `floor`, others leave it. To look for NaN on
    /// both sides, as `max` of a scalar does, costs the pair loop several percent.
    fn at_least(self, floor: T) -> Self;

    /// The value, or `ceiling` where it is not below it; see [`at_least`](Self::at_least).
    fn at_most(self, ceiling: T) -> Self;

    /// The value where `key < limit`, zero elsewhere.
    fn where_below(self, key: Self, limit: T) -> Self;
}

macro_rules! scalar {
    ($real:ty) => {
        impl Number<$real> for $real {
            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }

            #[inline(always)]
            fn dividing(self, numerator: $real) -> Self {
                numerator / self
            }

            #[inline(always)]
            fn exponential(self) -> Self {
                self.exp()
            }

            #[inline(always)]
            fn nearest(self) -> Self {
                self.round_ties_even()
            }

            #[inline(always)]
            fn at_least(self, floor: $real) -> Self {
                if self > floor { self } else { floor }
            }

            #[inline(always)]
            fn at_most(self, ceiling: $real) -> Self {
                if self < ceiling { self } else { ceiling }
            }

            #[inline(always)]
            fn where_below(self, key: Self, limit: $real) -> Self {
                if key < limit { self } else { 0.0 }
            }
        }
    };
}

scalar!(f32);
scalar!(f64);
