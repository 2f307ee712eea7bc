//! Loads per length over a part of an axis: steps of a table inside of elements; loads that are made of vectors.

use rncf::app::{EquilibriumSettings, static_equilibria};

rncf::model! {
    /// A stiff cantilever of 1 m under 100 N/m on its first 0.37 m, and on 0.37 to 0.81 m of another one.
    pub model Partial {
        param n: count = 8;
        table near { x = [0, 0.37, 0.37, 1] m; q = [1, 1, 0, 0]; interpolation = linear; }
        table middle { x = [0, 0.37, 0.37, 0.81, 0.81, 1] m; q = [0, 0, 1, 1, 0, 0]; interpolation = linear; }
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar { area = 1e-3 m^2; second_moment = 1e-6 m^4; }
        body first { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh n * cable(bar, steel); }
        body second { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh n * cable(bar, steel); }
        joint foot = clamp(first.start, inertial);
        joint other_foot = clamp(second.start, inertial);
        load snow = distributed(first, [0 [N/m], -100 [N/m] * near.q, 0]);
        load sand = distributed(second, [0 [N/m], -100 [N/m] * middle.q, 0]);
        output moment = foot.moment.z;
        output force = foot.force.y;
        output other_moment = other_foot.moment.z;
        output other_force = other_foot.force.y;
        output tip: um = first.end.y;
    }
}

/// All of the load counts, whatever the points of the elements see: 37.5 N stood for 37 N, "differ by at most 1.5e-3".
#[test]
fn a_load_over_a_part_is_whole() {
    for n in [3, 5, 8] {
        let model = Partial { n };
        let found = static_equilibria(
            &model,
            &EquilibriumSettings {
                steps: 1,
                ..EquilibriumSettings::default()
            },
        )
        .unwrap();
        let last = |index: usize| found.history.column(index).last().unwrap();
        let near =
            |found: f64, want: f64, part: f64| assert!((found.abs() - want).abs() < part * want, "{n}: {found} {want}");
        near(last(1), 37.0, 1e-9);
        near(last(3), 44.0, 1e-9);
        near(last(0), 37.0 * 0.185, 1e-6);
        near(last(2), 44.0 * 0.59, 1e-6);
        // q a^3 (4 L - a) / (24 EI)
        near(
            last(4),
            1e6 * 100.0 * 0.37_f64.powi(3) * (4.0 - 0.37) / (24.0 * 210e3),
            2e-3,
        );
    }
}

rncf::model! {
    /// The same loads on equal bars, written out, and made of vectors.
    pub model Made {
        param lift = 30 N;
        param at = 0.3 s;
        table rows { at = u; u = [0, 1] s; f = [0, 2]; }
        motion wave(t) = sin(5 [rad/s] * t);
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar { area = 1e-3 m^2; second_moment = 1e-6 m^4; }
        body one { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(bar, steel); }
        body two { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(bar, steel); }
        joint foot = clamp(one.start, inertial);
        joint other_foot = clamp(two.start, inertial);
        load own = force(one.end, [5 N * rows.f(t), lift * wave(t), 0 N]);
        load turn = moment(one.end, [0, 0, 2 [N*m] * wave(t)]);
        load made = force(two.end, rows.f(t) * [5, 0, 0] N + [0, 1, 0] * wave(t) * lift);
        load made_turn = moment(two.end, [0, 0, 1] N*m * 2 * sin(5 [rad/s] * t));
        load inside = force(one.at(0.3 m), [0, 4, 0] N);
        load part = force(two.at(eta = 0.3), [0, 4, 0] N);
        load weight = gravity(-9.81 [m/s^2] * [0, 1, 0]);
        output here = one.end;
        output there = two.end;
        output inside_here = one.at(0.6 m).y;
        output inside_there = two.at(eta = 0.6).y;
        run { t_end = at; every = at; }
    }
}

#[test]
fn loads_are_made_of_vectors() {
    let found = static_equilibria(&Made::default(), &EquilibriumSettings::default()).unwrap();
    let last = |index: usize| found.history.column(index).last().unwrap();
    let [x, y] = [0, 1].map(&last);
    let [other_x, other_y] = [2, 3].map(&last);
    println!("{x} {y} {other_x} {other_y}");
    assert_eq!(last(4), last(5));
    assert!(y.abs() > 1e-6 && (y - other_y).abs() < 1e-9 * y.abs() && (x - other_x).abs() < 1e-12);
}
