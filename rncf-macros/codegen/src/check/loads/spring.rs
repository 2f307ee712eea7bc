//! Springs and dampers, along lines and about joints.

use crate::check::observed::members::angular;
use crate::check::observed::shown::Shown;
use crate::check::values::quantity::{Typed, Wanted};
use crate::check::values::scope::Scope;
use crate::check::values::vector::Quantity;
use crate::check::{Check, Shape, fold, say};
use crate::joints::algebra::{self, Vector, add, both, divide, dot, multiply, norm, number, observed, subtract};
use crate::joints::{Angle, Builder};
use crate::model::{Expr as Value, Force, ForceKind, MarkerId};
use crate::parse::tree::{Call, Expr, ExprKind, Item, ItemKind, Keyword};
use crate::suggest;
use crate::units::Dimension;

pub(super) const STIFFNESS: Wanted = Wanted::new("the stiffness of a spring", [0, 1, -2, 0, 0, 0], "N/m");
pub(super) const DAMPING: Wanted = Wanted::new("the damping of a spring", [0, 1, -1, 0, 0, 0], "N*s/m");
pub(super) const LENGTH: Wanted = Wanted::new("the length of a spring", [1, 0, 0, 0, 0, 0], "m");
pub(super) const FORCE: Wanted = Wanted::new("the force of a law", [1, 1, -2, 0, 0, 0], "N");
pub(super) const TORSION: Wanted = Wanted::new("the stiffness of a torsional spring", [2, 1, -2, 0, 0, 0], "N*m/rad");
pub(super) const FRICTION: Wanted = Wanted::new("the damping of a torsional spring", [2, 1, -1, 0, 0, 0], "N*m*s/rad");
pub(super) const MOMENT: Wanted = Wanted::new("the moment of a law", [2, 1, -2, 0, 0, 0], "N*m");

/// Exponents of J.
const ENERGY: [i8; 6] = [2, 1, -2, 0, 0, 0];

const LINEAR: Shape = Shape {
    positional: 2,
    named: &["stiffness", "damping", "length"],
    required: &[],
    usage: "linear(arm, beam.end, stiffness = 100 [N/m], length = 1 m)",
};
const LAW: Shape = Shape {
    positional: 2,
    named: &["force"],
    required: &["force"],
    usage: "law(arm, beam.end, force = k * (length - L) + c * rate)",
};
const TORSIONAL: Shape = Shape {
    positional: 1,
    named: &["stiffness", "damping", "angle"],
    required: &[],
    usage: "torsional(hinge, stiffness = 3 [N*m/rad])",
};
const TORSIONAL_LAW: Shape = Shape {
    positional: 1,
    named: &["moment"],
    required: &["moment"],
    usage: "torsional_law(hinge, moment = k * angle + c * rate)",
};

/// What is said of a joint without an angle.
const TURNING_JOINTS: &str = ": a torsional spring needs a joint about one axis, such as a `revolute`";

/// What a spring does, and shows.
pub struct Acting {
    /// Forces on markers.
    pub forces: Vec<(MarkerId, Vector)>,
    /// Their potential where there is one.
    pub energy: Option<Value>,
    /// What can be observed of it, by names.
    pub shown: Shown,
}

/// The line between two points.
struct Line {
    points: [MarkerId; 2],
    apart: Vector,
    length: Value,
    rate: Value,
}

impl<'a> Check<'a> {
    pub(in crate::check) fn springs(&mut self) {
        for item in self.items(Keyword::Spring) {
            let before = self.errors.len();
            if let ItemKind::Spring(call) = &item.kind {
                let shown = self.spring(item, call);
                self.shown.insert(item.name.text.clone(), shown);
            }
            if self.errors.len() > before || Self::is_broken(item) {
                self.tied = None;
            }
        }
    }

    fn spring(&mut self, item: &Item, call: &'a Call) -> Option<Shown> {
        let acting = match call.name.text.as_str() {
            "linear" => self.linear(call)?,
            "law" => self.law(call)?,
            "torsional" => self.torsional(call)?,
            "torsional_law" => self.torsional_law(call)?,
            "coordinate" => self.coordinate_spring(call)?,
            "coordinate_law" => self.coordinate_law(call)?,
            "bushing" => self.bushing(call)?,
            other => {
                let known = [
                    "linear",
                    "law",
                    "torsional",
                    "torsional_law",
                    "coordinate",
                    "coordinate_law",
                    "bushing",
                ];
                self.errors.at(call.name.span, suggest::unknown("spring", other, known));
                return None;
            }
        };
        self.push_force(item, acting.forces, acting.energy);
        Some(acting.shown)
    }

    /// Adds a force; the bodies that it acts on are held by it.
    pub(in crate::check) fn push_force(&mut self, item: &Item, forces: Vec<(MarkerId, Vector)>, energy: Option<Value>) {
        let acting: Vec<MarkerId> = forces.iter().map(|(marker, _)| *marker).collect();
        if item.keyword == Keyword::Spring {
            self.note_all_held(&acting);
        }
        let (markers, components) = self.complete(forces);
        self.model.forces.push(Force {
            name: item.name.text.clone(),
            doc: item.doc.clone(),
            markers,
            components,
            energy,
            kind: match item.keyword {
                Keyword::Load => ForceKind::Load,
                Keyword::State => ForceKind::State,
                _ => ForceKind::Spring,
            },
        });
    }

    /// Length and rate of the line between two places.
    fn line_between(&mut self, first: &'a Expr, second: &'a Expr) -> Option<Line> {
        let (a, b) = (self.hold_on(first), self.hold_on(second));
        let holds = [a?, b?];
        self.are_two(&holds)?;
        let plane = self.common_plane([&holds[0], &holds[1]])?;
        let parties = [holds[0].party(), holds[1].party()];
        let points = Builder::new(&mut self.model.markers, parties, plane).origins();
        let [from, to] = points.map(|point| observed(point, 0, plane));
        let apart = both(&to, &from, subtract);
        let [from, to] = points.map(|point| observed(point, 1, plane));
        let moving = both(&to, &from, subtract);
        let length = norm(&apart);
        let rate = divide(dot(&apart, &moving), length.clone());
        Some(Line {
            points,
            apart,
            length,
            rate,
        })
    }

    fn linear(&mut self, call: &'a Call) -> Option<Acting> {
        let arguments = self.arguments(call, &LINEAR)?;
        let line = self.line_between(arguments.positional[0], arguments.positional[1]);
        let stiffness = self.stiffness(call, arguments.named.get("stiffness").copied(), STIFFNESS);
        let damping = self.damping(arguments.named.get("damping").copied(), DAMPING);
        let length = match arguments.named.get("length") {
            Some(expr) => self.not_negative(expr, LENGTH),
            None if stiffness.as_ref().and_then(fold::constant) == Some(0.0) => Some(number(0.0)),
            None => {
                self.errors.at(call.area, say::SPRING_LENGTH);
                None
            }
        };
        let (line, stiffness, damping, length) = (line?, stiffness?, damping?, length?);
        if damping.is_none() && fold::constant(&length) == Some(0.0) {
            // Also where the ends meet, and no line between them has a direction.
            let square = multiply(number(0.5), dot(&line.apart, &line.apart));
            let towards = algebra::scale(&stiffness, &line.apart);
            let energy = multiply(stiffness.clone(), square);
            return Some(Acting {
                shown: stored(line.shown(multiply(stiffness, line.length.clone())), &energy),
                forces: towards_each_other(&line, towards),
                energy: Some(energy),
            });
        }
        let stretch = subtract(line.length.clone(), length);
        let elastic = Elastic::new(stiffness, damping, stretch, line.rate.clone());
        Some(Acting {
            shown: stored(line.shown(elastic.force.clone()), &elastic.stored),
            energy: elastic.potential(),
            forces: pull(&line, elastic.force),
        })
    }

    fn law(&mut self, call: &'a Call) -> Option<Acting> {
        let arguments = self.arguments(call, &LAW)?;
        let line = self.line_between(arguments.positional[0], arguments.positional[1])?;
        let force = self.in_law(line.locals(), |check| {
            check.quantity(arguments.named["force"], Scope::Force, FORCE)
        })?;
        Some(Acting {
            shown: line.shown(force.clone()),
            forces: pull(&line, force),
            energy: None,
        })
    }

    /// Resolves a law in which some names have values of their own.
    pub(super) fn in_law<T>(&mut self, locals: [(&'static str, Typed); 2], resolve: impl FnOnce(&mut Self) -> T) -> T {
        self.locals.extend(locals);
        let result = self.with_lookups(resolve);
        self.locals.clear();
        result
    }

    /// A stiffness that must be given.
    pub(super) fn stiffness(&mut self, call: &Call, expr: Option<&'a Expr>, wanted: Wanted) -> Option<Value> {
        let Some(expr) = expr else {
            self.errors
                .at(call.area, say::spring_stiffness(&call.name.text, wanted.unit));
            return None;
        };
        self.not_negative(expr, wanted)
    }

    pub(super) fn damping(&mut self, expr: Option<&'a Expr>, wanted: Wanted) -> Option<Option<Value>> {
        match expr {
            Some(expr) => self.not_negative(expr, wanted).map(Some),
            None => Some(None),
        }
    }

    fn not_negative(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<Value> {
        let value = self.quantity(expr, Scope::Parameter, wanted)?;
        if fold::constant(&value).is_some_and(|value| value < 0.0) {
            self.errors.at(expr.area, say::not_negative(wanted.what));
            return None;
        }
        Some(value)
    }

    /// The angle of a joint, or of a planar or hinged frame.
    fn spring_angle(&mut self, expr: &'a Expr) -> Option<Angle> {
        let ExprKind::Name(name) = &expr.kind else {
            self.errors.at(expr.area, say::TORSIONAL_EXPECTED);
            return None;
        };
        if self.is_frame(&name.text) {
            let frame = self.frame(name)?;
            return self.own_angle(frame, name);
        }
        let built = self.built_joint(name)?;
        let coordinates = built
            .kind
            .map_or(&[][..], |kind| kind.coordinates[usize::from(built.normal.is_some())]);
        if !coordinates.contains(&"angle") {
            let message = say::no_coordinate(&name.text, &built.word, "angle", TURNING_JOINTS);
            self.errors.at(name.span, message);
            return None;
        }
        self.angle_between(&built, name)
    }

    fn torsional(&mut self, call: &'a Call) -> Option<Acting> {
        let arguments = self.arguments(call, &TORSIONAL)?;
        let angle = self.spring_angle(arguments.positional[0]);
        let stiffness = self.stiffness(call, arguments.named.get("stiffness").copied(), TORSION);
        let damping = self.damping(arguments.named.get("damping").copied(), FRICTION);
        let rest = match arguments.named.get("angle") {
            Some(expr) => self.angle(expr, Scope::Parameter, "the angle of a spring"),
            None => Some(number(0.0)),
        };
        let (angle, stiffness, damping, rest) = (angle?, stiffness?, damping?, rest?);
        let turn = subtract(angle.value(), rest);
        let elastic = Elastic::new(stiffness, damping, turn, angle.rate());
        Some(Acting {
            forces: angle.forces(&elastic.force),
            energy: elastic.potential(),
            shown: stored(shown_about(&angle, elastic.force), &elastic.stored),
        })
    }

    fn torsional_law(&mut self, call: &'a Call) -> Option<Acting> {
        let arguments = self.arguments(call, &TORSIONAL_LAW)?;
        let angle = self.spring_angle(arguments.positional[0])?;
        let moment = self.in_law(locals_about(&angle), |check| {
            check.quantity(arguments.named["moment"], Scope::Force, MOMENT)
        })?;
        Some(Acting {
            forces: angle.forces(&moment),
            energy: None,
            shown: shown_about(&angle, moment),
        })
    }
}

/// What a stiffness and a damping do along a way x.
pub(super) struct Elastic {
    /// `k x + c x'`
    pub force: Value,
    /// `k x^2 / 2`
    pub stored: Value,
    is_conservative: bool,
}

impl Elastic {
    pub fn new(stiffness: Value, damping: Option<Value>, way: Value, rate: Value) -> Self {
        let is_conservative = damping.is_none() && !algebra::has_time(&way);
        let square = multiply(way.clone(), way.clone());
        let stored = multiply(multiply(number(0.5), stiffness.clone()), square);
        let mut force = multiply(stiffness, way);
        if let Some(damping) = damping {
            force = add(force, multiply(damping, rate));
        }
        Self {
            force,
            stored,
            is_conservative,
        }
    }

    /// The energy, where all of the force follows from it.
    pub fn potential(&self) -> Option<Value> {
        self.is_conservative.then(|| self.stored.clone())
    }
}

impl Line {
    fn locals(&self) -> [(&'static str, Typed); 2] {
        let typed = |value: &Value, dimension| Typed::new(value.clone(), Dimension::of(dimension));
        [
            ("length", typed(&self.length, LENGTH.dimension)),
            ("rate", typed(&self.rate, [1, 0, -1, 0, 0, 0])),
        ]
    }

    /// A force that is positive where it pulls, with what it depends on.
    fn shown(&self, force: Value) -> Shown {
        shown(
            "force",
            Typed::new(force, Dimension::of(FORCE.dimension)),
            self.locals(),
        )
    }
}

/// The angle of a torsional spring, and its rate.
fn locals_about(angle: &Angle) -> [(&'static str, Typed); 2] {
    let typed = |value, dimension| Typed {
        nature: angular(),
        ..Typed::new(value, Dimension::of(dimension))
    };
    [
        ("angle", typed(angle.value(), [0; 6])),
        ("rate", typed(angle.rate(), [0, 0, -1, 0, 0, 0])),
    ]
}

/// A moment that is positive where it turns back, with what it depends on.
fn shown_about(angle: &Angle, moment: Value) -> Shown {
    let moment = Typed::new(moment, Dimension::of(MOMENT.dimension));
    shown("moment", moment, locals_about(angle))
}

/// What acts, and what it depends on.
pub(super) fn shown(name: &'static str, acts: Typed, locals: [(&'static str, Typed); 2]) -> Shown {
    let all = [(name, acts)].into_iter().chain(locals);
    all.map(|(name, typed)| (name, Quantity::Scalar(typed))).collect()
}

/// What a spring shows, and the energy that it stores.
pub(super) fn stored(mut shown: Shown, energy: &Value) -> Shown {
    let energy = Typed::new(energy.clone(), Dimension::of(ENERGY));
    shown.push(("energy", Quantity::Scalar(energy)));
    shown
}

/// Forces of a pull on both points towards each other.
fn pull(line: &Line, force: Value) -> Vec<(MarkerId, Vector)> {
    towards_each_other(line, algebra::scale(&divide(force, line.length.clone()), &line.apart))
}

fn towards_each_other(line: &Line, towards: Vector) -> Vec<(MarkerId, Vector)> {
    let back = towards.clone().map(algebra::negate);
    vec![(line.points[0], towards), (line.points[1], back)]
}
