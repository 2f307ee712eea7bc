//! What joints exert on the bodies and free frames that they hold. Reactions there balance each other, so that none is known better than the largest.

use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::{Linked, Marker};

/// Largest force (N) and moment (N m) of a reaction, by bodies and frames.
pub(super) struct Exerted {
    bodies: Vec<[f64; 2]>,
    frames: Vec<[f64; 2]>,
}

/// What a joint holds, which moves.
#[derive(Clone, Copy)]
pub(super) enum Held {
    Body(usize),
    Frame(usize),
}

impl Exerted {
    fn meet(&mut self, held: Held, [force, moment]: [f64; 2]) {
        let largest = match held {
            Held::Body(body) => &mut self.bodies[body],
            Held::Frame(frame) => &mut self.frames[frame],
        };
        *largest = [largest[0].max(force), largest[1].max(moment)];
    }

    /// The largest force and moment on any of these.
    pub fn largest(&self, held: &mut dyn Iterator<Item = Held>) -> [f64; 2] {
        let on = held.map(|held| match held {
            Held::Body(body) => self.bodies[body],
            Held::Frame(frame) => self.frames[frame],
        });
        on.fold([0.0; 2], |most, on| [most[0].max(on[0]), most[1].max(on[1])])
    }
}

impl MeshScene {
    /// At the loaded state; forces must be evaluated.
    pub(super) fn exerted(&self, t: f64, lambda: &[f64]) -> Exerted {
        let mut exerted = Exerted {
            bodies: vec![[0.0; 2]; self.bodies.len()],
            frames: vec![[0.0; 2]; self.buffers.frames.len()],
        };
        for (position, linked) in self.links.constraints.iter().enumerate() {
            let reaction = self
                .constraint_reaction(position, t, lambda)
                .map(|vector| vector.norm());
            for held in self.held_by(linked) {
                exerted.meet(held, reaction);
            }
        }
        for (joint, spec) in self.joints.iter().enumerate() {
            let reaction = [false, true].map(|moment| self.reaction(joint, moment, t, lambda).norm());
            exerted.meet(Held::Body(spec.body), reaction);
        }
        exerted
    }

    /// What a constraint on markers holds; frames that are prescribed carry what they have to.
    pub(super) fn held_by<'s>(&'s self, linked: &'s Linked) -> impl Iterator<Item = Held> + 's {
        linked
            .spec
            .markers
            .iter()
            .filter_map(|&marker| match &self.links.markers[marker] {
                Marker::Body { point, .. } | Marker::Section { point, .. } | Marker::SectionTurn { point } => {
                    Some(Held::Body(point.body))
                }
                Marker::Fixed { frame, .. } | Marker::Turn { frame } => {
                    self.frames.free_of[*frame].map(|_| Held::Frame(*frame))
                }
                Marker::Angle { free } => Some(Held::Frame(self.frames.free[*free].spec.frame)),
            })
    }
}
