//! What is closed to a ring, and free.

use rncf::app::{EquilibriumSettings, RunSettings, modes, run, static_equilibria};

rncf::model! {
    /// A ring in space that nothing holds and nothing acts on.
    pub model Ring {
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section round = circle(radius = 5 mm);
        frame f = free(plane = xy);
        body ring in f {
            planar xy;
            arc from [500, 0, 0] mm direction [0, 1, 0] radius 500 mm angle 360 deg;
            mesh 32 * cable(round, steel, axial = engineering, bending = exact);
            mean_axes;
        }
        joint close = weld(ring.start, ring.end);
        output c = ring.at(eta = 0.5);
    }
}

/// The weld is open by round-off, and its force has a lever of round-off: no force that is not balanced. `w^2 = EI n^2 (n^2 - 1)^2 / (m R^4 (n^2 + 1))`.
#[test]
fn a_free_ring_that_is_welded_has_its_modes() {
    let found = modes(&Ring {}, &EquilibriumSettings::default()).unwrap();
    let own: Vec<f64> = found.modes.iter().map(|mode| mode.im).collect();
    let radius: f64 = 5e-3;
    let (area, second) = (
        std::f64::consts::PI * radius.powi(2),
        std::f64::consts::PI * radius.powi(4) / 4.0,
    );
    let right = |n: f64| {
        let square = 210e9 * second * (n * (n * n - 1.0)).powi(2) / (7850.0 * area * 0.5f64.powi(4) * (n * n + 1.0));
        square.sqrt()
    };
    println!("{own:?} {} {}", right(2.0), right(3.0));
    assert_eq!(own[..3], [0.0; 3]);
    for (index, n) in [(3, 2.0), (4, 2.0), (5, 3.0), (6, 3.0)] {
        assert!(
            (own[index] / right(n) - 1.0).abs() < 5e-3,
            "{n}: {} {}",
            own[index],
            right(n)
        );
    }
}

rncf::model! {
    /// An arm that is declared beside the pin that it hangs on.
    pub model Beside {
        param gap = 0 m;
        rigid arm { plane xy; mass = 1 kg; inertia = 1 kg*m^2; origin = [gap, 0, 0]; center = [1, 0, 0] m; }
        joint pin = revolute(arm.at([0, 0, 0] m), inertial.at([0, 0, 0] m));
        spring coil = torsional(pin, stiffness = 100 N*m/rad);
        load push = force(arm.at([1, 0, 0] m), [0, 1, 0] N);
        output tip = arm.at([1, 0, 0] m);
        run { t_end = 0.1 s; every = 0.01 s; }
    }
}

/// A run refuses what is open; an equilibrium closes it, and says so.
#[test]
fn a_joint_that_an_equilibrium_closes_is_told() {
    let of = |warnings: &[String]| {
        warnings
            .iter()
            .any(|text| text.contains("joint `pin` (revolute)") && text.contains("is open, by 0.5:"))
    };
    for (gap, is_open) in [(0.0, false), (0.5, true)] {
        let model = Beside { gap };
        let settings = EquilibriumSettings::default();
        let held = static_equilibria(&model, &settings).unwrap();
        let found = modes(&model, &settings).unwrap();
        assert_eq!(
            [of(&held.warnings), of(&found.warnings)],
            [is_open; 2],
            "{:?} {:?}",
            held.warnings,
            found.warnings
        );
        assert_eq!(run(&model, &RunSettings::default()).is_err(), is_open);
    }
}
