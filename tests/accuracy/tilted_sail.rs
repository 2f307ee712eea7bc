//! A tilted E-sail over half a day: how its rate of spin changes.
//!
//! The thrust that turns the spin axis with the orbit has a part about that axis where the main tethers make it. With the spin axis
//! at the angle alpha to the direction s from the Sun, the moment of one tether t is x t x s per unit of thrust, so that voltages
//! that vary with sin and cos of its place make `(b cos(alpha) e - a cos(alpha) e2 - b sin(alpha) n) K/2`, n the spin axis, e in the
//! plane of n and s. Turning n by the rate W of the orbit takes b K/2 = -H W / cos(alpha), and that changes the angular momentum H
//! by H W tan(alpha) (the orbital Coriolis effect of Toivanen & Janhunen 2013). The ring has no such part.

use rncf::app::{RunSettings, run};
use rncf::{Method, Options, StepSize};
use rncf_models::EsailTilted;

/// Relative change of the spin in time, 1/s, by a straight line through the second half of the run; and the mean tilt, rad.
fn change_of_spin(ring_share: f64) -> (f64, f64) {
    // What is asked is how the whole sail turns: its tethers may be straight.
    let model = EsailTilted {
        elements: 1,
        ring_share,
        ..EsailTilted::default()
    };
    let settings = RunSettings {
        method: Method::GeneralizedAlpha { rho_inf: 0.8 },
        options: Options {
            step: StepSize::Fixed(5.0),
            ..Options::default()
        },
        t_end: Some(43200.0),
        every: Some(360.0),
        ..RunSettings::default()
    };
    let result = run(&model, &settings).expect("a run");
    let history = &result.history;
    let rows: Vec<[f64; 3]> = history
        .keys
        .iter()
        .zip(history.values.chunks_exact(history.columns.len()))
        .map(|(&t, row)| [t, row[0], row[1].to_radians()])
        .skip(history.keys.len() / 4)
        .collect();
    let mean = |of: usize| rows.iter().map(|row| row[of]).sum::<f64>() / rows.len() as f64;
    let (t, spin) = (mean(0), mean(1));
    let above: f64 = rows.iter().map(|row| (row[0] - t) * (row[1] - spin)).sum();
    let below: f64 = rows.iter().map(|row| (row[0] - t).powi(2)).sum();
    (above / below / spin, mean(2))
}

#[test]
fn main_tethers_that_turn_the_sail_change_its_spin_and_the_ring_does_not() {
    let orbital_rate = (5.93e-3_f64 / 1.5e11).sqrt();
    // Side by side: they are the longest runs of all tests.
    let ((by_main, tilt), (by_ring, _)) = rayon::join(|| change_of_spin(0.0), || change_of_spin(1.0));
    let expected = orbital_rate * tilt.tan();
    assert!((by_main / expected - 1.0).abs() < 0.1, "{by_main:e} for {expected:e}");
    assert!((by_ring / expected).abs() < 0.05, "{by_ring:e} for {expected:e}");
}
