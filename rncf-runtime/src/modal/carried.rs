//! Inertia of modes on the free frames that carry them: forces and moments on the frame, and the blocks between
//! the frame's unknowns and the modal coordinates (THEORY 2.1).

use super::action::CarriedTangent;
use super::body::ModalBody;
use crate::emitted::FrameMotion;
use crate::scene::MeshScene;
use crate::scene::frames::directions::Direction;
use crate::space::Vector;
use crate::system::Tangent;

/// Most rows of force and moment.
const ROWS: usize = 6;

/// The derivatives of what is carried with respect to the unknowns of the frame (k) and q (n), one
/// block after the other: mass ff, fq; damping ff, fq, qf; stiffness ff, fq, qf.
struct Blocks {
    k: usize,
    n: usize,
}

impl Blocks {
    fn width(&self) -> usize {
        3 * self.k * self.k + 5 * self.k * self.n
    }

    /// Start of a block by its place in the order above.
    fn start(&self, block: usize) -> usize {
        let (square, long) = (self.k * self.k, self.k * self.n);
        [
            0,
            square,
            square + long,
            2 * square + long,
            2 * square + 2 * long,
            2 * square + 3 * long,
            3 * square + 3 * long,
            3 * square + 4 * long,
        ][block]
    }
}

/// Derivatives between a free frame's k unknowns and a body's n modal coordinates.
pub(crate) struct Beside {
    /// First unknown of the frame.
    pub first: usize,
    /// Number of its unknowns.
    pub count: usize,
    /// Frame rows by p'', k x n; transposed also p rows by the frame's accelerations.
    pub mass: Vec<f64>,
    /// Frame rows by p' (k x n), then p rows by the frame's velocities (n x k).
    pub damping: [Vec<f64>; 2],
    /// Frame rows by p (k x n), then p rows by the frame's unknowns (n x k).
    pub stiffness: [Vec<f64>; 2],
}

/// Components of a force in the order of the axes, then of a moment (planar: about the normal).
fn rows_of(axes: &[usize], force: Vector, moment: Vector) -> [f64; ROWS] {
    let mut rows = [0.0; ROWS];
    for (place, &axis) in axes.iter().enumerate() {
        rows[place] = force[axis];
    }
    if let [first, second] = *axes {
        rows[2] = moment[3 - first - second];
    } else {
        rows[3..].copy_from_slice(moment.as_slice());
    }
    rows
}

/// The reverse of [`rows_of`]: force and moment, frame axes.
fn vectors_of(axes: &[usize], rows: &[f64; ROWS]) -> [Vector; 2] {
    let [mut force, mut moment] = [Vector::zeros(); 2];
    for (place, &axis) in axes.iter().enumerate() {
        force[axis] = rows[place];
    }
    if let [first, second] = *axes {
        moment[3 - first - second] = rows[2];
    } else {
        moment.copy_from_slice(&rows[3..]);
    }
    [force, moment]
}

/// Number of rows of a force and of a moment.
fn counts(axes: &[usize]) -> (usize, usize) {
    if axes.len() == 2 { (2, 1) } else { (3, 3) }
}

/// One unknown of a frame as seen from the frame.
struct Seen {
    /// Acceleration and angular acceleration by the unknown's own, in rows.
    rate: [f64; ROWS],
    /// Change of the acceleration e = A^T (r'' - g) by the unknown, in rows.
    change: [f64; ROWS],
    shift: Vector,
    turn: Vector,
}

/// `field` is the change of the field on the frame by the unknown, inertial axes.
fn seen(axes: &[usize], frame: &FrameMotion, e: Vector, direction: &Direction, field: Vector) -> Seen {
    let shift = frame.direction_to_frame(direction.shift);
    Seen {
        rate: rows_of(axes, shift, direction.turn),
        change: rows_of(
            axes,
            e.cross(&direction.turn) - frame.direction_to_frame(field),
            Vector::zeros(),
        ),
        shift,
        turn: direction.turn,
    }
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Chains the derivatives in frame axes to the frame's unknowns; `force` is that on the frame.
fn chain(axes: &[usize], unknowns: &[Seen], force: Vector, tangent: &CarriedTangent, blocks: &Blocks, out: &mut [f64]) {
    let (d, s) = counts(axes);
    let (b, k, n) = (d + s, blocks.k, blocks.n);
    let row = |matrix: &[f64], width: usize, weights: &[f64; ROWS], column: usize| -> f64 {
        (0..b).map(|i| weights[i] * matrix[i * width + column]).sum()
    };
    for (i, unknown) in unknowns.iter().enumerate() {
        let weights = &unknown.rate;
        let mut by_motion = [0.0; ROWS];
        for (column, value) in by_motion.iter_mut().enumerate().take(b) {
            *value = row(&tangent.mass, b + n, weights, column);
        }
        let mut by_spin = [0.0; 3];
        for (column, value) in by_spin.iter_mut().enumerate().take(s) {
            *value = row(&tangent.damping, s + n, weights, column);
        }
        for (j, other) in unknowns.iter().enumerate() {
            out[blocks.start(0) + i * k + j] += product(&by_motion[..b], &other.rate);
            out[blocks.start(2) + i * k + j] += product(&by_spin[..s], &other.rate[d..]);
            // The row of the force turns with the frame: d(A F) = A (dF + dpi x F).
            out[blocks.start(5) + i * k + j] +=
                product(&by_motion[..b], &other.change) + unknown.shift.dot(&other.turn.cross(&force));
        }
        for c in 0..n {
            let mass = row(&tangent.mass, b + n, weights, b + c);
            out[blocks.start(1) + i * n + c] += mass;
            out[blocks.start(3) + i * n + c] += row(&tangent.damping, s + n, weights, s + c);
            out[blocks.start(6) + i * n + c] += row(&tangent.stiffness, n, weights, c);
            out[blocks.start(4) + c * k + i] += product(&tangent.spin[c * s..(c + 1) * s], &unknown.rate[d..]);
            out[blocks.start(7) + c * k + i] += row(&tangent.mass, b + n, &unknown.change, b + c);
        }
    }
}

impl MeshScene {
    /// Adds force and moment (rows) on a free frame to the forces of its unknowns.
    pub(crate) fn add_to_frame(&mut self, free: usize, axes: &[usize], rows: &[f64]) {
        let mut padded = [0.0; ROWS];
        padded[..rows.len()].copy_from_slice(rows);
        self.add_to_unknowns(free, vectors_of(axes, &padded));
    }

    /// The unknowns of a free frame as seen from it, at the loaded state.
    fn seen_unknowns(&self, free: usize, axes: &[usize], gravity: Vector) -> Vec<Seen> {
        let frame = &self.frames.free[free];
        let motion = &self.buffers.frames[frame.spec.frame];
        let e = motion.felt(gravity);
        let change = |place: usize| {
            self.buffers
                .field_changes
                .get(free)
                .map_or(Vector::zeros(), |all| all[place])
        };
        let directions = frame.directions.iter().enumerate();
        directions
            .map(|(place, direction)| seen(axes, motion, e, direction, change(place)))
            .collect()
    }

    /// Adds what the inertia of a body's modes makes among the unknowns of its free frame, at the
    /// loaded state with modal coordinates `at`, and returns what it makes beside them.
    pub(crate) fn add_carried_modes(
        &self,
        body: usize,
        modes: &ModalBody,
        at: [&[f64]; 3],
        gravity: Vector,
        out: &mut Tangent,
    ) -> Option<Beside> {
        let body = &self.bodies[body];
        let free = self.frames.free_of[body.frame]?;
        let axes = body.spec.axes;
        let action = self.buffers.frames[body.frame].action(axes, gravity);
        let mut rows = [0.0; ROWS];
        let (d, s) = counts(axes);
        modes.carried(&action, at, &mut rows[..d + s]);
        let mut tangent = CarriedTangent::default();
        modes.carried_tangent(&action, at, &mut tangent);
        let unknowns = self.seen_unknowns(free, axes, gravity);
        let blocks = Blocks {
            k: unknowns.len(),
            n: modes.modes(),
        };
        let mut result = vec![0.0; blocks.width()];
        let [force, _] = vectors_of(axes, &rows);
        chain(axes, &unknowns, force, &tangent, &blocks, &mut result);
        self.scatter_square(free, &blocks, &result, out);
        let block = |place: usize| result[blocks.start(place)..][..blocks.k * blocks.n].to_vec();
        Some(Beside {
            first: self.first_unknown(free),
            count: blocks.k,
            mass: block(1),
            damping: [block(3), block(4)],
            stiffness: [block(6), block(7)],
        })
    }

    fn scatter_square(&self, free: usize, blocks: &Blocks, result: &[f64], out: &mut Tangent) {
        let k = blocks.k;
        let first = self.first_unknown(free);
        for j in 0..k {
            // The rows of all frames are at the end of the column and dense.
            let Some(start) = self.tabulated.pattern.find(first, first + j) else {
                continue;
            };
            for i in 0..k {
                out.mass[start + i] += result[blocks.start(0) + i * k + j];
                out.damping[start + i] += result[blocks.start(2) + i * k + j];
                out.stiffness[start + i] += result[blocks.start(5) + i * k + j];
            }
        }
    }
}
