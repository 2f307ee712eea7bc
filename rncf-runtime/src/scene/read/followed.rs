//! Poses of frames that follow a body in absolute coordinates. There they are no unknowns: outputs find the pose from the
//! body, as the one in which the conditions of [`Tie`] hold, on the branch that goes on from the start.

use crate::emitted::{FrameMotion, FrameTie};
use crate::linalg::{solve_full, symmetric_eigen};
use crate::scene::MeshScene;
use crate::scene::frames::ties::{self, Tie};
use crate::space::{Matrix, Rotation, Vector, exp, from_rows, matrix, perpendicular, product};

impl MeshScene {
    /// Sets the frames that follow bodies at the loaded state.
    pub(crate) fn follow(&mut self) {
        for place in 0..self.frames.followed.len() {
            let frame = self.bodies[self.frames.followed[place].body].spec.frame;
            let tie = &self.frames.followed[place];
            if let Some(motion) = self.pose_of(tie).and_then(|pose| self.moving(tie, pose)) {
                self.buffers.frames[frame] = motion;
            }
        }
    }

    /// The pose that a tie asks for, at rest.
    fn pose_of(&self, tie: &Tie) -> Option<FrameMotion> {
        let body = &self.bodies[tie.body];
        let spec = &body.spec;
        let normal = spec.plane_normal();
        let at = |full: &[f64], place: usize| self.vector_at(body, full, tie.first + place);
        let moved = |place: usize| at(&self.buffers.q, place) + body.offset;
        let own = &self.frames.followed_shape[tie.first..];
        let declared = |place: usize| {
            let mut vector = Vector::zeros();
            for (value, &axis) in own[place..].iter().zip(spec.axes) {
                vector[axis] = *value;
            }
            vector
        };
        // Centres, or starts, of the declared shape and of the present one.
        let ends = ties::ends(spec).map(|vector| vector * spec.dimension());
        let (mut from, mut to, mut mass) = (Vector::zeros(), Vector::zeros(), 0.0);
        if spec.tie == FrameTie::Chord {
            (from, to) = (declared(ends[0]), moved(ends[0]));
        } else {
            ties::each_mass(body, tie.first, |_, second, [is_first, is_second], value| {
                if is_first {
                    from += value * declared(second);
                    to += value * at(&self.buffers.q, second);
                    mass += if is_second { value } else { 0.0 };
                }
            });
            (from, to) = (1.0 / mass * from, 1.0 / mass * to + body.offset);
        }
        // B = M^ab R_b q_a^T, both from these points.
        let mut moments = Matrix::zeros();
        ties::each_mass(body, tie.first, |first, second, [is_first, is_second], value| {
            let mut q = declared(first);
            let mut r = at(&self.buffers.q, second);
            if is_first {
                q -= from;
            }
            if is_second {
                r = r + body.offset - to;
            }
            moments += value * r * q.transpose();
        });
        let rotation = if spec.tie == FrameTie::Chord {
            let was = declared(ends[1]) - from;
            let along = moved(ends[1]) - to;
            along_chord(&moments, [was, along].map(|way| 1.0 / way.norm() * way), normal)
        } else {
            nearest(&moments, normal)?
        };
        let motion = FrameMotion {
            position: to - rotation * from,
            rotation,
            ..FrameMotion::INERTIAL
        };
        motion.is_finite().then_some(motion)
    }

    /// The pose with the velocities for which the rates of the conditions vanish.
    fn moving(&self, tie: &Tie, pose: FrameMotion) -> Option<FrameMotion> {
        let body = &self.bodies[tie.body];
        let frame = self
            .frames
            .fixed
            .iter()
            .find(|frame| frame.spec.frame == body.spec.frame)?;
        let rates = |motion: &FrameMotion| -> Vec<f64> {
            let mut local = vec![0.0; body.spec.vectors() * body.spec.dimension()];
            for vector in 0..body.spec.vectors() {
                let place = vector * body.spec.dimension();
                let [mut q, mut v] =
                    [&self.buffers.q, &self.buffers.v].map(|full| self.vector_at(body, full, tie.first + place));
                if body.spec.nodal[body.spec.locate(vector).1].is_position() {
                    q = q + body.offset - motion.position;
                    v -= motion.velocity;
                }
                let rate = motion.rate_to_frame(q, v);
                for (component, &axis) in body.spec.axes.iter().enumerate() {
                    local[place + component] = rate[axis];
                }
            }
            tie.products(&local)
        };
        let still = rates(&pose);
        let size = frame.count();
        if still.len() != size {
            return None;
        }
        let mut matrix = vec![0.0; size * size];
        for (column, direction) in frame.directions.iter().enumerate() {
            let moved = FrameMotion {
                velocity: direction.shift,
                spin: direction.turn,
                ..pose
            };
            for (row, (with, without)) in rates(&moved).iter().zip(&still).enumerate() {
                matrix[row * size + column] = with - without;
            }
        }
        // The first column of the right sides; the others stay zero.
        let zero = vec![0.0; size * size];
        let mut right = zero.clone();
        (0..size).for_each(|row| right[row * size] = still[row]);
        let [found, _] = solve_full(size, &matrix, [&right, &zero])?;
        let mut motion = pose;
        for (row, direction) in frame.directions.iter().enumerate() {
            motion.velocity -= found[row * size] * direction.shift;
            motion.spin -= found[row * size] * direction.turn;
        }
        motion.is_finite().then_some(motion)
    }
}

/// Half the axial vector of `B - B^T`.
fn axial(b: &Matrix) -> Vector {
    Vector::new(b[(2, 1)] - b[(1, 2)], b[(0, 2)] - b[(2, 0)], b[(1, 0)] - b[(0, 1)])
}

/// The rotation A for which `tr(A^T B)` is largest: about the normal, or in space by Horn's quaternion.
fn nearest(b: &Matrix, normal: Option<Vector>) -> Option<Matrix> {
    let axial = axial(b);
    let trace = b.trace();
    if let Some(normal) = normal {
        return Some(matrix(&exp(axial.dot(&normal).atan2(trace) * normal)));
    }
    let mut k = vec![0.0; 16];
    k[0] = trace;
    for i in 0..3 {
        k[i + 1] = axial[i];
        k[4 * (i + 1)] = axial[i];
        for j in 0..3 {
            k[4 * (i + 1) + j + 1] = b[(i, j)] + b[(j, i)] - if i == j { trace } else { 0.0 };
        }
    }
    let (_, vectors) = symmetric_eigen(4, &k).ok()?;
    let [w, x, y, z]: [f64; 4] = vectors.last()?[..].try_into().ok()?;
    Some(from_rows(&[
        [
            w * w + x * x - y * y - z * z,
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            w * w - x * x + y * y - z * z,
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            w * w - x * x - y * y + z * z,
        ],
    ]))
}

/// The rotation that takes one direction to another and about it is the nearest.
fn along_chord(b: &Matrix, [was, along]: [Vector; 2], normal: Option<Vector>) -> Matrix {
    if let Some(normal) = normal {
        let angle = normal.dot(&was.cross(&along)).atan2(was.dot(&along));
        return matrix(&exp(angle * normal));
    }
    // Any rotation that takes the direction there, then one about it.
    let axis = was.cross(&along);
    let size = axis.norm();
    let first = if size > 0.0 {
        exp(size.atan2(was.dot(&along)) / size * axis)
    } else if was.dot(&along) > 0.0 {
        Rotation::identity()
    } else {
        exp(std::f64::consts::PI * perpendicular(was))
    };
    let b = b * matrix(&first).transpose();
    let axial = axial(&b);
    let across = b.trace() - along.dot(&(b * along));
    let about = exp(along.dot(&axial).atan2(across) * along);
    matrix(&product(&about, &first))
}
