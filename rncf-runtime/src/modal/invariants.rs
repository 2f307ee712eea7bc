//! Inertia of a modal body from constants, THEORY 3.2, Eqs. (15)-(17).

use super::action::{CarriedTangent, FrameAction};
use crate::scene::bodies::described::Inertial;
use crate::space::{Matrix, Vector, crossed, rows, second_moment};

/// What the frame does, in three components; planar bodies lie in the first two.
#[derive(Clone, Copy, Debug, Default)]
pub struct Action {
    /// Acceleration of the origin minus gravity, m/s^2.
    pub acceleration: Vector,
    /// Angular velocity, rad/s.
    pub spin: Vector,
    /// Its rate, rad/s^2.
    pub spin_rate: Vector,
}

impl Action {
    /// From the order of a body's axes.
    pub(crate) fn new(frame: &FrameAction, dimension: usize) -> Self {
        let turned = |spin: Vector| {
            if dimension == 2 {
                Vector::new(0.0, 0.0, spin[0])
            } else {
                spin
            }
        };
        Self {
            acceleration: frame.acceleration,
            spin: turned(frame.spin),
            spin_rate: turned(frame.spin_rate),
        }
    }
}

/// Modal coordinates (the phi are normalised by mass: sqrt(kg) m) with their first two derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Motion<'a> {
    /// p
    pub p: &'a [f64],
    /// p'
    pub v: &'a [f64],
    /// p''
    pub a: &'a [f64],
}

/// Constants of a body with k modes; of a mesh nodal sets are summed with the mass matrix M^ab.
pub use crate::import::Inertia as Invariants;

/// Distance of a centre of mass from the origin, relative to the body's extent, that is round-off.
const CENTRED: f64 = 1e-12;

fn plus(a: &Matrix, factor: f64, b: &Matrix) -> Matrix {
    Matrix::from_fn(|i, j| a[(i, j)] + factor * b[(i, j)])
}

/// `d/dw (w x (w x u))`, THEORY 2.1
fn spin_derivative(w: Vector, u: Vector) -> Matrix {
    let parallel = w.dot(&u);
    Matrix::from_fn(|i, j| {
        let unit = if i == j { parallel } else { 0.0 };
        unit + w[i] * u[j] - 2.0 * u[i] * w[j]
    })
}

fn quadratic(w: Vector, a: &Matrix) -> f64 {
    w.dot(&(a * w))
}

/// `M^ab u_b`
fn weighted(mass: &[f64], u: &[Vector]) -> Vec<Vector> {
    let row = |row: &[f64]| row.iter().zip(u).fold(Vector::zeros(), |sum, (&m, &u)| sum + m * u);
    mass.chunks_exact(u.len()).map(row).collect()
}

/// Inertia of the displaced body.
struct Displaced {
    /// m r_c + P
    moment: Vector,
    /// J(p)
    inertia: Matrix,
    /// gamma_j + eta_ij p_i
    gamma: Vec<Vector>,
    /// (Gamma_j + Ups_ij p_i) p_j'
    rate: Matrix,
}

impl Invariants {
    /// Sums the constants. `mass` is M^ab, rows first; `whole` holds the nodal values of the constant 1
    /// (1 for positions, 0 for slopes), whose sums with M^ab are m and d^a.
    pub fn new(mass: &[f64], whole: &[f64], shape: &[Vector], modes: &[Vec<Vector>]) -> Self {
        let k = modes.len();
        let moments: Vec<f64> = mass
            .chunks_exact(whole.len())
            .map(|row| row.iter().zip(whole).map(|(m, c)| m * c).sum())
            .collect();
        let first_moment = |u: &[Vector]| moments.iter().zip(u).fold(Vector::zeros(), |sum, (&d, &u)| sum + d * u);
        let weighted_modes: Vec<Vec<Vector>> = modes.iter().map(|mode| weighted(mass, mode)).collect();
        let pairs = || (0..k).flat_map(|i| (0..k).map(move |j| (i, j)));
        let inner = |i: usize, j: usize| {
            let pairs = modes[i].iter().zip(&weighted_modes[j]);
            pairs.map(|(&u, &v)| u.dot(&v)).sum::<f64>()
        };
        Self {
            mass: moments.iter().zip(whole).map(|(d, c)| d * c).sum(),
            moment: first_moment(shape),
            inertia: second_moment(shape, &weighted(mass, shape)),
            phibar: modes.iter().map(|mode| first_moment(mode)).collect(),
            gamma: weighted_modes.iter().map(|mode| crossed(shape, mode)).collect(),
            eta: pairs().map(|(i, j)| crossed(&modes[i], &weighted_modes[j])).collect(),
            first: weighted_modes.iter().map(|mode| second_moment(shape, mode)).collect(),
            second: pairs()
                .map(|(i, j)| second_moment(&modes[i], &weighted_modes[j]))
                .collect(),
            inner: pairs().map(|(i, j)| inner(i, j)).collect(),
        }
    }

    /// The same body without modes, all of whose mass is at its centre of mass: J0 = m [c]^T [c]. A centre nearer
    /// to the origin than round-off of `extent` (m) is at the origin, so that a motion without inertia has none at all.
    pub fn at_centre(&self, extent: f64) -> Self {
        let moment = self.moment.map(|component| {
            if component.abs() > CENTRED * self.mass * extent {
                component
            } else {
                0.0
            }
        });
        let centre = 1.0 / self.mass * moment;
        Self {
            mass: self.mass,
            moment,
            inertia: second_moment(&[centre], &[moment]),
            phibar: Vec::new(),
            gamma: Vec::new(),
            eta: Vec::new(),
            first: Vec::new(),
            second: Vec::new(),
            inner: Vec::new(),
        }
    }

    /// Number of modes.
    fn modes(&self) -> usize {
        self.phibar.len()
    }

    /// I_ij, rows first: the mass matrix of the modes.
    pub fn inner(&self) -> &[f64] {
        &self.inner
    }

    fn displaced(&self, at: Motion) -> Displaced {
        let k = self.modes();
        let mut moment = self.moment;
        let mut inertia = self.inertia;
        let mut rate = Matrix::zeros();
        let mut gamma = self.gamma.clone();
        for i in 0..k {
            moment += at.p[i] * self.phibar[i];
            let both = plus(&self.first[i], 1.0, &self.first[i].transpose());
            inertia = plus(&inertia, at.p[i], &both);
            rate = plus(&rate, at.v[i], &self.first[i]);
            for j in 0..k {
                gamma[j] += at.p[i] * self.eta[i * k + j];
                inertia = plus(&inertia, at.p[i] * at.p[j], &self.second[i * k + j]);
                rate = plus(&rate, at.p[i] * at.v[j], &self.second[i * k + j]);
            }
        }
        Displaced {
            moment,
            inertia,
            gamma,
            rate,
        }
    }

    /// Mass, first moment, momentum, angular momentum and kinetic energy about an origin at rest.
    pub fn carried(&self, spin: Vector, p: &[f64], v: &[f64]) -> Inertial {
        let none = vec![0.0; p.len()];
        let body = self.displaced(Motion { p, v, a: &none });
        let (mut rate, mut turned) = (Vector::zeros(), body.inertia * spin);
        let mut kinetic = 0.5 * spin.dot(&turned);
        for i in 0..self.modes() {
            rate += v[i] * self.phibar[i];
            turned += v[i] * body.gamma[i];
            kinetic += v[i] * spin.dot(&body.gamma[i]);
            for j in 0..self.modes() {
                kinetic += 0.5 * v[i] * v[j] * self.inner[i * self.modes() + j];
            }
        }
        Inertial {
            mass: self.mass,
            moment: body.moment,
            inertia: body.inertia,
            momentum: spin.cross(&body.moment) + rate,
            spin: turned,
            kinetic,
        }
    }

    /// S_i = Gamma_i + Ups_ij p_j
    fn shifted(&self, i: usize, p: &[f64]) -> Matrix {
        (0..self.modes()).fold(self.first[i], |sum, j| {
            plus(&sum, p[j], &self.second[i * self.modes() + j])
        })
    }

    /// Adds the inertia part of (17).
    pub fn modal_force(&self, action: &Action, at: Motion, out: &mut [f64]) {
        let k = self.modes();
        let (w, dw) = (action.spin, action.spin_rate);
        for i in 0..k {
            let mut sum = self.phibar[i].dot(&action.acceleration) + self.gamma[i].dot(&dw);
            for j in 0..k {
                let eta = self.eta[i * k + j];
                sum += self.inner[i * k + j] * at.a[j] - at.p[j] * eta.dot(&dw) - 2.0 * at.v[j] * w.dot(&eta);
            }
            out[i] += sum - quadratic(w, &self.shifted(i, at.p));
        }
    }

    /// Adds the derivatives of (17) with respect to p and p', k x k.
    pub fn modal_tangent(&self, action: &Action, stiffness: &mut [f64], damping: &mut [f64]) {
        for (place, (eta, second)) in self.eta.iter().zip(&self.second).enumerate() {
            stiffness[place] -= eta.dot(&action.spin_rate) + quadratic(action.spin, second);
            damping[place] -= 2.0 * action.spin.dot(eta);
        }
    }

    /// Force and moment about the origin, left sides of (15) and (16).
    pub fn frame_force(&self, action: &Action, at: Motion) -> [Vector; 2] {
        let Action {
            acceleration: e,
            spin: w,
            spin_rate: dw,
        } = *action;
        let body = self.displaced(at);
        let mut force = self.mass * e + dw.cross(&body.moment);
        let mut moment = body.moment.cross(&e) + body.inertia * dw;
        moment += w.cross(&(body.inertia * w));
        moment += 2.0 * (body.rate * w);
        let mut rate = Vector::zeros();
        for i in 0..self.modes() {
            force += at.a[i] * self.phibar[i];
            moment += at.a[i] * body.gamma[i];
            rate += at.v[i] * self.phibar[i];
        }
        let turned = 2.0 * rate + w.cross(&body.moment);
        [force + w.cross(&turned), moment]
    }

    /// Derivatives of (15) and (16), six rows; `moves`: whether the modal coordinates change the
    /// inertia. See [`CarriedTangent`] for the columns.
    pub(crate) fn frame_tangent(&self, action: &Action, at: Motion, moves: bool, out: &mut CarriedTangent) {
        let (k, w) = (self.modes(), action.spin);
        let body = self.displaced(at);
        let tilt = body.moment.cross_matrix();
        let mut rate = Vector::zeros();
        for i in 0..k {
            rate += at.v[i] * self.phibar[i];
        }
        let by_spin = plus(&spin_derivative(w, body.moment), -2.0, &rate.cross_matrix());
        let turning = w.cross_matrix() * body.inertia;
        let gyroscopic = plus(&turning, -1.0, &(body.inertia * w).cross_matrix());
        let gyroscopic = plus(&gyroscopic, 2.0, &body.rate);
        resize(&mut out.mass, 6 * (6 + k));
        resize(&mut out.damping, 6 * (3 + k));
        resize(&mut out.stiffness, 6 * k);
        resize(&mut out.spin, 3 * k);
        block(
            &mut out.mass,
            6 + k,
            0,
            0,
            &plus(&Matrix::zeros(), self.mass, &Matrix::identity()),
        );
        block(&mut out.mass, 6 + k, 0, 3, &tilt.transpose());
        block(&mut out.mass, 6 + k, 3, 0, &tilt);
        block(&mut out.mass, 6 + k, 3, 3, &body.inertia);
        block(&mut out.damping, 3 + k, 0, 0, &by_spin);
        block(&mut out.damping, 3 + k, 3, 0, &gyroscopic);
        for j in 0..k {
            let shifted = if moves {
                self.shifted_back(j, at.p)
            } else {
                self.first[j]
            };
            column(&mut out.mass, 6 + k, 6 + j, self.phibar[j], body.gamma[j]);
            let coriolis = 2.0 * (shifted * w);
            column(&mut out.damping, 3 + k, 3 + j, 2.0 * w.cross(&self.phibar[j]), coriolis);
            self.spin_row(action, at, j, &mut out.spin);
        }
        if moves {
            (0..k).for_each(|j| self.displacement_column(action, at, j, &mut out.stiffness));
        }
    }

    /// Gamma_j + Ups_ij p_i
    fn shifted_back(&self, j: usize, p: &[f64]) -> Matrix {
        (0..self.modes()).fold(self.first[j], |sum, i| {
            plus(&sum, p[i], &self.second[i * self.modes() + j])
        })
    }

    /// d(17)/dw of mode i.
    fn spin_row(&self, action: &Action, at: Motion, i: usize, spin: &mut [f64]) {
        let shifted = self.shifted(i, at.p);
        let w = action.spin;
        let mut row = -(shifted * w + shifted.tr_mul(&w));
        for j in 0..self.modes() {
            row -= 2.0 * at.v[j] * self.eta[i * self.modes() + j];
        }
        spin[3 * i..3 * i + 3].copy_from_slice(row.as_slice());
    }

    /// d(15), (16)/dp_j.
    fn displacement_column(&self, action: &Action, at: Motion, j: usize, stiffness: &mut [f64]) {
        let k = self.modes();
        let (w, dw, phibar) = (action.spin, action.spin_rate, self.phibar[j]);
        let force = dw.cross(&phibar) + w.cross(&w.cross(&phibar));
        let shifted = self.shifted(j, at.p);
        let inertia = plus(&shifted, 1.0, &shifted.transpose());
        let mut moment = phibar.cross(&action.acceleration) + inertia * dw;
        moment += w.cross(&(inertia * w));
        for m in 0..k {
            moment += at.a[m] * self.eta[j * k + m];
            let rate = self.second[j * k + m] * w;
            moment += 2.0 * at.v[m] * rate;
        }
        column(stiffness, k, j, force, moment);
    }
}

fn resize(values: &mut Vec<f64>, count: usize) {
    values.clear();
    values.resize(count, 0.0);
}

fn block(values: &mut [f64], width: usize, row: usize, first: usize, entries: &Matrix) {
    for (i, line) in rows(entries).iter().enumerate() {
        values[(row + i) * width + first..(row + i) * width + first + 3].copy_from_slice(line);
    }
}

fn column(values: &mut [f64], width: usize, place: usize, force: Vector, moment: Vector) {
    for i in 0..3 {
        values[i * width + place] = force[i];
        values[(3 + i) * width + place] = moment[i];
    }
}
