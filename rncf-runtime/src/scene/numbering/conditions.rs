//! Joints: which of their conditions are eliminated and which keep multipliers.

use super::layout::VectorKind;
use crate::emitted::{BodySpec, FrameMotion, Interpolant, JointData, JointKind, JointSpec};
use crate::model::Joints;
use crate::space::{Vector, perpendicular};

/// A joint on its node.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Joint.
    pub joint: usize,
    /// Global numbers of the node's position, then of its slope or of its section's axes.
    pub vectors: Vec<usize>,
    /// Their components in the full arrays; filled in once they are numbered.
    pub components: Vec<usize>,
    /// Constants in the joint's frame.
    pub data: JointData,
    /// Whether the body's vectors are in the inertial frame.
    pub absolute: bool,
    /// Whether the position is eliminated.
    pub position_eliminated: bool,
    /// What is eliminated of the vectors after the position.
    pub kinds: Vec<VectorKind>,
    /// Vector and component that are held at their undeformed value.
    pub held: Option<(usize, usize)>,
    /// Rows of the joint's conditions that keep multipliers.
    pub rows: Vec<usize>,
}

impl Condition {
    /// Whether it prescribes directions with their norms.
    pub fn prescribes_directions(&self) -> bool {
        self.kinds.contains(&VectorKind::Prescribed)
    }
}

/// What a joint's conditions are about besides the position: the slope, or the section's axes.
pub fn directions(kind: JointKind, body: &BodySpec) -> &'static [(Interpolant, usize)] {
    const SLOPE: &[(Interpolant, usize)] = &[(Interpolant::Position, 1)];
    const AXES: &[(Interpolant, usize)] = &[(Interpolant::SectionY, 0), (Interpolant::SectionZ, 0)];
    let holds_slope = matches!(
        kind,
        JointKind::Hold {
            of: Interpolant::Position,
            order: 1,
            ..
        }
    );
    if holds_slope || !body.has_section() {
        SLOPE
    } else {
        &AXES[..body.dimension() - 1]
    }
}

/// Components of the vectors of a node that a joint's conditions are about.
pub fn width(kind: JointKind, body: &BodySpec) -> usize {
    (1 + directions(kind, body).len()) * body.dimension()
}

/// Number of condition rows of a joint: position, then directions or whole vectors, one after the other.
pub fn row_count(kind: JointKind, body: &BodySpec) -> usize {
    let dimension = body.dimension();
    let directions = directions(kind, body).len();
    match kind {
        JointKind::Pin => dimension,
        // All of a section's rotation, or a direction alone.
        JointKind::Clamp if directions > 1 => dimension + 3,
        JointKind::Clamp => dimension + dimension - 1,
        JointKind::ClampFull => dimension + directions * dimension,
        JointKind::Hold { .. } => 1,
    }
}

/// Constants of a joint from the undeformed body at t = 0.
pub fn joint_data(joint: &JointSpec, body: &BodySpec, frames: &[FrameMotion]) -> JointData {
    let u = if joint.at_end { 1.0 } else { 0.0 };
    let (point, tangent) = body.line.at(u);
    let (own, other) = (&frames[body.frame], &frames[joint.frame]);
    let is_own = joint.frame == body.frame;
    let turned = |direction: Vector| {
        if is_own {
            return direction;
        }
        other.direction_to_frame(own.direction_to_inertial(direction))
    };
    let there = if is_own {
        point
    } else {
        other.point_to_frame(own.point_to_inertial(point))
    };
    let normal = body.plane_normal().map(turned);
    let along: Vec<Vector> = match directions(joint.kind, body) {
        [(Interpolant::Position, _)] => vec![turned(tangent)],
        axes => body.section(u)[..axes.len()].iter().map(|&axis| turned(axis)).collect(),
    };
    let across = |direction: Vector| {
        let first = match normal {
            Some(normal) => normal.cross(&direction),
            None => perpendicular(direction),
        };
        [first, direction.cross(&first)]
    };
    JointData {
        point: joint.point.unwrap_or(there.into()),
        tangent: along[0].into(),
        normals: across(along[0]).map(Into::into),
        second: along.get(1).copied().unwrap_or_default().into(),
    }
}

/// What a joint does to its node: eliminated where the directions do not turn in the body's frame.
pub fn condition(
    index: usize,
    joint: &JointSpec,
    body: &BodySpec,
    first_vector: usize,
    data: JointData,
    absolute: bool,
    joints: Joints,
) -> Condition {
    let place = |&(of, order): &(Interpolant, usize)| body.end_vector(joint.at_end, of, order);
    let directions = directions(joint.kind, body);
    let vectors = std::iter::once(&(Interpolant::Position, 0)).chain(directions);
    let vectors: Vec<usize> = vectors.filter_map(place).map(|place| first_vector + place).collect();
    let all = row_count(joint.kind, body);
    let own_frame = if absolute { 0 } else { body.frame };
    let turns = joint.frame != own_frame;
    let alike = |kind: VectorKind| vec![kind; directions.len()];
    let free = || alike(VectorKind::Free);
    let mut held = None;
    let (position_eliminated, kinds, rows) = match (joints, joint.kind) {
        (Joints::Multipliers, _) => (false, free(), (0..all).collect()),
        (Joints::Eliminated, JointKind::Pin) => (true, free(), Vec::new()),
        // Held components are those of the body's own frame.
        (Joints::Eliminated, JointKind::Hold { .. }) if own_frame != body.frame => (false, free(), vec![0]),
        (Joints::Eliminated, JointKind::Hold { of, order, axis }) => {
            let component = body.axes.iter().position(|&other| other == axis);
            let vector = place(&(of, order)).map(|place| first_vector + place);
            held = vector.zip(component);
            (false, free(), Vec::new())
        }
        (Joints::Eliminated, JointKind::ClampFull) => (true, alike(VectorKind::Prescribed), Vec::new()),
        (Joints::Eliminated, JointKind::Clamp) if turns => (true, free(), (body.dimension()..all).collect()),
        (Joints::Eliminated, JointKind::Clamp) => {
            let mut along = [Vector::zeros(); 2];
            for (along, direction) in along.iter_mut().zip([data.tangent, data.second]) {
                for (component, &axis) in body.axes.iter().enumerate() {
                    along[component] = direction[axis];
                }
            }
            let [y, z] = along;
            let kinds = match vectors[1..] {
                // The section does not turn, and strains and shears in its plane as it likes.
                [shear, _] => [[y, z], [z, y]]
                    .map(|axes| VectorKind::InPlane { axes, shear })
                    .to_vec(),
                _ => vec![VectorKind::Directed(y)],
            };
            (true, kinds, Vec::new())
        }
    };
    Condition {
        joint: index,
        vectors,
        components: Vec::new(),
        data,
        absolute,
        position_eliminated,
        kinds,
        held,
        rows,
    }
}

/// What is unknown of every vector after all conditions: several may share a node.
pub fn vector_kinds(count: usize, conditions: &[Condition]) -> Vec<VectorKind> {
    let mut kinds = vec![VectorKind::Free; count];
    for condition in conditions {
        if condition.position_eliminated {
            kinds[condition.vectors[0]] = VectorKind::Prescribed;
        }
        for (&vector, &kind) in condition.vectors[1..].iter().zip(&condition.kinds) {
            if kind != VectorKind::Free {
                kinds[vector] = kind;
            }
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
