//! T11 of THEORY 10: constraints that are held as accelerations drift away.

use rncf::system::ConstraintLevel;
use rncf::{Integrator, Method, Options, Scene, State, Stop};

use crate::failing::index_1;
use crate::failing::index_3::{Change, Family, Index3};
use crate::pendulum::{consistent, fixed, scene};

/// The constraint (m^2) and its rate (m^2/s), largest so far.
#[derive(Clone, Copy, Debug, Default)]
struct Violation {
    position: f64,
    rate: f64,
}

impl Violation {
    fn meet(&mut self, scene: &mut dyn Scene, state: &State) {
        let (mut position, mut rate) = ([0.0], [0.0]);
        scene.constraint(ConstraintLevel::Position, state, &mut position);
        scene.constraint(ConstraintLevel::Velocity, state, &mut rate);
        let pattern = scene.constraint_pattern().clone();
        let mut jacobian = vec![0.0; pattern.entries()];
        scene.constraint_jacobian(state, &mut jacobian);
        pattern.transpose_multiply_add(1.0, &jacobian, &state.v, &mut rate);
        self.position = self.position.max(position[0].abs());
        self.rate = self.rate.max(rate[0].abs());
    }
}

/// What the runtime leaves over a run.
fn ours(method: Method, options: Options, end: f64) -> Violation {
    let mut scene = scene();
    let rest = scene.rest(0.0);
    let mut integrator = Integrator::new(scene.as_mut(), rest, end, method, options).unwrap();
    let mut most = Violation::default();
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state().clone();
        most.meet(integrator.system(), &state);
        if stop == Stop::End {
            return most;
        }
    }
}

#[test]
fn accelerations_alone_let_positions_drift_with_the_square_of_time() {
    let mut scene = scene();
    let mut state = consistent(scene.as_mut());
    let (mut most, mut found) = (Violation::default(), Vec::new());
    let h = 0.02;
    for step in 1..=6400 {
        index_1::step(scene.as_mut(), &mut state, h);
        most.meet(scene.as_mut(), &state);
        if [400, 800, 1600, 3200, 6400].contains(&step) {
            println!(
                "index 1, t {:.0} s: {:.1e} m^2, {:.1e} m^2/s",
                state.t, most.position, most.rate
            );
            found.push(most);
        }
    }
    for pair in found.windows(2) {
        let growth = [pair[1].position / pair[0].position, pair[1].rate / pair[0].rate];
        assert!((3.8..4.3).contains(&growth[0]), "position: {growth:?}");
        assert!((1.9..2.3).contains(&growth[1]), "rate: {growth:?}");
    }
    assert!(found[4].position > 0.15, "the rod is 16 % longer after 128 s");
    let held = ours(Method::GeneralizedAlpha { rho_inf: 0.8 }, fixed(h), 128.0);
    println!("ours, 128 s: {:.1e} m^2, {:.1e} m^2/s", held.position, held.rate);
    assert!(held.position < 1e-13 && held.rate < 1e-14);
}

#[test]
fn positions_alone_leave_rates_of_second_order() {
    let mut found = Vec::new();
    for h in [0.02, 0.01, 0.005] {
        let mut scene = scene();
        let state = consistent(scene.as_mut());
        let mut method = Index3::new(scene.as_mut(), &state, Family::generalized_alpha(0.8), Change::Carried);
        let mut most = Violation::default();
        while method.state.t < 5.0 {
            method.step(h).unwrap();
            // What the plain start leaves has decayed by then.
            if method.state.t > 1.0 {
                let state = method.state.clone();
                most.meet(method.system, &state);
            }
        }
        println!("index 3, h {h}: {:.1e} m^2, {:.1e} m^2/s", most.position, most.rate);
        assert!(most.position < 1e-14);
        found.push(most.rate);
    }
    assert!(
        found.windows(2).all(|pair| (3.8..4.2).contains(&(pair[0] / pair[1]))),
        "{found:?}"
    );
}

#[test]
fn the_runtime_holds_rates_too() {
    for method in [
        Method::GeneralizedAlpha { rho_inf: 0.8 },
        Method::Hht { alpha: -0.05 },
        Method::Radau,
    ] {
        for stabilised in [false, true] {
            let found = [0.02, 0.01].map(|h| ours(method, Options { stabilised, ..fixed(h) }, 20.0));
            let [coarse, fine] = found;
            println!("{method:?}, stabilised {stabilised}: {found:?}");
            assert!(coarse.position < 1e-12 && fine.position < 1e-12);
            match (method, stabilised) {
                // Third order, as its velocities.
                (Method::Radau, false) => assert!((7.0..9.0).contains(&(coarse.rate / fine.rate))),
                // Positions to Newton's tolerance, divided by a step.
                (Method::Radau, true) => assert!(coarse.rate < 1e-9 && fine.rate < 1e-9),
                _ => assert!(coarse.rate < 1e-12 && fine.rate < 1e-12),
            }
        }
    }
}
