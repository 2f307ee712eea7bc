//! Errors that come from few steps: ten times the tolerance makes the same ones, and says nothing. Quick runs are compared with a tenth of it,
//! in steps that are half as long. References are scipy's DOP853 at 1e-12, of the equations written down anew; Radau at 1e-10 agrees to 8e-12.

use rncf::AnyModel;
use rncf::app::{Judging, RunSettings, run};
use rncf::{Method, Options, StepSize};

mod belt {
    rncf::model! {
        /// A block on a belt, held by a spring, by friction that falls with the speed and turns over within a millimetre per second.
        pub model Belt {
            param belt = 0.1 m/s; param width = 1e-3 m/s;
            rigid m { plane xy; mass = 2 kg; }
            spring k = law(m, inertial.at([-1, 0, 0] m), force = 800 [N/m] * (length - 1 m) + 1 [N*s/m] * rate);
            load friction = force(m, [-20 [N] * tanh((m.velocity.x - belt) / width) * (0.5 + 0.5 / (1 + 50 [s^2/m^2] * (m.velocity.x - belt)^2)), 0, 0]);
            output x = m.x; output v = m.velocity.x;
            run { t_end = 20 s; every = 0.1 s; }
        }
    }
}

mod upside_down {
    rncf::model! {
        /// A pendulum that stands on its hinge, but for 1e-7 rad.
        pub model Standing {
            param start = 1e-7 rad;
            rigid a { plane xy; mass = 1 kg; inertia = 1e-3 kg*m^2; center = [0, 1, 0] m; angle = start; }
            joint j = revolute(inertial, a);
            load g = gravity([0, -9.81, 0] m/s^2);
            spring d = torsional(j, stiffness = 0 [N*m/rad], damping = 0.05 N*m*s/rad);
            output q = a.angle;
            run { t_end = 20 s; every = 0.1 s; }
        }
    }
}

/// Places of the block and angles of the pendulum at every second.
const BLOCK: [f64; 20] = [
    0.0042498088,
    0.0090467600,
    0.0138329414,
    0.0186054357,
    0.0233549742,
    0.0278134846,
    0.0289366332,
    0.0213043405,
    0.0081354683,
    0.0007081704,
    0.0047574597,
    0.0095533472,
    0.0143382656,
    0.0191089896,
    0.0238544647,
    0.0281834698,
    0.0286020431,
    0.0200044777,
    0.0068707015,
    0.0007438474,
];
const PENDULUM: [f64; 20] = [
    0.000001127,
    0.000025116,
    0.000560690,
    0.012516676,
    0.278961618,
    3.984748136,
    5.636448360,
    1.422709549,
    1.765613196,
    5.442638239,
    1.897610832,
    2.201867342,
    5.135105216,
    1.355268793,
    3.761827524,
    3.961762967,
    1.505490403,
    4.887376666,
    1.839800972,
    3.609723348,
];

/// The error of the first output at whole seconds, as a part of its change, and what is told of it.
fn error_and_told(model: &dyn AnyModel, exact: &[f64], method: Method, rtol: f64) -> (f64, f64) {
    let settings = RunSettings {
        method,
        options: Options {
            rtol,
            ..Options::default()
        },
        judged: Judging::Affordable,
        ..RunSettings::default()
    };
    let found = run(model, &settings).unwrap();
    let values: Vec<f64> = found.history.column(0).collect();
    let error = (1..=20).map(|second| (values[10 * second] - exact[second - 1]).abs());
    let [low, high] = [f64::min as fn(f64, f64) -> f64, f64::max].map(|of| values.iter().copied().reduce(of).unwrap());
    let told = found.off_by.iter().find(|off| off.0 == 0).map_or(0.0, |off| off.1);
    let error = error.fold(0.0, f64::max) / (high - low);
    println!("{} {method:?} {rtol:e}: {error:.1e}, told {told:.1e}", model.name());
    (error, told)
}

/// 1.5e-3 was told as 7.7e-5 at 1e-6, and hardly fell from 3e-5 to 3e-7.
#[test]
fn what_the_end_of_a_stick_makes_is_told() {
    for rtol in [3e-6, 1e-6, 3e-7, 1e-7] {
        let (error, told) = error_and_told(&belt::Belt::default(), &BLOCK, Method::Radau, rtol);
        assert!(told > 0.3 * error, "{rtol:e}: {error:e}, told {told:e}");
    }
}

/// 3.0e-2 was told as 6.7e-5 at 3e-6: while the angle is below the tolerance, steps of 0.8 s are as long as with ten times that. Radau13 was not
/// compared at all at its largest tolerances.
#[test]
fn what_grows_from_below_the_tolerance_is_told() {
    for (method, rtol) in [
        (Method::Radau, 1e-5),
        (Method::Radau, 3e-6),
        (Method::Radau, 1e-6),
        (Method::Radau, 1e-8),
        (Method::Radau13, 1e-5),
        (Method::Radau13, 3e-6),
    ] {
        let (error, told) = error_and_told(&upside_down::Standing::default(), &PENDULUM, method, rtol);
        assert!(told > 0.3 * error, "{method:?} {rtol:e}: {error:e}, told {told:e}");
    }
}

mod ringing {
    rncf::model! {
        /// A mass that rings on a spring, 200 rad/s.
        pub model Ringing {
            rigid m { plane xy; mass = 1 kg; origin = [1.01, 0, 0] m; }
            spring s = linear(m, inertial.at([0, 0, 0] m), stiffness = 40 [kN/m], length = 1 m);
            output x = m.x;
            run { t_end = 3 s; every = 0.013 s; }
        }
    }
}

fn fixed(model: &dyn AnyModel, h: f64) -> rncf::app::RunResult {
    let settings = RunSettings {
        options: Options {
            step: StepSize::Fixed(h),
            ..Options::default()
        },
        judged: Judging::Affordable,
        ..RunSettings::default()
    };
    run(model, &settings).unwrap()
}

/// Short fixed steps know the pendulum better than Radau does with the tolerance that they are compared with: half of the step tells, and they are not
/// blamed. Long ones lose the vibration of a mass, and so does half of them; there Radau tells.
#[test]
fn fixed_steps_are_blamed_for_what_they_miss_alone() {
    let found = fixed(&upside_down::Standing::default(), 0.02);
    let off = PENDULUM
        .iter()
        .enumerate()
        .map(|(at, exact)| (found.history.values[10 * (at + 1)] - exact).abs());
    let off = off.fold(0.0, f64::max);
    let told = found.off_by.iter().map(|told| told.1).fold(0.0, f64::max);
    assert!(off < 1e-5 && told > 0.0 && told < 1e-5, "{off:e} {told:e}");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    let told = fixed(&ringing::Ringing {}, 0.05).warnings;
    assert!(
        told.iter()
            .any(|told| told.contains("Steps of 5e-2 s are chosen by no tolerance: Radau")),
        "{told:?}"
    );
}
