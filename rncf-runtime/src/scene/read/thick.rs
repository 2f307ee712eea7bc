//! Sections that do not fit their bodies: mostly a second moment in another unit than meant.

use crate::model::Warning;
use crate::scene::MeshScene;

/// Places of an axis at which its curvature is looked at.
const PLACES: usize = 32;
/// Part by which a moment turns a curved beam too far, from which on that is told.
const TOLD: f64 = 0.01;
/// Vectors of a node of a `cable`: others have axes of a section.
const WITHOUT_SECTION: usize = 2;

impl MeshScene {
    /// Beams of a shape whose axes are curved so much that their strains are not those of a thin one: bending is measured by the axes of the section, `r_x . r_y'`,
    /// which a moment on a curved axis stretches, too. It turns the axis by the part `2 curvature^2 I / A` more.
    pub(crate) fn thick_curves(&self) -> Vec<Warning> {
        let mut told: Vec<&str> = Vec::new();
        let mut warnings = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            let (line, section) = (&body.spec.line, self.section_spec(index, 0.0));
            let moment = section.second_moments.iter().copied().fold(0.0, f64::max);
            let tangent = |place: usize| line.at(place as f64 / PLACES as f64).1.normalize();
            let span = line.length() / PLACES as f64;
            let curvatures = (0..PLACES).map(|place| (tangent(place + 1) - tangent(place)).norm() / span);
            let curvature = curvatures.fold(0.0, f64::max);
            let part = 2.0 * curvature.powi(2) * moment / section.area;
            let has_section = body.spec.vectors_per_node > WITHOUT_SECTION;
            if has_section && part.is_finite() && part > TOLD && !told.contains(&body.spec.name) {
                told.push(body.spec.name);
                warnings.push(Warning {
                    text: format!(
                        "body `{}`: its section is so thick beside the radius of its axis, {:.3e} m, that a moment turns it too far by {:.1} %: strains of a `beam` with a shape are those of a thin one. Give its section in numbers (`EA`, `GJ`, `EIy`, ..)",
                        body.spec.name,
                        1.0 / curvature,
                        100.0 * part
                    ),
                    weight: part,
                });
            }
        }
        warnings
    }

    /// Bodies whose sections' radius of gyration is longer than they are, one of each name.
    pub(crate) fn thick_sections(&self) -> Vec<Warning> {
        let mut told: Vec<&str> = Vec::new();
        let mut warnings = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            let section = self.section_spec(index, 0.0);
            let moment = section.second_moments.iter().copied().fold(0.0, f64::max);
            let (radius, length) = ((moment / section.area).sqrt(), body.spec.line.length());
            // Not where one of them is unknown.
            if radius.is_finite() && radius > length && !told.contains(&body.spec.name) {
                told.push(body.spec.name);
                warnings.push(Warning {
                    text: format!(
                        "body `{}`: the radius of gyration of its section, sqrt(second_moment / area) = {radius:.3e} m, is longer than the body ({length:.3e} m), which no slender body has: are these the units of `second_moment` and `area`?",
                        body.spec.name
                    ),
                    weight: radius / length,
                });
            }
        }
        warnings
    }
}
