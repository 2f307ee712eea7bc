//! Products of units, and numbers scaled by them without a rounding of their own.

use super::table::Unit;

/// A product of powers of units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compound {
    /// Exponents of m, kg, s, K, A, angle.
    pub dimension: [i8; 6],
    /// Power of ten towards SI.
    pub decimal: i32,
    /// Factor that is no power of ten.
    pub factor: f64,
}

impl Compound {
    /// No unit.
    pub const ONE: Compound = Compound {
        dimension: [0; 6],
        decimal: 0,
        factor: 1.0,
    };

    /// Multiplied by a power of a unit; `None` where an exponent is too large.
    pub fn times(self, unit: &Unit, exponent: i32) -> Option<Self> {
        let mut result = self;
        for (total, own) in result.dimension.iter_mut().zip(unit.dimension) {
            *total = i8::try_from(i32::from(*total) + i32::from(own).checked_mul(exponent)?).ok()?;
        }
        result.decimal = result.decimal.checked_add(unit.decimal.checked_mul(exponent)?)?;
        if unit.factor != 1.0 {
            result.factor *= unit.factor.powi(exponent);
        }
        Some(result)
    }

    /// One of these units in SI.
    pub fn si(self) -> f64 {
        scale("1", self).unwrap_or(f64::NAN)
    }
}

/// Why the text of a number has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleError {
    /// Not a decimal number: hexadecimal, or with a suffix.
    NotDecimal,
    /// Too large, or so small that it became zero.
    Range,
}

/// Value in SI of a decimal number in some unit: the power of ten of the unit is added to the
/// exponent of the text before it is read, so that there is one rounding only; a factor that is no
/// power of ten (deg, rpm, min) multiplies.
///
/// # Errors
/// Text that is no decimal number, and values outside the range of f64.
pub fn scale(text: &str, unit: Compound) -> Result<f64, ScaleError> {
    let plain: String = text.chars().filter(|c| *c != '_').collect();
    let (mantissa, exponent) = match plain.find(['e', 'E']) {
        Some(at) => (
            &plain[..at],
            plain[at + 1..].parse::<i32>().map_err(|_| ScaleError::NotDecimal)?,
        ),
        None => (plain.as_str(), 0),
    };
    if mantissa.is_empty() || !mantissa.chars().all(|c| c.is_ascii_digit() || c == '.') {
        return Err(ScaleError::NotDecimal);
    }
    let exponent = exponent.checked_add(unit.decimal).ok_or(ScaleError::Range)?;
    let decimal: f64 = format!("{mantissa}e{exponent}")
        .parse()
        .map_err(|_| ScaleError::NotDecimal)?;
    let value = decimal * unit.factor;
    let vanished = value == 0.0 && mantissa.chars().any(|c| c.is_ascii_digit() && c != '0');
    if value.is_finite() && !vanished {
        Ok(value)
    } else {
        Err(ScaleError::Range)
    }
}
