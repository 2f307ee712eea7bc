//! Time of one Newton iteration of the E-sail by its parts, and of 200 s of its motion.
//!
//! `RAYON_NUM_THREADS=1 cargo run --release --example esail_speed`; arguments `TETHERS ELEMENTS` for another size.
//! Medians of wall times; the parts take turns, so that a busy machine slows all of them alike. Runs in processor time.

use std::time::Instant;

use rncf::linalg::Saddle;
use rncf::prelude::*;
use rncf::system::ConstraintLevel;
use rncf_models::Esail;

/// Rounds that are timed.
const ROUNDS: usize = 400;
/// Step of the iteration, s.
const STEP: f64 = 1.0;
/// Generalized-alpha with spectral radius 0.8: gamma, beta, and the factor of the mass.
const GAMMA: f64 = 0.5 + 1.0 / 9.0;
const BETA: f64 = 0.25 * (0.5 + GAMMA) * (0.5 + GAMMA);
const MASS: f64 = 10.0 / 9.0 / (10.0 / 9.0 - 4.0 / 9.0 + 1.0 / 3.0);

fn main() {
    let arguments: Vec<usize> = std::env::args().skip(1).filter_map(|text| text.parse().ok()).collect();
    let mut model = Esail::default();
    if let [tethers, elements] = arguments[..] {
        (model.tethers, model.elements) = (tethers, elements);
    }
    let start = Instant::now();
    let mut scene = built(&model);
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{} unknowns, {} constraints, {} entries; built in {:.0} ms",
        scene.unknowns(),
        scene.constraints(),
        scene.pattern().entries(),
        1e3 * seconds
    );
    let state = after(scene.as_mut(), 20.0);
    parts(scene.as_mut(), &state);
    run(&model);
}

/// The state that the scene reaches after `seconds`.
fn after(scene: &mut dyn Scene, seconds: f64) -> State {
    let start = scene.rest(0.0);
    let mut integrator =
        Integrator::new(scene, start, seconds, METHOD, fixed(STEP)).unwrap_or_else(|error| panic!("{error}"));
    while integrator.step().unwrap_or_else(|error| panic!("{error}")) != Stop::End {}
    integrator.state().clone()
}

const METHOD: Method = Method::GeneralizedAlpha { rho_inf: 0.8 };

fn fixed(step: f64) -> Options {
    Options {
        step: StepSize::Fixed(step),
        ..Options::default()
    }
}

/// Times the parts of an iteration at a state.
fn parts(scene: &mut dyn Scene, state: &State) {
    let (pattern, constraint_pattern) = (scene.pattern().clone(), scene.constraint_pattern().clone());
    let mut saddle = Saddle::new(&pattern, scene.border(), &constraint_pattern);
    let mut matrix = vec![0.0; pattern.entries()];
    let mut jacobian = vec![0.0; constraint_pattern.entries()];
    let (n, m) = (scene.unknowns(), scene.constraints());
    let (mut dynamics, mut constraints) = (vec![0.0; n], vec![0.0; m]);
    let factors = [MASS, GAMMA * STEP, BETA * STEP * STEP];
    let names = [
        "residual",
        "constraints",
        "iteration matrix",
        "factorization",
        "solution",
    ];
    let mut times = vec![Vec::new(); names.len()];
    for _ in 0..ROUNDS {
        let mut clock = Instant::now();
        let mut lap = |part: usize| {
            times[part].push(clock.elapsed().as_secs_f64());
            clock = Instant::now();
        };
        scene.residual(state, &mut dynamics);
        lap(0);
        scene.constraint_jacobian(state, &mut jacobian);
        constraint_pattern.multiply_add(1.0, &jacobian, &state.lambda, &mut dynamics);
        scene.constraint(ConstraintLevel::Position, state, &mut constraints);
        lap(1);
        scene.iteration_matrix(state, factors, &mut matrix);
        lap(2);
        saddle
            .factor_symmetric(&matrix, &jacobian)
            .unwrap_or_else(|singular| panic!("{singular:?}"));
        lap(3);
        saddle.solve(&mut dynamics, &mut constraints);
        lap(4);
    }
    let medians: Vec<f64> = times.iter_mut().map(|times| median(times)).collect();
    for (name, seconds) in names.iter().zip(&medians) {
        println!("{name:>20} {:8.1} us", 1e6 * seconds);
    }
    let full: f64 = medians.iter().sum();
    let kept = medians[0] + medians[1] + medians[4];
    println!("{:>20} {:8.1} us", "full iteration", 1e6 * full);
    println!("{:>20} {:8.1} us", "kept factorization", 1e6 * kept);
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Times 200 s of motion: fixed steps with their error against a quarter of the step, and an adaptive run.
fn run(model: &Esail) {
    for step in [1.0, 0.5] {
        let name = format!("steps of {step} s");
        let coarse = timed(model, METHOD, fixed(step), &name);
        let fine = timed(model, METHOD, fixed(step / 4.0), "a quarter of that");
        for (place, error) in errors(model, &coarse, &fine) {
            println!("{name}: error {error:.1e} of the deflection at {place}");
        }
    }
    let options = Options {
        rtol: 1e-7,
        ..Options::default()
    };
    timed(model, Method::Hht { alpha: -0.05 }, options, "HHT -0.05, rtol 1e-7");
}

/// Processor time of the main thread, s.
fn cpu() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds = text.split(' ').next().and_then(|text| text.parse().ok());
    nanoseconds.unwrap_or(f64::NAN) * 1e-9
}

/// Runs 200 s; the last state.
fn timed(model: &Esail, method: Method, options: Options, name: &str) -> State {
    let mut scene = built(model);
    let rest = scene.rest(0.0);
    let start = cpu();
    let integrator = Integrator::new(scene.as_mut(), rest, 200.0, method, options);
    let mut integrator = integrator.unwrap_or_else(|error| panic!("{error}"));
    let begun = cpu() - start;
    while integrator.step().unwrap_or_else(|error| panic!("{error}")) != Stop::End {}
    let seconds = cpu() - start;
    let counts = integrator.statistics();
    println!(
        "200 s, {name}: {seconds:.3} s of one core, of which {begun:.3} s to begin; {} steps, {} iterations, {} factorizations",
        counts.steps, counts.newton_iterations, counts.factorizations
    );
    integrator.state().clone()
}

/// Largest differences of nodal positions along each axis of the frame, with their places, relative to the largest displacement
/// since the start; the largest comes first.
fn errors(model: &Esail, state: &State, reference: &State) -> Vec<(String, f64)> {
    let scene = built(model);
    let rest = scene.rest(0.0);
    let places = (0..scene.unknowns() - scene.border()).filter(|&i| scene.sizes()[i] > 1.0);
    let named: Vec<(usize, String)> = places.map(|i| (i, scene.describe_unknown(i))).collect();
    let moved = named.iter().map(|&(i, _)| (reference.x[i] - rest.x[i]).abs());
    let deflection = moved.fold(0.0, f64::max);
    let error = |i: usize| (state.x[i] - reference.x[i]).abs() / deflection;
    let mut largest: Vec<(String, f64)> = Vec::new();
    for axis in ["x", "y", "z"] {
        let own = named.iter().filter(|(_, name)| name.ends_with(axis));
        let worst = own.max_by(|a, b| error(a.0).total_cmp(&error(b.0)));
        largest.extend(worst.map(|(i, name)| (name.clone(), error(*i))));
    }
    largest.sort_by(|a, b| b.1.total_cmp(&a.1));
    largest
}

fn built(model: &Esail) -> Box<dyn Scene> {
    let scene = model.build(Formulation::Rncf, Joints::Eliminated);
    scene.unwrap_or_else(|error| panic!("{error}"))
}
