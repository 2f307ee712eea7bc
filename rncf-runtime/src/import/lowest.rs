//! Lowest modes of a body that is free or held: `K x = w^2 M x`, where K may leave it the rigid motions that are given, and M
//! may be singular.

use super::files::Sparse;
use crate::linalg::{Lu, Pattern, lowest_modes, symmetric_eigen};

/// Up to this number of unknowns all modes are found at once.
const DENSE: usize = 400;
/// Further vectors of the iteration, and most of its steps.
const FURTHER: usize = 8;
const MOST_STEPS: usize = 200;
/// Relative change of the squares of the frequencies that ends it.
const SETTLED: f64 = 1e-13;

/// Modes of unit modal mass.
#[derive(Clone, Debug, Default)]
pub struct Lowest {
    /// rad/s, ascending.
    pub frequencies: Vec<f64>,
    pub vectors: Vec<Vec<f64>>,
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn add_scaled(x: &mut [f64], factor: f64, y: &[f64]) {
    x.iter_mut().zip(y).for_each(|(x, y)| *x += factor * y);
}

/// Makes vectors orthonormal in the mass matrix, twice against cancellation; `None`: one has no mass.
pub(super) fn orthonormal(mass: &Sparse, mut vectors: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    for _ in 0..2 {
        for index in 0..vectors.len() {
            let (before, rest) = vectors.split_at_mut(index);
            let momentum = mass.times(&rest[0]);
            for other in before.iter() {
                let part = dot(other, &momentum);
                add_scaled(&mut rest[0], -part, other);
            }
            let square = dot(&rest[0], &mass.times(&rest[0]));
            if square.is_nan() || square <= 0.0 {
                return None;
            }
            rest[0].iter_mut().for_each(|x| *x /= square.sqrt());
        }
    }
    Some(vectors)
}

/// Unknowns at which holding them holds the body and no more: by elimination with complete pivoting.
pub(super) fn supports(rigid: &[Vec<f64>]) -> Vec<usize> {
    let mut left: Vec<Vec<f64>> = rigid.to_vec();
    let mut found = Vec::new();
    while !left.is_empty() {
        let size = |vector: &Vec<f64>, at: usize| vector[at].abs();
        let places = (0..left.len()).flat_map(|which| (0..left[which].len()).map(move |at| (which, at)));
        let Some((which, at)) = places.max_by(|a, b| size(&left[a.0], a.1).total_cmp(&size(&left[b.0], b.1))) else {
            break;
        };
        let pivot = left.swap_remove(which);
        for vector in &mut left {
            let factor = vector[at] / pivot[at];
            add_scaled(vector, -factor, &pivot);
        }
        found.push(at);
    }
    found.sort_unstable();
    found
}

/// The `count` lowest modes with a frequency. `rigid` are the motions that meet no stiffness, orthonormal in the mass.
///
/// # Errors
/// There is another motion without stiffness, or one without mass among the lowest.
pub(super) fn lowest(stiffness: &Sparse, mass: &Sparse, rigid: &[Vec<f64>], count: usize) -> Option<Lowest> {
    let size = stiffness.size();
    let held = supports(rigid);
    let active: Vec<usize> = (0..size).filter(|at| held.binary_search(at).is_err()).collect();
    let momenta: Vec<Vec<f64>> = rigid.iter().map(|vector| mass.times(vector)).collect();
    let count = count.min(active.len());
    let (frequencies, reduced) = if active.len() <= DENSE {
        let n = active.len();
        let (mut k, mut m) = (vec![0.0; n * n], vec![0.0; n * n]);
        let mut place = vec![None; size];
        active.iter().enumerate().for_each(|(at, &full)| place[full] = Some(at));
        for (at, &full) in active.iter().enumerate() {
            for (matrix, dense) in [(stiffness, &mut k), (mass, &mut m)] {
                for &(column, value) in &matrix.rows[full] {
                    if let Some(column) = place[column] {
                        dense[at * n + column] += value;
                    }
                }
            }
            for momentum in &momenta {
                for (other, &column) in active.iter().enumerate() {
                    m[at * n + other] -= momentum[full] * momentum[column];
                }
            }
        }
        // Both are symmetric but for the round-off of their file.
        for matrix in [&mut k, &mut m] {
            for row in 0..n {
                for column in 0..row {
                    let mean = 0.5 * (matrix[row * n + column] + matrix[column * n + row]);
                    (matrix[row * n + column], matrix[column * n + row]) = (mean, mean);
                }
            }
        }
        let found = lowest_modes(n, &k, &m, count).ok()?;
        (found.frequencies, found.vectors)
    } else {
        iterated(stiffness, mass, &active, &momenta, count)?
    };
    // Back to all unknowns, and without the rigid motions that holding the supports brought.
    let whole = |vector: Vec<f64>| {
        let mut full = vec![0.0; size];
        active.iter().zip(vector).for_each(|(&at, value)| full[at] = value);
        for _ in 0..2 {
            for (vector, momentum) in rigid.iter().zip(&momenta) {
                let part = dot(momentum, &full);
                add_scaled(&mut full, -part, vector);
            }
        }
        full
    };
    Some(Lowest {
        frequencies,
        vectors: reduced.into_iter().map(whole).collect(),
    })
}

/// Factors of the rows and columns of a symmetric matrix that are active.
pub(super) fn factored(matrix: &Sparse, active: &[usize]) -> Option<Lu<f64>> {
    let mut place = vec![None; matrix.size()];
    active.iter().enumerate().for_each(|(at, &full)| place[full] = Some(at));
    let entries = || {
        active.iter().enumerate().flat_map(|(at, &full)| {
            let place = &place;
            let own = matrix.rows[full].iter();
            own.filter_map(move |&(column, value)| Some((at, place[column]?, value)))
        })
    };
    let diagonal = (0..active.len()).map(|at| (at, at));
    let pattern = Pattern::new(
        active.len(),
        active.len(),
        entries()
            .map(|(row, column, _)| (row, column))
            .chain(diagonal)
            .collect::<Vec<_>>(),
    );
    let mut values = vec![0.0; pattern.entries()];
    for (row, column, value) in entries() {
        if let Some(entry) = pattern.find(row, column) {
            values[entry] += value;
        }
    }
    let mut factors = Lu::new(&pattern);
    factors.factor(&values).ok()?;
    Some(factors)
}

/// By iteration of a subspace with the inverse of K.
fn iterated(
    stiffness: &Sparse,
    mass: &Sparse,
    active: &[usize],
    momenta: &[Vec<f64>],
    count: usize,
) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
    let n = active.len();
    let width = (count + count.max(FURTHER)).min(n);
    let mut factors = factored(stiffness, active)?;
    let inertia = |x: &[f64]| -> Vec<f64> {
        let mut full = vec![0.0; mass.size()];
        active.iter().zip(x).for_each(|(&at, value)| full[at] = *value);
        let mut product = mass.times(&full);
        for momentum in momenta {
            let part = dot(momentum, &full);
            add_scaled(&mut product, -part, momentum);
        }
        active.iter().map(|&at| product[at]).collect()
    };
    // Numbers without a pattern, the same in every run.
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut number = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let mut vectors: Vec<Vec<f64>> = (0..width).map(|_| (0..n).map(|_| number()).collect()).collect();
    let mut before: Vec<f64> = Vec::new();
    for _ in 0..MOST_STEPS {
        let loads: Vec<Vec<f64>> = vectors.iter().map(|vector| inertia(vector)).collect();
        let images: Vec<Vec<f64>> = loads
            .iter()
            .map(|load| {
                let mut image = load.clone();
                factors.solve(&mut image);
                image
            })
            .collect();
        let momenta: Vec<Vec<f64>> = images.iter().map(|image| inertia(image)).collect();
        let gram = |left: &[Vec<f64>], right: &[Vec<f64>]| -> Vec<f64> {
            let pairs = (0..width * width).map(|at| (at / width, at % width));
            pairs
                .map(|(i, j)| 0.5 * (dot(&left[i], &right[j]) + dot(&left[j], &right[i])))
                .collect()
        };
        let (k, m) = (gram(&images, &loads), gram(&images, &momenta));
        let scaled = scaled_modes(width, &k, &m)?;
        vectors = scaled
            .iter()
            .map(|(_, combination)| {
                let mut sum = vec![0.0; n];
                combination
                    .iter()
                    .zip(&images)
                    .for_each(|(factor, image)| add_scaled(&mut sum, *factor, image));
                sum
            })
            .collect();
        let squares: Vec<f64> = scaled.iter().take(count).map(|(square, _)| *square).collect();
        let is_settled = before.len() == squares.len()
            && squares
                .iter()
                .zip(&before)
                .all(|(now, before)| (now - before).abs() <= SETTLED * now);
        before = squares;
        if is_settled {
            vectors.truncate(count);
            return Some((before.into_iter().map(f64::sqrt).collect(), vectors));
        }
    }
    None
}

/// Squares of frequencies and combinations of unit mass of the small problem; its vectors may be nearly dependent.
fn scaled_modes(size: usize, stiffness: &[f64], mass: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
    let diagonal: Vec<f64> = (0..size)
        .map(|at| stiffness[at * size + at].max(f64::MIN_POSITIVE).sqrt())
        .collect();
    let scaled = |matrix: &[f64]| -> Vec<f64> {
        let entries = matrix.iter().enumerate();
        entries
            .map(|(at, value)| value / (diagonal[at / size] * diagonal[at % size]))
            .collect()
    };
    let (k, m) = (scaled(stiffness), scaled(mass));
    let (values, vectors) = symmetric_eigen(size, &k).ok()?;
    let most = values.last().copied().unwrap_or(0.0);
    let basis: Vec<Vec<f64>> = values
        .iter()
        .zip(vectors)
        .filter(|(value, _)| **value > 1e-13 * most)
        .map(|(value, vector)| vector.iter().map(|x| x / value.sqrt()).collect())
        .collect();
    let count = basis.len();
    let image = |x: &Vec<f64>| -> Vec<f64> { m.chunks_exact(size).map(|row| dot(row, x)).collect() };
    let images: Vec<Vec<f64>> = basis.iter().map(image).collect();
    let small: Vec<f64> = (0..count * count)
        .map(|at| dot(&basis[at / count], &images[at % count]))
        .collect();
    let (values, vectors) = symmetric_eigen(count, &small).ok()?;
    let found = values.into_iter().zip(vectors).rev().filter(|(value, _)| *value > 0.0);
    let found = found.map(|(value, vector)| {
        let mut sum = vec![0.0; size];
        vector
            .iter()
            .zip(&basis)
            .for_each(|(factor, basis)| add_scaled(&mut sum, *factor, basis));
        let unit = sum.iter().zip(&diagonal).map(|(x, d)| x / (d * value.sqrt())).collect();
        (1.0 / value, unit)
    });
    Some(found.collect())
}
