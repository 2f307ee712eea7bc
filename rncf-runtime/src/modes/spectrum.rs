//! The lowest eigenpairs of a pencil: found, refined, checked against the pencil, and freed of what
//! appears twice.

use super::arnoldi;
use super::dense;
use super::pencil::Pencil;
use crate::linalg::{Lu, c64};

/// Unknowns up to which full matrices are used, and up to which they are if many modes are wanted.
const SMALL: usize = 60;
const STILL_SMALL: usize = 600;
/// Part of the unknowns that counts as many modes: one of this many.
const MANY: usize = 4;
/// Most refinements of a pair.
const REFINEMENTS: usize = 12;
/// Distance of the factored from the wanted eigenvalue in refinements, relative.
const BESIDE: f64 = 1e-4;
/// Changes of the vector that are round-off, and shrinkage that round-off does not reach.
const ROUND_OFF: f64 = 1e-14;
const STAGNANT: f64 = 0.5;
/// Largest residual of a pair that is returned, relative to the terms of its equation.
const ACCEPTED: f64 = 1e-10;
/// Eigenvalues closer than this, relative to their distance from the shift, may be one.
const CLOSE: f64 = 1e-6;
/// Part of a unit vector that makes it new beside others of the same eigenvalue.
const INDEPENDENT: f64 = 1e-3;

/// An eigenvalue and the unknowns of its vector, relative to the pencil's sizes.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub s: c64,
    pub x: Vec<c64>,
}

/// Why modes were not found. Rows count unknowns first, then constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Failure {
    /// The pencil is singular whatever the eigenvalue.
    Singular(Option<usize>),
    /// An entry is not finite.
    NotFinite,
    /// The iteration for eigenvalues of a full matrix did not converge.
    NotFound,
    /// Arnoldi's iteration did not converge beyond this number of modes.
    Slow(usize),
    /// The mode of this number does not satisfy its equation.
    Inexact(usize),
}

/// The `count` modes of lowest |s|, one of two conjugates, sorted by frequency, then by growth; all, if
/// there are fewer.
pub(super) fn lowest(pencil: &Pencil, count: usize) -> Result<Vec<Pair>, Failure> {
    if !pencil.is_finite() {
        return Err(Failure::NotFinite);
    }
    if count == 0 || pencil.unknowns() == 0 {
        return Ok(Vec::new());
    }
    let n = pencil.unknowns();
    let mut asked = count;
    loop {
        let is_small = n <= SMALL || n <= STILL_SMALL && MANY * asked >= n;
        let (shift, pairs, is_all) = if is_small {
            let (shift, pairs) = dense::spectrum(pencil)?;
            (shift, pairs, true)
        } else {
            arnoldi::spectrum(pencil, asked)?
        };
        let (mut modes, is_checked) = distinct(pencil, shift, pairs, asked)?;
        // Of a motion that drifts two eigenvalues make one mode.
        if modes.len() < count && !(is_all && is_checked) {
            asked *= 2;
            continue;
        }
        modes.truncate(count);
        modes.sort_by(|a, b| a.s.im.total_cmp(&b.s.im).then(a.s.re.total_cmp(&b.s.re)));
        return Ok(modes);
    }
}

/// Refines the pairs of about `count` modes and joins what is one mode; the lowest |s| first. `true` if
/// there were no more.
fn distinct(pencil: &Pencil, shift: f64, mut pairs: Vec<Pair>, count: usize) -> Result<(Vec<Pair>, bool), Failure> {
    // One of two conjugates.
    pairs.retain(|pair| pair.s.im >= 0.0);
    pairs.sort_by(|a, b| order(a.s, b.s));
    let found = pairs.len();
    pairs.truncate(count + 1);
    let mut refinement = Refinement::new(pencil, shift);
    let mut modes = Vec::with_capacity(pairs.len());
    for (index, pair) in pairs.into_iter().enumerate() {
        // The one beyond the count only completes a group.
        match refinement.refined(pair) {
            Some(pair) => modes.push(pair),
            None if index < count => return Err(Failure::Inexact(index)),
            None => {}
        }
    }
    let zeros = |pair: &Pair| pair.s == c64::default();
    let still: Vec<Pair> = modes.iter().filter(|pair| zeros(pair)).cloned().collect();
    modes.retain(|pair| !zeros(pair));
    let mut joined = independent(real_vectors(still));
    while let Some(first) = modes.first().map(|pair| pair.s) {
        let near = |pair: &Pair| (pair.s - first).norm() <= CLOSE * (first.norm() + shift);
        let (group, rest): (Vec<Pair>, Vec<Pair>) = modes.into_iter().partition(near);
        modes = rest;
        joined.extend(one_of_each(group));
    }
    joined.sort_by(|a, b| order(a.s, b.s));
    Ok((joined, found <= count))
}

fn order(a: c64, b: c64) -> std::cmp::Ordering {
    a.norm().total_cmp(&b.norm()).then(a.re.total_cmp(&b.re))
}

/// The pairs of nearly equal eigenvalues. Where their vectors depend on each other (motions that drift, as
/// of a free body) the eigenvalue is a multiple one: the mean is exact where each is not.
fn one_of_each(group: Vec<Pair>) -> Vec<Pair> {
    let size = group.len();
    let mean = group.iter().map(|pair| pair.s).sum::<c64>() / size as f64;
    let mut kept = independent(group);
    if kept.len() < size {
        kept.iter_mut().for_each(|pair| pair.s = mean);
    }
    kept
}

/// Real and imaginary parts of vectors with the eigenvalue zero.
fn real_vectors(pairs: Vec<Pair>) -> Vec<Pair> {
    let both = pairs.into_iter().flat_map(|pair| {
        let part = |part: fn(&c64) -> f64| Pair {
            s: pair.s,
            x: pair.x.iter().map(|value| c64::new(part(value), 0.0)).collect(),
        };
        [part(|value| value.re), part(|value| value.im)]
    });
    both.filter(|pair| length(&pair.x) > INDEPENDENT).collect()
}

/// Those vectors that do not follow from others, the largest rests first, in their order.
fn independent(pairs: Vec<Pair>) -> Vec<Pair> {
    let mut rests: Vec<Vec<c64>> = pairs.iter().map(|pair| pair.x.clone()).collect();
    for rest in &mut rests {
        let size = length(rest);
        rest.iter_mut().for_each(|value| *value /= size);
    }
    let mut kept = vec![false; pairs.len()];
    loop {
        let open = (0..rests.len()).filter(|&index| !kept[index]);
        let Some(next) = open.max_by(|&a, &b| length(&rests[a]).total_cmp(&length(&rests[b])).then(b.cmp(&a))) else {
            break;
        };
        let size = length(&rests[next]);
        if size.is_nan() || size <= INDEPENDENT {
            break;
        }
        kept[next] = true;
        let unit: Vec<c64> = rests[next].iter().map(|value| value / size).collect();
        for (index, rest) in rests.iter_mut().enumerate() {
            if !kept[index] {
                let part: c64 = unit.iter().zip(&*rest).map(|(a, b)| a.conj() * b).sum();
                rest.iter_mut().zip(&unit).for_each(|(value, of)| *value -= part * of);
            }
        }
    }
    let chosen = pairs.into_iter().zip(kept).filter(|(_, kept)| *kept);
    chosen.map(|(pair, _)| pair).collect()
}

fn length(vector: &[c64]) -> f64 {
    vector.iter().map(|value| value.norm_sqr()).sum::<f64>().sqrt()
}

/// Scales the vector such that its first entry of the largest size is 1.
pub(super) fn normalise(x: &mut [c64], lambda: &mut [c64]) {
    let largest = x.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let entry = x.iter().copied().find(|value| value.norm() >= (1.0 - CLOSE) * largest);
    if let Some(entry) = entry.filter(|entry| entry.norm() > 0.0) {
        x.iter_mut().chain(lambda).for_each(|value| *value /= entry);
    }
}

/// Residual inverse iteration with residuals in twice the working precision: what is soft beside
/// something stiff comes out as exact as the entries of the pencil tell it.
struct Refinement<'a> {
    pencil: &'a Pencil,
    shift: f64,
    lu: Lu<c64>,
}

impl<'a> Refinement<'a> {
    fn new(pencil: &'a Pencil, shift: f64) -> Self {
        let lu = pencil.lu();
        Self { pencil, shift, lu }
    }

    /// The refined pair, if it satisfies its equation; an eigenvalue that is zero to round-off is zero.
    fn refined(&mut self, pair: Pair) -> Option<Pair> {
        let (n, is_real) = (self.pencil.unknowns(), pair.s.im == 0.0);
        let (mut s, mut x) = (pair.s, pair.x);
        let mut lambda = vec![c64::default(); self.pencil.constraints()];
        normalise(&mut x, &mut lambda);
        let distance = s.norm().max(self.shift);
        let mut factored = [1.0, -1.7, 3.0].into_iter();
        while self.lu.factor(&self.pencil.at(s + factored.next()? * BESIDE * distance)).is_err() {}
        let mut last = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            let (residual, root) = self.residual(s, &x, &lambda);
            s = if is_real { c64::new(root.re, 0.0) } else { root };
            let mut change = residual;
            self.lu.solve(&mut change);
            let sizes = x.iter().map(|value| value.norm());
            let largest = sizes.fold(0.0, f64::max);
            let size = change[..n].iter().map(|value| value.norm()).fold(0.0, f64::max) / largest;
            if !size.is_finite() {
                return None;
            }
            x.iter_mut().chain(&mut lambda).zip(&change).for_each(|(value, change)| *value -= change);
            normalise(&mut x, &mut lambda);
            if size <= ROUND_OFF || size > STAGNANT * last {
                break;
            }
            last = size;
        }
        // The multipliers belong to the vector before they are judged.
        let (residual, root) = self.residual(s, &x, &lambda);
        s = if is_real { c64::new(root.re, 0.0) } else { root };
        if s.norm() <= CLOSE * self.shift && self.is_exact(c64::default(), &x, &lambda) {
            s = c64::default();
        }
        let _ = residual;
        self.is_exact(s, &x, &lambda).then_some(Pair { s, x })
    }

    fn is_exact(&self, s: c64, x: &[c64], lambda: &[c64]) -> bool {
        let products = self.pencil.products(x, lambda);
        let n = self.pencil.unknowns();
        let residual: Vec<c64> = (0..n)
            .map(|i| products.stiffness[i] + s * (products.damping[i] + s * products.mass[i]))
            .collect();
        let tied = products.constraints.iter().all(|value| value.norm() <= ACCEPTED);
        let error = self.pencil.backward_error(s, &residual, x, lambda);
        tied && error <= ACCEPTED && residual.iter().all(|value| value.is_finite())
    }

    /// The eigenvalue next to `s` that fits the vector, `x^H (K + s C + s^2 M) x = 0`, and the residual with
    /// it.
    fn residual(&self, s: c64, x: &[c64], lambda: &[c64]) -> (Vec<c64>, c64) {
        let products = self.pencil.products(x, lambda);
        let along = |image: &[c64]| x.iter().zip(image).map(|(x, image)| x.conj() * image).sum::<c64>();
        let parts = [&products.mass, &products.damping, &products.stiffness].map(|image| along(image));
        let root = nearest_root(parts, s);
        let dynamic = (0..x.len()).map(|i| products.stiffness[i] + root * (products.damping[i] + root * products.mass[i]));
        (dynamic.chain(products.constraints.iter().copied()).collect(), root)
    }
}

/// The root next to `s` of `m s^2 + c s + k`; `s` where there is none.
fn nearest_root([m, c, k]: [c64; 3], s: c64) -> c64 {
    let root = (c * c - 4.0 * m * k).sqrt();
    let sum = if (c.conj() * root).re >= 0.0 { c + root } else { c - root };
    let half = -0.5 * sum;
    let candidates = [half / m, k / half];
    let finite = candidates.into_iter().filter(|root| root.is_finite());
    finite.min_by(|a, b| (a - s).norm().total_cmp(&(b - s).norm())).unwrap_or(s)
}
