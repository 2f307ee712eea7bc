//! Diagrams of what forces that come from no energy act on: closed forms.

use rncf::app::{Campbell, EquilibriumSettings, Range, campbell};

rncf::model! {
    /// A controlled mass on a table that turns; `det K = (5 N/m - m w^2) (a - m w^2) + 12 N^2/m^2` in its axes.
    pub model Controlled {
        param a = 1 N/m;
        param spin = 1 rad/s;
        frame table_top = rotating(axis = z, angle = spin * t);
        rigid p in table_top { plane xy; mass = 1 kg; }
        load control = force(p, [
            -5 [N/m] * p.in(table_top).x + 2 [N/m] * p.in(table_top).y - 3 [N*s/m] * p.in(table_top).velocity.x,
            -6 [N/m] * p.in(table_top).x - a * p.in(table_top).y - 3 [N*s/m] * p.in(table_top).velocity.y,
            0], in = table_top);
        output x = p.in(table_top).x;
    }
}

fn over_a(model: &Controlled, from: f64, to: f64) -> Campbell {
    let settings = EquilibriumSettings {
        range: Some(Range { param: 0, from, to }),
        steps: 7,
        ..EquilibriumSettings::default()
    };
    campbell(model, &settings).unwrap()
}

/// The whole stiffness is singular where a frequency in the turning axes is zero; its symmetric part is elsewhere.
#[test]
fn a_real_root_that_passes_zero_is_found_at_rest_and_on_what_turns() {
    for spin in [0.0, 1.0, 1.5] {
        let square = spin * spin;
        let expected = square - 12.0 / (5.0 - square);
        let model = Controlled {
            spin,
            ..Controlled::default()
        };
        for [from, to] in [[2.0, -5.0], [-5.0, 1.0]] {
            let found = over_a(&model, from, to);
            let values: Vec<f64> = found.critical.iter().map(|critical| critical.value).collect();
            let at: Vec<usize> = (0..values.len()).filter(|&index| found.standing[index]).collect();
            assert_eq!(at.len(), 1, "{spin} {from}: {values:?} {:?}", found.standing);
            assert!((values[at[0]] - expected).abs() < 1e-6, "{spin} {from}: {values:?}");
        }
    }
}
