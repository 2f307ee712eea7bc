//! Numbers as a reader meets them: few digits, with their units.

use crate::emitted::TableFile;
use crate::{Param, ParamKind};

/// A value in the declared unit, e.g. `4 rad/s`; `value` in SI.
pub(in crate::app) fn in_unit(param: &Param, value: f64) -> String {
    if let ParamKind::Table(form) = param.kind {
        return TableFile::declared(form).numbered(value).path().to_owned();
    }
    let number = short(value / param.unit_si);
    match (param.kind, param.unit) {
        (ParamKind::Count, _) | (_, "1" | "") => number,
        (_, unit) => format!("{number} {unit}"),
    }
}

/// Significant digits without the noise of a conversion.
pub(in crate::app) const SHORT: usize = 12;

/// At most 12 significant digits, without the noise of a conversion.
pub(in crate::app) fn short(value: f64) -> String {
    digits(value, SHORT)
}

/// At most `count` significant digits, in exponent form where that is shorter.
pub(in crate::app) fn digits(value: f64, count: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", count.max(1) - 1).parse().unwrap_or(value);
    if rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs()) {
        format!("{}", rounded + 0.0)
    } else {
        format!("{rounded:e}")
    }
}

/// A value with four digits and a prefix of its unit: `362.1 MPa`.
pub(in crate::app) fn with_prefix(value: f64, unit: &str) -> String {
    const PREFIXES: [(f64, &str); 4] = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, "")];
    let fitting = PREFIXES.into_iter().find(|(factor, _)| value.abs() >= *factor);
    let (factor, prefix) = fitting.unwrap_or((1.0, ""));
    format!("{} {prefix}{unit}", digits(value / factor, 4))
}

/// Time for people: `12 ms`.
pub(in crate::app) fn time(seconds: f64) -> String {
    match seconds {
        _ if seconds < 1e-3 => format!("{} us", digits(1e6 * seconds, 2)),
        _ if seconds < 1.0 => format!("{} ms", digits(1e3 * seconds, 2)),
        _ => format!("{} s", digits(seconds, 3)),
    }
}
