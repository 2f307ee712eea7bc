//! Markers at a state: values, time derivatives, and how they depend on the unknowns.

use super::super::frame::FrameMotion;
use super::super::scene::{MeshPoint, MeshScene, PlaceVector};
use super::{Linked, Reach};
use crate::vector::{Vector, add, apply, cross, dot};

/// A marker with what it needs at run time.
#[derive(Clone, Debug)]
pub(in super::super) enum Marker {
    /// Fixed in a frame: a point, else a direction.
    Fixed { frame: usize, at: Vector, is_point: bool },
    /// A vector at a place on a body.
    Body { point: MeshPoint, of: PlaceVector },
    /// Numbers that neither change nor depend on anything.
    Constant(Vector),
    /// The turning of a frame.
    Turn { frame: usize },
    /// The angle of a free frame (index among the free ones).
    Angle { free: usize },
}

impl Marker {
    /// Whether it is a point rather than a direction, turning or angle.
    pub fn is_point(&self) -> bool {
        matches!(
            self,
            Self::Fixed { is_point: true, .. }
                | Self::Body {
                    of: PlaceVector::Position,
                    ..
                }
        )
    }
}

/// What one component of the full arrays does to a marker. All are linear in the component's change.
#[derive(Clone, Copy, Debug, Default)]
pub(in super::super) struct Column {
    /// Component in the full arrays, of a nodal vector or a free frame.
    pub component: usize,
    /// Change of the value, inertial axes.
    pub value: Vector,
    /// Change of the velocity at constant rates of the unknowns, inertial axes.
    pub rate: Vector,
    /// Rotation of the frame, frame axes: zero but for rotations.
    turn: Vector,
    /// Change within the frame, frame axes: zero but for nodal vectors.
    within: Vector,
    /// Both together, without the origin: what turns when the frame turns on.
    turned: Vector,
}

impl Column {
    /// `d(J_i . f)/dx_j` at a constant force with the components `force` in frame axes: what the
    /// change of the marker's derivative adds to the stiffness (THEORY 2.2).
    pub fn second(&self, other: &Self, force: Vector) -> f64 {
        dot(
            force,
            add(cross(other.turn, self.turned), cross(self.turn, other.within)),
        )
    }

    /// Rotation of the frame, frame axes.
    pub fn turn(&self) -> Vector {
        self.turn
    }

    /// Whether it turns its frame.
    pub fn turns(&self) -> bool {
        self.turn != [0.0; 3]
    }
}

/// Time derivatives, in inertial axes, of a vector given in a frame with its derivatives there.
fn turned(frame: &FrameMotion, within: [Vector; 4]) -> [Vector; 4] {
    const BINOMIAL: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 1.0]];
    let spins = [frame.spin, frame.spin_rate, frame.spin_jerk];
    let mut jet = within;
    let mut result = [apply(&frame.rotation, within[0]); 4];
    for order in 1..4 {
        // u' + w x u and as many of its derivatives as are needed
        let mut next = [[0.0; 3]; 4];
        for (derivative, value) in next.iter_mut().enumerate().take(4 - order) {
            *value = jet[derivative + 1];
            for (part, spin) in spins.iter().enumerate().take(derivative + 1) {
                let product = cross(*spin, jet[derivative - part]);
                *value = std::array::from_fn(|i| value[i] + BINOMIAL[derivative][part] * product[i]);
            }
        }
        jet = next;
        result[order] = apply(&frame.rotation, jet[0]);
    }
    result
}

impl MeshScene {
    /// Frame that a marker's vectors live in.
    pub(in super::super) fn marker_frame(&self, marker: &Marker) -> usize {
        match marker {
            Marker::Fixed { frame, .. } | Marker::Turn { frame } => *frame,
            Marker::Body { point, .. } => self.bodies[point.body].frame,
            Marker::Angle { free } => self.free[*free].spec.frame,
            Marker::Constant(_) => 0,
        }
    }

    /// Vector of a marker in its frame, with derivatives there.
    pub(super) fn within(&self, marker: &Marker) -> [Vector; 4] {
        match marker {
            Marker::Fixed { at, .. } | Marker::Constant(at) => [*at, [0.0; 3], [0.0; 3], [0.0; 3]],
            Marker::Body { point, of } => {
                let buffers = &self.buffers;
                let full = [&buffers.q, &buffers.v, &buffers.a, &buffers.jerks];
                let mut jet = full.map(|full| self.at_point(point, *of, full));
                if *of == PlaceVector::Position {
                    jet[0] = add(jet[0], self.bodies[point.body].offset);
                }
                jet
            }
            Marker::Turn { .. } | Marker::Angle { .. } => [[0.0; 3]; 4],
        }
    }

    /// Value, velocity, acceleration and jerk of a marker at the loaded state, inertial axes; the
    /// jerk is that without the jerk of the unknowns.
    pub(in super::super) fn jet(&self, marker: &Marker) -> [Vector; 4] {
        self.jet_from(marker, None)
    }

    /// The same of a marker of a constraint: in the axes of its frame where it depends on nothing else, and points
    /// from its anchor.
    pub(in super::super) fn jet_of(&self, linked: &Linked, marker: &Marker) -> [Vector; 4] {
        match linked.reach {
            Reach::Within(_) => self.within(marker),
            Reach::Space | Reach::Differences => self.jet_from(marker, linked.anchor),
        }
    }

    /// How a marker of a constraint depends on the unknowns at the loaded state, in the axes of [`MeshScene::jet_of`].
    pub(in super::super) fn columns_of(&self, linked: &Linked, marker: &Marker) -> Vec<Column> {
        match (linked.reach, marker) {
            (Reach::Within(_), Marker::Body { point, of }) => {
                let mut columns = Vec::new();
                self.add_body_columns(point, *of, &FrameMotion::INERTIAL, &mut columns);
                columns
            }
            (Reach::Within(_), _) => Vec::new(),
            _ => self.columns(marker),
        }
    }

    /// Components that a marker of a constraint depends on, at any state.
    pub(in super::super) fn components_of(&self, linked: &Linked, marker: &Marker) -> Vec<usize> {
        match (linked.reach, marker) {
            (Reach::Within(_), Marker::Body { point, .. }) => {
                self.bodies[point.body].connectivity.element(point.element).to_vec()
            }
            (Reach::Within(_), _) => Vec::new(),
            _ => self.marker_components(marker),
        }
    }

    /// Position of a frame's origin and its derivatives, inertial axes, from the uniformly moving point that the positions
    /// of the free frame `anchor` count from: no digits are lost far from the origin.
    fn origin_from(&self, frame: usize, anchor: Option<usize>) -> [Vector; 4] {
        let motion = &self.buffers.frames[frame];
        let [mut position, mut velocity] = [motion.position, motion.velocity];
        if let Some(anchor) = anchor {
            let (base, t) = (&self.free[anchor], self.buffers.t);
            [position, velocity] = match self.free_of[frame].map(|free| &self.free[free]) {
                Some(free) if free.shifts() > 0 => {
                    let first = self.layout.vector_components() + free.first;
                    let own = first..first + free.count();
                    free.relative(base, t, [&self.buffers.q[own.clone()], &self.buffers.v[own]])
                }
                _ => base.seen(t, position, velocity),
            };
        }
        [position, velocity, motion.acceleration, motion.jerk]
    }

    /// See [`MeshScene::jet`]; points from the anchor.
    pub(super) fn jet_from(&self, marker: &Marker, anchor: Option<usize>) -> [Vector; 4] {
        let frame = &self.buffers.frames[self.marker_frame(marker)];
        match marker {
            Marker::Turn { .. } => {
                let rates = [frame.spin, frame.spin_rate, frame.spin_jerk, [0.0; 3]];
                let [first, second, third, _] = turned(frame, rates);
                [[0.0; 3], first, second, third]
            }
            Marker::Angle { free } => {
                let buffers = &self.buffers;
                let component = self.angle_component(*free);
                [&buffers.q, &buffers.v, &buffers.a, &buffers.jerks].map(|full| [full[component], 0.0, 0.0])
            }
            _ => {
                let mut jet = turned(frame, self.within(marker));
                if marker.is_point() {
                    let origin = self.origin_from(self.marker_frame(marker), anchor);
                    jet = std::array::from_fn(|order| add(jet[order], origin[order]));
                }
                jet
            }
        }
    }

    /// Component of the angle of a free frame; frames without one are refused when markers are made.
    fn angle_component(&self, free: usize) -> usize {
        let frame = &self.free[free];
        self.layout.vector_components() + frame.first + frame.angle().unwrap_or(0)
    }

    /// Components that a marker depends on, at any state.
    pub(in super::super) fn marker_components(&self, marker: &Marker) -> Vec<usize> {
        if let Marker::Angle { free } = marker {
            return vec![self.angle_component(*free)];
        }
        let mut components = Vec::new();
        if let Some(free) = self.free_of[self.marker_frame(marker)] {
            let first = self.layout.vector_components() + self.free[free].first;
            components.extend(first..first + self.free[free].count());
        }
        if let Marker::Body { point, .. } = marker {
            components.extend(self.bodies[point.body].connectivity.element(point.element));
        }
        components
    }

    /// How a marker depends on the unknowns at the loaded state.
    pub(in super::super) fn columns(&self, marker: &Marker) -> Vec<Column> {
        let component = |component: usize, value: Vector| Column {
            component,
            value,
            ..Column::default()
        };
        if let Marker::Angle { free } = marker {
            return vec![component(self.angle_component(*free), [1.0, 0.0, 0.0])];
        }
        let mut columns = Vec::new();
        let at = self.marker_frame(marker);
        let frame = &self.buffers.frames[at];
        let [p, rate, ..] = self.within(marker);
        let velocity = match marker {
            Marker::Turn { .. } => frame.spin,
            _ => add(rate, cross(frame.spin, p)),
        };
        if let Some(free) = self.free_of[at] {
            let first = self.layout.vector_components() + self.free[free].first;
            for (place, direction) in self.free[free].directions.iter().enumerate() {
                let turn = direction.turn;
                let turned = match marker {
                    Marker::Turn { .. } => turn,
                    _ => cross(turn, p),
                };
                let mut value = apply(&frame.rotation, turned);
                if marker.is_point() {
                    value = add(value, direction.shift);
                }
                columns.push(Column {
                    component: first + place,
                    value,
                    rate: apply(&frame.rotation, cross(turn, velocity)),
                    turn,
                    within: [0.0; 3],
                    turned,
                });
            }
        }
        if let Marker::Body { point, of } = marker {
            self.add_body_columns(point, *of, frame, &mut columns);
        }
        columns
    }

    /// Adds what nodal vectors do to a vector of a body in a frame.
    fn add_body_columns(&self, point: &MeshPoint, of: PlaceVector, frame: &FrameMotion, columns: &mut Vec<Column>) {
        let body = &self.bodies[point.body];
        let weights = point.weights(of);
        let dimension = body.spec.dimension();
        for (place, &component) in body.connectivity.element(point.element).iter().enumerate() {
            let mut within = [0.0; 3];
            within[body.spec.axes[place % dimension]] = weights[place / dimension];
            columns.push(Column {
                component,
                value: apply(&frame.rotation, within),
                rate: apply(&frame.rotation, cross(frame.spin, within)),
                turn: [0.0; 3],
                within,
                turned: within,
            });
        }
    }
}
