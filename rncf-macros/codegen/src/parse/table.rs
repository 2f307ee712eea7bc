//! Tables: columns in the declaration, or a file.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::{Cursor, Parsed};
use super::expr;
use super::item::fields_of;
use super::tree::{Field, Fields, ItemKind};
use crate::errors::{Area, Errors};

/// `= file("path", interpolation = monotone);`, of a table or of a parameter that names a file.
pub(super) fn file_table(cursor: &mut Cursor, is_param: bool) -> Parsed<ItemKind> {
    cursor.expect_punct('=')?;
    cursor.expect_word("file")?;
    let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
        return Err(cursor.expected("`(\"path\")` after `file`"));
    };
    let mut inner = Cursor::of(&group);
    let area = Area::from(inner.here());
    let path = match inner.peek() {
        Some(TokenTree::Literal(literal)) => syn::parse_str::<syn::LitStr>(&literal.to_string()).ok(),
        _ => None,
    };
    let Some(path) = path.map(|path| path.value()) else {
        return Err(inner.expected("the path of a file in quotes, beside the manifest of the crate"));
    };
    inner.next();
    let arguments = if inner.eat_punct(',') {
        expr::arguments(&mut inner, 0, &[3])?
    } else {
        Vec::new()
    };
    if !inner.is_empty() {
        return Err(inner.expected("`,` or `)`"));
    }
    cursor.expect_end()?;
    Ok(ItemKind::FileTable {
        path,
        area,
        arguments,
        is_param,
    })
}

/// Whether the parameter whose name was read names a file, `: table`.
pub(super) fn is_param(cursor: &Cursor) -> bool {
    cursor.is_punct(':') && cursor.is_second_word("table")
}

/// `: table = file(..);`
pub(super) fn param(cursor: &mut Cursor) -> Parsed<ItemKind> {
    cursor.next();
    cursor.next();
    file_table(cursor, true)
}

/// `{ column = [..] unit; interpolation = monotone; }`
pub(super) fn columns(cursor: &mut Cursor, area: Area, errors: &mut Errors) -> Parsed<Fields> {
    let expected = "`{` and columns, or `=` and `file(\"path\")`";
    fields_of(cursor, area, errors, expected, column)
}

fn column(cursor: &mut Cursor) -> Parsed<Field> {
    let name = cursor.expect_name("the name of a column")?;
    cursor.expect_punct('=')?;
    let value = match cursor.group(Delimiter::Bracket) {
        Some(_) => expr::list(cursor)?,
        None => expr::expression(cursor)?,
    };
    cursor.expect_end()?;
    Ok(Field { name, value })
}
