//! Modes that grow, but are not among the lowest.

use rncf::app::{Campbell, EquilibriumSettings, Range, campbell, modes};

rncf::model! {
    /// A hose with a weight at its end, of rubber, under a thrust along its end.
    pub model Hose {
        param thrust = 3.9 kN;
        param elements: count = 12;
        section rubber { EA = 1e7 N; EI = 100 N*m^2; mass = 2 kg/m; damping = 20 ms; }
        body hose { planar xy; line from [0, 0, 0] m to [1.5, 0, 0] m; mesh elements * cable(rubber, axial = engineering, bending = exact); }
        joint root = clamp(hose.start, inertial);
        fixture nozzle on hose.end { mass = 1 kg; }
        load push = follower(hose.end, -thrust);
        output y = hose.end.y;
    }
}

rncf::model! {
    /// A shaft on bearings, and beside it a mass of 1 kg on 1 GN/m with a damper that feeds it: it grows with 0.5 1/s at 31623 rad/s.
    pub model Fed {
        param speed = 100 rad/s;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 10 mm);
        frame rotor = rotating(axis = x, angle = speed * t);
        body shaft in rotor { spatial; line from [0, 0, 0] m to [0.6, 0, 0] m; mesh 6 * beam(round, steel); }
        joint motor = hold(shaft.start.twist);
        joint thrust = hold(shaft.start.x);
        spring left = bushing(shaft.start, inertial.at([0, 0, 0] m), stiffness = [0, 10, 10] MN/m, damping = [0, 100, 100] N*s/m);
        spring right = bushing(shaft.end, inertial.at([0.6, 0, 0] m), stiffness = [0, 10, 10] MN/m, damping = [0, 100, 100] N*s/m);
        rigid lump in rotor { mass = 1 kg; origin = [1, 0, 0] m; }
        spring hold = bushing(lump, rotor.at([1, 0, 0] m), stiffness = [1, 2, 2] GN/m);
        spring feed = coordinate_law(lump.x, force = -1 [N*s/m] * rate);
        output x = lump.x;
        output bow = shaft.at(0.3 m).y;
    }
}

rncf::model! {
    /// A motor with its characteristic drives a fan through a shaft; both run at 100 rad/s.
    pub model Driven {
        param slope = 0.4 N*m*s;
        param torque = 50 N*m;
        frame motor = hinged(axis = x, speed = 100 rad/s);
        frame fan = hinged(axis = x, speed = 100 rad/s);
        fixture rotor on motor { mass = 1 kg; inertia = [0.1, 0.1, 0.1] kg*m^2; }
        fixture wheel on fan { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
        spring shaft = coordinate_law(motor.angle - fan.angle, moment = 1000 [N*m/rad] * value);
        load drive = moment(motor, [torque - slope * motor.speed, 0, 0]);
        load air = moment(fan, [-1e-3 [N*m*s^2] * fan.speed^2, 0, 0]);
        output wind = motor.angle - fan.angle;
    }
}

fn over(param: usize, from: f64, to: f64, steps: u32) -> EquilibriumSettings {
    EquilibriumSettings {
        range: Some(Range { param, from, to }),
        steps,
        ..EquilibriumSettings::default()
    }
}

/// The largest re at each value.
fn growth(found: &Campbell) -> Vec<f64> {
    let rows = (0..found.keys.len()).map(|row| found.row(row).map(|mode| mode.re).fold(f64::NEG_INFINITY, f64::max));
    rows.collect()
}

/// Reference: 60 Hermite elements and numpy's eigenvalues, 49.88 1/s and 14.5 rad/s under 4 kN. The modes of high frequency, which damping stops, have a smaller |s|.
#[test]
fn a_mode_that_grows_faster_than_others_vibrate_is_in_the_diagram() {
    let found = campbell(&Hose::default(), &over(0, 3900.0, 4000.0, 4)).unwrap();
    let growth = growth(&found);
    assert!(found.is_all && growth.iter().all(|re| *re > 48.0), "{growth:?}");
    assert!((growth.last().unwrap() - 49.88).abs() < 0.02, "{growth:?}");
    // It begins to grow once, and goes on.
    let found = campbell(&Hose::default(), &over(0, 1.0, 4000.0, 32)).unwrap();
    let [onset] = &found.onsets[..] else {
        panic!("{} onsets", found.onsets.len())
    };
    assert!(onset.begins && (onset.key - 0.39339).abs() < 1e-5, "{}", onset.key);
}

/// Meshes do not decide on it: 97 unknowns have it as 49 do.
#[test]
fn modes_show_what_grows_on_finer_meshes() {
    let margins = [12, 24].map(|elements| {
        let hose = Hose {
            elements,
            ..Hose::default()
        };
        modes(&hose, &EquilibriumSettings::default()).unwrap().margin.unwrap()
    });
    assert!(
        (margins[0] - 48.563).abs() < 2e-3 && (margins[1] - 48.563).abs() < 4e-3,
        "{margins:?}"
    );
}

/// A diagram of many unknowns looks at the lowest modes on its way, and says so; at both ends at all.
#[test]
fn a_diagram_says_what_it_looks_at() {
    let found = modes(&Fed::default(), &EquilibriumSettings::default()).unwrap();
    assert!((found.margin.unwrap() - 0.5).abs() < 1e-6, "{:?}", found.margin);
    let found = campbell(&Fed::default(), &over(0, 0.0, 300.0, 3)).unwrap();
    assert!(!found.is_all);
    let told: Vec<&String> = found
        .warnings
        .iter()
        .filter(|text| text.starts_with("Beyond the 8 lowest"))
        .collect();
    assert_eq!(told.len(), 2, "{:?}", found.warnings);
    assert!(
        told[1].contains("at speed = 300 rad/s, by the factor e in 2 s, with 31622.78 rad/s"),
        "{told:?}"
    );
}

/// The speed that nothing holds dies away, or grows, by what torques change with it: far more slowly than the shaft twists, and beside the angle, which
/// stays where it is. The roots are those of `(J1 s^2 + c1 s + k) (J2 s^2 + c2 s + k) - k^2`.
#[test]
fn a_speed_that_grows_slowly_is_a_mode() {
    for (slope, torque) in [(0.4, 50.0), (-0.19, -9.0), (-0.21, -11.0)] {
        let model = Driven { slope, torque };
        let found = modes(&model, &EquilibriumSettings::default()).unwrap();
        let [still, others @ ..] = &found.modes[..] else {
            panic!("{found:?}")
        };
        let slow = others
            .iter()
            .chain([still])
            .find(|mode| mode.im == 0.0 && mode.re != 0.0);
        let slow = slow.unwrap_or_else(|| panic!("{slope}: {:?}", found.modes)).re;
        let (k, fan) = (1000.0, 0.2);
        let dynamic = |s: f64| (0.1 * s * s + slope * s + k) * (s * s + fan * s + k) - k * k;
        let (near, rest) = (1e-6 * slow.abs(), dynamic(slow));
        assert!(rest.abs() < (dynamic(slow + near) - rest).abs(), "{slope}: {slow}");
        assert_eq!(slow > 0.0, slope + fan < 0.0, "{slow}");
        let most = found.margin.unwrap();
        assert!(slow <= 0.0 || most >= slow, "{most}");
        assert_eq!(found.modes.iter().filter(|mode| mode.is_still()).count(), 1);
    }
}
