//! Forces on markers, and declared loads where frames are free: the frame feels them, too.

use super::constraints::{block_product, part};
use super::jets::Column;
use crate::emitted::{FrameMotion, LoadKind};
use crate::scene::bodies::place::MeshPoint;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::numbering::assembly::couple_all;
use crate::scene::pieces::combined::Combined;
use crate::scene::pieces::marker::Marker;
use crate::scene::pieces::push::Law;
use crate::scene::terms::force::{At, Force};
use crate::space::{Matrix, Vector};
use crate::system::{Sums, Tangent};

/// Springs and other forces on markers, what is spread over points, and loads that free frames feel.
pub(crate) struct Pushes;

impl Force for Pushes {
    fn couple(&self, scene: &MeshScene, entries: &mut Vec<(usize, usize)>) {
        // What acts at points of an element or a frame couples what they couple anyway.
        let declared = scene
            .links
            .forces
            .iter()
            .filter(|force| matches!(force.law, Law::Force(_)));
        let declared = declared.map(|force| scene.unknowns_of_markers(&force.markers));
        let marked = scene.links.marked_loads.iter().map(|marked| {
            let turn = Marker::Turn {
                frame: scene.dead_loads.specs[marked.load].frame,
            };
            let markers = marked.markers.iter().chain([&turn]);
            scene.unknowns_of(markers.flat_map(|marker| scene.marker_components(marker)))
        });
        declared.chain(marked).for_each(|group| couple_all(&group, entries));
    }

    fn add(&self, scene: &mut MeshScene, at: &At) {
        scene.add_marker_forces(at.t, at.load_scale);
    }

    fn add_tangent(&self, scene: &mut MeshScene, at: &At, out: &mut Tangent) {
        scene.add_marker_force_tangents(at.t, at.load_scale, out);
    }

    fn add_combined(&self, scene: &mut MeshScene, at: &At, out: &mut Combined) {
        scene.add_marker_force_tangents(at.t, at.load_scale, out);
    }
}

impl MeshScene {
    /// Adds the forces on markers (to the left side, where they are negative) at the loaded state.
    fn add_marker_forces(&mut self, t: f64, load_scale: f64) {
        self.add_spread_forces(t, load_scale);
        for index in 0..self.links.forces.len() {
            let spec = &self.links.forces[index];
            if spec.element.is_some() {
                continue;
            }
            let (z, velocity) = self.force_arguments(index);
            let mut forces = vec![0.0; 3 * z.len()];
            self.push(index, t, &z, &velocity, &mut forces);
            self.apply_part(index, load_scale, &mut forces);
            for (place, &marker) in spec.markers.iter().enumerate() {
                let columns = self.columns(&self.links.markers[marker]);
                for column in columns {
                    self.buffers.force[column.component] -= part(&forces, place).dot(&column.value);
                }
            }
        }
        for index in 0..self.links.marked_loads.len() {
            let forces = self.on_markers(index, self.marked_value(index, t, load_scale));
            for (place, force) in forces.into_iter().enumerate() {
                let marker = &self.links.marked_loads[index].markers[place];
                let force = self.buffers.frames[self.marker_frame(marker)].direction_to_inertial(force);
                for column in self.columns(marker) {
                    self.buffers.force[column.component] -= force.dot(&column.value);
                }
            }
        }
    }

    /// Calls with every marker that a force, a load or a constraint acts on at the loaded state, and what acts
    /// there, inertial axes; not with what is spread over elements.
    pub(crate) fn each_marker_force(
        &self,
        t: f64,
        load_scale: f64,
        lambda: &[f64],
        mut call: impl FnMut(&Marker, Vector),
    ) {
        let at_places = self
            .links
            .forces
            .iter()
            .enumerate()
            .filter(|(_, spec)| spec.element.is_none());
        for (index, spec) in at_places {
            let (z, velocity) = self.force_arguments(index);
            let mut forces = vec![0.0; 3 * z.len()];
            self.push(index, t, &z, &velocity, &mut forces);
            self.apply_part(index, load_scale, &mut forces);
            for (place, &marker) in spec.markers.iter().enumerate() {
                call(&self.links.markers[marker], part(&forces, place));
            }
        }
        for (index, marked) in self.links.marked_loads.iter().enumerate() {
            let forces = self.on_markers(index, self.marked_value(index, t, load_scale));
            for (marker, force) in marked.markers.iter().zip(forces) {
                call(marker, self.marked_frame(index).direction_to_inertial(force));
            }
        }
        self.each_constraint_force(t, lambda, call);
    }

    /// Multiplies the forces of a load, or their derivatives, by a part of it.
    fn apply_part(&self, force: usize, load_scale: f64, values: &mut [f64]) {
        if load_scale != 1.0 && self.is_load(force) {
            values.iter_mut().for_each(|value| *value *= load_scale);
        }
    }

    /// Values and velocities of the markers of a force; points from its anchor.
    pub(crate) fn force_arguments(&self, index: usize) -> (Vec<Vector>, Vec<Vector>) {
        let anchor = self.links.anchors.get(index).copied().flatten();
        let markers = self.links.forces[index].markers.iter();
        let jets = markers.map(|&marker| self.jet_from(&self.links.markers[marker], anchor));
        jets.map(|jet| (jet[0], jet[1])).unzip()
    }

    /// Adds the derivatives of the forces on markers at the loaded state.
    fn add_marker_force_tangents(&self, t: f64, load_scale: f64, out: &mut impl Sums) {
        self.add_spread_tangents(t, load_scale, out);
        for (index, spec) in self.links.forces.iter().enumerate() {
            if self.is_added_by_element(index) {
                continue;
            }
            let (z, velocity) = self.force_arguments(index);
            let count = z.len();
            let mut forces = vec![0.0; 3 * count];
            self.push(index, t, &z, &velocity, &mut forces);
            let [mut by_value, mut by_velocity] = [vec![0.0; 9 * count * count], vec![0.0; 9 * count * count]];
            self.push_tangent(index, t, &z, &velocity, [&mut by_value, &mut by_velocity]);
            for values in [&mut forces, &mut by_value, &mut by_velocity] {
                self.apply_part(index, load_scale, values);
            }
            let columns: Vec<Vec<Column>> = spec
                .markers
                .iter()
                .map(|&marker| self.columns(&self.links.markers[marker]))
                .collect();
            for m in 0..count {
                let frame = self.marker_frame(&self.links.markers[spec.markers[m]]);
                let force = self.buffers.frames[frame].direction_to_frame(part(&forces, m));
                let curvature = self.curvature(&self.links.markers[spec.markers[m]], force);
                for i in &columns[m] {
                    for (n, others) in columns.iter().enumerate() {
                        for j in others {
                            let rate = block_product(&by_velocity, count, m, n, i.value, j.value);
                            let mut value = block_product(&by_value, count, m, n, i.value, j.value)
                                + block_product(&by_velocity, count, m, n, i.value, j.rate);
                            if m == n {
                                value += i.second(j, force, curvature.as_ref());
                            }
                            for (entry, factor) in self.entries_of(i.component, j.component) {
                                out.stiffness(entry, -factor * value);
                                out.damping(entry, -factor * rate);
                            }
                        }
                    }
                }
            }
        }
        for index in 0..self.links.marked_loads.len() {
            self.add_marked_tangent(index, t, load_scale, out);
        }
    }

    /// Frame of the body that a marked load acts on.
    fn marked_frame(&self, index: usize) -> &FrameMotion {
        let marker = &self.links.marked_loads[index].markers[0];
        &self.buffers.frames[self.marker_frame(marker)]
    }

    /// Components of a marked load in the axes of its body's frame.
    fn marked_value(&self, index: usize, t: f64, load_scale: f64) -> Vector {
        let marked = &self.links.marked_loads[index];
        let load = load_scale * Vector::from(self.parts.load(marked.load, t));
        let inertial = self.buffers.frames[self.dead_loads.specs[marked.load].frame].direction_to_inertial(load);
        self.marked_frame(index).direction_to_frame(inertial)
    }

    /// Place and axes of the body that a marked moment acts on; `None` for forces.
    fn marked_moment(&self, index: usize) -> Option<(&MeshPoint, &'static [usize])> {
        let marked = &self.links.marked_loads[index];
        let point = self.dead_loads.points[marked.load].as_ref()?;
        let LoadKind::Moment { .. } = self.dead_loads.specs[marked.load].kind else {
            return None;
        };
        Some((point, self.bodies[point.body].spec.axes))
    }

    /// Forces on the markers in frame axes that a load with these components makes: those of a moment are
    /// linear in its components.
    fn on_markers(&self, index: usize, value: Vector) -> Vec<Vector> {
        let Some((point, axes)) = self.marked_moment(index) else {
            return vec![value];
        };
        let forces = self.moment_at(point, moment_in(axes, value));
        let count = self.links.marked_loads[index].markers.len();
        let vector = |part: &[f64]| {
            let mut force = Vector::zeros();
            for (value, &axis) in part.iter().zip(axes) {
                force[axis] = *value;
            }
            force
        };
        forces.chunks_exact(axes.len()).take(count).map(vector).collect()
    }

    /// Derivatives of those forces with respect to the markers, frame axes; the forces are objective.
    fn by_markers(&self, index: usize, value: Vector) -> Vec<Vec<Matrix>> {
        let count = self.links.marked_loads[index].markers.len();
        let mut blocks = vec![vec![Matrix::zeros(); count]; count];
        let Some((point, axes)) = self.marked_moment(index) else {
            return blocks;
        };
        let tangent = self.moment_tangent_at(point, moment_in(axes, value));
        let width = count * axes.len();
        for (m, row) in blocks.iter_mut().enumerate() {
            for (n, block) in row.iter_mut().enumerate() {
                for (i, &first) in axes.iter().enumerate() {
                    for (j, &second) in axes.iter().enumerate() {
                        block[(first, second)] = tangent[(m * axes.len() + i) * width + n * axes.len() + j];
                    }
                }
            }
        }
        blocks
    }

    fn add_marked_tangent(&self, index: usize, t: f64, load_scale: f64, out: &mut impl Sums) {
        let marked = &self.links.marked_loads[index];
        let frame = self.marked_frame(index);
        let value = self.marked_value(index, t, load_scale);
        let (forces, blocks) = (self.on_markers(index, value), self.by_markers(index, value));
        let columns: Vec<Vec<Column>> = marked.markers.iter().map(|marker| self.columns(marker)).collect();
        let load_frame = self.dead_loads.specs[marked.load].frame;
        let load = load_scale * Vector::from(self.parts.load(marked.load, t));
        let turns = match self.frames.free_of[load_frame] {
            Some(_) => self.columns(&Marker::Turn { frame: load_frame }),
            None => Vec::new(),
        };
        let axes = &self.buffers.frames[load_frame];
        let with_load: Vec<(usize, Vec<Vector>)> = turns
            .iter()
            .map(|turn| {
                let turned = axes.direction_to_inertial(turn.turn().cross(&load));
                (turn.component, self.on_markers(index, frame.direction_to_frame(turned)))
            })
            .collect();
        for (m, rows) in columns.iter().enumerate() {
            for i in rows {
                let row = frame.direction_to_frame(i.value);
                for (n, others) in columns.iter().enumerate() {
                    for j in others {
                        let change = frame.direction_to_frame(j.value);
                        let mut value = row.dot(&(blocks[m][n] * change));
                        if m == n {
                            value += i.second(j, forces[m], None);
                        }
                        for (entry, factor) in self.entries_of(i.component, j.component) {
                            out.stiffness(entry, -factor * value);
                        }
                    }
                }
                for (component, changes) in &with_load {
                    for (entry, factor) in self.entries_of(i.component, *component) {
                        out.stiffness(entry, -factor * row.dot(&changes[m]));
                    }
                }
            }
        }
    }

    /// Potential of the conservative forces on markers, J; `None` where one is not conservative.
    pub(crate) fn marker_energy(&self, t: f64) -> Option<f64> {
        let mut energy = 0.0;
        for (index, spec) in self.links.forces.iter().enumerate() {
            if !spec.conservative {
                return None;
            }
            let (z, _) = self.force_arguments(index);
            energy += self.parts.marker_energy(index, t, &z);
        }
        Some(energy)
    }
}

/// A moment as bodies with these axes take it: planar ones about the normal, first.
fn moment_in(axes: &[usize], value: Vector) -> [f64; 3] {
    match *axes {
        [first, second] => [value[3 - first - second], 0.0, 0.0],
        _ => value.into(),
    }
}
