//! Loads per length over a part of an axis: steps of a table inside of elements.

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
