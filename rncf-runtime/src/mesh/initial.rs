//! Initial shapes: where and how fast bodies start, and whether their joints let them.

use super::conditions::joint_data;
use super::frame::FrameMotion;
use super::parts::{BodySpec, JointData, JointKind, JointSpec, Parts};
use super::scene::{MeshScene, undeformed};
use crate::error::ModelError;
use crate::vector::{Vector, add, cross, dot, norm, subtract};

/// Relative size of a contradiction between an initial shape and a joint that counts as round-off.
const ROUND_OFF: f64 = 1e-10;

impl<P: Parts> MeshScene<P> {
    /// Components of all nodal vectors and of their rates at t = 0, in their declared frames.
    pub(super) fn initial_shape(&self) -> [Vec<f64>; 2] {
        let (mut q, mut v) = (Vec::new(), Vec::new());
        for (index, body) in self.bodies.iter().enumerate() {
            let spec = &body.spec;
            for within in 0..spec.vectors() {
                let (node, local) = spec.locate(within);
                let order = spec.orders[local];
                let [position, velocity] = self.parts.initial(index, arclength(spec, node));
                let taken = |vectors: [Vector; 2]| spec.axes.iter().map(move |&axis| vectors[order][axis]);
                match position {
                    Some(position) => q.extend(taken(position)),
                    None => q.extend(undeformed(spec, node, order)),
                }
                v.extend(taken(velocity.unwrap_or_default()));
            }
        }
        [q, v]
    }

    /// Refuses initial shapes that are not finite, without direction, or elsewhere than where a joint
    /// holds the body.
    pub(super) fn check_initial(&self) -> Result<(), ModelError> {
        for (index, body) in self.bodies.iter().enumerate() {
            for node in 0..=body.spec.count {
                let x = arclength(&body.spec, node);
                check_node(&body.spec, x, self.parts.initial(index, x))?;
            }
        }
        let frames = self.motions(0.0);
        self.joints.iter().try_for_each(|joint| self.check_held(joint, &frames))
    }

    fn check_held(&self, joint: &JointSpec, frames: &[FrameMotion]) -> Result<(), ModelError> {
        let spec = &self.bodies[joint.body].spec;
        let node = if joint.at_end { spec.count } else { 0 };
        let [position, velocity] = self.parts.initial(joint.body, arclength(spec, node));
        let straight = spec.line.at(if joint.at_end { 1.0 } else { 0.0 });
        let held = Held {
            kind: joint.kind,
            data: joint_data(joint, spec, frames),
            length: spec.line.length(),
        };
        let own = &frames[spec.frame];
        let other = &frames[joint.frame];
        let is_own = joint.frame == spec.frame;
        let here = position.unwrap_or([straight.0, straight.1]);
        let seen = |q: [Vector; 2], v: [Vector; 2]| if is_own { (q, v) } else { seen_in(own, other, q, v) };
        let (q, v) = seen(here, velocity.unwrap_or_default());
        let undeformed = [straight.0, straight.1];
        let place = position.and_then(|_| held.misplaced(q, undeformed));
        let rate = velocity.and_then(|_| held.moving(q, v));
        let Some(what) = place.or(rate) else {
            return Ok(());
        };
        let end = if joint.at_end { "end" } else { "start" };
        Err(ModelError::new(format!(
            "the initial shape of body `{}` contradicts joint `{}`: {what}; let the shape at the {end} be what the joint holds there",
            spec.name, joint.name
        )))
    }
}

/// Arclength of a node, m.
fn arclength(spec: &BodySpec, node: usize) -> f64 {
    spec.line.length() * (node as f64 / spec.count as f64)
}

fn check_node(spec: &BodySpec, x: f64, initial: [Option<[Vector; 2]>; 2]) -> Result<(), ModelError> {
    let is_finite = initial
        .iter()
        .flatten()
        .flatten()
        .flatten()
        .all(|value| value.is_finite());
    let has_slope = initial[0].is_none_or(|[_, slope]| norm(slope) > 0.0);
    if is_finite && has_slope {
        return Ok(());
    }
    let what = if is_finite { "has no direction" } else { "is not finite" };
    Err(ModelError::new(format!(
        "the initial shape of body `{}` {what} at x = {x} m: give a smooth shape whose derivative by x is finite and not zero",
        spec.name
    )))
}

/// Position and slope, and their rates, of one frame as seen in another one.
fn seen_in(own: &FrameMotion, other: &FrameMotion, q: [Vector; 2], v: [Vector; 2]) -> ([Vector; 2], [Vector; 2]) {
    let point = subtract(own.point_to_inertial(q[0]), other.position);
    let velocity = add(own.velocity, own.rate_to_inertial(q[0], v[0]));
    let slope = own.direction_to_inertial(q[1]);
    let places = [other.direction_to_frame(point), other.direction_to_frame(slope)];
    let rates = [
        other.rate_to_frame(point, subtract(velocity, other.velocity)),
        other.rate_to_frame(slope, own.rate_to_inertial(q[1], v[1])),
    ];
    (places, rates)
}

/// What a joint holds at t = 0, axes of its frame.
struct Held {
    kind: JointKind,
    data: JointData,
    length: f64,
}

impl Held {
    /// How position and slope differ from what is held, in words.
    fn misplaced(&self, q: [Vector; 2], undeformed: [Vector; 2]) -> Option<String> {
        let gap = norm(subtract(q[0], self.data.point));
        let away =
            || (gap > ROUND_OFF * self.length).then(|| format!("it starts {gap:.3e} m away from the joint's point"));
        match self.kind {
            JointKind::Pin => away(),
            JointKind::Clamp => away().or_else(|| {
                let angle = norm(cross(self.data.tangent, q[1])).atan2(dot(self.data.tangent, q[1]));
                (angle > ROUND_OFF).then(|| format!("its slope starts at {angle:.3e} rad to the joint's direction"))
            }),
            JointKind::ClampFull => away().or_else(|| {
                let gap = norm(subtract(q[1], self.data.tangent));
                (gap > ROUND_OFF).then(|| format!("its slope starts {gap:.3e} away from the joint's"))
            }),
            JointKind::Hold { order, axis } => {
                let (found, wanted) = (q[order][axis], undeformed[order][axis]);
                let size = if order == 0 { self.length } else { 1.0 };
                ((found - wanted).abs() > ROUND_OFF * size)
                    .then(|| format!("what it holds starts at {found:.6e} instead of {wanted:.6e}"))
            }
        }
    }

    /// How fast what is held moves, in words.
    fn moving(&self, q: [Vector; 2], v: [Vector; 2]) -> Option<String> {
        let across = match self.kind {
            JointKind::Hold { order, axis } => v[order][axis].abs(),
            JointKind::Pin => norm(v[0]),
            // The norm of the slope may change.
            JointKind::Clamp => norm(v[0]).max(norm(cross(self.data.tangent, v[1])) / norm(q[1])),
            JointKind::ClampFull => norm(v[0]).max(norm(v[1])),
        };
        let size = 1.0 + norm(v[0]) + norm(v[1]);
        (across > ROUND_OFF * size).then(|| format!("what it holds starts with the rate {across:.3e}"))
    }
}
