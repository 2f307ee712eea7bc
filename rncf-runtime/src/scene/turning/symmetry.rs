//! Symmetries of what acts on a scene: whether constraints and forces on markers stay the same when
//! frames are displaced rigidly (THEORY 8.1). Relative equilibria need those of the rotation;
//! motions that change nothing make a stiffness singular.

use crate::linalg::{norm, normalise, reduce};
use crate::scene::MeshScene;
use crate::scene::frames::free_frames::FreeFrame;
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
    /// Of a constraint those of its rows by the components that its markers depend on, of a force those by the values and by
    /// the velocities of its markers.
    derivatives: Vec<Vec<f64>>,
}

/// What acts on some frames before they are displaced.
pub(crate) struct Undisplaced {
    /// With their places among all.
    constraints: Vec<(usize, Acting)>,
    forces: Vec<(usize, Acting)>,
    loads: Vec<(&'static str, Vec<f64>)>,
    /// Which loads time changes, where displacements ask for that.
    timed: Vec<bool>,
}

impl Undisplaced {
    /// What holds, without what acts.
    pub(crate) fn of_constraints(mut self) -> Self {
        self.forces.clear();
        self.timed.fill(false);
        self
    }
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
                let turns = frame.turns() || carries;
                let size = (motion.position - displacement.point).norm() + step.norm() + f64::MIN_POSITIVE;
                left.norm() <= ROUND_OFF * size && (!turns || untold.norm() <= ROUND_OFF * turn.norm())
            })
    }

    /// The first constraint or force on markers, in the user's words, that a displacement changes at the
    /// loaded state, which is left as it was.
    pub(crate) fn changed_by(&mut self, t: f64, displacement: &Displacement) -> Option<String> {
        let before = self.undisplaced(t, &displacement.moved, displacement.later);
        self.changed_from(&before, t, displacement)
    }

    /// What acts on the moved frames at the loaded state, as far as displacements look at it meanwhile `later`.
    pub(crate) fn undisplaced(&self, t: f64, moved: &[bool], later: Option<f64>) -> Undisplaced {
        let touches = |markers: &[usize]| {
            let mut frames = markers
                .iter()
                .map(|&marker| self.marker_frame(&self.links.markers[marker]));
            frames.any(|frame| moved[frame])
        };
        let is_looked_at = |acting: &dyn Fn(f64) -> Acting| {
            later.is_none_or(|later| (later != 0.0) == (acting(t).values != acting(t + A_WHILE).values))
        };
        let constraints = (0..self.links.constraints.len())
            .filter(|&index| touches(self.links.constraints[index].spec.markers))
            .filter(|&index| is_looked_at(&|t| self.constraining(index, t)))
            .map(|index| (index, self.constraining(index, t)));
        let forces = (0..self.links.forces.len())
            .filter(|&index| touches(&self.links.forces[index].markers))
            .filter(|&index| is_looked_at(&|t| self.forcing(index, t)))
            .map(|index| (index, self.forcing(index, t)));
        Undisplaced {
            constraints: constraints.collect(),
            forces: forces.collect(),
            loads: self.marked_values(t),
            timed: later.map_or_else(Vec::new, |_| self.timed_values(t)),
        }
    }

    /// Parts of a row by components as parts by unknowns, in the sizes of these.
    fn by_unknowns<'a>(&'a self, components: &'a [usize], row: &'a [f64]) -> impl Iterator<Item = (usize, f64)> + 'a {
        components.iter().zip(row).flat_map(move |(&component, &value)| {
            let unknowns = self.layout.unknowns_at(component);
            unknowns.map(move |(unknown, factor)| (unknown, factor * value * self.tabulated.sizes[unknown]))
        })
    }

    /// Rows of the constraints by the unknowns that they depend on, in the sizes of these.
    pub(crate) fn constraint_rows(&self, before: &Undisplaced) -> Vec<Vec<(usize, f64)>> {
        let of = |(index, acting): &(usize, Acting)| {
            let components = self.constrained(*index);
            let rows = acting.derivatives.iter();
            rows.map(|row| self.by_unknowns(&components, row).collect())
                .collect::<Vec<_>>()
        };
        before.constraints.iter().flat_map(of).collect()
    }

    /// [`MeshScene::changed_by`] of what acts on the frames that are moved.
    pub(crate) fn changed_from(&mut self, before: &Undisplaced, t: f64, displacement: &Displacement) -> Option<String> {
        self.changes(before, t, displacement, 1).pop()
    }

    /// The first `count` that a displacement changes: constraints, each looked at beside its own frames, then forces and loads.
    pub(crate) fn changes(
        &mut self,
        before: &Undisplaced,
        t: f64,
        displacement: &Displacement,
        count: usize,
    ) -> Vec<String> {
        let later = t + displacement.later.unwrap_or(0.0);
        let mut names = Vec::new();
        for (index, before) in &before.constraints {
            if names.len() == count {
                return names;
            }
            let frames = self.of_markers(&self.links.constraints[*index], |marker| self.marker_frame(marker));
            let is_changed = self.displaced(displacement, frames, |scene| {
                scene.is_constraint_changed(*index, displacement, before, &scene.constraining(*index, later))
            });
            if is_changed {
                let spec = &self.links.constraints[*index].spec;
                names.push(match spec.kind {
                    "constraint" => format!("constraint `{}`", spec.name),
                    kind => format!("joint `{}` ({kind})", spec.name),
                });
            }
        }
        if names.len() == count {
            return names;
        }
        let all = (0..self.buffers.frames.len()).collect();
        let acting = self.displaced(displacement, all, |scene| {
            let is_changed = |(index, before): &&(usize, Acting)| {
                scene.is_force_changed(*index, displacement, before, &scene.forcing(*index, later))
            };
            let forces = before.forces.iter().filter(is_changed);
            let mut acting: Vec<String> = forces
                .map(|(index, _)| scene.told_of_force(*index))
                .take(count - names.len())
                .collect();
            if acting.len() + names.len() < count {
                acting.extend(scene.changed_loads(t, displacement, &before.loads, &before.timed));
            }
            acting
        });
        names.extend(acting);
        names.truncate(count);
        names
    }

    /// What is seen of the loaded state while some frames are displaced, as far as they are moved.
    pub(crate) fn displaced<T>(
        &mut self,
        by: &Displacement,
        mut frames: Vec<usize>,
        see: impl FnOnce(&Self) -> T,
    ) -> T {
        frames.sort_unstable();
        frames.dedup();
        frames.retain(|&frame| by.moved[frame]);
        let kept: Vec<_> = frames
            .iter()
            .map(|&frame| {
                let angle = self.angle_of(frame);
                (
                    self.buffers.frames[frame],
                    angle.map(|(angle, _)| (angle, self.buffers.q[angle])),
                )
            })
            .collect();
        frames.iter().for_each(|&frame| self.displace(frame, by));
        let seen = see(self);
        for (frame, (motion, angle)) in frames.into_iter().zip(kept) {
            self.buffers.frames[frame] = motion;
            if let Some((angle, value)) = angle {
                self.buffers.q[angle] = value;
            }
        }
        seen
    }

    /// Displaces a loaded frame.
    fn displace(&mut self, index: usize, by: &Displacement) {
        if let Some((angle, axis)) = self.angle_of(index) {
            self.buffers.q[angle] += axis.dot(&by.turn);
        }
        let free = self.frames.free_of[index].map(|free| &self.frames.free[free]);
        let turns = free.is_none_or(FreeFrame::turns);
        let frame = &mut self.buffers.frames[index];
        *frame = by.displaced(frame, turns);
    }

    /// Where among the components the angle of a loaded frame stands, if it has one, and its axis, inertial axes.
    fn angle_of(&self, frame: usize) -> Option<(usize, Vector)> {
        let free = &self.frames.free[self.frames.free_of[frame]?];
        let place = free.angle()?;
        let axis = self.buffers.frames[frame].direction_to_inertial(free.directions[place].turn);
        Some((self.layout.vector_components() + free.first + place, axis))
    }

    /// Components that a constraint depends on, in ascending order.
    fn constrained(&self, index: usize) -> Vec<usize> {
        let linked = &self.links.constraints[index];
        let of_markers = self.of_markers(linked, |marker| self.marker_components(marker));
        let mut components = of_markers.concat();
        components.sort_unstable();
        components.dedup();
        components
    }

    /// Rows of a constraint, and their derivatives by the components that it depends on.
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
        let components = self.constrained(index);
        let columns = self.of_markers(linked, |marker| self.columns(marker));
        let derivatives = gradient.chunks_exact(width).map(|gradient| {
            let mut row = vec![0.0; components.len()];
            for (place, columns) in columns.iter().enumerate() {
                let pull = Vector::from_fn(|i, _| gradient[3 * place + i]);
                for column in columns {
                    let own = components.binary_search(&column.component);
                    row[own.expect("a marker depends on its components")] += pull.dot(&column.value);
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
    fn is_constraint_changed(&self, index: usize, by: &Displacement, before: &Acting, after: &Acting) -> bool {
        let back = matrix(&by.rotation().inverse());
        let border = self.layout.vector_components();
        let components = self.constrained(index);
        let unknowns = self.unknowns_of(components.iter().copied());
        let sized = |row: &[f64]| -> Vec<f64> {
            let mut result = vec![0.0; unknowns.len()];
            for (unknown, value) in self.by_unknowns(&components, row) {
                let own = unknowns.binary_search(&unknown);
                result[own.expect("of these components")] += value;
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
        let mut frames = self.of_markers(&self.links.constraints[index], |marker| self.marker_frame(marker));
        frames.sort_unstable();
        frames.dedup();
        let moved = frames.into_iter().filter(|&frame| by.moved[frame]);
        let moved = moved.filter_map(|frame| self.frames.free_of[frame]);
        let frames: Vec<_> = moved
            .map(|free| {
                let frame = &self.frames.free[free];
                // All components of a frame, or its angle alone.
                let own = |place| components.binary_search(&(border + frame.first + place)).ok();
                (frame, (0..frame.count()).map(own).collect::<Vec<_>>())
            })
            .collect();
        after.derivatives.iter().any(|row| {
            let mut row = row.clone();
            for (frame, places) in &frames {
                let (mut along, mut about) = (Vector::zeros(), Vector::zeros());
                let present = || places.iter().zip(&frame.directions);
                for (place, direction) in present() {
                    let value = place.map_or(0.0, |place| row[place]);
                    along += value * direction.shift;
                    about += value * direction.turn;
                }
                if by.is_own {
                    let motion = &self.buffers.frames[frame.spec.frame];
                    let within = motion.direction_to_frame(by.turn);
                    about = matrix(&exp(within)) * about;
                } else {
                    along = back * along;
                }
                for (place, direction) in present() {
                    if let Some(place) = *place {
                        row[place] = direction.shift.dot(&along) + direction.turn.dot(&about);
                    }
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
