//! Derivatives of inertia forces at the level of nodal vectors (THEORY 2.1), as parts of a matrix
//! `mass M + damping C + stiffness K`.
//!
//! With unknown i of a free frame shifting the origin by s_i and turning the frame by t_i (frame axes), and for
//! every vector a `u_ia = d_a s_i + t_i x Mq_a`:
//!
//! ```text
//! frame row i by q''_a, q'_a, q_a:    u_ia,   2 u_ia x w,   G^T u_ia - t_i x R_a
//! row a by a unknown's derivatives:   u_ia,   2 t_i x Mq'_a + t_i x (w x Mq_a) + w x (t_i x Mq_a),   d_a e x t_i
//! ```

use crate::scene::bodies::nodal_mass::padded;
use crate::scene::pieces::border::Border;
use crate::scene::pieces::combination::Combination;
use pulp::Arch;

use crate::linalg::{Vectorised, dispatch};
use crate::scene::bodies::nodal_mass::{Columns, NodalMass, Padded, Total, Transport, add_scaled, spread, vector};
use crate::scene::frames::free_frames::SPATIAL;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::buffers::Buffers;
use crate::space::{Matrix, Vector};

/// Most unknowns of a frame.
const MOST_UNKNOWNS: usize = 6;

/// One unknown of a frame as seen from the frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    /// Shift of the origin as a row.
    shift: Vector,
    /// Turn of the frame as a row.
    turn: Vector,
    /// Shift and turn by the unknown's derivatives in time.
    rate: [Vector; 2],
    /// Change of e = A^T (r'' - g) by the unknown.
    change: Vector,
}

/// Sums over the vectors that a free frame carries.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    mass: f64,
    /// Dq = d^a q_a
    moment: Vector,
    /// d^a q'_a
    moment_rate: Vector,
    /// J = -sum [q_a][Mq_a]
    inertia: Matrix,
    /// -2 sum [q_a][Mq'_a]
    inertia_rate: Matrix,
    /// sum c_a R_a
    force: Vector,
}

/// `sum -= factor [a][b]`, where `[a][b] = b a^T - (a.b) I`.
#[inline(always)]
fn subtract_product(sum: &mut Matrix, factor: f64, a: Vector, b: Vector) {
    let inner = a.dot(&b);
    for i in 0..3 {
        for j in 0..3 {
            sum[(i, j)] -= factor * (b[i] * a[j] - if i == j { inner } else { 0.0 });
        }
    }
}

/// What one unknown of a frame makes with a vector: rows of the frame by the vector, and the reverse.
#[derive(Clone, Copy)]
struct Arms {
    turns: bool,
    lower_by_first: Padded,
    lower_by_mass: Columns,
    lower_by_force: Columns,
    upper_by_first: Padded,
    upper_by_mass: Columns,
    upper_by_rate: Columns,
}

fn sum(terms: &[(f64, &Matrix)]) -> Matrix {
    Matrix::from_fn(|i, j| terms.iter().map(|(factor, matrix)| factor * matrix[(i, j)]).sum())
}

impl Arms {
    fn new(unknown: &Seen, [b, g, k]: [f64; 3], transport: &Transport) -> Self {
        let (w, unit) = (transport.spin.cross_matrix(), Matrix::identity());
        let (coriolis, turning) = (transport.coriolis(), transport.turning());
        // Transposes: 2 u x w = (2 [w])^T u.
        let by_u = sum(&[(b, &unit), (g, &coriolis), (k, &turning)]);
        let by_u = by_u.transpose();
        let (turn, rate) = (unknown.turn.cross_matrix(), unknown.rate[1].cross_matrix());
        let swing = sum(&[(1.0, &(rate * w)), (1.0, &(w * rate))]);
        Self {
            turns: unknown.turn != Vector::zeros(),
            lower_by_first: padded(by_u * unknown.shift),
            lower_by_mass: Columns::new(&(by_u * turn)),
            lower_by_force: Columns::new(&sum(&[(-k, &turn)])),
            upper_by_first: padded(b * unknown.rate[0] + k * unknown.change),
            upper_by_mass: Columns::new(&sum(&[(b, &rate), (g, &swing)])),
            upper_by_rate: Columns::new(&sum(&[(2.0 * g, &rate)])),
        }
    }

    /// Frame row by the vector, and the vector's rows by the unknown.
    #[inline(always)]
    fn beside(&self, first: f64, [mq, mv, force]: &[Padded; 3]) -> [Padded; 2] {
        let [mut lower, mut upper] = [[0.0; 4]; 2];
        if first != 0.0 {
            add_scaled(&mut lower, first, &self.lower_by_first);
            add_scaled(&mut upper, first, &self.upper_by_first);
        }
        if self.turns {
            self.lower_by_mass.add_product(mq, &mut lower);
            self.lower_by_force.add_product(force, &mut lower);
            self.upper_by_mass.add_product(mq, &mut upper);
            self.upper_by_rate.add_product(mv, &mut upper);
        }
        [lower, upper]
    }
}

/// Adds what the vectors of one body make beside its frame.
struct Beside<'a> {
    mass: &'a NodalMass,
    axes: &'a [usize],
    arms: &'a [Arms],
    border: &'a Border,
    /// Places, velocities and accelerations of the vectors.
    at: &'a [[Padded; 3]],
    sums: &'a mut Sums,
    values: &'a mut [f64],
}

impl Vectorised for Beside<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let (count, mut beside) = (self.arms.len(), [[[0.0; 4]; 2]; MOST_UNKNOWNS]);
        for place in 0..self.mass.vectors() {
            let products = self.mass.product(place, self.at);
            let d = self.mass.first(place);
            self.sums
                .add(d, self.mass.is_position(place), &self.at[place], &products);
            for (both, arms) in beside.iter_mut().zip(self.arms) {
                *both = arms.beside(d, &products);
            }
            for (c, &axis) in self.axes.iter().enumerate() {
                let component = place * self.axes.len() + c;
                self.border.add(component, axis, &beside[..count], self.values);
            }
            let own = place * self.axes.len()..(place + 1) * self.axes.len();
            for (after, component) in self.border.doubled.iter().enumerate() {
                if own.contains(component) {
                    let axis = self.axes[component - own.start];
                    let entry = self.mass.vectors() * self.axes.len() + after;
                    self.border.add(entry, axis, &beside[..count], self.values);
                }
            }
        }
    }
}

impl MeshScene {
    /// Looks up the places of a body's components beside its free frame.
    pub(crate) fn border_of(&self, body: usize) -> Border {
        let body = &self.bodies[body];
        let mut border = Border::default();
        let Some(free) = self.frames.free_of[body.frame] else {
            return border;
        };
        let frame = &self.frames.free[free];
        let first = self.layout.offset(body.first_vector);
        let count = body.spec.vectors() * body.spec.dimension();
        let unknown = self.first_unknown(free);
        let width = frame.count();
        let (dependences, doubled) = self.layout.dependences(first..first + count);
        border.doubled = doubled;
        for own in dependences {
            // The rows of all frames are at the end of a column, and those of one frame are all there.
            let lower = own.and_then(|(row, _)| self.tabulated.pattern.find(unknown, row));
            let upper = (0..width).map(|i| own.and_then(|(row, _)| self.tabulated.pattern.find(row, unknown + i)));
            let upper: Option<Vec<usize>> = upper.collect();
            let (factor, lower, upper) = match (own, lower, upper) {
                (Some((_, factor)), Some(lower), Some(upper)) => (factor, lower, upper),
                _ => (0.0, 0, vec![0; width]),
            };
            border.factors.push(factor);
            border.lower.push(lower as u32);
            border.upper.extend(upper.into_iter().map(|place| place as u32));
        }
        border
    }

    /// First unknown of a free frame.
    pub(crate) fn first_unknown(&self, free: usize) -> usize {
        self.layout.unknowns() - self.layout.border() + self.frames.free[free].first
    }

    /// The unknowns of a free frame as seen from it, at the loaded state.
    fn seen(&self, free: usize, gravity: Vector, maps: &[Matrix]) -> Vec<Seen> {
        let frame = &self.frames.free[free];
        let motion = &self.buffers.frames[frame.spec.frame];
        let e = motion.felt(gravity);
        let field = |place: usize| {
            let changes = self.buffers.field_changes.get(free);
            changes.map_or(Vector::zeros(), |changes| motion.direction_to_frame(changes[place]))
        };
        let mut seen: Vec<Seen> = frame
            .directions
            .iter()
            .enumerate()
            .map(|(place, direction)| {
                let shift = motion.direction_to_frame(direction.shift);
                Seen {
                    shift,
                    turn: direction.turn,
                    rate: [shift, direction.turn],
                    change: e.cross(&direction.turn) - field(place),
                }
            })
            .collect();
        if let Some(map) = frame.turn.and_then(|turn| maps.get(turn)) {
            // The three turns are about the axes.
            let first = frame.shifts();
            for (j, unknown) in seen[first..].iter_mut().enumerate() {
                unknown.rate[1] = Vector::from_fn(|l, _| map[(l, j)]);
            }
        }
        seen
    }

    /// Adds what the inertia of elements, fixtures and rigid parts makes in the rows and columns of free frames, at the
    /// loaded state.
    pub(crate) fn add_inertia_borders(&mut self, gravity: Vector, combination: &Combination, values: &mut [f64]) {
        let rigid = self.frames.free.iter().map(|frame| {
            let (rigid, motion) = (&frame.spec.rigid, &self.buffers.frames[frame.spec.frame]);
            Sums {
                mass: rigid.mass,
                moment: rigid.moment,
                inertia: rigid.inertia,
                force: Transport::new(motion, SPATIAL, gravity).of_rigid(rigid)[0],
                ..Sums::default()
            }
        });
        let mut carried: Vec<Sums> = rigid.collect();
        let seen: Vec<Vec<Seen>> = (0..self.frames.free.len())
            .map(|free| self.seen(free, gravity, &combination.maps))
            .collect();
        let Buffers {
            q,
            v,
            a,
            frames,
            nodal_rates: scratch,
            ..
        } = &mut self.buffers;
        for (body, border) in self.bodies.iter().zip(&self.tabulated.borders) {
            let mass = body.nodal_mass(self.in_modes);
            let Some(free) = self.frames.free_of[body.frame].filter(|_| !mass.is_empty()) else {
                continue;
            };
            let axes = body.spec.axes;
            let transport = Transport::new(&frames[body.frame], axes, gravity);
            let total = Total::new(&transport);
            let arms: Vec<Arms> = seen[free]
                .iter()
                .map(|unknown| Arms::new(unknown, combination.factors, &transport))
                .collect();
            let first = self.layout.offset(body.first_vector);
            scratch.clear();
            scratch.extend((0..mass.vectors()).map(|place| {
                let [q, v, a] = [&*q, &*v, &*a].map(|values| spread(axes, &values[first..], place));
                [q, v, total.acceleration(mass.is_position(place), [&q, &v, &a])]
            }));
            let beside = Beside {
                mass,
                axes,
                arms: &arms,
                border,
                at: scratch,
                sums: &mut carried[free],
                values,
            };
            dispatch(Arch::new(), beside);
        }
        for (free, sums) in carried.iter().enumerate() {
            let motion = &self.buffers.frames[self.frames.free[free].spec.frame];
            let transport = Transport::new(motion, SPATIAL, gravity);
            self.add_square(free, &seen[free], &transport, sums, combination.factors, values);
        }
    }

    /// Adds what is carried makes among the unknowns of a frame.
    fn add_square(
        &self,
        free: usize,
        seen: &[Seen],
        transport: &Transport,
        sums: &Sums,
        [b, g, k]: [f64; 3],
        values: &mut [f64],
    ) {
        let first = self.first_unknown(free);
        for (j, column) in seen.iter().enumerate() {
            // The rows of all frames are at the end of the column and dense.
            let Some(start) = self.tabulated.pattern.find(first, first + j) else {
                continue;
            };
            let by_rate = sums.by_acceleration(column.rate);
            let by_spin = sums.by_spin(transport, column.rate[1]);
            let by_pose = sums.by_acceleration([column.change, Vector::zeros()]);
            // The row of the force turns with the frame: d(A F) = A (dF + dpi x F).
            let turned = column.turn.cross(&sums.force);
            for (i, row) in seen.iter().enumerate() {
                let along = |[force, moment]: [Vector; 2]| row.shift.dot(&force) + row.turn.dot(&moment);
                values[start + i] +=
                    b * along(by_rate) + g * along(by_spin) + k * (along(by_pose) + row.shift.dot(&turned));
            }
        }
    }
}

impl Sums {
    /// Adds one vector: its place, velocity, `M^ab` times these, and its force.
    #[inline(always)]
    fn add(&mut self, first: f64, is_position: bool, [q, v, _]: &[Padded; 3], [mq, mv, force]: &[Padded; 3]) {
        let q = vector(*q);
        if first != 0.0 {
            self.moment += first * q;
            self.moment_rate += first * vector(*v);
        }
        subtract_product(&mut self.inertia, 1.0, q, vector(*mq));
        subtract_product(&mut self.inertia_rate, 2.0, q, vector(*mv));
        if is_position {
            self.mass += first;
            self.force += vector(*force);
        }
    }

    /// Force and moment by an acceleration of the origin and an angular acceleration.
    fn by_acceleration(&self, [e, rate]: [Vector; 2]) -> [Vector; 2] {
        [
            self.mass * e - self.moment.cross(&rate),
            self.moment.cross(&e) + self.inertia * rate,
        ]
    }

    /// Force and moment by a change y of the angular velocity w.
    fn by_spin(&self, transport: &Transport, y: Vector) -> [Vector; 2] {
        let w = transport.spin;
        let turned = y.cross(&w.cross(&self.moment)) + w.cross(&y.cross(&self.moment));
        let gyroscopic = w.cross(&(self.inertia * y)) - (self.inertia * w).cross(&y);
        [
            turned - 2.0 * self.moment_rate.cross(&y),
            self.inertia_rate * y + gyroscopic,
        ]
    }
}
