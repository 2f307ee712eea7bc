//! The tube on its hub in both formulations, as `--compare` lays them over each other.

use rncf::Formulation;
use rncf::app::{Figure, RunSettings};
use rncf_guide::drawing::{Drawing, View};
use rncf_models::SpinUp;

use crate::{chart, column, drawn, line, says, shows};

#[test]
fn both_formulations_have_one_motion() {
    let (ours, shots) = drawn(&SpinUp::default(), RunSettings::default());
    let absolute = RunSettings {
        formulation: Formulation::Ancf,
        ..RunSettings::default()
    };
    let (theirs, _) = drawn(&SpinUp::default(), absolute);
    let [one, other] = [&ours, &theirs].map(|run| column(&run.history, "v"));
    let apart = one.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-4, "{apart} m");
    says("pages", &format!("up to {:.0} um", 1e6 * apart));
    let mut figure = Figure::default();
    let lines = vec![
        line(&ours.history, "v", 1.0, 0),
        line(&theirs.history, "v", 1.0, 1).dashed(),
    ];
    figure.add(
        "Deflection of the tip in the hub",
        &["referenced", "absolute"],
        chart("t [s]", "v [m]", lines),
    );
    let row = |t: f64| (t / 20.0 * (shots.count() - 1) as f64).round() as usize;
    let drawing = Drawing::new(
        &shots,
        View::XY,
        [4.0, 5.0, 6.0, 7.0].map(row).to_vec(),
        "The tube after 0, 4, 5, 6 and 7 s",
    );
    let title = "A tube on a hub that is spun up, and the deflection of its tip in two sets of coordinates";
    shows("pages", Some(&drawing), &figure, title);
}
