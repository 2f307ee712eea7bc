//! Critical values in sentences and in charts.

use std::fmt::Write;

use crate::app::results::history::Column;
use crate::app::writing::numbers::digits;
use crate::modes::Critical;

/// Relative error of critical values that is not told.
pub(in crate::app) const EXACT: f64 = 1e-6;

/// Critical values in sentences; `what` says of what.
pub(in crate::app) fn critical_lines(key: &Column, critical: &[Critical], what: &str) -> Vec<String> {
    let line = |critical: &Critical| {
        let count = critical.change.unsigned_abs();
        let directions = if count == 1 { "one direction" } else { "two directions" };
        let sense = if critical.change > 0 {
            "becomes negative"
        } else {
            "becomes positive again"
        };
        let directions = if count > 2 {
            format!("{count} directions")
        } else {
            directions.into()
        };
        let happens = if critical.circulates {
            format!("the stiffness is singular in {directions}")
        } else {
            format!("the stiffness of {directions} {sense}")
        };
        let mut line = format!("{what} at {}: {happens}.", key.at(critical.value, 7));
        if critical.within > EXACT * critical.value.abs() {
            let _ = write!(line, " It lies there within {}.", key.quantity(critical.within, 2));
        }
        if let Some([low, high]) = critical.open {
            let _ = write!(
                line,
                " Between {} and {} no equilibrium is found: there deflections grow without bound.",
                digits(low.min(high), 7),
                key.quantity(low.max(high), 7)
            );
        }
        line
    };
    critical.iter().map(line).collect()
}

/// Vertical lines at critical values.
pub(in crate::app) fn marks(critical: &[Critical]) -> Vec<(f64, String)> {
    let mark = |critical: &Critical| (critical.value, format!("critical {}", digits(critical.value, 5)));
    critical.iter().map(mark).collect()
}
