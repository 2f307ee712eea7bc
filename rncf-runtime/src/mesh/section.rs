//! What sections carry: forces and moments that the part of a body beyond a place exerts on the part
//! before it, from the strain energy and damping at points of an element (THEORY 5.1, 5.2).

use super::parts::{Interpolant, Parts};
use super::scene::{MeshPoint, MeshScene};
use super::section_spec::SectionQuantity;
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
            SectionQuantity::Moment => moment_y.hypot(moment_z),
            SectionQuantity::Stress => return self.stress,
        })
    }
}

/// Points in [0, 1] where strains are most accurate: those at which elements are integrated. Forces and
/// moments are interpolated between them, since strains in between contain what the shape functions cannot
/// do in a bent element.
const TWO: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];
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

/// Fields of a body at a point of an element, with the forces on them.
struct Fields<'a> {
    of: &'a [(Interpolant, usize)],
    axes: &'static [usize],
    values: Vec<f64>,
    forces: Vec<f64>,
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
        self.pick(&self.values, of, order)
    }

    fn force(&self, of: Interpolant, order: usize) -> Vector {
        self.pick(&self.forces, of, order)
    }

    /// Force and moment on a section with axes, `R = dU/dr_x`, `M = r_y x dU/dr_y' + r_z x dU/dr_z'`, in its
    /// triad; `normal` is that of a planar body.
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

    /// Force along the slope of a centre line (first), and moment `r_x x dU/dr_xx` in frame axes.
    fn of_line(&self) -> [Vector; 2] {
        let slope = self.value(Interpolant::Position, 1);
        let axial = dot(self.force(Interpolant::Position, 1), unit(slope));
        [[axial, 0.0, 0.0], cross(slope, self.force(Interpolant::Position, 2))]
    }
}

/// Right-handed triad of a section: `r_y x r_z`, r_y, and what is normal to both.
fn section_axes(y: Vector, z: Vector) -> [Vector; 3] {
    let (along, y) = (unit(cross(y, z)), unit(y));
    [along, y, cross(along, y)]
}

impl<P: Parts> MeshScene<P> {
    /// What the section of a body carries at `xi` in [0, 1] of an element, at the loaded state.
    pub fn section_state(&self, body: usize, element: usize, xi: f64) -> SectionState {
        let spec = &self.bodies[body].spec;
        let normal = spec.plane_normal();
        let is_line = !spec.has_section();
        let at = |point: f64| {
            let fields = self.fields_at(body, element, point);
            if is_line {
                fields.of_line()
            } else {
                fields.of_section(normal)
            }
        };
        let three = THREE.map(at);
        let forces = interpolated(&THREE, &three.map(|[force, _]| force), xi);
        let mut moments = if is_line {
            interpolated(&THREE, &three.map(|[_, moment]| moment), xi)
        } else {
            interpolated(&TWO, &TWO.map(at).map(|[_, moment]| moment), xi)
        };
        if is_line {
            let size = normal.map_or_else(|| norm(moments), |normal| dot(moments, normal));
            moments = [0.0, 0.0, size];
        }
        let section = self.parts.section(body);
        let stress = |moments| largest_stress(&section, normal.is_some(), forces, moments);
        // Which way a centre line in space bends relative to its section is not known.
        let other = if is_line && normal.is_none() {
            [0.0, moments[2], 0.0]
        } else {
            moments
        };
        SectionState {
            x: spec.line.length() * (element as f64 + xi) / spec.count as f64,
            forces,
            moments,
            stress: stress(moments).zip(stress(other)).map(|(a, b)| a.max(b)),
            is_planar: normal.is_some(),
        }
    }

    /// Refuses the stress of a section that does not know its extents.
    pub(super) fn check_stress(&self, body: usize, what: SectionQuantity) -> Result<(), ModelError> {
        let (spec, section) = (&self.bodies[body].spec, self.parts.section(body));
        let is_known = || largest_stress(&section, spec.dimension() == 2, [0.0; 3], [0.0; 3]).is_some();
        if what != SectionQuantity::Stress || is_known() {
            return Ok(());
        }
        Err(ModelError::new(format!(
            "an output reads the stress of body `{}`, whose section does not say where its outermost fibres are: give `extent_y` and in space `extent_z`",
            spec.name
        )))
    }

    /// The same at a place.
    pub(super) fn section_at(&self, point: &MeshPoint) -> SectionState {
        self.section_state(point.body, point.element, point.xi)
    }

    fn fields_at(&self, body: usize, element: usize, xi: f64) -> Fields<'_> {
        let mesh_body = &self.bodies[body];
        let spec = &mesh_body.spec;
        let (dimension, of) = (spec.dimension(), self.parts.fields(body));
        let mut weights = vec![vec![0.0; spec.nodal.len()]; of.len()];
        for (&(of, order), weights) in of.iter().zip(&mut weights) {
            self.parts.shapes(body, of, order, xi, weights);
        }
        let all = |local: &[f64]| -> Vec<f64> {
            let component = |weights: &[f64], c: usize| -> f64 {
                let vectors = local.chunks_exact(dimension);
                weights
                    .iter()
                    .zip(vectors)
                    .map(|(weight, vector)| weight * vector[c])
                    .sum()
            };
            let fields = weights.iter();
            fields
                .flat_map(|weights| (0..dimension).map(move |c| component(weights, c)))
                .collect()
        };
        let gathered = |full: &[f64]| -> Vec<f64> {
            let components = mesh_body.connectivity.element(element);
            components.iter().map(|&component| full[component]).collect()
        };
        let undeformed: Vec<f64> = (0..spec.nodal.len())
            .flat_map(|local| spec.undeformed(element, local))
            .collect();
        let (free, values) = (all(&undeformed), all(&gathered(&self.buffers.q)));
        let rates = all(&gathered(&self.buffers.v));
        let mut forces = vec![0.0; values.len()];
        self.parts.field_forces(body, &free, &values, &rates, &mut forces);
        Fields {
            of,
            axes: spec.axes,
            values,
            forces,
        }
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
        let fields = Fields {
            of: SPACE,
            axes: &[0, 1, 2],
            values: [turned([1.0, 0.0, 0.0]), y, z, [0.0; 3], [0.0; 3]].concat(),
            forces,
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
            values: vec![1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
            forces: vec![5.0, 7.0, 0.0, 0.0, -3.0, 0.0],
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
        }
    }
}
