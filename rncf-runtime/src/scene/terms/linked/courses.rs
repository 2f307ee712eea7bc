//! What forces and loads per length do over time and over the vectors that they read, and how these go on.

use crate::course::{Courses, Operation, Path};
use crate::emitted::FrameMotion;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::Marker;
use crate::scene::pieces::push::{Law, Push};
use crate::space::Vector;

/// Part of the acceleration on a screw by which that of a frame's origin may differ: else it flies straight on, or nearly.
const ON_SCREW: f64 = 0.5;

impl MeshScene {
    /// Courses of forces on markers and of points of elements that time or their vectors act on.
    pub(in crate::scene) fn courses_of_forces(&self) -> impl Iterator<Item = Courses> {
        self.links.forces.iter().filter_map(|push| {
            let course = self.course_of(push)?;
            let is_timed = course.operations.contains(&Operation::Time) || course.reads_vectors();
            is_timed.then_some(Courses {
                markers: push.markers.clone(),
                ..course
            })
        })
    }

    /// What a force does that steps could jump over.
    pub(in crate::scene) fn course_of(&self, push: &Push) -> Option<Courses> {
        match push.law {
            Law::Force(force) => self.parts.force_course(force),
            Law::Distributed { load, at, .. } => self.parts.distributed_course(load, at),
            Law::Gravity { load, .. } => self.parts.around_course(load),
        }
    }

    /// Ways of the vectors of markers at the loaded state, from a time (s) on.
    pub(in crate::scene) fn paths_of(&self, markers: &[usize], t: f64) -> Vec<Path> {
        let markers = markers.iter();
        let path = |&index: &usize| {
            let marker = &self.links.markers[index];
            let [value, rate, ..] = self.jet_from(marker, None);
            way(
                marker,
                &self.buffers.frames[self.marker_frame(marker)],
                [value, rate],
                t,
            )
        };
        markers.map(path).collect()
    }
}

/// The way of a marker that has a value and a rate and is carried by a frame, from a time (s) on.
pub(in crate::scene) fn way(marker: &Marker, frame: &FrameMotion, vector: [Vector; 2], t: f64) -> Path {
    match marker {
        Marker::Angle { .. } | Marker::Turn { .. } | Marker::SectionTurn { .. } => straight(vector, t),
        _ if marker.is_point() => on_screw(frame, vector, t),
        _ => {
            let turned = FrameMotion {
                spin: frame.spin,
                rotation: frame.rotation,
                ..FrameMotion::INERTIAL
            };
            on_screw(&turned, vector, t)
        }
    }
}

/// The way of a vector that changes evenly.
fn straight([value, rate]: [Vector; 2], t: f64) -> Path {
    Path {
        from: t,
        middle: value.into(),
        velocity: rate.into(),
        acceleration: [0.0; 3],
        arm: [0.0; 3],
        quarter: [0.0; 3],
        spin: 0.0,
        spin_rate: 0.0,
    }
}

/// The way of a place (m), or of a direction in a frame without velocity, that has a rate (m/s) and is carried by the frame.
fn on_screw(frame: &FrameMotion, [place, velocity]: [Vector; 2], t: f64) -> Path {
    let turning = frame.rotation * frame.spin;
    let spin = turning.norm();
    let carried = frame.velocity + turning.cross(&(place - frame.position));
    let drift = velocity - carried;
    if spin == 0.0 {
        return straight([place, velocity], t);
    }
    let axis = turning / spin;
    let inward = turning.cross(&frame.velocity);
    let is_turned = (frame.acceleration - inward).norm() <= ON_SCREW * inward.norm();
    let (centre, along) = if is_turned {
        (frame.position + inward / spin.powi(2), axis * axis.dot(&frame.velocity))
    } else {
        (frame.position, frame.velocity)
    };
    let way = place - centre;
    let middle = centre + axis * axis.dot(&way);
    Path {
        from: t,
        middle: middle.into(),
        velocity: (along + drift).into(),
        acceleration: [0.0; 3],
        arm: (place - middle).into(),
        quarter: axis.cross(&(place - middle)).into(),
        spin,
        spin_rate: 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wheel that rolls turns about its hub, and what turns about a far axis about that; a frame that flies evenly and tumbles goes straight on.
    #[test]
    fn what_a_frame_carries_turns_about_its_axis() {
        let mut frame = FrameMotion {
            position: Vector::new(3.0, 0.0, 0.0),
            velocity: Vector::new(0.0, 6.0, 0.0),
            acceleration: Vector::new(-12.0, 0.0, 0.0),
            spin: Vector::new(0.0, 0.0, 2.0),
            ..FrameMotion::INERTIAL
        };
        let place = Vector::new(4.0, 0.0, 1.0);
        let about_origin = on_screw(&frame, [place, Vector::new(0.0, 8.0, 0.0)], 0.0);
        assert_eq!(about_origin.middle, [0.0, 0.0, 1.0]);
        assert_eq!(about_origin.arm, [4.0, 0.0, 0.0]);
        assert_eq!(about_origin.quarter, [0.0, 4.0, 0.0]);
        assert_eq!(about_origin.velocity, [0.0; 3]);
        frame.acceleration = Vector::zeros();
        let rolling = on_screw(&frame, [place, Vector::new(0.0, 8.0, 0.5)], 0.0);
        assert_eq!(rolling.middle, [3.0, 0.0, 1.0]);
        assert_eq!(rolling.arm, [1.0, 0.0, 0.0]);
        assert_eq!(rolling.velocity, [0.0, 6.0, 0.5]);
    }
}
