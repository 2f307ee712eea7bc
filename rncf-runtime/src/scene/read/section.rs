//! What sections carry: forces and moments that the part of a body beyond a place exerts on the part before it, from
//! the balance of the element with the forces on its nodes, and of its part up to the place with inertia and loads.

use super::stress::largest_stress;
use crate::emitted::{FIVE, Fidelity, Interpolant, MAX_SIZE, SectionQuantity, SectionSpec};
use crate::error::ModelError;
use crate::linalg::Cholesky;
use crate::model::SectionState;
use crate::scene::bodies::described::Kernels;
use crate::scene::bodies::nodal_mass::{Total, Transport, padded, vector as vector_of};
use crate::scene::bodies::place::MeshPoint;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::point_force::PointForce;
use crate::vector::{Vector, add, cross, dot, norm, scale, subtract};

/// A unit vector; zero where there is no direction.
fn unit(vector: Vector) -> Vector {
    let size = norm(vector);
    if size > 0.0 { scale(1.0 / size, vector) } else { vector }
}

/// Right-handed triad of a section: `r_y x r_z`, r_y, and what is normal to both.
fn section_axes(y: Vector, z: Vector) -> [Vector; 3] {
    let (along, y) = (unit(cross(y, z)), unit(y));
    [along, y, cross(along, y)]
}

/// What the section at the start of an element carries, and what acts between there and its end.
struct Element {
    /// Nodal vectors at the places that forces act at, frame axes.
    levers: Vec<Vector>,
    /// Force and moment at its start, frame axes.
    start: [Vector; 2],
    /// Inertia less loads per length: nodal values of what is interpolated as the vectors are.
    distributed: Vec<Vector>,
}

/// Weights of an element's nodal vectors at a place in what it interpolates, zeros where it does not.
struct Weights {
    position: Vec<f64>,
    slope: Vec<f64>,
    /// Of r_y and r_z.
    axes: [Vec<f64>; 2],
}

/// A place on an element, and the points between its start and the place with their parts of the element's length.
struct Reach {
    xi: f64,
    at: Weights,
    before: [(f64, Weights); 5],
}

/// `sum_a weight_a u_a`
fn sum(weights: &[f64], vectors: &[Vector]) -> Vector {
    let parts = weights.iter().zip(vectors);
    parts.fold([0.0; 3], |sum, (&weight, &vector)| add(sum, scale(weight, vector)))
}

/// Reads off what the sections of one body carry at the loaded state: [`MeshScene::set_sections`] comes first.
pub(crate) struct Reader<'a> {
    scene: &'a MeshScene,
    body: usize,
    /// What stresses follow from, where that is the same along the body.
    section: Option<SectionSpec>,
    is_line: bool,
    normal: Option<Vector>,
    /// The element that is read, and its length, m.
    element: usize,
    length: f64,
    /// The local vector that is the position of the first node.
    first: usize,
    /// For every interpolant the local vectors that it interpolates, with the factors of `int s_a s_b dx`.
    grams: Vec<(Vec<usize>, Cholesky)>,
    reaches: Vec<Reach>,
}

impl<'a> Reader<'a> {
    pub fn new(scene: &'a MeshScene, body: usize) -> Self {
        let spec = &scene.bodies[body].spec;
        let mut reader = Self {
            scene,
            body,
            section: (!scene.parts.varies(body)).then(|| scene.section_spec(body, 0.0)),
            is_line: !spec.has_section(),
            normal: spec.plane_normal(),
            element: 0,
            length: 0.0,
            first: spec
                .nodal
                .iter()
                .position(|vector| vector.is_position() && vector.xi == 0.0)
                .unwrap_or(0),
            grams: Vec::new(),
            reaches: Vec::new(),
        };
        reader.begin_length(0);
        reader
    }

    /// What depends on the length of an element.
    fn begin_length(&mut self, element: usize) {
        self.element = element;
        let length = self.scene.bodies[self.body].spec.element_length(element);
        if length != self.length {
            self.length = length;
            self.reaches.clear();
            let all = [Interpolant::Position, Interpolant::SectionY, Interpolant::SectionZ];
            self.grams = all.into_iter().filter_map(|of| self.gram(of)).collect();
        }
    }

    fn gram(&self, of: Interpolant) -> Option<(Vec<usize>, Cholesky)> {
        let nodal = self.scene.bodies[self.body].spec.nodal;
        let own: Vec<usize> = (0..nodal.len()).filter(|&vector| nodal[vector].of == of).collect();
        let mut matrix = vec![0.0; own.len() * own.len()];
        for (xi, weight) in FIVE {
            let shapes = self.shapes(of, 0, xi);
            for (place, entry) in matrix.iter_mut().enumerate() {
                let (row, column) = (own[place / own.len()], own[place % own.len()]);
                *entry += self.length * weight * shapes[row] * shapes[column];
            }
        }
        // Shape functions are independent.
        let factor = Cholesky::new(own.len(), &matrix).ok()?;
        (!own.is_empty()).then_some((own, factor))
    }

    fn shapes(&self, of: Interpolant, order: usize, xi: f64) -> Vec<f64> {
        let spec = &self.scene.bodies[self.body].spec;
        let mut weights = vec![0.0; spec.nodal.len()];
        if spec.interpolates(of) {
            self.scene
                .parts
                .shapes(self.body, self.element, of, order, xi, &mut weights);
        }
        weights
    }

    fn weights(&self, xi: f64) -> Weights {
        Weights {
            position: self.shapes(Interpolant::Position, 0, xi),
            slope: self.shapes(Interpolant::Position, 1, xi),
            axes: [Interpolant::SectionY, Interpolant::SectionZ].map(|of| self.shapes(of, 0, xi)),
        }
    }

    /// Place among the reaches of one up to `xi`.
    fn reach(&mut self, xi: f64) -> usize {
        if let Some(place) = self.reaches.iter().position(|reach| reach.xi == xi) {
            return place;
        }
        let reach = Reach {
            xi,
            at: self.weights(xi),
            before: FIVE.map(|(point, weight)| (xi * weight, self.weights(xi * point))),
        };
        self.reaches.push(reach);
        self.reaches.len() - 1
    }

    /// What the sections at places in [0, 1] of an element carry.
    pub fn element(&mut self, element: usize, places: &[f64], out: &mut Vec<SectionState>) {
        let found = self.begin(element);
        for &xi in places {
            out.push(self.state(element, xi, &found));
        }
    }

    fn state(&mut self, element: usize, xi: f64, found: &Element) -> SectionState {
        let place = self.reach(xi);
        let triad = self.triad(&self.reaches[place].at, &found.levers);
        let [force, moment] = self.carried(element, &self.reaches[place], found);
        let mut forces = triad.map(|axis| dot(axis, force));
        let mut moments = triad.map(|axis| dot(axis, moment));
        let spec = &self.scene.bodies[self.body].spec;
        if self.is_line {
            // Across the slope: a centre line has no torsion.
            let across = subtract(moment, scale(moments[0], triad[0]));
            let size = self.normal.map_or_else(|| norm(across), |normal| dot(moment, normal));
            moments = [0.0, 0.0, size];
            forces = [forces[0], 0.0, 0.0];
        }
        let is_planar = self.normal.is_some();
        let x = spec.arclength(element, xi);
        let section = self.section.unwrap_or_else(|| self.scene.section_spec(self.body, x));
        let stress = |moments| largest_stress(&section, is_planar, forces, moments);
        // Which way a centre line in space bends relative to its section is not known.
        let other = if self.is_line && !is_planar {
            [0.0, moments[2], 0.0]
        } else {
            moments
        };
        SectionState {
            x,
            forces,
            moments,
            stress: stress(moments).zip(stress(other)).map(|(a, b)| a.max(b)),
            is_planar,
        }
    }

    /// Force and moment on the section at the end of a reach, frame axes: those at the start of the element, and what
    /// between there and here is not balanced by the section. Of what acts at single places that up to here counts.
    fn carried(&self, element: usize, reach: &Reach, found: &Element) -> [Vector; 2] {
        let here = sum(&reach.at.position, &found.levers);
        let lever = |weights: &[f64]| subtract(sum(weights, &found.levers), here);
        let [mut force, mut moment] = found.start;
        moment = add(moment, cross(subtract(found.levers[self.first], here), force));
        for (part, weights) in &reach.before {
            let part = part * self.length;
            let density = scale(part, sum(&weights.position, &found.distributed));
            force = add(force, density);
            moment = add(moment, cross(lever(&weights.position), density));
            for axes in &weights.axes {
                let couple = scale(part, sum(axes, &found.distributed));
                moment = add(moment, cross(sum(axes, &found.levers), couple));
            }
        }
        for point in self.acting(element).filter(|point| point.xi <= reach.xi) {
            if point.on_position {
                force = subtract(force, point.force);
                moment = subtract(moment, cross(lever(&point.weights), point.force));
            } else {
                moment = subtract(moment, cross(sum(&point.weights, &found.levers), point.force));
            }
        }
        [force, moment]
    }

    /// What acts inside an element.
    fn acting(&self, element: usize) -> impl Iterator<Item = &PointForce> {
        let all = self.scene.buffers.point_forces.get(self.body);
        all.into_iter().flatten().filter(move |point| point.element == element)
    }

    /// What the section at the start of an element carries. The element is in equilibrium with what its nodes exert on
    /// it: its generalised forces (elastic ones and inertia less loads) on the vectors of its first node are what the
    /// part before exerts there. So sections, joints and loads balance as the discrete equations do, whatever the mesh.
    fn begin(&mut self, element: usize) -> Element {
        self.begin_length(element);
        let body = &self.scene.bodies[self.body];
        let (spec, buffers) = (&body.spec, &self.scene.buffers);
        let (d, size) = (spec.dimension(), spec.element_size());
        let vectors = |local: &[f64]| -> Vec<Vector> {
            let parts = local.chunks_exact(d);
            let components = |part: &[f64]| std::array::from_fn(|i| part.get(i).copied().unwrap_or(0.0));
            parts.map(|part| body.spread(components(part))).collect()
        };
        let gather = |full: &[f64]| {
            let mut local = [0.0; MAX_SIZE];
            body.connectivity.gather(element, full, &mut local[..size]);
            local
        };
        let undeformed = || -> Vec<f64> {
            let all = (0..spec.nodal.len()).flat_map(|local| spec.undeformed(element, local));
            all.collect()
        };
        let [q, v, a] = [&buffers.q, &buffers.v, &buffers.a].map(|full| gather(full));
        let (levers, elastic) = self.elastic(element, [&q[..size], &v[..size]]);
        let levers = vectors(&levers.unwrap_or_else(undeformed));
        // Inertia less loads.
        let transport = Transport::new(&buffers.frames[body.frame], spec.axes, buffers.gravity);
        let total = Total::new(&transport);
        let rates = [&v[..size], &a[..size]].map(vectors);
        let acceleration = |vector: usize| {
            let at = [levers[vector], rates[0][vector], rates[1][vector]].map(padded);
            vector_of(total.acceleration(spec.nodal[vector].is_position(), at.each_ref()))
        };
        let accelerations: Vec<Vector> = (0..spec.nodal.len()).map(acceleration).collect();
        let loads = vectors(&self.scene.densities_on(self.body, element)[..size]);
        let inertia = body.mass_of(element).chunks_exact(spec.nodal.len());
        let acting: Vec<Vector> = inertia
            .zip(&loads)
            .map(|(masses, &load)| subtract(sum(masses, &accelerations), load))
            .collect();
        let mut start = [[0.0; 3]; 2];
        for (vector, elastic) in vectors(&elastic).into_iter().enumerate() {
            if spec.nodal[vector].xi != 0.0 {
                continue;
            }
            let points = self.acting(element);
            let points = points.fold([0.0; 3], |sum, point| {
                add(sum, scale(point.weights[vector], point.force))
            });
            let force = subtract(points, add(elastic, acting[vector]));
            if spec.nodal[vector].is_position() {
                start[0] = add(start[0], force);
            } else {
                start[1] = add(start[1], cross(levers[vector], force));
            }
        }
        Element {
            start,
            distributed: self.distribution(&acting),
            levers,
        }
    }

    /// Elastic forces of an element on its nodal vectors as the description of the body has them, what bodies in modes
    /// carry to their joints included, and its nodal vectors where they act; none: the undeformed ones.
    fn elastic(&self, element: usize, [q, v]: [&[f64]; 2]) -> (Option<Vec<f64>>, Vec<f64>) {
        let body = &self.scene.bodies[self.body];
        let mut force = vec![0.0; q.len()];
        let Some(modes) = &body.modes else {
            self.scene.parts.elastic_force(self.body, element, q, v, &mut force);
            return (Some(q.to_vec()), force);
        };
        let levers = if modes.is_linear() {
            let first = self.scene.layout.offset(body.first_vector);
            let own = first..first + modes.shape().len();
            let elements = Kernels {
                parts: &*self.scene.parts,
                body: self.body,
            };
            let buffers = &self.scene.buffers;
            force = modes.linear_force(&elements, element, [&buffers.q[own.clone()], &buffers.v[own]]);
            None
        } else {
            self.scene.parts.elastic_force(self.body, element, q, v, &mut force);
            Some(q.to_vec())
        };
        let held = self.scene.buffers.held.get(self.body);
        let held = held.and_then(|held| held.chunks_exact(q.len()).nth(element));
        for (force, held) in force.iter_mut().zip(held.unwrap_or(&[])) {
            *force += held;
        }
        (levers, force)
    }

    /// Nodal values of the force per length, interpolated as the vectors are, that makes these generalised forces:
    /// that itself where it is at most cubic, as inertia is; else the nearest to it, with the same force and moment.
    fn distribution(&self, forces: &[Vector]) -> Vec<Vector> {
        let mut values = vec![[0.0; 3]; forces.len()];
        for (own, factor) in &self.grams {
            for axis in 0..3 {
                let mut part: Vec<f64> = own.iter().map(|&vector| forces[vector][axis]).collect();
                factor.solve(&mut part);
                for (&vector, value) in own.iter().zip(part) {
                    values[vector][axis] = value;
                }
            }
        }
        values
    }

    /// Axes of the section at a place of an element; of a centre line the first is along its slope.
    fn triad(&self, at: &Weights, levers: &[Vector]) -> [Vector; 3] {
        if self.is_line {
            return [unit(sum(&at.slope, levers)), [0.0; 3], [0.0; 3]];
        }
        let [y, z] = at.axes.each_ref().map(|weights| sum(weights, levers));
        section_axes(y, self.normal.unwrap_or(z))
    }
}

impl MeshScene {
    /// What the section of a body carries at `xi` in [0, 1] of an element, at the loaded state.
    fn section_state(&self, body: usize, element: usize, xi: f64) -> SectionState {
        let mut reader = Reader::new(self, body);
        let found = reader.begin(element);
        reader.state(element, xi, &found)
    }

    /// Remembers what section forces need at the loaded state; of bodies in modes the forces are evaluated before.
    pub(crate) fn set_sections(&mut self, t: f64, load_scale: f64, lambda: &[f64]) {
        self.buffers.gravity = self.gravity(t).map(|g| load_scale * g);
        self.set_fields(t, load_scale);
        self.set_densities(t, load_scale);
        self.set_point_forces(t, load_scale, lambda);
    }

    /// Whether it is known what the sections of a body carry: not where its mass is at one place, or where its joints
    /// let it move and its description alone holds it.
    pub(crate) fn knows_sections(&self, body: usize) -> bool {
        let body = &self.bodies[body];
        body.spec.fidelity != Fidelity::Point && !body.modes.as_ref().is_some_and(|modes| modes.is_loose())
    }

    /// Refuses to read sections of a body without any extent.
    pub(crate) fn check_sections(&self, body: usize) -> Result<(), ModelError> {
        if self.bodies[body].spec.fidelity != Fidelity::Point {
            return Ok(());
        }
        Err(ModelError::new(format!(
            "an output reads what a section of body `{}` carries, which is described as a point: its mass is at one place and nothing is spread along it; describe it as `rigid`",
            self.bodies[body].spec.label()
        )))
    }

    /// What stresses of a body follow from at an arclength, m.
    pub(crate) fn section_spec(&self, body: usize, x: f64) -> SectionSpec {
        self.parts.section(body, x, self.bodies[body].spec.line.length())
    }

    /// Whether the largest stress of a body's sections is known.
    pub(crate) fn knows_stress(&self, body: usize) -> bool {
        let (spec, section) = (&self.bodies[body].spec, self.section_spec(body, 0.0));
        largest_stress(&section, spec.dimension() == 2, [0.0; 3], [0.0; 3]).is_some()
    }

    /// Refuses the stress of a section that does not know its extents.
    pub(crate) fn check_stress(&self, body: usize, what: SectionQuantity) -> Result<(), ModelError> {
        if what != SectionQuantity::Stress || self.knows_stress(body) {
            return Ok(());
        }
        Err(ModelError::new(format!(
            "an output reads the stress of body `{}`, whose section does not say where its outermost fibres are: give `extent_y` and in space `extent_z`",
            self.bodies[body].spec.label()
        )))
    }

    /// The same at a place.
    pub(crate) fn section_at(&self, point: &MeshPoint) -> SectionState {
        self.section_state(point.body, point.element, point.xi)
    }
}
