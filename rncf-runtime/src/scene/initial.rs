//! Initial shapes: where and how fast bodies start, and whether their joints let them.

use super::mesh_scene::MeshScene;
use crate::emitted::{BodySpec, FrameMotion, Interpolant, JointData, JointKind};
use crate::error::ModelError;
use crate::model::Warning;
use crate::scene::frames::ties::add_rigid;
use crate::scene::numbering::conditions::{directions, joint_data};
use crate::space::Vector;

/// Relative size of a contradiction between an initial shape and a joint that counts as round-off.
const ROUND_OFF: f64 = 1e-10;
/// Distance of a joint's point from the undeformed end, as a part of the body's length, that is not worth telling.
const AWAY: f64 = 1e-6;
/// One plus the cosine of directions that count as opposite.
const OPPOSITE: f64 = 1e-12;
/// Places of an axis at which its initial tangent is compared with the undeformed one, and between which sections are carried along it.
const PLACES: usize = 32;
const CARRIED: usize = 64;

/// Vectors of a place by [`place_of`]: position, slope, section's y and z axes.
type Vectors = [Vector; 4];

/// Place of a vector among [`Vectors`].
fn place_of(of: Interpolant, order: usize) -> usize {
    match of {
        Interpolant::Position => order,
        Interpolant::SectionY => 2,
        Interpolant::SectionZ => 3,
    }
}

impl MeshScene {
    /// Components of all nodal vectors and of their rates at t = 0, in their declared frames: those of starts in
    /// relative equilibrium, else of initial shapes.
    pub(crate) fn initial_shape(&self) -> [Vec<f64>; 2] {
        let (mut q, mut v) = (Vec::new(), Vec::new());
        for (index, body) in self.bodies.iter().enumerate() {
            let spec = &body.spec;
            if let Some(settled) = self.settled.get(index).filter(|settled| !settled.is_empty()) {
                q.extend(settled);
                v.resize(q.len(), 0.0);
                continue;
            }
            let first = q.len();
            for within in 0..spec.vectors() {
                let (node, local) = spec.locate(within);
                let [values, rates] = self.initial_vectors(index, spec.fraction(node, local));
                let place = place_of(spec.nodal[local].of, spec.nodal[local].order);
                q.extend(spec.axes.iter().map(|&axis| values[place][axis]));
                v.extend(spec.axes.iter().map(|&axis| rates[place][axis]));
            }
            for &(_, motion) in self.frames.taken.iter().filter(|(frame, _)| *frame == spec.frame) {
                add_rigid(spec, &q[first..], motion, -1.0, &mut v[first..]);
            }
        }
        self.set_normals([&mut q, &mut v]);
        [q, v]
    }

    /// Vectors of a body and their rates at t = 0 at the fraction `u` of its axis, frame axes. Sections
    /// turn with the tangent by the smallest rotation from its undeformed direction, or where the shape turns by more than a
    /// right angle anywhere, as they are carried along it from its start, and move without shear and without turning about the
    /// tangent.
    pub(crate) fn initial_vectors(&self, body: usize, u: f64) -> [Vectors; 2] {
        let spec = &self.bodies[body].spec;
        let (point, tangent) = spec.line.at(u);
        let [position, velocity] = self.parts.initial(body, spec.line.length() * u);
        let [at, slope] = position.map_or([point, tangent], |given| given.map(Vector::from));
        let [rate, slope_rate] = velocity.unwrap_or_default().map(Vector::from);
        if !spec.has_section() {
            return [
                [at, slope, Vector::zeros(), Vector::zeros()],
                [rate, slope_rate, Vector::zeros(), Vector::zeros()],
            ];
        }
        let section = spec.section(u);
        let axes = match position {
            Some(_) if self.turns_far(body) => self.carried_section(body, u),
            Some(_) => section.map(|axis| turned(axis, tangent, slope, self.normal(body, section[0]))),
            None => section,
        };
        let spin = 1.0 / slope.dot(&slope) * slope.cross(&slope_rate);
        let rates = axes.map(|axis| spin.cross(&axis));
        [[at, slope, axes[0], axes[1]], [rate, slope_rate, rates[0], rates[1]]]
    }

    /// Undeformed and initial place and unit tangent of a body at a fraction of its axis.
    fn axes_at(&self, body: usize, u: f64) -> [[Vector; 2]; 2] {
        let spec = &self.bodies[body].spec;
        let (point, tangent) = spec.line.at(u);
        let [position, _] = self.parts.initial(body, spec.line.length() * u);
        let initial = position.map_or([point, tangent], |given| given.map(Vector::from));
        [[point, tangent], initial].map(|[point, slope]| [point, 1.0 / slope.norm() * slope])
    }

    /// What directions turn about that become opposite: in a plane its normal.
    fn normal(&self, body: usize, in_space: Vector) -> Vector {
        let spec = &self.bodies[body].spec;
        match (0..3).find(|axis| !spec.axes.contains(axis)) {
            Some(normal) => Vector::from_fn(|axis, _| f64::from(u8::from(axis == normal))),
            None => in_space,
        }
    }

    /// Whether an initial tangent in space is turned by more than a right angle somewhere: then the smallest rotation comes near to half a turn, whose axis is
    /// any. In a plane all rotations are about its normal.
    fn turns_far(&self, body: usize) -> bool {
        let is_far = |place: usize| {
            let [[_, tangent], [_, slope]] = self.axes_at(body, place as f64 / PLACES as f64);
            tangent.dot(&slope) < 0.0
        };
        self.bodies[body].spec.dimension() == 3 && (0..=PLACES).any(is_far)
    }

    /// Section axes of an initial shape that are turned about its tangent as the undeformed ones are about theirs, both beside axes
    /// that are carried along from the start without turning about the tangent.
    fn carried_section(&self, body: usize, u: f64) -> [Vector; 2] {
        let spec = &self.bodies[body].spec;
        let begin = spec.section(0.0);
        let [mut undeformed, mut initial] = self.axes_at(body, 0.0);
        let mut beside = begin;
        let mut carried = begin.map(|axis| turned(axis, undeformed[1], initial[1], begin[0]));
        for place in 1..=CARRIED {
            let next = self.axes_at(body, u * place as f64 / CARRIED as f64);
            beside = along(beside, undeformed, next[0]);
            carried = along(carried, initial, next[1]);
            [undeformed, initial] = next;
        }
        spec.section(u).map(|axis| {
            let parts = beside.map(|other| axis.dot(&other));
            parts[0] * carried[0] + parts[1] * carried[1] + axis.dot(&undeformed[1]) * initial[1]
        })
    }

    /// Refuses initial shapes that are not finite, without direction, or elsewhere than where a joint
    /// holds the body, and joints that hold an end far from where it is undeformed. Comes back with what is to be told of
    /// those that hold it nearby.
    pub(crate) fn check_initial(&self) -> Result<Vec<Warning>, ModelError> {
        for (index, body) in self.bodies.iter().enumerate() {
            for within in 0..body.spec.vectors() {
                let (node, local) = body.spec.locate(within);
                let x = body.spec.line.length() * body.spec.fraction(node, local);
                check_node(
                    &body.spec,
                    x,
                    self.parts
                        .initial(index, x)
                        .map(|given| given.map(|both| both.map(Vector::from))),
                )?;
            }
        }
        let frames = self.motions(0.0);
        let found = (0..self.joints.len()).map(|joint| self.check_held(joint, &frames));
        let found: Result<Vec<Option<Warning>>, ModelError> = found.collect();
        Ok(found?.into_iter().flatten().collect())
    }

    fn check_held(&self, index: usize, frames: &[FrameMotion]) -> Result<Option<Warning>, ModelError> {
        let joint = &self.joints[index];
        let spec = &self.bodies[joint.body].spec;
        let u = if joint.at_end { 1.0 } else { 0.0 };
        let [position, velocity] = self.parts.initial(joint.body, spec.line.length() * u);
        let held = Held {
            kind: joint.kind,
            data: joint_data(joint, spec, frames),
            directions: directions(joint.kind, spec),
            length: spec.line.length(),
        };
        let [q, v] = self.initial_vectors(joint.body, u);
        let (q, v) = if joint.frame == spec.frame {
            (q, v)
        } else {
            seen_in(&frames[spec.frame], &frames[joint.frame], q, v)
        };
        if position.is_none() && joint.point.is_some() {
            return self.check_point(index, in_plane(spec, q[0] - Vector::from(held.data.point)).norm());
        }
        let (point, tangent) = spec.line.at(u);
        let [y, z] = spec.section(u);
        let place = position.and_then(|_| held.misplaced(&q, [point, tangent, y, z]));
        let rate = velocity.and_then(|_| held.moving(&q, &v));
        let Some(what) = place.or(rate) else {
            return Ok(None);
        };
        let end = if joint.at_end { "end" } else { "start" };
        Err(ModelError::new(format!(
            "the initial shape of body `{}` contradicts joint `{}`: {what}; let the shape at the {end} be what the joint holds there",
            spec.label(),
            self.joint_label(index)
        )))
    }

    /// What is said of a joint that holds an end at a distance (m) from where it is undeformed: the element there
    /// starts with this strain.
    fn check_point(&self, index: usize, distance: f64) -> Result<Option<Warning>, ModelError> {
        let joint = &self.joints[index];
        let spec = &self.bodies[joint.body].spec;
        let at = if joint.at_end { spec.count - 1 } else { 0 };
        let (length, element) = (spec.line.length(), spec.element_length(at));
        let end = if joint.at_end { "end" } else { "start" };
        let text = format!(
            "joint `{}` holds the {end} of body `{}` {distance:.3e} m from where it is undeformed",
            self.joint_label(index),
            spec.label()
        );
        if distance > element {
            return Err(ModelError::new(format!(
                "{text}, farther than the element there is long ({element:.3e} m): let `at` be where the end is, move the `line`, or give the body an `initial position` that begins there"
            )));
        }
        let strain = distance / element;
        Ok((distance > AWAY * length).then(|| Warning {
            text: format!(
                "{text}: the element there starts with a strain of {strain:.1e}, and a run with a blow; an `initial position` would spread it"
            ),
            weight: strain,
        }))
    }
}

/// A vector (frame axes) without the part out of the plane of a planar body, which nothing holds.
fn in_plane(spec: &BodySpec, vector: Vector) -> Vector {
    if spec.dimension() == 3 {
        return vector;
    }
    Vector::from_fn(|axis, _| if spec.axes.contains(&axis) { vector[axis] } else { 0.0 })
}

/// Axes across a curve carried from one place and unit tangent of it to the next without turning about the tangent, by two reflections: right to the fourth power
/// of the distance (Wang, Juettler, Zheng and Liu 2008).
fn along(axes: [Vector; 2], from: [Vector; 2], to: [Vector; 2]) -> [Vector; 2] {
    let reflected = |vector: Vector, across: Vector| {
        let square = across.dot(&across);
        if square > 0.0 {
            vector - 2.0 / square * across.dot(&vector) * across
        } else {
            vector
        }
    };
    let chord = to[0] - from[0];
    let turn = to[1] - reflected(from[1], chord);
    axes.map(|axis| reflected(reflected(axis, chord), turn))
}

/// A vector turned by the smallest rotation that takes the direction of the unit vector `from` to that of
/// `to`; opposite directions turn about `about`.
fn turned(vector: Vector, from: Vector, to: Vector, about: Vector) -> Vector {
    let to = 1.0 / to.norm() * to;
    let (axis, cosine) = (from.cross(&to), from.dot(&to));
    if 1.0 + cosine < OPPOSITE {
        return 2.0 * about.dot(&vector) * about - vector;
    }
    let first = axis.cross(&vector);
    vector + first + 1.0 / (1.0 + cosine) * axis.cross(&first)
}

fn check_node(spec: &BodySpec, x: f64, initial: [Option<[Vector; 2]>; 2]) -> Result<(), ModelError> {
    let is_finite = initial
        .iter()
        .flatten()
        .flatten()
        .flatten()
        .all(|value| value.is_finite());
    let has_slope = initial[0].is_none_or(|[_, slope]| slope.norm() > 0.0);
    if is_finite && has_slope {
        return Ok(());
    }
    let what = if is_finite { "has no direction" } else { "is not finite" };
    Err(ModelError::new(format!(
        "the initial shape of body `{}` {what} at x = {x} m: give a smooth shape whose derivative by x is finite and not zero",
        spec.label()
    )))
}

/// Vectors of a place and their rates of one frame as seen in another one.
fn seen_in(own: &FrameMotion, other: &FrameMotion, q: Vectors, v: Vectors) -> (Vectors, Vectors) {
    let point = own.point_to_inertial(q[0]) - other.position;
    let velocity = own.velocity + own.rate_to_inertial(q[0], v[0]);
    let inertial: Vectors = std::array::from_fn(|i| if i == 0 { point } else { own.direction_to_inertial(q[i]) });
    let places = inertial.map(|vector| other.direction_to_frame(vector));
    let rates = std::array::from_fn(|i| {
        let rate = if i == 0 {
            velocity - other.velocity
        } else {
            own.rate_to_inertial(q[i], v[i])
        };
        other.rate_to_frame(inertial[i], rate)
    });
    (places, rates)
}

/// What a joint holds at t = 0, axes of its frame.
struct Held {
    kind: JointKind,
    data: JointData,
    /// What it holds besides the position.
    directions: &'static [(Interpolant, usize)],
    length: f64,
}

impl Held {
    /// Place, name and direction of the vectors that it holds besides the position.
    fn directions(&self) -> impl Iterator<Item = (usize, &'static str, Vector)> {
        const NAMES: [&str; 4] = ["position", "slope", "section's y axis", "section's z axis"];
        let along = [self.data.tangent, self.data.second].map(Vector::from);
        let places = self.directions.iter().map(|&(of, order)| place_of(of, order));
        places.zip(along).map(|(place, along)| (place, NAMES[place], along))
    }

    /// How the vectors differ from what is held, in words.
    fn misplaced(&self, q: &Vectors, undeformed: Vectors) -> Option<String> {
        let gap = (q[0] - Vector::from(self.data.point)).norm();
        let away =
            || (gap > ROUND_OFF * self.length).then(|| format!("it starts {gap:.3e} m away from the joint's point"));
        match self.kind {
            JointKind::Pin => away(),
            JointKind::Clamp => away().or_else(|| {
                self.directions().find_map(|(place, name, along)| {
                    let angle = along.cross(&q[place]).norm().atan2(along.dot(&q[place]));
                    (angle > ROUND_OFF)
                        .then(|| format!("its {name} starts at {angle:.3e} rad to the joint's direction"))
                })
            }),
            JointKind::ClampFull => away().or_else(|| {
                self.directions().find_map(|(place, name, along)| {
                    let gap = (q[place] - along).norm();
                    (gap > ROUND_OFF).then(|| format!("its {name} starts {gap:.3e} away from the joint's"))
                })
            }),
            JointKind::Hold { of, order, axis } => {
                let place = place_of(of, order);
                let (found, wanted) = (q[place][axis], undeformed[place][axis]);
                let size = if place == 0 { self.length } else { 1.0 };
                ((found - wanted).abs() > ROUND_OFF * size)
                    .then(|| format!("what it holds starts at {found:.6e} instead of {wanted:.6e}"))
            }
        }
    }

    /// How fast what is held moves, in words.
    fn moving(&self, q: &Vectors, v: &Vectors) -> Option<String> {
        let most = |rate: &dyn Fn(usize, Vector) -> f64| {
            let rates = self.directions().map(|(place, _, along)| rate(place, along));
            rates.fold(v[0].norm(), f64::max)
        };
        let across = match self.kind {
            JointKind::Hold { of, order, axis } => v[place_of(of, order)][axis].abs(),
            JointKind::Pin => v[0].norm(),
            // The norms may change.
            JointKind::Clamp => most(&|place, along| along.cross(&v[place]).norm() / q[place].norm()),
            JointKind::ClampFull => most(&|place, _| v[place].norm()),
        };
        let size = 1.0 + v[0].norm() + v[1].norm();
        (across > ROUND_OFF * size).then(|| format!("what it holds starts with the rate {across:.3e}"))
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::initial::*;

    #[test]
    fn the_smallest_rotation_takes_one_direction_to_the_other_and_nothing_else() {
        let near = |found: Vector, wanted: Vector| assert!((found - wanted).norm() < 1e-15, "{found:?} {wanted:?}");
        let [x, y, z] = [Vector::x(), Vector::y(), Vector::z()];
        // From x towards z: about -y, whatever the length.
        let along = Vector::new(0.6, 0.0, 0.8);
        let at = |vector| turned(vector, x, 3.0 * along, y);
        near(at(x), along);
        near(at(y), y);
        near(at(z), Vector::new(-0.8, 0.0, 0.6));
        near(turned(z, x, x, y), z);
        // Opposite directions turn about the given axis.
        near(turned(x, x, -2.0 * x, y), Vector::new(-1.0, 0.0, 0.0));
        near(turned(y, x, -2.0 * x, y), y);
        near(turned(z, x, -2.0 * x, y), Vector::new(0.0, 0.0, -1.0));
    }
}
