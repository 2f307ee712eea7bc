//! Sections that fixtures keep rigid (THEORY 5.4). Lengths of its axes and the angle between them stay what they start with,
//!
//! ```text
//! r_y . r_y / 2 = c,   r_z . r_z / 2 = c,   r_y . r_z = c
//! ```
//!
//! and where a fixture has moments along the normal n of the section, n is a nodal vector of its own with `n . n / 2 = c`,
//! `n . r_y = c`, `n . r_z = c`: the slope shears. So the inertia of the fixture is constant on r, n, r_y, r_z. In a plane there
//! is no r_z. The rows are inner products: they exert nothing on the frame, and no moment between two states.

use super::constraint::Constraint;
use crate::emitted::{JointKind, Line};
use crate::scene::bodies::place::{MeshPoint, PlaceVector, point_of};
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::combined::Combined;
use crate::scene::pieces::fixture::Fixture;
use crate::scene::pieces::marker::Marker;
use crate::scene::pieces::rigid_section::{Axes, Column, Kept, RigidSection, inner};
use crate::space::Vector;
use crate::system::{ConstraintLevel, Sums, Tangent};

/// What keeps sections below rigid fixtures rigid.
pub(crate) struct RigidSections;

impl Constraint for RigidSections {
    fn rows(&self, scene: &MeshScene) -> Vec<Vec<usize>> {
        let rows = |section: &RigidSection| {
            let rows = 0..section.rows();
            rows.map(|row| scene.unknowns_of(section.components(row)))
                .collect::<Vec<_>>()
        };
        scene.rigid_sections.iter().flat_map(rows).collect()
    }

    fn couple(&self, scene: &MeshScene, entries: &mut Vec<(usize, usize)>) {
        scene.couple_normals(entries);
    }

    fn describe(&self, scene: &MeshScene, row: usize) -> String {
        let sections = scene.rigid_sections.iter();
        let mut rows = sections.flat_map(|section| (0..section.rows()).map(move |row| (section, row)));
        rows.nth(row).map_or(String::new(), |(section, row)| {
            format!("fixture `{}`, {}", section.name, section.describe(row))
        })
    }

    fn is_curved(&self, scene: &MeshScene) -> bool {
        !scene.rigid_sections.is_empty()
    }

    fn values(&self, scene: &MeshScene, level: ConstraintLevel, _: f64, rows: &mut [f64]) {
        let mut out = rows.iter_mut();
        let buffers = &scene.buffers;
        for section in &scene.rigid_sections {
            let [at, v, a, jerks] = [&buffers.q, &buffers.v, &buffers.a, &buffers.jerks].map(|full| section.axes(full));
            for ((kept, reference), out) in section.rows.iter().zip(&section.references).zip(&mut out) {
                let gradient = kept.gradient(&at);
                let bent = kept.gradient(&v);
                *out = match level {
                    ConstraintLevel::Position => kept.value(&at) - reference,
                    ConstraintLevel::Velocity => inner(&gradient, &v),
                    ConstraintLevel::Acceleration => inner(&gradient, &a) + inner(&bent, &v),
                    ConstraintLevel::Jerk => inner(&gradient, &jerks) + 3.0 * inner(&bent, &a),
                };
            }
        }
    }

    fn add_jacobian(&self, scene: &MeshScene, _: f64, _: usize, values: &mut [f64]) {
        let q = &scene.buffers.q;
        scene.add_rows(values, |section, kept| kept.gradient(&section.axes(q)));
    }

    fn add_rate_tangent(&self, scene: &MeshScene, _: f64, _: usize, values: &mut [f64]) {
        let v = &scene.buffers.v;
        scene.add_rows(values, |section, kept| kept.gradient(&section.axes(v)));
    }

    fn add_stiffness(&self, scene: &MeshScene, _: f64, lambda: &[f64], out: &mut Tangent) {
        scene.add_rigid_section_curvature(lambda, |entry, value| out.stiffness(entry, value));
    }

    fn add_combined(&self, scene: &MeshScene, _: f64, lambda: &[f64], out: &mut Combined) {
        scene.add_rigid_section_curvature(lambda, |entry, value| out.stiffness(entry, value));
    }

    /// None: what they compare are the unknowns themselves.
    fn noise(&self, _: &MeshScene, _: f64, _: &mut [f64]) {}
}

impl MeshScene {
    /// Sets the normals of sections, and their rates, to those of the axes there.
    pub(crate) fn set_normals(&self, [q, v]: [&mut Vec<f64>; 2]) {
        for (index, body) in self.bodies.iter().enumerate() {
            for (place, &(element, xi)) in body.spec.normals.iter().enumerate() {
                let point = point_of(&*self.parts, &body.spec, index, element, xi);
                let plane = body.spec.plane_normal();
                let [y, z] = [PlaceVector::SectionY, PlaceVector::SectionZ].map(|of| self.at_point(&point, of, q));
                let z = plane.unwrap_or(z);
                let first = self
                    .layout
                    .offset(body.first_vector + body.spec.meshed_vectors() + place);
                let set = |full: &mut Vec<f64>, value: Vector| {
                    for (component, &axis) in body.spec.axes.iter().enumerate() {
                        full[first + component] = value[axis];
                    }
                };
                set(q, y.cross(&z));
                if !v.is_empty() {
                    let [dy, dz] =
                        [PlaceVector::SectionY, PlaceVector::SectionZ].map(|of| self.at_point(&point, of, v));
                    let [first, second] = [dy.cross(&z), y.cross(&dz)];
                    set(v, Vector::from_fn(|i, _| first[i] + second[i]));
                }
            }
        }
    }

    /// Finds the sections below rigid fixtures.
    pub(crate) fn find_rigid_sections(&mut self) {
        let mut found: Vec<RigidSection> = Vec::new();
        // Unknowns and factors of the axes that are kept already: bodies with a common end have one section there.
        let mut kept: Vec<Vec<(usize, usize, usize, f64)>> = Vec::new();
        // The axes of an interface of a body from elsewhere turn with it as one.
        let has_section = |fixture: &&Fixture| !matches!(self.bodies[fixture.point.body].spec.line, Line::Nodes(_));
        for fixture in self
            .fixtures
            .iter()
            .filter(|fixture| fixture.is_rigid)
            .filter(has_section)
        {
            let at = |point: &MeshPoint| (point.body, point.element, point.xi);
            let position = found
                .iter()
                .position(|section| at(&section.point) == at(&fixture.point));
            let place = position.unwrap_or_else(|| {
                let section = self.rigid_section(fixture);
                found.push(section);
                found.len() - 1
            });
            let section = &mut found[place];
            let has_normal = section.columns.iter().any(|column| column.vector == 2);
            if let Some(normal) = fixture.normal.filter(|_| !has_normal) {
                let body = &self.bodies[fixture.point.body];
                let first = self.layout.offset(body.first_vector + normal);
                for (component, &axis) in body.spec.axes.iter().enumerate() {
                    section.columns.push(Column {
                        component: first + component,
                        vector: 2,
                        axis,
                        weight: 1.0,
                    });
                }
                let axes = 0..body.spec.dimension() - 1;
                let normal = axes.chain([Kept::NORMAL]).map(|axis| Kept([axis, Kept::NORMAL]));
                section.rows.extend(normal);
            }
            if position.is_some() {
                continue;
            }
            let own = self.unknowns_of_axes(section);
            if kept.contains(&own) || self.is_held_whole(section) {
                section.rows.retain(|row| row.is_of_normal());
            }
            kept.push(own);
        }
        found.retain(|section| section.rows() > 0);
        self.rigid_sections = found;
    }

    /// The section below a fixture, without a normal.
    fn rigid_section(&self, fixture: &Fixture) -> RigidSection {
        let point = &fixture.point;
        let body = &self.bodies[point.body];
        let dimension = body.spec.dimension();
        let mut columns = Vec::new();
        for (vector, &of) in PlaceVector::section(dimension).iter().enumerate() {
            let components = body.connectivity.element(point.element).chunks_exact(dimension);
            for (components, &weight) in components.zip(point.weights(of)).filter(|(_, weight)| **weight != 0.0) {
                let own = components.iter().zip(body.spec.axes);
                columns.extend(own.map(|(&component, &axis)| Column {
                    component,
                    vector,
                    axis,
                    weight,
                }));
            }
        }
        let rows = match dimension {
            2 => vec![Kept([0, 0])],
            _ => vec![Kept([0, 0]), Kept([1, 1]), Kept([0, 1])],
        };
        RigidSection {
            name: fixture.spec.name,
            point: point.clone(),
            rows,
            references: Vec::new(),
            columns,
            stiffness: 0.0,
        }
    }

    /// Unknowns of the axes of a section, each with axis, frame axis and factor.
    fn unknowns_of_axes(&self, section: &RigidSection) -> Vec<(usize, usize, usize, f64)> {
        let mut own = Vec::new();
        for column in section.columns.iter().filter(|column| column.vector < 2) {
            for (unknown, factor) in self.layout.unknowns_at(column.component) {
                own.push((unknown, column.vector, column.axis, factor * column.weight));
            }
        }
        own.sort_by_key(|a| (a.0, a.1, a.2));
        own
    }

    /// Whether a joint holds all of the axes of a section, eliminated or by multipliers.
    fn is_held_whole(&self, section: &RigidSection) -> bool {
        let own = section.columns.iter().filter(|column| column.vector < 2);
        let mut own = own.map(|column| column.component).peekable();
        let body = &self.bodies[section.point.body];
        let dimension = body.spec.dimension();
        let held: Vec<usize> = self
            .conditions
            .iter()
            .filter(|condition| self.joints[condition.joint].kind == JointKind::ClampFull && !condition.rows.is_empty())
            .flat_map(|condition| &condition.vectors)
            .flat_map(|&vector| self.layout.offset(vector)..self.layout.offset(vector) + dimension)
            .collect();
        let is_given = |component: usize| self.layout.unknowns_at(component).next().is_none();
        let by_joint = own.peek().is_some() && own.all(|component| is_given(component) || held.contains(&component));
        let is_here = |marker: &usize| match &self.links.markers[*marker] {
            Marker::Body { point, of } => {
                *of == PlaceVector::SectionY
                    && (point.body, point.element, point.xi)
                        == (section.point.body, section.point.element, section.point.xi)
            }
            _ => false,
        };
        // Beside the position the rotation alone, or both axes.
        let rotation = if dimension == 2 { 1 } else { 3 };
        let by_constraint = self.links.constraints.iter().any(|linked| {
            matches!(linked.spec.kind, "clamp" | "clamp_full")
                && linked.spec.rows.len() > dimension + rotation
                && linked.spec.markers.iter().any(is_here)
        });
        by_joint || by_constraint
    }

    /// What rigid sections keep is what they start with; at the loaded start.
    pub(crate) fn refer_rigid_sections(&mut self) {
        if self.rigid_sections.is_empty() {
            return;
        }
        let stiffnesses = self.stiffnesses_of_axes();
        let q = &self.buffers.q;
        for (section, stiffness) in self.rigid_sections.iter_mut().zip(stiffnesses) {
            let axes = section.axes(q);
            section.references = section.rows.iter().map(|kept| kept.value(&axes)).collect();
            section.stiffness = stiffness;
        }
    }

    /// Largest stiffness against a change of an axis, for every section, N m.
    fn stiffnesses_of_axes(&mut self) -> Vec<f64> {
        let is_needed = |section: &RigidSection| section.columns.iter().any(|column| column.vector == 2);
        if !self.rigid_sections.iter().any(is_needed) {
            return vec![0.0; self.rigid_sections.len()];
        }
        let mut tangent = Tangent::default();
        self.full_tangent(0.0, 0.0, &mut tangent);
        let of = |section: &RigidSection| {
            let own = section.columns.iter().filter(|column| column.vector < 2);
            let own = own.flat_map(|column| self.entries_of(column.component, column.component));
            let largest = own.map(|(entry, _)| tangent.stiffness[entry]).fold(0.0, f64::max);
            if largest > 0.0 { largest } else { 1.0 }
        };
        self.rigid_sections.iter().map(of).collect()
    }

    /// Couples the normals with themselves and with the vectors of their elements.
    fn couple_normals(&self, entries: &mut Vec<(usize, usize)>) {
        for body in &self.bodies {
            for (place, &(element, _)) in body.spec.normals.iter().enumerate() {
                let first = self
                    .layout
                    .offset(body.first_vector + body.spec.meshed_vectors() + place);
                let own = first..first + body.spec.dimension();
                let all = own.clone().chain(body.connectivity.element(element).iter().copied());
                for component in all {
                    for normal in own.clone() {
                        for (i, _) in self.layout.unknowns_at(component) {
                            for (j, _) in self.layout.unknowns_at(normal) {
                                entries.extend([(i, j), (j, i)]);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Every row with its number among all constraints.
    fn rigid_rows(&self) -> impl Iterator<Item = (usize, &RigidSection, Kept)> {
        let rows = self
            .rigid_sections
            .iter()
            .flat_map(|section| section.rows.iter().map(move |&kept| (section, kept)));
        let first = self.first_rigid();
        rows.enumerate()
            .map(move |(row, (section, kept))| (first + row, section, kept))
    }

    /// Adds derivatives of rows by all components.
    fn add_rows(&self, values: &mut [f64], gradient: impl Fn(&RigidSection, Kept) -> Axes) {
        for (row, section, kept) in self.rigid_rows() {
            section.each(&gradient(section, kept), |component, value| {
                self.add_to_row(component, row, value, values);
            });
        }
    }

    /// Makes Jacobians at the loaded state those in the middle between it and the start of the step.
    pub(crate) fn rigid_section_jacobian_halfway(&self, values: &mut [f64]) {
        let change = |full: &[f64]| -> Vec<f64> {
            let begun = self.buffers.begun.iter().zip(full);
            begun.map(|(begun, now)| 0.5 * (begun - now)).collect()
        };
        let way = change(&self.buffers.q);
        self.add_rows(values, |section, kept| kept.gradient(&section.axes(&way)));
    }

    /// Calls with the entries of `d(C_x^T lambda)/dx` on the pattern.
    pub(crate) fn add_rigid_section_curvature(&self, lambda: &[f64], mut add: impl FnMut(usize, f64)) {
        let mut first = self.first_rigid();
        for section in &self.rigid_sections {
            let lambda = &lambda[first..first + section.rows()];
            first += section.rows();
            for by in &section.columns {
                let mut change = [Vector::zeros(); 3];
                change[by.vector][by.axis] = by.weight;
                section.each(&section.pull(&change, lambda), |component, value| {
                    if value != 0.0 {
                        for (entry, factor) in self.entries_of(component, by.component) {
                            add(entry, factor * value);
                        }
                    }
                });
            }
        }
    }

    /// Makes the block of the normals regular, which have no stiffness, for where inertia has no part in the leading block:
    /// adds squares of gradients, see [`RigidSection::stiffness`].
    pub(crate) fn hold_normals(&self, out: &mut impl Sums) {
        for (_, section, kept) in self.rigid_rows().filter(|(.., kept)| kept.is_of_normal()) {
            let gradient = kept.gradient(&section.axes(&self.buffers.q));
            section.each(&gradient, |row, first| {
                section.each(&gradient, |column, second| {
                    let value = section.stiffness * first * second;
                    if value != 0.0 {
                        for (entry, factor) in self.entries_of(row, column) {
                            out.stiffness(entry, factor * value);
                        }
                    }
                });
            });
        }
    }

    /// Adds `C_x^T lambda` of all rigid sections to the forces of all components.
    pub(crate) fn add_rigid_section_forces(&mut self, lambda: &[f64]) {
        let mut first = self.first_rigid();
        for section in &self.rigid_sections {
            let pull = section.pull(&section.axes(&self.buffers.q), &lambda[first..]);
            first += section.rows();
            section.each(&pull, |component, value| self.buffers.force[component] += value);
        }
    }

    /// Calls with what keeps rigid sections rigid exerts on their axes, axes of the body's frame.
    pub(crate) fn each_rigid_section_force(
        &self,
        lambda: &[f64],
        mut act: impl FnMut(&MeshPoint, PlaceVector, Vector),
    ) {
        let mut first = self.first_rigid();
        for section in &self.rigid_sections {
            let pull = section.pull(&section.axes(&self.buffers.q), &lambda[first..]);
            first += section.rows();
            let dimension = self.bodies[section.point.body].spec.dimension();
            for (&of, force) in PlaceVector::section(dimension).iter().zip(pull) {
                act(&section.point, of, force.map(|component| -component));
            }
        }
    }
}
