//! Smooth blows and walls that are over before a step would see them: steps end at the peaks of exponentials.

use std::f64::consts::PI;

use rncf::Method;
use rncf::app::{RunSettings, run};

use crate::runs::adaptive;

rncf::model! {
    /// A mass that rests on a spring, and a blow of 1 N s.
    pub model Blow {
        param width = 1 ms;
        param when = 3.3 s;
        rigid bob { mass = 1 kg; }
        spring bed = bushing(bob, inertial.at([0, 0, 0] m), stiffness = [40, 40, 40] N/m, damping = [0.1, 0.1, 0.1] N*s/m);
        load blow = force(bob, [1 [N*s] / (width * sqrt(pi / 1 rad)) * exp(-((t - when) / width)^2), 0, 0]);
        output x = bob.x;
        run { t_end = 10 s; every = 0.02 s; }
    }
}

rncf::model! {
    /// The same with a force that rises and falls by hyperbolic tangents.
    pub model Gate {
        param when = 3.3 s;
        rigid bob { mass = 1 kg; }
        spring bed = bushing(bob, inertial.at([0, 0, 0] m), stiffness = [40, 40, 40] N/m, damping = [0.1, 0.1, 0.1] N*s/m);
        load blow = force(bob, [500 N * (tanh((t - when + 1 ms) / 0.2 ms) - tanh((t - when - 1 ms) / 0.2 ms)) / 2, 0, 0]);
        output x = bob.x;
        run { t_end = 10 s; every = 0.02 s; }
    }
}

rncf::model! {
    /// Something that flies against a wall of millimetres, which would take the work `strength width sqrt(pi)`.
    pub model Wall {
        param width = 2 mm;
        param strength = 300 kN;
        rigid ball { mass = 1 kg; velocity = [20, 0, 0] m/s; }
        load wall = force(ball, [-strength * exp(-((ball.x - 30 m) / width)^2), 0, 0]);
        output x = ball.x;
        output v = ball.velocity.x;
        run { t_end = 4 s; every = 0.02 s; }
    }
}

rncf::model! {
    /// A fence whose tails are exponentials, about a place; the ball passes by it.
    pub model Fence {
        param strength = 4 kN;
        rigid ball { mass = 1 kg; origin = [0, 0.01, 0] m; velocity = [20, 0, 0] m/s; }
        load fence = force(ball, [0, strength / cosh((ball.x - 10 m) / 50 mm)^2, 0]);
        output v = ball.velocity.y;
        run { t_end = 1 s; every = 0.02 s; }
    }
}

const METHODS: [(Method, f64); 3] = [
    (Method::Radau, 1e-4),
    (Method::Hht { alpha: -0.05 }, 2e-2),
    (Method::GeneralizedAlpha { rho_inf: 0.8 }, 2e-2),
];

/// Outputs at the end of a run at a tolerance of 1e-6.
fn end(model: &dyn rncf::AnyModel, method: Method) -> Vec<f64> {
    let settings = RunSettings {
        method,
        options: adaptive(1e-6),
        ..RunSettings::default()
    };
    let result = run(model, &settings).unwrap();
    let mut scene = model.build_as(settings.formulation, settings.joints, &[]).unwrap();
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(&result.state, &mut row);
    row
}

/// The bob swings as after an impulse. Its frequency is so low that the length of the blow is 1e-5 of the amplitude.
#[test]
fn a_short_blow_on_what_rests_is_met() {
    let (decay, omega) = (0.05_f64, (40.0 - 0.05_f64.powi(2)).sqrt());
    let after = 10.0 - 3.3;
    let exact = (-decay * after).exp() * (omega * after).sin() / omega;
    for (method, part) in METHODS {
        for (name, found) in [
            ("blow", end(&Blow::default(), method)[0]),
            ("gate", end(&Gate::default(), method)[0]),
        ] {
            assert!(
                (found - exact).abs() < part / omega,
                "{name} {method:?}: {found} for {exact}"
            );
        }
    }
}

/// The wall has a potential: what it throws back is as quick as before, what it lets through has done its work.
#[test]
fn a_thin_wall_throws_back_what_it_should() {
    for (method, part) in METHODS {
        for strength in [3e5, 3e4] {
            let wall = Wall {
                strength,
                ..Wall::default()
            };
            let left = 20.0 * 20.0 - 2.0 * strength * wall.width * PI.sqrt();
            let back = if left < 0.0 { -20.0 } else { left.sqrt() };
            let found = end(&wall, method)[1];
            assert!((found - back).abs() < 20.0 * part, "{method:?}: {found} m/s for {back}");
        }
        // The impulse is strength 2 width / speed.
        let (found, exact) = (end(&Fence::default(), method)[0], 4e3 * 2.0 * 0.05 / 20.0);
        assert!(
            (found - exact).abs() < exact * part,
            "{method:?}: {found} m/s for {exact}"
        );
    }
}
