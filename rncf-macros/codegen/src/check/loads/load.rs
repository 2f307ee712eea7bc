//! Loads: gravity, dead forces and moments; per length and fields in `density`.

use crate::check::frames::plane::{is_parallel, normal, plane};
use crate::check::places::place::Place;
use crate::check::values::quantity::{Vector, Wanted};
use crate::check::values::words::AXES;
use crate::check::{Check, Shape, fold, say};
use crate::model::{FrameId, INERTIAL, Load, LoadKind, Space};
use crate::parse::tree::{Call, Expr, ExprKind, Item, ItemKind, Keyword};
use crate::suggest;

/// Component of gravity.
pub(in crate::check) const GRAVITY: Wanted = Wanted {
    what: "gravity",
    dimension: [1, 0, -2, 0, 0, 0],
    unit: "m/s^2",
};
/// Component of a force.
pub(in crate::check) const FORCE: Wanted = Wanted {
    what: "a force",
    dimension: [1, 1, -2, 0, 0, 0],
    unit: "N",
};
/// Component of a moment.
pub(in crate::check) const MOMENT: Wanted = Wanted {
    what: "a moment",
    dimension: [2, 1, -2, 0, 0, 0],
    unit: "N m",
};

impl<'a> Check<'a> {
    pub(in crate::check) fn loads(&mut self) {
        for item in self.items(Keyword::Load) {
            if let ItemKind::Load(call) = &item.kind
                && self.may_repeat_load(item)
            {
                self.in_loop(item, |check| check.load(item, call));
            }
        }
    }

    fn load(&mut self, item: &Item, call: &'a Call) {
        let kind = match call.name.text.as_str() {
            "gravity" => self.with_lookups(|check| check.gravity(call)),
            "force" => self.with_lookups(|check| check.point_load(item, call, false)),
            "moment" => self.with_lookups(|check| check.point_load(item, call, true)),
            "follower" => {
                let _ = self.with_lookups(|check| check.follower(item, call));
                None
            }
            "density" => {
                let _ = self.with_lookups(|check| check.density(item, call));
                None
            }
            "distributed" => {
                let _ = self.with_lookups(|check| check.distributed_load(item, call));
                None
            }
            other => {
                let known = ["gravity", "force", "moment", "follower", "density", "distributed"];
                let message = suggest::unknown("load", other, known);
                self.errors.at(call.name.span, message);
                None
            }
        };
        if let Some(kind) = kind {
            self.model.loads.push(Load {
                name: item.name.text.clone(),
                doc: item.doc.clone(),
                kind,
            });
        }
    }

    fn gravity(&mut self, call: &'a Call) -> Option<LoadKind> {
        let shape = Shape {
            positional: 1,
            named: &["on"],
            required: &[],
            usage: "gravity([0, 0, -9.81] m/s^2)",
        };
        let arguments = self.arguments(call, &shape)?;
        if let Some(on) = arguments.named.get("on") {
            return self.field(&arguments, on);
        }
        if !self.names.contains_key("position") && mentions(arguments.positional[0], "position") {
            return self.gravity_of_place(arguments.positional[0]);
        }
        let vector = self.vector_of_time(arguments.positional[0], GRAVITY)?;
        // One message for each plane that it leaves, however many bodies and frames move in it.
        for normal in self.plane_normals() {
            self.in_plane(&vector, Space::Planar { normal }, "gravity");
        }
        Some(LoadKind::Gravity(vector.values))
    }

    fn point_load(&mut self, item: &Item, call: &'a Call, is_moment: bool) -> Option<LoadKind> {
        let usage = if is_moment {
            "moment(beam.end, [0, 0, 3] N*m)"
        } else {
            "force(beam.end, [0, 10, 0] N)"
        };
        let shape = Shape {
            positional: 2,
            named: &["in"],
            required: &[],
            usage,
        };
        let arguments = self.arguments(call, &shape)?;
        if self.is_on_markers(&arguments) {
            self.marker_load(item, &arguments, is_moment)?;
            return None;
        }
        let [place, components] = arguments.positional.as_slice() else {
            return None;
        };
        let place = self.place(place);
        let vector = self.vector_of_time(components, if is_moment { MOMENT } else { FORCE });
        let frame_argument = arguments.named.get("in").copied();
        let frame = frame_argument.map_or(Some(INERTIAL), |frame| self.frame_argument(frame));
        let (Place { body, at, is_line, .. }, vector, frame) = (place?, vector?, frame?);
        if let Some(space) = body.space {
            let area = frame_argument.map_or(components.area, |frame| frame.area);
            let keeps = normal(space).is_none_or(|normal| self.keeps_plane(frame, normal, area));
            match (keeps, is_moment) {
                (false, _) => {}
                (true, false) => self.in_plane(&vector, space, "the force"),
                (true, true) => {
                    let tangent = body.tangent.filter(|_| is_line);
                    self.moment_direction(&vector, space, tangent, body.frame, frame);
                }
            }
        }
        let (body, components) = (body.id, vector.values);
        Some(if is_moment {
            LoadKind::Moment {
                body,
                at,
                components,
                frame,
            }
        } else {
            LoadKind::Force {
                body,
                at,
                components,
                frame,
            }
        })
    }

    /// In the plane a moment is along the normal; in space it is not along the axis of a straight centre line with this
    /// tangent, whatever the params are.
    pub(in crate::check) fn moment_direction(
        &mut self,
        vector: &Vector,
        space: Space,
        tangent: Option<[f64; 3]>,
        body_frame: Option<FrameId>,
        frame: FrameId,
    ) {
        if let Some(normal) = normal(space) {
            for axis in (0..3).filter(|axis| *axis != normal) {
                if fold::constant(&vector.values[axis]) != Some(0.0) {
                    let message = say::moment_out_of_plane(plane(normal), AXES[normal]);
                    self.errors.at(vector.areas[axis], message);
                }
            }
            return;
        }
        let (Some(tangent), Some(body_frame)) = (tangent, body_frame) else {
            return;
        };
        let is_along = |sample| {
            vector
                .sampled(sample)
                .is_some_and(|moment| is_parallel(moment, tangent))
        };
        if self.have_same_axes(body_frame, frame) && (0..fold::SAMPLES).all(is_along) {
            self.errors.at(vector.area, say::TORSION);
        }
    }
}

/// Whether a name stands in an expression.
pub(in crate::check) fn mentions(expr: &Expr, name: &str) -> bool {
    match &expr.kind {
        ExprKind::Name(own) => own.text == name,
        ExprKind::Member { base, arguments, .. } => {
            let arguments = arguments.iter().flatten();
            mentions(base, name) || arguments.into_iter().any(|argument| mentions(&argument.value, name))
        }
        _ => expr.parts().into_iter().any(|part| mentions(part, name)),
    }
}
