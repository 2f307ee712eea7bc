//! Mass, centre of mass and inertia of every body and of all: what an engineer checks before believing a result.
//! With `r = N_a q_a` the second moments are `integral rho r r^T = M^ab q_a q_b^T`, slopes included.

use crate::model::MassProperties;
use crate::scene::MeshScene;
use crate::scene::bodies::nodal_mass::{Padded, spread};
use crate::vector::{Matrix, Vector, add, apply, identity, multiply, scale, subtract, transpose};

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

/// `a b^T`.
fn outer(a: Vector, b: Vector) -> Matrix {
    a.map(|a| scale(a, b))
}

fn sum(a: Matrix, b: Matrix) -> Matrix {
    [0, 1, 2].map(|row| add(a[row], b[row]))
}

/// Of `integral rho r r^T` the inertia `integral rho (r.r 1 - r r^T)`, and the other way round with half the trace.
fn turned(second: Matrix, share: f64) -> Matrix {
    let trace = share * (second[0][0] + second[1][1] + second[2][2]);
    let mut inertia = second.map(|row| scale(-1.0, row));
    for (axis, row) in inertia.iter_mut().enumerate() {
        row[axis] += trace;
    }
    inertia
}

impl Moments {
    fn plus(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            first: add(self.first, other.first),
            second: sum(self.second, other.second),
        }
    }

    /// The same of what is seen from a point at `arm`, here given with places relative to that point.
    fn carried(self, arm: Vector) -> Self {
        let mixed = sum(outer(arm, self.first), outer(self.first, arm));
        Self {
            mass: self.mass,
            first: add(self.first, scale(self.mass, arm)),
            second: sum(sum(self.second, mixed), outer(scale(self.mass, arm), arm)),
        }
    }

    fn properties(self, name: String, reference: Vector) -> MassProperties {
        let centre = scale(1.0 / self.mass, self.first);
        let second = sum(self.second, outer(scale(-self.mass, centre), centre));
        MassProperties {
            name,
            mass: self.mass,
            centre: add(reference, centre),
            inertia: turned(second, 1.0),
        }
    }
}

impl MeshScene {
    /// At the loaded state: bodies, then what moves freely and has inertia of its own.
    pub(crate) fn masses_loaded(&self) -> Vec<MassProperties> {
        // A point among the bodies: far from the origin nothing cancels.
        let frames = self.bodies.iter().map(|body| body.frame);
        let reference = match frames.chain(self.free.iter().map(|frame| frame.spec.frame)).next() {
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
        for frame in &self.free {
            let (rigid, motion) = (&frame.spec.rigid, &self.buffers.frames[frame.spec.frame]);
            let axes: Matrix = transpose(&[0, 1, 2].map(|axis| {
                let mut unit = [0.0; 3];
                unit[axis] = 1.0;
                motion.direction_to_inertial(unit)
            }));
            let second = turned(rigid.inertia, 0.5);
            let own = Moments {
                mass: rigid.mass,
                first: apply(&axes, rigid.moment),
                second: multiply(&multiply(&axes, &second), &transpose(&axes)),
            };
            meet(
                self.parts.frame_name(frame.spec.frame).to_owned(),
                own.carried(subtract(motion.position, reference)),
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
                add([x, y, z], body.offset)
            } else {
                [x, y, z]
            };
            frame.direction_to_inertial(q)
        };
        let places: Vec<Vector> = (0..mass.vectors()).map(place).collect();
        let padded: Vec<[Padded; 1]> = places.iter().map(|[x, y, z]| [[*x, *y, *z, 0.0]]).collect();
        let mut own = Moments::default();
        for (vector, at) in places.iter().enumerate() {
            let [[x, y, z, _]] = mass.product(vector, &padded);
            if mass.is_position(vector) {
                own.mass += mass.first(vector);
            }
            own.first = add(own.first, scale(mass.first(vector), *at));
            own.second = sum(own.second, outer(*at, [x, y, z]));
        }
        let components = first..first + body.spec.vectors() * body.spec.dimension();
        let at = [&self.buffers.q, &self.buffers.v].map(|full| &full[components.clone()]);
        if let Some(sums) = body.modes.as_ref().and_then(|modes| modes.inertial(frame.spin, at)) {
            let axes: Matrix = transpose(&identity().map(|unit| frame.direction_to_inertial(unit)));
            let second = turned(sums.inertia, 0.5);
            own = own.plus(Moments {
                mass: sums.mass,
                first: apply(&axes, sums.moment),
                second: multiply(&multiply(&axes, &second), &transpose(&axes)),
            });
        }
        own.carried(subtract(frame.position, reference))
    }
}
