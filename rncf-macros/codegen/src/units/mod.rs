//! Units: the table as data, dimension algebra, and numbers scaled in decimal so that `68.95 GPa`
//! is the f64 nearest to 68.95e9.

mod compound;
mod dimension;
mod names;
mod table;

#[cfg(test)]
mod tests;

pub use compound::{Compound, ScaleError, scale};
pub use dimension::{Dimension, Fraction};
pub use table::{UNITS, Unit, meant};

/// The unit with this symbol.
pub fn find(symbol: &str) -> Option<&'static Unit> {
    UNITS.iter().find(|unit| unit.symbol == symbol)
}
