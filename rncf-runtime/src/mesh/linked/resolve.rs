//! From declared markers to those of the run: places on bodies, and constants at t = 0.

use super::super::frames::normal_of;
use super::super::markers::MarkerSpec;
use super::super::parts::{BodySpec, Parts, Place};
use super::super::scene::{MeshScene, PlaceVector, mesh_point};
use super::Marker;
use crate::error::ModelError;
use crate::vector::{Vector, cross, dot, norm, perpendicular, scale};

/// Deepest chain of markers that refer to each other.
const DEEPEST: usize = 8;
/// Who uses markers, for messages.
const USER: &str = "a joint, force or output";

/// Markers of the declared ones; those that stand for others at t = 0 get their constants later.
///
/// # Errors
/// A place beyond a body's end, or the angle of a frame that has none.
pub(in super::super) fn markers(
    parts: &dyn Parts,
    bodies: &[BodySpec],
    free_of: &[Option<usize>],
) -> Result<Vec<Marker>, ModelError> {
    let body = |body: usize, at, of| mesh_point(parts, bodies, body, at, USER).map(|point| Marker::Body { point, of });
    let fixed = |frame, at, is_point| Ok(Marker::Fixed { frame, at, is_point });
    let specs = parts.markers();
    let one = |spec: &MarkerSpec| match *spec {
        MarkerSpec::Point { frame, at } => fixed(frame, at, true),
        MarkerSpec::Direction { frame, along } => fixed(frame, along, false),
        MarkerSpec::BodyPoint { body: index, at } => body(index, at, PlaceVector::Position),
        MarkerSpec::BodySlope { body: index, at } => body(index, at, PlaceVector::Slope),
        MarkerSpec::BodySection { body: index, at, axis } => body(index, at, PlaceVector::section(3)[axis - 1]),
        MarkerSpec::InSection { .. } => Ok(Marker::Constant([0.0; 3])),
        MarkerSpec::Turn { frame } => Ok(Marker::Turn { frame }),
        MarkerSpec::Angle { frame } => match free_of[frame] {
            Some(free) => Ok(Marker::Angle { free }),
            None => Err(ModelError::new(format!(
                "frame `{}` has no unknown angle: only planar and hinged frames have one",
                parts.frame_name(frame)
            ))),
        },
        MarkerSpec::Matching { frame, marker } => fixed(frame, [0.0; 3], is_point(&specs, marker)?),
        MarkerSpec::Normal { frame, .. } => fixed(frame, [0.0; 3], false),
    };
    specs.iter().map(one).collect()
}

/// Whether a declared marker is a point.
fn is_point(specs: &[MarkerSpec], mut marker: usize) -> Result<bool, ModelError> {
    for _ in 0..DEEPEST {
        match specs[marker] {
            MarkerSpec::Point { .. } | MarkerSpec::BodyPoint { .. } => return Ok(true),
            MarkerSpec::Matching { marker: other, .. } => marker = other,
            _ => return Ok(false),
        }
    }
    Err(endless())
}

fn endless() -> ModelError {
    ModelError::new("markers refer to each other without end: let one of them be given by a frame or body")
}

impl MeshScene {
    /// Finds the constants of markers that are fixed in one frame and equal, or normal, to another
    /// marker; the state at t = 0 must be loaded.
    pub(in super::super) fn resolve_markers(&mut self) -> Result<(), ModelError> {
        let specs = self.parts.markers();
        for index in 0..specs.len() {
            if let MarkerSpec::Matching { frame, .. } | MarkerSpec::Normal { frame, .. } = specs[index] {
                let value = self.initial(&specs, index, 0)?;
                let motion = &self.buffers.frames[frame];
                let is_point = self.markers[index].is_point();
                let at = if is_point {
                    motion.point_to_frame(value)
                } else {
                    motion.direction_to_frame(value)
                };
                self.markers[index] = Marker::Fixed { frame, at, is_point };
            } else if let MarkerSpec::InSection { .. } = specs[index] {
                self.markers[index] = Marker::Constant(self.initial(&specs, index, 0)?);
            }
        }
        Ok(())
    }

    /// Value of a declared marker at the loaded state, inertial axes.
    fn initial(&self, specs: &[MarkerSpec], index: usize, depth: usize) -> Result<Vector, ModelError> {
        if depth > DEEPEST {
            return Err(endless());
        }
        let unit = |direction: Vector, frame: usize| {
            let size = norm(direction);
            if size > 0.0 {
                return Ok(scale(1.0 / size, direction));
            }
            let name = self.parts.frame_name(frame);
            Err(ModelError::new(format!(
                "a direction of a joint in frame `{name}` has no length: give it one that is not zero"
            )))
        };
        match specs[index] {
            MarkerSpec::Matching { frame, marker } => {
                let value = self.initial(specs, marker, depth + 1)?;
                if self.markers[index].is_point() {
                    Ok(value)
                } else {
                    unit(value, frame)
                }
            }
            MarkerSpec::Normal { frame, marker, which } => {
                let along = unit(self.initial(specs, marker, depth + 1)?, frame)?;
                // In a plane the first normal lies in it.
                let first = match self.plane_normal(specs, frame, marker) {
                    Some(normal) if norm(cross(normal, along)) > 0.5 => cross(normal, along),
                    _ => perpendicular(along),
                };
                Ok(if which == 0 { first } else { cross(along, first) })
            }
            MarkerSpec::InSection { body, at, marker } => {
                let value = self.initial(specs, marker, depth + 1)?;
                let direction = unit(value, self.bodies[body].spec.frame)?;
                Ok(components_in(&self.section_triad(body, at)?, direction))
            }
            _ => Ok(self.jet(&self.markers[index])[0]),
        }
    }

    /// Axes of a section at the loaded state, inertial axes: `r_y x r_z`, r_y, r_z, each normalised; in a
    /// plane r_y turned by -90 degrees about the normal, r_y, and the normal.
    ///
    /// # Errors
    /// A place beyond the body's end, or axes without length.
    fn section_triad(&self, body: usize, at: Place) -> Result<[Vector; 3], ModelError> {
        let point = self.point(body, at, USER)?;
        let mesh_body = &self.bodies[body];
        let frame = &self.buffers.frames[mesh_body.frame];
        let vector = |of| frame.direction_to_inertial(self.at_point(&point, of, &self.buffers.q));
        let y = vector(PlaceVector::SectionY);
        let (z, along) = match mesh_body.spec.plane_normal() {
            Some(normal) => {
                let normal = frame.direction_to_inertial(normal);
                (normal, cross(y, normal))
            }
            None => {
                let z = vector(PlaceVector::SectionZ);
                (z, cross(y, z))
            }
        };
        if norm(along) > 0.0 {
            return Ok([along, y, z].map(|axis| scale(1.0 / norm(axis), axis)));
        }
        Err(ModelError::new(format!(
            "the section's axes of body `{}` have no length or the same direction at t = 0: check its initial shape",
            mesh_body.spec.label()
        )))
    }

    /// Normal of the plane that a frame, or what another marker belongs to, stays in; inertial axes.
    fn plane_normal(&self, specs: &[MarkerSpec], frame: usize, marker: usize) -> Option<Vector> {
        let unit = |axis: usize| std::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 });
        let of_frame = |frame: usize| {
            self.free_of[frame]
                .and_then(|free| normal_of(self.free[free].spec.motions))
                .map(unit)
        };
        let other = match specs[marker] {
            MarkerSpec::BodySlope { body, .. }
            | MarkerSpec::BodyPoint { body, .. }
            | MarkerSpec::BodySection { body, .. }
            | MarkerSpec::InSection { body, .. } => {
                let spec = &self.bodies[body].spec;
                if let [first, second] = *spec.axes {
                    let motion = &self.buffers.frames[spec.frame];
                    return Some(motion.direction_to_inertial(unit(3 - first - second)));
                }
                spec.frame
            }
            MarkerSpec::Point { frame, .. }
            | MarkerSpec::Direction { frame, .. }
            | MarkerSpec::Turn { frame }
            | MarkerSpec::Angle { frame }
            | MarkerSpec::Matching { frame, .. }
            | MarkerSpec::Normal { frame, .. } => frame,
        };
        of_frame(frame).or_else(|| of_frame(other))
    }
}

/// The numbers c with `u = c_1 t_1 + c_2 t_2 + c_3 t_3`: t_1 is a unit vector normal to both others, which are
/// unit vectors and need not be normal to each other.
fn components_in([along, y, z]: &[Vector; 3], u: Vector) -> Vector {
    let (by_y, by_z) = (cross(*z, *along), cross(*along, *y));
    [
        dot(u, *along),
        dot(u, by_y) / dot(*y, by_y),
        dot(u, by_z) / dot(*z, by_z),
    ]
}
