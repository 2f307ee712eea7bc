//! Mass, centre of mass and inertia of every body and of all: what an engineer checks before believing a result.
//! With `r = N_a q_a` the second moments are `integral rho r r^T = M^ab q_a q_b^T`, slopes included.

use crate::model::MassProperties;
use crate::scene::MeshScene;
use crate::scene::bodies::nodal_mass::{Padded, padded, spread};
use crate::space::{Matrix, Vector};

/// Sums over particles, places from a reference point, inertial axes.
#[derive(Clone, Copy, Default)]
struct Moments {
    /// kg.
    mass: f64,
    /// kg m.
    first: Vector,
    /// `integral rho r r^T`, kg m^2.
    second: Matrix,
}

/// Of `integral rho r r^T` the inertia `integral rho (r.r 1 - r r^T)`, and the other way round with half the trace.
fn turned(second: Matrix, share: f64) -> Matrix {
    Matrix::from_diagonal_element(share * second.trace()) - second
}

impl Moments {
    fn plus(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            first: self.first + other.first,
            second: self.second + other.second,
        }
    }

    /// The same of what is seen from a point at `arm`, here given with places relative to that point.
    fn carried(self, arm: Vector) -> Self {
        let mixed = arm * self.first.transpose() + self.first * arm.transpose();
        Self {
            mass: self.mass,
            first: self.first + self.mass * arm,
            second: self.second + mixed + self.mass * arm * arm.transpose(),
        }
    }

    fn properties(self, name: String, reference: Vector) -> MassProperties {
        let centre = 1.0 / self.mass * self.first;
        let second = self.second - self.mass * centre * centre.transpose();
        MassProperties {
            name,
            mass: self.mass,
            centre: reference + centre,
            inertia: turned(second, 1.0),
        }
    }
}

impl MeshScene {
    /// At the loaded state: bodies, then what moves freely and has inertia of its own.
    pub(crate) fn masses_loaded(&self) -> Vec<MassProperties> {
        // A point among the bodies: far from the origin nothing cancels.
        let frames = self.bodies.iter().map(|body| body.frame);
        let reference = match frames
            .chain(self.frames.free.iter().map(|frame| frame.spec.frame))
            .next()
        {
            Some(frame) => self.buffers.frames[frame].position,
            None => return Vec::new(),
        };
        let mut all = Moments::default();
        let mut told = Vec::new();
        let mut meet = |name: String, moments: Moments| {
            if moments.mass > 0.0 {
                all = all.plus(moments);
                told.push(moments.properties(name, reference));
            }
        };
        for (index, body) in self.bodies.iter().enumerate() {
            meet(body.spec.label(), self.moments_of_body(index, reference));
        }
        for frame in &self.frames.free {
            let (rigid, motion) = (&frame.spec.rigid, &self.buffers.frames[frame.spec.frame]);
            let axes = motion.rotation;
            let second = turned(rigid.inertia, 0.5);
            let own = Moments {
                mass: rigid.mass,
                first: axes * rigid.moment,
                second: (axes * second) * axes.transpose(),
            };
            meet(
                self.parts.frame_name(frame.spec.frame).to_owned(),
                own.carried(motion.position - reference),
            );
        }
        if told.len() > 1 {
            told.push(all.properties(String::new(), reference));
        }
        told
    }

    fn moments_of_body(&self, index: usize, reference: Vector) -> Moments {
        let body = &self.bodies[index];
        let (mass, frame) = (&body.whole_mass, &self.buffers.frames[body.frame]);
        let first = self.layout.offset(body.first_vector);
        let place = |vector: usize| -> Vector {
            let [x, y, z, _]: Padded = spread(body.spec.axes, &self.buffers.q[first..], vector);
            let q = if mass.is_position(vector) {
                Vector::new(x, y, z) + body.offset
            } else {
                Vector::new(x, y, z)
            };
            frame.direction_to_inertial(q)
        };
        let places: Vec<Vector> = (0..mass.vectors()).map(place).collect();
        let padded: Vec<[Padded; 1]> = places.iter().map(|&place| [padded(place)]).collect();
        let mut own = Moments::default();
        for (vector, at) in places.iter().enumerate() {
            let [[x, y, z, _]] = mass.product(vector, &padded);
            if mass.is_position(vector) {
                own.mass += mass.first(vector);
            }
            own.first += mass.first(vector) * *at;
            own.second += at * Vector::new(x, y, z).transpose();
        }
        let components = first..first + body.spec.vectors() * body.spec.dimension();
        let at = [&self.buffers.q, &self.buffers.v].map(|full| &full[components.clone()]);
        if let Some(sums) = body.modes.as_ref().and_then(|modes| modes.inertial(frame.spin, at)) {
            let axes = frame.rotation;
            let second = turned(sums.inertia, 0.5);
            own = own.plus(Moments {
                mass: sums.mass,
                first: axes * sums.moment,
                second: (axes * second) * axes.transpose(),
            });
        }
        own.carried(frame.position - reference)
    }
}
