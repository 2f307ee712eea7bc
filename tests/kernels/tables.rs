//! Tables as the generator reads them, beside the same tables in a program that runs.

use rncf_codegen::model;
use rncf_runtime::emitted::Table;

#[test]
fn the_generator_reads_tables_as_programs_do() {
    const PLACES: [f64; 6] = [0.0, 0.1, 0.4, 0.4, 0.7, 1.0];
    const VALUES: [f64; 6] = [0.0, 1.0, 1.5, 3.0, 2.0, 7.0];
    for (is_relative, is_smooth) in [(true, true), (true, false), (false, true), (false, false)] {
        let ours = model::Table {
            name: "rows".into(),
            file: None,
            places: PLACES.to_vec(),
            dimension: [0; 6],
            is_relative,
            is_smooth,
            columns: vec![model::Column {
                header: None,
                name: "EI".into(),
                dimension: [0; 6],
                values: VALUES.to_vec(),
            }],
            placed_by: vec![0],
            alike: Vec::new(),
            is_param: false,
        };
        let theirs = Table {
            name: "rows",
            places: &PLACES,
            is_relative,
            is_smooth,
            columns: &[&VALUES],
        };
        for step in -10..=1100 {
            let x = 1e-3 * f64::from(step);
            assert_eq!(
                ours.value(0, x, 1.0),
                theirs.at(0, x, 1.0),
                "{x} {is_relative} {is_smooth}"
            );
        }
        // Halfway between rows: Hermite's cubic with the slopes 10 (an end) and the weighted harmonic mean of 10 and 5/3.
        let mean = (0.7 + 0.5) / (0.7 / 10.0 + 0.5 / (5.0 / 3.0));
        let expected = if is_smooth {
            0.5 + 0.1 * (10.0 - mean) / 8.0
        } else {
            0.5
        };
        assert!((ours.value(0, 0.05, 1.0) - expected).abs() < 1e-15);
    }
}
