//! Reverse Cuthill-McKee ordering: neighbours in the matrix become neighbours in the order.

use super::pattern::Pattern;

/// Order of the unknowns of a square pattern (taken as symmetric) with a small bandwidth:
/// `order[new] = old`.
pub(super) fn reverse_cuthill_mckee(pattern: &Pattern) -> Vec<usize> {
    let neighbours = neighbours(pattern);
    let mut order = Vec::with_capacity(neighbours.len());
    let mut seen = vec![false; neighbours.len()];
    for seed in 0..neighbours.len() {
        if seen[seed] {
            continue;
        }
        // An end of the component: the last one reached from anywhere, twice.
        let mut start = seed;
        for _ in 0..2 {
            start = breadth_first(&neighbours, start, &mut seen.clone(), &mut Vec::new());
        }
        breadth_first(&neighbours, start, &mut seen, &mut order);
    }
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

/// Appends the component of `start` level by level, few neighbours first; returns the last one.
fn breadth_first(neighbours: &[Vec<usize>], start: usize, seen: &mut [bool], order: &mut Vec<usize>) -> usize {
    let mut head = order.len();
    order.push(start);
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
    order[order.len() - 1]
}
