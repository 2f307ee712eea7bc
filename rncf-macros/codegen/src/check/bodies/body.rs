//! Bodies: what their statements make of them.

use crate::check::frames::plane::{PLANES, normal};
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::joints::algebra::{divide, multiply};
use crate::model::{Body, BodyId, Expr as Value, Fidelity, FrameId, FrameTie, INERTIAL, RepeatId, Space};
use crate::parse::tree::{Expr, ExprKind, Item, ItemKind, Keyword, Statement};
use crate::suggest;

/// What other items need to know of a body; `None`: reported.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    pub id: BodyId,
    /// The loop that it stands in.
    pub repeat: Option<RepeatId>,
    pub space: Option<Space>,
    pub frame: Option<FrameId>,
    /// Length of the axis where it is constant, m.
    pub length: Option<f64>,
    /// Direction of the axis where it is straight and the same for all params.
    pub tangent: Option<[f64; 3]>,
}

impl<'a> Check<'a> {
    /// The body that stands before a dot, `main[a]` or `beam`, and the number of the repetition.
    pub(in crate::check) fn named_body(&mut self, expr: &'a Expr) -> Option<(Known, Option<Value>)> {
        match &expr.kind {
            ExprKind::Name(name) => {
                let item = self.item(name, Keyword::Body)?;
                let body = *self.bodies.get(item.name.text.as_str())?;
                if body.repeat.is_some() {
                    let message = self.say_repeated(name);
                    self.errors.at(name.span, message);
                    return None;
                }
                Some((body, None))
            }
            ExprKind::Indexed { base, index } => {
                let item = self.item(base, Keyword::Body)?;
                let body = *self.bodies.get(item.name.text.as_str())?;
                let Some(repeat) = body.repeat else {
                    self.errors.at(index.area, say::not_repeated(&base.text));
                    return None;
                };
                let number = self.repetition(base, index, repeat)?;
                Some((body, Some(number)))
            }
            _ => {
                self.errors.at(expr.area, say::PLACE_EXPECTED);
                None
            }
        }
    }

    pub(in crate::check) fn bodies(&mut self) {
        for (at, item) in self.items(Keyword::Body).into_iter().enumerate() {
            self.in_loop(item, |check| check.body(BodyId(at), item));
        }
    }

    fn body(&mut self, id: BodyId, item: &'a Item) {
        let mut known = Known {
            id,
            repeat: item.repeat.map(RepeatId),
            space: None,
            frame: None,
            length: None,
            tangent: None,
        };
        let ItemKind::Body {
            frame,
            statements,
            complete,
        } = &item.kind
        else {
            self.bodies.insert(item.name.text.as_str(), known);
            return;
        };
        known.frame = frame.as_ref().map_or(Some(INERTIAL), |frame| self.frame(frame));
        known.space = match is_imported(statements) {
            true => Some(Space::Spatial),
            false => self.space(item, statements, *complete),
        };
        if let Some(frame_id) = known.frame
            && self.has_axes(frame_id, frame.as_ref())
            && let Some(normal) = known.space.and_then(normal)
        {
            let area = frame.as_ref().map_or(item.name.span, |frame| frame.span);
            self.keeps_plane(frame_id, normal, area);
        }
        if is_imported(statements) {
            self.imported(item, statements, known);
            return;
        }
        let line = self.line(item, statements, *complete, &mut known);
        let piece = self.piece(statements);
        let mesh = self.mesh(item, statements, *complete, known.space);
        let mut axes = self.section_axes(statements, known.space, line.as_ref());
        if let (Some(axes), Some(piece)) = (&mut axes, &piece)
            && !fold::has_arclength(&axes.twist)
        {
            axes.twist = multiply(axes.twist.clone(), divide(Value::Arclength, piece.whole.clone()));
        }
        if let (Some(line), Some(mesh)) = (&line, &mesh) {
            let twist = axes.as_ref().map(|axes| &axes.twist);
            self.is_fine_enough(statements, line, twist, &mesh.count);
        }
        let (fidelity, tie) = if item.repeat.is_some() {
            self.may_be_repeated(statements);
            (Some(Fidelity::Full), FrameTie::Joints)
        } else {
            let tie = self.frame_tie(item, statements, known.frame, known.space);
            (self.fidelity(statements), tie)
        };
        if let (Some(mesh), Some(space)) = (&mesh, known.space) {
            self.modes_of_timed(statements, mesh, space);
        }
        let initial = self.initial(item, statements, known.space);
        if tie != FrameTie::Joints {
            // In a prescribed frame that is a mistake of its own.
            self.note_held(id);
        }
        self.bodies.insert(item.name.text.as_str(), known);
        if let (Some(frame), Some(space), Some(line), Some(mesh), Some(axes), Some(fidelity), Some(initial)) =
            (known.frame, known.space, line, mesh, axes, fidelity, initial)
        {
            self.model.bodies.push(Body {
                repeat: known.repeat,
                name: item.name.text.clone(),
                doc: item.doc.clone(),
                frame,
                space,
                line,
                count: mesh.count,
                element: mesh.element,
                options: mesh.options,
                material_name: mesh.material_name,
                section_name: mesh.section_name,
                properties: mesh.stuff.properties,
                quadrature: mesh.quadrature,
                evaluation: mesh.evaluation,
                fidelity,
                tie,
                initial,
                strain_energy: mesh.stuff.energy,
                shape: mesh.stuff.shape,
                law: mesh.law,
                stations: mesh.stations,
                piece,
                section_y: axes.y,
                twist: axes.twist,
            });
        }
    }

    /// The one statement of a kind; more and none are reported.
    pub(in crate::check) fn single(
        &mut self,
        item: &Item,
        statements: &'a [Statement],
        complete: bool,
        word: &str,
        missing: &str,
        area_of: impl Fn(&Statement) -> Option<Area>,
    ) -> Option<&'a Statement> {
        let mut found = statements
            .iter()
            .filter_map(|statement| Some((statement, area_of(statement)?)));
        let Some((first, first_area)) = found.next() else {
            if complete {
                self.errors
                    .at(item.name.span, say::missing_statement(&item.name.text, missing));
            }
            return None;
        };
        for (_, area) in found {
            self.errors
                .at(area, say::duplicate_statement(word, &first_area.line().to_string()));
        }
        Some(first)
    }

    fn space(&mut self, item: &Item, statements: &'a [Statement], complete: bool) -> Option<Space> {
        let missing = "`planar xy;` (or `yz`, `zx`) or `spatial;`";
        let statement = self.single(
            item,
            statements,
            complete,
            "`planar` or `spatial`",
            missing,
            |statement| {
                if let Statement::Space { area, .. } = statement {
                    Some(*area)
                } else {
                    None
                }
            },
        )?;
        let Statement::Space { plane: Some(plane), .. } = statement else {
            return Some(Space::Spatial);
        };
        let normal = PLANES.iter().position(|name| *name == plane.text);
        if normal.is_none() {
            self.errors
                .at(plane.span, suggest::unknown("plane", &plane.text, ["xy", "yz", "zx"]));
        }
        normal.map(|normal| Space::Planar { normal })
    }
}

/// What a piece is called in words about the whole body, and which one it is; `None` of other bodies.
pub(in crate::check) fn piece(item: &Item) -> Option<(&str, usize)> {
    let ItemKind::Body { statements, .. } = &item.kind else {
        return None;
    };
    let number = statements.iter().find_map(|statement| match statement {
        Statement::Piece { number, .. } => Some(*number),
        _ => None,
    })?;
    let (whole, _) = item.name.text.rsplit_once('[')?;
    Some((whole, number))
}

/// Whether a body comes from a file.
pub(in crate::check) fn is_imported(statements: &[Statement]) -> bool {
    statements.iter().any(|statement| {
        matches!(
            statement,
            Statement::Import { .. } | Statement::Interface { .. } | Statement::InterfaceModes { .. }
        )
    })
}
