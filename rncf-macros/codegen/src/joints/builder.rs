//! Parties of a joint, their markers, and rows made of the primitives.

use super::algebra::{self, Vector, cross, dot, intern, observed, subtract};
use crate::model::{BodyId, Expr, FrameId, Location, Marker, MarkerId, Space};

/// What a joint, spring or constraint holds on to.
#[derive(Clone, Debug, PartialEq)]
pub enum Party {
    /// A frame or rigid body.
    Frame {
        /// Which.
        frame: FrameId,
        /// Point of it, m, frame axes; `None`: named without one.
        point: Option<[Expr; 3]>,
    },
    /// A place on a flexible body.
    Place {
        /// Body.
        body: BodyId,
        /// Where.
        at: Location,
        /// How far beside the axis, m, along the section's y and z axes.
        beside: Option<[Expr; 2]>,
        /// Of a body with cross-sections its declared frame, in whose axes directions are given; `None`
        /// of a centre line.
        section: Option<FrameId>,
    },
}

/// Rows of a joint and the markers that they are functions of.
#[derive(Clone, Debug)]
pub struct Rows {
    /// Markers, those of the first party first.
    pub markers: Vec<MarkerId>,
    /// How many belong to the first party.
    pub first_party: usize,
    /// What each row fixes, and its expression.
    pub rows: Vec<(String, Expr)>,
}

/// Collects the rows of a joint between two parties.
pub struct Builder<'m> {
    markers: &'m mut Vec<Marker>,
    /// First and second party.
    pub parties: [Party; 2],
    /// Normal of the plane, where the joint is in one.
    pub normal: Option<usize>,
    used: [Vec<MarkerId>; 2],
    rows: Vec<(String, Expr)>,
}

impl<'m> Builder<'m> {
    /// No rows so far; new markers go to `markers`.
    pub fn new(markers: &'m mut Vec<Marker>, parties: [Party; 2], normal: Option<usize>) -> Self {
        Self {
            markers,
            parties,
            normal,
            used: [Vec::new(), Vec::new()],
            rows: Vec::new(),
        }
    }

    /// A marker of a party.
    pub fn marker(&mut self, party: usize, marker: Marker) -> MarkerId {
        let id = intern(self.markers, marker);
        self.of(party, id)
    }

    /// Counts a marker to a party: reactions act on those of the first one.
    fn of(&mut self, party: usize, id: MarkerId) -> MarkerId {
        if !self.used[party].contains(&id) {
            self.used[party].push(id);
        }
        id
    }

    /// The frame of a party; none of a flexible body.
    pub fn frame(&self, party: usize) -> Option<FrameId> {
        match &self.parties[party] {
            Party::Frame { frame, .. } => Some(*frame),
            Party::Place { .. } => None,
        }
    }

    fn own_point(&mut self, party: usize, is_bare_origin: bool) -> Option<MarkerId> {
        let marker = match self.parties[party].clone() {
            Party::Frame { frame, point: Some(at) } => Marker::Point { frame, at },
            Party::Frame { frame, point: None } if is_bare_origin => Marker::Point {
                frame,
                at: algebra::numbers([0.0; 3]),
            },
            Party::Frame { .. } => return None,
            Party::Place { body, at, beside, .. } => Marker::on_section(body, at, beside),
        };
        Some(self.marker(party, marker))
    }

    /// The points of both parties. One without a point of its own has it where the other one's is
    /// at t = 0; of two such ones the first has it in its origin.
    pub fn points(&mut self) -> [MarkerId; 2] {
        match (self.own_point(0, false), self.own_point(1, false)) {
            (Some(first), Some(second)) => [first, second],
            (None, Some(second)) => [self.matching(0, second), second],
            (first, None) => {
                let first = first.or_else(|| self.own_point(0, true)).unwrap_or(MarkerId(0));
                [first, self.matching(1, first)]
            }
        }
    }

    /// The points of both parties; one without a point of its own has it in its origin.
    pub fn origins(&mut self) -> [MarkerId; 2] {
        [0, 1].map(|party| self.own_point(party, true).unwrap_or(MarkerId(0)))
    }

    /// Fixed in a party's frame, equal to another marker at t = 0.
    pub fn matching(&mut self, party: usize, marker: MarkerId) -> MarkerId {
        let frame = self.frame(party).unwrap_or(crate::model::INERTIAL);
        self.marker(party, Marker::Matching { frame, marker })
    }

    /// A direction at t = 0, in the axes of a party's frame or of its body's declared one. It says where directions of both
    /// parties start, and is [`Builder::fixed`] in one of them only then: a body may be declared in the other one's frame.
    pub fn direction(&mut self, party: usize, along: [f64; 3]) -> MarkerId {
        let frame = self.axes_of(party);
        let along = algebra::numbers(along);
        intern(self.markers, Marker::Direction { frame, along })
    }

    /// An axis of a party's frame, or of its body's declared one at t = 0 and then turning with the section, and its rate.
    pub fn own_axis(&mut self, party: usize, axis: usize) -> [Vector; 2] {
        let still = algebra::numbers([0.0; 3]);
        if self.normal == Some(axis) || self.frame(party) == Some(crate::model::INERTIAL) {
            return [algebra::numbers(algebra::unit(axis)), still];
        }
        let start = self.direction(party, algebra::unit(axis));
        let own = self.fixed(party, start);
        let along = self.value(own);
        let rate = match (self.frame(party), self.turn(party)) {
            (None, Some(turn)) => cross(&observed(turn, 1, None), &along),
            _ => observed(own, 1, self.normal),
        };
        [along, rate]
    }

    /// The direction fixed in a party that is another one at t = 0.
    pub fn fixed(&mut self, party: usize, start: MarkerId) -> MarkerId {
        if let (Marker::Direction { frame: own, .. }, Some(frame)) = (&self.markers[start.0], self.frame(party))
            && *own == frame
        {
            return self.of(party, start);
        }
        match self.in_section(party, start) {
            Some(direction) => direction,
            None => self.matching(party, start),
        }
    }

    /// The direction that turns with a party's section and is another one at t = 0; none of a frame or centre line.
    fn in_section(&mut self, party: usize, start: MarkerId) -> Option<MarkerId> {
        let (body, at) = self.section_place(party)?;
        let marker = start;
        Some(self.marker(party, Marker::InSection { body, at, marker }))
    }

    /// The turning of a party; none of a centre line.
    pub fn turn(&mut self, party: usize) -> Option<MarkerId> {
        let marker = match (self.frame(party), self.section_place(party)) {
            (Some(frame), _) => Marker::Turn { frame },
            (None, Some((body, at))) => Marker::SectionTurn { body, at },
            (None, None) => return None,
        };
        Some(self.marker(party, marker))
    }

    /// Fixed in a party, normal to a direction at t = 0.
    pub fn normal_to(&mut self, party: usize, marker: MarkerId, which: usize) -> MarkerId {
        let frame = self.axes_of(party);
        let normal = intern(self.markers, Marker::Normal { frame, marker, which });
        match self.in_section(party, normal) {
            Some(direction) => direction,
            None => self.of(party, normal),
        }
    }

    /// The frame in whose axes directions of a party are given.
    fn axes_of(&self, party: usize) -> FrameId {
        match &self.parties[party] {
            Party::Frame { frame, .. } => *frame,
            Party::Place { section, .. } => section.unwrap_or(crate::model::INERTIAL),
        }
    }

    /// Body and place of a party's section; none of a frame or centre line.
    fn section_place(&self, party: usize) -> Option<(BodyId, Location)> {
        match &self.parties[party] {
            Party::Place {
                body,
                at,
                section: Some(_),
                ..
            } => Some((*body, at.clone())),
            _ => None,
        }
    }

    /// Whether one party is a section and the other one a frame.
    pub fn is_section_on_frame(&self) -> bool {
        (0..2).any(|party| self.section_place(party).is_some() && self.frame(1 - party).is_some())
    }

    /// The axes of a party's section, in a plane the one in it; none of a frame or centre line.
    pub fn section(&mut self, party: usize) -> Option<(MarkerId, Option<MarkerId>)> {
        let (body, at) = self.section_place(party)?;
        let is_spatial = self.normal.is_none();
        let mut axis = |axis| {
            let at = at.clone();
            self.marker(party, Marker::BodySection { body, at, axis })
        };
        let y = axis(1);
        Some((y, is_spatial.then(|| axis(2))))
    }

    /// The slope of a flexible party.
    pub fn slope(&mut self, party: usize) -> Option<MarkerId> {
        match self.parties[party].clone() {
            Party::Place { body, at, .. } => Some(self.marker(party, Marker::BodySlope { body, at })),
            Party::Frame { .. } => None,
        }
    }

    /// A marker's components, without the one along the plane's normal.
    pub fn value(&self, marker: MarkerId) -> Vector {
        observed(marker, 0, self.normal)
    }

    /// From the first party's point to the second one's.
    pub fn between(&self, points: [MarkerId; 2]) -> Vector {
        algebra::both(&self.value(points[1]), &self.value(points[0]), subtract)
    }

    /// Adds a row.
    pub fn row(&mut self, name: impl Into<String>, value: Expr) {
        self.rows.push((name.into(), value));
    }

    /// Axes in which there is motion.
    pub fn axes(&self) -> &'static [usize] {
        self.normal
            .map_or(Space::Spatial, |normal| Space::Planar { normal })
            .axes()
    }

    /// One row for each component of a vector, `what x`, ..
    pub fn vector(&mut self, what: &str, value: &Vector) {
        for &axis in self.axes() {
            self.row(format!("{what} {}", ["x", "y", "z"][axis]), value[axis].clone());
        }
    }

    /// **S**: both points are one.
    pub fn s(&mut self, points: [MarkerId; 2]) {
        let apart = algebra::both(&self.value(points[0]), &self.value(points[1]), subtract);
        self.vector("position", &apart);
    }

    /// **d1**: two directions stay normal to each other.
    pub fn d1(&mut self, a: MarkerId, b: MarkerId) {
        let row = dot(&self.value(a), &self.value(b));
        self.numbered("direction", row);
    }

    /// In the plane: two directions stay parallel.
    pub fn parallel(&mut self, a: MarkerId, b: MarkerId) {
        let normal = self.normal.unwrap_or(2);
        let [x, y, z] = cross(&self.value(a), &self.value(b));
        self.numbered("direction", [x, y, z][normal].clone());
    }

    /// A row with a running number: `direction 2`.
    pub fn numbered(&mut self, what: &str, value: Expr) {
        let before = self.rows.iter().filter(|(name, _)| name.starts_with(what)).count();
        self.row(format!("{what} {}", before + 1), value);
    }

    /// **d2**: the way between the points stays normal to a direction.
    pub fn d2(&mut self, direction: MarkerId, points: [MarkerId; 2]) {
        let row = dot(&self.value(direction), &self.between(points));
        self.numbered("offset", row);
    }

    /// All rows, and the markers that stand in them.
    pub fn finish(self) -> Rows {
        let [first, second] = self.used;
        let first_party = first.len();
        let second = second
            .into_iter()
            .filter(|marker| !first.contains(marker))
            .collect::<Vec<_>>();
        let mut used = Vec::new();
        for (_, row) in &self.rows {
            algebra::markers_of(row, &mut used);
        }
        let first_kept = first[..first_party]
            .iter()
            .filter(|marker| used.contains(marker))
            .count();
        let markers = first.into_iter().chain(second).filter(|marker| used.contains(marker));
        Rows {
            markers: markers.collect(),
            first_party: first_kept,
            rows: self.rows,
        }
    }
}
