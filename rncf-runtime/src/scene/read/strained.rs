//! Strains of the elements of a body, read as forces and moments of its sections, and how flexible these are.

use super::section::{section_axes, unit};
use crate::emitted::Interpolant;
use crate::linalg::Cholesky;
use crate::scene::MeshScene;
use crate::space::{Matrix, Vector};

/// A centre line has slope and curvature; a section its own axes and their derivatives as well.
const LINE: [(Interpolant, usize); 2] = [(Interpolant::Position, 1), (Interpolant::Position, 2)];
/// Most fields of an energy: position, r_y and r_z, with two derivatives each.
const MOST_FIELDS: usize = 9;
/// Strain by which a section is disturbed to find its stiffness.
const DISTURBED: f64 = 1e-6;
/// `l^2 int w''^2 / int w'^2` of `w = x^2 (l - x)^2`.
const BUBBLE: f64 = 42.0;
/// Part of what strain and curvature have on their own from which on they couple: above the noise of differences.
const COUPLED: f64 = 1e-4;
/// A stiffness below this part of what the same strain on a circle of the body's length would meet is none.
const NONE: f64 = 1e-12;

/// The fields of a body that its energy depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Line,
    PlanarSection,
    Section,
}

/// Forces and moments of a section in its own axes: axial, shear y, shear z, torque, moments about y and z; then what its own
/// strains meet, along y, along z and their shear. Of a line and in a plane those that are there.
pub(super) type Components = [f64; 9];

/// A vector of every field of a body; zero beyond these.
pub(super) type Fields = [Vector; MOST_FIELDS];

/// Flexibility of a section, rows first.
pub(super) struct Flexibility {
    pub values: [Components; 9],
}

impl Flexibility {
    /// `c . F c`, twice the energy per length, J/m; bending about y and z is made less by a factor.
    pub fn energy(&self, components: &Components, less: [f64; 2]) -> f64 {
        let mut scaled = *components;
        scaled[4] *= less[0].sqrt();
        scaled[5] *= less[1].sqrt();
        let row = |row: &Components| -> f64 { row.iter().zip(&scaled).map(|(f, c)| f * c).sum() };
        self.values.iter().zip(&scaled).map(|(values, c)| c * row(values)).sum()
    }

    /// Forces that a unit moment brings along at strains of the axis that are held, 1/m, rows first; `None` where strains and
    /// curvatures do not couple.
    pub fn coupling(&self) -> Option<Matrix> {
        let block = |column: usize| Matrix::from_fn(|i, j| self.values[i][column + j]);
        let (axis, both) = (block(0), block(3));
        let coupling = -(axis.try_inverse()? * both);
        let part = |i: usize, j: usize| coupling[(i, j)] * (self.values[i][i] / self.values[3 + j][3 + j]).sqrt();
        let is_there = (0..9).any(|at| part(at / 3, at % 3).abs() > COUPLED);
        is_there.then_some(coupling)
    }

    /// By what the energy of a moment between the nodes of an element is less where an axial force (N) holds it: an element
    /// of some length (m) that bends between its nodes alone, as the difference of moments does it, takes up `N l^2 / 42`
    /// beside its own stiffness. Compression takes at most half of that away.
    pub fn held(&self, axial: f64, length: f64) -> [f64; 2] {
        [4, 5].map(|moment| 1.0 / (1.0 + (axial * length * length / BUBBLE * self.values[moment][moment]).max(-0.5)))
    }
}

/// What reads one body.
pub(super) struct Strained<'a> {
    pub scene: &'a MeshScene,
    pub body: usize,
    pub kind: Kind,
    fields: &'static [(Interpolant, usize)],
}

impl<'a> Strained<'a> {
    /// `None` where its elements have other fields than lines and sections.
    pub fn new(scene: &'a MeshScene, body: usize) -> Option<Self> {
        let fields = scene.parts.fields(body);
        if fields.len() > MOST_FIELDS {
            return None;
        }
        let has = |field: (Interpolant, usize)| fields.contains(&field);
        let is_section = |of: Interpolant| has((of, 0)) && has((of, 1));
        let kind = if fields.iter().all(|field| LINE.contains(field)) {
            Kind::Line
        } else if !has((Interpolant::Position, 2))
            && fields
                .iter()
                .all(|&(of, order)| order <= 1 || of != Interpolant::Position)
        {
            match (is_section(Interpolant::SectionY), is_section(Interpolant::SectionZ)) {
                (true, true) => Kind::Section,
                (true, false) => Kind::PlanarSection,
                _ => return None,
            }
        } else {
            return None;
        };
        Some(Self {
            scene,
            body,
            kind,
            fields,
        })
    }

    /// Every field of an element at a place, from its components; frame axes.
    pub fn fields_at(&self, weights: &[f64], local: &[f64]) -> Fields {
        let spec = &self.scene.bodies[self.body].spec;
        let (dimension, count) = (spec.dimension(), spec.nodal.len());
        let mut fields = [Vector::zeros(); MOST_FIELDS];
        for (value, weights) in fields.iter_mut().zip(weights.chunks_exact(count)) {
            for (weight, components) in weights.iter().zip(local.chunks_exact(dimension)) {
                for (&axis, component) in spec.axes.iter().zip(components) {
                    value[axis] += weight * component;
                }
            }
        }
        fields
    }

    /// Weights of an element's nodal vectors in every field at a place.
    pub fn weights(&self, element: usize, xi: f64) -> Vec<f64> {
        let count = self.scene.bodies[self.body].spec.nodal.len();
        let mut weights = vec![0.0; self.fields.len() * count];
        for (&(of, order), weights) in self.fields.iter().zip(weights.chunks_exact_mut(count)) {
            self.scene.parts.shapes(self.body, element, of, order, xi, weights);
        }
        weights
    }

    /// Forces on the fields at an arclength (m), frame axes.
    pub fn forces(&self, x: f64, fields: [&[Vector]; 3]) -> Fields {
        let spec = &self.scene.bodies[self.body].spec;
        let (dimension, size) = (spec.dimension(), self.fields.len() * spec.dimension());
        let mut flat = [[0.0; 3 * MOST_FIELDS]; 3];
        for (flat, fields) in flat.iter_mut().zip(fields) {
            for (components, field) in flat[..size].chunks_exact_mut(dimension).zip(fields) {
                for (component, &axis) in components.iter_mut().zip(spec.axes) {
                    *component = field[axis];
                }
            }
        }
        let [free, present, rates] = flat.each_ref().map(|flat| &flat[..size]);
        let mut on = [0.0; 3 * MOST_FIELDS];
        let at = [x, spec.line.length()];
        self.scene
            .parts
            .field_forces(self.body, at, free, present, rates, &mut on[..size]);
        let mut forces = [Vector::zeros(); MOST_FIELDS];
        for (force, components) in forces.iter_mut().zip(on[..size].chunks_exact(dimension)) {
            for (&axis, component) in spec.axes.iter().zip(components) {
                force[axis] = *component;
            }
        }
        forces
    }

    /// One of some vectors of all fields; nothing where there is no such field.
    fn of(&self, vectors: &[Vector], field: (Interpolant, usize)) -> Vector {
        let place = self.fields.iter().position(|&own| own == field);
        place.map_or(Vector::zeros(), |place| vectors[place])
    }

    /// Axes of the section: along, r_y and across; of a line the first is along its slope and the second towards its curvature, or
    /// normal to a plane's normal.
    pub fn triad(&self, fields: &[Vector]) -> [Vector; 3] {
        let normal = self.scene.bodies[self.body].spec.plane_normal();
        match self.kind {
            Kind::Line => {
                let along = unit(self.of(fields, LINE[0]));
                let across = normal.unwrap_or_else(|| crate::space::perpendicular(along));
                [along, across.cross(&along), across]
            }
            Kind::PlanarSection | Kind::Section => {
                let y = self.of(fields, (Interpolant::SectionY, 0));
                let z = normal.unwrap_or_else(|| self.of(fields, (Interpolant::SectionZ, 0)));
                section_axes(y, z)
            }
        }
    }

    /// Force and moment of the strains, by virtual work: on `r_x` at a fixed section, and on a section that turns along the axis.
    pub fn carried(&self, fields: &[Vector], forces: &[Vector]) -> [Vector; 2] {
        let [slope, pull] = [fields, forces].map(|all| self.of(all, LINE[0]));
        match self.kind {
            Kind::Line => {
                let [bent, couple] = [fields, forces].map(|all| self.of(all, LINE[1]));
                let stretch = slope.norm().max(f64::MIN_POSITIVE);
                let along = 1.0 / stretch * slope;
                // A stretch leaves the curvature per length as it is: r_xx grows with it.
                let across = bent - bent.dot(&along) * along;
                let axial = along.dot(&pull) + across.dot(&couple) / stretch;
                [axial * along, slope.cross(&couple)]
            }
            Kind::PlanarSection | Kind::Section => {
                let of = [Interpolant::SectionY, Interpolant::SectionZ];
                let moments = of.map(|of| self.of(fields, (of, 0)).cross(&self.of(forces, (of, 1))));
                [pull, moments[0] + moments[1]]
            }
        }
    }

    /// What the inertia (N m/m) of a section's vectors does to it in its own plane, where nothing acts on its sides.
    pub fn swelling(&self, fields: &[Vector], inertia: [Vector; 2]) -> [f64; 3] {
        let [y, z] = [Interpolant::SectionY, Interpolant::SectionZ].map(|of| self.of(fields, (of, 0)));
        [
            -inertia[0].dot(&y),
            -inertia[1].dot(&z),
            -inertia[0].dot(&z) - inertia[1].dot(&y),
        ]
    }

    /// Couples of what a section does in its own plane: their slopes along the axis balance it beside its inertia.
    pub fn couples(&self, fields: &[Vector], forces: &[Vector]) -> [f64; 3] {
        let (y, z) = (Interpolant::SectionY, Interpolant::SectionZ);
        let work = |on: Interpolant, by: Interpolant| self.of(forces, (on, 1)).dot(&self.of(fields, (by, 0)));
        [work(y, y), work(z, z), work(y, z) + work(z, y)]
    }

    /// Components of a force and moment that its strains tell.
    pub fn components(&self, triad: &[Vector; 3], [force, moment]: [Vector; 2]) -> Components {
        let f = triad.map(|axis| axis.dot(&force));
        let m = triad.map(|axis| axis.dot(&moment));
        let [mut f, mut m] = [f, m];
        match self.kind {
            Kind::Line => (f[1], f[2], m[0]) = (0.0, 0.0, 0.0),
            Kind::PlanarSection => (f[2], m[0], m[1]) = (0.0, 0.0, 0.0),
            Kind::Section => {}
        }
        [f[0], f[1], f[2], m[0], m[1], m[2], 0.0, 0.0, 0.0]
    }

    /// Components of what the strains of the element give.
    pub fn strained(&self, triad: &[Vector; 3], fields: &[Vector], forces: &[Vector]) -> Components {
        let mut all = self.components(triad, self.carried(fields, forces));
        // Of a section that widens alike along the axis, so that its derivatives grow as it does.
        let (y, z) = (Interpolant::SectionY, Interpolant::SectionZ);
        let work = |on: Interpolant, by: Interpolant| -> f64 {
            let part = |order| self.of(forces, (on, order)).dot(&self.of(fields, (by, order)));
            part(0) + part(1)
        };
        all[6..].copy_from_slice(&[work(y, y), work(z, z), work(y, z) + work(z, y)]);
        all
    }

    /// Flexibility at a place of the stress-free shape: its stiffness by small strains of the section as a whole, with the
    /// section's own strains relaxed.
    pub fn flexibility(&self, x: f64, free: &[Vector]) -> Flexibility {
        let triad = self.triad(free);
        let length = self.scene.bodies[self.body].spec.line.length();
        let still = vec![Vector::zeros(); free.len()];
        let of = |name: (Interpolant, usize)| self.fields.iter().position(|&own| own == name);
        let (y, z) = (Interpolant::SectionY, Interpolant::SectionZ);
        // What each strain moves.
        let moved = |strain: usize, by: f64| -> Vec<Vector> {
            let mut fields = free.to_vec();
            let mut shift = |name: (Interpolant, usize), vector: Vector| {
                if let Some(place) = of(name) {
                    fields[place] += by * vector;
                }
            };
            match strain {
                0..=2 => shift(LINE[0], triad[strain]),
                3..=5 if self.kind == Kind::Line => {
                    shift(LINE[1], triad[strain - 3].cross(&self.of(free, LINE[0])));
                }
                3..=5 => {
                    for of in [y, z] {
                        shift((of, 1), triad[strain - 3].cross(&self.of(free, (of, 0))));
                    }
                }
                6 => shift((y, 0), triad[1]),
                7 => shift((z, 0), triad[2]),
                _ => {
                    shift((y, 0), triad[2]);
                    shift((z, 0), triad[1]);
                }
            }
            fields
        };
        let response = |fields: &[Vector]| -> Components {
            self.strained(&triad, fields, &self.forces(x, [free, fields, &still]))
        };
        let strains: &[usize] = match self.kind {
            Kind::Line if self.scene.bodies[self.body].spec.dimension() == 2 => &[0, 5],
            Kind::Line => &[0, 4, 5],
            Kind::PlanarSection => &[0, 1, 5, 6],
            Kind::Section => &[0, 1, 2, 3, 4, 5, 6, 7, 8],
        };
        let sizes = |strain: usize| if (3..6).contains(&strain) { 1.0 / length } else { 1.0 };
        let columns: Vec<Components> = strains
            .iter()
            .map(|&strain| {
                let [up, down] = [DISTURBED, -DISTURBED].map(|by| response(&moved(strain, by * sizes(strain))));
                std::array::from_fn(|row| (up[row] - down[row]) / (2.0 * DISTURBED) * sizes(row))
            })
            .collect();
        // What has no stiffness carries nothing: a string does not bend.
        let largest = strains
            .iter()
            .zip(&columns)
            .map(|(&strain, column)| column[strain])
            .fold(0.0, f64::max);
        let kept: Vec<usize> = (0..strains.len())
            .filter(|&place| columns[place][strains[place]] > NONE * largest)
            .collect();
        let size = kept.len();
        let mut matrix = vec![0.0; size * size];
        for (i, &row) in kept.iter().enumerate() {
            for (j, &column) in kept.iter().enumerate() {
                let both = columns[column][strains[row]] + columns[row][strains[column]];
                matrix[i * size + j] = 0.5 * both;
            }
        }
        let mut values = [[0.0; 9]; 9];
        let Ok(factor) = Cholesky::new(size, &matrix) else {
            return Flexibility { values };
        };
        for (j, &column) in kept.iter().enumerate() {
            let mut solved = vec![0.0; size];
            solved[j] = 1.0;
            factor.solve(&mut solved);
            for (i, &row) in kept.iter().enumerate() {
                let (row, column) = (strains[row], strains[column]);
                values[row][column] = solved[i] * sizes(row) * sizes(column);
            }
        }
        Flexibility { values }
    }
}
