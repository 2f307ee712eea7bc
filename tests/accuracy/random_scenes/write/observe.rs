//! Outputs of a scene: places and velocities in all frames, section forces, reactions.

use super::*;

impl Writer<'_> {
    pub(super) fn output(
        &mut self,
        of: String,
        text: String,
        nature: Nature,
        quantity: Quantity,
        rate: Option<String>,
    ) -> String {
        let name = format!("o{}", self.outputs.len());
        self.items.push(format!("output {name} = {text};"));
        self.outputs.push(Observed {
            name: name.clone(),
            nature,
            quantity,
            rate,
            of,
        });
        name
    }

    /// Position and velocity of a place in a frame.
    fn seen(&mut self, what: &str, place: &str, frame: Option<usize>) {
        let frame_name = self.frame(frame);
        let of = frame.map_or("inertial".to_string(), |frame| format!("f{frame}"));
        let rate = self.output(
            format!("{what}.velocity in {of}"),
            format!("{place}.in({frame_name}).velocity"),
            Nature::Polar,
            Quantity::Velocity,
            None,
        );
        self.output(
            format!("{what} in {of}"),
            format!("{place}.in({frame_name}).position"),
            Nature::Polar,
            Quantity::Position,
            Some(rate),
        );
    }

    pub(super) fn observe(&mut self) {
        use Nature::{Axial, Even, Odd, Polar};
        // Mean axes are those of the referenced formulation alone.
        let shown: Vec<usize> = (0..self.tree.frames.len())
            .filter(|f| !self.tree.follows_mean(*f))
            .collect();
        let plane = self.tree.plane;
        for index in 0..self.tree.bodies.len() {
            let body = &self.tree.bodies[index];
            for at in [1.0, 0.37] {
                let place = self.place(Place::Body(index, at));
                let what = format!("b{index}.at({at})");
                self.seen(&what, &place, None);
                if !shown.is_empty() {
                    self.seen(
                        &what,
                        &place,
                        Some(shown[(index + usize::from(at == 1.0)) % shown.len()]),
                    );
                }
                if at == 1.0 {
                    continue;
                }
                let is_cable = body.is_cable;
                let mut number = |word: &str, nature, quantity| {
                    self.output(
                        format!("{what}.{word}"),
                        format!("{place}.{word}"),
                        nature,
                        quantity,
                        None,
                    );
                };
                number("axial_force", Even, Quantity::Force);
                match (is_cable, plane) {
                    (true, true) => number("moment", Odd, Quantity::Moment),
                    (true, false) => number("moment", Even, Quantity::Moment),
                    (false, true) => {
                        number("shear_y", Odd, Quantity::Force);
                        number("moment_z", Odd, Quantity::Moment);
                    }
                    (false, false) => {
                        number("torque", Odd, Quantity::Moment);
                        for (of, y, z, quantity) in [
                            ("shear", "shear_y", "shear_z", Quantity::Force),
                            ("bending", "moment_y", "moment_z", Quantity::Moment),
                        ] {
                            let text = format!("sqrt({place}.{y}^2 + {place}.{z}^2)");
                            self.output(format!("{what}.{of}"), text, Even, quantity, None);
                        }
                    }
                }
            }
        }
        for (number, &index) in shown.iter().enumerate() {
            if !matches!(self.tree.frames[index].kind, Kind::Rigid { .. }) {
                continue;
            }
            let name = self.name("f", index);
            self.seen(&format!("f{index}"), &name, None);
            let other = shown[(number + 1) % shown.len()];
            if other != index {
                self.seen(&format!("f{index}"), &name, Some(other));
            }
            if !self.tree.plane {
                let text = format!("{name}.angular_velocity");
                self.output(format!("f{index}.angular_velocity"), text, Axial, Quantity::Spin, None);
            }
        }
        for index in 0..self.tree.joints.len() {
            let joint = &self.tree.joints[index];
            let name = self.name("j", index);
            let word = joint.word;
            let of = format!("j{index} ({word})");
            self.output(
                format!("{of}.force"),
                format!("{name}.force"),
                Polar,
                Quantity::Force,
                None,
            );
            let is_free = matches!(word, "pin" | "spherical" | "distance") || self.tree.plane && word == "revolute";
            if !is_free {
                self.output(
                    format!("{of}.moment"),
                    format!("{name}.moment"),
                    Axial,
                    Quantity::Moment,
                    None,
                );
            }
        }
        self.observe_balance();
    }
}
