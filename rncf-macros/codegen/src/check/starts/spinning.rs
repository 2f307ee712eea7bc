//! Starts: frames whose bodies begin in relative equilibrium.

use crate::check::fold;
use crate::check::frames::free::SPIN;
use crate::check::frames::plane::{self, normal};
use crate::check::values::quantity;
use crate::check::values::scope::Scope;
use crate::check::values::words::AXES;
use crate::check::{Check, Shape, say};
use crate::model::{Fidelity, FrameId, INERTIAL, Start};
use crate::parse::tree::{Call, ItemKind, Keyword};
use crate::suggest;

const SPINNING: Shape = Shape {
    positional: 1,
    named: &["angular_velocity"],
    required: &[],
    usage: "spinning(hub, angular_velocity = [0, 0, 1] rad/s)",
};

impl<'a> Check<'a> {
    pub(in crate::check) fn starts(&mut self) {
        for item in self.items(Keyword::Start) {
            if let ItemKind::Start(call) = &item.kind
                && let Some(start) = self.spinning(&item.name.text, call)
            {
                self.model.starts.push(start);
            }
        }
    }

    fn spinning(&mut self, name: &str, call: &'a Call) -> Option<Start> {
        if call.name.text != "spinning" {
            let message = suggest::unknown("start", &call.name.text, ["spinning"]);
            self.errors.at(call.name.span, message);
            return None;
        }
        let arguments = self.arguments(call, &SPINNING)?;
        let area = arguments.positional[0].area;
        let frame = self.frame_argument(arguments.positional[0]);
        let spin = match arguments.named.get("angular_velocity") {
            Some(spin) => Some(Some(self.rates(spin, Scope::Parameter, SPIN)?)),
            None => Some(None),
        };
        let (frame, spin) = (frame?, spin?);
        if frame == INERTIAL {
            self.errors.at(area, say::START_OF_INERTIAL);
            return None;
        }
        let frame_name = self.model.frames[frame.0].name.clone();
        if let Some(other) = self.model.starts.iter().find(|start| start.frame == frame) {
            let message = say::start_twice(&frame_name, &other.name);
            self.errors.at(area, message);
            return None;
        }
        if !self.may_settle(frame, area) {
            return None;
        }
        if let Some(spin) = &spin {
            let spaces = self.bodies.values().filter(|body| body.frame == Some(frame));
            let mut spaces: Vec<_> = spaces.filter_map(|body| body.space).collect();
            spaces.sort_by_key(|&space| normal(space));
            spaces.dedup();
            for space in spaces {
                self.along_normal(spin, space);
            }
        }
        Some(Start {
            name: name.to_string(),
            frame,
            spin: spin.map(|spin| spin.values),
        })
    }

    /// Whether the frame has bodies, and all of them may start so.
    fn may_settle(&mut self, frame: FrameId, area: crate::errors::Area) -> bool {
        let bodies: Vec<_> = self.model.bodies.iter().filter(|body| body.frame == frame).collect();
        let unreadable = self.items(Keyword::Body).len() > self.model.bodies.len();
        if bodies.is_empty() && !unreadable {
            let message = say::start_without_bodies(&self.model.frames[frame.0].name);
            self.errors.at(area, message);
            return false;
        }
        let modal = bodies.iter().find(|body| body.fidelity != Fidelity::Full);
        let moving = bodies.iter().find(|body| body.initial.velocity.is_some());
        let message = match (modal, moving) {
            (Some(body), _) => say::start_of_modes(&body.name),
            (None, Some(body)) => say::start_with_velocity(&body.name),
            (None, None) => return true,
        };
        self.errors.at(area, message);
        false
    }

    /// In a plane the axis of the rotation is the normal.
    fn along_normal(&mut self, spin: &quantity::Vector, space: crate::model::Space) {
        let Some(normal) = normal(space) else { return };
        for axis in (0..3).filter(|&axis| axis != normal) {
            if fold::constant(&spin.values[axis]).is_some_and(|value| value != 0.0) {
                let message = say::start_out_of_plane(plane::plane(normal), AXES[normal]);
                self.errors.at(spin.areas[axis], message);
                return;
            }
        }
    }
}
