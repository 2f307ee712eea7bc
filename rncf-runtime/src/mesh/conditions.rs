//! Joints: which of their conditions are eliminated and which keep multipliers.

use super::frame::FrameMotion;
use super::layout::VectorKind;
use super::parts::{BodySpec, JointData, JointKind, JointSpec};
use crate::model::Joints;
use crate::vector::{cross, perpendicular};

/// A joint on its node.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Joint.
    pub joint: usize,
    /// Global numbers of the node's position and slope.
    pub position: usize,
    /// Global number of the node's slope.
    pub slope: usize,
    /// Components of position and slope in the full arrays; filled in once they are numbered.
    pub components: Vec<usize>,
    /// Constants in the joint's frame.
    pub data: JointData,
    /// Whether the body's vectors are in the inertial frame.
    pub absolute: bool,
    /// Whether the position is eliminated.
    pub position_eliminated: bool,
    /// What is eliminated of the slope.
    pub slope_kind: VectorKind,
    /// Vector and component that are held at their undeformed value.
    pub held: Option<(usize, usize)>,
    /// Rows of the joint's conditions that keep multipliers.
    pub rows: Vec<usize>,
}

/// Number of condition rows of a joint: position, then direction or slope.
pub fn row_count(kind: JointKind, dimension: usize) -> usize {
    match kind {
        JointKind::Pin => dimension,
        JointKind::Clamp => 2 * dimension - 1,
        JointKind::ClampFull => 2 * dimension,
        JointKind::Hold { .. } => 1,
    }
}

/// Constants of a joint from the undeformed body at t = 0.
pub fn joint_data(joint: &JointSpec, body: &BodySpec, frames: &[FrameMotion]) -> JointData {
    let (point, tangent) = body.line.at(if joint.at_end { 1.0 } else { 0.0 });
    let mut normal = [0.0; 3];
    if let [first, second] = *body.axes {
        normal[3 - first - second] = 1.0;
    }
    let (mut point, mut tangent) = (point, tangent);
    if joint.frame != body.frame {
        let (own, other) = (&frames[body.frame], &frames[joint.frame]);
        point = other.point_to_frame(own.point_to_inertial(point));
        tangent = other.direction_to_frame(own.direction_to_inertial(tangent));
        normal = other.direction_to_frame(own.direction_to_inertial(normal));
    }
    let first = if body.dimension() == 2 {
        cross(normal, tangent)
    } else {
        perpendicular(tangent)
    };
    JointData {
        point: joint.point.unwrap_or(point),
        tangent,
        normals: [first, cross(tangent, first)],
    }
}

/// What a joint does to its node: eliminated where the direction does not turn in the body's frame.
pub fn condition(
    index: usize,
    joint: &JointSpec,
    body: &BodySpec,
    first_vector: usize,
    data: JointData,
    absolute: bool,
    joints: Joints,
) -> Condition {
    let node = first_vector
        + if joint.at_end {
            body.count * body.vectors_per_node
        } else {
            0
        };
    let place = |order: usize| {
        let local = body.orders.iter().position(|&other| other == order).unwrap_or(0);
        node + body.connectivity[local]
    };
    let (position, slope) = (place(0), place(1));
    let dimension = body.dimension();
    let all = row_count(joint.kind, dimension);
    let own_frame = if absolute { 0 } else { body.frame };
    let turns = joint.frame != own_frame;
    let mut held = None;
    let (position_eliminated, slope_kind, rows) = match (joints, joint.kind) {
        (Joints::Multipliers, _) => (false, VectorKind::Free, (0..all).collect()),
        (Joints::Eliminated, JointKind::Pin) => (true, VectorKind::Free, Vec::new()),
        // Held components are those of the body's own frame.
        (Joints::Eliminated, JointKind::Hold { .. }) if own_frame != body.frame => (false, VectorKind::Free, vec![0]),
        (Joints::Eliminated, JointKind::Hold { order, axis }) => {
            let component = body.axes.iter().position(|&other| other == axis);
            held = component.map(|component| (if order == 0 { position } else { slope }, component));
            (false, VectorKind::Free, Vec::new())
        }
        (Joints::Eliminated, JointKind::ClampFull) => (true, VectorKind::Prescribed, Vec::new()),
        (Joints::Eliminated, JointKind::Clamp) if turns => (true, VectorKind::Free, (dimension..all).collect()),
        (Joints::Eliminated, JointKind::Clamp) => {
            let mut direction = [0.0; 3];
            for (component, &axis) in body.axes.iter().enumerate() {
                direction[component] = data.tangent[axis];
            }
            (true, VectorKind::Directed(direction), Vec::new())
        }
    };
    Condition {
        joint: index,
        position,
        slope,
        components: Vec::new(),
        data,
        absolute,
        position_eliminated,
        slope_kind,
        held,
        rows,
    }
}

/// What is unknown of every vector after all conditions: several may share a node.
pub fn vector_kinds(count: usize, conditions: &[Condition]) -> Vec<VectorKind> {
    let mut kinds = vec![VectorKind::Free; count];
    for condition in conditions {
        if condition.position_eliminated {
            kinds[condition.position] = VectorKind::Prescribed;
        }
        if condition.slope_kind != VectorKind::Free {
            kinds[condition.slope] = condition.slope_kind;
        }
    }
    for &(vector, component) in conditions.iter().filter_map(|condition| condition.held.as_ref()) {
        kinds[vector] = match kinds[vector] {
            VectorKind::Free => VectorKind::Held(std::array::from_fn(|i| i == component)),
            VectorKind::Held(held) => VectorKind::Held(std::array::from_fn(|i| held[i] || i == component)),
            // The norm is held through a component; a component across the direction is zero anyway.
            VectorKind::Directed(direction) if direction[component] != 0.0 => VectorKind::Held([true; 3]),
            kind => kind,
        };
    }
    kinds
}
