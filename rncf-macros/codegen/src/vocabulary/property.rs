//! What is known of a property: name, dimension and range.

/// Which values of a property make sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Range {
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NonNegative,
    /// A part of a whole: greater than zero, at most one.
    Part,
    /// Between -1 and 1/2, both excluded.
    Poisson,
    /// Any number.
    Any,
}

impl Range {
    /// Whether a value is in it.
    pub fn has(self, value: f64) -> bool {
        match self {
            Range::Positive => value > 0.0,
            Range::NonNegative => value >= 0.0,
            Range::Part => value > 0.0 && value <= 1.0,
            Range::Poisson => value > -1.0 && value < 0.5,
            Range::Any => value.is_finite(),
        }
    }
}

/// A property of a material or section.
#[derive(Clone, Copy, Debug)]
pub struct Property {
    /// Keyword.
    pub name: &'static str,
    /// Exponents of m, kg, s, K, A, angle.
    pub dimension: [i8; 6],
    /// Unit to suggest.
    pub unit: &'static str,
    /// Which values make sense; checked when the model is built from its parameters, and by the
    /// macro where the value is constant.
    pub range: Range,
    /// Value where the user gives none; `None`: required by the elements that use it.
    pub default: Option<f64>,
}

impl Property {
    /// Whether it is an angle, which is written with its unit.
    pub fn is_angle(&self) -> bool {
        self.dimension == [0, 0, 0, 0, 0, 1]
    }
}
