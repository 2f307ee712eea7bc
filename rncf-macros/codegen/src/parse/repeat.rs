//! Repetition: loops of items, numbers in brackets, and values over all repetitions.

use proc_macro2::{Delimiter, Group, Span, TokenTree};

use super::cursor::{Cursor, Parsed};
use super::messages as say;
use super::tree::{Expr, ExprKind, Item, ItemKind, Keyword, Loop, Name, Reduced, Tree};
use super::{expr, item};
use crate::errors::{Errors, Mistake};
use crate::model::Reduction;

/// `for index in 0..count { .. }`; its items are read whatever is wrong in its head.
pub fn repeated(cursor: &mut Cursor, tree: &mut Tree, outer: Option<usize>, errors: &mut Errors) {
    if outer.is_some() {
        errors.at(cursor.here(), say::NESTED_LOOP);
    }
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
        return item::recover(cursor);
    };
    tree.loops.push(Loop { index, count });
    let repeat = Some(tree.loops.len() - 1);
    item::items(&mut Cursor::of(&group), tree, repeat, errors);
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
        let area = if cursor.mark() == first { start.into() } else { cursor.since(start) };
        return Err(Mistake::new(area, say::RANGE_START));
    }
    cursor.next();
    cursor.next();
    if cursor.is_punct('=') {
        return Err(Mistake::new(cursor.here(), say::RANGE_END));
    }
    expr::nested(cursor, depth + 1)
}

fn is_dots(cursor: &Cursor) -> bool {
    cursor.is_punct('.') && cursor.is_second_punct('.')
}

/// The brackets behind the name of an item: in a loop its index, else none.
pub fn own_index(cursor: &mut Cursor, name: &Name, of: Option<&Loop>, errors: &mut Errors) {
    let group = cursor.eat_group(Delimiter::Bracket);
    let text = name.text.as_str();
    match (group, of) {
        (None, None) => {}
        (Some(group), None) => errors.at(group.span(), say::index_without_loop(text)),
        (group, Some(Loop { index: Some(index), .. })) => match group {
            None => errors.at(name.span, say::lacks_index(text, &index.text)),
            Some(group) if !is_only(&group, &index.text) => {
                errors.at(group.span(), say::other_index(text, &index.text));
            }
            Some(_) => {}
        },
        // The index has been reported.
        (_, Some(Loop { index: None, .. })) => {}
    }
}

fn is_only(group: &Group, word: &str) -> bool {
    let mut inner = Cursor::of(group);
    inner.eat_word(word) && inner.is_empty()
}

/// Refuses an item that is not repeated; `keyword` is where its keyword stands.
pub fn may_be_repeated(item: &mut Item, keyword: Span, errors: &mut Errors) {
    let word = item.keyword.word();
    let message = match item.keyword {
        Keyword::Body | Keyword::Fixture | Keyword::Joint | Keyword::Load => return,
        Keyword::Constraint | Keyword::Spring | Keyword::Rigid | Keyword::Frame => say::not_repeated_yet(word),
        Keyword::Output => say::OUTPUT_IN_LOOP.into(),
        _ => say::outside_of_loops(word),
    };
    errors.at(keyword, message);
    if !matches!(item.kind, ItemKind::Param { .. }) {
        // What it says of the index is no mistake.
        item.kind = ItemKind::Broken;
    }
}

/// `name[index]`, if that is what goes on behind the name; a vector has commas.
pub fn indexed(cursor: &mut Cursor, name: &Name, depth: usize) -> Parsed<Option<Expr>> {
    let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    let group = cursor.group(Delimiter::Bracket);
    let Some(group) = group.filter(|group| !group.stream().into_iter().any(|token| is_comma(&token))) else {
        return Ok(None);
    };
    let inner = expr::whole(&mut Cursor::of(group), depth, "the number of a repetition")?;
    cursor.next();
    let (height, base) = (1 + inner.height, name.clone());
    let index = Box::new(inner);
    expr::node(ExprKind::Indexed { base, index }, cursor.since(name.span), height).map(Some)
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
