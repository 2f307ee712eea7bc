//! The two fields in which systems are solved.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

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
    /// The real number as an element of the field.
    fn real(value: f64) -> Self;
    /// |re| + |im|: the size by which pivots are chosen.
    fn size(self) -> f64;
    /// Product with a real number.
    fn times(self, factor: f64) -> Self;
    /// 1 / self.
    fn inverse(self) -> Self;
}

impl Scalar for f64 {
    fn real(value: f64) -> Self {
        value
    }

    fn size(self) -> f64 {
        self.abs()
    }

    fn times(self, factor: f64) -> Self {
        self * factor
    }

    fn inverse(self) -> Self {
        1.0 / self
    }
}

impl Scalar for c64 {
    fn real(value: f64) -> Self {
        c64::new(value, 0.0)
    }

    fn size(self) -> f64 {
        self.re.abs() + self.im.abs()
    }

    fn times(self, factor: f64) -> Self {
        c64::new(self.re * factor, self.im * factor)
    }

    fn inverse(self) -> Self {
        let square = self.re * self.re + self.im * self.im;
        c64::new(self.re / square, -self.im / square)
    }
}
