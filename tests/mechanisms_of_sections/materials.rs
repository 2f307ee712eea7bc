//! Materials that are given by their energy: one that is linear against the beam by its moduli, a hyperelastic one
//! against its closed forms.

use rncf::app::{EquilibriumSettings, static_equilibria};
use rncf_test_models::Materials;

use crate::running::{WAYS, apart, at_rest, build, rows, run};

const MU: f64 = 1e6;
const LAMBDA: f64 = 2e6;

/// Root of an ascending function.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// Stretches along and across a bar with this nominal stress, of which the sides are free.
fn stretches(stress: f64) -> [f64; 2] {
    let across = |along: f64| root(0.3, 1.5, |b: f64| MU * (b * b - 1.0) + LAMBDA * (along * b * b).ln());
    let nominal = |along: f64| {
        let b = across(along);
        (MU * (along * along - 1.0) + LAMBDA * (along * b * b).ln()) / along
    };
    let along = root(0.5, 3.0, |along| nominal(along) - stress);
    [along, across(along)]
}

/// A linear material written as its energy bends and twists as the beam by its moduli, up to the square of slenderness.
#[test]
fn linear_energy_is_the_linear_beam() {
    for way in [WAYS[0], WAYS[1]] {
        let row = at_rest(&Materials::default(), way);
        let end = (0..3).map(|k| (row[k] - row[3 + k]).abs()).fold(0.0, f64::max);
        let turned = (12..15).map(|k| (row[k] - row[3 + k]).abs()).fold(0.0, f64::max);
        println!("{way:?}: {:?}, {end:.1e} m, {turned:.1e}", &row[..18]);
        assert!(row[1] > 0.05 && row[13].abs() > 0.05);
        assert!(end < 1e-4 * 0.5 && turned < 3e-4);
    }
}

#[test]
fn neo_hookean_bar_in_tension_and_compression() {
    let area = std::f64::consts::PI * 1e-4;
    for pull in [-60.0, 0.0, 50.0, 150.0, 400.0] {
        let [along, across] = stretches(pull / area);
        let model = Materials {
            pull,
            ..Materials::default()
        };
        let row = at_rest(&model, WAYS[0]);
        let errors = [row[6] / 0.3 - along, row[10] - across];
        println!(
            "{pull} N: stretch {along:.6}, {across:.6}, off by {errors:?}; tension {}",
            row[21]
        );
        assert!(errors.iter().all(|error| error.abs() < 1e-9), "{errors:?}");
    }
}

/// The lowest longitudinal vibration, kicked in its own shape, decays as that of a rod.
/// Stresses are forces over the undeformed section, which is told with how much smaller the section has become.
#[test]
fn shrunk_sections_are_told() {
    let area = std::f64::consts::PI * 1e-4;
    for pull in [1.0, 400.0] {
        let model = Materials {
            pull,
            ..Materials::default()
        };
        let found = static_equilibria(&model, &EquilibriumSettings::default()).unwrap();
        let told = found
            .warnings
            .iter()
            .find(|warning| warning.contains("its section is smaller"));
        let part = 100.0 * (stretches(pull / area)[1].powi(-2) - 1.0);
        if pull == 1.0 {
            assert!(part < 2.0 && told.is_none(), "{part} {told:?}");
        } else {
            let told = told.expect("a note");
            assert!(told.contains(&format!("larger by up to {part:.0} %")), "{part}: {told}");
        }
    }
}

#[test]
fn damping_dissipates_as_in_a_rod() {
    let model = Materials {
        bend: 0.0,
        turn: 0.0,
        damping: 5e-4,
        kick: 0.05,
        ..Materials::default()
    };
    let young: f64 = MU * (3.0 * LAMBDA + 2.0 * MU) / (LAMBDA + MU);
    let own = std::f64::consts::PI / 0.6 * (young / 1100.0).sqrt();
    let rate = own * own * model.damping / 2.0;
    let damped = (own * own - rate * rate).sqrt();
    for way in [WAYS[0], WAYS[2]] {
        let mut scene = build(&model, way);
        let states = run(scene.as_mut(), 0.06, 60, 1e-7);
        let rows = rows(scene.as_mut(), &states);
        let expected: Vec<Vec<f64>> = states
            .iter()
            .map(|state| vec![model.kick / damped * (-rate * state.t).exp() * (damped * state.t).sin()])
            .collect();
        let found: Vec<Vec<f64>> = rows.iter().map(|row| vec![row[6] - 0.3]).collect();
        let error = apart(&expected, &found, 0..1) * damped / model.kick;
        println!("{way:?}: {own:.1} rad/s, decays with {rate:.2}/s, off by {error:.1e} of the amplitude");
        assert!(error < 1e-2, "{error}");
    }
}
