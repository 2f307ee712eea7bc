//! Rigid fixtures on flexible bodies (THEORY 5.4): constants on position and slope of their place, with a
//! section also on its axes. Of a section that they make rigid the normal stands for the slope, which shears.

use super::force::{At, Force};
use crate::model::Warning;
use crate::scene::bodies::nodal_mass::Transport;
use crate::scene::bodies::place::weighted;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::combination::Combination;
use crate::scene::pieces::combined::Combined;
use crate::scene::pieces::fixture::{Fixture, MOST};
use crate::space::{Matrix, Vector};
use crate::system::Tangent;

/// Largest strain of the section below a rigid fixture of which nothing is said: its moments of inertia are then off
/// by two times as much.
const RIGID_ENOUGH: f64 = 1e-4;
/// The same for the stretch of a slope that a fixture reaches along.
const SHORT_ENOUGH: f64 = 1e-3;

/// Inertia of fixtures on nodal vectors: what turning frames make of their constant masses. Their forces are in the one
/// product of [`Inertia`](super::inertia::Inertia).
pub(crate) struct Fixtures;

impl Force for Fixtures {
    /// Nothing beside what their elements and the normals of rigid sections couple.
    fn couple(&self, _: &MeshScene, _: &mut Vec<(usize, usize)>) {}

    fn add(&self, _: &mut MeshScene, _: &At) {}

    fn add_tangent(&self, scene: &mut MeshScene, _: &At, out: &mut Tangent) {
        for (place, values) in [(1, &mut out.damping), (2, &mut out.stiffness)] {
            scene.add_fixture_tangents(&Combination::only(place), values);
        }
    }

    fn add_combined(&self, scene: &mut MeshScene, _: &At, out: &mut Combined) {
        scene.add_fixture_tangents(out.combination, out.values);
    }
}

impl MeshScene {
    /// The vectors of a fixture's place.
    fn fixture_place(&self, fixture: &Fixture) -> [f64; MOST] {
        let body = &self.bodies[fixture.point.body];
        let dimension = body.spec.dimension();
        let components = body.connectivity.element(fixture.point.element);
        let mut place = [0.0; MOST];
        for (vector, weights) in fixture.weights() {
            let part = &mut place[vector * dimension..(vector + 1) * dimension];
            part.copy_from_slice(&weighted(&self.buffers.q, components, dimension, weights)[..dimension]);
        }
        if let Some(normal) = fixture.normal {
            let first = self.layout.offset(body.first_vector + normal);
            place[dimension..2 * dimension].copy_from_slice(&self.buffers.q[first..first + dimension]);
        }
        place
    }

    /// Masses beside the normals of sections: body, first components of both vectors, mass.
    pub(crate) fn masses_of_normals(&self) -> Vec<(usize, [usize; 2], f64)> {
        let of = |fixture: &Fixture| {
            let (index, body) = (fixture.point.body, &self.bodies[fixture.point.body]);
            let entries = fixture.entries_of_normal(&body.spec).into_iter();
            let offset = |vector: usize| self.layout.offset(body.first_vector + vector);
            let own: Vec<_> = entries
                .map(|(vectors, value)| (index, vectors.map(offset), value))
                .collect();
            own
        };
        self.fixtures.iter().flat_map(of).collect()
    }

    /// Adds the derivatives of the inertia forces of all fixtures on nodal vectors, but for their mass, which is
    /// constant.
    fn add_fixture_tangents(&self, combination: &Combination, values: &mut [f64]) {
        for fixture in &self.fixtures {
            let body = &self.bodies[fixture.point.body];
            let axes = body.spec.axes;
            let transport = Transport::new(&self.buffers.frames[body.frame], axes, Vector::zeros());
            let block = combination.block(&transport);
            if block == Matrix::zeros() {
                continue;
            }
            let (d, size, count) = (axes.len(), body.spec.element_size(), fixture.count());
            let mass = fixture.mass();
            let entry = |place: usize| {
                let (row, column) = (place / size, place % size);
                mass[row / d * count + column / d] * block[(axes[row % d], axes[column % d])]
            };
            let local: Vec<f64> = (0..size * size).map(entry).collect();
            body.scatter.add(fixture.point.element, &local, values);
        }
        for (body, [row, column], mass) in self.masses_of_normals() {
            let body = &self.bodies[body];
            let axes = body.spec.axes;
            let transport = Transport::new(&self.buffers.frames[body.frame], axes, Vector::zeros());
            let block = combination.block(&transport);
            for (i, &a) in axes.iter().enumerate() {
                for (j, &b) in axes.iter().enumerate() {
                    for (entry, factor) in self.entries_of(row + i, column + j) {
                        values[entry] += factor * mass * block[(a, b)];
                    }
                }
            }
        }
    }

    /// Fixtures whose section is not rigid at the loaded state, in words: their inertia pulls at its axes, which are elastic.
    pub(crate) fn strained_fixtures(&self) -> Vec<Warning> {
        let told = |fixture: &Fixture| {
            let body = &self.bodies[fixture.point.body];
            let dimension = body.spec.dimension();
            if !body.spec.has_section() {
                return self.stretched_slope(fixture);
            }
            let strains = body.spec.fidelity.deforms() && !fixture.is_rigid;
            if !strains || fixture.spec.elastic || fixture.spec.constants[4..] == [0.0; 6] {
                return None;
            }
            let place = self.fixture_place(fixture);
            let axes: Vec<&[f64]> = place
                .chunks_exact(dimension)
                .take(fixture.vectors.len())
                .skip(2)
                .collect();
            let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let stretches = axes.iter().map(|axis| 0.5 * (product(axis, axis) - 1.0));
            let shear = if let [y, z] = axes[..] {
                0.5 * product(y, z)
            } else {
                0.0
            };
            let strain = stretches
                .chain([shear])
                .fold(0.0, |most: f64, strain| most.max(strain.abs()));
            (strain > RIGID_ENOUGH).then(|| Warning {
                weight: strain,
                text: format!(
                    "fixture `{}` is rigid, and the section of body `{}` that carries it strains by {:.2} %: its inertia is off by twice as much; describe the body by all its nodal vectors, or take a `rigid` body and a `weld`",
                    fixture.spec.name,
                    body.spec.label(),
                    100.0 * strain
                ),
            })
        };
        self.fixtures.iter().filter_map(told).collect()
    }

    /// A fixture that reaches along the slope of a body without cross-sections where that is stretched at the loaded state, in words: what acts there stretches
    /// it, which the last element alone resists, the less the longer it is.
    fn stretched_slope(&self, fixture: &Fixture) -> Option<Warning> {
        let body = &self.bodies[fixture.point.body];
        let constants = &fixture.spec.constants;
        // Its first and second moment along the slope.
        if !body.spec.fidelity.deforms() || constants[1] == 0.0 && constants[4] == 0.0 {
            return None;
        }
        let place = self.fixture_place(fixture);
        let slope = place.chunks_exact(body.spec.dimension()).nth(1)?;
        let stretch = (slope.iter().map(|part| part * part).sum::<f64>().sqrt() - 1.0).abs();
        (stretch > SHORT_ENOUGH).then(|| Warning {
            weight: stretch,
            text: format!(
                "fixture `{}` sits on the slope of body `{}`, which is stretched by {:.2} % there: its `offset` and `gyration` count by as much more, and shorter elements stretch further; take a `rigid` body and a `weld`",
                fixture.spec.name,
                body.spec.label(),
                100.0 * stretch
            ),
        })
    }

    /// Potential of a fixture in the gravity `g` (inertial axes), J, without what its frame's origin adds.
    pub(crate) fn fixture_potential(&self, fixture: &Fixture, gravity: Vector) -> f64 {
        let body = &self.bodies[fixture.point.body];
        let dimension = body.spec.dimension();
        let pull = self.buffers.frames[body.frame].direction_to_frame(gravity);
        let q = self.fixture_place(fixture);
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
