//! What a first-order system offers to an integrator and to a comparison.

use crate::dense::Matrix;

/// First-order system `y' = f(t, y)`, or equivalently `B y' = g(t, y)` with a constant matrix `B`.
///
/// The second form keeps the Jacobian sparse, where `f = B^-1 g` would fill it.
pub trait System: Send + Sync {
    /// Number of states.
    fn size(&self) -> usize;

    /// Writes `f(t, y)`, of length [`size`](Self::size).
    fn rate(&self, t: f64, y: &[f64], rate: &mut [f64]);

    /// The constant matrix `B`; `None` where it is the identity and `g = f`.
    fn mass(&self) -> Option<&Matrix> {
        None
    }

    /// Writes `g(t, y)`, of length [`size`](Self::size).
    fn load(&self, t: f64, y: &[f64], load: &mut [f64]) {
        self.rate(t, y, load);
    }

    /// Writes `dg/dy` at `(t, y)`.
    fn load_jacobian(&self, t: f64, y: &[f64], jacobian: &mut Matrix);

    /// Positions (row, column) that may be nonzero in `dg/dy`; every position unless stated.
    fn pattern(&self) -> Vec<(usize, usize)> {
        let n = self.size();
        (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).collect()
    }
}
