//! Sizes of the kinds of unknowns, by which every tolerance is measured: lengths of the scene, never of a round-off.

use super::mesh_scene::MeshScene;
use crate::model::{Kind, Scene, Uniform};
use crate::scene::frames::free_frames::FreeFrame;
use crate::scene::pieces::marker::Marker;
use crate::space::Vector;
use crate::system::{State, System, Tangent};

/// Round-off of a difference of two places, as a part of their coordinates: of a few operations on each.
const ROUND_OFF: f64 = 1e3 * f64::EPSILON;
/// A lever below this part of the scene's length says nothing of it: what is left of equal numbers that were written
/// down with some digits.
const NOTHING: f64 = 1e-9;
/// Smallest size of a frame's position as a part of the scene's length: below it tolerances meet the round-off of
/// what the frame is joined to.
const LEAST: f64 = 1e-6;
/// Length of a scene in which nothing has one, m; the shortest one that such a scene has for its place, and for its loads.
const LENGTH: f64 = 1.0;
const NEAREST: f64 = 1e-9;
const SHORTEST: f64 = 1e-12;
/// Speed of light, m/s.
const LIGHT: f64 = 299_792_458.0;

impl MeshScene {
    /// Sizes of all unknowns, at the state of t = 0.
    ///
    /// Positions of nodes have the length of their body. Positions of a free frame have the largest length of what it
    /// carries: bodies' lines and distances of its points from its origin, which are levers. Where there is none, or
    /// what there is is a round-off, it is the length of the scene. Beside them, where nothing has a length, the distance from the origin.
    pub(crate) fn unknown_sizes(&self) -> (Vec<f64>, Option<f64>) {
        let origins = self.layout.origins();
        let size = |&(vector, _): &(usize, usize)| {
            let (body, _, local) = self.locate(vector);
            if body.spec.nodal[local].is_position() {
                body.spec.line.length()
            } else {
                1.0
            }
        };
        let mut sizes: Vec<f64> = origins.iter().map(size).collect();
        let places = self.places();
        let coordinates = places.iter().map(|place| place.at.norm()).fold(0.0, f64::max);
        let round_off = ROUND_OFF * coordinates;
        let (scene, distance) = match self.scene_length(&places, round_off) {
            Ok(length) => (length, None),
            Err(distance) => (known_distance(distance).unwrap_or(LENGTH), Some(distance)),
        };
        for frame in &self.frames.free {
            let turns = frame.count() - frame.shifts();
            sizes.extend(std::iter::repeat_n(
                self.size_of(frame, scene, round_off),
                frame.shifts(),
            ));
            let of_turns = if frame.is_state() { frame.spec.size } else { 1.0 };
            sizes.extend(std::iter::repeat_n(of_turns, turns));
        }
        (sizes, distance)
    }

    /// The length of a scene that has none but its distance from the origin: how far it moves for its start and its loads there.
    pub(crate) fn measure_distance(&mut self) {
        let Some(distance) = self.tabulated.distance.filter(|distance| *distance > 0.0) else {
            return;
        };
        let moved = self.moved_by(&Uniform::at_rest(0.0), &self.rest(0.0));
        self.take_length(known_distance(distance.max(moved)).unwrap_or(LENGTH));
    }

    /// The same for all loads at a time, of what is at rest.
    pub(crate) fn measure_loads(&mut self, at: &Uniform) {
        let Some(distance) = self.tabulated.distance else {
            return;
        };
        let at = Uniform {
            kind: Kind::Static,
            ..at.scaled(1.0)
        };
        let mut state = self.rest(at.t);
        state.v.fill(0.0);
        let moved = distance.max(self.moved_by(&at, &state));
        if moved > SHORTEST {
            self.take_length(moved);
        }
    }

    /// How far forces and speeds of a state move what is stiff in the directions of the unknowns, m, and what is not.
    fn moved_by(&mut self, at: &Uniform, state: &State) -> f64 {
        let pattern = self.pattern().clone();
        let zeros = || vec![0.0; pattern.entries()];
        let mut tangent = Tangent {
            mass: zeros(),
            stiffness: zeros(),
            damping: zeros(),
        };
        let mut forces = vec![0.0; state.x.len()];
        self.uniform_residual(at, state, &mut forces);
        self.small_motions(at, state, &mut tangent);
        let mut longest: f64 = 0.0;
        for (unknown, (force, speed)) in forces.iter().zip(&state.v).enumerate() {
            let Some(entry) = pattern.find(unknown, unknown).filter(|_| self.is_length(unknown)) else {
                continue;
            };
            let [mass, stiffness] = [tangent.mass[entry], tangent.stiffness[entry].abs()];
            let moved = match force.abs() + speed.abs() > 0.0 {
                true if stiffness > 0.0 => (force / stiffness).abs().max(speed.abs() * (mass / stiffness).sqrt()),
                true => LENGTH,
                false => 0.0,
            };
            longest = longest.max(moved);
        }
        longest.min(LENGTH)
    }

    fn take_length(&mut self, length: f64) {
        for unknown in 0..self.tabulated.sizes.len() {
            if self.is_length(unknown) {
                self.tabulated.sizes[unknown] = length;
            }
        }
    }

    /// The fastest unknown position, where it is faster than light.
    pub(crate) fn faster_than_light(&self, state: &State) -> Option<String> {
        let (unknown, speed) = (0..state.v.len())
            .filter(|&unknown| self.is_length(unknown))
            .map(|unknown| (unknown, state.v[unknown].abs()))
            .max_by(|a, b| a.1.total_cmp(&b.1))?;
        (speed > LIGHT).then(|| {
            format!(
                "{} moves at {speed:.1e} m/s, faster than light",
                self.describe_unknown(unknown)
            )
        })
    }

    /// Whether an unknown is the position of a node or frame.
    pub(crate) fn is_length(&self, unknown: usize) -> bool {
        let Some(&(vector, _)) = self.layout.origins().get(unknown) else {
            let place = unknown - (self.layout.unknowns() - self.layout.border());
            let frame = &self.frames.free[self.frames.free.partition_point(|frame| frame.first <= place) - 1];
            return place - frame.first < frame.shifts();
        };
        let (body, _, local) = self.locate(vector);
        body.spec.nodal[local].is_position()
    }

    /// Lets the positions of frames that start far away count from moving points.
    pub(crate) fn follow_far_starts(&mut self) {
        let border = self.layout.unknowns() - self.layout.border();
        for frame in self.frames.free.iter_mut().filter(|frame| frame.shifts() > 0) {
            frame.follow(self.tabulated.sizes[border + frame.first]);
        }
    }

    /// Size of the position of a free frame in a scene of the given length, m.
    fn size_of(&self, frame: &FreeFrame, scene: f64, round_off: f64) -> f64 {
        let bodies = self.longest_body(frame);
        let lever = self.longest_lever(frame);
        if lever > bodies && lever > round_off.max(NOTHING * scene) {
            lever.max(LEAST * scene)
        } else if bodies > 0.0 {
            bodies
        } else {
            scene
        }
    }

    /// Length of the scene, m: the largest that bodies and levers have; else how far apart its free parts are; else the
    /// size of a rigid body by its inertia; else how far apart its free parts and the points are that they are joined
    /// to. Where there is none of these, as of one point, its distance from the origin is an error. Lengths of round-off do not count.
    fn scene_length(&self, places: &[Spot], round_off: f64) -> Result<f64, f64> {
        let lines = self.bodies.iter().map(|body| body.spec.line.length());
        let levers = self.frames.free.iter().map(|frame| self.longest_lever(frame));
        let carried = lines.chain(levers).fold(0.0, f64::max);
        let moving: Vec<Vector> = places
            .iter()
            .filter(|place| place.moves)
            .map(|place| place.at)
            .collect();
        let all: Vec<Vector> = places.iter().map(|place| place.at).collect();
        let by_inertia = self.frames.free.iter().map(size_by_inertia).fold(0.0, f64::max);
        let distance = moving.iter().map(|&at| at.norm()).fold(0.0, f64::max);
        let moving = extent(&moving);
        let known = |length: &f64| *length > round_off.max(NOTHING * moving) && length.is_finite();
        let lengths = [carried, moving, by_inertia, extent(&all)];
        lengths.into_iter().find(known).ok_or(distance)
    }

    fn longest_body(&self, frame: &FreeFrame) -> f64 {
        let bodies = self.bodies.iter().filter(|body| body.spec.frame == frame.spec.frame);
        bodies.map(|body| body.spec.line.length()).fold(0.0, f64::max)
    }

    /// Largest distance of a point in a free frame from its origin, m.
    fn longest_lever(&self, frame: &FreeFrame) -> f64 {
        let points = self.links.markers.iter().map(|marker| match marker {
            Marker::Fixed {
                frame: other,
                at,
                is_point: true,
            } if *other == frame.spec.frame => at.norm(),
            _ => 0.0,
        });
        points.fold(0.0, f64::max)
    }

    /// Places in space at t = 0: origins of free frames, ends of bodies, and points of joints and forces.
    fn places(&self) -> Vec<Spot> {
        let frames = &self.buffers.frames;
        let mut places: Vec<Spot> = self
            .frames
            .free
            .iter()
            .map(|frame| Spot {
                at: frame.start.position,
                moves: true,
            })
            .collect();
        for body in &self.bodies {
            let motion = &frames[body.spec.frame];
            for node in [0, body.spec.count] {
                let mut at = Vector::zeros();
                for (&axis, value) in body.spec.axes.iter().zip(body.spec.undeformed(node, 0)) {
                    at[axis] = value;
                }
                places.push(Spot {
                    at: motion.point_to_inertial(at),
                    moves: true,
                });
            }
        }
        for marker in self.links.markers.iter().filter(|marker| marker.is_point()) {
            let moves = match marker {
                Marker::Fixed { frame, .. } => self.frames.free_of[*frame].is_some(),
                _ => true,
            };
            places.push(Spot {
                at: self.jet(marker)[0],
                moves,
            });
        }
        places
    }
}

/// A distance from the origin that is no round-off.
fn known_distance(distance: f64) -> Option<f64> {
    Some(distance).filter(|distance| *distance > NEAREST && distance.is_finite())
}

/// A place in space.
struct Spot {
    /// Where, m, inertial axes.
    at: Vector,
    /// Whether it moves freely.
    moves: bool,
}

/// Diagonal of the box around places, m.
fn extent(places: &[Vector]) -> f64 {
    let Some(first) = places.first() else { return 0.0 };
    let least = |a: Vector, b: &Vector| a.inf(b);
    let most = |a: Vector, b: &Vector| a.sup(b);
    (places.iter().fold(*first, most) - places.iter().fold(*first, least)).norm()
}

/// Distance of a rigid body's centre of mass from its origin, or radius of gyration; the larger one, m.
fn size_by_inertia(frame: &FreeFrame) -> f64 {
    let rigid = &frame.spec.rigid;
    if rigid.mass == 0.0 {
        return 0.0;
    }
    let center = (1.0 / rigid.mass * rigid.moment).norm();
    let inertia = (0..3).map(|axis| rigid.inertia[(axis, axis)]).fold(0.0, f64::max);
    center.max((inertia / rigid.mass).sqrt())
}
