//! The table of units, as data. Dimensions are exponents of m, kg, s, K, A, angle.
//!
//! Compiled twice: into the macro, and into the runtime (`units.rs`) for the command line and for files, so that all know the
//! same units; hence nothing here refers to the rest of the crate.

use std::f64::consts::PI;

/// A unit symbol.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// Symbol, ASCII.
    pub symbol: &'static str,
    /// Exponents of m, kg, s, K, A, angle.
    pub dimension: [i8; 6],
    /// Power of ten towards SI; applied to the decimal text of a number, so that it is exact.
    pub decimal: i32,
    /// Factor that is no power of ten; multiplies.
    pub factor: f64,
}

const fn unit(symbol: &'static str, dimension: [i8; 6], decimal: i32) -> Unit {
    Unit {
        symbol,
        dimension,
        decimal,
        factor: 1.0,
    }
}

const fn times(symbol: &'static str, dimension: [i8; 6], factor: f64) -> Unit {
    Unit {
        symbol,
        dimension,
        decimal: 0,
        factor,
    }
}

const LENGTH: [i8; 6] = [1, 0, 0, 0, 0, 0];
const MASS: [i8; 6] = [0, 1, 0, 0, 0, 0];
const TIME: [i8; 6] = [0, 0, 1, 0, 0, 0];
const TEMPERATURE: [i8; 6] = [0, 0, 0, 1, 0, 0];
const CURRENT: [i8; 6] = [0, 0, 0, 0, 1, 0];
const ANGLE: [i8; 6] = [0, 0, 0, 0, 0, 1];
const SPIN: [i8; 6] = [0, 0, -1, 0, 0, 1];
const FREQUENCY: [i8; 6] = [0, 0, -1, 0, 0, 0];
const FORCE: [i8; 6] = [1, 1, -2, 0, 0, 0];
const PRESSURE: [i8; 6] = [-1, 1, -2, 0, 0, 0];
const ENERGY: [i8; 6] = [2, 1, -2, 0, 0, 0];
const POWER: [i8; 6] = [2, 1, -3, 0, 0, 0];
const VOLTAGE: [i8; 6] = [2, 1, -3, 0, -1, 0];

/// All units that the language knows.
#[rustfmt::skip]
pub const UNITS: &[Unit] = &[
    unit("m", LENGTH, 0), unit("mm", LENGTH, -3), unit("cm", LENGTH, -2), unit("dm", LENGTH, -1),
    unit("km", LENGTH, 3), unit("um", LENGTH, -6), unit("nm", LENGTH, -9),
    times("inch", LENGTH, 0.0254), times("ft", LENGTH, 0.3048), times("AU", LENGTH, 149_597_870_700.0),
    unit("kg", MASS, 0), unit("g", MASS, -3), unit("mg", MASS, -6), unit("t", MASS, 3),
    unit("s", TIME, 0), unit("ms", TIME, -3), unit("us", TIME, -6),
    times("min", TIME, 60.0), times("h", TIME, 3600.0), times("day", TIME, 86_400.0),
    unit("K", TEMPERATURE, 0), unit("A", CURRENT, 0), unit("mA", CURRENT, -3),
    unit("rad", ANGLE, 0), unit("mrad", ANGLE, -3), times("deg", ANGLE, PI / 180.0), times("rev", ANGLE, 2.0 * PI),
    times("rpm", SPIN, PI / 30.0), unit("Hz", FREQUENCY, 0), unit("kHz", FREQUENCY, 3),
    unit("N", FORCE, 0), unit("kN", FORCE, 3), unit("MN", FORCE, 6), unit("GN", FORCE, 9), unit("mN", FORCE, -3), unit("uN", FORCE, -6),
    unit("Pa", PRESSURE, 0), unit("kPa", PRESSURE, 3), unit("MPa", PRESSURE, 6), unit("GPa", PRESSURE, 9),
    unit("bar", PRESSURE, 5),
    times("lb", MASS, 0.453_592_37), times("lbf", FORCE, 4.448_221_615_260_5), times("psi", PRESSURE, 6_894.757_293_168_361),
    unit("J", ENERGY, 0), unit("kJ", ENERGY, 3), unit("MJ", ENERGY, 6), unit("mJ", ENERGY, -3),
    unit("W", POWER, 0), unit("kW", POWER, 3), unit("MW", POWER, 6), unit("mW", POWER, -3),
    unit("V", VOLTAGE, 0), unit("kV", VOLTAGE, 3), unit("mV", VOLTAGE, -3),
];

/// Other spellings of units, and what to write.
#[rustfmt::skip]
const SPELLINGS: &[(&str, &str)] = &[
    ("sec", "s"), ("second", "s"), ("seconds", "s"), ("minute", "min"), ("minutes", "min"), ("hour", "h"),
    ("hours", "h"), ("days", "day"), ("d", "day"), ("meter", "m"), ("metre", "m"), ("meters", "m"), ("metres", "m"),
    ("gram", "g"), ("ton", "t"), ("tonne", "t"), ("degree", "deg"), ("degrees", "deg"), ("radian", "rad"),
    ("radians", "rad"), ("hertz", "Hz"), ("newton", "N"), ("newtons", "N"), ("pascal", "Pa"), ("Nm", "N*m"),
    ("kNm", "kN*m"), ("in", "inch"), ("lbs", "lb"), ("kgs", "kg"), ("hr", "h"), ("hrs", "h"), ("feet", "ft"), ("foot", "ft"), ("inches", "inch"), ("turn", "rev"), ("RPM", "rpm"),
    ("volt", "V"), ("watt", "W"), ("joule", "J"), ("kelvin", "K"), ("kmh", "km/h"), ("kph", "km/h"), ("ampere", "A"), ("au", "AU"),
    ("degC", "K`, 273.15 more than `degC"), ("kgf", "9.80665 N"), ("kip", "4448.2216152605 N"), ("ksi", "6894757.293168361 Pa"), ("mil", "0.0254 mm"),
    ("thou", "0.0254 mm"), ("mph", "0.44704 m/s"), ("kn", "0.5144444444444445 m/s"), ("knot", "0.5144444444444445 m/s"), ("hp", "745.6998715822702 W"), ("slug", "14.593902937206365 kg"), ("dyn", "1e-5 N"),
    ("cP", "1e-3 Pa*s"), ("yr", "365.25 day"), ("year", "365.25 day"), ("oz", "0.028349523125 kg"), ("yd", "0.9144 m"), ("mile", "1609.344 m"),
];

/// Prefixes of the SI, and their powers of ten.
#[rustfmt::skip]
const PREFIXES: &[(&str, i32)] = &[
    ("f", -15), ("p", -12), ("n", -9), ("u", -6), ("m", -3), ("c", -2), ("d", -1),
    ("h", 2), ("k", 3), ("M", 6), ("G", 9), ("T", 12),
];

/// What to write for a word that is no unit but can only mean one: `sec` is `s`, `m2` is `m^2`, `TPa` is `1e12 Pa`,
/// `kgm` is `kg*m`.
pub fn meant(word: &str) -> Option<String> {
    let is_known = |text: &str| UNITS.iter().any(|unit| unit.symbol == text);
    if let Some((_, symbol)) = SPELLINGS.iter().find(|(spelling, _)| *spelling == word) {
        return Some((*symbol).to_string());
    }
    if let Some(symbol) = word
        .strip_suffix('s')
        .filter(|symbol| symbol.len() > 2 && is_known(symbol))
    {
        return Some(symbol.to_string());
    }
    let symbol = word.trim_end_matches(|c: char| c.is_ascii_digit());
    if symbol.len() < word.len() {
        let symbol = if is_known(symbol) {
            symbol.to_string()
        } else {
            meant(symbol)?
        };
        return Some(format!("{symbol}^{}", &word[symbol_length(word)..]));
    }
    let scaled = PREFIXES.iter().find_map(|(prefix, power)| {
        let rest = word.strip_prefix(prefix)?;
        (is_known(rest) && !rest.is_empty()).then(|| format!("1e{power} {rest}"))
    });
    // Another case of a known symbol is no product.
    let is_cased = UNITS.iter().any(|unit| unit.symbol.eq_ignore_ascii_case(word));
    scaled.or_else(|| if is_cased { None } else { product(word, &is_known) })
}

/// Length of a word without the digits at its end.
fn symbol_length(word: &str) -> usize {
    word.trim_end_matches(|c: char| c.is_ascii_digit()).len()
}

/// A word as a product of two or three symbols, the longest first: `kNm`, `Nms`.
fn product(word: &str, is_known: &impl Fn(&str) -> bool) -> Option<String> {
    (1..word.len())
        .rev()
        .filter(|&at| word.is_char_boundary(at))
        .find_map(|at| {
            let (first, rest) = word.split_at(at);
            if !is_known(first) {
                return None;
            }
            // Behind another symbol nobody means milliseconds: `Nms` is an angular momentum.
            let rest = if rest == "ms" {
                Some("m*s".to_string())
            } else if is_known(rest) {
                Some(rest.to_string())
            } else {
                product(rest, is_known)
            };
            rest.map(|rest| format!("{first}*{rest}"))
        })
}
