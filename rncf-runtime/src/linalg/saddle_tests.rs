use super::super::complement::tests::residual;
use super::super::lu::tests::{chain, numbers};
use super::super::scalar::c64;
use super::*;

const NODES: usize = 30;
const UNKNOWNS: usize = 4 * NODES;

/// Conditions between neighbours of a chain.
fn between_neighbours() -> Pattern {
    let entries = (0..NODES - 1).flat_map(|j| [4 * j, 4 * j + 1, 4 * j + 4, 4 * j + 6].map(|row| (row, j)));
    Pattern::new(UNKNOWNS, NODES - 1, entries)
}

fn check<T: Scalar>(mut number: impl FnMut() -> T, scale: f64) {
    let (block, transposed) = (chain(NODES), between_neighbours());
    let mut saddle = Saddle::<T>::new(&block, UNKNOWNS, &transposed);
    let mut real = numbers(7);
    let factor = |i: usize| if i % 3 == 1 { scale } else { 1.0 };
    let k: Vec<T> = block
        .places()
        .map(|(row, column)| number().times(factor(row) * factor(column)))
        .collect();
    let derivatives: Vec<f64> = transposed.places().map(|(row, _)| real() * factor(row)).collect();
    let forces: Vec<f64> = derivatives.iter().map(|value| value * (1.0 + 0.3 * real())).collect();
    let b: Vec<T> = (0..UNKNOWNS).map(|i| number().times(factor(i))).collect();
    let c: Vec<T> = (0..NODES - 1).map(|_| number()).collect();
    assert_eq!(saddle.factor(&k, &forces, &derivatives), Ok(()));
    assert!(saddle.is_whole());
    let (mut x, mut multipliers) = (b.clone(), c.clone());
    saddle.solve(&mut x, &mut multipliers);
    let values = (&k[..], &forces[..], &derivatives[..]);
    let rest = residual((&block, &transposed), values, (&b, &c), (&x, &multipliers));
    assert!(rest < 1e-11, "{scale}: {rest:e}");
}

#[test]
fn solutions_satisfy_both_rows() {
    for scale in [1.0, 1e6, 1e-6] {
        let mut a = numbers(3);
        check::<f64>(&mut a, scale);
        check::<c64>(|| c64::new(a(), a()), scale);
    }
}

#[test]
fn what_is_few_or_full_is_none() {
    let block = chain(NODES);
    assert!(Whole::<f64>::new(&chain(3), 12, &Pattern::new(12, 0, [])).is_none());
    assert!(Whole::<f64>::new(&block, 6, &Pattern::new(UNKNOWNS, 0, [])).is_none());
    assert!(Whole::<f64>::new(&block, UNKNOWNS, &between_neighbours()).is_some());
    let full = (0..60).flat_map(|row| (0..60).map(move |column| (row, column)));
    assert!(Whole::<f64>::new(&Pattern::new(60, 60, full), 60, &Pattern::new(60, 0, [])).is_none());
}

/// What partial pivoting finds doubtful is named by complete pivoting, and later values are factored whole again.
#[test]
fn redundant_conditions_are_named() {
    let (block, transposed) = (chain(NODES), between_neighbours());
    let entries = transposed.places();
    let twice = Pattern::new(
        UNKNOWNS,
        NODES,
        entries.chain((0..4).map(|k| ([0, 1, 4, 6][k], NODES - 1))),
    );
    let (mut number, mut saddle) = (numbers(4), Saddle::<f64>::new(&block, UNKNOWNS, &twice));
    let k: Vec<f64> = (0..block.entries()).map(|_| number()).collect();
    let mut c: Vec<f64> = (0..twice.entries()).map(|_| number()).collect();
    assert_eq!(saddle.factor_symmetric(&k, &c), Ok(()));
    assert!(saddle.is_whole());
    let last = c.len() - 4;
    for place in 0..4 {
        c[last + place] = 3.0 * c[place];
    }
    assert_eq!(saddle.factor_symmetric(&k, &c), Err(Singular::Constraint(NODES - 1)));
    assert!(!saddle.is_whole());
    c[last] += 1.0;
    assert_eq!(saddle.factor_symmetric(&k, &c), Ok(()));
    assert!(saddle.is_whole());
    c[0] = f64::NAN;
    assert!(saddle.factor_symmetric(&k, &c).is_err());
}
