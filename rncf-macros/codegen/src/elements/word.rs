//! Words of declarations that live as long as the program, as those of the compiler do.

use std::collections::HashSet;
use std::sync::{LazyLock, Mutex, PoisonError};

static WORDS: LazyLock<Mutex<HashSet<&'static str>>> = LazyLock::new(Mutex::default);

/// The word itself, kept once however often it occurs.
pub fn word(text: &str) -> &'static str {
    let mut words = WORDS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = words.get(text) {
        return known;
    }
    let kept: &'static str = String::leak(text.to_string());
    words.insert(kept);
    kept
}
