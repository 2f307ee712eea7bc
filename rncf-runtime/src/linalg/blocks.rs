//! LU factorization by node blocks: unknowns with equal patterns are eliminated together.

use std::cmp::Ordering;

use pulp::Arch;

use super::block_kernels::{self as kernels, Update, Vectorised};
use super::block_order::Nodes;
use super::block_solve::{backward, forward};
use super::graph::Graph;
use super::node::{Node, Segment};
use super::pattern::Pattern;
use super::scalar::Scalar;

/// Growth of entries, which are at most 1 at first, beyond which pivots inside the nodes do not
/// suffice: the backward error is about `f64::EPSILON` times the growth.
const LARGEST_GROWTH: f64 = 1e6;

/// How far the largest entry of a column may be from 1 before the matrix is equilibrated anew.
const ABOUT_ONE: std::ops::RangeInclusive<f64> = 1.0 / 16.0..=16.0;

/// Right sides that are solved at once.
const TOGETHER: usize = 8;

/// Block LU factors of a square matrix on a fixed pattern, with pivots inside the diagonal blocks and
/// equilibrated by rows and columns. Everything is laid out once; later calls do not allocate.
#[derive(Debug)]
pub(super) struct Blocks<T> {
    arch: Arch,
    nodes: Vec<Node>,
    /// Parts of the right side that the nodes act on, and products that they subtract from others.
    segments: Vec<Segment>,
    updates: Vec<Update>,
    /// Place of every entry of the pattern in `values`.
    slots: Vec<u32>,
    /// Starts and ends of the places in `values` that no entry of the pattern has.
    fill_in: Vec<[u32; 2]>,
    /// Unknown at every place of the elimination.
    unknowns: Vec<u32>,
    /// Of every node, one after another: its rows from the diagonal on, then the columns below it,
    /// transposed.
    values: Vec<T>,
    /// Row exchanges inside the nodes.
    pivots: Vec<u32>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    /// Whether the scales are those of an earlier matrix, which serve as long as they are about right.
    is_scaled: bool,
    /// Sums, then scales, of the rows of a node's columns, which are equal.
    of_rows: Vec<f64>,
    right: Vec<[T; 1]>,
    right_together: Vec<[T; TOGETHER]>,
}

/// Why there are no factors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Failure {
    /// This row or column is zero or not finite.
    Line(usize),
    /// Pivots inside the nodes do not suffice, or the matrix is singular.
    Unsuited,
}

impl<T: Scalar> Blocks<T> {
    /// `None` if the factors are too large to be numbered.
    pub(super) fn new(pattern: &Pattern, graph: &Graph) -> Option<Self> {
        let Nodes { members, later } = Nodes::new(pattern, graph);
        let mut layout = Layout::new(&members, &later);
        u32::try_from(layout.length).ok()?;
        layout.connect(&later);
        let longest = pattern.starts().windows(2).map(|pair| pair[1] - pair[0]).max();
        let size = pattern.columns();
        let slots = layout.slots(pattern, &members, &later);
        Some(Self {
            arch: Arch::new(),
            fill_in: gaps(&slots, layout.length as u32),
            slots,
            nodes: layout.nodes,
            segments: layout.segments,
            updates: layout.updates,
            unknowns: members.iter().flatten().map(|&unknown| unknown as u32).collect(),
            values: vec![T::default(); layout.length],
            pivots: vec![0; size],
            row_scale: vec![1.0; size],
            column_scale: vec![1.0; size],
            is_scaled: false,
            of_rows: vec![0.0; longest.unwrap_or(0)],
            right: vec![[T::default(); 1]; size],
            right_together: Vec::new(),
        })
    }

    /// Factors the values; those of column j begin at `starts[j]`. No pivot may be at most `smallest`.
    pub(super) fn factor(
        &mut self,
        pattern: &Pattern,
        values: &[T],
        starts: &[usize],
        smallest: f64,
    ) -> Result<(), Failure> {
        let arch = self.arch;
        kernels::dispatch(
            arch,
            Factor {
                blocks: self,
                pattern,
                values,
                starts,
                smallest,
            },
        )
    }

    /// Solves in place with the factors.
    pub(super) fn solve(&mut self, x: &mut [T]) {
        kernels::dispatch(self.arch, Solve(self, x));
    }

    /// Solves in place for `count` right sides; all of the first unknown come first.
    pub(super) fn solve_many(&mut self, x: &mut [T], count: usize) {
        self.right_together
            .resize(self.unknowns.len(), [T::default(); TOGETHER]);
        kernels::dispatch(self.arch, SolveMany(self, x, count));
    }

    /// Copies the values, equilibrated by rows and columns, into the places of the factors.
    #[inline(always)]
    fn load(&mut self, pattern: &Pattern, values: &[T], starts: &[usize]) -> Result<(), Failure> {
        if self.is_scaled && self.copy::<true>(pattern, values, starts).is_ok() {
            return Ok(());
        }
        self.is_scaled = false;
        self.scale_rows(pattern, values, starts)?;
        self.copy::<false>(pattern, values, starts)?;
        self.is_scaled = true;
        Ok(())
    }

    /// Scales of the rows: the inverse sums of their sizes.
    #[inline(always)]
    fn scale_rows(&mut self, pattern: &Pattern, values: &[T], starts: &[usize]) -> Result<(), Failure> {
        self.row_scale.fill(0.0);
        for node in &self.nodes {
            let columns = &self.unknowns[node.first..][..node.size];
            let rows = column(pattern, columns[0] as usize);
            let sums = &mut self.of_rows[..rows.len()];
            sums.fill(0.0);
            for &column in columns {
                let values = &values[starts[column as usize]..][..rows.len()];
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += value.size();
                }
            }
            for (&row, &sum) in rows.iter().zip(sums.iter()) {
                self.row_scale[row] += sum;
            }
        }
        for (row, scale) in self.row_scale.iter_mut().enumerate() {
            *scale = 1.0 / *scale;
            // An infinite sum has the inverse zero.
            if !(scale.is_finite() && *scale > 0.0) {
                return Err(Failure::Line(row));
            }
        }
        Ok(())
    }

    /// Copies the values, with the scales of an earlier matrix (`KEPT`), if these are about right, or new ones of the
    /// columns.
    #[inline(always)]
    fn copy<const KEPT: bool>(&mut self, pattern: &Pattern, values: &[T], starts: &[usize]) -> Result<(), Failure> {
        for &[start, end] in &self.fill_in {
            self.values[start as usize..end as usize].fill(T::default());
        }
        for node in &self.nodes {
            let columns = &self.unknowns[node.first..][..node.size];
            let rows = column(pattern, columns[0] as usize);
            let scales = &mut self.of_rows[..rows.len()];
            for (scale, &row) in scales.iter_mut().zip(rows) {
                *scale = self.row_scale[row];
            }
            for &column in columns {
                let values = &values[starts[column as usize]..][..rows.len()];
                let largest = largest_scaled(values, scales);
                let mut scale = self.column_scale[column as usize];
                if KEPT && !ABOUT_ONE.contains(&(largest * scale)) {
                    return Err(Failure::Unsuited);
                }
                if !KEPT {
                    scale = 1.0 / largest;
                    if !scale.is_finite() {
                        return Err(Failure::Line(column as usize));
                    }
                    self.column_scale[column as usize] = scale;
                }
                let slots = &self.slots[pattern.starts()[column as usize]..][..rows.len()];
                for ((&value, &of_row), &slot) in values.iter().zip(scales.iter()).zip(slots) {
                    self.values[slot as usize] = value.times(of_row * scale);
                }
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn eliminate<const F: bool>(&mut self, smallest: f64) -> Result<(), Failure> {
        let mut begin = 0;
        for node in &self.nodes {
            let (until, after) = self.values.split_at_mut(node.end());
            let own = &mut until[node.start..];
            let pivots = &mut self.pivots[node.first..][..node.size];
            let growth = kernels::factor_node::<T, F>(own, pivots, (node.size, node.below), smallest);
            if !growth.is_some_and(|growth| growth < LARGEST_GROWTH) {
                return Err(Failure::Unsuited);
            }
            for update in &self.updates[begin..node.updates_end] {
                let target = &mut after[update.target as usize - node.end()..];
                kernels::update::<T, F>(update, node.size, own, target);
            }
            begin = node.updates_end;
        }
        Ok(())
    }

    #[inline(always)]
    fn substitute<const F: bool, const W: usize>(&self, right: &mut [[T; W]]) {
        let mut begin = 0;
        for node in &self.nodes {
            let segments = &self.segments[begin..node.segments_end];
            begin = node.segments_end;
            let values = &self.values[node.start..node.end()];
            let pivots = &self.pivots[node.first..][..node.size];
            forward::<T, F, W>(node, segments, values, pivots, &mut right[node.first..]);
        }
        for (index, node) in self.nodes.iter().enumerate().rev() {
            let begin = if index == 0 {
                0
            } else {
                self.nodes[index - 1].segments_end
            };
            let segments = &self.segments[begin..node.segments_end];
            let values = &self.values[node.start..node.lower()];
            backward::<T, F, W>(node, segments, values, &mut right[node.first..]);
        }
    }
}

impl Blocks<f64> {
    /// Whether the determinant of what was factored is negative; the order is one of rows and columns.
    pub(super) fn is_determinant_negative(&self) -> bool {
        let signs = self.nodes.iter().flat_map(|node| {
            (0..node.size).map(|k| {
                let exchanged = self.pivots[node.first + k] as usize != k;
                exchanged ^ (self.values[node.start + k * node.width() + k] < 0.0)
            })
        });
        signs.fold(false, |odd, negative| odd ^ negative)
    }
}

struct Factor<'a, T> {
    blocks: &'a mut Blocks<T>,
    pattern: &'a Pattern,
    values: &'a [T],
    starts: &'a [usize],
    smallest: f64,
}

impl<T: Scalar> Vectorised for Factor<'_, T> {
    type Output = Result<(), Failure>;

    #[inline(always)]
    fn run<const F: bool>(self) -> Result<(), Failure> {
        self.blocks.load(self.pattern, self.values, self.starts)?;
        self.blocks.eliminate::<F>(self.smallest)
    }
}

struct Solve<'a, T>(&'a mut Blocks<T>, &'a mut [T]);

impl<T: Scalar> Vectorised for Solve<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(blocks, x) = self;
        let mut right = std::mem::take(&mut blocks.right);
        for (value, &unknown) in right.iter_mut().zip(&blocks.unknowns) {
            value[0] = x[unknown as usize].times(blocks.row_scale[unknown as usize]);
        }
        blocks.substitute::<F, 1>(&mut right);
        for (value, &unknown) in right.iter().zip(&blocks.unknowns) {
            x[unknown as usize] = value[0].times(blocks.column_scale[unknown as usize]);
        }
        blocks.right = right;
    }
}

struct SolveMany<'a, T>(&'a mut Blocks<T>, &'a mut [T], usize);

impl<T: Scalar> Vectorised for SolveMany<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(blocks, x, count) = self;
        let mut right = std::mem::take(&mut blocks.right_together);
        for from in (0..count).step_by(TOGETHER) {
            let width = TOGETHER.min(count - from);
            for (row, &unknown) in right.iter_mut().zip(&blocks.unknowns) {
                let scale = blocks.row_scale[unknown as usize];
                let x = &x[unknown as usize * count + from..][..width];
                *row = [T::default(); TOGETHER];
                for (value, x) in row.iter_mut().zip(x) {
                    *value = x.times(scale);
                }
            }
            blocks.substitute::<F, TOGETHER>(&mut right);
            for (row, &unknown) in right.iter().zip(&blocks.unknowns) {
                let scale = blocks.column_scale[unknown as usize];
                let x = &mut x[unknown as usize * count + from..][..width];
                for (value, x) in row.iter().zip(x) {
                    *x = value.times(scale);
                }
            }
        }
        blocks.right_together = right;
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
fn column(pattern: &Pattern, column: usize) -> &[usize] {
    &pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]]
}

#[inline(always)]
fn largest_scaled<T: Scalar>(values: &[T], scales: &[f64]) -> f64 {
    let mut lanes = [0.0; 4];
    let (of_values, rest) = values.as_chunks::<4>();
    let (of_scales, rest_scales) = scales.as_chunks::<4>();
    for (values, scales) in of_values.iter().zip(of_scales) {
        for lane in 0..4 {
            let size = values[lane].size() * scales[lane];
            lanes[lane] = if size > lanes[lane] { size } else { lanes[lane] };
        }
    }
    for (value, scale) in rest.iter().zip(rest_scales) {
        let size = value.size() * scale;
        lanes[0] = if size > lanes[0] { size } else { lanes[0] };
    }
    lanes.into_iter().fold(0.0, f64::max)
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

#[cfg(test)]
#[path = "blocks_tests.rs"]
pub(super) mod tests;
