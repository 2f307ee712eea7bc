//! Vectors that move with the system, and their components in the axes of frames.

use super::place::Spot;
use crate::check::frames::plane::normal;
use crate::check::{Check, fold, say};
use crate::errors::{Area, Errors};
use crate::joints::algebra::{self, Vector, add, both, dot, intern, observed, subtract};
use crate::joints::unit;
use crate::model::{Expr as Value, FrameId, INERTIAL, Marker, MarkerId, Motions, Space};

impl Check<'_> {
    /// Index of a marker.
    pub(in crate::check) fn marker(&mut self, marker: Marker) -> MarkerId {
        intern(&mut self.model.markers, marker)
    }

    /// The marker of a place.
    pub(in crate::check) fn point_marker(&mut self, spot: &Spot) -> MarkerId {
        let marker = match spot.clone() {
            Spot::Flexible(place) => Marker::on_section(place.body.id, place.at, place.beside),
            Spot::Rigid { frame, at } => Marker::Point { frame, at },
        };
        self.marker(marker)
    }

    /// An axis of a frame or its rate, inertial axes; in a plane without the component along its normal.
    pub(in crate::check) fn frame_axis(
        &mut self,
        frame: FrameId,
        axis: usize,
        derivative: usize,
        plane: Option<usize>,
    ) -> Vector {
        if frame == INERTIAL || plane == Some(axis) {
            return algebra::numbers(if derivative == 0 { unit(axis) } else { [0.0; 3] });
        }
        let along = algebra::numbers(unit(axis));
        let marker = self.marker(Marker::Direction { frame, along });
        observed(marker, derivative, plane)
    }

    /// Components of a vector in inertial axes.
    pub(in crate::check) fn in_inertial_axes(
        &mut self,
        vector: &Vector,
        frame: FrameId,
        plane: Option<usize>,
    ) -> Vector {
        if frame == INERTIAL {
            return vector.clone();
        }
        let mut sum = algebra::numbers([0.0; 3]);
        for (axis, component) in vector.iter().enumerate() {
            let along = self.frame_axis(frame, axis, 0, plane);
            sum = both(&sum, &algebra::scale(component, &along), add);
        }
        sum
    }

    /// Components of a vector in the axes of a frame.
    pub(in crate::check) fn in_frame_axes(&mut self, vector: &Vector, frame: FrameId, plane: Option<usize>) -> Vector {
        if frame == INERTIAL {
            return vector.clone();
        }
        [0, 1, 2].map(|axis| dot(&self.frame_axis(frame, axis, 0, plane), vector))
    }

    /// Position of a place relative to a frame's origin in its axes (`derivative` 0), or its time
    /// derivative: `e_k' . d + e_k . d'`. Second derivatives in the inertial frame only.
    pub(in crate::check) fn place_in(&mut self, spot: &Spot, frame: FrameId, derivative: usize) -> Vector {
        let plane = self.spot_normal(spot).filter(|normal| self.stays_in(frame, *normal));
        let point = self.point_marker(spot);
        if frame == INERTIAL {
            return observed(point, derivative, plane);
        }
        let at = algebra::numbers([0.0; 3]);
        let origin = self.marker(Marker::Point { frame, at });
        let apart = |order| {
            both(
                &observed(point, order, plane),
                &observed(origin, order, plane),
                subtract,
            )
        };
        [0, 1, 2].map(|axis| {
            let along = self.frame_axis(frame, axis, 0, plane);
            if derivative == 0 {
                return dot(&along, &apart(0));
            }
            let turning = self.frame_axis(frame, axis, 1, plane);
            add(dot(&turning, &apart(0)), dot(&along, &apart(1)))
        })
    }

    /// The plane that all moves in, where there is one.
    pub(in crate::check) fn scene_normal(&self) -> Option<usize> {
        let is_spatial = |motions: &Motions| matches!(motions, Motions::Spatial | Motions::Turning | Motions::Shifting);
        let frames = self.model.frames.iter().filter_map(|frame| frame.free.as_ref());
        let bodies = self.bodies.values().filter_map(|body| body.space);
        if frames.clone().any(|free| is_spatial(&free.motions)) || bodies.clone().any(|space| space == Space::Spatial) {
            return None;
        }
        match self.plane_normals()[..] {
            [normal] => Some(normal),
            _ => None,
        }
    }

    /// Normal of the plane that a frame moves in.
    pub(in crate::check) fn frame_normal(&mut self, frame: FrameId) -> Option<usize> {
        match self.model.frames[frame.0].free.as_ref().map(|free| &free.motions) {
            Some(Motions::Planar { normal } | Motions::ShiftingPlanar { normal }) => Some(*normal),
            Some(Motions::Spatial | Motions::Turning | Motions::Shifting | Motions::State) => None,
            Some(Motions::Hinged { .. }) | None => self.scene_normal().filter(|normal| self.stays_in(frame, *normal)),
        }
    }

    /// Normal of the plane that a place moves in.
    pub(in crate::check) fn spot_normal(&mut self, spot: &Spot) -> Option<usize> {
        match spot {
            Spot::Flexible(place) => place.body.space.and_then(normal),
            Spot::Rigid { frame, at } => self
                .frame_normal(*frame)
                .filter(|normal| fold::constant(&at[*normal]) == Some(0.0)),
        }
    }

    /// Whether a frame keeps a plane; nothing is reported.
    pub(in crate::check) fn stays_in(&mut self, frame: FrameId, normal: usize) -> bool {
        let mut quiet = Errors::new();
        std::mem::swap(self.errors, &mut quiet);
        let reported = self.out_of_plane.clone();
        self.out_of_plane.clear();
        let stays = self.keeps_plane(frame, normal, proc_macro2::Span::call_site());
        self.out_of_plane = reported;
        std::mem::swap(self.errors, &mut quiet);
        let _ = quiet.finish();
        stays
    }

    /// Whether a frame's pose is unknown.
    pub(in crate::check) fn is_free(&self, frame: FrameId) -> bool {
        self.model.frames[frame.0].free.is_some()
    }

    /// Motions of a free frame.
    pub(in crate::check) fn motions_of(&self, frame: FrameId) -> Option<&Motions> {
        self.model.frames[frame.0].free.as_ref().map(|free| &free.motions)
    }

    /// Whether a frame has no orientation: it is a point mass.
    pub(in crate::check) fn is_point_mass(&self, frame: FrameId) -> bool {
        matches!(
            self.motions_of(frame),
            Some(Motions::Shifting | Motions::ShiftingPlanar { .. })
        )
    }

    /// Whether axes turn with a frame; that a point mass has none is said.
    pub(in crate::check) fn has_orientation(&mut self, frame: FrameId, area: Area) -> bool {
        let is_point = self.is_point_mass(frame);
        if is_point {
            let message = say::point_mass_turns(&self.model.frames[frame.0].name);
            self.errors.at(area, message);
        }
        !is_point
    }

    /// The angle of a prescribed frame that turns about one inertial axis.
    pub(in crate::check) fn prescribed_angle(&self, frame: FrameId, normal: usize) -> Value {
        let mut angle = Value::Number(0.0);
        let mut at = frame;
        while at != INERTIAL {
            let frame = &self.model.frames[at.0];
            if let Some(rotation) = &frame.rotation {
                let turned = if rotation.axis[normal] < 0.0 {
                    algebra::negate(rotation.angle.clone())
                } else {
                    rotation.angle.clone()
                };
                angle = add(angle, turned);
            }
            at = frame.parent;
        }
        angle
    }
}
