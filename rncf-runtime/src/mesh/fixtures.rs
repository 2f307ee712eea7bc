//! Rigid fixtures on flexible bodies (THEORY 5.4): constants on position and slope of their place, with a
//! section also on its axes.

use super::evaluate::weighted;
use super::markers::FixtureSpec;
use super::parts::{BodySpec, Carried, CarriedTangent};
use super::scene::{MeshPoint, MeshScene, PlaceVector};
use crate::system::Tangent;
use crate::vector::Vector;

/// A fixture at its place.
pub(super) struct Fixture {
    pub spec: FixtureSpec,
    pub point: MeshPoint,
    vectors: &'static [PlaceVector],
}

/// Most components of the vectors of a place.
const MOST: usize = 12;

/// The vectors of a place with their derivatives.
type Places = [[f64; MOST]; 3];

/// The vectors of a place that a fixture acts on, in the order of its constants.
fn vectors_of(spec: &BodySpec) -> &'static [PlaceVector] {
    const ALL: &[PlaceVector] = &[
        PlaceVector::Position,
        PlaceVector::Slope,
        PlaceVector::SectionY,
        PlaceVector::SectionZ,
    ];
    &ALL[..1 + spec.interpolants()]
}

impl Fixture {
    /// A fixture at its place on a body.
    pub fn new(spec: FixtureSpec, point: MeshPoint, body: &BodySpec) -> Self {
        Self {
            spec,
            point,
            vectors: vectors_of(body),
        }
    }

    /// Masses of the vectors of the place (THEORY 5.4): mass, first and second moments.
    fn block(&self) -> [[f64; 4]; 4] {
        let [mass, x, y, z, xx, yy, zz, xy, xz, yz] = self.spec.constants;
        [[mass, x, y, z], [x, xx, xy, xz], [y, xy, yy, yz], [z, xz, yz, zz]]
    }

    /// Weights of an element's vectors in the vectors of the place.
    fn weights(&self) -> impl Iterator<Item = &[f64]> {
        self.vectors.iter().map(|&of| self.point.weights(of))
    }

    /// Number of vectors of the element.
    fn count(&self) -> usize {
        self.point.weights(PlaceVector::Position).len()
    }

    /// Mass of an element's vectors that the fixture adds, rows first.
    pub fn mass(&self) -> Vec<f64> {
        let (count, block) = (self.count(), self.block());
        let mut result = vec![0.0; count * count];
        for (i, rows) in self.weights().enumerate() {
            for (j, columns) in self.weights().enumerate() {
                for (place, sum) in result.iter_mut().enumerate() {
                    *sum += rows[place / count] * block[i][j] * columns[place % count];
                }
            }
        }
        result
    }

    /// Pulls columns of the place back to those of the element: `matrix` has `rows` rows of `skip`
    /// columns that stay, then those of the place.
    fn pull_columns(&self, matrix: &[f64], rows: usize, skip: usize, dimension: usize) -> Vec<f64> {
        let count = self.count();
        let (narrow, wide) = (skip + self.vectors.len() * dimension, skip + count * dimension);
        let mut result = vec![0.0; rows * wide];
        for row in 0..rows {
            result[row * wide..row * wide + skip].copy_from_slice(&matrix[row * narrow..row * narrow + skip]);
            for vector in 0..count {
                for c in 0..dimension {
                    let place = row * narrow + skip + c;
                    let pulled = self.weights().enumerate();
                    result[row * wide + skip + vector * dimension + c] = pulled
                        .map(|(of, weights)| weights[vector] * matrix[place + of * dimension])
                        .sum();
                }
            }
        }
        result
    }

    /// Pulls rows of the place (of `width` columns) back to those of the element.
    fn pull_rows(&self, matrix: &[f64], dimension: usize, width: usize) -> Vec<f64> {
        let count = self.count();
        let mut result = vec![0.0; count * dimension * width];
        for vector in 0..count {
            for c in 0..dimension {
                for column in 0..width {
                    let pulled = self.weights().enumerate();
                    result[(vector * dimension + c) * width + column] = pulled
                        .map(|(of, weights)| weights[vector] * matrix[(of * dimension + c) * width + column])
                        .sum();
                }
            }
        }
        result
    }
}

impl MeshScene {
    /// The vectors of a fixture's place, and their derivatives.
    fn fixture_place(&self, fixture: &Fixture) -> Places {
        let body = &self.bodies[fixture.point.body];
        let dimension = body.spec.dimension();
        let components = body.connectivity.element(fixture.point.element);
        let buffers = &self.buffers;
        [&buffers.q, &buffers.v, &buffers.a].map(|full| {
            let mut place = [0.0; MOST];
            for (part, weights) in place.chunks_exact_mut(dimension).zip(fixture.weights()) {
                part.copy_from_slice(&weighted(full, components, dimension, weights)[..dimension]);
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
            let vectors = fixture.vectors.len();
            let width = vectors * axes.len();
            let action = self.buffers.frames[frame].action(axes, gravity);
            let [q, v, a] = self.fixture_place(fixture);
            let (q, v, a) = (&q[..width], &v[..width], &a[..width]);
            let constants = fixture.spec.constants;
            let mut force = [0.0; MOST];
            let out = &mut force[..width];
            self.parts
                .fixture_force(axes.len(), vectors, constants, frame == 0, &action, q, v, a, out);
            let pulled = fixture.pull_rows(&force, axes.len(), 1);
            for (&component, value) in body.connectivity.element(fixture.point.element).iter().zip(pulled) {
                self.buffers.force[component] += value;
            }
            if let Some(free) = self.free_of[frame] {
                let mut rows = [0.0; 6];
                let rows = &mut rows[..carried_rows(axes.len())];
                let of = Carried::Fixture {
                    dimension: axes.len(),
                    vectors,
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
            let vectors = fixture.vectors.len();
            let width = vectors * dimension;
            let action = self.buffers.frames[body.frame].action(body.spec.axes, [0.0; 3]);
            let [mut k, mut c] = [vec![0.0; width * width], vec![0.0; width * width]];
            let constants = fixture.spec.constants;
            self.parts
                .fixture_tangent(dimension, vectors, constants, body.frame == 0, &action, &mut k, &mut c);
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
            let vectors = fixture.vectors.len();
            let width = vectors * dimension;
            let action = self.buffers.frames[body.frame].action(axes, gravity);
            let [q, v, a] = self.fixture_place(fixture);
            let (q, v, a) = (&q[..width], &v[..width], &a[..width]);
            let of = Carried::Fixture {
                dimension,
                vectors,
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
        // First moments: of the mass itself, and along the other vectors.
        let moments = fixture.spec.constants;
        let vectors = q.chunks_exact(dimension).zip(&moments).take(fixture.vectors.len());
        let along = |(vector, moment): (&[f64], &f64)| -> f64 {
            let pulled = vector.iter().zip(body.spec.axes).map(|(q, &axis)| q * pull[axis]);
            -moment * pulled.sum::<f64>()
        };
        vectors.map(along).sum()
    }
}

/// Rows of force and moment.
fn carried_rows(dimension: usize) -> usize {
    if dimension == 2 { 3 } else { 6 }
}
