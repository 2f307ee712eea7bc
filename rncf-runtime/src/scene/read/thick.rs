//! Sections that do not fit their bodies: mostly a second moment in another unit than meant.

use crate::model::Warning;
use crate::scene::MeshScene;

impl MeshScene {
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
