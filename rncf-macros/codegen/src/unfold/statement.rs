//! Statements of bodies and elements with the names of their scope.

use super::{Place, Unfold};
use crate::parse::tree::{Call, ElementKind, ElementStatement, Expr, Statement};

impl<'t> Unfold<'t, '_> {
    pub(super) fn statement(&mut self, at: &Place, statement: &'t Statement) -> Statement {
        let mut boxed = |expr: &'t Expr| Box::new(self.expr(at, expr));
        match statement {
            Statement::Space { .. }
            | Statement::FrameTie { .. }
            | Statement::Import { .. }
            | Statement::Interface { .. }
            | Statement::InterfaceModes { .. }
            | Statement::Piece { .. } => statement.clone(),
            Statement::Damping { area, value } => Statement::Damping {
                area: *area,
                value: self.expr(at, value),
            },
            Statement::Line {
                area,
                from,
                corners,
                to,
            } => Statement::Line {
                area: *area,
                from: self.expr(at, from),
                corners: corners.iter().map(|corner| self.expr(at, corner)).collect(),
                to: self.expr(at, to),
            },
            Statement::Arc {
                area,
                from,
                direction,
                normal,
                radius,
                angle,
            } => Statement::Arc {
                area: *area,
                direction: boxed(direction),
                normal: normal.as_ref().map(|normal| boxed(normal)),
                radius: boxed(radius),
                angle: boxed(angle),
                from: self.expr(at, from),
            },
            Statement::Curve {
                area,
                table,
                directions,
            } => Statement::Curve {
                area: *area,
                table: self.name(at, table),
                directions: Box::new(directions.each_ref().map(|expr| Some(self.expr(at, expr.as_ref()?)))),
            },
            Statement::Path {
                area,
                position,
                parameter,
                range,
            } => Statement::Path {
                area: *area,
                position: self.expr(at, position),
                parameter: parameter.clone(),
                range: Box::new(range.each_ref().map(|expr| self.expr(at, expr))),
            },
            Statement::SectionY { area, value } => Statement::SectionY {
                area: *area,
                value: self.expr(at, value),
            },
            Statement::Twist { area, value } => Statement::Twist {
                area: *area,
                value: self.expr(at, value),
            },
            Statement::Fidelity { word, count } => Statement::Fidelity {
                word: word.clone(),
                count: count.as_ref().map(|count| self.expr(at, count)),
            },
            Statement::Initial { word, area, value } => Statement::Initial {
                word: word.clone(),
                area: *area,
                value: self.expr(at, value),
            },
            Statement::Mesh {
                area,
                count,
                stations,
                element,
            } => Statement::Mesh {
                area: *area,
                count: self.expr(at, count),
                stations: stations.as_ref().map(|table| self.name(at, table)),
                element: Call {
                    name: self.element(at, &element.name),
                    ..self.call(at, element)
                },
            },
        }
    }

    /// A statement of an element: its formulas may read what stands around it.
    pub(super) fn of_element(&mut self, at: &Place, statement: &'t ElementStatement) -> ElementStatement {
        let kind = match &statement.kind {
            ElementKind::Coefficient { name, unit, value } => ElementKind::Coefficient {
                name: name.clone(),
                unit: unit.clone(),
                value: self.expr(at, value),
            },
            ElementKind::Definition {
                is_strain,
                name,
                when,
                value,
            } => ElementKind::Definition {
                is_strain: *is_strain,
                name: name.clone(),
                when: when.clone(),
                value: self.expr(at, value),
            },
            ElementKind::Energy {
                name,
                when,
                value,
                stress,
                points,
                nature,
            } => ElementKind::Energy {
                name: name.clone(),
                when: when.clone(),
                value: self.expr(at, value),
                stress: stress.as_ref().map(|stress| self.expr(at, stress)),
                points: points.clone(),
                nature: nature.clone(),
            },
            other => other.clone(),
        };
        ElementStatement {
            doc: statement.doc.clone(),
            word: statement.word.clone(),
            kind,
        }
    }
}

/// Names that an element gives to what is in it, and those of what it is made of.
pub(super) fn own_names(statements: &[ElementStatement]) -> Vec<&str> {
    let own = statements.iter().filter_map(|statement| match &statement.kind {
        ElementKind::Domain { coordinate: name }
        | ElementKind::Vector { name, .. }
        | ElementKind::Field { name, .. }
        | ElementKind::Coefficient { name, .. }
        | ElementKind::Definition { name, .. } => Some(name.text.as_str()),
        _ => None,
    });
    own.chain(["material", "section"]).collect()
}
