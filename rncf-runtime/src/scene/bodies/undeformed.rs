//! Stress-free shapes: axes of sections and nodal vectors of undeformed bodies.

use crate::emitted::{BodySpec, Interpolant, Line, PARALLEL};
use crate::error::ModelError;
use crate::space::{Vector, exp, matrix, perpendicular};
use std::f64::consts::FRAC_PI_2;

/// Places of an element at which the direction of sections on a curve is looked at.
const LOOKS: usize = 31;

impl BodySpec {
    /// Unit vectors along the section's y and z axes (1, frame axes) at the fraction `u` in [0, 1] of the
    /// stress-free axis; with the tangent they are a right-handed triad. On an arc they turn with the
    /// tangent about the arc's normal; on a curve y is the declared direction made normal to the tangent at every place; then
    /// both turn about the tangent by the stress-free twist. In a plane y is
    /// normal x tangent and z the plane's normal.
    pub fn section(&self, u: f64) -> [Vector; 2] {
        if let Line::Nodes(_) = self.line {
            return [Vector::y(), Vector::z()];
        }
        let (_, tangent) = self.line.at(u);
        if let Some(normal) = self.plane_normal() {
            return [normal.cross(&tangent), normal];
        }
        let turned = match self.line.turned(u) {
            Some(turned) => {
                let start = self.line.at(0.0).1;
                let across = self.across(start).unwrap_or_else(|| perpendicular(start));
                matrix(&exp(turned)) * across
            }
            None => self.across(tangent).unwrap_or_else(|| perpendicular(tangent)),
        };
        // Round-off of the turning must not tilt the axis.
        let turned = unit(turned - turned.dot(&tangent) * tangent);
        let side = tangent.cross(&turned);
        let (sine, cosine) = self.twist.at(u).sin_cos();
        let y = cosine * turned + sine * side;
        [y, tangent.cross(&y)]
    }

    /// Whether the direction of the sections is found anew at every place, as on a curve in space.
    pub(crate) fn has_turning_section(&self) -> bool {
        self.dimension() == 3 && self.has_section() && matches!(self.line, Line::Curve(_))
    }

    /// Tangent and section's y axis at a fraction of the axis.
    pub(crate) fn directed(&self, u: f64) -> Directed {
        Directed {
            tangent: self.line.at(u).1,
            y: self.section(u)[0],
        }
    }

    /// Unit normal of the plane of a planar body, frame axes.
    pub(crate) fn plane_normal(&self) -> Option<Vector> {
        let [first, second] = *self.axes else {
            return None;
        };
        let mut normal = Vector::zeros();
        normal[3 - first - second] = 1.0;
        Some(normal)
    }

    /// The section's y axis at the start, normal to the tangent there; `None` where the declared direction
    /// has no part across it.
    fn across(&self, tangent: Vector) -> Option<Vector> {
        let wanted = self.section_y.map(Vector::from).unwrap_or_else(|| {
            let side = Vector::z().cross(&tangent);
            if side.norm() > PARALLEL { side } else { Vector::y() }
        });
        let part = wanted - wanted.dot(&tangent) * tangent;
        let is_across = wanted.norm().is_finite() && part.norm() > PARALLEL * wanted.norm();
        is_across.then(|| unit(part))
    }

    /// Refuses an axis or a section without direction, by the body's name.
    pub(crate) fn check_directions(&self) -> Result<(), ModelError> {
        let name = self.label();
        if !self.line.has_plane() {
            return Err(ModelError::new(format!(
                "body `{name}`: the direction and the normal of its arc span no plane: give both a length, and let the normal point out of the arc's plane"
            )));
        }
        if self.dimension() == 2 || !self.has_section() {
            return Ok(());
        }
        if let (Some(wanted), None) = (self.section_y, self.across(self.line.at(0.0).1)) {
            return Err(ModelError::new(format!(
                "body `{name}`: `section_y` {wanted:?} has no part across the axis at its start: give a direction that is not along it"
            )));
        }
        // On a curve every section has this direction by itself.
        if let (Some(wanted), Line::Curve(_)) = (self.section_y, &self.line) {
            let count = LOOKS * self.count;
            let mut before: Option<Directed> = None;
            let lost = (0..=count).map(|place| place as f64 / count as f64).find(|&u| {
                let is_along = self.across(self.line.at(u).1).is_none();
                let here = self.directed(u);
                let last = before.replace(here);
                is_along || last.is_some_and(|last| last.turn_to(&here) > FRAC_PI_2)
            });
            if let Some(u) = lost {
                return Err(ModelError::new(format!(
                    "body `{name}`: `section_y` {wanted:?} has no part across the axis at x = {:.6} m, or next to it: give a direction that is nowhere along it",
                    u * self.line.length()
                )));
            }
        }
        let twists = (0..=self.count).map(|node| self.twist.at(self.fraction(node, 0)));
        if let Some(twist) = twists.into_iter().find(|twist| !twist.is_finite()) {
            return Err(ModelError::new(format!(
                "body `{name}`: `twist` is {twist} rad: give it a finite value"
            )));
        }
        Ok(())
    }

    /// Fraction of the axis where a nodal vector is: `node` is that of its element's start.
    pub(crate) fn fraction(&self, node: usize, local: usize) -> f64 {
        let xi = self.nodal[local].xi;
        match self.stations.get(node..node + 2) {
            Some([start, end]) => start + xi * (end - start),
            // The last node.
            None if !self.stations.is_empty() => 1.0,
            _ => (node as f64 + xi) / self.count as f64,
        }
    }

    /// A nodal vector of an element (`node` is that of its start) in the stress-free shape, frame axes.
    pub(crate) fn undeformed_vector(&self, node: usize, local: usize) -> Vector {
        let u = self.fraction(node, local);
        match (self.nodal[local].of, self.nodal[local].order) {
            (Interpolant::Position, 0) => self.line.at(u).0,
            (Interpolant::Position, _) => self.line.at(u).1,
            (Interpolant::SectionY, _) => self.section(u)[0],
            (Interpolant::SectionZ, _) => self.section(u)[1],
        }
    }

    /// The same in the order of the body's axes.
    pub(crate) fn undeformed(&self, node: usize, local: usize) -> impl Iterator<Item = f64> {
        let vector = self.undeformed_vector(node, local);
        self.axes.iter().map(move |&axis| vector[axis])
    }
}

fn unit(vector: Vector) -> Vector {
    1.0 / vector.norm() * vector
}

/// How a section stands on its axis: unit vectors, frame axes.
#[derive(Clone, Copy)]
pub(crate) struct Directed {
    tangent: Vector,
    y: Vector,
}

impl Directed {
    /// Angle, rad, not negative, by which the section turns about the axis up to a place next to it.
    pub fn turn_to(&self, next: &Self) -> f64 {
        // Carried along the axis without turning about it.
        let turn = self.tangent.cross(&next.tangent);
        let carried =
            self.y + turn.cross(&self.y) + turn.cross(&turn.cross(&self.y)) / (1.0 + self.tangent.dot(&next.tangent));
        let sine = next.tangent.cross(&carried).dot(&next.y);
        sine.atan2(carried.dot(&next.y)).abs()
    }
}
