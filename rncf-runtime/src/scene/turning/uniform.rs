//! Uniform motions of a scene and small motions about them (THEORY 8.1, 8.2).

use crate::emitted::FrameMotion;
use crate::linalg::Pattern;
use crate::model::{FrameState, Kind, Pose, Scene, Uniform};
use crate::scene::frames::free_frames::angle_axis;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::buffers::Regime;
use crate::space::{Rotation, Vector, exp, from_matrix, matrix, product};
use crate::system::{State, Tangent};

/// What co-rotating perturbations y of the unknowns of one free frame are: `dv = y' + velocity y`,
/// `da = y'' + coriolis y' + acceleration y`; k x k, rows first.
pub(crate) struct Corotation {
    /// First of the frame's unknowns.
    pub first: usize,
    count: usize,
    velocity: Vec<f64>,
    coriolis: Vec<f64>,
    acceleration: Vec<f64>,
}

impl Corotation {
    /// Adds what a co-rotating perturbation and its rate add to velocities and accelerations beside the rates themselves.
    pub fn add_rates(&self, [place, rate]: [&[f64]; 2], [v, a]: [&mut [f64]; 2]) {
        let (first, k) = (self.first, self.count);
        for i in 0..k {
            for j in 0..k {
                let (entry, by) = (i * k + j, first + j);
                v[first + i] += self.velocity[entry] * place[by];
                a[first + i] += self.coriolis[entry] * rate[by] + self.acceleration[entry] * place[by];
            }
        }
    }

    /// Turns derivatives by unknowns at constant velocities into those by co-rotating perturbations:
    /// `K += C velocity + M acceleration`, `C += M coriolis`.
    pub fn apply(&self, pattern: &Pattern, out: &mut Tangent) {
        let k = self.count;
        let columns = self.first..self.first + k;
        let mut rows: Vec<usize> = columns
            .clone()
            .flat_map(|column| &pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]])
            .copied()
            .collect();
        rows.sort_unstable();
        rows.dedup();
        for row in rows {
            let places: Vec<Option<usize>> = columns.clone().map(|column| pattern.find(row, column)).collect();
            let of = |values: &[f64]| -> Vec<f64> {
                let value = |place: &Option<usize>| place.map_or(0.0, |place| values[place]);
                places.iter().map(value).collect()
            };
            let [mass, damping] = [of(&out.mass), of(&out.damping)];
            for (j, place) in places.iter().enumerate() {
                let Some(place) = *place else { continue };
                for i in 0..k {
                    out.stiffness[place] +=
                        damping[i] * self.velocity[i * k + j] + mass[i] * self.acceleration[i * k + j];
                    out.damping[place] += mass[i] * self.coriolis[i * k + j];
                }
            }
        }
    }
}

/// What becomes of the increments of one free frame's unknowns when the system is turned; k x k, rows first.
pub(crate) struct Carried {
    /// First of the frame's unknowns.
    pub first: usize,
    count: usize,
    turned: Vec<f64>,
}

impl Carried {
    /// Turns increments of all unknowns.
    pub fn apply(&self, shape: &mut [[f64; 2]]) {
        let k = self.count;
        let own = &mut shape[self.first..self.first + k];
        let before = own.to_vec();
        for (row, value) in own.iter_mut().enumerate() {
            let entries = &self.turned[row * k..(row + 1) * k];
            *value = [0, 1].map(|part| entries.iter().zip(&before).map(|(entry, of)| entry * of[part]).sum());
        }
    }
}

impl MeshScene {
    /// Fills the full state of a uniform motion.
    pub(crate) fn load_uniform(&mut self, at: &Uniform, state: &State) {
        let unknowns = [&state.x[..], &state.v, &state.a];
        self.load(at.t, &state.turns, unknowns, Regime::Uniform(at.speed()));
    }

    /// Velocities and accelerations of the uniform motion.
    pub(crate) fn set_uniform(&mut self, at: &Uniform, state: &mut State) {
        state.t = at.t;
        state.v.fill(0.0);
        state.a.fill(0.0);
        // Where there is no common rotation the obstacle says so.
        let spin = self.rotation(at).unwrap_or_default();
        let turning = at.speed() * spin.velocity;
        self.load_uniform(at, state);
        let border = self.layout.unknowns() - self.layout.border();
        for frame in &self.frames.free {
            let motion = &self.buffers.frames[frame.spec.frame];
            let velocity = turning.cross(&(motion.position - spin.point));
            let acceleration = turning.cross(&velocity);
            let within = motion.direction_to_frame(turning);
            let own = border + frame.first..border + frame.first + frame.count();
            frame.rates(velocity, within, &mut state.v[own.clone()]);
            for (rate, direction) in state.a[own].iter_mut().zip(&frame.directions) {
                *rate = direction.shift.dot(&acceleration);
            }
        }
    }

    /// What co-rotating perturbations of the free frames are, at the loaded state.
    pub(crate) fn corotations(&self, at: &Uniform) -> Vec<Corotation> {
        let spin = self.rotation(at).unwrap_or_default();
        let turning = at.speed() * spin.velocity;
        if turning == Vector::zeros() {
            return Vec::new();
        }
        let border = self.layout.unknowns() - self.layout.border();
        let frames = self.frames.free.iter().map(|frame| {
            let within = self.buffers.frames[frame.spec.frame].direction_to_frame(turning);
            let k = frame.count();
            let product = |shifts: &dyn Fn(Vector) -> Vector, turns: &dyn Fn(Vector) -> Vector| -> Vec<f64> {
                let directions = &frame.directions;
                let entry = |place: usize| {
                    let (row, column) = (&directions[place / k], &directions[place % k]);
                    row.shift.dot(&shifts(column.shift)) + row.turn.dot(&turns(column.turn))
                };
                (0..k * k).map(entry).collect()
            };
            let carried = |shift: Vector| turning.cross(&shift);
            let turned = |turn: Vector| within.cross(&turn);
            Corotation {
                first: border + frame.first,
                count: k,
                velocity: product(&carried, &turned),
                coriolis: product(&|shift| 2.0 * carried(shift), &turned),
                acceleration: product(&|shift| carried(carried(shift)), &|_| Vector::zeros()),
            }
        });
        frames.collect()
    }

    /// Tangents at the loaded uniform motion at constant velocities, what modal bodies make excluded.
    pub(crate) fn uniform_tangent(&mut self, at: &Uniform, state: &State, out: &mut Tangent) {
        self.full_tangent(at.t, at.load(), out);
        self.add_constraint_stiffness(at.t, &state.lambda, out);
        self.hold_normals(out);
    }

    /// The declared start at the time of `at`, at rest in the frames; what moves freely is carried on with
    /// the prescribed frames since t = 0.
    pub(crate) fn guess(&self, at: &Uniform) -> State {
        let [q, v] = self.initial_shape();
        let mut poses = vec![Pose::default(); self.frames.free.len() + self.frames.fixed.len()];
        let carrier = self.carrier(at);
        for frame in self.frames.free.iter().chain(&self.frames.fixed) {
            let axis = angle_axis(frame.spec.motions).unwrap_or_default();
            poses[frame.place] = carrier.pose(&frame.start, axis);
        }
        self.unknowns_from(at.t, &q, &vec![0.0; v.len()], &poses)
    }

    /// A state whose free frames are carried on with what turns since t = 0, or `back` to there: so states at the same
    /// time of motions with different parameters are next to each other.
    pub(crate) fn carried_state(&mut self, at: &Uniform, state: &State, back: bool) -> State {
        let mut carrier = self.carrier(at);
        if self.frames.free.is_empty() || carrier.is_still() {
            return state.clone();
        }
        if back {
            carrier = carrier.inverse();
        }
        let FrameState { t, q, v, mut poses } = self.frame_state(state);
        for frame in self.frames.free.iter().chain(&self.frames.fixed) {
            let axis = angle_axis(frame.spec.motions).unwrap_or_default();
            poses[frame.place] = carrier.pose(&poses[frame.place], axis);
        }
        let mut carried = self.unknowns_from(t, &q, &v, &poses);
        carried.lambda.clone_from(&state.lambda);
        carried
    }

    /// What [`MeshScene::carried_state`] makes of increments of the unknowns: positions of free frames have inertial axes, turns have those of the body.
    pub(crate) fn carried_increments(&self, at: &Uniform, back: bool) -> Vec<Carried> {
        let mut carrier = self.carrier(at);
        if carrier.is_still() {
            return Vec::new();
        }
        if back {
            carrier = carrier.inverse();
        }
        let turn = matrix(&carrier.turn);
        let border = self.layout.unknowns() - self.layout.border();
        let turning = self.frames.free.iter().filter(|frame| !frame.is_state());
        let frames = turning.map(|frame| {
            let (directions, k) = (&frame.directions, frame.count());
            let entry = |place: usize| {
                let (row, column) = (&directions[place / k], &directions[place % k]);
                row.shift.dot(&(turn * column.shift)) + row.turn.dot(&column.turn)
            };
            Carried {
                first: border + frame.first,
                count: k,
                turned: (0..k * k).map(entry).collect(),
            }
        });
        frames.collect()
    }

    /// Where what moves freely has been carried since t = 0: with the first prescribed frame that turns,
    /// else uniformly with the declared rotation.
    fn carrier(&self, at: &Uniform) -> Carrier {
        let still = Carrier {
            turn: Rotation::identity(),
            from: Vector::zeros(),
            to: Vector::zeros(),
            turned: Vector::zeros(),
        };
        let moving = Uniform::steady(at.t);
        let Ok(spin) = self.rotation(&Uniform {
            spin: at.spin,
            ..moving
        }) else {
            return still;
        };
        if at.t == 0.0 || spin.velocity == Vector::zeros() {
            return still;
        }
        let turned = at.t * spin.velocity;
        let [before, after] = [0.0, at.t].map(|t| self.motions(t));
        let prescribed = (0..before.len()).filter(|&frame| self.frames.free_of[frame].is_none());
        let rotation = |frame: &FrameMotion| from_matrix(&frame.rotation);
        for frame in prescribed {
            let (before, after) = (&before[frame], &after[frame]);
            if after.spin != Vector::zeros() {
                return Carrier {
                    turn: product(&rotation(after), &rotation(before).inverse()),
                    from: before.position,
                    to: after.position,
                    turned,
                };
            }
        }
        if at.kind == Kind::Static {
            return still;
        }
        Carrier {
            turn: exp(turned),
            from: spin.point,
            to: spin.point,
            turned,
        }
    }
}

/// A rigid displacement.
struct Carrier {
    turn: Rotation,
    from: Vector,
    to: Vector,
    /// Rotation vector beyond half a turn, rad, about as much as `turn`.
    turned: Vector,
}

impl Carrier {
    fn is_still(&self) -> bool {
        self.turned == Vector::zeros() && self.from == self.to
    }

    fn inverse(&self) -> Self {
        Self {
            turn: self.turn.inverse(),
            from: self.to,
            to: self.from,
            turned: -self.turned,
        }
    }

    /// The pose behind the displacement, of a frame that may turn about an own axis by an angle.
    fn pose(&self, pose: &Pose, axis: Vector) -> Pose {
        let within = |vector| axis.dot(&matrix(&pose.rotation).tr_mul(&vector));
        Pose {
            position: self.point(pose.position),
            rotation: product(&self.turn, &pose.rotation),
            angle: pose.angle + nearest(within(self.turn.scaled_axis()), within(self.turned)),
            ..*pose
        }
    }

    fn point(&self, point: Vector) -> Vector {
        self.to + matrix(&self.turn) * (point - self.from)
    }
}

/// An angle (rad) with as many full turns more as bring it nearest to another one.
fn nearest(angle: f64, wanted: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle + turn * ((wanted - angle) / turn).round()
}
