use super::super::block_order::Nodes;
use super::super::graph::Graph;
use super::super::lu::tests::numbers;
use super::super::scalar::c64;
use super::super::sparse::Sparse;
use super::*;

/// The factors' places, where the pattern suits them.
fn factors_of<T: Scalar>(pattern: &Pattern) -> Option<Blocks<T>> {
    Structure::new(pattern, &Graph::new(pattern)).map(|structure| Blocks::new(Arc::new(structure)))
}

/// The pattern of tethers on a hub: `chains` of `length` nodes with 6 unknowns, one unknown at the
/// hub, 9 at the tip, of which 6 (position, slope of the ring) are coupled with those of the two
/// neighbours.
pub(crate) fn tethers(chains: usize, length: usize) -> Pattern {
    let each = 6 * length + 10;
    let mut entries = Vec::new();
    let mut couple = |a: &[usize], b: &[usize]| {
        for &i in a {
            entries.extend(b.iter().flat_map(|&j| [(i, j), (j, i)]));
        }
    };
    for chain in 0..chains {
        let start = chain * each;
        let node = |k: usize| -> Vec<usize> {
            match k {
                0 => vec![start],
                k if k <= length => (0..6).map(|i| start + 1 + 6 * (k - 1) + i).collect(),
                _ => (0..6).map(|i| start + 1 + 6 * length + i).collect(),
            }
        };
        let ring = |chain: usize| -> Vec<usize> {
            let tip = (chain % chains) * each + 1 + 6 * length;
            [0, 1, 2, 6, 7, 8].map(|i| tip + i).to_vec()
        };
        for k in 0..=length {
            let both = [node(k), node(k + 1)].concat();
            couple(&both, &both);
        }
        let both = [ring(chain), ring(chain + 1)].concat();
        couple(&both, &both);
    }
    Pattern::new(chains * each, chains * each, entries)
}

/// 1 / size of an unknown.
fn size(index: usize) -> f64 {
    10_f64.powi((index % 3) as i32 * 3 - 3)
}

/// Values with a heavier diagonal, in rows and columns of very different sizes, as of positions and
/// slopes.
fn values<T: Scalar>(pattern: &Pattern, mut number: impl FnMut() -> T) -> Vec<T> {
    let entries = (0..pattern.columns()).flat_map(|j| column(pattern, j).iter().map(move |&row| (row, j)));
    let value = |(row, column): (usize, usize)| {
        let diagonal = if row == column { T::real(6.0) } else { T::default() };
        (number() + diagonal).times(size(row) * size(column))
    };
    entries.map(value).collect()
}

fn multiply<T: Scalar>(pattern: &Pattern, values: &[T], x: &[T]) -> Vec<T> {
    let mut out = vec![T::default(); x.len()];
    for j in 0..pattern.columns() {
        for (&row, &value) in column(pattern, j).iter().zip(&values[pattern.starts()[j]..]) {
            out[row] += value * x[j];
        }
    }
    out
}

/// Nodes of sizes 1 to 7 that are coupled at random, with unknowns scattered.
fn random(nodes: usize, number: &mut impl FnMut() -> f64) -> Pattern {
    let sizes: Vec<usize> = (0..nodes).map(|index| 1 + index * 5 % 7).collect();
    let size = sizes.iter().sum::<usize>();
    let stride = (1..)
        .map(|k| 2 * k + 1)
        .find(|k| *k > 7 && (2..=*k).all(|d| k % d != 0 || size % d != 0));
    let stride = stride.expect("some number has no divisor of it");
    let mut unknown = (0..size).map(|index| index * stride % size);
    let members: Vec<Vec<usize>> = sizes
        .iter()
        .map(|&size| unknown.by_ref().take(size).collect())
        .collect();
    let mut entries = Vec::new();
    for i in 0..nodes {
        for j in 0..nodes {
            if i == j || number() > 0.75 {
                entries.extend(
                    members[i]
                        .iter()
                        .flat_map(|&row| members[j].iter().map(move |&at| (row, at))),
                );
            }
        }
    }
    Pattern::new(size, size, entries)
}

fn check<T: Scalar>(pattern: &Pattern, mut number: impl FnMut() -> T) {
    let n = pattern.columns();
    let mut blocks = factors_of(pattern).expect("a small pattern");
    let values = values(pattern, &mut number);
    for arch in [Arch::Scalar, Arch::new()] {
        blocks.arch = arch;
        blocks
            .factor(pattern, &values, pattern.starts(), 1e-14)
            .expect("a regular matrix");
        let exact: Vec<T> = (0..11 * n)
            .map(|index| number().times(1.0 / size(index / 11)))
            .collect();
        let side = |k: usize| -> Vec<T> { exact.iter().skip(k).step_by(11).copied().collect() };
        let right = |k: usize| multiply(pattern, &values, &side(k));
        let mut many = vec![T::default(); 11 * n];
        for k in 0..11 {
            for (value, right) in many.iter_mut().skip(k).step_by(11).zip(right(k)) {
                *value = right;
            }
        }
        blocks.solve_many(&mut many, 11);
        let mut one = right(4);
        blocks.solve(&mut one);
        for row in 0..n {
            let error = |value: T, k: usize| size(row) * (value - exact[11 * row + k]).size();
            assert!(error(one[row], 4) < 1e-9, "{row}: {:e}", error(one[row], 4));
            for k in 0..11 {
                let error = error(many[11 * row + k], k);
                assert!(error < 1e-9, "{row}, {k}: {error:e}");
            }
        }
    }
}

#[test]
fn solutions_of_random_blocks_and_of_tethers() {
    for (chains, length) in [(3, 1), (4, 3), (9, 5)] {
        let (pattern, mut number) = (tethers(chains, length), numbers(chains as u64));
        check::<f64>(&pattern, &mut number);
        check::<c64>(&pattern, || c64::new(number(), number()));
    }
    for nodes in [1, 2, 5, 12, 40] {
        let mut number = numbers(nodes as u64 + 20);
        let pattern = random(nodes, &mut number);
        check::<f64>(&pattern, &mut number);
        check::<c64>(&pattern, || c64::new(number(), number()));
    }
}

/// Multipliers whose diagonal is empty come after what they hold.
#[test]
fn empty_diagonals_wait() {
    let base = tethers(4, 2);
    let n = base.columns();
    let own = (0..n).flat_map(|j| column(&base, j).iter().map(move |&row| (row, j)));
    let held = (0..3).flat_map(|k| [(7 * k + 1, n + k), (n + k, 7 * k + 1), (60, n + k), (n + k, 60)]);
    let pattern = Pattern::new(n + 3, n + 3, own.chain(held));
    check::<f64>(&pattern, numbers(2));
}

#[test]
fn nodes_are_found() {
    let pattern = tethers(100, 15);
    let Nodes { members, later } = Nodes::new(&pattern, &Graph::new(&pattern));
    let of_size = |size: usize| members.iter().filter(|members| members.len() == size).count();
    assert_eq!((of_size(1), of_size(3), of_size(6)), (100, 300, 1500));
    let fill = later.iter().map(Vec::len).max();
    assert!(fill <= Some(6), "{fill:?}");
}

#[test]
fn repeated_factorizations_have_the_same_bits() {
    let pattern = tethers(7, 4);
    let mut number = numbers(6);
    let (first, second) = (values(&pattern, &mut number), values(&pattern, &mut number));
    let mut blocks = factors_of::<f64>(&pattern).expect("a small pattern");
    let mut solution = |values: &[f64]| {
        blocks
            .factor(&pattern, values, pattern.starts(), 1e-14)
            .expect("regular");
        let mut x: Vec<f64> = (0..pattern.columns()).map(|index| (index as f64).sin()).collect();
        blocks.solve(&mut x);
        x
    };
    let before = solution(&first);
    assert_ne!(before, solution(&second));
    assert_eq!(before, solution(&first));
}

#[test]
fn one_right_side_has_the_bits_of_several() {
    let pattern = tethers(12, 6);
    let mut blocks = factors_of::<f64>(&pattern).expect("a small pattern");
    assert!(blocks.structure.sixes >= 60, "{}", blocks.structure.sixes);
    // Twice: copies of factors are renewed with them.
    for seed in [3, 5] {
        let values = values(&pattern, numbers(seed));
        blocks
            .factor(&pattern, &values, pattern.starts(), 1e-15)
            .expect("regular");
        let mut number = numbers(seed + 1);
        let mut one: Vec<f64> = (0..pattern.columns()).map(|_| number()).collect();
        let mut several = one.clone();
        blocks.solve(&mut one);
        blocks.solve_many(&mut several, 1);
        assert_eq!(one, several);
    }
}

#[test]
fn growth_is_refused() {
    // A node whose diagonal is nearly empty is coupled with one whose diagonal is not.
    let pattern = Pattern::new(3, 3, [(0, 0), (0, 1), (1, 0), (1, 1), (1, 2), (2, 1), (2, 2)]);
    let mut blocks = factors_of::<f64>(&pattern).expect("a small pattern");
    let factor = |blocks: &mut Blocks<f64>, tiny: f64| {
        blocks.factor(
            &pattern,
            &[tiny, 1.0, 1.0, tiny, 1.0, 1.0, tiny],
            pattern.starts(),
            1e-15,
        )
    };
    assert_eq!(factor(&mut blocks, 0.1), Ok(()));
    assert_eq!(factor(&mut blocks, 1e-13), Err(Failure::Unsuited));
    assert_eq!(factor(&mut blocks, 0.0), Err(Failure::Unsuited));
    let zero = [0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0];
    let failure = blocks.factor(&pattern, &zero, pattern.starts(), 1e-15);
    assert_eq!(failure, Err(Failure::Line(0)));
}

/// Times on the pattern of the E-sail, with `--nocapture`; run with `--release --ignored`.
#[test]
#[ignore = "a measurement"]
fn time_of_tethers() {
    let median = |times: &mut Vec<f64>| {
        times.sort_by(f64::total_cmp);
        1e6 * times[times.len() / 2]
    };
    for (chains, length) in [(100, 15), (25, 15), (400, 31)] {
        let pattern = tethers(chains, length);
        let values = values(&pattern, numbers(1));
        let start = std::time::Instant::now();
        let mut blocks = factors_of::<f64>(&pattern).expect("a small pattern");
        let analysis = start.elapsed().as_secs_f64() * 1e6;
        let mut plain = factors_of::<f64>(&pattern).expect("a small pattern");
        plain.arch = Arch::Scalar;
        let mut sparse = Sparse::<f64>::new(&pattern).expect("a small pattern");
        let mut x = vec![1.0; pattern.columns()];
        let mut many = vec![1.0; 8 * pattern.columns()];
        let mut times = vec![Vec::new(); 8];
        for round in 0..200_000_000 / pattern.columns() / pattern.columns().max(10_000) * 100 + 20 {
            let mut time = |kind: usize, what: &mut dyn FnMut()| {
                let start = std::time::Instant::now();
                what();
                times[kind].push(start.elapsed().as_secs_f64());
            };
            let starts = pattern.starts();
            time(0, &mut || blocks.load(&pattern, &values, starts).expect("regular"));
            time(1, &mut || {
                blocks.factor(&pattern, &values, starts, 1e-15).expect("regular")
            });
            x.fill(1.0);
            time(2, &mut || blocks.solve(&mut x));
            many.fill(1.0);
            time(3, &mut || blocks.solve_many(&mut many, 8));
            if round % 20 == 0 {
                time(4, &mut || {
                    plain.factor(&pattern, &values, starts, 1e-15).expect("regular")
                });
                time(5, &mut || plain.solve(&mut x));
                time(6, &mut || sparse.factor(&pattern, &values, 1e-15).expect("regular"));
                time(7, &mut || sparse.solve(&mut x));
            }
        }
        let fused: usize = blocks
            .structure
            .nodes
            .iter()
            .map(|node| {
                let (n, m) = (node.size, node.below);
                n * (n - 1) * (2 * n - 1) / 6 + n * (n - 1) * m + n * m * m
            })
            .sum();
        println!(
            "{} unknowns, {} entries, {} factors, {fused} fused products, analysis {analysis:.0} us",
            pattern.columns(),
            pattern.entries(),
            blocks.values.len()
        );
        let names = [
            "load (baseline instructions)",
            "factor",
            "solve",
            "solve 8",
            "plain factor",
            "plain solve",
            "faer factor",
            "faer solve",
        ];
        for (name, times) in names.iter().zip(&mut times) {
            println!("{name:>30} {:8.1} us", median(times));
        }
    }
}
