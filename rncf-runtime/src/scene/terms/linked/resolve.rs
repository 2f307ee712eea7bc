//! From declared markers to those of the run: places on bodies, and constants at t = 0.

use crate::emitted::{BodySpec, MarkerSpec, Motions, Parts};
use crate::error::ModelError;
use crate::scene::bodies::place::{MeshPoint, PlaceVector, mesh_point};
use crate::scene::frames::free_frames::{FreeFrame, normal_of};
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::Marker;
use crate::space::{Vector, perpendicular};

/// Deepest chain of markers that refer to each other.
const DEEPEST: usize = 8;
/// Distance of a joint from a point mass, relative to the size of the model, that counts as round-off.
const ROUND_OFF: f64 = 1e-9;
/// Who uses markers, for messages.
const USER: &str = "a joint, force or output";

/// Markers of the declared ones; those that stand for others at t = 0 get their constants later.
///
/// # Errors
/// A place beyond a body's end, or the angle of a frame that has none.
pub(crate) fn markers(
    parts: &dyn Parts,
    bodies: &[BodySpec],
    free_of: &[Option<usize>],
) -> Result<Vec<Marker>, ModelError> {
    let body = |body: usize, at, of| mesh_point(parts, bodies, body, at, USER).map(|point| Marker::Body { point, of });
    let fixed = |frame, at, is_point| Ok(Marker::Fixed { frame, at, is_point });
    let specs = parts.markers();
    let one = |spec: &MarkerSpec| match *spec {
        MarkerSpec::Point { frame, at } => fixed(frame, at.into(), true),
        MarkerSpec::Direction { frame, along } => fixed(frame, along.into(), false),
        MarkerSpec::BodyPoint { body: index, at } => body(index, at, PlaceVector::Position),
        MarkerSpec::SectionPoint {
            body: index,
            at,
            beside: [y, z],
        } => mesh_point(parts, bodies, index, at, USER).map(|point| Marker::Section {
            point,
            along: Vector::new(0.0, y, z),
            is_point: true,
        }),
        MarkerSpec::BodySlope { body: index, at } => body(index, at, PlaceVector::Slope),
        MarkerSpec::BodySection { body: index, at, axis } => body(index, at, PlaceVector::section(3)[axis - 1]),
        MarkerSpec::InSection { body: index, at, .. } => {
            mesh_point(parts, bodies, index, at, USER).map(|point| Marker::Section {
                point,
                along: Vector::zeros(),
                is_point: false,
            })
        }
        MarkerSpec::Turn { frame } => Ok(Marker::Turn { frame }),
        MarkerSpec::SectionTurn { body: index, at } => {
            mesh_point(parts, bodies, index, at, USER).map(|point| Marker::SectionTurn { point })
        }
        MarkerSpec::Angle { frame } => match free_of[frame] {
            Some(free) => Ok(Marker::Angle { free }),
            None => Err(ModelError::new(format!(
                "frame `{}` has no unknown angle: only planar and hinged frames have one",
                parts.frame_name(frame)
            ))),
        },
        MarkerSpec::Matching { frame, marker } => fixed(frame, Vector::zeros(), is_point(&specs, marker)?),
        MarkerSpec::Normal { frame, .. } => fixed(frame, Vector::zeros(), false),
    };
    specs.iter().map(one).collect()
}

/// Whether a declared marker is a point.
fn is_point(specs: &[MarkerSpec], mut marker: usize) -> Result<bool, ModelError> {
    for _ in 0..DEEPEST {
        match specs[marker] {
            MarkerSpec::Point { .. } | MarkerSpec::BodyPoint { .. } | MarkerSpec::SectionPoint { .. } => {
                return Ok(true);
            }
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
    pub(crate) fn resolve_markers(&mut self) -> Result<(), ModelError> {
        let specs = self.parts.markers();
        for index in 0..specs.len() {
            if let MarkerSpec::Matching { frame, .. } | MarkerSpec::Normal { frame, .. } = specs[index] {
                let value = self.initial(&specs, index, 0)?;
                let motion = &self.buffers.frames[frame];
                let is_point = self.links.markers[index].is_point();
                let at = if is_point {
                    motion.point_to_frame(value)
                } else {
                    motion.direction_to_frame(value)
                };
                if is_point {
                    self.check_point_mass(index, frame, at)?;
                }
                self.links.markers[index] = Marker::Fixed { frame, at, is_point };
            } else if let MarkerSpec::InSection { body, at, .. } = specs[index] {
                let direction = self.initial(&specs, index, 0)?;
                let point = self.point(body, at, USER)?;
                let along = self.in_section(&point, direction)?;
                self.links.markers[index] = Marker::Section {
                    point,
                    along,
                    is_point: false,
                };
            }
        }
        Ok(())
    }

    /// A joint whose other place is elsewhere at t = 0 would hold a point mass in the air.
    fn check_point_mass(&self, index: usize, frame: usize, at: Vector) -> Result<(), ModelError> {
        let free = self.frames.free_of[frame].map(|free| &self.frames.free[free]);
        let is_mass =
            |free: &&FreeFrame| matches!(free.spec.motions, Motions::Shifting | Motions::ShiftingPlanar { .. });
        let distance = at.norm();
        let position = self.buffers.frames[frame].position.norm();
        let size = self.sizes_of_bodies().max(position);
        if free.filter(is_mass).is_none() || distance <= ROUND_OFF * size {
            return Ok(());
        }
        let user = self
            .links
            .constraints
            .iter()
            .find(|linked| linked.spec.markers.contains(&index));
        Err(ModelError::new(format!(
            "joint `{}` holds the point mass `{}` {distance:.3e} m away from where it is, and a point mass does not turn about it: give it an `inertia`, or use `distance`",
            user.map_or(USER, |linked| linked.spec.name),
            self.parts.frame_name(frame)
        )))
    }

    /// Length of the longest body, m.
    fn sizes_of_bodies(&self) -> f64 {
        let lengths = self.bodies.iter().map(|body| body.spec.line.length());
        lengths.fold(0.0, f64::max)
    }

    /// Value of a declared marker at the loaded state, inertial axes.
    fn initial(&self, specs: &[MarkerSpec], index: usize, depth: usize) -> Result<Vector, ModelError> {
        if depth > DEEPEST {
            return Err(endless());
        }
        let unit = |direction: Vector, frame: usize| {
            let size = direction.norm();
            if size > 0.0 {
                return Ok(1.0 / size * direction);
            }
            let name = self.parts.frame_name(frame);
            Err(ModelError::new(format!(
                "a direction of a joint in frame `{name}` has no length: give it one that is not zero"
            )))
        };
        match specs[index] {
            MarkerSpec::Matching { frame, marker } => {
                let value = self.initial(specs, marker, depth + 1)?;
                if self.links.markers[index].is_point() {
                    Ok(value)
                } else {
                    unit(value, frame)
                }
            }
            MarkerSpec::Normal { frame, marker, which } => {
                let along = unit(self.initial(specs, marker, depth + 1)?, frame)?;
                // In a plane the first normal lies in it.
                let first = match self.plane_normal(specs, frame, marker) {
                    Some(normal) if normal.cross(&along).norm() > 0.5 => normal.cross(&along),
                    _ => perpendicular(along),
                };
                Ok(if which == 0 { first } else { along.cross(&first) })
            }
            MarkerSpec::InSection { body, marker, .. } => {
                unit(self.initial(specs, marker, depth + 1)?, self.bodies[body].spec.frame)
            }
            _ => Ok(self.jet(&self.links.markers[index])[0]),
        }
    }

    /// Components of a direction (inertial axes) in the triad of a section at the loaded state.
    ///
    /// # Errors
    /// Axes without length, or with the same direction.
    fn in_section(&self, point: &MeshPoint, direction: Vector) -> Result<Vector, ModelError> {
        let body = &self.bodies[point.body];
        let along = self.buffers.frames[body.frame].direction_to_frame(direction);
        let components = self.triad(point).components(along);
        if components.iter().all(|component| component.is_finite()) {
            return Ok(components);
        }
        Err(ModelError::new(format!(
            "the section's axes of body `{}` have no length or the same direction at t = 0: check its initial shape",
            body.spec.label()
        )))
    }

    /// Normal of the plane that a frame, or what another marker belongs to, stays in; inertial axes.
    fn plane_normal(&self, specs: &[MarkerSpec], frame: usize, marker: usize) -> Option<Vector> {
        let unit = |axis: usize| Vector::ith(axis, 1.0);
        let of_frame = |frame: usize| {
            self.frames.free_of[frame]
                .and_then(|free| normal_of(self.frames.free[free].spec.motions))
                .map(unit)
        };
        let other = match specs[marker] {
            MarkerSpec::BodySlope { body, .. }
            | MarkerSpec::BodyPoint { body, .. }
            | MarkerSpec::SectionPoint { body, .. }
            | MarkerSpec::BodySection { body, .. }
            | MarkerSpec::InSection { body, .. }
            | MarkerSpec::SectionTurn { body, .. } => {
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
