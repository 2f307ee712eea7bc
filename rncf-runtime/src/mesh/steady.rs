//! Whether a relative equilibrium can exist: everything that acts on a body must be at rest in its
//! frame (THEORY 8.1).

use super::conditions::Condition;
use super::frame::FrameMotion;
use super::linked::Marker;
use super::parts::{JointKind, LoadKind, Parts};
use super::scene::MeshScene;
use crate::vector::{add, cross, norm, subtract};

/// Relative size below which a change of a motion, or a load's component across the spin, counts as
/// zero.
const NEGLIGIBLE: f64 = 1e-9;

/// Time after which a uniform motion must still be the same, s.
const A_WHILE: f64 = 1e-3;

/// Whether two spins (rad/s) or accelerations (m/s^2) differ by more than round-off; a motion that
/// sets out smoothly from rest counts as uniform there.
fn differs(a: [f64; 3], b: [f64; 3]) -> bool {
    norm(subtract(a, b)) > NEGLIGIBLE * norm(a).max(norm(b)).max(1.0)
}

/// Angular velocity of a frame, inertial axes.
fn turning(frame: &FrameMotion) -> [f64; 3] {
    frame.direction_to_inertial(frame.spin)
}

/// Velocity of a point (inertial) that is fixed in the frame.
fn carried(frame: &FrameMotion, point: [f64; 3]) -> [f64; 3] {
    add(frame.velocity, cross(turning(frame), subtract(point, frame.position)))
}

impl<P: Parts> MeshScene<P> {
    /// What stands against a relative equilibrium at `t`, by name.
    pub(super) fn obstacle(&self, t: f64) -> Option<String> {
        if let Some(frame) = self.free.first() {
            let name = self.parts.frame_name(frame.spec.frame);
            return Some(format!(
                "frame `{name}` moves freely: a relative equilibrium needs bodies in frames whose motion is prescribed"
            ));
        }
        if let Some(obstacle) = self.linked_obstacle() {
            return Some(obstacle);
        }
        let (frames, later) = (self.motions(t), self.motions(t + A_WHILE));
        let load = (0..self.loads.len()).find(|&index| self.parts.load_varies(index));
        if let Some(index) = load {
            return Some(format!("load `{}` varies with time", self.loads[index].name));
        }
        for body in &self.bodies {
            let (frame, next) = (&frames[body.spec.frame], &later[body.spec.frame]);
            let pull = |frame: &FrameMotion| frame.direction_to_frame(frame.acceleration);
            if differs(frame.spin, next.spin) || differs(pull(frame), pull(next)) {
                let name = self.parts.frame_name(body.spec.frame);
                return Some(format!(
                    "frame `{name}` does not move uniformly: its spin or acceleration changes"
                ));
            }
        }
        let loads = (0..self.loads.len()).find_map(|index| self.load_obstacle(index, t, &frames));
        loads.or_else(|| {
            let conditions = self.conditions.iter();
            conditions
                .map(|condition| self.joint_obstacle(condition, &frames))
                .find_map(|found| found)
        })
    }

    /// A constraint or force between things in different frames.
    fn linked_obstacle(&self) -> Option<String> {
        let users = self
            .constraints
            .iter()
            .map(|linked| (linked.spec.name, linked.spec.markers));
        let mut users = users.chain(self.forces.iter().map(|force| (force.name, force.markers)));
        let frame = |marker: usize| match &self.markers[marker] {
            Marker::Body { point, .. } => self.bodies[point.body].spec.frame,
            marker => self.marker_frame(marker),
        };
        let (name, _) = users.find(|(_, markers)| markers.iter().any(|&marker| frame(marker) != frame(markers[0])))?;
        Some(format!(
            "`{name}` acts between different frames: a relative equilibrium needs both ends in the same one"
        ))
    }

    /// A load that keeps its direction in a frame which turns relative to a body that it acts on.
    fn load_obstacle(&self, index: usize, t: f64, frames: &[FrameMotion]) -> Option<String> {
        let load = &self.loads[index];
        let value = frames[load.frame].direction_to_inertial(self.parts.load(index, t));
        let acts_on = |body: usize| match load.kind {
            LoadKind::Gravity => true,
            LoadKind::Force { body: other, .. } | LoadKind::Moment { body: other, .. } => body == other,
        };
        let turned = |&body: &usize| turns(&frames[load.frame], &frames[self.bodies[body].spec.frame], value);
        let body = (0..self.bodies.len()).filter(|&body| acts_on(body)).find(turned)?;
        let spec = &self.bodies[body].spec;
        let name = self.parts.frame_name(spec.frame);
        Some(format!(
            "load `{}` keeps its direction while body `{}` turns with frame `{name}`",
            load.name, spec.name
        ))
    }

    /// A joint whose point or direction moves in the frame of its body.
    fn joint_obstacle(&self, condition: &Condition, frames: &[FrameMotion]) -> Option<String> {
        let (joint, data) = (&self.joints[condition.joint], &condition.data);
        let body = &self.bodies[joint.body].spec;
        let (own, other) = (&frames[body.frame], &frames[joint.frame]);
        let tangent = other.direction_to_inertial(data.tangent);
        if joint.kind != JointKind::Pin && turns(other, own, tangent) {
            return Some(format!(
                "joint `{}` holds the direction of body `{}` in a frame that does not turn with it",
                joint.name, body.name
            ));
        }
        let point = other.point_to_inertial(data.point);
        let [held, moved] = [carried(other, point), carried(own, point)];
        if norm(subtract(held, moved)) > NEGLIGIBLE * norm(held).max(norm(moved)) {
            return Some(format!(
                "joint `{}` holds body `{}` at a point that moves in its frame",
                joint.name, body.name
            ));
        }
        None
    }
}

/// Whether a direction (inertial) fixed in frame `a` turns in frame `b`.
fn turns(a: &FrameMotion, b: &FrameMotion, direction: [f64; 3]) -> bool {
    let (first, second) = (turning(a), turning(b));
    let relative = subtract(second, first);
    let round_off = NEGLIGIBLE * norm(first).max(norm(second));
    norm(relative) > round_off && norm(cross(relative, direction)) > NEGLIGIBLE * norm(relative) * norm(direction)
}
