//! States of a scene in the declared frames and back.

use super::mesh_scene::MeshScene;
use crate::emitted::{FrameMotion, PointQuantity};
use crate::model::Pose;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::space::{Vector, matrix};
use crate::system::State;

impl MeshScene {
    /// Nodal vectors of all bodies, from the full arrays, in their declared frames.
    pub(crate) fn vectors_in_frames(&self, full: [&[f64]; 2]) -> [Vec<f64>; 2] {
        let mut result = [Vec::new(), Vec::new()];
        self.each_vector(|body, is_position, place| {
            let at = |full: &[f64]| self.vector_at(body, full, place);
            let pair = [at(full[0]), at(full[1])];
            let (what, rate) = if is_position {
                (
                    PointQuantity::Position,
                    self.in_declared(body, PointQuantity::Velocity, pair),
                )
            } else {
                let frame = &self.buffers.frames[body.spec.frame];
                let rate = if body.frame == body.spec.frame {
                    pair[1]
                } else {
                    frame.rate_to_frame(pair[0], pair[1])
                };
                (PointQuantity::Slope, rate)
            };
            let value = self.in_declared(body, what, pair);
            result[0].extend(body.spec.axes.iter().map(|&axis| value[axis]));
            result[1].extend(body.spec.axes.iter().map(|&axis| rate[axis]));
        });
        result
    }

    /// Calls back with every nodal vector: body, whether it is a position, place in the full arrays.
    fn each_vector(&self, mut each: impl FnMut(&MeshBody, bool, usize)) {
        for body in &self.bodies {
            for within in 0..body.spec.vectors() {
                let (_, local) = body.spec.locate(within);
                each(
                    body,
                    body.spec.nodal[local].is_position(),
                    self.layout.offset(body.first_vector + within),
                );
            }
        }
    }

    /// Motion of every frame at `t`; free ones at their start.
    pub(crate) fn motions(&self, t: f64) -> Vec<FrameMotion> {
        self.motions_with(t, &[])
    }

    /// Motion of every frame at `t`, free ones with the given poses or, where there is none, at their
    /// start.
    fn motions_with(&self, t: f64, poses: &[Pose]) -> Vec<FrameMotion> {
        let mut frames = vec![FrameMotion::INERTIAL; self.parts.frame_count()];
        self.parts.frames(t, &mut frames);
        for frame in &self.frames.free {
            let (mut x, mut v) = (vec![0.0; frame.count()], vec![0.0; frame.count()]);
            let a = x.clone();
            let pose = poses.get(frame.place).unwrap_or(&frame.start);
            frame.unknowns(t, pose, &mut x, &mut v);
            let parent = frames[frame.spec.parent];
            frames[frame.spec.frame] = frame.motion(t, &parent, pose.rotation, [&x, &v, &a]);
        }
        for frame in &self.frames.fixed {
            let pose = poses.get(frame.place).unwrap_or(&frame.start);
            frames[frame.spec.frame] = FrameMotion {
                position: pose.position,
                velocity: pose.velocity,
                rotation: matrix(&pose.rotation),
                spin: pose.spin,
                ..FrameMotion::INERTIAL
            };
        }
        frames
    }

    /// Poses of all declared free frames at the loaded state; those that are no unknowns are where they follow
    /// bodies, or at rest at their start.
    pub(crate) fn poses(&self) -> Vec<Pose> {
        let mut poses = vec![Pose::default(); self.frames.free.len() + self.frames.fixed.len()];
        let border = self.layout.vector_components();
        for frame in &self.frames.free {
            let motion = &self.buffers.frames[frame.spec.frame];
            poses[frame.place] = frame.pose(motion, &self.buffers.q[border + frame.first..]);
        }
        for frame in &self.frames.fixed {
            let motion = &self.buffers.frames[frame.spec.frame];
            poses[frame.place] = Pose {
                angle: frame.start.angle,
                ..frame.pose(motion, &[])
            };
        }
        poses
    }

    /// The unknowns of nodal vectors in declared frames and of the poses of free frames (as
    /// declared, where there are none).
    pub(crate) fn unknowns_from(&self, t: f64, q: &[f64], v: &[f64], poses: &[Pose]) -> State {
        let frames = self.motions_with(t, poses);
        let (mut full_q, mut full_v) = (q.to_vec(), v.to_vec());
        self.each_vector(|body, is_position, place| {
            if body.frame == body.spec.frame {
                return;
            }
            let frame = &frames[body.spec.frame];
            let at = |full: &[f64]| self.vector_at(body, full, place);
            let (value, rate) = (at(q), at(v));
            let mut inertial = [frame.direction_to_inertial(value), frame.rate_to_inertial(value, rate)];
            if is_position {
                inertial[0] = frame.point_to_inertial(value);
                inertial[1] = Vector::from_fn(|i, _| inertial[1][i] + frame.velocity[i]);
            }
            for (component, &axis) in body.spec.axes.iter().enumerate() {
                full_q[place + component] = inertial[0][axis];
                full_v[place + component] = inertial[1][axis];
            }
        });
        let mut state = State::of(self, t);
        self.layout.unknowns_of(&full_q, &mut state.x);
        self.layout.unknowns_of(&full_v, &mut state.v);
        let border = self.layout.unknowns() - self.layout.border();
        for frame in &self.frames.free {
            let own = border + frame.first..border + frame.first + frame.count();
            let pose = poses.get(frame.place).unwrap_or(&frame.start);
            frame.unknowns(t, pose, &mut state.x[own.clone()], &mut state.v[own]);
            if let Some(turn) = frame.turn {
                state.turns[turn] = pose.rotation;
            }
        }
        state
    }
}
