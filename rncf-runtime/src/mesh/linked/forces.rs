//! Forces on markers, and declared loads where frames are free: the frame feels them, too.

use super::super::parts::{LoadKind, Parts};
use super::super::scene::MeshScene;
use super::constraints::{block_product, part};
use super::jets::{Column, Marker};
use crate::vector::{Vector, cross, dot};

/// A declared load on a body whose frame is free, or along the axes of a free frame.
pub(in super::super) struct MarkedLoad {
    /// Load.
    pub load: usize,
    /// Where it acts: a point, or the slope for a moment.
    pub marker: Marker,
}

impl<P: Parts> MeshScene<P> {
    /// Adds the forces on markers (to the left side, where they are negative) at the loaded state.
    pub(in super::super) fn add_marker_forces(&mut self, t: f64, load_scale: f64) {
        for index in 0..self.forces.len() {
            let spec = &self.forces[index];
            let (z, velocity) = self.force_arguments(spec.markers);
            let mut forces = vec![0.0; 3 * z.len()];
            self.parts.marker_force(index, t, &z, &velocity, &mut forces);
            self.apply_part(index, load_scale, &mut forces);
            for (place, &marker) in spec.markers.iter().enumerate() {
                let columns = self.columns(&self.markers[marker]);
                for column in columns {
                    self.buffers.force[column.component] -= dot(part(&forces, place), column.value);
                }
            }
        }
        for index in 0..self.marked_loads.len() {
            let force = self.marked_force(index, t, load_scale);
            let columns = self.columns(&self.marked_loads[index].marker);
            for column in columns {
                self.buffers.force[column.component] -= dot(force, column.value);
            }
        }
    }

    /// Multiplies the forces of a load, or their derivatives, by a part of it.
    fn apply_part(&self, force: usize, load_scale: f64, values: &mut [f64]) {
        if load_scale != 1.0 && self.parts.is_load(force) {
            values.iter_mut().for_each(|value| *value *= load_scale);
        }
    }

    pub(super) fn force_arguments(&self, markers: &[usize]) -> (Vec<Vector>, Vec<Vector>) {
        let jets = markers.iter().map(|&marker| self.jet(&self.markers[marker]));
        jets.map(|jet| (jet[0], jet[1])).unzip()
    }

    /// Adds the derivatives of the forces on markers at the loaded state.
    pub(in super::super) fn add_marker_force_tangents(
        &self,
        t: f64,
        load_scale: f64,
        stiffness: &mut [f64],
        damping: &mut [f64],
    ) {
        for (index, spec) in self.forces.iter().enumerate() {
            let (z, velocity) = self.force_arguments(spec.markers);
            let count = z.len();
            let mut forces = vec![0.0; 3 * count];
            self.parts.marker_force(index, t, &z, &velocity, &mut forces);
            let [mut by_value, mut by_velocity] = [vec![0.0; 9 * count * count], vec![0.0; 9 * count * count]];
            self.parts
                .marker_force_tangent(index, t, &z, &velocity, &mut by_value, &mut by_velocity);
            for values in [&mut forces, &mut by_value, &mut by_velocity] {
                self.apply_part(index, load_scale, values);
            }
            let columns: Vec<Vec<Column>> = spec
                .markers
                .iter()
                .map(|&marker| self.columns(&self.markers[marker]))
                .collect();
            for m in 0..count {
                let frame = self.marker_frame(&self.markers[spec.markers[m]]);
                let force = self.buffers.frames[frame].direction_to_frame(part(&forces, m));
                for i in &columns[m] {
                    for (n, others) in columns.iter().enumerate() {
                        for j in others {
                            let rate = block_product(&by_velocity, count, m, n, i.value, j.value);
                            let mut value = block_product(&by_value, count, m, n, i.value, j.value)
                                + block_product(&by_velocity, count, m, n, i.value, j.rate);
                            if m == n {
                                value += i.second(j, force);
                            }
                            self.add_entry(i.component, j.component, -value, stiffness);
                            self.add_entry(i.component, j.component, -rate, damping);
                        }
                    }
                }
            }
        }
        for index in 0..self.marked_loads.len() {
            self.add_marked_tangent(index, t, load_scale, stiffness);
        }
    }

    /// Components of a marked load in the axes of its marker's frame.
    fn marked_value(&self, index: usize, t: f64, load_scale: f64) -> Vector {
        let marked = &self.marked_loads[index];
        let frames = &self.buffers.frames;
        let load = self.parts.load(marked.load, t).map(|x| load_scale * x);
        let inertial = frames[self.loads[marked.load].frame].direction_to_inertial(load);
        frames[self.marker_frame(&marked.marker)].direction_to_frame(inertial)
    }

    /// Force on the marker in frame axes that a load with these components makes: a moment is one on
    /// the slope, linear in its components.
    fn on_marker(&self, index: usize, value: Vector) -> Vector {
        let marked = &self.marked_loads[index];
        let Some((axes, slope)) = self.marked_slope(index) else {
            return value;
        };
        let mut force = [0.0; 3];
        self.parts.moment(
            axes.len(),
            &slope[..axes.len()],
            moment_in(axes, value),
            &mut force[..axes.len()],
        );
        self.bodies[self.body_of(&marked.marker)].spread(force)
    }

    /// Axes and slope (in their order) of the body that a marked moment acts on.
    fn marked_slope(&self, index: usize) -> Option<(&'static [usize], Vector)> {
        let marked = &self.marked_loads[index];
        let LoadKind::Moment { body, .. } = self.loads[marked.load].kind else {
            return None;
        };
        let axes = self.bodies[body].spec.axes;
        let frame = &self.buffers.frames[self.bodies[body].frame];
        let inertial = self.jet(&marked.marker)[0];
        let slope = frame.direction_to_frame(inertial);
        let mut ordered = [0.0; 3];
        for (place, &axis) in axes.iter().enumerate() {
            ordered[place] = slope[axis];
        }
        Some((axes, ordered))
    }

    fn body_of(&self, marker: &Marker) -> usize {
        match marker {
            Marker::Body { point, .. } => point.body,
            _ => 0,
        }
    }

    /// Force on the marker, inertial axes.
    fn marked_force(&self, index: usize, t: f64, load_scale: f64) -> Vector {
        let frame = self.marker_frame(&self.marked_loads[index].marker);
        let force = self.on_marker(index, self.marked_value(index, t, load_scale));
        self.buffers.frames[frame].direction_to_inertial(force)
    }

    fn add_marked_tangent(&self, index: usize, t: f64, load_scale: f64, stiffness: &mut [f64]) {
        let marked = &self.marked_loads[index];
        let frame = &self.buffers.frames[self.marker_frame(&marked.marker)];
        let value = self.marked_value(index, t, load_scale);
        let force = self.on_marker(index, value);
        let columns = self.columns(&marked.marker);
        // The force depends on the slope; its derivative is that in frame axes, since it is objective.
        let mut by_slope = [[0.0; 3]; 3];
        if let Some((axes, slope)) = self.marked_slope(index) {
            let dimension = axes.len();
            let mut block = [0.0; 9];
            self.parts.moment_tangent(
                dimension,
                &slope[..dimension],
                moment_in(axes, value),
                &mut block[..dimension * dimension],
            );
            for (i, &row) in axes.iter().enumerate() {
                for (j, &column) in axes.iter().enumerate() {
                    by_slope[row][column] = block[i * dimension + j];
                }
            }
        }
        let load_frame = self.loads[marked.load].frame;
        let load = self.parts.load(marked.load, t).map(|x| load_scale * x);
        for i in &columns {
            let row = frame.direction_to_frame(i.value);
            for j in &columns {
                let change = frame.direction_to_frame(j.value);
                let value = dot(row, crate::vector::apply(&by_slope, change)) + i.second(j, force);
                self.add_entry(i.component, j.component, -value, stiffness);
            }
            if self.free_of[load_frame].is_some() {
                let axes = &self.buffers.frames[load_frame];
                for j in self.columns(&Marker::Turn { frame: load_frame }) {
                    let turned = axes.direction_to_inertial(cross(j.turn(), load));
                    let change = self.on_marker(index, frame.direction_to_frame(turned));
                    self.add_entry(i.component, j.component, -dot(row, change), stiffness);
                }
            }
        }
    }

    /// Potential of the conservative forces on markers, J; `None` where one is not conservative.
    pub(in super::super) fn marker_energy(&self, t: f64) -> Option<f64> {
        let mut energy = 0.0;
        for (index, spec) in self.forces.iter().enumerate() {
            if !spec.conservative {
                return None;
            }
            let (z, _) = self.force_arguments(spec.markers);
            energy += self.parts.marker_energy(index, t, &z);
        }
        Some(energy)
    }
}

/// A moment as bodies with these axes take it: planar ones about the normal, first.
fn moment_in(axes: &[usize], value: Vector) -> Vector {
    match *axes {
        [first, second] => [value[3 - first - second], 0.0, 0.0],
        _ => value,
    }
}
