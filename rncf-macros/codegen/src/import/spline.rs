//! Cubic splines through the rows of a table.

/// Slopes at the rows of the cubic spline through values at ascending places: slope and curvature have no steps, and at the first and last inner
/// row neither has the third derivative ("not a knot"), so that what follows a cubic is met exactly. Two rows make a line, three a parabola.
pub fn slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
    let last = places.len() - 1;
    let width = |at: usize| places[at + 1] - places[at];
    let rise = |at: usize| (values[at + 1] - values[at]) / width(at);
    if last == 1 {
        return vec![rise(0); 2];
    }
    if last == 2 {
        let bend = (rise(1) - rise(0)) / (width(0) + width(1));
        return vec![
            rise(0) - bend * width(0),
            rise(0) + bend * width(0),
            rise(1) + bend * width(1),
        ];
    }
    // Slope beside an end from the two spans there, the outer one first.
    let end = |outer: usize, inner: usize| {
        let both = width(outer) + width(inner);
        let sum = (width(outer) + 2.0 * both) * width(inner) * rise(outer) + width(outer) * width(outer) * rise(inner);
        [width(inner), both, sum / both]
    };
    smooth(places, values, [end(0, 1), end(last - 1, last - 2)])
}

/// The same of the spline that begins and ends with a slope of zero ("clamped").
pub fn clamped_slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
    smooth(places, values, [[1.0, 0.0, 0.0]; 2])
}

/// Slopes at the rows with a curvature that has no steps; at each end `pivot * slope + beside * slope of the row beside it = right`.
fn smooth(places: &[f64], values: &[f64], [first, end]: [[f64; 3]; 2]) -> Vec<f64> {
    let last = places.len() - 1;
    let width = |at: usize| places[at + 1] - places[at];
    let rise = |at: usize| (values[at + 1] - values[at]) / width(at);
    // Thomas's elimination of a tridiagonal system.
    let [pivot, beside, right] = first;
    let mut factors = vec![beside / pivot];
    let mut slopes = vec![right / pivot];
    for at in 1..last {
        let (before, after) = (width(at - 1), width(at));
        let pivot = 2.0 * (before + after) - after * factors[at - 1];
        let right = 3.0 * (after * rise(at - 1) + before * rise(at));
        factors.push(before / pivot);
        slopes.push((right - after * slopes[at - 1]) / pivot);
    }
    let [pivot, beside, right] = end;
    slopes.push((right - beside * slopes[last - 1]) / (pivot - beside * factors[last - 1]));
    for at in (0..last).rev() {
        slopes[at] -= factors[at] * slopes[at + 1];
    }
    slopes
}

/// Value and first three derivatives of Hermite's cubic within a span of a width, at a share of it, from the values and slopes at its ends.
pub fn cubic(width: f64, [from, to]: [f64; 2], slopes: [f64; 2], share: f64) -> [f64; 4] {
    let rise = to - from;
    let [start, end] = slopes.map(|slope| width * slope);
    let (bend, tilt) = (share * (1.0 - share), 1.0 - 2.0 * share);
    let bent = (1.0 - share) * (start - rise) - share * (end - rise);
    let slope = rise + tilt * bent - bend * (start + end - 2.0 * rise);
    // Second and third derivative with respect to the share.
    let jerk = 6.0 * (start + end - 2.0 * rise);
    let curvature = 6.0 * rise - 4.0 * start - 2.0 * end + share * jerk;
    [
        from + share * rise + bend * bent,
        slope / width,
        curvature / width / width,
        jerk / width / width / width,
    ]
}

/// Slope of the monotone cubic (Fritsch and Carlson) at a row, seen from the span that begins at row `span`: the harmonic mean of the slopes beside it, none where
/// these differ in sign or where there is a step or an end.
pub fn monotone_slope(places: &[f64], values: &[f64], row: usize, span: usize) -> f64 {
    let width = |from: usize| places[from + 1] - places[from];
    let rise = |from: usize| (values[from + 1] - values[from]) / width(from);
    let other = if row == span { row.checked_sub(1) } else { Some(row) };
    let Some(other) = other.filter(|&from| from + 1 < places.len() && width(from) > 0.0) else {
        return rise(span);
    };
    let (before, after) = (span.min(other), span.max(other));
    let (left, right) = (rise(before), rise(after));
    if left * right <= 0.0 {
        return 0.0;
    }
    let weights = [2.0 * width(after) + width(before), width(after) + 2.0 * width(before)];
    (weights[0] + weights[1]) / (weights[0] / left + weights[1] / right)
}

/// Rows beyond which the ends of a spline are not felt: each row leaves a quarter of what comes from them.
const BEYOND: usize = 40;

/// The same of the spline that goes on as its rows repeat, the last of which is the first one again.
pub fn periodic_slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
    let last = places.len() - 1;
    let period = places[last] - places[0];
    let turns = 1 + BEYOND / last;
    let (mut all, mut repeated) = (Vec::new(), Vec::new());
    for turn in 0..=2 * turns {
        let away = period * (turn as f64 - turns as f64);
        all.extend(places[..last].iter().map(|place| place + away));
        repeated.extend_from_slice(&values[..last]);
    }
    let mut slopes = slopes(&all, &repeated)[turns * last..=(turns + 1) * last].to_vec();
    slopes[last] = slopes[0];
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spline_through_rows_of_a_polynomial_has_its_slopes() {
        for (rows, degree) in [(2, 1), (3, 2), (4, 3), (5, 3), (9, 3)] {
            let places: Vec<f64> = (0..rows).map(|row| f64::from(row) + 0.3 * f64::from(row % 3)).collect();
            let value = |x: &f64| (0..=degree).map(|power| (x - 1.7).powi(power)).sum::<f64>();
            let slope = |x: &f64| {
                (1..=degree)
                    .map(|power| f64::from(power) * (x - 1.7).powi(power - 1))
                    .sum::<f64>()
            };
            let values: Vec<f64> = places.iter().map(value).collect();
            for (place, found) in places.iter().zip(slopes(&places, &values)) {
                assert!(
                    (found - slope(place)).abs() < 1e-12 * (1.0 + slope(place).abs()),
                    "{rows} rows: {place}"
                );
            }
        }
    }

    /// Slopes at the rows by scipy 1.17, `CubicSpline(x, y, bc_type="periodic")`.
    #[test]
    fn periodic_slopes_are_those_of_an_independent_program() {
        let cases: [(&[f64], &[f64], &[f64]); 2] = [
            (
                &[0.0, 0.4, 0.5, 1.3, 2.0, 2.2],
                &[1.0, -0.5, 0.25, 2.0, 1.5, 1.0],
                &[
                    -4.822141541740267,
                    5.105352417356241,
                    8.12965434204447,
                    -0.6140974956503295,
                    -1.2112515834573176,
                    -4.822141541740267,
                ],
            ),
            (
                &[-1.0, 0.5, 3.0],
                &[0.0, 1.0, 0.0],
                &[0.2666666666666666, 0.2666666666666666, 0.2666666666666666],
            ),
        ];
        for (places, values, wanted) in cases {
            for (found, wanted) in periodic_slopes(places, values).into_iter().zip(wanted) {
                assert!(
                    (found - wanted).abs() < 1e-12 * wanted.abs().max(1.0),
                    "{found} {wanted}"
                );
            }
        }
    }

    /// Slopes at the rows by scipy 1.17, `CubicSpline(x, y, bc_type="not-a-knot")`.
    #[test]
    fn slopes_are_those_of_an_independent_program() {
        let places = [0.0, 0.4, 0.5, 1.3, 2.0, 2.2];
        let values = [1.0, -0.5, 0.25, 2.0, 1.5, 1.75];
        let wanted = [
            -23.12709422628267,
            7.325418845256537,
            7.155726443429332,
            -0.8439267437802158,
            0.5027950083180012,
            2.085975578874585,
        ];
        for (found, wanted) in slopes(&places, &values).into_iter().zip(wanted) {
            assert!(
                (found - wanted).abs() < 1e-12 * wanted.abs().max(1.0),
                "{found} {wanted}"
            );
        }
    }
}
