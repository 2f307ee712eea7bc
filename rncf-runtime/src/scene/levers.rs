//! Centres of what free frames and rigid bodies carry, where these move freely.

use crate::linalg::Pattern;
use crate::model::Scene;
use crate::scene::MeshScene;
use crate::scene::frames::free_frames::{FreeFrame, angle_axis};
use crate::space::{Matrix, Vector, matrix};
use crate::system::{Carried, Lever, System, Turning};

/// Determinant of an inertia over the cube of its trace, below which it counts as that of a line.
const SLENDER: f64 = 1e-10;

/// A scene at its start.
pub(crate) struct Inertia<'s> {
    positions: &'s [f64],
    mass: &'s [f64],
    pattern: &'s Pattern,
    /// Whether an unknown stands in a constraint.
    is_tied: Vec<bool>,
    /// First unknown of the poses.
    border: usize,
}

impl MeshScene {
    /// Poses whose unknowns stand in no constraint, and the centres of mass that they have at t = 0.
    pub(crate) fn free_levers(&mut self) -> Vec<Lever> {
        if self.frames.free.is_empty() {
            return Vec::new();
        }
        let start = self.rest(0.0);
        let mut mass = vec![0.0; self.tabulated.pattern.entries()];
        self.mass(&start, &mut mass);
        Inertia::new(self, &start.x, &mass).levers(&self.frames.free)
    }
}

impl<'s> Inertia<'s> {
    /// A scene with positions and mass matrix at its start.
    pub fn new(system: &'s dyn System, positions: &'s [f64], mass: &'s [f64]) -> Self {
        let mut is_tied = vec![false; positions.len()];
        for &unknown in system.constraint_pattern().indices() {
            is_tied[unknown] = true;
        }
        Self {
            positions,
            mass,
            pattern: system.pattern(),
            is_tied,
            border: positions.len() - system.border(),
        }
    }

    /// The levers of these frames, whose unknowns are the last ones.
    pub fn levers(&self, frames: &[FreeFrame]) -> Vec<Lever> {
        frames.iter().filter_map(|frame| self.lever(frame)).collect()
    }

    /// The lever of a frame; `None` where it does not turn or is tied.
    fn lever(&self, frame: &FreeFrame) -> Option<Lever> {
        let (first, shifts) = (self.border + frame.first, frame.shifts());
        let is_tied = self.is_tied[first..first + frame.count()].contains(&true);
        if shifts == frame.count() || is_tied {
            return None;
        }
        let turning = match (frame.turn, angle_axis(frame.spec.motions), frame.angle()) {
            (Some(index), ..) => Turning::Orientation { index },
            (None, Some(axis), Some(place)) => Turning::Angle {
                unknown: first + place,
                axis,
                base: frame.rotation_at_zero(),
            },
            _ => return None,
        };
        let entry = |row: usize, column: usize| {
            let place = self.pattern.find(first + row, first + column);
            place.map_or(0.0, |place| self.mass[place])
        };
        // Coupling of positions with a turn t is m R (t x c); (t x c) x t is c without its part along t.
        let rotation = matrix(&frame.start.rotation);
        let (mass, mut arm) = (if shifts == 0 { 0.0 } else { entry(0, 0) }, Vector::zeros());
        for column in shifts..frame.count() {
            let mut moment = Vector::zeros();
            for row in 0..shifts {
                moment += entry(row, column) / mass * frame.directions[row].shift;
            }
            arm += rotation.tr_mul(&moment).cross(&frame.directions[column].turn);
        }
        let mut inertia = None;
        if frame.turn.is_some() {
            // Each part was counted for two turns.
            arm = 0.5 * arm;
            let about_origin = Matrix::from_fn(|i, j| entry(shifts + i, shifts + j));
            let square = arm.dot(&arm);
            let steiner = |i: usize, j: usize| if i == j { square } else { 0.0 } - arm[i] * arm[j];
            let about_centre = Matrix::from_fn(|i, j| about_origin[(i, j)] - mass * steiner(i, j));
            let regular = Some(about_centre).filter(is_regular);
            inertia = regular.and_then(|inertia| Some([inertia, inertia.try_inverse()?]));
        }
        let carried = self.carried(frame, [first, shifts], mass);
        arm.iter().all(|part| part.is_finite()).then(|| Lever {
            positions: (0..shifts)
                .map(|row| (first + row, frame.directions[row].shift))
                .collect(),
            turning,
            arm,
            carried,
            inertia,
        })
    }

    /// The unknowns that shift the centre of the mass that a frame carries, whose first unknown and number of positions these are.
    fn carried(&self, frame: &FreeFrame, [first, shifts]: [usize; 2], mass: f64) -> Vec<Carried> {
        let rotation = matrix(&frame.start.rotation);
        let unknowns = if shifts == 0 { 0..0 } else { 0..self.border };
        let moving = unknowns.filter_map(|unknown| {
            let mut pushed = Vector::zeros();
            for row in 0..shifts {
                let place = self.pattern.find(first + row, unknown)?;
                pushed += self.mass[place] * frame.directions[row].shift;
            }
            (pushed != Vector::zeros()).then(|| Carried {
                unknown,
                start: self.positions[unknown],
                way: rotation.tr_mul(&pushed) / mass,
            })
        });
        moving.collect()
    }
}

/// Whether no moment of inertia vanishes as that of a line does.
fn is_regular(inertia: &Matrix) -> bool {
    inertia.determinant() > SLENDER * inertia.trace().powi(3)
}
