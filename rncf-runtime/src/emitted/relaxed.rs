//! A particle of a section whose lateral strains are free: they take the values at which the energy is least, so that the
//! sides of fibres carry no stress.
//!
//! In the axes of the section the particle's deformation gradient is `G = [g, U b, U c]`: g along the fibre, b and c the
//! section's axes, and U the part of the lateral strain that varies over the section. What is given are
//!
//! ```text
//! e = 1/2 (g.g - 1),  gamma_y = g.b,  gamma_z = g.c,  m = [b.b, b.c, c.c]
//! E_xx = e,  2 E_xy = p gamma_y + q gamma_z,  2 E_yy + 1 = p^2 b.b + 2 p q b.c + q^2 c.c,  ..      U = [[p, q], [q, r]]
//! ```
//!
//! U turns with nothing and stretches the section in its own plane. A rod under tension or bending thus has fibres under
//! uniaxial stress, and one under torsion or shear keeps its section, as it does in Rivlin's solutions for rubber; at fixed
//! E_xy the hoop strain would be relaxed, too, which the neighbours of a particle do not allow.

use crate::error::ModelError;

/// Energy per volume of a material as a function of the Green strain, with components xx, yy, zz, xy, xz, yz.
pub trait StrainEnergy {
    /// Writes energy (J/m^3), stress dW/dE and stiffness d2W/dE2 (Pa) at a strain; of the stiffness what is not zero on and
    /// above the diagonal.
    fn response(&self, strain: &[f64; 6], energy: &mut f64, stress: &mut [f64; 6], stiffness: &mut [[f64; 6]; 6]);

    /// Writes the derivative of the stiffness along a rate of the strain, in the same way. Only damped bodies need it.
    fn stiffness_rate(&self, _strain: &[f64; 6], _rate: &[f64; 6], _stiffness: &mut [[f64; 6]; 6]) {}
}

/// Checks that an energy per volume resists every small strain, so that those which are free have a least energy.
///
/// # Errors
/// The material by name.
pub fn resisting(material: &str, law: &impl StrainEnergy) -> Result<(), ModelError> {
    let (mut energy, mut stress, mut stiffness) = (0.0, [0.0; 6], [[0.0; 6]; 6]);
    law.response(&[0.0; 6], &mut energy, &mut stress, &mut stiffness);
    mirror(&mut stiffness);
    let diagonal: [f64; 6] = std::array::from_fn(|at| stiffness[at][at]);
    for at in 0..6 {
        let (pivot, own) = (stiffness[at][at], diagonal[at]);
        if !(own > 0.0 && pivot > 1e-9 * own) {
            let strain = ["E.xx", "E.yy", "E.zz", "E.xy", "E.xz", "E.yz"][at];
            return Err(ModelError::new(format!(
                "material `{material}`: with these parameters its energy does not resist `{strain}`: it must grow with the \
                 square of every strain, those across the axis included"
            )));
        }
        for row in at + 1..6 {
            let factor = stiffness[row][at] / pivot;
            for column in at..6 {
                stiffness[row][column] -= factor * stiffness[at][column];
            }
        }
    }
    Ok(())
}

/// Numbers that describe a particle: e, gamma_y, gamma_z, the three products of the section's axes; p, q, r.
const ALL: usize = 9;
/// Those that are given.
pub(crate) const GIVEN: usize = 6;

type State = [f64; ALL];
type Square<const N: usize> = [[f64; N]; N];

/// Which of p, q, r are free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Free {
    /// None: the section's axes say everything.
    Nothing,
    /// q and r: what leaves the plane of a planar body.
    OutOfPlane,
    /// All.
    Lateral,
}

impl Free {
    fn places(self) -> &'static [usize] {
        match self {
            Self::Nothing => &[],
            Self::OutOfPlane => &[7, 8],
            Self::Lateral => &[6, 7, 8],
        }
    }
}

/// What a particle answers to what is given.
pub(crate) struct Response {
    /// Energy, J/m^3.
    pub energy: f64,
    /// Its derivative, Pa.
    pub stress: [f64; GIVEN],
    /// Second derivative, Pa.
    pub stiffness: Square<GIVEN>,
    /// Rate of the second derivative where rates are given, Pa/s.
    pub stiffness_rate: Square<GIVEN>,
}

/// Step of U (plain number) below which Newton's iteration ends: the error behind it is its square.
const LAST_STEP: f64 = 1e-8;
/// Step below which a decrease of the energy is round-off.
const SURE_STEP: f64 = 1e-6;
const MOST_STEPS: usize = 60;

/// The energy at its least over what is free; `None` where it has no minimum near the undeformed section, or where no
/// material is (the energy is not finite).
pub(crate) fn respond(
    law: &impl StrainEnergy,
    given: &[f64; GIVEN],
    rates: Option<&[f64; GIVEN]>,
    free: Free,
) -> Option<Response> {
    let mut state = [0.0; ALL];
    state[..GIVEN].copy_from_slice(given);
    for place in [3, 5, 6, 8] {
        state[place] += 1.0;
    }
    let free = free.places();
    let mut at = Local::new(law, &state)?;
    if !free.is_empty() {
        let mut ends = false;
        for _ in 0..MOST_STEPS {
            if ends {
                break;
            }
            let step = at.step(free);
            let size = step.iter().fold(0.0_f64, |size, part| size.max(part.abs()));
            ends = size < LAST_STEP;
            at = at.after(law, free, &step, size)?;
        }
        if !ends {
            return None;
        }
    }
    at.condensed(law, free, rates)
}

/// Energy and derivatives at a state.
struct Local {
    state: State,
    strain: [f64; 6],
    energy: f64,
    stress: [f64; 6],
    stiffness: Square<6>,
    jacobian: [[f64; ALL]; 6],
    /// Second derivative with respect to the state.
    hessian: Square<ALL>,
}

impl Local {
    fn new(law: &impl StrainEnergy, state: &State) -> Option<Self> {
        let strain = strain(state);
        let (mut energy, mut stress, mut stiffness) = (0.0, [0.0; 6], [[0.0; 6]; 6]);
        law.response(&strain, &mut energy, &mut stress, &mut stiffness);
        mirror(&mut stiffness);
        let jacobian = jacobian(state);
        let mut hessian = curvature(&stress, state, 1.0);
        add_congruent(&mut hessian, &stiffness, &jacobian, &jacobian);
        let is_finite = energy.is_finite() && hessian.iter().flatten().all(|entry| entry.is_finite());
        is_finite.then_some(Self {
            state: *state,
            strain,
            energy,
            stress,
            stiffness,
            jacobian,
            hessian,
        })
    }

    /// Derivative of the energy with respect to one number of the state.
    fn gradient(&self, place: usize) -> f64 {
        (0..6).map(|k| self.stress[k] * self.jacobian[k][place]).sum()
    }

    /// Newton's step of what is free. Where the energy is not convex, its second derivative is shifted until it is.
    fn step(&self, free: &[usize]) -> [f64; 3] {
        let mut right = [0.0; 3];
        let mut matrix = [[0.0; 3]; 3];
        let mut largest = 0.0_f64;
        for (row, &i) in free.iter().enumerate() {
            right[row] = -self.gradient(i);
            for (column, &j) in free.iter().enumerate() {
                matrix[row][column] = self.hessian[i][j];
                largest = largest.max(self.hessian[i][j].abs());
            }
        }
        let mut shift = 0.0;
        loop {
            let mut shifted = matrix;
            (0..free.len()).for_each(|i| shifted[i][i] += shift);
            if let Some(factor) = Factor::new(&shifted, free.len()) {
                return factor.solve(right);
            }
            shift = if shift == 0.0 { 1e-3 * largest } else { 4.0 * shift };
            // What is no number ends here, too.
            if shift.is_nan() || shift >= 1e6 * largest {
                return [0.0; 3];
            }
        }
    }

    /// The state behind a step, shortened until the energy falls.
    fn after(&self, law: &impl StrainEnergy, free: &[usize], step: &[f64; 3], size: f64) -> Option<Self> {
        let slope: f64 = free.iter().zip(step).map(|(&i, part)| self.gradient(i) * part).sum();
        let mut share = 1.0;
        for _ in 0..40 {
            let mut state = self.state;
            for (&i, part) in free.iter().zip(step) {
                state[i] += share * part;
            }
            if let Some(next) = Self::new(law, &state)
                && (size < SURE_STEP || next.energy <= self.energy + 1e-4 * share * slope)
            {
                return Some(next);
            }
            share *= 0.5;
        }
        None
    }

    /// What is given alone, the free numbers following it: `W_ss - W_su W_uu^-1 W_us`.
    fn condensed(&self, law: &impl StrainEnergy, free: &[usize], rates: Option<&[f64; GIVEN]>) -> Option<Response> {
        let mut matrix = [[0.0; 3]; 3];
        for (row, &i) in free.iter().enumerate() {
            for (column, &j) in free.iter().enumerate() {
                matrix[row][column] = self.hessian[i][j];
            }
        }
        let factor = Factor::new(&matrix, free.len())?;
        // How the state follows what is given.
        let mut follow = [[0.0; GIVEN]; ALL];
        for given in 0..GIVEN {
            follow[given][given] = 1.0;
            let mut right = [0.0; 3];
            for (part, &i) in right.iter_mut().zip(free) {
                *part = -self.hessian[i][given];
            }
            for (&i, part) in free.iter().zip(factor.solve(right)) {
                follow[i][given] = part;
            }
        }
        let mut stiffness = [[0.0; GIVEN]; GIVEN];
        for (i, row) in stiffness.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = self.hessian[i][j] + free.iter().map(|&u| self.hessian[i][u] * follow[u][j]).sum::<f64>();
            }
        }
        let mut stiffness_rate = [[0.0; GIVEN]; GIVEN];
        if let Some(rates) = rates {
            // The free numbers follow to first order; to this order alone they enter the third derivative.
            let hessian_rate = self.hessian_rate(law, &follow.map(|row| dot(&row, rates)));
            add_congruent(&mut stiffness_rate, &hessian_rate, &follow, &follow);
        }
        Some(Response {
            energy: self.energy,
            stress: std::array::from_fn(|given| self.gradient(given)),
            stiffness,
            stiffness_rate,
        })
    }

    /// Derivative of the Hessian along a rate of the state.
    fn hessian_rate(&self, law: &impl StrainEnergy, rate: &State) -> Square<ALL> {
        let strain_rate = self.jacobian.map(|row| dot(&row, rate));
        let stress_rate = self.stiffness.map(|row| dot(&row, &strain_rate));
        let mut stiffness_rate = [[0.0; 6]; 6];
        law.stiffness_rate(&self.strain, &strain_rate, &mut stiffness_rate);
        mirror(&mut stiffness_rate);
        let jacobian_rate: [[f64; ALL]; 6] = std::array::from_fn(|k| {
            let mut unit = [0.0; 6];
            unit[k] = 1.0;
            curvature(&unit, &self.state, 1.0).map(|row| dot(&row, rate))
        });
        let mut result = curvature(&stress_rate, &self.state, 1.0);
        let moving = curvature(&self.stress, rate, 0.0);
        for (sum, part) in result.iter_mut().flatten().zip(moving.iter().flatten()) {
            *sum += part;
        }
        add_congruent(&mut result, &stiffness_rate, &self.jacobian, &self.jacobian);
        add_congruent(&mut result, &self.stiffness, &jacobian_rate, &self.jacobian);
        add_congruent(&mut result, &self.stiffness, &self.jacobian, &jacobian_rate);
        result
    }
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn mirror<const N: usize>(matrix: &mut Square<N>) {
    for i in 0..N {
        for j in 0..i {
            matrix[i][j] = matrix[j][i];
        }
    }
}

/// Adds `L^T M R`.
fn add_congruent<const N: usize, const K: usize>(
    sum: &mut Square<N>,
    matrix: &Square<K>,
    left: &[[f64; N]; K],
    right: &[[f64; N]; K],
) {
    for k in 0..K {
        let mut along = [0.0; N];
        for l in 0..K {
            let entry = matrix[k][l];
            if entry != 0.0 {
                along
                    .iter_mut()
                    .zip(&right[l])
                    .for_each(|(part, value)| *part += entry * value);
            }
        }
        for (row, &factor) in sum.iter_mut().zip(&left[k]) {
            if factor != 0.0 {
                row.iter_mut()
                    .zip(&along)
                    .for_each(|(part, value)| *part += factor * value);
            }
        }
    }
}

fn strain(&[e, gy, gz, yy, yz, zz, p, q, r]: &State) -> [f64; 6] {
    [
        e,
        0.5 * (p * p * yy + 2.0 * p * q * yz + q * q * zz - 1.0),
        0.5 * (q * q * yy + 2.0 * q * r * yz + r * r * zz - 1.0),
        0.5 * (p * gy + q * gz),
        0.5 * (q * gy + r * gz),
        0.5 * (p * q * yy + (p * r + q * q) * yz + q * r * zz),
    ]
}

/// Derivatives of the strain with respect to the state.
fn jacobian(&[_, gy, gz, yy, yz, zz, p, q, r]: &State) -> [[f64; ALL]; 6] {
    let (a, b) = (p * yy + q * yz, p * yz + q * zz);
    let (c, d) = (q * yy + r * yz, q * yz + r * zz);
    [
        [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.5 * p * p, p * q, 0.5 * q * q, a, b, 0.0],
        [0.0, 0.0, 0.0, 0.5 * q * q, q * r, 0.5 * r * r, 0.0, c, d],
        [0.0, 0.5 * p, 0.5 * q, 0.0, 0.0, 0.0, 0.5 * gy, 0.5 * gz, 0.0],
        [0.0, 0.5 * q, 0.5 * r, 0.0, 0.0, 0.0, 0.0, 0.5 * gy, 0.5 * gz],
        [
            0.0,
            0.0,
            0.0,
            0.5 * p * q,
            0.5 * (p * r + q * q),
            0.5 * q * r,
            0.5 * c,
            0.5 * (a + d),
            0.5 * b,
        ],
    ]
}

/// `sum_k S_k d2E_k`: linear in the state but for constants, which are multiplied with `one`.
fn curvature(stress: &[f64; 6], &[_, _, _, yy, yz, zz, p, q, r]: &State, one: f64) -> Square<ALL> {
    let [_, s_yy, s_zz, s_xy, s_xz, s_yz] = *stress;
    let mut h = [[0.0; ALL]; ALL];
    let (xy, xz, half) = (0.5 * one * s_xy, 0.5 * one * s_xz, 0.5 * s_yz);
    // gamma_y and gamma_z with p, q, r.
    (h[1][6], h[1][7], h[2][7], h[2][8]) = (xy, xz, xy, xz);
    // b.b, b.c, c.c with p, q, r.
    (h[3][6], h[3][7]) = (s_yy * p + half * q, s_zz * q + half * p);
    (h[4][6], h[4][7], h[4][8]) = (s_yy * q + half * r, s_yy * p + s_zz * r + s_yz * q, s_zz * q + half * p);
    (h[5][7], h[5][8]) = (s_yy * q + half * r, s_zz * r + half * q);
    (h[6][6], h[6][7], h[6][8]) = (s_yy * yy, s_yy * yz + half * yy, half * yz);
    (h[7][7], h[7][8], h[8][8]) = (s_yy * zz + s_zz * yy + s_yz * yz, s_zz * yz + half * zz, s_zz * zz);
    mirror(&mut h);
    h
}

/// Cholesky's factor of a small symmetric matrix.
struct Factor {
    lower: [[f64; 3]; 3],
    size: usize,
}

impl Factor {
    /// `None` where the matrix is not positive definite.
    fn new(matrix: &[[f64; 3]; 3], size: usize) -> Option<Self> {
        let mut lower = [[0.0; 3]; 3];
        for i in 0..size {
            for j in 0..=i {
                let rest = matrix[i][j] - (0..j).map(|k| lower[i][k] * lower[j][k]).sum::<f64>();
                if i == j {
                    // A pivot that is left over by round-off is none, nor is what is no number.
                    if rest.is_nan() || rest <= 1e-13 * matrix[i][i].abs() {
                        return None;
                    }
                    lower[i][i] = rest.sqrt();
                } else {
                    lower[i][j] = rest / lower[j][j];
                }
            }
        }
        Some(Self { lower, size })
    }

    fn solve(&self, mut right: [f64; 3]) -> [f64; 3] {
        for i in 0..self.size {
            let known: f64 = (0..i).map(|j| self.lower[i][j] * right[j]).sum();
            right[i] = (right[i] - known) / self.lower[i][i];
        }
        for i in (0..self.size).rev() {
            let known: f64 = (i + 1..self.size).map(|j| self.lower[j][i] * right[j]).sum();
            right[i] = (right[i] - known) / self.lower[i][i];
        }
        right
    }
}
