//! Tables along an axis that the elements of a body are too long to see.

use crate::emitted::Table;
use crate::model::Warning;
use crate::scene::MeshScene;

/// Rows for each element from which on a table is finer than the mesh.
const FINER: usize = 2;

impl MeshScene {
    /// Bodies with a step of a table inside of an element, or with far more rows than elements, one warning for each table.
    pub(crate) fn coarse_meshes(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            let spec = &body.spec;
            for table in self.parts.tables(index) {
                let name = table.name;
                let rows = table.places.len();
                let told = if let Some(x) = self.hidden_step(index, table) {
                    format!(
                        "a step of table `{name}` at x = {x:.6} m lies inside of an element, which sees it at its points of integration alone"
                    )
                } else if rows > FINER * spec.count + 1 {
                    format!(
                        "table `{name}` has {rows} rows and the body {} elements, which see it at their points of integration alone",
                        spec.count
                    )
                } else {
                    continue;
                };
                warnings.push(Warning {
                    text: format!(
                        "body `{}`: {told}: let nodes stand at the rows, `mesh at {} * ..`, or take more elements",
                        spec.label(),
                        table.declared_name()
                    ),
                    weight: rows as f64 / spec.count as f64,
                });
            }
        }
        warnings
    }

    /// Where the first step of a table is that is no node of a body, m.
    fn hidden_step(&self, body: usize, table: &Table) -> Option<f64> {
        let spec = &self.bodies[body].spec;
        let length = spec.line.length();
        let inside = table.steps(length).filter(|fraction| (0.0..1.0).contains(fraction));
        let mut hidden = inside.filter(|&fraction| spec.find(fraction).1 > 1e-9);
        hidden.next().map(|fraction| fraction * length)
    }
}
