//! Newmark, HHT and generalized-alpha for index 3 as textbooks print them (THEORY 7.1, 7.2): any start, any sequence of
//! steps, nothing put right.

use rncf::linalg::Saddle;
use rncf::space::{inverse_tangent_map, three};
use rncf::system::ConstraintLevel;
use rncf::{State, System};

/// Largest increment of Newton's iteration that ends it, relative to the sizes of the unknowns.
const CONVERGED: f64 = 1e-11;

/// Coefficients of a method.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    am: f64,
    af: f64,
    beta: f64,
    gamma: f64,
}

impl Family {
    /// The trapezoidal rule, Newmark (1/4, 1/2).
    pub const NEWMARK: Self = Self {
        am: 0.0,
        af: 0.0,
        beta: 0.25,
        gamma: 0.5,
    };

    /// HHT with the given alpha.
    pub fn hht(alpha: f64) -> Self {
        Self::averaging(0.0, -alpha)
    }

    /// Generalized-alpha with the given spectral radius at infinity.
    pub fn generalized_alpha(rho: f64) -> Self {
        Self::averaging((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0))
    }

    fn averaging(am: f64, af: f64) -> Self {
        let gamma = 0.5 + af - am;
        let beta = (gamma + 0.5) * (gamma + 0.5) / 4.0;
        Self { am, af, beta, gamma }
    }

    /// Algorithmic accelerations belong to the time so many steps after the others.
    fn shift(&self) -> f64 {
        self.am - self.af
    }

    /// Constant of the velocity bias, THEORY 10.
    fn kappa(&self) -> f64 {
        self.beta + self.shift() / 2.0 - 1.0 / 6.0
    }
}

/// What becomes of the algorithmic accelerations when the step changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// Nothing.
    Carried,
    /// Moved to where the new step has them; the velocity bias with a jerk from differences of accelerations.
    Differenced,
}

/// A run from a state with its accelerations and multipliers.
pub struct Index3<'s, S: System + ?Sized> {
    pub system: &'s mut S,
    family: Family,
    change: Change,
    pub state: State,
    /// Algorithmic accelerations, and those before.
    a: Vec<f64>,
    before: Vec<f64>,
    h: Option<f64>,
}

impl<'s, S: System + ?Sized> Index3<'s, S> {
    /// Begins with the accelerations of `start`.
    pub fn new(system: &'s mut S, start: &State, family: Family, change: Change) -> Self {
        let mut state = start.clone();
        state.rebase(system.turns());
        Self {
            a: state.a.clone(),
            before: state.a.clone(),
            system,
            family,
            change,
            state,
            h: None,
        }
    }

    /// Puts the start right for steps of size `h`, s, by the jerk there and its constrained part (THEORY 10): what is
    /// then lost is lost at step changes.
    pub fn correct_start(&mut self, jerk: &[f64], constrained: &[f64], h: f64) {
        for i in 0..self.a.len() {
            self.a[i] += self.family.shift() * h * jerk[i];
            self.state.v[i] -= self.family.kappa() * h * h * constrained[i];
        }
    }

    /// Takes a step of size `h`, s; `None` where Newton's iteration does not converge.
    pub fn step(&mut self, h: f64) -> Option<()> {
        if let Some(old) = self.h
            && old != h
            && self.change == Change::Differenced
        {
            self.change_step(old, h);
        }
        let Family { am, af, beta, gamma } = self.family;
        let algorithmic = |new: f64, old: f64, a: f64| ((1.0 - af) * new + af * old - am * a) / (1.0 - am);
        let mut next = self.state.clone();
        next.t += h;
        for i in 0..self.a.len() {
            let a1 = algorithmic(next.a[i], self.state.a[i], self.a[i]);
            next.x[i] += h * (next.v[i] + h * ((0.5 - beta) * self.a[i] + beta * a1));
            next.v[i] += h * ((1.0 - gamma) * self.a[i] + gamma * a1);
        }
        self.converge(h, &mut next)?;
        self.before.clone_from(&self.a);
        for i in 0..self.a.len() {
            self.a[i] = algorithmic(next.a[i], self.state.a[i], self.a[i]);
        }
        next.rebase(self.system.turns());
        self.state = next;
        self.h = Some(h);
        Some(())
    }

    /// Newton's iteration on positions and multipliers; velocities and accelerations follow the positions.
    fn converge(&mut self, h: f64, next: &mut State) -> Option<()> {
        let Family { am, af, beta, gamma } = self.family;
        let (rate, curvature) = (gamma / (h * beta), (1.0 - am) / (h * h * beta * (1.0 - af)));
        let system = &mut *self.system;
        let (pattern, borders) = (system.pattern().clone(), system.constraint_pattern().clone());
        let (mut matrix, mut border) = (vec![0.0; pattern.entries()], vec![0.0; borders.entries()]);
        let (mut d, mut value) = (vec![0.0; system.unknowns()], vec![0.0; system.constraints()]);
        let mut saddle = Saddle::new(&pattern, system.border(), &borders);
        let scale = beta * h * h;
        for _ in 0..20 {
            system.residual(next, &mut d);
            system.constraint_jacobian(next, &mut border);
            borders.multiply_add(1.0, &border, &next.lambda, &mut d);
            system.constraint(ConstraintLevel::Position, next, &mut value);
            system.iteration_matrix(next, [scale * curvature, scale * rate, scale], &mut matrix);
            saddle.factor_symmetric(&matrix, &border).ok()?;
            d.iter_mut().for_each(|d| *d *= -scale);
            value.iter_mut().for_each(|value| *value = -*value);
            saddle.solve(&mut d, &mut value);
            for &turn in system.turns() {
                let map = inverse_tangent_map(three(&next.x, turn));
                let change = map * three(&d, turn);
                d[turn..turn + 3].copy_from_slice(change.as_slice());
            }
            let mut largest = 0.0_f64;
            for (i, (d, size)) in d.iter().zip(system.sizes()).enumerate() {
                next.x[i] += d;
                next.v[i] += rate * d;
                next.a[i] += curvature * d;
                largest = largest.max((d / size).abs());
            }
            next.lambda
                .iter_mut()
                .zip(&value)
                .for_each(|(lambda, change)| *lambda += change / scale);
            if !largest.is_finite() {
                return None;
            }
            if largest < CONVERGED {
                return Some(());
            }
        }
        None
    }

    /// The remedy that is none: with the constrained part of a difference of accelerations.
    fn change_step(&mut self, old: f64, new: f64) {
        let system = &mut *self.system;
        let (pattern, borders) = (system.pattern().clone(), system.constraint_pattern().clone());
        let (mut mass, mut border) = (vec![0.0; pattern.entries()], vec![0.0; borders.entries()]);
        system.mass(&self.state, &mut mass);
        system.constraint_jacobian(&self.state, &mut border);
        let jerk: Vec<f64> = self.a.iter().zip(&self.before).map(|(a, b)| (a - b) / old).collect();
        let (mut constrained, mut rate) = (vec![0.0; jerk.len()], vec![0.0; system.constraints()]);
        borders.transpose_multiply_add(1.0, &border, &jerk, &mut rate);
        let mut saddle = Saddle::new(&pattern, system.border(), &borders);
        saddle.factor_symmetric(&mass, &border).expect("a regular matrix");
        saddle.solve(&mut constrained, &mut rate);
        let kappa = self.family.kappa();
        for i in 0..self.a.len() {
            let true_one = self.state.a[i];
            self.a[i] = true_one + new / old * (self.a[i] - true_one);
            self.state.v[i] -= kappa * (new * new - old * old) * constrained[i];
        }
    }
}
