//! Ends that are one node start at one place.

use crate::emitted::BodySpec;
use crate::error::ModelError;
use crate::scene::MeshScene;
use crate::scene::numbering::shared::{Shared, VECTORS};
use crate::space::Vector;

/// How far apart ends may start, as a part of the shorter body's length.
const APART: f64 = 0.01;

/// Angle between directions at the start of ends that are one, rad (10 degrees).
const TURNED: f64 = 10.0 * std::f64::consts::PI / 180.0;

impl MeshScene {
    /// Refuses ends that are one and start apart.
    pub(crate) fn check_shared(&self, shared: &Shared) -> Result<(), ModelError> {
        let specs: Vec<&BodySpec> = self.bodies.iter().map(|body| &body.spec).collect();
        for (index, spec) in shared.specs.iter().enumerate() {
            let at = spec
                .ends
                .map(|(body, at_end)| self.initial_vectors(body, f64::from(u8::from(at_end)))[0]);
            let lengths = spec.ends.map(|(body, _)| specs[body].line.length());
            let Some((what, cure)) = misplaced(at, lengths[0].min(lengths[1]), spec.smooth) else {
                continue;
            };
            let specs: Vec<BodySpec> = specs.iter().map(|&spec| spec.clone()).collect();
            return Err(ModelError::new(format!(
                "{} {what}: {cure}",
                shared.describe(index, &specs)
            )));
        }
        Ok(())
    }
}

/// Why ends do not meet along their axes, and across them.
const LINES: &str = "let the bodies' lines or initial shapes meet there";
const SECTIONS: &str = "their sections are turned about the axis, by `section_y` or `twist`: let these meet there";

/// How two ends that are one differ at the start, in words, and what cures it; vectors in the order of [`VECTORS`].
fn misplaced([first, second]: [[Vector; 4]; 2], length: f64, smooth: bool) -> Option<(String, &'static str)> {
    let gap = (first[0] - second[0]).norm();
    if gap > APART * length {
        return Some((format!("has ends that start {gap:.3e} m apart"), LINES));
    }
    let directions = (1..VECTORS.len()).filter(|_| smooth);
    directions.into_iter().find_map(|place| {
        let (a, b) = (first[place], second[place]);
        let angle = a.cross(&b).norm().atan2(a.dot(&b));
        (angle > TURNED).then(|| {
            let name = VECTORS[place].2;
            let what = format!(
                "has ends whose {name} differs by {:.1} degrees at the start, and they would be one",
                angle.to_degrees()
            );
            // The slope comes first: where it fits, the axes do.
            (what, if place == 1 { LINES } else { SECTIONS })
        })
    })
}
