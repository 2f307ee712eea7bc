//! Words of a line: flags with their values, and what a shell reads back.

use clap::{Arg, ArgMatches};

/// The value of a flag; `None` where it is not given.
pub(in crate::app) fn text<'m>(matches: &'m ArgMatches, name: &str) -> Option<&'m str> {
    matches.get_one::<String>(name).map(String::as_str)
}

/// The value of a flag as a number.
///
/// # Errors
/// The flag and what would be right.
pub(in crate::app) fn number(matches: &ArgMatches, name: &str) -> Result<Option<f64>, String> {
    let read = |text: &str| match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("`--{name} {text}`: a number without a unit is needed")),
    };
    text(matches, name).map(read).transpose()
}

/// A word as a shell reads it back.
pub(in crate::app) fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_=./:,+%@".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.into();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

/// A flag with a value, which may begin with a minus.
pub(in crate::app) fn value(name: &'static str, placeholder: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name(placeholder)
        .help(help)
        .allow_hyphen_values(true)
}
