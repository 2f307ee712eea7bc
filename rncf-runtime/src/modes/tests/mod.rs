//! Small motions against closed forms.

mod closed;
mod large;

use super::pencil::Pencil;
use crate::linalg::Pattern;
use crate::system::Tangent;

/// Entries `(row, column, value)` of a matrix.
type Entries = Vec<(usize, usize, f64)>;

/// The pencil of M, C, K and the rows of `C_x`, unknowns of size 1.
fn sparse(n: usize, matrices: [&Entries; 3], rows: &[Entries]) -> Pencil {
    let places = matrices.into_iter().flatten().flat_map(|&(i, j, _)| [(i, j), (j, i)]);
    let pattern = Pattern::new(n, n, places.chain((0..n).map(|i| (i, i))));
    let [mass, damping, stiffness] = matrices.map(|entries| {
        let mut values = vec![0.0; pattern.entries()];
        for &(row, column, value) in entries {
            values[pattern.find(row, column).unwrap()] += value;
        }
        values
    });
    let columns = rows.iter().enumerate();
    let columns = columns.flat_map(|(constraint, row)| row.iter().map(move |&(_, unknown, _)| (unknown, constraint)));
    let constraint_pattern = Pattern::new(n, rows.len(), columns);
    let mut jacobian = vec![0.0; constraint_pattern.entries()];
    for (constraint, row) in rows.iter().enumerate() {
        for &(_, unknown, value) in row {
            jacobian[constraint_pattern.find(unknown, constraint).unwrap()] += value;
        }
    }
    let tangent = Tangent {
        mass,
        stiffness,
        damping,
    };
    Pencil::new(&pattern, &tangent, &constraint_pattern, &jacobian, [&vec![1.0; n]; 2])
}

/// Entries of a full matrix, rows first.
fn full<const N: usize>(matrix: [[f64; N]; N]) -> Entries {
    let places = (0..N * N).map(|place| (place / N, place % N));
    places.map(|(i, j)| (i, j, matrix[i][j])).collect()
}

/// The row of a constraint.
fn row<const N: usize>(values: [f64; N]) -> Entries {
    values
        .into_iter()
        .enumerate()
        .map(|(unknown, value)| (0, unknown, value))
        .collect()
}

/// Real and imaginary parts of the lowest eigenvalues.
fn values(pencil: &Pencil, count: usize) -> Vec<[f64; 2]> {
    let pairs = super::spectrum::lowest(pencil, count).unwrap();
    pairs.iter().map(|pair| [pair.s.re, pair.s.im]).collect()
}

/// Frequencies of a system without damping.
fn frequencies(pencil: &Pencil, count: usize) -> Vec<f64> {
    let found = values(pencil, count);
    for [re, im] in &found {
        assert!(re.abs() <= 1e-10 * im.max(1.0), "{re} {im}");
    }
    found.into_iter().map(|[_, im]| im).collect()
}

#[track_caller]
fn assert_close(found: &[f64], exact: &[f64], tolerance: f64) {
    assert_eq!(found.len(), exact.len(), "{found:?} {exact:?}");
    for (found, exact) in found.iter().zip(exact) {
        assert!(
            (found - exact).abs() <= tolerance * exact.abs().max(1e-3),
            "{found} {exact}"
        );
    }
}

/// Masses of 1 kg in a row, springs of 1 N/m between them, and at the ends if `tied`; unknowns
/// `stride * i + first`.
fn chain(count: usize, tied: bool, stride: usize, first: usize) -> [Entries; 2] {
    let place = |i: usize| stride * i + first;
    let (mut mass, mut stiffness) = (Entries::new(), Entries::new());
    for i in 0..count {
        mass.push((place(i), place(i), 1.0));
        if i + 1 < count {
            let (a, b) = (place(i), place(i + 1));
            stiffness.extend([(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)]);
        }
    }
    if tied {
        stiffness.extend([(place(0), place(0), 1.0), (place(count - 1), place(count - 1), 1.0)]);
    }
    [mass, stiffness]
}

/// Frequencies of the chain between walls.
fn of_chain(count: usize) -> impl Iterator<Item = f64> {
    (1..=count).map(move |k| 2.0 * (k as f64 * std::f64::consts::PI / (2 * (count + 1)) as f64).sin())
}
