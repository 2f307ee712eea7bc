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

rncf::model! {
    /// A rod that hangs on a hinge a little beside a turning axis.
    pub model Hung {
        param w = 20 rad/s;
        param e = 10 mm;
        frame hub = rotating(axis = z, angle = w*t);
        rigid rod in hub { mass = 1 kg; inertia = [0.02, 0.02, 0.001] kg*m^2; center = [0, 0, -0.5] m; origin = [e, 0 m, 0 m]; }
        joint h = revolute(hub.at([e, 0 m, 0 m]), rod.at([0, 0, 0] m), axis = y);
        load g = gravity([0, 0, -9.81] m/s^2);
        output f = h.force.in(hub);
        output a: deg = h.angle;
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

/// A component of the reaction that is round-off in both equilibria differs by more parts than what anybody sees.
#[test]
fn the_other_equilibrium_is_told_by_what_is_there() {
    let found = equilibria(&Hung::default(), Kind::Steady, &EquilibriumSettings::default(), |_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    let near = "is nearer to the undeformed shape";
    let note = found.warnings.iter().find(|note| note.contains(near));
    let note = note.unwrap_or_else(|| panic!("{:?}", found.warnings));
    assert!(
        note.contains("with `a` = 1.116 deg") || note.contains("with `f.x` = "),
        "{note}"
    );
}

/// Moments about the hinge: `m g h sin a = (I + m h^2) w^2 sin a cos a + m e h w^2 cos a`. It came out at 179 degrees.
#[test]
fn a_rod_that_hangs_beside_the_axis_swings_out() {
    for steps in [8, 32, 100] {
        let settings = EquilibriumSettings {
            steps,
            ..EquilibriumSettings::default()
        };
        let found = equilibria(&Hung::default(), Kind::Steady, &settings, |_| ControlFlow::Continue(())).unwrap();
        let a = found.history.column(3).last().unwrap();
        // The axis of the hinge points back: outwards is negative.
        let out = -a.to_radians();
        let inertia = 0.02 - 0.001 + 0.25;
        let moment = 400.0 * (inertia * out.sin() + 0.01 * 0.5) * out.cos() - 9.81 * 0.5 * out.sin();
        assert!(moment.abs() < 1e-9 && out > 1.0 && out < 1.6, "{steps} {a} {moment}");
    }
}
