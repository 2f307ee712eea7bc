//! A rope that turns about the axis on which its ends are held: nothing holds it against turning about that axis relative to the frame.

use rncf::app::{EquilibriumSettings, Judging, equilibria};
use rncf::equilibrium::Kind;
use std::ops::ControlFlow;

rncf::model! {
    /// Three metres of cord between eyes that are nearer to each other, about an axis askew.
    pub model Skipping {
        param speed = 20 rad/s;
        const length = 3 m;
        const apart = 2.5 m;
        material rubber { density = 1100 kg/m^3; young = 100 MPa; }
        section cord { area = 1 cm^2; second_moment = 1 mm^4; }
        frame drum = rotating(axis = [1, 2, 2], angle = speed * t, origin = [5, 5, 5] m);
        body rope in drum {
            spatial;
            line from [0, 0, 0] m to [length / 3, 2 * length / 3, 2 * length / 3];
            mesh 24 * cable(cord, rubber, axial = engineering);
            initial position x * apart / length * [1, 2, 2] / 3 + length / 4 * sin(pi * x / length) * [0, 1, -1] / sqrt(2);
        }
        joint left = pin(rope.start, drum);
        joint right = pin(rope.end, drum, at = [apart / 3, 2 * apart / 3, 2 * apart / 3]);
        output bow = (rope.at(length / 2).y - rope.at(length / 2).z) / sqrt(2);
        output pull = rope.at(length / 2).axial_force;
        run { t_end = 0.1 s; every = 10 ms; }
    }
}

/// Bow (m) and pull (N) in the middle of a perfectly limp rope, by shooting from there to an end.
fn limp(speed: f64) -> [f64; 2] {
    const STEPS: usize = 400;
    let (half, reach, weight, stiffness) = (1.5, 1.25, 1100.0 * 1e-4, 100e6 * 1e-4);
    let end = |[bow, pull]: [f64; 2]| {
        // Place along the axis and beside it, and the part of the force across it.
        let slope = |[_, r, across]: [f64; 3]| {
            let force = f64::hypot(pull, across);
            let stretch = (1.0 + force / stiffness) / force;
            [stretch * pull, stretch * across, -weight * speed * speed * r]
        };
        let step = half / STEPS as f64;
        let mut at = [0.0, bow, 0.0];
        for _ in 0..STEPS {
            let moved = |k: [f64; 3], part: f64| std::array::from_fn(|i| at[i] + part * step * k[i]);
            let one = slope(at);
            let two = slope(moved(one, 0.5));
            let three = slope(moved(two, 0.5));
            let four = slope(moved(three, 1.0));
            at = std::array::from_fn(|i| at[i] + step / 6.0 * (one[i] + 2.0 * (two[i] + three[i]) + four[i]));
        }
        [at[0] - reach, at[1]]
    };
    let mut guess = [0.7, 0.07 * speed * speed];
    for _ in 0..20 {
        let off = end(guess);
        let column = |k: usize| {
            let change = 1e-6 * guess[k];
            let mut other = guess;
            other[k] += change;
            let moved = end(other);
            [(moved[0] - off[0]) / change, (moved[1] - off[1]) / change]
        };
        let ([a, c], [b, d]) = (column(0), column(1));
        let determinant = a * d - b * c;
        guess[0] -= (d * off[0] - b * off[1]) / determinant;
        guess[1] -= (a * off[1] - c * off[0]) / determinant;
    }
    guess
}

/// Beside an equilibrium the motion that nothing holds has a stiffness, and an iteration went far along it: 5,400 steps of a rope like this one, and
/// meshes that were compared at other angles.
#[test]
fn a_rope_is_followed_through_all_speeds_of_its_axis() {
    let settings = EquilibriumSettings {
        judged: Judging::Whole,
        ..EquilibriumSettings::default()
    };
    let model = Skipping::default();
    let found = equilibria(&model, Kind::Steady, &settings, |_| ControlFlow::Continue(())).unwrap();
    let columns = found.history.columns.len();
    let rows: Vec<&[f64]> = found.history.values.chunks(columns).collect();
    assert!(rows.len() < 80, "{}", rows.len());
    for row in rows.iter().filter(|row| row[0] >= 5.0) {
        let [bow, pull] = limp(row[0]);
        let [_, y, own] = **row else {
            panic!("{columns} columns")
        };
        assert!((y / bow - 1.0).abs() < 1e-3, "{row:?} {bow}");
        assert!((own / pull - 1.0).abs() < 2e-3, "{row:?} {pull}");
    }
    let told = format!("{:?}", found.warnings);
    assert!(!told.contains("too coarse"), "{told}");
}
