//! Elasticity and damping of elements, by their emitted kernels; of bodies in linear modes by these.

use super::force::{At, Force};
use crate::scene::bodies::described::Kernels;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::bodies::nodal_mass::Transport;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::numbering::units::Lanes;
use crate::scene::pieces::batches::Blocks;
use crate::scene::pieces::buffers::Buffers;
use crate::scene::pieces::combination::Combination;
use crate::scene::pieces::combined::Combined;
use crate::space::Vector;
use crate::system::Tangent;

/// Elements. With their derivatives they add what turning frames make of the mass that they carry: one pass adds
/// everything.
pub(crate) struct Elasticity;

impl Force for Elasticity {
    fn couple(&self, scene: &MeshScene, entries: &mut Vec<(usize, usize)>) {
        for body in &scene.bodies {
            body.connectivity.add_entries(&scene.layout, entries);
        }
    }

    fn add(&self, scene: &mut MeshScene, _: &At) {
        scene.add_elastic_forces();
    }

    fn add_tangent(&self, scene: &mut MeshScene, _: &At, out: &mut Tangent) {
        let [damping, stiffness] = [1, 2].map(Combination::only);
        let (by_place, by_rate) = (&mut out.stiffness, &mut out.damping);
        let blocks = |transport: &Transport| Blocks {
            by_place: stiffness.block(transport),
            by_rate: damping.block(transport),
        };
        scene.each_element_tangent(blocks, |body, element, [k, c], lane, damps| {
            body.scatter.add_by(element, k, |lanes| lanes[lane], by_place);
            if damps {
                body.scatter.add_by(element, c, |lanes| lanes[lane], by_rate);
            }
        });
    }

    fn add_combined(&self, scene: &mut MeshScene, _: &At, out: &mut Combined) {
        let combination = out.combination;
        let [_, g, k] = combination.factors;
        let blocks = |transport: &Transport| {
            let block = combination.block(transport);
            let divided = |factor: f64| block / factor;
            let mut blocks = Blocks::default();
            if k != 0.0 {
                blocks.by_place = divided(k);
            } else if g != 0.0 {
                blocks.by_rate = divided(g);
            }
            blocks
        };
        let values = &mut *out.values;
        scene.each_element_tangent(blocks, |body, element, [by_place, by_rate], lane, damps| {
            body.scatter.add_by(element, by_place, |lanes| k * lanes[lane], values);
            if damps {
                body.scatter.add_by(element, by_rate, |lanes| g * lanes[lane], values);
            }
        });
    }
}

impl MeshScene {
    fn add_elastic_forces(&mut self) {
        let Buffers { q, v, force, lanes, .. } = &mut self.buffers;
        for group in &self.tabulated.groups {
            let body = &self.bodies[group.body];
            match &body.modes {
                Some(_) if self.in_modes => {}
                // What the description that runs is made of, not what the elements make of its shape.
                Some(modes) if modes.is_linear() => {
                    let first = self.layout.offset(body.first_vector);
                    let own = first..first + modes.shape().len();
                    let elements = Kernels {
                        parts: &*self.parts,
                        body: group.body,
                    };
                    modes.add_linear_forces(&elements, [&q[own.clone()], &v[own.clone()]], &mut force[own]);
                }
                _ => group.add_forces(&*self.parts, [q, v], lanes, force),
            }
        }
    }

    /// Adds the stiffness of the elements alone at the loaded state, on the pattern.
    pub(crate) fn add_elastic_stiffness(&mut self, out: &mut [f64]) {
        self.each_element_tangent(
            |_| Blocks::default(),
            |body, element, [by_place, _], lane, _| {
                body.scatter.add_by(element, by_place, |lanes| lanes[lane], out);
            },
        );
    }

    /// Calls for every element with its elastic derivatives, see [`Group::each_tangent`](crate::scene::pieces::batches::Group::each_tangent).
    pub(crate) fn each_element_tangent(
        &mut self,
        blocks: impl Fn(&Transport) -> Blocks,
        mut call: impl FnMut(&MeshBody, usize, [&[Lanes]; 2], usize, bool),
    ) {
        let Buffers {
            q, v, frames, lanes, ..
        } = &mut self.buffers;
        for group in &self.tabulated.groups {
            let body = &self.bodies[group.body];
            if self.in_modes && body.modes.is_some() {
                continue;
            }
            let axes = body.spec.axes;
            let blocks = blocks(&Transport::new(&frames[body.frame], axes, Vector::zeros()));
            let bodies = &self.bodies;
            group.each_tangent(
                &*self.parts,
                axes,
                [q, v],
                &blocks,
                lanes,
                |(body, element), both, lane, damps| {
                    call(&bodies[body], element, both, lane, damps);
                },
            );
        }
    }
}
