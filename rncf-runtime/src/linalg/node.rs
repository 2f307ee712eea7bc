//! Nodes of a block factorization, and where their blocks stand.

/// A node: `size` rows of `size + below` values from `start` on, then `size` columns of `below`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// Place of its first unknown.
    pub first: usize,
    pub size: usize,
    /// Number of unknowns of later nodes that it is coupled to.
    pub below: usize,
    pub start: usize,
    /// Its segments and updates: from those of the node before to here.
    pub segments_end: usize,
    pub updates_end: usize,
}

impl Node {
    pub fn width(&self) -> usize {
        self.size + self.below
    }

    /// Start of the columns below it.
    pub fn lower(&self) -> usize {
        self.start + self.size * self.width()
    }

    pub fn end(&self) -> usize {
        self.lower() + self.size * self.below
    }

    /// Whether it has six unknowns and is coupled to six that follow each other, in as many segments: a node of a line in space.
    #[inline(always)]
    pub fn is_six(&self, segments: usize) -> bool {
        (self.size, self.below, segments) == (6, 6, 1)
    }
}

/// Consecutive places of later unknowns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    pub place: u32,
    pub length: u32,
}
