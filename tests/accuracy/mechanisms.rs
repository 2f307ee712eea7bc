//! Compiled mechanisms over their whole runs against the same in coordinates without constraints, by russell_ode.

use rncf::Method;
use rncf_models::{FlyballGovernor, HeavyTop};
use rncf_tests::governor::{self, Governor};
use rncf_tests::heavy_top;
use rncf_tests::integrate::{Method as Oracle, agreed};

use crate::runs::{WAYS, adaptive, far, grid, history, short};

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

#[test]
fn governor_in_three_coordinates() {
    let times = grid(0.1, 5.0);
    let exact = Governor::new(governor::SPIN);
    let oracle = agreed(&exact, Oracle::Radau5, 1e-13, &governor::START, &times, 1e-7).unwrap();
    let (rows, statistics) = history(
        &FlyballGovernor::default(),
        WAYS[0],
        Method::Radau,
        adaptive(1e-8),
        &times,
    );
    let mut worst = [0.0; 3];
    for (row, y) in rows.iter().zip(&oracle.states) {
        for (worst, (found, exact)) in worst.iter_mut().zip(row.iter().zip([y[0], y[1], exact.spin(y)])) {
            *worst = f64::max(*worst, (found - exact).abs());
        }
    }
    println!(
        "governor, 51 times: errors {} in {} steps",
        short(&worst),
        statistics.steps
    );
    assert!(worst.iter().all(|&error| error < 1e-6), "{worst:?}");
}
