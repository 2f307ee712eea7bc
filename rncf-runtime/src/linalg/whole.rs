//! Saddle-point systems `[[K, B], [C, 0]]` with many constraints and a large border that are sparse: LU of the whole.

use super::analysis::places;
use super::graph::Graph;
use super::lu::Lu;
use super::order::half_bandwidth;
use super::pattern::Pattern;
use super::scalar::Scalar;

/// Rows of border and constraints from which on a whole is thought of.
const MANY: usize = 40;
/// Operations of a full factorization for one of a sparse one that takes as long.
const ADVANTAGE: usize = 2;
/// Pivots of the equilibrated matrix below this leave it to complete pivoting what is singular.
const DOUBTFUL: f64 = 1e-12;
/// Rounds of equilibration; each about halves the exponents of what is left.
const ROUNDS: usize = 4;

/// LU of the whole matrix in the field `T`, equilibrated alike by rows and columns.
#[derive(Debug)]
pub(super) struct Whole<T: Scalar> {
    lu: Lu<T>,
    /// Row and column of all entries.
    places: Vec<[usize; 2]>,
    /// Places of the entries of K, of B, and of C, in the whole.
    block: Vec<usize>,
    forces: Vec<usize>,
    derivatives: Vec<usize>,
    values: Vec<T>,
    scales: Vec<f64>,
    largest: Vec<f64>,
    work: Vec<T>,
}

impl<T: Scalar> Whole<T> {
    /// `None` where the Schur complement of border and constraints costs less.
    pub(super) fn new(block: &Pattern, border: usize, constraint_transposed: &Pattern) -> Option<Self> {
        let (n, m) = (block.rows(), constraint_transposed.columns());
        let few = border + m;
        if few < MANY {
            return None;
        }
        let own = block.places();
        let both = constraint_transposed
            .places()
            .flat_map(|(row, j)| [(row, n + j), (n + j, row)]);
        let whole = Pattern::new(n + m, n + m, own.chain(both));
        // A row of a banded factor touches half a bandwidth of others, each with two.
        let order = places(&Graph::new(&whole));
        let half = half_bandwidth(&whole, &order);
        let sparse = (n + m) * half * (2 * half + 1);
        let full = few * few * few / 3 + (n - border) * few * few;
        if ADVANTAGE * sparse > full {
            return None;
        }
        let place = |row, column| whole.find(row, column).expect("the whole pattern holds its parts");
        Some(Self {
            block: block.places().map(|(row, column)| place(row, column)).collect(),
            forces: constraint_transposed
                .places()
                .map(|(row, j)| place(row, n + j))
                .collect(),
            derivatives: constraint_transposed
                .places()
                .map(|(row, j)| place(n + j, row))
                .collect(),
            places: whole.places().map(|(row, column)| [row, column]).collect(),
            values: vec![T::default(); whole.entries()],
            lu: Lu::exchanging(&whole, order),
            scales: vec![1.0; n + m],
            largest: vec![0.0; n + m],
            work: vec![T::default(); n + m],
        })
    }

    /// Whether the values of K, B and `C^T` could be factored without doubt.
    pub(super) fn factor(&mut self, block: &[T], forces: &[f64], constraint_transposed: &[f64]) -> bool {
        self.values.fill(T::default());
        for (&place, &value) in self.block.iter().zip(block) {
            self.values[place] = value;
        }
        let both = [(&self.forces, forces), (&self.derivatives, constraint_transposed)];
        for (places, values) in both {
            for (&place, &value) in places.iter().zip(values) {
                self.values[place] = T::real(value);
            }
        }
        self.equilibrate();
        self.lu.factor_above(&self.values, DOUBTFUL).is_ok()
    }

    /// Scales such that the largest of every row and of the column of the same number are near 1.
    fn equilibrate(&mut self) {
        self.scales.fill(1.0);
        for _ in 0..ROUNDS {
            self.largest.fill(0.0);
            for (&[row, column], value) in self.places.iter().zip(&self.values) {
                let size = value.size() * self.scales[row] * self.scales[column];
                self.largest[row] = self.largest[row].max(size);
                self.largest[column] = self.largest[column].max(size);
            }
            for (scale, largest) in self.scales.iter_mut().zip(&self.largest) {
                let next = *scale / largest.sqrt();
                if next > 0.0 && next.is_finite() {
                    *scale = next;
                }
            }
        }
        for (&[row, column], value) in self.places.iter().zip(&mut self.values) {
            *value = value.times(self.scales[row] * self.scales[column]);
        }
    }

    /// Solves in place, as [`super::Saddle::solve`].
    pub(super) fn solve(&mut self, dynamics: &mut [T], constraints: &mut [T]) {
        let (first, last) = self.work.split_at_mut(dynamics.len());
        first.copy_from_slice(dynamics);
        last.copy_from_slice(constraints);
        let scaled = |work: &mut [T], scales: &[f64]| {
            for (value, &scale) in work.iter_mut().zip(scales) {
                *value = value.times(scale);
            }
        };
        scaled(&mut self.work, &self.scales);
        self.lu.solve(&mut self.work);
        scaled(&mut self.work, &self.scales);
        let (first, last) = self.work.split_at(dynamics.len());
        dynamics.copy_from_slice(first);
        constraints.copy_from_slice(last);
    }
}
