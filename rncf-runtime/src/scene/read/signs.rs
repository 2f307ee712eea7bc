//! Signs of a picture: where joints hold and what acts there.

use super::configuration::pieces;
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
    /// Name of what acts along bodies or changes from place to place.
    Spread(&'s str),
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
        let linked = self.constraints.iter().filter(is_own).map(Shown::Linked);
        let has_arrow = |&load: &usize| !matches!(self.loads[load].kind, LoadKind::Around | LoadKind::Field { .. });
        let loads = (0..self.loads.len()).filter(has_arrow).map(Shown::Load);
        let pushes = (0..self.forces.len())
            .filter(|&index| matches!(self.forces[index].law, Law::Force(_)) && self.forces[index].element.is_none());
        let pushes = pushes.flat_map(|index| {
            let markers = self.forces[index].markers.iter().enumerate();
            let has_place = move |&(_, &marker): &(usize, &usize)| self.place_of(&self.markers[marker]).is_some();
            markers.filter(has_place).map(move |(at, _)| Shown::Push(index, at))
        });
        let spread = self.names_of_spread().into_iter().map(Shown::Spread);
        joints.chain(linked).chain(spread).chain(loads).chain(pushes).collect()
    }

    /// Names of the loads per length and of gravity that is not uniform, each once.
    fn names_of_spread(&self) -> Vec<&str> {
        let fields = self.loads.iter();
        let fields = fields.filter(|load| matches!(load.kind, LoadKind::Around | LoadKind::Field { .. }));
        let along = self
            .forces
            .iter()
            .filter(|force| matches!(force.law, Law::Distributed { .. }));
        let all = self.densities.iter().map(|density| density.spec.name);
        let all = all
            .chain(along.map(|force| force.name))
            .chain(fields.map(|load| load.name));
        let mut names = Vec::new();
        for name in all {
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
            Shown::Load(load) => Sign {
                name: self.loads[load].name.to_owned(),
                kind: match self.loads[load].kind {
                    LoadKind::Force { .. } => SignKind::Force,
                    LoadKind::Moment { .. } => SignKind::Moment,
                    _ => SignKind::Gravity,
                },
                place: self.load_points[load].as_ref().map(|point| self.on_curve(point)),
            },
            Shown::Push(index, at) => {
                let (name, markers) = (self.forces[index].name, &self.forces[index].markers);
                let marker = &self.markers[markers[at]];
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

    /// What acts at the loaded state at the signs that are no joints: N, N m or m/s^2, inertial axes.
    pub(crate) fn acting(&self, out: &mut Vec<Vector>) {
        out.clear();
        let t = self.buffers.t;
        for shown in self.shown() {
            match shown {
                Shown::Joint(_) | Shown::Linked(_) | Shown::Spread(_) => {}
                Shown::Load(load) => {
                    let frame = &self.buffers.frames[self.loads[load].frame];
                    out.push(frame.direction_to_inertial(self.parts.load(load, t).into()));
                }
                Shown::Push(index, at) => {
                    let (z, velocity) = self.force_arguments(index);
                    let mut forces = vec![0.0; 3 * z.len()];
                    self.push(index, t, &z, &velocity, &mut forces);
                    out.push(three(&forces, 3 * at));
                }
            }
        }
    }

    /// The first point that a constraint is about.
    fn held_at(&self, linked: &Linked) -> Option<SignPlace> {
        let markers = linked.spec.markers.iter().map(|&marker| &self.markers[marker]);
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
            | Marker::SectionTurn { point } => Some(self.on_curve(point)),
            Marker::Turn { frame } => Some(SignPlace::Frame {
                frame: *frame,
                at: Vector::zeros(),
            }),
            _ => None,
        }
    }

    fn on_curve(&self, point: &MeshPoint) -> SignPlace {
        let pieces = pieces(self.bodies[point.body].spec.count) as f64;
        SignPlace::Curve {
            curve: point.body,
            point: (point.element as f64 + point.xi) * pieces,
        }
    }

    fn last_point(&self, body: usize) -> f64 {
        let count = self.bodies[body].spec.count;
        (count * pieces(count)) as f64
    }
}
