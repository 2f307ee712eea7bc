//! Quantities as text, e.g. `40 rad/s`: a number and a unit made of symbols, products,
//! quotients, integer powers and brackets.

use table::UNITS;

/// The units of the language: one file of data for the macro and the command line, so that what a
/// declaration understands, `name=value` does too.
#[path = "../../rncf-macros/codegen/src/units/table.rs"]
mod table;

/// Exponents of m, kg, s, K, A and angle.
pub type Dimension = [i8; 6];

/// A unit: one of it is `factor * 10^decimal` in SI. The decimal exponent is kept apart so that
/// `68.95 GPa` becomes the number nearest to 68.95e9.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    factor: f64,
    decimal: i32,
    /// Exponents of the base units.
    pub dimension: Dimension,
}

/// A number as written: sign and digits, and the exponent after `e`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number<'t> {
    mantissa: &'t str,
    exponent: i32,
}

const NONE: Dimension = [0; 6];

/// Dimension of a time, for the flags that take one.
pub const SECOND: Dimension = [0, 0, 1, 0, 0, 0];

impl Unit {
    const ONE: Unit = Unit {
        factor: 1.0,
        decimal: 0,
        dimension: NONE,
    };

    /// The unit that `text` names; the empty text is 1.
    ///
    /// # Errors
    /// The symbol that is not known, with the nearest known one, or what is out of place.
    pub fn parse(text: &str) -> Result<Unit, String> {
        if text.trim().is_empty() {
            return Ok(Unit::ONE);
        }
        if let Some(ascii) = in_ascii(text) {
            return Err(match ascii {
                Some(ascii) => format!("`{text}` is not ASCII; write `{ascii}`"),
                None => format!("`{text}` is not ASCII: units are written with the letters a to z, as in `rad/s`"),
            });
        }
        let mut parser = Parser { rest: text.trim() };
        if !parser.rest.starts_with(|c: char| c.is_alphanumeric() || c == '(') {
            return Err(format!(
                "`{}` is no unit: write one number and its unit, as in `2.5 m/s`",
                text.trim()
            ));
        }
        let unit = parser.product()?;
        match parser.rest.chars().next() {
            None => Ok(unit),
            Some(c) => Err(format!("`{c}` is out of place in the unit `{}`", text.trim())),
        }
    }

    /// `number` of this unit, in SI.
    pub fn to_si(self, number: Number<'_>) -> f64 {
        let exponent = number.exponent.saturating_add(self.decimal);
        // A mantissa that `Number::split` has accepted is one that `parse` accepts.
        let scaled: f64 = format!("{}e{exponent}", number.mantissa).parse().unwrap_or(f64::NAN);
        scaled * self.factor
    }

    fn times(self, other: Unit, sign: i8) -> Result<Unit, String> {
        let mut dimension = self.dimension;
        for (mine, its) in dimension.iter_mut().zip(other.dimension) {
            *mine = its
                .checked_mul(sign)
                .and_then(|its| mine.checked_add(its))
                .ok_or("a power in the unit is too large")?;
        }
        let factor = if sign > 0 {
            self.factor * other.factor
        } else {
            self.factor / other.factor
        };
        let decimal = self.decimal + i32::from(sign) * other.decimal;
        Ok(Unit {
            factor,
            decimal,
            dimension,
        })
    }

    fn power(self, exponent: i32) -> Result<Unit, String> {
        if exponent.abs() > 12 {
            return Err(format!("the power {exponent} in the unit is too large"));
        }
        let mut unit = Unit::ONE;
        for _ in 0..exponent.abs() {
            unit = unit.times(self, exponent.signum() as i8)?;
        }
        Ok(unit)
    }
}

impl<'t> Number<'t> {
    /// Splits a quantity into its number and the text of its unit; `None` where no number begins it.
    pub fn split(text: &'t str) -> Option<(Number<'t>, &'t str)> {
        let text = text.trim();
        let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
        let sign = usize::from(text.starts_with(['+', '-']));
        let whole = digits(sign);
        let mut end = sign + whole;
        let mut fraction = 0;
        if text[end..].starts_with('.') {
            fraction = digits(end + 1);
            end += 1 + fraction;
        }
        if whole + fraction == 0 {
            return None;
        }
        let mantissa = &text[..end];
        let mut exponent = 0;
        if text[end..].starts_with(['e', 'E']) {
            let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
            let count = digits(end + 1 + sign);
            if count > 0 {
                let stop = end + 1 + sign + count;
                exponent = text[end + 1..stop].parse().ok()?;
                end = stop;
            }
        }
        Some((Number { mantissa, exponent }, text[end..].trim()))
    }
}

struct Parser<'t> {
    rest: &'t str,
}

impl Parser<'_> {
    /// Factors from left to right; `/` divides by the next factor alone.
    fn product(&mut self) -> Result<Unit, String> {
        let begins_with_one = self.rest.starts_with("1 ");
        let mut unit = self.factor()?;
        loop {
            let spaced = self.rest.starts_with(' ');
            self.rest = self.rest.trim_start();
            let sign = match self.rest.chars().next() {
                Some('*') => 1,
                Some('/') => -1,
                Some(c) if spaced && begins_with_one && c.is_alphabetic() => {
                    return Err("two numbers stand in a row: write one number and its unit".into());
                }
                Some(c) if spaced && (c.is_alphabetic() || c == '(') => {
                    unit = unit.times(self.factor()?, 1)?;
                    continue;
                }
                _ => return Ok(unit),
            };
            self.rest = self.rest[1..].trim_start();
            unit = unit.times(self.factor()?, sign)?;
        }
    }

    fn factor(&mut self) -> Result<Unit, String> {
        let unit = if let Some(rest) = self.rest.strip_prefix('(') {
            self.rest = rest.trim_start();
            let unit = self.product()?;
            self.rest = self.rest.strip_prefix(')').ok_or("a `)` is missing in the unit")?;
            unit
        } else {
            symbol(self.take(char::is_alphanumeric))?
        };
        let Some(rest) = self.rest.strip_prefix('^') else {
            return Ok(unit);
        };
        self.rest = rest;
        let exponent = self.take(|c| c.is_ascii_digit() || c == '-');
        match exponent.parse() {
            Ok(exponent) => unit.power(exponent),
            Err(_) => Err("a whole number belongs after `^` in the unit".into()),
        }
    }

    fn take(&mut self, belongs: impl Fn(char) -> bool) -> &str {
        let end = self.rest.find(|c| !belongs(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }
}

/// What to write for a unit with signs that no keyboard has, where that is known; `None` where there are none.
fn in_ascii(text: &str) -> Option<Option<String>> {
    if text.is_ascii() {
        return None;
    }
    let signs = [
        ("µ", "u"),
        ("μ", "u"),
        ("°", "deg"),
        ("·", "*"),
        ("⋅", "*"),
        ("×", "*"),
        ("²", "^2"),
        ("³", "^3"),
    ];
    let plain = signs
        .iter()
        .fold(text.to_owned(), |text, (sign, plain)| text.replace(sign, plain));
    Some(plain.is_ascii().then_some(plain))
}

fn symbol(text: &str) -> Result<Unit, String> {
    if text.is_empty() {
        return Err("a unit symbol is missing".into());
    }
    if text == "1" {
        return Ok(Unit::ONE);
    }
    if let Some(unit) = UNITS.iter().find(|unit| unit.symbol == text) {
        return Ok(Unit {
            factor: unit.factor,
            decimal: unit.decimal,
            dimension: unit.dimension,
        });
    }
    // Of three letters one other one is another unit.
    let is_alike = |near: &&str| text.len() > 3 || near.eq_ignore_ascii_case(text);
    let near = || crate::nearest::nearest(text, UNITS.iter().map(|unit| unit.symbol));
    let near = || near().filter(is_alike).map(ToString::to_string);
    Err(match table::meant(text).or_else(near) {
        Some(name) => format!("`{text}` is not a unit; did you mean `{name}`?"),
        None => format!("`{text}` is not a unit"),
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;

    fn si(text: &str) -> f64 {
        let (number, unit) = Number::split(text).unwrap();
        Unit::parse(unit).unwrap().to_si(number)
    }

    #[test]
    fn values_are_the_nearest_numbers() {
        assert_eq!(si("68.95 GPa"), 68.95e9);
        assert_eq!(si("0.7299 cm^2"), 0.7299e-4);
        assert_eq!(si("-2.5e-3km"), -2.5);
        assert_eq!(si("9.81 m/s^2"), 9.81);
        assert_eq!(si("1 rev/min"), TAU / 60.0);
        assert_eq!(si("30 rpm"), 30.0 * (PI / 30.0));
        assert_eq!(si("2 h"), 7200.0);
        assert_eq!(si(".5 um"), 0.5e-6);
    }

    #[test]
    fn dimensions_follow_products_quotients_and_brackets() {
        let dimension = |text| Unit::parse(text).unwrap().dimension;
        assert_eq!(dimension("N*m"), [2, 1, -2, 0, 0, 0]);
        assert_eq!(dimension("N m"), dimension("J"));
        assert_eq!(dimension("J/(kg*K)"), [2, 0, -2, -1, 0, 0]);
        assert_eq!(dimension("kg/m/s"), [-1, 1, -1, 0, 0, 0]);
        assert_eq!(dimension("1/s"), dimension("Hz"));
        assert_eq!(dimension("rpm"), dimension("deg/s"));
        assert_eq!(dimension("m^-2"), [-2, 0, 0, 0, 0, 0]);
        assert_eq!(dimension("min"), SECOND);
        assert_eq!(dimension(""), NONE);
    }

    #[test]
    fn wrong_units_are_named() {
        let error = |text| Unit::parse(text).unwrap_err();
        assert_eq!(error("rads/s"), "`rads` is not a unit; did you mean `rad`?");
        assert_eq!(error("m^x"), "a whole number belongs after `^` in the unit");
        assert_eq!(error("(m"), "a `)` is missing in the unit");
        assert_eq!(error("m)"), "`)` is out of place in the unit `m)`");
        assert_eq!(error("m/"), "a unit symbol is missing");
        assert_eq!(error("m^99"), "the power 99 in the unit is too large");
        assert_eq!(error("sec"), "`sec` is not a unit; did you mean `s`?");
        assert_eq!(error("kmin"), "`kmin` is not a unit; did you mean `1e3 min`?");
        for (word, meant) in [
            ("m2", "m^2"),
            ("kgm", "kg*m"),
            ("in", "inch"),
            ("TPa", "1e12 Pa"),
            ("Nms", "N*m*s"),
        ] {
            assert_eq!(error(word), format!("`{word}` is not a unit; did you mean `{meant}`?"));
        }
        assert_eq!(error("µm"), "`µm` is not ASCII; write `um`");
        assert_eq!(
            error("1 m"),
            "two numbers stand in a row: write one number and its unit"
        );
        assert_eq!(
            error(".1 m"),
            "`.1 m` is no unit: write one number and its unit, as in `2.5 m/s`"
        );
        assert_eq!(
            error("м"),
            "`м` is not ASCII: units are written with the letters a to z, as in `rad/s`"
        );
        assert_eq!(error("N·m²"), "`N·m²` is not ASCII; write `N*m^2`");
    }

    #[test]
    fn numbers_are_split_from_units() {
        assert!(Number::split("rad").is_none());
        assert!(Number::split("-").is_none());
        assert!(Number::split("").is_none());
        assert_eq!(Number::split("1e3").unwrap().1, "");
        assert_eq!(Number::split("1 eggs").unwrap().1, "eggs");
        assert_eq!(Number::split("40rad/s").unwrap().1, "rad/s");
    }
}
