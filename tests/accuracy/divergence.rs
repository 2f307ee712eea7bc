//! Equilibria that are lost, beside those that only seem to be: forces that come from no energy, and what turns.

use rncf::app::{EquilibriumSettings, Judging, Range, campbell, modes, static_equilibria, steady};

rncf::model! {
    /// A mass on springs whose push aside grows with its height: the stiffness `[[3 k, q], [0, k - q]]` is singular at q = k, its symmetric
    /// part at 0.93 k.
    pub model Pushed {
        param q = 1 N/m;
        rigid bob { mass = 1 kg; }
        spring bed = bushing(bob, inertial.at([0, 0, 0] m), stiffness = [300, 100, 200] N/m);
        load push = force(bob, [-q * bob.y, q * bob.y, 0]);
        output y = bob.y;
    }
}

rncf::model! {
    /// Beck's column: a force that stays along the end of a cantilever makes it flutter at 20.05 EI/L^2, and never buckle.
    pub model Beck {
        param load = 1 kN;
        param elements: count = 6;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar = rectangle(y = 10 mm, z = 20 mm);
        body column { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * cable(bar, steel); }
        joint foot = clamp(column.start, inertial);
        load push = follower(column.end, -load);
        output y = column.end.y;
    }
}

rncf::model! {
    /// A rod on a hinge of a vertical shaft: it hangs upright up to the speed at which it goes out.
    pub model Governor {
        param w = 3 rad/s;
        frame hub = rotating(axis = z, angle = w * t);
        rigid rod in hub { mass = 1 kg; inertia = [0.02, 0.02, 1e-5] kg*m^2; center = [0, 0, -0.5] m; axis = y; angle = -1 deg; }
        joint hinge = revolute(hub.at([0, 0, 0] m), rod.at([0, 0, 0] m), axis = y);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output angle = hinge.angle;
    }
}

rncf::model! {
    /// A rigid column of 1 m on a spring of 100 N m: it tips under 100 N.
    pub model Column {
        param load = 1 N;
        rigid rod { mass = 1 kg; inertia = [0.02, 0.02, 1e-5] kg*m^2; }
        joint hinge = revolute(inertial.at([0, 0, 0] m), rod.at([0, 0, 0] m), axis = y);
        spring coil = torsional(hinge, stiffness = 100 N*m);
        load push = force(rod.at([0, 0, 1] m), [0, 0, -load]);
        output angle = hinge.angle;
    }
}

fn over(param: usize, to: f64, steps: u32) -> EquilibriumSettings {
    EquilibriumSettings {
        range: Some(Range { param, from: 0.0, to }),
        steps,
        ..EquilibriumSettings::default()
    }
}

#[test]
fn forces_without_energy_are_not_left_out_of_critical_values() {
    let found = campbell(&Pushed::default(), &over(0, 150.0, 32)).unwrap();
    let [critical] = found.critical[..] else {
        panic!("{:?}", found.critical)
    };
    assert!((critical.value - 100.0).abs() < 1e-4, "{critical:?}");
    let found = campbell(&Beck::default(), &over(0, 10e3, 40)).unwrap();
    assert!(found.critical.is_empty(), "{:?}", found.critical);
    let unstable = found.margins().iter().position(|margin| margin.unwrap() > 1.0);
    let bending = 210e9 * 0.02 * 0.01_f64.powi(3) / 12.0;
    // In kN, the unit in which the load is declared.
    let flutter = 20.05 * bending / 1e3;
    let first = found.keys[unstable.expect("flutter")];
    assert!((0.0..0.25).contains(&(first - flutter)), "{first} for {flutter}");
}

/// A step of the way that lies on a critical value hid it: at rest a mode that is still there was taken for one without any stiffness.
#[test]
fn a_critical_value_on_a_step_is_found() {
    for steps in [30, 31] {
        let found = campbell(&Pushed::default(), &over(0, 150.0, steps)).unwrap();
        let [critical] = found.critical[..] else {
            panic!("{steps} steps: {:?}", found.critical)
        };
        assert!((critical.value - 100.0).abs() < 1e-4, "{critical:?}");
        let found = static_equilibria(&Column::default(), &over(0, 150.0, steps)).unwrap();
        let [critical] = found.critical[..] else {
            panic!("{steps} steps: {:?}", found.critical)
        };
        assert!((critical.value - 100.0).abs() < 1e-4, "{critical:?}");
    }
}

/// Where nothing couples, what grows has the rate that the diagonal tells: the inverse about it was singular, and no mode was found.
#[test]
fn what_grows_alone_has_its_modes() {
    let found = modes(&Governor { w: 6.0 }, &EquilibriumSettings::default()).unwrap();
    // (m l^2 + J_y) s^2 = w^2 (m l^2 + J_x - J_z) - m g l
    let growth = ((36.0 * (0.25 + 0.02 - 1e-5) - 9.81 * 0.5) / 0.27_f64).sqrt();
    let most = found.modes.iter().map(|mode| mode.re).fold(0.0, f64::max);
    assert!((most / growth - 1.0).abs() < 1e-9, "{most} {growth}");
}

#[test]
fn the_end_of_a_way_of_turning_equilibria_is_told_where_it_is_unstable() {
    // w^2 (m l^2 + J_x - J_z) = m g l
    let critical = (9.81_f64 * 0.5 / (0.25 + 0.02 - 1e-5)).sqrt();
    for (to, is_unstable) in [(0.95 * critical, false), (1.05 * critical, true)] {
        let settings = EquilibriumSettings {
            judged: Judging::Affordable,
            ..over(0, to, 8)
        };
        let found = steady(&Governor::default(), &settings).unwrap();
        let note = found
            .warnings
            .iter()
            .find(|note| note.contains("equilibrium is unstable"));
        assert_eq!(note.is_some(), is_unstable, "{to}: {:?}", found.warnings);
    }
}

rncf::model! {
    /// A cantilever under a dead load on its end.
    pub model Pressed {
        param load = 500 N;
        param n: count = 8;
        material alu { density = 2700 kg/m^3; young = 70 GPa; }
        section strip { area = 60 mm^2; second_moment = 20 mm^4; }
        body col { planar yz; line from [0, 1, 2] m to [0, 1.6, 2.8] m; mesh n * cable(strip, alu, axial = engineering, bending = exact); }
        joint foot = clamp(col.start, inertial);
        load top = force(col.end, [0, -0.6 * load, -0.8 * load]);
        output y = col.end.y;
    }
}

/// Euler's loads of a cantilever stand in the ratio of odd squares. The lowest one lies in the first step of the load factor, which nobody looked at: the second one
/// was told as the first. Where there are too many unknowns to count negative directions, the end is told as unstable all the same.
#[test]
fn the_first_step_of_loads_is_looked_at() {
    let euler = std::f64::consts::PI.powi(2) * 70e9 * 20e-12 / 4.0;
    let found = static_equilibria(&Pressed::default(), &EquilibriumSettings::default()).unwrap();
    for (critical, odd) in found.critical.iter().zip([1.0, 3.0, 5.0]) {
        let exact = euler * odd * odd / 500.0;
        assert!(
            (critical.value - exact).abs() < 2e-3 * exact,
            "{critical:?} for {exact}"
        );
    }
    assert_eq!(found.critical.len(), 6, "{:?}", found.critical);
    for (load, is_unstable) in [(2.0, false), (60.0, true)] {
        let model = Pressed { load, n: 120 };
        let found = static_equilibria(&model, &EquilibriumSettings::default()).unwrap();
        let told = found.warnings.iter().any(|note| note.contains("is unstable"));
        assert_eq!(told, is_unstable, "{load}: {:?}", found.warnings);
    }
}
