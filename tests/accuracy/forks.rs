//! Ways of equilibria past a fork of the perfect machine: of what is a little beside it they bend to one side.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use rncf::app::{Equilibria, EquilibriumSettings, Range, equilibria};
use rncf::equilibrium::Kind;

rncf::model! {
    /// A strip between two clamps that come nearer, and a force beside it.
    pub model Shortened {
        param way = 0.1 mm;
        param lean = 0.1 N;
        param elements: count = 12;
        section strip { EA = 42 MN; EI = 350 N*m^2; mass = 1.57 kg/m; }
        body c { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * cable(strip, axial = engineering, bending = exact); }
        joint a = clamp(c.start, inertial);
        joint b = clamp(c.end, inertial, at = [1 m - way, 0, 0]);
        load push = force(c.at(0.5 m), [0, lean, 0]);
        output y = c.at(0.5 m).y;
        output thrust = a.force.x;
    }
}

fn shortened(lean: f64, elements: usize, steps: u32) -> Equilibria {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 1e-3,
        }),
        steps,
        ..EquilibriumSettings::default()
    };
    let model = Shortened {
        lean,
        elements,
        ..Shortened::default()
    };
    equilibria(&model, Kind::Static, &settings, |_| ControlFlow::Continue(())).unwrap()
}

/// The way went straight on, with a critical value at one of its own steps, or to the other side.
#[test]
fn an_imperfect_strip_bends_to_the_side_of_its_force() {
    // Shortening by compression at P = 4 pi^2 EI/L^2, and the rest by `pi^2 A^2/4` of `y = A/2 (1 - cos(2 pi x/L))`.
    let load = 4.0 * PI * PI * 350.0;
    let critical = load / 42e6;
    let amplitude = 2.0 / PI * (1e-3_f64 - critical).sqrt();
    for lean in [1.0, 0.1, 0.01] {
        for (elements, steps) in [(12, 32), (24, 32), (12, 50), (12, 7)] {
            let found = shortened(lean, elements, steps);
            let last = found.history.column(0).last().unwrap();
            assert!(
                (last / amplitude - 1.0).abs() < 0.01,
                "{lean} {elements} {steps} {last} {amplitude}"
            );
            assert!(
                found.critical.is_empty(),
                "{lean} {elements} {steps} {:?}",
                found.critical
            );
        }
    }
    let perfect = shortened(0.0, 12, 32);
    let value = 1e3 * critical * (1.0 + critical);
    assert_eq!(perfect.critical.len(), 2, "{:?}", perfect.critical);
    assert!(
        (perfect.critical[0].value / value - 1.0).abs() < 2e-3,
        "{:?} {value}",
        perfect.critical
    );
}
