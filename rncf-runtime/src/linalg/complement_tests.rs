use super::super::lu::tests::{chain, numbers};
use super::super::scalar::c64;
use super::*;

/// A chain of nodes with a border that touches all of it and itself.
fn bordered(nodes: usize, border: usize) -> Pattern {
    let (chain, inner) = (chain(nodes), 4 * nodes);
    let all = inner + border;
    let full = (0..all).flat_map(|i| (inner..all).flat_map(move |j| [(i, j), (j, i)]));
    let leading: Vec<_> = chain.places().collect();
    Pattern::new(all, all, leading.into_iter().chain(full))
}

/// Constraints that touch three unknowns each.
fn constraints(rows: usize, count: usize) -> Pattern {
    Pattern::new(
        rows,
        count,
        (0..count).flat_map(|j| (0..3).map(move |k| ((5 * j + 11 * k) % rows, j))),
    )
}

/// `out -= A x` and the sizes of its terms, with A by entries.
fn subtract<T: Scalar>(terms: impl Iterator<Item = (usize, usize, T)>, x: &[T], out: &mut [T], sizes: &mut [f64]) {
    for (row, column, value) in terms {
        out[row] -= value * x[column];
        sizes[row] += (value * x[column]).size();
    }
}

/// Residual of a solution relative to its terms.
pub(in super::super) fn residual<T: Scalar>(
    (block, transposed): (&Pattern, &Pattern),
    (k, forces, derivatives): (&[T], &[f64], &[f64]),
    (b, c): (&[T], &[T]),
    (x, multipliers): (&[T], &[T]),
) -> f64 {
    let (mut dynamics, mut violations) = (b.to_vec(), c.to_vec());
    let size = |y: &[T]| y.iter().map(|value| value.size()).collect::<Vec<_>>();
    let (mut of_dynamics, mut of_violations) = (size(b), size(c));
    let terms = block
        .places()
        .enumerate()
        .map(|(entry, (row, column))| (row, column, k[entry]));
    subtract(terms, x, &mut dynamics, &mut of_dynamics);
    let terms = transposed
        .places()
        .enumerate()
        .map(|(entry, (row, column))| (row, column, T::real(forces[entry])));
    subtract(terms, multipliers, &mut dynamics, &mut of_dynamics);
    let terms = transposed
        .places()
        .enumerate()
        .map(|(entry, (row, column))| (column, row, T::real(derivatives[entry])));
    subtract(terms, x, &mut violations, &mut of_violations);
    let largest = |rest: &[T], sizes: &[f64]| {
        let scaled = rest.iter().zip(sizes).map(|(rest, size)| rest.size() / size);
        scaled.fold(0.0, f64::max)
    };
    largest(&dynamics, &of_dynamics).max(largest(&violations, &of_violations))
}

/// What stands in the border of K.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Border {
    Full,
    /// K is singular: the constraints alone hold the border.
    Zero,
}

fn check<T: Scalar>(
    mut number: impl FnMut() -> T,
    mut real: impl FnMut() -> f64,
    (nodes, border, count): (usize, usize, usize),
    kind: Border,
    scale: f64,
) {
    let n = 4 * nodes + border;
    let block = bordered(nodes, border);
    let transposed = match kind {
        Border::Full => constraints(n, count),
        Border::Zero => Pattern::new(n, count, (0..n).flat_map(|i| (0..count).map(move |j| (i, j)))),
    };
    let mut complement = Complement::<T>::new(&block, border, &transposed);
    let factor = |i: usize| if i % 3 == 1 { scale } else { 1.0 };
    let k: Vec<T> = block
        .places()
        .map(|(row, column)| {
            let outside = kind == Border::Zero && (row >= 4 * nodes || column >= 4 * nodes);
            number().times(if outside { 0.0 } else { factor(row) * factor(column) })
        })
        .collect();
    let derivatives: Vec<f64> = transposed.places().map(|(row, _)| real() * factor(row)).collect();
    let other: Vec<f64> = derivatives.iter().map(|value| value * (1.0 + 0.3 * real())).collect();
    let b: Vec<T> = (0..n).map(|i| number().times(factor(i))).collect();
    let c: Vec<T> = (0..count).map(|_| number()).collect();
    for forces in [&derivatives, &other] {
        complement
            .factor(&k, forces, &derivatives)
            .expect("random matrices are regular");
        let (mut x, mut multipliers) = (b.clone(), c.clone());
        complement.solve(&mut x, &mut multipliers);
        let values = (&k[..], &forces[..], &derivatives[..]);
        let rest = residual((&block, &transposed), values, (&b, &c), (&x, &multipliers));
        assert!(rest < 1e-12, "{nodes} {border} {count} {kind:?} {scale}: {rest:e}");
    }
}

#[test]
fn solutions_satisfy_both_rows() {
    for scale in [1.0, 1e8, 1e-8] {
        for case in [
            (2, 0, 0),
            (2, 0, 1),
            (20, 0, 6),
            (0, 6, 0),
            (0, 12, 5),
            (3, 6, 2),
            (20, 12, 6),
            (10, 1, 0),
        ] {
            let (mut a, mut b) = (numbers(case.0 as u64 + 1), numbers(99));
            check::<f64>(&mut a, &mut b, case, Border::Full, scale);
            check::<c64>(|| c64::new(a(), a()), &mut b, case, Border::Full, scale);
        }
        for case in [(3, 2, 2), (20, 6, 6), (0, 4, 4), (5, 3, 7)] {
            let (mut a, mut b) = (numbers(case.0 as u64 + 1), numbers(98));
            check::<f64>(&mut a, &mut b, case, Border::Zero, scale);
            check::<c64>(|| c64::new(a(), a()), &mut b, case, Border::Zero, scale);
        }
    }
}

#[test]
fn redundant_and_empty_constraints_are_named() {
    let block = chain(4);
    let transposed = Pattern::new(16, 3, [(0, 0), (5, 0), (0, 1), (5, 1), (9, 2)]);
    for border in [0, 8, 16] {
        let mut complement = Complement::<f64>::new(&block, border, &transposed);
        let mut number = numbers(4);
        let k: Vec<f64> = (0..block.entries()).map(|_| number()).collect();
        assert_eq!(
            complement.factor(&k, &[1.0, 2.0, 3.0, 5.0, 1.0], &[1.0, 2.0, 3.0, 5.0, 1.0]),
            Ok(())
        );
        assert_eq!(
            complement.factor(&k, &[1.0, 2.0, 1.0, 5.0, 0.0], &[1.0, 2.0, 1.0, 5.0, 0.0]),
            Err(Singular::Constraint(2))
        );
        let redundant = complement.factor(&k, &[1.0, 2.0, 1.5, 3.0, 1.0], &[1.0, 2.0, 1.5, 3.0, 1.0]);
        assert_eq!(redundant, Err(Singular::Constraint(1)));
        let empty = complement.factor(&vec![0.0; k.len()], &[1.0; 5], &[1.0; 5]);
        assert!(matches!(empty, Err(Singular::Unknown(_))), "{empty:?}");
    }
}

#[test]
fn border_that_nothing_holds_is_named() {
    let (block, inner) = (bordered(3, 3), 12);
    let transposed = Pattern::new(15, 1, [(0, 0), (13, 0)]);
    let mut complement = Complement::<f64>::new(&block, 3, &transposed);
    let mut number = numbers(8);
    // The last border unknown is a copy of a leading one: K is singular, and no constraint helps.
    let mut k: Vec<f64> = block.places().map(|_| number()).collect();
    let place = |row: usize, column: usize| block.find(row, column).expect("an entry");
    for column in 0..15 {
        let source = block.find(2, column).map_or(0.0, |entry| k[entry]);
        k[place(inner + 2, column)] = source;
    }
    assert_eq!(
        complement.factor(&k, &[1.0, 1.0], &[1.0, 1.0]),
        Err(Singular::Unknown(14))
    );
    k[place(13, 13)] = f64::NAN;
    assert_eq!(
        complement.factor(&k, &[1.0, 1.0], &[1.0, 1.0]),
        Err(Singular::Unknown(13))
    );
}

/// Times of tethers with a border of a frame and two full constraints; run with `--release --ignored`.
#[test]
#[ignore = "a measurement"]
fn time_of_bordered_tethers() {
    let leading = super::super::blocks::tests::tethers(100, 15);
    let inner = leading.columns();
    let n = inner + 6;
    let full = (0..n).flat_map(|i| (inner..n).flat_map(move |j| [(i, j), (j, i)]));
    let own: Vec<_> = leading.places().collect();
    let block = Pattern::new(n, n, own.into_iter().chain(full));
    let transposed = Pattern::new(n, 2, (0..n).flat_map(|i| [(i, 0), (i, 1)]));
    let mut number = numbers(3);
    let heavy = |row: usize, column: usize| if row == column { 6.0 } else { 0.0 };
    let k: Vec<f64> = block
        .places()
        .map(|(row, column)| number() + heavy(row, column))
        .collect();
    let c: Vec<f64> = (0..transposed.entries()).map(|_| number()).collect();
    let mut complement = Complement::<f64>::new(&block, 6, &transposed);
    let (mut x, mut multipliers) = (vec![1.0; n], vec![1.0; 2]);
    let mut times = [const { Vec::new() }; 6];
    for _ in 0..1000 {
        let mut time = |kind: usize, what: &mut dyn FnMut()| {
            let start = std::time::Instant::now();
            what();
            times[kind].push(start.elapsed().as_secs_f64() * 1e6);
        };
        time(0, &mut || complement.factor(&k, &c, &c).expect("regular"));
        x.fill(1.0);
        time(1, &mut || complement.solve(&mut x, &mut multipliers));
        time(2, &mut || {
            complement.leading.factor_from(&k, &complement.starts).expect("regular")
        });
        time(3, &mut || {
            complement.columns.load(&k, &c);
            complement.rows.load(&k, &c, 6);
        });
        time(4, &mut || {
            complement
                .leading
                .solve_many(&mut complement.columns.responses.values, 8)
        });
        time(5, &mut || complement.fill_schur(&k, &c, &c));
    }
    let names = [
        "factor",
        "solve",
        "  factor leading",
        "  load border",
        "  solve 8",
        "  Schur complement",
    ];
    for (name, times) in names.iter().zip(&mut times) {
        times.sort_by(f64::total_cmp);
        println!("{name:>20} {:8.1} us, least {:8.1}", times[500], times[0]);
    }
}

/// Tethers, which are factored by blocks, with a frame and constraints of which K needs two.
#[test]
fn tethers_with_a_border_are_solved() {
    let leading = super::super::blocks::tests::tethers(12, 5);
    let inner = leading.columns();
    let n = inner + 6;
    let full = (0..n).flat_map(|i| (inner..n).flat_map(move |j| [(i, j), (j, i)]));
    let own: Vec<_> = leading.places().collect();
    let block = Pattern::new(n, n, own.into_iter().chain(full));
    let transposed = Pattern::new(n, 3, (0..n).flat_map(|i| [(i, 0), (i, 1)]).chain([(5, 2), (90, 2)]));
    let (mut complement, mut number) = (Complement::<f64>::new(&block, 6, &transposed), numbers(3));
    let heavy = |row: usize, column: usize| if row == column { 6.0 } else { 0.0 };
    let mut k: Vec<f64> = block
        .places()
        .map(|(row, column)| number() + heavy(row, column))
        .collect();
    // The last two border unknowns act on nothing by themselves.
    for (entry, (row, column)) in block.places().enumerate() {
        if row >= n - 2 || column >= n - 2 {
            k[entry] = 0.0;
        }
    }
    let c: Vec<f64> = (0..transposed.entries()).map(|_| number()).collect();
    let (b, right): (Vec<f64>, Vec<f64>) = ((0..n).map(|_| number()).collect(), vec![0.3, -0.2, 0.1]);
    complement
        .factor(&k, &c, &c)
        .expect("the constraints hold what K does not");
    let (mut x, mut multipliers) = (b.clone(), right.clone());
    complement.solve(&mut x, &mut multipliers);
    let rest = residual((&block, &transposed), (&k, &c, &c), (&b, &right), (&x, &multipliers));
    assert!(rest < 1e-12, "{rest:e}");
}
