//! What sections carry: forces and moments that the part of a body beyond a place exerts on the part
//! before it, from the strain energy and damping at points of an element (THEORY 5.1, 5.2).

use super::evaluate::{MAX_SIZE, weighted};
use super::parts::Interpolant;
use super::scene::{MeshPoint, MeshScene};
use super::section_spec::{SectionQuantity, SectionSpec};
use super::stress::largest_stress;
use crate::error::ModelError;
use crate::vector::{Vector, add, cross, dot, norm, scale, subtract};

/// What a section carries at the loaded state, in its own axes x (along `r_y x r_z`, of a centre line its
/// slope), y (along r_y) and z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionState {
    /// Arclength of the stress-free axis, m.
    pub x: f64,
    /// Axial force and shear forces along y and z, N.
    pub forces: [f64; 3],
    /// Torque and moments about y and z, N m. A centre line has the last alone: about the plane's normal,
    /// in space its magnitude.
    pub moments: [f64; 3],
    /// Largest von Mises stress over the section, Pa; `None` where the section's extents are not known.
    pub stress: Option<f64>,
    /// Whether the body stays in a plane: its moment keeps its sign.
    is_planar: bool,
}

impl SectionState {
    /// One of its numbers; `None` for a stress that is not known.
    pub fn value(&self, of: SectionQuantity) -> Option<f64> {
        let [axial, shear_y, shear_z] = self.forces;
        let [torque, moment_y, moment_z] = self.moments;
        Some(match of {
            SectionQuantity::AxialForce => axial,
            SectionQuantity::ShearY => shear_y,
            SectionQuantity::ShearZ => shear_z,
            SectionQuantity::Torque => torque,
            SectionQuantity::MomentY => moment_y,
            SectionQuantity::MomentZ => moment_z,
            SectionQuantity::Moment if self.is_planar => moment_z,
            SectionQuantity::Moment => self.bending_moment(),
            SectionQuantity::Stress => return self.stress,
        })
    }

    /// Magnitude of the shear force, N.
    pub fn shear_force(&self) -> f64 {
        self.forces[1].hypot(self.forces[2])
    }

    /// Magnitude of the bending moment, N m.
    pub fn bending_moment(&self) -> f64 {
        self.moments[1].hypot(self.moments[2])
    }
}

/// Points in [0, 1] where strains are most accurate: those at which elements are integrated. Moments are
/// interpolated between them, since strains in between contain what the shape functions cannot do in a bent
/// element.
const TWO: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];
pub(super) const THREE: [f64; 3] = [0.112_701_665_379_258_31, 0.5, 0.887_298_334_620_741_7];

/// Polynomial through values at the points.
fn interpolated(points: &[f64], values: &[Vector], xi: f64) -> Vector {
    let mut sum = [0.0; 3];
    for (i, &value) in values.iter().enumerate() {
        let others = points.iter().enumerate().filter(|&(j, _)| j != i);
        let weight: f64 = others.map(|(_, &point)| (xi - point) / (points[i] - point)).product();
        sum = add(sum, scale(weight, value));
    }
    sum
}

/// A unit vector; zero where there is no direction.
fn unit(vector: Vector) -> Vector {
    let size = norm(vector);
    if size > 0.0 { scale(1.0 / size, vector) } else { vector }
}

/// Fields of a body at a point of an element, with the forces on them.
struct Fields<'a> {
    of: &'a [(Interpolant, usize)],
    axes: &'a [usize],
    values: &'a [f64],
    forces: &'a [f64],
}

impl Fields<'_> {
    /// A field among numbers of all fields, frame axes; zero where the body does not have it.
    fn pick(&self, numbers: &[f64], of: Interpolant, order: usize) -> Vector {
        let mut vector = [0.0; 3];
        if let Some(place) = self.of.iter().position(|&field| field == (of, order)) {
            let part = numbers.chunks_exact(self.axes.len()).nth(place).unwrap_or(&[]);
            for (value, &axis) in part.iter().zip(self.axes) {
                vector[axis] = *value;
            }
        }
        vector
    }

    fn value(&self, of: Interpolant, order: usize) -> Vector {
        self.pick(self.values, of, order)
    }

    fn force(&self, of: Interpolant, order: usize) -> Vector {
        self.pick(self.forces, of, order)
    }

    /// Moment on a section with axes, `M = r_y x dU/dr_y' + r_z x dU/dr_z'`, in its triad; `normal` is that of
    /// a planar body.
    fn of_section(&self, normal: Option<Vector>) -> Vector {
        let y = self.value(Interpolant::SectionY, 0);
        let z = normal.unwrap_or_else(|| self.value(Interpolant::SectionZ, 0));
        let mut moment = cross(y, self.force(Interpolant::SectionY, 1));
        if normal.is_none() {
            moment = add(moment, cross(z, self.force(Interpolant::SectionZ, 1)));
        }
        section_axes(y, z).map(|axis| dot(moment, axis))
    }

    /// Moment on a centre line, `r_x x dU/dr_xx`, frame axes.
    fn of_line(&self) -> Vector {
        let couple = self.force(Interpolant::Position, 2);
        cross(self.value(Interpolant::Position, 1), couple)
    }
}

/// Right-handed triad of a section: `r_y x r_z`, r_y, and what is normal to both.
fn section_axes(y: Vector, z: Vector) -> [Vector; 3] {
    let (along, y) = (unit(cross(y, z)), unit(y));
    [along, y, cross(along, y)]
}

/// What one element carries: forces in frame axes, moments in those of the sections.
struct Element {
    /// Mean of the force R on a section with the weight xi (1 - xi), N. With it a virtual displacement does work
    /// that stretches this element alone and moves what is beyond: the discrete equations themselves say that it
    /// is in equilibrium with the loads beyond, while R at single points contains what a cubic cannot do in a bent
    /// element.
    mean: Vector,
    /// How R changes, `dR/dxi = l rho A (r'' - g)`: coefficients of 1, s, s^2 with s = xi - 1/2.
    change: [Vector; 3],
    moments: Moments,
    /// Nodal vectors at present.
    local: [f64; MAX_SIZE],
}

/// Moments at those points where they are most accurate.
enum Moments {
    Two([Vector; 2]),
    Three([Vector; 3]),
}

impl Element {
    /// Force in frame axes: [`Element::mean`] and what the change adds to it; its mean with the same weight is 0,
    /// `6 int (1/4 - s^2) s^2/2 ds = 1/40`.
    fn force(&self, xi: f64) -> Vector {
        let s = xi - 0.5;
        let weights = [s, 0.5 * s * s - 0.025, s * s * s / 3.0];
        let terms = weights.into_iter().zip(self.change);
        terms.fold(self.mean, |sum, (weight, change)| add(sum, scale(weight, change)))
    }

    fn moment(&self, xi: f64) -> Vector {
        match &self.moments {
            Moments::Two(values) => interpolated(&TWO, values, xi),
            Moments::Three(values) => interpolated(&THREE, values, xi),
        }
    }
}

/// Weights of Gauss's rule at [`THREE`].
const THREE_WEIGHTS: [f64; 3] = [5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0];
/// Gauss's rule with five points, by which centre lines are integrated: place and weight.
const FIVE: [(f64, f64); 5] = [
    (0.046_910_077_030_668_02, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_24),
    (0.5, 0.284_444_444_444_444_45),
    (0.769_234_655_052_841_6, 0.239_314_335_249_683_24),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Reads off what the sections of one body carry at the loaded state.
pub(super) struct Reader<'a> {
    scene: &'a MeshScene,
    body: usize,
    of: &'static [(Interpolant, usize)],
    section: SectionSpec,
    is_line: bool,
    normal: Option<Vector>,
    /// Weights of the nodal vectors in every field, one field after the other, at the points.
    three: [Vec<f64>; 3],
    two: [Vec<f64>; 2],
    five: [Vec<f64>; 5],
    /// Weights of the nodal vectors in the position at [`THREE`].
    positions: [Vec<f64>; 3],
    /// Mass per length, kg/m.
    density: f64,
    /// Fields at a point: stress-free, at present, their rates, and the forces on them.
    fields: [Vec<f64>; 4],
}

impl<'a> Reader<'a> {
    pub fn new(scene: &'a MeshScene, body: usize) -> Self {
        let spec = &scene.bodies[body].spec;
        let of = scene.parts.fields(body);
        let count = spec.nodal.len();
        let weights = |xi: f64| weights(scene, body, of, xi);
        let positions = |xi: f64| {
            let mut weights = vec![0.0; count];
            scene.parts.shapes(body, Interpolant::Position, 0, xi, &mut weights);
            weights
        };
        let size = of.len() * spec.dimension();
        Self {
            scene,
            body,
            of,
            section: scene.parts.section(body),
            is_line: !spec.has_section(),
            normal: spec.plane_normal(),
            three: THREE.map(weights),
            two: TWO.map(weights),
            five: FIVE.map(|(xi, _)| weights(xi)),
            positions: THREE.map(positions),
            density: scene.mass_per_length(body),
            fields: std::array::from_fn(|_| vec![0.0; size]),
        }
    }

    /// What the sections at places in [0, 1] of an element carry.
    pub fn element(&mut self, element: usize, places: &[f64], out: &mut Vec<SectionState>) {
        let found = self.points(element);
        for &xi in places {
            out.push(self.state(element, xi, &found));
        }
    }

    fn state(&mut self, element: usize, xi: f64, found: &Element) -> SectionState {
        let triad = self.triad(&found.local, xi);
        let force = found.force(xi);
        let mut forces = triad.map(|axis| dot(axis, force));
        let mut moments = found.moment(xi);
        let spec = &self.scene.bodies[self.body].spec;
        if self.is_line {
            let size = self.normal.map_or_else(|| norm(moments), |normal| dot(moments, normal));
            moments = [0.0, 0.0, size];
            forces = [forces[0], 0.0, 0.0];
        }
        let is_planar = self.normal.is_some();
        let stress = |moments| largest_stress(&self.section, is_planar, forces, moments);
        // Which way a centre line in space bends relative to its section is not known.
        let other = if self.is_line && !is_planar {
            [0.0, moments[2], 0.0]
        } else {
            moments
        };
        SectionState {
            x: spec.line.length() * (element as f64 + xi) / spec.count as f64,
            forces,
            moments,
            stress: stress(moments).zip(stress(other)).map(|(a, b)| a.max(b)),
            is_planar,
        }
    }

    /// Forces and moments at the points of an element.
    fn points(&mut self, element: usize) -> Element {
        let body = &self.scene.bodies[self.body];
        let spec = &body.spec;
        let mut local = [[0.0; MAX_SIZE]; 3];
        let [free, values, rates] = &mut local;
        let undeformed = (0..spec.nodal.len()).flat_map(|local| spec.undeformed(element, local));
        free.iter_mut().zip(undeformed).for_each(|(to, from)| *to = from);
        body.connectivity.gather(element, &self.scene.buffers.q, values);
        body.connectivity.gather(element, &self.scene.buffers.v, rates);
        let (is_line, normal) = (self.is_line, self.normal);
        let moments = if is_line {
            Moments::Three(std::array::from_fn(|place| {
                self.fields_at(&local, Point::Three(place)).of_line()
            }))
        } else {
            Moments::Two(std::array::from_fn(|place| {
                self.fields_at(&local, Point::Two(place)).of_section(normal)
            }))
        };
        Element {
            mean: self.mean_force(&local),
            change: self.change(element),
            moments,
            local: local[1],
        }
    }

    /// [`Element::mean`]: of a section with axes of `R = dU/dr_x`, by the points of its rule; of a centre line of
    /// `dU/dr_x - (dU/dr_xx)'`, integrated by parts. R is the force itself, not the second Piola-Kirchhoff stress
    /// times the area: it is derived with respect to r_x, and contains its stretch.
    fn mean_force(&mut self, local: &[[f64; MAX_SIZE]; 3]) -> Vector {
        let mut sum = [0.0; 3];
        if !self.is_line {
            for (place, (xi, weight)) in THREE.into_iter().zip(THREE_WEIGHTS).enumerate() {
                let force = self
                    .fields_at(local, Point::Three(place))
                    .force(Interpolant::Position, 1);
                sum = add(sum, scale(6.0 * weight * xi * (1.0 - xi), force));
            }
            return sum;
        }
        let spec = &self.scene.bodies[self.body].spec;
        let length = spec.line.length() / spec.count as f64;
        for (place, (xi, weight)) in FIVE.into_iter().enumerate() {
            let fields = self.fields_at(local, Point::Five(place));
            let force = scale(xi * (1.0 - xi), fields.force(Interpolant::Position, 1));
            let couple = scale((1.0 - 2.0 * xi) / length, fields.force(Interpolant::Position, 2));
            sum = add(sum, scale(6.0 * weight, add(force, couple)));
        }
        sum
    }

    /// [`Element::change`] from accelerations and gravity.
    fn change(&self, element: usize) -> [Vector; 3] {
        let body = &self.scene.bodies[self.body];
        let spec = &body.spec;
        let (buffers, dimension) = (&self.scene.buffers, spec.dimension());
        let frame = &buffers.frames[body.frame];
        let origin = frame.felt(buffers.gravity);
        let mass = self.density * spec.line.length() / spec.count as f64;
        let components = body.connectivity.element(element);
        let [first, middle, last] = std::array::from_fn(|place| {
            let at = |full: &[f64]| body.spread(weighted(full, components, dimension, &self.positions[place]));
            let [p, v, a] = [&buffers.q, &buffers.v, &buffers.a].map(|full| at(full));
            let turning = cross(frame.spin, add(cross(frame.spin, p), scale(2.0, v)));
            let whole = add(add(origin, a), add(turning, cross(frame.spin_rate, p)));
            scale(mass, whole)
        });
        let s = THREE[2] - 0.5;
        let curved = subtract(add(first, last), scale(2.0, middle));
        [
            // Loads per length as spread evenly over the element.
            subtract(middle, self.scene.density_on(self.body, element)),
            scale(0.5 / s, subtract(last, first)),
            scale(0.5 / (s * s), curved),
        ]
    }

    /// Axes of the section at a place of an element; of a centre line the first is along its slope.
    fn triad(&self, values: &[f64; MAX_SIZE], xi: f64) -> [Vector; 3] {
        let body = &self.scene.bodies[self.body];
        let (count, dimension) = (body.spec.nodal.len(), body.spec.dimension());
        let at = |of: Interpolant, order: usize| {
            let mut shapes = [0.0; MAX_SIZE];
            let shapes = &mut shapes[..count];
            self.scene.parts.shapes(self.body, of, order, xi, shapes);
            let mut sum = [0.0; 3];
            for (weight, vector) in shapes.iter().zip(values.chunks_exact(dimension)) {
                sum.iter_mut()
                    .zip(vector)
                    .for_each(|(sum, value)| *sum += weight * value);
            }
            body.spread(sum)
        };
        if self.is_line {
            return [unit(at(Interpolant::Position, 1)), [0.0; 3], [0.0; 3]];
        }
        let y = at(Interpolant::SectionY, 0);
        let z = self.normal.unwrap_or_else(|| at(Interpolant::SectionZ, 0));
        section_axes(y, z)
    }

    /// Fields and forces on them at a point of the element with these nodal vectors.
    fn fields_at(&mut self, local: &[[f64; MAX_SIZE]; 3], point: Point) -> Fields<'_> {
        let spec = &self.scene.bodies[self.body].spec;
        let (dimension, count) = (spec.dimension(), spec.nodal.len());
        let weights = match point {
            Point::Two(place) => &self.two[place],
            Point::Three(place) => &self.three[place],
            Point::Five(place) => &self.five[place],
        };
        let [free, values, rates, forces] = &mut self.fields;
        for (fields, local) in [&mut *free, &mut *values, &mut *rates].into_iter().zip(local) {
            if dimension == 2 {
                interpolate::<2>(weights, &local[..2 * count], fields);
            } else {
                interpolate::<3>(weights, &local[..3 * count], fields);
            }
        }
        forces.fill(0.0);
        self.scene.parts.field_forces(self.body, free, values, rates, forces);
        Fields {
            of: self.of,
            axes: spec.axes,
            values: &self.fields[1],
            forces: &self.fields[3],
        }
    }
}

/// Fields of D components from the nodal vectors, with one weight for each vector and field.
fn interpolate<const D: usize>(weights: &[f64], local: &[f64], fields: &mut [f64]) {
    let (vectors, _) = local.as_chunks::<D>();
    let (fields, _) = fields.as_chunks_mut::<D>();
    for (field, weights) in fields.iter_mut().zip(weights.chunks_exact(vectors.len())) {
        let mut sum = [0.0; D];
        for (weight, vector) in weights.iter().zip(vectors) {
            for k in 0..D {
                sum[k] += weight * vector[k];
            }
        }
        *field = sum;
    }
}

/// Which of the points.
#[derive(Clone, Copy)]
enum Point {
    Two(usize),
    Three(usize),
    Five(usize),
}

/// Weights of the nodal vectors in every field at a place of an element, one field after the other.
pub(super) fn weights(scene: &MeshScene, body: usize, of: &[(Interpolant, usize)], xi: f64) -> Vec<f64> {
    let count = scene.bodies[body].spec.nodal.len();
    let mut weights = vec![0.0; of.len() * count];
    for (&(of, order), weights) in of.iter().zip(weights.chunks_exact_mut(count)) {
        scene.parts.shapes(body, of, order, xi, weights);
    }
    weights
}

impl MeshScene {
    /// What the section of a body carries at `xi` in [0, 1] of an element, at the loaded state.
    pub fn section_state(&self, body: usize, element: usize, xi: f64) -> SectionState {
        let mut reader = Reader::new(self, body);
        let found = reader.points(element);
        reader.state(element, xi, &found)
    }

    /// Mass of a body per length, kg/m.
    fn mass_per_length(&self, body: usize) -> f64 {
        let body = &self.bodies[body];
        let (nodal, count) = (body.spec.nodal, body.spec.nodal.len());
        // The shape functions of positions add up to one.
        let between = body.mass.iter().enumerate();
        let whole =
            between.filter(|(place, _)| nodal[place / count].is_position() && nodal[place % count].is_position());
        let mass: f64 = whole.map(|(_, mass)| mass).sum();
        mass * body.spec.count as f64 / body.spec.line.length()
    }

    /// Whether the largest stress of a body's sections is known.
    pub(super) fn knows_stress(&self, body: usize) -> bool {
        let (spec, section) = (&self.bodies[body].spec, self.parts.section(body));
        largest_stress(&section, spec.dimension() == 2, [0.0; 3], [0.0; 3]).is_some()
    }

    /// Refuses the stress of a section that does not know its extents.
    pub(super) fn check_stress(&self, body: usize, what: SectionQuantity) -> Result<(), ModelError> {
        if what != SectionQuantity::Stress || self.knows_stress(body) {
            return Ok(());
        }
        Err(ModelError::new(format!(
            "an output reads the stress of body `{}`, whose section does not say where its outermost fibres are: give `extent_y` and in space `extent_z`",
            self.bodies[body].spec.label()
        )))
    }

    /// The same at a place.
    pub(super) fn section_at(&self, point: &MeshPoint) -> SectionState {
        self.section_state(point.body, point.element, point.xi)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPACE: &[(Interpolant, usize)] = &[
        (Interpolant::Position, 1),
        (Interpolant::SectionY, 0),
        (Interpolant::SectionZ, 0),
        (Interpolant::SectionY, 1),
        (Interpolant::SectionZ, 1),
    ];

    #[test]
    fn a_section_has_the_moment_of_its_fibres() {
        // Fibres at (Y, Z) pulled with forces F along r_y x r_z make R = sum F, dU/dr_y' = sum Y F and
        // dU/dr_z' = sum Z F; the section is turned, its axes are longer than one and not square.
        let turn = crate::rotation::Rotation::exp([0.3, -0.7, 0.5]).matrix();
        let turned = |u: Vector| crate::vector::apply(&turn, u);
        let (y, z) = (turned([0.0, 1.1, 0.0]), turned([0.0, 0.2, 0.9]));
        let pull = turned([2.0, 0.3, -0.4]);
        let (a, b) = (0.05, -0.02);
        let forces = [pull, [0.0; 3], [0.0; 3], scale(a, pull), scale(b, pull)].concat();
        let values = [turned([1.0, 0.0, 0.0]), y, z, [0.0; 3], [0.0; 3]].concat();
        let fields = Fields {
            of: SPACE,
            axes: &[0, 1, 2],
            values: &values,
            forces: &forces,
        };
        let moment = fields.of_section(None);
        // r_y x r_z is along the first axis, r_y along the second.
        let arm = add(scale(a, [0.0, 1.1, 0.0]), scale(b, [0.0, 0.2, 0.9]));
        let wanted = cross(arm, [2.0, 0.3, -0.4]);
        for i in 0..3 {
            assert!((moment[i] - wanted[i]).abs() < 1e-14, "{moment:?} {wanted:?}");
        }
    }

    #[test]
    fn the_moment_of_a_planar_section_is_about_the_normal_of_its_plane() {
        // In the plane zx (normal y): the axis along z, r_y = normal x tangent along x.
        let fields = Fields {
            of: &[
                (Interpolant::Position, 1),
                (Interpolant::SectionY, 0),
                (Interpolant::SectionY, 1),
            ],
            axes: &[2, 0],
            values: &[1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
            forces: &[5.0, 7.0, 0.0, 0.0, -3.0, 0.0],
        };
        let moment = fields.of_section(Some([0.0, 1.0, 0.0]));
        // x cross (-3 z) = 3 y
        assert_eq!(moment, [0.0, 0.0, 3.0]);
    }

    #[test]
    fn polynomials_are_interpolated_exactly() {
        let line = |x: f64| [1.0 - 2.0 * x, 3.0 * x, 0.5];
        let curve = |x: f64| [1.0 - 2.0 * x + 5.0 * x * x, x * x, 0.0];
        for xi in [0.0, 0.3, 1.0] {
            for (found, wanted) in [
                (interpolated(&TWO, &TWO.map(line), xi), line(xi)),
                (interpolated(&THREE, &THREE.map(curve), xi), curve(xi)),
            ] {
                assert!(norm(add(found, scale(-1.0, wanted))) < 1e-14, "{found:?} {wanted:?}");
            }
        }
    }
}
