//! Units: the table as data, dimension algebra, and numbers scaled in decimal so that `68.95 GPa`
//! is the f64 nearest to 68.95e9.

mod dimension;
mod names;
mod number;
mod table;

#[cfg(test)]
mod tests;

pub use dimension::{Dimension, Fraction};
pub use number::{ScaleError, scale};
pub use table::{UNITS, Unit, meant};

/// The unit with this symbol.
pub fn find(symbol: &str) -> Option<&'static Unit> {
    UNITS.iter().find(|unit| unit.symbol == symbol)
}

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
