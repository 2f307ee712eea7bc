//! Numbers of four lanes, for the instruction sets that there are.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{LANES, Lanes, Real};

/// The operations of an instruction set on four lanes.
pub trait Instructions: Copy {
    /// Four values in registers.
    type Values: Copy;
    /// To registers.
    fn load(self, values: [f64; LANES]) -> Self::Values;
    /// To memory.
    fn store(self, values: Self::Values) -> [f64; LANES];
    /// `a + b`
    fn add(self, a: Self::Values, b: Self::Values) -> Self::Values;
    /// `a - b`
    fn sub(self, a: Self::Values, b: Self::Values) -> Self::Values;
    /// `a * b`
    fn mul(self, a: Self::Values, b: Self::Values) -> Self::Values;
    /// `a / b`
    fn div(self, a: Self::Values, b: Self::Values) -> Self::Values;
    /// `-a`
    fn neg(self, a: Self::Values) -> Self::Values;
    /// Square root.
    fn sqrt(self, a: Self::Values) -> Self::Values;
}

/// A number of four lanes.
#[derive(Clone, Copy)]
pub struct Four<I: Instructions> {
    instructions: I,
    values: I::Values,
}

impl<I: Instructions> Lanes for I {
    type Real = Four<I>;

    #[inline(always)]
    fn load(self, values: [f64; LANES]) -> Four<I> {
        Four {
            instructions: self,
            values: Instructions::load(self, values),
        }
    }
}

impl<I: Instructions> Four<I> {
    #[inline(always)]
    fn all(self, value: f64) -> Self {
        Lanes::load(self.instructions, [value; LANES])
    }
}

impl<I: Instructions> Real for Four<I> {
    type Cell = [f64; LANES];

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self {
            values: self.instructions.sqrt(self.values),
            ..self
        }
    }

    #[inline(always)]
    fn dividing(self, numerator: f64) -> Self {
        self.all(numerator) / self
    }
}

impl<I: Instructions> Neg for Four<I> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            values: self.instructions.neg(self.values),
            ..self
        }
    }
}

/// An operator between numbers of four lanes, and with one value for all lanes.
macro_rules! operator {
    ($operator:ident, $method:ident) => {
        impl<I: Instructions> $operator for Four<I> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self {
                    values: self.instructions.$method(self.values, other.values),
                    ..self
                }
            }
        }

        impl<I: Instructions> $operator<f64> for Four<I> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                $operator::$method(self, self.all(other))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<I: Instructions> AddAssign<Four<I>> for [f64; LANES] {
    #[inline(always)]
    fn add_assign(&mut self, other: Four<I>) {
        let sum = Lanes::load(other.instructions, *self) + other;
        *self = other.instructions.store(sum.values);
    }
}

impl<I: Instructions> SubAssign<Four<I>> for [f64; LANES] {
    #[inline(always)]
    fn sub_assign(&mut self, other: Four<I>) {
        let difference = Lanes::load(other.instructions, *self) - other;
        *self = other.instructions.store(difference.values);
    }
}

/// AVX2.
#[cfg(target_arch = "x86_64")]
pub mod avx2 {
    use std::sync::LazyLock;

    use pulp::x86::V3;
    use pulp::{Simd, WithSimd, cast, f64x4};

    use super::Instructions;
    use crate::emitted::lanes::{Kernel, LANES};

    static AVAILABLE: LazyLock<Option<V3>> = LazyLock::new(V3::try_new);

    /// Runs a kernel compiled for AVX2 if the processor has it; says whether it has.
    #[inline]
    pub fn run<K: Kernel>(kernel: K) -> bool {
        let Some(set) = *AVAILABLE else {
            return false;
        };
        Simd::vectorize(set, Vectorized(set, kernel));
        true
    }

    struct Vectorized<K>(V3, K);

    impl<K: Kernel> WithSimd for Vectorized<K> {
        type Output = ();

        #[inline(always)]
        fn with_simd<S: Simd>(self, _: S) {
            self.1.run(self.0);
        }
    }

    impl Instructions for V3 {
        type Values = f64x4;

        #[inline(always)]
        fn load(self, values: [f64; LANES]) -> f64x4 {
            cast(values)
        }
        #[inline(always)]
        fn store(self, values: f64x4) -> [f64; LANES] {
            cast(values)
        }
        #[inline(always)]
        fn add(self, a: f64x4, b: f64x4) -> f64x4 {
            self.add_f64s(a, b)
        }
        #[inline(always)]
        fn sub(self, a: f64x4, b: f64x4) -> f64x4 {
            self.sub_f64s(a, b)
        }
        #[inline(always)]
        fn mul(self, a: f64x4, b: f64x4) -> f64x4 {
            self.mul_f64s(a, b)
        }
        #[inline(always)]
        fn div(self, a: f64x4, b: f64x4) -> f64x4 {
            self.div_f64s(a, b)
        }
        #[inline(always)]
        fn neg(self, a: f64x4) -> f64x4 {
            self.neg_f64s(a)
        }
        #[inline(always)]
        fn sqrt(self, a: f64x4) -> f64x4 {
            self.sqrt_f64x4(a)
        }
    }
}
