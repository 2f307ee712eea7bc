//! Dimension algebra with rational exponents of m, kg, s, K, A. An angle is a plain number here;
//! that something was written as an angle is tracked lexically by the checks of expressions.

use super::names::NAMES;

/// A rational exponent, reduced, with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fraction {
    /// Numerator.
    pub over: i32,
    /// Denominator, positive.
    pub under: i32,
}

/// Largest numerator or denominator of an exponent.
const LARGEST: i32 = 1000;

impl Fraction {
    /// Reduced fraction; `None` where it is too large to make sense.
    pub fn new(over: i32, under: i32) -> Option<Self> {
        let (mut a, mut b) = (over.abs(), under.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let divisor = if under < 0 { -a } else { a };
        (divisor != 0)
            .then(|| Self {
                over: over / divisor,
                under: under / divisor,
            })
            .filter(|fraction| fraction.over.abs() <= LARGEST && fraction.under <= LARGEST)
    }

    /// The fraction with a small denominator that equals a number, if there is one.
    pub fn of(value: f64) -> Option<Self> {
        (1..=12).find_map(|under| {
            let over = value * f64::from(under);
            let whole = over.round();
            ((over - whole).abs() < 1e-12 * over.abs().max(1.0) && whole.abs() <= f64::from(LARGEST))
                .then(|| Self::new(whole as i32, under))
                .flatten()
        })
    }

    fn add(self, other: Self) -> Option<Self> {
        Self::new(
            self.over * other.under + other.over * self.under,
            self.under * other.under,
        )
    }

    fn multiply(self, other: Self) -> Option<Self> {
        Self::new(self.over * other.over, self.under * other.under)
    }
}

/// Exponents of m, kg, s, K, A.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension(pub [Fraction; 5]);

impl Dimension {
    /// Of a plain number.
    pub const NONE: Dimension = Dimension([Fraction { over: 0, under: 1 }; 5]);

    /// From whole exponents of m, kg, s, K, A, angle; the angle counts as 1.
    pub fn of(exponents: [i8; 6]) -> Self {
        let mut dimension = Self::NONE;
        for (fraction, exponent) in dimension.0.iter_mut().zip(exponents) {
            fraction.over = i32::from(exponent);
        }
        dimension
    }

    /// Whether it is a plain number.
    pub fn is_none(self) -> bool {
        self == Self::NONE
    }

    /// Of a product; `None` where an exponent is too large.
    pub fn multiply(self, other: Self) -> Option<Self> {
        let mut result = self;
        for (fraction, by) in result.0.iter_mut().zip(other.0) {
            *fraction = fraction.add(by)?;
        }
        Some(result)
    }

    /// Of a quotient; `None` where an exponent is too large.
    pub fn divide(self, other: Self) -> Option<Self> {
        self.multiply(other.power(Fraction { over: -1, under: 1 })?)
    }

    /// Of a power; `None` where an exponent is too large.
    pub fn power(self, exponent: Fraction) -> Option<Self> {
        let mut result = self;
        for fraction in &mut result.0 {
            *fraction = fraction.multiply(exponent)?;
        }
        Some(result)
    }

    /// Exponent of time.
    pub fn time(self) -> f64 {
        let Fraction { over, under } = self.0[2];
        f64::from(over) / f64::from(under)
    }

    /// Whole exponents, where they are.
    fn whole(self) -> Option<[i8; 5]> {
        let mut whole = [0; 5];
        for (exponent, fraction) in whole.iter_mut().zip(self.0) {
            if fraction.under != 1 {
                return None;
            }
            *exponent = i8::try_from(fraction.over).ok()?;
        }
        Some(whole)
    }

    /// Whole exponents of m, kg, s, K, A, angle, where they are whole.
    pub fn exponents(self, angle: bool) -> Option<[i8; 6]> {
        let [m, kg, s, k, a] = self.whole()?;
        Some([m, kg, s, k, a, i8::from(angle)])
    }

    fn known(self) -> Option<(&'static str, &'static str)> {
        let whole = self.whole()?;
        NAMES
            .iter()
            .find(|(exponents, ..)| *exponents == whole)
            .map(|(_, name, symbol)| (*name, *symbol))
    }

    /// SI unit symbol: `m`, `N m`, `rad/s` (where `angle`), `1`.
    pub fn symbol(self, angle: bool) -> String {
        match (self.known(), angle) {
            (Some((_, "1")), true) => "rad".into(),
            (Some((_, "1/s")), true) => "rad/s".into(),
            (Some((_, "1/s^2")), true) => "rad/s^2".into(),
            (Some((_, symbol)), _) => symbol.into(),
            (None, _) => self.base_symbol(),
        }
    }

    fn base_symbol(self) -> String {
        let side = |positive: bool| -> Vec<String> {
            self.0
                .iter()
                .zip(["m", "kg", "s", "K", "A"])
                .filter(|(fraction, _)| fraction.over != 0 && (fraction.over > 0) == positive)
                .map(|(fraction, symbol)| match (fraction.over.abs(), fraction.under) {
                    (1, 1) => symbol.to_string(),
                    (over, 1) => format!("{symbol}^{over}"),
                    (over, under) => format!("{symbol}^({over}/{under})"),
                })
                .collect()
        };
        let (over, under) = (side(true), side(false));
        let over = if over.is_empty() { "1".into() } else { over.join(" ") };
        match under.len() {
            0 => over,
            1 => format!("{over}/{}", under[0]),
            _ => format!("{over}/({})", under.join(" ")),
        }
    }

    /// What it is in words, for messages: `a length (m)`, `a plain number`.
    pub fn describe(self, angle: bool) -> String {
        let symbol = self.symbol(angle);
        match (self.known(), symbol.as_str()) {
            (_, "rad") => "an angle (rad)".into(),
            (_, "rad/s") => "an angular velocity (rad/s)".into(),
            (_, "rad/s^2") => "an angular acceleration (rad/s^2)".into(),
            (Some((name, "1")), _) => name.into(),
            (Some((name, _)), _) => format!("{name} ({symbol})"),
            (None, _) => format!("a quantity in {symbol}"),
        }
    }
}
