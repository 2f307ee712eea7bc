//! Symmetries of what acts on a scene: whether constraints and forces on markers stay the same when
//! frames are displaced rigidly (THEORY 8.1). Relative equilibria need those of the rotation;
//! motions that change nothing make a stiffness singular.

use crate::linalg::{norm, normalise, reduce};
use crate::scene::MeshScene;
use crate::scene::pieces::displacement::Displacement;
use crate::scene::pieces::marker::{Linked, Marker};
use crate::space::{Matrix, Vector, exp, matrix};
use crate::system::ConstraintLevel;

/// Relative change that counts as round-off.
const ROUND_OFF: f64 = 1e-8;

/// Time in which what depends on time changes, s.
const A_WHILE: f64 = 1e-3;

/// What constraint or force is at a place.
struct Acting {
    values: Vec<f64>,
    derivatives: Vec<Vec<f64>>,
}

/// Whether two lists of numbers differ by more than round-off of the given size.
fn differ(a: &[f64], b: &[f64], size: f64) -> bool {
    a.iter()
        .zip(b)
        .any(|(a, b)| (a - b).abs() > ROUND_OFF * size || (a - b).is_nan())
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

impl MeshScene {
    /// Whether the moved free frames can follow a displacement at the loaded state.
    pub(crate) fn follows(&self, displacement: &Displacement) -> bool {
        let turn = displacement.turn;
        self.frames
            .free
            .iter()
            .filter(|frame| displacement.moved[frame.spec.frame])
            .all(|frame| {
                let motion = &self.buffers.frames[frame.spec.frame];
                let moved = displacement.displaced(motion, true);
                let step = moved.position - motion.position;
                let within = motion.direction_to_frame(turn);
                let (mut left, mut untold) = (step, within);
                for direction in &frame.directions {
                    left -= direction.shift.dot(&step) * direction.shift;
                    untold -= direction.turn.dot(&within) * direction.turn;
                }
                let carries = self.bodies.iter().any(|body| body.spec.frame == frame.spec.frame)
                    || frame.spec.rigid.moment != Vector::zeros();
                let turns = frame.count() > frame.shifts() || carries;
                let size = (motion.position - displacement.point).norm() + step.norm() + f64::MIN_POSITIVE;
                left.norm() <= ROUND_OFF * size && (!turns || untold.norm() <= ROUND_OFF * turn.norm())
            })
    }

    /// The first constraint or force on markers, in the user's words, that a displacement changes at the
    /// loaded state, which is left as it was.
    pub(crate) fn changed_by(&mut self, t: f64, displacement: &Displacement) -> Option<String> {
        let is_looked_at = |is_timed: bool| displacement.later.is_none_or(|later| (later != 0.0) == is_timed);
        let later = t + A_WHILE;
        let touches = |scene: &Self, markers: &[usize]| {
            let moved = |&marker: &usize| displacement.moved[scene.marker_frame(&scene.links.markers[marker])];
            markers.iter().any(moved)
        };
        let constraints: Vec<usize> = (0..self.links.constraints.len())
            .filter(|&index| touches(self, self.links.constraints[index].spec.markers))
            .filter(|&index| is_looked_at(self.constraining(index, t).values != self.constraining(index, later).values))
            .collect();
        let forces: Vec<usize> = (0..self.links.forces.len())
            .filter(|&index| touches(self, &self.links.forces[index].markers))
            .filter(|&index| is_looked_at(self.forcing(index, t).values != self.forcing(index, later).values))
            .collect();
        let look = |scene: &Self, t: f64| -> [Vec<Acting>; 2] {
            [
                constraints.iter().map(|&index| scene.constraining(index, t)).collect(),
                forces.iter().map(|&index| scene.forcing(index, t)).collect(),
            ]
        };
        let before = look(self, t);
        let (loads, timed) = (self.marked_values(t), self.timed_values(t));
        let (frames, q) = (self.buffers.frames.clone(), self.buffers.q.clone());
        self.displace(displacement);
        let after = look(self, t + displacement.later.unwrap_or(0.0));
        let mut names = Vec::new();
        for (place, &index) in constraints.iter().enumerate() {
            if self.is_constraint_changed(displacement, &before[0][place], &after[0][place]) {
                let spec = &self.links.constraints[index].spec;
                names.push(match spec.kind {
                    "constraint" => format!("constraint `{}`", spec.name),
                    kind => format!("joint `{}` ({kind})", spec.name),
                });
            }
        }
        for (place, &index) in forces.iter().enumerate() {
            if self.is_force_changed(index, displacement, &before[1][place], &after[1][place]) {
                names.push(format!("force `{}`", self.links.forces[index].name));
            }
        }
        names.extend(self.changed_loads(t, displacement, &loads, &timed));
        (self.buffers.frames, self.buffers.q) = (frames, q);
        names.into_iter().next()
    }

    /// Displaces the loaded frames.
    pub(crate) fn displace(&mut self, displacement: &Displacement) {
        let border = self.layout.vector_components();
        for index in (0..self.buffers.frames.len()).filter(|&index| displacement.moved[index]) {
            let free = self.frames.free_of[index].map(|free| &self.frames.free[free]);
            let turns = free.is_none_or(|frame| frame.count() > frame.shifts());
            let frame = &mut self.buffers.frames[index];
            if let Some(free) = free
                && let Some(place) = free.angle()
            {
                let axis = frame.direction_to_inertial(free.directions[place].turn);
                self.buffers.q[border + free.first + place] += axis.dot(&displacement.turn);
            }
            *frame = displacement.displaced(frame, turns);
        }
    }

    /// Rows of a constraint, and their derivatives by all components.
    fn constraining(&self, index: usize, t: f64) -> Acting {
        let linked = &self.links.constraints[index];
        let jets: Vec<[Vector; 4]> = self.of_markers(linked, |marker| self.jet(marker));
        let z: Vec<Vector> = jets.iter().map(|jet| jet[0]).collect();
        let mut values = vec![0.0; linked.spec.rows.len()];
        self.parts
            .marker_constraint(linked.index, ConstraintLevel::Position, t, &jets, &mut values);
        let width = 3 * z.len();
        let mut gradient = vec![0.0; values.len() * width];
        self.parts
            .marker_constraint_gradient(linked.index, t, &z, &mut gradient);
        let columns = self.of_markers(linked, |marker| self.columns(marker));
        let derivatives = gradient.chunks_exact(width).map(|gradient| {
            let mut row = vec![0.0; self.layout.components()];
            for (place, columns) in columns.iter().enumerate() {
                let pull = Vector::from_fn(|i, _| gradient[3 * place + i]);
                for column in columns {
                    row[column.component] += pull.dot(&column.value);
                }
            }
            row
        });
        Acting {
            derivatives: derivatives.collect(),
            values,
        }
    }

    fn of_markers<T>(&self, linked: &Linked, call: impl Fn(&Marker) -> T) -> Vec<T> {
        let markers = linked.spec.markers.iter();
        markers.map(|&marker| call(&self.links.markers[marker])).collect()
    }

    /// A force on its markers, and its derivatives by their values and velocities.
    fn forcing(&self, index: usize, t: f64) -> Acting {
        let markers = &self.links.forces[index].markers;
        let jets = markers.iter().map(|&marker| self.jet(&self.links.markers[marker]));
        let (z, velocity): (Vec<Vector>, Vec<Vector>) = jets.map(|jet| (jet[0], jet[1])).unzip();
        let count = 3 * z.len();
        let zeros = |count: usize| vec![0.0; count];
        let [mut values, mut by_value, mut by_velocity] = [zeros(count), zeros(count * count), zeros(count * count)];
        self.push(index, t, &z, &velocity, &mut values);
        self.push_tangent(index, t, &z, &velocity, [&mut by_value, &mut by_velocity]);
        Acting {
            values,
            derivatives: vec![by_value, by_velocity],
        }
    }

    /// Whether rows change, or what they hold: the span of their derivatives in displaced axes.
    fn is_constraint_changed(&self, by: &Displacement, before: &Acting, after: &Acting) -> bool {
        let back = matrix(&by.rotation().inverse());
        let border = self.layout.vector_components();
        let sized = |row: &[f64]| -> Vec<f64> {
            let mut result = vec![0.0; self.tabulated.sizes.len()];
            for (component, value) in row.iter().enumerate() {
                for (unknown, factor) in self.layout.unknowns_at(component) {
                    result[unknown] += factor * value * self.tabulated.sizes[unknown];
                }
            }
            result
        };
        let mut basis: Vec<Vec<f64>> = Vec::new();
        let values = before.values.iter().zip(&after.values);
        for (row, (value, changed)) in before.derivatives.iter().zip(values) {
            let mut row = sized(row);
            let size = norm(&row);
            if differ(&[*value], &[*changed], size + value.abs()) {
                return true;
            }
            if reduce(&mut row, &basis) > ROUND_OFF * size {
                normalise(&mut row);
                basis.push(row);
            }
        }
        after.derivatives.iter().any(|row| {
            let mut row = row.clone();
            for frame in self.frames.free.iter().filter(|frame| by.moved[frame.spec.frame]) {
                let first = border + frame.first;
                let own = &mut row[first..first + frame.count()];
                let (mut along, mut about) = (Vector::zeros(), Vector::zeros());
                for (direction, value) in frame.directions.iter().zip(own.iter()) {
                    along += *value * direction.shift;
                    about += *value * direction.turn;
                }
                if by.is_own {
                    let motion = &self.buffers.frames[frame.spec.frame];
                    let within = motion.direction_to_frame(by.turn);
                    about = matrix(&exp(within)) * about;
                } else {
                    along = back * along;
                }
                for (value, direction) in own.iter_mut().zip(&frame.directions) {
                    *value = direction.shift.dot(&along) + direction.turn.dot(&about);
                }
            }
            let mut row = sized(&row);
            let size = norm(&row);
            reduce(&mut row, &basis) > 10.0 * ROUND_OFF * size
        })
    }

    /// Whether a force or its derivatives change in displaced axes; forces on what is held do not count.
    fn is_force_changed(&self, index: usize, by: &Displacement, before: &Acting, after: &Acting) -> bool {
        let matrix = matrix(&by.rotation());
        let markers: Vec<&Marker> = self.links.forces[index]
            .markers
            .iter()
            .map(|&m| &self.links.markers[m])
            .collect();
        let movable: Vec<bool> = markers
            .iter()
            .map(|marker| {
                let components = self.marker_components(marker);
                components
                    .into_iter()
                    .any(|component| self.layout.unknowns_at(component).next().is_some())
            })
            .collect();
        let turned = |place: usize, vector: Vector| {
            let marker = markers[place];
            let is_turned =
                by.moved[self.marker_frame(marker)] && !by.is_own && !matches!(marker, Marker::Angle { .. });
            if is_turned { matrix * vector } else { vector }
        };
        let count = markers.len();
        // What is 0 at the state, as of a spring without force, is round-off of its derivatives.
        let frames = self.buffers.frames.iter();
        let rate = frames.fold(1.0, |rate: f64, frame| rate.max(frame.spin.norm()));
        let length = self
            .tabulated
            .sizes
            .iter()
            .fold(0.0, |length: f64, size| length.max(*size));
        let stiffness = before
            .derivatives
            .iter()
            .zip([1.0, rate])
            .map(|(values, rate)| rate * largest(values));
        let stiffness = stiffness.fold(0.0, f64::max);
        let size = largest(&before.values).max(stiffness * length);
        // Where a force is largest its derivatives are round-off.
        let stiffness = stiffness.max(largest(&before.values) / length.max(f64::MIN_POSITIVE));
        for place in (0..count).filter(|&place| movable[place]) {
            let at = |values: &[f64]| -> Vector { Vector::from_fn(|i, _| values[3 * place + i]) };
            if differ(
                turned(place, at(&before.values)).as_slice(),
                at(&after.values).as_slice(),
                size,
            ) {
                return true;
            }
        }
        let derivatives = before.derivatives.iter().zip(&after.derivatives);
        derivatives.zip([1.0, rate]).any(|((before, after), rate)| {
            let size = stiffness / rate;
            let pairs = (0..count * count).map(|pair| (pair / count, pair % count));
            let mut pairs = pairs.filter(|&(m, n)| movable[m] && movable[n]);
            pairs.any(|(m, n)| {
                let block = |values: &[f64]| Matrix::from_fn(|i, j| values[(3 * m + i) * 3 * count + 3 * n + j]);
                // Rows turn with marker n, then columns with marker m.
                let (before, after) = (block(before), block(after));
                let rows = [0, 1, 2].map(|i| turned(n, before.row(i).transpose()).transpose());
                let rows = Matrix::from_rows(&rows);
                let column = |j: usize| turned(m, rows.column(j).into());
                (0..3).any(|j| differ(column(j).as_slice(), after.column(j).as_slice(), size))
            })
        })
    }
}
