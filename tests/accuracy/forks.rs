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

rncf::model! {
    /// A rod on a hinge beside a turning axis: it swings out on the side of its hinge, and beyond where a hinge on the axis would fork the rod that
    /// leans inwards is an equilibrium, too.
    pub model Swung {
        param speed = 20 rad/s; param beside = 10 mm;
        frame hub = rotating(axis = z, angle = speed * t);
        rigid rod in hub { mass = 1 kg; inertia = [0.02, 0.02, 0.001] kg*m^2; center = [0, 0, -0.5] m; origin = [beside, 0 m, 0 m]; }
        joint hinge = revolute(hub.at([beside, 0 m, 0 m]), rod.at([0, 0, 0] m), axis = y);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output angle = hinge.angle;
    }
}

/// Moments about the hinge, with `a` outwards from the vertical: `speed^2 cos a (0.269 sin a + 0.5 beside) = 0.5 9.81 sin a`.
#[test]
fn a_rod_beside_the_axis_swings_outwards() {
    for (beside, steps) in [(10e-3, 16), (10e-3, 32), (-10e-3, 32), (30e-3, 32), (1e-3, 100)] {
        let model = Swung {
            beside,
            ..Swung::default()
        };
        let settings = EquilibriumSettings {
            steps,
            ..EquilibriumSettings::default()
        };
        let found = equilibria(&model, Kind::Steady, &settings, |_| ControlFlow::Continue(())).unwrap();
        let is_unstable = found.warnings.iter().any(|note| note.contains("unstable"));
        assert!(!is_unstable, "{beside} m, {steps} steps: {:?}", found.warnings);
        let (spin, angle) = (20.0f64, -found.history.column(0).last().unwrap());
        let off =
            spin * spin * (0.269 * angle.sin() * angle.cos() + 0.5 * beside * angle.cos()) - 0.5 * 9.81 * angle.sin();
        assert!(
            off.abs() < 1e-6 && angle * beside.signum() > 1.4,
            "{beside} m, {steps} steps: {angle} rad, {off} N m"
        );
    }
}
