//! Free frames: what of their pose is unknown, and where they start (THEORY 2).

use super::plane::{PLANES, plane};
use super::rigid::{Given, zeros};
use crate::check::values::quantity::{Vector, Wanted};
use crate::check::values::scope::Scope;
use crate::check::values::words::AXES;
use crate::check::{Check, Shape, fold, inertial, say};
use crate::errors::Area;
use crate::model::{Binary, Expr as Value, Frame, FrameId, Free, INERTIAL, Motions, Rotation};
use crate::parse::tree::{Call, Expr, ExprKind, Name};
use crate::suggest;

/// How a free frame moves and starts.
pub struct Moves {
    pub origin: [Value; 3],
    pub rotation: Option<Rotation>,
    pub free: Free,
    /// Where its plane or kind is written.
    pub area: Option<Area>,
}

impl Moves {
    /// The frame in its parent, without name and documentation.
    pub fn frame(self, parent: FrameId) -> Frame {
        Frame {
            parent,
            origin: self.origin,
            rotation: self.rotation,
            free: Some(self.free),
            ..inertial()
        }
    }
}

const FREE: Shape = Shape {
    positional: 0,
    named: &[
        "plane",
        "origin",
        "axis",
        "angle",
        "velocity",
        "angular_velocity",
        "speed",
    ],
    required: &[],
    usage: "free(origin = [0, 1, 0] m)",
};
const TURNING: Shape = Shape {
    positional: 0,
    named: &["axis", "angle", "angular_velocity"],
    required: &[],
    usage: "turning(angular_velocity = [0, 0, 1] rad/s)",
};
const HINGED: Shape = Shape {
    positional: 0,
    named: &["axis", "angle", "speed"],
    required: &["axis"],
    usage: "hinged(axis = z, angle = 30 deg)",
};
const ORIGIN: Wanted = Wanted {
    what: "the origin",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const VELOCITY: Wanted = Wanted {
    what: "the velocity",
    dimension: [1, 0, -1, 0, 0, 0],
    unit: "m/s",
};
pub(in crate::check) const SPIN: Wanted = Wanted {
    what: "the angular velocity",
    dimension: [0, 0, -1, 0, 0, 1],
    unit: "rad/s",
};
const SPEED: Wanted = Wanted {
    what: "the speed of an angle",
    dimension: [0, 0, -1, 0, 0, 1],
    unit: "rad/s",
};

impl<'a> Check<'a> {
    /// `free(..)`, `turning(..)` or `hinged(..)`.
    pub(in crate::check) fn free_frame(&mut self, call: &'a Call) -> Option<Moves> {
        let shape = match call.name.text.as_str() {
            "turning" => &TURNING,
            "hinged" => &HINGED,
            _ => &FREE,
        };
        self.arguments(call, shape)?;
        let named = call.arguments.iter().filter_map(|argument| {
            let name = argument.name.as_ref()?;
            Some((name.text.as_str(), (Area::from(name.span), &argument.value)))
        });
        let given: Given<'a> = named.collect();
        let motions = match call.name.text.as_str() {
            "turning" => Motions::Turning,
            "hinged" => Motions::Hinged {
                axis: self.axis(given["axis"].1)?,
            },
            _ => match given.get("plane") {
                Some((_, plane)) => Motions::Planar {
                    normal: self.plane_word(plane)?,
                },
                None => Motions::Spatial,
            },
        };
        let mut moves = self.free_moves(motions, &given)?;
        moves.area = moves.area.or(Some(call.name.span.into()));
        Some(moves)
    }

    /// `xy`, `yz` or `zx`: the axis normal to it.
    pub(in crate::check) fn plane_word(&mut self, expr: &Expr) -> Option<usize> {
        let ExprKind::Name(name) = &expr.kind else {
            self.errors.at(expr.area, say::PLANE_EXPECTED);
            return None;
        };
        let normal = PLANES.iter().position(|plane| *plane == name.text);
        if normal.is_none() {
            let message = suggest::unknown("plane", &name.text, ["xy", "yz", "zx"]);
            self.errors.at(name.span, message);
        }
        normal
    }

    /// The start of what moves freely, from its named values.
    pub(in crate::check) fn free_moves(&mut self, motions: Motions, given: &Given<'a>) -> Option<Moves> {
        let normal = match motions {
            Motions::Planar { normal } | Motions::ShiftingPlanar { normal } => Some(normal),
            _ => None,
        };
        let origin = self.start(given, "origin", ORIGIN, normal);
        let velocity = self.start(given, "velocity", VELOCITY, normal);
        let turning = match motions {
            Motions::Planar { normal } => {
                let mut axis = [0.0; 3];
                axis[normal] = 1.0;
                self.turning_in_plane(given, normal)
                    .then(|| self.turning_about(given, axis))
                    .flatten()
            }
            Motions::Hinged { axis } => self.turning_about(given, axis),
            Motions::Spatial | Motions::Turning => self.turning_in_space(given),
            Motions::Shifting | Motions::ShiftingPlanar { .. } | Motions::State => Some((None, zeros())),
        };
        let (origin, velocity, (rotation, spin)) = (origin?, velocity?, turning?);
        Some(Moves {
            origin,
            rotation,
            area: given.get("plane").map(|(_, plane)| plane.area),
            free: Free {
                motions,
                velocity,
                spin,
                parts: Vec::new(),
                is_body: false,
                size: None,
            },
        })
    }

    fn start(&mut self, given: &Given<'a>, word: &str, wanted: Wanted, normal: Option<usize>) -> Option<[Value; 3]> {
        match given.get(word) {
            Some((_, expr)) => self.flat_vector(expr, wanted, normal).map(|vector| vector.values),
            None => Some(zeros()),
        }
    }

    /// A vector of parameters and constants that lies in the plane, where there is one.
    pub(in crate::check) fn flat_vector(
        &mut self,
        expr: &'a Expr,
        wanted: Wanted,
        normal: Option<usize>,
    ) -> Option<Vector> {
        let vector = self.vector(expr, Scope::Parameter, wanted)?;
        if let Some(normal) = normal
            && !self.is_flat(&vector, normal, wanted.what)
        {
            return None;
        }
        Some(vector)
    }

    /// Whether a vector lies in the plane of what moves in one.
    pub(in crate::check) fn is_flat(&mut self, vector: &Vector, normal: usize, what: &str) -> bool {
        let is_flat = fold::constant(&vector.values[normal]) == Some(0.0);
        if !is_flat {
            let message = say::leaves_own_plane(what, plane(normal), AXES[normal]);
            self.errors.at(vector.areas[normal], message);
        }
        is_flat
    }

    /// Refuses what has no meaning in a plane.
    fn turning_in_plane(&mut self, given: &Given<'a>, normal: usize) -> bool {
        let before = self.errors.len();
        if let Some((area, _)) = given.get("axis") {
            self.errors.at(*area, say::plane_axis(plane(normal), AXES[normal]));
        }
        if let Some((area, _)) = given.get("angular_velocity") {
            self.errors.at(*area, say::PLANE_SPIN);
        }
        self.errors.len() == before
    }

    /// Angle and speed about a fixed axis.
    fn turning_about(&mut self, given: &Given<'a>, axis: [f64; 3]) -> Option<(Option<Rotation>, [Value; 3])> {
        let angle = match given.get("angle") {
            Some((_, angle)) => self.angle(angle, Scope::Parameter, "the angle of a frame"),
            None => Some(Value::Number(0.0)),
        };
        let speed = match given.get("speed") {
            Some((_, speed)) => self.rate(speed, Scope::Parameter, SPEED),
            None => Some(Value::Number(0.0)),
        };
        let (angle, speed) = (angle?, speed?);
        let spin = axis.map(|along| match along {
            0.0 => Value::Number(0.0),
            1.0 => speed.clone(),
            _ => Value::Binary(
                Binary::Multiply,
                Box::new(Value::Number(along)),
                Box::new(speed.clone()),
            ),
        });
        Some((Some(Rotation { axis, angle }), spin))
    }

    /// Rotation at t = 0 and angular velocity in space.
    fn turning_in_space(&mut self, given: &Given<'a>) -> Option<(Option<Rotation>, [Value; 3])> {
        if let Some((area, _)) = given.get("speed") {
            self.errors.at(*area, say::LONE_SPEED);
            return None;
        }
        let spin = match given.get("angular_velocity") {
            Some((_, spin)) => self.rates(spin, Scope::Parameter, SPIN).map(|spin| spin.values),
            None => Some(zeros()),
        };
        let rotation = match (given.get("axis"), given.get("angle")) {
            (Some((_, axis)), Some((_, angle))) => {
                let axis = self.axis(axis);
                let angle = self.angle(angle, Scope::Parameter, "the angle of a frame");
                Some(Rotation {
                    axis: axis?,
                    angle: angle?,
                })
            }
            (Some((area, _)), None) => {
                // An angle that could not be read is missing, too.
                if self.tree.complete {
                    self.errors.at(*area, say::LONE_AXIS);
                }
                return None;
            }
            (None, Some((area, _))) => {
                self.errors.at(*area, say::LONE_ANGLE);
                return None;
            }
            (None, None) => None,
        };
        Some((rotation, spin?))
    }

    /// The parent of something free, where it can carry it.
    pub(in crate::check) fn carrier(
        &mut self,
        name: &str,
        word: Option<&Name>,
        parent: Option<FrameId>,
        moves: Option<&Moves>,
    ) -> Option<FrameId> {
        let (parent, moves, Some(word)) = (parent?, moves?, word) else {
            return parent;
        };
        if self.model.frames[parent.0].free.is_some() {
            self.errors.at(word.span, say::nested_free(name, &word.text));
            return None;
        }
        match moves.free.motions {
            Motions::Turning | Motions::Hinged { .. } => {
                let kind = if moves.free.motions == Motions::Turning {
                    "turning"
                } else {
                    "hinged"
                };
                if let Some(turning) = self.turns(parent) {
                    let message = say::turning_parent(kind, &turning);
                    self.errors.at(word.span, message);
                    return None;
                }
            }
            Motions::Planar { normal } | Motions::ShiftingPlanar { normal } => {
                let area = moves.area.unwrap_or(word.span.into());
                if !self.keeps_plane(parent, normal, area) {
                    return None;
                }
            }
            Motions::Spatial | Motions::Shifting | Motions::State => {}
        }
        Some(parent)
    }

    /// The name of the first frame from this one outwards that turns.
    fn turns(&self, frame: FrameId) -> Option<String> {
        let mut at = frame;
        while at != INERTIAL {
            let frame = &self.model.frames[at.0];
            let rotation = frame.rotation.as_ref();
            if rotation.is_some_and(|rotation| !fold::is_free_of_time(&rotation.angle)) {
                return Some(frame.name.clone());
            }
            at = frame.parent;
        }
        None
    }
}
