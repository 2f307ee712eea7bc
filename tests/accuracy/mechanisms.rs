//! Compiled mechanisms over their whole runs against the same in coordinates without constraints, by russell_ode.

use rncf::{Method, Options};
use rncf_models::{FlyballGovernor, HeavyTop};
use rncf_reference::governor::{self, Governor};
use rncf_reference::heavy_top;
use rncf_reference::integrate::{Method as Oracle, agreed};

use crate::runs::{WAYS, adaptive, far, fixed, grid, history, orders};

#[test]
fn heavy_top_in_a_turning_frame_without_constraints() {
    let times = grid(0.05, 1.0);
    let oracle = agreed(
        &heavy_top::HeavyTop,
        Oracle::DoPri8,
        1e-13,
        &heavy_top::START,
        &times,
        1e-8,
    )
    .unwrap();
    let (rows, _) = history(&HeavyTop::default(), WAYS[0], Method::Radau, adaptive(1e-9), &times);
    let (mut center, mut force) = (0.0, 0.0);
    for (row, y) in rows.iter().zip(&oracle.states) {
        let exact = heavy_top::HeavyTop::instant(y);
        center = f64::max(center, far(&row[..3], &exact.center));
        force = f64::max(force, far(&row[3..], &exact.multiplier.map(|lambda| -lambda)));
    }
    println!("heavy top, 21 times: centre of mass {center:.1e} m, force {force:.1e} N of 800 N");
    assert!(center < 1e-7 && force < 0.1, "{center:e} m, {force:e} N");
}

/// Largest errors of angle and height, and of the spin, which is a velocity.
fn governor_errors(oracle: &[Vec<f64>], times: &[f64], options: Options) -> [f64; 2] {
    let exact = Governor::new(governor::SPIN);
    let (rows, _) = history(&FlyballGovernor::default(), WAYS[0], Method::Radau, options, times);
    let mut worst = [0.0; 2];
    for (row, y) in rows.iter().zip(oracle) {
        worst[0] = f64::max(worst[0], far(&row[..2], &y[..2]));
        worst[1] = f64::max(worst[1], (row[2] - exact.spin(y)).abs());
    }
    worst
}

/// Index 3 leaves velocities order 3; the stabilised index 2 gives them 5.
#[test]
fn governor_in_three_coordinates() {
    let times = grid(0.1, 5.0);
    let exact = Governor::new(governor::SPIN);
    let oracle = agreed(&exact, Oracle::Radau5, 1e-13, &governor::START, &times, 1e-7)
        .unwrap()
        .states;
    for (stabilised, expected) in [(false, [5.0, 3.0]), (true, [5.0, 5.0])] {
        let with = |options| Options { stabilised, ..options };
        let table = [0.01, 0.005].map(|h| governor_errors(&oracle, &times, with(fixed(h))));
        let adapted = governor_errors(&oracle, &times, with(adaptive(1e-8)));
        for (kind, name) in ["angle and height", "spin"].iter().enumerate() {
            let order = orders(&table.map(|errors| errors[kind]))[0];
            println!(
                "governor, stabilised {stabilised}, {name}: {:.1e} at h = 0.005 s, order {order:.2}; {:.1e} at rtol 1e-8",
                table[1][kind], adapted[kind]
            );
            assert!(
                order > expected[kind] - 0.25,
                "stabilised {stabilised}, {name}: order {order}"
            );
        }
        let most = if stabilised { [1e-6, 1e-5] } else { [1e-6, 3e-5] };
        assert!(adapted[0] < most[0] && adapted[1] < most[1], "{adapted:?}");
    }
}
