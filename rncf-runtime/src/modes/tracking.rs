//! Which mode is which when a parameter changes.

use super::mode::Mode;
use crate::linalg::c64;

/// Assurance below this tells two modes from each other.
const SAME: f64 = 0.25;
/// The same of modes that are followed.
const CLEAR: f64 = 0.6;
/// Relative distance of eigenvalues that are one.
const EQUAL: f64 = 1e-6;
/// Part of a shape beside others that is new.
const NEW: f64 = 1e-3;
/// Weight of the nearness of eigenvalues beside the assurance: decides between shapes that fit equally,
/// as those of modes of equal frequency do.
const NEARNESS: f64 = 0.1;

/// Modal assurance criterion `|a^H W b|^2 / ((a^H W a) (b^H W b))`, 0 to 1: whether two shapes are one up
/// to a complex factor. `weights` are the diagonal of W, one for each unknown: 1 / size^2, or masses. 0
/// where a shape vanishes.
pub fn assurance(a: &[[f64; 2]], b: &[[f64; 2]], weights: &[f64]) -> f64 {
    let complex = |value: &[f64; 2]| c64::new(value[0], value[1]);
    let product = |a: &[[f64; 2]], b: &[[f64; 2]]| {
        let parts = a.iter().zip(b).zip(weights);
        parts
            .map(|((a, b), weight)| complex(a).conj() * complex(b) * *weight)
            .sum::<c64>()
    };
    let sizes = product(a, a).re * product(b, b).re;
    let part = product(a, b).norm_sqr() / sizes;
    if part.is_finite() { part.min(1.0) } else { 0.0 }
}

/// For every mode before, its index among the modes after, or `None` where it is lost; what no index
/// names is new. One to one, with the largest sum of assurance and (a little) nearness of eigenvalues.
/// `weights` as of [`assurance`].
pub fn matched(before: &[Mode], after: &[Mode], weights: &[f64]) -> Vec<Option<usize>> {
    best(before, after, SAME, |a, b| assurance(&a.shape, &b.shape, weights))
}

/// One to one, with the largest sum of fits and (a little) nearness of eigenvalues; what fits less than `least` is as good
/// as none.
fn best(before: &[Mode], after: &[Mode], least: f64, fit: impl Fn(&Mode, &Mode) -> f64) -> Vec<Option<usize>> {
    let near = |a: &Mode, b: &Mode| {
        let distance = (a.re - b.re).hypot(a.im - b.im);
        let size = a.re.hypot(a.im) + b.re.hypot(b.im);
        if size > 0.0 { 1.0 - distance / size } else { 1.0 }
    };
    let size = before.len().max(after.len());
    let mut cost = vec![vec![0.0; size]; size];
    for (a, row) in before.iter().zip(&mut cost) {
        for (b, cost) in after.iter().zip(row) {
            let fit = fit(a, b);
            *cost = if fit >= least {
                -fit - NEARNESS * near(a, b)
            } else {
                0.0
            };
        }
    }
    let partners = assignment(&cost);
    let real = |(row, column): (usize, usize)| (column < after.len() && cost[row][column] < 0.0).then_some(column);
    partners.into_iter().enumerate().take(before.len()).map(real).collect()
}

/// For every mode before, its index among the modes after and the mode that goes on there, or `None` where it is lost.
/// First by the shapes alone. What is left may have mixed: of modes with equal or, within `tolerance` (rad/s), nearly equal
/// eigenvalues only the space is the same before and after, and where they are equal after, the mode that goes on is the
/// part in this space of that before. Then as conjugates: a frequency that passes zero comes back.
pub fn followed(before: &[Mode], after: &[Mode], weights: &[f64], tolerance: f64) -> Vec<Option<(usize, Mode)>> {
    let mut partners: Vec<Option<(usize, Mode)>> = vec![None; before.len()];
    let one = |a: &Mode, b: &Mode| assurance(&a.shape, &b.shape, weights);
    let close = |a: &Mode, b: &Mode, tolerance: f64| {
        let size = a.re.hypot(a.im) + b.re.hypot(b.im);
        (a.re - b.re).hypot(a.im - b.im) <= tolerance + EQUAL * size
    };
    for is_conjugate in [false, true] {
        for mixed in [false, true] {
            let lost: Vec<usize> = (0..before.len()).filter(|&index| partners[index].is_none()).collect();
            let is_taken = |index: &usize| partners.iter().flatten().any(|(taken, _)| taken == index);
            let new: Vec<usize> = (0..after.len()).filter(|index| !is_taken(index)).collect();
            let turned = |mode: &Mode| if is_conjugate { mode.conjugate() } else { mode.clone() };
            let all: Vec<Mode> = before.iter().map(turned).collect();
            let first: Vec<Mode> = lost.iter().map(|&index| all[index].clone()).collect();
            let rest: Vec<Mode> = new.iter().map(|&index| after[index].clone()).collect();
            let fit = |a: &Mode, b: &Mode| {
                if !mixed {
                    return one(a, b);
                }
                let beside = |all: &[Mode], mode: &Mode| -> Vec<Vec<[f64; 2]>> {
                    let close = all.iter().filter(|other| close(mode, other, tolerance));
                    close.map(|other| other.shape.clone()).collect()
                };
                let forth = part_in(&b.shape, &beside(&all, a), weights).0;
                let back = part_in(&a.shape, &beside(after, b), weights).0;
                forth.max(back)
            };
            for (place, partner) in best(&first, &rest, CLEAR, fit).into_iter().enumerate() {
                let Some(partner) = partner else { continue };
                let index = new[partner];
                let mut mode = after[index].clone();
                let equal = after.iter().filter(|other| close(&mode, other, 0.0));
                let space: Vec<Vec<[f64; 2]>> = equal.map(|other| other.shape.clone()).collect();
                if space.len() > 1 {
                    let (fit, part) = part_in(&first[place].shape, &space, weights);
                    if fit >= CLEAR {
                        mode.shape = part;
                    }
                }
                partners[lost[place]] = Some((index, mode));
            }
        }
    }
    partners
}

/// Part of a shape in the span of others, 0 to 1, and that part.
fn part_in(shape: &[[f64; 2]], space: &[Vec<[f64; 2]>], weights: &[f64]) -> (f64, Vec<[f64; 2]>) {
    let complex =
        |values: &[[f64; 2]]| -> Vec<c64> { values.iter().map(|value| c64::new(value[0], value[1])).collect() };
    let product = |a: &[c64], b: &[c64]| -> c64 {
        let parts = a.iter().zip(b).zip(weights);
        parts.map(|((a, b), weight)| a.conj() * b * *weight).sum()
    };
    let mut basis: Vec<Vec<c64>> = Vec::new();
    for other in space {
        let mut vector = complex(other);
        let size = product(&vector, &vector).re.sqrt();
        for known in basis.iter().chain(&basis) {
            let part = product(known, &vector);
            vector.iter_mut().zip(known).for_each(|(value, of)| *value -= part * of);
        }
        let rest = product(&vector, &vector).re.sqrt();
        if rest > NEW * size {
            vector.iter_mut().for_each(|value| *value /= rest);
            basis.push(vector);
        }
    }
    let whole = complex(shape);
    let mut sum = vec![c64::default(); whole.len()];
    let mut found = 0.0;
    for vector in &basis {
        let part = product(vector, &whole);
        found += part.norm_sqr();
        sum.iter_mut().zip(vector).for_each(|(sum, of)| *sum += part * of);
    }
    let part = found / product(&whole, &whole).re;
    let part = if part.is_finite() { part.min(1.0) } else { 0.0 };
    (part, sum.iter().map(|value| [value.re, value.im]).collect())
}

/// The column of every row such that the sum of the costs is least: shortest augmenting paths (Kuhn and
/// Munkres), for a square matrix.
fn assignment(cost: &[Vec<f64>]) -> Vec<usize> {
    let n = cost.len();
    // Row n and column n stand for none.
    let (mut rows, mut columns) = (vec![0.0; n + 1], vec![0.0; n + 1]);
    let mut row_of = vec![n; n + 1];
    for row in 0..n {
        row_of[n] = row;
        let mut column = n;
        let mut least = vec![f64::INFINITY; n];
        let mut from = vec![n; n];
        let mut used = vec![false; n + 1];
        while row_of[column] < n {
            used[column] = true;
            let current = row_of[column];
            for other in 0..n {
                let reduced = cost[current][other] - rows[current] - columns[other];
                if !used[other] && reduced < least[other] {
                    (least[other], from[other]) = (reduced, column);
                }
            }
            let open = (0..n).filter(|&other| !used[other]);
            let next = open.min_by(|&a, &b| least[a].total_cmp(&least[b])).unwrap_or(n);
            let step = least[next];
            for other in 0..=n {
                if used[other] {
                    rows[row_of[other]] += step;
                    columns[other] -= step;
                } else if other < n {
                    least[other] -= step;
                }
            }
            column = next;
        }
        while column < n {
            let before = from[column];
            row_of[column] = row_of[before];
            column = before;
        }
    }
    let mut partner = vec![0; n];
    for column in 0..n {
        partner[row_of[column]] = column;
    }
    partner
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mode(im: f64, shape: &[[f64; 2]]) -> Mode {
        Mode {
            re: 0.0,
            im,
            shape: shape.to_vec(),
        }
    }

    #[test]
    fn assurance_does_not_see_a_phase() {
        let a = [[1.0, 0.0], [0.0, 2.0]];
        let turned = [[0.0, 3.0], [-6.0, 0.0]];
        assert!((assurance(&a, &turned, &[1.0, 1.0]) - 1.0).abs() < 1e-15);
        // (1, 2i) and (1, -2i) with weights 4 and 1 are orthogonal.
        let conjugate = [[1.0, 0.0], [0.0, -2.0]];
        assert!(assurance(&a, &conjugate, &[4.0, 1.0]) < 1e-15);
        assert_eq!(assurance(&a, &[[0.0; 2]; 2], &[1.0, 1.0]), 0.0);
    }

    #[test]
    fn the_best_total_wins() {
        // The first one fits the first place best, but the second one fits nowhere else.
        assert_eq!(assignment(&[vec![-0.9, -0.8], vec![-0.8, 0.0]]), [1, 0]);
        let cost = [
            [7.0, 5.0, 9.0, 8.0],
            [9.0, 4.0, 3.0, 7.0],
            [3.0, 8.0, 1.0, 8.0],
            [2.0, 2.0, 9.0, 1.0],
        ];
        let rows: Vec<Vec<f64>> = cost.iter().map(|row| row.to_vec()).collect();
        // By hand: 5 + 3 + 3 + 1 = 12.
        let total: f64 = assignment(&rows)
            .iter()
            .zip(&rows)
            .map(|(&column, row)| row[column])
            .sum();
        assert_eq!(total, 12.0);
    }

    #[test]
    fn modes_that_cross_keep_their_shapes() {
        let (x, y) = ([[1.0, 0.0], [0.05, 0.0]], [[0.05, 0.0], [1.0, 0.0]]);
        let before = [mode(1.0, &x), mode(1.1, &y)];
        let after = [mode(1.04, &y), mode(1.06, &x)];
        assert_eq!(matched(&before, &after, &[1.0, 1.0]), [Some(1), Some(0)]);
    }

    #[test]
    fn lost_and_new_modes_have_no_partner() {
        let [a, b, c]: [Vec<[f64; 2]>; 3] =
            std::array::from_fn(|i| (0..3).map(|j| [if i == j { 1.0 } else { 0.0 }, 0.0]).collect());
        let weights = [1.0; 3];
        let before = [mode(1.0, &a), mode(2.0, &b)];
        assert_eq!(matched(&before, &[mode(2.1, &b)], &weights), [None, Some(0)]);
        assert_eq!(
            matched(&before, &[mode(1.0, &c), mode(1.0, &a)], &weights),
            [Some(1), None]
        );
        assert_eq!(matched(&before, &[], &weights), [None, None]);
        assert_eq!(matched(&[], &before, &weights), []);
    }

    #[test]
    fn equal_shapes_go_to_the_nearest_frequency() {
        let x = [[1.0, 0.0]];
        let before = [mode(1.0, &x), mode(5.0, &x)];
        let after = [mode(5.2, &x), mode(1.1, &x)];
        assert_eq!(matched(&before, &after, &[1.0]), [Some(1), Some(0)]);
    }
}
