//! Substitution with block factors, for one right side or several at once.

use super::block_kernels::{add, is_specialised};
use super::node::{Node, Segment};
use super::scalar::Scalar;

/// One row of `W` right sides.
type Row<T, const W: usize> = [T; W];

#[inline(always)]
fn subtract<T: Scalar, const F: bool, const W: usize>(y: &mut Row<T, W>, factor: T, x: &Row<T, W>) {
    for (y, &x) in y.iter_mut().zip(x) {
        *y = add::<T, F>(*y, -factor, x);
    }
}

/// Forward substitution of a node: `right` holds its unknowns and all later ones.
#[inline(always)]
pub(super) fn forward<T: Scalar, const F: bool, const W: usize>(
    node: &Node,
    segments: &[Segment],
    values: &[T],
    pivots: &[u32],
    right: &mut [Row<T, W>],
) {
    let (n, m, count, first) = (node.size, node.below, segments.len(), node.first);
    if is_specialised::<T, F>() && (n, m, count) == (6, 6, 1) {
        forward_sized::<T, F, W>((6, 6), 1, first, segments, values, pivots, right);
    } else {
        forward_sized::<T, F, W>((n, m), count, first, segments, values, pivots, right);
    }
}

#[inline(always)]
fn forward_sized<T: Scalar, const F: bool, const W: usize>(
    (n, m): (usize, usize),
    count: usize,
    first: usize,
    segments: &[Segment],
    values: &[T],
    pivots: &[u32],
    right: &mut [Row<T, W>],
) {
    let width = n + m;
    let (rows, below) = values.split_at(n * width);
    let (own, rest) = right.split_at_mut(n);
    for (k, &pivot) in pivots[..n].iter().enumerate() {
        if pivot as usize != k {
            own.swap(k, pivot as usize);
        }
    }
    for row in 1..n {
        let (known, this) = own.split_at_mut(row);
        let factors = &rows[row * width..][..row];
        for (&factor, known) in factors.iter().zip(known.iter()) {
            subtract::<T, F, W>(&mut this[0], factor, known);
        }
    }
    let mut offset = 0;
    for segment in &segments[..count] {
        let length = if count == 1 { m } else { segment.length as usize };
        let target = &mut rest[segment.place as usize - first - n..][..length];
        if W == 1 {
            for k in 0..n {
                let factors = &below[k * m + offset..][..length];
                for (target, &factor) in target.iter_mut().zip(factors) {
                    subtract::<T, F, W>(target, factor, &own[k]);
                }
            }
        } else {
            for (row, target) in target.iter_mut().enumerate() {
                let mut sum = *target;
                for k in 0..n {
                    subtract::<T, F, W>(&mut sum, below[k * m + offset + row], &own[k]);
                }
                *target = sum;
            }
        }
        offset += length;
    }
}

/// Backward substitution of a node: `right` holds its unknowns and the known later ones.
#[inline(always)]
pub(super) fn backward<T: Scalar, const F: bool, const W: usize>(
    node: &Node,
    segments: &[Segment],
    values: &[T],
    right: &mut [Row<T, W>],
) {
    let (n, m, count, first) = (node.size, node.below, segments.len(), node.first);
    if is_specialised::<T, F>() && (n, m, count) == (6, 6, 1) {
        backward_sized::<T, F, W>((6, 6), 1, first, segments, values, right);
    } else {
        backward_sized::<T, F, W>((n, m), count, first, segments, values, right);
    }
}

#[inline(always)]
fn backward_sized<T: Scalar, const F: bool, const W: usize>(
    (n, m): (usize, usize),
    count: usize,
    first: usize,
    segments: &[Segment],
    values: &[T],
    right: &mut [Row<T, W>],
) {
    let width = n + m;
    let rows = &values[..n * width];
    let (own, rest) = right.split_at_mut(n);
    let mut offset = n;
    for segment in &segments[..count] {
        let length = if count == 1 { m } else { segment.length as usize };
        let known = &rest[segment.place as usize - first - n..][..length];
        for (k, own) in own.iter_mut().enumerate() {
            let factors = &rows[k * width + offset..][..length];
            let mut sum = *own;
            for (&factor, known) in factors.iter().zip(known) {
                subtract::<T, F, W>(&mut sum, factor, known);
            }
            *own = sum;
        }
        offset += length;
    }
    for k in (0..n).rev() {
        let (this, known) = own[k..].split_at_mut(1);
        let mut sum = this[0];
        for (&factor, known) in rows[k * width + k + 1..][..n - k - 1].iter().zip(known.iter()) {
            subtract::<T, F, W>(&mut sum, factor, known);
        }
        for value in &mut sum {
            *value *= rows[k * width + k];
        }
        this[0] = sum;
    }
}
