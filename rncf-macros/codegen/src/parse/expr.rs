//! Expressions by precedence: sum < product < sign < power (right-associative) < member < primary.

use proc_macro2::{Delimiter, Group, Literal, TokenTree};

use super::cursor::{Cursor, Parsed};
use super::messages as say;
use super::tree::{Argument, Call, Expr, ExprKind, If, Keyword, Name, UnitText};
use super::{repeat, unit};
use crate::errors::{Area, Mistake};
use crate::model::{Binary, Comparison};
use crate::units;

/// Greatest height of an expression tree: recursion over it stays far from the stack's end.
const MAX_HEIGHT: usize = 200;

/// Words that end an expression and never name a unit, besides the keywords of items. Where a value is
/// expected they may be names (`radius * 2`), but not before the word, literal or bracket with which a statement goes on.
const STOP: &[&str] = &[
    "angle",
    "radius",
    "direction",
    "for",
    "normal",
    "to",
    "from",
    "else",
    "if",
    "in",
    "at",
    "line",
    "arc",
    "mesh",
    "planar",
    "spatial",
    "plane",
    "mean_axes",
    "modal",
    "small",
    "run",
    "pub",
];

/// Those of them that are names of motions and frames as well.
const NAMES: &[&str] = &["angle", "radius", "direction", "normal", "line", "arc", "plane"];

/// Whether the next word may be a unit symbol.
pub fn is_unit_next(cursor: &Cursor) -> bool {
    let Some(word) = cursor.word().map(ToString::to_string) else {
        return false;
    };
    !STOP.contains(&word.as_str()) && Keyword::of(&word).is_none() && !cursor.is_second_punct('=')
}

pub(super) fn node(kind: ExprKind, area: Area, height: usize) -> Parsed<Expr> {
    if height > MAX_HEIGHT {
        return Err(Mistake::new(area, say::TOO_DEEP));
    }
    Ok(Expr { kind, area, height })
}

/// A whole right side: a literal with any unit up to `;`, or an expression.
pub fn right_side(cursor: &mut Cursor) -> Parsed<Expr> {
    let mark = cursor.mark();
    if let Some(expr) = quantity(cursor) {
        if cursor.is_punct(';') || cursor.is_empty() {
            return Ok(expr);
        }
        unit::check_end(cursor)?;
    }
    cursor.reset(mark);
    expression(cursor)
}

/// `[-] literal unit`, if that is what stands here.
fn quantity(cursor: &mut Cursor) -> Option<Expr> {
    let start = cursor.here();
    let minus = cursor.eat_punct('-');
    let Some(TokenTree::Literal(literal)) = cursor.next() else {
        return None;
    };
    let text = number(&literal).ok()?;
    let unit = unit::compound(cursor).ok()?;
    // `3 N * t` is a product with time, not with tonnes.
    if unit.factors.iter().skip(1).any(|(name, _)| name.text == "t") {
        return None;
    }
    let area = Area {
        start: literal.span(),
        end: unit.area.end,
    };
    let number = node(ExprKind::Number { text, unit: Some(unit) }, area, 1).ok()?;
    if !minus {
        return Some(number);
    }
    let area = cursor.since(start);
    node(ExprKind::Negate(Box::new(number)), area, 2).ok()
}

/// A literal with any unit that is a whole argument, and the comma behind it: `speed = 2 rad/s`.
fn whole_literal(cursor: &mut Cursor) -> Option<Expr> {
    let mark = cursor.mark();
    // `2 deg * gain` is a product with something that has a name.
    let value = quantity(cursor)
        .filter(has_known_unit)
        .filter(|_| cursor.is_empty() || cursor.eat_punct(','));
    if value.is_none() {
        cursor.reset(mark);
    }
    value
}

fn has_known_unit(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number { unit: Some(unit), .. } => {
            unit.factors.iter().all(|(name, _)| units::find(&name.text).is_some())
        }
        ExprKind::Negate(inner) => has_known_unit(inner),
        _ => false,
    }
}

/// An expression.
pub fn expression(cursor: &mut Cursor) -> Parsed<Expr> {
    nested(cursor, 0)
}

pub(super) fn nested(cursor: &mut Cursor, depth: usize) -> Parsed<Expr> {
    if depth > MAX_HEIGHT {
        return Err(Mistake::new(cursor.here(), say::TOO_DEEP));
    }
    let mut left = product(cursor, depth)?;
    loop {
        let operator = match () {
            () if cursor.eat_punct('+') => Binary::Add,
            () if cursor.eat_punct('-') => Binary::Subtract,
            () => return Ok(left),
        };
        let right = product(cursor, depth)?;
        left = binary(operator, left, right)?;
    }
}

fn binary(operator: Binary, left: Expr, right: Expr) -> Parsed<Expr> {
    let (area, height) = (left.area.to(right.area), 1 + left.height.max(right.height));
    node(
        ExprKind::Binary(operator, Box::new(left), Box::new(right)),
        area,
        height,
    )
}

fn product(cursor: &mut Cursor, depth: usize) -> Parsed<Expr> {
    let mut left = signed(cursor, depth)?;
    loop {
        let operator = match () {
            () if cursor.eat_punct('*') => Binary::Multiply,
            () if cursor.eat_punct('/') => Binary::Divide,
            () if cursor.eat_punct('%') => {
                if cursor.is_empty() || cursor.is_value_excluded() {
                    return Err(Mistake::new(cursor.before(), say::PERCENT));
                }
                let right = signed(cursor, depth)?;
                let (area, height) = (left.area.to(right.area), 1 + left.height.max(right.height));
                left = node(ExprKind::Remainder(Box::new(left), Box::new(right)), area, height)?;
                continue;
            }
            () => return Ok(left),
        };
        if operator == Binary::Multiply && cursor.is_punct('*') {
            return Err(Mistake::new(cursor.here(), say::POWER));
        }
        let right = signed(cursor, depth)?;
        left = binary(operator, left, right)?;
    }
}

fn signed(cursor: &mut Cursor, depth: usize) -> Parsed<Expr> {
    let start = cursor.here();
    if cursor.eat_punct('+') {
        return Err(Mistake::new(start, say::PLUS_SIGN));
    }
    if !cursor.eat_punct('-') {
        return power(cursor, depth);
    }
    if depth > MAX_HEIGHT {
        return Err(Mistake::new(start, say::TOO_DEEP));
    }
    let inner = signed(cursor, depth + 1)?;
    let (area, height) = (cursor.since(start), 1 + inner.height);
    node(ExprKind::Negate(Box::new(inner)), area, height)
}

fn power(cursor: &mut Cursor, depth: usize) -> Parsed<Expr> {
    let base = member(cursor, depth)?;
    if !cursor.eat_punct('^') {
        return Ok(base);
    }
    if depth > MAX_HEIGHT {
        return Err(Mistake::new(cursor.here(), say::TOO_DEEP));
    }
    // The exponent takes its own sign and its own power: 2^-3, 2^3^2 = 2^(3^2).
    let exponent = signed(cursor, depth + 1)?;
    let (area, height) = (base.area.to(exponent.area), 1 + base.height.max(exponent.height));
    node(ExprKind::Power(Box::new(base), Box::new(exponent)), area, height)
}

fn member(cursor: &mut Cursor, depth: usize) -> Parsed<Expr> {
    let mut base = primary(cursor, depth)?;
    loop {
        if let Some(further) = repeat::further(cursor, &base, depth)? {
            base = further;
            continue;
        }
        if !cursor.eat_punct('.') {
            break;
        }
        if cursor.is_punct('.') {
            return Err(Mistake::new(cursor.here(), say::RANGE_AS_VALUE));
        }
        let field = cursor.expect_name("a word such as `end` or `x` after the dot")?;
        let arguments = match cursor.eat_group(Delimiter::Parenthesis) {
            Some(group) => Some(arguments(&mut Cursor::of(&group), depth + 1, &[3])?),
            None => None,
        };
        let (area, height) = (base.area.to(cursor.before().into()), 1 + base.height);
        base = node(
            ExprKind::Member {
                base: Box::new(base),
                field,
                arguments,
            },
            area,
            height,
        )?;
    }
    Ok(base)
}

/// Whether a word with which statements go on is a name here: `line[i]`, `angle(t)`; behind the word stands no vector.
fn is_named(cursor: &Cursor) -> bool {
    if !NAMES.iter().any(|word| cursor.is_word(word)) {
        return false;
    }
    match cursor.second_group() {
        Some(group) if group.delimiter() == Delimiter::Bracket => !is_list(group),
        Some(group) => group.delimiter() == Delimiter::Parenthesis,
        None => false,
    }
}

/// A name that may go on with numbers of repetitions and words behind dots.
pub(super) fn reference(cursor: &mut Cursor, what: &str) -> Parsed<Name> {
    let mark = cursor.mark();
    let name = cursor.expect_name(what)?;
    if cursor.group(Delimiter::Bracket).is_none() && !cursor.is_punct('.') {
        return Ok(name);
    }
    cursor.reset(mark);
    let path = Some(Box::new(member(cursor, 0)?));
    Ok(Name { path, ..name })
}

fn primary(cursor: &mut Cursor, depth: usize) -> Parsed<Expr> {
    let start = cursor.here();
    if let Some(TokenTree::Literal(literal)) = cursor.peek().cloned() {
        cursor.next();
        return literal_with_unit(cursor, &literal);
    }
    if cursor.is_punct('.')
        && let Some(digits) = cursor.second_literal()
    {
        return Err(Mistake::new(start, say::bare_point(&digits)));
    }
    let group = cursor.eat_group(Delimiter::Parenthesis);
    if group.as_ref().or(cursor.group(Delimiter::Brace)).is_some_and(is_list) {
        return Err(Mistake::new(start, say::VECTOR_BRACKETS));
    }
    if let Some(group) = group {
        let mut inner = whole(&mut Cursor::of(&group), depth, "an expression in the parentheses")?;
        inner.area = group.span().into();
        return Ok(inner);
    }
    if let Some(group) = cursor.eat_group(Delimiter::Bracket) {
        return vector(cursor, &group, depth);
    }
    if cursor.is_word("if") {
        return conditional(cursor, depth);
    }
    let ends = STOP.iter().any(|word| cursor.is_word(word)) && !cursor.is_second_punct_or_end() && !is_named(cursor);
    if cursor.word().is_none() || ends {
        return Err(cursor.expected("a value"));
    }
    let name = cursor.expect_name("a value")?;
    if let Some(expr) = repeat::indexed(cursor, &name, depth)? {
        return Ok(expr);
    }
    if let Some(expr) = repeat::reduced(cursor, &name, depth)? {
        return Ok(expr);
    }
    if cursor.group(Delimiter::Parenthesis).is_some() {
        let call = call(cursor, name, depth)?;
        let height = 1 + call
            .arguments
            .iter()
            .map(|argument| argument.value.height)
            .max()
            .unwrap_or(0);
        return node(ExprKind::Call(call), cursor.since(start), height);
    }
    node(ExprKind::Name(name), start.into(), 1)
}

/// Whether there are commas in it.
fn is_list(group: &Group) -> bool {
    let is_comma = |token: TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    group.stream().into_iter().any(is_comma)
}

/// What stands behind the `=` of an argument, up to the comma.
pub(super) fn argument(cursor: &mut Cursor) -> Parsed<Expr> {
    let mark = cursor.mark();
    // `2 deg * gain` is a product with something that has a name.
    let value = quantity(cursor).filter(has_known_unit);
    if let Some(value) = value.filter(|_| cursor.is_empty() || cursor.is_punct(',')) {
        return Ok(value);
    }
    cursor.reset(mark);
    nested(cursor, 1)
}

/// An expression that fills a group.
pub(super) fn whole(cursor: &mut Cursor, depth: usize, what: &str) -> Parsed<Expr> {
    if cursor.is_empty() {
        return Err(cursor.expected(what));
    }
    let expr = nested(cursor, depth + 1)?;
    if cursor.is_empty() {
        Ok(expr)
    } else {
        Err(cursor.expected("an operator"))
    }
}

fn literal_with_unit(cursor: &mut Cursor, literal: &Literal) -> Parsed<Expr> {
    let start = literal.span();
    let text = number(literal)?;
    let unit = if let Some(group) = cursor.eat_group(Delimiter::Bracket) {
        Some(unit::bracketed(&group)?)
    } else if is_unit_next(cursor) {
        let unit = unit::single(cursor)?;
        if cursor.is_punct('^') {
            let power = cursor.second_literal().unwrap_or_else(|| "2".to_string());
            return Err(Mistake::new(
                cursor.since(start),
                say::unit_power(&text, &unit.text, &power),
            ));
        }
        if cursor.is_punct('.')
            && let Some(next) = cursor.second_word()
        {
            return Err(Mistake::new(cursor.since(start), say::unit_point(&unit.text, &next)));
        }
        Some(unit)
    } else if cursor.is_word("in") {
        return Err(Mistake::new(cursor.here(), say::INCH));
    } else {
        None
    };
    node(ExprKind::Number { text, unit }, cursor.since(start), 1)
}

/// Text of a decimal literal.
fn number(literal: &Literal) -> Parsed<String> {
    let text = literal.to_string();
    if text.starts_with(['"', '\'']) {
        return Err(Mistake::new(literal.span(), say::QUOTES));
    }
    let at = text.find(|c: char| !(c.is_ascii_digit() || c == '_' || c == '.'));
    let (digits, rest) = text.split_at(at.unwrap_or(text.len()));
    let exponent = rest
        .strip_prefix(['e', 'E'])
        .map(|e| e.strip_prefix(['+', '-']).unwrap_or(e));
    let is_exponent = exponent.is_some_and(|e| !e.is_empty() && e.chars().all(|c| c.is_ascii_digit()));
    if digits.is_empty() || text.starts_with("0x") || text.starts_with("0b") || text.starts_with("0o") {
        return Err(Mistake::new(literal.span(), say::not_a_number(&text)));
    }
    if !rest.is_empty() && !is_exponent {
        // `1e5rpm`: the suffix starts behind the exponent.
        let exponent = rest.len()
            - rest
                .trim_start_matches(|c: char| "eE+-".contains(c) || c.is_ascii_digit())
                .len();
        let exponent = if rest[..exponent].ends_with(|c: char| c.is_ascii_digit()) {
            exponent
        } else {
            0
        };
        let (number, unit) = text.split_at(digits.len() + exponent);
        return Err(Mistake::new(literal.span(), say::missing_space(number, unit)));
    }
    Ok(text)
}

/// The three or six numbers of an inertia.
pub fn inertia(cursor: &mut Cursor) -> Parsed<Expr> {
    match cursor.eat_group(Delimiter::Bracket) {
        Some(group) => components(cursor, &group, 0, &[3, 6]),
        None => right_side(cursor),
    }
}

fn vector(cursor: &mut Cursor, group: &Group, depth: usize) -> Parsed<Expr> {
    components(cursor, group, depth, &[3])
}

/// `[a, b, ..] unit`, as many as there are.
pub fn list(cursor: &mut Cursor) -> Parsed<Expr> {
    match cursor.eat_group(Delimiter::Bracket) {
        Some(group) => components(cursor, &group, 0, &[]),
        None => Err(cursor.expected("`[` and values")),
    }
}

/// The number one, where nothing is written.
pub fn one(cursor: &Cursor) -> Expr {
    Expr {
        kind: ExprKind::Number {
            text: "1".to_string(),
            unit: None,
        },
        area: cursor.here().into(),
        height: 1,
    }
}

/// Components of one of these numbers, of any where there are none, and their unit.
fn components(cursor: &mut Cursor, group: &Group, depth: usize, counts: &[usize]) -> Parsed<Expr> {
    let mut inner = Cursor::of(group);
    let mut components = Vec::new();
    while !inner.is_empty() {
        components.push(nested(&mut inner, depth + 1)?);
        if !inner.is_empty() && !inner.eat_punct(',') {
            return Err(inner.expected("`,` between components"));
        }
    }
    if !counts.is_empty() && !counts.contains(&components.len()) {
        let message = if counts.contains(&6) {
            say::inertia_components(components.len())
        } else {
            say::three_components(components.len())
        };
        return Err(Mistake::new(group.span(), message));
    }
    let unit = if let Some(unit) = cursor.eat_group(Delimiter::Bracket) {
        Some(unit::bracketed(&unit)?)
    } else if is_unit_next(cursor) {
        let unit = unit::compound(cursor)?;
        unit::check_end(cursor)?;
        Some(UnitText {
            is_delimited: true,
            ..unit
        })
    } else {
        None
    };
    let height = 1 + components.iter().map(|component| component.height).max().unwrap_or(0);
    node(
        ExprKind::Vector { components, unit },
        cursor.since(group.span()),
        height,
    )
}

/// `(arguments)` behind a name.
pub fn call(cursor: &mut Cursor, name: Name, depth: usize) -> Parsed<Call> {
    let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
        return Err(cursor.expected(&format!("`(` after `{}`", name.text)));
    };
    // Along and across: the only vector of two components.
    let counts: &[usize] = if name.text == "follower" { &[2, 3] } else { &[3] };
    let arguments = arguments(&mut Cursor::of(&group), depth + 1, counts)?;
    let area = cursor.since(name.span);
    Ok(Call { name, arguments, area })
}

/// Arguments; those that are vectors have one of these numbers of components.
pub(super) fn arguments(cursor: &mut Cursor, depth: usize, counts: &[usize]) -> Parsed<Vec<Argument>> {
    let mut arguments = Vec::new();
    while !cursor.is_empty() {
        let is_named = cursor.word().is_some() && cursor.is_second_punct('=');
        if cursor.is_named_by_colon() {
            let name = cursor.expect_name("a name")?;
            return Err(Mistake::new(cursor.here(), say::named_by_colon(&name.text)));
        }
        let name = if is_named {
            Some(cursor.expect_name("a name")?)
        } else {
            None
        };
        if is_named {
            cursor.expect_punct('=')?;
            if let Some(value) = whole_literal(cursor) {
                arguments.push(Argument { name, value });
                continue;
            }
        }
        let mark = cursor.mark();
        let pair = match cursor.eat_group(Delimiter::Bracket) {
            Some(group) if counts.contains(&2) => Some(components(cursor, &group, depth, counts)?),
            _ => None,
        };
        let value = match pair.filter(|_| cursor.is_empty() || cursor.is_punct(',')) {
            Some(value) => value,
            None => {
                cursor.reset(mark);
                nested(cursor, depth)?
            }
        };
        arguments.push(Argument { name, value });
        if !cursor.is_empty() && !cursor.eat_punct(',') {
            return Err(cursor.expected("`,` or `)`"));
        }
    }
    Ok(arguments)
}

fn conditional(cursor: &mut Cursor, depth: usize) -> Parsed<Expr> {
    let start = cursor.here();
    if depth > MAX_HEIGHT {
        return Err(Mistake::new(start, say::TOO_DEEP));
    }
    cursor.expect_word("if")?;
    if cursor.group(Delimiter::Parenthesis).is_some() && cursor.is_second_group(Delimiter::Brace) {
        return Err(Mistake::new(cursor.here(), say::IF_PARENTHESES));
    }
    let left = nested(cursor, depth + 1)?;
    let comparison = comparison(cursor)?;
    let right = nested(cursor, depth + 1)?;
    let then = braced(cursor, depth, "`{` and the value where the condition holds")?;
    if !cursor.eat_word("else") {
        return Err(Mistake::new(cursor.since(start), say::MISSING_ELSE));
    }
    let otherwise = if cursor.is_word("if") {
        conditional(cursor, depth + 1)?
    } else {
        braced(cursor, depth, "`{` and the value where the condition does not hold")?
    };
    let height = 1 + [&left, &right, &then, &otherwise]
        .map(|expr| expr.height)
        .into_iter()
        .max()
        .unwrap_or(0);
    let inner = If {
        comparison,
        left,
        right,
        then,
        otherwise,
    };
    node(ExprKind::If(Box::new(inner)), cursor.since(start), height)
}

fn braced(cursor: &mut Cursor, depth: usize, what: &str) -> Parsed<Expr> {
    match cursor.eat_group(Delimiter::Brace) {
        Some(group) => whole(&mut Cursor::of(&group), depth, "a value in the braces"),
        None => Err(cursor.expected(what)),
    }
}

/// `<`, `<=`, `>` or `>=`.
pub fn comparison(cursor: &mut Cursor) -> Parsed<Comparison> {
    let start = cursor.here();
    let less = cursor.eat_punct('<');
    if !less && !cursor.eat_punct('>') {
        if (cursor.is_punct('=') || cursor.is_punct('!')) && cursor.is_second_punct('=') {
            cursor.next();
            cursor.next();
            return Err(Mistake::new(cursor.since(start), say::NO_EQUALITY));
        }
        return Err(cursor.expected("`<`, `<=`, `>` or `>=`"));
    }
    Ok(match (less, cursor.eat_punct('=')) {
        (true, false) => Comparison::Less,
        (true, true) => Comparison::LessEqual,
        (false, false) => Comparison::Greater,
        (false, true) => Comparison::GreaterEqual,
    })
}

/// The number of elements in front of `*`: a whole number, a name, or something in parentheses.
pub fn count(cursor: &mut Cursor) -> Parsed<Expr> {
    primary(cursor, 0)
}
