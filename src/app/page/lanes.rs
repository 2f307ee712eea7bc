//! Rows for the names of vertical lines over a chart, so that none lies on another.

/// Width of a character, and height of a row, in units of its size.
const CHARACTER: f64 = 0.56;
const ROW: f64 = 1.2;

/// The row of each name, counted from the chart, where names of characters of this size are centred at these places, in units of a drawing.
pub(super) fn lanes<'n>(names: impl Iterator<Item = (f64, &'n str)>, size: u32) -> Vec<usize> {
    let half = |name: &str| 0.5 * CHARACTER * f64::from(size) * (name.chars().count() + 1) as f64;
    let spans: Vec<[f64; 2]> = names
        .map(|(place, name)| [place - half(name), place + half(name)])
        .collect();
    let mut order: Vec<usize> = (0..spans.len()).collect();
    order.sort_by(|&a, &b| spans[a][0].total_cmp(&spans[b][0]));
    let mut ends: Vec<f64> = Vec::new();
    let mut lanes = vec![0; spans.len()];
    for index in order {
        let [from, to] = spans[index];
        let free = ends.iter().position(|&end| end <= from).unwrap_or(ends.len());
        ends.resize(ends.len().max(free + 1), to);
        ends[free] = to;
        lanes[index] = free;
    }
    lanes
}

/// How far above the chart a row begins, in units of a drawing.
pub(super) fn above(lane: usize, size: u32) -> u32 {
    (ROW * f64::from(size) * lane as f64) as u32
}

/// Height of what stands over a chart with names in these rows.
pub(super) fn height(lanes: &[usize], size: u32) -> u32 {
    lanes.iter().max().map_or(24, |&last| 100 + above(last, size))
}

#[cfg(test)]
mod tests {
    use super::{height, lanes};

    #[test]
    fn names_that_lie_on_each_other_stand_in_rows() {
        let found = lanes(
            [
                (900.0, "critical 2"),
                (0.0, "critical 1"),
                (950.0, "critical 3"),
                (2000.0, "x"),
            ]
            .into_iter(),
            64,
        );
        assert_eq!(found, [0, 0, 1, 0]);
        assert!(height(&found, 64) > height(&[0], 64) && height(&[0], 64) > height(&[], 64));
    }
}
