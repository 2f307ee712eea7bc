//! Centres of what free frames and rigid bodies carry, where these move freely.

use super::frames::{FreeFrame, angle_axis};
use super::scene::MeshScene;
use crate::linalg::Pattern;
use crate::model::Scene;
use crate::system::{Lever, System, Turning};
use crate::vector::{Matrix, Vector, add, apply_transposed, cross, dot, scale};

/// Determinant of an inertia over the cube of its trace, below which it counts as that of a line.
const SLENDER: f64 = 1e-10;

/// Unknowns of a scene: inertia at the start, patterns, the first unknown of the poses.
struct Inertia<'s> {
    mass: Vec<f64>,
    pattern: &'s Pattern,
    constraint_pattern: &'s Pattern,
    border: usize,
}

impl MeshScene {
    /// Poses whose positions stand in no constraint, and the centres of mass that they have at t = 0.
    pub(super) fn free_levers(&mut self) -> Vec<Lever> {
        let start = self.rest(0.0);
        let mut mass = vec![0.0; self.pattern.entries()];
        self.mass(&start, &mut mass);
        let inertia = Inertia {
            mass,
            pattern: &self.pattern,
            constraint_pattern: &self.constraint_pattern,
            border: self.layout.unknowns() - self.layout.border(),
        };
        self.free.iter().filter_map(|frame| inertia.lever(frame)).collect()
    }
}

impl Inertia<'_> {
    /// The lever of a frame; `None` where it does not turn or is tied.
    fn lever(&self, frame: &FreeFrame) -> Option<Lever> {
        let (first, shifts) = (self.border + frame.first, frame.shifts());
        let is_tied = |row: usize| self.constraint_pattern.indices().contains(&row);
        if shifts == frame.count() || (first..first + frame.count()).any(is_tied) {
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
        let rotation = frame.start.rotation.matrix();
        let (mass, mut arm) = (if shifts == 0 { 0.0 } else { entry(0, 0) }, [0.0; 3]);
        for column in shifts..frame.count() {
            let mut moment: Vector = [0.0; 3];
            for row in 0..shifts {
                moment = add(moment, scale(entry(row, column) / mass, frame.directions[row].shift));
            }
            arm = add(
                arm,
                cross(apply_transposed(&rotation, moment), frame.directions[column].turn),
            );
        }
        let mut inertia = None;
        if frame.turn.is_some() {
            // Each part was counted for two turns.
            arm = scale(0.5, arm);
            let about_origin: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| entry(shifts + i, shifts + j)));
            let square = dot(arm, arm);
            let about_centre = std::array::from_fn(|i| {
                let steiner = |j: usize| if i == j { square } else { 0.0 } - arm[i] * arm[j];
                std::array::from_fn(|j| about_origin[i][j] - mass * steiner(j))
            });
            inertia = inverse(&about_centre).map(|inverse| [about_centre, inverse]);
        }
        arm.iter().all(|part| part.is_finite()).then(|| Lever {
            positions: (0..shifts)
                .map(|row| (first + row, frame.directions[row].shift))
                .collect(),
            turning,
            arm,
            inertia,
        })
    }
}

/// Inverse of an inertia whose least moment is not that of a line.
fn inverse(inertia: &Matrix) -> Option<Matrix> {
    let [a, b, c] = *inertia;
    let columns = [cross(b, c), cross(c, a), cross(a, b)];
    let determinant = dot(a, columns[0]);
    let trace = a[0] + b[1] + c[2];
    let is_regular = determinant > SLENDER * trace.powi(3);
    is_regular.then(|| std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i] / determinant)))
}
