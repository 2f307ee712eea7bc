//! Constraints and forces that depend on differences of points alone are evaluated near what they act on.
//!
//! Found by trial, as in `symmetry`: the emitted function is evaluated at arbitrary vectors, and at the same ones after a shift. An analytic function that does not change there does so nowhere but by chance.

use crate::emitted::Parts;
use crate::scene::MeshScene;
use crate::scene::pieces::marker::{Linked, Marker};
use crate::scene::pieces::push::{Law, Push};
use crate::space::Vector;
use crate::system::ConstraintLevel;

/// Largest change, as a part of the terms, that counts as round-off.
const ROUND_OFF: f64 = 1e-9;
/// Last bits of a value.
const LAST_BITS: f64 = 16.0 * f64::EPSILON;
/// Trials, each with vectors longer than those before: a constant may hide what small ones do.
const TRIALS: usize = 3;
const LONGER: f64 = 1e3;
/// Times at which functions of time are looked at, s; the kinks of the model are added.
const LOOKS: [f64; 4] = [0.0, 0.13, 7.3, 1009.0];
/// Distance of a start, in sizes of what the frame carries, from which on differences are taken near it.
const FAR: f64 = 10.0;

/// Arbitrary vectors: the same in every run.
struct Trial {
    values: Vec<Vector>,
    velocities: Vec<Vector>,
    shift: Vector,
    drift: Vector,
}

impl Trial {
    /// For markers in a scene of the given length, m.
    fn new(number: usize, markers: &[&Marker], length: f64) -> Self {
        let mut count = 31.0 * number as f64;
        let mut next = || {
            count += 1.0;
            (1e4 * (12.9898 * count).sin()).fract()
        };
        let length = length * LONGER.powi(number as i32);
        let mut vector = |size: f64| -> Vector { Vector::from_fn(|_, _| size * next()) };
        let size = |marker: &Marker| if marker.is_point() { length } else { 1.0 };
        Self {
            values: markers.iter().map(|&marker| vector(size(marker))).collect(),
            velocities: markers.iter().map(|&marker| vector(size(marker))).collect(),
            shift: vector(length),
            drift: vector(length),
        }
    }

    /// The values after a shift of all points.
    fn moved(&self, markers: &[&Marker]) -> Vec<Vector> {
        let moved = |(&value, &marker): (&Vector, &&Marker)| match marker.is_point() {
            true => value + self.shift,
            false => value,
        };
        self.values.iter().zip(markers).map(moved).collect()
    }
}

/// Times at which functions of time are looked at.
fn looks(parts: &dyn Parts) -> Vec<f64> {
    let kinks = parts.kinks().into_iter().filter(|t| t.is_finite());
    LOOKS
        .into_iter()
        .chain(kinks.flat_map(|t| [t.next_down(), t.next_up()]))
        .collect()
}

/// Whether two evaluations differ by no more than a round-off of what the vectors add to them, and of their own last
/// bits: constants in them may be large.
fn same(a: &[f64], b: &[f64], terms: f64) -> bool {
    // Not a number is no agreement.
    a.iter()
        .zip(b)
        .all(|(a, b)| (a - b).abs() <= ROUND_OFF * terms + LAST_BITS * a.abs())
}

/// Whether a constraint with so many rows depends on differences of points and on directions alone; `length` is that of the
/// scene, m.
fn constraint_is_of_differences(
    parts: &dyn Parts,
    (constraint, rows): (usize, usize),
    markers: &[&Marker],
    length: f64,
) -> bool {
    (0..TRIALS).all(|number| {
        let trial = Trial::new(number, markers, length);
        looks(parts).into_iter().all(|t| {
            let rows_at = |values: &[Vector]| {
                let jets: Vec<[Vector; 4]> = values
                    .iter()
                    .map(|&z| [z, Vector::zeros(), Vector::zeros(), Vector::zeros()])
                    .collect();
                let mut result = vec![0.0; rows];
                parts.marker_constraint(constraint, ConstraintLevel::Position, t, &jets, &mut result);
                result
            };
            let moved = trial.moved(markers);
            let mut gradient = vec![0.0; rows * 3 * moved.len()];
            parts.marker_constraint_gradient(constraint, t, &moved, &mut gradient);
            let sizes = moved.iter().map(|&z| z.norm()).fold(0.0, f64::max);
            let terms = sizes * gradient.iter().map(|entry| entry.abs()).sum::<f64>();
            terms.is_finite() && same(&rows_at(&trial.values), &rows_at(&moved), terms)
        })
    })
}

/// Whether a force depends on differences of points and of their velocities alone.
fn force_is_of_differences(parts: &dyn Parts, force: usize, markers: &[&Marker], length: f64) -> bool {
    (0..TRIALS).all(|number| {
        let trial = Trial::new(number, markers, length);
        let fast: Vec<Vector> = trial
            .velocities
            .iter()
            .zip(markers)
            .map(|(&v, marker)| if marker.is_point() { v + trial.drift } else { v })
            .collect();
        looks(parts).into_iter().all(|t| {
            let force_at = |z: &[Vector], velocity: &[Vector]| {
                let mut result = vec![0.0; 3 * z.len()];
                parts.marker_force(force, t, z, velocity, &mut result);
                result
            };
            let before = force_at(&trial.values, &trial.velocities);
            let after = force_at(&trial.moved(markers), &fast);
            let terms = before.iter().map(|value| value.abs()).sum::<f64>();
            terms.is_finite() && same(&before, &after, terms)
        })
    })
}

impl MeshScene {
    /// The free frames near which constraints and forces of differences are evaluated: where a scene is far from the
    /// origin, so that differences of its places would lose digits. Sizes must be known.
    pub(crate) fn find_anchors(&mut self) {
        let length = self.tabulated.sizes.iter().copied().fold(0.0, f64::max);
        let of_constraint = |linked: &Linked| {
            let anchor = self.anchor(linked.spec.markers)?;
            let markers: Vec<&Marker> = linked
                .spec
                .markers
                .iter()
                .map(|&marker| &self.links.markers[marker])
                .collect();
            let constraint = (linked.index, linked.spec.rows.len());
            constraint_is_of_differences(&*self.parts, constraint, &markers, length).then_some(anchor)
        };
        let anchors: Vec<Option<usize>> = self.links.constraints.iter().map(of_constraint).collect();
        let of_force = |spec: &Push| {
            let Law::Force(index) = spec.law else { return None };
            let anchor = self.anchor(&spec.markers)?;
            let markers: Vec<&Marker> = spec.markers.iter().map(|&marker| &self.links.markers[marker]).collect();
            force_is_of_differences(&*self.parts, index, &markers, length).then_some(anchor)
        };
        self.links.anchors = self.links.forces.iter().map(of_force).collect();
        for (linked, anchor) in self.links.constraints.iter_mut().zip(anchors) {
            linked.anchor = anchor;
        }
    }

    /// The first free frame among those of the points, if it starts far away.
    fn anchor(&self, markers: &[usize]) -> Option<usize> {
        let border = self.layout.unknowns() - self.layout.border();
        let points = markers
            .iter()
            .map(|&marker| &self.links.markers[marker])
            .filter(|marker| marker.is_point());
        let mut frames = points.filter_map(|marker| self.frames.free_of[self.marker_frame(marker)]);
        let free = frames.find(|&free| self.frames.free[free].shifts() > 0)?;
        let frame = &self.frames.free[free];
        (frame.start.position.norm() > FAR * self.tabulated.sizes[border + frame.first]).then_some(free)
    }
}
