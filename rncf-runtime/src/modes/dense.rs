//! Small systems: all modes from full matrices on the null space of the constraints.

use super::pair::{Failure, Pair, better_shift};
use super::pencil::Pencil;
use crate::linalg::{c64, general_eigen, negative_eigenvalues, solve_full, symmetric_eigen, times};

/// Constraints whose part that others do not fix is smaller than this depend on those.
const DEPENDENT: f64 = 1e-10;
/// Eigenvalues of the inverse below this part of the largest one stand for infinite frequencies.
const INFINITE: f64 = 1e-13;
/// Eigenvalues of a mass matrix of unit diagonal below this are those of motions without inertia.
const INERT: f64 = 1e-9;
/// Most rounds in which the shift is chosen.
const ROUNDS: usize = 8;

/// What full matrices tell.
pub(super) struct Spectrum {
    /// The shift at which the pairs were found, 1/s.
    pub shift: f64,
    pub pairs: Vec<Pair>,
    /// Number of motions that have inertia: there are as many modes, or more.
    pub moving: usize,
}

/// All finite eigenvalues with the unknowns' vectors, pairs of conjugates both.
pub(super) fn spectrum(pencil: &Pencil) -> Result<Spectrum, Failure> {
    let basis = null_space(pencil)?;
    let k = basis.len();
    if k == 0 {
        return Ok(Spectrum {
            shift: 1.0,
            pairs: Vec::new(),
            moving: 0,
        });
    }
    let [mass, damping, stiffness] = pencil.dense().map(|full| reduced(pencil.unknowns(), &full, &basis));
    let mut shift = pencil.guess();
    for round in 0..ROUNDS {
        let sum = |place: usize| stiffness[place] + shift * (damping[place] + shift * mass[place]);
        let dynamic: Vec<f64> = (0..k * k).map(sum).collect();
        // Right sides of what x' takes from x and from y = s x / shift.
        let from_x: Vec<f64> = (0..k * k)
            .map(|place| -(damping[place] + shift * mass[place]))
            .collect();
        let from_y: Vec<f64> = mass.iter().map(|value| -shift * value).collect();
        let Some([from_x, from_y]) = solve_full(k, &dynamic, [&from_x, &from_y]) else {
            shift *= 1.3;
            continue;
        };
        let mut inverse = vec![0.0; 4 * k * k];
        for i in 0..k {
            for j in 0..k {
                for (column, value) in [(j, from_x[i * k + j]), (k + j, from_y[i * k + j])] {
                    inverse[i * 2 * k + column] = value;
                    inverse[(k + i) * 2 * k + column] = value;
                }
            }
            inverse[(k + i) * 2 * k + i] += 1.0 / shift;
        }
        let (values, vectors) = general_eigen(2 * k, &inverse).map_err(|_| Failure::NotFound)?;
        let largest = values.iter().map(|value| value.norm()).fold(0.0, f64::max);
        let finite = values
            .into_iter()
            .zip(vectors)
            .filter(|(value, _)| value.norm() > INFINITE * largest);
        let pairs: Vec<Pair> = finite
            .map(|(value, vector)| Pair {
                s: c64::new(shift, 0.0) + c64::new(1.0, 0.0) / value,
                x: expanded(&basis, &vector[..k]),
            })
            .collect();
        match better_shift(pencil, shift, pairs.iter().cloned()) {
            Some(next) if round + 1 < ROUNDS => shift = next,
            _ => {
                let moving = moving(k, mass)?;
                return Ok(Spectrum { shift, pairs, moving });
            }
        }
    }
    Err(Failure::Singular(None))
}

/// Number of motions with inertia: the rank of the mass matrix, its rows made alike.
fn moving(k: usize, mut mass: Vec<f64>) -> Result<usize, Failure> {
    let roots: Vec<f64> = (0..k).map(|i| mass[i * k + i].max(0.0).sqrt()).collect();
    for i in 0..k {
        for j in 0..k {
            let size = roots[i] * roots[j];
            mass[i * k + j] = if size > 0.0 { mass[i * k + j] / size } else { 0.0 };
        }
    }
    let (values, _) = symmetric_eigen(k, &mass).map_err(|_| Failure::NotFound)?;
    Ok(values.into_iter().filter(|&value| value > INERT).count())
}

/// Number of negative eigenvalues of the symmetric part of K on the null space of the constraints, from
/// the signature of the bordered matrix; motions that are known to have no stiffness are none.
pub(super) fn negative_stiffness(pencil: &Pencil) -> Result<usize, Failure> {
    let (n, m) = (pencil.unknowns(), pencil.constraints());
    let size = n + m;
    let [_, _, stiffness] = pencil.dense();
    let mut whole = vec![0.0; size * size];
    for i in 0..n {
        for j in 0..n {
            whole[i * size + j] = 0.5 * (stiffness[i * n + j] + stiffness[j * n + i]);
        }
    }
    // What is zero to round-off is not negative.
    for (i, cancelled) in pencil.cancelled().enumerate() {
        whole[i * size + i] += cancelled;
    }
    // Constraints as large as the stiffness: the signature is the same, the pivots are better.
    let largest = whole.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    let weight = if largest > 0.0 { largest } else { 1.0 };
    // What changes nothing has the sign of round-off.
    for motion in pencil.known_still() {
        for i in 0..n {
            for j in 0..n {
                whole[i * size + j] += weight * motion[i].re * motion[j].re;
            }
        }
    }
    for (constraint, row) in pencil.constraint_rows().iter().enumerate() {
        for (unknown, value) in row.iter().enumerate() {
            whole[(n + constraint) * size + unknown] = weight * value;
            whole[unknown * size + n + constraint] = weight * value;
        }
    }
    let negative = negative_eigenvalues(size, &whole).map_err(|_| Failure::NotFound)?;
    Ok(negative.saturating_sub(m))
}

/// Orthonormal basis of the null space of the constraints.
fn null_space(pencil: &Pencil) -> Result<Vec<Vec<f64>>, Failure> {
    let n = pencil.unknowns();
    let mut projector = vec![0.0; n * n];
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for (constraint, mut row) in pencil.constraint_rows().into_iter().enumerate() {
        let before = norm(&row);
        for other in rows.iter().chain(&rows) {
            let part: f64 = other.iter().zip(&row).map(|(a, b)| a * b).sum();
            row.iter_mut().zip(other).for_each(|(value, of)| *value -= part * of);
        }
        let after = norm(&row);
        if after.is_nan() || after <= DEPENDENT * before {
            return Err(Failure::Singular(Some(n + constraint)));
        }
        row.iter_mut().for_each(|value| *value /= after);
        rows.push(row);
    }
    for row in &rows {
        for i in 0..n {
            for j in 0..n {
                projector[i * n + j] += row[i] * row[j];
            }
        }
    }
    if rows.is_empty() {
        let unit = |i: usize| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
        return Ok((0..n).map(unit).collect());
    }
    let (_, mut vectors) = symmetric_eigen(n, &projector).map_err(|_| Failure::NotFound)?;
    vectors.truncate(n - rows.len());
    Ok(vectors)
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}

/// `N^T A N`
fn reduced(n: usize, full: &[f64], basis: &[Vec<f64>]) -> Vec<f64> {
    let images: Vec<Vec<f64>> = basis.iter().map(|vector| times(n, full, vector)).collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let row = |of: &Vec<f64>| images.iter().map(|image| dot(of, image)).collect::<Vec<f64>>();
    basis.iter().flat_map(row).collect()
}

/// `N z`
fn expanded(basis: &[Vec<f64>], coordinates: &[c64]) -> Vec<c64> {
    let mut x = vec![c64::default(); basis[0].len()];
    for (vector, coordinate) in basis.iter().zip(coordinates) {
        for (sum, value) in x.iter_mut().zip(vector) {
            *sum += coordinate * value;
        }
    }
    x
}
