//! Motions of free frames that change nothing in an equilibrium: turning about the axis of the rotation
//! and shifting along it, turning about the own axis of a symmetric rigid body. Each is told from
//! what acts on the frames, at the loaded state.

use crate::emitted::LoadKind;
use crate::linalg::{normalise, reduce};
use crate::model::{Spin, Uniform};
use crate::scene::MeshScene;
use crate::scene::pieces::displacement::Displacement;
use crate::scene::pieces::marker::Marker;
use crate::scene::turning::symmetry::Undisplaced;
use crate::space::{Vector, exp, matrix, perpendicular};
use crate::system::{State, System};

/// Angles that a turning is tried with, rad.
const ANGLES: [f64; 3] = [0.7, 2.1, 4.4];
/// Shifts that are tried, as parts of the size of a frame.
const SHIFTS: [f64; 2] = [0.31, -0.83];
/// Relative size of a change, or of what is new in a motion, that counts as nothing.
const NEGLIGIBLE: f64 = 1e-8;

/// Relative rate of a constraint along a motion that it holds.
const HELD: f64 = 1e-6;

/// A motion of some frames, as a unit velocity field.
#[derive(Clone, Copy, Debug)]
enum Screw {
    Turn { axis: Vector, point: Vector },
    Shift { along: Vector },
}

/// A row of a constraint by its unknowns, in the sizes of these.
type Row = Vec<(usize, f64)>;

/// Whether constraints do not let a motion be.
fn hold(rows: &[Row], direction: &[f64]) -> bool {
    let largest = largest(direction.iter());
    rows.iter().any(|row| {
        let rate: f64 = row.iter().map(|&(unknown, value)| value * direction[unknown]).sum();
        rate.abs() > HELD * largest * self::largest(row.iter().map(|(_, value)| value))
    })
}

fn largest<'v>(values: impl Iterator<Item = &'v f64>) -> f64 {
    values.fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

fn unit(axis: usize) -> Vector {
    Vector::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 })
}

impl Screw {
    fn displacements(self, moved: &[bool], is_own: bool, size: f64) -> Vec<Displacement> {
        let still = Displacement {
            moved: moved.to_vec(),
            turn: Vector::zeros(),
            point: Vector::zeros(),
            shift: Vector::zeros(),
            is_own,
            later: None,
        };
        match self {
            Screw::Turn { axis, point } => ANGLES
                .map(|angle| Displacement {
                    turn: angle * axis,
                    point,
                    ..still.clone()
                })
                .to_vec(),
            Screw::Shift { along } => SHIFTS
                .map(|part| Displacement {
                    shift: part * size * along,
                    ..still.clone()
                })
                .to_vec(),
        }
    }
}

impl MeshScene {
    /// Directions of the unknowns that change nothing in the uniform motion at the state.
    pub(crate) fn neutral(&mut self, at: &Uniform, state: &State) -> Vec<Vec<f64>> {
        let mut found: Vec<Vec<f64>> = Vec::new();
        if self.frames.free.is_empty() {
            return found;
        }
        self.load_uniform(at, state);
        // What turns keeps its symmetry at every part of the spin.
        let Ok(spin) = self.rotation(at) else { return found };
        for frames in self.groups() {
            let mut moved = vec![false; self.buffers.frames.len()];
            for &free in &frames {
                moved[self.frames.free[free].spec.frame] = true;
            }
            let before = self.undisplaced(at.t, &moved, None);
            let rows = self.constraint_rows(&before);
            for screw in self.screws(&spin, &frames, at.t) {
                self.try_screw(at, screw, (&moved, &before, &rows), false, &mut found);
            }
        }
        for free in 0..self.frames.free.len() {
            let screws = self.own_screws(free);
            if screws.is_empty() {
                continue;
            }
            let mut moved = vec![false; self.buffers.frames.len()];
            moved[self.frames.free[free].spec.frame] = true;
            let before = self.undisplaced(at.t, &moved, None);
            for screw in screws {
                self.try_screw(at, screw, (&moved, &before, &[]), true, &mut found);
            }
        }
        let sizes = &self.tabulated.sizes;
        found
            .iter()
            .map(|motion| motion.iter().zip(sizes).map(|(x, size)| x * size).collect())
            .collect()
    }

    /// Shifts of each group across the axis of the rotation, in the unknowns.
    pub(crate) fn across(&mut self, at: &Uniform, state: &State) -> Vec<[Vec<f64>; 2]> {
        let velocity = at.speed() * self.rotation(at).unwrap_or_default().velocity;
        if self.frames.free.is_empty() || velocity == Vector::zeros() {
            return Vec::new();
        }
        let axis = velocity.normalize();
        let first = perpendicular(axis);
        self.load_uniform(at, state);
        let sizes = &self.tabulated.sizes;
        let shifts = self.groups().into_iter().map(|frames| {
            let mut moved = vec![false; self.buffers.frames.len()];
            frames
                .iter()
                .for_each(|&free| moved[self.frames.free[free].spec.frame] = true);
            [first, axis.cross(&first)].map(|along| {
                let relative = self.direction(Screw::Shift { along }, &moved);
                relative.iter().zip(sizes).map(|(x, size)| x * size).collect()
            })
        });
        shifts.collect()
    }

    /// Keeps the direction of a motion of the moved frames, relative to the sizes of the unknowns, if it is new and changes
    /// nothing of what acts on them; the rows of their constraints refuse most.
    fn try_screw(
        &mut self,
        at: &Uniform,
        screw: Screw,
        (moved, before, rows): (&[bool], &Undisplaced, &[Row]),
        is_own: bool,
        found: &mut Vec<Vec<f64>>,
    ) {
        let mut direction = self.direction(screw, moved);
        let whole: f64 = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
        if whole == 0.0 || !whole.is_finite() || hold(rows, &direction) {
            return;
        }
        if reduce(&mut direction, found) < 1e-6 * whole {
            return;
        }
        let size = self.largest_length();
        for displacement in screw.displacements(moved, is_own, size) {
            let is_free = (is_own || !self.is_pulled(at, &displacement))
                && self.changed_from(before, at.t, &displacement).is_none()
                && self.follows(&displacement);
            if !is_free {
                return;
            }
        }
        normalise(&mut direction);
        found.push(direction);
    }

    /// Groups of free frames that act on each other.
    fn groups(&self) -> Vec<Vec<usize>> {
        let mut group: Vec<usize> = (0..self.frames.free.len()).collect();
        let constraints = self.links.constraints.iter().map(|linked| linked.spec.markers);
        for markers in constraints.chain(self.links.forces.iter().map(|force| &force.markers[..])) {
            let frames = markers
                .iter()
                .map(|&marker| self.marker_frame(&self.links.markers[marker]));
            self.join(frames, &mut group);
        }
        for marked in &self.links.marked_loads {
            let frames = [
                self.marker_frame(&marked.markers[0]),
                self.dead_loads.specs[marked.load].frame,
            ];
            self.join(frames.into_iter(), &mut group);
        }
        let firsts = (0..group.len()).filter(|&free| group[free] == free);
        firsts
            .map(|first| (0..group.len()).filter(|&free| group[free] == first).collect())
            .collect()
    }

    fn join(&self, frames: impl Iterator<Item = usize>, group: &mut [usize]) {
        let free: Vec<usize> = frames
            .filter_map(|frame| self.frames.free_of[frame])
            .map(|free| group[free])
            .collect();
        if let Some(&first) = free.iter().min() {
            for label in group.iter_mut().filter(|label| free.contains(label)) {
                *label = first;
            }
        }
    }

    /// Motions of a group as a whole that may be neutral.
    fn screws(&self, spin: &Spin, group: &[usize], t: f64) -> Vec<Screw> {
        let speed = spin.velocity.norm();
        if speed > 0.0 {
            let axis = 1.0 / speed * spin.velocity;
            let point = spin.point;
            return vec![Screw::Turn { axis, point }, Screw::Shift { along: axis }];
        }
        let mut screws: Vec<Screw> = (0..3).map(|axis| Screw::Shift { along: unit(axis) }).collect();
        let (mut points, mut axes) = (Vec::new(), Vec::new());
        let gravity = self.gravity(t);
        if gravity.norm() > 0.0 {
            axes.push(1.0 / gravity.norm() * gravity);
        }
        axes.extend((0..3).map(unit));
        let frames: Vec<usize> = group.iter().map(|&free| self.frames.free[free].spec.frame).collect();
        let constraints = self.links.constraints.iter().map(|linked| linked.spec.markers);
        for markers in constraints.chain(self.links.forces.iter().map(|force| &force.markers[..])) {
            let markers = markers.iter().map(|&marker| &self.links.markers[marker]);
            if !markers
                .clone()
                .any(|marker| frames.contains(&self.marker_frame(marker)))
            {
                continue;
            }
            for marker in markers.filter(|marker| self.frames.free_of[self.marker_frame(marker)].is_none()) {
                let value = self.jet(marker)[0];
                match marker {
                    _ if marker.is_point() => points.push(value),
                    Marker::Fixed { .. } if value.norm() > 0.0 => axes.push(1.0 / value.norm() * value),
                    _ => {}
                }
            }
        }
        points.push(self.buffers.frames[frames[0]].position);
        for point in distinct(points) {
            let axes = distinct(axes.clone());
            screws.extend(axes.into_iter().map(|axis| Screw::Turn { axis, point }));
        }
        screws
    }

    /// Turning of a rigid body about its own axes of symmetry.
    fn own_screws(&self, free: usize) -> Vec<Screw> {
        let frame = &self.frames.free[free];
        let carries = self.bodies.iter().any(|body| body.spec.frame == frame.spec.frame);
        if carries || frame.turn.is_none() {
            return Vec::new();
        }
        let motion = &self.buffers.frames[frame.spec.frame];
        let rigid = &frame.spec.rigid;
        let size = rigid.inertia.amax();
        let is_symmetric = |axis: &Vector| {
            let turn = matrix(&exp(ANGLES[0] * *axis));
            let turned = (turn.transpose() * rigid.inertia) * turn;
            let same = (turned - rigid.inertia).amax() <= NEGLIGIBLE * size;
            same && axis.cross(&rigid.moment).norm() <= NEGLIGIBLE * rigid.moment.norm()
        };
        let axes = (0..3).map(unit).filter(is_symmetric);
        axes.map(|axis| Screw::Turn {
            axis: motion.direction_to_inertial(axis),
            point: motion.position,
        })
        .collect()
    }

    /// Whether loads of the scene make a difference between the places before and after.
    fn is_pulled(&mut self, at: &Uniform, displacement: &Displacement) -> bool {
        let matrix = matrix(&exp(displacement.turn));
        let differs = |expected: Vector, after: Vector| (expected - after).norm() > NEGLIGIBLE * expected.norm();
        let gravity = self.gravity(at.t);
        let mut free = self.frames.free.iter();
        if differs(matrix * gravity, gravity)
            && free.any(|frame| displacement.moved[frame.spec.frame] && self.is_heavy(frame.spec.frame))
        {
            return true;
        }
        let pull = |scene: &Self| -> Vec<(usize, Vector)> {
            let marked = scene.links.marked_loads.iter().map(|marked| {
                let load = &scene.dead_loads.specs[marked.load];
                let value =
                    scene.buffers.frames[load.frame].direction_to_inertial(scene.parts.load(marked.load, at.t).into());
                (scene.marker_frame(&marked.markers[0]), value)
            });
            marked.collect()
        };
        let before = pull(self);
        let frames = self.links.marked_loads.iter();
        let frames = frames.map(|marked| self.dead_loads.specs[marked.load].frame).collect();
        let after = self.displaced(displacement, frames, pull);
        before.into_iter().zip(after).any(|((frame, before), (_, after))| {
            let is_moved = displacement.moved[frame];
            differs(if is_moved { matrix * before } else { before }, after)
        })
    }

    fn is_heavy(&self, frame: usize) -> bool {
        let rigid = self.frames.free_of[frame].is_some_and(|free| self.frames.free[free].has_rigid_parts());
        let gravity = self.dead_loads.specs.iter().any(|load| load.kind == LoadKind::Gravity);
        gravity && (rigid || self.bodies.iter().any(|body| body.spec.frame == frame))
    }

    /// Velocities of the unknowns in a motion of some frames, relative to their sizes.
    fn direction(&self, screw: Screw, moved: &[bool]) -> Vec<f64> {
        let mut result = vec![0.0; self.layout.unknowns()];
        let border = self.layout.unknowns() - self.layout.border();
        for frame in self.frames.free.iter().filter(|frame| moved[frame.spec.frame]) {
            let motion = &self.buffers.frames[frame.spec.frame];
            let (shift, turn) = match screw {
                Screw::Turn { axis, point } => {
                    (axis.cross(&(motion.position - point)), motion.direction_to_frame(axis))
                }
                Screw::Shift { along } => (along, Vector::zeros()),
            };
            for (place, direction) in frame.directions.iter().enumerate() {
                let unknown = border + frame.first + place;
                result[unknown] =
                    (direction.shift.dot(&shift) + direction.turn.dot(&turn)) / self.tabulated.sizes[unknown];
            }
        }
        // Round-off is not a part of the motion.
        let largest = largest(result.iter());
        for value in &mut result {
            if value.abs() <= NEGLIGIBLE * largest {
                *value = 0.0;
            }
        }
        result
    }
}

/// Vectors that are not among those before; opposite ones are different.
fn distinct(vectors: Vec<Vector>) -> Vec<Vector> {
    let mut result: Vec<Vector> = Vec::new();
    for vector in vectors {
        let size = vector.norm().max(f64::MIN_POSITIVE);
        let is_known = |other: &Vector| (vector - other).norm() <= NEGLIGIBLE * size;
        if !result.iter().any(is_known) {
            result.push(vector);
        }
    }
    result
}
