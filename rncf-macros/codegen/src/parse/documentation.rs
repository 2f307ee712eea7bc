//! Documentation comments before items, statements and arguments.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::Cursor;
use super::messages as say;
use crate::errors::Errors;

/// Documentation comments, joined by newlines; other attributes are reported.
pub fn documentation(cursor: &mut Cursor, errors: &mut Errors) -> String {
    let mut lines: Vec<String> = Vec::new();
    while cursor.is_punct('#') {
        let start = cursor.here();
        cursor.next();
        if !cursor.is_punct('!') && cursor.group(Delimiter::Bracket).is_none() {
            cursor.skip_line(start);
            errors.at(start, say::COMMENT);
            continue;
        }
        let inner = cursor.eat_punct('!');
        let text = cursor
            .eat_group(Delimiter::Bracket)
            .and_then(|group| doc_text(&mut Cursor::of(&group)));
        match text {
            Some(text) if !inner => lines.extend(text.split('\n').map(|line| clean(line).to_string())),
            Some(_) => errors.at(cursor.since(start), say::INNER_DOC),
            None => errors.at(cursor.since(start), say::ATTRIBUTE),
        }
    }
    lines.join("\n").trim().to_string()
}

/// Without the space behind `///`, or the ` * ` of block comments.
fn clean(line: &str) -> &str {
    let line = line.trim_end();
    let starred = line.trim_start().strip_prefix("* ");
    starred.unwrap_or_else(|| line.strip_prefix(' ').unwrap_or(line))
}

fn doc_text(cursor: &mut Cursor) -> Option<String> {
    if !cursor.eat_word("doc") || !cursor.eat_punct('=') {
        return None;
    }
    let Some(TokenTree::Literal(literal)) = cursor.next() else {
        return None;
    };
    syn::parse_str::<syn::LitStr>(&literal.to_string())
        .ok()
        .map(|text| text.value())
}
