//! Which points are worth taking: the Pareto front of error over cost, and the cheapest for an error.

/// Indices of the points (cost, error) that no other one beats in both, the cheapest first. Of equal points the first.
pub(super) fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| {
        let (a, b) = (points[a], points[b]);
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let mut least = f64::INFINITY;
    order.retain(|&index| {
        let is_better = points[index].1 < least;
        least = least.min(points[index].1);
        is_better
    });
    order
}

/// Index of the cheapest point (cost, error) with an error of at most `wanted`.
pub(super) fn cheapest(points: &[(f64, f64)], wanted: f64) -> Option<usize> {
    front(points).into_iter().find(|&index| points[index].1 <= wanted)
}

/// Cost at which the front of the points (cost, error) reaches an error, between two of them on a straight line in
/// logarithms; `None` where no point is that good. An error that the cheapest point undercuts costs as much as that.
pub(super) fn cost_at(points: &[(f64, f64)], wanted: f64) -> Option<f64> {
    let front = front(points);
    let after = front.iter().position(|&index| points[index].1 <= wanted)?;
    let (cost, error) = points[front[after]];
    let Some(before) = after.checked_sub(1) else {
        return Some(cost);
    };
    let (cost_before, error_before) = points[front[before]];
    if !(error > 0.0 && cost_before > 0.0) {
        return Some(cost);
    }
    let share = (error_before / wanted).ln() / (error_before / error).ln();
    Some(cost_before * (cost / cost_before).powf(share))
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [(f64, f64); 7] = [
        (4.0, 1e-4),
        (1.0, 1e-2),
        (2.0, 1e-2),
        (2.0, 1e-3),
        (8.0, 1e-3),
        (16.0, 1e-6),
        (16.0, 1e-6),
    ];

    #[test]
    fn the_front_has_what_nothing_beats_in_both() {
        assert_eq!(front(&POINTS), [1, 3, 0, 5]);
        assert!(front(&[]).is_empty());
        // Two of the same cost: only the better one.
        assert_eq!(front(&[(1.0, 0.2), (1.0, 0.1)]), [1]);
    }

    #[test]
    fn the_cheapest_that_suffices_is_found() {
        for (wanted, expected) in [
            (1.0, Some(1)),
            (1e-2, Some(1)),
            (5e-4, Some(0)),
            (1e-6, Some(5)),
            (1e-7, None),
        ] {
            assert_eq!(cheapest(&POINTS, wanted), expected, "{wanted}");
        }
    }

    #[test]
    fn costs_between_points_lie_on_a_line_in_logarithms() {
        let cost = |wanted| cost_at(&POINTS, wanted);
        assert_eq!(cost(0.5), Some(1.0));
        assert_eq!(cost(1e-7), None);
        let half_way = 10f64.powf(-2.5);
        assert!((cost(half_way).unwrap() - 2f64.sqrt()).abs() < 1e-12);
        assert!((cost(1e-5).unwrap() - 8.0).abs() < 1e-12);
        assert!((cost(1e-4).unwrap() - 4.0).abs() < 1e-12);
    }
}
