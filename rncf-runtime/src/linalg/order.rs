//! Reverse Cuthill-McKee ordering: neighbours in the matrix become neighbours in the order.

use super::pattern::Pattern;

/// Order of the unknowns of a square pattern (taken as symmetric) with a small bandwidth:
/// `order[new] = old`.
pub(super) fn reverse_cuthill_mckee(pattern: &Pattern) -> Vec<usize> {
    let neighbours = neighbours(pattern);
    let walk = |start, seen: &mut [bool]| breadth_first(&neighbours, start, seen);
    let mut order = components(neighbours.len(), walk, |order| order[order.len() - 1]).concat();
    order.reverse();
    order
}

/// The components of a graph, each walked from an end: the last node reached from anywhere, twice. `walk` goes through the component of
/// a node, all of which it marks as seen; `last` is the node that it came to in the end.
pub(super) fn components<W>(
    nodes: usize,
    walk: impl Fn(usize, &mut [bool]) -> W,
    last: impl Fn(&W) -> usize,
) -> Vec<W> {
    let mut walks = Vec::new();
    let mut seen = vec![false; nodes];
    for seed in 0..nodes {
        if seen[seed] {
            continue;
        }
        let mut start = seed;
        for _ in 0..2 {
            start = last(&walk(start, &mut seen.clone()));
        }
        walks.push(walk(start, &mut seen));
    }
    walks
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

fn neighbours(pattern: &Pattern) -> Vec<Vec<usize>> {
    let mut neighbours = vec![Vec::new(); pattern.columns()];
    for column in 0..pattern.columns() {
        for &row in &pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]] {
            if row != column {
                neighbours[column].push(row);
                neighbours[row].push(column);
            }
        }
    }
    for list in &mut neighbours {
        list.sort_unstable();
        list.dedup();
    }
    neighbours
}

/// The component of `start` level by level, few neighbours first.
fn breadth_first(neighbours: &[Vec<usize>], start: usize, seen: &mut [bool]) -> Vec<usize> {
    let mut order = vec![start];
    let mut head = 0;
    seen[start] = true;
    while head < order.len() {
        let from = order.len();
        for &next in &neighbours[order[head]] {
            if !seen[next] {
                seen[next] = true;
                order.push(next);
            }
        }
        order[from..].sort_by_key(|&index| (neighbours[index].len(), index));
        head += 1;
    }
    order
}
