//! Starts in relative equilibrium: the bodies of a frame rest in it while it turns uniformly about its origin,
//! without loads, `M^ab w x (w x q_b) + F_e = 0` (THEORY 8.1) on what joints and common nodes leave free.
//!
//! This makes `U - 1/2 M^ab (w x q_a) . (w x q_b)` stationary, and strings that do not carry yet have no stiffness
//! across themselves while turning takes some away: the tangent is indefinite at a straight, unstretched start. The
//! way is that of a flow towards the equilibrium in a viscous medium, `mu M dq/ds = -R`, by implicit steps that grow
//! as the potential falls as foreseen, until they are those of Newton.

mod balance;
mod flow;

use crate::emitted::{BodySpec, Fidelity, FrameMotion, FrameTie, JointSpec, Motions, StartSpec, When};
use crate::error::ModelError;
use crate::model::Joints;
use crate::scene::MeshScene;
use crate::scene::frames::ties::{ChordEnds, Tie};
use crate::scene::numbering::conditions::{Condition, condition, directions, joint_data, vector_kinds};
use crate::scene::numbering::layout::Layout;
use crate::scene::numbering::shared::{Shared, numbering};
use crate::scene::pieces::marker::Marker;
use crate::space::Vector;
use balance::Balance;

/// Relative size of a component across the normal, or of a motion of a joint, that counts as round-off.
const NEGLIGIBLE: f64 = 1e-9;

impl MeshScene {
    /// Finds all declared starts, at the end of building.
    ///
    /// # Errors
    /// A start that cannot be, or was not found, by name.
    pub(crate) fn settle(&mut self) -> Result<(), ModelError> {
        self.settled = vec![Vec::new(); self.bodies.len()];
        for start in self.parts.starts() {
            let spin = self.settling_spin(&start)?;
            self.check_settling(&start)?;
            let mut balance = Balance::new(self, &start, spin)?;
            let q = balance.find(&start)?;
            let bodies = balance.bodies;
            for index in bodies {
                let body = &self.bodies[index];
                let first = self.layout.offset(body.first_vector);
                let count = body.spec.vectors() * body.spec.dimension();
                self.settled[index] = q[first..first + count].to_vec();
            }
        }
        Ok(())
    }

    /// Angular velocity of a start, frame axes.
    fn settling_spin(&self, start: &StartSpec) -> Result<Vector, ModelError> {
        let spin = start
            .spin
            .map(Vector::from)
            .unwrap_or_else(|| self.motions(0.0)[start.frame].spin);
        let name = self.parts.frame_name(start.frame);
        if !spin.iter().all(|value| value.is_finite()) {
            return Err(ModelError::new(format!(
                "start `{}`: the angular velocity of frame `{name}` is not finite",
                start.name
            )));
        }
        if spin.norm() == 0.0 {
            return Err(ModelError::new(format!(
                "start `{}`: frame `{name}` does not turn, and without rotation its bodies rest undeformed: give it an angular velocity, or leave the start out",
                start.name
            )));
        }
        let planes = self.bodies.iter().filter(|body| body.spec.frame == start.frame);
        let planes = planes.filter_map(|body| match *body.spec.axes {
            [first, second] => Some(3 - first - second),
            _ => None,
        });
        let free = self.frames.free.iter().chain(&self.frames.fixed);
        let frames = free.filter(|frame| frame.spec.frame == start.frame);
        let frames = frames.filter_map(|frame| match frame.spec.motions {
            Motions::Planar { normal } | Motions::ShiftingPlanar { normal } => Some(normal),
            _ => None,
        });
        for normal in planes.chain(frames) {
            let mut across = spin;
            across[normal] = 0.0;
            if across.norm() > NEGLIGIBLE * spin.norm() {
                return Err(ModelError::new(format!(
                    "start `{}`: what moves in a plane of frame `{name}` turns about the plane's normal only: give an angular velocity along {}",
                    start.name,
                    ["x", "y", "z"][normal]
                )));
            }
        }
        Ok(spin)
    }

    /// Refuses what holds or drives the bodies of a start in another way than joints to their frame.
    fn check_settling(&self, start: &StartSpec) -> Result<(), ModelError> {
        let refuse = |what: String| Err(ModelError::new(format!("start `{}`: {what}", start.name)));
        let lives = |body: usize| self.bodies[body].spec.frame == start.frame;
        let frame = self.parts.frame_name(start.frame);
        for body in self.bodies.iter().filter(|body| body.spec.frame == start.frame) {
            if body.spec.fidelity != Fidelity::Full {
                return refuse(format!(
                    "body `{}` is described by modes, which have no initial shape: describe it by its nodal vectors",
                    body.spec.label()
                ));
            }
        }
        if let Some(section) = self.rigid_sections.iter().find(|section| lives(section.point.body)) {
            return refuse(format!(
                "fixture `{}` keeps a section of body `{}` rigid, and the equilibrium knows only joints that hold its ends in frame `{frame}`: let the section strain, `section = elastic;` in the fixture, or leave the start out",
                section.name,
                self.bodies[section.point.body].spec.label()
            ));
        }
        let bodies_of = |markers: &[usize]| {
            let mut bodies = markers.iter().filter_map(|&marker| match &self.links.markers[marker] {
                Marker::Body { point, .. } | Marker::Section { point, .. } | Marker::SectionTurn { point } => {
                    Some(point.body)
                }
                _ => None,
            });
            bodies.find(|&body| lives(body))
        };
        let constraints = self.links.constraints.iter();
        let constraints = constraints.filter(|linked| linked.spec.when == When::Always);
        let constraints = constraints.map(|linked| (linked.spec.name, linked.spec.markers));
        let forces = self.links.forces.iter().enumerate();
        let forces = forces.filter(|&(index, _)| !self.is_load(index));
        let forces = forces.map(|(_, force)| (force.name, &force.markers[..]));
        for (name, markers) in constraints.chain(forces) {
            if let Some(body) = bodies_of(markers) {
                return refuse(format!(
                    "`{name}` acts on body `{}`, and the equilibrium knows only joints that hold its ends in frame `{frame}`: use such joints, or leave the start out",
                    self.bodies[body].spec.label()
                ));
            }
        }
        Ok(())
    }

    /// A joint as one to its body's frame.
    fn joint_at_rest(
        &self,
        start: &StartSpec,
        joint: &JointSpec,
        frames: &[FrameMotion],
    ) -> Result<JointSpec, ModelError> {
        let spec = &self.bodies[joint.body].spec;
        if joint.frame == spec.frame {
            return Ok(joint.clone());
        }
        let (own, other) = (&frames[spec.frame], &frames[joint.frame]);
        let data = joint_data(joint, spec, frames);
        let point = other.point_to_inertial(data.point.into());
        let spins = [own, other].map(|frame| frame.direction_to_inertial(frame.spin));
        let carried = |frame: &FrameMotion, spin: Vector| frame.velocity + spin.cross(&(point - frame.position));
        let velocities = [carried(own, spins[0]), carried(other, spins[1])];
        let differs = |[a, b]: [Vector; 2]| (a - b).norm() > NEGLIGIBLE * a.norm().max(b.norm());
        if differs(velocities) || !directions(joint.kind, spec).is_empty() && differs(spins) {
            return Err(ModelError::new(format!(
                "start `{}`: joint `{}` ties body `{}` to frame `{}`, which moves relative to frame `{}`: nothing rests there",
                start.name,
                joint.name,
                spec.label(),
                self.parts.frame_name(joint.frame),
                self.parts.frame_name(spec.frame)
            )));
        }
        Ok(JointSpec {
            frame: spec.frame,
            point: Some(own.point_to_frame(point).into()),
            ..joint.clone()
        })
    }

    /// Shapes of all bodies, and what is unknown of them, in their declared frames, with all joints of the start's
    /// bodies eliminated.
    fn referenced(&self, start: &StartSpec) -> Result<(Vec<f64>, Layout, Vec<Tie>), ModelError> {
        let frames = self.motions(0.0);
        let mut conditions: Vec<Condition> = Vec::new();
        for (index, joint) in self.joints.iter().enumerate() {
            let body = &self.bodies[joint.body];
            if body.spec.frame != start.frame {
                continue;
            }
            let own = self.joint_at_rest(start, joint, &frames)?;
            let data = joint_data(&own, &body.spec, &frames);
            let first = body.first_vector;
            conditions.push(condition(
                index,
                &own,
                &body.spec,
                first,
                data,
                false,
                Joints::Eliminated,
            ));
        }
        let specs: Vec<BodySpec> = self.bodies.iter().map(|body| body.spec.clone()).collect();
        let firsts: Vec<usize> = self.bodies.iter().map(|body| body.first_vector).collect();
        let shared = Shared::new(&*self.parts, &specs, &firsts)?;
        let mut kinds = vector_kinds(shared.leaders.len(), &conditions);
        let mut chords = Vec::new();
        for (index, spec) in specs.iter().enumerate() {
            if spec.frame == start.frame && spec.tie == FrameTie::Chord {
                let ends = ChordEnds::new(&*self.parts, index, spec, firsts[index])?;
                chords.push((index, ends.eliminate(&mut kinds, |vector| !shared.is_shared(vector))));
            }
        }
        let layout = numbering(&specs, kinds, &shared, 0);
        let [mut q, _] = self.initial_shape();
        let ties = self.ties_of(start, &layout, &q, &chords)?;
        let shape = self.shape();
        for condition in &conditions {
            let axes = self.bodies[self.joints[condition.joint].body].spec.axes;
            let mut set = |vector: usize, value: Vector| {
                let first = layout.offset(vector);
                for (place, &axis) in axes.iter().enumerate() {
                    q[first + place] = value[axis];
                }
            };
            if condition.position_eliminated {
                set(condition.vectors[0], condition.data.point.into());
            }
            if condition.prescribes_directions() {
                let values = [condition.data.tangent, condition.data.second];
                for (&vector, value) in condition.vectors[1..].iter().zip(values) {
                    set(vector, value.into());
                }
            }
            if let Some((vector, component)) = condition.held {
                let place = layout.offset(vector) + component;
                q[place] = shape[place];
            }
        }
        Ok((q, layout, ties))
    }

    /// What the frame follows, in absolute coordinates, too.
    fn ties_of(
        &self,
        start: &StartSpec,
        layout: &Layout,
        shape: &[f64],
        chords: &[(usize, [bool; 2])],
    ) -> Result<Vec<Tie>, ModelError> {
        let follows = |spec: &BodySpec| spec.frame == start.frame && spec.tie != FrameTie::Joints;
        let bodies = self.bodies.iter().enumerate();
        let bodies = bodies.filter(|(_, body)| follows(&body.spec));
        let ties = bodies.map(|(index, body)| {
            let eliminated = chords.iter().find(|(chord, _)| *chord == index);
            let eliminated = eliminated.map_or([false; 2], |&(_, ends)| ends);
            Tie::new(
                index,
                body,
                layout,
                shape,
                eliminated,
                self.parts.frame_name(start.frame),
            )
        });
        ties.collect()
    }
}
