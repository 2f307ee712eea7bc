//! Dense kernels of the block factorization, written for vectorisation: every loop runs over
//! contiguous values, and the frequent sizes of nodes are constants.
//!
//! `F` says whether products and sums are fused ([`Scalar::fused`]), which is fast where the processor
//! can and very slow where it cannot.

use pulp::{Arch, Simd, WithSimd};

use super::scalar::Scalar;

/// Something that is computed the same way on all processors but with the instructions each has.
pub(crate) trait Vectorised {
    type Output;

    /// Must be inlined, with all that it calls, to be compiled for the processor.
    fn run<const F: bool>(self) -> Self::Output;
}

struct Operation<V>(V);

impl<V: Vectorised> WithSimd for Operation<V> {
    type Output = V::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> V::Output {
        if S::IS_SCALAR {
            self.0.run::<false>()
        } else {
            self.0.run::<true>()
        }
    }
}

/// Runs with the instructions of `arch`.
pub(crate) fn dispatch<V: Vectorised>(arch: Arch, what: V) -> V::Output {
    arch.dispatch(Operation(what))
}

/// Whether kernels for constant sizes are worth their code: for real numbers where these are fast.
#[inline(always)]
pub(super) const fn is_specialised<T, const F: bool>() -> bool {
    F && size_of::<T>() == size_of::<f64>()
}

/// `c + a b`.
#[inline(always)]
pub(super) fn add<T: Scalar, const F: bool>(c: T, a: T, b: T) -> T {
    if F { c.fused(a, b) } else { c + a * b }
}

/// `y += factor x`, of equal lengths.
#[inline(always)]
fn add_scaled<T: Scalar, const F: bool>(y: &mut [T], factor: T, x: &[T]) {
    for (y, &x) in y.iter_mut().zip(x) {
        *y = add::<T, F>(*y, factor, x);
    }
}

/// LU in place of the first columns of `n` rows of `n + m` values, with row exchanges; the rest of the
/// rows is taken along, and the inverses of the pivots stay on the diagonal. The largest pivot, or `None`
/// where none exceeds `smallest`.
#[inline(always)]
fn eliminate<T: Scalar, const F: bool>(
    rows: &mut [T],
    pivots: &mut [u32],
    (n, m): (usize, usize),
    smallest: f64,
) -> Option<f64> {
    let mut growth: f64 = 0.0;
    let width = n + m;
    let (rows, pivots) = (&mut rows[..n * width], &mut pivots[..n]);
    for k in 0..n {
        let (mut pivot, mut size) = (k, rows[k * width + k].size());
        for row in k + 1..n {
            let candidate = rows[row * width + k].size();
            if candidate > size {
                (pivot, size) = (row, candidate);
            }
        }
        if !(size > smallest && size.is_finite()) {
            return None;
        }
        growth = growth.max(size);
        pivots[k] = pivot as u32;
        if pivot != k {
            for column in 0..width {
                rows.swap(k * width + column, pivot * width + column);
            }
        }
        let (upper, lower) = rows.split_at_mut((k + 1) * width);
        let top = &mut upper[k * width..];
        let inverse = top[k].inverse();
        top[k] = inverse;
        for row in lower.chunks_exact_mut(width) {
            let factor = row[k] * inverse;
            row[k] = factor;
            add_scaled::<T, F>(&mut row[k + 1..], -factor, &top[k + 1..]);
        }
    }
    Some(growth)
}

/// [`eliminate`] for constant sizes: whole rows at once.
#[inline(always)]
fn eliminate_fixed<T: Scalar, const F: bool, const N: usize, const WIDTH: usize>(
    rows: &mut [T],
    pivots: &mut [u32],
    smallest: f64,
) -> Option<f64> {
    let mut growth: f64 = 0.0;
    let (rows, _) = rows.as_chunks_mut::<WIDTH>();
    let rows: &mut [[T; WIDTH]; N] = rows.try_into().expect("rows of the node");
    let pivots: &mut [u32; N] = pivots.try_into().expect("pivots of the node");
    for k in 0..N {
        let (mut pivot, mut size) = (k, rows[k][k].size());
        for row in k + 1..N {
            let candidate = rows[row][k].size();
            if candidate > size {
                (pivot, size) = (row, candidate);
            }
        }
        if !(size > smallest && size.is_finite()) {
            return None;
        }
        growth = growth.max(size);
        pivots[k] = pivot as u32;
        if pivot != k {
            rows.swap(k, pivot);
        }
        let inverse = rows[k][k].inverse();
        rows[k][k] = inverse;
        // Zeros before the pivot leave the factors there alone.
        let mut top = rows[k];
        for value in &mut top[..=k] {
            *value = T::default();
        }
        for row in &mut rows[k + 1..] {
            let factor = row[k] * inverse;
            for (value, &above) in row.iter_mut().zip(&top) {
                *value = add::<T, F>(*value, -factor, above);
            }
            row[k] = factor;
        }
    }
    Some(growth)
}

/// Columns below the node times the inverse of its upper factor; they are stored as rows.
#[inline(always)]
fn divide<T: Scalar, const F: bool>(rows: &[T], below: &mut [T], (n, m): (usize, usize)) {
    let width = n + m;
    let (rows, below) = (&rows[..n * width], &mut below[..n * m]);
    for k in 0..n {
        let (before, this) = below.split_at_mut(k * m);
        let this = &mut this[..m];
        for (l, column) in before.chunks_exact(m.max(1)).enumerate() {
            add_scaled::<T, F>(this, -rows[l * width + k], column);
        }
        let inverse = rows[k * width + k];
        for value in this {
            *value *= inverse;
        }
    }
}

/// Largest size among values.
#[inline(always)]
fn largest<T: Scalar>(values: &[T]) -> f64 {
    let mut lanes = [0.0; 4];
    let (chunks, rest) = values.as_chunks::<4>();
    for chunk in chunks {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            let size = value.size();
            *lane = if size > *lane { size } else { *lane };
        }
    }
    for value in rest {
        let size = value.size();
        lanes[0] = if size > lanes[0] { size } else { lanes[0] };
    }
    lanes.into_iter().fold(0.0, f64::max)
}

/// Factors one node in its values; the largest pivot or entry below it before, or `None` where no pivot
/// exceeds `smallest`.
#[inline(always)]
pub(super) fn factor_node<T: Scalar, const F: bool>(
    values: &mut [T],
    pivots: &mut [u32],
    (n, m): (usize, usize),
    smallest: f64,
) -> Option<f64> {
    let (rows, below) = values.split_at_mut(n * (n + m));
    let size = largest(below);
    let pivot = if is_specialised::<T, F>() {
        let pivot = match (n, m) {
            (6, 6) => eliminate_fixed::<T, F, 6, 12>(rows, pivots, smallest),
            (6, 12) => eliminate_fixed::<T, F, 6, 18>(rows, pivots, smallest),
            (3, 3) => eliminate_fixed::<T, F, 3, 6>(rows, pivots, smallest),
            _ => eliminate::<T, F>(rows, pivots, (n, m), smallest),
        };
        match (n, m) {
            (6, 6) => divide::<T, F>(rows, below, (6, 6)),
            (6, 12) => divide::<T, F>(rows, below, (6, 12)),
            (3, 3) => divide::<T, F>(rows, below, (3, 3)),
            _ => divide::<T, F>(rows, below, (n, m)),
        }
        pivot
    } else {
        let pivot = eliminate::<T, F>(rows, pivots, (n, m), smallest);
        divide::<T, F>(rows, below, (n, m));
        pivot
    };
    pivot.map(|pivot| pivot.max(size))
}

/// A product that a node subtracts from values of a later one: `target[r][..] -= sum over k of
/// scalars[k][r] vectors[k][..]`. Places count from the start of the node, of the target in all values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Update {
    pub target: u32,
    pub target_stride: u32,
    pub rows: u32,
    pub width: u32,
    pub scalars: u32,
    pub scalar_stride: u32,
    pub vectors: u32,
    pub vector_stride: u32,
}

/// Carries out an update of a node of size `n`; `target` begins at its target.
#[inline(always)]
pub(super) fn update<T: Scalar, const F: bool>(update: &Update, n: usize, node: &[T], target: &mut [T]) {
    let rows = update.rows as usize;
    if !is_specialised::<T, F>() {
        return update_any::<T, F>(update, n, node, target);
    }
    match (n, rows, update.width) {
        (6, 6, 6) => update_fixed::<T, F, 6>(update, 6, 6, node, target),
        (6, 6, 12) => update_fixed::<T, F, 12>(update, 6, 6, node, target),
        (3, 3, 3) => update_fixed::<T, F, 3>(update, 3, 3, node, target),
        (_, _, 3) => update_fixed::<T, F, 3>(update, n, rows, node, target),
        (_, _, 6) => update_fixed::<T, F, 6>(update, n, rows, node, target),
        (_, _, 9) => update_fixed::<T, F, 9>(update, n, rows, node, target),
        (_, _, 12) => update_fixed::<T, F, 12>(update, n, rows, node, target),
        _ => update_any::<T, F>(update, n, node, target),
    }
}

#[inline(always)]
fn update_any<T: Scalar, const F: bool>(update: &Update, n: usize, node: &[T], target: &mut [T]) {
    for row in 0..update.rows as usize {
        let target = &mut target[row * update.target_stride as usize..][..update.width as usize];
        for k in 0..n {
            let scalar = node[update.scalars as usize + k * update.scalar_stride as usize + row];
            let vector = &node[update.vectors as usize + k * update.vector_stride as usize..];
            add_scaled::<T, F>(target, -scalar, vector);
        }
    }
}

#[inline(always)]
fn update_fixed<T: Scalar, const F: bool, const W: usize>(
    update: &Update,
    n: usize,
    rows: usize,
    node: &[T],
    target: &mut [T],
) {
    let scalars = &node[update.scalars as usize..];
    let vectors = &node[update.vectors as usize..];
    for row in 0..rows {
        let start = row * update.target_stride as usize;
        let target: &mut [T; W] = (&mut target[start..start + W]).try_into().expect("of this width");
        let mut sums = *target;
        for k in 0..n {
            let scalar = -scalars[k * update.scalar_stride as usize + row];
            let start = k * update.vector_stride as usize;
            let vector: &[T; W] = vectors[start..start + W].try_into().expect("of this width");
            for (sum, &value) in sums.iter_mut().zip(vector) {
                *sum = add::<T, F>(*sum, scalar, value);
            }
        }
        *target = sums;
    }
}
