//! How the matrices on a pattern are factored: found once for all copies of the pattern.

use std::sync::Arc;

use super::block_layout::Structure;
use super::graph::Graph;
use super::links::Links;
use super::order::{half_bandwidth, reverse_cuthill_mckee};
use super::pattern::Pattern;

/// Half-bandwidth up to which the banded factorization is used; with this and fewer unknowns a
/// full matrix is a banded one.
pub(super) const LARGEST_BANDWIDTH: usize = 40;

/// Number of unknowns from which on wide matrices are factored by node blocks. Measured with 100 chains
/// on a ring (10,000 unknowns, 176,800 entries, random values, for which faer exchanges many rows): blocks
/// 0.56 ms to factor and 0.10 ms to solve, faer 17.9 and 0.17 ms.
const LEAST_BLOCKS: usize = 300;

/// What a pattern shows of the matrices on it.
#[derive(Debug)]
pub(super) struct Analysis {
    /// Place of every unknown in an order with a small bandwidth.
    pub(super) place: Arc<[usize]>,
    pub(super) shape: Shape,
}

/// What a matrix is by its pattern.
#[derive(Debug)]
pub(super) enum Shape {
    /// Narrow, with the links of a chain where it is one.
    Narrow(Option<Links>),
    Wide,
    /// Wide and large, with its node blocks where they can be numbered.
    Large(Option<Arc<Structure>>),
}

impl Analysis {
    /// Of a square pattern.
    pub(super) fn new(pattern: &Pattern) -> Self {
        let graph = Graph::new(pattern);
        let place = places(&graph);
        let shape = if half_bandwidth(pattern, &place) <= LARGEST_BANDWIDTH {
            Shape::Narrow(Links::new(pattern, &graph))
        } else if pattern.columns() < LEAST_BLOCKS {
            Shape::Wide
        } else {
            Shape::Large(Structure::new(pattern, &graph).map(Arc::new))
        };
        Self {
            place: place.into(),
            shape,
        }
    }
}

/// Place of every unknown in an order with a small bandwidth.
pub(super) fn places(graph: &Graph) -> Vec<usize> {
    let mut place = vec![0; graph.len()];
    for (new, &old) in reverse_cuthill_mckee(graph).iter().enumerate() {
        place[old] = new;
    }
    place
}
