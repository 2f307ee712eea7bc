//! Which unknowns of a square pattern are coupled.

use super::pattern::{Pattern, accumulate};

/// Unknowns coupled with every unknown by its row or its column, with itself, ascending.
#[derive(Debug)]
pub(super) struct Graph {
    starts: Vec<usize>,
    coupled: Vec<usize>,
}

impl Graph {
    /// Of a square pattern. Nothing is sorted: columns ascend in the pattern, and rows come out ascending.
    ///
    /// # Panics
    /// If the pattern is not square: a defect of the caller.
    pub(super) fn new(pattern: &Pattern) -> Self {
        assert_eq!(pattern.rows(), pattern.columns(), "the pattern is square");
        let size = pattern.columns();
        let (columns, indices) = (pattern.starts(), pattern.indices());
        let mut rows = vec![0; size + 1];
        indices.iter().for_each(|&row| rows[row + 1] += 1);
        accumulate(&mut rows);
        let (mut places, mut of_rows) = (rows.clone(), vec![0; indices.len()]);
        for column in 0..size {
            for &row in &indices[columns[column]..columns[column + 1]] {
                of_rows[places[row]] = column;
                places[row] += 1;
            }
        }
        let mut graph = Self {
            starts: Vec::with_capacity(size + 1),
            coupled: Vec::with_capacity(indices.len() + size),
        };
        graph.starts.push(0);
        for index in 0..size {
            let by_column = &indices[columns[index]..columns[index + 1]];
            let by_row = &of_rows[rows[index]..rows[index + 1]];
            graph.push(index, by_column, by_row);
        }
        graph
    }

    /// Adds the next unknown, coupled with these and itself.
    fn push(&mut self, index: usize, by_column: &[usize], by_row: &[usize]) {
        if by_column == by_row && by_column.binary_search(&index).is_ok() {
            self.coupled.extend_from_slice(by_column);
        } else {
            let first = self.coupled.len();
            self.coupled.extend(by_column.iter().chain(by_row));
            self.coupled.push(index);
            self.coupled[first..].sort_unstable();
            let mut kept = first;
            for place in first..self.coupled.len() {
                let other = self.coupled[place];
                if kept == first || self.coupled[kept - 1] != other {
                    self.coupled[kept] = other;
                    kept += 1;
                }
            }
            self.coupled.truncate(kept);
        }
        self.starts.push(self.coupled.len());
    }

    /// Number of unknowns.
    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// What one unknown is coupled with.
    pub(super) fn of(&self, index: usize) -> &[usize] {
        &self.coupled[self.starts[index]..self.starts[index + 1]]
    }
}

/// Which nodes of a graph a walk has seen; the next walk begins anew without clearing them.
#[derive(Debug)]
pub(super) struct Seen {
    walks: Vec<usize>,
    walk: usize,
}

impl Seen {
    /// Marks a node; false where this walk has seen it already.
    pub(super) fn mark(&mut self, node: usize) -> bool {
        std::mem::replace(&mut self.walks[node], self.walk) != self.walk
    }
}

/// The components of a graph, each walked from an end: the last node reached from anywhere, twice. `walk` goes through the component of
/// a node, all of which it marks as seen; `last` is the node that it came to in the end.
pub(super) fn components<W>(nodes: usize, walk: impl Fn(usize, &mut Seen) -> W, last: impl Fn(&W) -> usize) -> Vec<W> {
    let mut walks = Vec::new();
    let mut seen = Seen {
        walks: vec![0; nodes],
        walk: 0,
    };
    for seed in 0..nodes {
        if seen.walks[seed] > 0 {
            continue;
        }
        let mut begin = |start| {
            seen.walk += 1;
            walk(start, &mut seen)
        };
        let from_seed = begin(seed);
        let back = begin(last(&from_seed));
        walks.push(begin(last(&back)));
    }
    walks
}
