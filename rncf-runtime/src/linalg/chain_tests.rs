use super::super::graph::Graph;
use super::super::lu::tests::{chain, numbers};
use super::*;
use crate::linalg::c64;

/// The factors' places, where the pattern suits them.
fn factors_of<T: Scalar>(pattern: &Pattern) -> Option<Chain<T>> {
    Chain::new(pattern, &Links::new(pattern, &Graph::new(pattern))?)
}

/// Values with a heavier diagonal, in unknowns of very different sizes, as positions and slopes are.
fn values<T: Scalar>(pattern: &Pattern, mut number: impl FnMut() -> T) -> Vec<T> {
    let size = |index: usize| 10_f64.powi((index % 2) as i32 * 3);
    let columns = pattern.starts().windows(2).enumerate();
    let entries = columns.flat_map(|(column, ends)| {
        pattern.indices()[ends[0]..ends[1]]
            .iter()
            .map(move |&row| (row, column))
    });
    let value = |(row, column): (usize, usize)| {
        let diagonal = T::real(if row == column { 24.0 } else { 0.0 });
        (number() + diagonal).times(size(row) * size(column))
    };
    entries.map(value).collect()
}

fn multiply<T: Scalar>(pattern: &Pattern, values: &[T], x: &[T]) -> Vec<T> {
    let mut out = vec![T::default(); x.len()];
    for (column, ends) in pattern.starts().windows(2).enumerate() {
        for entry in ends[0]..ends[1] {
            out[pattern.indices()[entry]] += values[entry] * x[column];
        }
    }
    out
}

fn check<T: Scalar>(pattern: &Pattern, mut number: impl FnMut() -> T) {
    let mut chain = factors_of(pattern).expect("a chain");
    for round in 0..3 {
        let values = values(pattern, &mut number);
        let x: Vec<T> = (0..pattern.rows()).map(|_| number()).collect();
        let mut solved = multiply(pattern, &values, &x);
        assert!(chain.factor(pattern, &values, pattern.starts()), "diagonals are heavy");
        chain.solve(&mut solved);
        for (solved, exact) in solved.iter().zip(&x) {
            assert!((*solved - *exact).size() < 1e-9, "round {round}: {solved:?} {exact:?}");
        }
    }
}

/// Bodies one after another, of nodes with these numbers of unknowns; unknowns are scattered.
fn bodies(bodies: &[&[usize]]) -> Pattern {
    let size: usize = bodies.iter().copied().flatten().sum();
    let scatter = |index: usize| index * 89 % size;
    let (mut entries, mut first) = (Vec::new(), 0);
    for nodes in bodies {
        let mut before = first..first;
        for node in *nodes {
            let own = first..first + node;
            for i in before.start..own.end {
                for j in before.start..own.end {
                    entries.push((scatter(i), scatter(j)));
                }
            }
            (before, first) = (own.clone(), own.end);
        }
    }
    Pattern::new(size, size, entries)
}

#[test]
fn chains_solve_what_was_multiplied() {
    for size in [4, 5, 6, 7, 9, 12, 18] {
        // A clamped root, a pinned end, bodies of one element.
        let clamped: Vec<usize> = std::iter::once(1).chain([size; 9]).collect();
        let pinned: Vec<usize> = [size; 6].into_iter().chain([size - 2]).collect();
        let pattern = bodies(&[&clamped, &[size / 2, size / 2], &pinned]);
        assert!(!pattern.columns().is_multiple_of(89), "scattering is one to one");
        let mut number = numbers(size as u64);
        check::<f64>(&pattern, &mut number);
        check::<c64>(&pattern, || c64::new(number(), number()));
    }
}

#[test]
fn what_is_no_chain_is_left_to_others() {
    // A ring; a node with three neighbours; nodes that are too large; no diagonal.
    let beside = |i: usize, j: usize| matches!(i.abs_diff(j), 0 | 1 | 9);
    let pairs = |size: usize| (0..size).flat_map(move |i| (0..size).map(move |j| (i, j)));
    let ring = |by: usize| Pattern::new(10 * by, 10 * by, pairs(10 * by).filter(|(i, j)| beside(i / by, j / by)));
    assert!(factors_of::<f64>(&ring(9)).is_some(), "two nodes of a ring make a link");
    assert!(factors_of::<f64>(&ring(10)).is_none());
    let star = pairs(48).filter(|(i, j)| i / 6 == j / 6 || i / 6 == 0 || j / 6 == 0);
    assert!(factors_of::<f64>(&Pattern::new(48, 48, star)).is_none());
    assert!(factors_of::<f64>(&bodies(&[&[19; 5]])).is_none());
    assert!(factors_of::<f64>(&Pattern::new(2, 2, [(0, 0), (0, 1), (1, 0)])).is_none());
}

#[test]
fn values_that_need_row_exchanges_are_refused() {
    let pattern = chain(10);
    let mut factors = factors_of::<f64>(&pattern).expect("a chain");
    let good = values(&pattern, numbers(3));
    let place = |row: usize, column: usize| pattern.find(row, column).expect("an entry");
    let with = |changes: &[(usize, usize, f64)]| {
        let mut values = good.clone();
        for &(row, column, value) in changes {
            values[place(row, column)] = value;
        }
        values
    };
    // A regular block whose first pivot is zero, or as small as round-off; a singular one; what is not finite.
    for small in [0.0, 1e-13] {
        let swapped = [
            (0, 0, small),
            (0, 1, 1.0),
            (1, 0, 1.0),
            (1, 1, 0.0),
            (0, 2, 0.0),
            (0, 3, 0.0),
            (1, 2, 0.0),
            (1, 3, 0.0),
        ];
        assert!(!factors.factor(&pattern, &with(&swapped), pattern.starts()));
    }
    let empty: Vec<_> = (8..20).map(|row| (row, 13, 0.0)).collect();
    assert!(!factors.factor(&pattern, &with(&empty), pattern.starts()));
    assert!(!factors.factor(&pattern, &with(&[(39, 38, f64::NAN)]), pattern.starts()));
    assert!(!factors.factor(&pattern, &with(&[(39, 35, f64::NAN)]), pattern.starts()));
    // A soft node between stiff ones: what is left there is large.
    assert!(!factors.factor(
        &pattern,
        &with(&[(0, 0, 1e-9), (0, 1, 0.0), (0, 2, 0.0), (0, 3, 0.0)]),
        pattern.starts()
    ));
    assert!(factors.factor(&pattern, &good, pattern.starts()));
}

#[test]
fn determinants_have_their_signs() {
    let pattern = chain(5);
    let mut factors = factors_of::<f64>(&pattern).expect("a chain");
    let mut values = values(&pattern, numbers(8));
    let mut sign = |values: &[f64]| {
        assert!(factors.factor(&pattern, values, pattern.starts()));
        factors.is_determinant_negative()
    };
    let before = sign(&values);
    // One row with the other sign.
    for column in 4..16 {
        values[pattern.find(9, column).expect("an entry")] *= -1.0;
    }
    assert_ne!(sign(&values), before);
}
