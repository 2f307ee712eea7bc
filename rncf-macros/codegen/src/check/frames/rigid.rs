//! Rigid bodies: free frames that carry ten numbers (THEORY 3.1, 5.3).

use std::collections::HashMap;

use super::plane::PLANES;
use crate::check::values::eigen;
use crate::check::values::quantity::Wanted;
use crate::check::values::scope::Scope;
use crate::check::{Check, say};
use crate::errors::Area;
use crate::model::{Expr as Value, Frame, FrameId, INERTIAL, Motions, RigidPart};
use crate::parse::tree::{Expr, ExprKind, Fields, Item, ItemKind};
use crate::suggest;

/// What is given by name: where the name stands, and the value.
pub type Given<'a> = HashMap<&'a str, (Area, &'a Expr)>;

/// Fields of `rigid`.
const FIELDS: &[&str] = &[
    "mass",
    "inertia",
    "center",
    "plane",
    "origin",
    "axis",
    "angle",
    "velocity",
    "angular_velocity",
    "speed",
];
const MASS: Wanted = Wanted {
    what: "the mass",
    dimension: [0, 1, 0, 0, 0, 0],
    unit: "kg",
};
const CENTER: Wanted = Wanted {
    what: "the centre of mass",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const INERTIA: Wanted = Wanted {
    what: "the inertia",
    dimension: [2, 1, 0, 0, 0, 0],
    unit: "kg*m^2",
};

impl<'a> Check<'a> {
    /// The frame of a rigid body; resolved at its first use.
    pub(in crate::check) fn rigid_item(&mut self, item: &'a Item, used: Area) -> Option<FrameId> {
        let name = item.name.text.as_str();
        if let Some(known) = self.frames.get(name) {
            return *known;
        }
        let ItemKind::Rigid { parent, fields } = &item.kind else {
            return None;
        };
        if !self.enter(name, used) {
            return None;
        }
        let id = parent.as_ref().map_or(Some(INERTIAL), |parent| self.frame(parent));
        let before = self.errors.len();
        let given = self.fields(fields, "`rigid`", FIELDS);
        let is_whole = fields.complete && self.errors.len() == before;
        let part = self.own_part(item, fields, &given);
        let motions = self.rigid_motions(name, &given, is_whole);
        let moves = motions.and_then(|motions| self.free_moves(motions, &given));
        self.leave();
        let id = self
            .carrier(name, parent.as_ref(), id, moves.as_ref())
            .and_then(|parent| {
                let (mut moves, part) = (moves?, part?);
                moves.free.is_body = true;
                moves.free.parts = vec![part];
                let id = FrameId(self.model.frames.len());
                let (name, doc) = (name.to_string(), item.doc.clone());
                self.model.frames.push(Frame {
                    name,
                    doc,
                    ..moves.frame(parent)
                });
                Some(id)
            });
        self.frames.insert(name, id);
        id
    }

    /// Fields by their names; unknown ones and repetitions are reported.
    pub(in crate::check) fn fields(&mut self, fields: &'a Fields, kind: &str, known: &[&str]) -> Given<'a> {
        let mut given = Given::new();
        for field in &fields.fields {
            let word = field.name.text.as_str();
            if !known.contains(&word) {
                let message = suggest::unknown(&format!("field of {kind}"), word, known.iter().copied());
                self.errors.at(field.name.span, message);
            } else if given.contains_key(word) {
                self.errors.at(field.name.span, say::twice(word));
            } else {
                given.insert(word, (field.name.span.into(), &field.value));
            }
        }
        given
    }

    /// What a rigid body can do: without inertia and centre it is a point mass.
    fn rigid_motions(&mut self, name: &str, given: &Given<'a>, is_whole: bool) -> Option<Motions> {
        let plane = match given.get("plane") {
            Some((_, plane)) => Some(self.plane_word(plane)?),
            None => None,
        };
        if given.contains_key("inertia") || given.contains_key("center") {
            return Some(plane.map_or(Motions::Spatial, |normal| Motions::Planar { normal }));
        }
        // What could not be read may be the inertia.
        if !is_whole {
            return None;
        }
        for word in ["axis", "angle", "angular_velocity", "speed"] {
            if let Some((area, _)) = given.get(word) {
                self.errors.at(*area, say::point_mass(name, word));
                return None;
            }
        }
        Some(plane.map_or(Motions::Shifting, |normal| Motions::ShiftingPlanar { normal }))
    }

    fn own_part(&mut self, item: &Item, fields: &Fields, given: &Given<'a>) -> Option<RigidPart> {
        let name = item.name.text.clone();
        let mass = self.mass(item, fields, given, "mass = 2 kg;");
        // An unreadable plane has its own message.
        let normal = match given.get("plane") {
            Some((_, plane)) => Some(plane_of(plane)?),
            None => None,
        };
        let center = match given.get("center") {
            Some((_, center)) => self.flat_vector(center, CENTER, normal).map(|vector| vector.values),
            None => Some(zeros()),
        };
        let inertia = match given.get("inertia") {
            Some((_, inertia)) => self.inertia(item, inertia, normal, true),
            None => Some(zeros()),
        };
        Some(RigidPart {
            name,
            mass: mass?,
            center: center?,
            inertia: inertia?,
        })
    }

    /// The mass of a rigid body or fixture, greater than zero.
    pub(in crate::check) fn mass(
        &mut self,
        item: &Item,
        fields: &Fields,
        given: &Given<'a>,
        example: &str,
    ) -> Option<Value> {
        let Some((_, mass)) = given.get("mass") else {
            // A misspelt field may be the mass.
            if fields.complete && given.len() == fields.fields.len() {
                let (kind, name) = (item.keyword.noun(), &item.name.text);
                self.errors
                    .at(item.name.span, say::lacks_field(kind, name, "mass", example));
            }
            return None;
        };
        let value = self.quantity(mass, Scope::Parameter, MASS)?;
        let what = format!("the mass of `{}`", item.name.text);
        self.is_positive(&value, mass, &what).then_some(value)
    }

    /// Whether a value is greater than zero with the defaults of the parameters.
    fn is_positive(&mut self, value: &Value, expr: &Expr, what: &str) -> bool {
        let is_positive = self.default(value) > 0.0;
        if !is_positive {
            self.errors.at(expr.area, say::positive(what));
        }
        is_positive
    }

    /// The inertia of an item about its centre of mass: one number in a plane, else three or six. `is_definite`:
    /// none of its principal moments may be zero.
    pub(in crate::check) fn inertia(
        &mut self,
        item: &Item,
        expr: &'a Expr,
        normal: Option<usize>,
        is_definite: bool,
    ) -> Option<[Value; 6]> {
        let mut inertia = zeros::<6>();
        match normal {
            Some(_) if expr.has_vector() => {
                self.errors.at(expr.area, say::PLANAR_INERTIA);
                return None;
            }
            Some(normal) => {
                let value = self.quantity(expr, Scope::Parameter, INERTIA)?;
                let number = self.default(&value);
                if !(number > 0.0 || number == 0.0 && !is_definite) {
                    let what = format!("the inertia of `{}`", item.name.text);
                    let message = if is_definite {
                        say::positive(&what)
                    } else {
                        say::not_negative(&what)
                    };
                    self.errors.at(expr.area, message);
                    return None;
                }
                inertia[normal] = value;
            }
            None if expr.has_vector() => {
                let (values, _) = self.components(expr, Scope::Parameter, INERTIA)?;
                for (to, value) in inertia.iter_mut().zip(values) {
                    *to = value;
                }
                let numbers = inertia.each_ref().map(|value| self.default(value));
                if let Some(message) = impossible(numbers, is_definite) {
                    self.errors.at(expr.area, message);
                    return None;
                }
            }
            None => {
                self.errors.at(expr.area, say::SPATIAL_INERTIA);
                return None;
            }
        }
        Some(inertia)
    }
}

/// Zeros.
pub fn zeros<const N: usize>() -> [Value; N] {
    std::array::from_fn(|_| Value::Number(0.0))
}

fn plane_of(expr: &Expr) -> Option<usize> {
    match &expr.kind {
        ExprKind::Name(name) => PLANES.iter().position(|plane| *plane == name.text),
        _ => None,
    }
}

/// Relative size of what counts as round-off in principal moments.
const SMALL: f64 = 1e-12;

/// Why no body has these moments xx, yy, zz, xy, xz, yz, if none has.
fn impossible([xx, yy, zz, xy, xz, yz]: [f64; 6], is_definite: bool) -> Option<&'static str> {
    let (mut moments, _) = eigen::symmetric([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]);
    moments.sort_by(f64::total_cmp);
    let [least, middle, most] = moments;
    let is_possible = if is_definite {
        least > SMALL * most
    } else {
        least >= -SMALL * most
    };
    if !is_possible {
        return Some(if is_definite {
            say::NOT_DEFINITE
        } else {
            say::NEGATIVE_INERTIA
        });
    }
    (most > (least + middle) * (1.0 + SMALL)).then_some(say::TRIANGLE)
}
