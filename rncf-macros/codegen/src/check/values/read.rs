//! Names that an item mentions, as they are written.

use crate::parse::tree::{Argument, ElementKind, Expr, ExprKind, Fields, Item, ItemKind, Statement, Tree};

/// Names that an item mentions; that of the number of repetitions belongs to every item of a loop. Names with a
/// meaning of their own (`t`, `x` of an initial shape, functions, units apart) are among them.
pub fn mentioned<'a>(tree: &'a Tree, item: &'a Item) -> Vec<&'a str> {
    let mut found = Vec::new();
    let count = item.repeat.and_then(|at| tree.loops.get(at)?.count.as_ref());
    count.into_iter().for_each(|count| names(count, &mut found));
    let found = &mut found;
    match &item.kind {
        ItemKind::Param { value, .. } => value.iter().for_each(|value| names(value, found)),
        ItemKind::Const(value) | ItemKind::Let(value) | ItemKind::Motion(value) | ItemKind::Constraint(value) => {
            names(value, found)
        }
        ItemKind::Output { value, .. } => names(value, found),
        ItemKind::Material(fields) | ItemKind::Section(fields) | ItemKind::Table(fields) => of_fields(fields, found),
        ItemKind::NamedSection(call)
        | ItemKind::Joint(call)
        | ItemKind::Corner(call)
        | ItemKind::Spring(call)
        | ItemKind::State(call)
        | ItemKind::Load(call)
        | ItemKind::Start(call) => of_arguments(&call.arguments, found),
        ItemKind::Frame { parent, call } => {
            found.extend(parent.as_ref().map(|parent| parent.text.as_str()));
            of_arguments(&call.arguments, found);
        }
        ItemKind::Body { frame, statements, .. } => {
            found.extend(frame.as_ref().map(|frame| frame.text.as_str()));
            statements.iter().for_each(|statement| of_statement(statement, found));
        }
        ItemKind::Rigid { parent, fields } => {
            found.extend(parent.as_ref().map(|parent| parent.text.as_str()));
            of_fields(fields, found);
        }
        ItemKind::Fixture { place, fields } => {
            names(place, found);
            of_fields(fields, found);
        }
        ItemKind::Caution(caution) => {
            names(&caution.left, found);
            names(&caution.right, found);
        }
        ItemKind::Element { statements, .. } => statements.iter().for_each(|one| of_element(&one.kind, found)),
        ItemKind::FileTable { .. } | ItemKind::Part(_) | ItemKind::Broken => {}
    }
    std::mem::take(found)
}

fn of_fields<'a>(fields: &'a Fields, found: &mut Vec<&'a str>) {
    fields.fields.iter().for_each(|field| names(&field.value, found));
}

fn of_arguments<'a>(arguments: &'a [Argument], found: &mut Vec<&'a str>) {
    arguments.iter().for_each(|argument| names(&argument.value, found));
}

fn of_element<'a>(kind: &'a ElementKind, found: &mut Vec<&'a str>) {
    match kind {
        ElementKind::Coefficient { value, .. } | ElementKind::Definition { value, .. } => names(value, found),
        ElementKind::Energy { value, stress, .. } => [Some(value), stress.as_ref()]
            .into_iter()
            .flatten()
            .for_each(|value| names(value, found)),
        _ => {}
    }
}

fn of_statement<'a>(statement: &'a Statement, found: &mut Vec<&'a str>) {
    match statement {
        Statement::Space { .. }
        | Statement::FrameTie { .. }
        | Statement::Import { .. }
        | Statement::Interface { .. }
        | Statement::InterfaceModes { .. } => {}
        Statement::Piece { points, .. } => points.iter().for_each(|expr| names(expr, found)),
        Statement::Curve { table, directions, .. } => {
            found.push(&table.text);
            directions.iter().flatten().for_each(|expr| names(expr, found));
        }
        Statement::Path { position, range, .. } => {
            std::iter::once(position)
                .chain(range.iter())
                .for_each(|expr| names(expr, found));
        }
        Statement::Line { from, to, .. } => [from, to].into_iter().for_each(|expr| names(expr, found)),
        Statement::Arc {
            from,
            direction,
            normal,
            radius,
            angle,
            ..
        } => {
            names(from, found);
            let others = [direction, radius, angle].into_iter().chain(normal);
            others.for_each(|expr| names(expr, found));
        }
        Statement::SectionY { value, .. }
        | Statement::Twist { value, .. }
        | Statement::Initial { value, .. }
        | Statement::Damping { value, .. } => {
            names(value, found);
        }
        Statement::Fidelity { count, .. } => count.iter().for_each(|count| names(count, found)),
        Statement::Mesh {
            count,
            stations,
            element,
            ..
        } => {
            names(count, found);
            found.push(&element.name.text);
            found.extend(stations.as_ref().map(|table| table.text.as_str()));
            of_arguments(&element.arguments, found);
        }
    }
}

/// Names in an expression, those of functions and motions that are called included.
pub fn names<'a>(expr: &'a Expr, found: &mut Vec<&'a str>) {
    match &expr.kind {
        ExprKind::Name(name) | ExprKind::Indexed { base: name, .. } => found.push(&name.text),
        ExprKind::Call(call) => found.push(&call.name.text),
        _ => {}
    }
    expr.parts().into_iter().for_each(|part| names(part, found));
}
