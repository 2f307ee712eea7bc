//! What loads per length do over time at the points of elements, and how these points move on.

use crate::course::{Courses, Operation, Path};
use crate::emitted::FrameMotion;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::push::Law;
use crate::space::Vector;

/// Part of the acceleration on a screw by which that of a frame's origin may differ: else it flies straight on, or nearly.
const ON_SCREW: f64 = 0.5;

impl MeshScene {
    /// Courses of the points that time acts on, with the indices of what acts there.
    pub(in crate::scene) fn courses_at_points(&self) -> impl Iterator<Item = (usize, Courses)> {
        self.links.forces.iter().enumerate().filter_map(|(index, push)| {
            let Law::Distributed { load, at, .. } = push.law else {
                return None;
            };
            let course = self.parts.distributed_course(load, at)?;
            let is_timed = course.operations.contains(&Operation::Time) || course.reads_position();
            is_timed.then_some((index, course))
        })
    }

    /// Ways of the points at the loaded state whose courses read their positions, from a time (s) on.
    pub(in crate::scene) fn paths_of_points(&self, t: f64) -> Vec<Path> {
        let reading = self.courses_at_points().filter(|(_, course)| course.reads_position());
        let paths = reading.map(|(index, _)| {
            let (z, velocity) = self.force_arguments(index);
            let frame = self.marker_frame(&self.links.markers[self.links.forces[index].markers[0]]);
            on_screw(&self.buffers.frames[frame], [z[0], velocity[0]], t)
        });
        paths.collect()
    }
}

/// The way of a particle with a place (m) and a velocity (m/s) that is carried by a frame.
fn on_screw(frame: &FrameMotion, [place, velocity]: [Vector; 2], t: f64) -> Path {
    let turning = frame.rotation * frame.spin;
    let spin = turning.norm();
    let carried = frame.velocity + turning.cross(&(place - frame.position));
    let drift = velocity - carried;
    let mut path = Path {
        from: t,
        middle: place.into(),
        velocity: velocity.into(),
        arm: [0.0; 3],
        quarter: [0.0; 3],
        spin,
    };
    if spin == 0.0 {
        return path;
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
    path.middle = middle.into();
    path.velocity = (along + drift).into();
    path.arm = (place - middle).into();
    path.quarter = axis.cross(&(place - middle)).into();
    path
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
