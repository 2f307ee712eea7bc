//! What a step costs beside residual, matrix and solution.

use std::cell::Cell;
use std::time::Instant;

use rncf::linalg::{Pattern, Saddle};
use rncf::system::{ConstraintLevel, Tangent};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, StepSize, Stop, System};

rncf::model! {
    /// Two long wires that spin about a core which points at the origin: many unknowns, two constraints.
    pub model Pointing {
        /// Elements of a wire.
        param elements: count = 20;
        const R = 149597870700 m;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
        section wire { area = 0.00453646 mm^2; second_moment = 1.6e-6 mm^4; }
        frame sail = free(
            origin = [R, 0, 0], axis = [0, 1, 0], angle = 90 deg,
            velocity = [0, 29785, 0] m/s, angular_velocity = [0, -1.99e-7, 0.00872] rad/s
        );
        fixture core on sail { mass = 100 kg; }
        body one in sail {
            spatial;
            line from [0, 0, 0] m to [10000, 0, 0] m;
            mesh elements * tether(wire, aluminium);
            initial position [1.0011 * x, 0, 0];
        }
        body two in sail {
            spatial;
            line from [0, 0, 0] m to [0, 10000, 0] m;
            mesh elements * tether(wire, aluminium);
            initial position [0, 1.0013 * x, 0];
        }
        joint one_hub = clamp(one.start, sail);
        joint two_hub = clamp(two.start, sail);
        fixture one_unit on one.end { mass = 0.4 kg; }
        fixture two_unit on two.end { mass = 0.5 kg; }
        constraint sun_x = dot(sail.ex, sail.position) / R;
        constraint sun_y = dot(sail.ey, sail.position) / R;
        output end = one.end.in(sail);
        output away = norm(sail.position) - R;
        run { t_end = 200 s; every = 10 s; }
    }
}

/// What is measured apart.
#[derive(Clone, Copy)]
enum Part {
    Residual,
    Tangent,
    Mass,
    Constraint,
    Jacobian,
}

/// A scene and the time (s) spent in its functions.
struct Clocked<'a> {
    scene: &'a mut dyn Scene,
    spent: [Cell<(f64, u32)>; 5],
}

impl<'a> Clocked<'a> {
    fn new(scene: &'a mut dyn Scene) -> Self {
        Self {
            scene,
            spent: Default::default(),
        }
    }

    fn timed(&mut self, part: Part, call: impl FnOnce(&mut dyn Scene)) {
        let clock = Instant::now();
        call(self.scene);
        let spent = &self.spent[part as usize];
        let (time, calls) = spent.get();
        spent.set((time + clock.elapsed().as_secs_f64(), calls + 1));
    }
}

impl System for Clocked<'_> {
    fn unknowns(&self) -> usize {
        self.scene.unknowns()
    }
    fn constraints(&self) -> usize {
        self.scene.constraints()
    }
    fn turns(&self) -> &[usize] {
        self.scene.turns()
    }
    fn border(&self) -> usize {
        self.scene.border()
    }
    fn pattern(&self) -> &Pattern {
        self.scene.pattern()
    }
    fn constraint_pattern(&self) -> &Pattern {
        self.scene.constraint_pattern()
    }
    fn mass(&mut self, state: &State, values: &mut [f64]) {
        self.timed(Part::Mass, |scene| scene.mass(state, values));
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        self.timed(Part::Residual, |scene| scene.residual(state, out));
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.timed(Part::Tangent, |scene| scene.tangent(state, out));
    }
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        self.timed(Part::Constraint, |scene| scene.constraint(level, state, out));
    }
    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        self.timed(Part::Jacobian, |scene| scene.constraint_jacobian(state, values));
    }
    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        self.timed(Part::Jacobian, |scene| scene.constraint_rate_tangent(state, values));
    }
    fn sizes(&self) -> &[f64] {
        self.scene.sizes()
    }
    fn describe_unknown(&self, index: usize) -> String {
        self.scene.describe_unknown(index)
    }
    fn describe_constraint(&self, index: usize) -> String {
        self.scene.describe_constraint(index)
    }
    fn kinks(&self) -> Vec<f64> {
        self.scene.kinks()
    }
    fn energy(&mut self, state: &State) -> Option<f64> {
        self.scene.energy(state)
    }
}

const METHOD: Method = Method::GeneralizedAlpha { rho_inf: 0.8 };

fn options(rtol: f64, step: StepSize) -> Options {
    Options {
        rtol,
        step,
        ..Options::default()
    }
}

/// Least times (s) of a solution with the mass matrix and its border, and of a factorization.
fn solution_times(scene: &mut dyn Scene) -> [f64; 2] {
    let state = scene.rest(0.0);
    let (mut mass, mut jacobian) = (
        vec![0.0; scene.pattern().entries()],
        vec![0.0; scene.constraint_pattern().entries()],
    );
    scene.mass(&state, &mut mass);
    scene.constraint_jacobian(&state, &mut jacobian);
    let mut saddle = Saddle::new(scene.pattern(), scene.border(), scene.constraint_pattern());
    let factorizations = (0..5).map(|_| {
        let clock = Instant::now();
        saddle.factor_symmetric(&mass, &jacobian).unwrap();
        clock.elapsed().as_secs_f64()
    });
    let factorization = factorizations.fold(f64::INFINITY, f64::min);
    let (mut right, mut below) = (vec![1.0; scene.unknowns()], vec![0.0; scene.constraints()]);
    let times = (0..20).map(|_| {
        let clock = Instant::now();
        saddle.solve(&mut right, &mut below);
        right.fill(1.0);
        clock.elapsed().as_secs_f64()
    });
    [times.fold(f64::INFINITY, f64::min), factorization]
}

#[test]
fn newton_comes_to_its_end_at_one_astronomical_unit() {
    for rtol in [1e-5, 1e-7, 1e-9] {
        let mut scene = Pointing::default()
            .build(Formulation::Rncf, Joints::Eliminated)
            .unwrap();
        assert_eq!(scene.constraints(), 2);
        // No unknown is measured by its distance from the Sun.
        assert!(scene.sizes().iter().all(|size| *size <= 1e4));
        let start = scene.rest(0.0);
        let mut integrator =
            Integrator::new(scene.as_mut(), start, 50.0, METHOD, options(rtol, StepSize::Adaptive)).unwrap();
        while integrator.step().unwrap() != Stop::End {}
        let (state, found) = (integrator.state().clone(), integrator.statistics().clone());
        println!(
            "rtol {rtol:.0e}: {} steps, {} iterations, {} rejected by Newton, constraints to {:.1e}",
            found.steps, found.newton_iterations, found.rejected_by_newton, found.max_constraint_residual
        );
        assert_eq!(found.rejected_by_newton, 0);
        // Increments at rtol 1e-9 are near round-off: there a step takes 4.13, else 3.4 and 3.9.
        assert!((found.newton_iterations as f64) < 4.2 * found.steps as f64);
        assert!(found.max_constraint_residual < 1e-13);
        // Velocities are on the constraints, too.
        let mut rates = [0.0; 2];
        scene.constraint(ConstraintLevel::Velocity, &state, &mut rates);
        let pattern = scene.constraint_pattern().clone();
        let mut jacobian = vec![0.0; pattern.entries()];
        scene.constraint_jacobian(&state, &mut jacobian);
        pattern.transpose_multiply_add(1.0, &jacobian, &state.v, &mut rates);
        assert!(rates.iter().all(|rate| rate.abs() < 1e-17), "{rates:?}");
    }
}

#[test]
#[ignore = "measurement: cargo test -p rncf-tests --test stability cost -- --ignored --nocapture"]
fn the_cost_of_a_step_beside_the_model_and_its_solutions() {
    let model = Pointing { elements: 833 };
    for (step, rtol, end) in [(StepSize::Fixed(0.01), 1e-7, 0.4), (StepSize::Adaptive, 1e-5, 1.0)] {
        let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let [solution, factorization] = solution_times(scene.as_mut());
        let unknowns = scene.unknowns();
        let start = scene.rest(0.0);
        let mut clocked = Clocked::new(scene.as_mut());
        let mut integrator = Integrator::new(&mut clocked, start, end, METHOD, options(rtol, step)).unwrap();
        let before = integrator.statistics().clone();
        let first: Vec<(f64, u32)> = integrator.system().spent.iter().map(Cell::get).collect();
        let clock = Instant::now();
        while integrator.step().unwrap() != Stop::End {}
        let total = clock.elapsed().as_secs_f64();
        let found = integrator.statistics().clone();
        let steps = (found.steps - before.steps) as f64;
        let (solves, factorizations) = (
            found.solves - before.solves,
            found.factorizations - before.factorizations,
        );
        println!("{unknowns} unknowns, {step:?}: {steps} steps, {solves} solutions, {factorizations} factorizations");
        let per_step = |time: f64| 1e3 * time / steps;
        let mut rest = total - solves as f64 * solution - factorizations as f64 * factorization;
        let spent: Vec<(f64, u32)> = integrator.system().spent.iter().map(Cell::get).collect();
        for (name, (now, then)) in ["residual", "tangent", "mass", "constraint", "jacobian"]
            .iter()
            .zip(spent.iter().zip(&first))
        {
            let (time, calls) = (now.0 - then.0, now.1 - then.1);
            rest -= time;
            println!("  {name}: {:.3} ms a step, {calls} calls", per_step(time));
        }
        let kept = [
            ("solutions", solves, solution),
            ("factorizations", factorizations, factorization),
        ];
        for (name, count, time) in kept {
            println!(
                "  {name}: {:.3} ms a step, {:.3} ms each",
                per_step(count as f64 * time),
                1e3 * time
            );
        }
        println!(
            "  total {:.3} ms a step, rest {:.3} ms",
            per_step(total),
            per_step(rest)
        );
    }
}
