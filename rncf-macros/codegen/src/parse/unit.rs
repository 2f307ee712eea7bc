//! Units behind numbers: one symbol, or a compound one.

use proc_macro2::{Delimiter, Group, TokenTree};

use super::cursor::{Cursor, Parsed};
use super::expr::is_unit_next;
use super::messages as say;
use super::tree::UnitText;
use crate::errors::Mistake;

/// Longest text of a unit: keeps nested parentheses from exhausting the stack.
const LONGEST: usize = 100;

/// Exactly one symbol.
pub fn single(cursor: &mut Cursor) -> Parsed<UnitText> {
    let name = cursor.expect_name("a unit")?;
    Ok(UnitText {
        text: name.text.clone(),
        area: name.span.into(),
        factors: vec![(name, 1)],
        is_delimited: false,
    })
}

/// The content of `[m/s^2]`.
pub fn bracketed(group: &Group) -> Parsed<UnitText> {
    let mut cursor = Cursor::of(group);
    let mut unit = compound(&mut cursor)?;
    check_end(&cursor)?;
    if !cursor.is_empty() {
        return Err(cursor.expected("a unit such as `m/s^2`"));
    }
    unit.area = group.span().into();
    unit.is_delimited = true;
    Ok(unit)
}

/// A unit up to `=`, in brackets or not, which is no name of an argument here.
pub fn before_equals(cursor: &mut Cursor) -> Parsed<UnitText> {
    if let Some(group) = cursor.eat_group(Delimiter::Bracket) {
        return bracketed(&group);
    }
    let mut tokens = Vec::new();
    while !cursor.is_punct('=') && !cursor.is_punct(';') {
        match cursor.next() {
            Some(token) => tokens.push(token),
            None => break,
        }
    }
    let mut inner = Cursor::new(tokens.into_iter().collect(), cursor.here());
    let unit = compound(&mut inner)?;
    if inner.is_empty() {
        return Ok(unit);
    }
    Err(inner.expected("a unit such as `N m^2`"))
}

/// Refuses a symbol behind a quotient: `m/s s` may mean two things.
pub fn check_end(cursor: &Cursor) -> Parsed<()> {
    if is_unit_next(cursor) {
        return Err(Mistake::new(cursor.here(), say::unit_after_slash(&cursor.found())));
    }
    Ok(())
}

/// `kg/m^3`, `N*m`, `N m`, `1/s`, `W/(m K)`: as far as it goes.
pub fn compound(cursor: &mut Cursor) -> Parsed<UnitText> {
    let start = cursor.here();
    let mut unit = UnitText {
        factors: Vec::new(),
        text: String::new(),
        is_delimited: false,
        area: start.into(),
    };
    factors(cursor, (1, false), &mut unit)?;
    unit.area = cursor.since(start);
    Ok(unit)
}

/// Factors, or divisors where the sign is -1; in parentheses nothing but a unit stands.
fn factors(cursor: &mut Cursor, (sign, is_inside): (i32, bool), unit: &mut UnitText) -> Parsed<()> {
    factor(cursor, sign, unit)?;
    let mut divided = false;
    loop {
        if !is_inside && is_value_behind(cursor) {
            return Ok(());
        }
        if cursor.eat_punct('*') {
            unit.text.push(' ');
            factor(cursor, sign, unit)?;
        } else if cursor.eat_punct('/') {
            divided = true;
            unit.text.push('/');
            factor(cursor, -sign, unit)?;
        } else if is_unit_next(cursor) {
            if divided {
                return Ok(());
            }
            // `2 1 m` is a blank within a number.
            if unit.text == "1" {
                return Err(cursor.expected("`/`"));
            }
            unit.text.push(' ');
            factor(cursor, sign, unit)?;
        } else {
            return Ok(());
        }
    }
}

/// Whether a number, a value that is called, a member, or an expression in parentheses multiplies or divides what the unit belongs to:
/// `[0, 1, 0] N * f(t)`.
fn is_value_behind(cursor: &mut Cursor) -> bool {
    let mark = cursor.mark();
    let is_value = |cursor: &Cursor| match cursor.peek() {
        Some(TokenTree::Literal(_)) => true,
        Some(TokenTree::Ident(_)) => cursor.is_second_group(Delimiter::Parenthesis) || cursor.is_second_punct('.'),
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => !is_unit(group),
        _ => false,
    };
    let is_behind = (cursor.eat_punct('*') || cursor.eat_punct('/')) && is_value(cursor);
    cursor.reset(mark);
    is_behind
}

/// Whether what stands in parentheses is a unit, and no value.
fn is_unit(group: &Group) -> bool {
    let mut cursor = Cursor::of(group);
    let mut unit = UnitText {
        factors: Vec::new(),
        text: String::new(),
        is_delimited: false,
        area: group.span().into(),
    };
    factors(&mut cursor, (1, true), &mut unit).is_ok() && cursor.is_empty()
}

fn factor(cursor: &mut Cursor, sign: i32, unit: &mut UnitText) -> Parsed<()> {
    if matches!(cursor.peek(), Some(TokenTree::Literal(literal)) if literal.to_string() == "1") {
        cursor.next();
        unit.text.push('1');
        return Ok(());
    }
    if unit.text.len() > LONGEST {
        return Err(Mistake::new(cursor.here(), say::TOO_DEEP));
    }
    if let Some(group) = cursor.eat_group(Delimiter::Parenthesis) {
        let mut inner = Cursor::of(&group);
        unit.text.push('(');
        factors(&mut inner, (sign, true), unit)?;
        unit.text.push(')');
        return if inner.is_empty() {
            Ok(())
        } else {
            Err(inner.expected("a unit"))
        };
    }
    let name = cursor.expect_name("a unit such as `m`")?;
    unit.text.push_str(&name.text);
    let exponent = if cursor.eat_punct('^') {
        exponent(cursor, unit)?
    } else {
        1
    };
    unit.factors.push((name, sign * exponent));
    Ok(())
}

fn exponent(cursor: &mut Cursor, unit: &mut UnitText) -> Parsed<i32> {
    let minus = cursor.eat_punct('-');
    let digits = match cursor.peek() {
        Some(TokenTree::Literal(literal)) => literal.to_string(),
        _ => String::new(),
    };
    let Some(value) = digits.parse::<i32>().ok().filter(|value| (1..=12).contains(value)) else {
        return Err(cursor.expected("a whole exponent such as `2`"));
    };
    cursor.next();
    unit.text.push_str(if minus { "^-" } else { "^" });
    unit.text.push_str(&digits);
    Ok(if minus { -value } else { value })
}
