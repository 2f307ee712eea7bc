//! Products of the rows and columns of a border, which run through all leading unknowns.

use pulp::Arch;

use super::block_kernels::{Vectorised, add, dispatch};
use super::scalar::Scalar;

/// Rows and columns of which the products are summed at once.
const TILE: usize = 4;

/// A matrix with few columns, row after row.
#[derive(Debug)]
pub(super) struct Tall<T> {
    pub width: usize,
    pub values: Vec<T>,
}

impl<T: Scalar> Tall<T> {
    /// Of zeros.
    pub(super) fn new(rows: usize, width: usize) -> Self {
        Self {
            width,
            values: vec![T::default(); rows * width],
        }
    }

    /// Calls `entry(i, j, sum, terms)` with every entry of the product of the transposed of this with
    /// `other`, and the sum of the sizes of its terms.
    pub(super) fn products(&self, other: &Self, entry: impl FnMut(usize, usize, T, f64)) {
        if self.width > 0 && other.width > 0 {
            dispatch(Arch::new(), Products(self, other, entry));
        }
    }

    /// Calls `entry(i, sum)` with every entry of the product of the transposed of this with `x`.
    pub(super) fn transposed_times(&self, x: &[T], entry: impl FnMut(usize, T)) {
        if self.width > 0 {
            dispatch(Arch::new(), TransposedTimes(self, x, entry));
        }
    }

    /// `x -= A y`.
    pub(super) fn subtract(&self, y: &[T], x: &mut [T]) {
        if self.width > 0 {
            dispatch(Arch::new(), Subtract(self, y, x));
        }
    }
}

struct Products<'a, T, E>(&'a Tall<T>, &'a Tall<T>, E);

impl<T: Scalar, E: FnMut(usize, usize, T, f64)> Vectorised for Products<'_, T, E> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(a, b, mut entry) = self;
        for i in tiles(a.width) {
            for j in tiles(b.width) {
                match (i.1, j.1) {
                    (TILE, TILE) => tile::<T, F, TILE, TILE>(a, b, (i.0, j.0), &mut entry),
                    (TILE, _) => tile::<T, F, TILE, 1>(a, b, (i.0, j.0), &mut entry),
                    (_, TILE) => tile::<T, F, 1, TILE>(a, b, (i.0, j.0), &mut entry),
                    _ => tile::<T, F, 1, 1>(a, b, (i.0, j.0), &mut entry),
                }
            }
        }
    }
}

/// Starts and sizes of tiles: whole ones, then single columns.
#[inline(always)]
fn tiles(width: usize) -> impl Iterator<Item = (usize, usize)> {
    let whole = width - width % TILE;
    let first = (0..whole).step_by(TILE).map(|at| (at, TILE));
    first.chain((whole..width).map(|at| (at, 1)))
}

#[inline(always)]
fn tile<T: Scalar, const F: bool, const R: usize, const W: usize>(
    a: &Tall<T>,
    b: &Tall<T>,
    (i, j): (usize, usize),
    entry: &mut impl FnMut(usize, usize, T, f64),
) {
    let (mut sums, mut terms) = ([[T::default(); W]; R], [[0.0; W]; R]);
    for (a, b) in a.values.chunks_exact(a.width).zip(b.values.chunks_exact(b.width)) {
        let left: [T; R] = a[i..i + R].try_into().expect("within the width");
        let right: [T; W] = b[j..j + W].try_into().expect("within the width");
        for row in 0..R {
            for column in 0..W {
                sums[row][column] = add::<T, F>(sums[row][column], left[row], right[column]);
                let sizes = (left[row].size(), right[column].size());
                terms[row][column] = add::<f64, F>(terms[row][column], sizes.0, sizes.1);
            }
        }
    }
    for row in 0..R {
        for column in 0..W {
            entry(i + row, j + column, sums[row][column], terms[row][column]);
        }
    }
}

struct TransposedTimes<'a, T, E>(&'a Tall<T>, &'a [T], E);

impl<T: Scalar, E: FnMut(usize, T)> Vectorised for TransposedTimes<'_, T, E> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(a, x, mut entry) = self;
        // The columns of a free frame and a few constraints at once: the rows are read once.
        match a.width {
            5 => return weighted::<T, F, 5>(a, x, 0, &mut entry),
            6 => return weighted::<T, F, 6>(a, x, 0, &mut entry),
            7 => return weighted::<T, F, 7>(a, x, 0, &mut entry),
            8 => return weighted::<T, F, 8>(a, x, 0, &mut entry),
            _ => {}
        }
        for (at, size) in tiles(a.width) {
            if size == TILE {
                weighted::<T, F, TILE>(a, x, at, &mut entry);
            } else {
                weighted::<T, F, 1>(a, x, at, &mut entry);
            }
        }
    }
}

#[inline(always)]
fn weighted<T: Scalar, const F: bool, const W: usize>(
    a: &Tall<T>,
    x: &[T],
    at: usize,
    entry: &mut impl FnMut(usize, T),
) {
    // Several sums, which do not wait for each other.
    let mut sums = [[T::default(); W]; 4];
    let (rows, factors) = (a.values.chunks(4 * a.width), x.chunks(4));
    for (rows, factors) in rows.zip(factors) {
        for ((row, &factor), sums) in rows.chunks_exact(a.width).zip(factors).zip(&mut sums) {
            let row: &[T; W] = row[at..at + W].try_into().expect("within the width");
            for (sum, &value) in sums.iter_mut().zip(row) {
                *sum = add::<T, F>(*sum, factor, value);
            }
        }
    }
    for column in 0..W {
        let sum = (sums[0][column] + sums[1][column]) + (sums[2][column] + sums[3][column]);
        entry(at + column, sum);
    }
}

struct Subtract<'a, T>(&'a Tall<T>, &'a [T], &'a mut [T]);

impl<T: Scalar> Vectorised for Subtract<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(a, y, x) = self;
        match a.width {
            6 => return subtract_fixed::<T, F, 6>(a, y, x),
            7 => return subtract_fixed::<T, F, 7>(a, y, x),
            8 => return subtract_fixed::<T, F, 8>(a, y, x),
            _ => {}
        }
        for (row, x) in a.values.chunks_exact(a.width).zip(x) {
            for (&value, &factor) in row.iter().zip(y) {
                *x = add::<T, F>(*x, -value, factor);
            }
        }
    }
}

/// The same with a width that is a constant of the code.
#[inline(always)]
fn subtract_fixed<T: Scalar, const F: bool, const W: usize>(a: &Tall<T>, y: &[T], x: &mut [T]) {
    let mut factors = [T::default(); W];
    factors.copy_from_slice(&y[..W]);
    for (row, x) in a.values.as_chunks::<W>().0.iter().zip(x) {
        let mut sum = *x;
        for (&value, factor) in row.iter().zip(factors) {
            sum = add::<T, F>(sum, -value, factor);
        }
        *x = sum;
    }
}
