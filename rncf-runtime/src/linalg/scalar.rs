//! The two fields in which systems are solved.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use super::column::{Column, Split};

pub use faer::c64;

/// A real or complex number: `f64` or [`c64`].
pub trait Scalar:
    faer::traits::ComplexField
    + Copy
    + Debug
    + Default
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// Some numbers of the field below each other.
    type Column<const N: usize>: Column<Self, N>;

    /// The real number as an element of the field.
    fn real(value: f64) -> Self;
    /// Whether it is a real number below zero.
    fn is_negative(self) -> bool;
    /// |re| + |im|: the size by which pivots are chosen.
    fn size(self) -> f64;
    /// Product with a real number.
    fn times(self, factor: f64) -> Self;
    /// 1 / self.
    fn inverse(self) -> Self;
    /// `self + a b`, rounded once for real numbers: fast where the processor does so, slow elsewhere.
    fn fused(self, a: Self, b: Self) -> Self;
}

impl Scalar for f64 {
    type Column<const N: usize> = [f64; N];

    #[inline(always)]
    fn is_negative(self) -> bool {
        self < 0.0
    }

    #[inline(always)]
    fn real(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn size(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        self * factor
    }

    #[inline(always)]
    fn inverse(self) -> Self {
        1.0 / self
    }

    #[inline(always)]
    fn fused(self, a: Self, b: Self) -> Self {
        a.mul_add(b, self)
    }
}

impl Scalar for c64 {
    type Column<const N: usize> = Split<N>;

    #[inline(always)]
    fn is_negative(self) -> bool {
        false
    }

    #[inline(always)]
    fn real(value: f64) -> Self {
        c64::new(value, 0.0)
    }

    #[inline(always)]
    fn size(self) -> f64 {
        self.re.abs() + self.im.abs()
    }

    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        c64::new(self.re * factor, self.im * factor)
    }

    #[inline(always)]
    fn inverse(self) -> Self {
        let square = self.re * self.re + self.im * self.im;
        c64::new(self.re / square, -self.im / square)
    }

    #[inline(always)]
    fn fused(self, a: Self, b: Self) -> Self {
        self + a * b
    }
}
