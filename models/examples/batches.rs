//! What four runs of one model with other parameters would gain side by side, one in each lane: their steps in common are
//! the shortest that any of them needs, and each takes as many as that makes.
//!
//! `cargo run --release --example batches`

use rncf::AnyModel;
use rncf::app::{RunSettings, StepTaken, run};
use rncf_models::{AndrewsSqueezer, Esail, FlyballGovernor, Motor, SliderCrank, SpinUp};

/// Runs side by side.
const LANES: usize = 4;

fn main() {
    println!("| scene | varied | steps of each | in common | price |");
    println!("|---|---|---|---|---|");
    row("spin_up", "omega_s 3 to 5 rad/s", None, |at| {
        Box::new(SpinUp {
            omega_s: 3.0 + 2.0 * at,
            ..SpinUp::default()
        })
    });
    row("spin_up", "omega_s 4 rad/s, 1 % apart", None, |at| {
        Box::new(SpinUp {
            omega_s: 4.0 * (1.0 + 0.03 * at),
            ..SpinUp::default()
        })
    });
    row("motor", "speed 7500 to 12500 rpm", None, |at| {
        Box::new(Motor {
            speed: (7500.0 + 5000.0 * at) * std::f64::consts::PI / 30.0,
            ..Motor::default()
        })
    });
    row("motor", "eccentricity 20 to 50 mm", None, |at| {
        Box::new(Motor {
            eccentricity: 0.02 + 0.03 * at,
            ..Motor::default()
        })
    });
    row("slider_crank", "omega_s 6 to 10 rad/s", None, |at| {
        Box::new(SliderCrank {
            omega_s: 6.0 + 4.0 * at,
            ..SliderCrank::default()
        })
    });
    row("andrews_squeezer", "torque 0.03 to 0.036 N m", None, |at| {
        Box::new(AndrewsSqueezer {
            torque: 0.03 + 0.006 * at,
        })
    });
    row("flyball_governor", "as declared, four times", None, |_| {
        Box::new(FlyballGovernor::default())
    });
    row("esail", "voltage 30 to 50 kV", Some(20.0), |at| {
        Box::new(Esail {
            voltage: 3e4 + 2e4 * at,
            ..Esail::default()
        })
    });
}

/// The runs of a scene whose parameters go from 0 to 1, with the default method and tolerance.
fn row(scene: &str, varied: &str, t_end: Option<f64>, model: impl Fn(f64) -> Box<dyn AnyModel>) {
    let settings = RunSettings {
        t_end,
        ..RunSettings::default()
    };
    let runs: Vec<Vec<StepTaken>> = (0..LANES)
        .map(|lane| {
            let model = model(lane as f64 / (LANES - 1) as f64);
            match run(model.as_ref(), &settings) {
                Ok(result) => result.steps,
                Err(error) => panic!("{scene}: {error}"),
            }
        })
        .collect();
    let counts: Vec<String> = runs.iter().map(|steps| steps.len().to_string()).collect();
    let (common, mean) = (
        in_common(&runs),
        runs.iter().map(Vec::len).sum::<usize>() as f64 / LANES as f64,
    );
    println!(
        "| {scene} | {varied} | {} | {common} | {:.2} |",
        counts.join(", "),
        common as f64 / mean
    );
}

/// Number of steps where each is the shortest that any run takes at its time.
fn in_common(runs: &[Vec<StepTaken>]) -> usize {
    let end = runs[0].last().map_or(0.0, |step| step.t);
    let (mut t, mut count) = (0.0, 0);
    while t < end * (1.0 - 1e-12) {
        let here = runs.iter().filter_map(|steps| {
            let at = steps.partition_point(|step| step.t <= t);
            steps.get(at).map(|step| step.h)
        });
        t += here.fold(f64::INFINITY, f64::min);
        count += 1;
    }
    count
}
