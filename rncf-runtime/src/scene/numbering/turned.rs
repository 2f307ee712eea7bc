//! Columns of orientations on the pattern.

use crate::linalg::Pattern;

/// Where an entry in a column of an orientation stands in all three of them.
#[derive(Clone, Debug)]
pub(crate) struct TurnedColumns {
    /// First entries of the columns, and the end.
    pub starts: [usize; 4],
    /// For every entry of the columns those of its row.
    pub places: Vec<[Option<usize>; 3]>,
}

impl TurnedColumns {
    /// Of the orientation whose first unknown is `turn`.
    pub fn new(turn: usize, pattern: &Pattern) -> Self {
        let starts = std::array::from_fn(|j| pattern.starts()[turn + j]);
        let rows = pattern.indices()[starts[0]..starts[3]].iter();
        Self {
            starts,
            places: rows
                .map(|&row| std::array::from_fn(|j| pattern.find(row, turn + j)))
                .collect(),
        }
    }
}
