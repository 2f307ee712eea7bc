//! What sections carry: forces and moments that the part of a body beyond a place exerts on the part
//! before it, from the strain energy and damping at points of an element (THEORY 5.1, 5.2).

use super::evaluate::MAX_SIZE;
use super::parts::{Interpolant, Parts, SectionQuantity, SectionSpec};
use super::scene::{MeshPoint, MeshScene};
use super::stress::largest_stress;
use crate::error::ModelError;
use crate::vector::{Vector, add, cross, dot, norm, scale};

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

/// Points in [0, 1] where strains are most accurate: those at which elements are integrated. Forces and
/// moments are interpolated between them, since strains in between contain what the shape functions cannot
/// do in a bent element.
const TWO: [f64; 2] = [0.211_324_865_405_187_12, 0.788_675_134_594_812_9];
const THREE: [f64; 3] = [0.112_701_665_379_258_31, 0.5, 0.887_298_334_620_741_7];

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

/// Derivative by xi of the polynomial through values at the points.
fn slope(points: &[f64], values: &[Vector], xi: f64) -> Vector {
    let mut sum = [0.0; 3];
    for (i, &value) in values.iter().enumerate() {
        let others = || points.iter().enumerate().filter(move |&(j, _)| j != i);
        let weight: f64 = others()
            .map(|(left_out, &from)| {
                let rest = others().filter(|&(j, _)| j != left_out);
                let product: f64 = rest.map(|(_, &point)| (xi - point) / (points[i] - point)).product();
                product / (points[i] - from)
            })
            .sum();
        sum = add(sum, scale(weight, value));
    }
    sum
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

    /// Force and moment on a section with axes, `R = dU/dr_x`, `M = r_y x dU/dr_y' + r_z x dU/dr_z'`, in its
    /// triad; `normal` is that of a planar body. R is the force itself, not the second Piola-Kirchhoff
    /// stress times the area: it is derived with respect to r_x, and contains its stretch.
    fn of_section(&self, normal: Option<Vector>) -> [Vector; 2] {
        let y = self.value(Interpolant::SectionY, 0);
        let z = normal.unwrap_or_else(|| self.value(Interpolant::SectionZ, 0));
        let triad = section_axes(y, z);
        let force = self.force(Interpolant::Position, 1);
        let mut moment = cross(y, self.force(Interpolant::SectionY, 1));
        if normal.is_none() {
            moment = add(moment, cross(z, self.force(Interpolant::SectionZ, 1)));
        }
        [force, moment].map(|vector| triad.map(|axis| dot(vector, axis)))
    }
}

/// What a point of a centre line carries, frame axes.
#[derive(Clone, Copy, Default)]
struct LinePoint {
    /// Unit vector along the slope.
    along: Vector,
    /// dU/dr_x, N.
    force: Vector,
    /// dU/dr_xx, N m.
    couple: Vector,
    /// `r_x x dU/dr_xx`, N m.
    moment: Vector,
}

/// Right-handed triad of a section: `r_y x r_z`, r_y, and what is normal to both.
fn section_axes(y: Vector, z: Vector) -> [Vector; 3] {
    let (along, y) = (unit(cross(y, z)), unit(y));
    [along, y, cross(along, y)]
}

/// Forces and moments at the points of one element.
struct Element {
    forces: [Vector; 3],
    moments: Moments,
}

/// Moments at those points where they are most accurate.
enum Moments {
    Two([Vector; 2]),
    Three([Vector; 3]),
}

impl Element {
    fn at(&self, xi: f64) -> [Vector; 2] {
        let moments = match &self.moments {
            Moments::Two(values) => interpolated(&TWO, values, xi),
            Moments::Three(values) => interpolated(&THREE, values, xi),
        };
        [interpolated(&THREE, &self.forces, xi), moments]
    }
}

/// Reads off what the sections of one body carry at the loaded state.
pub(super) struct Reader<'a, P> {
    scene: &'a MeshScene<P>,
    body: usize,
    of: &'static [(Interpolant, usize)],
    section: SectionSpec,
    is_line: bool,
    normal: Option<Vector>,
    /// Weights of the nodal vectors in every field, one field after the other, at the points.
    three: [Vec<f64>; 3],
    two: [Vec<f64>; 2],
    /// Fields at a point: stress-free, at present, their rates, and the forces on them.
    fields: [Vec<f64>; 4],
}

impl<'a, P: Parts> Reader<'a, P> {
    pub fn new(scene: &'a MeshScene<P>, body: usize) -> Self {
        let spec = &scene.bodies[body].spec;
        let of = scene.parts.fields(body);
        let count = spec.nodal.len();
        let weights = |xi: f64| {
            let mut weights = vec![0.0; of.len() * count];
            for (&(of, order), weights) in of.iter().zip(weights.chunks_exact_mut(count)) {
                scene.parts.shapes(body, of, order, xi, weights);
            }
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
            fields: std::array::from_fn(|_| vec![0.0; size]),
        }
    }

    /// What the sections at places in [0, 1] of an element carry.
    pub fn element(&mut self, element: usize, places: &[f64], out: &mut Vec<SectionState>) {
        let found = self.points(element);
        out.extend(places.iter().map(|&xi| self.state(element, xi, found.at(xi))));
    }

    fn state(&self, element: usize, xi: f64, [forces, mut moments]: [Vector; 2]) -> SectionState {
        let spec = &self.scene.bodies[self.body].spec;
        if self.is_line {
            let size = self.normal.map_or_else(|| norm(moments), |normal| dot(moments, normal));
            moments = [0.0, 0.0, size];
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
        if self.is_line {
            return self.line_element(&local);
        }
        let normal = self.normal;
        let mut forces = [[0.0; 3]; 3];
        for (place, force) in forces.iter_mut().enumerate() {
            *force = self.fields_at(&local, Point::Three(place)).of_section(normal)[0];
        }
        let mut moments = [[0.0; 3]; 2];
        for (place, moment) in moments.iter_mut().enumerate() {
            *moment = self.fields_at(&local, Point::Two(place)).of_section(normal)[1];
        }
        let moments = Moments::Two(moments);
        Element { forces, moments }
    }

    /// A centre line: the force that is in equilibrium with the loads is `R = dU/dr_x - (dU/dr_xx)'`, of which
    /// the part along the slope counts; the moment is `r_x x dU/dr_xx`.
    fn line_element(&mut self, local: &[[f64; MAX_SIZE]; 3]) -> Element {
        let spec = &self.scene.bodies[self.body].spec;
        let length = spec.line.length() / spec.count as f64;
        let mut points = [LinePoint::default(); 3];
        for (place, point) in points.iter_mut().enumerate() {
            let fields = self.fields_at(local, Point::Three(place));
            let tangent = fields.value(Interpolant::Position, 1);
            let couple = fields.force(Interpolant::Position, 2);
            *point = LinePoint {
                along: unit(tangent),
                force: fields.force(Interpolant::Position, 1),
                couple,
                moment: cross(tangent, couple),
            };
        }
        let couples = points.map(|point| point.couple);
        let mut forces = [[0.0; 3]; 3];
        for ((force, point), xi) in forces.iter_mut().zip(&points).zip(THREE) {
            let change = slope(&THREE, &couples, xi);
            let whole = add(point.force, scale(-1.0 / length, change));
            force[0] = dot(whole, point.along);
        }
        Element {
            forces,
            moments: Moments::Three(points.map(|point| point.moment)),
        }
    }

    /// Fields and forces on them at a point of the element with these nodal vectors.
    fn fields_at(&mut self, local: &[[f64; MAX_SIZE]; 3], point: Point) -> Fields<'_> {
        let spec = &self.scene.bodies[self.body].spec;
        let (dimension, count) = (spec.dimension(), spec.nodal.len());
        let weights = match point {
            Point::Two(place) => &self.two[place],
            Point::Three(place) => &self.three[place],
        };
        let [free, values, rates, forces] = &mut self.fields;
        for (fields, local) in [&mut *free, &mut *values, &mut *rates].into_iter().zip(local) {
            let vectors = fields.chunks_exact_mut(dimension);
            for (field, weights) in vectors.zip(weights.chunks_exact(count)) {
                field.fill(0.0);
                for (weight, vector) in weights.iter().zip(local.chunks_exact(dimension)) {
                    field
                        .iter_mut()
                        .zip(vector)
                        .for_each(|(sum, value)| *sum += weight * value);
                }
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

/// Which of the points.
#[derive(Clone, Copy)]
enum Point {
    Two(usize),
    Three(usize),
}

impl<P: Parts> MeshScene<P> {
    /// What the section of a body carries at `xi` in [0, 1] of an element, at the loaded state.
    pub fn section_state(&self, body: usize, element: usize, xi: f64) -> SectionState {
        let mut reader = Reader::new(self, body);
        let found = reader.points(element);
        reader.state(element, xi, found.at(xi))
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
            self.bodies[body].spec.name
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
        let [force, moment] = fields.of_section(None);
        // r_y x r_z is along the first axis, r_y along the second.
        let arm = add(scale(a, [0.0, 1.1, 0.0]), scale(b, [0.0, 0.2, 0.9]));
        let wanted = cross(arm, [2.0, 0.3, -0.4]);
        for i in 0..3 {
            assert!((force[i] - [2.0, 0.3, -0.4][i]).abs() < 1e-14, "{force:?}");
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
        let [force, moment] = fields.of_section(Some([0.0, 1.0, 0.0]));
        assert_eq!(force, [5.0, 7.0, 0.0]);
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
            let (found, wanted) = (slope(&THREE, &THREE.map(curve), xi), [10.0 * xi - 2.0, 2.0 * xi, 0.0]);
            assert!(norm(add(found, scale(-1.0, wanted))) < 1e-13, "{found:?} {wanted:?}");
        }
    }
}
