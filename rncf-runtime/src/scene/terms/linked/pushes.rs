//! What acts on markers: declared forces, and loads per length and gravity at points of what carries mass. A load per length on
//! an element is summed over its points before it goes to the nodal vectors.

use crate::emitted::MAX_SIZE;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::bodies::place::{MeshPoint, PlaceVector};
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::Marker;
use crate::scene::pieces::push::{Law, Spread};
use crate::space::{Matrix, Vector};
use crate::system::Sums;

/// Derivatives of a spread load by the components of an element, rows first.
struct Local {
    stiffness: Vec<f64>,
    damping: Vec<f64>,
}

impl MeshScene {
    /// Forces on the markers of a force, 3 k numbers.
    pub(crate) fn push(&self, index: usize, t: f64, z: &[Vector], velocity: &[Vector], out: &mut [f64]) {
        match self.links.forces[index].law {
            Law::Force(force) => self.parts.marker_force(force, t, z, velocity, out),
            Law::Distributed { load, at, weight } => {
                self.parts.distributed_force(load, t, at, z, velocity, out);
                out.iter_mut().for_each(|value| *value *= weight);
            }
            Law::Gravity { load, mass } => {
                let gravity = self.parts.around(load, t, z[0]);
                out.iter_mut().zip(&gravity).for_each(|(to, value)| *to = mass * value);
            }
        }
    }

    /// Their derivatives with respect to the markers' values and velocities, 3 k x 3 k each.
    pub(crate) fn push_tangent(
        &self,
        index: usize,
        t: f64,
        z: &[Vector],
        velocity: &[Vector],
        [by_value, by_velocity]: [&mut [f64]; 2],
    ) {
        match self.links.forces[index].law {
            Law::Force(force) => self
                .parts
                .marker_force_tangent(force, t, z, velocity, by_value, by_velocity),
            Law::Distributed { load, at, weight } => {
                self.parts
                    .distributed_tangent(load, t, at, z, velocity, by_value, by_velocity);
                let all = by_value.iter_mut().chain(by_velocity);
                all.for_each(|value| *value *= weight);
            }
            Law::Gravity { load, mass } => {
                let mut gradient = [0.0; 9];
                self.parts.around_gradient(load, t, z[0], &mut gradient);
                by_velocity.fill(0.0);
                by_value
                    .iter_mut()
                    .zip(gradient)
                    .for_each(|(to, value)| *to = mass * value);
            }
        }
    }

    /// Whether a force on markers is a load, which equilibria apply in parts. What reads a state is a controller's, and acts in full.
    pub(crate) fn is_load(&self, index: usize) -> bool {
        let is_of_state = |&marker: &usize| self.is_state_marker(&self.links.markers[marker]);
        match self.links.forces[index].law {
            Law::Force(force) => self.parts.is_load(force) && !self.links.forces[index].markers.iter().any(is_of_state),
            Law::Distributed { .. } | Law::Gravity { .. } => true,
        }
    }

    /// Place, or direction, and its velocity in the axes of the frame of the body.
    fn particle(&self, body: &MeshBody, point: &MeshPoint, of: PlaceVector) -> [Vector; 2] {
        let [mut p, rate] = [&self.buffers.q, &self.buffers.v].map(|full| self.at_point(point, of, full));
        if of == PlaceVector::Position {
            p += body.offset;
        }
        [p, rate]
    }

    /// The places of a spread force on its element.
    fn spread_places(&self, index: usize) -> impl Iterator<Item = (&MeshPoint, PlaceVector)> {
        let markers = self.links.forces[index].markers.iter();
        markers.filter_map(|&marker| match &self.links.markers[marker] {
            Marker::Body { point, of } => Some((point, *of)),
            _ => None,
        })
    }

    /// Arguments of a spread force, inertial axes, and its places in the frame of the body.
    fn spread_arguments(&self, index: usize, body: &MeshBody) -> [Vec<Vector>; 3] {
        let frame = &self.buffers.frames[body.frame];
        let (mut z, mut velocity, mut places) = (Vec::new(), Vec::new(), Vec::new());
        for (point, of) in self.spread_places(index) {
            let [p, rate] = self.particle(body, point, of);
            let mut at = frame.rotation * p;
            let mut rate = frame.rotation * (rate + frame.spin.cross(&p));
            if of == PlaceVector::Position {
                at += frame.position;
                rate += frame.velocity;
            }
            z.push(at);
            velocity.push(rate);
            places.push(p);
        }
        [z, velocity, places]
    }

    /// Generalised forces of what is spread over an element on its components, in the axes of the frame that they live in, and
    /// force and moment on that frame.
    fn spread_force(&self, spread: &Spread, t: f64) -> ([f64; MAX_SIZE], [Vector; 2]) {
        let body = &self.bodies[spread.body];
        let rotation = &self.buffers.frames[body.frame].rotation;
        let dimension = body.spec.dimension();
        let (mut local, mut on_frame) = ([0.0; MAX_SIZE], [Vector::zeros(); 2]);
        for index in spread.forces.clone() {
            let [z, velocity, places] = self.spread_arguments(index, body);
            let mut out = [0.0; 12];
            let out = &mut out[..3 * z.len()];
            self.push(index, t, &z, &velocity, out);
            for (place, (point, of)) in self.spread_places(index).enumerate() {
                let force = rotation.tr_mul(&vector(out, place));
                for (own, &weight) in local.chunks_exact_mut(dimension).zip(point.weights(of)) {
                    for (value, &axis) in own.iter_mut().zip(body.spec.axes) {
                        *value += weight * force[axis];
                    }
                }
                if of == PlaceVector::Position {
                    on_frame[0] += force;
                }
                on_frame[1] += places[place].cross(&force);
            }
        }
        (local, on_frame)
    }

    /// Adds what is spread over elements to the forces (to the left side, where it is negative).
    pub(crate) fn add_spread_forces(&mut self, t: f64, load_scale: f64) {
        for at in 0..self.links.spread.len() {
            let (local, on_frame) = self.spread_force(&self.links.spread[at], t);
            let spread = &self.links.spread[at];
            let body = &self.bodies[spread.body];
            for (&component, value) in body.connectivity.element(spread.element).iter().zip(local) {
                self.buffers.force[component] -= load_scale * value;
            }
            if let Some(free) = self.frames.free_of[body.frame] {
                self.add_to_unknowns(free, on_frame.map(|row| -load_scale * row));
            }
        }
    }

    /// What is spread over one element.
    pub(crate) fn spread_over(&self, body: usize, element: usize) -> impl Iterator<Item = &Spread> {
        let all = &self.links.spread;
        let first = all.partition_point(|spread| (spread.body, spread.element) < (body, element));
        all[first..]
            .iter()
            .take_while(move |spread| (spread.body, spread.element) == (body, element))
    }

    /// Generalised forces of what is spread over one element on its components, at the loaded state.
    pub(crate) fn spread_on(&self, body: usize, element: usize) -> [f64; MAX_SIZE] {
        let mut sum = [0.0; MAX_SIZE];
        for spread in self.spread_over(body, element) {
            let (local, _) = self.spread_force(spread, self.buffers.t);
            sum.iter_mut().zip(local).for_each(|(sum, value)| *sum += value);
        }
        sum
    }

    /// Whether the derivatives of a force are added with those of its element: not where a free frame feels it, too.
    pub(crate) fn is_added_by_element(&self, index: usize) -> bool {
        let body = self.links.forces[index].element.map(|(body, _)| &self.bodies[body]);
        body.is_some_and(|body| self.frames.free_of[body.frame].is_none())
    }

    /// Adds the derivatives of what is spread over elements of bodies whose frames are prescribed.
    pub(crate) fn add_spread_tangents(&self, t: f64, load_scale: f64, out: &mut impl Sums) {
        let mut local = Local {
            stiffness: Vec::new(),
            damping: Vec::new(),
        };
        for spread in &self.links.spread {
            let body = &self.bodies[spread.body];
            if self.frames.free_of[body.frame].is_some() {
                continue;
            }
            let size = body.spec.element_size();
            for values in [&mut local.stiffness, &mut local.damping] {
                values.clear();
                values.resize(size * size, 0.0);
            }
            for index in spread.forces.clone() {
                self.add_point_tangent(index, t, body, &mut local);
            }
            let (stiffness, factor) = out.all_stiffness();
            let factor = -factor * load_scale;
            let add_to = |values: &[f64], factor: f64, sums: &mut [f64]| {
                body.scatter
                    .add_by(spread.element, values, |value| factor * value, sums);
            };
            add_to(&local.stiffness, factor, stiffness);
            let (damping, factor) = out.all_damping();
            add_to(&local.damping, -factor * load_scale, damping);
        }
    }

    /// Adds the derivatives of one point of a spread force.
    fn add_point_tangent(&self, index: usize, t: f64, body: &MeshBody, local: &mut Local) {
        let frame = &self.buffers.frames[body.frame];
        let [z, velocity, _] = self.spread_arguments(index, body);
        let count = z.len();
        let (mut by_value, mut by_velocity) = ([0.0; 144], [0.0; 144]);
        let (by_value, by_velocity) = (
            &mut by_value[..9 * count * count],
            &mut by_velocity[..9 * count * count],
        );
        self.push_tangent(index, t, &z, &velocity, [by_value, by_velocity]);
        let (back, spin) = (frame.rotation.transpose(), frame.spin.cross_matrix());
        let turns = frame.spin != Vector::zeros();
        let in_frame = |values: &[f64], m: usize, n: usize| -> Option<Matrix> {
            let entry = |i: usize, j: usize| values[(3 * m + i) * 3 * count + 3 * n + j];
            let block = Matrix::from_fn(entry);
            (block != Matrix::zeros()).then(|| back * (block * frame.rotation))
        };
        let places: Vec<(&MeshPoint, PlaceVector)> = self.spread_places(index).collect();
        for (m, &(point, of)) in places.iter().enumerate() {
            for (n, &(other, by)) in places.iter().enumerate() {
                let mut value = in_frame(by_value, m, n);
                let rate = in_frame(by_velocity, m, n);
                if let Some(rate) = rate.as_ref().filter(|_| turns) {
                    // The velocity of a particle has w x p in it.
                    let carried = rate * spin;
                    let sum = value.unwrap_or(Matrix::zeros());
                    value = Some(sum + carried);
                }
                for (block, to) in [(value, &mut local.stiffness), (rate, &mut local.damping)] {
                    if let Some(block) = block {
                        add_block(to, &block, [point.weights(of), other.weights(by)], body.spec.axes);
                    }
                }
            }
        }
    }
}

/// A vector among numbers.
fn vector(values: &[f64], place: usize) -> Vector {
    Vector::from_fn(|i, _| values[3 * place + i])
}

/// Adds a block to the matrix of an element, with weights of its vectors in rows and columns.
fn add_block(to: &mut [f64], block: &Matrix, [rows, columns]: [&[f64]; 2], axes: &[usize]) {
    let dimension = axes.len();
    let size = rows.len() * dimension;
    for (a, &row) in rows.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
        for (b, &column) in columns.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
            let weight = row * column;
            for (c, &i) in axes.iter().enumerate() {
                for (e, &j) in axes.iter().enumerate() {
                    to[(a * dimension + c) * size + b * dimension + e] += weight * block[(i, j)];
                }
            }
        }
    }
}
