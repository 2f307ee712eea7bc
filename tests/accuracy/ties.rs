//! Frames that follow a chord or mean axes, and momentum and energy as outputs: against closed forms, against what nothing
//! can change, and both formulations against each other.

use rncf::{Formulation, Joints, Method, Model, Options, Statistics};
use rncf_models::FreeFlight;

use crate::runs::{adaptive, states_at};

const WAYS: [Formulation; 2] = [Formulation::Rncf, Formulation::Ancf];

rncf::model! {
    /// Free bodies of all kinds, under gravity.
    model Flyers {
        param fall = 9.81 m/s^2;
        param tip_mass = 0.5 kg;
        param kick = 0.3;
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }
        section thick = circle(radius = 30 mm);

        rigid arm {
            mass = 2 kg; center = [0.5, 0, 0.1] m; inertia = [0.2, 0.3, 0.4, 0.01, 0, 0.02] kg*m^2;
            origin = [1, 2, 3] m; axis = [1, 1, 0]; angle = 50 deg;
            velocity = [0.3, 0, 1] m/s; angular_velocity = [1, -2, 3] rad/s;
        }
        fixture tool on arm.at([0, 1, 0] m) { mass = 0.5 kg; }
        // The chord is along no axis and does not pass the origin.
        frame f = free(
            origin = [0.3, -0.2, 0.5] m, axis = [1, 2, -1], angle = 40 deg,
            velocity = [-1, 1, 2] m/s, angular_velocity = [2, -1, 1] rad/s
        );
        body rope in f {
            spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 3 * cable(flat, soft);
            initial position [0.1 m + 1.5 m * sin(x / 1.5 m), 0.2 m + 1.5 m * (1 - cos(x / 1.5 m)), 0.1 m];
            initial velocity [kick * 1 [m/s], kick * x * 2 [1/s], kick * x^2 * 1 [1/(m s)]];
            chord;
        }
        fixture tip on rope.end { mass = tip_mass; }
        frame middle = free(origin = [0, 0, -3] m, angular_velocity = [1, 2, -3] rad/s, velocity = [0.1, 0.2, 0.3] m/s);
        body bow in middle {
            spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 3 * cable(flat, soft);
            initial position [1.2 m * sin(x / 1.2 m), 1.2 m * (1 - cos(x / 1.2 m)), 0];
            initial velocity [0, 0, kick * x * 1 [1/s]];
            mean_axes;
        }
        frame plate = free(plane = xy, origin = [5, 0, 0] m, angle = 60 deg, velocity = [1, 2, 0] m/s, speed = 7 rad/s);
        body tube in plate { planar xy; line from [1, 1, 0] m to [2, 1, 0] m; mesh 2 * beam(thick, steel); chord; }

        load weight = gravity([0, -fall, 0]);

        output arm_mass = arm.mass;
        output arm_momentum = arm.momentum;
        output arm_spin = arm.angular_momentum(about = arm.center_of_mass);
        output arm_spin_in = arm.angular_momentum(about = arm.center_of_mass).in(arm);
        output arm_center = arm.center_of_mass;
        output arm_kinetic = arm.kinetic_energy;
        output mass = total.mass;
        output momentum = total.momentum;
        output spin = total.angular_momentum;
        output spin_about = total.angular_momentum(about = total.center_of_mass);
        output spin_rope = rope.angular_momentum(about = rope.center_of_mass);
        output spin_at = rope.angular_momentum(about = inertial.at([1, 2, 3] m));
        output rope_momentum = rope.momentum;
        output rope_center = rope.center_of_mass;
        output center = total.center_of_mass;
        output energy = total.kinetic_energy + total.strain_energy + total.gravity_energy;
        output tube_spin = tube.angular_momentum(about = tube.center_of_mass).z;
        output tube_kinetic = tube.kinetic_energy;
        output tube_momentum = tube.momentum;
        output rope_end = rope.end;
        output rope_rate = rope.at(1 m).velocity;
        output rope_ex = f.ex;
        output rope_turning = f.angular_velocity;
        output rope_origin = f.velocity;
        output bow_end = bow.end;
        output bow_turning = middle.angular_velocity;
        output bow_ey = middle.ey;
        output tube_end = tube.end.x;
        output tube_ex = plate.ex;
        run { t_end = 0.3 s; every = 0.1 s; }
    }
}

/// Rows of outputs at the times.
fn rows(model: &impl Model, way: Formulation, options: Options, times: &[f64]) -> (Vec<Vec<f64>>, Statistics) {
    let mut scene = model.build(way, Joints::Eliminated).unwrap();
    let rest = scene.rest(0.0);
    let (states, statistics) = states_at(scene.as_mut(), rest, Method::Radau, options, times);
    let mut row = vec![0.0; scene.output_columns()];
    let rows = states.iter().map(|state| {
        scene.outputs(state, &mut row);
        row.clone()
    });
    (rows.collect(), statistics)
}

/// First column of an output, and its components.
fn columns(name: &str) -> std::ops::Range<usize> {
    let mut first = 0;
    for output in Flyers::outputs() {
        let count = output.components.len().max(1);
        if output.name == name {
            return first..first + count;
        }
        first += count;
    }
    panic!("no output `{name}`");
}

#[track_caller]
fn near(row: &[f64], name: &str, wanted: &[f64], bound: f64) {
    let found = &row[columns(name)];
    assert_eq!(found.len(), wanted.len(), "{name}");
    let size = wanted.iter().fold(1.0f64, |size, x| size.max(x.abs()));
    for (found, wanted) in found.iter().zip(wanted) {
        assert!(
            (found - wanted).abs() <= bound * size,
            "{name}: {found} instead of {wanted}"
        );
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A vector turned about an axis (Rodrigues).
fn turned(axis: [f64; 3], angle: f64, v: [f64; 3]) -> [f64; 3] {
    let size = dot(axis, axis).sqrt();
    let n = axis.map(|x| x / size);
    let (sin, cos) = angle.sin_cos();
    let (side, along) = (cross(n, v), dot(n, v));
    std::array::from_fn(|k| cos * v[k] + sin * side[k] + (1.0 - cos) * along * n[k])
}

#[test]
fn rigid_bodies_and_tubes_have_the_momenta_of_closed_forms() {
    let model = Flyers::default();
    for way in WAYS {
        let (rows, _) = rows(&model, way, adaptive(1e-6), &[1e-9]);
        let row = &rows[0];
        // The arm with its tool: two parts, axes of the body.
        let spin = [1.0, -2.0, 3.0];
        let parts = [(2.0, [0.5, 0.0, 0.1]), (0.5, [0.0, 1.0, 0.0])];
        let mass = 2.5;
        let centre: [f64; 3] = std::array::from_fn(|k| parts.iter().map(|(m, at)| m * at[k]).sum::<f64>() / mass);
        let own = [[0.2, 0.01, 0.0], [0.01, 0.3, 0.02], [0.0, 0.02, 0.4]];
        let mut turning: [f64; 3] = own.map(|line| dot(line, spin));
        for (m, at) in parts {
            let arm = std::array::from_fn(|k| at[k] - centre[k]);
            let more = cross(arm, cross(spin, arm));
            (0..3).for_each(|k| turning[k] += m * more[k]);
        }
        let out = |v| turned([1.0, 1.0, 0.0], 50.0f64.to_radians(), v);
        let [carried, from] = [out(cross(spin, centre)), out(centre)];
        let velocity: [f64; 3] = std::array::from_fn(|k| [0.3, 0.0, 1.0][k] + carried[k]);
        near(row, "arm_mass", &[mass], 1e-15);
        near(row, "arm_momentum", &velocity.map(|v| mass * v), 1e-7);
        near(row, "arm_spin", &out(turning), 1e-7);
        near(row, "arm_spin_in", &turning, 1e-7);
        near(
            row,
            "arm_center",
            &std::array::from_fn::<_, 3, _>(|k| [1.0, 2.0, 3.0][k] + from[k]),
            1e-7,
        );
        near(
            row,
            "arm_kinetic",
            &[0.5 * mass * dot(velocity, velocity) + 0.5 * dot(spin, turning)],
            1e-7,
        );
        // The tube turns about its frame's origin, sections included: J = m L^2/12 + rho I L.
        let area = std::f64::consts::PI * 0.03f64.powi(2);
        let (m, second) = (7800.0 * area, std::f64::consts::PI * 0.03f64.powi(4) / 4.0);
        let inertia = m / 12.0 + 7800.0 * second;
        let (sin, cos) = 60.0f64.to_radians().sin_cos();
        let at = [1.5 * cos - sin, 1.5 * sin + cos];
        let velocity = [1.0 - 7.0 * at[1], 2.0 + 7.0 * at[0]];
        near(row, "tube_spin", &[inertia * 7.0], 1e-7);
        near(row, "tube_momentum", &velocity.map(|v| m * v), 1e-7);
        let kinetic = 0.5 * m * (velocity[0].powi(2) + velocity[1].powi(2)) + 0.5 * inertia * 49.0;
        near(row, "tube_kinetic", &[kinetic], 1e-7);
        near(row, "mass", &[2.5 + m + 0.5 + 2.0 * 3.0], 1e-12);
    }
}

#[test]
fn what_falls_keeps_what_nothing_changes_in_both_formulations() {
    let model = Flyers::default();
    let times = [1e-9, 0.1, 0.2, 0.3];
    let all = WAYS.map(|way| rows(&model, way, adaptive(1e-9), &times).0);
    for rows in &all {
        let mass = rows[0][columns("mass")][0];
        let start = |name: &str| rows[0][columns(name)].to_vec();
        let (momentum, center) = (start("momentum"), start("center"));
        for (row, t) in rows.iter().zip(times) {
            let pull = [0.0, -9.81 * t, 0.0];
            let wanted: Vec<f64> = (0..3).map(|k| momentum[k] + mass * pull[k]).collect();
            near(row, "momentum", &wanted, 1e-8);
            let wanted: Vec<f64> = (0..3)
                .map(|k| center[k] + momentum[k] / mass * t + 0.5 * pull[k] * t)
                .collect();
            near(row, "center", &wanted, 1e-8);
            for name in ["spin_about", "spin_rope", "arm_spin", "tube_spin", "energy"] {
                near(row, name, &start(name), 1e-7);
            }
            // L about a place = L about the centre of mass + arm x p.
            let vector = |name: &str| -> [f64; 3] { row[columns(name)].try_into().unwrap() };
            let arm = std::array::from_fn(|k| vector("rope_center")[k] - [1.0, 2.0, 3.0][k]);
            let moved = cross(arm, vector("rope_momentum"));
            near(
                row,
                "spin_at",
                &std::array::from_fn::<_, 3, _>(|k| vector("spin_rope")[k] + moved[k]),
                1e-12,
            );
        }
    }
    // All columns, those of the frames that absolute coordinates find from the bodies, too.
    for (a, b) in all[0].iter().zip(&all[1]) {
        for output in Flyers::outputs() {
            near(a, output.name, &b[columns(output.name)], 3e-7);
        }
    }
}

#[test]
fn nothing_is_unknown_of_the_frames_in_absolute_coordinates() {
    let scene = Flyers::default().build(Formulation::Ancf, Joints::Eliminated).unwrap();
    assert_eq!(scene.constraints(), 0);
    assert_eq!(scene.border(), 6);
    // Of the chord that is not eliminated at its end three conditions are left, of mean axes six.
    let scene = Flyers::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    assert_eq!(scene.constraints(), 3 + 6);
}

#[test]
fn free_flight_on_its_chord_takes_the_steps_of_the_motion() {
    let model = FreeFlight::default();
    let (_, rncf) = rows(&model, Formulation::Rncf, adaptive(1e-8), &[2.0]);
    let (_, ancf) = rows(&model, Formulation::Ancf, adaptive(1e-8), &[2.0]);
    println!(
        "RNCF {} steps, {} rejected; ANCF {}, {}",
        rncf.steps, rncf.rejected_steps, ancf.steps, ancf.rejected_steps
    );
    assert!(rncf.steps < 2 * ancf.steps, "{} against {}", rncf.steps, ancf.steps);
    assert!(
        rncf.rejected_by_newton * 50 <= rncf.steps,
        "{} failures of Newton",
        rncf.rejected_by_newton
    );
}

rncf::model! {
    /// A cable that may start straight, or closed.
    model Shapes {
        param radius = 1 m;
        param round = 1;
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }
        frame f = free();
        body rope in f {
            spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 3 * cable(flat, soft);
            initial position [radius * sin(x / radius) + (1 - round) * x, round * radius * (1 - cos(x / radius)), 0];
            chord;
        }
        output mass = rope.mass;
    }
}

#[test]
fn shapes_without_a_chord_or_straight_ones_are_refused_by_name() {
    let refusal = |model: Shapes| {
        WAYS.map(|way| {
            model
                .build(way, Joints::Eliminated)
                .err()
                .map(|error| error.to_string())
        })
    };
    let closed = Shapes {
        radius: 1.0 / std::f64::consts::PI,
        round: 1.0,
    };
    for text in refusal(closed) {
        let text = text.expect("ends at one place");
        assert!(
            text.contains("the ends of body `rope` start") && text.contains("mean_axes"),
            "{text}"
        );
    }
    for text in refusal(Shapes {
        radius: 1e5,
        round: 0.0,
    }) {
        let text = text.expect("a straight shape");
        assert!(
            text.contains("body `rope` is straight: its chord does not tie the turning"),
            "{text}"
        );
    }
    assert!(refusal(Shapes::default()).iter().all(Option::is_none));
}

rncf::model! {
    /// The cable of free flight whose frame is clamped to the slope at its start.
    model Clamped {
        param elements: count = 3;
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }
        frame f = free(
            origin = [0.3, -0.2, 0.5] m, axis = [1, 2, -1], angle = 40 deg,
            velocity = [-3, 1, 2] m/s, angular_velocity = [4, -1, 1] rad/s
        );
        body cable in f {
            spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh elements * cable(flat, soft);
            initial position [1.5 m * sin(x / 1.5 m), 1.5 m * (1 - cos(x / 1.5 m)), 0];
        }
        joint _root = clamp(cable.start, f);
        joint twist = hold(cable.end.z);
        fixture tip on cable.end { mass = 0.7 kg; }
        output start = cable.start.in(inertial);
        output end = cable.end.in(inertial);
        run { t_end = 2 s; every = 0.01 s; }
    }
}

/// A frame on a slope follows the bending of the mesh: the motion of the cable is the same, the steps are not.
#[test]
fn a_frame_on_a_slope_takes_many_times_the_steps_and_is_named() {
    let times = [0.25];
    let [(slope, clamped), (chord, followed)] = [
        rows(&Clamped::default(), Formulation::Rncf, adaptive(1e-6), &times),
        rows(&FreeFlight::default(), Formulation::Rncf, adaptive(1e-6), &times),
    ];
    println!(
        "slope: {} steps, {} failures of Newton; chord: {}, {}",
        clamped.steps, clamped.rejected_by_newton, followed.steps, followed.rejected_by_newton
    );
    for (a, b) in slope[0][..6].iter().zip(&chord[0]) {
        assert!((a - b).abs() < 1e-3, "{slope:?} {chord:?}");
    }
    assert!(
        clamped.steps > 3 * followed.steps,
        "{} against {}",
        clamped.steps,
        followed.steps
    );
    let scene = Clamped::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let text = scene.loose_tie("frame `f`, rotation about x").expect("a loose tie");
    let wanted =
        "joint `_root` turns frame `f`, which has no mass of its own, with the slope at an end of body `cable`";
    assert!(text.contains(wanted) && text.contains("`chord;`"), "{text}");
    assert_eq!(scene.loose_tie("rigid body `arm`, position x"), None);
    let scene = FreeFlight::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap();
    assert_eq!(scene.loose_tie("frame `f`, rotation about x"), None);
    // Nothing reads the frame: in absolute coordinates neither it nor its ties are there.
    let scene = Clamped::default().build(Formulation::Ancf, Joints::Eliminated).unwrap();
    assert_eq!([scene.constraints(), scene.border()], [0, 0]);
}

rncf::model! {
    /// A cable whose end is level with a place near its start by a row that is written by hand.
    model Level {
        param elements: count = 24;
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }
        frame f = free(plane = xy, origin = [0, 0, 0] m, speed = 3 rad/s);
        body rope in f { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh elements * cable(flat, soft); }
        joint root = pin(rope.start, f);
        constraint level = rope.end.in(f).y - rope.at(0.5 m).in(f).y;
        output tip = rope.end.in(inertial);
    }
}

/// Such a row is linear: it meets the unknowns of both places in its multiplier alone, and the matrix stays as narrow as it is.
#[test]
fn a_linear_row_from_end_to_end_leaves_the_matrix_narrow() {
    let scene = Level::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let (pattern, own) = (scene.pattern(), scene.unknowns() - scene.border());
    assert_eq!(scene.constraints(), 1);
    let far = |i: usize, j: usize| i.abs_diff(j) > 8 && pattern.find(i, j).is_some();
    let coupled = (0..own)
        .flat_map(|i| (0..own).map(move |j| (i, j)))
        .filter(|&(i, j)| far(i, j));
    assert_eq!(coupled.count(), 0);
}
