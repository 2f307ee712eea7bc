//! Items of a model and statements of a body.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::{Cursor, Parsed};
use super::documentation::documentation;
use super::messages as say;
use super::recover::{recover, recover_before};
use super::statement::statements;
use super::tree::{Caution, Field, Fields, Item, ItemKind, Keyword, Name, Tree};
use super::{ascii, element, expr, table, unit};
use crate::errors::{Area, Errors, Mistake};
use crate::{suggest, units};

/// All items of a model, or of a loop.
pub fn items(cursor: &mut Cursor, tree: &mut Tree, repeat: Option<usize>, errors: &mut Errors) {
    while !cursor.is_empty() {
        let doc = documentation(cursor, errors);
        if cursor.is_empty() {
            return;
        }
        if cursor.is_word("for") {
            super::repeat::repeated(cursor, tree, repeat, errors);
            continue;
        }
        if cursor.is_word("run") {
            if repeat.is_some() {
                errors.at(cursor.here(), say::outside_of_loops("run"));
            } else if tree.is_component {
                errors.at(cursor.here(), say::RUN_INSIDE);
            }
            run(cursor, tree, errors);
            continue;
        }
        if cursor.is_word("component") && cursor.is_two_words() {
            super::component::component(cursor, doc, tree, repeat.is_some(), errors);
            continue;
        }
        let Some(keyword) = cursor.word().and_then(|word| Keyword::of(&word.to_string())) else {
            errors.push(unknown_item(cursor));
            cursor.next();
            tree.lost.extend(cursor.word().map(ToString::to_string));
            recover(cursor);
            continue;
        };
        cursor.next();
        let at = cursor.before();
        let word = cursor.word().map(ToString::to_string);
        match item_name(cursor, keyword) {
            Ok(name) => {
                super::repeat::own_index(cursor, &name, tree, repeat, errors);
                let item = item(cursor, doc, keyword, name, errors);
                // A field of the model has the name of its param, which that of a part or repetition cannot be.
                if keyword == Keyword::Param && (tree.is_component || repeat.is_some()) {
                    if tree.is_component {
                        errors.at(at, say::PARAM_INSIDE);
                    } else {
                        errors.at(at, say::outside_of_loops(keyword.word()));
                    }
                    tree.lost.extend(word);
                } else {
                    tree.items.push(Item { repeat, ..item });
                }
            }
            Err(mistake) => {
                errors.push(mistake);
                tree.lost.extend(word);
                recover(cursor);
            }
        }
    }
}

/// What stands where an item should: a word that is nearly one, or something else.
fn unknown_item(cursor: &Cursor) -> Mistake {
    let valid = Keyword::ALL
        .map(Keyword::word)
        .into_iter()
        .chain(["run", "for", "component"]);
    // `left = pin(..)`: what is called tells what it would be.
    let called = cursor.third_word().filter(|_| cursor.is_second_punct('='));
    let keywords = Keyword::ALL.map(Keyword::word);
    let meant = called
        .as_ref()
        .map(|call| suggest::elsewhere::synonyms(call, &keywords));
    if let (Some(word), Some(call), Some([keyword])) = (cursor.word(), &called, meant.as_deref()) {
        return Mistake::new(word.span(), say::without_keyword(&word.to_string(), keyword, call));
    }
    match cursor.word() {
        Some(word) => Mistake::new(word.span(), say::unknown("item", &word.to_string(), valid)),
        None => cursor.expected("an item such as `param` or `body`"),
    }
}

fn item_name(cursor: &mut Cursor, keyword: Keyword) -> Parsed<Name> {
    // A keyword before a name is an item whose line before is half: `param` `body beam ..`. In `body part in hub` it is a name.
    let is_next_item = cursor
        .word()
        .is_some_and(|word| Keyword::of(&word.to_string()).is_some());
    if is_next_item && cursor.is_two_words() && !["in", "on"].iter().any(|word| cursor.is_second_word(word)) {
        return Err(Mistake::new(cursor.before(), say::missing_name(keyword.word())));
    }
    let name = cursor.expect_name(&format!("a name after `{}`", keyword.word()))?;
    let is_value = cursor.group(Delimiter::Parenthesis).is_some() || cursor.is_punct('.');
    if is_value && is_assigned(keyword) {
        return Err(Mistake::new(name.span, say::unnamed(keyword.word(), &name.text)));
    }
    check_name(&name)?;
    Ok(name)
}

/// Whether the item is a name, `=` and what it is.
fn is_assigned(keyword: Keyword) -> bool {
    use Keyword::{Const, Constraint, Frame, Joint, Let, Load, Output, Param, Part, Section, Spring, Start, State};
    matches!(
        keyword,
        Const | Constraint | Frame | Joint | Let | Load | Output | Param | Part | Section | Spring | Start | State
    )
}

/// Refuses names that cannot be Rust identifiers or have a meaning of their own.
pub fn check_name(name: &Name) -> Parsed<()> {
    let text = name.text.as_str();
    let message = if let Some(plain) = ascii::suggestion(text) {
        say::not_ascii(text, &plain)
    } else if let Some(plain) = text.strip_prefix("r#") {
        say::raw_name(plain)
    } else if !ascii::is_identifier(text) {
        say::rust_keyword(text)
    } else {
        return Ok(());
    };
    Err(Mistake::new(name.span, message))
}

/// Content of an item; unreadable content is reported and left out.
fn item(cursor: &mut Cursor, doc: String, keyword: Keyword, name: Name, errors: &mut Errors) -> Item {
    let kind = match keyword {
        Keyword::Param if table::is_param(cursor) => table::param(cursor).unwrap_or_else(|mistake| {
            errors.push(mistake);
            recover(cursor);
            ItemKind::Broken
        }),
        Keyword::Param => param(cursor, &name, errors),
        _ => content(cursor, keyword, errors).unwrap_or_else(|mistake| {
            errors.push(mistake);
            recover(cursor);
            ItemKind::Broken
        }),
    };
    // What reads a table does not ask where its rows come from.
    let is_table = matches!(kind, ItemKind::FileTable { .. });
    Item {
        doc,
        keyword: if is_table { Keyword::Table } else { keyword },
        name,
        repeat: None,
        is_shared: false,
        kind,
    }
}

/// A parameter keeps its kind even where its value is unreadable: the struct keeps its field.
fn param(cursor: &mut Cursor, name: &Name, errors: &mut Errors) -> ItemKind {
    let mut count = false;
    let value = param_value(cursor, name, &mut count).unwrap_or_else(|mistake| {
        errors.push(mistake);
        recover(cursor);
        None
    });
    ItemKind::Param { count, value }
}

fn param_value(cursor: &mut Cursor, name: &Name, count: &mut bool) -> Parsed<Option<super::tree::Expr>> {
    if cursor.eat_punct(':') {
        let Some(kind) = cursor.word().map(ToString::to_string) else {
            return Err(Mistake::new(cursor.here(), say::quantity_kind(&name.text)));
        };
        if kind != "count" {
            let message = match suggest::alike(&kind, &["count", "table"]).is_empty() {
                true => say::quantity_kind(&name.text),
                false => say::unknown("kind of parameter", &kind, ["count", "table"]),
            };
            return Err(Mistake::new(cursor.here(), message));
        }
        cursor.next();
        *count = true;
    }
    cursor.expect_punct('=')?;
    if cursor.is_word("file") {
        return Err(Mistake::new(cursor.here(), say::file_of_table(&name.text)));
    }
    assigned(cursor).map(Some)
}

/// `= right ;`
fn assignment(cursor: &mut Cursor) -> Parsed<super::tree::Expr> {
    cursor.expect_punct('=')?;
    assigned(cursor)
}

/// `right ;`
fn assigned(cursor: &mut Cursor) -> Parsed<super::tree::Expr> {
    let value = expr::right_side(cursor)?;
    cursor.expect_end()?;
    Ok(value)
}

fn content(cursor: &mut Cursor, keyword: Keyword, errors: &mut Errors) -> Parsed<ItemKind> {
    let area = Area::from(cursor.before());
    Ok(match keyword {
        Keyword::Param => unreachable!("parameters are read by `param`"),
        Keyword::Const => ItemKind::Const(assignment(cursor)?),
        Keyword::Let => ItemKind::Let(assignment(cursor)?),
        Keyword::Output => {
            let unit = cursor.eat_punct(':').then(|| unit::before_equals(cursor)).transpose()?;
            ItemKind::Output {
                unit,
                value: output(cursor)?,
            }
        }
        Keyword::Element => element::element(cursor, errors)?,
        Keyword::Motion => {
            time_argument(cursor)?;
            ItemKind::Motion(assignment(cursor)?)
        }
        Keyword::Table if cursor.is_punct('=') => table::file_table(cursor, false)?,
        Keyword::Table => ItemKind::Table(table::columns(cursor, area, errors)?),
        Keyword::Material => ItemKind::Material(fields(cursor, area, errors)?),
        Keyword::Section if cursor.is_punct('=') && !cursor.is_second_group(Delimiter::Brace) => {
            ItemKind::NamedSection(assigned_call(cursor, "`circle(..)`, `tube(..)` or `rectangle(..)`")?)
        }
        Keyword::Section if cursor.group(Delimiter::Brace).is_none() && !cursor.is_punct('=') => {
            return Err(cursor.expected("`{` and fields, or `=` and a shape such as `circle(radius = 5 mm)`"));
        }
        Keyword::Section => ItemKind::Section(fields(cursor, area, errors)?),
        Keyword::Joint => ItemKind::Joint(assigned_call(cursor, "`clamp(..)`, `clamp_full(..)` or `pin(..)`")?),
        Keyword::Constraint => ItemKind::Constraint(assignment(cursor)?),
        Keyword::Spring => ItemKind::Spring(assigned_call(cursor, "a spring such as `linear(..)`")?),
        Keyword::Load => ItemKind::Load(assigned_call(cursor, "`gravity(..)`, `force(..)` or `moment(..)`")?),
        Keyword::State => ItemKind::State(assigned_call(
            cursor,
            "what it is the integral of, `integral(rate, start = ..)`",
        )?),
        Keyword::Start => ItemKind::Start(assigned_call(cursor, "`spinning(..)`")?),
        Keyword::Part => ItemKind::Part(assigned_call(cursor, "a component, `part left = Blade(..);`")?),
        Keyword::Caution => ItemKind::Caution(Box::new(caution(cursor)?)),
        Keyword::Frame => {
            let parent = in_frame(cursor)?;
            ItemKind::Frame {
                parent,
                call: assigned_call(cursor, "a motion such as `rotating(..)` or `free(..)`")?,
            }
        }
        Keyword::Rigid => ItemKind::Rigid {
            parent: in_frame(cursor)?,
            fields: fields(cursor, area, errors)?,
        },
        Keyword::Fixture => {
            if !cursor.eat_word("on") {
                return Err(cursor.expected("`on` and a place, `fixture tip on beam.end { mass = 1 kg; }`"));
            }
            let place = expr::expression(cursor)?;
            let fields = fields(cursor, area, errors)?;
            ItemKind::Fixture { place, fields }
        }
        Keyword::Body => {
            let frame = in_frame(cursor)?;
            let Some(group) = cursor.eat_group(Delimiter::Brace) else {
                return Err(cursor.expected("`{` and the statements of the body, or `in` and the name of its frame"));
            };
            let before = errors.len();
            let statements = statements(&mut Cursor::of(&group), errors);
            ItemKind::Body {
                frame,
                statements,
                complete: errors.len() == before,
            }
        }
    })
}

/// `= right ;` of an output, behind which no unit stands.
fn output(cursor: &mut Cursor) -> Parsed<super::tree::Expr> {
    cursor.expect_punct('=')?;
    let value = expr::right_side(cursor)?;
    let mark = cursor.mark();
    let is_in = cursor.eat_word("in");
    let unit = cursor.word().map(ToString::to_string);
    match unit {
        Some(unit) if units::find(&unit).is_some() => {
            return Err(Mistake::new(cursor.here(), say::unit_of_output(&unit)));
        }
        Some(frame) if is_in => return Err(Mistake::new(cursor.here(), say::seen_in(&frame))),
        _ => {}
    }
    cursor.reset(mark);
    cursor.expect_end()?;
    Ok(value)
}

/// `= "text" [on outputs] if left < right;`
fn caution(cursor: &mut Cursor) -> Parsed<Caution> {
    cursor.expect_punct('=')?;
    let text = match cursor.peek() {
        Some(TokenTree::Literal(literal)) => syn::parse_str::<syn::LitStr>(&literal.to_string()).ok(),
        _ => None,
    };
    let Some(text) = text.map(|text| text.value()).filter(|text| !text.trim().is_empty()) else {
        return Err(cursor.expected("a sentence in quotes"));
    };
    cursor.next();
    let mut outputs = Vec::new();
    if cursor.eat_word("on") {
        outputs.push(expr::reference(cursor, "the name of an output")?);
        while cursor.eat_punct(',') {
            outputs.push(expr::reference(cursor, "the name of an output")?);
        }
    }
    cursor.expect_word("if")?;
    let left = expr::expression(cursor)?;
    let comparison = expr::comparison(cursor)?;
    let right = expr::right_side(cursor)?;
    cursor.expect_end()?;
    Ok(Caution {
        text,
        outputs,
        comparison,
        left,
        right,
    })
}

fn time_argument(cursor: &mut Cursor) -> Parsed<()> {
    let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
        return Err(cursor.expected("`(t)` after the name of the motion"));
    };
    let mut inner = Cursor::of(&group);
    if inner.eat_word("t") && inner.is_empty() {
        return Ok(());
    }
    Err(Mistake::new(group.span(), say::MOTION_ARGUMENT))
}

fn in_frame(cursor: &mut Cursor) -> Parsed<Option<Name>> {
    if cursor.eat_word("in") {
        expr::reference(cursor, "the name of a frame").map(Some)
    } else {
        Ok(None)
    }
}

fn assigned_call(cursor: &mut Cursor, what: &str) -> Parsed<super::tree::Call> {
    if !cursor.eat_punct('=') {
        return Err(cursor.expected(&format!("`=` and {what}")));
    }
    let name = cursor.expect_name(what)?;
    let call = expr::call(cursor, name, 0)?;
    cursor.expect_end()?;
    Ok(call)
}

/// `{ name = value; .. }`
fn fields(cursor: &mut Cursor, area: Area, errors: &mut Errors) -> Parsed<Fields> {
    fields_of(cursor, area, errors, "`{` and fields", field)
}

/// What stands in braces, each read by `field`.
pub(super) fn fields_of(
    cursor: &mut Cursor,
    area: Area,
    errors: &mut Errors,
    expected: &str,
    field: fn(&mut Cursor) -> Parsed<Field>,
) -> Parsed<Fields> {
    if cursor.is_punct('=') && cursor.is_second_group(Delimiter::Brace) {
        return Err(Mistake::new(cursor.here(), say::FIELDS_WITHOUT_EQUALS));
    }
    let Some(group) = cursor.eat_group(Delimiter::Brace) else {
        return Err(cursor.expected(expected));
    };
    let mut inner = Cursor::of(&group);
    let (mut fields, mut complete) = (Vec::new(), true);
    while !inner.is_empty() {
        documentation(&mut inner, errors);
        if inner.is_empty() {
            break;
        }
        match field(&mut inner) {
            Ok(field) => fields.push(field),
            Err(mistake) => {
                complete = false;
                errors.push(mistake);
                recover_field(&mut inner);
            }
        }
    }
    Ok(Fields { area, fields, complete })
}

/// `name = value;`, or `plane xy;` as the statements of a body have it.
fn field(cursor: &mut Cursor) -> Parsed<Field> {
    let is_plane = cursor.is_word("plane") && cursor.is_two_words();
    let name = cursor.expect_name("the name of a field")?;
    let value = if is_plane {
        let value = expr::expression(cursor)?;
        cursor.expect_end()?;
        value
    } else if name.text == "inertia" {
        cursor.expect_punct('=')?;
        let value = expr::inertia(cursor)?;
        cursor.expect_end()?;
        value
    } else {
        assignment(cursor)?
    };
    Ok(Field { name, value })
}

fn run(cursor: &mut Cursor, tree: &mut Tree, errors: &mut Errors) {
    cursor.next();
    match fields(cursor, cursor.before().into(), errors) {
        Ok(fields) => tree.runs.push(fields),
        Err(mistake) => {
            errors.push(mistake);
            recover(cursor);
        }
    }
}

fn recover_field(cursor: &mut Cursor) {
    recover_before(cursor, |cursor| cursor.word().is_some() && cursor.is_second_punct('='));
}
