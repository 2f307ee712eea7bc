//! Where reading goes on behind a mistake.

use proc_macro2::Delimiter;

use super::cursor::Cursor;
use super::tree::Keyword;

/// Words that begin something without a keyword of its own.
const BRACED: [&str; 3] = ["run", "for", "component"];

/// Skips to the next item: behind a `;` or `{..}`, or before a keyword with a name.
pub(super) fn recover(cursor: &mut Cursor) {
    recover_before(cursor, |cursor| {
        cursor
            .word()
            .is_some_and(|word| BRACED.iter().any(|other| word == other) || Keyword::of(&word.to_string()).is_some())
            && (cursor.is_two_words() || cursor.is_word("run"))
    });
}

pub(super) fn recover_before(cursor: &mut Cursor, is_start: impl Fn(&Cursor) -> bool) {
    while !cursor.is_empty() && !is_start(cursor) && !is_documentation(cursor) {
        if cursor.eat_punct(';') {
            return;
        }
        let is_brace = cursor.group(Delimiter::Brace).is_some();
        cursor.next();
        if is_brace && !cursor.is_punct(';') && !cursor.is_word("else") && !cursor.is_empty() {
            return;
        }
    }
}

fn is_documentation(cursor: &Cursor) -> bool {
    cursor.is_punct('#')
}
