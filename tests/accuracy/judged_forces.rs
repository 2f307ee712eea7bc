//! What judged runs tell of forces, moments and accelerations: their errors are larger than those of places.

use rncf::app::{Judging, RunResult, RunSettings, run};
use rncf::prelude::*;
use rncf_test_models::Flapping;

rncf::model! {
    /// A spar that nothing loads: its moments are round-off.
    pub model Still {
        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 1 m);
        body spar { spatial; line from [0, 0, 0] m to [30, 40, 90] m; mesh 10 * beam(round, steel); }
        joint root = clamp(spar.start, inertial);
        output tip = spar.end.position;
        output moment = root.moment;
        output force = root.force;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A tether of 2 km between two masses that starts without tension and spins. The wave of the start dies away between the third row and the fourth.
    pub model Tether {
        material fibre { density = 970 kg/m^3; young = 90 GPa; damping = 2 s; }
        section wire { area = 2 mm^2; second_moment = 0.32 mm^4; }
        frame f = free(plane = xy, speed = 0.5 deg/s);
        fixture ship on f { mass = 1000 kg; inertia = 500 kg*m^2; }
        body tether in f { planar xy; line from [0, 0, 0] m to [2, 0, 0] km; mesh 8 * cable(wire, fibre); }
        joint root = pin(tether.start, f);
        fixture probe on tether.end { mass = 50 kg; }
        output tip = tether.end.in(inertial);
        output tension = tether.start.axial_force;
        run { t_end = 300 s; every = 1 s; }
    }
}

rncf::model! {
    /// A bob that bounces on a steel wire, by millimetres, and a stone that flies by, by kilometres.
    pub model Bouncing {
        material steel { density = 7800 kg/m^3; young = 210 GPa; damping = 1 ms; }
        section round { area = 1 mm^2; second_moment = 0.08 mm^4; }
        body wire { planar xy; line from [0, 0, 0] m to [0, -10, 0] m; mesh 4 * cable(round, steel); }
        fixture bob on wire.end { mass = 5 kg; }
        joint hook = pin(wire.start, inertial);
        rigid stone { mass = 1 kg; origin = [0, 0, 100] m; velocity = [2, 0, 0] km/s; }
        load weight = gravity([0, -9.81, 0] m/s^2);
        output stretch = -10 m - wire.end.y;
        output aside = wire.end.x;
        output way = stone.position;
        run { t_end = 1 s; every = 0.01 s; }
    }
}

rncf::model! {
    /// Two equal ropes that swing down, one turned and elsewhere: what they differ by is nothing.
    pub model Copies {
        material _rubber { density = 1100 kg/m^3; young = 5 MPa; damping = 2 ms; }
        section round { area = 78.5 mm^2; second_moment = 491 mm^4; }
        body a { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(round, _rubber); }
        body b { spatial; line from [3.3, 1.7, 0.4] m to [4.1, 2.3, 0.4] m; mesh 4 * cable(round, _rubber); }
        joint hook_a = pin(a.start, inertial);
        joint hook_b = pin(b.start, inertial);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output lengths = norm(a.end) - norm(b.end - [3.3, 1.7, 0.4] m);
        output heights = a.end.z - b.end.z + 0.4 m;
        output pulls = hook_a.force.z - hook_b.force.z;
        output tensions = a.start.axial_force - b.start.axial_force;
        run { t_end = 0.5 s; every = 0.01 s; }
    }
}

fn judged(elements: usize, method: Method, rtol: f64, judged: Judging) -> RunResult {
    run(&Flapping { elements }, &settings(method, rtol, judged)).unwrap()
}

fn settings(method: Method, rtol: f64, judged: Judging) -> RunSettings {
    RunSettings {
        method,
        options: Options {
            rtol,
            ..Options::default()
        },
        judged,
        ..RunSettings::default()
    }
}

/// Largest distance of an output from a second run, as part of its largest change or value there.
fn part_off(columns: &[usize], run: &RunResult, exact: &RunResult) -> f64 {
    let rows = |of: &RunResult| -> Vec<Vec<f64>> {
        let columns: Vec<Vec<f64>> = columns
            .iter()
            .map(|&column| of.history.column(column).collect())
            .collect();
        (0..columns[0].len())
            .map(|row| columns.iter().map(|column| column[row]).collect())
            .collect()
    };
    let distance = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let (rows, exact) = (rows(run), rows(exact));
    let largest = |value: &dyn Fn(usize) -> f64| (0..exact.len()).map(value).fold(0.0, f64::max);
    let zero = vec![0.0; columns.len()];
    let size = largest(&|k| distance(&exact[k], &exact[0])).min(largest(&|k| distance(&exact[k], &zero)));
    largest(&|k| distance(&rows[k], &exact[k])) / size
}

/// Outputs with their columns.
const OUTPUTS: [(&str, &[usize]); 4] = [
    ("tip", &[0]),
    ("force", &[1, 2]),
    ("moment", &[3]),
    ("acceleration", &[4, 5]),
];

/// What a note tells of an output.
pub fn told(note: &str, output: &str) -> Option<f64> {
    let after = note.split(&format!("`{output}` by about ")).nth(1)?;
    Some(after.split(' ').next()?.parse::<f64>().ok()? / 100.0)
}

/// Each output that is off by more than a fiftieth is told within a third and three times of that, of steps and of the mesh.
#[test]
fn errors_of_forces_are_told() {
    let exact = judged(6, Method::Radau, 1e-9, Judging::No);
    let hht = Method::Hht { alpha: -0.05 };
    let alpha = Method::GeneralizedAlpha { rho_inf: 0.8 };
    for (method, rtol, least) in [
        (Method::Radau, 1e-3, 2),
        (Method::Radau, 1e-4, 1),
        (hht, 1e-4, 3),
        (hht, 1e-6, 2),
        (alpha, 1e-5, 3),
    ] {
        let found = judged(6, method, rtol, Judging::Affordable);
        let steps = found
            .warnings
            .iter()
            .find(|note| note.contains("Radau with a tolerance") || note.contains("steps add up"));
        let steps = steps.unwrap_or_else(|| panic!("{method:?} {rtol}: {:?}", found.warnings));
        let mut seen = 0;
        for (name, columns) in OUTPUTS {
            let error = part_off(columns, &found, &exact);
            if error > 0.025 {
                seen += 1;
                let told = told(steps, name).unwrap_or_else(|| panic!("{name}, {method:?} {rtol}: {error}, {steps}"));
                let ratio = told / error;
                assert!(
                    (1.0 / 3.0..3.0).contains(&ratio),
                    "{name}, {method:?} {rtol}: {error}, told {told}"
                );
            }
        }
        assert!(seen >= least, "{method:?} {rtol}: {seen} are off");
    }
    let found = judged(6, Method::Radau, 1e-6, Judging::Affordable);
    let finer = judged(24, Method::Radau, 1e-6, Judging::No);
    assert!(
        found.warnings.len() == 1 && found.warnings[0].contains("too coarse"),
        "{:?}",
        found.warnings
    );
    for (name, columns) in OUTPUTS {
        let error = part_off(columns, &found, &finer);
        match told(&found.warnings[0], name) {
            Some(told) => assert!(
                (1.0 / 3.0..3.0).contains(&(told / error)),
                "{name}: {error}, told {told}"
            ),
            None => assert!(error < 0.015, "{name}: {error}"),
        }
    }
    assert_eq!(
        judged(12, Method::Radau, 1e-6, Judging::Affordable).warnings,
        Vec::<String>::new()
    );
}

/// What is round-off on one mesh is another round-off on the next.
#[test]
fn round_off_is_no_error_of_the_mesh() {
    let settings = RunSettings {
        judged: Judging::Affordable,
        ..RunSettings::default()
    };
    let found = run(&Still::default(), &settings).unwrap();
    assert_eq!((found.judged_until, found.warnings), (Some(1.0), Vec::new()));
}

/// All rows are compared, with steps that are better than those of the run.
#[test]
fn a_start_that_dies_away_within_a_row_is_told() {
    let model = Tether::default();
    let exact = run(&model, &settings(Method::Radau, 1e-9, Judging::No)).unwrap();
    let hht = Method::Hht { alpha: -0.05 };
    let alpha = Method::GeneralizedAlpha { rho_inf: 0.8 };
    for (method, rtol) in [
        (hht, 1e-4),
        (hht, 1e-5),
        (alpha, 1e-4),
        (alpha, 1e-5),
        (Method::Radau, 1e-4),
    ] {
        let found = run(&model, &settings(method, rtol, Judging::Affordable)).unwrap();
        let error = part_off(&[2], &found, &exact);
        let note = found.warnings.iter().find_map(|note| told(note, "tension"));
        println!("{method:?} {rtol:e}: off by {error:.4}, told {note:?}");
        let ratio = note.unwrap_or_else(|| panic!("{method:?} {rtol:e}: {error}, {:?}", found.warnings)) / error;
        assert!(
            error > 0.01 && (1.0 / 3.0..3.0).contains(&ratio),
            "{method:?} {rtol:e}: {error} {note:?}"
        );
    }
    let found = run(&model, &settings(Method::Radau, 1e-5, Judging::Affordable)).unwrap();
    assert!(
        part_off(&[2], &found, &exact) < 0.002 && found.warnings.is_empty(),
        "{:?}",
        found.warnings
    );
}

/// An output is measured by its own size, whatever stands beside it.
#[test]
fn a_small_output_beside_large_ones_is_told() {
    let hht = Method::Hht { alpha: -0.05 };
    let of = |method, rtol, judging| run(&Bouncing::default(), &settings(method, rtol, judging)).unwrap();
    let exact = of(Method::Radau, 1e-9, Judging::No);
    for (method, rtol) in [(hht, 1e-6), (Method::Radau, 1e-4)] {
        let found = of(method, rtol, Judging::Affordable);
        let error = part_off(&[0], &found, &exact);
        let told = found.warnings.iter().find_map(|note| told(note, "stretch"));
        let told = told.unwrap_or_else(|| panic!("{method:?} {rtol}: {error}, {:?}", found.warnings));
        assert!(
            error > 0.02 && (1.0 / 3.0..3.0).contains(&(told / error)),
            "{method:?} {rtol}: {error}, told {told}"
        );
        assert!(
            !found.warnings.iter().any(|note| note.contains("`aside`")),
            "{:?}",
            found.warnings
        );
    }
    assert_eq!(
        of(Method::Radau, 1e-7, Judging::Affordable).warnings,
        Vec::<String>::new()
    );
}

/// A difference that is nothing is measured by what it is made of.
#[test]
fn a_difference_of_equal_copies_is_not_told() {
    for (method, rtol) in [
        (Method::Radau, 1e-4),
        (Method::Radau, 1e-6),
        (Method::Hht { alpha: -0.05 }, 1e-5),
    ] {
        let found = run(&Copies::default(), &settings(method, rtol, Judging::Affordable)).unwrap();
        assert_eq!(found.warnings, Vec::<String>::new(), "{method:?} {rtol}");
    }
}

mod cranks {
    rncf::model! {
        /// Two cranks and a coupler that turn evenly: all that the coupler's mass needs acts at one of its pins, at the other nothing.
        pub model Cranks {
            param w = 1 rad/s;
            rigid a { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; speed = w; }
            rigid b { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [3, 0, 0] m; speed = w; }
            rigid c { plane xy; mass = 2 kg; inertia = 1 kg*m^2; origin = [0, 1, 0] m; velocity = -w * [1, 0, 0] m; }
            joint left = revolute(inertial, a);
            joint right = revolute(inertial.at([3, 0, 0] m), b);
            joint front = revolute(a.at([0, 1, 0] m), c);
            joint back = revolute(b.at([0, 1, 0] m), c.at([3, 0, 0] m));
            output angle = a.angle;
            output carried = front.force;
            output spared = back.force;
            run { t_end = 20 s; every = 0.05 s; }
        }
    }
}

/// A reaction is known as well as those that it balances.
#[test]
fn a_reaction_that_is_nothing_is_no_other_motion() {
    for rtol in [1e-6, 1e-8] {
        let found = run(
            &cranks::Cranks::default(),
            &settings(Method::Radau, rtol, Judging::Affordable),
        )
        .unwrap();
        assert_eq!(found.warnings, Vec::<String>::new(), "{rtol}");
        let first = found.history.find("spared.x").unwrap();
        let largest =
            [first, first + 1].map(|column| found.history.column(column).fold(0.0, |most: f64, f| most.max(f.abs())));
        assert!(
            largest.iter().all(|most| *most < 2.0 * rtol.sqrt()),
            "{rtol}: {largest:?}"
        );
    }
}

mod ground {
    rncf::model! {
        /// A body that is welded to the ground, beside a pendulum.
        pub model Ground {
            rigid a { plane xy; mass = 1.7 kg; inertia = 0.018 kg*m^2; origin = [0.033, 0.137, 0] m; center = [0.019, 0.084, 0] m; }
            rigid b { plane xy; mass = 1.5 kg; inertia = 0.0168 kg*m^2; origin = [0.2425, -0.349, 0] m; }
            joint foot = weld(inertial.at([0.2496, -0.0156, 0] m), a.at([0.2166, -0.1526, 0] m));
            joint pivot = spherical(inertial.at([0.2496, -0.0156, 0] m), b.at([0.0071, 0.3334, 0] m));
            load weight = gravity([7.6, -6.2, 0] m/s^2);
            output velocity = a.velocity;
            output acceleration = a.center.acceleration;
            output swing = b;
            output mass: [t] = total.mass;
            output moment: N m = foot.moment.z;
            run { t_end = 0.5 s; every = 0.05 s; }
        }
    }
}

/// Velocities and accelerations of what stands still are round-off, which no steps lose; units of outputs with blanks and in brackets are units.
#[test]
fn what_stands_still_loses_no_vibrations() {
    let found = run(
        &ground::Ground::default(),
        &settings(Method::Radau, 1e-6, Judging::Affordable),
    )
    .unwrap();
    assert_eq!(found.warnings, Vec::<String>::new());
    let [mass, moment] = ["mass", "moment"].map(|name| {
        let column = found.history.find(name).unwrap();
        found.history.column(column).next().unwrap()
    });
    assert!((mass - 3.2e-3).abs() < 1e-15 && moment.abs() > 0.1, "{mass} {moment}");
}

mod stretched {
    rncf::model! {
        /// A bar of 1 m under a step of its load: its end moves by half a millimetre.
        pub model Stretched {
            material steel { density = 7850 kg/m^3; young = 210 GPa; }
            section round = circle(radius = 10 mm);
            body bar { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 20 * cable(round, steel, axial = engineering); }
            joint root = clamp(bar.start, inertial);
            load pull = force(bar.end, [50000 N, 0 N, 0 N]);
            output end = bar.end.x;
            run { t_end = 4 ms; every = 4 ms; }
        }
    }
}

/// What is known to a small part of its change has one, however small beside its value.
#[test]
fn a_change_that_is_small_beside_its_value_is_compared() {
    let found = run(
        &stretched::Stretched::default(),
        &settings(Method::Radau, 1e-6, Judging::Affordable),
    )
    .unwrap();
    let told = found.agreement.unwrap();
    assert!(told.contains("of their largest change (`end`)"), "{told}");
}
