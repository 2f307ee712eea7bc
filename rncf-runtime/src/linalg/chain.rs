//! LU factorization of chains: meshes of lines, whose nodes are coupled with the one before and the one behind.
//!
//! The matrix is block-tridiagonal. With the blocks B below, D on and C above the diagonal of every link,
//!
//! ```text
//! D'_i = D_i - B_i E_(i-1),   E_i = D'_i^-1 C_i,   L_i = D'_i^-1 B_i
//! z_i = D'_i^-1 f_i - L_i z_(i-1),   x_i = z_i - E_i x_(i+1)
//! ```
//!
//! All blocks have one size, which is a constant of the code. Smaller links are filled up with a unit matrix. There are no row
//! exchanges: what is mass, or mass and stiffness, does without. Every inverse is tried out with one vector, and growth is
//! watched; where either is too much, the factors are refused.

use pulp::Arch;

use super::block_kernels::{Vectorised, dispatch};
use super::column::Column;
use super::links::Links;
use super::pattern::Pattern;
use super::scalar::Scalar;

/// Largest residual of an inverse on the trial vector, relative to it.
const TRUE_INVERSE: f64 = 1e-10;
/// Growth of the rows of a diagonal block beyond which cancellation is to be feared.
const LARGEST_GROWTH: f64 = 1e3;

/// Factors of a block-tridiagonal matrix on a fixed pattern. Everything is laid out once; later calls do not allocate.
#[derive(Debug)]
pub(super) struct Chain<T: Scalar> {
    arch: Arch,
    sized: BySize<T>,
}

/// Factors by the size of the blocks.
#[derive(Debug)]
enum BySize<T: Scalar> {
    Four(Factors<T, 4>),
    Six(Factors<T, 6>),
    Eight(Factors<T, 8>),
    Twelve(Factors<T, 12>),
    Eighteen(Factors<T, 18>),
}

/// Does the same with blocks of every size.
macro_rules! with_factors {
    ($sized:expr, $factors:ident => $do:expr) => {
        match $sized {
            BySize::Four($factors) => $do,
            BySize::Six($factors) => $do,
            BySize::Eight($factors) => $do,
            BySize::Twelve($factors) => $do,
            BySize::Eighteen($factors) => $do,
        }
    };
}

impl<T: Scalar> Chain<T> {
    /// `None` where the pattern is no chain, or one with links of very different or large sizes.
    pub(super) fn new(pattern: &Pattern, links: &Links) -> Option<Self> {
        let sized = [4, 6, 8, 12, 18].into_iter().find_map(|size| {
            let links = links.together(size)?;
            Some(match size {
                4 => BySize::Four(Factors::new(pattern, &links)),
                6 => BySize::Six(Factors::new(pattern, &links)),
                8 => BySize::Eight(Factors::new(pattern, &links)),
                12 => BySize::Twelve(Factors::new(pattern, &links)),
                _ => BySize::Eighteen(Factors::new(pattern, &links)),
            })
        });
        Some(Self {
            arch: Arch::new(),
            sized: sized?,
        })
    }

    /// Factors the values, of which those of column j begin at `starts[j]`; false where this is not safe.
    pub(super) fn factor(&mut self, pattern: &Pattern, values: &[T], starts: &[usize]) -> bool {
        with_factors!(&mut self.sized, factors => {
            dispatch(self.arch, Factor { factors, pattern, values, starts })
        })
    }

    /// Solves in place with the factors.
    pub(super) fn solve(&mut self, x: &mut [T]) {
        with_factors!(&mut self.sized, factors => dispatch(self.arch, Solve(factors, x)));
    }
}

impl Chain<f64> {
    /// Whether the determinant of what was factored is negative.
    pub(super) fn is_determinant_negative(&self) -> bool {
        with_factors!(&self.sized, factors => factors.negative_pivots % 2 == 1)
    }
}

/// The blocks of a link, column after column.
#[derive(Clone, Copy, Debug)]
struct Link<C, const N: usize> {
    /// B, then L.
    below: [C; N],
    /// D, then the inverse of D'.
    diagonal: [C; N],
    /// C, then E.
    above: [C; N],
}

#[derive(Debug)]
struct Factors<T: Scalar, const N: usize> {
    links: Vec<Link<T::Column<N>, N>>,
    /// Columns of the blocks in which there are places without entries: with what stands there.
    begun: Vec<(Place, T::Column<N>)>,
    /// Entries of the pattern that stand together, column by column, and their number up to the end of each column.
    runs: Vec<Run>,
    run_ends: Vec<u32>,
    members: Vec<Members>,
    right: Vec<T::Column<N>>,
    negative_pivots: usize,
}

/// A column of one of the blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    link: u32,
    block: Block,
    column: u8,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Block {
    Below,
    Diagonal,
    Above,
}

/// Entries below each other in a column of a block.
#[derive(Clone, Copy, Debug)]
struct Run {
    place: Place,
    row: u8,
    length: u8,
    /// The first of them, counted in its column of the pattern.
    first: u32,
}

/// Unknowns of a link.
#[derive(Clone, Debug)]
struct Members {
    all: Vec<u32>,
    /// They follow each other, and there is no empty place.
    is_whole: bool,
}

impl<T: Scalar, const N: usize> Factors<T, N> {
    fn new(pattern: &Pattern, links: &Links) -> Self {
        let zeros = [T::Column::<N>::ZERO; N];
        let blocks = Link {
            below: zeros,
            diagonal: zeros,
            above: zeros,
        };
        let count = links.members.len();
        let mut factors = Self {
            links: vec![blocks; count],
            begun: Vec::new(),
            runs: Vec::new(),
            run_ends: Vec::new(),
            members: links.members.iter().map(|members| Members::new::<N>(members)).collect(),
            right: vec![T::Column::<N>::ZERO; count],
            negative_pivots: 0,
        };
        factors.find_runs(pattern, links);
        factors.find_begun(links);
        factors
    }

    fn find_runs(&mut self, pattern: &Pattern, links: &Links) {
        let mut places = vec![(0, 0); pattern.columns()];
        for (link, members) in links.members.iter().enumerate() {
            for (place, &unknown) in members.iter().enumerate() {
                places[unknown] = (link as u32, place as u8);
            }
        }
        for (column, ends) in pattern.starts().windows(2).enumerate() {
            let begin = self.runs.len();
            for (entry, &row) in pattern.indices()[ends[0]..ends[1]].iter().enumerate() {
                let ((link, row), (by, column)) = (places[row], places[column]);
                let block = match by.cmp(&link) {
                    std::cmp::Ordering::Less => Block::Below,
                    std::cmp::Ordering::Equal => Block::Diagonal,
                    std::cmp::Ordering::Greater => Block::Above,
                };
                let place = Place { link, block, column };
                match self.runs[begin..].last_mut() {
                    Some(last) if last.place == place && last.row + last.length == row => last.length += 1,
                    _ => self.runs.push(Run {
                        place,
                        row,
                        length: 1,
                        first: entry as u32,
                    }),
                }
            }
            self.run_ends.push(self.runs.len() as u32);
        }
    }

    fn find_begun(&mut self, links: &Links) {
        let mut covered = vec![[[false; 3]; N]; self.links.len()];
        for Run { place, .. } in self.runs.iter().filter(|run| run.length as usize == N) {
            covered[place.link as usize][place.column as usize][place.block as usize] = true;
        }
        for (link, members) in links.members.iter().enumerate() {
            for column in 0..N {
                for block in [Block::Below, Block::Diagonal, Block::Above] {
                    if !covered[link][column][block as usize] {
                        let mut begin = T::Column::<N>::ZERO;
                        if block == Block::Diagonal && column >= members.len() {
                            begin.set(column, T::real(1.0));
                        }
                        let place = Place {
                            link: link as u32,
                            block,
                            column: column as u8,
                        };
                        self.begun.push((place, begin));
                    }
                }
            }
        }
    }

    /// Copies the values into the blocks.
    #[inline(always)]
    fn load(&mut self, pattern: &Pattern, values: &[T], starts: &[usize]) {
        for (place, begin) in &self.begun {
            *place.of(&mut self.links) = *begin;
        }
        let mut begin = 0;
        for (&end, &start) in self.run_ends.iter().zip(&starts[..pattern.columns()]) {
            for run in &self.runs[begin..end as usize] {
                let target = run.place.of(&mut self.links);
                let values = &values[start + run.first as usize..];
                match values.first_chunk::<N>() {
                    Some(values) if run.length as usize == N => *target = T::Column::<N>::of(values),
                    _ => {
                        for (row, &value) in values[..run.length as usize].iter().enumerate() {
                            target.set(run.row as usize + row, value);
                        }
                    }
                }
            }
            begin = end as usize;
        }
    }

    #[inline(always)]
    fn eliminate<const F: bool>(&mut self) -> bool {
        let trial = trial::<T, N>();
        self.negative_pivots = 0;
        let mut before: Option<[T::Column<N>; N]> = None;
        for link in &mut self.links {
            let mut diagonal = link.diagonal;
            let mut original = T::Column::<N>::ZERO;
            let mut grown = T::Column::<N>::ZERO;
            if let Some(before) = &before {
                for (column, by) in diagonal.iter_mut().zip(before) {
                    original.take_larger(column);
                    for k in 0..N {
                        column.add_scaled::<F>(-by.get(k), &link.below[k]);
                    }
                    grown.take_larger(column);
                }
            }
            let (inverse, negative) = inverted::<T, F, N>(diagonal);
            let mut response = product::<T, F, N>(&inverse, &trial);
            response = product::<T, F, N>(&diagonal, &response);
            response.add_scaled::<false>(T::real(-1.0), &trial);
            if !(response.is_within(TRUE_INVERSE, &trial) && grown.is_within(LARGEST_GROWTH, &original)) {
                return false;
            }
            self.negative_pivots += negative;
            link.diagonal = inverse;
            for column in link.below.iter_mut().chain(&mut link.above) {
                *column = product::<T, F, N>(&inverse, column);
            }
            before = Some(link.above);
        }
        true
    }

    #[inline(always)]
    fn substitute<const F: bool>(&mut self, x: &mut [T]) {
        let mut known = T::Column::<N>::ZERO;
        for ((link, right), members) in self.links.iter().zip(&mut self.right).zip(&self.members) {
            let given: T::Column<N> = members.read(x);
            let mut sum = product::<T, F, N>(&link.diagonal, &given);
            for k in 0..N {
                sum.add_scaled::<F>(-known.get(k), &link.below[k]);
            }
            known = sum;
            *right = known;
        }
        known = T::Column::<N>::ZERO;
        for ((link, right), members) in self.links.iter().zip(&self.right).zip(&self.members).rev() {
            let mut sum = *right;
            for k in 0..N {
                sum.add_scaled::<F>(-known.get(k), &link.above[k]);
            }
            members.write::<T, N>(&sum, x);
            known = sum;
        }
    }
}

impl Place {
    #[inline(always)]
    fn of<C, const N: usize>(self, links: &mut [Link<C, N>]) -> &mut C {
        let link = &mut links[self.link as usize];
        let block = match self.block {
            Block::Below => &mut link.below,
            Block::Diagonal => &mut link.diagonal,
            Block::Above => &mut link.above,
        };
        &mut block[self.column as usize]
    }
}

impl Members {
    fn new<const N: usize>(members: &[usize]) -> Self {
        Self {
            all: members.iter().map(|&unknown| unknown as u32).collect(),
            is_whole: members.len() == N && members.windows(2).all(|pair| pair[1] == pair[0] + 1),
        }
    }

    /// Their values, and zeros.
    #[inline(always)]
    fn read<C: Column<T, N>, T: Scalar, const N: usize>(&self, x: &[T]) -> C {
        if self.is_whole
            && let Some(values) = x[self.all[0] as usize..].first_chunk::<N>()
        {
            return C::of(values);
        }
        let mut column = C::ZERO;
        for (place, &unknown) in self.all.iter().enumerate() {
            column.set(place, x[unknown as usize]);
        }
        column
    }

    /// Writes their values.
    #[inline(always)]
    fn write<T: Scalar, const N: usize>(&self, column: &T::Column<N>, x: &mut [T]) {
        if self.is_whole
            && let Some(values) = x[self.all[0] as usize..].first_chunk_mut::<N>()
        {
            *values = column.together();
            return;
        }
        for (place, &unknown) in self.all.iter().enumerate() {
            x[unknown as usize] = column.get(place);
        }
    }
}

/// A vector without symmetries.
#[inline(always)]
fn trial<T: Scalar, const N: usize>() -> T::Column<N> {
    let mut trial = T::Column::<N>::ZERO;
    for place in 0..N {
        trial.set(place, T::real(1.0 - place as f64 / 32.0));
    }
    trial
}

/// `A x`
#[inline(always)]
fn product<T: Scalar, const F: bool, const N: usize>(a: &[T::Column<N>; N], x: &T::Column<N>) -> T::Column<N> {
    let mut sum = T::Column::<N>::ZERO;
    for (k, column) in a.iter().enumerate() {
        sum.add_scaled::<F>(x.get(k), column);
    }
    sum
}

/// The inverse by Gauss and Jordan, and the number of negative pivots.
#[inline(always)]
fn inverted<T: Scalar, const F: bool, const N: usize>(mut a: [T::Column<N>; N]) -> ([T::Column<N>; N], usize) {
    let mut negative = 0;
    for k in 0..N {
        let pivot = a[k].get(k);
        negative += usize::from(pivot.is_negative());
        let inverse = pivot.inverse();
        a[k].scale(inverse);
        a[k].set(k, inverse);
        let own = a[k];
        for (j, column) in a.iter_mut().enumerate() {
            if j != k {
                let factor = -column.get(k);
                column.add_scaled::<F>(factor, &own);
                column.set(k, factor * inverse);
            }
        }
    }
    (a, negative)
}

struct Factor<'a, T: Scalar, const N: usize> {
    factors: &'a mut Factors<T, N>,
    pattern: &'a Pattern,
    values: &'a [T],
    starts: &'a [usize],
}

impl<T: Scalar, const N: usize> Vectorised for Factor<'_, T, N> {
    type Output = bool;

    #[inline(always)]
    fn run<const F: bool>(self) -> bool {
        self.factors.load(self.pattern, self.values, self.starts);
        self.factors.eliminate::<F>()
    }
}

struct Solve<'a, T: Scalar, const N: usize>(&'a mut Factors<T, N>, &'a mut [T]);

impl<T: Scalar, const N: usize> Vectorised for Solve<'_, T, N> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        self.0.substitute::<F>(self.1);
    }
}

#[cfg(test)]
#[path = "chain_tests.rs"]
mod tests;
