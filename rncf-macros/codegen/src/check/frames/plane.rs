//! What keeps a planar body in its plane, and which frames have the same axes.

use crate::check::values::quantity::Vector;
use crate::check::values::words::AXES;
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::model::{Expr as Value, Frame, FrameId, INERTIAL, Motions, Space};
use crate::parse::tree::Name;

/// Cosine of the angle between two axes that count as parallel.
const PARALLEL: f64 = 1.0 - 1e-12;

/// Names of the planes by their normals.
pub const PLANES: [&str; 3] = ["yz", "zx", "xy"];

/// Name of the plane with this normal.
pub fn plane(normal: usize) -> &'static str {
    PLANES[normal]
}

/// Normal of a planar body.
pub fn normal(space: Space) -> Option<usize> {
    match space {
        Space::Planar { normal } => Some(normal),
        Space::Spatial => None,
    }
}

impl Check<'_> {
    /// Whether a frame and all that carry it move in the plane; reports the first that does not.
    pub(in crate::check) fn keeps_plane(&mut self, frame: FrameId, normal: usize, area: impl Into<Area>) -> bool {
        let mut at = frame;
        while at != INERTIAL {
            let frame = &self.model.frames[at.0];
            let name = frame.name.clone();
            match frame.free.as_ref().map(|free| free_keeps(&free.motions, &name, normal)) {
                // Its own declaration has put it into the plane.
                Some(Ok(true)) => return true,
                Some(Ok(false)) => {
                    at = frame.parent;
                    continue;
                }
                Some(Err(message)) => {
                    if self.out_of_plane.insert((at, normal)) {
                        self.errors.at(area, message);
                    }
                    return false;
                }
                None => {}
            }
            let leaves = frame
                .rotation
                .as_ref()
                .is_some_and(|rotation| rotation.axis[normal].abs() < PARALLEL);
            let drifts = fold::constant(&frame.origin[normal]) != Some(0.0);
            if leaves || drifts {
                if !self.out_of_plane.insert((at, normal)) {
                    return false;
                }
                let axis = AXES[normal];
                let message = if leaves {
                    say::rotation_leaves_plane(&name, plane(normal), axis)
                } else {
                    say::origin_leaves_plane(&name, plane(normal), axis)
                };
                self.errors.at(area, message);
                return false;
            }
            at = frame.parent;
        }
        true
    }

    /// Normals of the planes in which bodies and frames move.
    pub(in crate::check) fn plane_normals(&self) -> Vec<usize> {
        let bodies = self.bodies.values().filter_map(|body| normal(body.space?));
        let frames = self
            .model
            .frames
            .iter()
            .filter_map(|frame| match frame.free.as_ref()?.motions {
                Motions::Planar { normal } | Motions::ShiftingPlanar { normal } => Some(normal),
                _ => None,
            });
        let mut normals: Vec<usize> = bodies.chain(frames).collect();
        normals.sort_unstable();
        normals.dedup();
        normals
    }

    /// Reports a component along the normal that is not literally zero: one of a param would be lost in silence.
    pub(in crate::check) fn in_plane(&mut self, vector: &Vector, space: Space, what: &str) {
        let Some(normal) = normal(space) else {
            return;
        };
        if fold::constant(&vector.values[normal]) != Some(0.0) {
            self.errors.at(
                vector.areas[normal],
                say::out_of_plane(what, plane(normal), AXES[normal]),
            );
        }
    }

    /// Whether a body can be in a frame: a point mass has no axes.
    pub(in crate::check) fn has_axes(&mut self, frame: FrameId, word: Option<&Name>) -> bool {
        let motions = self.model.frames[frame.0].free.as_ref().map(|free| free.motions);
        let is_point = matches!(motions, Some(Motions::Shifting | Motions::ShiftingPlanar { .. }));
        if let Some(word) = word.filter(|_| is_point) {
            self.errors.at(word.span, say::body_in_point_mass(&word.text));
        }
        !is_point
    }

    /// The next frame, from this one towards the inertial one, that rotates in its parent or is
    /// free: frames with the same one have parallel axes at all times.
    fn rotating_ancestor(&self, frame: FrameId) -> FrameId {
        let mut at = frame;
        let keeps_axes = |frame: &Frame| frame.rotation.is_none() && frame.free.is_none();
        while at != INERTIAL && keeps_axes(&self.model.frames[at.0]) {
            at = self.model.frames[at.0].parent;
        }
        at
    }

    /// Whether two frames have the same axes at all times.
    pub(in crate::check) fn have_same_axes(&self, a: FrameId, b: FrameId) -> bool {
        self.rotating_ancestor(a) == self.rotating_ancestor(b)
    }
}

/// Whether a free frame keeps a plane: by itself, or (`false`) where its parent does.
fn free_keeps(motions: &Motions, name: &str, normal: usize) -> Result<bool, String> {
    match motions {
        Motions::Planar { normal: own } | Motions::ShiftingPlanar { normal: own } if *own == normal => Ok(true),
        Motions::Planar { normal: own } | Motions::ShiftingPlanar { normal: own } => {
            Err(say::other_plane(name, plane(*own), plane(normal)))
        }
        Motions::Hinged { axis } if axis[normal].abs() >= PARALLEL => Ok(false),
        Motions::Hinged { .. } => Err(say::hinge_leaves_plane(name, plane(normal), AXES[normal])),
        Motions::Spatial | Motions::Turning | Motions::Shifting => Err(say::spatial_frame(name, plane(normal))),
        Motions::State => Ok(true),
    }
}

/// Whether a vector is parallel to a unit vector, and not zero.
pub fn is_parallel(vector: [f64; 3], unit: [f64; 3]) -> bool {
    let norm = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    let dot: f64 = vector.iter().zip(unit).map(|(a, b)| a * b).sum();
    norm > 0.0 && dot.abs() >= norm * PARALLEL
}

/// A zero vector of constants.
pub fn is_zero(values: &[Value; 3]) -> bool {
    values.iter().all(|value| fold::constant(value) == Some(0.0))
}
