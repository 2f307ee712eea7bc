//! Joints: eliminated ones of flexible ends, and those with multipliers from the library.

use super::eliminated::{ENDS, Held};
use super::known::{Built, Known};
use super::share::SHARES;
use crate::check::bodies::body;
use crate::check::frames::plane::{self, is_parallel};
use crate::check::places::place::{Hold, Spot};
use crate::check::values::quantity::Wanted;
use crate::check::values::scope::Scope;
use crate::check::values::words::AXES;
use crate::check::{Arguments, Check, Shape, fold, say};
use crate::errors::Area;
use crate::joints::{self, Axis, Builder, KINDS, Kind, Rows, unit};
use crate::model::{BodyId, Constraint, ConstraintId, JointId};
use crate::parse::tree::{Call, Expr, ExprKind, Item, ItemKind, Keyword, Name};
use crate::suggest;

const POINT: Wanted = Wanted {
    what: "the point of a joint",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const LENGTH: Wanted = Wanted {
    what: "the length of a joint",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
/// Cosine of the angle between axes that count as normal to each other.
const NORMAL: f64 = 1e-9;

impl<'a> Check<'a> {
    pub(in crate::check) fn joints(&mut self) {
        let mut held: Vec<Held> = Vec::new();
        if !self.tree.complete {
            self.tied = None;
        }
        let items = self.items(Keyword::Joint);
        let last = |item: &&Item| match &item.kind {
            ItemKind::Joint(call) => call.name.text == "drive" || is_share(&call.name.text),
            _ => false,
        };
        // Drives of coordinates stand behind the joints that have them, shared nodes behind what holds ends.
        let (last, joints): (Vec<&Item>, Vec<&Item>) = items.into_iter().partition(last);
        for item in joints.into_iter().chain(last) {
            let mut known = Known {
                id: JointId(self.model.joints.len()),
                kind: None,
                body: None,
                frame: None,
                built: None,
                is_repeated: item.repeat.is_some(),
                is_share: false,
            };
            let before = self.errors.len();
            match &item.kind {
                ItemKind::Joint(call) => self.in_loop(item, |check| check.joint(item, call, &mut known, &mut held)),
                ItemKind::Corner(call) => self.corner(item, call, &mut known).unwrap_or_default(),
                _ => {}
            }
            if let (Some(body), ItemKind::Joint(_)) = (known.body, &item.kind) {
                self.note_held(body.id);
            } else if self.errors.len() > before || Self::is_broken(item) {
                self.tied = None;
            }
            self.joints.insert(item.name.text.as_str(), known);
        }
    }

    /// Notes that something holds a body.
    pub(in crate::check) fn note_held(&mut self, body: BodyId) {
        if let Some(tied) = &mut self.tied {
            tied.push(body);
        }
    }

    /// Reports bodies in prescribed frames that nothing holds.
    pub(in crate::check) fn floating(&mut self) {
        let Some(mut tied) = self.tied.clone() else { return };
        // What is held holds all that shares nodes with it.
        let shared = || {
            self.model
                .shares
                .iter()
                .map(|share| share.ends.each_ref().map(|(body, _)| *body))
        };
        let joined = || shared().chain(self.corners.iter().copied());
        let reached = |tied: &[BodyId]| joined().find(|ends| tied.contains(&ends[0]) != tied.contains(&ends[1]));
        while let Some(ends) = reached(&tied) {
            tied.extend(ends);
        }
        for (at, item) in self.items(Keyword::Body).into_iter().enumerate() {
            let is_carried = self
                .bodies
                .get(item.name.text.as_str())
                .and_then(|body| body.frame)
                .is_none_or(|frame| self.is_free(frame));
            if !tied.contains(&BodyId(at)) && !is_carried {
                let ItemKind::Body { frame, .. } = &item.kind else {
                    continue;
                };
                let frame = frame.as_ref().map_or("inertial", |frame| frame.text.as_str());
                let (name, piece) = body::piece(item).unwrap_or((&item.name.text, 0));
                if piece == 0 {
                    self.errors.at(item.name.span, say::floating(name, frame));
                }
            }
        }
    }

    fn joint(&mut self, item: &'a Item, call: &'a Call, known: &mut Known, held: &mut Vec<Held>) {
        let word = call.name.text.as_str();
        let is_end = word == "hold" || is_share(word) || ENDS.iter().any(|(end, _)| *end == word);
        let is_known = word == "drive" || KINDS.iter().any(|kind| kind.name == word);
        if item.repeat.is_some() && is_known && !is_end {
            self.errors.at(call.name.span, say::joint_not_repeated(word));
            return;
        }
        match word {
            _ if is_share(word) => {
                if self.share(item, call, known, held).is_none() {
                    // What holds the other body is not known.
                    self.tied = None;
                }
            }
            "hold" => self.hold(item, call, known, held).unwrap_or_default(),
            "drive" => self.drive(item, call, known).unwrap_or_default(),
            _ => {
                let kind = KINDS.iter().find(|kind| kind.name == word);
                let end = ENDS.iter().find(|(end, _)| *end == word);
                let usage = match (kind, end) {
                    (Some(kind), _) => kind.usage,
                    (_, Some((_, usage))) => usage,
                    _ => {
                        let words = ENDS.iter().map(|(end, _)| *end);
                        let words = words.chain(KINDS.iter().map(|kind| kind.name)).chain(["hold", "drive"]);
                        let words = words.chain(SHARES.iter().map(|(share, _)| *share));
                        self.errors.at(call.name.span, suggest::unknown("joint", word, words));
                        return;
                    }
                };
                let shape = Shape {
                    positional: 2,
                    named: kind.map_or(&["at"], named),
                    required: &[],
                    usage,
                };
                let Some(arguments) = self.arguments(call, &shape) else {
                    return;
                };
                self.between(item, &call.name, kind, &arguments, known, held)
                    .unwrap_or_default();
            }
        }
    }

    /// A joint between two parties.
    fn between(
        &mut self,
        item: &Item,
        word: &Name,
        kind: Option<&'static Kind>,
        arguments: &Arguments<'a>,
        known: &mut Known,
        held: &mut Vec<Held>,
    ) -> Option<()> {
        let first = self.hold_on(arguments.positional[0]);
        if let Some(Spot::Flexible(place)) = first.as_ref().map(|first| &first.spot) {
            known.body = Some(place.body);
        }
        let second = self.second_party(arguments.positional[1]);
        let point = arguments
            .named
            .get("at")
            .map(|point| self.vector(point, Scope::Parameter, POINT));
        let (mut first, mut second) = (first?, second?);
        if let (Some(carrier), Spot::Flexible(place)) = (first.frame(), &second.spot)
            && place.body.frame == Some(carrier)
            && self.eliminated(&word.text, &second, &first).is_some()
        {
            // In the body's own frame the end is what is held, whichever is named first.
            known.body = Some(place.body);
            std::mem::swap(&mut first, &mut second);
        }
        for hold in [&first, &second] {
            if let Spot::Flexible(place) = &hold.spot {
                self.note_held(place.body.id);
            }
        }
        if let (Some(kind), Some(frame)) = (self.eliminated(&word.text, &first, &second), second.frame()) {
            let at = match (&second.spot, second.is_bare, point) {
                (_, _, Some(point)) => {
                    let point = point?;
                    if let Some(space) = known.body.and_then(|body| body.space) {
                        self.in_plane(&point, space, "the point of the joint");
                    }
                    Some(point.values)
                }
                (Spot::Rigid { at, .. }, false, None) => Some(at.clone()),
                _ => None,
            };
            let area = [first.area, second.area];
            let Spot::Flexible(place) = first.spot else { return None };
            return self.tie_end(item, kind, place, frame, at, area, known, held);
        }
        if let (Some(point), Spot::Rigid { at, .. }) = (point, &mut second.spot) {
            *at = point?.values;
            second.is_bare = false;
        }
        self.with_multipliers(item, word, kind, arguments, [first, second], known)
    }

    /// The other thing: a frame's name has the messages of frames.
    fn second_party(&mut self, expr: &'a Expr) -> Option<Hold> {
        match &expr.kind {
            ExprKind::Name(_) | ExprKind::Member { .. } => self.hold_on(expr),
            _ => {
                self.errors.at(expr.area, say::FRAME_EXPECTED);
                None
            }
        }
    }

    pub(in crate::check) fn push_constraint(
        &mut self,
        item: &Item,
        kind: &str,
        rows: Rows,
        absolute: Option<BodyId>,
    ) -> ConstraintId {
        self.model.constraints.push(Constraint {
            name: item.name.text.clone(),
            doc: item.doc.clone(),
            kind: kind.into(),
            markers: rows.markers,
            first_party: rows.first_party,
            rows: rows.rows,
            absolute,
        });
        ConstraintId(self.model.constraints.len() - 1)
    }

    /// A joint of the library, or of a flexible end to something free.
    pub(in crate::check) fn with_multipliers(
        &mut self,
        item: &Item,
        word: &Name,
        kind: Option<&'static Kind>,
        arguments: &Arguments<'a>,
        holds: [Hold; 2],
        known: &mut Known,
    ) -> Option<()> {
        let (area, word) = (word.span.into(), word.text.as_str());
        if item.repeat.is_some() {
            self.errors.at(holds[1].area, say::REPEATED_TO_FREE);
            return None;
        }
        self.are_two(&holds)?;
        let plane = self.common_plane([&holds[0], &holds[1]])?;
        let parties = [holds[0].party(), holds[1].party()];
        let ends = holds.iter().filter(|hold| hold.frame().is_none()).count();
        let is_clamp = matches!(word, "clamp" | "clamp_full")
            // Of a centre line there is a tangent, and no more.
            || word == "weld" && holds.iter().any(Hold::is_line);
        let orients =
            is_clamp || kind.is_some_and(|kind| kind.orients && !(kind.name == "revolute" && plane.is_some()));
        if matches!(word, "clamp" | "clamp_full") && ends == 0 {
            self.errors.at(holds[0].area, say::PLACE_EXPECTED);
            return None;
        }
        if orients {
            self.have_orientation(word, is_clamp, plane, &holds)?;
        } else if word == "revolute" {
            self.can_turn(word, &holds)?;
        }
        let given = match kind {
            Some(kind) => self.joint_arguments(kind, arguments, plane, area)?,
            None => joints::Arguments::default(),
        };
        if let (Some(kind), Some(normal)) = (kind, plane)
            && let Err(advice) = kind.planar
        {
            self.errors
                .at(holds[0].area, say::not_in_plane(word, plane::plane(normal), advice));
            return None;
        }
        let mut builder = Builder::new(&mut self.model.markers, parties.clone(), plane);
        match (kind, plane) {
            _ if holds.iter().all(Hold::is_line) && is_clamp => joints::corner(&mut builder),
            _ if is_clamp => joints::clamp(&mut builder, word == "clamp_full"),
            (Some(kind), Some(_)) => kind.planar.ok()?(&mut builder, &given),
            (Some(kind), None) => (kind.spatial)(&mut builder, &given),
            (None, _) => {
                let points = builder.points();
                builder.s(points);
            }
        }
        let rows = builder.finish();
        let constraint = self.push_constraint(item, word, rows, None);
        known.built = Some(Built {
            constraint,
            word: word.into(),
            has_moment: is_clamp || kind.is_some_and(|kind| kind.has_moment[usize::from(plane.is_some())]),
            kind: kind.filter(|_| !is_clamp),
            is_reversed: false,
            parties,
            normal: plane,
            axis: given.axis,
        });
        Some(())
    }

    /// Two different things, and one of them free to move.
    pub(in crate::check) fn are_two(&mut self, holds: &[Hold; 2]) -> Option<()> {
        let [first, second] = holds;
        let message = match (&first.spot, &second.spot) {
            (Spot::Rigid { frame: a, .. }, Spot::Rigid { frame: b, .. }) if a == b => say::SAME_PARTY,
            (Spot::Flexible(a), Spot::Flexible(b)) if a.body.id == b.body.id && a.at == b.at => say::SAME_PARTY,
            (Spot::Rigid { frame: a, .. }, Spot::Rigid { frame: b, .. }) if !self.is_free(*a) && !self.is_free(*b) => {
                say::BOTH_PRESCRIBED
            }
            _ => return Some(()),
        };
        self.errors.at(second.area, message);
        None
    }

    fn have_orientation(&mut self, word: &str, is_clamp: bool, plane: Option<usize>, holds: &[Hold; 2]) -> Option<()> {
        // In a plane two tangents are enough.
        let is_corner = word == "weld" && plane.is_some();
        if holds.iter().all(Hold::is_line) && !is_corner {
            self.errors.at(holds[1].area, say::two_ends(word));
            return None;
        }
        if is_corner {
            for hold in holds {
                if let Spot::Flexible(place) = &hold.spot
                    && place.is_line
                    && self.has_slope(place.body.id) == Some(false)
                {
                    self.errors.at(hold.area, say::NO_SLOPE);
                    return None;
                }
            }
        }
        if is_clamp && holds.iter().all(Hold::is_section) {
            self.errors.at(holds[1].area, say::two_sections(word));
            return None;
        }
        for hold in holds {
            match hold.frame() {
                Some(frame) if self.is_point_mass(frame) => {
                    let name = self.model.frames[frame.0].name.clone();
                    self.errors.at(hold.area, say::point_mass_joint(&name, word));
                    return None;
                }
                None if !is_clamp && hold.is_line() => {
                    self.errors.at(hold.area, say::end_orientation(word));
                    return None;
                }
                _ => {}
            }
        }
        Some(())
    }

    /// Refuses point masses where something is to turn.
    fn can_turn(&mut self, word: &str, holds: &[Hold; 2]) -> Option<()> {
        for hold in holds {
            if let Some(frame) = hold.frame().filter(|frame| self.is_point_mass(*frame)) {
                let name = self.model.frames[frame.0].name.clone();
                self.errors.at(hold.area, say::point_mass_joint(&name, word));
                return None;
            }
        }
        Some(())
    }

    fn joint_arguments(
        &mut self,
        kind: &Kind,
        arguments: &Arguments<'a>,
        plane: Option<usize>,
        area: Area,
    ) -> Option<joints::Arguments> {
        let mut given = joints::Arguments::default();
        let axis = match arguments.named.get("axis") {
            Some(expr) => Some((self.axis(expr)?, expr.area)),
            None => None,
        };
        let is_needed = kind.axis == Axis::Always || kind.axis == Axis::InSpace && plane.is_none();
        match (axis, plane) {
            (Some((axis, area)), Some(normal)) => {
                let is_normal = is_parallel(axis, unit(normal));
                let fits = if kind.axis == Axis::InSpace {
                    is_normal
                } else {
                    axis[normal] == 0.0
                };
                if !fits && kind.planar.is_ok() {
                    let message = if kind.axis == Axis::InSpace {
                        say::axis_along_normal(kind.name, plane::plane(normal), AXES[normal])
                    } else {
                        say::axis_in_plane(kind.name, plane::plane(normal), AXES[normal])
                    };
                    self.errors.at(area, message);
                    return None;
                }
                given.axis = axis;
            }
            (Some((axis, _)), None) => given.axis = axis,
            (None, Some(normal)) if !is_needed => given.axis = unit(normal),
            (None, _) if is_needed => {
                self.errors.at(area, say::needs_axis(kind.name, kind.usage));
                return None;
            }
            (None, _) => {}
        }
        if kind.has_cross {
            let Some(expr) = arguments.named.get("cross") else {
                self.errors.at(area, say::usage(kind.name, kind.usage));
                return None;
            };
            given.cross = self.axis(expr)?;
            let product: f64 = (0..3).map(|i| given.axis[i] * given.cross[i]).sum();
            if product.abs() > NORMAL {
                self.errors.at(expr.area, say::CROSS_NOT_NORMAL);
                return None;
            }
        }
        if let Some(expr) = arguments.named.get("length") {
            let length = self.quantity(expr, Scope::Parameter, LENGTH)?;
            if fold::constant(&length).is_some_and(|length| length <= 0.0) {
                self.errors.at(expr.area, say::positive("the length of a joint"));
                return None;
            }
            given.length = Some(length);
        }
        Some(given)
    }
}

fn is_share(word: &str) -> bool {
    SHARES.iter().any(|(share, _)| *share == word)
}

/// Named arguments of a kind.
fn named(kind: &'static Kind) -> &'static [&'static str] {
    match (kind.axis, kind.has_cross, kind.name) {
        (Axis::None, _, "distance") => &["length"],
        (Axis::None, ..) => &[],
        (_, true, _) => &["axis", "cross"],
        _ => &["axis"],
    }
}
