//! Forces and tangents of all nodal components at a state.

use crate::scene::numbering::turned::TurnedColumns;
use std::sync::Arc;

use super::mesh_scene::MeshScene;
use crate::emitted::{LoadKind, Prescribed};
use crate::model::Scene;
use crate::scene::bodies::described::Kernels;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::bodies::nodal_mass::Transport;
use crate::scene::bodies::place::PlaceVector;
use crate::scene::numbering::conditions::Condition;
use crate::scene::numbering::units::Lanes;
use crate::scene::pieces::batches::Blocks;
use crate::scene::pieces::buffers::{Buffers, Regime};
use crate::scene::pieces::combination::Combination;
use crate::scene::terms::moments::turned_by_moments;
use crate::space::{Rotation, Vector};
use crate::system::{State, Sums, Tangent};

/// Most components of a node's vectors that a joint is about, and most of its conditions.
pub(crate) const MOST: usize = 9;

/// Adds contributions to a combination of the matrices of a scene.
struct Combined<'a> {
    combination: &'a Combination,
    turned: Arc<[TurnedColumns]>,
    values: &'a mut [f64],
}

impl Combined<'_> {
    /// Adds to an entry of M or C: that of an orientation's column goes to all three columns.
    fn add_mapped(&mut self, entry: usize, value: f64) {
        for (turned, map) in self.turned.iter().zip(&self.combination.maps) {
            let starts = turned.starts;
            if (starts[0]..starts[3]).contains(&entry) {
                let from = (1..3).filter(|&column| entry >= starts[column]).count();
                for (place, factor) in turned.places[entry - starts[0]].into_iter().zip(&map.row(from)) {
                    if let Some(place) = place {
                        self.values[place] += factor * value;
                    }
                }
                return;
            }
        }
        self.values[entry] += value;
    }
}

impl Sums for Combined<'_> {
    fn mass(&mut self, entry: usize, value: f64) {
        self.add_mapped(entry, self.combination.factors[0] * value);
    }

    fn damping(&mut self, entry: usize, value: f64) {
        self.add_mapped(entry, self.combination.factors[1] * value);
    }

    fn stiffness(&mut self, entry: usize, value: f64) {
        self.values[entry] += self.combination.factors[2] * value;
    }

    fn all_stiffness(&mut self) -> (&mut [f64], f64) {
        (self.values, self.combination.factors[2])
    }

    fn all_damping(&mut self) -> (&mut [f64], f64) {
        (self.values, self.combination.factors[1])
    }
}

impl MeshScene {
    /// Fills the full state: prescribed frames, unknowns, free frames, prescribed vectors.
    pub(crate) fn load(&mut self, t: f64, turns: &[Rotation], [x, v, a]: [&[f64]; 3], regime: Regime) {
        let buffers = &mut self.buffers;
        buffers.t = t;
        self.parts.set_time(t);
        self.parts.frames(t, &mut buffers.frames);
        if let Regime::Uniform(scale) = regime {
            for frame in &mut buffers.frames {
                *frame = frame.steady(scale);
            }
        }
        self.layout.expand(x, &mut buffers.q);
        self.layout.expand(v, &mut buffers.v);
        self.layout.expand(a, &mut buffers.a);
        let border = self.layout.vector_components();
        for frame in &self.free {
            let own = border + frame.first..border + frame.first + frame.count();
            let turn = frame.turn.and_then(|turn| turns.get(turn)).copied().unwrap_or_default();
            let unknowns = [&buffers.q, &buffers.v, &buffers.a].map(|full| &full[own.clone()]);
            let parent = buffers.frames[frame.spec.parent];
            buffers.frames[frame.spec.frame] = frame.motion(t, &parent, turn, unknowns);
        }
        for frame in &self.fixed {
            buffers.frames[frame.spec.frame] = frame.fixed();
        }
        self.set_prescribed(t, regime);
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
        for (index, load) in self.loads.iter().enumerate() {
            if load.kind == LoadKind::Gravity {
                sum += self.buffers.frames[load.frame].direction_to_inertial(self.parts.load(index, t).into());
            }
        }
        sum
    }

    /// `M a + f` of all components at the loaded state; loads are multiplied by `load_scale`.
    pub(crate) fn full_force(&mut self, t: f64, load_scale: f64) {
        self.set_fields(t, load_scale);
        let gravity = load_scale * self.gravity(t);
        self.buffers.force.fill(0.0);
        // The sums for free frames hold before elastic forces are added.
        self.add_inertia_forces(gravity);
        self.add_elastic_forces();
        self.add_loads(t, load_scale);
        self.add_marker_forces(t, load_scale);
        self.add_density_forces(t, load_scale);
    }

    fn add_elastic_forces(&mut self) {
        let Buffers { q, v, force, lanes, .. } = &mut self.buffers;
        for group in &self.groups {
            let body = &self.bodies[group.body];
            match &body.modes {
                Some(_) if self.in_modes => {}
                // What the description that runs is made of, not what the elements make of its shape.
                Some(modes) if modes.is_linear() => {
                    let first = self.layout.offset(body.first_vector);
                    let own = first..first + modes.shape().len();
                    let elements = Kernels {
                        parts: &*self.parts,
                        body: group.body,
                    };
                    modes.add_linear_forces(&elements, [&q[own.clone()], &v[own.clone()]], &mut force[own]);
                }
                _ => group.add_forces(&*self.parts, [q, v], lanes, force),
            }
        }
    }

    /// Whether a load acts through a marker, since a free frame feels it.
    pub(crate) fn is_marked(&self, load: usize) -> bool {
        self.marked_loads.iter().any(|marked| marked.load == load)
    }

    /// Force or moment of a load in the axes of its body, in their order.
    pub(crate) fn load_in_body(&self, index: usize, t: f64, body: &MeshBody) -> [f64; 3] {
        let load = &self.loads[index];
        let mut value = Vector::from(self.parts.load(index, t));
        if load.frame != body.frame {
            let frames = &self.buffers.frames;
            value = frames[body.frame].direction_to_frame(frames[load.frame].direction_to_inertial(value));
        }
        match (&load.kind, body.spec.axes) {
            (LoadKind::Moment { .. }, &[first, second]) => [value[3 - first - second], 0.0, 0.0],
            (_, axes) => {
                let mut components = [0.0; 3];
                for (place, &axis) in axes.iter().enumerate() {
                    components[place] = value[axis];
                }
                components
            }
        }
    }

    /// Adds constant and follower loads on bodies.
    pub(crate) fn add_loads(&mut self, t: f64, load_scale: f64) {
        for index in 0..self.loads.len() {
            let Some(point) = self.load_points[index].as_ref().filter(|_| !self.is_marked(index)) else {
                continue;
            };
            let body = &self.bodies[point.body];
            let dimension = body.spec.dimension();
            let value = self.load_in_body(index, t, body).map(|x| load_scale * x);
            let components = body.connectivity.element(point.element);
            match self.loads[index].kind {
                LoadKind::Gravity | LoadKind::Around | LoadKind::Field { .. } => {}
                LoadKind::Force { .. } => {
                    for (place, &component) in components.iter().enumerate() {
                        let weight = point.weights(PlaceVector::Position)[place / dimension];
                        self.buffers.force[component] -= weight * value[place % dimension];
                    }
                }
                LoadKind::Moment { .. } => {
                    let force = self.moment_at(point, value);
                    for (&of, force) in turned_by_moments(&body.spec).iter().zip(force.chunks_exact(dimension)) {
                        for (place, &component) in components.iter().enumerate() {
                            let weight = point.weights(of)[place / dimension];
                            self.buffers.force[component] -= weight * force[place % dimension];
                        }
                    }
                }
            }
        }
    }

    /// Derivatives of [`MeshScene::full_force`] at the loaded state, on the pattern.
    pub(crate) fn full_tangent(&mut self, t: f64, load_scale: f64, out: &mut Tangent) {
        self.set_fields(t, load_scale);
        out.mass.clone_from(&self.mass);
        for values in [&mut out.stiffness, &mut out.damping] {
            values.clear();
            values.resize(self.mass.len(), 0.0);
        }
        let [damping, stiffness] = [1, 2].map(Combination::only);
        let Tangent {
            stiffness: by_place,
            damping: by_rate,
            ..
        } = &mut *out;
        let blocks = |transport: &Transport| Blocks {
            by_place: stiffness.block(transport),
            by_rate: damping.block(transport),
        };
        self.each_element_tangent(blocks, |body, element, [k, c], lane, damps| {
            body.scatter.add_by(element, |entry| k[entry][lane], by_place);
            if damps {
                body.scatter.add_by(element, |entry| c[entry][lane], by_rate);
            }
        });
        let gravity = load_scale * self.gravity(t);
        for (place, values) in [&mut out.mass, &mut out.damping, &mut out.stiffness]
            .into_iter()
            .enumerate()
        {
            let only = Combination::only(place);
            self.add_fixture_tangents(&only, values);
            self.add_inertia_borders(gravity, &only, values);
        }
        self.add_load_tangents(t, load_scale, out);
        self.add_marker_force_tangents(t, load_scale, out);
        self.add_density_tangents(t, load_scale, out);
    }

    /// A combination of mass, damping and stiffness at the loaded state, that of constraints included.
    pub(crate) fn full_combination(&mut self, t: f64, lambda: &[f64], combination: &Combination, values: &mut [f64]) {
        self.set_fields(t, 1.0);
        let [b, g, k] = combination.factors;
        for (value, mass) in values.iter_mut().zip(&self.mass) {
            *value = b * mass;
        }
        // All that is not elastic starts the stiffness, so that one pass adds everything.
        let blocks = |transport: &Transport| {
            let block = combination.block(transport);
            let divided = |factor: f64| block / factor;
            let mut blocks = Blocks::default();
            if k != 0.0 {
                blocks.by_place = divided(k);
            } else if g != 0.0 {
                blocks.by_rate = divided(g);
            }
            blocks
        };
        self.each_element_tangent(blocks, |body, element, [by_place, by_rate], lane, damps| {
            if damps {
                let entry = |entry: usize| k * by_place[entry][lane] + g * by_rate[entry][lane];
                body.scatter.add_by(element, entry, values);
            } else {
                body.scatter.add_by(element, |entry| k * by_place[entry][lane], values);
            }
        });
        self.add_fixture_tangents(combination, values);
        self.add_inertia_borders(self.gravity(t), combination, values);
        let mut sums = Combined {
            combination,
            turned: self.turned.clone(),
            values,
        };
        self.add_load_tangents(t, 1.0, &mut sums);
        self.add_marker_force_tangents(t, 1.0, &mut sums);
        self.add_density_tangents(t, 1.0, &mut sums);
        // Conditions on nodes and mean axes are linear in the unknowns: they add nothing.
        self.marker_constraint_stiffness(t, lambda, &mut sums);
        self.rigid_section_stiffness(lambda, &mut sums);
    }

    /// Calls for every element with its elastic derivatives, see [`super::terms::batches::Group::each_tangent`].
    pub(crate) fn each_element_tangent(
        &mut self,
        blocks: impl Fn(&Transport) -> Blocks,
        mut call: impl FnMut(&MeshBody, usize, [&[Lanes]; 2], usize, bool),
    ) {
        let Buffers {
            q, v, frames, lanes, ..
        } = &mut self.buffers;
        for group in &self.groups {
            let body = &self.bodies[group.body];
            if self.in_modes && body.modes.is_some() {
                continue;
            }
            let axes = body.spec.axes;
            let blocks = blocks(&Transport::new(&frames[body.frame], axes, Vector::zeros()));
            let bodies = &self.bodies;
            group.each_tangent(
                &*self.parts,
                axes,
                [q, v],
                &blocks,
                lanes,
                |(body, element), both, lane, damps| {
                    call(&bodies[body], element, both, lane, damps);
                },
            );
        }
    }

    fn add_load_tangents(&self, t: f64, load_scale: f64, out: &mut impl Sums) {
        for (index, point) in self.load_points.iter().enumerate() {
            let (Some(point), LoadKind::Moment { .. }) = (point, self.loads[index].kind) else {
                continue;
            };
            if self.is_marked(index) {
                continue;
            }
            let body = &self.bodies[point.body];
            let (dimension, size) = (body.spec.dimension(), body.spec.element_size());
            let value = self.load_in_body(index, t, body).map(|x| load_scale * x);
            let block = self.moment_tangent_at(point, value);
            let vectors = turned_by_moments(&body.spec);
            let width = vectors.len() * dimension;
            let mut local = vec![0.0; size * size];
            for (place, entry) in local.iter_mut().enumerate() {
                let (row, column) = (place / size, place % size);
                for (m, &of) in vectors.iter().enumerate() {
                    for (n, &by) in vectors.iter().enumerate() {
                        let weight = point.weights(of)[row / dimension] * point.weights(by)[column / dimension];
                        let (i, j) = (m * dimension + row % dimension, n * dimension + column % dimension);
                        *entry -= weight * block[i * width + j];
                    }
                }
            }
            let components = body.connectivity.element(point.element);
            for (place, &value) in local.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                for (entry, factor) in self.entries_of(components[place / size], components[place % size]) {
                    out.stiffness(entry, factor * value);
                }
            }
        }
    }

    /// The vectors of a condition's node in one of the full arrays.
    pub(crate) fn node(&self, condition: &Condition, full: &[f64]) -> [f64; MOST] {
        let mut node = [0.0; MOST];
        for (place, &component) in condition.components.iter().enumerate() {
            node[place] = full[component];
        }
        node
    }
}
