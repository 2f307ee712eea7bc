//! Markers at a state: values, time derivatives, and how they depend on the unknowns.

use super::triad::{Axes, Triad, turning};
use crate::emitted::FrameMotion;
use crate::scene::bodies::place::{MeshPoint, PlaceVector};
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::Marker;
use crate::space::Vector;

/// What one component of the full arrays does to a marker. All are linear in the component's change.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Column {
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
    /// Axis of a nodal vector's component, and its weights in the axes of the section that the marker follows.
    axis: usize,
    weights: [f64; 2],
}

/// What the rotation of a section adds to the second derivatives of a marker that follows it, under one force: by
/// components of the section's axes.
pub(crate) struct Curvature([[f64; 6]; 6]);

impl Curvature {
    /// For two columns of the marker.
    fn between(&self, i: &Column, j: &Column) -> f64 {
        let mut sum = 0.0;
        for (first, a) in i.weights.into_iter().enumerate() {
            for (second, b) in j.weights.into_iter().enumerate() {
                sum += a * b * self.0[3 * first + i.axis][3 * second + j.axis];
            }
        }
        sum
    }
}

impl Column {
    /// `d(J_i . f)/dx_j` at a constant force with the components `force` in frame axes: what the
    /// change of the marker's derivative adds to the stiffness (THEORY 2.2).
    pub fn second(&self, other: &Self, force: Vector, curvature: Option<&Curvature>) -> f64 {
        let turned = other.turn.cross(&self.turned) + self.turn.cross(&other.within);
        force.dot(&turned) + curvature.map_or(0.0, |curvature| curvature.between(self, other))
    }

    /// Rotation of the frame, frame axes.
    pub fn turn(&self) -> Vector {
        self.turn
    }
}

/// The first N time derivatives, in inertial axes, of a vector given in a frame with its derivatives there; the others are zero.
fn turned<const N: usize>(frame: &FrameMotion, within: [Vector; 4]) -> [Vector; 4] {
    const BINOMIAL: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 1.0]];
    let spins = [frame.spin, frame.spin_rate, frame.spin_jerk];
    let mut jet = within;
    let mut result = [Vector::zeros(); 4];
    result[0] = frame.rotation * within[0];
    for order in 1..N {
        // u' + w x u and as many of its derivatives as are needed
        let mut next = [Vector::zeros(); 4];
        for (derivative, value) in next.iter_mut().enumerate().take(N - order) {
            *value = jet[derivative + 1];
            for (part, spin) in spins.iter().enumerate().take(derivative + 1) {
                let product = spin.cross(&jet[derivative - part]);
                *value = Vector::from_fn(|i, _| value[i] + BINOMIAL[derivative][part] * product[i]);
            }
        }
        jet = next;
        result[order] = frame.rotation * jet[0];
    }
    result
}

impl MeshScene {
    /// Frame that a marker's vectors live in.
    pub(crate) fn marker_frame(&self, marker: &Marker) -> usize {
        match marker {
            Marker::Fixed { frame, .. } | Marker::Turn { frame } => *frame,
            Marker::Body { point, .. } | Marker::Section { point, .. } | Marker::SectionTurn { point } => {
                self.bodies[point.body].frame
            }
            Marker::Angle { free } => self.frames.free[*free].spec.frame,
        }
    }

    /// Vector of a marker in its frame, with derivatives there.
    pub(crate) fn within(&self, marker: &Marker) -> [Vector; 4] {
        self.within_to::<4>(marker)
    }

    /// The first N of these, and more where they come along; those left out are zero.
    fn within_to<const N: usize>(&self, marker: &Marker) -> [Vector; 4] {
        match marker {
            Marker::Fixed { at, .. } => [*at, Vector::zeros(), Vector::zeros(), Vector::zeros()],
            Marker::Body { point, of } => self.on_body::<N>(point, *of),
            Marker::Section { point, along, is_point } => {
                let mut jet = if N == 1 {
                    let direction = self.triad(point).direction(*along);
                    [direction, Vector::zeros(), Vector::zeros(), Vector::zeros()]
                } else {
                    let (triad, spins) = self.section_motion(point);
                    turning(triad.direction(*along), &spins)
                };
                if *is_point {
                    let axis = self.on_body::<N>(point, PlaceVector::Position);
                    jet.iter_mut().zip(axis).for_each(|(value, axis)| *value += axis);
                }
                jet
            }
            Marker::SectionTurn { point } => {
                let (_, [spin, rate, jerk]) = self.section_motion(point);
                [Vector::zeros(), spin, rate, jerk]
            }
            Marker::Turn { .. } | Marker::Angle { .. } => [Vector::zeros(); 4],
        }
    }

    /// The first N of a nodal vector, or of a position, at a place on a body.
    fn on_body<const N: usize>(&self, point: &MeshPoint, of: PlaceVector) -> [Vector; 4] {
        let buffers = &self.buffers;
        let full = [&buffers.q, &buffers.v, &buffers.a, &buffers.jerks];
        let mut jet = [Vector::zeros(); 4];
        for (value, full) in jet.iter_mut().zip(full).take(N) {
            *value = self.at_point(point, of, full);
        }
        if of == PlaceVector::Position {
            jet[0] += self.bodies[point.body].offset;
        }
        jet
    }

    /// The axes of a section in one of the full arrays, frame axes.
    fn section_axes(&self, point: &MeshPoint, full: &[f64]) -> Axes {
        let mut axes = [Vector::zeros(); 2];
        let vectors = PlaceVector::section(self.bodies[point.body].spec.dimension());
        for (axis, &of) in axes.iter_mut().zip(vectors) {
            *axis = self.at_point(point, of, full);
        }
        axes
    }

    /// The rotation of a section at the loaded state, frame axes.
    pub(super) fn triad(&self, point: &MeshPoint) -> Triad {
        let plane = self.bodies[point.body].spec.plane_normal();
        Triad::new(self.section_axes(point, &self.buffers.q), plane)
    }

    /// The direction with these components in the triad of a section at the loaded state, frame axes.
    pub(crate) fn direction_in_section(&self, point: &MeshPoint, along: Vector) -> Vector {
        self.triad(point).direction(along)
    }

    /// Forces on the axes of a section that do the work of a moment (frame axes) on its turning.
    pub(crate) fn on_section_axes(&self, point: &MeshPoint, moment: Vector) -> Vec<(PlaceVector, Vector)> {
        let triad = self.triad(point);
        let vectors = PlaceVector::section(self.bodies[point.body].spec.dimension());
        let force = |axis: usize| {
            Vector::from_fn(|component, _| {
                let mut change = [Vector::zeros(); 2];
                change[axis][component] = 1.0;
                moment.dot(&triad.turn(change))
            })
        };
        vectors
            .iter()
            .enumerate()
            .map(|(axis, &of)| (of, force(axis)))
            .collect()
    }

    /// The same, and its angular velocity in the frame with two derivatives.
    fn section_motion(&self, point: &MeshPoint) -> (Triad, [Vector; 3]) {
        let buffers = &self.buffers;
        let orders = [&buffers.q, &buffers.v, &buffers.a, &buffers.jerks].map(|full| self.section_axes(point, full));
        let triad = self.triad(point);
        let spins = triad.spins([0, 1].map(|axis| orders.map(|order| order[axis])));
        (triad, spins)
    }

    /// What the rotation of a section adds to the second derivatives of a marker under a force (frame axes).
    pub(crate) fn curvature(&self, marker: &Marker, force: Vector) -> Option<Curvature> {
        let (point, along) = match marker {
            Marker::Section { point, along, .. } => (point, Some(*along)),
            Marker::SectionTurn { point } => (point, None),
            _ => return None,
        };
        let triad = self.triad(point);
        let along = along.map(|along| triad.direction(along));
        let unit: [Axes; 6] = std::array::from_fn(|entry| {
            let mut change = [Vector::zeros(); 2];
            change[entry / 3][entry % 3] = 1.0;
            change
        });
        let turns = unit.map(|change| triad.turn(change));
        // A force on a direction is a moment on the section.
        let moment = along.map_or(force, |along| along.cross(&force));
        let entry = |i: usize, j: usize| {
            let turned = along.map_or(0.0, |along| force.dot(&turns[i].cross(&turns[j].cross(&along))));
            moment.dot(&triad.second(unit[i], unit[j])) + turned
        };
        Some(Curvature(std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))))
    }

    /// Value, velocity, acceleration and jerk of a marker at the loaded state, inertial axes; the
    /// jerk is that without the jerk of the unknowns.
    pub(crate) fn jet(&self, marker: &Marker) -> [Vector; 4] {
        self.jet_from(marker, None)
    }

    /// Position of a frame's origin and its derivatives, inertial axes, from the uniformly moving point that the positions
    /// of the free frame `anchor` count from: no digits are lost far from the origin.
    fn origin_from(&self, frame: usize, anchor: Option<usize>) -> [Vector; 4] {
        let motion = &self.buffers.frames[frame];
        let [mut position, mut velocity] = [motion.position, motion.velocity];
        if let Some(anchor) = anchor {
            let (base, t) = (&self.frames.free[anchor], self.buffers.t);
            [position, velocity] = match self.frames.free_of[frame].map(|free| &self.frames.free[free]) {
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
        self.jet_to::<4>(marker, anchor)
    }

    /// The first N of these, with the same bits: constraints ask for values far more often than for accelerations.
    pub(super) fn jet_to<const N: usize>(&self, marker: &Marker, anchor: Option<usize>) -> [Vector; 4] {
        let frame = &self.buffers.frames[self.marker_frame(marker)];
        match marker {
            Marker::Turn { .. } | Marker::SectionTurn { .. } if N == 1 => [Vector::zeros(); 4],
            Marker::Turn { .. } | Marker::SectionTurn { .. } => {
                let [_, spin, rate, jerk] = self.within(marker);
                let rates = [
                    frame.spin + spin,
                    frame.spin_rate + rate,
                    frame.spin_jerk + jerk,
                    Vector::zeros(),
                ];
                let [first, second, third, _] = turned::<3>(frame, rates);
                [Vector::zeros(), first, second, third]
            }
            Marker::Angle { free } => {
                let buffers = &self.buffers;
                let component = self.angle_component(*free);
                [&buffers.q, &buffers.v, &buffers.a, &buffers.jerks].map(|full| Vector::new(full[component], 0.0, 0.0))
            }
            _ => {
                let mut jet = turned::<N>(frame, self.within_to::<N>(marker));
                if marker.is_point() {
                    let origin = self.origin_from(self.marker_frame(marker), anchor);
                    for (value, origin) in jet.iter_mut().zip(origin).take(N) {
                        *value += origin;
                    }
                }
                jet
            }
        }
    }

    /// Component of the angle of a free frame; frames without one are refused when markers are made.
    fn angle_component(&self, free: usize) -> usize {
        let frame = &self.frames.free[free];
        self.layout.vector_components() + frame.first + frame.angle().unwrap_or(0)
    }

    /// Components that a marker depends on, at any state.
    pub(crate) fn marker_components(&self, marker: &Marker) -> Vec<usize> {
        if let Marker::Angle { free } = marker {
            return vec![self.angle_component(*free)];
        }
        let mut components = Vec::new();
        if let Some(free) = self.frames.free_of[self.marker_frame(marker)] {
            let first = self.layout.vector_components() + self.frames.free[free].first;
            components.extend(first..first + self.frames.free[free].count());
        }
        if let Marker::Body { point, .. } | Marker::Section { point, .. } | Marker::SectionTurn { point } = marker {
            components.extend(self.bodies[point.body].connectivity.element(point.element));
        }
        components
    }

    /// How a marker depends on the unknowns at the loaded state.
    pub(crate) fn columns(&self, marker: &Marker) -> Vec<Column> {
        let mut columns = Vec::new();
        self.each_column(marker, |column| columns.push(column));
        columns
    }

    /// Calls with each of these; what the call does not read is not computed where it is compiled into this.
    #[inline]
    pub(super) fn each_column(&self, marker: &Marker, mut call: impl FnMut(Column)) {
        if let Marker::Angle { free } = marker {
            return call(Column {
                component: self.angle_component(*free),
                value: Vector::x(),
                ..Column::default()
            });
        }
        let at = self.marker_frame(marker);
        let frame = &self.buffers.frames[at];
        let [p, rate, ..] = self.within_to::<2>(marker);
        let is_turn = matches!(marker, Marker::Turn { .. } | Marker::SectionTurn { .. });
        let velocity = if is_turn {
            frame.spin + rate
        } else {
            rate + frame.spin.cross(&p)
        };
        if let Some(free) = self.frames.free_of[at] {
            let first = self.layout.vector_components() + self.frames.free[free].first;
            for (place, direction) in self.frames.free[free].directions.iter().enumerate() {
                let turn = direction.turn;
                let turned = if is_turn { turn } else { turn.cross(&p) };
                let mut value = frame.rotation * turned;
                if marker.is_point() {
                    value += direction.shift;
                }
                call(Column {
                    component: first + place,
                    value,
                    rate: frame.rotation * turn.cross(&velocity),
                    turn,
                    turned,
                    ..Column::default()
                });
            }
        }
        match marker {
            Marker::Body { point, of } => self.body_columns(point, *of, call),
            Marker::Section {
                point, is_point: true, ..
            } => {
                // The vectors of the axis are others than those of the section.
                self.body_columns(point, PlaceVector::Position, &mut call);
                let [axis, ..] = self.on_body::<1>(point, PlaceVector::Position);
                self.section_columns(point, false, p - axis).into_iter().for_each(call);
            }
            Marker::Section { point, .. } | Marker::SectionTurn { point } => {
                self.section_columns(point, is_turn, p).into_iter().for_each(call);
            }
            _ => {}
        }
    }

    /// How a vector at a place on a body depends on nodal vectors.
    #[inline]
    fn body_columns(&self, point: &MeshPoint, of: PlaceVector, mut call: impl FnMut(Column)) {
        let body = &self.bodies[point.body];
        let frame = &self.buffers.frames[body.frame];
        let weights = point.weights(of);
        let dimension = body.spec.dimension();
        for (place, &component) in body.connectivity.element(point.element).iter().enumerate() {
            let weight = weights[place / dimension];
            if weight == 0.0 {
                continue;
            }
            let mut within = Vector::zeros();
            within[body.spec.axes[place % dimension]] = weight;
            call(Column {
                component,
                value: frame.rotation * within,
                rate: frame.rotation * frame.spin.cross(&within),
                within,
                turned: within,
                ..Column::default()
            });
        }
    }

    /// How a direction that follows a section (frame axes), or the turning of the section, depends on nodal vectors.
    fn section_columns(&self, point: &MeshPoint, is_turn: bool, direction: Vector) -> Vec<Column> {
        let body = &self.bodies[point.body];
        let frame = &self.buffers.frames[body.frame];
        let dimension = body.spec.dimension();
        let triad = self.triad(point);
        let velocity = self.section_axes(point, &self.buffers.v);
        let spin = triad.turn(velocity);
        let mut columns = Vec::new();
        for (place, &component) in body.connectivity.element(point.element).iter().enumerate() {
            let mut weights = [0.0; 2];
            for (weight, &of) in weights.iter_mut().zip(PlaceVector::section(dimension)) {
                *weight = point.weights(of)[place / dimension];
            }
            if weights == [0.0; 2] {
                continue;
            }
            let axis = body.spec.axes[place % dimension];
            let change = weights.map(|weight| Vector::ith(axis, weight));
            let (turn, faster) = (triad.turn(change), triad.second(velocity, change));
            let (value, rate, within) = if is_turn {
                (turn, faster, Vector::zeros())
            } else {
                let within = turn.cross(&direction);
                let rate = faster.cross(&direction) + (spin + frame.spin).cross(&within);
                (within, rate, within)
            };
            columns.push(Column {
                component,
                value: frame.rotation * value,
                rate: frame.rotation * rate,
                within,
                turned: value,
                axis,
                weights,
                ..Column::default()
            });
        }
        columns
    }
}
