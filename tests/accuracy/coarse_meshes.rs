//! What meshes are told of themselves: estimates of their errors beside the errors against closed forms.

use rncf::app::{
    Campbell, EquilibriumSettings, Judging, Range, RunResult, RunSettings, campbell, modes, run, static_equilibria,
};
use rncf::equilibrium::{Uniform, follow};
use rncf::modes::{Mode, Wanted};
use rncf::prelude::*;
use rncf_test_models::Rope;

rncf::model! {
    /// Half rings and cantilevers, each with a force at its end.
    pub model Bent {
        param n: count = 4;
        param force = 0.1 N;
        material m { density = 1000 kg/m^3; young = 1e10 Pa; poisson = 0.3; }
        section strip { area = 1 cm^2; second_moment = 1e-8 m^4; shear_factor = 5/6; }
        section taper { area = 1 [cm^2] * (1 - x / 2 [m])^2; second_moment = 1e-8 [m^4] * (1 - x / 2 [m])^4; }
        body ring { planar xy; arc from [1, 0, 0] m direction [0, 1, 0] radius 1 m angle 180 deg; mesh n * cable(strip, m); }
        body bow { planar xy; arc from [1, 0, 0] m direction [0, 1, 0] radius 1 m angle 180 deg; mesh n * beam(strip, m); }
        body spike { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh n * cable(taper, m); }
        joint root_of_ring = clamp(ring.start, inertial);
        joint root_of_bow = clamp(bow.start, inertial);
        joint root_of_spike = clamp(spike.start, inertial);
        load on_ring = force(ring.end, [-force, 0 N, 0 N]);
        load on_bow = force(bow.end, [-force, 0 N, 0 N]);
        load on_spike = force(spike.end, [0 N, force, 0 N]);
        output of_ring = -1 m - ring.end.x;
        output of_bow = -1 m - bow.end.x;
        output of_spike = spike.end.y;
    }
}

rncf::model! {
    /// A cantilever in bending and stretching.
    pub model Reed {
        param n: count = 4;
        material m { density = 1000 kg/m^3; young = 1e10 Pa; }
        section strip { area = 1 cm^2; second_moment = 1e-8 m^4; }
        body reed { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh n * cable(strip, m); }
        joint root = clamp(reed.start, inertial);
        output tip = reed.end.y;
    }
}

rncf::model! {
    /// A reed on a hub that turns.
    pub model Blade {
        param n: count = 4;
        param speed = 20 rad/s;
        material m { density = 1000 kg/m^3; young = 1e10 Pa; }
        section strip { area = 1 cm^2; second_moment = 1e-8 m^4; }
        frame hub = rotating(axis = z, angle = speed * t);
        body reed in hub { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh n * cable(strip, m); }
        joint root = clamp(reed.start, hub);
        output tip = reed.end.y;
    }
}

rncf::model! {
    /// A wire with a weight hangs from two hooks: its shape bends, its strains are small.
    pub model Wire {
        param n: count = 6;
        material m { density = 8000 kg/m^3; young = 1e9 Pa; }
        section round = circle(radius = 1 mm);
        body line {
            planar xy;
            line from [0, 0, 0] m to [10, 0, 0] m;
            mesh n * cable(round, m, axial = engineering, bending = exact);
            initial position [0.9 * x, -1.2 m * sin(pi * x / 10 [m]), 0 m];
        }
        joint left = pin(line.start, inertial);
        joint right = pin(line.end, inertial, at = [9, 0, 0] m);
        fixture weight on line.at(5 m) { mass = 0.1 kg; }
        load g = gravity([0, -9.81, 0] m/s^2);
        output sag = -line.at(5 m).y;
    }
}

rncf::model! {
    /// A point on an eccentric orbit, ten times round.
    pub model Orbit {
        rigid point { mass = 1 kg; origin = [0.5, 0, 0] m; velocity = [0, 1.7320508075688772, 0] m/s; }
        load pull = force(point, -1 [m^3/s^2] * 1 kg * point.position / norm(point.position)^3);
        output place = point.position;
        run { t_end = 62.83 s; every = 0.1 s; }
    }
}

/// Outputs at rest under the loads, and for every body the part of its energy that is error.
fn at_rest(model: &impl Model) -> (Vec<f64>, Vec<f64>) {
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let at = Uniform::at_rest(0.0);
    let found = follow(scene.as_mut(), &at, 1.0, |_, _| ()).unwrap();
    let state = found.state().unwrap();
    let mut outputs = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&at, state, &mut outputs);
    let mut errors = Vec::new();
    scene.uniform_mesh_errors(&at, state, &mut errors);
    (outputs, errors.iter().map(|of| of.error / of.energy).collect())
}

/// Whether an estimate is between a third and three times of the error.
#[track_caller]
fn assert_true(estimate: f64, error: f64, what: &str) {
    println!("{what}: {error:.2e}, estimated {estimate:.2e}");
    let ratio = estimate / error;
    assert!(
        (1.0 / 3.0..3.0).contains(&ratio),
        "{what}: {error:e}, estimated {estimate:e}"
    );
}

/// What a mesh is too stiff by: F r^3 pi / (2 EI) of half a ring (with what shear and stretch add), 2/3 F L^3 / EI of a spike.
#[test]
fn the_energy_that_is_error_is_what_a_deflection_is_too_small_by() {
    let flexible = 1e-2;
    let stretch = 0.5 * std::f64::consts::PI / 1e6;
    let ring = 0.5 * std::f64::consts::PI * flexible;
    let shear = stretch * 2.6 * 1.2;
    let exact = [ring + stretch, ring + stretch + shear, 2.0 / 3.0 * flexible];
    for n in [2, 4, 8] {
        let (deflections, estimates) = at_rest(&Bent { n, force: 1e-3 });
        for (body, name) in ["ring", "bow", "spike"].iter().enumerate() {
            let error = 1.0 - deflections[body] / (1e-3 * exact[body]);
            assert_true(estimates[body], error, &format!("{name}, {n} elements"));
        }
    }
    let told = |n: usize| {
        static_equilibria(&Bent { n, force: 0.1 }, &EquilibriumSettings::default())
            .unwrap()
            .warnings
    };
    let coarse = told(4);
    assert!(coarse[0].contains("about 5.6 % of `ring` (4 elements)"), "{coarse:?}");
    assert!(told(16).is_empty());
}

/// Catenaries are strings: what is taken up by tension counts. The sag of a very fine mesh is 2.0937 m (parabolas of equal arclength
/// agree to a hundredth).
#[test]
fn a_hanging_wire_is_judged_by_its_tension() {
    for n in [4, 10] {
        let (sag, estimate) = at_rest(&Wire { n });
        assert_true(estimate[0], 1.0 - sag[0] / 2.0937, &format!("wire, {n} elements"));
    }
}

/// Frequencies of a cantilever: (beta L)^2 sqrt(EI / (rho A)) / L^2, and odd multiples of pi / 2 sqrt(E / rho) / L.
#[test]
fn the_error_of_a_frequency_is_estimated() {
    let bending =
        [1.875_104_068_711_961, 4.694_091_132_974_175, 7.854_757_438_237_613].map(|x: f64| x * x * 1e3_f64.sqrt());
    let axial = 0.5 * std::f64::consts::PI * 1e7_f64.sqrt();
    for n in [1, 2, 4, 8] {
        let mut scene = Reed { n }.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let (at, state) = (Uniform::at_rest(0.0), scene.rest(0.0));
        let found = rncf::modes::modes(scene.as_mut(), &at, &state, Wanted { count: 8 }).unwrap();
        let (lateral, along): (Vec<Mode>, Vec<Mode>) = found.into_iter().partition(|mode| is_bending(&mode.shape));
        for (modes, exact) in [(lateral, &bending[..]), (along, &[axial])] {
            let estimates = rncf::modes::mesh_errors(scene.as_mut(), &at, &state, &modes);
            for ((mode, exact), estimate) in modes.iter().zip(exact).zip(estimates) {
                let error = mode.im / exact - 1.0;
                // Below, axial strain counts that the closed form leaves out.
                if (2e-5..0.5).contains(&error) {
                    assert_true(estimate[0], error, &format!("{exact:.0} rad/s, {n} elements"));
                }
            }
        }
    }
    let told = modes(
        &Reed { n: 4 },
        &EquilibriumSettings {
            count: 4,
            ..EquilibriumSettings::default()
        },
    )
    .unwrap()
    .warnings;
    assert!(
        told.len() == 1 && told[0].contains("of mode 3 by about 0.8 % and of mode 4 by about 1.4 % is too high"),
        "{told:?}"
    );
}

/// Components of planar nodal vectors stand one after the other.
fn is_bending(shape: &[[f64; 2]]) -> bool {
    let sum = |first: usize| -> f64 {
        shape
            .iter()
            .skip(first)
            .step_by(2)
            .map(|value| value[0] * value[0])
            .sum()
    };
    sum(1) > sum(0)
}

/// At 2 s the tip of 8 elements is 2 cm from where it belongs, of 1 m; that of 16 elements is 1 mm off.
#[test]
fn a_run_tells_that_its_mesh_is_too_coarse() {
    for (method, formulation) in [
        (Method::Radau, Formulation::Rncf),
        (Method::Radau, Formulation::Ancf),
        (Method::Hht { alpha: -0.05 }, Formulation::Rncf),
    ] {
        let settings = RunSettings {
            method,
            formulation,
            ..RunSettings::default()
        };
        let told = run(&Rope::default(), &settings).unwrap().warnings;
        assert!(
            told.len() == 1 && told[0].contains("about 3.5 % of `rope` (8 elements)"),
            "{told:?}"
        );
        assert!(run(&Rope { n: 16 }, &settings).unwrap().warnings.is_empty());
    }
}

/// Places of the tip of a rope, m.
fn path(result: &RunResult) -> Vec<[f64; 2]> {
    let [x, y] = [0, 1].map(|column| result.history.column(column).collect::<Vec<f64>>());
    x.into_iter().zip(y).map(|(x, y)| [x, y]).collect()
}

/// What a note says that an output is off by.
fn part(note: &str) -> f64 {
    let after = note.split(" by about ").nth(1).unwrap();
    after.split(' ').next().unwrap().parse::<f64>().unwrap() / 100.0
}

/// A rope falls from the horizontal. The energy of its strains is small beside that of its motion, and does not tell what becomes of its path.
#[test]
fn a_judged_run_tells_what_its_outputs_are_off_by() {
    let with = |method, rtol, formulation| RunSettings {
        method,
        formulation,
        options: Options {
            rtol,
            ..Options::default()
        },
        judged: Judging::Affordable,
        ..RunSettings::default()
    };
    let hht = Method::Hht { alpha: -0.05 };
    let fine = RunSettings {
        judged: Judging::No,
        ..with(Method::Radau, 1e-6, Formulation::Rncf)
    };
    let exact = path(&run(&Rope { n: 32 }, &fine).unwrap());
    let error_and_notes = |n: usize, settings: RunSettings| {
        let found = run(&Rope { n }, &settings).unwrap();
        assert_eq!(found.judged_until, Some(2.0));
        let apart = path(&found)
            .into_iter()
            .zip(&exact)
            .map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
        (apart.fold(0.0, f64::max), found.warnings)
    };
    for (n, method, rtol, formulation) in [
        (8, Method::Radau, 1e-6, Formulation::Rncf),
        (8, hht, 1e-4, Formulation::Ancf),
        (4, Method::Radau, 1e-3, Formulation::Rncf),
    ] {
        let (error, told) = error_and_notes(n, with(method, rtol, formulation));
        let what = format!("{n} elements, {method:?} {rtol}");
        let start = format!("with twice as many elements in `rope` ({n}) outputs differ by");
        assert!(told.len() == 1 && told[0].contains(&start), "{told:?}");
        assert_true(part(&told[0]), error, &what);
    }
    let (error, told) = error_and_notes(16, with(Method::Radau, 1e-4, Formulation::Rncf));
    assert!(error < 0.01 && told.is_empty(), "{error}, {told:?}");
}

/// Where finer meshes take longer than the run, the program says how far it looked.
#[test]
fn what_was_not_judged_is_told() {
    let found = |judged| {
        let settings = RunSettings {
            t_end: Some(40.0),
            options: Options {
                rtol: 1e-3,
                ..Options::default()
            },
            judged,
            ..RunSettings::default()
        };
        run(&Rope { n: 8 }, &settings).unwrap()
    };
    let is_told = |of: &RunResult| {
        of.warnings
            .iter()
            .any(|note| note.contains("nothing is known of their errors"))
    };
    let [short, whole] = [Judging::Affordable, Judging::Whole].map(found);
    assert!(
        short.judged_until.unwrap() < 39.0 && is_told(&short),
        "{:?} {:?}",
        short.judged_until,
        short.warnings
    );
    assert!(
        whole.judged_until == Some(40.0) && !is_told(&whole),
        "{:?}",
        whole.warnings
    );
}

/// A point on an orbit that goes ten times round: errors of steps add up, with Radau at a loose tolerance, too.
#[test]
fn a_judged_run_tells_what_its_steps_add_up_to() {
    let told = |rtol| {
        let settings = RunSettings {
            options: Options {
                rtol,
                ..Options::default()
            },
            judged: Judging::Affordable,
            ..RunSettings::default()
        };
        let found = run(&Orbit::default(), &settings).unwrap();
        // The period of a semi-major axis of 1 m is 2 pi seconds where mu is 1 m^3/s^2; the run begins at the pericentre, 0.5 m.
        let error = found.history.keys.iter().zip(path(&found)).map(|(t, place)| {
            let mut anomaly: f64 = *t;
            for _ in 0..60 {
                anomaly -= (anomaly - 0.5 * anomaly.sin() - t) / (1.0 - 0.5 * anomaly.cos());
            }
            let exact = [anomaly.cos() - 0.5, 0.75_f64.sqrt() * anomaly.sin()];
            (place[0] - exact[0]).hypot(place[1] - exact[1]) / 1.5
        });
        (error.fold(0.0, f64::max), found.warnings)
    };
    for rtol in [1e-3, 1e-4] {
        let (error, notes) = told(rtol);
        assert!(
            error > 0.01 && notes.len() == 1 && notes[0].contains("steps add up"),
            "{error}, {notes:?}"
        );
        assert_true(part(&notes[0]), error, &format!("orbit, {rtol}"));
    }
    let (error, notes) = told(1e-6);
    assert!(error < 1e-3 && notes.is_empty(), "{error}, {notes:?}");
}

/// A Campbell diagram tells the modes whose frequencies are too high, as far as a fine mesh has them lower.
#[test]
fn a_campbell_diagram_is_judged_by_its_modes() {
    let found = |n: usize| {
        let range = Range {
            param: 1,
            from: 0.0,
            to: 40.0,
        };
        let settings = EquilibriumSettings {
            range: Some(range),
            steps: 4,
            count: 3,
            ..EquilibriumSettings::default()
        };
        let blade = Blade { n, ..Blade::default() };
        campbell(&blade, &settings).unwrap()
    };
    let [coarse, fine] = [2, 24].map(found);
    assert_eq!(
        (fine.warnings.len(), coarse.warnings.len()),
        (0, 1),
        "{:?} {:?}",
        fine.warnings,
        coarse.warnings
    );
    let frequency = |of: &Campbell, mode: usize| of.tracks[mode][0].unwrap().im;
    let mut told = 0;
    for mode in 0..3 {
        let error = frequency(&coarse, mode) / frequency(&fine, mode) - 1.0;
        let name = format!("of mode {} by about ", mode + 1);
        match coarse.warnings[0].split(&name).nth(1) {
            Some(after) => {
                let part: f64 = after.split(' ').next().unwrap().parse().unwrap();
                assert_true(part / 100.0, error, &format!("mode {}", mode + 1));
                told += 1;
            }
            None => assert!(error < 0.01, "mode {}: {error}", mode + 1),
        }
    }
    assert!(told > 0);
}

rncf::model! {
    /// A taut cable with a damper near its end.
    pub model Stay {
        param n: count = 20;
        const strain = 3e-3;
        const L = 100 m;
        material wire { density = 8000 kg/m^3; young = 200 GPa; }
        section strand { area = 50 cm^2; second_moment = 1e-9 m^4; }
        body cab { planar xy; line from [0, 0, 0] m to [L, 0, 0]; mesh n * cable(strand, wire, axial = engineering, bending = exact); initial position [x * (1 + strain), 0, 0]; }
        joint a = pin(cab.start, inertial);
        joint b = pin(cab.end, inertial, at = [L * (1 + strain), 0, 0]);
        spring damper = bushing(cab.at(5 m), inertial.at([5 m * (1 + strain), 0 m, 0 m]), stiffness = [0, 0, 0], damping = [0, 20, 0] kN*s/m);
        output y = cab.at(L/2).y;
        run { t_end = 1 s; every = 0.01 s; }
    }
}

/// Rate of growth of the fourth mode of a taut string, where `sinh(s L) + eta sinh(s a) sinh(s (L - a)) = 0` (scipy), 1/s.
const OF_STRING: f64 = -0.9992530650;

/// Frequencies of a taut cable are right to 2e-4 where its dampings are 7 % off: a kink at the damper converges slowly.
#[test]
fn dampings_are_judged_as_frequencies_are() {
    let mut before = f64::INFINITY;
    for n in [20, 40] {
        let settings = EquilibriumSettings {
            count: 4,
            judged: Judging::Affordable,
            ..EquilibriumSettings::default()
        };
        let found = modes(&Stay { n }, &settings).unwrap();
        let error = (found.modes[3].re / OF_STRING - 1.0).abs();
        let note = found
            .warnings
            .iter()
            .find(|note| note.contains("the damping differs by parts of it"));
        let told = part(note.unwrap().rsplit("of mode 4").next().unwrap());
        assert!(
            told > 0.4 * error && told < error && error < 0.7 * before,
            "{told} {error}"
        );
        before = error;
    }
}

rncf::model! {
    /// A rigid boom of 2 m and 10 kg/m on a hinge, in waves of 0.3 m.
    pub model Boom {
        param elements: count = 4;
        section spar { EA = 1 GN; GAy = 1 GN; GAz = 1 GN; GJ = 1 GN*m^2; EIy = 1 GN*m^2; EIz = 1 GN*m^2; mass = 10 kg/m; inertia_y = 1 g*m; inertia_z = 1 g*m; }
        body boom { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh elements * beam(spar); rigid; }
        joint root = clamp(boom.start, inertial);
        load waves = distributed(boom, [0, 0, 100 [N/m] * sin(10 [1/m] * x)^2]);
        output force = root.force.z;
        output moment = root.moment.y;
        run { t_end = 1 s; every = 0.5 s; }
    }
}

/// Elements of what does not deform integrate loads along it: from `static`, too, where nothing is unknown.
#[test]
fn loads_along_rigid_bodies_are_judged() {
    let integral = |f: fn(f64) -> f64| {
        let h = 2.0 / 2000.0;
        (0..2000).map(|k| f((f64::from(k) + 0.5) * h) * h).sum::<f64>()
    };
    let exact = [
        integral(|x| 100.0 * (10.0 * x).sin().powi(2)),
        integral(|x| 100.0 * x * (10.0 * x).sin().powi(2)),
    ];
    for elements in [4, 16] {
        let model = Boom { elements };
        let settings = EquilibriumSettings {
            judged: Judging::Affordable,
            ..EquilibriumSettings::default()
        };
        let found = static_equilibria(&model, &settings).unwrap();
        for (column, exact) in exact.iter().enumerate() {
            let value = found.history.column(column).last().unwrap().abs();
            let error = (value / exact - 1.0).abs();
            let told = found.off_by.iter().find(|off| off.0 == column).map_or(0.0, |off| off.1);
            println!("{elements}: {value} for {exact}, off by {error:.1e}, told {told:.1e}");
            assert!(
                (0.5..2.0).contains(&(told / error)) || error < 1e-6,
                "{error:.1e}, told {told:.1e}"
            );
        }
        let of_run = run(
            &model,
            &RunSettings {
                judged: Judging::Affordable,
                ..RunSettings::default()
            },
        )
        .unwrap();
        assert_eq!(of_run.warnings.is_empty(), elements == 16, "{:?}", of_run.warnings);
    }
}

rncf::model! {
    /// DaDeppo and Schmidt's arch, clamped and hinged: no equilibria beyond 8.97 EI/R^2 next to those before.
    pub model Arch {
        param load = 0 N;
        param elements: count = 16;
        material m { density = 1 kg/m^3; young = 1 MPa; }
        section s { area = 100 m^2; second_moment = 1 m^4; }
        const half = 107.5 deg;
        body arch {
            planar xy;
            arc from [-100 m * sin(half), 100 m * cos(half), 0 m] direction [cos(half), sin(half), 0] radius 100 m angle -215 deg;
            mesh elements * cable(s, m, axial = engineering, bending = exact);
        }
        joint left = pin(arch.start, inertial);
        joint right = clamp(arch.end, inertial);
        const mid = 100 m * 3.752457891787808 / 2;
        load push = force(arch.at(mid), [0 N, -load, 0 N]);
        output crown = arch.at(mid);
    }
}

/// A mesh that is too stiff goes past the limit; that the finer one finds nothing there is told.
#[test]
fn rows_beyond_the_limit_load_of_a_finer_mesh_are_told() {
    let told = |to: f64| {
        let settings = EquilibriumSettings {
            range: Some(Range {
                param: 0,
                from: 0.0,
                to,
            }),
            judged: Judging::Whole,
            ..EquilibriumSettings::default()
        };
        static_equilibria(&Arch::default(), &settings).unwrap()
    };
    let beyond = told(1000.0);
    assert_eq!(beyond.history.keys.last(), Some(&1000.0));
    let note = |of: &rncf::app::Equilibria| {
        of.warnings
            .iter()
            .any(|text| text.contains("no equilibrium is found beyond load = 9"))
    };
    assert!(note(&beyond), "{:?}", beyond.warnings);
    assert!(!note(&told(800.0)));
}
