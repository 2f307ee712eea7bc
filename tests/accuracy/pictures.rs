//! Pictures of runs: what is drawn is where the outputs say.

use rncf::AnyModel;
use rncf::app::{EquilibriumSettings, Pictures, RunResult, RunSettings, modes, run};
use rncf::model::{SignKind, SignPlace};
use rncf::nalgebra::Vector3;
use rncf_models::{EsailSlack, FreeFlight, HeavyTop, SpinUp};

fn drawn(model: &dyn AnyModel, t_end: f64, every: f64) -> (RunResult, Pictures) {
    let settings = RunSettings {
        t_end: Some(t_end),
        every: Some(every),
        pictures: true,
        ..RunSettings::default()
    };
    let mut result = run(model, &settings).expect("a run");
    let pictures = result.pictures.take().expect("pictures");
    (result, pictures)
}

/// The scale of the colours goes to what the envelope says, which all rows and steps tell and not the pictures alone; the strain is that of
/// the axial force by Hooke's law.
#[test]
fn scales_are_those_of_the_envelopes() {
    let (result, pictures) = drawn(&SpinUp::default(), 20.0, 0.03);
    assert!((pictures.times.len() as u64) < result.history.rows());
    let of = |name: &str| {
        let mut scales = pictures.scales().into_iter();
        scales.rfind(|scale| scale.name == name).expect(name).range
    };
    let envelope = &result.envelopes.bodies[0];
    let force = envelope.axial_force.expect("a force").value;
    assert_eq!(of("axial force")[1], force);
    assert_eq!(
        of("bending moment")[1],
        envelope.bending_moment.expect("a moment").value
    );
    assert_eq!(of("stress")[1], envelope.stress.expect("a stress").value);
    let strain = force / (68.95e9 * 0.7299e-4);
    assert!(
        (of("axial strain")[1] / strain - 1.0).abs() < 1e-6,
        "{:?} {strain}",
        of("axial strain")
    );
}

/// Joints and loads stand where they are declared: the beam's clamp, the top's pivot and weight.
#[test]
fn joints_and_loads_have_their_places() {
    let (_, beam) = drawn(&SpinUp::default(), 0.1, 0.1);
    let [root] = &beam.signs[..] else {
        panic!("{:?}", beam.signs)
    };
    assert_eq!((root.name.as_str(), root.kind), ("root", SignKind::Joint));
    assert_eq!(root.place, Some(SignPlace::Curve { curve: 0, point: 0.0 }));
    let (_, top) = drawn(&HeavyTop::default(), 0.1, 0.1);
    let [pivot, weight] = &top.signs[..] else {
        panic!("{:?}", top.signs)
    };
    let Some(SignPlace::Frame { frame, at }) = pivot.place else {
        panic!("{pivot:?}")
    };
    assert_eq!((top.frames[frame].as_str(), at), ("top", -Vector3::y()));
    assert_eq!((weight.kind, weight.place), (SignKind::Gravity, None));
    assert!(
        top.shots
            .iter()
            .all(|shot| shot.acting == [Vector3::new(0.0, 0.0, -9.81)])
    );
}

mod wheel {
    rncf::model! {
        /// A disc on its axle, and a point that falls.
        pub model Wheel {
            rigid _disc { plane xy; mass = 2 kg; inertia = 0.01 kg*m^2; }
            joint axle = revolute(inertial, _disc);
            rigid drop { mass = 1 kg; origin = [1, 0, 0] m; }
            load weight = gravity([0, -10, 0] m/s^2);
            output y = drop.y;
            run { t_end = 0.1 s; every = 0.1 s; }
        }
    }
}

/// What nothing is attached to is seen, too: a planar disc by its radii of gyration, of which each is J / (2 m) in square.
#[test]
fn rigid_bodies_without_levers_are_crosses() {
    let (_, pictures) = drawn(&wheel::Wheel {}, 0.1, 0.1);
    let names: Vec<&str> = pictures.curves.iter().map(|curve| curve.name.as_str()).collect();
    assert_eq!(names, ["_disc", "drop"]);
    let [of_disc, of_drop] = [pictures.curves[0].points, pictures.curves[1].points];
    let points = &pictures.shots[0].points;
    assert_eq!((of_disc, of_disc + of_drop), (12, points.len()));
    let radius = (0.01f64 / 4.0).sqrt();
    for (end, exact) in [1, 4, 7, 10]
        .into_iter()
        .zip([[radius, 0.0], [-radius, 0.0], [0.0, radius], [0.0, -radius]])
    {
        let found = points[end];
        assert!(
            (found.x - exact[0]).abs() + (found.y - exact[1]).abs() < 1e-15,
            "{found}"
        );
    }
    let largest = points[of_disc..].iter().map(|point| point.norm()).fold(0.0, f64::max);
    assert!(largest > 0.0 && largest < 0.1, "{largest}");
}

rncf::model! {
    /// A cable and a beam of two elements each in frames that are turned, under loads per length that are known.
    pub model Loaded {
        material rubber { density = 900 kg/m^3; young = 20 MPa; poisson = 0.4; }
        section cord = circle(radius = 10 mm);
        frame hub = rotating(axis = z, angle = 90 deg);
        body rope in hub { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(cord, rubber); }
        body spar in hub { spatial; line from [0, 0, 1] m to [0, 1, 1] m; mesh 2 * beam(cord, rubber); }
        joint a = clamp(rope.start, hub);
        joint b = clamp(spar.start, hub);
        load push = density(rope, [0, 5, 0] N/m);
        load lift = distributed(spar, [0, 0, 2 [N/m] + 4 [N/m^2] * x]);
        output rope_end = rope.end.y;
        output spar_end = spar.end.z;
        run { t_end = 1 ms; every = 1 ms; }
    }
}

/// Loads per length have an arrow in the middle of each element: what acts there over its length, in inertial axes.
#[test]
fn loads_per_length_have_arrows_along_the_axis() {
    let (_, pictures) = drawn(&Loaded::default(), 1e-3, 1e-3);
    let lines: Vec<_> = pictures
        .signs
        .iter()
        .filter(|sign| sign.kind != SignKind::Joint)
        .collect();
    let names: Vec<(&str, SignKind)> = lines.iter().map(|sign| (sign.name.as_str(), sign.kind)).collect();
    let [lift, push] = [("lift", SignKind::Line), ("push", SignKind::Line)];
    assert_eq!(names, [lift, lift, push, push]);
    // The frame is turned by a right angle about z: its y is minus x.
    let wanted = [
        Vector3::new(0.0, 0.0, 3.0),
        Vector3::new(0.0, 0.0, 5.0),
        Vector3::new(-5.0, 0.0, 0.0),
        Vector3::new(-5.0, 0.0, 0.0),
    ];
    for (found, wanted) in pictures.shots[0].acting.iter().zip(wanted) {
        assert!((found - wanted).norm() < 1e-12, "{found} {wanted}");
    }
}

/// A scene of many points has fewer pictures, so that its page does not grow without bound.
#[test]
fn a_large_scene_has_fewer_pictures() {
    let (result, sail) = drawn(&EsailSlack::default(), 2.0, 0.01);
    assert_eq!(result.history.rows(), 201);
    let points = sail.shots[0].points.len();
    assert!(
        (20..201).contains(&sail.times.len()),
        "{} pictures of {points} points",
        sail.times.len()
    );
    let spread: Vec<&str> = sail
        .signs
        .iter()
        .filter(|sign| sign.kind == SignKind::Spread)
        .map(|sign| sign.name.as_str())
        .collect();
    assert_eq!(spread, ["sun"]);
    // Two loads on 1600 elements of main tethers and on the others.
    let lines = sail.signs.iter().filter(|sign| sign.kind == SignKind::Line).count();
    assert!((2..=96).contains(&lines), "{lines} arrows");
}

/// A cable that tumbles through space: its ends in the pictures are those of the outputs, in inertial axes.
#[test]
fn ends_of_curves_are_where_the_outputs_say() {
    let settings = RunSettings {
        t_end: Some(0.2),
        every: Some(0.05),
        pictures: true,
        ..RunSettings::default()
    };
    let result = run(&FreeFlight::default(), &settings).expect("a run");
    let Some(Pictures {
        curves,
        frames,
        times,
        shots,
        ..
    }) = &result.pictures
    else {
        panic!("no pictures");
    };
    assert_eq!((frames.join(" ").as_str(), times.len()), ("inertial f", 5));
    assert_eq!((curves[0].name.as_str(), curves[0].frame), ("cable", 1));
    for (row, shot) in shots.iter().enumerate() {
        let values = &result.history.values[row * 7..];
        let (place, rotation) = &shot.poses[1];
        for (point, output) in [(0, &values[..3]), (curves[0].points - 1, &values[3..6])] {
            let drawn = *place + rotation * shot.points[point];
            assert!((drawn - Vector3::new(output[0], output[1], output[2])).norm() < 1e-12);
        }
    }
}

/// Modes are drawn as they are: of a cantilever that hardly turns the middle moves by 0.339523 of what the tip does in the first one
/// and by -0.713666 in the second (Euler and Bernoulli).
#[test]
fn drawn_modes_are_those_of_a_cantilever() {
    let beam = SpinUp {
        omega_s: 1e-3,
        elements: 16,
        ..SpinUp::default()
    };
    let found = modes(&beam, &EquilibriumSettings::default()).expect("modes");
    let shapes = found.pictures.expect("a beam is drawn");
    let points = shapes.curves[0].points;
    // Along that of the tip, whose size is 1.
    let along_tip = |mode: usize, point: usize| {
        let [own, tip] = [point, points - 1].map(|point| shapes.moved[mode][point]);
        own[0].dot(&tip[0]) + own[1].dot(&tip[1])
    };
    for (mode, wanted) in [0.339_523, -0.713_666].into_iter().enumerate() {
        let [root, middle, tip] = [0, points / 2, points - 1].map(|point| along_tip(mode, point));
        assert!(root.abs() < 1e-9 && (tip - 1.0).abs() < 1e-9, "{root} {tip}");
        assert!((middle - wanted).abs() < 1e-4, "mode {mode}: {middle}");
    }
}
