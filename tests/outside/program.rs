//! A user's crate with a scene of its own: it builds against the facade, runs from the command line, and moves as
//! formulas that were written by hand.

use rncf::equilibrium::{Kind, Uniform, follow};
use rncf::model::Configuration;
use rncf::nalgebra::{UnitQuaternion, Vector3};
use rncf::{Formulation, Joints, Model};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use rncf_reference::beam::{Beam, Root};
use rncf_reference::element::Data;
use rncf_reference::integrate::{Method, agreed};
use rncf_reference::rotating_beam::RotatingBeam;
use rncf_reference::swing::Swing;

const ELEMENTS: usize = 5;
const LENGTH: f64 = 1.2;

/// The model of `src/lib.rs` by hand.
fn reference() -> RotatingBeam<Swing> {
    let (radius, young, density) = (2e-3_f64, 2.7e9, 1150.0);
    let area = std::f64::consts::PI * radius.powi(2);
    let data = Data {
        dimension: 2,
        length: LENGTH,
        mass_per_length: density * area,
        axial_stiffness: young * area,
        bending_stiffness: young * std::f64::consts::PI * radius.powi(4) / 4.0,
        exponent: 2,
        damping: 0.4e-3,
        points: 5,
    };
    let beam = Beam {
        elements: ELEMENTS,
        length: LENGTH,
        hub_radius: 0.2,
        root: Root::Clamped,
        element: data,
    };
    let motion = Swing::new(1.5, 3.0_f64.to_radians(), 11.0).expect("finite values");
    RotatingBeam::new(beam, motion).expect("a beam")
}

rncf::model! {
    use swing::cords::cords;
    /// Cords of another crate, and an element of its own.
    pub model Hung {
        /// Bar of this model.
        element bar(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain l = norm(a) - 1;
            energy stretching = 1/2*300 [N]*l^2;
        }
        body line in inertial { spatial; line from [-1, 0, 0] m to [-1, 0, -1] m; mesh 1 * cord(thin, light); }
        joint top = pin(line.start, inertial);
        joint guide_x = hold(line.end.x);
        joint guide_y = hold(line.end.y);
        fixture stone on line.end { mass = 10 kg; }
        body rod in inertial { spatial; line from [-2, 0, 0] m to [-2, 0, -1] m; mesh 1 * bar(thin, light); }
        joint roof = pin(rod.start, inertial);
        joint rod_x = hold(rod.end.x);
        joint rod_y = hold(rod.end.y);
        fixture block on rod.end { mass = 10 kg; }
        for i in 0..2 { part plumb[i] = Plumb(stiffness = 300 N * (1 + i), side = 1 m * i, ageing = 2 s); }
        load weight = gravity([0, 0, -9.81] m/s^2);
        output of_cord = -line.end.z - 1 m;
        output of_bar = -rod.end.z - 1 m;
    }
}

/// Stretches under the weight of the stone and half of the cord solve the laws of their elements, wherever these are declared.
#[test]
fn elements_go_from_crate_to_crate() {
    let mut scene = Hung::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .expect("a scene");
    for t in [0.0, 1.0_f64] {
        let at = Uniform {
            kind: Kind::Static,
            ..Uniform::steady(t)
        };
        let found = follow(scene.as_mut(), &at, 0.25, |_, _| ()).expect("an equilibrium");
        let state = found.state().expect("an equilibrium").clone();
        let mut row = vec![0.0; scene.output_columns()];
        scene.uniform_outputs(&at, &state, &mut row);
        let weight = 10.15 * 9.81;
        let age = (-t / 2.0).exp();
        // Outputs of parts come first.
        let laws = [(300.0 * age, 2.0), (600.0 * age, 2.0), (300.0, 2.0), (300.0, 0.0)];
        assert_eq!(row.len(), laws.len());
        for (l, (stiffness, stiffening)) in row.iter().zip(laws) {
            let tension = stiffness * (l + stiffening * l.powi(3));
            assert!((tension / weight - 1.0).abs() < 1e-9, "{t} s: {row:?}");
        }
    }
}

/// What a scene tells is of nalgebra's types, in the version that the facade names.
#[test]
fn places_and_rotations_are_those_of_nalgebra() {
    let mut scene = swing::Swing::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .expect("a scene");
    let t = 0.7_f64;
    let theta = 1.5 * t * t / 2.0 + 3.0_f64.to_radians() * (1.0 - (11.0 * t).cos());
    let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), theta);
    let state = scene.rest(t);
    let mut picture = Configuration::default();
    scene.configuration(&state, &mut picture);
    let (place, rotation): (Vector3<f64>, UnitQuaternion<f64>) = picture.poses[1];
    let tip: Vector3<f64> = *picture.points.last().expect("the arm");
    assert!((place + rotation * tip - turned * Vector3::new(0.2 + LENGTH, 0.0, 0.0)).norm() < 1e-12);
    let centre = scene.masses(&state)[0].centre;
    assert!((centre - turned * Vector3::new(0.2 + 0.5 * LENGTH, 0.0, 0.0)).norm() < 1e-12);
}

/// A folder for files of these tests.
fn scratch() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
}

/// The crate's program.
fn program() -> PathBuf {
    PathBuf::from(env!("CARGO_BIN_EXE_swing"))
}

/// The program with a folder for its files and further words.
fn run(program: &Path, out: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(["run", "--quiet", "--out"]).arg(out).args(words);
    command
}

fn finish(mut command: Command) {
    let output = command.output().expect("the program runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
}

/// Runs the crate's program into a folder, and returns the rows of its history.
fn history(formulation: &str) -> Vec<[f64; 3]> {
    let out = scratch().join(format!("outside-{formulation}"));
    finish(run(&program(), &out, &["--formulation", formulation, "--rtol", "1e-9"]));
    let table = fs::read_to_string(out.join("history.csv")).expect("the run wrote its history");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("t [s],u [m],v [m]"));
    let row = |line: &str| -> [f64; 3] {
        let row: Vec<f64> = line.split(',').map(|text| text.parse().expect("a number")).collect();
        row.try_into().expect("three columns")
    };
    lines.map(row).collect()
}

#[test]
fn a_scene_of_its_own_moves_as_formulas_by_hand() {
    let reference = reference();
    let times: Vec<f64> = (0..=20).map(|k| f64::from(k) / 10.0).collect();
    // Twice the reference's own tolerances agree far below what is asked of the program.
    let run = agreed(&reference, Method::Radau5, 1e-11, &reference.rest(), &times, 1e-6).expect("two runs that agree");
    let mut largest = 0.0;
    for formulation in ["rncf", "ancf"] {
        let rows = history(formulation);
        assert_eq!(rows.len(), times.len());
        let mut worst = 0.0;
        for ((row, time), state) in rows.iter().zip(&times).zip(&run.states) {
            let [u, v, _] = reference.tip(state);
            assert!((row[0] - time).abs() < 1e-12, "{} s instead of {time} s", row[0]);
            worst = f64::max(worst, f64::max((row[1] - u).abs(), (row[2] - v).abs()));
            largest = f64::max(largest, v.abs());
        }
        println!("{formulation}: differs by {worst:.1e} m of {largest:.2} m");
        // A tolerance of 1e-9 of the length in each step, ten times; a term that is wrong or missing (hub radius,
        // damping, exponent of bending) shows in the third digit of v.
        assert!(worst < 10.0 * 1e-9 * LENGTH, "{formulation}: {worst}");
        assert!(largest > 0.1 * LENGTH, "the rod should bend visibly, by {largest} m");
    }
}

/// Rows and all else that a run has gathered survive a kill, and the run goes on from there as if nothing had been.
#[test]
fn a_killed_run_goes_on_to_the_same_history() {
    let program = program();
    let [whole, killed] = ["whole", "killed"].map(|name| scratch().join(format!("outside-{name}")));
    let words = ["--rtol", "1e-9", "--every", "50 us"];
    finish(run(&program, &whole, &words));
    let _ = fs::remove_dir_all(&killed);
    let history = |folder: &Path| fs::read(folder.join("history.csv")).unwrap_or_default();
    let complete = history(&whole);
    let words_again = [&words[..], &["--resume"]].concat();
    let mut kills = 0;
    for (words, least) in [
        (&words[..], 1),
        (&words_again, complete.len() / 4),
        (&words_again, complete.len() / 2),
    ] {
        let mut process = run(&program, &killed, words).spawn().expect("the program runs");
        let is_enough = || history(&killed).len() >= least && killed.join("checkpoint").exists();
        while !is_enough() && process.try_wait().expect("it is a child").is_none() {
            std::thread::sleep(Duration::from_millis(5));
        }
        // What the last one left may be enough.
        std::thread::sleep(Duration::from_millis(100));
        process.kill().expect("it is a child");
        kills += u32::from(!process.wait().expect("it is a child").success());
    }
    assert!(kills >= 2, "it ended before it was killed");
    finish(run(&program, &killed, &words_again));
    assert!(history(&killed) == complete);
    assert_eq!(complete.iter().filter(|&&byte| byte == b'\n').count(), 40_002);
    assert!(!killed.join("checkpoint").exists());
}

/// Five elements of four components, a clamp that takes three of them.
#[test]
fn the_model_is_explained() {
    let output = Command::new(program())
        .arg("explain")
        .output()
        .expect("the program runs");
    assert!(output.status.success());
    let text = String::from_utf8_lossy(&output.stdout);
    let value = |name: &str| {
        let line = text
            .lines()
            .find(|line| line.trim_start().starts_with(name))
            .expect(name);
        line.split_whitespace().last().unwrap_or_default().to_string()
    };
    assert_eq!(value("unknowns "), (4 * (ELEMENTS + 1) - 3).to_string());
    assert_eq!(value("eliminated conditions"), "3");
    assert!(text.contains("CABLE_PLANAR_EXACT_DAMPED_MASS_MATRIX"), "{text}");
}

/// The fifth frequency of three elements is more than 1 % too high: the model card says so.
#[test]
fn first_frequencies_of_a_coarse_mesh_are_told_to_be_that() {
    let out = scratch().join("outside-card");
    let words = [
        "gain=0 rad/s^2",
        "amplitude=0 deg",
        "elements=3",
        "--t-end",
        "0.1 s",
        "--every",
        "0.1 s",
    ];
    finish(run(&program(), &out, &words));
    let page = fs::read_to_string(out.join("report.html")).expect("the run wrote its report");
    let row = page
        .split("<th>First frequencies</th>")
        .nth(1)
        .and_then(|rest| rest.split("</tr>").next());
    let row = row.expect("the card has first frequencies");
    println!("{row}");
    assert!(row.contains("The mesh is too coarse for these modes"), "{row}");
}
