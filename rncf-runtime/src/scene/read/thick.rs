//! Sections that do not fit their bodies: mostly a second moment in another unit than meant, or an axis that is curved more than a thin beam's.

use std::f64::consts::PI;

use crate::emitted::{BodySpec, SectionShape, SectionSpec};
use crate::model::Warning;
use crate::scene::MeshScene;
use crate::space::Vector;

/// Places of an axis at which its curvature is looked at.
const PLACES: usize = 32;
/// Places at which sections that differ along the axis are looked at.
const SECTIONS: usize = 256;
/// Part by which a moment turns a curved beam too far, from which on that is told.
const TOLD: f64 = 0.01;
/// Part of the stress of bending by which it is larger at the inner side of a curved axis, of the outermost fibre's distance over the radius (Winkler): 2/3 for
/// rectangles, 4/5 for circles; and from which on it is told.
const INNER: f64 = 0.75;
const TOLD_OF_STRESS: f64 = 0.02;
/// Young's modulus over the shear modulus and the shear coefficient, of steel and a circle.
const YOUNG_OVER_SHEAR: f64 = 3.0;

/// A body with its sections along the axis, in the middles of equal pieces; one where all are alike.
struct Along<'s> {
    body: &'s BodySpec,
    sections: Vec<SectionSpec>,
}

impl MeshScene {
    /// What does not fit, of one body of each name.
    pub(crate) fn thick_sections(&self) -> Vec<Warning> {
        [too_thick, too_curved, stressed_inside, too_deep]
            .into_iter()
            .flat_map(|find| self.one_of_each_name(|body| find(&self.along(body))))
            .collect()
    }

    fn along(&self, body: usize) -> Along<'_> {
        let spec = &self.bodies[body].spec;
        let (count, length) = (if self.parts.varies(body) { SECTIONS } else { 1 }, spec.line.length());
        let at = |place: usize| self.section_spec(body, length * (place as f64 + 0.5) / count as f64);
        Along {
            body: spec,
            sections: (0..count).map(at).collect(),
        }
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

impl Along<'_> {
    /// The section at a fraction of the axis.
    fn at(&self, fraction: f64) -> &SectionSpec {
        let place = (fraction * self.sections.len() as f64) as usize;
        &self.sections[place.min(self.sections.len() - 1)]
    }

    /// Second moment of a section over its area where it bends along a direction at a fraction of the axis, m^2; no number where it is unknown. Without
    /// these, and of a line in space, whose section has no axes, the larger one.
    fn square_of_gyration(&self, section: &SectionSpec, bend: Option<(f64, Vector)>) -> f64 {
        if let SectionShape::Numbers { square_of_gyration } = section.shape {
            return square_of_gyration;
        }
        let [about_y, about_z] = section.second_moments;
        let larger = about_y.max(about_z);
        let about = match bend {
            _ if self.body.dimension() == 2 => about_z,
            Some((fraction, along)) if self.body.has_section() => {
                let [y, z] = self.body.section(fraction).map(|axis| axis.dot(&along).powi(2));
                if y + z > 0.0 {
                    (y * about_z + z * about_y) / (y + z)
                } else {
                    larger
                }
            }
            _ => larger,
        };
        about / section.area
    }

    /// Radius of gyration, m: the root of the mean square along the axis.
    fn radius_of_gyration(&self) -> f64 {
        let all = self
            .sections
            .iter()
            .map(|section| self.square_of_gyration(section, None));
        (all.sum::<f64>() / self.sections.len() as f64).sqrt()
    }

    /// Whether it is longer than thick; of what is not more is told already.
    fn is_slender(&self) -> bool {
        self.radius_of_gyration() <= self.body.line.length()
    }
}

/// A section whose radius of gyration is longer than the body.
fn too_thick(along: &Along<'_>) -> Option<Warning> {
    let (radius, length) = (along.radius_of_gyration(), along.body.line.length());
    let (ratio, words) = match along.sections[0].shape {
        SectionShape::Numbers { .. } => ("EI / EA", "its stiffness"),
        _ => ("second_moment / area", "`second_moment` and `area`"),
    };
    (radius.is_finite() && radius > length).then(|| Warning {
        text: format!(
            "body `{}`: the radius of gyration of its section, sqrt({ratio}) = {radius:.3e} m, is longer than the body ({length:.3e} m), which no slender body has: are these the units of {words}?",
            along.body.name
        ),
        weight: radius / length,
    })
}

/// A body whose axis is curved so much that its strains are not those of a thin one: bending is measured by the axes of the section, `r_x . r_y'`, or the polynomial
/// `r_x x r_xx`, which a moment on a curved axis stretches, too. It turns the axis by a part of `curvature^2 I / A` more.
fn too_curved(along: &Along<'_>) -> Option<Warning> {
    let body = along.body;
    let parts = curvatures(body).map(|(fraction, curvature)| {
        let section = along.at(fraction);
        let square = along.square_of_gyration(section, Some((fraction, curvature)));
        let part = section.softness_of_curves * curvature.norm_squared() * square;
        [part, 1.0 / curvature.norm()]
    });
    let [part, radius] = parts.fold([0.0, 0.0], |most, own| if own[0] > most[0] { own } else { most });
    let cure = if body.has_section() {
        "strains of a `beam` with a shape are those of a thin one. Give its section in numbers (`EA`, `GJ`, `EIy`, ..)"
    } else {
        "its polynomial of bending grows with the stretch. Take `cable(.., bending = exact)`"
    };
    (along.is_slender() && part.is_finite() && part > TOLD).then(|| Warning {
        text: format!(
            "body `{}`: its section is so thick beside the radius of its axis, {radius:.3e} m, that a moment turns it too far by {:.1} %: {cure}",
            body.name,
            100.0 * part
        ),
        weight: part,
    })
}

/// A body without sections that is so short that their shear and rotary inertia count: of a half wave as long as the body they lower the frequency by
/// `pi^2 (1 + E / (k G)) i^2 / (2 L^2)` (Timoshenko), with the radius of gyration i. Along the body shear counts as the square of the half wave's shear force
/// over the area, and bending as that of its moment over the second moment.
fn too_deep(along: &Along<'_>) -> Option<Warning> {
    let body = along.body;
    if body.has_section() {
        return None;
    }
    let (mut shear, mut bending) = (0.0, 0.0);
    for (place, section) in along.sections.iter().enumerate() {
        let fraction = (place as f64 + 0.5) / along.sections.len() as f64;
        let square = along.square_of_gyration(section, None);
        let area = match section.shape {
            SectionShape::Numbers { .. } => 1.0,
            _ => section.area,
        };
        let (sine, cosine) = match along.sections.len() {
            1 => (1.0, 1.0),
            _ => (PI * fraction).sin_cos(),
        };
        shear += cosine * cosine / area;
        bending += sine * sine / (area * square);
    }
    let part = 0.5 * (PI / body.line.length()).powi(2) * (shear / bending) * (1.0 + YOUNG_OVER_SHEAR);
    (along.is_slender() && part.is_finite() && part > TOLD).then(|| Warning {
        text: format!(
            "body `{}`: its section is so thick beside its length that shear and rotary inertia count, which an element without sections leaves out: frequencies of half waves as long as the body are too high by about {:.1} %, of the n-th by n^2 of it, and deflections too small by about as much. Take `beam`",
            body.name,
            100.0 * part
        ),
        weight: part,
    })
}

/// Curvature vectors of an undeformed axis, 1/m, with their fractions of it.
fn curvatures(body: &BodySpec) -> impl Iterator<Item = (f64, Vector)> {
    let line = &body.line;
    let tangent = |place: usize| line.at(place as f64 / PLACES as f64).1.normalize();
    let span = line.length() / PLACES as f64;
    (0..PLACES).map(move |place| {
        let fraction = (place as f64 + 0.5) / PLACES as f64;
        (fraction, (tangent(place + 1) - tangent(place)) / span)
    })
}

/// Distances of the outermost fibres along y and z, m, where both are known or only the first one counts.
fn outermost(body: &BodySpec, shape: SectionShape) -> Option<[f64; 2]> {
    Some(match shape {
        SectionShape::Circle { radius } | SectionShape::Tube { radius, .. } => [radius; 2],
        SectionShape::Rectangle { sizes } => sizes.map(|size| 0.5 * size),
        SectionShape::Numbers { .. } => return None,
        SectionShape::General { extent: [y, z], .. } => [y?, if body.dimension() == 2 { 0.0 } else { z? }],
    })
}

/// A body whose axis is curved so much that stresses at its inner side are larger than those of a straight one, which are told.
fn stressed_inside(along: &Along<'_>) -> Option<Warning> {
    let body = along.body;
    let depths = curvatures(body).map(|(fraction, curvature)| {
        let outermost = outermost(body, along.at(fraction).shape)?;
        if !body.has_section() {
            return Some(outermost[0] * curvature.norm());
        }
        let axes = body.section(fraction);
        let depths = (0..2).map(|axis| outermost[axis] * axes[axis].dot(&curvature).abs());
        Some(depths.sum())
    });
    let depth = depths.flatten().fold(0.0, f64::max);
    let part = INNER * depth;
    (along.is_slender() && part.is_finite() && part > TOLD_OF_STRESS).then(|| Warning {
        text: format!(
            "body `{}`: its outermost fibre is {depth:.2} of the radius of its axis away from that: stresses of bending and torsion are those of a straight bar, and larger at the inner side by about {:.0} %. Multiply them by the factor of Winkler or Wahl",
            body.name,
            100.0 * part
        ),
        weight: part,
    })
}
