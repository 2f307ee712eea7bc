//! Strings that pull only: the law, its tangent, its energy, and runs in which they go slack.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, StepSize, Stop};

rncf::model! {
    /// A mass on an undamped string, thrown up from its point.
    pub model Thrown {
        param elements: count = 6;
        param upwards = 3 m/s;
        material nylon { density = 1100 kg/m^3; young = 20 MPa; }
        section round = circle(radius = 1 mm);
        body string in inertial {
            spatial;
            line from [0, 0, 0] m to [0, 0, -1] m;
            initial velocity [0.3 [1/s] * x, 0, upwards * x / (1 m)];
            mesh elements * cable(round, nylon, slack = true);
        }
        joint root = pin(string.start, inertial);
        fixture stone on string.end { mass = 50 g; }
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = string.end;
        output force = string.start.axial_force;
    }
}

rncf::model! {
    /// The same, damped, in the plane, with the exact bending energy.
    pub model Damped {
        param elements: count = 3;
        material nylon { density = 1100 kg/m^3; young = 20 MPa; damping = 2 ms; }
        section round = circle(radius = 5 mm);
        body string in inertial {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh elements * cable(round, nylon, slack = true, bending = exact);
        }
        joint root = pin(string.start, inertial);
        output tip = string.end;
        output force = string.at(0.4 m).axial_force;
    }
}

rncf::model! {
    /// Linear elastic beside slack, in space.
    pub model Both {
        material nylon { density = 1100 kg/m^3; young = 20 MPa; }
        section round = circle(radius = 5 mm);
        body linear in inertial { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(round, nylon); }
        body slack in inertial { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(round, nylon, slack = true); }
        joint one = pin(linear.start, inertial);
        joint other = pin(slack.start, inertial);
        output a = linear.at(0.3 m).axial_force;
        output b = slack.at(0.3 m).axial_force;
    }
}

const STIFFNESS: f64 = 20e6 * std::f64::consts::PI * 25e-6;

/// Stretches a straight body along x by `stretch`.
fn stretched(scene: &dyn Scene, stretch: f64) -> State {
    let mut state = scene.rest(0.0);
    // Positions and slopes alike grow with the stretch.
    state.x.iter_mut().for_each(|x| *x *= stretch);
    state
}

#[test]
fn a_slack_string_pulls_as_a_linear_one_and_never_pushes() {
    let mut scene = Both::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let mut out = vec![0.0; scene.output_columns()];
    for stretch in [0.7_f64, 0.99, 1.0 - 1e-5, 1.0, 1.0 + 1e-3, 1.1] {
        let strain = 0.5 * (stretch * stretch - 1.0);
        let state = stretched(scene.as_ref(), stretch);
        scene.outputs(&state, &mut out);
        println!("{strain:.3e}: {out:?}");
        let [linear, slack] = [out[0] / stretch, out[1] / stretch];
        assert!((linear - STIFFNESS * strain).abs() < 1e-12 * STIFFNESS);
        assert!(slack >= 0.0, "{slack}");
        if strain <= 0.0 {
            assert!(slack <= 0.5e-6 * STIFFNESS * (1.0 + 1e-9), "{slack}");
        } else {
            assert!(
                (slack / linear - 1.0).abs() < (1e-6 / strain).powi(2),
                "{slack} {linear}"
            );
        }
    }
}

fn random(seed: &mut u64) -> f64 {
    *seed = seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

#[test]
fn the_tangent_is_the_derivative_of_the_force_on_both_sides() {
    let scenes = [
        Damped::default().build(Formulation::Rncf, Joints::Eliminated).unwrap(),
        Both::default().build(Formulation::Rncf, Joints::Eliminated).unwrap(),
    ];
    for mut scene in scenes {
        for stretch in [0.97, 1.04] {
            let mut state = stretched(scene.as_ref(), stretch);
            let mut seed = 5;
            state.x.iter_mut().for_each(|x| *x += 2e-3 * random(&mut seed));
            state.v.iter_mut().for_each(|v| *v = 0.2 * random(&mut seed));
            let n = state.x.len();
            let mut tangent = rncf::system::Tangent::default();
            scene.tangent(&state, &mut tangent);
            let direction: Vec<f64> = (0..n).map(|_| random(&mut seed)).collect();
            for by_rates in [false, true] {
                let step = 1e-7;
                let mut side = |sign: f64| {
                    let mut moved = state.clone();
                    let values = if by_rates { &mut moved.v } else { &mut moved.x };
                    values
                        .iter_mut()
                        .zip(&direction)
                        .for_each(|(x, d)| *x += sign * step * d);
                    let mut force = vec![0.0; n];
                    scene.residual(&moved, &mut force);
                    force
                };
                let (ahead, behind) = (side(1.0), side(-1.0));
                let mut exact = vec![0.0; n];
                let values = if by_rates { &tangent.damping } else { &tangent.stiffness };
                scene.pattern().multiply_add(1.0, values, &direction, &mut exact);
                let size = exact.iter().fold(1e-9_f64, |most, value| most.max(value.abs()));
                for ((a, b), wanted) in ahead.iter().zip(&behind).zip(&exact) {
                    let found = (a - b) / (2.0 * step);
                    assert!(
                        (found - wanted).abs() < 2e-6 * size,
                        "{stretch}: {found} {wanted} of {size}"
                    );
                }
            }
        }
    }
}

/// Steps, smallest step, relative change of energy, greatest and least force in a run.
fn fly(method: Method, options: Options) -> (u64, f64, f64, [f64; 2]) {
    let model = Thrown::default();
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let start = scene.rest(0.0);
    let first = scene.energy(&start).unwrap();
    let mut out = vec![0.0; scene.output_columns()];
    let (mut drift, mut forces) = (0.0_f64, [f64::INFINITY, 0.0_f64]);
    let mut kinetic = 0.05 * 9.0 / 2.0;
    let mut integrator = Integrator::new(scene.as_mut(), start, 1.5, method, options).unwrap();
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state().clone();
        let energy = integrator.system().energy(&state).unwrap();
        drift = drift.max((energy - first).abs());
        integrator.system().outputs(&state, &mut out);
        forces = [forces[0].min(out[3]), forces[1].max(out[3])];
        if stop == Stop::End {
            break;
        }
    }
    kinetic += first.abs();
    let counts = integrator.statistics();
    (counts.steps, counts.smallest_step, drift / kinetic, forces)
}

#[test]
fn a_string_that_goes_slack_is_integrated_and_keeps_its_energy() {
    let options = Options {
        rtol: 1e-6,
        ..Options::default()
    };
    let (steps, smallest, drift, forces) = fly(Method::Radau, options);
    println!("radau: {steps} steps, smallest {smallest:.1e} s, energy {drift:.1e}, forces {forces:?}");
    assert!(forces[0] < 1e-3 && forces[1] > 1.0, "{forces:?}");
    assert!(drift < 5e-4, "{drift}");
    assert!(steps < 20_000 && smallest > 1e-8, "{steps} {smallest}");
    let method = Method::GeneralizedAlpha { rho_inf: 0.8 };
    let (steps, smallest, drift, forces) = fly(method, options);
    println!("generalized alpha: {steps} steps, smallest {smallest:.1e} s, energy {drift:.1e}, forces {forces:?}");
    assert!(drift < 0.05 && smallest > 1e-8 && forces[0] < 1e-3);
    let fixed = Options {
        step: StepSize::Fixed(1e-4),
        ..options
    };
    let (_, _, drift, _) = fly(Method::GeneralizedAlpha { rho_inf: 0.8 }, fixed);
    println!("fixed: energy {drift:.1e}");
    assert!(drift < 0.05, "{drift}");
}
