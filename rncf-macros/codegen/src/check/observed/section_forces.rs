//! What a section of a flexible body shows: its axes, and the forces, moments and stress that it carries.

use crate::check::frames::plane::{normal, plane};
use crate::check::places::place::{Place, Spot};
use crate::check::values::quantity::{Nature, Typed};
use crate::check::values::scope::Scope;
use crate::check::values::vector::{Quantity, Vectorial};
use crate::check::values::words::CARRIED;
use crate::check::{Check, say};
use crate::joints::algebra::observed;
use crate::model::{
    Body, BodyId, Expr as Value, Fidelity, FrameId, Location, Marker, Observable, SectionQuantity, SectionShape, Space,
};
use crate::parse::tree::{Expr, Name};
use crate::suggest;
use crate::units::Dimension;

/// What sections carry: with axes of their own in space and in a plane, and of a centre line.
fn words(has_section: bool, space: Space) -> (&'static str, &'static [&'static str]) {
    match (has_section, space) {
        (true, Space::Spatial) => (
            "a beam in space",
            &[
                "axial_force",
                "shear_y",
                "shear_z",
                "torque",
                "moment_y",
                "moment_z",
                "stress",
            ],
        ),
        (true, Space::Planar { .. }) => ("a planar beam", &["axial_force", "shear_y", "moment_z", "stress"]),
        (false, _) => ("a centre line", &["axial_force", "moment", "stress"]),
    }
}

/// Words behind a place, for suggestions.
pub fn known_words(place: &Place) -> Vec<&'static str> {
    let Some(space) = place.body.space else {
        return Vec::new();
    };
    let axes: &[&str] = match (place.has_section, space) {
        (false, _) => &[],
        (true, Space::Planar { .. }) => &["ey"],
        (true, Space::Spatial) => &["ey", "ez"],
    };
    let (_, carried) = words(place.has_section, space);
    axes.iter().chain(carried).copied().collect()
}

impl<'a> Check<'a> {
    /// Number of the section's axis that `ey` or `ez` means: 1 or 2.
    pub(in crate::check) fn section_axis(&mut self, place: &Place, word: &Name) -> Option<usize> {
        self.body_of(place.body.id)?;
        if !place.has_section {
            self.errors.at(word.span, say::no_section(&word.text));
            return None;
        }
        match place.body.space.and_then(normal) {
            Some(normal) if word.text == "ez" => {
                self.errors.at(word.span, say::one_section_axis(plane(normal)));
                None
            }
            _ => Some(if word.text == "ey" { 1 } else { 2 }),
        }
    }

    /// `PLACE.ey` or `PLACE.ez` in the axes of a frame; in constraints the unit axis that turns with the section.
    pub(in crate::check) fn section_direction(
        &mut self,
        place: &Place,
        frame: Option<FrameId>,
        word: &Name,
        scope: Scope,
    ) -> Option<Vectorial> {
        let axis = self.section_axis(place, word)?;
        let (body, at) = (place.body.id, place.at.clone());
        let deforming = Marker::BodySection {
            body,
            at: at.clone(),
            axis,
        };
        // What ties the axes acts on the rotation of the section.
        let axis = if scope == Scope::Constraint {
            let marker = self.marker(deforming);
            Marker::InSection { body, at, marker }
        } else {
            deforming
        };
        self.direction_on(place, frame, axis)
    }

    /// A direction at a place of a flexible body in the axes of a frame, by default its own one.
    pub(in crate::check) fn direction_on(
        &mut self,
        place: &Place,
        frame: Option<FrameId>,
        marker: Marker,
    ) -> Option<Vectorial> {
        let frame = frame.or(place.body.frame)?;
        let own = place.body.space.and_then(normal);
        let plane = own.filter(|normal| self.stays_in(frame, *normal));
        let marker = self.marker(marker);
        let values = self.in_frame_axes(&observed(marker, 0, plane), frame, plane);
        Some(Vectorial {
            values,
            axes: self.moving_axes(&Spot::Flexible(place.clone()), frame),
            dimension: Dimension::NONE,
            nature: Nature::default(),
            frame: Some(frame),
        })
    }

    /// `beam.end.stress` in an output.
    pub(in crate::check) fn carried_by(&mut self, place: &'a Expr, word: &Name, rest: &[&'a Name]) -> Option<Quantity> {
        let place = self.place(place)?;
        if let Some(surplus) = rest.first() {
            self.errors.at(surplus.span, say::after_component(&surplus.text));
            return None;
        }
        self.carried(&place, None, word, Scope::Output)
    }

    /// What the section at a place carries.
    pub(in crate::check) fn carried(
        &mut self,
        place: &Place,
        frame: Option<FrameId>,
        word: &Name,
        scope: Scope,
    ) -> Option<Quantity> {
        let (_, what, dimension) = CARRIED.iter().find(|(known, ..)| *known == word.text)?;
        let body = self.body_of(place.body.id)?;
        let (space, missing) = (body.space, lacks_shape(body));
        let (kind, words) = words(place.has_section, space);
        let message = if scope != Scope::Output {
            Some(say::only_in_outputs(&word.text))
        } else if frame.is_some() {
            Some(say::section_axes_only(&word.text))
        } else if !words.contains(&word.text.as_str()) {
            Some(say::not_carried(&word.text, kind, &suggest::list(words)))
        } else if body.fidelity == Fidelity::Point {
            Some(say::carried_by_point(&body.name))
        } else {
            missing.filter(|_| *what == SectionQuantity::Stress)
        };
        if let Some(message) = message {
            self.errors.at(word.span, message);
            return None;
        }
        // About the normal of a plane it has a sign.
        let what = match (what, space) {
            (SectionQuantity::Moment, Space::Planar { .. }) => SectionQuantity::MomentZ,
            _ => *what,
        };
        let value = carried_at(place.body.id, &place.at, what);
        Some(Quantity::Scalar(Typed::new(value, Dimension::of(*dimension))))
    }
}

fn carried_at(body: BodyId, at: &Location, what: SectionQuantity) -> Value {
    let at = at.clone();
    Value::Observed(Observable::Section { body, at, what })
}

/// What is missing for the stress over the section of a body.
fn lacks_shape(body: &Body) -> Option<String> {
    let SectionShape::General { extent: [y, z] } = &body.shape else {
        return None;
    };
    let name = &body.section_name;
    if body.has_own_stiffness() {
        return Some(say::stress_of_stiffness(name));
    }
    match (y, z, body.space) {
        (None, _, Space::Planar { .. }) => Some(say::stress_without_shape(name, "`extent_y`")),
        (_, _, Space::Planar { .. }) | (Some(_), Some(_), _) => None,
        _ => Some(say::stress_without_shape(name, "`extent_y` and `extent_z`")),
    }
}

#[cfg(test)]
mod tests {
    use crate::check::values::words::{CARRIED, balance_words};
    use crate::vocabulary::members::{BALANCES, OF_SECTIONS, words};

    #[test]
    fn editors_complete_every_word_that_is_understood() {
        let carried: Vec<&str> = CARRIED.iter().map(|(word, ..)| *word).collect();
        let completed: Vec<&str> = words(OF_SECTIONS).skip(4).collect();
        assert_eq!(completed, carried);
        assert_eq!(words(BALANCES).collect::<Vec<_>>(), balance_words().collect::<Vec<_>>());
    }
}
