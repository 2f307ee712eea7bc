//! Rigid fixtures on flexible bodies (THEORY 5.4): constants on position and slope of their place.

use super::markers::FixtureSpec;
use super::parts::{Carried, CarriedTangent, Parts};
use super::scene::{MeshPoint, MeshScene};
use crate::system::Tangent;
use crate::vector::Vector;

/// A fixture at its place.
pub(super) struct Fixture {
    pub spec: FixtureSpec,
    pub point: MeshPoint,
}

/// Position and slope of a place with their derivatives: up to six numbers each.
type Places = [[f64; 6]; 3];

impl Fixture {
    /// Weight of an element's vector in position (0) or slope (1).
    fn weight(&self, order: usize, vector: usize) -> f64 {
        if order == 0 {
            self.point.values[vector]
        } else {
            self.point.slopes[vector]
        }
    }

    /// Mass of an element's vectors that the fixture adds, rows first.
    pub fn mass(&self) -> Vec<f64> {
        let count = self.point.values.len();
        let [mass, first, second] = self.spec.constants;
        let block = [[mass, first], [first, second]];
        let mut result = vec![0.0; count * count];
        for a in 0..count {
            for b in 0..count {
                for i in 0..2 {
                    for j in 0..2 {
                        result[a * count + b] += self.weight(i, a) * block[i][j] * self.weight(j, b);
                    }
                }
            }
        }
        result
    }

    /// Pulls columns of the place back to those of the element: `matrix` has `rows` rows of `skip`
    /// columns that stay, then `2 d`.
    fn pull_columns(&self, matrix: &[f64], rows: usize, skip: usize, dimension: usize) -> Vec<f64> {
        let count = self.point.values.len();
        let (narrow, wide) = (skip + 2 * dimension, skip + count * dimension);
        let mut result = vec![0.0; rows * wide];
        for row in 0..rows {
            result[row * wide..row * wide + skip].copy_from_slice(&matrix[row * narrow..row * narrow + skip]);
            for vector in 0..count {
                for c in 0..dimension {
                    let at = |order: usize| matrix[row * narrow + skip + order * dimension + c];
                    result[row * wide + skip + vector * dimension + c] =
                        self.weight(0, vector) * at(0) + self.weight(1, vector) * at(1);
                }
            }
        }
        result
    }

    /// Pulls rows of the place (`2 d`, of `width` columns) back to those of the element.
    fn pull_rows(&self, matrix: &[f64], dimension: usize, width: usize) -> Vec<f64> {
        let count = self.point.values.len();
        let mut result = vec![0.0; count * dimension * width];
        for vector in 0..count {
            for c in 0..dimension {
                for column in 0..width {
                    let at = |order: usize| matrix[(order * dimension + c) * width + column];
                    result[(vector * dimension + c) * width + column] =
                        self.weight(0, vector) * at(0) + self.weight(1, vector) * at(1);
                }
            }
        }
        result
    }
}

impl<P: Parts> MeshScene<P> {
    /// Position and slope of a fixture's place, and their derivatives.
    fn fixture_place(&self, fixture: &Fixture) -> Places {
        let body = &self.bodies[fixture.point.body];
        let dimension = body.spec.dimension();
        let components = body.connectivity.element(fixture.point.element);
        let buffers = &self.buffers;
        [&buffers.q, &buffers.v, &buffers.a].map(|full| {
            let mut place = [0.0; 6];
            for (local, &component) in components.iter().enumerate() {
                for order in 0..2 {
                    place[order * dimension + local % dimension] +=
                        fixture.weight(order, local / dimension) * full[component];
                }
            }
            place
        })
    }

    /// Adds the inertia forces of all fixtures at the loaded state.
    pub(super) fn add_fixture_forces(&mut self, gravity: Vector) {
        for index in 0..self.fixtures.len() {
            let fixture = &self.fixtures[index];
            let body = &self.bodies[fixture.point.body];
            let (axes, frame) = (body.spec.axes, body.frame);
            let width = 2 * axes.len();
            let action = self.buffers.frames[frame].action(axes, gravity);
            let [q, v, a] = self.fixture_place(fixture);
            let (q, v, a) = (&q[..width], &v[..width], &a[..width]);
            let constants = fixture.spec.constants;
            let mut force = [0.0; 6];
            self.parts
                .fixture_force(axes.len(), constants, frame == 0, &action, q, v, a, &mut force[..width]);
            let pulled = fixture.pull_rows(&force, axes.len(), 1);
            for (&component, value) in body.connectivity.element(fixture.point.element).iter().zip(pulled) {
                self.buffers.force[component] += value;
            }
            if let Some(free) = self.free_of[frame] {
                let mut rows = [0.0; 6];
                let rows = &mut rows[..carried_rows(axes.len())];
                let of = Carried::Fixture {
                    dimension: axes.len(),
                    constants,
                };
                self.parts.carried(of, &action, q, v, a, rows);
                self.add_to_frame(free, axes, rows);
            }
        }
    }

    /// Adds the derivatives of the forces of all fixtures on nodal vectors.
    pub(super) fn add_fixture_tangents(&self, stiffness: &mut [f64], damping: &mut [f64]) {
        for fixture in &self.fixtures {
            let body = &self.bodies[fixture.point.body];
            let dimension = body.spec.dimension();
            let width = 2 * dimension;
            let action = self.buffers.frames[body.frame].action(body.spec.axes, [0.0; 3]);
            let [mut k, mut c] = [vec![0.0; width * width], vec![0.0; width * width]];
            let constants = fixture.spec.constants;
            self.parts
                .fixture_tangent(dimension, constants, body.frame == 0, &action, &mut k, &mut c);
            let size = body.spec.element_size();
            for (local, values) in [(k, &mut *stiffness), (c, &mut *damping)] {
                let rows = fixture.pull_columns(&local, width, 0, dimension);
                let pulled = fixture.pull_rows(&rows, dimension, size);
                body.scatter.add(fixture.point.element, &pulled, values);
            }
        }
    }

    /// Adds what fixtures make between nodal vectors and their free frames.
    pub(super) fn add_fixture_borders(&self, gravity: Vector, out: &mut Tangent) {
        for fixture in &self.fixtures {
            let body = &self.bodies[fixture.point.body];
            if self.free_of[body.frame].is_none() {
                continue;
            }
            let axes = body.spec.axes;
            let dimension = axes.len();
            let width = 2 * dimension;
            let action = self.buffers.frames[body.frame].action(axes, gravity);
            let [q, v, a] = self.fixture_place(fixture);
            let (q, v, a) = (&q[..width], &v[..width], &a[..width]);
            let of = Carried::Fixture {
                dimension,
                constants: fixture.spec.constants,
            };
            let mut rows = [0.0; 6];
            let count = carried_rows(dimension);
            self.parts.carried(of, &action, q, v, a, &mut rows[..count]);
            let mut tangent = CarriedTangent::default();
            self.parts.carried_tangent(of, &action, q, v, a, &mut tangent);
            let turns = count - dimension;
            let pulled = CarriedTangent {
                mass: fixture.pull_columns(&tangent.mass, count, count, dimension),
                damping: fixture.pull_columns(&tangent.damping, count, turns, dimension),
                spin: fixture.pull_rows(&tangent.spin, dimension, turns),
                stiffness: fixture.pull_columns(&tangent.stiffness, count, 0, dimension),
            };
            self.add_carried_place(&fixture.point, &pulled, &rows[..count], gravity, out);
        }
    }

    /// Potential of a fixture in the gravity `g` (inertial axes), J, without what its frame's origin adds.
    pub(super) fn fixture_potential(&self, fixture: &Fixture, gravity: Vector) -> f64 {
        let body = &self.bodies[fixture.point.body];
        let dimension = body.spec.dimension();
        let pull = self.buffers.frames[body.frame].direction_to_frame(gravity);
        let [q, ..] = self.fixture_place(fixture);
        let [mass, first, _] = fixture.spec.constants;
        (0..dimension)
            .map(|c| -pull[body.spec.axes[c]] * (mass * q[c] + first * q[dimension + c]))
            .sum()
    }
}

/// Rows of force and moment.
fn carried_rows(dimension: usize) -> usize {
    if dimension == 2 { 3 } else { 6 }
}
