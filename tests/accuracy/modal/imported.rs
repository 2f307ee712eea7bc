//! Bodies from finite-element programs against closed forms, conservation, rigid bodies and our own beams. The files are written by
//! `tests/reference/data/finite_elements.py` and `solid_elements.py`.

// One declaration serves several models: not all of them need all of its params.
#![allow(deprecated)]

use rncf::app::{EquilibriumSettings, static_equilibria};
use rncf::{Formulation, Joints, Method, Model, Scene};

use super::frequencies::natural;
use crate::runs::{WAYS, adaptive, apart, far, fixed, grid, history};

/// Beam of `beam.npz`: 2 m, 40 mm along y, 20 mm along z.
const LENGTH: f64 = 2.0;
const MASS: f64 = 2700.0 * 8e-4;
const BENDING: [f64; 2] = [70e9 * 0.02 * 64e-6 / 12.0, 70e9 * 0.04 * 8e-6 / 12.0];
/// Roots of `cos x cosh x = -1`.
const CLAMPED: [f64; 3] = [1.875_104_068_711_961, 4.694_091_132_974_175, 7.854_757_438_237_613];

fn bending(root: f64, stiffness: f64) -> f64 {
    (root / LENGTH).powi(2) * (stiffness / MASS).sqrt()
}

/// An arm that is clamped in a hub, swung to and fro in the plane.
macro_rules! arm {
    ($name:ident, { $($body:tt)* }, $root:ident, $tip:ident) => {
        rncf::model! {
            pub model $name {
                param modes: count = 8;
                param swing = 0.2 rad;
                param rate = 4 rad/s;
                param push = 0 N;
                material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
                section bar { area = 8 cm^2; second_moment = 10.66666666666666666667 cm^4; }
                frame hub = rotating(axis = z, angle = swing * (1 - cos(rate * t)));
                body arm in hub { $($body)* }
                joint grip = clamp(arm.$root, hub);
                load tug = force(arm.$tip, [0 N, push, 0 N], in = hub);
                output x = arm.$tip.x;
                output y = arm.$tip.y;
            }
        }
    };
}
arm!(ImportedArm, {
    import "reference/data/beam.npz";
    interface root = node 10;
    interface tip = node 90;
    small(modes);
}, root, tip);
arm!(OwnArm, {
    planar xy;
    line from [0, 0, 0] m to [2, 0, 0] m;
    mesh 8 * cable(bar, aluminium);
    small(modes);
}, start, end);

/// The beam in a free frame, spun, and the block in mm; a rigid one hangs beside a rigid body.
macro_rules! flying {
    ($name:ident, $($word:tt)*) => {
        rncf::model! {
            pub model $name {
                param modes: count = 8;
                param wx = 0.3 rad/s;
                param wy = 0.2 rad/s;
                param wz = 3 rad/s;
                param pull = 0 N;
                frame craft = free(velocity = [1, 2, 3] m/s, angular_velocity = [wx, wy, wz]);
                body arm in craft {
                    import "reference/data/beam_mm.npz" units(mm, t, s);
                    interface root = node 10;
                    interface middle = node 50;
                    interface tip = node 90;
                    $($word)*
                }
                load tug = force(arm.tip, [0 N, 0 N, if t < 100 ms { pull * sin(pi * t / 100 ms)^2 } else { 0 N }]);
                output mass = arm.mass;
                output momentum = arm.momentum;
                output spin = total.angular_momentum(about = total.center_of_mass);
                output energy = arm.kinetic_energy + arm.strain_energy;
                output centre = arm.center_of_mass;
                output tip = arm.tip;
                output middle = arm.middle.velocity;
            }
        }
    };
}
flying!(Flying, modal(modes););

rncf::model! {
    /// The beam, rigid, on a ball joint beside a rigid body of its mass and inertia.
    pub model Hanging {
        frame carrier = free(angular_velocity = [2, 0.1, 0] rad/s);
        body arm in carrier {
            import "reference/data/beam.npz";
            interface root = node 10;
            interface tip = node 90;
            rigid;
        }
        rigid twin {
            mass = 4.32 kg;
            center = [1, 0, 0] m;
            inertia = [7.2e-4, 1.44, 1.44] kg*m^2;
            angular_velocity = [2, 0.1, 0] rad/s;
        }
        joint hook = spherical(arm.root, inertial);
        joint other = spherical(twin, inertial);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = arm.tip.in(inertial) - twin.at([2, 0, 0] m);
        output energy = arm.kinetic_energy - twin.kinetic_energy;
    }
}

rncf::model! {
    /// The beam with the motions of its interfaces, held by a joint with multipliers.
    pub model Fixed {
        param modes: count = 4;
        frame craft = free();
        body arm in craft {
            import "reference/data/beam.npz";
            interface root = node 10;
            interface tip = node 90;
            modal(modes);
            interface_modes;
        }
        joint grip = clamp(arm.root, inertial);
        load tug = force(arm.tip, [0 N, 3 N, 0 N]);
        output tip = arm.tip.in(inertial).y;
        output moment = grip.moment.z;
    }
}

/// A bar of 8 solid elements of second order, which `tests/reference/data/solid_elements.py` made with scikit-fem.
macro_rules! solid {
    ($name:ident, $($word:tt)*) => {
        rncf::model! {
            pub model $name {
                param push = 0 N;
                body bar in inertial {
                    import "reference/data/solid.npz";
                    interface root = nodes [1, 2, 3, 4, 5, 6, 7, 8, 9];
                    interface tip = node 149;
                    $($word)*
                }
                joint grip = clamp(bar.root, inertial);
                load tug = force(bar.tip, [0 N, 0 N, push]);
                output z = bar.tip.z;
                output mass = bar.mass;
            }
        }
    };
}
solid!(Solid, small(6););
solid!(PulledSolid, small(6); interface_modes;);

/// Our own beam with sections, and what `modes --export` wrote of it.
macro_rules! strip {
    ($name:ident, { $($body:tt)* }, $root:ident, $tip:ident) => {
        rncf::model! {
            pub model $name {
                param modes: count = 6;
                material alloy { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; damping = 0.2 ms; }
                section bar = rectangle(y = 40 mm, z = 20 mm);
                frame hub = rotating(axis = [0, 1, 2], angle = 0.3 rad * (1 - cos(4 [rad/s] * t)));
                body arm in hub { $($body)* }
                joint grip = clamp(arm.$root, hub);
                load tug = force(arm.$tip, [0 N, 5 N * sin(9 [rad/s] * t), 2 N], in = hub);
                output tip = arm.$tip;
                output mass = arm.mass;
            }
        }
    };
}
strip!(OwnStrip, {
    spatial;
    line from [0, 0, 0] m to [2, 0.3, 0.1] m;
    mesh 4 * beam(bar, alloy);
    small(modes);
}, start, end);
strip!(ImportedStrip, {
    import "reference/data/own_strip.npz";
    interface root = node 1;
    interface tip = node 5;
    small(modes);
}, root, tip);

fn build(model: &impl Model) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

#[test]
fn a_clamped_beam_of_finite_elements_has_the_frequencies_of_a_cantilever() {
    let at_rest = ImportedArm {
        swing: 0.0,
        ..ImportedArm::default()
    };
    let found = natural(&mut *build(&at_rest), 8).unwrap();
    for (root, mode) in CLAMPED.iter().zip([[1, 0], [3, 2], [6, 4]]) {
        for (stiffness, at) in BENDING.iter().zip(mode) {
            let error = found[at] / bending(*root, *stiffness) - 1.0;
            println!("{:.6} rad/s: {error:.1e}", found[at]);
            assert!(error.abs() < 2e-3);
        }
    }
}

#[test]
fn under_a_force_at_its_tip_it_bends_as_a_cantilever() {
    let model = ImportedArm {
        push: 3.0,
        swing: 0.0,
        modes: 48,
        ..ImportedArm::default()
    };
    let mut scene = build(&model);
    let state = rncf::steady(&mut *scene, 0.0).unwrap().state().unwrap().clone();
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(&state, &mut row);
    let expected = 3.0 * LENGTH.powi(3) / (3.0 * BENDING[0]);
    let error = row[1] / expected - 1.0;
    println!("{:e} m: {error:.1e}", row[1]);
    assert!(error.abs() < 1e-9);
}

#[test]
fn it_swings_as_our_own_beam() {
    let times = grid(0.05, 1.0);
    let own = OwnArm {
        modes: 8,
        ..OwnArm::default()
    };
    let imported = ImportedArm {
        modes: 24,
        ..ImportedArm::default()
    };
    let run = |model: &dyn Fn() -> Vec<Vec<f64>>| model();
    let own = run(&|| history(&own, WAYS[0], Method::Radau, adaptive(1e-9), &times).0);
    let imported = run(&|| history(&imported, WAYS[0], Method::Radau, adaptive(1e-9), &times).0);
    let most = own.iter().map(|row| row[1].abs()).fold(0.0, f64::max);
    let error = apart(&own, &imported);
    println!("bends by {most:.3} m, apart {error:.1e} m");
    assert!(error < 1e-4 * most);
}

#[test]
fn a_free_body_has_its_mass_and_keeps_momentum_and_energy() {
    let model = Flying {
        pull: 50.0,
        ..Flying::default()
    };
    let times = grid(0.05, 1.0);
    let rows = history(&model, WAYS[0], Method::Radau, adaptive(1e-10), &times).0;
    let after = &rows[2..];
    let drift = |from: usize, to: usize| {
        after
            .iter()
            .map(|row| far(&row[from..to], &after[0][from..to]))
            .fold(0.0, f64::max)
    };
    println!("{:.1e} {:.1e} {:.1e}", drift(1, 4), drift(4, 7), drift(7, 8));
    assert!((rows[0][0] - MASS * LENGTH).abs() < 1e-9);
    assert!(drift(1, 4) < 1e-9);
    assert!(drift(4, 7) < 1e-7);
    assert!(drift(7, 8) < 1e-6);
}

#[test]
fn a_rigid_one_hangs_as_a_rigid_body() {
    let rows = history(&Hanging {}, WAYS[0], Method::Radau, adaptive(1e-10), &grid(0.1, 1.0)).0;
    let most = rows.iter().flatten().map(|value| value.abs()).fold(0.0, f64::max);
    println!("apart {most:.1e}");
    assert!(most < 1e-7);
}

#[test]
fn motions_of_the_interfaces_bend_it_exactly_under_a_force_there() {
    let mut scene = build(&Fixed::default());
    let state = rncf::steady(&mut *scene, 0.0).unwrap().state().unwrap().clone();
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(&state, &mut row);
    let expected = 3.0 * LENGTH.powi(3) / (3.0 * BENDING[0]);
    println!("{:e} m: {:.1e}; {:e} N m", row[0], row[0] / expected - 1.0, row[1]);
    assert!((row[0] / expected - 1.0).abs() < 1e-6);
    assert!((row[1].abs() / 6.0 - 1.0).abs() < 1e-6);
}

/// Frequencies and deflection as scipy has them of the same matrices: `solid_elements.py` prints them.
#[test]
fn solid_elements_of_another_program_have_its_frequencies_and_deflection() {
    let found = natural(&mut *build(&Solid::default()), 6).unwrap();
    let wanted = [
        662.545825569431,
        1315.5793429442972,
        4129.917627555702,
        7934.571780761,
        10_191.366_919_785_525,
        11_491.599_287_616_029,
    ];
    for (found, wanted) in found.iter().zip(wanted) {
        println!("{found:.6} rad/s: {:.1e}", found / wanted - 1.0);
        assert!((found / wanted - 1.0).abs() < 1e-8);
    }
    let mut scene = build(&PulledSolid { push: 100.0 });
    let state = rncf::steady(&mut *scene, 0.0).unwrap().state().unwrap().clone();
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(&state, &mut row);
    println!("{:e} m, {} kg", row[0], row[1]);
    assert!((row[0] / 3.751_204_260_202_968_4e-4 - 1.0).abs() < 1e-7);
    assert!((row[1] / (7850.0 * 0.4 * 0.04 * 0.02) - 1.0).abs() < 1e-12);
}

/// What the program wrote of our own beam is what it is made of, and runs as it does.
#[test]
fn a_body_that_was_exported_runs_as_before() {
    let times = grid(0.05, 1.0);
    let own = history(&OwnStrip::default(), WAYS[0], Method::Radau, fixed(5e-3), &times).0;
    let imported = history(&ImportedStrip::default(), WAYS[0], Method::Radau, fixed(5e-3), &times).0;
    let error = apart(&own, &imported);
    println!("apart {error:.1e}");
    assert!(error < 1e-12);

    let scene = build(&OwnStrip::default());
    let exported = scene.exported();
    let find = |name: &str| {
        let found = exported[0].arrays.iter().find(|array| array.0 == name);
        found.map_or(&[][..], |array| &array.2)
    };
    let bytes = include_bytes!("../../reference/data/own_strip.npz");
    let file = rncf_codegen::import::File {
        path: "own_strip.npz",
        bytes,
    };
    let read = rncf_codegen::import::FiniteElements::read(&[file]).unwrap();
    assert!(far(&read.nodes.concat(), find("nodes")) < 1e-14);
    let modes = read.modes.unwrap();
    let size = modes.values.iter().map(|value| value.abs()).fold(0.0, f64::max);
    assert!(far(&modes.values, find("modes")) < 1e-7 * size);
}

#[test]
fn what_its_file_does_not_know_is_told() {
    let told = |wy: f64| {
        let model = Flying {
            wy,
            ..Flying::default()
        };
        let mut scene = build(&model);
        let start = scene.rest(0.0);
        let warnings = scene.warnings(&start);
        warnings
            .into_iter()
            .map(|warning| warning.text)
            .collect::<Vec<_>>()
            .join("\n")
    };
    let (slow, fast) = (told(1.0), told(150.0));
    assert!(
        slow.contains("lumped at its 9 nodes") && !slow.contains("tightens"),
        "{slow}"
    );
    assert!(fast.contains("what tightens it is not in its file"), "{fast}");

    let mut scene = build(&Flying::default());
    let start = scene.rest(0.0);
    let masses = scene.masses(&start);
    assert!((masses[0].mass - MASS * LENGTH).abs() < 1e-9);
    assert!((masses[0].inertia[(1, 1)] / (MASS * LENGTH.powi(3) / 12.0) - 1.0).abs() < 1e-6);

    let in_absolute = Flying::default().build(Formulation::Ancf, Joints::Eliminated);
    assert!(in_absolute.is_err_and(|error| error.to_string().contains("use the referenced formulation")));
    let full = [("arm".to_string(), rncf::model::Fidelity::Full)];
    let whole = Flying::default().build_as(Formulation::Rncf, Joints::Eliminated, &full);
    assert!(whole.is_err_and(|error| error.to_string().contains("has modes alone")));
}

/// Of a moment at the tip few modes turn it by much less than the matrices of the file do; those of the interfaces know it.
#[test]
fn what_its_modes_lack_of_a_force_is_told() {
    let told = |model: &dyn rncf::AnyModel| {
        let found = static_equilibria(model, &EquilibriumSettings::default()).unwrap();
        let lacking = found
            .warnings
            .into_iter()
            .find(|text| text.contains("modes are too few"));
        (lacking, found.history.column(1).last().unwrap())
    };
    let arm = |modes: usize| ImportedArm {
        push: 3.0,
        swing: 0.0,
        modes,
        ..ImportedArm::default()
    };
    let exact = 3.0 * LENGTH.powi(3) / (3.0 * BENDING[0]);
    for modes in [1, 2] {
        let (text, y) = told(&arm(modes));
        let text = text.unwrap();
        let part: f64 = text
            .split(" % of how far")
            .next()
            .unwrap()
            .rsplit(' ')
            .next()
            .unwrap()
            .parse()
            .unwrap();
        let lost = 1.0 - y / exact;
        println!("{modes}: {lost} {text}");
        assert!(
            text.contains("`tip`") && part >= (100.0 * lost).floor(),
            "{lost} {text}"
        );
    }
    assert_eq!(told(&arm(48)).0, None);
    assert_eq!(told(&Fixed::default()).0, None);
}

rncf::model! {
    /// An arm on a carrier that moves freely.
    pub model Carried {
        rigid bus { mass = 10 kg; inertia = [10, 10, 10] kg*m^2; origin = [1, 2, 3] m; }
        body arm in bus { import "reference/data/own_strip.npz"; interface root = node 1; interface tip = node 5; modal(4); }
        joint grip = clamp(arm.root, bus);
        output tip = arm.tip;
    }
}

/// The carrier's part alone was told: the bending of the arm was its rigid motion to 100 per cent.
#[test]
fn parts_of_the_kinetic_energy_are_not_told_where_a_body_is_from_a_file() {
    let found = rncf::app::modes(&Carried {}, &EquilibriumSettings::default()).unwrap();
    assert!(found.modes.len() >= 4);
    assert!(
        found
            .compositions
            .iter()
            .all(|of| of.motions.is_empty() && of.bodies.is_empty())
    );
}

rncf::model! {
    /// The arm on a hub that turns evenly.
    pub model ImportedBlade {
        param speed = 15 rad/s;
        frame hub = rotating(axis = z, angle = speed * t);
        body arm in hub { import "reference/data/beam.npz"; interface root = node 10; interface tip = node 90; modal(6); }
        joint grip = clamp(arm.root, hub);
        output tip = arm.tip.in(hub).y;
        run { t_end = 0.02 s; every = 0.01 s; }
    }
}

/// What bends across the axis is pulled outwards by `spin^2` of its mass; the file does not know what holds against it.
#[test]
fn what_a_spin_takes_of_an_imported_stiffness_is_told() {
    for speed in [5.0, 15.0, 40.0] {
        let model = ImportedBlade { speed };
        let settings = rncf::app::RunSettings {
            judged: rncf::app::Judging::No,
            ..rncf::app::RunSettings::default()
        };
        let found = rncf::app::run(&model, &settings).unwrap();
        let told = found.warnings.iter().find_map(|text| {
            let (_, rest) = text.split_once("centrifugal forces take ")?;
            rest.split_once(" %")?.0.parse::<f64>().ok()
        });
        let taken = 100.0 * (speed / bending(CLAMPED[0], BENDING[0])).powi(2);
        match told {
            Some(told) => assert!(
                taken > 2.0 && (told - taken).abs() < 0.02 * taken + 0.05,
                "{speed}: {told} {taken}"
            ),
            None => assert!(taken < 2.0, "{speed}: {:?}", found.warnings),
        }
    }
}
