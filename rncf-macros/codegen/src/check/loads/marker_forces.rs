//! Loads on what moves freely, loads that depend on the motion, and followers: forces on markers.

use super::load::{FORCE, MOMENT};
use crate::check::frames::plane::{normal, plane};
use crate::check::places::place::{Hold, Spot};
use crate::check::values::quantity::Vector;
use crate::check::values::scope::Scope;
use crate::check::values::words::AXES;
use crate::check::{Arguments, Check, Shape, fold, say};
use crate::joints::algebra::{self, cross, observed};
use crate::joints::{Builder, unit};
use crate::model::{Expr as Value, FrameId, INERTIAL, Marker, MarkerId, Space};
use crate::parse::tree::{Call, Expr, ExprKind, Item, Keyword};

const FOLLOWER: Shape = Shape {
    positional: 2,
    named: &[],
    required: &[],
    usage: "follower(beam.end, 3 N)",
};

impl<'a> Check<'a> {
    /// Whether something of the motion stands in an expression.
    pub(in crate::check) fn observes(&self, expr: &Expr) -> bool {
        match &expr.kind {
            // Of a table only the place where it is looked up may be of the motion.
            ExprKind::Member { base, arguments, .. } => match (&base.kind, arguments) {
                (ExprKind::Name(name), Some(arguments)) if self.is_table(&name.text) => {
                    arguments.iter().any(|argument| self.observes(&argument.value))
                }
                _ => true,
            },
            ExprKind::Indexed { .. }
            | ExprKind::Numbered { .. }
            | ExprKind::Applied { .. }
            | ExprKind::Remainder(..) => false,
            ExprKind::Reduced(reduced) => self.observes(&reduced.value),
            ExprKind::Name(name) => self.states.contains_key(name.text.as_str()),
            _ => expr.parts().into_iter().any(|part| self.observes(part)),
        }
    }

    fn is_table(&self, name: &str) -> bool {
        self.names.get(name).is_some_and(|item| item.keyword == Keyword::Table)
    }

    /// Whether a load is a force on markers: on or in something free, or a function of the motion.
    pub(in crate::check) fn is_on_markers(&self, arguments: &Arguments<'a>) -> bool {
        let place = arguments.positional[0];
        let (carrier, is_body) = match root(place) {
            Some(name) if self.is_frame(name) => return true,
            Some(name) => (self.bodies.get(name).and_then(|body| body.frame), true),
            None => (None, false),
        };
        let axes = match arguments.named.get("in").map(|frame| &frame.kind) {
            Some(ExprKind::Name(name)) => self.frames.get(name.text.as_str()).copied().flatten(),
            _ => None,
        };
        let is_free = |frame: Option<FrameId>| frame.is_some_and(|frame| self.is_free(frame));
        let is_beside = matches!(&place.kind, ExprKind::Member { field, .. } if field.text == "beside");
        is_body && (is_beside || is_free(carrier) || is_free(axes) || self.observes(arguments.positional[1]))
    }

    /// `force(PLACE, [..], in = F)` or `moment(..)` on markers.
    pub(in crate::check) fn marker_load(
        &mut self,
        item: &Item,
        arguments: &Arguments<'a>,
        is_moment: bool,
    ) -> Option<()> {
        let place = self.hold_on(arguments.positional[0]);
        let expr = arguments.positional[1];
        let wanted = if is_moment { MOMENT } else { FORCE };
        let given = match arguments.named.get("in") {
            Some(frame) => Some(self.frame_argument(frame)?),
            None => None,
        };
        let (values, own) = if self.observes(expr) {
            let vector = self.wanted_vector(expr, Scope::Force, wanted)?;
            let components = Vector {
                values: vector.values.clone(),
                areas: [expr.area; 3],
                area: expr.area,
            };
            if let Some(hold) = &place {
                self.lies_in_plane(hold, &components, is_moment)?;
            }
            (vector.values, vector.frame)
        } else {
            let vector = self.vector_of_time(expr, wanted)?;
            if let Some(hold) = &place {
                self.lies_in_plane(hold, &vector, is_moment)?;
                if let Spot::Flexible(place) = &hold.spot
                    && is_moment
                    && place.body.space == Some(Space::Spatial)
                {
                    let tangent = place.body.tangent.filter(|_| place.is_line);
                    self.moment_direction(
                        &vector,
                        Space::Spatial,
                        tangent,
                        place.body.frame,
                        given.unwrap_or(INERTIAL),
                    );
                }
            }
            (vector.values, None)
        };
        if let (Some(given), Some(own)) = (given, own)
            && given != own
        {
            self.errors.at(expr.area, say::AXES_OF_LOAD);
            return None;
        }
        let place = place?;
        let frame = given.or(own).unwrap_or(INERTIAL);
        if let Some(normal) = self.spot_normal(&place.spot) {
            let area = arguments.named.get("in").map_or(expr.area, |frame| frame.area);
            if !self.keeps_plane(frame, normal, area) {
                return None;
            }
        }
        let axes = self.spot_normal(&place.spot);
        let load = self.in_inertial_axes(&values, frame, axes);
        let forces = if is_moment {
            self.moment_on(&place, load)?
        } else {
            self.force_on(&place, load)?
        };
        self.push_force(item, forces, None);
        Some(())
    }

    /// A load on something planar stays in its plane, or turns about its normal: other components are literally zero.
    fn lies_in_plane(&mut self, hold: &Hold, vector: &Vector, is_moment: bool) -> Option<()> {
        let Some(normal) = self.spot_normal(&hold.spot) else {
            return Some(());
        };
        let before = self.errors.len();
        if !is_moment {
            self.in_plane(vector, Space::Planar { normal }, "the force");
            return (self.errors.len() == before).then_some(());
        }
        for axis in (0..3).filter(|axis| *axis != normal) {
            if fold::constant(&vector.values[axis]) != Some(0.0) {
                let message = say::moment_out_of_plane(plane(normal), AXES[normal]);
                self.errors.at(vector.areas[axis], message);
            }
        }
        (self.errors.len() == before).then_some(())
    }

    fn is_pushed(&mut self, hold: &Hold) -> Option<()> {
        let is_prescribed = hold.frame().is_some_and(|frame| !self.is_free(frame));
        if is_prescribed {
            self.errors.at(hold.area, say::FORCE_ON_PRESCRIBED);
            return None;
        }
        Some(())
    }

    fn force_on(&mut self, hold: &Hold, force: algebra::Vector) -> Option<Vec<(MarkerId, algebra::Vector)>> {
        self.is_pushed(hold)?;
        Some(vec![(self.point_marker(&hold.spot), force)])
    }

    /// On a frame or section its turning, on a centre line the slope: `f = m x d / (d . d)`.
    fn moment_on(&mut self, hold: &Hold, moment: algebra::Vector) -> Option<Vec<(MarkerId, algebra::Vector)>> {
        self.is_pushed(hold)?;
        match hold.spot.clone() {
            Spot::Rigid { frame, .. } => {
                if !self.has_orientation(frame, hold.area) {
                    return None;
                }
                Some(vec![(self.marker(Marker::Turn { frame }), moment)])
            }
            Spot::Flexible(place) => {
                let plane = place.body.space.and_then(normal);
                let parties = [place.party(), place.party()];
                let mut builder = Builder::new(&mut self.model.markers, parties, plane);
                if let Some(turn) = builder.turn(0) {
                    return Some(vec![(turn, moment)]);
                }
                let direction = builder.slope(0)?;
                let force = algebra::turning(&moment, &observed(direction, 0, plane));
                Some(vec![(direction, force)])
            }
        }
    }

    /// `follower(PLACE, F)` along the tangent, `follower(PLACE, [along, across])` in a plane.
    pub(in crate::check) fn follower(&mut self, item: &Item, call: &'a Call) -> Option<()> {
        let arguments = self.arguments(call, &FOLLOWER)?;
        let hold = self.hold_on(arguments.positional[0])?;
        let Spot::Flexible(place) = hold.spot.clone() else {
            self.errors.at(hold.area, say::FOLLOWER_ON_FRAME);
            return None;
        };
        let expr = arguments.positional[1];
        let plane = normal(place.body.space?);
        let (along, across) = match &expr.kind {
            ExprKind::Vector { components, .. } if components.len() == 2 => {
                if plane.is_none() {
                    self.errors.at(expr.area, say::FOLLOWER_IN_SPACE);
                    return None;
                }
                let (values, _) = self.components(expr, Scope::Force, FORCE)?;
                let [along, across]: [Value; 2] = values.try_into().ok()?;
                (along, Some(across))
            }
            ExprKind::Vector { .. } => {
                self.errors.at(expr.area, say::FOLLOWER_COMPONENTS);
                return None;
            }
            _ => (self.quantity(expr, Scope::Force, FORCE)?, None),
        };
        let (body, at) = (place.body.id, place.at.clone());
        let slope = self.marker(Marker::BodySlope { body, at });
        let tangent = algebra::normalised(&observed(slope, 0, plane));
        let mut force = algebra::scale(&along, &tangent);
        if let (Some(across), Some(normal)) = (across, plane) {
            let normal = cross(&algebra::numbers(unit(normal)), &tangent);
            force = algebra::both(&force, &algebra::scale(&across, &normal), algebra::add);
        }
        let point = self.point_marker(&hold.spot);
        self.push_force(item, vec![(point, force)], None);
        Some(())
    }
}

/// The name that an expression of members begins with.
fn root(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) | ExprKind::Indexed { base: name, .. } => Some(&name.text),
        ExprKind::Member { base, .. } => root(base),
        _ => None,
    }
}
