//! Parts of sentences.

/// The first `most` of some parts of a sentence, and how many more there are; `None` without any.
pub(in crate::app) fn listed(parts: &[String], most: usize) -> Option<String> {
    let shown = parts[..parts.len().min(most)].join(", ");
    match parts.len().saturating_sub(most) {
        _ if parts.is_empty() => None,
        0 => Some(shown),
        more => Some(format!("{shown}, and {more} more")),
    }
}
