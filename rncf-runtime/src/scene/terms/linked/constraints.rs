//! Constraints on markers: values, Jacobians, and what their forces add to the stiffness.

use super::jets::Column;
use crate::scene::MeshScene;
use crate::scene::numbering::assembly::couple_all;
use crate::scene::pieces::combined::Combined;
use crate::scene::pieces::marker::{Linked, Marker};
use crate::scene::terms::constraint::Constraint;
use crate::space::Vector;
use crate::system::{ConstraintLevel, Sums, Tangent};

/// The three numbers of marker `place` in a row of `3 k`.
pub(super) fn part(row: &[f64], place: usize) -> Vector {
    Vector::from_fn(|i, _| row[3 * place + i])
}

/// `a . H b` with the block (`m`, `n`) of a matrix of `3 k` columns.
pub(super) fn block_product(matrix: &[f64], markers: usize, m: usize, n: usize, a: Vector, b: Vector) -> f64 {
    let width = 3 * markers;
    (0..3)
        .map(|i| {
            let row = &matrix[(3 * m + i) * width + 3 * n..][..3];
            a[i] * (row[0] * b[0] + row[1] * b[1] + row[2] * b[2])
        })
        .sum()
}

/// Whether the block (`m`, `n`) of a matrix of `3 k` columns is zero.
fn is_zero_block(matrix: &[f64], markers: usize, m: usize, n: usize) -> bool {
    let row = |i: usize| &matrix[(3 * m + i) * 3 * markers + 3 * n..][..3];
    (0..3).all(|i| row(i).iter().all(|&entry| entry == 0.0))
}

/// Joints, drives and declared constraints on markers.
pub(crate) struct Links;

impl Constraint for Links {
    fn rows(&self, scene: &MeshScene) -> Vec<Vec<usize>> {
        let rows = |linked: &Linked| {
            let markers = linked.spec.markers.iter();
            let components = markers.flat_map(|&marker| scene.marker_components(&scene.links.markers[marker]));
            vec![scene.unknowns_of(components); linked.spec.rows.len()]
        };
        scene.links.constraints.iter().flat_map(rows).collect()
    }

    /// A constraint couples what one marker depends on, by its frame, and what markers depend on that it multiplies. Others
    /// meet in its multipliers alone: a row from end to end of a body leaves the matrix as narrow as it is.
    fn couple(&self, scene: &MeshScene, entries: &mut Vec<(usize, usize)>) {
        for linked in &scene.links.constraints {
            let markers = linked.spec.markers;
            for &marker in markers {
                couple_all(&scene.unknowns_of_markers(&[marker]), entries);
            }
            for &[first, second] in linked.spec.coupled {
                couple_all(&scene.unknowns_of_markers(&[markers[first], markers[second]]), entries);
            }
        }
    }

    fn describe(&self, scene: &MeshScene, row: usize) -> String {
        let links = scene.links.constraints.iter();
        let mut rows = links.flat_map(|linked| linked.spec.rows.iter().map(|row| (&linked.spec, row)));
        rows.nth(row).map_or(String::new(), |(spec, row)| {
            let owner = match spec.kind {
                "constraint" => format!("constraint `{}`", spec.name),
                kind => format!("joint `{}` ({kind})", spec.name),
            };
            format!("{owner}, {row}")
        })
    }

    fn is_curved(&self, scene: &MeshScene) -> bool {
        !scene.links.constraints.is_empty()
    }

    fn values(&self, scene: &MeshScene, level: ConstraintLevel, t: f64, out: &mut [f64]) {
        let mut first = 0;
        for linked in &scene.links.constraints {
            // A level reads derivatives up to its own.
            let jet = |&marker: &usize| {
                let marker = &scene.links.markers[marker];
                match level {
                    ConstraintLevel::Position => scene.jet_to::<1>(marker, linked.anchor),
                    _ => scene.jet_from(marker, linked.anchor),
                }
            };
            let jets: Vec<[Vector; 4]> = linked.spec.markers.iter().map(jet).collect();
            let count = linked.spec.rows.len();
            let rows = &mut out[first..first + count];
            rows.fill(0.0);
            scene.parts.marker_constraint(linked.index, level, t, &jets, rows);
            first += count;
        }
    }

    fn add_jacobian(&self, scene: &MeshScene, t: f64, mut first: usize, values: &mut [f64]) {
        for linked in &scene.links.constraints {
            let z = scene.marker_values(linked);
            let gradient = scene.gradient(linked, t, &z);
            let width = 3 * z.len();
            for (place, &marker) in linked.spec.markers.iter().enumerate() {
                scene.each_column(&scene.links.markers[marker], |column| {
                    for (row, gradient) in gradient.chunks_exact(width).enumerate() {
                        let value = part(gradient, place).dot(&column.value);
                        scene.add_to_row(column.component, first + row, value, values);
                    }
                });
            }
            first += linked.spec.rows.len();
        }
    }

    fn add_rate_tangent(&self, scene: &MeshScene, t: f64, mut first: usize, values: &mut [f64]) {
        for linked in &scene.links.constraints {
            let [z, velocity] = scene.arguments(linked);
            let gradient = scene.gradient(linked, t, &z);
            let mut rates = vec![0.0; gradient.len()];
            scene
                .parts
                .marker_constraint_rate_gradient(linked.index, t, &z, &velocity, &mut rates);
            let width = 3 * z.len();
            for (place, columns) in scene.all_columns(linked).iter().enumerate() {
                for row in 0..linked.spec.rows.len() {
                    let line = row * width..(row + 1) * width;
                    let (gradient, rate) = (part(&gradient[line.clone()], place), part(&rates[line], place));
                    for column in columns {
                        let value = rate.dot(&column.value) + gradient.dot(&column.rate);
                        scene.add_to_row(column.component, first + row, value, values);
                    }
                }
            }
            first += linked.spec.rows.len();
        }
    }

    fn add_stiffness(&self, scene: &MeshScene, t: f64, lambda: &[f64], out: &mut Tangent) {
        scene.link_stiffness(t, lambda, out);
    }

    fn add_combined(&self, scene: &MeshScene, t: f64, lambda: &[f64], out: &mut Combined) {
        scene.link_stiffness(t, lambda, out);
    }

    fn noise(&self, scene: &MeshScene, t: f64, rows: &mut [f64]) {
        scene.link_noise(t, rows);
    }
}

impl MeshScene {
    /// Unknowns that some markers depend on, ascending, each once.
    pub(super) fn unknowns_of_markers(&self, markers: &[usize]) -> Vec<usize> {
        let markers = markers.iter().map(|&marker| &self.links.markers[marker]);
        self.unknowns_of(markers.flat_map(|marker| self.marker_components(marker)))
    }

    fn constraint_marker(&self, linked: &Linked, place: usize) -> &Marker {
        &self.links.markers[linked.spec.markers[place]]
    }

    /// Values of the markers of a constraint.
    pub(super) fn marker_values(&self, linked: &Linked) -> Vec<Vector> {
        let markers = linked.spec.markers.iter();
        let value = |&marker: &usize| self.jet_to::<1>(&self.links.markers[marker], linked.anchor)[0];
        markers.map(value).collect()
    }

    /// These, and those of their velocities.
    pub(super) fn arguments(&self, linked: &Linked) -> [Vec<Vector>; 2] {
        let jets = linked
            .spec
            .markers
            .iter()
            .map(|&marker| self.jet_to::<2>(&self.links.markers[marker], linked.anchor));
        let (values, velocities) = jets.map(|jet| (jet[0], jet[1])).unzip();
        [values, velocities]
    }

    fn all_columns(&self, linked: &Linked) -> Vec<Vec<Column>> {
        let markers = linked.spec.markers.iter();
        markers
            .map(|&marker| self.columns(&self.links.markers[marker]))
            .collect()
    }

    /// dC/dz at the loaded state: rows x 3 k.
    fn gradient(&self, linked: &Linked, t: f64, values: &[Vector]) -> Vec<f64> {
        let mut gradient = vec![0.0; linked.spec.rows.len() * 3 * values.len()];
        self.parts
            .marker_constraint_gradient(linked.index, t, values, &mut gradient);
        gradient
    }

    /// dC/dz of one constraint at the loaded state: rows x 3 k.
    pub(super) fn gradient_of(&self, linked: &Linked, t: f64) -> Vec<f64> {
        let values = self.marker_values(linked);
        self.gradient(linked, t, &values)
    }

    /// `(dC/dz)^T lambda` of a constraint whose multipliers begin at `first`: 3 k numbers.
    fn pulls(&self, linked: &Linked, t: f64, z: &[Vector], lambda: &[f64]) -> Vec<f64> {
        let gradient = self.gradient(linked, t, z);
        let width = 3 * z.len();
        let mut pulls = vec![0.0; width];
        for (row, multiplier) in gradient.chunks_exact(width).zip(lambda) {
            for (sum, value) in pulls.iter_mut().zip(row) {
                *sum += multiplier * value;
            }
        }
        pulls
    }

    /// Adds `d(C_x^T lambda)/dx` of all constraints on markers.
    fn link_stiffness(&self, t: f64, lambda: &[f64], out: &mut impl Sums) {
        let mut first = self.first_linked();
        for linked in &self.links.constraints {
            let rows = linked.spec.rows.len();
            let lambda = &lambda[first..first + rows];
            first += rows;
            if lambda.iter().all(|&multiplier| multiplier == 0.0) {
                continue;
            }
            let z = self.marker_values(linked);
            let count = z.len();
            let mut hessian = vec![0.0; 9 * count * count];
            self.parts
                .marker_constraint_hessian(linked.index, t, &z, lambda, &mut hessian);
            let pulls = self.pulls(linked, t, &z, lambda);
            let columns = self.all_columns(linked);
            for m in 0..count {
                let frame = self.marker_frame(self.constraint_marker(linked, m));
                let pull = self.buffers.frames[frame].direction_to_frame(part(&pulls, m));
                let curvature = self.curvature(self.constraint_marker(linked, m), pull);
                for i in &columns[m] {
                    for (n, others) in columns.iter().enumerate() {
                        if m != n && is_zero_block(&hessian, count, m, n) {
                            continue;
                        }
                        for j in others {
                            let mut value = block_product(&hessian, count, m, n, i.value, j.value);
                            if m == n {
                                value += i.second(j, pull, curvature.as_ref());
                            }
                            for (entry, factor) in self.entries_of(i.component, j.component) {
                                out.stiffness(entry, factor * value);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Entries of two components on the pattern, each with the factor of what is added there.
    pub(crate) fn entries_of(&self, row: usize, column: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.layout.unknowns_at(row).flat_map(move |(i, a)| {
            let columns = self.layout.unknowns_at(column);
            columns.filter_map(move |(j, b)| Some((self.tabulated.pattern.find(i, j)?, a * b)))
        })
    }

    /// Adds `C_x^T lambda` of all constraints on markers to the forces of all components.
    pub(crate) fn add_marker_constraint_forces(&mut self, t: f64, lambda: &[f64]) {
        let mut first = self.first_linked();
        for index in 0..self.links.constraints.len() {
            let linked = &self.links.constraints[index];
            let rows = linked.spec.rows.len();
            let z = self.marker_values(linked);
            let pulls = self.pulls(linked, t, &z, &lambda[first..first + rows]);
            let columns = self.all_columns(linked);
            for (place, columns) in columns.iter().enumerate() {
                for column in columns {
                    self.buffers.force[column.component] += part(&pulls, place).dot(&column.value);
                }
            }
            first += rows;
        }
    }

    /// Calls with every marker of a constraint and what the constraint exerts on it, inertial axes.
    pub(super) fn each_constraint_force(&self, t: f64, lambda: &[f64], mut call: impl FnMut(&Marker, Vector)) {
        let mut first = self.first_linked();
        for linked in &self.links.constraints {
            let rows = linked.spec.rows.len();
            let z = self.marker_values(linked);
            let pulls = self.pulls(linked, t, &z, &lambda[first..first + rows]);
            for place in 0..z.len() {
                call(self.constraint_marker(linked, place), -part(&pulls, place));
            }
            first += rows;
        }
    }

    /// First row of a constraint on markers among all constraints.
    pub(crate) fn first_row(&self, position: usize) -> usize {
        let before = self.links.constraints[..position]
            .iter()
            .map(|linked| linked.spec.rows.len());
        self.first_linked() + before.sum::<usize>()
    }

    /// Force and moment (inertial axes) of a constraint on its first party at the loaded state; the
    /// moment is about the first point among its markers there.
    pub(crate) fn constraint_reaction(&self, position: usize, t: f64, lambda: &[f64]) -> [Vector; 2] {
        let linked = &self.links.constraints[position];
        let first = self.first_row(position);
        let z = self.marker_values(linked);
        let pulls = self.pulls(linked, t, &z, &lambda[first..first + linked.spec.rows.len()]);
        let markers = 0..linked.spec.first_party.min(z.len());
        let about = markers
            .clone()
            .find(|&place| self.constraint_marker(linked, place).is_point())
            .map_or(Vector::zeros(), |place| z[place]);
        let [mut force, mut moment] = [Vector::zeros(); 2];
        for place in markers {
            let pull = -part(&pulls, place);
            let marker = self.constraint_marker(linked, place);
            let turning = match marker {
                _ if marker.is_point() => {
                    force += pull;
                    (z[place] - about).cross(&pull)
                }
                Marker::Turn { .. } | Marker::SectionTurn { .. } => pull,
                Marker::Angle { free } => {
                    let frame = &self.frames.free[*free];
                    let turn = frame.directions[frame.angle().unwrap_or(0)].turn;
                    let motion = &self.buffers.frames[frame.spec.frame];
                    pull[0] * motion.direction_to_inertial(turn)
                }
                _ => z[place].cross(&pull),
            };
            moment += turning;
        }
        [force, moment]
    }
}
