//! The forces on the bodies of one frame that turns uniformly, on what joints leave free.

use crate::emitted::{MAX_SIZE, StartSpec};
use crate::error::ModelError;
use crate::linalg::Pattern;
use crate::scene::MeshScene;
use crate::scene::frames::ties::Tie;
use crate::scene::numbering::assembly::{Scatter, evaluate};
use crate::scene::numbering::layout::Layout;
use crate::space::{Matrix, Vector};

/// The mass matrix of some vectors: an element, or a fixture on one.
struct Inertia {
    body: usize,
    element: usize,
    mass: Vec<f64>,
}

/// The forces on the bodies of one frame.
pub(super) struct Balance<'a> {
    pub scene: &'a MeshScene,
    pub bodies: Vec<usize>,
    pub layout: Layout,
    /// Components of all vectors, those that are not unknown at their values.
    pub q: Vec<f64>,
    /// `[w]^2`, and w^2.
    turning: Matrix,
    pub square: f64,
    inertias: Vec<Inertia>,
    scatters: Vec<Scatter>,
    pub ties: Vec<Tie>,
    /// Of unknowns, then multipliers of ties.
    pub pattern: Pattern,
    /// On the pattern: mass, centrifugal forces' derivatives, and what else is constant.
    pub mass: Vec<f64>,
    constant: Vec<f64>,
    pub inverse_sizes: Vec<f64>,
    results: Vec<f64>,
}

impl<'a> Balance<'a> {
    pub(super) fn new(scene: &'a MeshScene, start: &StartSpec, spin: Vector) -> Result<Self, ModelError> {
        let (q, layout, ties) = scene.referenced(start)?;
        let bodies: Vec<usize> = (0..scene.bodies.len())
            .filter(|&body| scene.bodies[body].spec.frame == start.frame)
            .collect();
        let mut inertias = Vec::new();
        for &body in &bodies {
            let mass = |element| Inertia {
                body,
                element,
                mass: scene.bodies[body].mass_of(element).to_vec(),
            };
            inertias.extend((0..scene.bodies[body].spec.count).map(mass));
        }
        let fixtures = scene
            .fixtures
            .iter()
            .filter(|fixture| bodies.contains(&fixture.point.body));
        inertias.extend(fixtures.map(|fixture| Inertia {
            body: fixture.point.body,
            element: fixture.point.element,
            mass: fixture.mass().to_vec(),
        }));
        let mut balance = Self {
            ties,
            turning: spin.cross_matrix() * spin.cross_matrix(),
            square: spin.iter().map(|w| w * w).sum(),
            inverse_sizes: inverse_sizes(scene, &layout),
            pattern: Pattern::new(0, 0, []),
            scatters: Vec::new(),
            mass: Vec::new(),
            constant: Vec::new(),
            results: Vec::new(),
            scene,
            bodies,
            layout,
            q,
            inertias,
        };
        balance.tabulate();
        Ok(balance)
    }

    /// The pattern, and what is constant on it.
    fn tabulate(&mut self) {
        let (scene, layout) = (self.scene, &self.layout);
        let n = layout.unknowns();
        let rows = self
            .ties
            .iter()
            .flat_map(|tie| tie.rows.iter().map(move |row| (tie.first, row)));
        let mut borders = Vec::new();
        for (column, (first, row)) in rows.enumerate() {
            for (place, &value) in row.iter().enumerate() {
                for (unknown, factor) in layout.unknowns_at(first + place) {
                    borders.push((unknown, n + column, factor * value));
                }
            }
        }
        let size = n + self.ties.iter().map(|tie| tie.rows.len()).sum::<usize>();
        let mut entries: Vec<(usize, usize)> = (0..size).map(|i| (i, i)).collect();
        for &body in &self.bodies {
            scene.bodies[body].connectivity.add_entries(layout, &mut entries);
        }
        entries.extend(
            borders
                .iter()
                .flat_map(|&(row, column, _)| [(row, column), (column, row)]),
        );
        self.pattern = Pattern::new(size, size, entries);
        let scatters = self.bodies.iter();
        let scatters = scatters.map(|&body| Scatter::new(&scene.bodies[body].connectivity, layout, &self.pattern));
        self.scatters = scatters.collect();
        self.mass = vec![0.0; self.pattern.entries()];
        self.constant = vec![0.0; self.pattern.entries()];
        for inertia in &self.inertias {
            let place = self.place(inertia.body);
            let one = |r: usize, c: usize| if r == c { 1.0 } else { 0.0 };
            self.scatters[place].add(inertia.element, &self.spread(inertia, one), &mut self.mass);
            let turned = self.spread(inertia, |r, c| self.turning[(r, c)]);
            self.scatters[place].add(inertia.element, &turned, &mut self.constant);
        }
        for (row, column, value) in borders {
            for (i, j) in [(row, column), (column, row)] {
                if let Some(place) = self.pattern.find(i, j) {
                    self.constant[place] += value;
                }
            }
        }
        // Unknowns of other frames stay.
        let mut own = vec![false; n];
        for &body in &self.bodies {
            for &component in &scene.bodies[body].connectivity.components {
                for (unknown, _) in layout.unknowns_at(component) {
                    own[unknown] = true;
                }
            }
        }
        for unknown in (0..n).filter(|&unknown| !own[unknown]) {
            if let Some(place) = self.pattern.find(unknown, unknown) {
                self.constant[place] = 1.0;
            }
        }
    }

    /// Place of a body among those of the frame.
    fn place(&self, body: usize) -> usize {
        self.bodies.partition_point(|&other| other < body)
    }

    /// A mass matrix of vectors as one of components, `M_ab A` with a matrix of frame axes.
    fn spread(&self, inertia: &Inertia, matrix: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        let spec = &self.scene.bodies[inertia.body].spec;
        let (count, dimension, size) = (spec.nodal.len(), spec.dimension(), spec.element_size());
        let mut local = vec![0.0; size * size];
        for (place, entry) in local.iter_mut().enumerate() {
            let (row, column) = (place / size, place % size);
            let mass = inertia.mass[row / dimension * count + column / dimension];
            *entry = mass * matrix(spec.axes[row % dimension], spec.axes[column % dimension]);
        }
        local
    }

    /// Unknowns of the shapes.
    pub(super) fn unknowns(&self) -> Vec<f64> {
        let n = self.layout.unknowns();
        let (mut x, mut weight) = (vec![0.0; n], vec![0.0; n]);
        for (component, &value) in self.q.iter().enumerate() {
            for (unknown, factor) in self.layout.unknowns_at(component) {
                x[unknown] += factor * value;
                weight[unknown] += factor * factor;
            }
        }
        x.iter_mut().zip(weight).for_each(|(x, weight)| *x /= weight);
        x
    }

    pub(super) fn load(&mut self, x: &[f64]) {
        self.layout.expand(x, &mut self.q);
    }

    /// Components of an element of the frame.
    fn local(&self, body: usize, element: usize) -> [f64; MAX_SIZE] {
        let mut local = [0.0; MAX_SIZE];
        let body = &self.scene.bodies[body];
        body.connectivity
            .gather(element, &self.q, &mut local[..body.spec.element_size()]);
        local
    }

    /// Strain energy and kinetic energy of the rotation at the loaded state, J.
    pub(super) fn energies(&self) -> [f64; 2] {
        let (scene, mut energies) = (self.scene, [0.0; 2]);
        for &body in &self.bodies {
            let size = scene.bodies[body].spec.element_size();
            for element in 0..scene.bodies[body].spec.count {
                let q = self.local(body, element);
                energies[0] += scene.parts.energy(body, element, &q[..size]);
            }
        }
        for inertia in &self.inertias {
            let q = self.local(inertia.body, inertia.element);
            let force = self.centrifugal(inertia, &q);
            energies[1] += -0.5 * force.iter().zip(&q).map(|(force, q)| force * q).sum::<f64>();
        }
        energies
    }

    /// `M^ab w x (w x q_b)`.
    fn centrifugal(&self, inertia: &Inertia, q: &[f64; MAX_SIZE]) -> [f64; MAX_SIZE] {
        let spec = &self.scene.bodies[inertia.body].spec;
        let (count, dimension) = (spec.nodal.len(), spec.dimension());
        let mut accelerations = [0.0; MAX_SIZE];
        for (row, value) in accelerations[..spec.element_size()].iter_mut().enumerate() {
            let vector = &q[row / dimension * dimension..];
            let axis = spec.axes[row % dimension];
            *value = (0..dimension)
                .map(|c| self.turning[(axis, spec.axes[c])] * vector[c])
                .sum();
        }
        let mut force = [0.0; MAX_SIZE];
        for (row, value) in force[..spec.element_size()].iter_mut().enumerate() {
            let masses = &inertia.mass[row / dimension * count..];
            let sum = (0..count).map(|b| masses[b] * accelerations[b * dimension + row % dimension]);
            *value = sum.sum();
        }
        force
    }

    /// Residual at the loaded state: forces on unknowns, then mean axes; also the largest energy of the inertia
    /// over the size of an unknown.
    pub(super) fn residual(&mut self, out: &mut [f64]) -> f64 {
        let (scene, n) = (self.scene, self.layout.unknowns());
        let mut full = vec![0.0; self.q.len()];
        for inertia in &self.inertias {
            let q = self.local(inertia.body, inertia.element);
            let force = self.centrifugal(inertia, &q);
            let components = scene.bodies[inertia.body].connectivity.element(inertia.element);
            components
                .iter()
                .zip(force)
                .for_each(|(&component, force)| full[component] += force);
        }
        self.layout.project(&full, &mut out[..n]);
        let acting = self.largest(&out[..n]);
        let mut results = std::mem::take(&mut self.results);
        for &body in &self.bodies {
            let own = &scene.bodies[body];
            let size = own.spec.element_size();
            let rest = [0.0; MAX_SIZE];
            evaluate(own.spec.count, size, &mut results, |element, result| {
                let q = self.local(body, element);
                scene
                    .parts
                    .elastic_force(body, element, &q[..size], &rest[..size], result);
            });
            for (&component, value) in own.connectivity.components.iter().zip(&results) {
                full[component] += value;
            }
        }
        self.results = results;
        self.layout.project(&full, &mut out[..n]);
        let mut row = n;
        for tie in &self.ties {
            for (coefficients, wanted) in tie.rows.iter().zip(&tie.reference) {
                let values = coefficients.iter().zip(&self.q[tie.first..]);
                out[row] = values.map(|(a, q)| a * q).sum::<f64>() - wanted;
                row += 1;
            }
        }
        acting
    }

    /// Derivatives of the residual at the loaded state.
    pub(super) fn tangent(&mut self, values: &mut Vec<f64>) {
        values.clone_from(&self.constant);
        let scene = self.scene;
        let mut results = std::mem::take(&mut self.results);
        for (place, &body) in self.bodies.iter().enumerate() {
            let count = scene.bodies[body].spec.count;
            let size = scene.bodies[body].spec.element_size();
            let (square, rest) = (size * size, [0.0; MAX_SIZE]);
            evaluate(count, 2 * square, &mut results, |element, result| {
                let q = self.local(body, element);
                let (stiffness, damping) = result.split_at_mut(square);
                let parts = &scene.parts;
                parts.elastic_tangent(body, element, &q[..size], &rest[..size], stiffness, damping);
            });
            for element in 0..count {
                let from = element * 2 * square;
                self.scatters[place].add(element, &results[from..from + square], values);
            }
        }
        self.results = results;
    }

    /// Largest energy of forces over the sizes of their unknowns, J.
    pub(super) fn largest(&self, forces: &[f64]) -> f64 {
        let energies = forces.iter().zip(&self.inverse_sizes);
        energies.fold(0.0, |largest: f64, (force, inverse)| {
            largest.max((force / inverse).abs())
        })
    }
}

/// One over the sizes of the unknowns: lengths of bodies, and 1.
fn inverse_sizes(scene: &MeshScene, layout: &Layout) -> Vec<f64> {
    let size = |&(vector, _): &(usize, usize)| {
        let (body, _, local) = scene.locate(vector);
        if body.spec.nodal[local].is_position() {
            1.0 / body.spec.line.length()
        } else {
            1.0
        }
    };
    layout.origins().iter().map(size).collect()
}
