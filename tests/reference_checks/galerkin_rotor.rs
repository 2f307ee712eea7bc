//! The rotor on a hub against the table of THEORY 8.2, closed limits and itself.

use rncf_reference::galerkin_rotor::Rotor;

/// THEORY 8.2: eta, flap 1 to 3, lag 1 and 2; zero hub radius.
const TABLE: [(f64, [f64; 5]); 13] = [
    (0.0, [3.51602, 22.03449, 61.69721, 3.51602, 22.03449]),
    (1.0, [3.68165, 22.18101, 61.84176, 3.54324, 22.15846]),
    (2.0, [4.13732, 22.61492, 62.27318, 3.62180, 22.52631]),
    (3.0, [4.79728, 23.32026, 62.98497, 3.74351, 23.12649]),
    (4.0, [5.58500, 24.27335, 63.96676, 3.89772, 23.94150]),
    (5.0, [6.44954, 25.44608, 65.20504, 4.07390, 24.95001]),
    (6.0, [7.36037, 26.80908, 66.68391, 4.26323, 26.12904]),
    (7.0, [8.29964, 28.33408, 68.38595, 4.45914, 27.45579]),
    (8.0, [9.25684, 29.99538, 70.29296, 4.65715, 28.90887]),
    (9.0, [10.22569, 31.77051, 72.38668, 4.85434, 30.46909]),
    (10.0, [11.20233, 33.64037, 74.64929, 5.04897, 32.11969]),
    (11.0, [12.18434, 35.58897, 77.06384, 5.24005, 33.84634]),
    (12.0, [13.17015, 37.60311, 79.61448, 5.42705, 35.63698]),
];

fn five(eta: f64, hub: f64, terms: usize) -> [f64; 5] {
    let rotor = Rotor { eta, hub, terms };
    let (flap, lag) = (rotor.flap().unwrap(), rotor.lag().unwrap());
    [flap[0], flap[1], flap[2], lag[0], lag[1]]
}

#[test]
fn the_table_without_a_hub_to_all_its_digits() {
    for (eta, expected) in TABLE {
        for (value, expected) in five(eta, 0.0, 22).into_iter().zip(expected) {
            assert!((value - expected).abs() < 5.1e-6, "eta {eta}: {value} not {expected}");
        }
    }
}

#[test]
fn a_hub_stiffens_and_more_terms_change_nothing() {
    for hub in [0.5, 1.0, 2.0] {
        for eta in [2.0, 6.0, 12.0] {
            let (few, many, without) = (five(eta, hub, 22), five(eta, hub, 28), five(eta, 0.0, 22));
            println!("hub {hub}, eta {eta}: flap {:.5?}, lag {:.5?}", &few[..3], &few[3..]);
            for k in 0..5 {
                assert!((few[k] / many[k] - 1.0).abs() < 1e-9);
                assert!(few[k] > without[k]);
            }
        }
    }
}

/// Fast rotation without a hub: a stiff rod on a hinge whose stiffness is that of the layer at the root,
/// `sqrt(EI T(0)) = eta / sqrt 2`, so that `mu^2` tends to `eta^2 + 3 eta / sqrt 2`.
#[test]
fn fast_rotation_is_a_hinged_rod() {
    for eta in [50.0, 100.0] {
        let excess = (five(eta, 0.0, 40)[0] / eta).powi(2) - 1.0;
        let expected = 3.0 / (f64::sqrt(2.0) * eta);
        assert!((excess / expected - 1.0).abs() < 3.0 / eta, "{excess} {expected}");
    }
}

/// What the free end lacks, second and third derivative there of both solutions clamped at the root, as a
/// determinant; by Runge-Kutta.
fn shot(eta: f64, hub: f64, mu: f64) -> f64 {
    const STEPS: usize = 4000;
    let h = 1.0 / STEPS as f64;
    let slope = |x: f64, w: [f64; 4]| {
        let tension = eta * eta * (hub * (1.0 - x) + 0.5 * (1.0 - x * x));
        let load = mu * mu * w[0] + tension * w[2] - eta * eta * (hub + x) * w[1];
        [w[1], w[2], w[3], load]
    };
    let ends = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]].map(|mut w: [f64; 4]| {
        for step in 0..STEPS {
            let x = step as f64 * h;
            let shifted = |k: [f64; 4], by: f64| std::array::from_fn(|i| w[i] + by * k[i]);
            let k1 = slope(x, w);
            let k2 = slope(x + 0.5 * h, shifted(k1, 0.5 * h));
            let k3 = slope(x + 0.5 * h, shifted(k2, 0.5 * h));
            let k4 = slope(x + h, shifted(k3, h));
            w = std::array::from_fn(|i| w[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        }
        w
    });
    ends[0][2] * ends[1][3] - ends[1][2] * ends[0][3]
}

#[test]
fn the_differential_equation_has_these_frequencies() {
    for hub in [0.0, 0.5, 1.0, 2.0] {
        for eta in [2.0, 6.0, 12.0] {
            for mu in &five(eta, hub, 22)[..3] {
                let (below, above) = (shot(eta, hub, mu * (1.0 - 1e-7)), shot(eta, hub, mu * (1.0 + 1e-7)));
                assert!(below * above < 0.0, "hub {hub}, eta {eta}, mu {mu}: {below} {above}");
            }
        }
    }
}
