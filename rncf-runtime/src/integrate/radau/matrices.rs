//! The factorizations of a step: the Newton matrix of S stages, split by the eigenvectors of A^-1
//! into a real system and (S - 1) / 2 complex ones of the size of one stage.

use pulp::Arch;

use super::chart::Chart;
use super::coefficients::Coefficients;
use super::stabilised::{Slopes, Stabilised};
use super::stages::{combine, combined, slices};
use crate::integrate::statistics::Statistics;
use crate::linalg::{Pattern, Saddle, Singular, Vectorised, c64, dispatch};
use crate::system::{State, System, Tangent};

/// Tangent, constraint Jacobian and the factorizations made of them, in the chart.
pub(super) struct Matrices<const S: usize> {
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
    /// One of each pair of eigenvalues.
    complex: Vec<Saddle<c64>>,
    /// With the stabilised index 2.
    stabilised: Option<Box<Borders>>,
    real_block: Vec<f64>,
    complex_block: Vec<c64>,
    /// Right sides: equations of motion, constraints, their rates.
    real_sides: [Vec<f64>; 3],
    complex_sides: Vec<[Vec<c64>; 3]>,
    /// Step size of the factorizations; none if they do not fit the tangent.
    factored: Option<f64>,
}

/// The second constraint blocks, of the real eigenvalue and of one of each pair.
struct Borders {
    real: Stabilised<f64>,
    complex: Vec<Stabilised<c64>>,
}

impl<const S: usize> Matrices<S> {
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
            complex: (0..S / 2)
                .map(|_| Saddle::new(&chart.block, system.border(), &chart.constraints).sized(system.sizes()))
                .collect(),
            stabilised: stabilised.then(|| {
                Box::new(Borders {
                    real: Stabilised::new(n, m),
                    complex: (0..S / 2).map(|_| Stabilised::new(n, m)).collect(),
                })
            }),
            real_block: vec![0.0; entries],
            complex_block: vec![c64::default(); entries],
            real_sides: [n, m, rates].map(|length| vec![0.0; length]),
            complex_sides: vec![[n, m, rates].map(|length| vec![c64::default(); length]); S / 2],
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
        coefficients: &Coefficients<S>,
        h: f64,
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        if self.factored == Some(h) {
            return Ok(());
        }
        self.factored = None;
        let g = coefficients.real / h;
        let (tangent, block) = (&self.tangent, &mut self.real_block);
        dispatch(Arch::new(), RealBlock { tangent, g, block });
        let (forces, slopes) = (&self.forces, &self.slopes);
        self.real.factor(&self.real_block, forces, &slopes.jacobian)?;
        if let Some(second) = &mut self.stabilised {
            second.real.factor(&self.chart, g, tangent, slopes, &mut self.real)?;
        }
        for (k, (pair, saddle)) in coefficients.pairs.iter().zip(&mut self.complex).enumerate() {
            let z = pair.value / h;
            let block = &mut self.complex_block;
            dispatch(Arch::new(), ComplexBlock { tangent, z, block });
            saddle.factor(&self.complex_block, forces, &slopes.jacobian)?;
            if let Some(second) = &mut self.stabilised {
                second.complex[k].factor(&self.chart, z, tangent, slopes, saddle)?;
            }
        }
        let count = 1 + self.complex.len() as u64;
        statistics.factorizations += count;
        if self.stabilised.is_some() {
            statistics.solves += count * self.constraint_pattern.columns() as u64;
        }
        self.factored = Some(h);
        Ok(())
    }

    /// Solves `(G^2 (x) M + G (x) D + 1 (x) K) dZ + F dL = dynamics, C_y dZ = constraints` with
    /// G = A^-1 / h in place; with the stabilised index 2 also for mu, `super::stabilised`.
    pub(super) fn solve_stages(
        &mut self,
        coefficients: &Coefficients<S>,
        h: f64,
        sides: [&mut [Vec<f64>; S]; 3],
        statistics: &mut Statistics,
    ) {
        for (stages, real) in sides.iter().zip(&mut self.real_sides) {
            dispatch(Arch::new(), ToReal(&coefficients.real_left, stages, real));
        }
        let [f, c, r] = &mut self.real_sides;
        match &mut self.stabilised {
            None => self.real.solve(f, c),
            Some(second) => {
                let (pattern, slopes, g) = (&self.chart.constraints, &self.slopes, coefficients.real / h);
                second.real.solve(pattern, g, slopes, &mut self.real, (f, c, r));
            }
        }
        for (k, (pair, saddle)) in coefficients.pairs.iter().zip(&mut self.complex).enumerate() {
            let parts = &mut self.complex_sides[k];
            for (stages, complex) in sides.iter().zip(&mut *parts) {
                dispatch(Arch::new(), ToPair(&pair.left, stages, complex));
            }
            let [f, c, r] = parts;
            match &mut self.stabilised {
                None => saddle.solve(f, c),
                Some(second) => {
                    let (pattern, slopes, z) = (&self.chart.constraints, &self.slopes, pair.value / h);
                    second.complex[k].solve(pattern, z, slopes, saddle, (f, c, r));
                }
            }
        }
        statistics.solves += 1 + self.complex.len() as u64;
        for (k, stages) in sides.into_iter().enumerate() {
            let (real, complex) = (&self.real_sides[k], &self.complex_sides);
            dispatch(Arch::new(), FromFirst(coefficients, stages, real, &complex[0][k]));
            for (pair, parts) in coefficients.pairs.iter().zip(complex).skip(1) {
                dispatch(Arch::new(), FromPair(&pair.right, stages, &parts[k]));
            }
        }
    }

    /// Solves with the real matrix `(g/h)^2 M + (g/h) D + K` and the constraints in place.
    pub(super) fn solve_real(&mut self, dynamics: &mut [f64], constraints: &mut [f64], statistics: &mut Statistics) {
        self.real.solve(dynamics, constraints);
        statistics.solves += 1;
    }
}

/// The real matrix made of a tangent.
struct RealBlock<'a> {
    tangent: &'a Tangent,
    g: f64,
    block: &'a mut [f64],
}

impl Vectorised for RealBlock<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self { tangent, g, block } = self;
        let n = block.len();
        let (mass, damping) = (&tangent.mass[..n], &tangent.damping[..n]);
        let stiffness = &tangent.stiffness[..n];
        for i in 0..n {
            block[i] = (g * mass[i] + damping[i]) * g + stiffness[i];
        }
    }
}

/// A complex matrix made of a tangent.
struct ComplexBlock<'a> {
    tangent: &'a Tangent,
    z: c64,
    block: &'a mut [c64],
}

impl Vectorised for ComplexBlock<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self { tangent, z, block } = self;
        let square = z * z;
        let n = block.len();
        let (mass, damping) = (&tangent.mass[..n], &tangent.damping[..n]);
        let stiffness = &tangent.stiffness[..n];
        for i in 0..n {
            let (m, d, k) = (mass[i], damping[i], stiffness[i]);
            block[i] = c64::new(square.re * m + z.re * d + k, square.im * m + z.im * d);
        }
    }
}

/// What the stages have along the real eigenvector of A^-1.
struct ToReal<'a, const S: usize>(&'a [f64; S], &'a [Vec<f64>; S], &'a mut [f64]);

impl<const S: usize> Vectorised for ToReal<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        combine(self.0, self.1, self.2);
    }
}

/// What the stages have along a complex eigenvector of A^-1.
struct ToPair<'a, const S: usize>(&'a [c64; S], &'a [Vec<f64>; S], &'a mut [c64]);

impl<const S: usize> Vectorised for ToPair<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(left, stages, complex) = self;
        let (re, im) = (left.map(|value| value.re), left.map(|value| value.im));
        let stages = slices(stages, complex.len());
        for (i, value) in complex.iter_mut().enumerate() {
            *value = c64::new(combined(&re, &stages, i), combined(&im, &stages, i));
        }
    }
}

/// The stages' part along the real eigenvector and the first pair, in their place.
struct FromFirst<'a, const S: usize>(&'a Coefficients<S>, &'a mut [Vec<f64>; S], &'a [f64], &'a [c64]);

impl<const S: usize> Vectorised for FromFirst<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(coefficients, stages, real, complex) = self;
        let first = &coefficients.pairs[0];
        for (s, stage) in stages.iter_mut().enumerate() {
            let (a, b) = (coefficients.real_right[s], first.right[s]);
            for ((value, real), complex) in stage.iter_mut().zip(real).zip(complex) {
                *value = a * real + 2.0 * (b.re * complex.re - b.im * complex.im);
            }
        }
    }
}

/// Adds the stages' part along a complex eigenvector and its conjugate.
struct FromPair<'a, const S: usize>(&'a [c64; S], &'a mut [Vec<f64>; S], &'a [c64]);

impl<const S: usize> Vectorised for FromPair<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(right, stages, complex) = self;
        for (stage, b) in stages.iter_mut().zip(right) {
            for (value, complex) in stage.iter_mut().zip(complex) {
                *value += 2.0 * (b.re * complex.re - b.im * complex.im);
            }
        }
    }
}
