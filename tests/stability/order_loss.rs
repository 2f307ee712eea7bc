//! T2 of THEORY 10: the order of the multipliers that is lost at starts, restarts and step changes.

use rncf::{Method, Options};

use crate::agrees;
use crate::failing::index_3::{Change, Family};
use crate::pendulum::{Begin, Error, errors, fixed, largest, ours, run, scene, textbook};

/// Methods, and THEORY's largest errors of the multiplier (N/m) over 1 s where the step changes by 1.5 every four steps
/// and is corrected, for steps of 0.02, 0.01, 0.005 and 0.0025 s.
const METHODS: [(Method, [f64; 4]); 4] = [
    (Method::Hht { alpha: -0.3 }, [0.34, 0.082, 0.022, 0.0054]),
    (Method::Hht { alpha: -0.05 }, [0.32, 0.067, 0.016, 0.0041]),
    (Method::GeneralizedAlpha { rho_inf: 0.8 }, [0.28, 0.058, 0.015, 0.0039]),
    (Method::GeneralizedAlpha { rho_inf: 0.9 }, [0.38, 0.069, 0.014, 0.0036]),
];

fn family(method: Method) -> Family {
    match method {
        Method::Hht { alpha } => Family::hht(alpha),
        Method::GeneralizedAlpha { rho_inf } => Family::generalized_alpha(rho_inf),
        other => panic!("{other:?} is of no such family"),
    }
}

/// Steps up to 1 s that change by `ratio` every four steps; `h` (s) is the shorter one, and the first.
fn alternating(h: f64, ratio: f64) -> Vec<f64> {
    let (mut steps, mut t) = (vec![], 0.0);
    while t < 1.0 {
        let h = if (steps.len() / 4) % 2 == 0 { h } else { ratio * h };
        steps.push(h);
        t += h;
    }
    steps
}

/// Steps up to 1 s of random lengths between `h / 2` and `h` (s), four of each.
fn random(h: f64) -> Vec<f64> {
    let (mut steps, mut t, mut seed) = (vec![], 0.0, 12345_u64);
    while t < 1.0 {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let step = h * (0.5 + 0.5 * (seed >> 11) as f64 / (1_u64 << 53) as f64);
        steps.extend([step; 4]);
        t += 4.0 * step;
    }
    steps
}

/// The runtime over the same steps, begun anew wherever the step changes.
fn restarted(method: Method, steps: &[f64]) -> Vec<Error> {
    let mut scene = scene();
    let (mut state, mut all) = (scene.rest(0.0), Vec::new());
    for group in steps.chunk_by(|a, b| a == b) {
        let end = state.t + group.iter().sum::<f64>();
        let (points, last) = run(scene.as_mut(), state, method, fixed(group[0]), end);
        all.extend(points);
        state = last;
    }
    errors(&all)
}

/// The largest error of the multiplier, N/m, of a textbook's method.
fn changing(method: Method, begin: Begin, change: Change, steps: &[f64]) -> f64 {
    largest(&errors(&textbook(family(method), begin, change, steps)), 0.0, 9.0)
}

#[test]
fn a_plain_start_is_of_first_order() {
    let method = Method::GeneralizedAlpha { rho_inf: 0.8 };
    for (h, plain, corrected, stabilised) in [
        (0.02, 2.5, 5.2e-2, 4.6e-2),
        (0.01, 1.2, 9.9e-3, 6.5e-3),
        (0.005, 0.58, 2.5e-3, 1.3e-3),
    ] {
        let steps = vec![h; (0.2 / h) as usize];
        // The table has ours, which grows with the motion, over six steps.
        let first = |options| largest(&errors(&ours(method, options, 0.2)), 0.0, 6.0 * h);
        let held = Options {
            stabilised: true,
            ..fixed(h)
        };
        let found = [
            changing(method, Begin::Plain, Change::Carried, &steps),
            first(fixed(h)),
            first(held),
        ];
        println!("start, h {h}: plain, ours, stabilised {} N/m", crate::short(&found));
        agrees(found[0], plain, 0.05);
        agrees(found[1], corrected, 0.03);
        agrees(found[2], stabilised, 0.5);
    }
}

#[test]
fn accelerations_that_are_carried_over_a_step_change_are_of_first_order() {
    let method = Method::GeneralizedAlpha { rho_inf: 0.8 };
    for (h, carried, corrected) in [(0.01, 0.91, 0.058), (0.005, 0.42, 0.015), (0.0025, 0.20, 0.0039)] {
        let steps = alternating(h, 1.5);
        let found = changing(method, Begin::Corrected, Change::Carried, &steps);
        let ours = largest(&restarted(method, &steps), 0.0, 9.0);
        println!("ratio 1.5, h {h}: carried {found:.3}, ours {ours:.2e} N/m");
        agrees(found, carried, 0.025);
        agrees(ours, corrected, 0.1);
    }
}

#[test]
fn restarts_keep_the_second_order_over_any_sequence() {
    for (method, printed) in METHODS {
        for ratio in [1.5, 2.0] {
            let most = |steps: &[f64]| largest(&restarted(method, steps), 0.0, 9.0);
            let found = [0.02, 0.01, 0.005, 0.0025].map(|h| most(&alternating(h, ratio)));
            let scattered = [0.01, 0.0025].map(|h| most(&random(ratio * h)));
            println!("{method:?}, ratio {ratio}: {found:.4?}, random {scattered:.4?} N/m");
            assert!(found.windows(2).all(|pair| (3.7..4.3).contains(&(pair[0] / pair[1]))));
            assert!((13.0..25.0).contains(&(scattered[0] / scattered[1])));
            if ratio == 1.5 {
                // Restarts do a little better than the step changes of the table.
                let near = |(found, printed): (&f64, f64)| (0.6..1.1).contains(&(found / printed));
                assert!(found.iter().zip(printed).all(near), "{found:?}");
            }
        }
    }
}

#[test]
fn jerks_from_differences_make_step_changes_unstable() {
    let method = Method::GeneralizedAlpha { rho_inf: 0.8 };
    let found = [0.01, 0.005].map(|h| changing(method, Begin::Corrected, Change::Differenced, &alternating(h, 2.0)));
    println!("{method:?}, ratio 2, differenced: {found:.1?} N/m");
    assert!(found[0] > 1e3 && found[1] > 1e2 * found[0]);
    for method in [Method::Hht { alpha: -0.05 }, Method::GeneralizedAlpha { rho_inf: 0.9 }] {
        let found =
            [0.005, 0.0025].map(|h| changing(method, Begin::Corrected, Change::Differenced, &alternating(h, 1.5)));
        println!("{method:?}, ratio 1.5, differenced: {found:.1?} N/m");
        assert!(found[1] > 1e2 * found[0] && found[1] > 1e8);
    }
    // The strongest dissipation survives it.
    let strong = changing(
        Method::Hht { alpha: -0.3 },
        Begin::Corrected,
        Change::Differenced,
        &alternating(0.0025, 2.0),
    );
    assert!(strong < 0.3, "{strong}");
}

#[test]
fn steps_that_an_error_test_chooses_are_no_excuse() {
    for (method, _) in METHODS {
        let points = ours(
            method,
            Options {
                rtol: 1e-6,
                ..Options::default()
            },
            1.0,
        );
        let mut t = 0.0;
        let steps: Vec<f64> = points
            .iter()
            .map(|point| point.t - std::mem::replace(&mut t, point.t))
            .collect();
        let changes = steps
            .windows(2)
            .filter(|pair| (pair[0] / pair[1] - 1.0).abs() > 1e-6)
            .count();
        let found = largest(&errors(&points), 0.0, 1.0);
        let [plain, carried] =
            [Begin::Plain, Begin::Corrected].map(|begin| changing(method, begin, Change::Carried, &steps));
        println!(
            "{method:?}: {} steps, {changes} changes: ours {found:.1e}, carried {carried:.1e}, plain start {plain:.1e}",
            steps.len()
        );
        assert!(changes > 2 && found < 1e-2 && plain > 10.0 * found);
    }
}
