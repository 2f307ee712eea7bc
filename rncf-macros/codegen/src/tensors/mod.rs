//! Exact polynomials and constant tensors.

/// A polynomial in xi with rational coefficients.
#[derive(Clone, Debug)]
pub struct Polynomial {}
