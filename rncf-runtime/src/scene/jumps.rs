//! Whether prescribed motions are continuous over a kink: frames, and what drives and other constraints prescribe.

use super::mesh_scene::MeshScene;
use crate::emitted::FrameMotion;
use crate::scene::frames::free_frames::declared_free;
use crate::scene::pieces::buffers::Jolt;
use crate::system::{ConstraintLevel, Jump, State, System};

/// Change of a position over the size of the model, or of an angle (rad), that counts as round-off.
const ROUND_OFF: f64 = 1e-6;
/// The same of a position over its distance from the origin.
const FAR: f64 = 1e-12;

impl MeshScene {
    /// The frames that jump, else the first constraint; positions before velocities.
    pub(crate) fn jumps_between(&mut self, state: &State, behind: f64) -> Vec<Jump> {
        let size = self.largest_length();
        let frames = self.jumps_of_frames(state.t, behind, size);
        if frames.iter().any(|jump| jump.of_position) {
            return frames;
        }
        let found = self.jump_of_constraint(ConstraintLevel::Position, state, behind, size);
        if let Some((row, change)) = found {
            return vec![Jump {
                text: format!(
                    "what {} prescribes jumps by {change:.3e}",
                    self.describe_constraint(row)
                ),
                of_position: true,
            }];
        }
        if !frames.is_empty() {
            return frames;
        }
        let found = self.jump_of_constraint(ConstraintLevel::Velocity, state, behind, size);
        let jump = found.map(|(row, change)| Jump {
            text: format!(
                "the rate that {} prescribes jumps by {change:.3e} 1/s",
                self.describe_constraint(row)
            ),
            of_position: false,
        });
        jump.into_iter().collect()
    }

    /// By how much prescribed velocities jump from those of a state to the time `behind`. Frames that move freely follow from their unknowns.
    pub(crate) fn velocity_jumps(&mut self, state: &State, behind: f64) -> Jolt {
        let mut still = state.clone();
        still.a.fill(0.0);
        self.load_state(&still);
        let (frames, values) = (self.buffers.frames.clone(), self.buffers.v.clone());
        still.t = behind;
        self.load_state(&still);
        let after = &self.buffers;
        let frames = after.frames.iter().zip(&frames);
        let values = after.v.iter().zip(&values);
        Jolt {
            frames: frames
                .map(|(b, a)| [b.velocity - a.velocity, b.spin - a.spin])
                .collect(),
            values: values.map(|(b, a)| b - a).collect(),
        }
    }

    /// The first prescribed frame whose pose jumps, else all whose velocities do.
    fn jumps_of_frames(&self, t: f64, behind: f64, size: f64) -> Vec<Jump> {
        let free = declared_free(&*self.parts);
        let at = |t: f64| {
            let mut motions = vec![FrameMotion::INERTIAL; free.len()];
            self.parts.frames(t, &mut motions);
            motions
        };
        let (before, after) = (at(t), at(behind));
        let prescribed: Vec<usize> = (1..free.len()).filter(|&frame| !free[frame]).collect();
        let name = |frame: usize| self.parts.frame_name(frame);
        for &frame in &prescribed {
            let (a, b) = (&before[frame], &after[frame]);
            // Over the time between the two it moves by itself.
            let moved = (b.position - (a.position + (behind - t) * a.velocity)).norm();
            let turned = (0..3)
                .map(|row| (b.rotation.row(row) - a.rotation.row(row)).norm())
                .fold(0.0, f64::max);
            let turning = 2.0 * (behind - t) * a.spin.norm().max(b.spin.norm());
            if moved > ROUND_OFF * size + FAR * a.position.norm() {
                return vec![Jump {
                    text: format!("the origin of frame `{}` jumps by {moved:.3e} m", name(frame)),
                    of_position: true,
                }];
            }
            if turned > ROUND_OFF + turning {
                return vec![Jump {
                    text: format!(
                        "frame `{}` jumps by {:.3e} deg or more",
                        name(frame),
                        turned.to_degrees()
                    ),
                    of_position: true,
                }];
            }
        }
        let mut jumps = Vec::new();
        for &frame in &prescribed {
            let (a, b) = (&before[frame], &after[frame]);
            for (a, b, least, what, unit) in [
                (a.velocity, b.velocity, size, "velocity", "m/s"),
                (a.spin, b.spin, 1.0, "angular velocity", "rad/s"),
            ] {
                let change = (b - a).norm();
                if change > ROUND_OFF * (a.norm().max(b.norm()) + 1e-3 * least) {
                    jumps.push(Jump {
                        text: format!("the {what} of frame `{}` jumps by {change:.3e} {unit}", name(frame)),
                        of_position: false,
                    });
                }
            }
        }
        jumps
    }

    /// The constraint whose value changes most between the two times with the same unknowns, and by how much.
    fn jump_of_constraint(
        &mut self,
        level: ConstraintLevel,
        state: &State,
        behind: f64,
        size: f64,
    ) -> Option<(usize, f64)> {
        let m = self.constraints();
        let (mut before, mut after) = (vec![0.0; m], vec![0.0; m]);
        let mut later = state.clone();
        self.constraint(level, state, &mut before);
        later.t = behind;
        self.constraint(level, &later, &mut after);
        let jump = |row: usize| {
            let change = (after[row] - before[row]).abs();
            let limit = match level {
                ConstraintLevel::Position => ROUND_OFF * size,
                _ => ROUND_OFF * (before[row].abs().max(after[row].abs()) + 1e-3 * size),
            };
            (change > limit).then_some((row, change))
        };
        (0..m).filter_map(jump).max_by(|a, b| a.1.total_cmp(&b.1))
    }
}

/// The inertia of a jolt: the difference that it makes to a residual. `scene` finds the one that a system is made of.
pub(crate) fn inertia<S: System>(
    system: &mut S,
    scene: impl Fn(&mut S) -> &mut MeshScene,
    (state, behind): (&State, f64),
    jolt: Jolt,
    out: &mut [f64],
) {
    let mut still = state.clone();
    still.a.fill(0.0);
    still.t = behind;
    let mut rest = vec![0.0; out.len()];
    system.residual(&still, &mut rest);
    scene(system).buffers.jolt = Some(jolt);
    system.residual(&still, out);
    scene(system).buffers.jolt = None;
    out.iter_mut().zip(&rest).for_each(|(out, rest)| *out -= rest);
}
