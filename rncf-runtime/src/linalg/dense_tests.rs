use super::super::lu::tests::numbers;
use super::super::scalar::c64;
use super::*;

/// Largest residual of a solution relative to the terms it is summed from.
fn residual<T: Scalar>(values: &[T], x: &[T], right: &[T]) -> f64 {
    let n = x.len();
    (0..n)
        .map(|i| {
            let (mut sum, mut terms) = (-right[i], right[i].size());
            for j in 0..n {
                sum += values[i * n + j] * x[j];
                terms += values[i * n + j].size() * x[j].size();
            }
            sum.size() / terms
        })
        .fold(0.0, f64::max)
}

fn check<T: Scalar>(n: usize, mut number: impl FnMut() -> T) {
    let mut dense = Dense::new(n);
    for _ in 0..2 {
        // Rows and columns of very different size.
        let scale = |i: usize| 10_f64.powi((5 * i % 17) as i32 - 8);
        let values: Vec<T> = (0..n * n)
            .map(|k| number().times(scale(k / n) * scale(k % n + 3)))
            .collect();
        let right: Vec<T> = (0..n).map(|i| number().times(scale(i))).collect();
        dense.clear();
        for (k, &value) in values.iter().enumerate() {
            dense.add(k / n, k % n, value, value.size());
        }
        dense.factor().expect("random matrices are regular");
        let mut x = right.clone();
        dense.solve(&mut x);
        assert!(residual(&values, &x, &right) < 1e-13, "{n}");
    }
}

#[test]
fn solutions_satisfy_badly_scaled_systems() {
    for n in [0, 1, 2, 7, 60] {
        let mut number = numbers(n as u64 + 1);
        check::<f64>(n, &mut number);
        check::<c64>(n, || c64::new(number(), number()));
    }
}

#[test]
fn rows_without_diagonal_are_exchanged_and_dependent_ones_named() {
    let fill = |values: [[f64; 3]; 3]| {
        let mut dense = Dense::new(3);
        for (i, row) in values.iter().enumerate() {
            row.iter()
                .enumerate()
                .for_each(|(j, &value)| dense.add(i, j, value, value.abs()));
        }
        dense
    };
    assert_eq!(
        fill([[0.0, 1.0, 0.0], [0.0, 0.0, 2.0], [3.0, 0.0, 0.0]]).factor(),
        Ok(())
    );
    assert_eq!(
        fill([[1.0, 2.0, 3.0], [0.0, 1.0, 5.0], [2.0, 4.0, 6.0]]).factor(),
        Err(2)
    );
    assert_eq!(
        fill([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [0.0, 1.0, 5.0]]).factor(),
        Err(1)
    );
    assert_eq!(
        fill([[1.0, 2.0, 3.0], [0.0, 0.0, 0.0], [0.0, 1.0, 5.0]]).factor(),
        Err(1)
    );
    assert_eq!(
        fill([[1.0, 2.0, 3.0], [0.0, f64::NAN, 0.0], [0.0, 1.0, 5.0]]).factor(),
        Err(1)
    );
    // What is left of terms that cancel is round-off, not a small pivot.
    let mut cancelled = fill([[1.0, 0.0, 0.0], [0.0, 1e9, 0.0], [0.0, 0.0, 1.0]]);
    cancelled.add(1, 1, -1e9 + 1e-7, 1e9);
    assert_eq!(cancelled.factor(), Err(1));
}
