//! Elements: what stands in the braces of `element name(section, material) { .. }`.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::{Cursor, Parsed};
use super::documentation::documentation;
use super::item::check_name;
use super::messages as say;
use super::recover::recover_before;
use super::tree::{ElementKind, ElementStatement, Expr, ItemKind, Name, When};
use super::{expr, unit};
use crate::errors::{Errors, Mistake};

/// Words that a statement of an element begins with.
pub const STATEMENTS: [&str; 12] = [
    "domain",
    "vector",
    "field",
    "coefficient",
    "inertia",
    "damping",
    "option",
    "let",
    "strain",
    "energy",
    "points",
    "also",
];

/// `(section, material) { statement .. }`, behind the name.
pub fn element(cursor: &mut Cursor, errors: &mut Errors) -> Parsed<ItemKind> {
    let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
        return Err(cursor.expected("`(section, material)` after the name of the element"));
    };
    let mut inner = Cursor::of(&group);
    let is_of_section = inner.eat_word("section") && inner.is_empty();
    let is_usual = is_of_section || inner.eat_punct(',') && inner.eat_word("material");
    if !is_usual || !inner.is_empty() {
        return Err(Mistake::new(group.span(), say::ELEMENT_ARGUMENTS));
    }
    let of_section = is_of_section.then(|| group.span());
    let Some(group) = cursor.eat_group(Delimiter::Brace) else {
        return Err(cursor.expected("`{` and the statements of the element"));
    };
    let before = errors.len();
    let mut inner = Cursor::of(&group);
    let mut statements = Vec::new();
    while !inner.is_empty() {
        let doc = documentation(&mut inner, errors);
        if inner.is_empty() {
            break;
        }
        match statement(&mut inner, doc) {
            Ok(statement) => statements.push(statement),
            Err(mistake) => {
                errors.push(mistake);
                recover_before(&mut inner, |cursor| {
                    STATEMENTS.iter().any(|word| cursor.is_word(word)) && cursor.is_two_words()
                });
            }
        }
    }
    Ok(ItemKind::Element {
        of_section,
        statements,
        complete: errors.len() == before,
    })
}

fn statement(cursor: &mut Cursor, doc: String) -> Parsed<ElementStatement> {
    let word = cursor.expect_name("a statement of an element such as `vector` or `energy`")?;
    let kind = match word.text.as_str() {
        "domain" => {
            let coordinate = name(cursor, "the coordinate of the unit element")?;
            cursor.expect_word("in")?;
            unit_range(cursor)?;
            ElementKind::Domain { coordinate }
        }
        "vector" => {
            let name = name(cursor, "the name of a nodal vector")?;
            cursor.expect_punct('=')?;
            let of = cursor.expect_name("what it is: `r`, `r_x`, `r_y` or `r_z`")?;
            cursor.expect_word("at")?;
            let place = expr::expression(cursor)?;
            cursor.expect_punct(',')?;
            cursor.expect_word("shape")?;
            let shape = expr::expression(cursor)?;
            ElementKind::Vector { name, of, place, shape }
        }
        "field" => {
            let name = name(cursor, "the name of a field")?;
            cursor.expect_punct('=')?;
            let of = cursor.expect_name("a derivative such as `r_x`")?;
            ElementKind::Field { name, of }
        }
        "coefficient" => {
            let name = name(cursor, "the name of a coefficient")?;
            if cursor.is_punct('=') {
                return Err(Mistake::new(name.span, say::coefficient_without_unit(&name.text)));
            }
            cursor.expect_punct(':')?;
            let unit = unit::before_equals(cursor)?;
            cursor.expect_punct('=')?;
            let value = expr::right_side(cursor)?;
            ElementKind::Coefficient { name, unit, value }
        }
        "inertia" => {
            let of = cursor.expect_name("what moves: `r`, `r_y` or `r_z`")?;
            cursor.expect_punct('=')?;
            let coefficient = cursor.expect_name("a coefficient")?;
            ElementKind::Inertia { of, coefficient }
        }
        "damping" => {
            cursor.expect_punct('=')?;
            ElementKind::Damping(expr::expression(cursor)?)
        }
        "option" => {
            let option = name(cursor, "the name of an option")?;
            cursor.expect_punct('=')?;
            let mut values = vec![cursor.expect_name("a value of the option")?];
            while cursor.eat_punct('|') {
                values.push(cursor.expect_name("a value of the option")?);
            }
            ElementKind::Option { name: option, values }
        }
        "let" | "strain" => {
            let name = name(cursor, "a name")?;
            let when = when(cursor)?;
            cursor.expect_punct('=')?;
            ElementKind::Definition {
                is_strain: word.text == "strain",
                name,
                when,
                value: expr::expression(cursor)?,
            }
        }
        "energy" => energy(cursor)?,
        "points" => ElementKind::Points(expr::expression(cursor)?),
        "also" => ElementKind::Also(name(cursor, "another name of the element")?),
        other => {
            let message = say::unknown("statement of an element", other, STATEMENTS.iter().copied());
            return Err(Mistake::new(word.span, message));
        }
    };
    cursor.expect_end()?;
    Ok(ElementStatement { doc, word, kind })
}

/// `name [when ..] = value [, stress value] [, points count] [, active | undamped | viscous]`
fn energy(cursor: &mut Cursor) -> Parsed<ElementKind> {
    let name = name(cursor, "the name of a part of the energy")?;
    let when = when(cursor)?;
    cursor.expect_punct('=')?;
    let value = expr::expression(cursor)?;
    let mut tail = |word: &str| -> Parsed<Option<Expr>> {
        if cursor.is_punct(',') && cursor.is_second_word(word) {
            cursor.next();
            cursor.next();
            return expr::expression(cursor).map(Some);
        }
        Ok(None)
    };
    let (stress, points) = (tail("stress")?, tail("points")?);
    let mut nature = None;
    let is_nature = |cursor: &Cursor| {
        ["active", "undamped", "viscous"]
            .iter()
            .any(|word| cursor.is_second_word(word))
    };
    if cursor.is_punct(',') && is_nature(cursor) {
        cursor.next();
        nature = Some(Box::new(cursor.expect_name("`active`")?));
    }
    Ok(ElementKind::Energy {
        name,
        when,
        value,
        stress,
        points,
        nature,
    })
}

/// `[when OPTION is VALUE { and OPTION is VALUE }] [in plane | in space]`
fn when(cursor: &mut Cursor) -> Parsed<When> {
    let mut when = When {
        options: Vec::new(),
        space: None,
    };
    if cursor.eat_word("when") {
        loop {
            let option = cursor.expect_name("an option of the element")?;
            cursor.expect_word("is")?;
            when.options
                .push((option, cursor.expect_name("a value of the option")?));
            if !cursor.eat_word("and") {
                break;
            }
        }
    }
    if cursor.eat_word("in") {
        let space = cursor.expect_name("`plane` or `space`")?;
        if !["plane", "space"].contains(&space.text.as_str()) {
            return Err(Mistake::new(
                space.span,
                say::unknown("space", &space.text, ["plane", "space"]),
            ));
        }
        when.space = Some(space);
    }
    Ok(when)
}

/// `0..1`
fn unit_range(cursor: &mut Cursor) -> Parsed<()> {
    let start = cursor.here();
    let literal = |cursor: &mut Cursor, text: &str| {
        let is = matches!(cursor.peek(), Some(TokenTree::Literal(literal)) if literal.to_string() == text);
        is && cursor.next().is_some()
    };
    let is_unit = literal(cursor, "0") && cursor.eat_punct('.') && cursor.eat_punct('.') && literal(cursor, "1");
    if !is_unit || !cursor.is_punct(';') {
        return Err(Mistake::new(start, say::ELEMENT_DOMAIN));
    }
    Ok(())
}

fn name(cursor: &mut Cursor, what: &str) -> Parsed<Name> {
    let name = cursor.expect_name(what)?;
    check_name(&name)?;
    Ok(name)
}
