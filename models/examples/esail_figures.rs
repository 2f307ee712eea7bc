//! Charts of the E-sail like Figs. 14 to 19 of the paper, for docs/esail.md.
//!
//! `cargo run --release --example esail_figures [FOLDER]`; the folder is docs/images without one.

use std::path::PathBuf;

use rncf::app::charts::{Chart, Line};
use rncf::app::{Figure, RunResult, RunSettings, run};
use rncf::model::Configuration;
use rncf::prelude::*;
use rncf_models::{Esail, EsailSlack};

/// Spins of most charts, deg/s, and their names.
const SPINS: [f64; 3] = [0.5, 1.0, 1.5];
const NAMES: [&str; 3] = ["0.5 deg/s", "1.0 deg/s", "1.5 deg/s"];
const SAILS: [(&str, f64); 2] = [("(a) 10 km", 10e3), ("(b) 20 km", 20e3)];

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn main() -> Outcome {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "docs/images".into()));
    let runs = |end: f64, elements: usize| {
        SAILS.map(|(_, length)| SPINS.map(|spin| follow(&sail(length, spin, elements), end)))
    };
    let short = runs(200.0, 16);
    let write = |name: &str, title: &str, figure: Figure| -> Outcome {
        let path = folder.join(name);
        std::fs::write(&path, figure.to_svg(title)?)?;
        println!("{}", path.display());
        Ok(())
    };
    write(
        "esail_radial.svg",
        "Radial displacement of the core",
        over_time(&short, "radial [m]", &["radial"]),
    )?;
    write("esail_shape.svg", "Tethers after 200 s", shapes(&short))?;
    write(
        "esail_tension.svg",
        "Tensions at the roots and in the ring",
        tensions(&short),
    )?;
    let torques = over_time(&short, "torque_x, torque_y [N m]", &["torque_x", "torque_y"]);
    write("esail_torque.svg", "Torques that point the sail at the Sun", torques)?;
    let long = runs(2000.0, 8);
    write(
        "esail_spin.svg",
        "Relative change of the spin over 2000 s",
        spins(&long),
    )?;
    write("esail_buckling.svg", "The sail buckles at 0.25 deg/s", buckling())
}

fn sail(length: f64, spin: f64, elements: usize) -> Esail {
    let mut model = Esail {
        spin: spin.to_radians(),
        elements,
        ..Esail::default()
    };
    if length > 15e3 {
        (model.length, model.voltage, model.core_mass) = (length, 20e3, 80.0);
    }
    model
}

/// A run and its final shape.
struct Motion {
    result: RunResult,
    shape: Configuration,
    /// Points of each line of the shape.
    points: Vec<usize>,
}

/// Steps of 1 s; where the ring buckles they adapt.
fn follow<M: Model>(model: &M, end: f64) -> Motion {
    let buckles = M::params()
        .iter()
        .position(|param| param.name == "spin")
        .is_some_and(|index| model.get(index) < 0.005);
    let settings = RunSettings {
        method: if buckles {
            Method::Radau
        } else {
            Method::GeneralizedAlpha { rho_inf: 0.8 }
        },
        options: Options {
            step: if buckles {
                StepSize::Adaptive
            } else {
                StepSize::Fixed(1.0)
            },
            rtol: if buckles { 1e-6 } else { 1e-10 },
            ..Options::default()
        },
        t_end: Some(end),
        every: Some((end / 400.0).max(1.0)),
        ..RunSettings::default()
    };
    let result = run(model, &settings).unwrap_or_else(|error| panic!("{error}"));
    let mut scene = model
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap_or_else(|error| panic!("{error}"));
    let mut shape = Configuration::default();
    scene.configuration(&result.state, &mut shape);
    let points = scene.curves().iter().map(|curve| curve.points).collect();
    Motion { result, shape, points }
}

/// An output over time.
fn line(motion: &Motion, output: &str, color: usize, of: impl Fn(f64) -> f64) -> Line {
    let history = &motion.result.history;
    let index = history.find(output).unwrap_or_else(|| panic!("no output {output}"));
    Line::new(history.keys.iter().copied().zip(history.column(index).map(of)), color)
}

fn chart(x: &str, y: &str, lines: Vec<Line>) -> Chart {
    Chart {
        x: x.into(),
        y: y.into(),
        lines,
        ..Chart::default()
    }
}

/// Both sails; a colour for each spin, all outputs in it.
fn over_time(runs: &[[Motion; 3]; 2], axis: &str, outputs: &[&str]) -> Figure {
    let mut figure = Figure::default();
    for ((name, _), motions) in SAILS.iter().zip(runs) {
        let lines = motions.iter().enumerate().flat_map(|(color, motion)| {
            outputs
                .iter()
                .map(move |output| line(motion, output, color, |value| value))
        });
        figure.add(name, &NAMES, chart("t [s]", axis, lines.collect()));
    }
    figure
}

/// Change of the spin relative to that at the start.
fn spins(runs: &[[Motion; 3]; 2]) -> Figure {
    let mut figure = Figure::default();
    for ((name, _), motions) in SAILS.iter().zip(runs) {
        let lines = motions.iter().zip(SPINS).enumerate();
        let lines =
            lines.map(|(color, (motion, spin))| line(motion, "spin", color, |value| 1e4 * (value / spin - 1.0)));
        figure.add(
            name,
            &NAMES,
            chart("t [s]", "change of the spin [1e-4]", lines.collect()),
        );
    }
    figure
}

/// Greatest tension at the roots, greatest and least of the ring; of the slowest 10 km sail once more by itself.
fn tensions(runs: &[[Motion; 3]; 2]) -> Figure {
    let lines = |motion: &Motion, color: usize| {
        let kinds = [("tension_main", 0), ("tension_aux_max", 1), ("tension_aux_min", 1)];
        kinds.map(|(output, kind)| line(motion, output, color + kind, |value| value))
    };
    let mut figure = Figure::default();
    for ((name, _), motions) in SAILS.iter().zip(runs) {
        let all = motions
            .iter()
            .enumerate()
            .flat_map(|(spin, motion)| lines(motion, 2 * spin));
        let names = [
            "0.5 deg/s: roots",
            "ring",
            "1.0 deg/s: roots",
            "ring",
            "1.5 deg/s: roots",
            "ring",
        ];
        figure.add(name, &names, chart("t [s]", "tension [N]", all.collect()));
    }
    let slowest = lines(&runs[0][0], 0).into_iter().collect();
    figure.add(
        "10 km, 0.5 deg/s",
        &["roots", "ring"],
        chart("t [s]", "tension [N]", slowest),
    );
    figure
}

/// How far main tethers are out of the plane, over their radius.
fn shapes(runs: &[[Motion; 3]; 2]) -> Figure {
    let mut figure = Figure::default();
    for ((name, _), motions) in SAILS.iter().zip(runs) {
        let lines = motions.iter().enumerate().flat_map(|(color, motion)| {
            [0, 25, 50, 75].map(|tether| {
                let first: usize = motion.points[..tether].iter().sum();
                let points = &motion.shape.points[first..first + motion.points[tether]];
                Line::new(
                    points.iter().map(|point| (point[0].hypot(point[1]) / 1e3, point[2])),
                    color,
                )
            })
        });
        figure.add(
            &format!("{name}, every 25th tether"),
            &NAMES,
            chart("radius [km]", "z [m]", lines.collect()),
        );
    }
    figure
}

/// 10 km, 0.25 deg/s: tensions with both kinds of tethers, radial displacements, torques, tips.
fn buckling() -> Figure {
    let slow = Esail {
        asymmetry: 1e-6,
        ..sail(10e3, 0.25, 16)
    };
    let slack = EsailSlack::default();
    let (taut, slack, fast) = (
        follow(&slow, 200.0),
        follow(&slack, 200.0),
        follow(&sail(10e3, 0.5, 16), 200.0),
    );
    let mut figure = Figure::default();
    let tensions = |motion: &Motion| -> Vec<Line> {
        let outputs = ["tension_main", "tension_aux_min", "tension_aux_max"];
        outputs
            .iter()
            .enumerate()
            .map(|(color, output)| line(motion, output, color, |value| value))
            .collect()
    };
    let names = ["greatest at a root", "least in the ring", "greatest in the ring"];
    figure.add(
        "Tethers that carry compression",
        &names,
        chart("t [s]", "tension [N]", tensions(&taut)),
    );
    figure.add(
        "Tethers that do not (slack = true)",
        &names,
        chart("t [s]", "tension [N]", tensions(&slack)),
    );
    let both = |output: &str| {
        vec![
            line(&taut, output, 0, |value| value),
            line(&slack, output, 1, |value| value),
        ]
    };
    let mut radial = both("radial");
    radial.push(line(&fast, "radial", 2, |value| value));
    let kinds = ["with compression", "without"];
    let names = ["with compression", "without", "0.5 deg/s"];
    figure.add("Radial displacement", &names, chart("t [s]", "radial [m]", radial));
    let torques = [both("torque_x"), both("torque_y")].into_iter().flatten().collect();
    figure.add(
        "Torques, made by the mesh",
        &kinds,
        chart("t [s]", "torque_x, torque_y [N m]", torques),
    );
    let tips = vec![tips(&taut, 0), tips(&slack, 1)];
    figure.add("Tips after 200 s", &kinds, chart("tether", "z [m]", tips));
    figure
}

/// How far the tips are out of the plane.
fn tips(motion: &Motion, color: usize) -> Line {
    let mut last = 0;
    let tips = motion.points[..Esail::default().tethers]
        .iter()
        .enumerate()
        .map(|(tether, points)| {
            last += points;
            (tether as f64, motion.shape.points[last - 1][2])
        });
    Line::new(tips.collect::<Vec<_>>(), color)
}
