//! Sparse linear algebra: a fixed pattern, its factorizations, and saddle-point systems on it.

mod analysis;
mod banded;
mod block_kernels;
mod block_layout;
mod block_order;
mod block_solve;
mod block_solve_one;
mod blocks;
mod border_kernels;
mod chain;
mod column;
mod complement;
mod dense;
mod eigen;
mod general_eigen;
mod graph;
mod links;
mod lu;
mod node;
mod order;
mod pattern;
mod saddle;
mod scalar;
mod singular;
mod span;
mod sparse;
mod whole;

pub(crate) use block_kernels::{Vectorised, dispatch};
pub use column::Column;
pub use dense::Dense;
pub use eigen::{
    Cholesky, Indefinite, NaturalModes, lowest_modes, natural_modes, negative_eigenvalues, product, solve_full,
    symmetric_eigen, times,
};
pub use general_eigen::general_eigen;
pub(crate) use general_eigen::scattered;
pub use lu::Lu;
pub use pattern::Pattern;
pub use saddle::Saddle;
pub use scalar::{Scalar, c64};
pub use singular::Singular;
pub(crate) use span::{clear, dot, norm, normalise, power_of_two, reduce, total};
