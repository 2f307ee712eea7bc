//! The rotating cantilever's frequencies against the table of THEORY 8.2 and, on a hub, against Galerkin's method.

use rncf::equilibrium::{Kind, Uniform};
use rncf::modes::{Wanted, modes};
use rncf_models::RotatingCantilever;
use rncf_reference::galerkin_rotor::Rotor;

use crate::scenes::{equilibrium, short};

/// eta; flap 1, flap 2, lag 1, lag 2 of THEORY 8.2.
const TABLE: [[f64; 4]; 13] = [
    [3.51602, 22.03449, 3.51602, 22.03449],
    [3.68165, 22.18101, 3.54324, 22.15846],
    [4.13732, 22.61492, 3.62180, 22.52631],
    [4.79728, 23.32026, 3.74351, 23.12649],
    [5.58500, 24.27335, 3.89772, 23.94150],
    [6.44954, 25.44608, 4.07390, 24.95001],
    [7.36037, 26.80908, 4.26323, 26.12904],
    [8.29964, 28.33408, 4.45914, 27.45579],
    [9.25684, 29.99538, 4.65715, 28.90887],
    [10.22569, 31.77051, 4.85434, 30.46909],
    [11.20233, 33.64037, 5.04897, 32.11969],
    [12.18434, 35.58897, 5.24005, 33.84634],
    [13.17015, 37.60311, 5.42705, 35.63698],
];

/// Flap 1, flap 2, lag 1, lag 2 with 16 elements.
fn frequencies(eta: f64, hub_ratio: f64) -> [f64; 4] {
    let model = RotatingCantilever {
        eta,
        hub_ratio,
        elements: 16,
    };
    let (mut scene, state, row) = equilibrium(&model, Kind::Steady, 1.0);
    // T = rho A W^2 (R L + L^2 / 2) in the root.
    let tension = eta * eta * (hub_ratio + 0.5);
    assert!(
        (row[3] - tension).abs() <= 1e-3 * tension && row[1].abs() + row[2].abs() < 1e-9,
        "{row:?}"
    );
    let found = modes(scene.as_mut(), &Uniform::steady(0.0), &state, Wanted { count: 4 }).unwrap();
    assert!(found.iter().all(|mode| mode.re.abs() < 1e-5 * mode.im));
    let [lag_1, flap_1, lag_2, flap_2] = [0, 1, 2, 3].map(|k| found[k].im);
    [flap_1, flap_2, lag_1, lag_2]
}

/// Relative differences.
fn apart(found: [f64; 4], expected: [f64; 4]) -> [f64; 4] {
    [0, 1, 2, 3].map(|k| (found[k] / expected[k] - 1.0).abs())
}

#[test]
fn frequencies_over_the_speed() {
    for (eta, row) in TABLE.into_iter().enumerate() {
        let differences = apart(frequencies(eta as f64, 0.0), row);
        println!(
            "eta {eta}: flap 1, 2, lag 1, 2 from the table by {}",
            short(&differences)
        );
        for (difference, limit) in differences.into_iter().zip([1e-4, 4e-4, 1e-4, 4e-4]) {
            assert!(difference < limit, "eta {eta}: {differences:?}");
        }
    }
}

#[test]
fn frequencies_on_a_hub() {
    for hub in [0.5, 1.0, 2.0] {
        for eta in [2.0, 6.0, 12.0] {
            let rotor = Rotor { eta, hub, terms: 22 };
            let (flap, lag) = (rotor.flap().unwrap(), rotor.lag().unwrap());
            let differences = apart(frequencies(eta, hub), [flap[0], flap[1], lag[0], lag[1]]);
            println!(
                "hub {hub}, eta {eta}: flap 1, 2, lag 1, 2 from Galerkin's by {}",
                short(&differences)
            );
            assert!(differences.into_iter().all(|difference| difference < 1e-3));
        }
    }
}
