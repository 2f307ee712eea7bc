//! Eigenvalues and vectors of full matrices without symmetry.
//!
//! Where eigenvalues nearly coincide, faer's back substitution (0.24) solves with pairs of rows by determinants, which cancel: its vectors
//! satisfy nothing. Such ones are found by inverse iteration with the matrix in Hessenberg form, which costs the square of its size each.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::hessenberg::{hessenberg_in_place, hessenberg_in_place_scratch};
use faer::linalg::evd::{ComputeEigenvectors, EvdParams, evd_real, evd_scratch};
use faer::linalg::householder::{
    apply_block_householder_sequence_on_the_left_in_place_scratch as applied_scratch,
    apply_block_householder_sequence_on_the_left_in_place_with_conj as apply,
};
use faer::linalg::qr::no_pivoting::factor::recommended_block_size;
use faer::{Conj, Mat, Par, Spec};

use super::eigen::Indefinite;
use super::scalar::c64;

/// Residual of a vector, relative to the matrix, from which on it is found anew.
const POOR: f64 = 1e-12;
/// Solutions of an inverse iteration, whose first one is as exact as its start is without order.
const ITERATIONS: usize = 2;

/// Eigenvalues of a real matrix in no order, conjugate ones both, and their vectors of length 1.
///
/// # Errors
/// Not found, as for entries that are not finite.
pub fn general_eigen(size: usize, matrix: &[f64]) -> Result<(Vec<c64>, Vec<Vec<c64>>), Indefinite> {
    if size == 0 {
        return Ok((Vec::new(), Vec::new()));
    }
    if !matrix.iter().all(|value| value.is_finite()) {
        return Err(Indefinite);
    }
    let dense = Mat::from_fn(size, size, |i, j| matrix[i * size + j]);
    let mut vectors = Mat::zeros(size, size);
    let (mut re, mut im) = (Diag::zeros(size), Diag::zeros(size));
    let no = ComputeEigenvectors::No;
    let memory = evd_scratch::<f64>(size, no, ComputeEigenvectors::Yes, Par::Seq, unblocked());
    evd_real(
        dense.as_ref(),
        re.as_mut(),
        im.as_mut(),
        None,
        Some(vectors.as_mut()),
        Par::Seq,
        MemStack::new(&mut MemBuffer::new(memory)),
        unblocked(),
    )
    .map_err(|_| Indefinite)?;
    let column = |real: usize, imaginary: Option<usize>, sign: f64| -> Vec<c64> {
        let part = |row: usize| imaginary.map_or(0.0, |column| sign * vectors[(row, column)]);
        (0..size).map(|row| c64::new(vectors[(row, real)], part(row))).collect()
    };
    let (mut values, mut shapes) = (Vec::with_capacity(size), Vec::with_capacity(size));
    while values.len() < size {
        let at = values.len();
        if im[at] == 0.0 {
            values.push(c64::new(re[at], 0.0));
            shapes.push(column(at, None, 1.0));
            continue;
        }
        // Of a pair one column has the real parts, the next one the imaginary parts.
        for sign in [1.0, -1.0] {
            values.push(c64::new(re[at], sign * im[at]));
            shapes.push(column(at, Some(at + 1), sign));
        }
    }
    shapes.iter_mut().for_each(|shape| normalise(shape));
    repair(&dense, &values, &mut shapes);
    Ok((values, shapes))
}

/// The iteration with double shifts at any size: the blocked one (faer 0.24) does not end for some matrices of 75 and
/// more rows, where its deflation cannot swap two pairs.
fn unblocked() -> Spec<EvdParams, f64> {
    let mut params = Spec::<EvdParams, f64>::default();
    params.schur.blocking_threshold = usize::MAX;
    params
}

/// Scales a vector to the length 1.
fn normalise(vector: &mut [c64]) {
    // Squares of the largest are still numbers.
    let largest = vector.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let size = |value: &c64| (value / largest).norm_sqr();
    let length = largest * vector.iter().map(size).sum::<f64>().sqrt();
    vector.iter_mut().for_each(|value| *value /= length);
}

/// Places of the vectors that do not satisfy their equations, of two conjugate ones the first.
fn poor(matrix: &Mat<f64>, values: &[c64], vectors: &[Vec<c64>]) -> Vec<usize> {
    let size = values.len();
    // Of a pair the second column has the imaginary parts, with the other sign.
    let part = |row: usize, place: usize| match values[place].im < 0.0 {
        true => vectors[place][row].im,
        false => vectors[place][row].re,
    };
    let image = matrix * Mat::from_fn(size, size, part);
    let limit = POOR * matrix.norm_l2();
    let is_poor = |&place: &usize| {
        let (value, vector) = (values[place], &vectors[place]);
        let rest = |row: usize| {
            let imaginary = if value.im > 0.0 { -image[(row, place + 1)] } else { 0.0 };
            (c64::new(image[(row, place)], imaginary) - value * vector[row]).norm_sqr()
        };
        let rest = (0..size).map(rest).sum::<f64>().sqrt();
        value.im >= 0.0 && (rest > limit || !rest.is_finite())
    };
    (0..size).filter(is_poor).collect()
}

/// Finds those vectors anew that do not satisfy their equations; conjugates follow each other.
fn repair(matrix: &Mat<f64>, values: &[c64], vectors: &mut [Vec<c64>]) {
    let (size, poor) = (values.len(), poor(matrix, values, vectors));
    if poor.is_empty() {
        return;
    }
    let block = recommended_block_size::<f64>(size - 1, size - 1);
    let mut reduced = matrix.clone();
    let mut factors = Mat::zeros(block, size - 1);
    let memory = hessenberg_in_place_scratch::<f64>(size, block, Par::Seq, Spec::default());
    let mut memory = MemBuffer::new(memory);
    let stack = MemStack::new(&mut memory);
    hessenberg_in_place(reduced.as_mut(), factors.as_mut(), Par::Seq, stack, Spec::default());
    let found: Vec<Vec<c64>> = poor
        .iter()
        .map(|&place| inverse_iteration(&reduced, values[place], place))
        .collect();
    let part = |row: usize, column: usize| match column % 2 {
        0 => found[column / 2][row].re,
        _ => found[column / 2][row].im,
    };
    let mut turned = Mat::from_fn(size, 2 * poor.len(), part);
    let mut memory = MemBuffer::new(applied_scratch::<f64>(size - 1, block, 2 * poor.len()));
    apply(
        reduced.as_ref().submatrix(1, 0, size - 1, size - 1),
        factors.as_ref(),
        Conj::No,
        turned.as_mut().submatrix_mut(1, 0, size - 1, 2 * poor.len()),
        Par::Seq,
        MemStack::new(&mut memory),
    );
    for (index, &place) in poor.iter().enumerate() {
        let vector = |row: usize| c64::new(turned[(row, 2 * index)], turned[(row, 2 * index + 1)]);
        vectors[place] = (0..size).map(vector).collect();
        if values[place].im > 0.0 {
            vectors[place + 1] = vectors[place].iter().map(|value| value.conj()).collect();
        }
    }
}

/// The vector of an eigenvalue of a Hessenberg matrix, from one without order; below the subdiagonal nothing is read. Vectors of equal eigenvalues may
/// come out alike.
fn inverse_iteration(matrix: &Mat<f64>, value: c64, start: usize) -> Vec<c64> {
    let size = matrix.nrows();
    let entry = |row: usize, column: usize| match row {
        _ if row > column + 1 => c64::default(),
        _ if row == column => matrix[(row, column)] - value,
        _ => c64::new(matrix[(row, column)], 0.0),
    };
    let mut rows: Vec<Vec<c64>> = (0..size)
        .map(|row| (0..size).map(|column| entry(row, column)).collect())
        .collect();
    let least = f64::EPSILON * matrix.norm_max();
    // Of each column whether two rows change places, and the part of the upper one that the lower one loses.
    let mut steps = Vec::with_capacity(size);
    for column in 0..size {
        let is_turned = column + 1 < size && rows[column + 1][column].norm() > rows[column][column].norm();
        if is_turned {
            rows.swap(column, column + 1);
        }
        if rows[column][column].norm() <= least {
            rows[column][column] = c64::new(least, 0.0);
        }
        if let [upper, lower] = &mut rows[column..(column + 2).min(size)] {
            let part = lower[column] / upper[column];
            let rest = lower[column..].iter_mut().zip(&upper[column..]);
            rest.for_each(|(lower, upper)| *lower -= part * upper);
            steps.push((is_turned, part));
        }
    }
    let mut vector: Vec<c64> = scattered(size, start)
        .into_iter()
        .map(|value| c64::new(value, 0.0))
        .collect();
    for _ in 0..ITERATIONS {
        for (row, &(is_turned, part)) in steps.iter().enumerate() {
            if is_turned {
                vector.swap(row, row + 1);
            }
            let upper = vector[row];
            vector[row + 1] -= part * upper;
        }
        for row in (0..size).rev() {
            let known: c64 = rows[row][row + 1..]
                .iter()
                .zip(&vector[row + 1..])
                .map(|(a, x)| a * x)
                .sum();
            vector[row] = (vector[row] - known) / rows[row][row];
        }
        normalise(&mut vector);
    }
    vector
}

/// Numbers between -1 and 1 without order, the same ones for the same start.
pub fn scattered(count: usize, start: usize) -> Vec<f64> {
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(start as u64 + 1);
    let next = |_| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    (0..count).map(next).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::linalg::solvers::DenseSolveCore;

    #[test]
    fn vectors_of_equal_eigenvalues_satisfy_their_equations() {
        // Rotations that are equal up to round-off, and another one, seen in oblique axes.
        const PAIRS: usize = 5;
        const SIZE: usize = 2 * PAIRS;
        let mut plain = Mat::<f64>::zeros(SIZE, SIZE);
        for pair in 0..PAIRS {
            let speed = [1.0, 1.0 + 1e-13, 1.0 - 3e-13, 1.0, 2.0][pair];
            plain[(2 * pair, 2 * pair + 1)] = -speed;
            plain[(2 * pair + 1, 2 * pair)] = speed;
        }
        let axes = scattered(SIZE * SIZE, 0);
        let axes = Mat::from_fn(SIZE, SIZE, |row, column| axes[row * SIZE + column]);
        let matrix = &axes * plain * axes.partial_piv_lu().inverse();
        let entries: Vec<f64> = (0..SIZE * SIZE).map(|at| matrix[(at / SIZE, at % SIZE)]).collect();
        let (values, vectors) = general_eigen(SIZE, &entries).unwrap();
        for (value, vector) in values.iter().zip(&vectors) {
            let image = |row: usize| {
                (0..SIZE)
                    .map(|column| vector[column] * matrix[(row, column)])
                    .sum::<c64>()
            };
            let rest = (0..SIZE)
                .map(|row| (image(row) - value * vector[row]).norm())
                .fold(0.0, f64::max);
            let length = vector.iter().map(|value| value.norm_sqr()).sum::<f64>();
            assert!(
                rest < 2.0 * POOR * matrix.norm_l2() && (length - 1.0).abs() < 1e-14,
                "{value}: {rest:e}"
            );
        }
    }

    #[test]
    fn a_rotation_has_imaginary_eigenvalues() {
        let (values, vectors) = general_eigen(2, &[0.5, -2.0, 2.0, 0.5]).unwrap();
        for (value, vector) in values.iter().zip(&vectors) {
            assert!((value.re - 0.5).abs() < 1e-14 && (value.im.abs() - 2.0).abs() < 1e-14);
            let rest = vector[0] * (c64::new(0.5, 0.0) - value) - vector[1] * 2.0;
            assert!(rest.norm() < 1e-14);
        }
        assert!(values[0].im * values[1].im < 0.0);
        assert!(general_eigen(1, &[f64::NAN]).is_err());
    }
}
