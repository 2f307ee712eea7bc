//! What emitted code needs to check parameters and to pass slices as arrays.

use crate::error::ModelError;

/// Relative size of what counts as round-off in moments of inertia.
const ROUND_OFF: f64 = 1e-10;

/// Relative size of what counts as round-off of declared properties of a section.
const DECLARED: f64 = 1e-6;

fn check(holds: bool, owner: &str, name: &str, value: f64, unit: &str, range: &str) -> Result<f64, ModelError> {
    if holds {
        return Ok(value);
    }
    Err(ModelError::new(format!(
        "{owner}: {name} is {value} {unit}, it must be {range}"
    )))
}

/// `value`, if it is greater than zero.
///
/// # Errors
/// The property by name.
pub fn positive(owner: &str, name: &str, value: f64, unit: &str) -> Result<f64, ModelError> {
    check(
        value.is_finite() && value > 0.0,
        owner,
        name,
        value,
        unit,
        "greater than zero",
    )
}

/// `value`, if it is not negative.
///
/// # Errors
/// The property by name.
pub fn non_negative(owner: &str, name: &str, value: f64, unit: &str) -> Result<f64, ModelError> {
    check(
        value.is_finite() && value >= 0.0,
        owner,
        name,
        value,
        unit,
        "zero or greater",
    )
}

/// `value`, if it is a number.
///
/// # Errors
/// The property by name.
pub fn finite(owner: &str, name: &str, value: f64, unit: &str) -> Result<f64, ModelError> {
    check(value.is_finite(), owner, name, value, unit, "finite")
}

/// `value`, if it is a Poisson's ratio.
///
/// # Errors
/// The property by name.
pub fn poisson(owner: &str, name: &str, value: f64, unit: &str) -> Result<f64, ModelError> {
    check(
        value > -1.0 && value < 0.5,
        owner,
        name,
        value,
        unit,
        "between -1 and 0.5",
    )
}

/// `value`, if it is a part of a whole.
///
/// # Errors
/// The property by name.
pub fn part(owner: &str, name: &str, value: f64, unit: &str) -> Result<f64, ModelError> {
    check(
        value > 0.0 && value <= 1.0,
        owner,
        name,
        value,
        unit,
        "greater than zero and at most 1",
    )
}

/// Checks that some section has an area (m^2), second moments about y and z, a torsion constant (m^4), and distances of
/// the outermost fibre along y and z (m); what is not known is NaN.
///
/// # Errors
/// The property that is too large for the others.
pub fn section(owner: &str, [area, y, z, torsion, extent_y, extent_z]: [f64; 6]) -> Result<(), ModelError> {
    let bounds = [
        ("torsion_constant", torsion, y + z, "the sum of the second moments"),
        ("second_moment_z", z, area * extent_y * extent_y, "area * extent_y^2"),
        ("second_moment_y", y, area * extent_z * extent_z, "area * extent_z^2"),
    ];
    for (name, value, most, what) in bounds {
        if value > most * (1.0 + DECLARED) {
            return Err(ModelError::new(format!(
                "{owner}: no section has a {name} of {value:e} m^4, it is at most {what}, {most:e} m^4"
            )));
        }
    }
    Ok(())
}

/// Checks an inertia about the centre of mass (kg m^2: xx, yy, zz, xy, xz, yz) in space.
///
/// # Errors
/// An inertia that no body has.
pub fn inertia(owner: &str, inertia: [f64; 6]) -> Result<(), ModelError> {
    if is_inertia(inertia) {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "{owner}: no body has the inertia {inertia:?} kg*m^2: no principal moment may be negative or greater than the sum of the other two"
    )))
}

/// Whether `tr(J)/2 I - J`, the second moments of a body's mass, is positive semidefinite: then the
/// principal moments of J are so, too, and none is greater than the sum of the others.
fn is_inertia([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> bool {
    let half = 0.5 * (xx + yy + zz);
    let [a, b, c] = [half - xx, half - yy, half - zz];
    let size = half.max(xx.abs()).max(yy.abs()).max(zz.abs());
    let least = |power: i32| -ROUND_OFF * size.powi(power);
    let minors = [a * b - xy * xy, a * c - xz * xz, b * c - yz * yz];
    let determinant = a * minors[2] - xy * (xy * c + yz * xz) - xz * (xy * yz + b * xz);
    size.is_finite()
        && [a, b, c].iter().all(|&value| value >= least(1))
        && minors.iter().all(|&value| value >= least(2))
        && determinant >= least(3)
}

/// A slice as an array.
///
/// # Panics
/// If the length differs: a defect of generated code.
pub fn array<T, const N: usize>(slice: &[T]) -> &[T; N] {
    slice
        .try_into()
        .expect("generated code passes slices of the element's size")
}

/// A mutable slice as an array.
///
/// # Panics
/// If the length differs: a defect of generated code.
pub fn array_mut<T, const N: usize>(slice: &mut [T]) -> &mut [T; N] {
    slice
        .try_into()
        .expect("generated code passes slices of the element's size")
}

#[cfg(test)]
mod tests {
    /// Inertia of unit point masses about the origin: sum (r.r I - r r^T).
    fn of_points(points: &[[f64; 3]]) -> [f64; 6] {
        let mut inertia = [0.0; 6];
        for [x, y, z] in points {
            let terms = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
            for (sum, term) in inertia.iter_mut().zip(terms) {
                *sum += term;
            }
        }
        inertia
    }

    #[test]
    fn what_points_have_is_possible_and_a_little_less_is_not() {
        // In a plane the triangle's inequality is an equation; a line has a moment of zero.
        let points = [[1.0, 2.0, -0.5], [-0.3, 0.4, 2.0], [0.2, -1.0, 0.7]];
        for count in 0..=3 {
            let mut inertia = of_points(&points[..count]);
            assert!(super::inertia("body", inertia).is_ok(), "{count}");
            if count < 3 {
                // The second moments of mass, singular for fewer than three points, less 1e-3 I.
                inertia[..3].iter_mut().for_each(|moment| *moment -= 2e-3);
                assert!(super::inertia("body", inertia).is_err(), "{count}");
            }
        }
        assert!(super::inertia("body", [0.0, 0.0, 0.1, 0.0, 0.0, 0.0]).is_err());
        assert!(super::inertia("body", [f64::NAN; 6]).is_err());
    }
}
