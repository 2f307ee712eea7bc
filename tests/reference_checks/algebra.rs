//! The linear algebra of the references against each other and closed forms.

use crate::differences::{Random, relative};
use rncf_reference::banded::Banded;
use rncf_reference::dense::Matrix;
use rncf_reference::symmetric::{eigenvalues, generalised};
use std::f64::consts::PI;

#[test]
fn banded_elimination_agrees_with_the_dense_one() {
    let (size, half) = (23, 4);
    let mut random = Random(3);
    let (mut banded, mut full) = (Banded::zero(size, half), Matrix::zero(size));
    for i in 0..size {
        // No weight on the diagonal: rows must be exchanged.
        for j in i.saturating_sub(half)..(i + half + 1).min(size) {
            let value = random.next() * if i == j { 1e-9 } else { 1.0 };
            banded.add(i, j, value);
            full.set(i, j, value);
        }
    }
    let right = random.list(size, 1.0);
    let (x, expected) = (banded.solve(&right).unwrap(), full.solve(&right).unwrap());
    assert!(relative(&x, &expected) < 1e-10);
    assert!(Banded::zero(2, 1).solve(&[1.0, 1.0]).unwrap_err().contains("column 0"));
}

#[test]
fn eigenvalues_of_a_chain_of_springs() {
    let n = 12;
    let (mut k, mut twice) = (Matrix::zero(n), Matrix::zero(n));
    for i in 0..n {
        k.set(i, i, 2.0);
        twice.set(i, i, 2.0);
        if i > 0 {
            k.set(i, i - 1, -1.0);
            k.set(i - 1, i, -1.0);
        }
    }
    let exact = |j: usize| 2.0 - 2.0 * (PI * (j + 1) as f64 / (n + 1) as f64).cos();
    for (factor, values) in [(1.0, eigenvalues(&k)), (0.5, generalised(&k, &twice).unwrap())] {
        for (j, value) in values.iter().enumerate() {
            assert!((value - factor * exact(j)).abs() < 1e-14, "{j}: {value}");
        }
    }
    assert!(generalised(&k, &Matrix::zero(n)).is_err());
}
