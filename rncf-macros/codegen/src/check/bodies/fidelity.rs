//! How finely a body deforms, and what of it its frame follows.

use super::mesh::Mesh;
use crate::check::{Check, say};
use crate::errors::Area;
use crate::model::{Fidelity, FrameId, FrameTie, Motions, Space};
use crate::parse::tree::{Item, Statement};

impl<'a> Check<'a> {
    /// `modal(n);`, `small(n);`, `rigid;`, `point;` or nothing; `None`: reported.
    pub(in crate::check) fn fidelity(&mut self, statements: &'a [Statement]) -> Option<Fidelity> {
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
            found = Some((fidelity, word.line()));
        }
        found.map_or(Some(Fidelity::Full), |(fidelity, _)| fidelity)
    }

    /// Refuses modes of a body whose strain energy changes with time.
    pub(in crate::check) fn modes_of_timed(&mut self, statements: &[Statement], mesh: &Mesh, space: Space) {
        let element = &self.library.elements[mesh.element.0];
        if !element.is_timed(space.dimension(), &mesh.options) {
            return;
        }
        let name = element.names[0];
        for statement in statements {
            if let Statement::Fidelity { word, count: Some(_) } = statement {
                self.errors.at(word.span, say::modes_of_timed(&word.text, name));
            }
        }
    }

    /// Refuses what repeated bodies cannot be yet.
    pub(in crate::check) fn may_be_repeated(&mut self, statements: &[Statement]) {
        for statement in statements {
            let (area, word) = match statement {
                Statement::Fidelity { word, .. } => (Area::from(word.span), word.text.as_str()),
                Statement::FrameTie { word } => (Area::from(word.span), word.text.as_str()),
                _ => continue,
            };
            self.errors.at(area, say::statement_not_repeated(word));
        }
    }

    /// `mean_axes;` or `chord;`: the frame must be free, alike in dimension, and no body itself, and the body described by
    /// all its nodal vectors.
    pub(in crate::check) fn frame_tie(
        &mut self,
        item: &Item,
        statements: &'a [Statement],
        frame: Option<FrameId>,
        space: Option<Space>,
    ) -> FrameTie {
        let mut words = statements.iter().filter_map(|statement| match statement {
            Statement::FrameTie { word } => Some(word),
            _ => None,
        });
        let Some(first) = words.next() else {
            return FrameTie::Joints;
        };
        let tie = if first.text == FrameTie::Chord.word() {
            FrameTie::Chord
        } else {
            FrameTie::MeanAxes
        };
        for word in words {
            let line = first.line().to_string();
            let words = if word.text == first.text {
                format!("`{}`", word.text)
            } else {
                "`mean_axes` or `chord`".to_string()
            };
            self.errors.at(word.span, say::duplicate_statement(&words, &line));
        }
        if let (Some(frame), Some(space)) = (frame, space) {
            let frame = &self.model.frames[frame.0];
            let has_modes = statements
                .iter()
                .any(|statement| matches!(statement, Statement::Fidelity { .. }));
            let what = tie.describe();
            let message = match frame.free.as_ref() {
                Some(free) if free.is_body => say::tie_of_body(what, &frame.name),
                Some(free) => match (free.motions, space) {
                    (Motions::Spatial, Space::Spatial) | (Motions::Planar { .. }, Space::Planar { .. })
                        if !has_modes =>
                    {
                        return tie;
                    }
                    (Motions::Spatial, Space::Spatial) | (Motions::Planar { .. }, Space::Planar { .. }) => {
                        say::tie_of_modes(what, &item.name.text, tie.word())
                    }
                    (Motions::Planar { .. }, Space::Spatial) => say::tie_in_space(what),
                    _ => say::tie_of_held(what, &frame.name),
                },
                None => say::tie_of_prescribed(what, &frame.name),
            };
            self.errors.at(first.span, message);
        }
        tie
    }
}
