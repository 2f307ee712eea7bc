//! Columns of few numbers, laid out for vector instructions: parts of complex numbers stand apart.

use std::fmt::Debug;

use faer::c64;

/// `N` numbers of the field `T` below each other: their real parts, then, of complex numbers, their imaginary parts.
pub trait Column<T, const N: usize>: Copy + Debug + Send + Sync {
    /// Of zeros.
    const ZERO: Self;

    /// The number at a place.
    fn get(&self, place: usize) -> T;

    /// Writes the number at a place.
    fn set(&mut self, place: usize, value: T);

    /// Of numbers that stand together.
    fn of(values: &[T; N]) -> Self;

    /// The numbers, together.
    fn together(&self) -> [T; N];

    /// Multiplies all by a number.
    fn scale(&mut self, factor: T);

    /// `self += factor x`; `F` says whether products and sums are fused.
    fn add_scaled<const F: bool>(&mut self, factor: T, x: &Self);

    /// The sizes of both, of which the larger ones stay: by parts.
    fn take_larger(&mut self, other: &Self);

    /// Whether all sizes are at most `limit` times those of `other`; false where one is not a number.
    fn is_within(&self, limit: f64, other: &Self) -> bool;
}

/// `c + a b`.
#[inline(always)]
fn sum<const F: bool>(c: f64, a: f64, b: f64) -> f64 {
    if F { a.mul_add(b, c) } else { c + a * b }
}

impl<const N: usize> Column<f64, N> for [f64; N] {
    const ZERO: Self = [0.0; N];

    #[inline(always)]
    fn get(&self, place: usize) -> f64 {
        self[place]
    }

    #[inline(always)]
    fn set(&mut self, place: usize, value: f64) {
        self[place] = value;
    }

    #[inline(always)]
    fn of(values: &[f64; N]) -> Self {
        *values
    }

    #[inline(always)]
    fn together(&self) -> [f64; N] {
        *self
    }

    #[inline(always)]
    fn scale(&mut self, factor: f64) {
        for value in self {
            *value *= factor;
        }
    }

    #[inline(always)]
    fn add_scaled<const F: bool>(&mut self, factor: f64, x: &Self) {
        for (value, x) in self.iter_mut().zip(x) {
            *value = sum::<F>(*value, factor, *x);
        }
    }

    #[inline(always)]
    fn take_larger(&mut self, other: &Self) {
        for (value, other) in self.iter_mut().zip(other) {
            let (own, other) = (value.abs(), other.abs());
            *value = if own > other { own } else { other };
        }
    }

    #[inline(always)]
    fn is_within(&self, limit: f64, other: &Self) -> bool {
        let within = self.iter().zip(other);
        within.fold(true, |all, (value, other)| all & (value.abs() <= limit * other.abs()))
    }
}

/// Complex numbers: real parts, imaginary parts.
#[derive(Clone, Copy, Debug)]
pub struct Split<const N: usize> {
    re: [f64; N],
    im: [f64; N],
}

impl<const N: usize> Column<c64, N> for Split<N> {
    const ZERO: Self = Self {
        re: [0.0; N],
        im: [0.0; N],
    };

    #[inline(always)]
    fn get(&self, place: usize) -> c64 {
        c64::new(self.re[place], self.im[place])
    }

    #[inline(always)]
    fn set(&mut self, place: usize, value: c64) {
        self.re[place] = value.re;
        self.im[place] = value.im;
    }

    #[inline(always)]
    fn of(values: &[c64; N]) -> Self {
        Self {
            re: values.map(|value| value.re),
            im: values.map(|value| value.im),
        }
    }

    #[inline(always)]
    fn together(&self) -> [c64; N] {
        std::array::from_fn(|place| self.get(place))
    }

    #[inline(always)]
    fn scale(&mut self, factor: c64) {
        for (re, im) in self.re.iter_mut().zip(&mut self.im) {
            (*re, *im) = (*re * factor.re - *im * factor.im, *re * factor.im + *im * factor.re);
        }
    }

    #[inline(always)]
    fn add_scaled<const F: bool>(&mut self, factor: c64, x: &Self) {
        for place in 0..N {
            let (re, im) = (x.re[place], x.im[place]);
            self.re[place] = sum::<F>(sum::<F>(self.re[place], factor.re, re), -factor.im, im);
            self.im[place] = sum::<F>(sum::<F>(self.im[place], factor.re, im), factor.im, re);
        }
    }

    #[inline(always)]
    fn take_larger(&mut self, other: &Self) {
        self.re.take_larger(&other.re);
        self.im.take_larger(&other.im);
    }

    #[inline(always)]
    fn is_within(&self, limit: f64, other: &Self) -> bool {
        let size = |of: &Self, place: usize| of.re[place].abs() + of.im[place].abs();
        (0..N).fold(true, |all, place| {
            all & (size(self, place) <= limit * size(other, place))
        })
    }
}
