//! Bushings: springs and dampers between two places along and about the axes of the second one.

use super::spring::Acting;
use crate::check::places::place::Hold;
use crate::check::values::matrix::{Matrix, is_symmetric};
use crate::check::values::quantity::{Nature, Wanted};
use crate::check::values::vector::{Quantity, Vectorial};
use crate::check::{Arguments, Check, Shape, say};
use crate::joints::algebra::{
    self, Vector, add, both, cross, dot, multiply, negate, number, observed, scale, subtract,
};
use crate::joints::{Builder, Tilt};
use crate::model::{Expr as Value, MarkerId};
use crate::parse::tree::Call;
use crate::units::Dimension;

const STIFFNESS: Wanted = Wanted::new("the stiffness of a bushing", [0, 1, -2, 0, 0, 0], "N/m");
const DAMPING: Wanted = Wanted::new("the damping of a bushing", [0, 1, -1, 0, 0, 0], "N*s/m");
const TURNING: Wanted = Wanted::new("the rotational stiffness of a bushing", [2, 1, -2, 0, 0, 0], "N*m/rad");
const FRICTION: Wanted = Wanted::new("the rotational damping of a bushing", [2, 1, -1, 0, 0, 0], "N*m*s/rad");
const COUPLING: Wanted = Wanted::new("the coupling of a bushing", [1, 1, -2, 0, 0, 0], "N/rad");

/// Dimensions of what a bushing exerts.
const FORCE: [i8; 6] = [1, 1, -2, 0, 0, 0];
const MOMENT: [i8; 6] = [2, 1, -2, 0, 0, 0];

const WORDS: [&str; 5] = [
    "stiffness",
    "damping",
    "rotational_stiffness",
    "rotational_damping",
    "coupling",
];
const BUSHING: Shape = Shape {
    positional: 2,
    named: &WORDS,
    required: &[],
    usage: "bushing(shaft.end, inertial.at([1, 0, 0] m), stiffness = [0, 3e6, 3e6] N/m)",
};

/// What a bushing is given: forces by ways and their rates, moments by angles and theirs, and forces by angles.
struct Given {
    stiffness: Option<Matrix>,
    damping: Option<Matrix>,
    turning: Option<Matrix>,
    friction: Option<Matrix>,
    coupling: Option<Matrix>,
}

impl Given {
    fn turns(&self) -> bool {
        [&self.turning, &self.friction, &self.coupling]
            .iter()
            .any(|matrix| matrix.is_some())
    }

    /// Whether anything acts by its angles, not by their rates alone.
    fn has_angles(&self) -> bool {
        self.turning.is_some() || self.coupling.is_some()
    }

    /// The only axis about which angles exert nothing: what turns about it turns freely, and far.
    fn free_axis(&self) -> Option<usize> {
        let is_zero = |value: &Value| matches!(value, Value::Number(number) if *number == 0.0);
        let is_free = |axis: &usize| {
            let by_angle = [&self.turning, &self.coupling].into_iter().flatten();
            let of_angle = self.turning.iter().flat_map(|matrix| &matrix[*axis]);
            by_angle
                .flat_map(|matrix| matrix.iter().map(|row| &row[*axis]))
                .chain(of_angle)
                .all(is_zero)
        };
        let free: Vec<usize> = (0..3).filter(is_free).collect();
        <[usize; 1]>::try_from(free).ok().map(|[axis]| axis)
    }

    /// Whether its forces are the derivative of a potential.
    fn has_potential(&self) -> bool {
        let is_damped = self.damping.is_some() || self.friction.is_some();
        let mut own = [&self.stiffness, &self.turning].into_iter().flatten();
        !is_damped && own.all(is_symmetric)
    }

    /// How much of the force along, or moment about, one axis belongs to a way or angle, and to its rate.
    fn entries(&self, of: &Motion, by: &Motion) -> [Value; 2] {
        let entry = |matrix: &Option<Matrix>, row: usize, column: usize| match matrix {
            Some(matrix) => matrix[row][column].clone(),
            None => number(0.0),
        };
        let (row, column) = (of.axis, by.axis);
        match (of.is_angle, by.is_angle) {
            (false, false) => [&self.stiffness, &self.damping].map(|matrix| entry(matrix, row, column)),
            (true, true) => [&self.turning, &self.friction].map(|matrix| entry(matrix, row, column)),
            (false, true) => [entry(&self.coupling, row, column), number(0.0)],
            (true, false) => [entry(&self.coupling, column, row), number(0.0)],
        }
    }
}

/// A way along an axis of B, or an angle about it.
struct Motion {
    axis: usize,
    is_angle: bool,
    value: Value,
    rate: Value,
    /// Direction of the force or moment that does work on it, inertial axes.
    direction: Vector,
}

impl<'a> Check<'a> {
    /// `bushing(A, B, stiffness = K, ..)`: on A acts `-(K d + C d')` with the components d of A - B in the axes of B. The
    /// opposite acts on B at the place of A, so that both together have no moment, and the power is that of the potential
    /// `d K d / 2`. In the same way a moment acts by the angles of A in B, and a coupling by both. `force` and `moment` are shown as they act on A,
    /// in the axes of B.
    pub(in crate::check) fn bushing(&mut self, call: &'a Call) -> Option<Acting> {
        let arguments = self.arguments(call, &BUSHING)?;
        if arguments.named.is_empty() {
            self.errors.at(call.area, say::BUSHING_OF_NOTHING);
            return None;
        }
        let (a, b) = (
            self.hold_on(arguments.positional[0]),
            self.hold_on(arguments.positional[1]),
        );
        let holds = [a?, b?];
        self.are_two(&holds)?;
        let plane = self.common_plane([&holds[0], &holds[1]]);
        let given = self.bushing_given(&arguments);
        if holds[1].is_line() {
            self.errors.at(holds[1].area, say::BUSHING_AXES);
        }
        let (plane, given) = (plane?, given?);
        let have_axes = holds[1].frame().is_some() || holds[1].is_section();
        if !have_axes || given.turns() && !holds.iter().all(|hold| self.turns_something(hold)) {
            return None;
        }
        let is_free = holds.each_ref().map(|hold| match hold.frame() {
            Some(frame) => self.is_free(frame),
            None => true,
        });
        let parties = [holds[0].party(), holds[1].party()];
        let mut joint = Builder::new(&mut self.model.markers, parties, plane);
        let points = joint.origins();
        let way = joint.between([points[1], points[0]]);
        let mut motions = ways(&mut joint, points, &way);
        let turns = match given.turns() {
            true => [0, 1].map(|party| joint.turn(party)),
            false => [None, joint.turn(1)],
        };
        if given.turns() {
            let tilts = match given.has_angles() {
                true => Tilt::all(&mut joint, given.free_axis()),
                false => Tilt::rates_alone(&mut joint),
            };
            motions.extend(tilts.into_iter().map(|tilt| Motion {
                axis: tilt.axis,
                is_angle: true,
                rate: tilt.rate(turns),
                value: tilt.value,
                direction: tilt.arm,
            }));
        }

        let (mut pull, mut moment) = (algebra::numbers([0.0; 3]), algebra::numbers([0.0; 3]));
        let mut energy = number(0.0);
        let mut shown = [("force", FORCE), ("moment", MOMENT)].map(|(name, dimension)| {
            let vector = Vectorial {
                values: algebra::numbers([0.0; 3]),
                axes: Vec::new(),
                dimension: Dimension::of(dimension),
                nature: Nature::default(),
                frame: None,
            };
            (name, vector)
        });
        for motion in &motions {
            let mut part = number(0.0);
            let mut lost = number(0.0);
            for other in &motions {
                let [stiffness, damping] = given.entries(motion, other);
                part = add(part, multiply(stiffness, other.value.clone()));
                lost = add(lost, multiply(damping, other.rate.clone()));
            }
            energy = add(
                energy,
                multiply(multiply(number(0.5), part.clone()), motion.value.clone()),
            );
            let acting = if motion.is_angle { &mut moment } else { &mut pull };
            let size = add(part, lost);
            *acting = both(acting, &scale(&size, &motion.direction), add);
            let vector = &mut shown[usize::from(motion.is_angle)].1;
            vector.values[motion.axis] = negate(size);
            vector.axes.push(motion.axis);
        }

        if joint.normal.is_none() && given.turns() {
            // What belongs to an angle is a moment about an axis of B while little is turned; what is told is the one that acts.
            for &axis in joint.axes() {
                let along = joint.own_axis(1, axis)[0].clone();
                shown[1].1.values[axis] = negate(dot(&moment, &along));
            }
        }

        let mut forces = vec![(points[0], pull.clone().map(negate))];
        if let (true, Some(turn)) = (is_free[0], turns[0]) {
            forces.push((turn, moment.clone().map(negate)));
        }
        if let (true, Some(turn)) = (is_free[1], turns[1]) {
            // At the place of A.
            forces.push((turn, both(&cross(&way, &pull), &moment, add)));
            forces.push((points[1], pull));
        }
        let shown = shown.into_iter().filter(|(_, vector)| !vector.axes.is_empty());
        Some(Acting {
            forces,
            energy: given.has_potential().then_some(energy),
            shown: shown.map(|(name, vector)| (name, Quantity::Vector(vector))).collect(),
        })
    }

    fn bushing_given(&mut self, arguments: &Arguments<'a>) -> Option<Given> {
        let mut read = |word: &str, wanted: Wanted| match arguments.named.get(word) {
            Some(expr) => self.with_lookups(|check| check.matrix(expr, wanted)).map(Some),
            None => Some(None),
        };
        let (stiffness, damping) = (read(WORDS[0], STIFFNESS), read(WORDS[1], DAMPING));
        let (turning, friction) = (read(WORDS[2], TURNING), read(WORDS[3], FRICTION));
        let coupling = read(WORDS[4], COUPLING);
        Some(Given {
            stiffness: stiffness?,
            damping: damping?,
            turning: turning?,
            friction: friction?,
            coupling: coupling?,
        })
    }

    /// Whether axes turn with a place; otherwise this is said.
    fn turns_something(&mut self, hold: &Hold) -> bool {
        if let Some(frame) = hold.frame() {
            return self.has_orientation(frame, hold.area);
        }
        if hold.is_line() {
            self.errors.at(hold.area, say::BUSHING_ANGLES);
        }
        hold.is_section()
    }
}

/// The ways of A from B along the axes of B; in a plane those in it.
fn ways(joint: &mut Builder, points: [MarkerId; 2], way: &Vector) -> Vec<Motion> {
    let [a, b] = points.map(|point| observed(point, 1, joint.normal));
    let rate = both(&a, &b, subtract);
    let along = joint.axes().iter().map(|&axis| {
        let [direction, moving] = joint.own_axis(1, axis);
        Motion {
            axis,
            is_angle: false,
            value: dot(&direction, way),
            rate: add(dot(&moving, way), dot(&direction, &rate)),
            direction,
        }
    });
    along.collect()
}
