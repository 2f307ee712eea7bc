//! The links of a chain: groups of unknowns in an order in which each is coupled with its neighbours alone.

use super::block_order::equal_unknowns;
use super::graph::{Graph, Seen, components};
use super::pattern::Pattern;

/// Places for each unknown, at most: links that are filled up cost as much as full ones.
const WASTE: usize = 2;

/// Unknowns of every link.
#[derive(Debug, PartialEq)]
pub(super) struct Links {
    pub(super) members: Vec<Vec<usize>>,
}

impl Links {
    /// The links of a square pattern; `None` where the diagonal is not whole.
    pub(super) fn new(pattern: &Pattern, graph: &Graph) -> Option<Self> {
        let unknowns = pattern.columns();
        if unknowns == 0 || (0..unknowns).any(|index| pattern.find(index, index).is_none()) {
            return None;
        }
        let nodes = equal_unknowns(pattern, graph);
        let mut node_of = vec![0; unknowns];
        for (index, members) in nodes.iter().enumerate() {
            members.iter().for_each(|&member| node_of[member] = index);
        }
        let neighbours: Vec<Vec<usize>> = nodes
            .iter()
            .map(|members| {
                let mut others: Vec<usize> = graph.of(members[0]).iter().map(|&other| node_of[other]).collect();
                others.sort_unstable();
                others.dedup();
                others
            })
            .collect();
        let members = levels(&neighbours).into_iter().map(|level| {
            let unknowns = level.into_iter().flat_map(|node| nodes[node].iter().copied());
            unknowns.collect()
        });
        Some(Self {
            members: members.collect(),
        })
    }

    /// Those that follow each other put together, as far as they have at most `size` unknowns; `None` where there are larger
    /// ones, or where most places would be empty.
    pub(super) fn together(&self, size: usize) -> Option<Self> {
        let mut members: Vec<Vec<usize>> = Vec::new();
        for link in &self.members {
            if link.len() > size {
                return None;
            }
            match members.last_mut() {
                Some(last) if last.len() + link.len() <= size => last.extend(link),
                _ => members.push(link.clone()),
            }
        }
        let unknowns: usize = self.members.iter().map(Vec::len).sum();
        (members.len() * size <= WASTE * unknowns + size).then_some(Self { members })
    }
}

/// Levels of all components of a graph, from an end of each: a node's neighbours are in its level and the two beside it.
fn levels(neighbours: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let walk = |start, seen: &mut Seen| breadth_first(neighbours, start, seen);
    components(neighbours.len(), walk, |levels| levels[levels.len() - 1][0]).concat()
}

/// The component of a node, level by level.
fn breadth_first(neighbours: &[Vec<usize>], start: usize, seen: &mut Seen) -> Vec<Vec<usize>> {
    seen.mark(start);
    let mut levels = vec![vec![start]];
    loop {
        let mut next = Vec::new();
        for &node in levels.iter().next_back().into_iter().flatten() {
            for &other in &neighbours[node] {
                if seen.mark(other) {
                    next.push(other);
                }
            }
        }
        if next.is_empty() {
            return levels;
        }
        levels.push(next);
    }
}
