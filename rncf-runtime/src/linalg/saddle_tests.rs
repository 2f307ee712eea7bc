use super::super::lu::tests::{chain, numbers};
use super::super::scalar::c64;
use super::*;

/// Constraints that touch three unknowns each.
fn constraints(rows: usize, count: usize) -> Pattern {
    Pattern::new(
        rows,
        count,
        (0..count).flat_map(|j| (0..3).map(move |k| ((5 * j + 11 * k) % rows, j))),
    )
}

/// Residual of a solution, relative to its right side of size 1.
fn check<T: Scalar>(mut number: impl FnMut() -> T, mut real: impl FnMut() -> f64, nodes: usize, count: usize) {
    let (block, transposed) = (chain(nodes), constraints(4 * nodes, count));
    let mut saddle = Saddle::<T>::new(&block, &transposed);
    let k: Vec<T> = (0..block.entries()).map(|_| number()).collect();
    let ct: Vec<f64> = (0..transposed.entries()).map(|_| real()).collect();
    let (b, c): (Vec<T>, Vec<T>) = (
        (0..4 * nodes).map(|_| number()).collect(),
        (0..count).map(|_| number()).collect(),
    );
    saddle.factor(&k, &ct).expect("random matrices are regular");
    let (mut x, mut multipliers) = (b.clone(), c.clone());
    saddle.solve(&mut x, &mut multipliers);
    let mut residual: Vec<T> = b.iter().map(|&value| -value).collect();
    for column in 0..4 * nodes {
        for entry in block.starts()[column]..block.starts()[column + 1] {
            residual[block.indices()[entry]] += k[entry] * x[column];
        }
    }
    for j in 0..count {
        let mut violation = -c[j];
        for entry in transposed.starts()[j]..transposed.starts()[j + 1] {
            let row = transposed.indices()[entry];
            residual[row] += multipliers[j].times(ct[entry]);
            violation += x[row].times(ct[entry]);
        }
        assert!(violation.size() < 1e-9, "constraint {j}: {violation:?}");
    }
    for (row, value) in residual.iter().enumerate() {
        assert!(value.size() < 1e-9, "row {row}: {value:?}");
    }
}

#[test]
fn solution_satisfies_both_rows() {
    for (nodes, count) in [(2, 0), (2, 1), (3, 2), (20, 6)] {
        let (mut a, mut b) = (numbers(nodes as u64), numbers(99));
        check::<f64>(&mut a, &mut b, nodes, count);
        check::<c64>(|| c64::new(a(), a()), &mut b, nodes, count);
    }
}

#[test]
fn redundant_and_empty_constraints_are_named() {
    let block = chain(4);
    let transposed = Pattern::new(16, 3, [(0, 0), (5, 0), (0, 1), (5, 1), (9, 2)]);
    let mut saddle = Saddle::<f64>::new(&block, &transposed);
    let mut number = numbers(4);
    let k: Vec<f64> = (0..block.entries()).map(|_| number()).collect();
    assert_eq!(saddle.factor(&k, &[1.0, 2.0, 3.0, 5.0, 1.0]), Ok(()));
    assert_eq!(
        saddle.factor(&k, &[1.0, 2.0, 1.0, 5.0, 0.0]),
        Err(Singular::Constraint(2))
    );
    let redundant = saddle.factor(&k, &[1.0, 2.0, 1.5, 3.0, 1.0]);
    assert_eq!(redundant, Err(Singular::Constraint(1)));
    assert_eq!(saddle.factor(&vec![0.0; k.len()], &[1.0; 5]), Err(Singular::Unknown(0)));
}
