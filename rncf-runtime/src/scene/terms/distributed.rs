//! Loads per length that are integrated at points, and gravity that changes from place to place: where their points are.
//!
//! Gravity acts on masses at points that have mass, first and second moments of what they stand for: points of every element and
//! around them in its section, of fixtures and of rigid bodies. So its gradient turns all of them, force and moment have the
//! potential of these masses, and momenta balance.

use crate::emitted::{Fidelity, Interpolant, Line, LoadKind, Motions, legendre};
use crate::error::ModelError;
use crate::model::Warning;
use crate::scene::bodies::place::{MeshPoint, PlaceVector, point_of};
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::Marker;
use crate::scene::pieces::push::{Law, Push, Spread};
use crate::space::{Matrix, Vector, rows};

/// The vectors of a place, as a load counts them.
const VECTORS: [PlaceVector; 4] = [
    PlaceVector::Position,
    PlaceVector::Slope,
    PlaceVector::SectionY,
    PlaceVector::SectionZ,
];

/// Part of the inertia of a planar body that is not that of masses at known places, from which on it is told.
const UNPLACED: f64 = 0.01;

/// Part of an element below which nothing is integrated on its own.
const SHORTEST: f64 = 1e-9;

/// A rule of an element that is cut where a load has steps: with its points on every part.
fn cut(rule: &[(f64, f64)], steps: impl Iterator<Item = f64>) -> Vec<(f64, f64)> {
    let mut ends: Vec<f64> = steps.filter(|xi| (SHORTEST..1.0 - SHORTEST).contains(xi)).collect();
    ends.push(1.0);
    ends.sort_unstable_by(f64::total_cmp);
    let mut points = Vec::with_capacity(ends.len() * rule.len());
    let mut from = 0.0;
    for to in ends {
        if to - from > SHORTEST {
            points.extend(
                rule.iter()
                    .map(|&(xi, weight)| (from + (to - from) * xi, (to - from) * weight)),
            );
            from = to;
        }
    }
    points
}

/// Most points of an element that masses stand at: they have its moments up to the third along the axis.
const MOST_POINTS: usize = 4;

/// Difference of a monomial from what shape functions make of it that counts as round-off.
const ROUND_OFF: f64 = 1e-9;

impl MeshScene {
    /// Finds the points of distributed loads and of gravity that changes from place to place.
    ///
    /// # Errors
    /// A table that does not cover an axis, or a body without shape, by name.
    pub(crate) fn place_points(&mut self) -> Result<(), ModelError> {
        let mut pushes = Vec::new();
        for (load, spec) in self.parts.distributed().iter().enumerate() {
            let Some(body) = self.bodies.get(spec.body) else {
                return Err(ModelError::new(format!(
                    "load `{}` is on a repetition of its body that there is none of",
                    spec.name
                )));
            };
            self.refuse_points(spec.name, spec.body)?;
            let (spec_of, length) = (&body.spec, body.spec.line.length());
            for table in &spec.tables {
                table.check(&spec_of.label(), length)?;
            }
            let rule = legendre(spec.points);
            for element in 0..spec_of.count {
                let [from, to] = [0.0, 1.0].map(|xi| spec_of.arclength(element, xi));
                let steps = spec.tables.iter().flat_map(|table| table.steps(length));
                for (xi, weight) in cut(&rule, steps.map(|fraction| (fraction * length - from) / (to - from))) {
                    let point = point_of(&*self.parts, spec_of, spec.body, element, xi);
                    let law = Law::Distributed {
                        load,
                        at: [spec_of.arclength(element, xi), length],
                        weight: weight * (to - from),
                    };
                    let markers = spec.vectors.iter().map(|&of| Marker::Body {
                        point: point.clone(),
                        of: VECTORS[of],
                    });
                    pushes.push((spec.name, law, markers.collect(), Some((spec.body, element))));
                }
            }
        }
        let around = self.dead_loads.specs.iter().enumerate();
        let around: Vec<(usize, &'static str)> = around
            .filter(|(_, load)| load.kind == LoadKind::Around)
            .map(|(index, load)| (index, load.name))
            .collect();
        for &(load, name) in &around {
            for (mass, marker, element) in self.masses(name)? {
                pushes.push((name, Law::Gravity { load, mass }, vec![marker], element));
            }
        }
        // What acts at one place first, then element after element.
        pushes.sort_by_key(|(.., element)| *element);
        for (name, law, markers, element) in pushes {
            let first = self.links.markers.len();
            self.links.markers.extend(markers);
            let index = self.links.forces.len();
            if let Some((body, number)) = element {
                match self.links.spread.last_mut() {
                    Some(last) if (last.body, last.element) == (body, number) => last.forces.end = index + 1,
                    _ => self.links.spread.push(Spread {
                        body,
                        element: number,
                        forces: index..index + 1,
                    }),
                }
            }
            let markers: Vec<usize> = (first..self.links.markers.len()).collect();
            let nowhere = vec![Vector::zeros(); markers.len()];
            let branches = self.gaps_of(law, 0.0, &nowhere, &nowhere).len();
            self.links.forces.push(Push {
                name,
                markers,
                of_differences: false,
                conservative: false,
                branches,
                law,
                element,
            });
        }
        Ok(())
    }

    /// Refuses loads along a body whose mass is at one place.
    fn refuse_points(&self, load: &str, body: usize) -> Result<(), ModelError> {
        let spec = &self.bodies[body].spec;
        if matches!(spec.line, Line::Nodes(_)) {
            return Err(ModelError::new(format!(
                "load `{load}` acts on every particle of body `{}`, which comes from a file and has no particles: let forces act on its interfaces, and `gravity([0, 0, -9.81] m/s^2)` on its mass",
                spec.label()
            )));
        }
        if spec.fidelity != Fidelity::Point {
            return Ok(());
        }
        Err(ModelError::new(format!(
            "load `{load}` acts along body `{}`, which is described as a point: describe it as `rigid`",
            spec.label()
        )))
    }

    /// Masses (kg) at points that stand for all that has mass, and the element that they are spread over.
    #[allow(clippy::type_complexity)] // one list, read at once
    fn masses(&self, load: &str) -> Result<Vec<(f64, Marker, Option<(usize, usize)>)>, ModelError> {
        let mut masses = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            self.refuse_points(load, index)?;
            for element in 0..body.spec.count {
                for (xi, [mass, y, z, yy, zz, yz]) in self.masses_of_element(index, element) {
                    let point = point_of(&*self.parts, &body.spec, index, element, xi);
                    for (mass, [y, z]) in particles(mass, [y, z], [[yy, yz], [yz, zz]]) {
                        masses.push((mass, at(point.combined([1.0, 0.0, y, z])), Some((index, element))));
                    }
                }
            }
        }
        for fixture in &self.fixtures {
            let [[mass, x, y, z], second @ ..] = fixture.block();
            let second: [[f64; 3]; 3] = second.map(|[_, rest @ ..]| rest);
            for (mass, [x, y, z]) in particles(mass, [x, y, z], second) {
                masses.push((mass, at(fixture.point.combined([1.0, x, y, z])), None));
            }
        }
        for free in &self.frames.free {
            let (spec, rigid) = (&free.spec, &free.spec.rigid);
            let (mass, first) = (rigid.mass, rigid.moment);
            let trace: f64 = (0..3).map(|i| rigid.inertia[(i, i)]).sum();
            let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
            let second = |i: usize, j: usize| 0.5 * trace * unit(i, j) - rigid.inertia[(i, j)];
            let second: Matrix = match spec.motions {
                Motions::Shifting | Motions::ShiftingPlanar { .. } => Matrix::zeros(),
                // Of what is unplaced in a plane half lies along either axis of it, and nothing along its normal.
                Motions::Planar { normal } => {
                    Matrix::from_fn(|i, j| if [i, j].contains(&normal) { 0.0 } else { second(i, j) })
                }
                _ => Matrix::from_fn(second),
            };
            for (mass, at) in particles(mass, first.into(), rows(&second)) {
                let (frame, is_point) = (spec.frame, true);
                let at = at.into();
                masses.push((mass, Marker::Fixed { frame, at, is_point }, None));
            }
        }
        Ok(masses)
    }

    /// Planar bodies whose mass is spread in a way that nothing tells, under gravity that depends on the place.
    pub(crate) fn spread_alike(&self) -> Vec<Warning> {
        let mut loads = self.dead_loads.specs.iter();
        let Some(load) = loads.find(|load| load.kind == LoadKind::Around) else {
            return Vec::new();
        };
        let free = self.frames.free.iter().filter_map(|free| {
            let (spec, inertia) = (&free.spec, &free.spec.rigid.inertia);
            let Motions::Planar { normal } = spec.motions else {
                return None;
            };
            let part = unplaced(inertia, normal) / inertia[(normal, normal)];
            (part > UNPLACED).then(|| Warning {
                text: format!(
                    "`{}` moves in a plane, where one `inertia` says nothing of how its mass is spread: `{}` acts on it as on mass that is spread alike along both axes, which the gradient of gravity does not turn. Give its masses as fixtures at their places, or let it move in space",
                    self.parts.frame_name(spec.frame),
                    load.name
                ),
                weight: part,
            })
        });
        free.collect()
    }

    /// Masses of an element at points of its axis: mass, first moments y and z, second moments yy, zz and yz. They have its moments
    /// along the axis up to the third, or as many as its shape functions tell.
    fn masses_of_element(&self, body: usize, element: usize) -> Vec<(f64, [f64; 6])> {
        let spec = &self.bodies[body].spec;
        let count = spec.nodal.len();
        let mut mass = vec![0.0; count * count];
        self.parts.mass(body, element, &mut mass);
        let all = [Interpolant::Position, Interpolant::SectionY, Interpolant::SectionZ];
        let powers = all.map(|of| self.powers(body, element, of));
        // Moment of this power of s = 2 xi - 1, and the highest one that is known.
        let moment = |[a, b]: [usize; 2], power: usize| {
            let first = power.min(powers[a].len().saturating_sub(1));
            let (left, right) = (powers[a].get(first)?, powers[b].get(power - first)?);
            let rows = left.iter().zip(mass.chunks_exact(count));
            Some(
                rows.map(|(l, row)| l * row.iter().zip(right).map(|(m, r)| m * r).sum::<f64>())
                    .sum(),
            )
        };
        const PAIRS: [[usize; 2]; 6] = [[0, 0], [0, 1], [0, 2], [1, 1], [2, 2], [1, 2]];
        let there = PAIRS.map(|[a, b]| !powers[a].is_empty() && !powers[b].is_empty());
        let known = |points: usize| {
            let mut pairs = PAIRS.iter().zip(there).filter(|(_, there)| *there);
            pairs.all(|(&pair, _)| (0..points).all(|power| moment(pair, power).is_some()))
        };
        let points = (1..=MOST_POINTS).rev().find(|&points| known(points)).unwrap_or(1);
        let places = legendre(points);
        let row = |power: i32| places.iter().map(|(xi, _)| (2.0 * xi - 1.0).powi(power)).collect();
        let rows: Vec<Vec<f64>> = (0..points as i32).map(row).collect();
        let shares = PAIRS.map(|pair| {
            let moments: Vec<f64> = (0..points).map(|power| moment(pair, power).unwrap_or(0.0)).collect();
            solved(rows.clone(), moments)
        });
        let at = |place: usize| shares.each_ref().map(|share| share[place]);
        places
            .iter()
            .enumerate()
            .map(|(place, (xi, _))| (*xi, at(place)))
            .collect()
    }

    /// Components of the element's vectors that make an interpolant 1, s, s^2, .. of s = 2 xi - 1, as far as its shapes can.
    fn powers(&self, body: usize, element: usize, of: Interpolant) -> Vec<Vec<f64>> {
        let spec = &self.bodies[body].spec;
        let count = spec.nodal.len();
        let own: Vec<usize> = (0..count).filter(|&vector| spec.nodal[vector].of == of).collect();
        if own.is_empty() {
            return Vec::new();
        }
        let shapes = |xi: f64| {
            let mut weights = vec![0.0; count];
            self.parts.shapes(body, element, of, 0, xi, &mut weights);
            own.iter().map(|&vector| weights[vector]).collect::<Vec<f64>>()
        };
        let places: Vec<f64> = (0..own.len()).map(|at| (at as f64 + 0.5) / own.len() as f64).collect();
        let rows: Vec<Vec<f64>> = places.iter().map(|&xi| shapes(xi)).collect();
        let mut powers = Vec::new();
        for power in 0..own.len() as i32 {
            let value = |xi: f64| (2.0 * xi - 1.0).powi(power);
            let found = solved(rows.clone(), places.iter().map(|&xi| value(xi)).collect());
            let made = |xi: f64| shapes(xi).iter().zip(&found).map(|(shape, c)| shape * c).sum::<f64>();
            let is_made = [0.07, 0.37, 0.9]
                .iter()
                .all(|&xi| (made(xi) - value(xi)).abs() <= ROUND_OFF);
            if !is_made {
                break;
            }
            let mut all = vec![0.0; count];
            own.iter().zip(&found).for_each(|(&vector, &value)| all[vector] = value);
            powers.push(all);
        }
        powers
    }
}

/// Of an inertia in a plane what is not that of masses at known places: those have moments about the axes of the plane, too.
fn unplaced(inertia: &Matrix, normal: usize) -> f64 {
    let placed: f64 = (0..3)
        .filter(|&axis| axis != normal)
        .map(|axis| inertia[(axis, axis)])
        .sum();
    (inertia[(normal, normal)] - placed).max(0.0)
}

fn at(point: MeshPoint) -> Marker {
    let of = PlaceVector::Position;
    Marker::Body { point, of }
}

/// Masses at points with the same mass, first and second moments: pairs beside the centre along columns of a Cholesky factor of
/// what the second moments about it are.
fn particles<const N: usize>(mass: f64, first: [f64; N], second: [[f64; N]; N]) -> Vec<(f64, [f64; N])> {
    if mass <= 0.0 {
        return Vec::new();
    }
    let center = first.map(|value| value / mass);
    let mut rest = second;
    for (i, row) in rest.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            *value -= first[i] * center[j];
        }
    }
    let mut columns: Vec<[f64; N]> = Vec::new();
    for _ in 0..N {
        // Largest pivots first: what is left of the others is round-off.
        let largest = |a: &usize, b: &usize| rest[*a][*a].total_cmp(&rest[*b][*b]);
        let Some(pivot) = (0..N).max_by(largest).filter(|&pivot| rest[pivot][pivot] > 0.0) else {
            break;
        };
        let root = rest[pivot][pivot].sqrt();
        let column: [f64; N] = std::array::from_fn(|i| rest[i][pivot] / root);
        for (i, row) in rest.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                *value -= column[i] * column[j];
            }
        }
        rest[pivot][pivot] = 0.0;
        columns.push(column);
    }
    if columns.is_empty() {
        return vec![(mass, center)];
    }
    let pairs = columns.len() as f64;
    let apart = (pairs / mass).sqrt();
    let both = columns.iter().flat_map(|column| {
        [-apart, apart].map(|apart| {
            let at = std::array::from_fn(|i| center[i] + apart * column[i]);
            (0.5 * mass / pairs, at)
        })
    });
    both.collect()
}

/// Solution of a few equations by elimination with row pivots; zeros where they are singular.
fn solved(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    let count = right.len();
    for column in 0..count {
        let largest = |a: &usize, b: &usize| rows[*a][column].abs().total_cmp(&rows[*b][column].abs());
        let pivot = (column..count).max_by(largest).unwrap_or(column);
        if rows[pivot][column] == 0.0 {
            return vec![0.0; count];
        }
        rows.swap(column, pivot);
        right.swap(column, pivot);
        let own = rows[column].clone();
        for row in (0..count).filter(|&row| row != column) {
            let factor = rows[row][column] / own[column];
            rows[row]
                .iter_mut()
                .zip(&own)
                .for_each(|(value, own)| *value -= factor * own);
            right[row] -= factor * right[column];
        }
    }
    (0..count).map(|row| right[row] / rows[row][row]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn particles_have_mass_first_and_second_moments() {
        let (mass, first) = (3.0, [0.6, -0.9, 1.5]);
        let about: [[f64; 3]; 3] = [[2.0, 0.3, -0.4], [0.3, 1.0, 0.2], [-0.4, 0.2, 0.7]];
        let second = Matrix::from_fn(|i, j| about[i][j] + first[i] * first[j] / mass);
        let all = particles(mass, first, rows(&second));
        assert_eq!(all.len(), 6);
        let sum = |of: &dyn Fn(&[f64; 3]) -> f64| all.iter().map(|(mass, at)| mass * of(at)).sum::<f64>();
        assert!((sum(&|_| 1.0) - mass).abs() < 1e-14);
        for i in 0..3 {
            assert!((sum(&|at| at[i]) - first[i]).abs() < 1e-14);
            for j in 0..3 {
                assert!((sum(&|at| at[i] * at[j]) - second[(i, j)]).abs() < 1e-14);
            }
        }
        assert_eq!(particles(2.0, [0.0; 3], [[0.0; 3]; 3]), vec![(2.0, [0.0; 3])]);
    }
}
