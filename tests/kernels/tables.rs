//! Tables as the generator reads them, beside the same tables in a program that runs.

use rncf_codegen::model::{self, Between};
use rncf_runtime::emitted::{self, Table};

const VALUES: [f64; 6] = [0.0, 1.0, 1.5, 3.0, 2.0, 7.0];
/// Of a spline, slopes at its rows: any.
const SLOPES: [f64; 6] = [12.0, 5.0, -2.0, 1.0, 9.0, 30.0];

#[test]
fn the_generator_reads_tables_as_programs_do() {
    const STEPPED: [f64; 6] = [0.0, 0.1, 0.4, 0.4, 0.7, 1.0];
    const SMOOTH: [f64; 6] = [0.0, 0.1, 0.4, 0.5, 0.7, 1.0];
    let kinds = [
        (Between::Line, emitted::Between::Line, &STEPPED),
        (Between::Monotone, emitted::Between::Monotone, &STEPPED),
        (Between::Spline, emitted::Between::Spline(&[&SLOPES]), &SMOOTH),
        (Between::Clamped, emitted::Between::Clamped(&[&SLOPES]), &SMOOTH),
        (Between::Periodic, emitted::Between::Periodic(&[&SLOPES]), &SMOOTH),
    ];
    for ((between, ran, places), is_relative) in kinds.into_iter().flat_map(|kind| [(kind, true), (kind, false)]) {
        let is_spline = matches!(between, Between::Spline | Between::Clamped | Between::Periodic);
        let ours = model::Table {
            name: "rows".into(),
            file: None,
            places: places.to_vec(),
            dimension: [0; 6],
            is_relative,
            between,
            columns: vec![model::Column {
                header: None,
                name: "EI".into(),
                dimension: [0; 6],
                hertz: 0,
                values: VALUES.to_vec(),
                slopes: if is_spline { SLOPES.to_vec() } else { Vec::new() },
            }],
            placed_by: vec![0],
            alike: Vec::new(),
            is_param: false,
        };
        let theirs = Table {
            name: "rows",
            places,
            is_relative,
            between: ran,
            columns: &[&VALUES],
        };
        for x in (-10..=1100).map(|step| 1e-3 * f64::from(step)) {
            assert_eq!(ours.value(0, x, 1.0), theirs.at(0, x, 1.0), "{x} {between:?}");
            for order in (0..4).filter(|_| (0.0..=1.0).contains(&x) || between == Between::Clamped) {
                let pair = [ours.look_up(0, order, x), theirs.look_up(0, order, x)];
                assert_eq!(pair[0], pair[1], "{x} {between:?} {order}");
            }
        }
        // Halfway between rows: Hermite's cubic with the slopes 10 (an end) and the weighted harmonic mean of 10 and 5/3, or those given.
        let mean = (0.7 + 0.5) / (0.7 / 10.0 + 0.5 / (5.0 / 3.0));
        let expected = match between {
            Between::Line => 0.5,
            Between::Monotone => 0.5 + 0.1 * (10.0 - mean) / 8.0,
            Between::Spline | Between::Clamped | Between::Periodic => 0.5 + 0.1 * (12.0 - 5.0) / 8.0,
        };
        assert!((ours.value(0, 0.05, 1.0) - expected).abs() < 1e-15);
    }
}

/// Derivatives are those of the cubic: by differences of the ones below.
#[test]
fn splines_have_their_derivatives() {
    let places = [0.0, 0.1, 0.4, 0.5, 0.7, 1.0];
    let slopes = rncf_codegen::import::spline::slopes(&places, &VALUES);
    let table = Table {
        name: "rows",
        places: Box::leak(Box::new(places)),
        is_relative: false,
        between: emitted::Between::Spline(Box::leak(Box::new([slopes.leak() as &[f64]]))),
        columns: &[&VALUES],
    };
    for x in [0.03, 0.27, 0.43, 0.66, 0.91] {
        for order in 1..4 {
            let at = |x: f64| table.look_up(0, order - 1, x);
            let difference = (at(x + 1e-5) - at(x - 1e-5)) / 2e-5;
            let found = table.look_up(0, order, x);
            assert!(
                (found - difference).abs() < 1e-6 * found.abs().max(1.0),
                "{x} {order}: {found} {difference}"
            );
        }
    }
    // Value, slope and curvature have no steps; at the first and last inner row the third derivative has none, either.
    for (row, &place) in places.iter().enumerate().skip(1).take(4) {
        let orders = if row == 1 || row == 4 { 4 } else { 3 };
        for order in 0..orders {
            let (before, behind) = (
                table.look_up(0, order, place.next_down()),
                table.look_up(0, order, place),
            );
            assert!(
                (before - behind).abs() < 1e-9 * behind.abs().max(1.0),
                "{place} {order}: {before} {behind}"
            );
        }
    }
    // Rows 1 and 4 are no knots: steps have to end at the others alone.
    assert_eq!(table.kinks_of_acceleration(0), [0.4, 0.5]);
}

/// A clamped spline has slopes of zero at its ends, and no step of the second derivative at an inner row.
#[test]
fn clamped_splines_are_smooth_and_level_at_their_ends() {
    let places = [0.0, 0.1, 0.4, 0.5, 0.7, 1.0];
    let slopes = rncf_codegen::import::spline::clamped_slopes(&places, &VALUES);
    assert_eq!([slopes[0], slopes[5]], [0.0; 2]);
    for row in 1..5 {
        let curvature = |span: usize, share: f64| {
            let ends = [VALUES[span], VALUES[span + 1]];
            let width = places[span + 1] - places[span];
            rncf_codegen::import::spline::cubic(width, ends, [slopes[span], slopes[span + 1]], share)[2]
        };
        let [before, behind] = [curvature(row - 1, 1.0), curvature(row, 0.0)];
        assert!(
            (before - behind).abs() < 1e-9 * before.abs().max(1.0),
            "{row}: {before} {behind}"
        );
    }
}
