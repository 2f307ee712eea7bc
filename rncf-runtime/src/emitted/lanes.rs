//! Four elements side by side: what a generated kernel needs of its number type, a type of four lanes, and the
//! choice of the instruction set at run time.
//!
//! A kernel is written once, generic over [`Real`]. With `f64` it is the kernel of one element; with the numbers of
//! [`Lanes`] it evaluates four at a time. Multiplications and additions are never contracted to fused ones: every
//! lane then has the same bits as the kernel of one element, on every machine.

#[cfg(target_arch = "x86_64")]
mod four;

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Elements that are evaluated side by side.
pub const LANES: usize = 4;

/// A number of a kernel: one value, or one for each lane.
///
/// Literals stand to the right of an operator: `x * 2.0`. Every operation is rounded as that of `f64`.
pub trait Real:
    Copy
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// What a result is added to in memory: `f64`, or one for each lane.
    type Cell: Copy + AddAssign<Self> + SubAssign<Self>;

    /// Square root.
    fn sqrt(self) -> Self;

    /// `numerator / self`.
    fn dividing(self, numerator: f64) -> Self;

    /// `1 / self`.
    #[inline(always)]
    fn recip(self) -> Self {
        self.dividing(1.0)
    }

    /// `self^n` for n >= 1 by repeated squaring.
    #[inline(always)]
    fn powi(self, n: i32) -> Self {
        let mut power = self;
        let mut bit = 31 - n.leading_zeros();
        while bit > 0 {
            bit -= 1;
            power = power * power;
            if n >> bit & 1 == 1 {
                power = power * self;
            }
        }
        power
    }
}

impl Real for f64 {
    type Cell = Self;

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn dividing(self, numerator: f64) -> Self {
        numerator / self
    }
}

/// Makes numbers of four lanes for one instruction set.
pub trait Lanes: Copy {
    /// Numbers of four lanes.
    type Real: Real<Cell = [f64; LANES]>;

    /// The number with these values in its lanes.
    fn load(self, values: [f64; LANES]) -> Self::Real;

    /// The number with one value of each element in its lanes.
    #[inline(always)]
    fn of_each<E>(self, [a, b, c, d]: [&E; LANES], value: impl Fn(&E) -> f64) -> Self::Real {
        self.load([value(a), value(b), value(c), value(d)])
    }

    /// Several of them.
    #[inline(always)]
    fn load_all<const N: usize>(self, values: &[[f64; LANES]; N]) -> [Self::Real; N] {
        let mut loaded = [self.load([0.0; LANES]); N];
        for (number, values) in loaded.iter_mut().zip(values) {
            *number = self.load(*values);
        }
        loaded
    }

    /// Several of them from one array for each lane.
    #[inline(always)]
    fn gather<const N: usize>(self, values: [&[f64; N]; LANES]) -> [Self::Real; N] {
        let mut loaded = [self.load([0.0; LANES]); N];
        for (place, number) in loaded.iter_mut().enumerate() {
            *number = self.load(values.map(|own| own[place]));
        }
        loaded
    }
}

/// A kernel with its arguments, to be run with an instruction set that is known only at run time.
pub trait Kernel {
    /// Runs it; implementations are `#[inline(always)]`, since only then are the operations compiled for the
    /// instruction set.
    fn run<L: Lanes>(self, lanes: L);
}

/// Runs a kernel if the processor has instructions for four lanes (AVX2), and says whether it has; where it has not,
/// the kernel of one element for each lane gives the same bits.
#[inline]
pub fn run(kernel: impl Kernel) -> bool {
    #[cfg(target_arch = "x86_64")]
    let ran = four::avx2::run(kernel);
    #[cfg(not(target_arch = "x86_64"))]
    let ran = {
        drop(kernel);
        false
    };
    ran
}

/// One of four elements' numbers.
pub fn lane<const N: usize>(all: &[[f64; LANES]], lane: usize) -> [f64; N] {
    std::array::from_fn(|place| all[place][lane])
}

/// Adds the numbers of one of four elements.
pub fn add_lane(all: &mut [[f64; LANES]], lane: usize, own: &[f64]) {
    for (sum, value) in all.iter_mut().zip(own) {
        sum[lane] += value;
    }
}
