//! Saddle-point systems `[[K, B], [C, 0]]` with a small border: LU of the leading block of K, dense Schur
//! complement of its border and of the multipliers.

use super::border_kernels::Tall;
use super::dense::Dense;
use super::lu::Lu;
use super::pattern::Pattern;
use super::scalar::Scalar;
use super::singular::Singular;

/// Factorization of `[[K, B], [C, 0]]` in the field `T` (`f64` or `c64`), for a border and constraints that are few or touch
/// most of K.
///
/// ```text
/// S = [[K_bb, B_b], [C_b, 0]] - [K_bi; C_i] K_ii^-1 [K_ib, B_i],  i: leading unknowns, b: border
/// ```
#[derive(Debug)]
pub(super) struct Complement<T: Scalar> {
    /// Number of leading unknowns.
    inner: usize,
    border: usize,
    leading: Lu<T>,
    /// Start of every leading column among the entries of K; its leading rows come first.
    starts: Vec<usize>,
    /// Entries of K with row and column in the border, of B and `C^T` with border row and constraint;
    /// counted in the Schur complement.
    corner: Vec<(usize, usize, usize)>,
    corner_constraints: Vec<(usize, usize, usize)>,
    columns: Columns<T>,
    rows: Rows<T>,
    /// Entries on the diagonal of K with their unknowns; sizes of all unknowns, where known; those of the rows of the Schur
    /// complement.
    diagonal: Vec<(usize, usize)>,
    sizes: Vec<f64>,
    scales: Vec<f64>,
    constraint_entries: Vec<(usize, usize)>,
    schur: Dense<T>,
    /// Right sides and solution of the Schur complement; what of it multiplies the responses.
    work: Vec<T>,
    known: Vec<T>,
}

/// Columns of `[K_ib, B_i]` that have entries.
#[derive(Debug)]
struct Columns<T> {
    /// Their numbers in the Schur complement.
    numbers: Vec<usize>,
    /// Places in the responses and entries, of K and of B.
    of_block: Vec<(u32, u32)>,
    of_forces: Vec<(u32, u32)>,
    /// `K_ii^-1` times them.
    responses: Tall<T>,
}

/// Rows of `[K_bi; C_i]`.
#[derive(Debug)]
struct Rows<T> {
    /// Those with most entries stored: their numbers, places in the values and entries, of K and of `C^T`.
    full: Vec<usize>,
    full_of_block: Vec<(u32, u32)>,
    full_of_constraints: Vec<(u32, u32)>,
    full_values: Tall<T>,
    /// The others: number, and end of the leading unknowns and entries.
    sparse: Vec<(usize, usize)>,
    sparse_entries: Vec<(usize, usize)>,
    sparse_values: Vec<T>,
    /// Sums of products with the responses, and of the sizes of their terms.
    sums: Vec<(T, f64)>,
}

impl<T: Scalar> Complement<T> {
    /// Analyses the pattern of K (n x n), whose last `border` unknowns form the border, and that of
    /// B and `C^T` (n x m).
    ///
    /// # Panics
    /// If the shapes do not fit: a defect of the caller.
    pub(super) fn new(block: &Pattern, border: usize, constraint_transposed: &Pattern) -> Self {
        assert_eq!(block.rows(), constraint_transposed.rows(), "K and C^T have equal rows");
        assert!(border <= block.rows(), "the border is a part of K");
        let (n, m) = (block.rows(), constraint_transposed.columns());
        let inner = n - border;
        let (mut columns, mut rows) = (vec![Vec::new(); border + m], vec![Vec::new(); border + m]);
        let (mut corner, mut corner_constraints) = (Vec::new(), Vec::new());
        for column in 0..n {
            let own = block.starts()[column]..block.starts()[column + 1];
            // Rows of the border come last in a column.
            let first = own.start + block.indices()[own.clone()].partition_point(|&row| row < inner);
            match column.checked_sub(inner) {
                None => (first..own.end).for_each(|entry| rows[block.indices()[entry] - inner].push((column, entry))),
                Some(place) => {
                    columns[place].extend((own.start..first).map(|entry| (block.indices()[entry], entry)));
                    corner.extend((first..own.end).map(|entry| (entry, block.indices()[entry] - inner, place)));
                }
            }
        }
        for (entry, (row, column)) in constraint_transposed.places().enumerate() {
            if row < inner {
                columns[border + column].push((row, entry));
                rows[border + column].push((row, entry));
            } else {
                corner_constraints.push((entry, row - inner, border + column));
            }
        }
        let columns = Columns::new(&columns, border, inner);
        Self {
            inner,
            border,
            leading: Lu::new(&block.leading(inner)),
            starts: block.starts()[..inner].to_vec(),
            corner,
            corner_constraints,
            rows: Rows::new(&rows, border, inner, columns.numbers.len()),
            known: vec![T::default(); columns.numbers.len()],
            columns,
            diagonal: (0..n).filter_map(|i| Some((block.find(i, i)?, i))).collect(),
            sizes: Vec::new(),
            scales: vec![1.0; border + m],
            constraint_entries: constraint_transposed.places().collect(),
            schur: Dense::new(border + m),
            work: vec![T::default(); border + m],
        }
    }

    /// With the sizes of the unknowns, in which a matrix may be regular that is not in other units.
    pub(super) fn set_sizes(&mut self, sizes: &[f64]) {
        self.sizes = sizes.to_vec();
    }

    /// Scales with unknowns in parts of their sizes: the largest entry on the diagonal of K is 1 then, and the largest of
    /// every constraint. False where sizes are not known.
    fn begin_scales(&mut self, block: &[T], constraint_transposed: &[f64]) -> bool {
        if self.sizes.is_empty() {
            return false;
        }
        let most = self
            .diagonal
            .iter()
            .map(|&(entry, unknown)| block[entry].size() * self.sizes[unknown] * self.sizes[unknown])
            .fold(0.0, f64::max)
            .sqrt();
        if !(most > 0.0 && most.is_finite()) {
            return false;
        }
        for (scale, size) in self.scales.iter_mut().zip(&self.sizes[self.inner..]) {
            *scale = size / most;
        }
        let rows = &mut self.scales[self.border..];
        rows.fill(0.0);
        for (entry, &(unknown, row)) in self.constraint_entries.iter().enumerate() {
            rows[row] = rows[row].max(constraint_transposed[entry].abs() * self.sizes[unknown]);
        }
        for row in rows {
            *row = if *row > 0.0 { most / *row } else { 1.0 };
        }
        true
    }

    /// Factors `[[K, B], [C, 0]]` by the values of K, B and `C^T` on their patterns.
    ///
    /// # Errors
    /// The unknown around which K is singular (and not fixed by constraints), or the constraint that
    /// is redundant or empty: the last one of those that are found to depend on each other.
    pub(super) fn factor(
        &mut self,
        block: &[T],
        forces: &[f64],
        constraint_transposed: &[f64],
    ) -> Result<(), Singular> {
        let factored = self.leading.factor_from(block, &self.starts);
        factored.map_err(Singular::Unknown)?;
        self.columns.load(block, forces);
        let responses = &mut self.columns.responses;
        if responses.width > 0 {
            self.leading.solve_many(&mut responses.values, responses.width);
        }
        self.rows.load(block, constraint_transposed, self.border);
        self.fill_schur(block, forces, constraint_transposed);
        let mut factored = self.schur.factor();
        if factored.is_err() && self.begin_scales(block, constraint_transposed) {
            // What is regular in its own units is not singular in others.
            self.fill_schur(block, forces, constraint_transposed);
            factored = self.schur.factor_from(&self.scales);
        }
        factored.map_err(|index| {
            if index < self.border {
                Singular::Unknown(self.inner + index)
            } else {
                Singular::Constraint(index - self.border)
            }
        })
    }

    fn fill_schur(&mut self, block: &[T], forces: &[f64], constraint_transposed: &[f64]) {
        let schur = &mut self.schur;
        schur.clear();
        for &(entry, row, column) in &self.corner {
            schur.add(row, column, block[entry], block[entry].size());
        }
        for &(entry, row, column) in &self.corner_constraints {
            let (force, derivative) = (forces[entry], constraint_transposed[entry]);
            schur.add(row, column, T::real(force), force.abs());
            schur.add(column, row, T::real(derivative), derivative.abs());
        }
        let (rows, columns) = (&mut self.rows, &self.columns);
        rows.full_values.products(&columns.responses, |i, j, sum, terms| {
            schur.add(rows.full[i], columns.numbers[j], -sum, terms);
        });
        let (responses, width) = (&columns.responses.values, columns.responses.width);
        let mut begin = 0;
        for &(row, end) in &rows.sparse {
            rows.sums.fill((T::default(), 0.0));
            for (&(at, _), &value) in rows.sparse_entries[begin..end]
                .iter()
                .zip(&rows.sparse_values[begin..end])
            {
                for (sum, &response) in rows.sums.iter_mut().zip(&responses[at * width..(at + 1) * width]) {
                    let term = value * response;
                    sum.0 += term;
                    sum.1 += term.size();
                }
            }
            for (&column, &(sum, terms)) in columns.numbers.iter().zip(&rows.sums) {
                schur.add(row, column, -sum, terms);
            }
            begin = end;
        }
    }

    /// Solves in place: on entry the right sides of the dynamic and of the constraint rows, on
    /// return the unknowns and the multipliers.
    pub(super) fn solve(&mut self, dynamics: &mut [T], constraints: &mut [T]) {
        let (leading, border) = dynamics.split_at_mut(self.inner);
        self.leading.solve(leading);
        let (work, rows) = (&mut self.work, &self.rows);
        work[..self.border].copy_from_slice(border);
        work[self.border..].copy_from_slice(constraints);
        rows.full_values
            .transposed_times(leading, |i, sum| work[rows.full[i]] -= sum);
        let mut begin = 0;
        for &(row, end) in &rows.sparse {
            for (&(at, _), &value) in rows.sparse_entries[begin..end]
                .iter()
                .zip(&rows.sparse_values[begin..end])
            {
                work[row] -= value * leading[at];
            }
            begin = end;
        }
        self.schur.solve(work);
        border.copy_from_slice(&work[..self.border]);
        constraints.copy_from_slice(&work[self.border..]);
        for (known, &number) in self.known.iter_mut().zip(&self.columns.numbers) {
            *known = work[number];
        }
        self.columns.responses.subtract(&self.known, leading);
    }
}

impl<T: Scalar> Columns<T> {
    /// From leading unknowns and entries of all columns, of which the first `border` are those of K.
    fn new(all: &[Vec<(usize, usize)>], border: usize, inner: usize) -> Self {
        let numbers: Vec<usize> = (0..all.len()).filter(|&number| !all[number].is_empty()).collect();
        let width = numbers.len();
        let (mut of_block, mut of_forces) = (Vec::new(), Vec::new());
        for (index, &number) in numbers.iter().enumerate() {
            let target = if number < border { &mut of_block } else { &mut of_forces };
            let place = |&(row, entry): &(usize, usize)| numbered(row * width + index, entry);
            target.extend(all[number].iter().map(place));
        }
        // In the order of the responses, which are written several to a row; stable, as the columns are runs in order.
        of_block.sort();
        of_forces.sort();
        Self {
            responses: Tall::new(inner, width),
            numbers,
            of_block,
            of_forces,
        }
    }

    fn load(&mut self, block: &[T], forces: &[f64]) {
        let target = &mut self.responses.values;
        target.fill(T::default());
        for &(place, entry) in &self.of_block {
            target[place as usize] = block[entry as usize];
        }
        for &(place, entry) in &self.of_forces {
            target[place as usize] = T::real(forces[entry as usize]);
        }
    }
}

impl<T: Scalar> Rows<T> {
    /// From leading unknowns and entries of all rows, of which the first `border` are those of K.
    fn new(all: &[Vec<(usize, usize)>], border: usize, inner: usize, responses: usize) -> Self {
        let is_full = |row: &[(usize, usize)]| !row.is_empty() && 2 * row.len() >= inner;
        let full: Vec<usize> = (0..all.len()).filter(|&number| is_full(&all[number])).collect();
        let width = full.len();
        let (mut full_of_block, mut full_of_constraints) = (Vec::new(), Vec::new());
        for (index, &number) in full.iter().enumerate() {
            let is_of_block = number < border;
            let target = if is_of_block {
                &mut full_of_block
            } else {
                &mut full_of_constraints
            };
            let place = |&(column, entry): &(usize, usize)| numbered(column * width + index, entry);
            target.extend(all[number].iter().map(place));
        }
        // In the order of K, whose columns hold all of these rows next to each other.
        full_of_block.sort_by_key(|&(_, entry)| entry);
        full_of_constraints.sort();
        let (mut sparse, mut sparse_entries) = (Vec::new(), Vec::new());
        for (number, row) in all.iter().enumerate().filter(|(_, row)| !is_full(row)) {
            sparse_entries.extend(row);
            sparse.push((number, sparse_entries.len()));
        }
        Self {
            full_values: Tall::new(inner, width),
            full,
            full_of_block,
            full_of_constraints,
            sparse_values: vec![T::default(); sparse_entries.len()],
            sparse,
            sparse_entries,
            sums: vec![(T::default(), 0.0); responses],
        }
    }

    fn load(&mut self, block: &[T], constraint_transposed: &[f64], border: usize) {
        let target = &mut self.full_values.values;
        for &(place, entry) in &self.full_of_block {
            target[place as usize] = block[entry as usize];
        }
        for &(place, entry) in &self.full_of_constraints {
            target[place as usize] = T::real(constraint_transposed[entry as usize]);
        }
        let mut begin = 0;
        for &(row, end) in &self.sparse {
            let entries = &self.sparse_entries[begin..end];
            for (value, &(_, entry)) in self.sparse_values[begin..end].iter_mut().zip(entries) {
                *value = if row < border {
                    block[entry]
                } else {
                    T::real(constraint_transposed[entry])
                };
            }
            begin = end;
        }
    }
}

/// A place and an entry in few bytes.
///
/// # Panics
/// From 2^32 entries on.
fn numbered(place: usize, entry: usize) -> (u32, u32) {
    let narrow = |value: usize| u32::try_from(value).expect("fewer than 2^32 entries");
    (narrow(place), narrow(entry))
}

#[cfg(test)]
#[path = "complement_tests.rs"]
pub(super) mod tests;
