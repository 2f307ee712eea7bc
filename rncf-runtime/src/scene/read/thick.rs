//! Sections that do not fit their bodies: mostly a second moment in another unit than meant, or an axis that is curved more than a thin beam's.

use std::f64::consts::PI;

use crate::emitted::{BodySpec, SectionShape, SectionSpec};
use crate::model::Warning;
use crate::scene::MeshScene;
use crate::space::Vector;

/// Places of an axis at which its curvature is looked at.
const PLACES: usize = 32;
/// Part by which a moment turns a curved beam too far, from which on that is told.
const TOLD: f64 = 0.01;
/// Part of the stress of bending by which it is larger at the inner side of a curved axis, of the outermost fibre's distance over the radius (Winkler): 2/3 for
/// rectangles, 4/5 for circles; and from which on it is told.
const INNER: f64 = 0.75;
const TOLD_OF_STRESS: f64 = 0.02;
/// Young's modulus over the shear modulus and the shear coefficient, of steel and a circle.
const YOUNG_OVER_SHEAR: f64 = 3.0;

impl MeshScene {
    /// What does not fit, of one body of each name.
    pub(crate) fn thick_sections(&self) -> Vec<Warning> {
        [too_thick, too_curved, stressed_inside, too_deep]
            .into_iter()
            .flat_map(|find| self.one_of_each_name(|body| find(&self.bodies[body].spec, &self.section_spec(body, 0.0))))
            .collect()
    }

    /// What is found of bodies, by their numbers; of one body of each name.
    pub(crate) fn one_of_each_name(&self, find: impl Fn(usize) -> Option<Warning>) -> Vec<Warning> {
        let mut told: Vec<&str> = Vec::new();
        let mut warnings = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            if told.contains(&body.spec.name) {
                continue;
            }
            if let Some(warning) = find(index) {
                told.push(body.spec.name);
                warnings.push(warning);
            }
        }
        warnings
    }
}

/// The larger second moment of a section over its area, m^2; no number where one of them is unknown.
fn square_of_gyration(section: &SectionSpec) -> f64 {
    if let SectionShape::Numbers { square_of_gyration } = section.shape {
        return square_of_gyration;
    }
    section.second_moments.iter().copied().fold(0.0, f64::max) / section.area
}

/// Whether it is longer than thick; of what is not more is told already.
fn is_slender(body: &BodySpec, section: &SectionSpec) -> bool {
    square_of_gyration(section).sqrt() <= body.line.length()
}

/// A section whose radius of gyration is longer than the body.
fn too_thick(body: &BodySpec, section: &SectionSpec) -> Option<Warning> {
    let (radius, length) = (square_of_gyration(section).sqrt(), body.line.length());
    let (ratio, words) = match section.shape {
        SectionShape::Numbers { .. } => ("EI / EA", "its stiffness"),
        _ => ("second_moment / area", "`second_moment` and `area`"),
    };
    (radius.is_finite() && radius > length).then(|| Warning {
        text: format!(
            "body `{}`: the radius of gyration of its section, sqrt({ratio}) = {radius:.3e} m, is longer than the body ({length:.3e} m), which no slender body has: are these the units of {words}?",
            body.name
        ),
        weight: radius / length,
    })
}

/// A body whose axis is curved so much that its strains are not those of a thin one: bending is measured by the axes of the section, `r_x . r_y'`, or the polynomial
/// `r_x x r_xx`, which a moment on a curved axis stretches, too. It turns the axis by a part of `curvature^2 I / A` more.
fn too_curved(body: &BodySpec, section: &SectionSpec) -> Option<Warning> {
    let curvature = curvatures(body).map(|of| of.norm()).fold(0.0, f64::max);
    let part = section.softness_of_curves * curvature.powi(2) * square_of_gyration(section);
    let cure = if body.has_section() {
        "strains of a `beam` with a shape are those of a thin one. Give its section in numbers (`EA`, `GJ`, `EIy`, ..)"
    } else {
        "its polynomial of bending grows with the stretch. Take `cable(.., bending = exact)`"
    };
    (is_slender(body, section) && part.is_finite() && part > TOLD).then(|| Warning {
        text: format!(
            "body `{}`: its section is so thick beside the radius of its axis, {:.3e} m, that a moment turns it too far by {:.1} %: {cure}",
            body.name,
            1.0 / curvature,
            100.0 * part
        ),
        weight: part,
    })
}

/// A body without sections that is so short that their shear and rotary inertia count: of a half wave as long as the body they lower the frequency by
/// `pi^2 (1 + E / (k G)) i^2 / (2 L^2)` (Timoshenko), with the radius of gyration i.
fn too_deep(body: &BodySpec, section: &SectionSpec) -> Option<Warning> {
    if body.has_section() {
        return None;
    }
    let square = square_of_gyration(section);
    let part = 0.5 * (PI / body.line.length()).powi(2) * square * (1.0 + YOUNG_OVER_SHEAR);
    (is_slender(body, section) && part.is_finite() && part > TOLD).then(|| Warning {
        text: format!(
            "body `{}`: its section is so thick beside its length that shear and rotary inertia count, which an element without sections leaves out: frequencies of half waves as long as the body are too high by about {:.1} %, of the n-th by n^2 of it, and deflections too small by about as much. Take `beam`",
            body.name,
            100.0 * part
        ),
        weight: part,
    })
}

/// Curvature vectors of an undeformed axis, 1/m.
fn curvatures(body: &BodySpec) -> impl Iterator<Item = Vector> {
    let line = &body.line;
    let tangent = |place: usize| line.at(place as f64 / PLACES as f64).1.normalize();
    let span = line.length() / PLACES as f64;
    (0..PLACES).map(move |place| (tangent(place + 1) - tangent(place)) / span)
}

/// Distances of the outermost fibres along y and z, m, where both are known or only the first one counts.
fn outermost(body: &BodySpec, shape: SectionShape) -> Option<[f64; 2]> {
    Some(match shape {
        SectionShape::Circle { radius } | SectionShape::Tube { radius, .. } => [radius; 2],
        SectionShape::Rectangle { sizes } => sizes.map(|size| 0.5 * size),
        SectionShape::Numbers { .. } => return None,
        SectionShape::General { extent: [y, z] } => [y?, if body.dimension() == 2 { 0.0 } else { z? }],
    })
}

/// A body whose axis is curved so much that stresses at its inner side are larger than those of a straight one, which are told.
fn stressed_inside(body: &BodySpec, section: &SectionSpec) -> Option<Warning> {
    let outermost = outermost(body, section.shape)?;
    let depths = curvatures(body).enumerate().map(|(place, curvature)| {
        if !body.has_section() {
            return outermost[0] * curvature.norm();
        }
        let axes = body.section((place as f64 + 0.5) / PLACES as f64);
        (0..2)
            .map(|axis| outermost[axis] * axes[axis].dot(&curvature).abs())
            .sum()
    });
    let depth = depths.fold(0.0, f64::max);
    let part = INNER * depth;
    (is_slender(body, section) && part.is_finite() && part > TOLD_OF_STRESS).then(|| Warning {
        text: format!(
            "body `{}`: its outermost fibre is {depth:.2} of the radius of its axis away from that: stresses of bending and torsion are those of a straight bar, and larger at the inner side by about {:.0} %. Multiply them by the factor of Winkler or Wahl",
            body.name,
            100.0 * part
        ),
        weight: part,
    })
}
