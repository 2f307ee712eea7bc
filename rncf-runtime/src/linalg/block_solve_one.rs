//! Substitution with block factors for one right side, by nodes of `N` unknowns that are followed by `M` others in one piece:
//! sizes are constants of the code, and columns are taken off whole. Every sum has its terms in the order of `block_solve`. Of
//! large scenes memory takes longer than sums: each direction has what it needs of the factors in one piece.

use super::block_kernels::add;
use super::scalar::Scalar;

/// Copies what forward substitution takes of a node's values: rows of the lower triangle, then the columns below it.
#[inline(always)]
pub(super) fn copy_lower<T: Scalar, const N: usize, const WIDTH: usize>(values: &[T], lower: &mut [T]) {
    let (rows, below) = values.split_at(N * WIDTH);
    let (triangle, columns) = lower.split_at_mut(N * (N - 1) / 2);
    let mut at = 0;
    for (k, row) in rows.as_chunks::<WIDTH>().0.iter().enumerate() {
        triangle[at..at + k].copy_from_slice(&row[..k]);
        at += k;
    }
    columns.copy_from_slice(&below[..columns.len()]);
}

/// Copies what backward substitution takes of a node's values: rows of the upper triangle, then the columns behind it.
#[inline(always)]
pub(super) fn copy_upper<T: Scalar, const N: usize, const WIDTH: usize>(values: &[T], upper: &mut [T]) {
    let rows = &values.as_chunks::<WIDTH>().0[..N];
    let (triangle, columns) = upper.split_at_mut(N * (N + 1) / 2);
    let mut at = 0;
    for (k, row) in rows.iter().enumerate() {
        triangle[at..at + N - k].copy_from_slice(&row[k..N]);
        at += N - k;
    }
    for (column, target) in columns.as_chunks_mut::<N>().0.iter_mut().enumerate() {
        for k in 0..N {
            target[k] = rows[k][N + column];
        }
    }
}

/// Forward substitution of a node: `own` are its right sides, `later` those that follow it.
#[inline(always)]
pub(super) fn forward<T: Scalar, const F: bool, const N: usize, const M: usize, const LOWER: usize>(
    lower: &[T; LOWER],
    pivots: &[u32; N],
    own: &mut [T; N],
    later: &mut [T; M],
) {
    for (k, &pivot) in pivots.iter().enumerate() {
        if pivot as usize != k {
            own.swap(k, pivot as usize);
        }
    }
    let (mut known, mut at) = (*own, 0);
    for row in 1..N {
        for k in 0..row {
            known[row] = add::<T, F>(known[row], -lower[at], known[k]);
            at += 1;
        }
    }
    *own = known;
    let mut sums = *later;
    for k in 0..N {
        for row in 0..M {
            sums[row] = add::<T, F>(sums[row], -lower[at + row], known[k]);
        }
        at += M;
    }
    *later = sums;
}

/// Backward substitution of a node: `later` is known.
#[inline(always)]
pub(super) fn backward<T: Scalar, const F: bool, const N: usize, const M: usize, const UPPER: usize>(
    upper: &[T; UPPER],
    own: &mut [T; N],
    later: &[T; M],
) {
    let (mut sums, mut at) = (*own, N * (N + 1) / 2);
    for known in later {
        for k in 0..N {
            sums[k] = add::<T, F>(sums[k], -upper[at + k], *known);
        }
        at += N;
    }
    at = N * (N + 1) / 2;
    for k in (0..N).rev() {
        at -= N - k;
        for j in k + 1..N {
            sums[k] = add::<T, F>(sums[k], -upper[at + j - k], sums[j]);
        }
        sums[k] *= upper[at];
    }
    *own = sums;
}
