//! Whether joints hold a body that does not deform: where they let it turn, it would hang in the air.

use super::body::Nodal;
use crate::emitted::Fidelity;
use crate::error::ModelError;
use crate::linalg::symmetric_eigen;
use crate::scene::MeshScene;

/// Part of a rigid motion, squared, below which joints do not hinder it.
const FREE: f64 = 1e-12;
/// Displacement, squared, below which a motion is none: turning about a straight centre line.
const NONE: f64 = 1e-9;

impl MeshScene {
    /// Refuses a body without deformation that its joints let move in its frame: it has no unknowns for that. In a free
    /// frame of its own it moves with the frame.
    pub(super) fn check_hanging(&self, index: usize, nodal: &Nodal) -> Result<(), ModelError> {
        let spec = &self.bodies[index].spec;
        let word = match spec.fidelity {
            Fidelity::Rigid => "rigid",
            Fidelity::Point => "point",
            _ => return Ok(()),
        };
        let is_held = self
            .conditions
            .iter()
            .any(|condition| self.joints[condition.joint].body == index);
        let is_carried = self.frames.free_of[spec.frame].is_some_and(|free| {
            let alone = self.bodies.iter().filter(|body| body.spec.frame == spec.frame).count() == 1;
            !is_held || alone && !self.frames.free[free].has_rigid_parts()
        });
        if is_carried || !nodal.is_loose() {
            return Ok(());
        }
        Err(ModelError::new(format!(
            "body `{}` is described as `{word}`, but its joints let it move in its frame `{}`, and `{word}` has no unknown for that, so that it would hang still: clamp it, leave `{word}` out, or declare a `rigid` of its mass and join that",
            spec.label(),
            self.parts.frame_name(spec.frame)
        )))
    }
}

impl Nodal {
    /// Whether eliminated conditions leave the undeformed body a rigid motion.
    fn is_loose(&self) -> bool {
        let motions = self.rigid_motions();
        let count = motions.len();
        let rest: Vec<Vec<f64>> = motions.iter().map(|motion| self.hindered(motion)).collect();
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let gram = |vectors: &[Vec<f64>]| -> Vec<f64> {
            let pairs = (0..count * count).map(|entry| product(&vectors[entry / count], &vectors[entry % count]));
            pairs.collect()
        };
        let Ok((values, vectors)) = symmetric_eigen(count, &gram(&rest)) else {
            return false;
        };
        let most = motions.iter().map(|motion| product(motion, motion)).fold(0.0, f64::max);
        let moves = |combination: &Vec<f64>| {
            let mut sum = vec![0.0; motions[0].len()];
            for (factor, motion) in combination.iter().zip(&motions) {
                sum.iter_mut()
                    .zip(motion)
                    .for_each(|(sum, value)| *sum += factor * value);
            }
            product(&sum, &sum) > NONE * most
        };
        values
            .iter()
            .zip(&vectors)
            .any(|(value, vector)| *value <= FREE * most && moves(vector))
    }

    /// Displacements of all components in unit translations and rotations; lengths over the body's extent.
    fn rigid_motions(&self) -> Vec<Vec<f64>> {
        let d = self.dimension;
        let size = self.extent();
        let vector = |a: usize| &self.shape[a * d..(a + 1) * d];
        let planes: &[[usize; 2]] = if d == 2 { &[[0, 1]] } else { &[[0, 1], [1, 2], [2, 0]] };
        let mut motions = Vec::new();
        for axis in 0..d {
            let of = |component: usize| {
                if component % d == axis {
                    self.whole[component / d]
                } else {
                    0.0
                }
            };
            motions.push((0..self.shape.len()).map(of).collect());
        }
        for &[i, j] in planes {
            let of = |component: usize| {
                let (a, axis) = (component / d, component % d);
                let scale = if self.whole[a] == 0.0 { 1.0 } else { 1.0 / size };
                match axis {
                    _ if axis == i => -scale * vector(a)[j],
                    _ if axis == j => scale * vector(a)[i],
                    _ => 0.0,
                }
            };
            motions.push((0..self.shape.len()).map(of).collect());
        }
        motions
    }

    /// What of a displacement the freedoms cannot do: the rest of least squares. The columns of E are orthogonal.
    fn hindered(&self, motion: &[f64]) -> Vec<f64> {
        let mut squares = vec![0.0; self.freedoms];
        for &(freedom, factor) in self.map.iter().flatten() {
            squares[freedom] += factor * factor;
        }
        let along = self.reduced(motion).into_iter().zip(squares);
        let image = self.expanded(&[along.map(|(sum, square)| sum / square.max(f64::MIN_POSITIVE)).collect()]);
        motion.iter().zip(image).map(|(motion, image)| motion - image).collect()
    }
}
