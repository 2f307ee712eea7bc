//! Declared constraints: an expression of positions, directions, angles and time that vanishes.

use crate::check::values::scope::Scope;
use crate::check::values::vector::Quantity;
use crate::check::values::words::AXES;
use crate::check::{Check, fold, say};
use crate::joints::{Rows, algebra};
use crate::model::{ConstraintId, Expr as Value, FrameId, Marker, MarkerId};
use crate::parse::tree::{Expr, Item, ItemKind, Keyword};
use crate::units::Dimension;

/// What other items need to know of a constraint.
#[derive(Clone, Debug)]
pub struct Known {
    pub id: ConstraintId,
    pub dimension: Dimension,
    /// Axes of a vector's rows; none of a scalar.
    pub axes: Option<Vec<usize>>,
    pub frame: Option<FrameId>,
}

/// A body or frame that a marker belongs to.
#[derive(PartialEq)]
enum Owner {
    Frame(FrameId),
    Body(crate::model::BodyId),
}

impl<'a> Check<'a> {
    pub(in crate::check) fn constraints(&mut self) {
        for item in self.items(Keyword::Constraint) {
            let before = self.errors.len();
            if let ItemKind::Constraint(value) = &item.kind {
                self.constraint(item, value);
            }
            if self.errors.len() > before || Self::is_broken(item) {
                self.tied = None;
            }
        }
    }

    fn constraint(&mut self, item: &'a Item, value: &'a Expr) -> Option<()> {
        let (rows, dimension, axes, frame) = match self.with_lookups(|check| check.value(value, Scope::Constraint))? {
            Quantity::Scalar(typed) => (vec![(String::from("value"), typed.value)], typed.dimension, None, None),
            Quantity::Vector(vector) => {
                let name = |axis: usize| AXES[axis].to_string();
                // A component that is written as zero asks for nothing.
                let mut axes = vector.axes.clone();
                axes.retain(|&axis| fold::constant(&vector.values[axis]) != Some(0.0));
                if axes.is_empty() {
                    axes.clone_from(&vector.axes);
                }
                let rows = axes.iter().map(|axis| (name(*axis), vector.values[*axis].clone()));
                (rows.collect(), vector.dimension, Some(axes), vector.frame)
            }
        };
        if !self.is_smooth(value.area, rows.iter().map(|(_, row)| row)) {
            return None;
        }
        let mut markers = Vec::new();
        for (_, row) in &rows {
            let mut own = Vec::new();
            algebra::markers_of(row, &mut own);
            if !own.iter().any(|marker| self.moves(*marker)) {
                self.errors.at(value.area, say::NOTHING_CONSTRAINED);
                return None;
            }
            markers.extend(
                own.into_iter()
                    .filter(|marker| !markers.contains(marker))
                    .collect::<Vec<_>>(),
            );
        }
        self.note_all_held(&markers);
        let (markers, first_party) = self.first_party(markers);
        let rows = Rows {
            markers,
            first_party,
            rows,
        };
        let id = self.push_constraint(item, "constraint", rows, None);
        self.constraints.insert(
            item.name.text.as_str(),
            Known {
                id,
                dimension,
                axes,
                frame,
            },
        );
        Some(())
    }

    fn owner(&self, marker: MarkerId) -> Owner {
        match &self.model.markers[marker.0] {
            Marker::Point { frame, .. }
            | Marker::Direction { frame, .. }
            | Marker::Turn { frame }
            | Marker::Angle { frame }
            | Marker::Matching { frame, .. }
            | Marker::Normal { frame, .. } => Owner::Frame(*frame),
            Marker::BodyPoint { body, .. }
            | Marker::SectionPoint { body, .. }
            | Marker::BodySlope { body, .. }
            | Marker::BodySection { body, .. }
            | Marker::InSection { body, .. }
            | Marker::SectionTurn { body, .. } => Owner::Body(*body),
        }
    }

    /// Whether a marker depends on unknowns.
    pub(in crate::check) fn moves(&self, marker: MarkerId) -> bool {
        match self.owner(marker) {
            Owner::Frame(frame) => self.is_free(frame),
            Owner::Body(_) => true,
        }
    }

    /// Notes the bodies of markers as held.
    pub(in crate::check) fn note_all_held(&mut self, markers: &[MarkerId]) {
        for marker in markers {
            if let Owner::Body(body) = self.owner(*marker) {
                self.note_held(body);
            }
        }
    }

    /// Markers with those of the first one's owner in front, and their number. The first that moves
    /// says whose they are.
    fn first_party(&self, markers: Vec<MarkerId>) -> (Vec<MarkerId>, usize) {
        let first = markers.iter().copied().find(|marker| self.moves(*marker));
        let Some(owner) = first.map(|marker| self.owner(marker)) else {
            return (markers, 0);
        };
        let (mut own, other): (Vec<MarkerId>, Vec<MarkerId>) =
            markers.into_iter().partition(|marker| self.owner(*marker) == owner);
        let count = own.len();
        own.extend(other);
        (own, count)
    }

    /// Markers of forces: those that it acts on with the components, then those that it only
    /// depends on.
    pub(in crate::check) fn complete(
        &self,
        forces: Vec<(MarkerId, algebra::Vector)>,
    ) -> (Vec<MarkerId>, Vec<[Value; 3]>) {
        let (mut markers, mut components): (Vec<MarkerId>, Vec<[Value; 3]>) = (Vec::new(), Vec::new());
        for (marker, force) in forces {
            match markers.iter().position(|other| *other == marker) {
                Some(at) => components[at] = algebra::both(&components[at], &force, algebra::add),
                None => {
                    markers.push(marker);
                    components.push(force);
                }
            }
        }
        let acting = components.len();
        for at in 0..acting {
            for component in components[at].clone() {
                algebra::markers_of(&component, &mut markers);
            }
        }
        components.resize(markers.len(), algebra::numbers([0.0; 3]));
        (markers, components)
    }
}
