//! Energy-momentum integration: 100 000 steps of a bow that tumbles freely, and beside the other integrators on the freely
//! tumbling cable (absolute coordinates): work, error of the end's place and change of the energy over 2 s.
//!
//! `cargo run --release --example energy_momentum`

use rncf::app::{RunSettings, run};
use rncf::prelude::*;
use rncf_models::FreeFlight;

rncf::model! {
    /// A soft bow that flies and tumbles in space; its frame is no unknown in absolute coordinates.
    model Bow {
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; poisson = 0.3; }
        section bar = rectangle(y = 5 cm, z = 3 cm);
        frame f = free(velocity = [-3, 1, 2] m/s, angular_velocity = [2, -1, 1] rad/s);
        body bow in f {
            spatial;
            mean_axes;
            arc from [0, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius 1.5 m angle 80 deg;
            mesh 2 * beam(bar, soft);
        }
        fixture tip on bow.end { mass = 0.7 kg; }
        output end = bow.end.in(inertial);
    }
}

/// Time of the comparison, s: later the frame of the cable loses the direction that it follows.
const SPAN: f64 = 2.0;

fn main() {
    let (change, steps) = change_of_energy(&Bow::default(), Method::EnergyMomentum, fixed(0.005), 500.0);
    println!("{steps} steps of 5 ms: the energy changes by {change} of itself at most\n");
    let reference = places(Method::Radau, adaptive(1e-12));
    println!(
        "| integrator | setting | steps | residuals | factorizations | CPU (ms) | error of the end (m) | change of energy |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let energy = ("energy-momentum", Method::EnergyMomentum);
    for h in [0.01, 0.005, 0.002, 0.001] {
        row(energy, &format!("{h} s"), fixed(h), &reference);
    }
    let alpha = Method::GeneralizedAlpha { rho_inf: 0.8 };
    for (name, method) in [
        ("generalized-alpha 1", Method::GeneralizedAlpha { rho_inf: 1.0 }),
        ("generalized-alpha 0.8", alpha),
        ("HHT -0.05", Method::Hht { alpha: -0.05 }),
    ] {
        for h in [0.01, 0.005, 0.002, 0.001] {
            row((name, method), &format!("{h} s"), fixed(h), &reference);
        }
    }
    for (name, method) in [energy, ("generalized-alpha 0.8", alpha), ("Radau", Method::Radau)] {
        for rtol in [1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
            row((name, method), &format!("rtol {rtol:e}"), adaptive(rtol), &reference);
        }
    }
}

fn fixed(h: f64) -> Options {
    Options {
        step: StepSize::Fixed(h),
        ..Options::default()
    }
}

fn adaptive(rtol: f64) -> Options {
    Options {
        rtol,
        ..Options::default()
    }
}

fn row((name, method): (&str, Method), setting: &str, options: Options, reference: &[[f64; 3]]) {
    let settings = RunSettings {
        formulation: Formulation::Ancf,
        method,
        options,
        t_end: Some(SPAN),
        ..RunSettings::default()
    };
    let Ok(result) = run(&FreeFlight::default(), &settings) else {
        println!("| {name} | {setting} | fails | | | | | |");
        return;
    };
    let counts = &result.statistics;
    let found = places(method, options);
    let far = |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
    let error = found.iter().zip(reference).map(far).fold(0.0, f64::max);
    println!(
        "| {name} | {setting} | {} | {} | {} | {:.1} | {error:.1e} | {} |",
        counts.steps,
        counts.residual_evaluations,
        counts.factorizations,
        1e3 * result.seconds.cpu,
        change_of_energy(&FreeFlight::default(), method, options, SPAN).0,
    );
}

/// Place of the end every tenth of a second.
fn places(method: Method, options: Options) -> Vec<[f64; 3]> {
    let settings = RunSettings {
        formulation: Formulation::Ancf,
        method,
        options,
        t_end: Some(SPAN),
        ..RunSettings::default()
    };
    let result = run(&FreeFlight::default(), &settings).unwrap_or_else(|error| panic!("{error}"));
    let columns: [Vec<f64>; 3] = [3, 4, 5].map(|column| result.history.column(column).collect());
    (0..columns[0].len())
        .map(|at| [0, 1, 2].map(|k| columns[k][at]))
        .collect()
}

/// Largest relative change of the energy at the ends of the steps, as text, and the number of steps.
fn change_of_energy(model: &impl Model, method: Method, options: Options, end: f64) -> (String, u64) {
    let mut scene = model.scene::<Ancf>().unwrap_or_else(|error| panic!("{error}"));
    let start = scene.rest(0.0);
    let energy = |scene: &mut dyn Scene, state: &State| scene.energy(state).unwrap_or(f64::NAN);
    let first = energy(scene.as_mut(), &start);
    let mut integrator = match Integrator::new(scene.as_mut(), start, end, method, options) {
        Ok(integrator) => integrator,
        Err(error) => panic!("{error}"),
    };
    let mut most = 0.0_f64;
    loop {
        match integrator.step() {
            Err(error) => return (format!("fails at {:.1} s", error.t), integrator.statistics().steps),
            Ok(stop) => {
                let state = integrator.state().clone();
                most = most.max((energy(integrator.system(), &state) - first).abs() / first);
                if stop == Stop::End {
                    return (format!("{most:.1e}"), integrator.statistics().steps);
                }
            }
        }
    }
}
