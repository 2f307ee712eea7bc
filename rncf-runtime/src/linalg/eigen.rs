//! Dense symmetric problems of moderate size: Cholesky factors, eigenvalues, and the lowest natural
//! modes of a stiffness and a mass matrix. All matrices are square, rows first.

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// Eigenvalues that differ relatively by less than this belong to one subspace of modes.
const EQUAL: f64 = 1e-6;
/// Part of the largest mass by which a mass may be negative, as that of files is by round-off.
const NEGATIVE: f64 = 1e-7;
/// Part of the largest mass below which there is none.
const MASSLESS: f64 = 1e-14;
/// A pivot below this part of its diagonal entry is round-off.
const PIVOT: f64 = 1e-14;

/// A matrix is not positive definite, or its eigenvalues were not found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Indefinite;

/// The factor of `A = L L^T`.
#[derive(Clone, Debug)]
pub struct Cholesky {
    size: usize,
    lower: Vec<f64>,
}

impl Cholesky {
    /// Factors a symmetric positive definite matrix of which the lower triangle is read.
    ///
    /// # Errors
    /// A pivot is not positive beyond round-off.
    pub fn new(size: usize, matrix: &[f64]) -> Result<Self, Indefinite> {
        let mut lower = vec![0.0; size * size];
        for i in 0..size {
            for j in 0..=i {
                let (row, other) = (&lower[i * size..i * size + j], &lower[j * size..j * size + j]);
                let sum: f64 = row.iter().zip(other).map(|(a, b)| a * b).sum();
                let rest = matrix[i * size + j] - sum;
                lower[i * size + j] = if i != j {
                    rest / lower[j * size + j]
                } else if rest > PIVOT * matrix[i * size + i] {
                    rest.sqrt()
                } else {
                    return Err(Indefinite);
                };
            }
        }
        Ok(Self { size, lower })
    }

    /// `x = L^-1 x`
    fn forward(&self, x: &mut [f64]) {
        for i in 0..self.size {
            let row = &self.lower[i * self.size..];
            let sum: f64 = row[..i].iter().zip(&*x).map(|(a, b)| a * b).sum();
            x[i] = (x[i] - sum) / row[i];
        }
    }

    /// `x = L^-T x`
    fn backward(&self, x: &mut [f64]) {
        for i in (0..self.size).rev() {
            let row = &self.lower[i * self.size..];
            x[i] /= row[i];
            let value = x[i];
            for (other, entry) in x[..i].iter_mut().zip(row) {
                *other -= entry * value;
            }
        }
    }

    /// `x = A^-1 x`
    pub fn solve(&self, x: &mut [f64]) {
        self.forward(x);
        self.backward(x);
    }
}

/// Eigenvalues of a symmetric matrix, ascending, and their orthonormal vectors.
///
/// # Errors
/// Not found, as for entries that are not finite.
pub fn symmetric_eigen(size: usize, matrix: &[f64]) -> Result<(Vec<f64>, Vec<Vec<f64>>), Indefinite> {
    if size == 0 {
        return Ok((Vec::new(), Vec::new()));
    }
    let dense = Mat::from_fn(size, size, |i, j| 0.5 * (matrix[i * size + j] + matrix[j * size + i]));
    let eigen = dense.self_adjoint_eigen(Side::Lower).map_err(|_| Indefinite)?;
    let values = (0..size).map(|i| eigen.S()[i]).collect();
    let vectors = (0..size)
        .map(|column| (0..size).map(|row| eigen.U()[(row, column)]).collect())
        .collect();
    Ok((values, vectors))
}

/// `A^-1 B` of two full B, or `None` where A is singular or not finite.
pub fn solve_full<const N: usize>(size: usize, matrix: &[f64], right: [&[f64]; N]) -> Option<[Vec<f64>; N]> {
    let factor = Mat::from_fn(size, size, |i, j| matrix[i * size + j]).partial_piv_lu();
    let solutions = right.map(|right| {
        let solution = factor.solve(Mat::from_fn(size, size, |i, j| right[i * size + j]));
        let place = |place: usize| solution[(place / size, place % size)];
        (0..size * size).map(place).collect::<Vec<f64>>()
    });
    let finite = solutions.iter().flatten().all(|value| value.is_finite());
    finite.then_some(solutions)
}

/// Number of negative eigenvalues of a symmetric matrix that need not be definite, of which the lower
/// triangle is read: its signature by pivots of one or two rows (Bunch and Kaufman).
///
/// # Errors
/// Entries are not finite.
pub fn negative_eigenvalues(size: usize, matrix: &[f64]) -> Result<usize, Indefinite> {
    if !matrix.iter().all(|value| value.is_finite()) {
        return Err(Indefinite);
    }
    if size == 0 {
        return Ok(0);
    }
    let factor = Mat::from_fn(size, size, |i, j| matrix[i * size + j]).lblt(Side::Lower);
    let (diagonal, beside) = (factor.B_diag(), factor.B_subdiag());
    let (mut negative, mut place) = (0, 0);
    while place < size {
        if place + 1 < size && beside[place] != 0.0 {
            // Of a pivot of two rows one eigenvalue is negative, or both have the sign of the trace.
            let (a, b, c) = (diagonal[place], beside[place], diagonal[place + 1]);
            negative += match a * c - b * b {
                product if product < 0.0 => 1,
                _ if a + c < 0.0 => 2,
                _ => 0,
            };
            place += 2;
        } else {
            negative += usize::from(diagonal[place] < 0.0);
            place += 1;
        }
    }
    Ok(negative)
}

/// Solutions of `K x = omega^2 M x`.
#[derive(Clone, Debug)]
pub struct NaturalModes {
    /// omega, rad/s where K and M are in SI, ascending.
    pub frequencies: Vec<f64>,
    /// `x^T M x = 1`; the largest component is positive.
    pub vectors: Vec<Vec<f64>>,
}

/// The `count` lowest solutions, both matrices positive definite. Solved as `M x = omega^-2 K x`: the
/// lowest frequencies come out as exact as the stiffest direction of K permits.
///
/// # Errors
/// K or M is not positive definite.
pub fn natural_modes(size: usize, stiffness: &[f64], mass: &[f64], count: usize) -> Result<NaturalModes, Indefinite> {
    modes_with_mass(size, stiffness, mass, count, true)
}

/// The same where M is only semidefinite: what has no mass has no frequency, and is not among the lowest.
///
/// # Errors
/// K is not positive definite, or M is indefinite.
pub fn lowest_modes(size: usize, stiffness: &[f64], mass: &[f64], count: usize) -> Result<NaturalModes, Indefinite> {
    modes_with_mass(size, stiffness, mass, count, false)
}

fn modes_with_mass(
    size: usize,
    stiffness: &[f64],
    mass: &[f64],
    count: usize,
    is_definite: bool,
) -> Result<NaturalModes, Indefinite> {
    let factor = Cholesky::new(size, stiffness)?;
    if is_definite {
        Cholesky::new(size, mass)?;
    }
    // L^-1 M L^-T
    let mut flexibility = mass.to_vec();
    for _ in 0..2 {
        for row in flexibility.chunks_exact_mut(size.max(1)) {
            factor.forward(row);
        }
        transpose(size, &mut flexibility);
    }
    let (values, mut vectors) = symmetric_eigen(size, &flexibility)?;
    vectors.reverse();
    let inverse: Vec<f64> = values.into_iter().rev().collect();
    let same = |first: usize| {
        let is_same = |&other: &usize| inverse[other] > inverse[first] * (1.0 - EQUAL);
        (first..size).take_while(is_same).last().unwrap_or(first)
    };
    if let (Some(least), Some(most)) = (inverse.last(), inverse.first())
        && *least < -NEGATIVE * most
    {
        return Err(Indefinite);
    }
    let massive = inverse.iter().take_while(|own| **own > MASSLESS * inverse[0]).count();
    let known = if is_definite { size } else { massive };
    let count = count.min(known);
    let needed = if count == 0 {
        0
    } else {
        (same(count - 1) + 1).min(known)
    };
    vectors.truncate(needed);
    for vector in &mut vectors {
        factor.backward(vector);
    }
    orthonormalise(size, mass, &mut vectors)?;
    let mut first = 0;
    while first < count {
        let last = same(first).min(needed - 1);
        align(&mut vectors[first..=last]);
        first = last + 1;
    }
    vectors.truncate(count);
    let frequency = |vector: &Vec<f64>| product(size, stiffness, vector, vector).sqrt();
    Ok(NaturalModes {
        frequencies: vectors.iter().map(frequency).collect(),
        vectors,
    })
}

/// Makes the vectors orthonormal in the mass matrix, in their order; twice, against cancellation.
fn orthonormalise(size: usize, mass: &[f64], vectors: &mut [Vec<f64>]) -> Result<(), Indefinite> {
    for _ in 0..2 {
        for index in 0..vectors.len() {
            let (before, rest) = vectors.split_at_mut(index);
            let weighted = times(size, mass, &rest[0]);
            for other in before {
                let part: f64 = other.iter().zip(&weighted).map(|(a, b)| a * b).sum();
                rest[0].iter_mut().zip(&*other).for_each(|(x, y)| *x -= part * y);
            }
            let square = product(size, mass, &rest[0], &rest[0]);
            if square.is_nan() || square <= 0.0 {
                return Err(Indefinite);
            }
            rest[0].iter_mut().for_each(|x| *x /= square.sqrt());
        }
    }
    Ok(())
}

/// Vectors of equal frequency are free up to a rotation among them, and a single one up to its sign:
/// each in turn takes all of the component that is largest in what is left, which is positive. Modes
/// thus do not depend on round-off.
fn align(vectors: &mut [Vec<f64>]) {
    for index in 0..vectors.len() {
        let rest = &mut vectors[index..];
        let square = |row: usize| rest.iter().map(|vector| vector[row].powi(2)).sum::<f64>();
        let size = rest[0].len();
        let most = (0..size).map(square).fold(0.0, f64::max);
        let Some(row) = (0..size).find(|&row| square(row) >= (1.0 - EQUAL) * most) else {
            return;
        };
        // Householder reflection that sends the row to a multiple of the first unit vector.
        let mut normal: Vec<f64> = rest.iter().map(|vector| vector[row]).collect();
        let length = square(row).sqrt();
        normal[0] += if normal[0] < 0.0 { -length } else { length };
        let norm: f64 = normal.iter().map(|x| x * x).sum();
        for component in 0..size {
            let part: f64 = rest.iter().zip(&normal).map(|(vector, n)| vector[component] * n).sum();
            for (vector, n) in rest.iter_mut().zip(&normal) {
                vector[component] -= 2.0 * part * n / norm;
            }
        }
        if rest[0][row] < 0.0 {
            rest[0].iter_mut().for_each(|x| *x = -*x);
        }
    }
}

fn transpose(size: usize, matrix: &mut [f64]) {
    for i in 0..size {
        for j in 0..i {
            matrix.swap(i * size + j, j * size + i);
        }
    }
}

/// `A x`
pub fn times(size: usize, matrix: &[f64], x: &[f64]) -> Vec<f64> {
    let row = |row: &[f64]| row.iter().zip(x).map(|(a, b)| a * b).sum();
    matrix.chunks_exact(size.max(1)).map(row).collect()
}

/// `x^T A y`
pub fn product(size: usize, matrix: &[f64], x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(times(size, matrix, y)).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stiffness and mass matrix of a chain of `n` masses between walls.
    fn chain(n: usize) -> (Vec<f64>, Vec<f64>) {
        let (mut k, mut m) = (vec![0.0; n * n], vec![0.0; n * n]);
        for i in 0..n {
            (k[i * n + i], m[i * n + i]) = (2.0, 1.0);
            if i > 0 {
                (k[i * n + i - 1], k[(i - 1) * n + i]) = (-1.0, -1.0);
            }
        }
        (k, m)
    }

    #[test]
    fn a_chain_has_the_frequencies_of_theory() {
        let (k, m) = chain(12);
        let modes = natural_modes(12, &k, &m, 12).unwrap();
        for (index, frequency) in modes.frequencies.iter().enumerate() {
            let exact = 2.0 * ((index + 1) as f64 * std::f64::consts::PI / 26.0).sin();
            assert!((frequency - exact).abs() < 1e-13, "{index}: {frequency} {exact}");
        }
        for i in 0..12 {
            for j in 0..12 {
                let unit = if i == j { 1.0 } else { 0.0 };
                let scalar = product(12, &m, &modes.vectors[i], &modes.vectors[j]);
                assert!((scalar - unit).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn equal_frequencies_have_modes_along_the_components() {
        // Two equal chains that do not know of each other.
        let n = 3;
        let (k, _) = chain(n);
        let mut both = vec![0.0; 4 * n * n];
        let mut m = both.clone();
        for i in 0..n {
            for j in 0..n {
                for (a, b) in [(0, 0), (1, 1)] {
                    both[(2 * i + a) * 2 * n + 2 * j + b] = k[i * n + j];
                }
            }
        }
        (0..2 * n).for_each(|i| m[i * 2 * n + i] = 1.0);
        let modes = natural_modes(2 * n, &both, &m, 2).unwrap();
        let small = |vector: &[f64], first: usize| (first..2 * n).step_by(2).all(|i| vector[i].abs() < 1e-14);
        assert!(small(&modes.vectors[0], 1) && small(&modes.vectors[1], 0), "{modes:?}");
        assert!(modes.vectors[0][2] > 0.0 && modes.vectors[1][3] > 0.0);
    }

    #[test]
    fn signs_of_eigenvalues_are_counted() {
        // Eigenvalues of the chain without walls, shifted: 2 - 2 cos(k pi / n) - shift.
        let n = 9;
        let (mut k, _) = chain(n);
        (k[0], k[n * n - 1]) = (1.0, 1.0);
        for (shift, negative) in [(-0.1, 0), (0.1, 1), (0.3, 2), (3.5, 7), (5.0, 9)] {
            let mut shifted = k.clone();
            (0..n).for_each(|i| shifted[i * n + i] -= shift);
            assert_eq!(negative_eigenvalues(n, &shifted), Ok(negative), "{shift}");
        }
        assert_eq!(negative_eigenvalues(2, &[0.0, 1.0, 1.0, 0.0]), Ok(1));
    }

    #[test]
    fn what_is_not_stiff_is_refused() {
        let (mut k, m) = chain(2);
        k.copy_from_slice(&[1.0, -1.0, -1.0, 1.0]);
        assert_eq!(natural_modes(2, &k, &m, 1).err(), Some(Indefinite));
    }
}
