//! Reverse Cuthill-McKee ordering: neighbours in the matrix become neighbours in the order.

use super::graph::{Graph, Seen, components};
use super::pattern::Pattern;

/// Order of the unknowns of a square pattern (taken as symmetric) with a small bandwidth:
/// `order[new] = old`.
pub(super) fn reverse_cuthill_mckee(graph: &Graph) -> Vec<usize> {
    let walk = |start, seen: &mut Seen| breadth_first(graph, start, seen);
    let mut order = components(graph.len(), walk, |order| order[order.len() - 1]).concat();
    order.reverse();
    order
}

/// Largest distance of an entry from the diagonal in the given order.
pub(super) fn half_bandwidth(pattern: &Pattern, place: &[usize]) -> usize {
    (0..pattern.columns())
        .flat_map(|column| {
            pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]]
                .iter()
                .map(move |&row| place[row].abs_diff(place[column]))
        })
        .max()
        .unwrap_or(0)
}

/// The component of `start` level by level, few neighbours first.
fn breadth_first(graph: &Graph, start: usize, seen: &mut Seen) -> Vec<usize> {
    let mut order = vec![start];
    let mut head = 0;
    seen.mark(start);
    while head < order.len() {
        let from = order.len();
        let next = graph.of(order[head]).iter().filter(|&&next| seen.mark(next));
        order.extend(next);
        order[from..].sort_unstable_by_key(|&index| (graph.of(index).len(), index));
        head += 1;
    }
    order
}
