//! Bushings: springs and dampers between two points along the axes of the second one's frame.

use super::expr::Scope;
use super::quantity::Wanted;
use super::spring::Acting;
use super::{Check, Shape, fold, say};
use crate::joints::Builder;
use crate::joints::algebra::{self, add, both, cross, dot, multiply, negate, number, observed, scale, subtract};
use crate::model::{Expr as Value, FrameId, Marker, MarkerId};
use crate::parse::tree::{Call, Expr};

const STIFFNESS: Wanted = Wanted {
    what: "the stiffness of a bushing",
    dimension: [0, 1, -2, 0, 0, 0],
    unit: "N/m",
};
const DAMPING: Wanted = Wanted {
    what: "the damping of a bushing",
    dimension: [0, 1, -1, 0, 0, 0],
    unit: "N*s/m",
};
const BUSHING: Shape = Shape {
    positional: 2,
    named: &["stiffness", "damping"],
    required: &["stiffness"],
    usage: "bushing(shaft.end, inertial.at([1, 0, 0] m), stiffness = [0, 3e6, 3e6] N/m)",
};

impl<'a> Check<'a> {
    /// `bushing(A, B, stiffness = [..], damping = [..])`: on A acts `-(k d + c d')` with the components d
    /// of A - B in the axes of B's frame. The opposite acts on B's frame at the place of A, so that both
    /// together have no moment and the power is that of the potential `k d^2 / 2`.
    pub(super) fn bushing(&mut self, call: &'a Call) -> Option<Acting> {
        let arguments = self.arguments(call, &BUSHING)?;
        let (a, b) = (
            self.hold_on(arguments.positional[0]),
            self.hold_on(arguments.positional[1]),
        );
        let holds = [a?, b?];
        self.are_two(&holds)?;
        let plane = self.common_plane([&holds[0], &holds[1]]);
        let stiffness = self.three(arguments.named["stiffness"], STIFFNESS);
        let damping = match arguments.named.get("damping") {
            Some(expr) => self.three(expr, DAMPING).map(Some),
            None => Some(None),
        };
        let Some(frame) = holds[1].frame() else {
            self.errors.at(holds[1].area, say::BUSHING_AXES);
            return None;
        };
        if self.is_point_mass(frame) {
            let name = self.model.frames[frame.0].name.clone();
            self.errors.at(holds[1].area, say::point_mass_turns(&name));
            return None;
        }
        let (plane, stiffness, damping) = (plane?, stiffness?, damping?);
        let parties = [holds[0].party(), holds[1].party()];
        let points = Builder::new(&mut self.model.markers, parties, plane).origins();
        let apart = |order| {
            let [a, b] = points.map(|point| observed(point, order, plane));
            both(&a, &b, subtract)
        };
        let (way, rate) = (apart(0), apart(1));
        let mut pull = algebra::numbers([0.0; 3]);
        let mut energy = number(0.0);
        for axis in (0..3).filter(|axis| Some(*axis) != plane) {
            let along = self.frame_axis(frame, axis, 0, plane);
            let d = dot(&along, &way);
            let mut part = multiply(stiffness[axis].clone(), d.clone());
            energy = add(energy, multiply(multiply(number(0.5), part.clone()), d));
            if let Some(damping) = &damping {
                let turning = self.frame_axis(frame, axis, 1, plane);
                let rate = add(dot(&turning, &way), dot(&along, &rate));
                part = add(part, multiply(damping[axis].clone(), rate));
            }
            pull = both(&pull, &scale(&part, &along), add);
        }
        let mut forces = vec![(points[0], pull.clone().map(negate))];
        forces.extend(self.carried_back(frame, &way, pull, points[1]));
        Some((forces, damping.is_none().then_some(energy)))
    }

    /// The force on B's frame at the place of A, which is `way` from B.
    fn carried_back(
        &mut self,
        frame: FrameId,
        way: &algebra::Vector,
        force: algebra::Vector,
        point: MarkerId,
    ) -> Vec<(MarkerId, algebra::Vector)> {
        if !self.is_free(frame) {
            return Vec::new();
        }
        let turn = self.marker(Marker::Turn { frame });
        vec![(turn, cross(way, &force)), (point, force)]
    }

    /// Three components that are not negative.
    fn three(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<[Value; 3]> {
        let vector = self.vector(expr, Scope::Parameter, wanted)?;
        for (value, area) in vector.values.iter().zip(vector.areas) {
            if fold::constant(value).is_some_and(|value| value < 0.0) {
                self.errors.at(area, say::not_negative(wanted.what));
                return None;
            }
        }
        Some(vector.values)
    }
}
