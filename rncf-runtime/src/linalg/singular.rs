//! What is told of a singular matrix.

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
