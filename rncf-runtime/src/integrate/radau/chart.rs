//! The chart of a step (THEORY 7.5). A free orientation is `A = turn exp(xi)` with the turn at the start
//! of the step; chart rates nu = dxi/dt and their derivatives are plain numbers, and so are all other
//! unknowns. In the chart the system is a second-order one in a vector space. With w in body axes,
//!
//! ```text
//! w = T nu,   dw/dt = T dnu/dt + W,   W = (dT/dxi . nu) nu
//! ```
//!
//! Derivatives with respect to right increments and w become those with respect to xi and nu by the
//! chain rule, exactly: `dpi = T dxi`, and those of w and dw/dt below.

use crate::linalg::Pattern;
use crate::space::{Matrix, Vector, exp, tangent_map, three as at, turned};
use crate::system::{State, Tangent};

/// Angles (rad) below this use series.
const SMALL: f64 = 1.0;
/// Largest angle from the start of a step, rad: below pi, where rotation vectors become ambiguous.
const REACH: f64 = 3.0;
/// Terms of the series: the next one is below round-off.
const TERMS: usize = 9;

/// Orientations among the unknowns and the patterns of the chart: the three columns of an orientation
/// (rows of `C^T`) mix, so that they have common entries.
#[derive(Debug)]
pub(super) struct Chart {
    turns: Vec<usize>,
    /// Pattern of mass, damping and stiffness.
    pub(super) block: Pattern,
    /// Pattern of `C^T`.
    pub(super) constraints: Pattern,
    /// Places of the system's entries in these patterns.
    block_places: Vec<usize>,
    constraint_places: Vec<usize>,
}

impl Chart {
    /// The chart of a system by the first unknowns of its orientations, its pattern and that of `C^T`.
    pub(super) fn new(turns: &[usize], block: &Pattern, constraints: &Pattern) -> Self {
        let mates = |index: usize| {
            let first = turns.iter().copied().find(|&first| (first..first + 3).contains(&index));
            first.map_or(index..index + 1, |first| first..first + 3)
        };
        let (n, m) = (constraints.rows(), constraints.columns());
        let of = |pattern: &Pattern| pattern.places().collect::<Vec<_>>();
        let (block, constraints) = (of(block), of(constraints));
        let wide = |&(row, column): &(usize, usize)| mates(column).map(move |column| (row, column));
        let tall = |&(row, column): &(usize, usize)| mates(row).map(move |row| (row, column));
        let chart_block = Pattern::new(n, n, block.iter().flat_map(wide));
        let chart_constraints = Pattern::new(n, m, constraints.iter().flat_map(tall));
        let places = |pattern: &Pattern, of: &[(usize, usize)]| {
            of.iter()
                .filter_map(|&(row, column)| pattern.find(row, column))
                .collect()
        };
        Self {
            block_places: places(&chart_block, &block),
            constraint_places: places(&chart_constraints, &constraints),
            block: chart_block,
            constraints: chart_constraints,
            turns: turns.to_vec(),
        }
    }

    /// Turns chart rates and their derivatives in `state.v` and `state.a` into velocities and
    /// accelerations at `state.x`.
    pub(super) fn leave(&self, state: &mut State) {
        for &first in &self.turns {
            let (xi, nu, rate) = (at(&state.x, first), at(&state.v, first), at(&state.a, first));
            let point = Point::new(xi);
            let acceleration = point.map(rate) + point.turning(nu);
            state.v[first..first + 3].copy_from_slice(point.map(nu).as_slice());
            state.a[first..first + 3].copy_from_slice(acceleration.as_slice());
        }
    }

    /// Rotation vectors `increments`, since `start`, of an orientation on the chart that begins at
    /// `increment` since `start` instead.
    pub(super) fn transport(&self, increment: &[f64], increments: &mut [f64]) {
        for &first in &self.turns {
            let turn = exp(at(increment, first)).inverse();
            let moved = turned(&turn, at(increments, first)).scaled_axis();
            increments[first..first + 3].copy_from_slice(moved.as_slice());
        }
    }

    /// The first unknown of an orientation that left the chart by the given increments, if any.
    pub(super) fn left_by(&self, increments: &[f64]) -> Option<usize> {
        let far = |&first: &usize| at(increments, first).norm() > REACH;
        self.turns.iter().copied().find(far)
    }

    /// First unknowns of the orientations.
    pub(super) fn turns(&self) -> &[usize] {
        &self.turns
    }

    /// Derivatives of the residual with respect to chart coordinates, rates and their derivatives from
    /// those of the system. `chart` gives coordinates, rates and derivatives as of before
    /// [`Chart::leave`].
    pub(super) fn tangent(&self, chart: &State, system: &Tangent, out: &mut Tangent) {
        scatter(&self.block_places, &system.mass, &mut out.mass);
        scatter(&self.block_places, &system.damping, &mut out.damping);
        scatter(&self.block_places, &system.stiffness, &mut out.stiffness);
        for &first in &self.turns {
            let (xi, nu, rate) = (at(&chart.x, first), at(&chart.v, first), at(&chart.a, first));
            let point = Point::new(xi);
            let map = tangent_map(xi).transpose();
            let dv_dx = transposed(|d| point.map_change(nu, d));
            let da_dv = transposed(|d| point.turning_change_by_rate(nu, d));
            let da_dx = transposed(|d| point.map_change(rate, d) + point.turning_change(nu, d));
            let starts = self.block.starts();
            let columns = [starts[first], starts[first + 1], starts[first + 2]];
            for row in 0..starts[first + 1] - starts[first] {
                let places = columns.map(|start| start + row);
                let of = |values: &[f64]| Vector::from(places.map(|place| values[place]));
                let (m, d, k) = (of(&out.mass), of(&out.damping), of(&out.stiffness));
                let stiffness = map * k + (dv_dx * d + da_dx * m);
                let damping = map * d + da_dv * m;
                let mass = map * m;
                for (i, place) in places.into_iter().enumerate() {
                    out.mass[place] = mass[i];
                    out.damping[place] = damping[i];
                    out.stiffness[place] = stiffness[i];
                }
            }
        }
    }

    /// `C^T` as it is, on the chart's pattern.
    pub(super) fn forces(&self, system: &[f64], out: &mut [f64]) {
        scatter(&self.constraint_places, system, out);
    }

    /// Transposed derivative of the constraints with respect to chart coordinates at `x`, from `C^T`.
    pub(super) fn jacobian(&self, x: &[f64], system: &[f64], out: &mut [f64]) {
        scatter(&self.constraint_places, system, out);
        for &first in &self.turns {
            let map = tangent_map(at(x, first)).transpose();
            self.on_rows(first, |places| {
                let mapped = map * Vector::from(places.map(|place| out[place]));
                places
                    .into_iter()
                    .zip(&mapped)
                    .for_each(|(place, value)| out[place] = *value);
            });
        }
    }

    /// Transposed derivative of `C_x v + C_t` with respect to chart coordinates at constant rates, from
    /// `C^T` and the system's rate tangent; `chart` as in [`Chart::tangent`].
    pub(super) fn rate_tangent(&self, chart: &State, jacobian: &[f64], system: &[f64], out: &mut [f64]) {
        self.jacobian(&chart.x, system, out);
        let mut forces = vec![0.0; out.len()];
        scatter(&self.constraint_places, jacobian, &mut forces);
        for &first in &self.turns {
            let (point, nu) = (Point::new(at(&chart.x, first)), at(&chart.v, first));
            let dv_dx = transposed(|d| point.map_change(nu, d));
            self.on_rows(first, |places| {
                let part = dv_dx * Vector::from(places.map(|place| forces[place]));
                places
                    .into_iter()
                    .zip(&part)
                    .for_each(|(place, value)| out[place] += value);
            });
        }
    }

    /// Visits the three places of an orientation in every column of `C^T` that has them.
    fn on_rows(&self, first: usize, mut visit: impl FnMut([usize; 3])) {
        for column in 0..self.constraints.columns() {
            if let Some(place) = self.constraints.find(first, column) {
                visit([place, place + 1, place + 2]);
            }
        }
    }
}

fn scatter(places: &[usize], values: &[f64], out: &mut [f64]) {
    out.fill(0.0);
    for (&place, &value) in places.iter().zip(values) {
        out[place] = value;
    }
}

/// The transpose of the matrix of a linear map.
fn transposed(map: impl Fn(Vector) -> Vector) -> Matrix {
    Matrix::from_columns(&[Vector::x(), Vector::y(), Vector::z()].map(map)).transpose()
}

/// `T = 1 - b [xi] + c [xi]^2` and what turns with it at one place of the chart; b and c with their
/// first and second derivatives with respect to |xi|^2.
struct Point {
    xi: Vector,
    b: [f64; 3],
    c: [f64; 3],
}

impl Point {
    fn new(xi: Vector) -> Self {
        let s = xi.dot(&xi);
        let (b, c) = if s < SMALL * SMALL {
            (series(2, s), series(3, s))
        } else {
            let t = s.sqrt();
            let sine = t.sin() / t;
            let (b, c) = ((1.0 - t.cos()) / s, (1.0 - sine) / s);
            let (b1, c1) = ((0.5 * sine - b) / s, (b - 3.0 * c) / (2.0 * s));
            let (b2, c2) = (((c - b) / 4.0 - 2.0 * b1) / s, (b1 - 5.0 * c1) / (2.0 * s));
            ([b, b1, b2], [c, c1, c2])
        };
        Self { xi, b, c }
    }

    /// `T u`
    fn map(&self, u: Vector) -> Vector {
        let p = self.xi.cross(&u);
        u + self.mix(0, p)
    }

    /// `-b p + c xi x p` with derivatives of b and c of the given order.
    fn mix(&self, order: usize, p: Vector) -> Vector {
        -self.b[order] * p + self.c[order] * self.xi.cross(&p)
    }

    /// Change of `T u` with a change d of xi.
    fn map_change(&self, u: Vector, d: Vector) -> Vector {
        let (p, change) = (self.xi.cross(&u), d.cross(&u));
        let direct = self.mix(0, change) + self.c[0] * d.cross(&p);
        2.0 * self.xi.dot(&d) * self.mix(1, p) + direct
    }

    /// `W = (dT/dxi . u) u`
    fn turning(&self, u: Vector) -> Vector {
        let p = self.xi.cross(&u);
        2.0 * self.xi.dot(&u) * self.mix(1, p) + self.c[0] * u.cross(&p)
    }

    /// Change of W with a change d of xi.
    fn turning_change(&self, u: Vector, d: Vector) -> Vector {
        let (p, change) = (self.xi.cross(&u), d.cross(&u));
        let along = 2.0 * self.xi.dot(&d);
        let mut mixed = along * self.mix(2, p) + self.mix(1, change);
        mixed += self.c[1] * d.cross(&p);
        let mut out = 2.0 * self.xi.dot(&u) * mixed;
        out += 2.0 * d.dot(&u) * self.mix(1, p);
        out += along * self.c[1] * u.cross(&p);
        out + self.c[0] * u.cross(&change)
    }

    /// Change of W with a change d of u.
    fn turning_change_by_rate(&self, u: Vector, d: Vector) -> Vector {
        let (p, change) = (self.xi.cross(&u), self.xi.cross(&d));
        let mixed = self.xi.dot(&d) * self.mix(1, p) + self.xi.dot(&u) * self.mix(1, change);
        let direct = d.cross(&p) + u.cross(&change);
        2.0 * mixed + self.c[0] * direct
    }
}

/// `sum (-s)^k / (2 k + first)!` and its first two derivatives.
fn series(first: u32, s: f64) -> [f64; 3] {
    let mut terms = [0.0; TERMS + 2];
    let mut factorial = (1..=first).map(f64::from).product::<f64>();
    let mut next = f64::from(first);
    for (k, term) in terms.iter_mut().enumerate() {
        *term = if k % 2 == 0 { 1.0 } else { -1.0 } / factorial;
        factorial *= (next + 1.0) * (next + 2.0);
        next += 2.0;
    }
    let mut sums = [0.0; 3];
    for k in (0..TERMS).rev() {
        let k1 = (k + 1) as f64;
        sums[0] = sums[0] * s + terms[k];
        sums[1] = sums[1] * s + k1 * terms[k + 1];
        sums[2] = sums[2] * s + k1 * (k1 + 1.0) * terms[k + 2];
    }
    sums
}

#[cfg(test)]
#[path = "chart_tests.rs"]
mod tests;
