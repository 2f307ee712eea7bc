//! Mass matrices of nodal vectors, and accelerations in space that they are multiplied with.

use crate::emitted::{BodySpec, FrameMotion, RigidSpec};
use crate::space::{Matrix, Vector};

/// Three components, and one more for the width of the machine.
pub(crate) type Padded = [f64; 4];

/// A vector with a fourth component, zero.
pub(crate) fn padded(vector: Vector) -> Padded {
    let [x, y, z] = vector.into();
    [x, y, z, 0.0]
}

/// The vector without the fourth component.
pub(crate) fn vector([x, y, z, _]: Padded) -> Vector {
    Vector::new(x, y, z)
}

/// `sum += factor x`
#[inline(always)]
pub(crate) fn add_scaled<const W: usize>(sum: &mut [f64; W], factor: f64, x: &[f64; W]) {
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
        Self(std::array::from_fn(|j| padded(matrix.column(j).into())))
    }

    /// One after the other.
    #[inline(always)]
    pub fn each(&self) -> &[Padded; 3] {
        &self.0
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
        (2.0 * self.spin).cross_matrix()
    }

    /// `G = [w'] + [w][w]`: acceleration by place in the frame.
    pub fn turning(&self) -> Matrix {
        let (rate, square) = (
            self.spin_rate.cross_matrix(),
            self.spin.cross_matrix() * self.spin.cross_matrix(),
        );
        Matrix::from_fn(|i, j| rate[(i, j)] + square[(i, j)])
    }

    /// Inertia force and moment of rigid parts on the frame, Eq. (14).
    pub fn of_rigid(&self, rigid: &RigidSpec) -> [Vector; 2] {
        let (w, rate) = (self.spin, self.spin_rate);
        let turning = rate.cross(&rigid.moment) + w.cross(&w.cross(&rigid.moment));
        let gyroscopic = w.cross(&(rigid.inertia * w));
        [
            rigid.mass * self.e + turning,
            rigid.moment.cross(&self.e) + (rigid.inertia * rate + gyroscopic),
        ]
    }
}

/// Constant mass matrix M^ab of the nodal vectors of one body, its entries other than zero row by row.
#[derive(Clone, Debug, Default)]
pub(crate) struct NodalMass {
    /// Start of every row in `columns` and `values`, and their length at the end.
    pub starts: Vec<u32>,
    pub columns: Vec<u32>,
    /// Whether the columns of every row follow each other.
    in_runs: bool,
    /// kg for two positions, kg m and kg m^2 with slopes.
    pub values: Vec<f64>,
    /// First moments d^a = M^ab c_b.
    pub first: Vec<f64>,
    /// c_a: whether a vector is a position.
    pub is_position: Vec<bool>,
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

    pub fn of_rows(spec: &BodySpec, mut rows: Vec<Vec<(u32, f64)>>) -> Self {
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
        let follow = |pair: &[(u32, f64)]| pair[0].0 + 1 == pair[1].0;
        mass.in_runs = rows.iter().all(|row| row.windows(2).all(follow));
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

    /// All rows, from the first on.
    #[inline(always)]
    pub fn rows(&self) -> Rows<'_> {
        Rows {
            starts: &self.starts,
            columns: &self.columns,
            values: &self.values,
            in_runs: self.in_runs,
        }
    }

    /// Columns and values of one row.
    pub fn entries(&self, row: usize) -> impl Iterator<Item = (usize, f64)> {
        let own = self.starts[row] as usize..self.starts[row + 1] as usize;
        let columns = self.columns[own.clone()].iter().map(|&column| column as usize);
        columns.zip(self.values[own].iter().copied())
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

/// The rows of a mass that are left.
pub(crate) struct Rows<'a> {
    starts: &'a [u32],
    columns: &'a [u32],
    values: &'a [f64],
    in_runs: bool,
}

impl Rows<'_> {
    /// `M^ab x_b` of the next row.
    #[inline(always)]
    pub fn next_times<const W: usize>(&mut self, x: &[[f64; W]]) -> [f64; W] {
        let &[start, ref later @ ..] = self.starts else {
            return [0.0; W];
        };
        let length = later.first().map_or(0, |end| (end - start) as usize);
        let (columns, other_columns) = self.columns.split_at(length);
        let (values, other_values) = self.values.split_at(length);
        (self.starts, self.columns, self.values) = (later, other_columns, other_values);
        match columns {
            // Two vectors each of a node and of those beside it: a length that is a constant of the code.
            &[first, ..] if length == 6 && self.in_runs => sum_of::<6, W>(values, &x[first as usize..]),
            _ => sum(values.iter().zip(columns.iter().map(|&column| &x[column as usize]))),
        }
    }
}

/// Sum of vectors by factors.
#[inline(always)]
fn sum<'a, const W: usize>(terms: impl Iterator<Item = (&'a f64, &'a [f64; W])>) -> [f64; W] {
    let mut sum = [0.0; W];
    for (&factor, x) in terms {
        add_scaled(&mut sum, factor, x);
    }
    sum
}

/// The same of `N` vectors.
#[inline(always)]
fn sum_of<const N: usize, const W: usize>(factors: &[f64], x: &[[f64; W]]) -> [f64; W] {
    let (factors, x) = (factors.first_chunk::<N>(), x.first_chunk::<N>());
    let (Some(factors), Some(x)) = (factors, x) else {
        unreachable!("as many as were counted");
    };
    let mut sum = [0.0; W];
    for k in 0..N {
        add_scaled(&mut sum, factors[k], &x[k]);
    }
    sum
}

/// Adds to the entry of a row in a column.
pub(crate) fn add_entry(row: &mut Vec<(u32, f64)>, column: usize, value: f64) {
    let column = column as u32;
    match row.iter_mut().find(|(other, _)| *other == column) {
        Some((_, sum)) => *sum += value,
        None => row.push((column, value)),
    }
}

/// Accelerations u_b of a body's vectors from their places, velocities and accelerations in the frame.
pub(crate) struct Total {
    pub coriolis: Columns,
    pub turning: Columns,
    pub e: Padded,
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
