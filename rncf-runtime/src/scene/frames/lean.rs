//! Free frames that absolute coordinates do not need. A frame without mass of its own feels nothing but what ties it. Where
//! these conditions are as many as its motions their multipliers vanish, and without the frame and them all else moves the
//! same; it is left out where nothing else reads or loads it. Otherwise it would be dragged along, with a dense border.

use super::directions::motions_of;
use crate::emitted::{
    About, BalanceQuantity, BodySpec, ConstraintSpec, FrameTie, FreeSpec, MarkerSpec, ObservedSpec, Parts,
};

/// What refers to frames.
pub(crate) struct References {
    markers: Vec<MarkerSpec>,
    constraints: Vec<ConstraintSpec>,
    /// For every frame whether anything but constraints reads or loads it.
    used: Vec<bool>,
}

impl References {
    /// Of a model with these bodies, in absolute coordinates.
    pub fn new(parts: &dyn Parts, bodies: &[BodySpec]) -> Self {
        let mut references = Self {
            markers: parts.markers(),
            constraints: parts.constraints(),
            used: vec![false; parts.frame_count()],
        };
        let mut used = vec![0];
        for observed in parts.observed() {
            match observed {
                ObservedSpec::Point { body, .. } => used.push(bodies[body].frame),
                ObservedSpec::Marker { marker, .. }
                | ObservedSpec::Balance {
                    what: BalanceQuantity::AngularMomentum(About::Marker(marker)),
                    ..
                } => used.extend(references.frame(marker)),
                _ => {}
            }
        }
        for load in parts.loads() {
            used.push(load.frame);
        }
        let markers = parts
            .forces()
            .into_iter()
            .flat_map(|force| force.markers.iter().copied());
        used.extend(markers.filter_map(|marker| references.frame(marker)));
        used.extend(
            bodies
                .iter()
                .filter(|body| body.instance.is_some())
                .map(|body| body.frame),
        );
        used.into_iter().for_each(|frame| references.used[frame] = true);
        references
    }

    /// The frame that a marker is fixed in.
    fn frame(&self, marker: usize) -> Option<usize> {
        match self.markers[marker] {
            MarkerSpec::Point { frame, .. }
            | MarkerSpec::Direction { frame, .. }
            | MarkerSpec::Turn { frame }
            | MarkerSpec::Angle { frame }
            | MarkerSpec::Matching { frame, .. }
            | MarkerSpec::Normal { frame, .. } => Some(frame),
            MarkerSpec::BodyPoint { .. }
            | MarkerSpec::SectionPoint { .. }
            | MarkerSpec::BodySlope { .. }
            | MarkerSpec::BodySection { .. }
            | MarkerSpec::InSection { .. }
            | MarkerSpec::SectionTurn { .. } => None,
        }
    }

    /// Whether a constraint is about a frame.
    pub fn touches(&self, constraint: &ConstraintSpec, frame: usize) -> bool {
        constraint
            .markers
            .iter()
            .any(|&marker| self.frame(marker) == Some(frame))
    }

    /// Whether a free frame without mass of its own is left out.
    pub fn leaves_out(&self, spec: &FreeSpec, bodies: &[BodySpec], free: &[FreeSpec]) -> bool {
        let follows = bodies
            .iter()
            .any(|body| body.frame == spec.frame && body.tie != FrameTie::Joints);
        if follows || self.used[spec.frame] {
            return false;
        }
        let ties = self
            .constraints
            .iter()
            .filter(|constraint| self.touches(constraint, spec.frame));
        let mut rows = 0;
        for tie in ties {
            rows += tie.rows.len();
            let others = free.iter().filter(|other| other.frame != spec.frame);
            if others.into_iter().any(|other| self.touches(tie, other.frame)) {
                return false;
            }
        }
        rows == motions_of(spec)
    }
}
