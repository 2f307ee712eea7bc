//! The template's rope on Earth and on the Moon: its first mode is that of a hanging chain.

use rncf::app::charts::Line;
use rncf::app::{EquilibriumSettings, Figure, RunSettings, modes, run};
use rncf_guide::python::Swing;

use crate::{chart, column, says, shows};

#[test]
fn the_rope_swings_slower_on_the_moon() {
    let names = ["Earth", "Moon"];
    let mut lines = Vec::new();
    for (color, g) in [9.81, 1.62].into_iter().enumerate() {
        let swing = Swing {
            length: 2.0,
            g,
            ..Swing::default()
        };
        let found = modes(&swing, &EquilibriumSettings::default()).unwrap();
        // The first zero of the Bessel function J0.
        let chain = 2.404_825_557_695_773 / 2.0 * (g / 2.0_f64).sqrt();
        let frequency = found.modes[0].im;
        assert!(
            (frequency / chain - 1.0).abs() < 6e-3,
            "{frequency} rad/s, {chain} rad/s"
        );
        says("python", &format!("{frequency:.3} rad/s"));
        says("python", &format!("{chain:.3}"));
        let result = run(
            &swing,
            &RunSettings {
                t_end: Some(3.0),
                ..RunSettings::default()
            },
        )
        .unwrap();
        let heights = column(&result.history, "tip.y");
        lines.push(Line::new(result.history.keys.iter().copied().zip(heights), color));
    }
    let mut figure = Figure::default();
    figure.add("Height of the free end", &names, chart("t [s]", "tip.y [m]", lines));
    shows(
        "python",
        None,
        &figure,
        "The free end of a rope of 2 m on Earth and on the Moon",
    );
}
