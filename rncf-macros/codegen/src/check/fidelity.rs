//! How finely a body deforms, and whether its frame follows its mean axes.

use super::{Check, say};
use crate::errors::Area;
use crate::model::{Fidelity, FrameId, Motions, Space};
use crate::parse::tree::{Item, Statement};

impl<'a> Check<'a> {
    /// `modal(n);`, `small(n);`, `rigid;`, `point;` or nothing; `None`: reported.
    pub(super) fn fidelity(&mut self, statements: &'a [Statement]) -> Option<Fidelity> {
        let mut found = None;
        for statement in statements {
            let Statement::Fidelity { word, count } = statement else {
                continue;
            };
            if let Some((_, line)) = found {
                let (words, line): (_, usize) = ("`modal`, `small`, `rigid` or `point`", line);
                self.errors
                    .at(word.span, say::duplicate_statement(words, &line.to_string()));
                continue;
            }
            let modes = count.as_ref().map(|count| self.modes(count));
            let fidelity = match (word.text.as_str(), modes) {
                (_, Some(None)) => None,
                ("modal", Some(Some(count))) => Some(Fidelity::Modal(count)),
                ("small", Some(Some(count))) => Some(Fidelity::Small(count)),
                ("point", _) => Some(Fidelity::Point),
                _ => Some(Fidelity::Rigid),
            };
            found = Some((fidelity, Area::from(word.span).line()));
        }
        found.map_or(Some(Fidelity::Full), |(fidelity, _)| fidelity)
    }

    /// Refuses what repeated bodies cannot be yet.
    pub(super) fn may_be_repeated(&mut self, statements: &[Statement]) {
        for statement in statements {
            let (area, word) = match statement {
                Statement::Fidelity { word, .. } => (Area::from(word.span), word.text.as_str()),
                Statement::MeanAxes { area } => (*area, "mean_axes"),
                _ => continue,
            };
            self.errors.at(area, say::statement_not_repeated(word));
        }
    }

    /// Whether there is `mean_axes;`: the frame must be free, alike in dimension, and no body itself, and the body
    /// described by all its nodal vectors.
    pub(super) fn mean_axes(
        &mut self,
        item: &Item,
        statements: &'a [Statement],
        frame: Option<FrameId>,
        space: Option<Space>,
    ) -> bool {
        let mut areas = statements.iter().filter_map(|statement| match statement {
            Statement::MeanAxes { area } => Some(*area),
            _ => None,
        });
        let Some(first) = areas.next() else {
            return false;
        };
        for area in areas {
            let line = first.line().to_string();
            self.errors.at(area, say::duplicate_statement("`mean_axes`", &line));
        }
        if let (Some(frame), Some(space)) = (frame, space) {
            let frame = &self.model.frames[frame.0];
            let has_modes = statements
                .iter()
                .any(|statement| matches!(statement, Statement::Fidelity { .. }));
            let message = match frame.free.as_ref() {
                Some(free) if free.is_body => say::mean_axes_of_body(&frame.name),
                Some(free) => match (free.motions, space) {
                    (Motions::Spatial, Space::Spatial) | (Motions::Planar { .. }, Space::Planar { .. })
                        if !has_modes =>
                    {
                        return true;
                    }
                    (Motions::Spatial, Space::Spatial) | (Motions::Planar { .. }, Space::Planar { .. }) => {
                        say::mean_axes_of_modes(&item.name.text)
                    }
                    (Motions::Planar { .. }, Space::Spatial) => say::MEAN_AXES_IN_SPACE.into(),
                    _ => say::mean_axes_of_held(&frame.name),
                },
                None => say::mean_axes_of_prescribed(&frame.name),
            };
            self.errors.at(first, message);
        }
        true
    }
}
