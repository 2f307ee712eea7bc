//! Where the blocks of a factorization by nodes stand, and what they do to each other: what a pattern tells of it.

use std::cmp::Ordering;

use super::block_kernels::Update;
use super::block_order::Nodes;
use super::graph::Graph;
use super::node::{Node, Segment};
use super::pattern::Pattern;

/// What the pattern tells of the factors.
#[derive(Debug)]
pub(super) struct Structure {
    pub(super) nodes: Vec<Node>,
    /// Parts of the right side that the nodes act on, and products that they subtract from others.
    pub(super) segments: Vec<Segment>,
    pub(super) updates: Vec<Update>,
    /// Place of every entry of the pattern among the values of the factors, and their number.
    pub(super) slots: Vec<u32>,
    pub(super) length: usize,
    /// Starts and ends of the places that no entry of the pattern has.
    pub(super) fill_in: Vec<[u32; 2]>,
    /// Unknown at every place of the elimination.
    pub(super) unknowns: Vec<u32>,
    /// Most entries of a column.
    pub(super) longest: usize,
    /// Number of nodes of six unknowns before six others in one piece.
    pub(super) sixes: usize,
}

impl Structure {
    /// `None` if the factors are too large to be numbered.
    pub(super) fn new(pattern: &Pattern, graph: &Graph) -> Option<Self> {
        let Nodes { members, later } = Nodes::new(pattern, graph);
        let mut layout = Layout::new(&members, &later);
        u32::try_from(layout.length).ok()?;
        layout.connect(&later);
        let longest = pattern.starts().windows(2).map(|pair| pair[1] - pair[0]).max();
        let slots = layout.slots(pattern, &members, &later);
        let mut begin = 0;
        let sixes = layout.nodes.iter().filter(|node| {
            let count = node.segments_end - begin;
            begin = node.segments_end;
            node.is_six(count)
        });
        Some(Self {
            sixes: sixes.count(),
            fill_in: gaps(&slots, layout.length as u32),
            slots,
            length: layout.length,
            nodes: layout.nodes,
            segments: layout.segments,
            updates: layout.updates,
            unknowns: members.iter().flatten().map(|&unknown| unknown as u32).collect(),
            longest: longest.unwrap_or(0),
        })
    }
}

/// Starts and ends of what is not among the places below `length`.
fn gaps(places: &[u32], length: u32) -> Vec<[u32; 2]> {
    let mut is_taken = vec![false; length as usize];
    places.iter().for_each(|&place| is_taken[place as usize] = true);
    let mut at = 0;
    let runs = is_taken.chunk_by(|one, other| one == other).map(|run| {
        let start = at;
        at += run.len() as u32;
        (run[0], [start, at])
    });
    runs.filter(|(taken, _)| !taken).map(|(_, gap)| gap).collect()
}

/// Rows of a column.
pub(super) fn column(pattern: &Pattern, column: usize) -> &[usize] {
    &pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]]
}

/// Where everything lies.
struct Layout {
    nodes: Vec<Node>,
    /// For every node the offsets of its later nodes in what is below it.
    offsets: Vec<Vec<usize>>,
    segments: Vec<Segment>,
    updates: Vec<Update>,
    length: usize,
}

impl Layout {
    fn new(members: &[Vec<usize>], later: &[Vec<usize>]) -> Self {
        let mut layout = Self {
            nodes: Vec::with_capacity(members.len()),
            offsets: Vec::with_capacity(members.len()),
            segments: Vec::new(),
            updates: Vec::new(),
            length: 0,
        };
        let mut first = 0;
        for (own, later) in members.iter().zip(later) {
            let mut below = 0;
            let mut offsets = Vec::with_capacity(later.len());
            for &node in later {
                offsets.push(below);
                below += members[node].len();
            }
            let node = Node {
                first,
                size: own.len(),
                below,
                start: layout.length,
                segments_end: 0,
                updates_end: 0,
            };
            first += own.len();
            layout.length = node.end();
            layout.nodes.push(node);
            layout.offsets.push(offsets);
        }
        layout
    }

    /// Segments and updates of every node.
    fn connect(&mut self, later: &[Vec<usize>]) {
        for index in 0..self.nodes.len() {
            let from = self.segments.len();
            for &node in &later[index] {
                let Node { first, size, .. } = self.nodes[node];
                match self.segments[from..].last_mut() {
                    Some(last) if (last.place + last.length) as usize == first => last.length += size as u32,
                    _ => self.segments.push(Segment {
                        place: first as u32,
                        length: size as u32,
                    }),
                }
            }
            for at in 0..later[index].len() {
                self.update(index, at, later);
            }
            self.nodes[index].segments_end = self.segments.len();
            self.nodes[index].updates_end = self.updates.len();
        }
    }

    /// Updates by a node of the rows of its later node number `at` and of the columns below that.
    fn update(&mut self, index: usize, at: usize, later: &[Vec<usize>]) {
        let (node, offsets) = (self.nodes[index], &self.offsets[index]);
        let of = later[index][at];
        let target = self.nodes[of];
        // Runs of columns that are consecutive in both: offset below the target, own offset, length.
        let mut runs: Vec<(usize, usize, usize)> = Vec::new();
        for (&other, &own) in later[index].iter().zip(offsets).skip(at + 1) {
            let (there, size) = (self.offset(of, other, later), self.nodes[other].size);
            match runs.last_mut() {
                Some((start, _, length)) if *start + *length == there => *length += size,
                _ => runs.push((there, own, size)),
            }
        }
        let (rows, lower) = (node.size, node.lower() - node.start);
        let upper = |column: usize, own: usize, width: usize| Update {
            target: (target.start + column) as u32,
            target_stride: target.width() as u32,
            rows: target.size as u32,
            width: width as u32,
            scalars: (lower + offsets[at]) as u32,
            scalar_stride: node.below as u32,
            vectors: (rows + own) as u32,
            vector_stride: node.width() as u32,
        };
        // The diagonal block, with what follows it without a gap.
        let mut rest = &runs[..];
        let mut width = target.size;
        if let [(0, _, length), others @ ..] = rest {
            width += length;
            rest = others;
        }
        self.updates.push(upper(0, offsets[at], width));
        for &(there, own, width) in rest {
            self.updates.push(upper(target.size + there, own, width));
        }
        for &(there, own, width) in &runs {
            self.updates.push(Update {
                target: (target.lower() + there) as u32,
                target_stride: target.below as u32,
                rows: target.size as u32,
                width: width as u32,
                scalars: (rows + offsets[at]) as u32,
                scalar_stride: node.width() as u32,
                vectors: (lower + own) as u32,
                vector_stride: node.below as u32,
            });
        }
    }

    /// Offset of a later node in what is below another.
    fn offset(&self, of: usize, node: usize, later: &[Vec<usize>]) -> usize {
        let at = later[of].binary_search(&node).expect("fill-in is in the structure");
        self.offsets[of][at]
    }

    /// Place of every entry of the pattern.
    fn slots(&self, pattern: &Pattern, members: &[Vec<usize>], later: &[Vec<usize>]) -> Vec<u32> {
        let mut place = vec![(0, 0); pattern.columns()];
        for (node, members) in members.iter().enumerate() {
            for (index, &member) in members.iter().enumerate() {
                place[member] = (node, index);
            }
        }
        // Rows of a column come node by node: what two nodes have in common is looked up once.
        let mut slots = Vec::with_capacity(pattern.entries());
        for j in 0..pattern.columns() {
            let (of_column, in_j) = place[j];
            let (mut of_row, mut start, mut stride) = (usize::MAX, 0, 0);
            for &row in column(pattern, j) {
                let (node, in_i) = place[row];
                if node != of_row {
                    of_row = node;
                    (start, stride) = self.block(node, of_column, in_j, later);
                }
                slots.push((start + in_i * stride) as u32);
            }
        }
        slots
    }

    /// Where a column of the block of two nodes begins, and the distance of its rows.
    fn block(&self, of_row: usize, of_column: usize, column: usize, later: &[Vec<usize>]) -> (usize, usize) {
        let node = self.nodes[of_row.min(of_column)];
        match of_row.cmp(&of_column) {
            Ordering::Equal => (node.start + column, node.width()),
            Ordering::Less => {
                let offset = self.offset(of_row, of_column, later);
                (node.start + node.size + offset + column, node.width())
            }
            Ordering::Greater => {
                let offset = self.offset(of_column, of_row, later);
                (node.lower() + column * node.below + offset, 1)
            }
        }
    }
}
