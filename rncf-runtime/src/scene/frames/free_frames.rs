//! Free frames with their unknowns: from the state to a pose, and from a pose to the state.

use super::lean::References;
use super::ties;
use crate::emitted::{BodySpec, FrameMotion, FrameTie, FreeSpec, Motions, Parts, RigidSpec};
use crate::error::ModelError;
use crate::model::{Formulation, Pose};
use crate::scene::frames::directions::{Direction, directions, unit};
use crate::space::{Matrix, Rotation, Vector, exp, from_matrix, matrix, product, three, turned};

/// Largest change of a rotation matrix, or part of a velocity out of a plane, that counts as round-off.
/// Frame axes of spatial things.
pub(crate) const SPATIAL: &[usize] = &[0, 1, 2];
const ROUND_OFF: f64 = 1e-9;
/// Distance of a start, in lengths of what the frame carries, beyond which positions count from a point
/// that moves on uniformly.
const FAR: f64 = 1e4;
/// Times at which a parent is looked at for whether it turns, s; the kinks of the model are added.
const LOOKS: [f64; 7] = [0.0, 1e-2, 0.13, 1.0, 7.3, 61.0, 1009.0];

/// A free frame and its unknowns.
#[derive(Clone, Debug)]
pub struct FreeFrame {
    /// As declared.
    pub spec: FreeSpec,
    /// Its place among the declared free frames.
    pub place: usize,
    /// First of its unknowns among those of all free frames.
    pub first: usize,
    /// What every unknown moves.
    pub directions: Vec<Direction>,
    /// Index among the orientations of the state, for three unknown rotations.
    pub turn: Option<usize>,
    /// Pose and velocities at t = 0.
    pub start: Pose,
    /// Rotation at the angle zero, of planar and hinged frames.
    base: Rotation,
    /// Velocity of the point that positions count from, m/s, inertial axes.
    drift: Vector,
}

impl FreeFrame {
    /// A free frame whose parent moves as given at t = 0; its unknowns are not numbered yet.
    ///
    /// # Errors
    /// A start out of the plane that the frame keeps, by name.
    pub fn new(spec: FreeSpec, place: usize, name: &str, parent: &FrameMotion) -> Result<Self, ModelError> {
        let carrier = from_matrix(&parent.rotation);
        let relative = exp(spec.angle * spec.axis);
        let (mut base, mut rotation) = (carrier, product(&carrier, &relative));
        let mut spin = matrix(&relative).tr_mul(&parent.spin) + spec.spin;
        if let Some(axis) = angle_axis(spec.motions) {
            base = carrier;
            rotation = turned(&carrier, spec.angle * axis);
            spin = matrix(&exp(spec.angle * axis)).tr_mul(&parent.spin) + spec.spin;
        }
        if spec.motions == Motions::State {
            rotation = carrier;
        }
        let start = Pose {
            position: parent.point_to_inertial(spec.position),
            rotation,
            angle: spec.angle,
            velocity: parent.velocity + parent.direction_to_inertial(parent.spin.cross(&spec.position) + spec.velocity),
            spin,
        };
        check_plane(&spec, name, parent, &start)?;
        let directions = directions(spec.motions);
        if carrier == Rotation::identity() {
            base = Rotation::identity();
        }
        Ok(Self {
            spec,
            place,
            first: 0,
            directions,
            turn: None,
            start,
            base,
            drift: Vector::zeros(),
        })
    }

    /// Number of unknowns.
    pub fn count(&self) -> usize {
        self.directions.len()
    }

    /// Number of unknown positions: they stand first.
    pub fn shifts(&self) -> usize {
        self.directions
            .iter()
            .filter(|direction| direction.shift != Vector::zeros())
            .count()
    }

    /// Whether the origin is that of the parent all the time.
    fn is_carried(&self) -> bool {
        matches!(self.spec.motions, Motions::Turning | Motions::Hinged { .. })
    }

    /// Whether it can turn.
    pub fn turns(&self) -> bool {
        let mut directions = self.directions.iter();
        directions.any(|direction| direction.turn != Vector::zeros())
    }

    /// Whether it is a state: a number, which moves nothing.
    pub fn is_state(&self) -> bool {
        self.spec.motions == Motions::State
    }

    /// Place of the angle, or of the state, among the frame's unknowns, where there is one.
    pub fn angle(&self) -> Option<usize> {
        let is_number = self.is_state() || angle_axis(self.spec.motions).is_some();
        is_number.then(|| self.count() - 1)
    }

    /// Lets positions count from a point that moves on with the velocity of the start where that is far
    /// away: more than 1e4 times `length` (m), that of what the frame carries. There the round-off of a
    /// position would be felt, and the motion is an orbit. Nearby what starts fast may stay bounded,
    /// and would leave such a point behind.
    pub fn follow(&mut self, length: f64) {
        if self.start.position.norm() > FAR * length {
            self.drift = self.start.velocity;
        }
    }

    /// Motion at time `t` (s) from the frame's own unknowns and their rates; `turn` is the orientation of
    /// the state at which the three rotations vanish. Unknown positions are displacements x from the
    /// start, which moves on with the drift u: `r = r_0 + u t + x`, `dr/dt = u + dx/dt`.
    pub fn motion(&self, t: f64, parent: &FrameMotion, turn: Rotation, [x, v, a]: [&[f64]; 3]) -> FrameMotion {
        let mut motion = FrameMotion::INERTIAL;
        motion.position = self.start.position;
        if self.is_carried() {
            motion.position = parent.position;
            motion.velocity = parent.velocity;
            motion.acceleration = parent.acceleration;
            motion.jerk = parent.jerk;
        }
        for (place, direction) in self.directions.iter().enumerate() {
            for axis in 0..3 {
                let shift = direction.shift[axis];
                motion.position[axis] += shift * (self.drift[axis] * t + x[place]);
                motion.velocity[axis] += shift * (self.drift[axis] + v[place]);
                motion.acceleration[axis] += shift * a[place];
                motion.spin[axis] += direction.turn[axis] * v[place];
                motion.spin_rate[axis] += direction.turn[axis] * a[place];
            }
        }
        motion.rotation = matrix(&self.rotation(turn, x));
        motion
    }

    /// Position and velocity of the origin at time `t` (s), inertial axes, from the point that the positions of `base` count
    /// from: starts are subtracted from each other before anything is added.
    pub fn relative(&self, base: &Self, t: f64, [x, v]: [&[f64]; 2]) -> [Vector; 2] {
        let mut velocity = self.drift - base.drift;
        let mut position = self.start.position - base.start.position + t * velocity;
        for ((direction, x), v) in self.directions.iter().zip(x).zip(v) {
            position += *x * direction.shift;
            velocity += *v * direction.shift;
        }
        [position, velocity]
    }

    /// A position and velocity in space at time `t` (s) from the point that the positions of this frame count from.
    pub fn seen(&self, t: f64, position: Vector, velocity: Vector) -> [Vector; 2] {
        let from = self.start.position + t * self.drift;
        [position - from, velocity - self.drift]
    }

    /// Sum of the sizes of what the position of the origin at time `t` (s) is made of, m; from the point of `base`, if
    /// given.
    pub fn terms(&self, base: Option<&Self>, t: f64, x: &[f64]) -> f64 {
        let (start, drift) = match base {
            Some(base) => (self.start.position - base.start.position, self.drift - base.drift),
            None => (self.start.position, self.drift),
        };
        let moved: f64 = x.iter().take(self.shifts()).map(|x| x.abs()).sum();
        start.norm() + t.abs() * drift.norm() + moved
    }

    fn rotation(&self, turn: Rotation, x: &[f64]) -> Rotation {
        if self.turn.is_some() {
            let first = self.shifts();
            turned(&turn, three(x, first))
        } else if let (Some(axis), Some(place)) = (angle_axis(self.spec.motions), self.angle()) {
            turned(&self.base, x[place] * axis)
        } else {
            self.start.rotation
        }
    }

    /// Rotation at the angle zero, of planar and hinged frames.
    pub fn rotation_at_zero(&self) -> Rotation {
        self.base
    }

    /// Rates of the unknowns at a velocity of the origin (inertial axes) and an angular velocity (frame axes).
    pub fn rates(&self, velocity: Vector, spin: Vector, v: &mut [f64]) {
        let shifting = velocity - self.drift;
        for (rate, direction) in v.iter_mut().zip(&self.directions) {
            *rate = direction.shift.dot(&shifting) + direction.turn.dot(&spin);
        }
    }

    /// Unknowns and rates of a pose at time `t` (s); rotation vectors are zero, [`Pose::rotation`] goes to
    /// the state.
    pub fn unknowns(&self, t: f64, pose: &Pose, x: &mut [f64], v: &mut [f64]) {
        let moved = pose.position - self.start.position - t * self.drift;
        for (value, direction) in x.iter_mut().zip(&self.directions) {
            *value = direction.shift.dot(&moved);
        }
        self.rates(pose.velocity, pose.spin, v);
        if let Some(place) = self.angle() {
            x[place] = pose.angle;
        }
    }

    /// Pose from a motion and the unknowns that it was made of.
    pub fn pose(&self, motion: &FrameMotion, x: &[f64]) -> Pose {
        Pose {
            position: motion.position,
            rotation: from_matrix(&motion.rotation),
            angle: self.angle().and_then(|place| x.get(place).copied()).unwrap_or_default(),
            velocity: motion.velocity,
            spin: motion.spin,
        }
    }

    /// The unknown in the user's words.
    pub fn describe(&self, name: &str, place: usize) -> String {
        const AXES: [&str; 3] = ["x", "y", "z"];
        if self.is_state() {
            return format!("state `{name}`");
        }
        let owner = if self.spec.is_body { "rigid body" } else { "frame" };
        let direction = &self.directions[place];
        let axis = |vector: Vector| (0..3).find(|&axis| vector == unit(axis));
        let what = match (axis(direction.shift), axis(direction.turn)) {
            (Some(axis), _) => format!("position {}", AXES[axis]),
            (None, Some(axis)) => format!("rotation about {}", AXES[axis]),
            (None, None) => "rotation about its axis".to_string(),
        };
        format!("{owner} `{name}`, {what}")
    }

    /// Whether it has inertia of its own.
    pub fn has_rigid_parts(&self) -> bool {
        let rigid = &self.spec.rigid;
        rigid.mass != 0.0 || rigid.inertia != Matrix::zeros()
    }

    /// Motion at its start.
    pub fn started(&self) -> FrameMotion {
        FrameMotion {
            velocity: self.start.velocity,
            spin: self.start.spin,
            ..self.fixed()
        }
    }

    /// What the frame does at its start, at rest there: where it is no unknown.
    pub fn fixed(&self) -> FrameMotion {
        FrameMotion {
            position: self.start.position,
            rotation: matrix(&self.start.rotation),
            ..FrameMotion::INERTIAL
        }
    }
}

/// All frames of a model at t = 0.
pub struct Frames {
    /// Free frames with their unknowns.
    pub free: Vec<FreeFrame>,
    /// For every frame its index among the free ones.
    pub free_of: Vec<Option<usize>>,
    /// Free frames that are no unknowns: they follow a body, or nothing needs them.
    pub fixed: Vec<FreeFrame>,
    /// Motions of all frames at t = 0.
    pub motions: Vec<FrameMotion>,
}

impl Frames {
    /// Numbers the free frames of a model with these bodies.
    ///
    /// # Errors
    /// A frame whose parent, plane or body does not fit its motions, by name.
    pub fn new(parts: &dyn Parts, bodies: &[BodySpec], formulation: Formulation) -> Result<Self, ModelError> {
        let mut motions = vec![FrameMotion::INERTIAL; parts.frame_count()];
        parts.frames(0.0, &mut motions);
        check_motions(parts, &motions)?;
        let mut frames = Self {
            free: Vec::new(),
            free_of: vec![None; motions.len()],
            fixed: Vec::new(),
            motions,
        };
        let specs = parts.free();
        let references = (formulation == Formulation::Ancf).then(|| References::new(parts, bodies));
        let (mut first, mut turns) = (0, 0);
        for (place, spec) in specs.iter().enumerate() {
            let name = parts.frame_name(spec.frame);
            check_numbers(spec, name)?;
            check_parent(parts, &specs, spec)?;
            let mut frame = FreeFrame::new(spec.clone(), place, name, &frames.motions[spec.parent])?;
            let mut follows = false;
            for body in bodies.iter().filter(|body| body.frame == spec.frame) {
                check_plane_of(body, name, spec.motions)?;
                if body.tie != FrameTie::Joints {
                    ties::check(body, name, frame.count())?;
                    follows = true;
                }
            }
            frames.motions[spec.frame] = frame.started();
            let is_left_out = |references: &References| follows || references.leaves_out(spec, bodies, &specs);
            let may_be_left_out = !frame.has_rigid_parts() && !frame.is_state();
            if references.as_ref().is_some_and(is_left_out) && may_be_left_out {
                frames.fixed.push(frame);
                continue;
            }
            frame.first = first;
            first += frame.count();
            if matches!(spec.motions, Motions::Spatial | Motions::Turning) {
                frame.turn = Some(turns);
                turns += 1;
            }
            frames.free_of[spec.frame] = Some(frames.free.len());
            frames.free.push(frame);
        }
        Ok(frames)
    }
}

/// Prescribed motions have numbers at the start.
fn check_motions(parts: &dyn Parts, motions: &[FrameMotion]) -> Result<(), ModelError> {
    let free = declared_free(parts);
    let Some(frame) = (0..motions.len()).find(|&frame| !free[frame] && !motions[frame].is_finite()) else {
        return Ok(());
    };
    Err(ModelError::new(format!(
        "the motion of frame `{}` or one of its derivatives is not finite at t = 0: check its functions of time, the rows of its tables and its parameters",
        parts.frame_name(frame)
    )))
}

/// Whether each frame was declared free.
pub fn declared_free(parts: &dyn Parts) -> Vec<bool> {
    let mut free = vec![false; parts.frame_count()];
    for spec in parts.free() {
        free[spec.frame] = true;
    }
    free
}

/// A planar body needs a frame that keeps its plane.
fn check_plane_of(body: &BodySpec, name: &str, motions: Motions) -> Result<(), ModelError> {
    let [first, second] = *body.axes else {
        return Ok(());
    };
    let normal = 3 - first - second;
    let keeps = match motions {
        Motions::Planar { normal: other } | Motions::ShiftingPlanar { normal: other } => other == normal,
        Motions::Hinged { axis } => axis.cross(&unit(normal)).norm() <= ROUND_OFF,
        Motions::Shifting | Motions::State => true,
        Motions::Spatial | Motions::Turning => false,
    };
    if keeps {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "body `{}` is planar, but frame `{name}` does not keep its plane: free the frame in that plane only, or mesh the body in space",
        body.label()
    )))
}

/// Axis (frame axes) of frames with one angle.
pub fn angle_axis(motions: Motions) -> Option<Vector> {
    match motions {
        Motions::Planar { normal } => Some(unit(normal)),
        Motions::Hinged { axis } => Some(axis),
        _ => None,
    }
}

/// Axis normal to the plane that a frame keeps.
pub fn normal_of(motions: Motions) -> Option<usize> {
    match motions {
        Motions::Planar { normal } | Motions::ShiftingPlanar { normal } => Some(normal),
        _ => None,
    }
}

/// Start and rigid parts are finite, masses not negative, axes of turning unit vectors.
fn check_numbers(spec: &FreeSpec, name: &str) -> Result<(), ModelError> {
    let refuse = |what: &str| {
        Err(ModelError::new(format!(
            "frame `{name}`: {what}; check the values and parameters of its declaration"
        )))
    };
    let RigidSpec { mass, moment, inertia } = spec.rigid;
    let start = [spec.position, spec.axis, spec.velocity, spec.spin, moment];
    let all = start.iter().flatten().chain(&inertia).chain([&spec.angle, &mass]);
    if !all.into_iter().all(|value| value.is_finite()) {
        return refuse("a number of its start or of its rigid parts is not finite");
    }
    if spec.motions == Motions::State {
        return Ok(());
    }
    if mass < 0.0 || (0..3).any(|axis| inertia[(axis, axis)] < 0.0) {
        return refuse("its mass or moment of inertia is negative");
    }
    let axis = angle_axis(spec.motions).unwrap_or(spec.axis);
    let turned = spec.angle != 0.0 || angle_axis(spec.motions).is_some();
    if turned && (axis.norm() - 1.0).abs() > ROUND_OFF {
        return refuse("the axis that it turns about is no unit vector");
    }
    Ok(())
}

/// A planar frame starts in its plane, with velocities in it.
fn check_plane(spec: &FreeSpec, name: &str, parent: &FrameMotion, start: &Pose) -> Result<(), ModelError> {
    let Some(normal) = normal_of(spec.motions) else {
        return Ok(());
    };
    let letter = ["x", "y", "z"][normal];
    let tilt = (parent.direction_to_inertial(unit(normal)) - unit(normal)).norm();
    if tilt > ROUND_OFF {
        return Err(ModelError::new(format!(
            "frame `{name}` moves in the plane normal to {letter}, but its parent's axis {letter} is not the inertial one at t = 0: turn the parent about {letter} only, or free the frame in space"
        )));
    }
    let across = start.velocity[normal].abs() > ROUND_OFF * start.velocity.norm();
    let tumbling = unit(normal).cross(&start.spin);
    if across || tumbling.norm() > ROUND_OFF * start.spin.norm() {
        return Err(ModelError::new(format!(
            "frame `{name}` moves in the plane normal to {letter}, but starts with a velocity out of it: leave that component away, or free the frame in space"
        )));
    }
    Ok(())
}

/// Checks that the parent of a frame is prescribed, and does not turn where it carries the origin.
///
/// # Errors
/// The frame and its parent by name.
pub fn check_parent(parts: &dyn Parts, free: &[FreeSpec], spec: &FreeSpec) -> Result<(), ModelError> {
    let (name, parent) = (parts.frame_name(spec.frame), parts.frame_name(spec.parent));
    if free.iter().any(|other| other.frame == spec.parent) {
        return Err(ModelError::new(format!(
            "frame `{name}` starts relative to frame `{parent}`, which is free itself: give it a prescribed parent"
        )));
    }
    if !matches!(spec.motions, Motions::Turning | Motions::Hinged { .. }) {
        return Ok(());
    }
    let mut frames = vec![FrameMotion::INERTIAL; parts.frame_count()];
    let mut at = |t: f64| {
        parts.frames(t, &mut frames);
        frames[spec.parent]
    };
    let first = at(0.0).rotation;
    let times = parts
        .kinks()
        .into_iter()
        .filter(|t| t.is_finite())
        .flat_map(|t| [t, t + 1e-2]);
    for t in LOOKS.into_iter().chain(times) {
        let motion = at(t);
        let turned = (0..3).any(|row| (motion.rotation.row(row) - first.row(row)).norm() > ROUND_OFF);
        if turned || motion.spin.norm() > ROUND_OFF {
            return Err(ModelError::new(format!(
                "frame `{name}` turns about the origin of frame `{parent}`, which turns itself: choose a parent that only shifts"
            )));
        }
    }
    Ok(())
}
