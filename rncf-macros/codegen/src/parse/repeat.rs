//! Repetition: loops of items, numbers in brackets, and values over all repetitions.

use proc_macro2::{Delimiter, Group, TokenTree};

use super::cursor::{Cursor, Parsed};
use super::messages as say;
use super::recover::recover;
use super::tree::{Expr, ExprKind, Keyword, Loop, Name, Reduced, Tree};
use super::{expr, item};
use crate::errors::{Errors, Mistake};
use crate::model::Reduction;

/// `for index in 0..count { .. }`; its items are read whatever is wrong in its head.
pub fn repeated(cursor: &mut Cursor, tree: &mut Tree, outer: Option<usize>, errors: &mut Errors) {
    cursor.next();
    let mut index = None;
    let count = head(cursor, &mut index).unwrap_or_else(|mistake| {
        errors.push(mistake);
        while !is_over(cursor) {
            cursor.next();
        }
        None
    });
    let Some(group) = cursor.eat_group(Delimiter::Brace) else {
        return recover(cursor);
    };
    let (at, first) = (tree.loops.len(), tree.items.len());
    let items = first..first;
    tree.loops.push(Loop {
        index,
        count,
        outer,
        items,
    });
    item::items(&mut Cursor::of(&group), tree, Some(at), errors);
    tree.loops[at].items.end = tree.items.len();
}

/// `index in 0..count`, up to the braces.
fn head(cursor: &mut Cursor, index: &mut Option<Name>) -> Parsed<Option<Expr>> {
    let name = cursor.expect_name("the name of an index, `for a in 0..n { .. }`")?;
    item::check_name(&name)?;
    *index = Some(name);
    cursor.expect_word("in")?;
    let count = range(cursor, 0)?;
    if cursor.group(Delimiter::Brace).is_none() {
        return Err(cursor.expected("`{` and the repeated items"));
    }
    Ok(Some(count))
}

/// Whether the head of a loop has ended: before its braces, or where they are missing.
fn is_over(cursor: &Cursor) -> bool {
    let is_item = cursor
        .word()
        .is_some_and(|word| Keyword::of(&word.to_string()).is_some());
    cursor.is_empty() || cursor.group(Delimiter::Brace).is_some() || cursor.is_punct(';') || is_item
}

/// `0..count`
fn range(cursor: &mut Cursor, depth: usize) -> Parsed<Expr> {
    let start = cursor.here();
    let is_zero = matches!(cursor.peek(), Some(TokenTree::Literal(literal)) if literal.to_string() == "0");
    let first = cursor.mark();
    while !is_over(cursor) && !cursor.is_punct(',') && !is_dots(cursor) {
        cursor.next();
    }
    if !is_dots(cursor) {
        cursor.reset(first);
        return Err(Mistake::new(start, say::RANGE));
    }
    if !is_zero || cursor.mark() != first + 1 {
        let area = if cursor.mark() == first {
            start.into()
        } else {
            cursor.since(start)
        };
        return Err(Mistake::new(area, say::RANGE_START));
    }
    cursor.next();
    cursor.next();
    if cursor.is_punct('=') {
        return Err(Mistake::new(cursor.here(), say::RANGE_END));
    }
    if is_over(cursor) || cursor.is_punct(',') {
        return Err(Mistake::new(cursor.since(start), say::RANGE));
    }
    expr::nested(cursor, depth + 1)
}

fn is_dots(cursor: &Cursor) -> bool {
    cursor.is_punct('.') && cursor.is_second_punct('.')
}

/// The brackets behind the name of an item: in loops their indices, the outermost first, else none.
pub fn own_index(cursor: &mut Cursor, name: &Name, tree: &Tree, of: Option<usize>, errors: &mut Errors) {
    let text = name.text.as_str();
    let around = tree.around(of);
    let mut groups = Vec::new();
    while let Some(group) = cursor.eat_group(Delimiter::Bracket) {
        groups.push(group);
    }
    let indices: Option<Vec<&Name>> = around.iter().map(|&at| tree.loops[at].index.as_ref()).collect();
    // An index that cannot be read has been reported.
    let Some(indices) = indices else { return };
    let wanted: Vec<&str> = indices.iter().map(|index| index.text.as_str()).collect();
    let wanted = wanted.join("][");
    if groups.len() < indices.len() {
        errors.at(name.span, say::lacks_index(text, &wanted));
        return;
    }
    for (at, group) in groups.iter().enumerate() {
        match indices.get(at) {
            None if indices.is_empty() => errors.at(group.span(), say::index_without_loop(text)),
            None => errors.at(group.span(), say::other_index(text, &wanted)),
            Some(index) if !is_only(group, &index.text) => errors.at(group.span(), say::other_index(text, &wanted)),
            Some(_) => {}
        }
    }
}

fn is_only(group: &Group, word: &str) -> bool {
    let mut inner = Cursor::of(group);
    inner.eat_word(word) && inner.is_empty()
}

/// What goes on behind a name with numbers or dots: another number, or the arguments of a repeated motion.
pub fn further(cursor: &mut Cursor, base: &Expr, depth: usize) -> Parsed<Option<Expr>> {
    let is_numbered = matches!(base.kind, ExprKind::Indexed { .. } | ExprKind::Numbered { .. });
    let is_member = matches!(&base.kind, ExprKind::Member { arguments: None, .. });
    if !is_numbered && !is_member {
        return Ok(None);
    }
    if is_numbered && let Some(group) = cursor.eat_group(Delimiter::Parenthesis) {
        let arguments = expr::arguments(&mut Cursor::of(&group), depth + 1, &[3])?;
        let height = 1 + arguments
            .iter()
            .map(|argument| argument.value.height)
            .fold(base.height, usize::max);
        let (base, area) = (Box::new(base.clone()), base.area.to(group.span().into()));
        return expr::node(ExprKind::Applied { base, arguments }, area, height).map(Some);
    }
    numbered(cursor, base, depth)
}

/// Another number behind what has one.
fn numbered(cursor: &mut Cursor, base: &Expr, depth: usize) -> Parsed<Option<Expr>> {
    let Some(index) = number(cursor, depth)? else {
        return Ok(None);
    };
    let (height, area) = (1 + base.height.max(index.height), base.area.to(cursor.before().into()));
    let (base, index) = (Box::new(base.clone()), Box::new(index));
    expr::node(ExprKind::Numbered { base, index }, area, height).map(Some)
}

/// A name with the numbers of a repetition behind it, before the brackets of a call.
pub fn called(cursor: &mut Cursor, what: &str) -> Parsed<Name> {
    let name = cursor.expect_name(what)?;
    let mut path = indexed(cursor, &name, 0)?;
    while let Some(base) = &path {
        match numbered(cursor, base, 0)? {
            Some(further) => path = Some(further),
            None => break,
        }
    }
    let path = path.map(Box::new);
    Ok(Name { path, ..name })
}

/// `name[index]`, if that is what goes on behind the name.
pub fn indexed(cursor: &mut Cursor, name: &Name, depth: usize) -> Parsed<Option<Expr>> {
    let Some(inner) = number(cursor, depth)? else {
        return Ok(None);
    };
    let (height, base) = (1 + inner.height, name.clone());
    let index = Box::new(inner);
    expr::node(ExprKind::Indexed { base, index }, cursor.since(name.span), height).map(Some)
}

/// `[index]`; a vector has commas.
fn number(cursor: &mut Cursor, depth: usize) -> Parsed<Option<Expr>> {
    let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    let group = cursor.group(Delimiter::Bracket);
    let Some(group) = group.filter(|group| !group.stream().into_iter().any(|token| is_comma(&token))) else {
        return Ok(None);
    };
    let inner = expr::whole(&mut Cursor::of(group), depth, "the number of a repetition")?;
    cursor.next();
    Ok(Some(inner))
}

/// `max(index in 0..count, value)`, if that is what goes on behind the name.
pub fn reduced(cursor: &mut Cursor, name: &Name, depth: usize) -> Parsed<Option<Expr>> {
    let Some(group) = cursor.group(Delimiter::Parenthesis) else {
        return Ok(None);
    };
    let mut inner = Cursor::of(group);
    if inner.word().is_none() || !inner.is_second_word("in") {
        return Ok(None);
    }
    let reduction = match name.text.as_str() {
        "max" => Reduction::Max,
        "min" => Reduction::Min,
        "sum" => Reduction::Sum,
        "mean" => Reduction::Mean,
        other => return Err(Mistake::new(name.span, say::not_a_reduction(other))),
    };
    let index = inner.expect_name("the name of an index")?;
    item::check_name(&index)?;
    inner.expect_word("in")?;
    let count = range(&mut inner, depth + 1)?;
    if !inner.eat_punct(',') {
        return Err(inner.expected("`,` and what is looked at"));
    }
    let value = expr::nested(&mut inner, depth + 1)?;
    inner.eat_punct(',');
    if !inner.is_empty() {
        return Err(inner.expected("`)`"));
    }
    cursor.next();
    let height = 1 + count.height.max(value.height);
    let reduced = Reduced {
        reduction,
        index,
        count,
        value,
    };
    expr::node(ExprKind::Reduced(Box::new(reduced)), cursor.since(name.span), height).map(Some)
}
