//! Bodies from elsewhere: their files and interfaces.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::{Cursor, Parsed};
use super::tree::Statement;
use crate::errors::Area;

/// `"panel.npz" units(mm, t, s)` behind `import`.
pub(super) fn files(cursor: &mut Cursor, area: Area) -> Parsed<Statement> {
    let mut files = Vec::new();
    loop {
        let here = Area::from(cursor.here());
        let text = match cursor.peek() {
            Some(TokenTree::Literal(literal)) => syn::parse_str::<syn::LitStr>(&literal.to_string()).ok(),
            _ => None,
        };
        let Some(text) = text else {
            return Err(cursor.expected("the path of a file in quotes, beside the manifest of the crate"));
        };
        cursor.next();
        files.push((text.value(), here));
        if !cursor.eat_punct(',') {
            break;
        }
    }
    let start = cursor.here();
    let units = match cursor.eat_word("units") {
        true => {
            let expected = "`(m, kg, s)`: the units of length, mass and time in the file";
            let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
                return Err(cursor.expected(expected));
            };
            let mut inner = Cursor::of(&group);
            let mut names = Vec::new();
            while !inner.is_empty() {
                names.push(inner.expect_name("a unit such as `mm`")?);
                if !inner.eat_punct(',') && !inner.is_empty() {
                    return Err(inner.expected("`,` or `)`"));
                }
            }
            Some((names, cursor.since(start)))
        }
        false => None,
    };
    Ok(Statement::Import { area, files, units })
}

/// `root = node 1` or `tip = nodes [57, 58]` behind `interface`.
pub(super) fn interface(cursor: &mut Cursor) -> Parsed<Statement> {
    let name = cursor.expect_name("the name of the interface, `interface root = node 1;`")?;
    cursor.expect_punct('=')?;
    let mut nodes = Vec::new();
    if cursor.eat_word("node") {
        nodes.push(number(cursor)?);
    } else if cursor.eat_word("nodes") {
        let Some(group) = cursor.eat_group(Delimiter::Bracket) else {
            return Err(cursor.expected("the numbers of the nodes, `nodes [57, 58, 59]`"));
        };
        let mut inner = Cursor::of(&group);
        while !inner.is_empty() {
            nodes.push(number(&mut inner)?);
            if !inner.eat_punct(',') && !inner.is_empty() {
                return Err(inner.expected("`,` or `]`"));
            }
        }
        if nodes.is_empty() {
            return Err(inner.expected("the number of a node"));
        }
    } else {
        return Err(cursor.expected("`node 1` or `nodes [57, 58, 59]`"));
    }
    Ok(Statement::Interface { name, nodes })
}

fn number(cursor: &mut Cursor) -> Parsed<(u64, Area)> {
    let here = Area::from(cursor.here());
    let number = match cursor.peek() {
        Some(TokenTree::Literal(literal)) => literal.to_string().replace('_', "").parse().ok(),
        _ => None,
    };
    let Some(number) = number else {
        return Err(cursor.expected("the number of a node in the file"));
    };
    cursor.next();
    Ok((number, here))
}
