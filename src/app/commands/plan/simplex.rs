//! The least value of a function in the unit cube, from its values alone: the simplex of Nelder and Mead (1965), with the
//! coefficients of Gao and Han (2012) for many dimensions.
//!
//! Points outside of the cube are moved onto its faces. There a simplex may lose its volume; so the search begins anew
//! around the best point until that brings nothing.

/// Size of the first simplex, and of later ones, in parts of the cube.
const SIZES: [f64; 2] = [0.1, 0.03];
/// Most new beginnings.
const MOST_BEGINNINGS: usize = 8;

/// A point of the cube and the value there.
pub(super) type Valued = (Vec<f64>, f64);

/// Goes down from `start` until the corners of the simplex lie within `precision` of each other, and a new simplex finds
/// the same; the best point. `value` may be infinite where there is none.
///
/// # Errors
/// That of `value`.
pub(super) fn descend<E>(
    start: Valued,
    precision: f64,
    mut value: impl FnMut(&[f64]) -> Result<f64, E>,
) -> Result<Valued, E> {
    let mut best = start;
    for beginning in 0..MOST_BEGINNINGS {
        let size = SIZES[beginning.min(1)];
        let found = one_descent(&best, size, precision, &mut value)?;
        let (moved, gained) = (distance(&found.0, &best.0), best.1 - found.1);
        let is_better = found.1 < best.1;
        if is_better {
            best = found;
        }
        let is_settled = !is_better || moved <= 10.0 * precision || gained <= 1e-12 * best.1.abs();
        if beginning > 0 && is_settled {
            break;
        }
    }
    Ok(best)
}

fn one_descent<E>(
    start: &Valued,
    size: f64,
    precision: f64,
    value: &mut impl FnMut(&[f64]) -> Result<f64, E>,
) -> Result<Valued, E> {
    let dimension = start.0.len();
    let n = dimension.max(2) as f64;
    let (expansion, contraction, shrinkage) = (1.0 + 2.0 / n, 0.75 - 0.5 / n, 1.0 - 1.0 / n);
    let mut corners = vec![start.clone()];
    for axis in 0..dimension {
        let mut corner = start.0.clone();
        corner[axis] += if corner[axis] + size <= 1.0 { size } else { -size };
        let height = value(&corner)?;
        corners.push((corner, height));
    }
    loop {
        // A stable sort: of equal values the older one counts as the better.
        corners.sort_by(|a, b| a.1.total_cmp(&b.1));
        let diameter = corners.iter().map(|corner| distance(&corner.0, &corners[0].0));
        if diameter.fold(0.0, f64::max) <= precision {
            return Ok(corners.swap_remove(0));
        }
        let worst = corners[dimension].clone();
        let centre: Vec<f64> = (0..dimension)
            .map(|axis| corners[..dimension].iter().map(|corner| corner.0[axis]).sum::<f64>() / dimension as f64)
            .collect();
        // On the line from the worst corner through the middle of the others, which is at 0.
        let along = |part: f64| -> Vec<f64> {
            let axes = centre.iter().zip(&worst.0);
            axes.map(|(middle, bad)| (middle + part * (middle - bad)).clamp(0.0, 1.0))
                .collect()
        };
        let mut at = |part: f64| {
            let point = along(part);
            let height = value(&point)?;
            Ok((point, height))
        };
        let reflected = at(1.0)?;
        let taken = if reflected.1 < corners[0].1 {
            let expanded = at(expansion)?;
            Some(if expanded.1 < reflected.1 { expanded } else { reflected })
        } else if reflected.1 < corners[dimension.max(1) - 1].1 {
            Some(reflected)
        } else {
            let outside = reflected.1 < worst.1;
            let contracted = at(if outside { contraction } else { -contraction })?;
            (contracted.1 < reflected.1.min(worst.1)).then_some(contracted)
        };
        if let Some(taken) = taken {
            corners[dimension] = taken;
            continue;
        }
        let best = corners[0].0.clone();
        for corner in &mut corners[1..] {
            let axes = corner.0.iter().zip(&best);
            let point: Vec<f64> = axes.map(|(own, best)| best + shrinkage * (own - best)).collect();
            let height = value(&point)?;
            *corner = (point, height);
        }
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn least(start: &[f64], function: impl Fn(&[f64]) -> f64) -> (Valued, usize) {
        let mut count = 0;
        let value = |point: &[f64]| {
            count += 1;
            assert!(point.iter().all(|x| (0.0..=1.0).contains(x)), "{point:?}");
            Ok::<_, ()>(function(point))
        };
        let found = descend((start.to_vec(), function(start)), 1e-6, value).unwrap();
        (found, count)
    }

    /// Rosenbrock's valley, from -2 to 2; the least value is 0 at (1, 1).
    #[test]
    fn the_valley_of_rosenbrock_is_followed() {
        let valley = |point: &[f64]| {
            let (x, y) = (4.0 * point[0] - 2.0, 4.0 * point[1] - 2.0);
            (1.0 - x).powi(2) + 100.0 * (y - x * x).powi(2)
        };
        let ((point, value), count) = least(&[0.2, 0.75], valley);
        assert!(
            distance(&point, &[0.75, 0.75]) < 1e-5 && value < 1e-9,
            "{point:?} {value}"
        );
        assert!(count < 400, "{count}");
    }

    #[test]
    fn a_minimum_on_faces_of_the_cube_is_found_and_so_is_one_beside_what_fails() {
        // The least value in the cube is at (1, 0, 0.4): two faces hold it.
        let bowl = |point: &[f64]| (point[0] - 1.5).powi(2) + point[1] + (point[2] - 0.4).powi(2);
        let ((point, _), _) = least(&[0.3, 0.3, 0.9], bowl);
        assert!(distance(&point, &[1.0, 0.0, 0.4]) < 1e-5, "{point:?}");
        let beside = |point: &[f64]| match point[0] {
            x if x < 0.6 => f64::INFINITY,
            x => (x - 0.7).powi(2),
        };
        let ((point, _), count) = least(&[0.95], beside);
        assert!((point[0] - 0.7).abs() < 1e-5 && count < 100, "{point:?} {count}");
    }
}
