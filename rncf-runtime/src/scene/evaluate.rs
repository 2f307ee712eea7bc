//! A state loaded into the full arrays, and forces and tangents of all nodal components there.

use std::sync::Arc;

use super::mesh_scene::MeshScene;
use crate::emitted::{LoadKind, Prescribed};
use crate::model::Scene;
use crate::scene::pieces::buffers::Regime;
use crate::scene::pieces::combination::Combination;
use crate::scene::pieces::combined::Combined;
use crate::scene::terms::force::At;
use crate::scene::terms::kinds::{CONSTRAINTS, FORCES};
use crate::space::{Rotation, Vector};
use crate::system::{State, Tangent};

impl MeshScene {
    /// Fills the full state: prescribed frames, unknowns, free frames, prescribed vectors.
    pub(crate) fn load(&mut self, t: f64, turns: &[Rotation], [x, v, a]: [&[f64]; 3], regime: Regime) {
        let buffers = &mut self.buffers;
        buffers.t = t;
        self.parts.set_time(t);
        self.parts.frames(t, &mut buffers.frames);
        if let Some(jolt) = &buffers.jolt {
            for (frame, [velocity, spin]) in buffers.frames.iter_mut().zip(&jolt.frames) {
                frame.acceleration += velocity;
                frame.spin_rate += spin;
            }
        }
        if let Regime::Uniform(scale) = regime {
            for frame in &mut buffers.frames {
                *frame = frame.steady(scale);
            }
        }
        self.layout.expand(x, &mut buffers.q);
        self.layout.expand(v, &mut buffers.v);
        self.layout.expand(a, &mut buffers.a);
        let border = self.layout.vector_components();
        for frame in &self.frames.free {
            let own = border + frame.first..border + frame.first + frame.count();
            let turn = frame.turn.and_then(|turn| turns.get(turn)).copied().unwrap_or_default();
            let unknowns = [&buffers.q, &buffers.v, &buffers.a].map(|full| &full[own.clone()]);
            let parent = buffers.frames[frame.spec.parent];
            buffers.frames[frame.spec.frame] = frame.motion(t, &parent, turn, unknowns);
        }
        for frame in &self.frames.fixed {
            buffers.frames[frame.spec.frame] = frame.fixed();
        }
        self.set_prescribed(t, regime);
        if let Some(jolt) = &self.buffers.jolt {
            self.buffers.a.iter_mut().zip(&jolt.values).for_each(|(a, v)| *a += v);
        }
    }

    /// Fills the full state of a system's state as it moves.
    pub(crate) fn load_state(&mut self, state: &State) {
        self.load(state.t, &state.turns, [&state.x, &state.v, &state.a], Regime::Moving);
    }

    /// Fills the full state of the declared start.
    pub(crate) fn load_rest(&mut self) {
        let rest = self.rest(0.0);
        self.load_state(&rest);
    }

    /// Fills in what the eliminated conditions prescribe.
    fn set_prescribed(&mut self, t: f64, regime: Regime) {
        let buffers = &mut self.buffers;
        for condition in &self.conditions {
            let dimension = self.bodies[self.joints[condition.joint].body].spec.dimension();
            let prescribes_directions = condition.prescribes_directions();
            if !condition.position_eliminated && !prescribes_directions {
                continue;
            }
            let mut prescribed = Prescribed::default();
            self.parts
                .prescribed(condition.joint, condition.absolute, t, &condition.data, &mut prescribed);
            if regime != Regime::Moving {
                for values in [&mut prescribed.position, &mut prescribed.slope, &mut prescribed.second] {
                    values[1..].fill([0.0; 3]);
                }
            }
            let mut set = |vector: usize, values: [[f64; 3]; 4]| {
                let place = self.layout.offset(vector);
                let full = [&mut buffers.q, &mut buffers.v, &mut buffers.a, &mut buffers.jerks];
                for (full, value) in full.into_iter().zip(values) {
                    full[place..place + dimension].copy_from_slice(&value[..dimension]);
                }
            };
            if condition.position_eliminated {
                set(condition.vectors[0], prescribed.position);
            }
            if prescribes_directions {
                for (&vector, values) in condition.vectors[1..].iter().zip([prescribed.slope, prescribed.second]) {
                    set(vector, values);
                }
            }
        }
    }

    /// Sum of all gravity loads, inertial axes.
    pub(crate) fn gravity(&self, t: f64) -> Vector {
        let mut sum = Vector::zeros();
        for (index, load) in self.dead_loads.specs.iter().enumerate() {
            if load.kind == LoadKind::Gravity {
                sum += self.buffers.frames[load.frame].direction_to_inertial(self.parts.load(index, t).into());
            }
        }
        sum
    }

    /// Where forces are wanted: the loaded state, with the fields of its frames; loads are multiplied by `load_scale`.
    fn at(&mut self, t: f64, load_scale: f64) -> At {
        self.set_fields(t, load_scale);
        At {
            t,
            load_scale,
            gravity: load_scale * self.gravity(t),
        }
    }

    /// `M a + f` of all components at the loaded state; loads are multiplied by `load_scale`.
    pub(crate) fn full_force(&mut self, t: f64, load_scale: f64) {
        let at = self.at(t, load_scale);
        self.buffers.force.fill(0.0);
        for force in FORCES {
            force.add(self, &at);
        }
    }

    /// Derivatives of [`MeshScene::full_force`] at the loaded state, on the pattern.
    pub(crate) fn full_tangent(&mut self, t: f64, load_scale: f64, out: &mut Tangent) {
        let at = self.at(t, load_scale);
        out.mass.clone_from(&self.tabulated.mass);
        for values in [&mut out.stiffness, &mut out.damping] {
            values.clear();
            values.resize(self.tabulated.mass.len(), 0.0);
        }
        for force in FORCES {
            force.add_tangent(self, &at, out);
        }
    }

    /// Adds `d(C_x^T lambda)/dx` at the loaded state.
    pub(crate) fn add_constraint_stiffness(&self, t: f64, lambda: &[f64], out: &mut Tangent) {
        for constraint in CONSTRAINTS {
            constraint.add_stiffness(self, t, lambda, out);
        }
    }

    /// A combination of mass, damping and stiffness at the loaded state, that of constraints included.
    pub(crate) fn full_combination(&mut self, t: f64, lambda: &[f64], combination: &Combination, values: &mut [f64]) {
        let at = self.at(t, 1.0);
        for (value, mass) in values.iter_mut().zip(&self.tabulated.mass) {
            *value = combination.factors[0] * mass;
        }
        let mut sums = Combined {
            combination,
            turned: Arc::clone(&self.frames.turned),
            values,
        };
        for force in FORCES {
            force.add_combined(self, &at, &mut sums);
        }
        for constraint in CONSTRAINTS {
            constraint.add_combined(self, t, lambda, &mut sums);
        }
    }
}
