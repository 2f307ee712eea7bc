//! Inertia at the level of nodal vectors (THEORY 2). The mass matrix M^ab of a body's nodal vectors is constant
//! and couples vectors, not components: inertia forces of all elements and fixtures are one product with it,
//!
//! ```text
//! u_b = q''_b + 2 w x q'_b + w' x q_b + w x (w x q_b) + c_b e,    e = A^T (r'' - g), c_b = 1 on positions
//! R_a = M^ab u_b                                                  inertia part of (13)
//! A^T R_r = sum_a c_a R_a,   R_pi = sum_a q_a x R_a               (11), (12), over all vectors
//! ```
//!
//! The sums run over eliminated vectors, too, and hold before elastic forces are added, which drop out of them.
//! Planar bodies are taken in space, with vectors in their plane.

use pulp::Arch;

use crate::emitted::{BodySpec, Fidelity, FrameMotion, RigidSpec};
use crate::linalg::{Vectorised, dispatch};
use crate::scene::frames::free_frames::SPATIAL;
use crate::scene::mesh_scene::{Buffers, MeshBody, MeshScene};
use crate::vector::{Matrix, Vector, add, apply, cross, dot, multiply, scale, skew};

/// Three components, and one more for the width of the machine.
pub(crate) type Padded = [f64; 4];

/// A vector with a fourth component, zero.
pub(crate) fn padded([x, y, z]: Vector) -> Padded {
    [x, y, z, 0.0]
}

/// The vector without the fourth component.
pub(crate) fn vector([x, y, z, _]: Padded) -> Vector {
    [x, y, z]
}

/// `sum += factor x`
#[inline(always)]
pub(crate) fn add_scaled(sum: &mut Padded, factor: f64, x: &Padded) {
    for (sum, x) in sum.iter_mut().zip(x) {
        *sum += factor * x;
    }
}

/// A matrix by columns.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Columns([Padded; 3]);

impl Columns {
    /// The columns of a matrix with rows first.
    pub fn new(matrix: &Matrix) -> Self {
        Self(std::array::from_fn(|j| {
            padded([matrix[0][j], matrix[1][j], matrix[2][j]])
        }))
    }

    /// `sum += A x`
    #[inline(always)]
    pub fn add_product(&self, x: &Padded, sum: &mut Padded) {
        for (column, &x) in self.0.iter().zip(x) {
            add_scaled(sum, x, column);
        }
    }
}

/// What a frame does to everything in it, in space and frame axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transport {
    /// Acceleration of the origin minus gravity, e = A^T (r'' - g), m/s^2.
    pub e: Vector,
    /// Angular velocity w, rad/s; for planar bodies about the normal of their plane.
    pub spin: Vector,
    /// Angular acceleration w', rad/s^2; for planar bodies about the normal of their plane.
    pub spin_rate: Vector,
}

impl Transport {
    /// Of a frame on a body with these axes, under gravity (m/s^2, inertial axes).
    pub fn new(frame: &FrameMotion, axes: &[usize], gravity: Vector) -> Self {
        let along = |mut vector: Vector| {
            if axes.len() == 2 {
                axes.iter().for_each(|&axis| vector[axis] = 0.0);
            }
            vector
        };
        Self {
            e: frame.felt(gravity),
            spin: along(frame.spin),
            spin_rate: along(frame.spin_rate),
        }
    }

    /// `2 [w]`: acceleration by velocity in the frame.
    pub fn coriolis(&self) -> Matrix {
        skew(scale(2.0, self.spin))
    }

    /// `G = [w'] + [w][w]`: acceleration by place in the frame.
    pub fn turning(&self) -> Matrix {
        let (rate, square) = (skew(self.spin_rate), multiply(&skew(self.spin), &skew(self.spin)));
        std::array::from_fn(|i| std::array::from_fn(|j| rate[i][j] + square[i][j]))
    }

    /// Inertia force and moment of rigid parts on the frame, Eq. (14).
    pub fn of_rigid(&self, rigid: &RigidSpec) -> [Vector; 2] {
        let (w, rate) = (self.spin, self.spin_rate);
        let turning = add(cross(rate, rigid.moment), cross(w, cross(w, rigid.moment)));
        let gyroscopic = cross(w, apply(&rigid.inertia, w));
        [
            add(scale(rigid.mass, self.e), turning),
            add(
                cross(rigid.moment, self.e),
                add(apply(&rigid.inertia, rate), gyroscopic),
            ),
        ]
    }
}

/// Constant mass matrix M^ab of the nodal vectors of one body, its entries other than zero row by row.
#[derive(Clone, Debug, Default)]
pub(crate) struct NodalMass {
    /// Start of every row in `columns` and `values`, and their length at the end.
    starts: Vec<u32>,
    columns: Vec<u32>,
    /// kg for two positions, kg m and kg m^2 with slopes.
    values: Vec<f64>,
    /// First moments d^a = M^ab c_b.
    first: Vec<f64>,
    /// c_a: whether a vector is a position.
    is_position: Vec<bool>,
}

impl NodalMass {
    /// Sum of local matrices (scalars for an element's vectors, rows first) of elements.
    /// `beside`: entries of single vectors, counted in the body.
    pub fn new<'a>(
        spec: &BodySpec,
        parts: impl IntoIterator<Item = (usize, &'a [f64])>,
        beside: impl IntoIterator<Item = ([usize; 2], f64)>,
    ) -> Self {
        let count = spec.nodal.len();
        let mut rows: Vec<Vec<(u32, f64)>> = vec![Vec::new(); spec.vectors()];
        for (element, local) in parts {
            let place = |a: usize| element * spec.stride + spec.connectivity[a];
            for (entry, &value) in local.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                add_entry(&mut rows[place(entry / count)], place(entry % count), value);
            }
        }
        for ([row, column], value) in beside {
            add_entry(&mut rows[row], column, value);
        }
        Self::of_rows(spec, rows)
    }

    /// All mass at the centre of mass, which is linear in the nodal vectors: M^ab = d^a d^b / m.
    pub fn at_centre(&self, spec: &BodySpec) -> Self {
        let counted = (0..self.vectors()).filter(|&vector| self.is_position[vector]);
        let mass: f64 = counted.map(|vector| self.first[vector]).sum();
        let row = |a: usize| {
            let entries = (0..self.vectors()).map(move |b| (b as u32, self.first[a] * self.first[b] / mass));
            entries.filter(|(_, value)| *value != 0.0).collect()
        };
        Self::of_rows(spec, (0..self.vectors()).map(row).collect())
    }

    /// The sum of two masses of one body.
    pub fn plus(&self, other: &Self, spec: &BodySpec) -> Self {
        let mut rows: Vec<Vec<(u32, f64)>> = vec![Vec::new(); spec.vectors()];
        for mass in [self, other] {
            for (row, sums) in rows.iter_mut().enumerate() {
                let own = mass.starts[row] as usize..mass.starts[row + 1] as usize;
                for (&column, &value) in mass.columns[own.clone()].iter().zip(&mass.values[own]) {
                    add_entry(sums, column as usize, value);
                }
            }
        }
        Self::of_rows(spec, rows)
    }

    fn of_rows(spec: &BodySpec, mut rows: Vec<Vec<(u32, f64)>>) -> Self {
        let is_position: Vec<bool> = (0..spec.vectors())
            .map(|vector| spec.nodal[spec.locate(vector).1].is_position())
            .collect();
        let mut mass = Self {
            starts: vec![0],
            is_position,
            ..Self::default()
        };
        for row in &mut rows {
            row.sort_unstable_by_key(|&(column, _)| column);
            let counted = row.iter().filter(|&&(column, _)| mass.is_position[column as usize]);
            mass.first.push(counted.map(|(_, value)| value).sum());
            mass.columns.extend(row.iter().map(|(column, _)| column));
            mass.values.extend(row.iter().map(|(_, value)| value));
            mass.starts.push(mass.columns.len() as u32);
        }
        mass
    }

    /// Whether there is no mass at all.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Number of vectors.
    pub fn vectors(&self) -> usize {
        self.first.len()
    }

    /// First moment d^a of a vector.
    pub fn first(&self, vector: usize) -> f64 {
        self.first[vector]
    }

    /// Whether a vector is a position.
    pub fn is_position(&self, vector: usize) -> bool {
        self.is_position[vector]
    }

    /// `M^ab x_b` of one row for several quantities of every vector.
    #[inline(always)]
    pub fn product<const N: usize>(&self, row: usize, x: &[[Padded; N]]) -> [Padded; N] {
        let mut sums = [[0.0; 4]; N];
        let own = self.starts[row] as usize..self.starts[row + 1] as usize;
        for (&column, &value) in self.columns[own.clone()].iter().zip(&self.values[own]) {
            for (sum, x) in sums.iter_mut().zip(&x[column as usize]) {
                add_scaled(sum, value, x);
            }
        }
        sums
    }
}

/// Adds to the entry of a row in a column.
fn add_entry(row: &mut Vec<(u32, f64)>, column: usize, value: f64) {
    let column = column as u32;
    match row.iter_mut().find(|(other, _)| *other == column) {
        Some((_, sum)) => *sum += value,
        None => row.push((column, value)),
    }
}

/// Accelerations u_b of a body's vectors from their places, velocities and accelerations in the frame.
pub(crate) struct Total {
    coriolis: Columns,
    turning: Columns,
    e: Padded,
}

impl Total {
    /// In a frame that moves so.
    pub fn new(transport: &Transport) -> Self {
        Self {
            coriolis: Columns::new(&transport.coriolis()),
            turning: Columns::new(&transport.turning()),
            e: padded(transport.e),
        }
    }

    /// `q'' + 2 w x q' + w' x q + w x (w x q)`, with e for positions.
    #[inline(always)]
    pub fn acceleration(&self, is_position: bool, [q, v, a]: [&Padded; 3]) -> Padded {
        let mut u = *a;
        self.turning.add_product(q, &mut u);
        self.coriolis.add_product(v, &mut u);
        if is_position {
            add_scaled(&mut u, 1.0, &self.e);
        }
        u
    }
}

/// The vector `place` of a body's components, in space.
#[inline(always)]
pub(crate) fn spread(axes: &[usize], components: &[f64], place: usize) -> Padded {
    if let [_, _, _] = axes {
        let own = &components[3 * place..3 * place + 3];
        return [own[0], own[1], own[2], 0.0];
    }
    let mut vector = [0.0; 4];
    for (value, &axis) in components[axes.len() * place..].iter().zip(axes) {
        vector[axis & 3] = *value;
    }
    vector
}

impl MeshBody {
    /// Whether all elements are alike.
    pub fn is_even(&self) -> bool {
        self.mass.len() == self.spec.nodal.len().pow(2)
    }

    /// Mass matrix of the vectors of an element.
    pub fn mass_of(&self, element: usize) -> &[f64] {
        let size = self.spec.nodal.len().pow(2);
        let element = if self.is_even() { 0 } else { element };
        &self.mass[element * size..(element + 1) * size]
    }

    /// Mass of its nodal vectors; where modes describe the body, that of what is fixed to it.
    pub fn nodal_mass(&self, in_modes: bool) -> &NodalMass {
        if in_modes && self.modes.is_some() {
            &self.fixed_mass
        } else {
            &self.whole_mass
        }
    }
}

impl MeshScene {
    /// Masses of the nodal vectors of a body: with its elements, and of fixtures alone.
    pub(crate) fn nodal_masses(&self, index: usize) -> [NodalMass; 2] {
        let body = &self.bodies[index];
        let on_body = || self.fixtures.iter().filter(|fixture| fixture.point.body == index);
        let normals = || on_body().flat_map(|fixture| fixture.entries_of_normal(&body.spec));
        let fixed: Vec<(usize, Vec<f64>)> = on_body()
            .map(|fixture| (fixture.point.element, fixture.mass().to_vec()))
            .collect();
        let fixed = || fixed.iter().map(|(element, local)| (*element, &local[..]));
        let elements = (0..body.spec.count).map(|element| (element, body.mass_of(element)));
        let on_it = NodalMass::new(&body.spec, fixed(), normals());
        let whole = match body.spec.fidelity {
            Fidelity::Point => {
                let own = NodalMass::new(&body.spec, elements, []);
                own.at_centre(&body.spec).plus(&on_it, &body.spec)
            }
            _ => NodalMass::new(&body.spec, elements.chain(fixed()), normals()),
        };
        [whole, on_it]
    }

    /// Adds the inertia forces of elements, fixtures and rigid parts at the loaded state, on nodal vectors and on
    /// free frames.
    pub(crate) fn add_inertia_forces(&mut self, gravity: Vector) {
        let rigid = self.free.iter().map(|frame| {
            let motion = &self.buffers.frames[frame.spec.frame];
            Transport::new(motion, SPATIAL, gravity).of_rigid(&frame.spec.rigid)
        });
        let mut on_frames: Vec<[Vector; 2]> = rigid.collect();
        let Buffers {
            q,
            v,
            a,
            force,
            frames,
            nodal,
            ..
        } = &mut self.buffers;
        for body in &self.bodies {
            let mass = body.nodal_mass(self.in_modes);
            if mass.is_empty() {
                continue;
            }
            let axes = body.spec.axes;
            let transport = Transport::new(&frames[body.frame], axes, gravity);
            let first = self.layout.offset(body.first_vector);
            let own = first..first + mass.vectors() * axes.len();
            let [places, rates, accelerations] = [&*q, &*v, &*a].map(|full| &full[own.clone()]);
            let mut forces_of = |mass: &NodalMass, at: [&[f64]; 3], out: &mut [f64]| {
                let forces = Forces {
                    mass,
                    axes,
                    transport: &transport,
                    at,
                    scratch: &mut *nodal,
                    out,
                };
                dispatch(Arch::new(), forces)
            };
            let small = body.modes.as_ref().filter(|modes| !self.in_modes && modes.is_linear());
            let sums = match small {
                // Inertia of small deformations is that of the undeformed shape; fixtures follow the deformed one.
                Some(modes) => {
                    let mut undeformed = vec![0.0; places.len()];
                    forces_of(&body.fixed_mass, [modes.shape(), rates, accelerations], &mut undeformed);
                    let out = &mut force[own.clone()];
                    out.iter_mut().zip(undeformed).for_each(|(sum, value)| *sum -= value);
                    forces_of(&body.fixed_mass, [places, rates, accelerations], out);
                    forces_of(mass, [modes.shape(), rates, accelerations], out)
                }
                None => forces_of(mass, [places, rates, accelerations], &mut force[own.clone()]),
            };
            if let Some(free) = self.free_of[body.frame] {
                for (sum, value) in on_frames[free].iter_mut().zip(sums) {
                    *sum = add(*sum, value);
                }
            }
        }
        for (free, sums) in on_frames.into_iter().enumerate() {
            self.add_to_unknowns(free, sums);
        }
    }

    /// Adds force and moment (frame axes) on a free frame to the forces of its unknowns.
    pub(crate) fn add_to_unknowns(&mut self, free: usize, [force, moment]: [Vector; 2]) {
        let frame = &self.free[free];
        let force = self.buffers.frames[frame.spec.frame].direction_to_inertial(force);
        let first = self.layout.vector_components() + frame.first;
        for (place, direction) in frame.directions.iter().enumerate() {
            self.buffers.force[first + place] += dot(direction.shift, force) + dot(direction.turn, moment);
        }
    }
}

/// [`forces`] with the instructions of the processor.
struct Forces<'a> {
    mass: &'a NodalMass,
    axes: &'a [usize],
    transport: &'a Transport,
    at: [&'a [f64]; 3],
    scratch: &'a mut Vec<[Padded; 1]>,
    out: &'a mut [f64],
}

impl Vectorised for Forces<'_> {
    type Output = [Vector; 2];

    #[inline(always)]
    fn run<const F: bool>(self) -> [Vector; 2] {
        forces(self.mass, self.axes, self.transport, self.at, self.scratch, self.out)
    }
}

/// Adds the inertia forces of a body on its vectors; their force and moment about the frame's origin.
#[inline(always)]
fn forces(
    mass: &NodalMass,
    axes: &[usize],
    transport: &Transport,
    [q, v, a]: [&[f64]; 3],
    scratch: &mut Vec<[Padded; 1]>,
    out: &mut [f64],
) -> [Vector; 2] {
    let total = Total::new(transport);
    scratch.clear();
    scratch.extend((0..mass.vectors()).map(|place| {
        let at = [q, v, a].map(|values| spread(axes, values, place));
        [total.acceleration(mass.is_position(place), at.each_ref())]
    }));
    let (mut force, mut moment) = ([0.0; 4], [0.0; 3]);
    for (place, out) in out.chunks_exact_mut(axes.len()).enumerate() {
        let [g] = mass.product(place, scratch);
        for (out, &axis) in out.iter_mut().zip(axes) {
            *out += g[axis & 3];
        }
        if mass.is_position(place) {
            add_scaled(&mut force, 1.0, &g);
        }
        moment = add(moment, cross(vector(spread(axes, q, place)), vector(g)));
    }
    [vector(force), moment]
}
