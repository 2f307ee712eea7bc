//! LU factorization by node blocks: unknowns with equal patterns are eliminated together.

use std::sync::Arc;

use pulp::Arch;

use super::block_kernels::{self as kernels, Vectorised};
use super::block_layout::{Structure, column};
use super::block_solve::{backward, forward};
use super::block_solve_one::{self as one, copy_lower, copy_upper};
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
    structure: Arc<Structure>,
    /// Of every node, one after another: its rows from the diagonal on, then the columns below it,
    /// transposed.
    values: Vec<T>,
    /// Of every node of six unknowns before six others once more what a single right side is substituted with, forwards and
    /// backwards.
    lower: Vec<T>,
    upper: Vec<T>,
    /// Row exchanges inside the nodes.
    pivots: Vec<u32>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    /// Both scales at every place of the elimination.
    placed_scales: [Vec<f64>; 2],
    /// Whether the scales are those of an earlier matrix, which serve as long as they are about right.
    is_scaled: bool,
    /// Sums, then scales, of the rows of a node's columns, which are equal.
    of_rows: Vec<f64>,
    right: Vec<[T; 1]>,
    right_together: Vec<[T; TOGETHER]>,
}

/// Numbers of a node of six unknowns before six others that its substitution takes, forwards and backwards.
const SIX_LOWER: usize = 15 + 36;
const SIX_UPPER: usize = 21 + 36;

/// Why there are no factors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Failure {
    /// This row or column is zero or not finite.
    Line(usize),
    /// Pivots inside the nodes do not suffice, or the matrix is singular.
    Unsuited,
}

impl<T: Scalar> Blocks<T> {
    /// For matrices on the pattern of this structure.
    pub(super) fn new(structure: Arc<Structure>) -> Self {
        let size = structure.unknowns.len();
        Self {
            arch: Arch::new(),
            values: vec![T::default(); structure.length],
            lower: vec![T::default(); structure.sixes * SIX_LOWER],
            upper: vec![T::default(); structure.sixes * SIX_UPPER],
            pivots: vec![0; size],
            row_scale: vec![1.0; size],
            column_scale: vec![1.0; size],
            placed_scales: [vec![1.0; size], vec![1.0; size]],
            is_scaled: false,
            of_rows: vec![0.0; structure.longest],
            right: vec![[T::default(); 1]; size],
            right_together: Vec::new(),
            structure,
        }
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
            .resize(self.structure.unknowns.len(), [T::default(); TOGETHER]);
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
        for (placed, scale) in self.placed_scales.iter_mut().zip([&self.row_scale, &self.column_scale]) {
            for (placed, &unknown) in placed.iter_mut().zip(&self.structure.unknowns) {
                *placed = scale[unknown as usize];
            }
        }
        self.is_scaled = true;
        Ok(())
    }

    /// Scales of the rows: the inverse sums of their sizes.
    #[inline(always)]
    fn scale_rows(&mut self, pattern: &Pattern, values: &[T], starts: &[usize]) -> Result<(), Failure> {
        self.row_scale.fill(0.0);
        for node in &self.structure.nodes {
            let columns = &self.structure.unknowns[node.first..][..node.size];
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
        for &[start, end] in &self.structure.fill_in {
            self.values[start as usize..end as usize].fill(T::default());
        }
        for node in &self.structure.nodes {
            let columns = &self.structure.unknowns[node.first..][..node.size];
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
                let slots = &self.structure.slots[pattern.starts()[column as usize]..][..rows.len()];
                for ((&value, &of_row), &slot) in values.iter().zip(scales.iter()).zip(slots) {
                    self.values[slot as usize] = value.times(of_row * scale);
                }
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn eliminate<const F: bool>(&mut self, smallest: f64) -> Result<(), Failure> {
        let (mut begin, mut first_segment) = (0, 0);
        let lower = self.lower.as_chunks_mut::<SIX_LOWER>().0.iter_mut();
        let mut sixes = lower.zip(self.upper.as_chunks_mut::<SIX_UPPER>().0);
        for node in &self.structure.nodes {
            let (until, after) = self.values.split_at_mut(node.end());
            let own = &mut until[node.start..];
            let pivots = &mut self.pivots[node.first..][..node.size];
            let growth = kernels::factor_node::<T, F>(own, pivots, (node.size, node.below), smallest);
            if !growth.is_some_and(|growth| growth < LARGEST_GROWTH) {
                return Err(Failure::Unsuited);
            }
            for update in &self.structure.updates[begin..node.updates_end] {
                let target = &mut after[update.target as usize - node.end()..];
                kernels::update::<T, F>(update, node.size, own, target);
            }
            begin = node.updates_end;
            if kernels::is_specialised::<T, F>() && node.is_six(node.segments_end - first_segment) {
                let Some((lower, upper)) = sixes.next() else {
                    unreachable!("every node of six and six has its copies");
                };
                copy_lower::<T, 6, 12>(own, lower);
                copy_upper::<T, 6, 12>(own, upper);
            }
            first_segment = node.segments_end;
        }
        Ok(())
    }

    #[inline(always)]
    fn substitute<const F: bool, const W: usize>(&self, right: &mut [[T; W]]) {
        let mut begin = 0;
        for node in &self.structure.nodes {
            let segments = &self.structure.segments[begin..node.segments_end];
            begin = node.segments_end;
            let values = &self.values[node.start..node.end()];
            let pivots = &self.pivots[node.first..][..node.size];
            forward::<T, F, W>(node, segments, values, pivots, &mut right[node.first..]);
        }
        for (index, node) in self.structure.nodes.iter().enumerate().rev() {
            let begin = if index == 0 {
                0
            } else {
                self.structure.nodes[index - 1].segments_end
            };
            let segments = &self.structure.segments[begin..node.segments_end];
            let values = &self.values[node.start..node.lower()];
            backward::<T, F, W>(node, segments, values, &mut right[node.first..]);
        }
    }

    /// Substitution of a single right side.
    #[inline(always)]
    fn substitute_one<const F: bool>(&self, right: &mut [[T; 1]]) {
        let (mut begin, mut lower) = (0, self.lower.as_chunks::<SIX_LOWER>().0.iter());
        for node in &self.structure.nodes {
            let segments = &self.structure.segments[begin..node.segments_end];
            begin = node.segments_end;
            let pivots = &self.pivots[node.first..];
            let right = &mut right[node.first..];
            if let (Some((own, later)), Some(pivots)) = (six(node, segments, right), pivots.first_chunk()) {
                let Some(lower) = lower.next() else {
                    unreachable!("every node of six and six has its copies");
                };
                one::forward::<T, F, 6, 6, SIX_LOWER>(lower, pivots, own, later);
            } else {
                let values = &self.values[node.start..node.end()];
                forward::<T, F, 1>(node, segments, values, &pivots[..node.size], right);
            }
        }
        let mut upper = self.upper.as_chunks::<SIX_UPPER>().0.iter();
        for (index, node) in self.structure.nodes.iter().enumerate().rev() {
            let begin = index
                .checked_sub(1)
                .map_or(0, |before| self.structure.nodes[before].segments_end);
            let segments = &self.structure.segments[begin..node.segments_end];
            let right = &mut right[node.first..];
            if let Some((own, later)) = six(node, segments, right) {
                let Some(upper) = upper.next_back() else {
                    unreachable!("every node of six and six has its copies");
                };
                one::backward::<T, F, 6, 6, SIX_UPPER>(upper, own, later);
            } else {
                let values = &self.values[node.start..node.lower()];
                backward::<T, F, 1>(node, segments, values, right);
            }
        }
    }
}

/// The right sides of a node of six unknowns and those of the six that it is coupled to, if it is such a node and these follow
/// each other.
#[inline(always)]
fn six<'a, T: Scalar>(
    node: &Node,
    segments: &[Segment],
    right: &'a mut [[T; 1]],
) -> Option<(&'a mut [T; 6], &'a mut [T; 6])> {
    if !node.is_six(segments.len()) {
        return None;
    }
    let segment = segments.first()?;
    let (own, rest) = right.as_flattened_mut().split_first_chunk_mut::<6>()?;
    let later = rest
        .get_mut(segment.place as usize - node.first - 6..)?
        .first_chunk_mut::<6>()?;
    Some((own, later))
}

impl Blocks<f64> {
    /// Whether the determinant of what was factored is negative; the order is one of rows and columns.
    pub(super) fn is_determinant_negative(&self) -> bool {
        let signs = self.structure.nodes.iter().flat_map(|node| {
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
        let [row_scale, column_scale] = &blocks.placed_scales;
        let unknowns = &blocks.structure.unknowns;
        for ((value, &unknown), &scale) in right.iter_mut().zip(unknowns).zip(row_scale) {
            value[0] = x[unknown as usize].times(scale);
        }
        if kernels::is_specialised::<T, F>() {
            blocks.substitute_one::<F>(&mut right);
        } else {
            blocks.substitute::<F, 1>(&mut right);
        }
        for ((value, &unknown), &scale) in right.iter().zip(unknowns).zip(column_scale) {
            x[unknown as usize] = value[0].times(scale);
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
            for (row, &unknown) in right.iter_mut().zip(&blocks.structure.unknowns) {
                let scale = blocks.row_scale[unknown as usize];
                let x = &x[unknown as usize * count + from..][..width];
                *row = [T::default(); TOGETHER];
                for (value, x) in row.iter_mut().zip(x) {
                    *value = x.times(scale);
                }
            }
            blocks.substitute::<F, TOGETHER>(&mut right);
            for (row, &unknown) in right.iter().zip(&blocks.structure.unknowns) {
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

#[cfg(test)]
#[path = "blocks_tests.rs"]
pub(super) mod tests;
