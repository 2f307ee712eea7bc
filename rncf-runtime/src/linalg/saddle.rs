//! Saddle-point systems `[[K, C^T], [C, 0]]`: sparse LU of K, dense Schur complement of C.

use super::Pattern;

/// The matrix has no unique solution; the unknown or constraint at which it was noticed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Singular {
    /// Around this unknown.
    Unknown(usize),
    /// Around this constraint: redundant, or not fixing anything.
    Constraint(usize),
    /// Somewhere.
    Somewhere,
}

/// Factorization of `[[K, C^T], [C, 0]]` with K sparse on a fixed pattern, in the field `T`
/// (`f64` or `c64`); the pattern is analysed once.
#[derive(Debug)]
pub struct Saddle<T> {
    _todo: std::marker::PhantomData<(T, Pattern)>,
}
