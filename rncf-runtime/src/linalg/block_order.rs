//! Node blocks of a pattern and the order in which they are eliminated.

use std::collections::BTreeSet;

use super::graph::Graph;
use super::pattern::Pattern;

/// Node blocks of a square pattern in the order of elimination.
#[derive(Debug)]
pub(super) struct Nodes {
    /// Unknowns of every node.
    pub members: Vec<Vec<usize>>,
    /// Nodes later in the order that each is coupled to when its turn comes, ascending.
    pub later: Vec<Vec<usize>>,
}

impl Nodes {
    /// Unknowns with equal rows and columns form a node; nodes are ordered by minimum degree.
    pub(super) fn new(pattern: &Pattern, graph: &Graph) -> Self {
        let members = equal_unknowns(pattern, graph);
        let mut node = vec![0; pattern.columns()];
        for (index, members) in members.iter().enumerate() {
            for &member in members {
                node[member] = index;
            }
        }
        let neighbours = members.iter().enumerate().map(|(index, members)| {
            let others = graph.of(members[0]).iter().map(|&other| node[other]);
            others.filter(|&other| other != index).collect()
        });
        let sizes: Vec<usize> = members.iter().map(Vec::len).collect();
        let empty = |members: &Vec<usize>| members.iter().any(|&at| pattern.find(at, at).is_none());
        let empty: Vec<bool> = members.iter().map(empty).collect();
        let (order, later) = minimum_degree(&sizes, neighbours.collect(), &empty);
        let mut place = vec![0; order.len()];
        for (new, &old) in order.iter().enumerate() {
            place[old] = new;
        }
        let sorted = |of: &usize| {
            let mut nodes: Vec<usize> = later[*of].iter().map(|&node| place[node]).collect();
            nodes.sort_unstable();
            nodes
        };
        Self {
            later: order.iter().map(sorted).collect(),
            members: order.iter().map(|&old| members[old].clone()).collect(),
        }
    }
}

fn rows(pattern: &Pattern, column: usize) -> &[usize] {
    &pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]]
}

/// Groups of unknowns with the same neighbours and the same stored columns, by their first members.
pub(super) fn equal_unknowns(pattern: &Pattern, graph: &Graph) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    // Whose neighbours are the same is a neighbour itself: it stands in the group of one of those before it.
    let mut group_of = Vec::with_capacity(graph.len());
    for unknown in 0..graph.len() {
        let own = (graph.of(unknown), rows(pattern, unknown));
        let before = own.0.iter().take_while(|&&other| other < unknown);
        let equal = before
            .copied()
            .find(|&other| (graph.of(other), rows(pattern, other)) == own);
        let group = equal.map_or(groups.len(), |other| group_of[other]);
        if group == groups.len() {
            groups.push(Vec::new());
        }
        groups[group].push(unknown);
        group_of.push(group);
    }
    groups
}

/// Order by least weight of the neighbours left, and these neighbours. Among equals the one that
/// changed longest ago comes first: neighbours in the order are then independent of each other, which
/// lets the processor overlap their chains of operations. Nodes with an `empty` diagonal (multipliers)
/// wait until all that fill it are eliminated: fewer may leave it singular.
fn minimum_degree(
    sizes: &[usize],
    mut neighbours: Vec<BTreeSet<usize>>,
    empty: &[bool],
) -> (Vec<usize>, Vec<Vec<usize>>) {
    let degree = |neighbours: &BTreeSet<usize>| neighbours.iter().map(|&node| sizes[node]).sum::<usize>();
    let mut filling: Vec<Vec<usize>> = vec![Vec::new(); sizes.len()];
    let mut missing = vec![0; sizes.len()];
    for node in (0..sizes.len()).filter(|&node| empty[node]) {
        for &other in neighbours[node].iter().filter(|&&other| !empty[other]) {
            filling[other].push(node);
            missing[node] += 1;
        }
    }
    let mut keys: Vec<_> = neighbours
        .iter()
        .zip(&missing)
        .map(|(neighbours, &missing)| (missing > 0, degree(neighbours), 0))
        .collect();
    let mut queue: BTreeSet<_> = keys.iter().copied().zip(0..sizes.len()).collect();
    let mut order = Vec::with_capacity(sizes.len());
    let mut later = vec![Vec::new(); sizes.len()];
    while let Some((_, node)) = queue.pop_first() {
        order.push(node);
        for &waiting in &filling[node] {
            missing[waiting] -= 1;
        }
        // All that wait for the node are among its neighbours.
        let left = std::mem::take(&mut neighbours[node]);
        for &at in &left {
            queue.remove(&(keys[at], at));
            neighbours[at].remove(&node);
            neighbours[at].extend(left.iter().filter(|&&other| other != at));
            keys[at] = (missing[at] > 0, degree(&neighbours[at]), order.len());
            queue.insert((keys[at], at));
        }
        later[node] = left.into_iter().collect();
    }
    (order, later)
}
