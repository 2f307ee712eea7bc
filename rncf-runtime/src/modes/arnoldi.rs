//! The eigenvalues next to a real shift, of large sparse pencils: Arnoldi's iteration with the inverse
//!
//! ```text
//! (x, y) -> (x', x / shift + x'),  [[K + s C + s^2 M, C_x^T], [C_x, 0]] (x', lambda) = -(C x + s M x + s M y, 0)
//! ```
//!
//! at s = shift, where y = (s / shift) x; its eigenvalues are 1 / (s - shift). What has converged is locked
//! as an invariant subspace, and the iteration starts again beside it, until a start finds nothing new:
//! one vector alone does not see an eigenvalue twice.

use super::pair::{CLOSE, Failure, Pair, better_shift};
use super::pencil::Pencil;
use crate::linalg::{Lu, c64, clear, general_eigen, norm, scattered};

/// Residual of an eigenpair of the inverse, relative to the eigenvalue, at which it is locked.
const CONVERGED: f64 = 1e-10;
/// Largest residual of what is locked: vectors of eigenvalues that are there several times come out of a small matrix worse than it is.
const EXACT: f64 = 1e-8;
/// The same relative to the size of the inverse: what is slow to it is known no better.
const ROUND_OFF: f64 = 1e-13;
/// Residual from which on an eigenvalue tells the order of frequencies.
const ROUGH: f64 = 1e-2;
/// Part of a solution that one refinement may change before all solutions are refined: beside something very stiff the rest is round-off, in which
/// an iteration loses its way.
const REFINED: f64 = 1e-11;
/// Most refinements of a solution.
const REFINEMENTS: usize = 3;
/// Images below this part of the first one are round-off: nothing is left.
const EXHAUSTED: f64 = 1e-13;
/// Eigenvalues below this part of the largest one stand for infinite frequencies.
const INFINITE: f64 = 1e-10;
/// Part of a vector beyond the locked ones that counts as new. What is less is known worse by as much, and another start finds it again.
const NEW: f64 = 1e-3;
/// Vectors after which an iteration looks at its eigenvalues first, and the growth to the next look.
const FIRST_LOOK: usize = 24;
const LONGER: f64 = 1.4;
/// Most vectors of one start, beside twice what is wanted.
const MOST_VECTORS: usize = 300;
/// Most starts, beside as many as eigenvalues are wanted.
const MOST_STARTS: usize = 40;
/// Most rounds in which the shift is chosen, the vectors of each, and how many eigenvalues are looked at
/// in any case.
const ROUNDS: usize = 12;
const LOOK_AROUND: usize = 40;
const FIRST: usize = 4;

/// The `count` lowest modes and what else was found, with the shift; conjugates both. `true` if these are
/// all.
pub(super) fn spectrum(pencil: &Pencil, count: usize) -> Result<(f64, Vec<Pair>, bool), Failure> {
    let mut inverse = choose_shift(pencil)?;
    let mut locked: Vec<Vec<f64>> = Vec::new();
    let mut found: Vec<c64> = Vec::new();
    let mut carried = vec![0.0; 2 * pencil.unknowns()];
    let mut all = false;
    for start in 0.. {
        let mut iteration = Iteration::new(&mut inverse, &locked, &carried, start)?;
        let needed = (found.len() >= 2 * count).then(|| farthest(&found, count, iteration.inverse.shift));
        let wanted = (2 * count + 6).saturating_sub(found.len());
        let end = iteration.run(wanted, needed, 2 * count + MOST_VECTORS)?;
        let ritz = iteration.ritz()?;
        let ready = ritz.iter().take_while(|ritz| ritz.residual <= CONVERGED).count();
        let news = ritz[..ready]
            .iter()
            .filter(|ritz| needed.is_none_or(|needed| ritz.value.norm() >= needed));
        let is_new = news.count() > 0;
        if end == End::Exhausted && ready == 0 || needed.is_some() && !is_new {
            all = end == End::Exhausted;
            break;
        }
        if ready == 0 || start > 2 * count + MOST_STARTS {
            return Err(Failure::Slow(found.len() / 2));
        }
        carried = iteration.combined(&ritz[ready..], wanted);
        let size = iteration.size;
        let fresh: Vec<(c64, Vec<Vec<f64>>)> = iteration.vectors(&ritz[..ready]).collect();
        let (known, mut is_inexact) = (locked.len(), false);
        for (value, parts) in fresh {
            let count = parts.len();
            if !inverse.is_exact(value, &parts, &locked[..known], size) {
                is_inexact |= needed.is_none_or(|needed| value.norm() >= needed);
            } else if lock(&mut locked, parts) {
                found.extend([value, value.conj()].into_iter().take(count));
            }
        }
        if locked.len() == known && is_inexact {
            return Err(Failure::Lost(found.len() / 2));
        }
        if locked.len() == known || locked.len() >= 2 * pencil.unknowns() {
            break;
        }
    }
    let shift = inverse.shift;
    Ok((shift, inverse.pairs(&locked)?, all))
}

/// Size of the inverse's eigenvalue that is certainly not exceeded by those farther from zero than the
/// `count` lowest of the found ones.
fn farthest(found: &[c64], count: usize, shift: f64) -> f64 {
    let mut speeds: Vec<f64> = found
        .iter()
        .map(|value| (c64::new(shift, 0.0) + value.inv()).norm())
        .collect();
    speeds.sort_by(f64::total_cmp);
    let radius = speeds[(2 * count).min(speeds.len()) - 1];
    1.0 / (radius + shift)
}

/// The inverse at a shift near the lowest frequency that is not zero.
fn choose_shift(pencil: &Pencil) -> Result<Inverse<'_>, Failure> {
    let mut inverse = Inverse::new(pencil, pencil.guess())?;
    let nothing = vec![0.0; 2 * pencil.unknowns()];
    for _ in 0..ROUNDS {
        let shift = inverse.shift;
        let mut iteration = Iteration::new(&mut inverse, &[], &nothing, 0)?;
        iteration.extend(LOOK_AROUND);
        let ritz = iteration.ritz()?;
        // The first ones tell the direction, whether they have converged or not.
        let seen = ritz
            .iter()
            .enumerate()
            .filter(|(place, ritz)| *place < FIRST || ritz.residual <= ROUGH);
        let pairs = seen.map(|(_, ritz)| Pair {
            s: c64::new(shift, 0.0) + ritz.value.inv(),
            x: combination(&iteration.basis, &ritz.vector, pencil.unknowns()),
        });
        match better_shift(pencil, shift, pairs) {
            Some(next) => inverse.factor(next)?,
            None => break,
        }
    }
    Ok(inverse)
}

/// Adds vectors that belong together to an orthonormal set, unless one of them is no new one.
fn lock(locked: &mut Vec<Vec<f64>>, parts: Vec<Vec<f64>>) -> bool {
    let before = locked.len();
    for mut vector in parts {
        let length = norm(&vector);
        clear(&mut vector, locked, &mut []);
        let rest = norm(&vector);
        if rest <= NEW * length {
            locked.truncate(before);
            return false;
        }
        vector.iter_mut().for_each(|value| *value /= rest);
        clear(&mut vector, locked, &mut []);
        let length = norm(&vector);
        vector.iter_mut().for_each(|value| *value /= length);
        locked.push(vector);
    }
    true
}

/// The inverse of the pencil at a shift.
struct Inverse<'a> {
    pencil: &'a Pencil,
    lu: Lu<f64>,
    shift: f64,
    /// The matrix, and whether its solutions are refined.
    values: Vec<f64>,
    refines: bool,
    work: Vec<f64>,
}

impl<'a> Inverse<'a> {
    fn new(pencil: &'a Pencil, shift: f64) -> Result<Self, Failure> {
        let mut inverse = Self {
            pencil,
            lu: pencil.lu(),
            shift,
            values: Vec::new(),
            refines: false,
            work: vec![0.0; pencil.unknowns() + pencil.constraints()],
        };
        inverse.factor(shift)?;
        Ok(inverse)
    }

    /// Moves to a shift, or beside it where that is an eigenvalue.
    fn factor(&mut self, shift: f64) -> Result<(), Failure> {
        let mut worst = None;
        for part in [1.0, 1.3, 0.7, 3.0] {
            self.shift = part * shift;
            self.values = self.pencil.at(self.shift);
            match self.lu.factor(&self.values) {
                Ok(()) => {
                    let right = scattered(self.work.len(), 0);
                    let mut solution = right.clone();
                    self.lu.solve(&mut solution);
                    self.refines = self.refine(&mut solution, &right) > REFINED;
                    return Ok(());
                }
                Err(row) => worst = Some(row),
            }
        }
        Err(Failure::Singular(worst))
    }

    /// Refines a solution once: the change of the unknowns, relative to them.
    fn refine(&mut self, solution: &mut [f64], right: &[f64]) -> f64 {
        let mut change = self.pencil.rest(&self.values, solution, right);
        self.lu.solve(&mut change);
        solution.iter_mut().zip(&change).for_each(|(x, change)| *x += change);
        let n = self.pencil.unknowns();
        norm(&change[..n]) / norm(&solution[..n])
    }

    /// Solves for the right side in `work`.
    fn solve(&mut self) {
        let mut solution = std::mem::take(&mut self.work);
        let right = if self.refines { solution.clone() } else { Vec::new() };
        self.lu.solve(&mut solution);
        let mut left = if self.refines { REFINEMENTS } else { 0 };
        while left > 0 && self.refine(&mut solution, &right) > REFINED {
            left -= 1;
        }
        self.work = solution;
    }

    fn apply(&mut self, z: &[f64]) -> Vec<f64> {
        let n = self.pencil.unknowns();
        let (x, y) = z.split_at(n);
        self.work.fill(0.0);
        let sum: Vec<f64> = x.iter().zip(y).map(|(x, y)| self.shift * (x + y)).collect();
        self.pencil.add_mass(1.0, &sum, &mut self.work[..n]);
        self.pencil.add_damping(x, &mut self.work[..n]);
        self.solve();
        let image: Vec<f64> = self.work[..n].iter().map(|value| -value).collect();
        let rates = x.iter().zip(&image).map(|(x, image)| x / self.shift + image);
        image.iter().copied().chain(rates).collect()
    }

    /// Whether a vector, as its real parts and its imaginary ones, is that of an eigenvalue of the inverse beside the locked ones; `size` is that of
    /// the inverse.
    fn is_exact(&mut self, value: c64, parts: &[Vec<f64>], locked: &[Vec<f64>], size: f64) -> bool {
        let image = |part: &Vec<f64>| {
            let mut image = self.apply(part);
            clear(&mut image, locked, &mut []);
            image
        };
        let images: Vec<Vec<f64>> = parts.iter().map(image).collect();
        let entry = |parts: &[Vec<f64>], at: usize| c64::new(parts[0][at], parts.get(1).map_or(0.0, |part| part[at]));
        let (mut rest, mut length) = (0.0, 0.0);
        for at in 0..parts[0].len() {
            rest += (entry(&images, at) - value * entry(parts, at)).norm_sqr();
            length += entry(parts, at).norm_sqr();
        }
        (rest / length).sqrt() <= EXACT * value.norm() + ROUND_OFF * size
    }

    /// Eigenpairs of the inverse on an invariant subspace, as those of the pencil.
    fn pairs(&mut self, basis: &[Vec<f64>]) -> Result<Vec<Pair>, Failure> {
        let k = basis.len();
        let mut matrix = vec![0.0; k * k];
        for (column, vector) in basis.iter().enumerate() {
            let image = self.apply(vector);
            for (row, other) in basis.iter().enumerate() {
                matrix[row * k + column] = other.iter().zip(&image).map(|(a, b)| a * b).sum();
            }
        }
        let (values, vectors) = general_eigen(k, &matrix).map_err(|_| Failure::NotFound)?;
        let n = self.pencil.unknowns();
        let pair = |(value, vector): (c64, Vec<c64>)| Pair {
            s: c64::new(self.shift, 0.0) + value.inv(),
            x: combination(basis, &vector, n),
        };
        Ok(values.into_iter().zip(vectors).map(pair).collect())
    }
}

/// Whether an eigenvalue is there twice: one vector alone sees it once, and again when it has lost all but round-off, and then ever worse.
fn has_twice(values: impl Iterator<Item = c64>) -> bool {
    let upper: Vec<c64> = values.filter(|value| value.im >= 0.0).collect();
    let is_close = |a: c64, b: c64| (a - b).norm() <= CLOSE * a.norm();
    (1..upper.len()).any(|at| upper[..at].iter().any(|other| is_close(upper[at], *other)))
}

/// `sum_k z_k v_k`, the first `length` components.
fn combination(basis: &[Vec<f64>], coordinates: &[c64], length: usize) -> Vec<c64> {
    let mut sum = vec![c64::default(); length];
    for (vector, coordinate) in basis.iter().zip(coordinates) {
        for (sum, value) in sum.iter_mut().zip(vector) {
            *sum += coordinate * value;
        }
    }
    sum
}

/// An approximate eigenvalue of the inverse.
struct Ritz {
    value: c64,
    /// Coordinates of the vector in the basis.
    vector: Vec<c64>,
    /// Relative to the value.
    residual: f64,
}

/// How an iteration ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    /// With what was asked for.
    Enough,
    /// With an invariant subspace.
    Exhausted,
}

/// One start of Arnoldi's iteration beside the locked vectors.
struct Iteration<'a, 'b> {
    inverse: &'a mut Inverse<'b>,
    locked: &'a [Vec<f64>],
    basis: Vec<Vec<f64>>,
    /// Columns of the projected inverse, with the entry below the diagonal at the end.
    columns: Vec<Vec<f64>>,
    /// Size of the inverse, as seen.
    size: f64,
    exhausted: bool,
}

impl<'a, 'b> Iteration<'a, 'b> {
    /// Starts from `carried` and a vector that depends on the number of the start only.
    fn new(
        inverse: &'a mut Inverse<'b>,
        locked: &'a [Vec<f64>],
        carried: &[f64],
        start: usize,
    ) -> Result<Self, Failure> {
        let mut vector = scattered(2 * inverse.pencil.unknowns(), start);
        let mut size: f64 = 0.0;
        let mut exhausted = false;
        // The images satisfy the constraints; the second one in both halves.
        for _ in 0..3 {
            clear(&mut vector, locked, &mut []);
            let before = norm(&vector);
            vector = inverse.apply(&vector);
            let growth = norm(&vector) / before;
            if !growth.is_finite() {
                return Err(Failure::NotFinite);
            }
            size = size.max(growth);
            clear(&mut vector, locked, &mut []);
            let after = norm(&vector);
            exhausted = after <= EXHAUSTED * size * before;
            if exhausted {
                break;
            }
            vector.iter_mut().for_each(|value| *value /= after);
        }
        vector.iter_mut().zip(carried).for_each(|(value, more)| *value += more);
        clear(&mut vector, locked, &mut []);
        let length = norm(&vector);
        vector.iter_mut().for_each(|value| *value /= length);
        Ok(Self {
            inverse,
            locked,
            basis: vec![vector],
            columns: Vec::new(),
            size,
            exhausted,
        })
    }

    /// Adds vectors up to the given number.
    fn extend(&mut self, count: usize) {
        while self.columns.len() < count && !self.exhausted {
            let k = self.columns.len();
            let mut image = self.inverse.apply(&self.basis[k]);
            self.size = self.size.max(norm(&image));
            clear(&mut image, self.locked, &mut []);
            let mut column = vec![0.0; k + 2];
            clear(&mut image, &self.basis, &mut column);
            // Twice again: what is left may be small beside what was removed.
            clear(&mut image, self.locked, &mut []);
            let rest = norm(&image);
            column[k + 1] = rest;
            self.columns.push(column);
            self.exhausted = rest <= EXHAUSTED * self.size;
            image.iter_mut().for_each(|value| *value /= rest);
            self.basis.push(image);
        }
    }

    /// Goes on until `wanted` eigenvalues have converged, or, where it is known how large `needed`
    /// eigenvalues are, all of those and one smaller one; or until one comes twice; or until `most` vectors.
    fn run(&mut self, wanted: usize, needed: Option<f64>, most: usize) -> Result<End, Failure> {
        let mut look = FIRST_LOOK;
        while !self.exhausted && self.columns.len() < most {
            self.extend(look.min(most));
            look = (LONGER * look as f64) as usize;
            let ritz = self.ritz()?;
            let ready = ritz.iter().take_while(|ritz| ritz.residual <= CONVERGED);
            if has_twice(ready.clone().map(|ritz| ritz.value)) {
                break;
            }
            let enough = match needed {
                Some(needed) => ready.map(|ritz| ritz.value.norm()).any(|size| size < needed),
                None => ready.count() >= wanted,
            };
            if enough {
                return Ok(End::Enough);
            }
        }
        Ok(if self.exhausted { End::Exhausted } else { End::Enough })
    }

    /// Approximate eigenvalues, the largest first, conjugates next to each other.
    fn ritz(&self) -> Result<Vec<Ritz>, Failure> {
        let k = self.columns.len();
        let mut matrix = vec![0.0; k * k];
        for (column, values) in self.columns.iter().enumerate() {
            for (row, value) in values.iter().enumerate().take(k) {
                matrix[row * k + column] = *value;
            }
        }
        let (values, vectors) = general_eigen(k, &matrix).map_err(|_| Failure::NotFinite)?;
        let rest = self.columns.last().map_or(0.0, |column| column[k]);
        let all = values.into_iter().zip(vectors);
        let mut ritz: Vec<Ritz> = all
            .filter(|(value, _)| value.norm() > INFINITE * self.size)
            .map(|(value, vector)| {
                let residual = if self.exhausted {
                    0.0
                } else {
                    rest * vector[k - 1].norm() / value.norm()
                };
                Ritz {
                    value,
                    vector,
                    residual,
                }
            })
            .collect();
        let key = |ritz: &Ritz| (ritz.value.norm(), ritz.value.im.abs());
        ritz.sort_by(|a, b| {
            let ((size_a, im_a), (size_b, im_b)) = (key(a), key(b));
            size_b
                .total_cmp(&size_a)
                .then(im_b.total_cmp(&im_a))
                .then(b.value.im.total_cmp(&a.value.im))
        });
        Ok(ritz)
    }

    /// Real vectors that span those of the given eigenvalues and their conjugates: one or two of each.
    fn vectors(&self, ritz: &[Ritz]) -> impl Iterator<Item = (c64, Vec<Vec<f64>>)> {
        let upper = ritz.iter().filter(|ritz| ritz.value.im >= 0.0);
        upper.map(|ritz| {
            let vector = combination(&self.basis, &ritz.vector, self.basis[0].len());
            let part = |part: fn(&c64) -> f64| vector.iter().map(part).collect::<Vec<f64>>();
            let real = part(|value| value.re);
            let imaginary = (ritz.value.im > 0.0).then(|| part(|value| value.im));
            (ritz.value, std::iter::once(real).chain(imaginary).collect())
        })
    }

    /// The sum of the first vectors that have not converged: a start for the next iteration.
    fn combined(&self, ritz: &[Ritz], count: usize) -> Vec<f64> {
        let mut sum = vec![0.0; self.basis[0].len()];
        for vector in self
            .vectors(&ritz[..count.min(ritz.len())])
            .flat_map(|(_, parts)| parts)
        {
            sum.iter_mut().zip(&vector).for_each(|(sum, value)| *sum += value);
        }
        sum
    }
}
