//! Signs of a picture: where joints hold and what acts there.

use super::configuration::pieces;
use super::per_length::Line;
use crate::emitted::{JointSpec, LoadKind, When};
use crate::model::{Sign, SignKind, SignPlace};
use crate::scene::MeshScene;
use crate::scene::bodies::place::{MeshPoint, PlaceVector};
use crate::scene::pieces::marker::{Linked, Marker};
use crate::scene::pieces::push::Law;
use crate::space::{Vector, three};

/// Something of the declaration that a picture has a sign for.
enum Shown<'s> {
    Joint(&'s JointSpec),
    Linked(&'s Linked),
    /// Name of gravity that changes from place to place.
    Spread(&'s str),
    /// A load per length, in the middle of an element.
    Line(Line<'s>),
    /// Index of the load.
    Load(usize),
    /// A force on markers, and a place among its markers.
    Push(usize, usize),
}

impl MeshScene {
    /// Joints first, then what acts: along bodies, and at places.
    fn shown(&self) -> Vec<Shown<'_>> {
        let joints = self.joints.iter().map(Shown::Joint);
        let is_own = |linked: &&Linked| linked.spec.when == When::Always && self.held_at(linked).is_some();
        let linked = self.links.constraints.iter().filter(is_own).map(Shown::Linked);
        let has_arrow = |&load: &usize| {
            !matches!(
                self.dead_loads.specs[load].kind,
                LoadKind::Around | LoadKind::Field { .. }
            )
        };
        let loads = (0..self.dead_loads.specs.len()).filter(has_arrow).map(Shown::Load);
        let pushes = (0..self.links.forces.len()).filter(|&index| {
            matches!(self.links.forces[index].law, Law::Force(_)) && self.links.forces[index].element.is_none()
        });
        let pushes = pushes.filter(|&index| !self.is_of_state(index)).flat_map(|index| {
            let markers = self.links.forces[index].markers.iter().enumerate();
            let has_place = move |&(_, &marker): &(usize, &usize)| self.place_of(&self.links.markers[marker]).is_some();
            markers.filter(has_place).map(move |(at, _)| Shown::Push(index, at))
        });
        let spread = self.names_of_spread().into_iter().map(Shown::Spread);
        let lines = self.lines().into_iter().map(Shown::Line);
        let acting = spread.chain(lines).chain(loads).chain(pushes);
        joints.chain(linked).chain(acting).collect()
    }

    /// Names of gravity that is not uniform, each once.
    fn names_of_spread(&self) -> Vec<&str> {
        let fields = self.dead_loads.specs.iter();
        let fields = fields.filter(|load| matches!(load.kind, LoadKind::Around | LoadKind::Field { .. }));
        let mut names = Vec::new();
        for name in fields.map(|load| load.name) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// Joints, and loads and forces at places, and uniform gravity.
    pub(crate) fn signs(&self) -> Vec<Sign> {
        let sign = |shown: Shown<'_>| match shown {
            Shown::Joint(joint) => Sign {
                name: joint.name.to_owned(),
                kind: SignKind::Joint,
                place: Some(SignPlace::Curve {
                    curve: joint.body,
                    point: if joint.at_end { self.last_point(joint.body) } else { 0.0 },
                }),
            },
            Shown::Linked(linked) => Sign {
                name: linked.spec.name.to_owned(),
                kind: SignKind::Joint,
                place: self.held_at(linked),
            },
            Shown::Spread(name) => Sign {
                name: name.to_owned(),
                kind: SignKind::Spread,
                place: None,
            },
            Shown::Line(line) => Sign {
                name: line.name.to_owned(),
                kind: SignKind::Line,
                place: Some(self.on_element(line.body, line.element, 0.5)),
            },
            Shown::Load(load) => Sign {
                name: self.dead_loads.specs[load].name.to_owned(),
                kind: match self.dead_loads.specs[load].kind {
                    LoadKind::Force { .. } => SignKind::Force,
                    LoadKind::Moment { .. } => SignKind::Moment,
                    _ => SignKind::Gravity,
                },
                place: self.dead_loads.points[load].as_ref().map(|point| self.on_curve(point)),
            },
            Shown::Push(index, at) => {
                let (name, markers) = (self.links.forces[index].name, &self.links.forces[index].markers);
                let marker = &self.links.markers[markers[at]];
                Sign {
                    name: name.to_owned(),
                    kind: if marker.is_point() {
                        SignKind::Force
                    } else {
                        SignKind::Moment
                    },
                    place: self.place_of(marker),
                }
            }
        };
        self.shown().into_iter().map(sign).collect()
    }

    /// What acts at the loaded state at the signs with arrows: N/m, N, N m or m/s^2, inertial axes.
    pub(crate) fn acting(&self, out: &mut Vec<Vector>) {
        out.clear();
        let t = self.buffers.t;
        let values = self.all_values(t);
        for shown in self.shown() {
            match shown {
                Shown::Joint(_) | Shown::Linked(_) | Shown::Spread(_) => {}
                Shown::Line(line) => out.push(self.per_length(line, t, &values)),
                Shown::Load(load) => {
                    let frame = &self.buffers.frames[self.dead_loads.specs[load].frame];
                    out.push(frame.direction_to_inertial(self.parts.load(load, t).into()));
                }
                Shown::Push(index, at) => {
                    out.push(three(&self.pushed(index, t), 3 * at));
                }
            }
        }
    }

    /// Whether a force is the equation of a state, which is its first marker.
    fn is_of_state(&self, index: usize) -> bool {
        let first = self.links.forces[index].markers.first();
        first.is_some_and(|&marker| self.is_state_marker(&self.links.markers[marker]))
    }

    /// A force in messages: what it is, and its name.
    pub(crate) fn told_of_force(&self, index: usize) -> String {
        let what = if self.is_of_state(index) {
            "the rate of state"
        } else {
            "force"
        };
        format!("{what} `{}`", self.links.forces[index].name)
    }

    /// Whether a marker is the number of a state.
    pub(crate) fn is_state_marker(&self, marker: &Marker) -> bool {
        matches!(*marker, Marker::Angle { free } if self.frames.free[free].is_state())
    }

    /// Whether a force, a load or another state reads the state that is this unknown.
    pub(crate) fn reads(&self, unknown: usize) -> bool {
        let border = self.layout.unknowns() - self.layout.border();
        let is_it = |&marker: &usize| match self.links.markers[marker] {
            Marker::Angle { free } => border + self.frames.free[free].first == unknown,
            _ => false,
        };
        let is_own = |index: usize| self.is_of_state(index) && is_it(&self.links.forces[index].markers[0]);
        let mut others = (0..self.links.forces.len()).filter(|&index| !is_own(index));
        others.any(|index| self.links.forces[index].markers.iter().any(is_it))
    }

    /// What a force does to its markers at the loaded state.
    pub(crate) fn pushed(&self, index: usize, t: f64) -> Vec<f64> {
        let (z, velocity) = self.force_arguments(index);
        let mut forces = vec![0.0; 3 * z.len()];
        self.push(index, t, &z, &velocity, &mut forces);
        forces
    }

    /// The first point that a constraint is about.
    fn held_at(&self, linked: &Linked) -> Option<SignPlace> {
        let markers = linked.spec.markers.iter().map(|&marker| &self.links.markers[marker]);
        markers
            .filter(|marker| marker.is_point())
            .find_map(|marker| self.place_of(marker))
    }

    /// Where a point is, or what is turned; directions and angles have no place.
    fn place_of(&self, marker: &Marker) -> Option<SignPlace> {
        match marker {
            Marker::Fixed {
                frame,
                at,
                is_point: true,
            } => Some(SignPlace::Frame { frame: *frame, at: *at }),
            Marker::Body {
                point,
                of: PlaceVector::Position,
            }
            | Marker::Section {
                point, is_point: true, ..
            }
            | Marker::SectionTurn { point } => Some(self.on_curve(point)),
            Marker::Turn { frame } => Some(SignPlace::Frame {
                frame: *frame,
                at: Vector::zeros(),
            }),
            _ => None,
        }
    }

    fn on_curve(&self, point: &MeshPoint) -> SignPlace {
        self.on_element(point.body, point.element, point.xi)
    }

    fn on_element(&self, body: usize, element: usize, xi: f64) -> SignPlace {
        let pieces = pieces(self.bodies[body].spec.count) as f64;
        SignPlace::Curve {
            curve: body,
            point: (element as f64 + xi) * pieces,
        }
    }

    fn last_point(&self, body: usize) -> f64 {
        let count = self.bodies[body].spec.count;
        (count * pieces(count)) as f64
    }
}
