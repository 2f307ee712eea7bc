//! Forces that are narrow in space, and change within a turn at angles that nobody tries: their bounds tell which.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use super::steady::Turning;
use crate::course::{Courses, Interval, Operation, Path};
use crate::emitted::FrameMotion;
use crate::scene::MeshScene;
use crate::scene::pieces::push::Push;
use crate::scene::terms::linked::courses::way;

/// Part of all that a force takes on anywhere, by which it may change.
const SAME: f64 = 1e-6;
/// Spans in which a turn is bounded at most; halvings that make bounds close.
const SPANS: u32 = 4096;
const SHORTEST: f64 = 1e-12;

impl MeshScene {
    /// Angles, rad, by which the loaded state may be turned so that forces change: one for each whose bounds leave what they are there, and that does not depend on time.
    pub(super) fn angles_of_narrow_forces(&self, turning: &Turning) -> Vec<f64> {
        let moved = |&marker: &usize| turning.moved[self.marker_frame(&self.links.markers[marker])];
        let speed = turning.spin.velocity.norm();
        let motion = FrameMotion {
            position: turning.spin.point,
            velocity: turning.along,
            spin: turning.spin.velocity,
            ..FrameMotion::INERTIAL
        };
        let angle = |push: &Push| {
            let course = self.course_of(push)?;
            if course.operations.contains(&Operation::Time) {
                return None;
            }
            let ways = push.markers.iter().map(|&index| {
                let marker = &self.links.markers[index];
                let [value, rate, ..] = self.jet(marker);
                let frame = if moved(&index) { &motion } else { &FrameMotion::INERTIAL };
                way(marker, frame, [value, rate], 0.0)
            });
            Some(speed * changed(course, ways.collect(), TAU / speed)?)
        };
        let forces = self.links.forces.iter().filter(|push| push.markers.iter().any(moved));
        forces.filter_map(angle).collect()
    }
}

/// A time within a period, s, at which a function of vectors on paths has left the value that it has at zero.
fn changed(mut courses: Courses, paths: Vec<Path>, period: f64) -> Option<f64> {
    let mut all = Vec::new();
    // Without paths vectors are anywhere.
    courses.bounds(Interval::point(0.0), &mut all);
    let widths: Vec<f64> = courses.functions.iter().map(|&(_, at)| all[at].width()).collect();
    courses.paths = paths;
    courses.bounds(Interval::point(0.0), &mut all);
    let known = courses
        .functions
        .iter()
        .zip(widths)
        .filter(|(_, width)| width.is_finite());
    let allowed: Vec<(usize, Interval)> = known
        .map(|(&(_, at), width)| (at, all[at].wider(SAME * width)))
        .collect();
    let mut stays = |span: Interval| {
        courses.bounds(span, &mut all);
        allowed.iter().all(|&(at, allowed)| allowed.contains(all[at]))
    };
    let mut spans = VecDeque::from([Interval::new(0.0, period)]);
    for _ in 0..SPANS {
        let span = spans.pop_front()?;
        if span.width() < SHORTEST * period || stays(span) {
            continue;
        }
        let middle = 0.5 * (span.low + span.high);
        if !stays(Interval::point(middle)) {
            return Some(middle);
        }
        spans.extend([Interval::new(span.low, middle), Interval::new(middle, span.high)]);
    }
    None
}
