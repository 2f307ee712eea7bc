//! Which mode is which when a parameter changes.

use super::Mode;
use crate::linalg::c64;

/// Assurance below this tells two modes from each other.
const SAME: f64 = 0.25;
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
    let fit = |a: &Mode, b: &Mode| assurance(&a.shape, &b.shape, weights);
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
            // What is not the same mode is as good as none.
            *cost = if fit >= SAME { -fit - NEARNESS * near(a, b) } else { 0.0 };
        }
    }
    let partners = assignment(&cost);
    let real = |(row, column): (usize, usize)| (column < after.len() && cost[row][column] < 0.0).then_some(column);
    partners.into_iter().enumerate().take(before.len()).map(real).collect()
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
