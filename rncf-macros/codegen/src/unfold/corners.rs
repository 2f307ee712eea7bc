//! Bodies whose axis has corners: each straight piece becomes a body, `frame[0]`, `frame[1]`, .., and each corner a rigid joint.

use super::messages as say;
use super::names::Reached;
use super::{Place, Planned, Unfold};
use crate::errors::Area;
use crate::model::Binary;
use crate::parse::tree::{Argument, Call, Expr, ExprKind, Item, ItemKind, Keyword, Name, Statement};

/// Quantities of a body that are the sums of those of its pieces.
const SUMS: [&str; 6] = [
    "mass",
    "momentum",
    "angular_momentum",
    "kinetic_energy",
    "strain_energy",
    "gravity_energy",
];

impl<'t> Unfold<'t, '_> {
    /// Remembers a body with corners, and the names of its pieces.
    pub(super) fn note_corners(&mut self, item: &Item, name: &str) {
        let ItemKind::Body { statements, .. } = &item.kind else {
            return;
        };
        let Some(corners) = corners(statements) else {
            return;
        };
        let pieces = corners.len() + 1;
        self.existing.extend((0..pieces).map(|number| piece(name, number)));
        self.cornered.insert(name.to_string(), pieces);
        self.is_copied = true;
    }

    /// Writes an item, or what it becomes for the pieces of a body with corners.
    pub(super) fn item_or_pieces(&mut self, planned: &Planned<'t>, out: &mut Vec<Item>) {
        let is_cornered = self.cornered.contains_key(&planned.name);
        if is_cornered && planned.item.keyword == Keyword::Body {
            let mut item = self.item(planned);
            if planned.repeat.is_some() {
                self.errors.at(planned.item.name.span, say::CORNERS_IN_KEPT);
                item.kind = ItemKind::Broken;
            }
            return self.pieces(item, out);
        }
        let Some(count) = self.pieces_under(planned) else {
            let item = self.item(planned);
            return out.push(item);
        };
        for number in 0..count {
            self.piece = Some(number);
            let mut item = self.item(planned);
            item.name.text = piece(&item.name.text, number);
            out.push(item);
        }
        self.piece = None;
    }

    /// How many pieces the body has on which a load per length acts, if it has corners.
    fn pieces_under(&mut self, planned: &Planned<'t>) -> Option<usize> {
        let ItemKind::Load(call) = &planned.item.kind else {
            return None;
        };
        let first = &call.arguments.first()?.value;
        if !matches!(first.kind, ExprKind::Name(_) | ExprKind::Indexed { .. }) || self.cornered.is_empty() {
            return None;
        }
        match self.reach(&planned.at, first)? {
            Reached::Item(name) => self.cornered.get(&name.text).copied(),
            _ => None,
        }
    }

    /// The bodies and rigid joints that a body with corners becomes.
    fn pieces(&mut self, item: Item, out: &mut Vec<Item>) {
        let ItemKind::Body {
            frame,
            statements,
            complete,
        } = &item.kind
        else {
            return out.push(item);
        };
        self.refuse_with_corners(statements);
        let Some((area, points)) = points(statements) else {
            return out.push(item);
        };
        for number in 0..points.len() - 1 {
            let of_piece = |statement: &Statement| match statement {
                Statement::Line { area, .. } => Statement::Line {
                    area: *area,
                    from: points[number].clone(),
                    corners: Vec::new(),
                    to: points[number + 1].clone(),
                },
                other => other.clone(),
            };
            // The frame follows one thing: the first piece.
            let of_it = |statement: &&Statement| number == 0 || !matches!(statement, Statement::FrameTie { .. });
            let own = Statement::Piece {
                points: points.clone(),
                number,
            };
            let name = Name::new(piece(&item.name.text, number), item.name.span);
            out.push(Item {
                name,
                kind: ItemKind::Body {
                    frame: frame.clone(),
                    statements: statements.iter().filter(of_it).map(of_piece).chain([own]).collect(),
                    complete: *complete,
                },
                ..item.clone()
            });
        }
        for corner in 1..points.len() - 1 {
            let at = points[corner].area;
            let end = |number: usize, word: &str| Argument {
                name: None,
                value: Expr {
                    kind: end_of(&item.name, number, word, at),
                    area: at,
                    height: 2,
                },
            };
            let (span, text) = (at.start, format!("{}.corner[{corner}]", item.name.text));
            out.push(Item {
                doc: String::new(),
                keyword: Keyword::Joint,
                name: Name::new(text, span),
                kind: ItemKind::Corner(Call {
                    name: Name::new("weld", area.start),
                    arguments: vec![end(corner - 1, "end"), end(corner, "start")],
                    area: at,
                }),
                ..item.clone()
            });
        }
    }

    /// Refuses statements that are about a body without corners.
    fn refuse_with_corners(&mut self, statements: &[Statement]) {
        for statement in statements {
            let (area, word) = match statement {
                Statement::Fidelity { word, .. } => (Area::from(word.span), word.text.as_str()),
                Statement::Initial { area, .. } => (*area, "initial"),
                Statement::Mesh {
                    stations: Some(table), ..
                } => (table.span.into(), "at"),
                _ => continue,
            };
            self.errors.at(area, say::cornered_without(word));
        }
    }

    /// What the name of a body with corners becomes where no piece of it is named.
    pub(super) fn all_pieces(&mut self, name: &Name, area: Area) -> ExprKind {
        match self.piece {
            Some(number) => ExprKind::Name(Name::new(piece(&name.text, number), name.span)),
            None => {
                self.errors.at(area, say::cornered_whole(&name.text));
                ExprKind::Name(name.clone())
            }
        }
    }

    /// `frame[1]`
    pub(super) fn one_piece(&mut self, at: &Place, name: &Name, index: &'t Expr) -> Reached<'t> {
        let Some(value) = self.value(at, index, 0) else {
            self.errors.at(index.area, say::piece_unknown(&name.text));
            return Reached::Nothing;
        };
        let written = format!("{}[{value}]", name.text);
        if self.existing.contains(&written) {
            return Reached::Item(Name::new(written, name.span));
        }
        let message = if value.trunc() == value {
            self.out_of_range(at, index, value, &written)
        } else {
            say::whole_number(&name.text)
        };
        self.errors.at(index.area, message);
        Reached::Nothing
    }

    /// `frame.start`, `frame.mass`: what stands behind the dot of a body with corners; `None` of anything else.
    pub(super) fn of_cornered(
        &mut self,
        at: &Place,
        base: &'t Expr,
        field: &Name,
        arguments: Option<&'t [Argument]>,
        area: Area,
    ) -> Option<ExprKind> {
        if self.cornered.is_empty() {
            return None;
        }
        let Some(Reached::Item(name)) = self.reach(at, base) else {
            return None;
        };
        let count = *self.cornered.get(&name.text)?;
        let word = field.text.as_str();
        let message = match (word, arguments) {
            ("start", None) => return Some(end_of(&name, 0, word, area)),
            ("end", None) => return Some(end_of(&name, count - 1, word, area)),
            ("start" | "end" | "at", _) => say::cornered_place(&name.text),
            _ if SUMS.contains(&word) => {
                let arguments = arguments.map(|arguments| self.arguments(at, arguments));
                let term = |number: usize| {
                    let base = ExprKind::Name(Name::new(piece(&name.text, number), name.span));
                    Expr {
                        kind: ExprKind::Member {
                            base: Box::new(Expr {
                                kind: base,
                                area,
                                height: 1,
                            }),
                            field: field.clone(),
                            arguments: arguments.clone(),
                        },
                        area,
                        height: 2,
                    }
                };
                let sum = (1..count).fold(term(0), |sum, number| Expr {
                    height: sum.height + 1,
                    kind: ExprKind::Binary(Binary::Add, Box::new(sum), Box::new(term(number))),
                    area,
                });
                return Some(sum.kind);
            }
            _ => say::cornered_quantity(&name.text, word),
        };
        self.errors.at(area, message);
        Some(end_of(&name, 0, "start", area))
    }
}

fn corners(statements: &[Statement]) -> Option<&[Expr]> {
    statements.iter().find_map(|statement| match statement {
        Statement::Line { corners, .. } if !corners.is_empty() => Some(corners.as_slice()),
        _ => None,
    })
}

/// The word `line`; start, corners and end.
fn points(statements: &[Statement]) -> Option<(Area, Vec<Expr>)> {
    statements.iter().find_map(|statement| match statement {
        Statement::Line {
            area,
            from,
            corners,
            to,
        } => {
            let all = std::iter::once(from).chain(corners).chain([to]);
            Some((*area, all.cloned().collect()))
        }
        _ => None,
    })
}

/// Name of a piece.
fn piece(name: &str, number: usize) -> String {
    format!("{name}[{number}]")
}

/// `frame[1].end`
fn end_of(name: &Name, number: usize, word: &str, area: Area) -> ExprKind {
    let base = ExprKind::Name(Name::new(piece(&name.text, number), name.span));
    ExprKind::Member {
        base: Box::new(Expr {
            kind: base,
            area,
            height: 1,
        }),
        field: Name::new(word, name.span),
        arguments: None,
    }
}
