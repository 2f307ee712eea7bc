//! Whether a relative equilibrium can exist: everything that acts on a body must be at rest in its
//! frame (THEORY 8.1).

use crate::emitted::{FrameMotion, JointKind, LoadKind};
use crate::error::Short;
use crate::model::{Kind, Spin, Uniform};
use crate::scene::MeshScene;
use crate::scene::numbering::conditions::Condition;
use crate::scene::pieces::displacement::Displacement;
use crate::scene::pieces::push::Law;
use crate::space::Vector;
use crate::system::State;

/// Relative size below which a change of a motion, or a load's component across the spin, counts as
/// zero.
const NEGLIGIBLE: f64 = 1e-9;

/// Time after which a uniform motion must still be the same, s.
const A_WHILE: f64 = 1e-3;

/// Times after which a load must still be the same, s: no period is a part of both.
const WHILES: [f64; 2] = [A_WHILE, 0.618_033_988_749_895 * A_WHILE];

/// Frames that turn about one axis.
pub(super) struct Turning {
    pub spin: Spin,
    /// Velocity along the axis, m/s, inertial axes.
    pub along: Vector,
    /// For every frame whether it is one of them.
    pub moved: Vec<bool>,
}

/// Whether two spins (rad/s) or accelerations (m/s^2) differ by more than round-off; a motion that
/// sets out smoothly from rest counts as uniform there.
pub(super) fn differs(a: Vector, b: Vector) -> bool {
    (a - b).norm() > NEGLIGIBLE * a.norm().max(b.norm()).max(1.0)
}

/// Angular velocity of a frame, inertial axes.
pub(super) fn turning(frame: &FrameMotion) -> Vector {
    frame.direction_to_inertial(frame.spin)
}

/// Velocity of a point (inertial) that is fixed in the frame.
fn carried(frame: &FrameMotion, point: Vector) -> Vector {
    frame.velocity + turning(frame).cross(&(point - frame.position))
}

/// The rotation of a frame that turns, about the point of its axis that is next to where the frame is.
fn spin_of(frame: &FrameMotion) -> Spin {
    let velocity = turning(frame);
    let point = frame.position + 1.0 / velocity.dot(&velocity) * velocity.cross(&frame.velocity);
    Spin { velocity, point }
}

impl MeshScene {
    /// The rotation of what moves freely, at scale 1; rest where nothing turns.
    ///
    /// # Errors
    /// Frames that do not turn together, by name.
    pub(crate) fn rotation(&self, at: &Uniform) -> Result<Spin, String> {
        if at.kind == Kind::Static {
            return Ok(Spin::default());
        }
        let frames = self.motions(at.t);
        let is_free = |&frame: &usize| self.frames.free_of[frame].is_some();
        let prescribed = (0..frames.len()).filter(|frame| !is_free(frame));
        if let Some(spin) = self.common(prescribed, &frames, at.spin)? {
            return Ok(at.spin.unwrap_or(spin));
        }
        if let Some(spin) = at.spin {
            if spin.velocity != Vector::zeros() && self.frames.free.is_empty() {
                return Err(
                    "nothing turns with the rotation that is given (`--spin`): leave that away, or put what turns into a frame that does, such as a `rotating` one".into(),
                );
            }
            return Ok(spin);
        }
        let free = (0..frames.len()).filter(is_free);
        let spin = self.common(free, &frames, None)?;
        Ok(spin.unwrap_or_default())
    }

    /// The rotation of all those frames that turn.
    fn common(
        &self,
        candidates: impl Iterator<Item = usize>,
        frames: &[FrameMotion],
        wanted: Option<Spin>,
    ) -> Result<Option<Spin>, String> {
        let mut found = wanted;
        let mut any = None;
        for index in candidates {
            let (frame, name) = (&frames[index], self.parts.frame_name(index));
            let velocity = turning(frame);
            let square = velocity.dot(&velocity);
            if square == 0.0 {
                continue;
            }
            let along = velocity.dot(&frame.velocity);
            if along.abs() > NEGLIGIBLE * velocity.norm() * frame.velocity.norm() {
                return Err(format!(
                    "frame `{name}` moves along the axis that it turns about: let it turn only"
                ));
            }
            let spin = spin_of(frame);
            let other = *found.get_or_insert(spin);
            any.get_or_insert(spin);
            let expected = other.velocity.cross(&(frame.position - other.point));
            if differs(velocity, other.velocity) || differs(frame.velocity, expected) {
                if wanted.is_some() {
                    return Err(format!(
                        "frame `{name}` turns in a prescribed way, with {:.6} rad/s, and not with the rotation that is given (`--spin`): leave that away, or give the model another speed",
                        velocity.norm()
                    ));
                }
                return Err(format!(
                    "frame `{name}` does not turn with the others: what moves freely needs one angular velocity and one axis in common; give the rotation, or frames that turn alike"
                ));
            }
        }
        Ok(any)
    }

    /// What stands against an equilibrium, by name.
    pub(crate) fn obstacle(&mut self, at: &Uniform, state: &State) -> Option<String> {
        if at.kind == Kind::Static {
            return None;
        }
        if let Some(name) = self.parts.timed_energy() {
            return Some(format!(
                "the strain energy of body `{name}` changes with time: give it a constant value"
            ));
        }
        let whole = at.whole();
        let spin = match self.rotation(&whole) {
            Ok(spin) => spin,
            Err(text) if self.is_coupled() || at.spin.is_some() => return Some(text),
            Err(_) => Spin::default(),
        };
        let mut prescribed = self.motions(at.t).into_iter();
        // Where nothing turns, loads are those of the time.
        let turns = spin.velocity != Vector::zeros() || prescribed.any(|frame| frame.spin != Vector::zeros());
        if let Some(told) = turns.then(|| self.varying(at.t)).flatten() {
            return Some(told);
        }
        let mut turning = state.clone();
        self.set_uniform(&whole, &mut turning);
        self.load_uniform(&whole, &turning);
        let mut frames = self.buffers.frames.clone();
        let later = self.motions(at.t + A_WHILE);
        for (index, motion) in self.motions(at.t).into_iter().enumerate() {
            if self.frames.free_of[index].is_none() {
                frames[index] = motion;
            }
        }
        let obstacle = self.unsteady(&frames, &later).or_else(|| self.unable(&spin, &frames));
        if obstacle.is_some() {
            return obstacle;
        }
        // What only shifts is carried about the axis, too.
        for frame in &self.frames.free {
            let motion = &mut frames[frame.spec.frame];
            motion.spin = motion.direction_to_frame(spin.velocity);
        }
        let variant = self.variant(&spin, at);
        (0..self.dead_loads.specs.len())
            .find_map(|index| self.load_obstacle(index, at.t, &frames))
            .or_else(|| {
                let conditions = self.conditions.iter();
                conditions
                    .map(|condition| self.joint_obstacle(condition, &frames))
                    .find_map(|found| found)
            })
            // Beyond the rows of a table nothing is as it was.
            .or_else(|| variant.map(|told| self.undefined_now(at.t).unwrap_or(told)))
    }

    /// A load that is another one a while later. One that has long been over, or has yet to come, is none of them.
    fn varying(&self, t: f64) -> Option<String> {
        let at = |index, t| self.parts.load(index, t);
        let varies = |&index: &usize| {
            self.parts.load_varies(index) && WHILES.iter().any(|later| at(index, t) != at(index, t + later))
        };
        let load = (0..self.dead_loads.specs.len()).find(varies);
        if let Some(index) = load {
            return Some(format!(
                "load `{}` varies with time: give it a constant value",
                self.dead_loads.specs[index].name
            ));
        }
        let name = self.timed_load(t)?;
        Some(format!("load `{name}` varies with time: give it a constant value"))
    }

    /// A constraint or force on markers that changes when what turns is turned on, what stands staying;
    /// at the loaded state.
    fn variant(&mut self, spin: &Spin, at: &Uniform) -> Option<String> {
        if spin.velocity == Vector::zeros()
            && let Some(name) = self.moved_by_time(at.t)
        {
            return Some(format!(
                "{name} moves at t = {} s, and nothing turns with it: let it rest at that time, or look at another one (`--at`)",
                Short(at.t)
            ));
        }
        for turning in self.turnings(spin) {
            let Some((name, is_timed)) = self.changed_by_turning(&turning, at.t) else {
                continue;
            };
            let motions = self.motions(at.t);
            let is_prescribed = at.spin.is_some()
                || (0..motions.len())
                    .any(|frame| self.frames.free_of[frame].is_none() && motions[frame].spin != Vector::zeros());
            let speed = Short(spin.velocity.norm());
            if is_timed {
                let cure = if is_prescribed {
                    "let it rest at that time"
                } else {
                    "start it with the rate of what drives it"
                };
                let from = if is_prescribed { "" } else { ", in which it starts" };
                return Some(format!(
                    "{name} moves at t = {} s, and not as the system turns, with {speed} rad/s{from}: {cure}, or look at another time (`--at`)",
                    Short(at.t)
                ));
            }
            let from = if is_prescribed {
                String::new()
            } else {
                format!(" with the {speed} rad/s in which it starts (`--spin \"0 rad/s\"` leaves it at rest)")
            };
            return Some(format!(
                "{name} does not stay the same while the system turns{from}: let it act alike in all directions across the axis, on the axis, or between things that turn"
            ));
        }
        None
    }

    /// Names of what acts or holds otherwise a while later, though nothing moves; at the state.
    pub(crate) fn timed(&mut self, at: &Uniform, state: &State) -> Vec<String> {
        self.load_uniform(at, state);
        let later = at.t + A_WHILE;
        let varies = |&load: &usize| self.parts.load(load, at.t) != self.parts.load(load, later);
        let loads = (0..self.dead_loads.specs.len()).filter(varies);
        let mut names: Vec<String> = loads
            .map(|load| format!("load `{}`", self.dead_loads.specs[load].name))
            .collect();
        names.extend(
            self.parts
                .timed_energy()
                .map(|body| format!("the strain energy of `{body}`")),
        );
        let still = self.while_nothing_moves();
        let before = self.undisplaced(at.t, &still.moved, still.later);
        names.extend(self.changes(&before, at.t, &still, usize::MAX));
        names
    }

    /// A joint or constraint that is another one a while later though nothing turns, by name.
    fn moved_by_time(&mut self, t: f64) -> Option<String> {
        let still = self.while_nothing_moves();
        let before = self.undisplaced(t, &still.moved, still.later).of_constraints();
        self.changed_from(&before, t, &still)
    }

    fn while_nothing_moves(&self) -> Displacement {
        Displacement {
            moved: vec![true; self.buffers.frames.len()],
            turn: Vector::zeros(),
            point: Vector::zeros(),
            shift: Vector::zeros(),
            is_own: false,
            later: Some(A_WHILE),
        }
    }

    /// What is another while it turns, by name, and whether for what it does over time.
    fn changed_by_turning(&mut self, turning: &Turning, t: f64) -> Option<(String, bool)> {
        let speed = turning.spin.velocity.norm();
        // Of drives the rate must be that of the rotation, of all else nothing may change at any angle.
        let narrow = self.angles_of_narrow_forces(turning);
        let angles = [0.7, 2.1, 4.4].into_iter().chain(narrow).map(|angle| (angle, 0.0));
        let rates = [A_WHILE, -0.5 * A_WHILE].map(|later| (speed * later, later));
        angles.chain(rates).find_map(|(angle, later)| {
            let displacement = Displacement {
                moved: turning.moved.clone(),
                turn: angle / speed * turning.spin.velocity,
                point: turning.spin.point,
                shift: angle / speed * turning.along,
                is_own: false,
                later: Some(later),
            };
            self.changed_by(t, &displacement).map(|name| (name, later != 0.0))
        })
    }

    /// What turns at the loaded state: all of it together where things in different frames act on each other, else each prescribed frame for itself.
    fn turnings(&self, spin: &Spin) -> Vec<Turning> {
        let frames = &self.buffers.frames;
        let turns = |index: usize| self.frames.free_of[index].is_some() || frames[index].spin != Vector::zeros();
        if self.is_coupled() {
            let moved = (0..frames.len()).map(turns).collect();
            let together = Turning {
                spin: *spin,
                along: Vector::zeros(),
                moved,
            };
            return if spin.velocity == Vector::zeros() {
                Vec::new()
            } else {
                vec![together]
            };
        }
        let alone = |index: usize| {
            let spin = spin_of(&frames[index]);
            let axis = spin.velocity.normalize();
            Turning {
                spin,
                along: axis * axis.dot(&frames[index].velocity),
                moved: (0..frames.len()).map(|other| other == index).collect(),
            }
        };
        (0..frames.len()).filter(|&index| turns(index)).map(alone).collect()
    }

    /// Whether things in different frames act on each other, or frames move freely: all must turn alike.
    fn is_coupled(&self) -> bool {
        let constraints = self.links.constraints.iter().map(|linked| linked.spec.markers);
        let mut users = constraints.chain(self.links.forces.iter().map(|force| &force.markers[..]));
        let frame = |marker: usize| self.marker_frame(&self.links.markers[marker]);
        // Loads at points depend on places and velocities in space.
        !self.frames.free.is_empty()
            || self.is_marked_elsewhere()
            || self
                .links
                .forces
                .iter()
                .any(|force| !matches!(force.law, Law::Force(_)))
            || users.any(|markers| markers.iter().any(|&marker| frame(marker) != frame(markers[0])))
    }

    /// A prescribed frame whose motion is not uniform.
    fn unsteady(&self, frames: &[FrameMotion], later: &[FrameMotion]) -> Option<String> {
        let coupled = self.is_coupled();
        let marked = |index: usize| {
            self.links
                .markers
                .iter()
                .any(|marker| self.marker_frame(marker) == index)
        };
        let used = |index: usize| self.bodies.iter().any(|body| body.spec.frame == index) || coupled && marked(index);
        let pull = |frame: &FrameMotion| frame.direction_to_frame(frame.acceleration);
        let prescribed = (0..frames.len()).filter(|&index| self.frames.free_of[index].is_none() && used(index));
        for index in prescribed {
            let (frame, next) = (&frames[index], &later[index]);
            let shifts = frame.velocity != Vector::zeros() || frame.acceleration != Vector::zeros();
            if coupled && frame.spin == Vector::zeros() && shifts {
                let name = self.parts.frame_name(index);
                return Some(format!(
                    "frame `{name}` shifts without turning: let it stand still or turn about the axis of the rotation"
                ));
            }
            if differs(frame.spin, next.spin) || differs(pull(frame), pull(next)) {
                let name = self.parts.frame_name(index);
                return Some(format!(
                    "frame `{name}` does not move uniformly: its spin or acceleration changes; take a time when it does"
                ));
            }
        }
        None
    }

    /// A free frame that cannot turn with the system.
    fn unable(&self, spin: &Spin, frames: &[FrameMotion]) -> Option<String> {
        for frame in self.frames.free.iter().filter(|frame| !frame.is_state()) {
            let (motion, name) = (&frames[frame.spec.frame], self.parts.frame_name(frame.spec.frame));
            let needed = spin.velocity.cross(&(motion.position - spin.point));
            if differs(needed, motion.velocity) {
                return Some(format!(
                    "frame `{name}` cannot be carried about the axis of the rotation: free it along more axes, or put its origin on the axis"
                ));
            }
            let carries = self.bodies.iter().any(|body| body.spec.frame == frame.spec.frame)
                || frame.spec.rigid.moment != Vector::zeros();
            if (frame.turns() || carries) && differs(turning(motion), spin.velocity) {
                return Some(format!(
                    "frame `{name}` cannot turn about the axis of the rotation: free it to turn about that axis"
                ));
            }
        }
        None
    }

    /// A load that keeps its direction in a frame which turns relative to a body that it acts on.
    fn load_obstacle(&self, index: usize, t: f64, frames: &[FrameMotion]) -> Option<String> {
        let load = &self.dead_loads.specs[index];
        let value = frames[load.frame].direction_to_inertial(self.parts.load(index, t).into());
        let acts_on = |body: usize| match load.kind {
            LoadKind::Gravity => true,
            // Looked at with the forces on markers.
            LoadKind::Around | LoadKind::Field { .. } => false,
            LoadKind::Force { body: other, .. } | LoadKind::Moment { body: other, .. } => body == other,
        };
        let turned = |frame: usize| turns(&frames[load.frame], &frames[frame], value);
        let body = (0..self.bodies.len()).find(|&body| acts_on(body) && turned(self.bodies[body].spec.frame));
        let remedy = "let it act along the axis, or in the axes of that frame";
        if let Some(body) = body {
            let spec = &self.bodies[body].spec;
            let name = self.parts.frame_name(spec.frame);
            return Some(format!(
                "load `{}` keeps its direction while body `{}` turns with frame `{name}`: {remedy}",
                load.name,
                spec.label()
            ));
        }
        let mut pulled = self.frames.free.iter().filter(|_| load.kind == LoadKind::Gravity);
        let frame = pulled.find(|frame| frame.has_rigid_parts() && turned(frame.spec.frame))?;
        let name = self.parts.frame_name(frame.spec.frame);
        Some(format!(
            "load `{}` keeps its direction while `{name}` turns: {remedy}",
            load.name
        ))
    }

    /// A joint whose point or direction moves in the frame of its body.
    fn joint_obstacle(&self, condition: &Condition, frames: &[FrameMotion]) -> Option<String> {
        let (joint, data) = (&self.joints[condition.joint], &condition.data);
        let body = &self.bodies[joint.body].spec;
        let (own, other) = (&frames[body.frame], &frames[joint.frame]);
        let held = [data.tangent, data.second].map(|direction| other.direction_to_inertial(direction.into()));
        if joint.kind != JointKind::Pin && held.iter().any(|&direction| turns(other, own, direction)) {
            return Some(format!(
                "joint `{}` holds the direction of body `{}` in a frame that does not turn with it",
                self.joint_label(condition.joint),
                body.label()
            ));
        }
        let point = other.point_to_inertial(data.point.into());
        let [held, moved] = [carried(other, point), carried(own, point)];
        if (held - moved).norm() > NEGLIGIBLE * held.norm().max(moved.norm()) {
            return Some(format!(
                "joint `{}` holds body `{}` at a point that moves in its frame",
                self.joint_label(condition.joint),
                body.label()
            ));
        }
        None
    }
}

/// Whether a direction (inertial) fixed in frame `a` turns in frame `b`.
fn turns(a: &FrameMotion, b: &FrameMotion, direction: Vector) -> bool {
    let (first, second) = (turning(a), turning(b));
    let relative = second - first;
    let round_off = NEGLIGIBLE * first.norm().max(second.norm());
    relative.norm() > round_off && relative.cross(&direction).norm() > NEGLIGIBLE * relative.norm() * direction.norm()
}
