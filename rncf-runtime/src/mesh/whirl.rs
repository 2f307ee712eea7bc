//! Circulation of the bodies' points about the axis of a uniform rotation, from the shape of a mode.

use super::scene::MeshScene;
use crate::equilibrium::Uniform;
use crate::modes::circulation;
use crate::system::State;
use crate::vector::{Vector, add, cross, norm, perpendicular, scale};

impl MeshScene {
    /// Circulation of all nodes, of the origins of free frames, and of two points of every rigid body
    /// on both sides of its origin along the axis, as far away as its radius of gyration: they see the
    /// body's tilt.
    pub(super) fn circulation_of(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Option<f64> {
        let spin = scale(at.speed(), self.rotation(at).unwrap_or_default().velocity);
        let speed = norm(spin);
        if speed == 0.0 {
            return None;
        }
        let axis = scale(1.0 / speed, spin);
        self.load_uniform(at, state);
        let [real, imaginary] = [0, 1].map(|part| {
            let unknowns: Vec<f64> = shape.iter().map(|value| value[part]).collect();
            self.displacements(&unknowns, axis)
        });
        let pairs = real.into_iter().zip(imaginary);
        let points: Vec<[[f64; 2]; 3]> = pairs.map(|(re, im)| std::array::from_fn(|i| [re[i], im[i]])).collect();
        let first = perpendicular(axis);
        circulation(&points, first, cross(axis, first))
    }

    /// Displacements of the points at the loaded state, inertial axes, by increments of the unknowns.
    fn displacements(&self, unknowns: &[f64], axis: Vector) -> Vec<Vector> {
        let mut full = vec![0.0; self.layout.components()];
        self.layout.expand(unknowns, &mut full);
        let border = self.layout.vector_components();
        let moves: Vec<[Vector; 2]> = self
            .free
            .iter()
            .map(|frame| {
                let own = &full[border + frame.first..][..frame.count()];
                let parts = frame.directions.iter().zip(own);
                parts.fold([[0.0; 3]; 2], |[shift, turn], (direction, &value)| {
                    [
                        add(shift, scale(value, direction.shift)),
                        add(turn, scale(value, direction.turn)),
                    ]
                })
            })
            .collect();
        let mut points = Vec::new();
        for body in &self.bodies {
            let frame = &self.buffers.frames[body.frame];
            let [shift, turn] = self.free_of[body.frame].map_or([[0.0; 3]; 2], |free| moves[free]);
            for within in 0..body.spec.vectors() {
                let (_, local) = body.spec.locate(within);
                if !body.spec.nodal[local].is_position() {
                    continue;
                }
                let place = self.layout.offset(body.first_vector + within);
                let vector = |values: &[f64]| {
                    let mut components = [0.0; 3];
                    components[..body.spec.dimension()].copy_from_slice(&values[place..][..body.spec.dimension()]);
                    body.spread(components)
                };
                let position = add(body.offset, vector(&self.buffers.q));
                let change = add(vector(&full), cross(turn, position));
                points.push(add(shift, frame.direction_to_inertial(change)));
            }
        }
        for (frame, &[shift, turn]) in self.free.iter().zip(&moves) {
            points.push(shift);
            let rigid = &frame.spec.rigid;
            let trace = (0..3).map(|i| rigid.inertia[i][i]).sum::<f64>();
            if trace > 0.0 {
                // A body with inertia alone is given a unit mass: all of its points tell the same.
                let mass = if rigid.mass > 0.0 { rigid.mass } else { 1.0 };
                let turn = self.buffers.frames[frame.spec.frame].direction_to_inertial(turn);
                let tilt = scale((0.5 * trace / mass).sqrt(), cross(turn, axis));
                points.extend([1.0, -1.0].map(|side| add(shift, scale(side, tilt))));
            }
        }
        points
    }
}
