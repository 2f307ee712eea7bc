//! The bodies of a scene as they are described.

use crate::emitted::Line;
use crate::model::DescribedBody;
use crate::scene::MeshScene;

impl MeshScene {
    /// The meshed bodies of the declaration in its order; those from files have no mesh, and are as they are.
    pub(crate) fn described_bodies(&self) -> Vec<DescribedBody> {
        let mut all: Vec<DescribedBody> = Vec::new();
        let loaded = self.loaded_bodies();
        for (index, body) in self.bodies.iter().enumerate() {
            let is_loaded = loaded.contains(&index);
            let spec = &body.spec;
            if matches!(spec.line, Line::Nodes(_)) {
                continue;
            }
            match all
                .last_mut()
                .filter(|last| spec.instance.is_some() && last.name == spec.name)
            {
                Some(last) => {
                    last.repetitions = last.repetitions.map(|count| count + 1);
                    last.elements += spec.count;
                    last.is_loaded |= is_loaded;
                }
                None => all.push(DescribedBody {
                    name: spec.name,
                    repetitions: spec.instance.map(|_| 1),
                    fidelity: spec.fidelity,
                    elements: spec.count,
                    is_loaded,
                }),
            }
        }
        all
    }

    /// The bodies that loads per length act on.
    pub(crate) fn loaded_bodies(&self) -> Vec<usize> {
        self.parts.distributed().iter().map(|load| load.body).collect()
    }
}
