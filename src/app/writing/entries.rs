//! Entries of a summary, in their order.

use serde_json::{Map, Value};

/// Keys in the order in which they are written.
pub(in crate::app) type Summary = Map<String, Value>;

/// Adds an entry behind the others.
pub(in crate::app) fn put(summary: &mut Summary, key: &str, value: Value) {
    summary.insert(key.into(), value);
}

/// The text of the file.
pub(in crate::app) fn to_text(summary: &Summary) -> String {
    // The alternate form of a JSON value is the indented one.
    format!("{:#}\n", Value::Object(summary.clone()))
}
