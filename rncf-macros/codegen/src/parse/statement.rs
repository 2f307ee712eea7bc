//! Statements of bodies.

use proc_macro2::Delimiter;

use super::cursor::{Cursor, Parsed};
use super::documentation::documentation;
use super::messages as say;
use super::recover::recover_before;
use super::tree::{ExprKind, Statement};
use super::{expr, import, repeat};
use crate::errors::{Area, Errors, Mistake};

/// Statements of a body.
const STATEMENTS: &[&str] = &[
    "planar",
    "spatial",
    "line",
    "arc",
    "curve",
    "section_y",
    "twist",
    "mesh",
    "import",
    "interface",
    "interface_modes",
    "damping",
    "initial",
    "mean_axes",
    "chord",
    "modal",
    "small",
    "rigid",
    "point",
];

pub(super) fn statements(cursor: &mut Cursor, errors: &mut Errors) -> Vec<Statement> {
    let mut statements = Vec::new();
    while !cursor.is_empty() {
        documentation(cursor, errors);
        if cursor.is_empty() {
            break;
        }
        match statement(cursor) {
            Ok(statement) => statements.push(statement),
            Err(mistake) => {
                errors.push(mistake);
                recover_statement(cursor);
            }
        }
    }
    statements
}

fn statement(cursor: &mut Cursor) -> Parsed<Statement> {
    let word = cursor.expect_name("a statement such as `line` or `mesh`")?;
    let area = Area::from(word.span);
    if STATEMENTS.contains(&word.text.as_str()) && cursor.is_punct('=') {
        return Err(Mistake::new(cursor.here(), say::no_equals(&word.text)));
    }
    let statement = match word.text.as_str() {
        "planar" => {
            let plane = cursor.expect_name("a plane: `xy`, `yz` or `zx`")?;
            Statement::Space {
                area: cursor.since(word.span),
                plane: Some(plane),
            }
        }
        "spatial" => Statement::Space { area, plane: None },
        "mean_axes" | "chord" => Statement::FrameTie { word },
        "rigid" | "point" => Statement::Fidelity { word, count: None },
        "modal" | "small" => {
            let call = expr::call(cursor, word.clone(), 0)?;
            let mut arguments = call.arguments;
            let count = match (arguments.pop(), arguments.is_empty()) {
                (Some(only), true) if only.name.is_none() => Some(only.value),
                _ => return Err(Mistake::new(call.area, say::mode_count(&word.text))),
            };
            Statement::Fidelity { word, count }
        }
        "line" => {
            if !cursor.eat_word("from") {
                return Err(cursor.expected("`from`, `line from [0, 0, 0] m to [1, 0, 0] m;`"));
            }
            let from = expr::expression(cursor)?;
            cursor.expect_word("to")?;
            let (mut corners, mut to) = (Vec::new(), expr::expression(cursor)?);
            while cursor.eat_word("to") {
                corners.push(std::mem::replace(&mut to, expr::expression(cursor)?));
            }
            Statement::Line {
                area,
                from,
                corners,
                to,
            }
        }
        "arc" => {
            cursor.expect_word("from")?;
            let from = expr::expression(cursor)?;
            cursor.expect_word("direction")?;
            let direction = Box::new(expr::expression(cursor)?);
            let normal = match cursor.eat_word("normal") {
                true => Some(Box::new(expr::expression(cursor)?)),
                false => None,
            };
            cursor.expect_word("radius")?;
            let radius = Box::new(expr::expression(cursor)?);
            cursor.expect_word("angle")?;
            Statement::Arc {
                area,
                from,
                direction,
                normal,
                radius,
                angle: Box::new(expr::expression(cursor)?),
            }
        }
        "curve" if cursor.eat_word("through") => {
            let table = expr::reference(cursor, "the name of a table with columns x, y, z")?;
            let mut directions = Box::new([None, None]);
            for (direction, word) in directions.iter_mut().zip(["from", "to"]) {
                if cursor.eat_word(word) {
                    cursor.expect_word("direction")?;
                    *direction = Some(expr::expression(cursor)?);
                }
            }
            Statement::Curve {
                area,
                table,
                directions,
            }
        }
        "curve" => {
            let position = expr::expression(cursor)?;
            cursor.expect_word("for")?;
            let parameter = cursor.expect_name("the name of the curve's parameter, e.g. `s`")?;
            cursor.expect_word("from")?;
            let from = expr::expression(cursor)?;
            cursor.expect_word("to")?;
            Statement::Path {
                area,
                position,
                parameter,
                range: Box::new([from, expr::expression(cursor)?]),
            }
        }
        "import" => import::files(cursor, area)?,
        "interface" => import::interface(cursor)?,
        "interface_modes" => Statement::InterfaceModes { word },
        "damping" => Statement::Damping {
            area,
            value: expr::expression(cursor)?,
        },
        "section_y" => Statement::SectionY {
            area,
            value: expr::expression(cursor)?,
        },
        "twist" => Statement::Twist {
            area,
            value: expr::right_side(cursor)?,
        },
        "initial" => {
            let of = cursor.expect_name("`position` or `velocity`")?;
            if !["position", "velocity"].contains(&of.text.as_str()) {
                let message = say::unknown("initial quantity", &of.text, ["position", "velocity"]);
                return Err(Mistake::new(of.span, message));
            }
            let value = expr::expression(cursor)?;
            Statement::Initial {
                word: of,
                area: cursor.since(word.span),
                value,
            }
        }
        "mesh" => {
            let count = if cursor.is_word("at") && !cursor.is_second_punct('*') {
                expr::one(cursor)
            } else {
                expr::count(cursor)?
            };
            let stations = match cursor.eat_word("at") {
                true => Some(expr::reference(cursor, "the name of a table")?),
                false => None,
            };
            let is_element_first = matches!(count.kind, ExprKind::Call(_));
            if is_element_first && !cursor.is_punct('*') {
                return Err(Mistake::new(count.area, say::COUNT_BEHIND));
            }
            let is_computed = |cursor: &Cursor| ['*', '+', '-', '/'].iter().any(|&sign| cursor.is_punct(sign));
            if is_computed(cursor) && !cursor.is_punct('*') {
                return Err(Mistake::new(count.area, say::COUNT_IN_BRACKETS));
            }
            cursor.expect_punct('*')?;
            if is_element_first && !cursor.is_second_group(Delimiter::Parenthesis) {
                return Err(Mistake::new(count.area, say::COUNT_BEHIND));
            }
            let name = repeat::called(cursor, "an element, `mesh 6 * element(section, material);`")?;
            if is_computed(cursor) || cursor.is_word("at") {
                return Err(Mistake::new(cursor.since(count.area.start), say::COUNT_IN_BRACKETS));
            }
            Statement::Mesh {
                area,
                count,
                stations,
                element: expr::call(cursor, name, 0)?,
            }
        }
        other => {
            return Err(Mistake::new(
                word.span,
                say::unknown("statement", other, STATEMENTS.iter().copied()),
            ));
        }
    };
    cursor.expect_end()?;
    Ok(statement)
}

fn recover_statement(cursor: &mut Cursor) {
    recover_before(cursor, |cursor| STATEMENTS.iter().any(|word| cursor.is_word(word)));
}
