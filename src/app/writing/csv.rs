//! Numbers in tables of text.

/// Adds a number in the fewest digits that read back to the same bits.
pub(in crate::app) fn push_number(text: &mut String, value: f64) {
    text.push_str(zmij::Buffer::new().format(value));
}

/// A number as text; none where there is no value.
pub(in crate::app) fn cell(value: impl Into<Option<f64>>) -> String {
    let mut text = String::new();
    if let Some(value) = value.into() {
        push_number(&mut text, value);
    }
    text
}
