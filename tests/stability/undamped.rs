//! T1 of THEORY 10: methods without dissipation on constraints of index 3.

use std::fs;

use rncf::app::Figure;
use rncf::app::charts::{Chart, Line};
use rncf::{Integrator, Method, Options};

use crate::agrees;
use crate::failing::index_3::{Change, Family};
use crate::pendulum::{Begin, Error, errors, fixed, largest, ours, scene, textbook};

/// Spans of time that are looked at, s.
const SPANS: [(f64, f64); 3] = [(0.0, 0.1), (0.0, 1.0), (1.0, 4.0)];

/// Errors of a textbook's method with fixed steps.
fn fixed_steps(family: Family, begin: Begin, h: f64, end: f64) -> Vec<Error> {
    let steps = vec![h; (end / h).round() as usize];
    errors(&textbook(family, begin, Change::Carried, &steps))
}

#[test]
fn without_dissipation_the_multiplier_diverges_however_short_the_step() {
    let undamped = Family::generalized_alpha(1.0);
    for h in [0.02, 0.01, 0.005] {
        let found = fixed_steps(undamped, Begin::Plain, h, 1.0);
        let last = found[found.len() - 1];
        println!(
            "rho 1, h {h}: early {:.2}, at 1 s {:.1} N/m, {:.1e} m",
            largest(&found, 0.0, 0.05),
            last.multiplier,
            last.place
        );
        agrees(last.multiplier, 213.0, 0.015);
        agrees(largest(&found, 0.0, 0.05), 1.5, if h > 0.01 { 0.25 } else { 0.02 });
        assert!(last.place < 0.9 * h * h, "positions are still fine");
    }
    let newmark = fixed_steps(Family::NEWMARK, Begin::Plain, 0.01, 4.0);
    println!("Newmark: {:.1e} N/m before step 400", largest(&newmark, 0.0, 4.0));
    assert!(largest(&newmark, 0.0, 4.0) > 1e7);
    let [little, damped] = [0.95, 0.8].map(|rho| fixed_steps(Family::generalized_alpha(rho), Begin::Plain, 0.01, 4.0));
    for (all, printed) in [(&little, [2.7, 15.0, 13.0]), (&damped, [1.2, 1.2, 0.16])] {
        let found = SPANS.map(|(from, to)| largest(all, from, to));
        for (found, printed) in found.iter().zip(printed) {
            agrees(*found, printed, 0.1);
        }
        println!(
            "rho 0.95 or 0.8: {}; at 1 s {:.1e}",
            crate::short(&found),
            all[99].multiplier
        );
    }
    assert!(
        largest(&little, 1.0, 4.0) > 10.0,
        "little damping leaves the error of the start for seconds"
    );
    agrees(largest(&damped, 0.0, 0.1), 1.1, 0.1);
    agrees(damped[99].multiplier, 2e-3, 0.25);
}

#[test]
fn a_small_kick_along_the_rod_grows_like_that() {
    let kicked = |rho| fixed_steps(Family::generalized_alpha(rho), Begin::Kicked(1e-4), 0.01, 2.0);
    let (undamped, damped) = (kicked(1.0), kicked(0.8));
    for (step, printed) in [(2, 0.5), (20, 5.6), (100, 184.0), (200, 4784.0)] {
        println!(
            "kick, after {step} steps: {:.4}, {:.1e} N/m",
            undamped[step - 1].multiplier,
            damped[step - 1].multiplier
        );
        agrees(undamped[step - 1].multiplier, printed, 0.03);
    }
    assert!(damped[99].multiplier < 3e-3);
}

#[test]
fn the_runtime_decays_or_refuses() {
    let (alpha, hht) = (Method::GeneralizedAlpha { rho_inf: 0.8 }, Method::Hht { alpha: -0.05 });
    // The table of docs/stability.md.
    for (method, stabilised, printed) in [
        (alpha, false, [1.2e-2, 3.2e-2, 0.16]),
        (alpha, true, [7.4e-3, 2.7e-2, 0.12]),
        (hht, false, [1.2e-2, 3.4e-2, 0.17]),
        (hht, true, [7.9e-3, 3.0e-2, 0.13]),
        (Method::Radau, false, [2.1e-3, 1.5e-2, 1.5e-2]),
        (Method::Radau, true, [7.7e-5, 1.2e-4, 1.2e-4]),
    ] {
        let all = errors(&ours(
            method,
            Options {
                stabilised,
                ..fixed(0.01)
            },
            4.0,
        ));
        let found = SPANS.map(|(from, to)| largest(&all, from, to));
        println!("{method:?}, stabilised {stabilised}: {}", crate::short(&found));
        // The pull grows from 9 to 40 N/m on the way down, and its errors with it.
        for (found, printed) in found.iter().zip(printed) {
            agrees(*found, printed, 0.2);
        }
    }
    for method in [Method::GeneralizedAlpha { rho_inf: 1.0 }, Method::Hht { alpha: 0.0 }] {
        let mut scene = scene();
        let rest = scene.rest(0.0);
        let refusal = Integrator::new(scene.as_mut(), rest, 1.0, method, Options::default()).err();
        let text = refusal.expect("refused").to_string();
        assert!(
            text.contains("= 0 damps nothing") || text.contains("= 1 damps nothing"),
            "{text}"
        );
        // With the rates held, too, nothing is there to grow.
        let all = errors(&ours(
            method,
            Options {
                stabilised: true,
                ..fixed(0.01)
            },
            4.0,
        ));
        println!("{method:?}, stabilised: {:.2e}", largest(&all, 0.0, 4.0));
        assert!(largest(&all, 0.0, 4.0) < 0.13);
    }
}

#[test]
fn little_dissipation_is_enough_for_short_steps_alone() {
    let after = |rho_inf, h| {
        largest(
            &errors(&ours(Method::GeneralizedAlpha { rho_inf }, fixed(h), 4.0)),
            3.0,
            4.0,
        )
    };
    for (rho_inf, h, stable) in [
        (0.95, 0.02, false),
        (0.95, 0.01, true),
        (0.99, 0.005, false),
        (0.99, 0.00125, true),
        (0.8, 0.02, true),
    ] {
        let found = after(rho_inf, h);
        println!(
            "rho {rho_inf}, h {h}: {found:.2e} N/m, (1 - rho)/h = {:.1}",
            (1.0 - rho_inf) / h
        );
        // Errors of second order: 1600 h^2.
        assert_eq!(found < 1700.0 * h * h, stable, "{found}");
    }
    // Every change of the step begins anew from the velocity on the constraint.
    for (rho_inf, steps, printed) in [
        (0.8, 875.0, 0.018),
        (0.95, 868.0, 0.018),
        (0.99, 869.0, 0.017),
        (0.999, 870.0, 0.021),
    ] {
        let points = ours(Method::GeneralizedAlpha { rho_inf }, Options::default(), 4.0);
        let found = largest(&errors(&points), 0.0, 4.0);
        println!("rho {rho_inf}, {} steps to a tolerance: {found:.1e} N/m", points.len());
        agrees(points.len() as f64, steps, 0.2);
        agrees(found, printed, 0.3);
    }
}

/// The largest errors within 0.1 s each.
fn envelope(errors: &[Error]) -> Vec<(f64, f64)> {
    let tenths = errors.chunk_by(|a, b| (10.0 * a.t - 0.01).floor() == (10.0 * b.t - 0.01).floor());
    let most = |part: &[Error]| part.iter().fold(1e-6, |most: f64, error| most.max(error.multiplier));
    tenths.map(|part| (part[part.len() - 1].t, most(part))).collect()
}

#[test]
#[ignore = "draws: cargo test -p rncf-tests --test stability draw -- --ignored"]
fn draw() {
    let textbook = |rho, h, end| envelope(&fixed_steps(Family::generalized_alpha(rho), Begin::Plain, h, end));
    let ours_with = |rho_inf| envelope(&errors(&ours(Method::GeneralizedAlpha { rho_inf }, fixed(0.01), 4.0)));
    let chart = |lines: Vec<Vec<(f64, f64)>>, is_tall| Chart {
        x: "t [s]".into(),
        y: "error [N/m]".into(),
        logarithmic: true,
        lines: lines
            .into_iter()
            .zip(0..)
            .map(|(points, color)| Line::new(points, color))
            .collect(),
        marks: Vec::new(),
        is_tall,
    };
    let mut figure = Figure::default();
    let names = ["textbook 1", "0.95", "0.8", "rncf 0.95", "0.8"];
    let mut lines: Vec<_> = [1.0, 0.95, 0.8].map(|rho| textbook(rho, 0.01, 4.0)).into();
    lines.extend([0.95, 0.8].map(ours_with));
    figure.add("Multiplier, h = 0.01 s, rho of", &names, chart(lines, true));
    let lines = [0.02, 0.01, 0.005].map(|h| textbook(1.0, h, 1.8)).into();
    figure.add(
        "Textbook, rho = 1, h in s",
        &["0.02", "0.01", "0.005"],
        chart(lines, false),
    );
    let svg = figure
        .to_svg("errors of the multiplier over time with and without dissipation")
        .unwrap();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/images/stability_undamped.svg");
    fs::write(path, svg).unwrap();
}
