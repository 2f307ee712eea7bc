//! What is not declared to start in the rotation that a uniform motion has.

use super::steady::{differs, turning};
use crate::model::{Kind, Uniform};
use crate::scene::MeshScene;
use crate::space::Vector;

impl MeshScene {
    /// See [`Scene::starting_otherwise`](crate::model::Scene::starting_otherwise).
    pub(crate) fn not_starting_in_rotation(&self, at: &Uniform) -> Vec<String> {
        let begin = Uniform { t: 0.0, ..at.whole() };
        let spin = match (at.kind, at.spin, self.rotation(&begin)) {
            (Kind::Steady, None, Ok(spin)) if spin.velocity != Vector::zeros() => spin,
            // A rotation that is given takes the place of starts.
            _ => return Vec::new(),
        };
        let frames = self.motions(0.0);
        let is_otherwise = |&place: &usize| {
            let free = &self.frames.free[place];
            let motion = &frames[free.spec.frame];
            if free.is_state() {
                false
            } else if free.turns() {
                differs(turning(motion), spin.velocity)
            } else {
                differs(motion.velocity, spin.velocity.cross(&(motion.position - spin.point)))
            }
        };
        let otherwise = (0..self.frames.free.len()).filter(is_otherwise);
        otherwise
            .map(|place| self.parts.frame_name(self.frames.free[place].spec.frame).to_string())
            .collect()
    }
}
