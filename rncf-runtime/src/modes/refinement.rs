//! Eigenpairs as exact as the entries of the pencil tell them, checked against it.

use super::pair::{CLOSE, Pair, normalise};
use super::pencil::{Pencil, Products};
use crate::linalg::{Lu, c64, general_eigen, scattered, solve_full};

/// Most refinements of a pair.
const REFINEMENTS: usize = 12;
/// Distance of the factored from the wanted eigenvalue in refinements, relative; and where several
/// eigenvalues are one.
const BESIDE: f64 = 1e-4;
const TOUCHING: f64 = 1e-7;
/// Changes of the vector that are round-off, and shrinkage that round-off does not reach.
const ROUND_OFF: f64 = 1e-14;
const STAGNANT: f64 = 0.5;
/// Largest residual of a pair that is returned, relative to the terms of its equation.
const ACCEPTED: f64 = 1e-10;
/// The same where the eigenvalue is a multiple one with too few vectors: their neighbourhood is as flat.
const ACCEPTED_MULTIPLE: f64 = 1e-5;
/// Inverse iterations for a space of vectors.
const INVERSE_ITERATIONS: usize = 4;
/// Part of the shift beside which zeros are looked for.
const STILL: f64 = 1e-2;
/// Multiple of an eigenvalue that a first guess of it may be.
const GUESSED: f64 = 2.0;
/// Vectors that inverse iteration starts from for each one that is looked for.
const STARTS: usize = 3;
/// Part of a unit vector that makes it new beside others of the same eigenvalue.
const INDEPENDENT: f64 = 1e-2;

/// Residual inverse iteration with residuals in twice the working precision: what is soft beside
/// something stiff comes out as exact as the entries of the pencil tell it.
pub(super) struct Refinement<'a> {
    pencil: &'a Pencil,
    shift: f64,
    lu: Lu<c64>,
}

impl<'a> Refinement<'a> {
    pub fn new(pencil: &'a Pencil, shift: f64) -> Self {
        let lu = pencil.lu();
        Self { pencil, shift, lu }
    }

    /// The refined pairs of nearly equal eigenvalues, if they satisfy their equations. Where their vectors
    /// depend on each other they are found anew; if there are too few of them (motions that drift, as
    /// of a free body) the eigenvalue is a multiple one: the mean is exact where each is not.
    pub fn group(&mut self, group: Vec<Pair>) -> Option<Vec<Pair>> {
        let size = group.len();
        if size == 1 {
            return group.into_iter().map(|pair| self.refined(pair)).collect();
        }
        let mean = group.iter().map(|pair| pair.s).sum::<c64>() / size as f64;
        let refined = group.into_iter().filter_map(|pair| self.refined(pair)).collect();
        let apart = independent(refined);
        if apart.len() == size {
            return Some(apart);
        }
        self.factor(mean, TOUCHING)?;
        // Some vectors without order are nearly alike: more of them than are needed.
        let vectors = self.eigenspace(STARTS * size, |pencil, x, image| {
            let products = pencil.products(x, &[]);
            for (place, value) in image.iter_mut().enumerate() {
                *value = products.damping[place] + 2.0 * mean * products.mass[place];
            }
        });
        // There is none where all that it starts from vanishes, as of what is damped critically by itself.
        let vectors = vectors.unwrap_or_default();
        let mut pairs = independent(vectors.into_iter().map(|x| Pair { s: mean, x }).collect());
        pairs.truncate(size);
        if pairs.len() == size {
            let refined: Vec<Pair> = pairs.iter().filter_map(|pair| self.refined(pair.clone())).collect();
            if refined.len() == size {
                return Some(refined);
            }
        }
        let exact = |pair: &Pair| {
            let lambda = self.multipliers(pair);
            self.is_exact(pair.s, &pair.x, &lambda, ACCEPTED_MULTIPLE)
        };
        pairs.retain(exact);
        if pairs.len() >= apart.len() {
            return (!pairs.is_empty()).then_some(pairs);
        }
        // Inverse iteration prefers what drifts to what does not. These satisfy their equations beside the mean, which alone knows their growth.
        let at = |s: c64| c64::new(mean.re, s.im);
        Some(apart.into_iter().map(|Pair { s, x }| Pair { s: at(s), x }).collect())
    }

    /// Motions with the eigenvalue zero, at most `count` of them: the null vectors of K.
    pub fn still(&mut self, count: usize) -> Vec<Pair> {
        let beside = STILL * self.shift;
        if count == 0
            || self
                .lu
                .factor(&self.pencil.without_damping(c64::new(beside, 0.0)))
                .is_err()
        {
            return Vec::new();
        }
        let vectors = self.eigenspace(count, |pencil, x, image| image.copy_from_slice(&pencil.inertia(x)));
        let lowest = CLOSE * self.shift;
        let is_still = |x: &Vec<c64>| self.pencil.is_still(x, lowest);
        let beside = vectors
            .unwrap_or_default()
            .into_iter()
            .filter(is_still)
            .filter_map(|x| self.pencil.beside_known(x));
        let zero = |x| Pair { s: c64::default(), x };
        let mut found: Vec<Pair> = self.pencil.known_still().map(zero).collect();
        found.extend(independent(beside.map(zero).collect()));
        found.truncate(count);
        found
    }

    /// What motions without stiffness do apart from lying still, where that is slow (up to this |s|): a damper, or a torque that depends on the speed, lets
    /// their speed die away or grow, `(s M + C) x = 0`. Of those that neither resists, this is zero as well, and no mode of its own.
    pub fn running(&mut self, still: &[Pair], slow: f64) -> Vec<Pair> {
        let count = still.len();
        let images: Vec<[Vec<c64>; 2]> = still
            .iter()
            .map(|pair| {
                let Products { mass, damping, .. } = self.pencil.products(&pair.x, &[]);
                [mass, damping]
            })
            .collect();
        let [mass, damping] = [0, 1].map(|which| -> Vec<f64> {
            let form = |place: usize| {
                let image = &images[place % count][which];
                let parts = still[place / count].x.iter().zip(image);
                parts.map(|(x, image)| (x.conj() * image).re).sum()
            };
            (0..count * count).map(form).collect()
        });
        let Some([rates]) = solve_full(count, &mass, [&damping]) else {
            return Vec::new();
        };
        let against: Vec<f64> = rates.iter().map(|rate| -rate).collect();
        let Ok((values, vectors)) = general_eigen(count, &against) else {
            return Vec::new();
        };
        let zero = CLOSE * self.shift;
        let guessed = values.into_iter().zip(vectors);
        let guessed = guessed.filter(|(s, _)| s.norm() > zero && s.norm() <= GUESSED * slow && s.im >= 0.0);
        let mut found = Vec::new();
        for (s, parts) in guessed {
            let mut x = vec![c64::default(); self.pencil.unknowns()];
            for (part, pair) in parts.iter().zip(still) {
                x.iter_mut().zip(&pair.x).for_each(|(sum, value)| *sum += part * value);
            }
            let refined = self.refined(Pair { s, x });
            found.extend(refined.filter(|pair| pair.s.norm() > zero && pair.s.norm() <= slow));
        }
        found
    }

    /// Inverse iteration with the present factors from vectors without order, real where the factors are;
    /// `weight` is what an image is made of.
    fn eigenspace(&mut self, count: usize, weight: impl Fn(&Pencil, &[c64], &mut [c64])) -> Option<Vec<Vec<c64>>> {
        let n = self.pencil.unknowns();
        let mut vectors = Vec::with_capacity(count);
        for start in 0..count {
            let mut x: Vec<c64> = scattered(n, start)
                .into_iter()
                .map(|value| c64::new(value, 0.0))
                .collect();
            for _ in 0..INVERSE_ITERATIONS {
                let mut image = vec![c64::default(); n + self.pencil.constraints()];
                weight(self.pencil, &x, &mut image[..n]);
                self.lu.solve(&mut image);
                image.truncate(n);
                normalise(&mut image, &mut []);
                x = image;
            }
            if !x.iter().all(|value| value.is_finite()) {
                return None;
            }
            vectors.push(x);
        }
        Some(vectors)
    }

    /// Multipliers that fit a vector.
    fn multipliers(&self, pair: &Pair) -> Vec<c64> {
        let none = vec![c64::default(); self.pencil.constraints()];
        let mut lu: Lu<c64> = self.pencil.lu();
        let (mut change, _) = self.pencil.residual_at(pair.s, &pair.x, &none);
        let beside = BESIDE * pair.s.norm().max(self.shift);
        match lu.factor(&self.pencil.at(pair.s + beside)) {
            Ok(()) => lu.solve(&mut change),
            Err(_) => return none,
        }
        change[self.pencil.unknowns()..].iter().map(|value| -value).collect()
    }

    /// Factors beside an eigenvalue.
    fn factor(&mut self, s: c64, part: f64) -> Option<()> {
        let distance = part * s.norm().max(self.shift);
        let mut places = [1.0, -1.7, 3.0].into_iter();
        places
            .find(|place| self.lu.factor(&self.pencil.at(s + place * distance)).is_ok())
            .map(|_| ())
    }

    /// The refined pair, if it satisfies its equation. Where others are nearer than the shift, as those of motions that damping alone resists are to each
    /// other, a shift that is nearer tells them apart.
    fn refined(&mut self, pair: Pair) -> Option<Pair> {
        self.refined_beside(pair.clone(), BESIDE)
            .or_else(|| self.refined_beside(pair, TOUCHING))
    }

    fn refined_beside(&mut self, pair: Pair, beside: f64) -> Option<Pair> {
        let (n, is_real) = (self.pencil.unknowns(), pair.s.im == 0.0);
        let (mut s, mut x) = (pair.s, pair.x);
        let mut lambda = vec![c64::default(); self.pencil.constraints()];
        normalise(&mut x, &mut lambda);
        self.factor(s, beside)?;
        let mut last = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            let (mut change, root) = self.pencil.residual(s, &x, &lambda);
            s = if is_real { c64::new(root.re, 0.0) } else { root };
            self.lu.solve(&mut change);
            let size = change[..n].iter().map(|value| value.norm()).fold(0.0, f64::max);
            if !change.iter().all(|value| value.is_finite()) {
                return None;
            }
            x.iter_mut()
                .chain(&mut lambda)
                .zip(&change)
                .for_each(|(value, change)| *value -= change);
            normalise(&mut x, &mut lambda);
            if size <= ROUND_OFF || size > STAGNANT * last {
                break;
            }
            last = size;
        }
        let (_, root) = self.pencil.residual(s, &x, &lambda);
        s = if is_real { c64::new(root.re, 0.0) } else { root };
        self.is_exact(s, &x, &lambda, ACCEPTED).then_some(Pair { s, x })
    }

    fn is_exact(&self, s: c64, x: &[c64], lambda: &[c64], accepted: f64) -> bool {
        let (residual, _) = self.pencil.residual_at(s, x, lambda);
        let (dynamic, constraints) = residual.split_at(x.len());
        let is_tied = constraints.iter().all(|value| value.norm() <= accepted);
        let is_finite = residual.iter().all(|value| value.is_finite());
        is_tied && is_finite && self.pencil.backward_error(s, dynamic, x, lambda) <= accepted
    }
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
