//! The two factorizations of a step: the Newton matrix of three stages, split by the
//! eigenvectors of A^-1 into a real and a complex system of the size of one stage.

use pulp::Arch;

use super::chart::Chart;
use super::coefficients::Coefficients;
use super::stabilised::{Slopes, Stabilised};
use crate::integrate::statistics::Statistics;
use crate::linalg::{Pattern, Saddle, Singular, Vectorised, c64, dispatch};
use crate::system::{State, System, Tangent};

/// Tangent, constraint Jacobian and the factorizations made of them, in the chart.
pub(super) struct Matrices {
    pub(super) chart: Chart,
    /// The system's own pattern of `C^T`.
    pub(super) constraint_pattern: Pattern,
    pub(super) tangent: Tangent,
    /// As the system gives them; the tangent where it is not that of the chart.
    system_tangent: Tangent,
    system_jacobian: Vec<f64>,
    system_rate: Vec<f64>,
    /// `C_x^T` of the multipliers' forces on the chart's pattern.
    forces: Vec<f64>,
    pub(super) slopes: Slopes,
    state: State,
    real: Saddle<f64>,
    complex: Saddle<c64>,
    /// With the stabilised index 2.
    stabilised: Option<Box<(Stabilised<f64>, Stabilised<c64>)>>,
    real_block: Vec<f64>,
    complex_block: Vec<c64>,
    /// Right sides: equations of motion, constraints, their rates.
    real_sides: [Vec<f64>; 3],
    complex_sides: [Vec<c64>; 3],
    /// Step size of the factorizations; none if they do not fit the tangent.
    factored: Option<f64>,
}

impl Matrices {
    pub(super) fn new(system: &mut dyn System, stabilised: bool) -> Self {
        let chart = Chart::new(system.turns(), system.pattern(), system.constraint_pattern());
        let (n, m) = (system.unknowns(), system.constraints());
        let tangent = |entries: usize| Tangent {
            mass: vec![0.0; entries],
            stiffness: vec![0.0; entries],
            damping: vec![0.0; entries],
        };
        let constraint_pattern = system.constraint_pattern().clone();
        let (entries, constraint_entries) = (chart.block.entries(), chart.constraints.entries());
        let rates = if stabilised { m } else { 0 };
        Self {
            tangent: tangent(entries),
            system_tangent: tangent(if chart.turns().is_empty() {
                0
            } else {
                system.pattern().entries()
            }),
            system_jacobian: vec![0.0; constraint_pattern.entries()],
            system_rate: vec![0.0; constraint_pattern.entries()],
            forces: vec![0.0; constraint_entries],
            slopes: Slopes {
                jacobian: vec![0.0; constraint_entries],
                rate: vec![0.0; constraint_entries],
            },
            state: State::of(system, 0.0),
            real: Saddle::new(&chart.block, system.border(), &chart.constraints).sized(system.sizes()),
            complex: Saddle::new(&chart.block, system.border(), &chart.constraints).sized(system.sizes()),
            stabilised: stabilised.then(|| Box::new((Stabilised::new(n, m), Stabilised::new(n, m)))),
            real_block: vec![0.0; entries],
            complex_block: vec![c64::default(); entries],
            real_sides: [n, m, rates].map(|length| vec![0.0; length]),
            complex_sides: [n, m, rates].map(|length| vec![c64::default(); length]),
            factored: None,
            constraint_pattern,
            chart,
        }
    }

    /// Evaluates tangent and constraint Jacobian at `place`, given in the chart.
    pub(super) fn linearize(&mut self, system: &mut dyn System, place: &State, statistics: &mut Statistics) {
        self.state.clone_from(place);
        self.chart.leave(&mut self.state);
        if self.chart.turns().is_empty() {
            // The chart is no other than the system's unknowns.
            system.tangent(&self.state, &mut self.tangent);
        } else {
            system.tangent(&self.state, &mut self.system_tangent);
            self.chart.tangent(place, &self.system_tangent, &mut self.tangent);
        }
        if self.constraint_pattern.columns() > 0 {
            system.constraint_jacobian(&self.state, &mut self.system_jacobian);
            self.chart.forces(&self.system_jacobian, &mut self.forces);
            self.chart
                .jacobian(&place.x, &self.system_jacobian, &mut self.slopes.jacobian);
            if self.stabilised.is_some() {
                system.constraint_rate_tangent(&self.state, &mut self.system_rate);
                self.chart
                    .rate_tangent(place, &self.system_jacobian, &self.system_rate, &mut self.slopes.rate);
            }
        }
        statistics.jacobian_evaluations += 1;
        self.factored = None;
    }

    /// Whether all entries that were factored last are numbers.
    pub(super) fn is_finite(&self) -> bool {
        let entries = self.real_block.iter().chain(&self.slopes.jacobian);
        entries.copied().all(f64::is_finite)
    }

    /// Factors for step size `h` unless that is done.
    pub(super) fn factor(
        &mut self,
        coefficients: &Coefficients,
        h: f64,
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        if self.factored == Some(h) {
            return Ok(());
        }
        self.factored = None;
        let (g, z) = (coefficients.real / h, coefficients.complex / h);
        let square = z * z;
        let blocks = Blocks {
            tangent: &self.tangent,
            real: (g, &mut self.real_block),
            complex: ([z, square], &mut self.complex_block),
        };
        dispatch(Arch::new(), blocks);
        statistics.factorizations += 2;
        let (forces, slopes) = (&self.forces, &self.slopes);
        self.real.factor(&self.real_block, forces, &slopes.jacobian)?;
        self.complex.factor(&self.complex_block, forces, &slopes.jacobian)?;
        if let Some(second) = &mut self.stabilised {
            let (real, complex) = &mut **second;
            real.factor(&self.chart, g, &self.tangent, slopes, &mut self.real)?;
            complex.factor(&self.chart, z, &self.tangent, slopes, &mut self.complex)?;
            statistics.solves += 2 * self.constraint_pattern.columns() as u64;
        }
        self.factored = Some(h);
        Ok(())
    }

    /// Solves `(G^2 (x) M + G (x) D + 1 (x) K) dZ + F dL = dynamics, C_y dZ = constraints` with
    /// G = A^-1 / h in place; with the stabilised index 2 also for mu, `super::stabilised`.
    pub(super) fn solve_stages(
        &mut self,
        coefficients: &Coefficients,
        h: f64,
        sides: [&mut [Vec<f64>; 3]; 3],
        statistics: &mut Statistics,
    ) {
        for (k, stages) in sides.iter().enumerate() {
            let (real, complex) = (&mut self.real_sides[k], &mut self.complex_sides[k]);
            dispatch(Arch::new(), ToEigenvectors(coefficients, stages, real, complex));
        }
        let ([f, c, r], [zf, zc, zr]) = (&mut self.real_sides, &mut self.complex_sides);
        match &mut self.stabilised {
            None => {
                self.real.solve(f, c);
                self.complex.solve(zf, zc);
            }
            Some(second) => {
                let (real, complex) = &mut **second;
                let (pattern, slopes) = (&self.chart.constraints, &self.slopes);
                let (g, z) = (coefficients.real / h, coefficients.complex / h);
                real.solve(pattern, g, slopes, &mut self.real, (f, c, r));
                complex.solve(pattern, z, slopes, &mut self.complex, (zf, zc, zr));
            }
        }
        statistics.solves += 2;
        for (k, stages) in sides.into_iter().enumerate() {
            let (real, complex) = (&self.real_sides[k], &self.complex_sides[k]);
            dispatch(Arch::new(), FromEigenvectors(coefficients, stages, real, complex));
        }
    }

    /// Solves with the real matrix `(g/h)^2 M + (g/h) D + K` and the constraints in place.
    pub(super) fn solve_real(&mut self, dynamics: &mut [f64], constraints: &mut [f64], statistics: &mut Statistics) {
        self.real.solve(dynamics, constraints);
        statistics.solves += 1;
    }
}

/// The real and the complex matrix made of a tangent.
struct Blocks<'a> {
    tangent: &'a Tangent,
    real: (f64, &'a mut [f64]),
    /// Its factor and the square of that.
    complex: ([c64; 2], &'a mut [c64]),
}

impl Vectorised for Blocks<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let (g, real) = self.real;
        let ([z, square], complex) = self.complex;
        let n = real.len();
        let (mass, damping) = (&self.tangent.mass[..n], &self.tangent.damping[..n]);
        let (stiffness, complex) = (&self.tangent.stiffness[..n], &mut complex[..n]);
        for i in 0..n {
            let (m, d, k) = (mass[i], damping[i], stiffness[i]);
            real[i] = (g * m + d) * g + k;
            complex[i] = c64::new(square.re * m + z.re * d + k, square.im * m + z.im * d);
        }
    }
}

/// What the stages have along the real and the complex eigenvector of A^-1.
struct ToEigenvectors<'a>(&'a Coefficients, &'a [Vec<f64>; 3], &'a mut [f64], &'a mut [c64]);

impl Vectorised for ToEigenvectors<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(coefficients, [f0, f1, f2], real, complex) = self;
        let n = real.len();
        let (f0, f1, f2, complex) = (&f0[..n], &f1[..n], &f2[..n], &mut complex[..n]);
        let (r, c) = (coefficients.real_left, coefficients.complex_left);
        for i in 0..n {
            real[i] = r[0] * f0[i] + r[1] * f1[i] + r[2] * f2[i];
            complex[i] = c64::new(
                c[0].re * f0[i] + c[1].re * f1[i] + c[2].re * f2[i],
                c[0].im * f0[i] + c[1].im * f1[i] + c[2].im * f2[i],
            );
        }
    }
}

/// The stages from what they have along these eigenvectors.
struct FromEigenvectors<'a>(&'a Coefficients, &'a mut [Vec<f64>; 3], &'a [f64], &'a [c64]);

impl Vectorised for FromEigenvectors<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(coefficients, stages, real, complex) = self;
        for (s, stage) in stages.iter_mut().enumerate() {
            let (a, b) = (coefficients.real_right[s], coefficients.complex_right[s]);
            for ((value, real), complex) in stage.iter_mut().zip(real).zip(complex) {
                *value = a * real + 2.0 * (b.re * complex.re - b.im * complex.im);
            }
        }
    }
}
