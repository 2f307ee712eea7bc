//! The larger and the smaller of two numbers, as laws take them: what is no number, as a place beyond the rows of a table, stays none.
//! [`f64::max`] and [`f64::min`] would pass over it, and a limit take its place.

/// The larger of two; NaN if one of them is.
#[inline]
pub fn max(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// The smaller of two; NaN if one of them is.
#[inline]
pub fn min(a: f64, b: f64) -> f64 {
    if a < b || a.is_nan() { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_stays_none() {
        assert_eq!(
            [max(1.0, 2.0), max(2.0, 1.0), min(1.0, 2.0), min(2.0, 1.0)],
            [2.0, 2.0, 1.0, 1.0]
        );
        for of in [max, min] {
            assert!(of(f64::NAN, 1.0).is_nan() && of(1.0, f64::NAN).is_nan());
        }
    }
}
