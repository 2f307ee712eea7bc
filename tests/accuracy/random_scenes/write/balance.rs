//! What acts on all that moves from outside: the rates of momentum and of angular momentum about the inertial origin.

use super::*;

impl Writer<'_> {
    /// Momentum and angular momentum, with what changes them: reactions of the ground, springs on it, loads and gravity.
    /// Where one of these is no output, nothing is observed.
    pub(super) fn observe_balance(&mut self) {
        let mut forces: Vec<(String, Option<String>)> = Vec::new();
        let mut moments: Vec<String> = Vec::new();
        for index in 0..self.tree.joints.len() {
            if !self.reaction(index, &mut forces, &mut moments) {
                return;
            }
        }
        for index in 0..self.tree.springs.len() {
            self.held_by_spring(index, &mut forces);
        }
        for index in 0..self.tree.loads.len() {
            self.loaded(index, &mut forces, &mut moments);
        }
        if let Some(gravity) = self.tree.gravity {
            let g = self.polar(gravity, "m/s^2");
            forces.push((format!("total.mass * {g}"), Some("total.center_of_mass".to_string())));
        }
        if forces.is_empty() {
            let none = self.components([0.0; 3], "N");
            forces.push((none, None));
        }
        let sum: Vec<&str> = forces.iter().map(|(force, _)| force.as_str()).collect();
        let rate = self.output(
            "force on all".to_string(),
            sum.join(" + "),
            Nature::Polar,
            Quantity::Force,
            None,
        );
        self.output(
            "momentum".to_string(),
            "total.momentum".to_string(),
            Nature::Polar,
            Quantity::Momentum,
            Some(rate),
        );
        for (force, at) in &forces {
            if let Some(at) = at {
                moments.push(self.normal(&format!("cross({at}, {force})")));
            }
        }
        if moments.is_empty() {
            return;
        }
        let nature = if self.tree.plane { Nature::Odd } else { Nature::Axial };
        let text = moments.join(" + ");
        let rate = self.output("moment on all".to_string(), text, nature, Quantity::Moment, None);
        let text = self.normal("total.angular_momentum");
        self.output(
            "angular momentum".to_string(),
            text,
            nature,
            Quantity::AngularMomentum,
            Some(rate),
        );
    }

    /// In a plane the component of a moment along its normal.
    fn normal(&self, moment: &str) -> String {
        match self.plane {
            None => moment.to_string(),
            Some(("xy", _)) => format!("{moment}.z"),
            Some(("yz", _)) => format!("{moment}.x"),
            Some(_) => format!("{moment}.y"),
        }
    }

    /// Whether a place is on what moves as prescribed.
    fn is_ground(&self, place: Place) -> bool {
        match place {
            Place::Ground(_) => true,
            Place::Frame(frame, _) => {
                matches!(
                    self.tree.frames[frame].kind,
                    Kind::Rotating { .. } | Kind::Moving { .. }
                )
            }
            Place::Body(..) => false,
        }
    }

    /// Whether a joint holds an end of a body in the prescribed frame that it is declared in: conditions, which can be
    /// eliminated.
    fn is_condition(&self, joint: &Joint) -> bool {
        let (a, b) = (joint.a, joint.b);
        let end = [(a, b), (b, a)]
            .into_iter()
            .any(|(place, other)| matches!(place, Place::Body(_, at) if !is_inner(at)) && self.is_ground(other));
        let word =
            matches!(joint.word, "clamp" | "pin" | "spherical" | "weld") || self.tree.plane && joint.word == "revolute";
        end && word && self.tree.axes_of(a) == self.tree.axes_of(b)
    }

    /// A place in inertial axes.
    fn inertial(&mut self, place: Place) -> String {
        match place {
            Place::Ground(point) => self.polar(point, "m"),
            _ => format!("{}.in(inertial).position", self.place(place)),
        }
    }

    /// Components in the axes of a frame as a vector in inertial axes.
    fn out_of(&self, frame: Option<usize>, vector: &str) -> String {
        let Some(frame) = frame else { return vector.to_string() };
        let name = self.name("f", frame);
        let axes = match self.plane {
            None => "xyz",
            Some((plane, _)) => plane,
        };
        let parts: Vec<String> = axes
            .chars()
            .map(|axis| format!("({vector}).{axis} * {name}.e{axis}"))
            .collect();
        format!("({})", parts.join(" + "))
    }

    /// What a joint to the ground exerts on all that moves; false where that is no output.
    fn reaction(
        &mut self,
        index: usize,
        forces: &mut Vec<(String, Option<String>)>,
        moments: &mut Vec<String>,
    ) -> bool {
        let joint = &self.tree.joints[index];
        let (a, b) = (self.is_ground(joint.a), self.is_ground(joint.b));
        if !a && !b {
            return true;
        }
        let name = self.name("j", index);
        // That of a condition acts on the body, in the axes of its frame; that of other joints on A, in inertial axes.
        let on_body = self.is_condition(joint);
        let sign = if a && !on_body { "-" } else { "" };
        let at = joint.a;
        let frame = if on_body {
            self.tree.axes_of(joint.a).or(self.tree.axes_of(joint.b))
        } else {
            None
        };
        // In a plane a moment has one component in all axes.
        let on = |what: &str| match (what, self.tree.plane) {
            ("moment", true) => format!("{sign}{name}.moment"),
            _ => format!("{sign}({})", self.out_of(frame, &format!("{name}.{what}"))),
        };
        let force = on("force");
        let turns_freely =
            matches!(joint.word, "pin" | "spherical" | "distance") || self.tree.plane && joint.word == "revolute";
        let moment = (!turns_freely).then(|| on("moment"));
        if joint.coil.is_some() {
            return false;
        }
        let drive = joint
            .drive
            .map(|_| on("moment").replacen(&name, &format!("{name}_drive"), 1));
        let at = self.inertial(at);
        forces.push((force, Some(at)));
        for moment in [moment, drive].into_iter().flatten() {
            moments.push(self.normal(&moment));
        }
        true
    }

    fn held_by_spring(&mut self, index: usize, forces: &mut Vec<(String, Option<String>)>) {
        let spring = self.tree.springs[index].clone();
        let (Spring::Linear { a, b, .. } | Spring::Law { a, b, .. } | Spring::Bushing { a, b, .. }) = spring;
        let (first, second) = (self.is_ground(a), self.is_ground(b));
        if first == second {
            return;
        }
        let sign = if first { "-" } else { "" };
        let (at, other) = (self.inertial(a), self.inertial(b));
        let way = format!("({other} - {at})");
        let velocity = |writer: &mut Self, place: Place| match place {
            Place::Ground(_) => None,
            _ => Some(format!("{}.in(inertial).velocity", writer.place(place))),
        };
        let pull = match spring {
            Spring::Bushing {
                a,
                b,
                stiffness,
                damping,
            } => {
                let frame = self.tree.axes_of(b);
                let (k, c) = (self.number(stiffness, "N/m"), self.number(damping, "N*s/m"));
                let (place, center, of) = (self.place(a), self.point(frame, self.tree.point(b)), self.frame(frame));
                let local = format!("{k} * ({center} - {place}.in({of}).position) - {c} * {place}.in({of}).velocity");
                let force = self.out_of(frame, &local);
                forces.push((format!("{sign}({force})"), Some(at)));
                return;
            }
            Spring::Law { cubic, length, .. } => {
                let (cubic, rest) = (self.number(cubic, "N/m^3"), self.number(length, "m"));
                format!("{cubic} * (norm({way}) - {rest})^3")
            }
            Spring::Linear {
                stiffness,
                damping,
                length,
                ..
            } => {
                let (k, c) = (self.number(stiffness, "N/m"), self.number(damping, "N*s/m"));
                let rest = self.number(length, "m");
                let rate = match (velocity(self, a), velocity(self, b)) {
                    (Some(a), Some(b)) => format!("({b} - {a})"),
                    (None, Some(b)) => b,
                    (Some(a), None) => format!("(-({a}))"),
                    (None, None) => unreachable!("one of them moves"),
                };
                format!("({k} * (norm({way}) - {rest}) + {c} * dot({rate}, {way}) / norm({way}))")
            }
        };
        forces.push((format!("{sign}({pull} * {way} / norm({way}))"), Some(at)));
    }

    fn loaded(&mut self, index: usize, forces: &mut Vec<(String, Option<String>)>, moments: &mut Vec<String>) {
        match self.tree.loads[index].clone() {
            Load::Force { at, force, rate, axes } => {
                let local = clean(self.tree.pose(axes).turned_back(force));
                let force = self.varying(turned(&self.copy.matrix, local), rate, "N");
                let force = self.out_of(axes, &force);
                let at = self.inertial(at);
                forces.push((force, Some(at)));
            }
            Load::Moment { moment, rate, .. } => {
                let moment = scaled(turned(&self.copy.matrix, moment), self.copy.parity);
                let moment = self.varying(moment, rate, "N*m");
                moments.push(self.normal(&moment));
            }
            Load::Follower { at, force } => {
                let slope = format!("{}.in(inertial).slope", self.place(at));
                let force = self.number(force, "N");
                let at = self.inertial(at);
                forces.push((format!("{force} * {slope} / norm({slope})"), Some(at)));
            }
            Load::Density { body, force } => {
                let frame = self.tree.bodies[body].frame;
                let local = clean(self.tree.pose(frame).turned_back(force));
                let length = self.tree.bodies[body].length;
                let cut = self.cut(body).map(|(_, at)| at);
                let name = self.name("b", body);
                let parts = match cut {
                    None => vec![(name, length)],
                    Some(at) => vec![(name.clone(), at * length), (format!("{name}_2"), (1.0 - at) * length)],
                };
                for (name, length) in parts {
                    let (force, length) = (self.polar(local, "N/m"), self.number(length, "m"));
                    let force = self.out_of(frame, &force);
                    forces.push((format!("{length} * {force}"), Some(format!("{name}.center_of_mass"))));
                }
            }
        }
    }
}
