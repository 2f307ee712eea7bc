//! Where the rows of every kind of constraint stand.

use std::ops::Range;

/// Number of kinds: conditions of joints on nodes, frames that follow bodies, sections below rigid fixtures, constraints on
/// markers, in this order.
pub(crate) const KINDS: usize = 4;

/// The place of sections below rigid fixtures among the kinds.
pub(crate) const RIGID_SECTIONS: usize = 2;

/// The place of constraints on markers among the kinds.
pub(crate) const LINKS: usize = 3;

/// Place of the first row of every kind, and of what follows them.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Rows([usize; KINDS + 1]);

impl Rows {
    /// From the number of rows of every kind.
    pub fn new(counts: [usize; KINDS]) -> Self {
        let mut first = [0; KINDS + 1];
        for (kind, count) in counts.into_iter().enumerate() {
            first[kind + 1] = first[kind] + count;
        }
        Self(first)
    }

    /// Number of rows.
    pub fn count(&self) -> usize {
        self.0[KINDS]
    }

    /// Place of the first row of a kind.
    pub fn first(&self, kind: usize) -> usize {
        self.0[kind]
    }

    /// The rows of every kind.
    pub fn ranges(&self) -> [Range<usize>; KINDS] {
        std::array::from_fn(|kind| self.0[kind]..self.0[kind + 1])
    }

    /// Kind of a row, as a place among the kinds, and its place among the rows of its kind.
    pub fn locate(&self, row: usize) -> (usize, usize) {
        let kind = self.0[1..KINDS].partition_point(|&end| end <= row);
        (kind, row - self.0[kind])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_found_beside_kinds_without_any() {
        let rows = Rows::new([2, 0, 3, 1]);
        assert_eq!(rows.count(), 6);
        assert_eq!(rows.ranges(), [0..2, 2..2, 2..5, 5..6]);
        let kinds: Vec<_> = (0..6).map(|row| rows.locate(row)).collect();
        assert_eq!(kinds, [(0, 0), (0, 1), (2, 0), (2, 1), (2, 2), (3, 0)]);
    }
}
