//! faer's sparse LU (column elimination tree, partial pivoting): the general fallback.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::perm::PermRef;
use faer::sparse::linalg::lu::{LuSymbolicParams, factorize_symbolic_lu, simplicial};
use faer::sparse::linalg::{LuError, SupernodalThreshold};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par};

use super::pattern::Pattern;
use super::scalar::Scalar;

/// Factors of a sparse matrix; memory is kept from one factorization to the next.
#[derive(Debug)]
pub(super) struct Sparse<T> {
    columns: Vec<usize>,
    columns_back: Vec<usize>,
    rows: Vec<usize>,
    rows_back: Vec<usize>,
    factors: simplicial::SimplicialLu<usize, T>,
    memory: Memory,
}

struct Memory(MemBuffer);

impl std::fmt::Debug for Memory {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Memory")
    }
}

impl<T: Scalar> Sparse<T> {
    /// `None` if the ordering fails (memory).
    pub(super) fn new(pattern: &Pattern) -> Option<Self> {
        let size = pattern.rows();
        // Simplicial factors show their pivots, which the singularity check needs.
        let parameters = LuSymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SIMPLICIAL,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_lu(matrix(pattern), parameters).ok()?;
        let (columns, columns_back) = symbolic.col_perm().arrays();
        let memory = StackReq::any_of(&[
            simplicial::factorize_simplicial_numeric_lu_scratch::<usize, T>(size, size),
            simplicial::solve_in_place_scratch::<usize, T>(size, 1, Par::Seq),
        ]);
        Some(Self {
            columns: columns.to_vec(),
            columns_back: columns_back.to_vec(),
            rows: vec![0; size],
            rows_back: vec![0; size],
            factors: simplicial::SimplicialLu::new(),
            memory: Memory(MemBuffer::new(memory)),
        })
    }

    /// Factors the values; the column at which no pivot exceeds `smallest`, if any (NaN included).
    pub(super) fn factor(&mut self, pattern: &Pattern, values: &[T], smallest: f64) -> Result<(), usize> {
        let columns = PermRef::new_checked(&self.columns, &self.columns_back, self.columns.len());
        simplicial::factorize_simplicial_numeric_lu(
            &mut self.rows,
            &mut self.rows_back,
            &mut self.factors,
            SparseColMatRef::new(matrix(pattern), values),
            columns,
            MemStack::new(&mut self.memory.0),
        )
        .map_err(|error| match error {
            LuError::SymbolicSingular { index } => self.columns[index],
            LuError::Generic(_) => 0,
        })?;
        let upper = self.factors.u_factor_unsorted();
        for k in 0..self.columns.len() {
            let pivot = upper
                .row_idx_of_col(k)
                .zip(upper.val_of_col(k))
                .find(|&(row, _)| row == k)
                .map_or(0.0, |(_, value)| value.size());
            if !(pivot > smallest && pivot.is_finite()) {
                return Err(self.columns[k]);
            }
        }
        Ok(())
    }

    /// Solves in place with the factors.
    pub(super) fn solve(&mut self, x: &mut [T]) {
        let size = x.len();
        self.factors.solve_in_place_with_conj(
            PermRef::new_checked(&self.rows, &self.rows_back, size),
            PermRef::new_checked(&self.columns, &self.columns_back, size),
            Conj::No,
            MatMut::from_column_major_slice_mut(x, size, 1),
            Par::Seq,
            MemStack::new(&mut self.memory.0),
        );
    }
}

impl Sparse<f64> {
    /// Whether the determinant of what was factored is negative.
    pub(super) fn is_determinant_negative(&self) -> bool {
        let upper = self.factors.u_factor_unsorted();
        let pivot = |k: usize| {
            let entries = upper.row_idx_of_col(k).zip(upper.val_of_col(k));
            entries
                .filter(|&(row, _)| row == k)
                .map(|(_, value)| *value)
                .sum::<f64>()
        };
        let negative = (0..self.columns.len()).filter(|&k| pivot(k) < 0.0).count();
        (negative % 2 == 1) ^ is_odd(&self.rows) ^ is_odd(&self.columns)
    }
}

/// Whether a permutation is odd.
fn is_odd(permutation: &[usize]) -> bool {
    let mut seen = vec![false; permutation.len()];
    let mut odd = false;
    for start in 0..permutation.len() {
        let mut at = permutation[start];
        while !seen[start] && at != start {
            seen[at] = true;
            odd = !odd;
            at = permutation[at];
        }
        seen[start] = true;
    }
    odd
}

fn matrix(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    SymbolicSparseColMatRef::new_checked(
        pattern.rows(),
        pattern.columns(),
        pattern.starts(),
        None,
        pattern.indices(),
    )
}
