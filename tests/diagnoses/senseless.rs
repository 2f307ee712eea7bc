//! Declarations that can be built and make no sense with the numbers that they get: told when they are built, when they
//! start, or within a bounded time.

use rncf::app::{RunError, RunSettings, run};
use rncf::model::Fidelity;
use rncf::{Formulation, Integrator, Joints, Method, Model, ModelError, Options, Scene, SolveError, Stop};

use crate::contains;

pub mod models {
    rncf::model! {
        /// A strip in a hub and an arm, both of which can be made to jump.
        pub model Shaken {
            /// Where the root is held, from where it is undeformed.
            param away = 0 m;
            /// Angle by which the hub jumps.
            param step = 0 deg;
            /// Angular velocity of the hub behind the jump.
            param rate = 0 deg/s;
            /// Way by which the hub jumps.
            param shift = 0 m;
            /// Angle by which the drive jumps.
            param kick = 0 deg;
            /// Angular velocity of the drive behind the jump.
            param turn = 0 deg/s;
            /// Damping at the tip.
            param drag = 0 N*s/m;
            /// Force at the tip.
            param push = 0 N;
            /// Of the material.
            param damping = 2 ms;
            param elements: count = 4;

            material rubber { density = 1100 kg/m^3; young = 5 MPa; damping = damping; }
            section round { area = 78.5 mm^2; second_moment = 491 mm^4; }
            motion theta(t) = if t < 0.1 s { 0 rad } else { step + rate * (t - 0.1 s) };
            motion x(t) = if t < 0.1 s { 0 m } else { shift };
            motion phi(t) = if t < 0.1 s { 0 rad } else { kick + turn * (t - 0.1 s) };
            frame hub = rotating(axis = z, angle = theta(t), origin = [x(t), 0 m, 0]);
            body strip in hub { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * cable(round, rubber); }
            joint root = clamp(strip.start, hub, at = [away, 0 m, 0]);
            rigid arm { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
            joint hinge = revolute(inertial, arm);
            joint motor = drive(hinge.angle, phi(t));
            load brake = force(strip.end, -drag * strip.end.velocity);
            load shove = force(strip.end, [0, push, 0]);
            output tip = strip.end;
            output turned = arm.angle;
            run { t_end = 0.2 s; every = 0.01 s; }
        }
    }
    rncf::model! {
        /// A pinned rod, a clamped one, an arc, and a point mass on a joint.
        pub model Hung {
            /// Distance of the point mass from its joint.
            param gap = 0 m;
            /// Angle of the arc.
            param angle = 90 deg;
            param elements: count = 2;
            param modes: count = 1;
            param weight = 0.1 m/s^2;
            param area = 78.5 mm^2;
            param extent = 5 mm;

            material rubber { density = 1100 kg/m^3; young = 5 MPa; }
            section round { area = area; second_moment = 491 mm^4; extent_y = extent; }
            body rod { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(round, rubber); }
            joint pivot = pin(rod.start, inertial);
            body blade { planar xy; line from [0, 1, 0] m to [1, 1, 0] m; mesh 8 * cable(round, rubber); modal(modes); }
            joint root = clamp(blade.start, inertial);
            body bow { planar xy; arc from [0, 2, 0] m direction [1, 0, 0] radius 1 m angle angle; mesh elements * cable(round, rubber); }
            joint grip = clamp(bow.start, inertial);
            rigid bob { plane xy; mass = 1 kg; origin = [gap, 5 m, 0]; }
            joint knot = spherical(inertial.at([0, 5, 0] m), bob);
            load gravity_load = gravity([0, -weight, 0]);
            output tip = rod.end;
            output deflection = blade.end.y - 1 m;
            output held = pivot.force.y;
            output far = bow.end;
            output bob_y = bob.y;
            run { t_end = 2 s; every = 0.02 s; }
        }
    }
}
use models::{Hung, Shaken};

fn build<M: Model>(model: &M, fidelity: &[(&str, Fidelity)]) -> Result<Box<dyn Scene>, ModelError> {
    let fidelity: Vec<(String, Fidelity)> = fidelity.iter().map(|&(name, of)| (name.to_string(), of)).collect();
    model.build_as(Formulation::Rncf, Joints::Eliminated, &fidelity)
}

#[track_caller]
fn unbuilt<M: Model>(model: &M, fidelity: &[(&str, Fidelity)], parts: &[&str]) {
    match build(model, fidelity) {
        Ok(_) => panic!("the model is refused"),
        Err(error) => contains(&error.message, parts),
    }
}

/// The error of a run up to a time, s, and the steps that it took.
fn ended(model: &Shaken, end: f64) -> (Result<(), SolveError>, u64) {
    let mut scene = build(model, &[]).unwrap();
    let rest = scene.rest(0.0);
    let mut integrator = match Integrator::new(scene.as_mut(), rest, end, Method::Radau, Options::default()) {
        Ok(integrator) => integrator,
        Err(error) => return (Err(error), 0),
    };
    loop {
        match integrator.step() {
            Ok(Stop::End) => return (Ok(()), integrator.statistics().steps),
            Ok(_) => {}
            Err(error) => return (Err(error), integrator.statistics().steps),
        }
    }
}

#[test]
fn a_motion_that_jumps_is_refused_before_the_first_step() {
    let jumps = [
        (
            Shaken {
                step: 0.1,
                ..Shaken::default()
            },
            "frame `hub` jumps by 5.7",
        ),
        (
            Shaken {
                shift: 0.1,
                ..Shaken::default()
            },
            "the origin of frame `hub` jumps by 1.000e-1 m",
        ),
        (
            Shaken {
                kick: 0.1,
                ..Shaken::default()
            },
            "what joint `motor` (drive), angle prescribes jumps by 1.0",
        ),
    ];
    for (model, part) in jumps {
        let (outcome, steps) = ended(&model, 0.2);
        contains(
            &outcome.unwrap_err().to_string(),
            &[part, "at t = 0.1 s", "which no body can follow"],
        );
        assert_eq!(steps, 0);
    }
}

#[test]
fn a_velocity_that_jumps_is_told() {
    for (model, part) in [
        (
            Shaken {
                rate: 1.0,
                ..Shaken::default()
            },
            "the angular velocity of frame `hub` jumps by 1.000e0 rad/s",
        ),
        (
            Shaken {
                turn: 1.0,
                ..Shaken::default()
            },
            "the rate that joint `motor` (drive), angle prescribes jumps by 1.0",
        ),
    ] {
        let notes = run(&model, &RunSettings::default()).unwrap().warnings;
        // The strip swings, and may be told that its elements are few.
        assert!(notes[0].starts_with(part) && notes[0].contains("impact"), "{notes:?}");
    }
    assert!(
        run(&Shaken::default(), &RunSettings::default())
            .unwrap()
            .warnings
            .is_empty()
    );
}

#[test]
fn a_joint_far_from_the_undeformed_end_is_refused_and_a_near_one_told() {
    let far = Shaken {
        away: -0.26,
        ..Shaken::default()
    };
    unbuilt(
        &far,
        &[],
        &[
            "joint `root` holds the start of body `strip` 2.600e-1 m",
            "initial position",
        ],
    );
    let near = Shaken {
        away: -0.01,
        ..Shaken::default()
    };
    let notes = run(&near, &RunSettings::default()).unwrap().warnings;
    assert!(
        notes[0].contains("1.000e-2 m from where it is undeformed: the element there starts with a strain of 4.0e-2"),
        "{notes:?}"
    );
}

#[test]
fn what_grows_without_end_is_stopped() {
    let torn = Shaken {
        push: 1e12,
        damping: 0.0,
        ..Shaken::default()
    };
    let (outcome, steps) = ended(&torn, 10.0);
    contains(
        &outcome.unwrap_err().to_string(),
        &["body `strip`", "faster than light"],
    );
    assert!(steps < 1000, "{steps}");
    // The step is a part of a period, and falls as the amplitude grows.
    let fed = Shaken {
        drag: -2.0,
        push: 1e-3,
        damping: 0.0,
        elements: 1,
        ..Shaken::default()
    };
    let (outcome, steps) = ended(&fed, 10.0);
    contains(
        &outcome.unwrap_err().to_string(),
        &["grows without end", "body `strip`", "wrong sign"],
    );
    assert!(steps < 80_000, "{steps}");
}

#[test]
fn a_stretch_that_no_material_bears_is_told() {
    let torn = Shaken {
        push: 1e6,
        ..Shaken::default()
    };
    let notes = run(&torn, &RunSettings::default()).unwrap().warnings;
    assert!(
        notes[0].starts_with("body `strip`: its axis is stretched to "),
        "{notes:?}"
    );
    // No mesh of four elements follows that.
    assert!(
        notes.len() == 2 && notes[1].starts_with("The mesh is too coarse") && notes[1].contains("`strip` (4 elements)"),
        "{notes:?}"
    );
}

#[test]
fn a_pinned_body_without_deformation_would_hang_still() {
    for (fidelity, word) in [(Fidelity::Rigid, "`rigid`"), (Fidelity::Point, "`point`")] {
        unbuilt(
            &Hung::default(),
            &[("rod", fidelity)],
            &["body `rod`", word, "frame `inertial`", "hang still"],
        );
        build(&Hung::default(), &[("blade", fidelity)]).unwrap();
    }
    build(&Hung::default(), &[]).unwrap();
}

#[test]
fn a_point_mass_is_not_held_from_afar() {
    let parts = ["joint `knot`", "point mass `bob` 1.000e0 m away", "inertia", "distance"];
    unbuilt(
        &Hung {
            gap: 1.0,
            ..Hung::default()
        },
        &[],
        &parts,
    );
}

#[test]
fn shapes_that_no_element_or_section_has_are_refused() {
    let bent = Hung {
        angle: 3.3,
        ..Hung::default()
    };
    unbuilt(&bent, &[], &["body `bow`", "bent by 95 deg", "at least 3 elements"]);
    build(&Hung { elements: 3, ..bent }, &[]).unwrap();
    unbuilt(
        &Hung {
            extent: 2e-3,
            ..Hung::default()
        },
        &[],
        &["section `round`", "second_moment_z", "area * extent_y^2"],
    );
}

#[test]
fn a_section_that_is_thicker_than_its_body_is_long_is_told() {
    let thick = Hung {
        area: 1e-12,
        extent: 100.0,
        ..Hung::default()
    };
    let mut scene = build(&thick, &[]).unwrap();
    let rest = scene.rest(0.0);
    let notes = scene.warnings(&rest);
    // The rod, the blade and the bow.
    assert_eq!(notes.len(), 3, "{notes:?}");
    contains(&notes[0].text, &["body `rod`", "2.216e1 m", "units of `second_moment`"]);
}

#[test]
fn more_elements_than_memory_are_refused() {
    let fine = Hung {
        elements: 1_000_000_000,
        ..Hung::default()
    };
    unbuilt(&fine, &[], &["body `bow` has 1000000000 elements"]);
}

/// The part of a deflection that the note of a body in modes tells, and the part that is missing beside the whole body.
fn told_and_missing(model: &Hung, t_end: f64) -> [f64; 2] {
    let of = |fidelity: &[(&str, Fidelity)]| {
        let settings = RunSettings {
            fidelity: fidelity.iter().map(|&(name, of)| (name.to_string(), of)).collect(),
            t_end: Some(t_end),
            ..RunSettings::default()
        };
        let result = run(model, &settings).unwrap();
        let columns = &result.history.columns;
        let place = columns.iter().position(|column| column.name == "deflection").unwrap();
        let deflection = result.history.column(place).map(f64::abs).fold(0.0, f64::max);
        (deflection, result.warnings)
    };
    let (deflection, notes) = of(&[]);
    let (whole, _) = of(&[("blade", Fidelity::Full)]);
    let note = notes.iter().find(|note| note.contains("of the deflection are missing"));
    let told = note.map_or(0.0, |note| {
        let number = note.split("about ").nth(1).and_then(|rest| rest.split(' ').next());
        number.unwrap().parse::<f64>().unwrap() / 100.0
    });
    println!(
        "g {} missing {:.3}, told {told}",
        model.weight,
        1.0 - deflection / whole
    );
    [told, 1.0 - deflection / whole]
}

/// Over half a period of the whole body, which begins to fall at the start.
#[test]
fn the_note_of_modes_that_hinder_tells_what_is_missing() {
    for (weight, modes, least) in [(3e-4, 1, 0.1), (1e-3, 1, 0.3), (1e-2, 3, 0.7)] {
        let model = Hung {
            weight,
            modes,
            ..Hung::default()
        };
        let [told, missing] = told_and_missing(&model, 6.0);
        assert!(missing >= least, "{missing}");
        assert!((told / missing - 1.0).abs() < 0.25, "{told} instead of {missing}");
    }
}

#[test]
fn a_tolerance_below_round_off_is_refused() {
    let options = Options {
        rtol: 1e-16,
        ..Options::default()
    };
    let settings = RunSettings {
        options,
        ..RunSettings::default()
    };
    match run(&Shaken::default(), &settings) {
        Err(RunError::Start(error)) => contains(&error.to_string(), &["rtol", "round-off"]),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_model_may_stand_in_a_function() {
    rncf::model! {
        /// A mass that falls.
        model Falling {
            param drop = 9.81 m/s^2;
            rigid bob { mass = 1 kg; }
            load weight = gravity([0, 0, -drop]);
            output z = bob.z;
            run { t_end = 1 s; every = 1 s; }
        }
    }
    let result = run(&Falling { drop: 2.0 }, &RunSettings::default()).unwrap();
    assert!((result.history.column(0).last().unwrap() + 1.0).abs() < 1e-9);
}
