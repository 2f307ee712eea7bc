use super::super::analysis::places;
use super::super::block_layout::Structure;
use super::super::graph::Graph;
use super::super::links::Links;
use super::super::order::reverse_cuthill_mckee;
use super::super::scalar::c64;
use super::*;
use crate::linalg::Pattern;

/// Deterministic numbers in (-1, 1).
pub(crate) fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Block tri-diagonal pattern of a chain with 4 unknowns per node.
pub(crate) fn chain(nodes: usize) -> Pattern {
    let entries = (0..4 * nodes).flat_map(|row| {
        let node = row / 4;
        let from = 4 * node.saturating_sub(1);
        let to = (4 * (node + 2)).min(4 * nodes);
        (from..to).map(move |column| (row, column))
    });
    Pattern::new(4 * nodes, 4 * nodes, entries)
}

fn multiply<T: Scalar>(pattern: &Pattern, values: &[T], x: &[T]) -> Vec<T> {
    let mut out = vec![T::default(); x.len()];
    for column in 0..pattern.columns() {
        for entry in pattern.starts()[column]..pattern.starts()[column + 1] {
            out[pattern.indices()[entry]] += values[entry] * x[column];
        }
    }
    out
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Method {
    Chain,
    Banded,
    Sparse,
    Blocks,
}

const METHODS: [Method; 4] = [Method::Chain, Method::Banded, Method::Sparse, Method::Blocks];

fn with<T: Scalar>(pattern: &Pattern, method: Method) -> Lu<T> {
    let graph = Graph::new(pattern);
    let place: Arc<[usize]> = places(&graph).into();
    let factors = match method {
        Method::Chain => Links::new(pattern, &graph)
            .and_then(|links| Chain::new(pattern, &links))
            .map(|chain| Factors::Chain(Box::new(chain))),
        Method::Banded => None,
        Method::Sparse => sparse(pattern),
        Method::Blocks => {
            Structure::new(pattern, &graph).map(|structure| Factors::Blocks(Box::new(Blocks::new(Arc::new(structure)))))
        }
    };
    Lu::with(pattern, factors.unwrap_or_else(|| banded(pattern, &place)), place)
}

fn check<T: Scalar>(pattern: &Pattern, method: Method, mut number: impl FnMut() -> T) {
    let mut lu = with(pattern, method);
    for round in 0..3 {
        // Rows of very different size, as positions and slopes have.
        let values: Vec<T> = pattern
            .indices()
            .iter()
            .map(|&row| number().times(10_f64.powi((row % 7) as i32 * 2)))
            .collect();
        let x: Vec<T> = (0..pattern.rows()).map(|_| number()).collect();
        let mut solved = multiply(pattern, &values, &x);
        lu.factor(&values).expect("random matrices are regular");
        lu.solve(&mut solved);
        for (solved, exact) in solved.iter().zip(&x) {
            assert!((*solved - *exact).size() < 1e-9, "round {round}: {solved:?} {exact:?}");
        }
    }
}

#[test]
fn banded_and_sparse_solve_what_was_multiplied() {
    for nodes in [1, 2, 17, 60] {
        let mut number = numbers(nodes as u64);
        for method in METHODS {
            check::<f64>(&chain(nodes), method, &mut number);
            check::<c64>(&chain(nodes), method, || c64::new(number(), number()));
        }
    }
}

#[test]
fn scattered_chain_is_banded_again() {
    let chain = chain(50);
    let scatter = |index: usize| (index * 77) % 200;
    let entries = (0..200).flat_map(|column| {
        chain.indices()[chain.starts()[column]..chain.starts()[column + 1]]
            .iter()
            .map(move |&row| (scatter(row), scatter(column)))
    });
    let scattered = Pattern::new(200, 200, entries);
    let mut place = vec![0; 200];
    for (new, &old) in reverse_cuthill_mckee(&Graph::new(&scattered)).iter().enumerate() {
        place[old] = new;
    }
    assert!(
        half_bandwidth(&scattered, &place) <= 8,
        "{}",
        half_bandwidth(&scattered, &place)
    );
    check::<f64>(&scattered, Method::Banded, numbers(5));
}

#[test]
fn singular_and_not_finite_values_are_placed() {
    let pattern = chain(10);
    for method in METHODS {
        let mut number = numbers(3);
        let mut lu = with::<f64>(&pattern, method);
        let good: Vec<f64> = (0..pattern.entries()).map(|_| number()).collect();
        let mut empty = good.clone();
        for entry in pattern.starts()[13]..pattern.starts()[14] {
            empty[entry] = 0.0;
        }
        assert_eq!(lu.factor(&empty), Err(13));
        // Two equal columns of one node: the second one is noticed.
        let mut double = good.clone();
        let (a, b) = (pattern.starts()[20], pattern.starts()[21]);
        for offset in 0..b - a {
            double[b + offset] = double[a + offset];
        }
        assert!(matches!(lu.factor(&double), Err(20 | 21)), "{:?}", lu.factor(&double));
        let mut broken = good.clone();
        broken[pattern.find(7, 6).unwrap()] = f64::NAN;
        assert_eq!(lu.factor(&broken), Err(7));
        assert_eq!(lu.factor(&good), Ok(()));
    }
}

/// Times of a chain, printed with `--nocapture`; run with `--release --ignored`.
#[test]
#[ignore = "a measurement"]
fn time_of_chains() {
    fn time<T: Scalar>(method: Method, nodes: usize) -> (f64, f64) {
        let pattern = chain(nodes);
        let mut number = numbers(1);
        let mut values: Vec<T> = (0..pattern.entries()).map(|_| T::real(number())).collect();
        for index in 0..pattern.columns() {
            values[pattern.find(index, index).unwrap()] += T::real(6.0);
        }
        let mut lu = with::<T>(&pattern, method);
        let mut x = vec![T::real(1.0); 4 * nodes];
        let rounds = 100_000 / nodes;
        let start = std::time::Instant::now();
        for _ in 0..rounds {
            lu.factor(&values).unwrap();
        }
        let factor = start.elapsed().as_secs_f64() / rounds as f64;
        let start = std::time::Instant::now();
        for _ in 0..rounds {
            lu.solve(&mut x);
            x.fill(T::real(1.0));
        }
        (factor * 1e6, start.elapsed().as_secs_f64() / rounds as f64 * 1e6)
    }
    for nodes in [16, 17, 75, 750] {
        for method in METHODS {
            let (real, complex) = (time::<f64>(method, nodes), time::<c64>(method, nodes));
            println!(
                "{} unknowns, us to factor and solve: {method:?} {real:.2?}, complex {complex:.2?}",
                4 * nodes
            );
        }
    }
}

#[test]
fn signs_of_determinants() {
    let mut number = numbers(9);
    for size in 1..7 {
        let entries = (0..size * size).map(|i| (i % size, i / size));
        let pattern = Pattern::new(size, size, entries);
        for method in METHODS {
            let mut lu = with(&pattern, method);
            let (mut negative, mut positive) = (0, 0);
            for _ in 0..8 {
                let values: Vec<f64> = (0..size * size).map(|_| number()).collect();
                lu.factor(&values).unwrap();
                let expected = determinant(size, &values) < 0.0;
                assert_eq!(lu.is_determinant_negative(), expected);
                negative += usize::from(expected);
                positive += usize::from(!expected);
            }
            assert!(negative > 0 && positive > 0);
        }
    }
}

/// By the first column.
fn determinant(size: usize, columns: &[f64]) -> f64 {
    if size == 0 {
        return 1.0;
    }
    let minor = |row: usize| -> Vec<f64> {
        let rest = columns[size..].iter().enumerate();
        rest.filter(|(place, _)| place % size != row)
            .map(|(_, &value)| value)
            .collect()
    };
    let sign = |row: usize| if row.is_multiple_of(2) { 1.0 } else { -1.0 };
    let term = |row: usize| sign(row) * columns[row] * determinant(size - 1, &minor(row));
    (0..size).map(term).sum()
}
