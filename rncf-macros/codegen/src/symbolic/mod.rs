//! Hash-consed expression graph.

/// A node of a [`Graph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Id(pub u32);

/// A hash-consed expression graph.
#[derive(Debug, Default)]
pub struct Graph {}
