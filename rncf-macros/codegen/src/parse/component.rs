//! Components: items under one name, with what they are told where they are placed.

use proc_macro2::Delimiter;

use super::cursor::{Cursor, Parsed};
use super::messages as say;
use super::recover::recover;
use super::tree::{Keyword, Name, Parameter, ParameterKind, Tree};
use super::{expr, item, unit};
use crate::errors::Errors;

/// Kinds of what a component is told, beside units of quantities.
const KINDS: [(&str, ParameterKind); 12] = [
    ("angle", ParameterKind::Angle),
    ("number", ParameterKind::Number),
    ("count", ParameterKind::Count),
    ("vector", ParameterKind::Vector),
    ("place", ParameterKind::Place),
    ("frame", ParameterKind::Item(&[Keyword::Frame, Keyword::Rigid])),
    ("body", ParameterKind::Item(&[Keyword::Body])),
    ("joint", ParameterKind::Item(&[Keyword::Joint])),
    ("motion", ParameterKind::Item(&[Keyword::Motion])),
    ("material", ParameterKind::Item(&[Keyword::Material])),
    ("section", ParameterKind::Item(&[Keyword::Section])),
    ("table", ParameterKind::Item(&[Keyword::Table])),
];

/// Words that mean something else where they stand in expressions, so that a component is not told them.
pub const TAKEN: &[&str] = &[
    "x", "y", "z", "xy", "yz", "zx", "t", "pi", "E", "position", "slope", "inertial", "total", "t_end",
];

/// `component Name(parameters) { items }`; its items are read whatever is wrong in its head.
pub fn component(cursor: &mut Cursor, doc: String, tree: &mut Tree, is_in_loop: bool, errors: &mut Errors) {
    let keyword = cursor.here();
    cursor.next();
    if is_in_loop {
        errors.at(keyword, say::COMPONENT_IN_LOOP);
    } else if tree.is_component {
        errors.at(keyword, say::COMPONENT_INSIDE);
    }
    let word = cursor.word().map(ToString::to_string);
    let name = cursor.expect_name("the name of a component").and_then(|name| {
        item::check_name(&name)?;
        Ok(name)
    });
    let name = match name {
        Ok(name) => name,
        Err(mistake) => {
            errors.push(mistake);
            tree.lost.extend(word);
            return recover(cursor);
        }
    };
    let mut component = Tree {
        doc,
        is_component: true,
        ..Tree::new(name)
    };
    let before = errors.len();
    parameters(cursor, &mut component, errors);
    let Some(group) = cursor.eat_group(Delimiter::Brace) else {
        errors.push(cursor.expected("`{` and the items of the component"));
        tree.lost.push(component.name.text);
        return recover(cursor);
    };
    item::items(&mut Cursor::of(&group), &mut component, None, errors);
    component.complete = errors.len() == before;
    if let Some(first) = tree
        .components
        .iter()
        .find(|other| other.name.text == component.name.text)
    {
        let line = first.name.line().to_string();
        let message = crate::messages::duplicate(&component.name.text, "component", &line);
        errors.at(component.name.span, message);
    }
    tree.components.push(component);
}

/// `(name: kind [= value], ..)`
fn parameters(cursor: &mut Cursor, component: &mut Tree, errors: &mut Errors) {
    let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
        errors.push(cursor.expected("`(` and what the component is told, e.g. `(azimuth: angle)`, or `()`"));
        return;
    };
    let mut inner = Cursor::of(&group);
    while !inner.is_empty() {
        let word = inner.word().map(ToString::to_string);
        match parameter(&mut inner) {
            Ok(parameter) => add(parameter, component, errors),
            Err(mistake) => {
                errors.push(mistake);
                component.lost.extend(word);
                while !inner.is_empty() && !inner.is_punct(',') {
                    inner.next();
                }
                inner.eat_punct(',');
            }
        }
    }
}

fn add(parameter: Parameter, component: &mut Tree, errors: &mut Errors) {
    let Name { text, span, .. } = &parameter.name;
    if TAKEN.contains(&text.as_str()) {
        errors.at(*span, say::meaning_of_its_own(text));
    } else if component.parameters.iter().any(|other| other.name.text == *text) {
        errors.at(*span, say::parameter_twice(text));
    }
    component.parameters.push(parameter);
}

fn parameter(cursor: &mut Cursor) -> Parsed<Parameter> {
    let name = cursor.expect_name("a name, `azimuth: angle`")?;
    item::check_name(&name)?;
    if !cursor.eat_punct(':') {
        return Err(cursor.expected(&format!(
            "`:` and what `{}` is, e.g. `angle`, `m` or `frame`",
            name.text
        )));
    }
    let kind = kind(cursor)?;
    let default = match cursor.eat_punct('=') {
        true => Some(expr::argument(cursor)?),
        false => None,
    };
    if !cursor.is_empty() && !cursor.eat_punct(',') {
        return Err(cursor.expected("`,` or `)`"));
    }
    Ok(Parameter { name, kind, default })
}

/// A word of [`KINDS`], or a unit.
fn kind(cursor: &mut Cursor) -> Parsed<ParameterKind> {
    let word = cursor.word().map(ToString::to_string).unwrap_or_default();
    if let Some((_, kind)) = KINDS.iter().find(|(known, _)| *known == word) {
        cursor.next();
        return Ok(kind.clone());
    }
    let mark = cursor.mark();
    let unknown = |cursor: &Cursor| {
        let known = KINDS.map(|(word, _)| word);
        let message = say::parameter_kind(&word, &known.join("`, `"));
        crate::errors::Mistake::new(cursor.here(), message)
    };
    match unit::compound(cursor) {
        Ok(unit)
            if unit
                .factors
                .iter()
                .all(|(name, _)| crate::units::find(&name.text).is_some()) =>
        {
            Ok(ParameterKind::Quantity(unit))
        }
        _ => {
            cursor.reset(mark);
            Err(unknown(cursor))
        }
    }
}
