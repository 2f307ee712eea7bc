//! Elements whose energy changes with time: against closed forms, and an integration of their own equation.

use rncf::equilibrium::{Kind, Uniform, follow};
use rncf::modes::{Wanted, modes};
use rncf::{Integrator, Method, Options, Stop};

use crate::scenes::{outputs, referenced};

rncf::model! {
    /// Bars between two walls that get cold and age.
    pub model Heated {
        /// Time in which the stiffness falls to 1/e.
        param ageing = 2 s;
        /// Strain of heat each second; bars without bending are held across by tension alone.
        param warming = -1e-3 [1/s];
        /// Growth of the area of the second bars over their length, relative to that at the start.
        param widening = 0;

        /// Bar with thermal strain.
        element bar(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient EA: N      = material.young * section.area * exp(-t/ageing);
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            let heat = warming*t;
            strain l = norm(a) - 1;
            energy axial = 1/2*EA*(l - heat)^2, active;
        }
        material unit { density = 1 kg/m^3; young = 1 Pa; }
        section even { area = 1 m^2; }
        section wide { area = 1 [m^2] * (1 + widening*x/(1 m)); }
        body rod in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * bar(even, unit); }
        joint left = pin(rod.start, inertial);
        joint right = pin(rod.end, inertial);
        for i in 0..2 {
            body taper[i] in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * bar(wide, unit); }
            joint near[i] = pin(taper[i].start, inertial);
            joint far[i] = pin(taper[i].end, inertial);
        }
        body loose in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 1 * bar(even, unit); }
        joint foot = pin(loose.start, inertial);
        joint guide = hold(loose.end.y);
        output push = right.force.x;
        output push_of_taper = far[1].force.x;
        output tip = loose.end.x;
        output energy = rod.strain_energy;
    }
}

rncf::model! {
    /// A stone on a string that ages and is damaged at once.
    pub model Aged {
        /// Stiffness at small strains at the start.
        param stiffness = 300 N;
        /// Time in which it falls to 1/e.
        param ageing = 2 s;
        /// What is left of it after half a second.
        param left = 0.6;

        /// String with the tension `k(t) (l + 2 l^3)` of the stretch less one, l.
        element string(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain l = norm(a) - 1;
            let whole = if t < 0.5 s { 1 } else { left };
            energy stretching = stiffness*whole*exp(-t/ageing)*(l^2/2 + 2*l^4/4);
        }
        material light { density = 1 kg/m^3; }
        section thin { area = 0.3 m^2; }
        body line in inertial { spatial; line from [0, 0, 0] m to [0, 0, -1] m; mesh 1 * string(thin, light); }
        joint top = pin(line.start, inertial);
        joint guide_x = hold(line.end.x);
        joint guide_y = hold(line.end.y);
        fixture stone on line.end { mass = 10 kg; }
        load weight = gravity([0, 0, -9.81] m/s^2);
        output z = line.end.z;
        output energy = line.strain_energy;
    }
}

/// Static equilibrium at a time.
fn at(model: &Heated, t: f64) -> Vec<f64> {
    let mut scene = referenced(model);
    let at = Uniform {
        kind: Kind::Static,
        ..Uniform::steady(t)
    };
    let state = follow(scene.as_mut(), &at, 1.0, |_, _| ())
        .unwrap()
        .state()
        .unwrap()
        .clone();
    outputs(scene.as_mut(), &at, &state)
}

/// The walls are drawn by `EA(t)` times the thermal strain, a free bar grows by it; an area that grows linearly is in each
/// element that of its middle.
#[test]
fn a_cold_bar_draws_its_walls() {
    for t in [0.5, 3.0_f64] {
        let (heat, young) = (-1e-3 * t, (-t / 2.0).exp());
        let row = at(&Heated::default(), t);
        let wanted = [-young * heat, -young * heat, 1.0 + heat, 0.5 * young * heat * heat];
        for (found, wanted) in row.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12, "{t} s: {row:?}");
        }
    }
    let widening = 1.5;
    let row = at(
        &Heated {
            widening,
            ..Heated::default()
        },
        3.0,
    );
    let flexibility: f64 = [0.125, 0.375, 0.625, 0.875]
        .iter()
        .map(|x| 0.25 / (1.0 + widening * x))
        .sum();
    let wanted = 3e-3 * (-1.5_f64).exp() / flexibility;
    assert!((row[1] / wanted - 1.0).abs() < 1e-9, "{row:?} {wanted}");
}

/// Frequencies of linear elements between walls fall with the root of the stiffness at the time of the state.
#[test]
fn frequencies_are_those_of_the_time() {
    let model = Heated {
        warming: 0.0,
        ..Heated::default()
    };
    for t in [0.0, 1.0, 4.0] {
        let mut scene = referenced(&model);
        let state = scene.rest(t);
        let found = modes(scene.as_mut(), &Uniform::at_rest(t), &state, Wanted { count: 30 }).unwrap();
        let highest = found.iter().map(|mode| mode.im).fold(0.0, f64::max);
        // `w^2 = 6/h^2 (1 - cos b)/(2 + cos b)` with b = pi 3/4.
        let cosine = (0.75 * std::f64::consts::PI).cos();
        let square = 96.0 * (1.0 - cosine) / (2.0 + cosine) * (-t / 2.0_f64).exp();
        assert!((highest / square.sqrt() - 1.0).abs() < 1e-9, "{t} s: {highest}");
    }
}

/// Position, velocity of the end of the string after a time, by Runge and Kutta in steps that end at the damage.
fn integrated(model: &Aged, end: f64) -> [f64; 2] {
    let (mass, weight) = (10.0 + 0.1, (10.0 + 0.15) * 9.81);
    let slope = |t: f64, whole: f64, [l, v]: [f64; 2]| {
        let stiffness = model.stiffness * whole * (-t / model.ageing).exp();
        [v, (weight - stiffness * (l + 2.0 * l * l * l)) / mass]
    };
    let mut y = [0.0; 2];
    for (from, to, whole) in [(0.0, 0.5_f64.min(end), 1.0), (0.5, end, model.left)] {
        let steps = 4000;
        let h = (to - from) / f64::from(steps);
        for step in 0..if to > from { steps } else { 0 } {
            let t = from + h * f64::from(step);
            let plus = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
            let k1 = slope(t, whole, y);
            let k2 = slope(t + h / 2.0, whole, plus(y, k1, h / 2.0));
            let k3 = slope(t + h / 2.0, whole, plus(y, k2, h / 2.0));
            let k4 = slope(t + h, whole, plus(y, k3, h));
            y = [0, 1].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        }
    }
    y
}

#[test]
fn a_stone_on_an_ageing_string_moves_as_its_equation_says() {
    let model = Aged::default();
    for (method, rtol, bound) in [
        (Method::Radau, 1e-9, 1e-8),
        (Method::GeneralizedAlpha { rho_inf: 0.8 }, 1e-6, 1e-3),
    ] {
        for end in [0.4, 1.5] {
            let mut scene = referenced(&model);
            let start = scene.rest(0.0);
            let options = Options {
                rtol,
                ..Options::default()
            };
            let mut integrator = Integrator::new(scene.as_mut(), start, end, method, options).unwrap();
            while integrator.step().unwrap() != Stop::End {}
            let state = integrator.state().clone();
            let mut row = vec![0.0; integrator.system().output_columns()];
            integrator.system().outputs(&state, &mut row);
            let [l, _] = integrated(&model, end);
            assert!((-row[0] - 1.0 - l).abs() < bound, "{method:?} {end} s: {row:?}, {l}");
            let whole = if end < 0.5 { 1.0 } else { 0.6 };
            let energy = 300.0 * whole * (-end / 2.0_f64).exp() * (l * l / 2.0 + l.powi(4) / 2.0);
            assert!(
                (row[1] / energy - 1.0).abs() < 10.0 * bound,
                "{method:?} {end} s: {row:?}, {energy}"
            );
        }
    }
}

/// Nothing keeps the energy: there is no sum of it, and no forces that conserve it.
#[test]
fn an_energy_that_changes_with_time_is_not_conserved() {
    let mut scene = referenced(&Aged::default());
    let start = scene.rest(0.0);
    assert_eq!(scene.energy(&start), None);
    let error = Integrator::new(scene.as_mut(), start, 1.0, Method::EnergyMomentum, Options::default()).err();
    let text = error.expect("no forces between two states").to_string();
    assert!(
        text.contains("the strain energy of body `line` changes with time"),
        "{text}"
    );
    let mut scene = referenced(&Heated::default());
    let text = follow(scene.as_mut(), &Uniform::steady(0.0), 1.0, |_, _| ())
        .unwrap_err()
        .to_string();
    assert!(
        text.contains("the strain energy of body `rod` changes with time"),
        "{text}"
    );
}
