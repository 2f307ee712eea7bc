//! What sections carry: forces and moments that the part of a body beyond a place exerts on the part before it, from
//! the balance of the element with the forces on its nodes, and of its part up to the place with inertia and loads.

use super::stress::largest_stress;
use crate::emitted::{Fidelity, Interpolant, MAX_SIZE, SectionQuantity, SectionSpec};
use crate::error::ModelError;
use crate::model::SectionState;
use crate::scene::bodies::described::Kernels;
use crate::scene::bodies::nodal_mass::{Total, Transport, padded, vector as vector_of};
use crate::scene::bodies::place::MeshPoint;
use crate::scene::bodies::section::Section;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::point_force::PointForce;
use crate::scene::pieces::reach::{Body, Reach, Reaches};
use crate::space::Vector;

/// A unit vector; zero where there is no direction.
pub(super) fn unit(vector: Vector) -> Vector {
    1.0 / (vector.dot(&vector) + f64::MIN_POSITIVE).sqrt() * vector
}

/// Right-handed triad of a section: `r_y x r_z`, r_y, and what is normal to both.
pub(super) fn section_axes(y: Vector, z: Vector) -> [Vector; 3] {
    let (along, y) = (unit(y.cross(&z)), unit(y));
    [along, y, along.cross(&y)]
}

/// What the section at the start of an element carries, and what acts between there and its end.
#[derive(Default)]
struct Element {
    /// Nodal vectors at the places that forces act at, frame axes.
    levers: Vec<Vector>,
    /// Force and moment at its start, frame axes.
    start: [Vector; 2],
    /// Inertia less loads on the nodal vectors, N on positions.
    acting: Vec<Vector>,
    /// Accelerations in space, m/s^2 of positions.
    accelerations: Vec<Vector>,
}

/// `sum_a weight_a u_a`
fn sum(weights: &[f64], vectors: &[Vector]) -> Vector {
    let parts = weights.iter().zip(vectors);
    parts.fold(Vector::zeros(), |sum, (&weight, &vector)| sum + weight * vector)
}

/// Reads off what the sections of one body carry at the loaded state: [`MeshScene::set_sections`] comes first.
pub(crate) struct Reader<'a> {
    pub(super) scene: &'a MeshScene,
    pub(super) body: usize,
    /// Accelerations in the body's frame.
    pub(super) total: Total,
    /// What stresses follow from, where that is the same along the body.
    section: Option<&'a Section>,
    pub(super) is_line: bool,
    pub(super) normal: Option<Vector>,
    /// Of the axis, m.
    length: f64,
    /// The local vector that is the position of the first node.
    pub(super) first: usize,
    pub(super) reaches: &'a mut Reaches,
    /// The element that is read, and its number.
    found: Element,
    at: usize,
}

impl<'a> Reader<'a> {
    pub fn new(scene: &'a MeshScene, body: usize, reaches: &'a mut Reaches) -> Self {
        let (spec, frame) = (&scene.bodies[body].spec, scene.bodies[body].frame);
        let transport = Transport::new(&scene.buffers.frames[frame], spec.axes, scene.buffers.gravity);
        Self {
            scene,
            body,
            total: Total::new(&transport),
            section: (!scene.parts.varies(body)).then(|| scene.section_of(body)),
            is_line: !spec.has_section(),
            normal: spec.plane_normal(),
            length: spec.line.length(),
            first: spec
                .nodal
                .iter()
                .position(|vector| vector.is_position() && vector.xi == 0.0)
                .unwrap_or(0),
            reaches,
            found: Element::default(),
            at: 0,
        }
    }

    /// Force and moment on the section at a place in [0, 1] of the element begun last, frame axes.
    pub fn carried(&mut self, xi: f64) -> [Vector; 2] {
        let reach = self.reaches.to(described(self.scene, self.body), xi);
        carried(self.scene, (self.body, self.at), self.first, reach, &self.found)
    }

    /// Inertia of a section's vectors r_y and r_z per length at a place in [0, 1] of the element begun last, N m/m, frame axes.
    pub fn inertia_of_section(&mut self, xi: f64) -> [Vector; 2] {
        let reach = self.reaches.to(described(self.scene, self.body), xi);
        let body = &self.scene.bodies[self.body];
        let (nodal, length) = (body.spec.nodal, body.spec.element_length(self.at));
        let of = [Interpolant::Position, Interpolant::SectionY, Interpolant::SectionZ];
        let weights = [&reach.position, &reach.axes[0], &reach.axes[1]];
        let accelerations = weights.map(|weights| sum(weights, &self.found.accelerations));
        // Shape functions add up to one: those of positions by themselves, with slopes beside them.
        let counts = |place: usize, which: Interpolant| nodal[place].of == which && nodal[place].order == 0;
        let masses = body.mass_of(self.at);
        let density = |row: Interpolant, column: Interpolant| -> f64 {
            let entries = masses.iter().enumerate();
            let own =
                entries.filter(|&(entry, _)| counts(entry / nodal.len(), row) && counts(entry % nodal.len(), column));
            own.map(|(_, mass)| mass / length).sum()
        };
        [1, 2].map(|row| {
            let parts = (0..3).map(|column| density(of[row], of[column]) * accelerations[column]);
            parts.fold(Vector::zeros(), |sum, part| sum + part)
        })
    }

    /// What the sections at places in [0, 1] of an element carry, which are equally far from each other. Instead of one inside it may be the nearest
    /// place at which something acts, where more is carried.
    pub fn element(&mut self, element: usize, places: &[f64], out: &mut Vec<SectionState>) {
        self.begin(element);
        let pieces = places.len().saturating_sub(1);
        for (index, &xi) in places.iter().enumerate() {
            let mut most = self.state(element, xi);
            if 0 < index && index < pieces {
                let nearest = |place: f64| ((place * pieces as f64).round() as usize).clamp(1, pieces - 1);
                let points = acting_inside(self.scene, self.body, element).map(|point| point.xi);
                for place in points.filter(|&place| nearest(place) == index) {
                    // What is carried jumps there.
                    for xi in [place * (1.0 - f64::EPSILON), place] {
                        let beside = self.state_once(element, xi);
                        let weight = |state: &SectionState| state.stress.unwrap_or_else(|| state.bending_moment());
                        if weight(&beside) > weight(&most) {
                            most = beside;
                        }
                    }
                }
            }
            out.push(most);
        }
    }

    fn state(&mut self, element: usize, xi: f64) -> SectionState {
        let reach = self.reaches.to(described(self.scene, self.body), xi);
        let [force, moment] = carried(self.scene, (self.body, element), self.first, reach, &self.found);
        let axes = axis_weights(self.is_line, reach).map(|weights| sum(weights, &self.found.levers));
        self.stressed(element, xi, self.in_own_axes(force, moment, axes))
    }

    /// The same at a place that may be another one each time.
    fn state_once(&self, element: usize, xi: f64) -> SectionState {
        let reach = self.reaches.once(described(self.scene, self.body), xi);
        let [force, moment] = carried(self.scene, (self.body, element), self.first, &reach, &self.found);
        let axes = axis_weights(self.is_line, &reach).map(|weights| sum(weights, &self.found.levers));
        self.stressed(element, xi, self.in_own_axes(force, moment, axes))
    }

    /// Forces and moments on a section in its own axes, which follow from its slope, or r_y and r_z; frame axes.
    fn in_own_axes(&self, force: Vector, moment: Vector, axes: [Vector; 2]) -> [[f64; 3]; 2] {
        if self.is_line {
            // Across the slope: a centre line has no torsion.
            let along = unit(axes[0]);
            let size = match self.normal {
                Some(normal) => moment.dot(&normal),
                None => (moment - along.dot(&moment) * along).norm(),
            };
            return [[along.dot(&force), 0.0, 0.0], [0.0, 0.0, size]];
        }
        let triad = section_axes(axes[0], self.normal.unwrap_or(axes[1]));
        [force, moment].map(|carried| triad.map(|axis| axis.dot(&carried)))
    }

    /// What a section carries, with its stress.
    #[inline]
    pub(super) fn stressed(&self, element: usize, xi: f64, [forces, moments]: [[f64; 3]; 2]) -> SectionState {
        let is_planar = self.normal.is_some();
        let spec = &self.scene.bodies[self.body].spec;
        let x = spec.arclength_of(self.length, element, xi);
        let varied;
        let section = match self.section {
            Some(section) => section,
            None => {
                let inside = spec.arclength_inside(self.length, element, xi);
                varied = Section::new(self.scene.section_spec(self.body, inside));
                &varied
            }
        };
        let mut stress = largest_stress(section, is_planar, forces, moments);
        if self.is_line && !is_planar {
            // Which way a centre line in space bends relative to its section is not known.
            let other = largest_stress(section, is_planar, forces, [0.0, moments[2], 0.0]);
            stress = stress.zip(other).map(|(a, b)| a.max(b));
        }
        let (area, [about_y, about_z]) = (section.spec.area, section.spec.second_moments);
        SectionState {
            x,
            forces: forces.into(),
            moments: moments.into(),
            stress,
            axial_stress: (stress.is_none() && area > 0.0).then(|| forces[0].abs() / area),
            least_bending: (stress.is_none() && area > 0.0 && section.spec.yield_stress.is_some()).then(|| {
                let by = |moment: f64, about: f64| {
                    if about > 0.0 {
                        moment.abs() / (area * about).sqrt()
                    } else {
                        0.0
                    }
                };
                by(moments[1], about_y).max(by(moments[2], about_z))
            }),
            yield_stress: section.spec.yield_stress,
            is_planar,
        }
    }

    /// What the section at the start of an element carries. The element is in equilibrium with what its nodes exert on
    /// it: its generalised forces (elastic ones and inertia less loads) on the vectors of its first node are what the
    /// part before exerts there. So sections, joints and loads balance as the discrete equations do, whatever the mesh.
    pub fn begin(&mut self, element: usize) {
        self.at = element;
        self.reaches.begin(described(self.scene, self.body), element);
        let body = &self.scene.bodies[self.body];
        let (spec, buffers) = (&body.spec, &self.scene.buffers);
        let size = spec.element_size();
        let mut at = [[0.0; MAX_SIZE]; 3];
        for (local, full) in at.iter_mut().zip([&buffers.q, &buffers.v, &buffers.a]) {
            body.connectivity.gather(element, full, &mut local[..size]);
        }
        let [q, v, a] = at.each_ref().map(|local| &local[..size]);
        let (mut levers, mut elastic) = ([0.0; MAX_SIZE], [0.0; MAX_SIZE]);
        self.elastic(element, [q, v], [&mut levers[..size], &mut elastic[..size]]);
        let count = spec.nodal.len();
        let vector = |local: &[f64], vector: usize| -> Vector {
            let mut value = Vector::zeros();
            for (&axis, &component) in spec.axes.iter().zip(&local[vector * spec.axes.len()..]) {
                value[axis] = component;
            }
            value
        };
        let found = &mut self.found;
        found.levers.clear();
        found.levers.extend((0..count).map(|place| vector(&levers, place)));
        // Inertia less loads.
        let total = &self.total;
        found.accelerations.clear();
        found.accelerations.extend((0..count).map(|place| {
            let at = [found.levers[place], vector(v, place), vector(a, place)].map(padded);
            vector_of(total.acceleration(spec.nodal[place].is_position(), at.each_ref()))
        }));
        let loads = self.scene.densities_on(self.body, element);
        let inertia = body.mass_of(element).chunks_exact(count).enumerate();
        found.acting.clear();
        found
            .acting
            .extend(inertia.map(|(place, masses)| sum(masses, &found.accelerations) - vector(&loads, place)));
        found.start = [Vector::zeros(); 2];
        for place in (0..count).filter(|&place| spec.nodal[place].xi == 0.0) {
            let points = acting_inside(self.scene, self.body, element);
            let points = points.fold(Vector::zeros(), |sum, point| sum + point.weights[place] * point.force);
            let force = points - (vector(&elastic, place) + found.acting[place]);
            if spec.nodal[place].is_position() {
                found.start[0] += force;
            } else {
                found.start[1] += found.levers[place].cross(&force);
            }
        }
    }

    /// Where the nodal vectors of an element are as the description of the body has them, and its elastic forces on them,
    /// what bodies in modes carry to their joints included; forces are zero before.
    fn elastic(&self, element: usize, [q, v]: [&[f64]; 2], [levers, force]: [&mut [f64]; 2]) {
        let body = &self.scene.bodies[self.body];
        match &body.modes {
            Some(modes) if modes.is_linear() => {
                let first = self.scene.layout.offset(body.first_vector);
                let own = first..first + modes.shape().len();
                let elements = Kernels {
                    parts: &*self.scene.parts,
                    body: self.body,
                };
                let buffers = &self.scene.buffers;
                let at = [&buffers.q[own.clone()], &buffers.v[own]];
                force.copy_from_slice(&modes.linear_force(&elements, element, at));
                let undeformed = (0..body.spec.nodal.len()).flat_map(|local| body.spec.undeformed(element, local));
                levers
                    .iter_mut()
                    .zip(undeformed)
                    .for_each(|(lever, value)| *lever = value);
            }
            _ => {
                self.scene.parts.elastic_force(self.body, element, q, v, force);
                levers.copy_from_slice(q);
            }
        }
        let held = self.scene.buffers.held.get(self.body).filter(|_| body.modes.is_some());
        let held = held.and_then(|held| held.chunks_exact(q.len()).nth(element));
        for (force, held) in force.iter_mut().zip(held.unwrap_or(&[])) {
            *force += held;
        }
    }
}

/// A body as reaches see it.
pub(super) fn described(scene: &MeshScene, index: usize) -> Body<'_> {
    Body {
        parts: &*scene.parts,
        index,
        spec: &scene.bodies[index].spec,
    }
}

/// What acts inside an element of a body.
pub(super) fn acting_inside(scene: &MeshScene, body: usize, element: usize) -> impl Iterator<Item = &PointForce> {
    let all = scene.buffers.point_forces.get(body);
    all.into_iter().flatten().filter(move |point| point.element == element)
}

/// Force and moment on the section at the end of a reach, frame axes: those at the start of the element, and what
/// between there and here is not balanced by the section. Of what acts at single places that up to here counts.
fn carried(
    scene: &MeshScene,
    (body, element): (usize, usize),
    first: usize,
    reach: &Reach,
    found: &Element,
) -> [Vector; 2] {
    let here = sum(&reach.position, &found.levers);
    let [mut force, mut moment] = found.start;
    moment += (found.levers[first] - here).cross(&force);
    let between = sum(&reach.forces, &found.acting);
    force += between;
    moment -= here.cross(&between);
    for (row, &lever) in reach.levers.chunks_exact(reach.position.len()).zip(&found.levers) {
        moment += lever.cross(&sum(row, &found.acting));
    }
    for point in acting_inside(scene, body, element).filter(|point| point.xi <= reach.xi) {
        let lever = sum(&point.weights, &found.levers);
        if point.on_position {
            force -= point.force;
            moment -= (lever - here).cross(&point.force);
        } else {
            moment -= lever.cross(&point.force);
        }
    }
    [force, moment]
}

/// Weights of the nodal vectors in what tells how the section at the end of a reach stands.
pub(super) fn axis_weights(is_line: bool, reach: &Reach) -> [&[f64]; 2] {
    let [y, z] = &reach.axes;
    if is_line { [&reach.slope, &[]] } else { [y, z] }
}

impl MeshScene {
    /// The reaches on the elements of all bodies, to be given back.
    pub(crate) fn taken_reaches(&mut self) -> Vec<Reaches> {
        let mut reaches = std::mem::take(&mut self.buffers.reaches);
        reaches.resize(self.bodies.len(), Reaches::default());
        reaches
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

    /// The same at the start of a body, kept.
    pub(crate) fn section_of(&self, body: usize) -> &Section {
        self.bodies[body]
            .section
            .get_or_init(|| Section::new(self.section_spec(body, 0.0)))
    }

    /// Whether the largest stress of a body's sections is known.
    pub(crate) fn knows_stress(&self, body: usize) -> bool {
        let (spec, section) = (&self.bodies[body].spec, self.section_of(body));
        largest_stress(section, spec.dimension() == 2, [0.0; 3], [0.0; 3]).is_some()
    }

    /// Refuses the stress of a section that does not know its extents.
    pub(crate) fn check_stress(&self, body: usize, what: SectionQuantity) -> Result<(), ModelError> {
        if what != SectionQuantity::Stress || self.knows_stress(body) {
            return Ok(());
        }
        let why = if self.section_spec(body, 0.0).area > 0.0 {
            "whose section does not say where its outermost fibres are: give `extent_y` and in space `extent_z`"
        } else {
            "whose section is given in numbers, from which no stress follows: read what it carries (`axial_force`, `moment`, ..), or give it a shape, or an `area` and a material"
        };
        Err(ModelError::new(format!(
            "an output reads the stress of body `{}`, {why}",
            self.bodies[body].spec.label()
        )))
    }

    /// What the section at a place carries at the loaded state.
    pub(crate) fn section_at(&self, point: &MeshPoint, reaches: &mut Reaches) -> SectionState {
        let mut reader = Reader::new(self, point.body, reaches);
        reader.begin(point.element);
        reader.state(point.element, point.xi)
    }
    /// The same of the sections at both ends of a body.
    pub(crate) fn sections_at_ends(&self, body: usize, reaches: &mut Reaches) -> [SectionState; 2] {
        let last = self.bodies[body].spec.count - 1;
        let mut reader = Reader::new(self, body, reaches);
        [(0, 0.0), (last, 1.0)].map(|(element, xi)| {
            reader.begin(element);
            reader.state(element, xi)
        })
    }
}
