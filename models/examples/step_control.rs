//! Error over tolerance of all integrators, and where Radau's advantage ends: at low accuracy, with many unknowns, with
//! many switches (docs/step_control.md).
//!
//! `cargo run --release --example step_control` prints the tables and writes `step_control.svg`; a word, `tolerances`,
//! `accuracy`, `size` or `switches`, prints one table.

use rncf::app::charts::{Chart, Line};
use rncf::app::{Figure, RunResult, RunSettings, run};
use rncf::prelude::*;
use rncf_models::{Esail, HeavyTop, Motor, SliderCrank, SpinUp};

rncf::model! {
    /// A beam that is pushed to and fro by a load of square waves.
    pub model Pushed {
        /// Number of elements.
        param elements: count = 8;
        /// Time between two switches.
        param pause = 1 s;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; damping = 1 ms; }
        section strip { area = 1 cm^2; second_moment = 0.02 cm^4; }
        motion gate(t) = if sin(pi * t / pause) > 0 { 1 } else { -1 };
        body beam in inertial {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh elements * cable(strip, aluminium);
        }
        joint root = clamp(beam.start, inertial);
        load push = gravity([0, gate(t) * 2 [m/s^2], 0]);
        output v = beam.end.y;
        run { t_end = 4 s; every = 0.02 s; }
    }
}

const METHODS: [(&str, Method); 4] = [
    ("Radau", Method::Radau),
    ("HHT −0.05", Method::Hht { alpha: -0.05 }),
    ("HHT −0.3", Method::Hht { alpha: -0.3 }),
    ("generalized-α 0.8", Method::GeneralizedAlpha { rho_inf: 0.8 }),
];

/// Tolerance of the converged runs.
const CONVERGED: f64 = 1e-11;
/// Repetitions of a run whose time counts: the fastest does.
const REPETITIONS: usize = 3;

fn main() {
    let word = std::env::args().nth(1);
    let wanted = |name: &str| word.as_deref().is_none_or(|word| word == name);
    if wanted("tolerances") {
        tolerances();
    }
    if wanted("accuracy") {
        println!(
            "\n| scene | unknowns | error, part of the largest | Radau ms (steps) | HHT −0.05 ms (steps) | HHT −0.3 ms (steps) | generalized-α ms (steps) | best of the others / Radau |\n|---|---|---|---|---|---|---|---|"
        );
        let levels = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];
        costs("spin-up, 16 elements", &spin_up(16), 1, &levels);
        costs("slider-crank, 8 elements", &SliderCrank::default(), 2, &levels);
        costs("heavy top", &HeavyTop::default(), 0, &levels);
    }
    if wanted("size") {
        println!(
            "\n| scene | unknowns | error, part of the largest | Radau ms (steps) | HHT −0.05 ms (steps) | HHT −0.3 ms (steps) | generalized-α ms (steps) | best of the others / Radau |\n|---|---|---|---|---|---|---|---|"
        );
        for elements in [4, 64, 256] {
            costs(
                &format!("spin-up, {elements} elements"),
                &spin_up(elements),
                1,
                &[1e-2, 1e-4],
            );
        }
        let sail = Esail {
            elements: 4,
            spin: 1_f64.to_radians(),
            ..Esail::default()
        };
        costs("E-sail, 4 elements", &sail, 1, &[1e-2, 1e-4]);
    }
    if wanted("switches") {
        println!(
            "\n| time between switches (s) | unknowns | error, part of the largest | Radau ms (steps) | HHT −0.05 ms (steps) | HHT −0.3 ms (steps) | generalized-α ms (steps) | best of the others / Radau |\n|---|---|---|---|---|---|---|---|"
        );
        for pause in [4.0, 1.0, 0.25, 0.05, 0.01] {
            let model = Pushed {
                pause,
                ..Pushed::default()
            };
            costs(&format!("{pause}"), &model, 0, &[1e-2, 1e-4]);
        }
    }
}

fn spin_up(elements: usize) -> SpinUp {
    SpinUp {
        elements,
        ..SpinUp::default()
    }
}

/// A run, or why there is none.
fn solve<M: Model>(model: &M, method: Method, options: Options) -> Result<RunResult, String> {
    let settings = RunSettings {
        method,
        options,
        ..RunSettings::default()
    };
    run(model, &settings).map_err(|error| error.to_string())
}

fn tolerance(rtol: f64) -> Options {
    Options {
        rtol,
        ..Options::default()
    }
}

/// Largest difference of one output on the grid of the history, and the output's largest value.
fn error(result: &RunResult, reference: &RunResult, column: usize) -> (f64, f64) {
    let pairs = result.history.column(column).zip(reference.history.column(column));
    pairs.fold((0.0, 0.0), |(error, largest): (f64, f64), (a, b)| {
        (error.max((a - b).abs()), largest.max(b.abs()))
    })
}

fn tolerances() {
    let mut figure = Figure::default();
    println!(
        "| scene | integrator | rtol | proportional | steps | rejected | Newton | factorizations | error |\n|---|---|---|---|---|---|---|---|---|"
    );
    errors(&mut figure, "Spin-up: v [m]", "spin-up", &spin_up(16), 1);
    errors(&mut figure, "Heavy top: x [m]", "heavy top", &HeavyTop::default(), 0);
    let damped = SliderCrank {
        damping: 1e-4,
        ..SliderCrank::default()
    };
    errors(
        &mut figure,
        "Slider-crank, damped: middle [m]",
        "slider-crank, damped",
        &damped,
        2,
    );
    let motor = Motor {
        speed: 15_000.0 * std::f64::consts::PI / 30.0,
        T_s: 0.2,
        ..Motor::default()
    };
    errors(&mut figure, "Motor, 15000 rpm: middle [m]", "motor", &motor, 0);
    let svg = figure.to_svg("Errors of four integrators over the tolerance");
    let svg = svg.unwrap_or_else(|error| panic!("{error}"));
    std::fs::write("step_control.svg", svg).unwrap_or_else(|error| panic!("step_control.svg: {error}"));
}

/// Rows and a chart of one scene; the dots are those of the proportional tolerance.
fn errors<M: Model>(figure: &mut Figure, heading: &str, name: &str, model: &M, column: usize) {
    let reference = solve(model, Method::Radau, tolerance(CONVERGED)).unwrap_or_else(|error| panic!("{error}"));
    let mut chart = Chart {
        x: "log10 of the tolerance".into(),
        y: "error".into(),
        logarithmic: true,
        ..Chart::default()
    };
    for (color, (integrator, method)) in METHODS.into_iter().enumerate() {
        let mut points = Vec::new();
        for proportional in [false, true] {
            if proportional && method == Method::Radau {
                continue; // as it is
            }
            let last = if proportional { 6 } else { 9 };
            for exponent in 2 + i32::from(!proportional)..=last {
                let rtol = 10f64.powi(-exponent);
                let options = Options {
                    proportional,
                    ..tolerance(rtol)
                };
                let result = match solve(model, method, options) {
                    Ok(result) => result,
                    Err(error) => {
                        println!("| {name} | {integrator} | {rtol:.0e} | {error} |");
                        continue;
                    }
                };
                let (error, _) = error(&result, &reference, column);
                let s = &result.statistics;
                println!(
                    "| {name} | {integrator} | {rtol:.0e} | {} | {} | {} | {} | {} | {error:.1e} |",
                    if proportional { "yes" } else { "" },
                    s.steps,
                    s.rejected_steps,
                    s.newton_iterations,
                    s.factorizations
                );
                let point = (-f64::from(exponent), error.max(1e-16));
                if proportional && exponent < 3 {
                    continue; // beside the axis of the others
                }
                if proportional {
                    chart.lines.push(Line::dots([point], color));
                } else {
                    points.push(point);
                }
            }
        }
        chart.lines.push(Line::new(points, color));
    }
    figure.add(heading, &METHODS.map(|(name, _)| name), chart);
}

/// One row for each wanted accuracy: the cheapest run of every method that has it.
fn costs<M: Model>(name: &str, model: &M, column: usize, levels: &[f64]) {
    let reference = solve(model, Method::Radau, tolerance(1e-10)).unwrap_or_else(|error| panic!("{error}"));
    let least = levels.iter().copied().fold(f64::INFINITY, f64::min);
    // Error as a part of the largest value, seconds, steps.
    let curves = METHODS.map(|(_, method)| {
        let mut curve: Vec<(f64, f64, u64)> = Vec::new();
        for half in 4..=20 {
            let rtol = 10f64.powf(-0.5 * f64::from(half));
            let Ok(mut result) = solve(model, method, tolerance(rtol)) else {
                continue;
            };
            for _ in 1..REPETITIONS {
                if let Ok(again) = solve(model, method, tolerance(rtol))
                    && again.seconds.cpu < result.seconds.cpu
                {
                    result = again;
                }
            }
            let (error, largest) = error(&result, &reference, column);
            curve.push((error / largest, result.seconds.cpu, result.statistics.steps));
            if error < least * largest || result.statistics.steps > 30_000 {
                break;
            }
        }
        curve
    });
    for &level in levels {
        let best = curves.each_ref().map(|curve| {
            let enough = curve.iter().filter(|(error, ..)| *error <= level);
            enough.min_by(|a, b| a.1.total_cmp(&b.1)).copied()
        });
        let cells = best.map(|found| match found {
            Some((_, seconds, steps)) => format!("{:.1} ({steps})", 1e3 * seconds),
            None => "—".into(),
        });
        let others = best[1..]
            .iter()
            .flatten()
            .map(|found| found.1)
            .fold(f64::INFINITY, f64::min);
        let ratio = match best[0] {
            Some((_, seconds, _)) if others.is_finite() => format!("{:.2}", others / seconds),
            _ => "—".into(),
        };
        println!(
            "| {name} | {} | {level:.0e} | {} | {ratio} |",
            reference.unknowns,
            cells.join(" | ")
        );
    }
}
