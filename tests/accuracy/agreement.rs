//! What judged runs say of their own errors, against closed forms: the warnings where they are large, and the line that tells how small they are.

use rncf::AnyModel;
use rncf::app::{
    Equilibria, EquilibriumSettings, Judging, Range, RunResult, RunSettings, modes, run, static_equilibria,
};
use rncf::prelude::*;

rncf::model! {
    /// A bar that is pulled at its end from 0.1 ms on: it moves by less than a millionth of its length.
    pub model Pulled {
        param elements: count = 16;
        material alu { density = 2700 kg/m^3; young = 70 GPa; }
        section rod = circle(radius = 10 mm);
        body bar { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * cable(rod, alu); }
        joint root = clamp(bar.start, inertial);
        load pull = force(bar.end, [if t < 1e-4 s { 0 [N] } else { 10 [N] }, 0, 0]);
        output u = bar.end.x - 1 m;
        run { t_end = 3 ms; every = 0.01 ms; }
    }
}

rncf::model! {
    /// A charge that circles in a magnetic field: nothing damps the errors of its phase.
    pub model Circling {
        param rate = 100 1/s;
        rigid charge { mass = 1 kg; velocity = [1, 0, 0.1] m/s; }
        load field = force(charge, 1 [kg] * rate * cross(charge.velocity, inertial.ez));
        output x = charge.x;
        output z = charge.z;
        run { t_end = 2 s; every = 0.01 s; }
    }
}

fn judged(model: &dyn AnyModel, method: Method, rtol: f64) -> RunResult {
    let settings = RunSettings {
        method,
        options: Options {
            rtol,
            ..Options::default()
        },
        judged: Judging::Whole,
        ..RunSettings::default()
    };
    run(model, &settings).unwrap()
}

/// Largest distance of the first output from a closed form, over its largest value.
fn error(of: &RunResult, exact: impl Fn(f64) -> f64) -> f64 {
    let pairs = || of.history.keys.iter().zip(of.history.column(0));
    let size = pairs().map(|(&t, _)| exact(t).abs()).fold(0.0, f64::max);
    pairs().map(|(&t, x)| (x - exact(t)).abs()).fold(0.0, f64::max) / size
}

/// The end of a bar after d'Alembert: there and back twice.
fn end_of_bar(t: f64) -> f64 {
    let (young, density, area) = (70e9f64, 2700.0, std::f64::consts::PI * 1e-4);
    let phase = ((t - 1e-4).max(0.0) * (young / density).sqrt()) % 4.0;
    phase.min(4.0 - phase) * 10.0 / (young * area)
}

/// Ten times the tolerance of such a run finds as little of the wave as the run does: it is a tenth that tells. What one element lacks is told, though the
/// way is less than what larger tolerances know of a bar of 1 m.
#[test]
fn small_waves_are_told_with_their_errors() {
    for (elements, rtol, what) in [
        (1, 1e-8, "The mesh is too coarse"),
        (4, 1e-8, "The mesh is too coarse"),
        (16, 1e-6, "The tolerance of 1e-6"),
    ] {
        let found = judged(&Pulled { elements }, Method::Radau, rtol);
        let error = error(&found, end_of_bar);
        let note = found.warnings.iter().find(|note| note.starts_with(what));
        let told = note.and_then(|note| super::judged_forces::told(note, "u"));
        let ratio = told.unwrap_or(0.0) / error;
        assert!(
            (1.0 / 3.0..3.0).contains(&ratio),
            "{elements} elements, {rtol:e}: off by {error}, {:?}",
            found.warnings
        );
        assert_eq!(found.agreement, None);
    }
}

/// Errors too small for a warning stand in a line, within a third and three times; those of tight tolerances, too, which larger ones do not know.
#[test]
fn small_errors_stand_in_a_line() {
    for (rate, method, rtol) in [
        (100.0, Method::Radau, 1e-5),
        (100.0, Method::Radau, 1e-6),
        (3.0, Method::Radau, 1e-6),
        (3.0, Method::Radau, 1e-8),
        (100.0, Method::Hht { alpha: -0.05 }, 2e-9),
        (100.0, Method::GeneralizedAlpha { rho_inf: 0.8 }, 2e-9),
    ] {
        let found = judged(&Circling { rate }, method, rtol);
        assert_eq!(found.warnings, Vec::<String>::new(), "{method:?} {rtol:e}");
        let error = error(&found, |t| (rate * t).sin() / rate);
        let (output, told) = found.off_by[0];
        let line = found.agreement.as_deref().unwrap_or_default();
        assert!(
            output == 0 && (1.0 / 3.0..3.0).contains(&(told / error)),
            "{method:?} {rtol:e}: off by {error}, told {told}: {line}"
        );
        let expected =
            format!("Compared with other steps, outputs differ by at most {told:.1e} of their largest change (`x`).");
        assert_eq!(line, expected);
    }
}

/// With meshes, too, the line is of the tolerance of the run: a hundredth of what a larger one finds. Found are ten times the tolerance, and the mesh.
#[test]
fn small_errors_of_meshes_stand_in_a_line() {
    let model = |elements| rncf_models::SpinUp {
        elements,
        ..rncf_models::SpinUp::default()
    };
    let found = judged(&model(24), Method::Radau, 1e-8);
    let settings = RunSettings {
        options: Options {
            rtol: 1e-10,
            ..Options::default()
        },
        ..RunSettings::default()
    };
    let reference = run(&model(96), &settings).unwrap();
    let deflection = |of: &RunResult| -> Vec<f64> { of.history.column(1).collect() };
    let exact = deflection(&reference);
    let size = exact.iter().fold(0.0_f64, |size, v| size.max(v.abs()));
    let differences = deflection(&found)
        .into_iter()
        .zip(exact)
        .map(|(v, exact)| (v - exact).abs());
    let error = differences.fold(0.0, f64::max) / size;
    let told = found.off_by.iter().find(|off| off.0 == 1).map_or(0.0, |off| off.1);
    let line = found.agreement.as_deref().unwrap_or_default();
    assert!(
        (1.0 / 3.0..30.0).contains(&(told / error)),
        "off by {error}, told {told}: {line}"
    );
}

rncf::model! {
    /// A pinned column.
    pub model Column {
        param elements: count = 2;
        param load_of = 1 kN;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar = rectangle(y = 10 mm, z = 20 mm);
        body column { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(bar, steel); }
        joint foot = pin(column.start, inertial);
        joint head = hold(column.end.y);
        load push = force(column.end, [-load_of, 0, 0]);
        output shortening = 1 m - column.end.x;
    }
}

rncf::model! {
    /// A quarter of a circle with a force across its plane.
    pub model Bow {
        param elements: count = 4;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar = circle(radius = 5 mm);
        body bow { spatial; arc from [0, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius 1 m angle 90 deg; mesh elements * beam(bar, steel); }
        joint root = clamp(bow.start, inertial);
        load push = force(bow.end, [0, 0, 0.1] N);
        output z = bow.end.z;
    }
}

rncf::model! {
    /// A cable of 100 m between two points that are 80 m apart. It starts as a sine, which strains it.
    pub model Hanging {
        param elements: count = 16;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section rope { area = 100 mm^2; second_moment = 1 mm^4; }
        body cable {
            planar xy;
            line from [0, 0, 0] m to [100, 0, 0] m;
            mesh elements * cable(rope, steel);
            initial position [0.8 * x, -25 m * sin(pi * x / 100 [m]), 0];
        }
        joint left = pin(cable.start, inertial);
        joint right = pin(cable.end, inertial, at = [80, 0, 0] m);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output sag = -cable.at(50 m).y;
        output pull = -left.force.x;
    }
}

fn equilibria(model: &dyn AnyModel, range: Option<Range>) -> Equilibria {
    let settings = EquilibriumSettings {
        range,
        judged: Judging::Whole,
        ..EquilibriumSettings::default()
    };
    static_equilibria(model, &settings).unwrap()
}

const COARSE: &str = "The mesh is too coarse for these equilibria";

/// That a line tells an error behind these words, in such parts of one, within a third and three times.
fn assert_told(line: &str, words: &str, parts: f64, error: f64) {
    let number = line.split(words).nth(1).and_then(|rest| rest.split(' ').next());
    let told = number.unwrap().parse::<f64>().unwrap() / parts;
    assert!((1.0 / 3.0..3.0).contains(&(told / error)), "off by {error}: {line}");
}

/// A straight column has no error of its elements in front of its buckling. Euler's load is right to 4e-4 for this one, which shortens and shears.
#[test]
fn critical_values_are_told_with_their_errors() {
    let euler = std::f64::consts::PI.powi(2) * 210e9 * 20e-3 * 10e-3f64.powi(3) / 12.0;
    let range = Range {
        param: 1,
        from: 500.0,
        to: 8000.0,
    };
    for (elements, is_told) in [(1, true), (2, false)] {
        let found = equilibria(
            &Column {
                elements,
                ..Column::default()
            },
            Some(range),
        );
        let error = (1e3 * found.critical[0].value - euler) / euler;
        let (words, line) = if is_told {
            let note = found.warnings.iter().find(|note| note.starts_with(COARSE));
            ("the critical value at load_of = 4.198 kN by about ", note.cloned())
        } else {
            (", critical values by ", found.agreement.clone())
        };
        let line = line.unwrap_or_else(|| panic!("{elements}: {:?}", found.warnings));
        assert_told(&line, words, if is_told { 100.0 } else { 1.0 }, error);
    }
}

/// After Castigliano: bending and torsion of a quarter of a circle.
#[test]
fn equilibria_are_told_with_their_errors() {
    let (stiffness, pi) = (
        210e9 * std::f64::consts::PI * 5e-3f64.powi(4) / 4.0,
        std::f64::consts::PI,
    );
    let exact = 0.1 * (pi / 4.0 / stiffness + (0.75 * pi - 2.0) * 1.3 / stiffness);
    for (elements, is_told) in [(2, true), (8, false)] {
        let found = equilibria(&Bow { elements }, None);
        let error = (found.history.column(0).last().unwrap() - exact).abs() / exact;
        let told = found.off_by[0].1;
        assert!(
            (1.0 / 3.0..3.0).contains(&(told / error)),
            "{elements}: off by {error}, told {told}"
        );
        let note = found.warnings.iter().find(|note| note.starts_with(COARSE));
        assert_eq!(
            (note.is_some(), found.agreement.is_none()),
            (is_told, is_told),
            "{elements}"
        );
    }
}

/// The strained start is no equilibrium without loads, and no row. The last one is an elastic catenary: Irvine's numbers for this cable.
#[test]
fn a_start_that_is_no_equilibrium_is_no_row() {
    let found = equilibria(&Hanging::default(), None);
    assert!(
        found.history.keys[0] > 0.0 && found.agreement.is_some(),
        "{:?}",
        found.warnings
    );
    let last = |column: usize| found.history.column(column).last().unwrap();
    for (value, exact) in [(last(0), 26.544978615), (last(1), 260.430721508)] {
        assert!((value / exact - 1.0).abs() < 3e-5, "{value} {exact}");
    }
}

rncf::model! {
    /// A cantilever of a fifth of its length in thickness.
    pub model Thick {
        param elements: count = 2;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar { area = 0.02 m^2; second_moment = 6.666666666666667e-5 m^4; shear_factor = 0.8333333333333333; }
        body beam { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(bar, steel); }
        joint root = clamp(beam.start, inertial);
        output tip = beam.end.y;
    }
}

/// Timoshenko's beam: where the determinant of its transfer matrix vanishes (scipy), rad/s.
#[test]
fn frequencies_are_told_with_their_errors() {
    let exact = [1018.2184268, 5483.7096776];
    for (elements, is_told) in [(2, true), (6, false)] {
        let settings = EquilibriumSettings {
            count: 2,
            judged: Judging::Whole,
            ..EquilibriumSettings::default()
        };
        let found = modes(&Thick { elements }, &settings).unwrap();
        let errors = found.modes.iter().zip(exact).map(|(mode, exact)| mode.im / exact - 1.0);
        let error = errors.fold(0.0, f64::max);
        let (words, line) = if is_told {
            let note = found
                .warnings
                .iter()
                .find(|note| note.starts_with("The mesh is too coarse for these modes"));
            ("that of mode 2 by about ", note.cloned())
        } else {
            ("frequencies differ by at most ", found.agreement.clone())
        };
        let line = line.unwrap_or_else(|| panic!("{elements}: {:?}", found.warnings));
        assert_told(&line, words, if is_told { 100.0 } else { 1.0 }, error);
    }
}

rncf::model! {
    /// A blade in bending modes, which do not know that turning makes it stiffer.
    pub model TurningModes {
        param w = 100 rad/s;
        material alu { density = 2700 kg/m^3; young = 70 GPa; }
        section strip = rectangle(y = 6 mm, z = 40 mm);
        frame hub = rotating(axis = z, angle = w * t);
        body blade in hub { planar xy; line from [0.2, 0, 0] m to [1.2, 0, 0] m; mesh 8 * cable(strip, alu); modal(3); }
        joint root = clamp(blade.start, hub);
        output y = blade.end.y;
    }
}

/// What is missing is not the mesh, and no finer one helps.
#[test]
fn frequencies_of_few_modes_are_told_as_those() {
    let settings = EquilibriumSettings {
        judged: Judging::Whole,
        ..EquilibriumSettings::default()
    };
    let found = modes(&TurningModes { w: 25.0 }, &settings).unwrap();
    let note = found.warnings.iter().find(|note| note.contains("for these modes"));
    let note = note.unwrap_or_else(|| panic!("{:?}", found.warnings));
    for words in ["or the modes are too few", "and without modes in `blade` (8, modal(3))"] {
        assert!(note.contains(words), "{note}");
    }
}
