//! Names what has no finite value: a spring whose ends coincide, a motion that leaves the range of its
//! function.

use crate::scene::MeshScene;
use crate::scene::pieces::marker::Linked;
use crate::space::Vector;
use crate::system::System;

/// What can be wrong, and what can be done, where markers may meet.
const APART: &str = "a length, direction or divisor in it is zero, or a function or table in it is outside its range or too large for a number; move its points apart where they meet (a `bushing` acts where they are one), or change its parameters";
/// The same where they do not.
const BEYOND: &str = "a divisor in it is zero, or a function or table in it is outside its range or too large for a number, as `cosh(x)` is beyond x = 710; its points are apart, so change its rows, parameters or formula";

fn finite(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite())
}

/// Distance of two points, as a part of their coordinates, that is nothing but round-off.
const ROUND_OFF: f64 = 1e3 * f64::EPSILON;

impl MeshScene {
    /// Puts points into one place that are apart by a round-off: a direction between them would be one of round-off, too.
    fn merge_points(&self, markers: &[usize], z: &mut [Vector]) {
        let points = self.points(markers);
        let at: Vec<Vector> = markers
            .iter()
            .map(|&marker| self.jet(&self.links.markers[marker])[0])
            .collect();
        let coordinates = points.iter().map(|&place| at[place].norm()).fold(0.0, f64::max);
        for (index, &place) in points.iter().enumerate() {
            let near = |&&other: &&usize| (at[place] - at[other]).norm() <= ROUND_OFF * coordinates;
            if let Some(&first) = points[..index].iter().find(near) {
                z[place] = z[first];
            }
        }
    }

    /// What can be wrong with a function of the values of markers whose meeting points have been merged.
    fn cause(&self, markers: &[usize], z: &[Vector]) -> &'static str {
        let points: Vec<Vector> = self.points(markers).iter().map(|&place| z[place]).collect();
        let is_apart = |place: usize| !points[..place].contains(&points[place]);
        if points.len() > 1 && (1..points.len()).all(is_apart) {
            BEYOND
        } else {
            APART
        }
    }

    /// Places of the markers in a list that are points.
    fn points(&self, markers: &[usize]) -> Vec<usize> {
        (0..markers.len())
            .filter(|&place| self.links.markers[markers[place]].is_point())
            .collect()
    }

    /// dC/dz of a constraint with such points in one place.
    fn gradient_where_points_meet(&self, linked: &Linked, t: f64) -> Vec<f64> {
        let markers = linked.spec.markers;
        let mut z: Vec<Vector> = markers
            .iter()
            .map(|&marker| self.jet_from(&self.links.markers[marker], linked.anchor)[0])
            .collect();
        self.merge_points(markers, &mut z);
        let mut gradient = vec![0.0; linked.spec.rows.len() * 3 * z.len()];
        self.parts
            .marker_constraint_gradient(linked.index, t, &z, &mut gradient);
        gradient
    }

    /// The first motion, load, constraint or force at the loaded state that is not finite.
    pub(crate) fn undefined_now(&self, t: f64) -> Option<String> {
        let motion = self.undefined_frame().or_else(|| self.undefined_load(t));
        motion
            .or_else(|| self.undefined_constraint(t))
            .or_else(|| self.undefined_force(t))
    }

    fn undefined_frame(&self) -> Option<String> {
        let prescribed = |frame: &usize| self.frames.free_of[*frame].is_none();
        let frame = (0..self.buffers.frames.len())
            .filter(prescribed)
            .find(|&frame| !self.buffers.frames[frame].is_finite())?;
        Some(format!(
            "the motion of frame `{}` or one of its derivatives is not finite: check its functions of time, the rows of its tables and its parameters",
            self.parts.frame_name(frame)
        ))
    }

    fn undefined_load(&self, t: f64) -> Option<String> {
        let load = (0..self.dead_loads.specs.len()).find(|&load| !finite(&self.parts.load(load, t)))?;
        Some(format!(
            "load `{}` is not finite: check its functions of time, the rows of its tables and its parameters",
            self.dead_loads.specs[load].name
        ))
    }

    fn undefined_constraint(&self, t: f64) -> Option<String> {
        let mut first = self.first_linked();
        for linked in &self.links.constraints {
            let count = linked.spec.rows.len();
            let gradient = self.gradient_where_points_meet(linked, t);
            let width = gradient.len() / count.max(1);
            if let Some(place) = gradient.iter().position(|value| !value.is_finite()) {
                return Some(format!(
                    "{} has no finite derivative: {APART}",
                    self.describe_constraint(first + place / width)
                ));
            }
            first += count;
        }
        None
    }

    fn undefined_force(&self, t: f64) -> Option<String> {
        for (index, spec) in self.links.forces.iter().enumerate() {
            let (mut z, velocity) = self.force_arguments(index);
            self.merge_points(&spec.markers, &mut z);
            let mut forces = vec![0.0; 3 * z.len()];
            self.push(index, t, &z, &velocity, &mut forces);
            let size = 9 * z.len() * z.len();
            let [mut by_value, mut by_velocity] = [vec![0.0; size], vec![0.0; size]];
            self.push_tangent(index, t, &z, &velocity, [&mut by_value, &mut by_velocity]);
            if !(finite(&forces) && finite(&by_value) && finite(&by_velocity)) {
                let cause = self.cause(&spec.markers, &z);
                return Some(format!("the force of `{}` is not finite: {cause}", spec.name));
            }
        }
        None
    }
}
