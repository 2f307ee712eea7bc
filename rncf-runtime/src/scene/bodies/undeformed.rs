//! Stress-free shapes: axes of sections and nodal vectors of undeformed bodies.

use crate::emitted::{BodySpec, Interpolant, Line, PARALLEL};
use crate::error::ModelError;
use crate::rotation::Rotation;
use crate::vector::{Vector, add, apply, cross, dot, norm, perpendicular, scale, subtract};

impl BodySpec {
    /// Unit vectors along the section's y and z axes (1, frame axes) at the fraction `u` in [0, 1] of the
    /// stress-free axis; with the tangent they are a right-handed triad. On an arc they turn with the
    /// tangent about the arc's normal; on a curve y is the declared direction made normal to the tangent at every place; then
    /// both turn about the tangent by the stress-free twist. In a plane y is
    /// normal x tangent and z the plane's normal.
    pub fn section(&self, u: f64) -> [Vector; 2] {
        if let Line::Nodes(_) = self.line {
            return [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        }
        let (_, tangent) = self.line.at(u);
        if let Some(normal) = self.plane_normal() {
            return [cross(normal, tangent), normal];
        }
        let turned = match self.line.turned(u) {
            Some(turned) => {
                let start = self.line.at(0.0).1;
                let across = self.across(start).unwrap_or_else(|| perpendicular(start));
                apply(&Rotation::exp(turned).matrix(), across)
            }
            None => self.across(tangent).unwrap_or_else(|| perpendicular(tangent)),
        };
        // Round-off of the turning must not tilt the axis.
        let turned = unit(subtract(turned, scale(dot(turned, tangent), tangent)));
        let side = cross(tangent, turned);
        let (sine, cosine) = self.twist.at(u).sin_cos();
        let y = add(scale(cosine, turned), scale(sine, side));
        [y, cross(tangent, y)]
    }

    /// Unit normal of the plane of a planar body, frame axes.
    pub(crate) fn plane_normal(&self) -> Option<Vector> {
        let [first, second] = *self.axes else {
            return None;
        };
        let mut normal = [0.0; 3];
        normal[3 - first - second] = 1.0;
        Some(normal)
    }

    /// The section's y axis at the start, normal to the tangent there; `None` where the declared direction
    /// has no part across it.
    fn across(&self, tangent: Vector) -> Option<Vector> {
        let wanted = self.section_y.unwrap_or_else(|| {
            let side = cross([0.0, 0.0, 1.0], tangent);
            if norm(side) > PARALLEL { side } else { [0.0, 1.0, 0.0] }
        });
        let part = subtract(wanted, scale(dot(wanted, tangent), tangent));
        let is_across = norm(wanted).is_finite() && norm(part) > PARALLEL * norm(wanted);
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
    scale(1.0 / norm(vector), vector)
}
