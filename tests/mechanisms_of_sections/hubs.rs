//! Rotors of several blades on a hub that gives way: what an observer sees who stands beside them.

use rncf::app::{EquilibriumSettings, Inertial, RunSettings, modes, run};

mod three {
    rncf::model! {
        /// Three rigid blades on flap hinges with springs; their hub can shift and tilt. The wind pushes one of them at the start.
        pub model Three {
            param w = 2 rad/s;
            motion gust(t) = if t < 0.5 s { 1 - cos(2*pi*t / 0.5 [s]) } else { 0 };
            rigid hub { mass = 50 [t]; inertia = [2e5, 1e5, 1e5] kg*m^2; angular_velocity = [w, 0, 0]; }
            spring mount = bushing(hub, inertial, stiffness = [3, 3, 3] MN/m, rotational_stiffness = [0, 400, 400] MN*m/rad);
            for b in 0..3 {
                rigid blade[b] {
                    mass = 17 [t]; inertia = [3e6, 3e6, 2e4] kg*m^2; center = [0, 0, 20] m;
                    axis = x; angle = 2*pi*b/3; origin = [0 m, -1.5 [m] * sin(2*pi*b/3), 1.5 [m] * cos(2*pi*b/3)];
                    angular_velocity = [w, 0, 0]; velocity = [0, -1.5 [m] * w * cos(2*pi*b/3), -1.5 [m] * w * sin(2*pi*b/3)];
                }
                joint hinge[b] = revolute(blade[b], hub.at([0 m, -1.5 [m] * sin(2*pi*b/3), 1.5 [m] * cos(2*pi*b/3)]), axis = y);
                spring flap[b] = torsional(hinge[b], stiffness = 40 [MN*m/rad]);
            }
            load wind = force(blade[0].at([0, 0, 20] m), [20 [kN] * gust(t), 0, 0]);
            output right = hub.ex.y;
            output up = hub.ex.z;
            run { t_end = 120 s; every = 0.05 s; }
        }
    }
}

mod two {
    rncf::model! {
        /// Two such blades, one opposite the other.
        pub model Two {
            param w = 2 rad/s;
            rigid hub { mass = 50 [t]; inertia = [2e5, 1e5, 1e5] kg*m^2; angular_velocity = [w, 0, 0]; }
            spring mount = bushing(hub, inertial, stiffness = [3, 3, 3] MN/m, rotational_stiffness = [0, 400, 400] MN*m/rad);
            for b in 0..2 {
                rigid blade[b] {
                    mass = 17 [t]; inertia = [3e6, 3e6, 2e4] kg*m^2; center = [0, 0, 20] m;
                    axis = x; angle = pi*b; origin = [0 m, 0 m, 1.5 [m] * cos(pi*b)];
                    angular_velocity = [w, 0, 0]; velocity = [0, -1.5 [m] * w * cos(pi*b), 0];
                }
                joint hinge[b] = revolute(blade[b], hub.at([0 m, 0 m, 1.5 [m] * cos(pi*b)]), axis = y);
                spring flap[b] = torsional(hinge[b], stiffness = 40 [MN*m/rad]);
            }
            output x = hub.x;
        }
    }
}

mod four {
    rncf::model! {
        /// Four elastic blades that are clamped to a hub on springs.
        pub model Four {
            param w = 10 rad/s;
            material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
            section flat = rectangle(y = 50 mm, z = 20 mm);
            frame rotor = free(angular_velocity = [w, 0, 0]);
            fixture hub on rotor { mass = 20 kg; inertia = [0.4, 0.3, 0.3] kg*m^2; }
            spring mount = bushing(rotor, inertial, stiffness = [1, 1, 1] MN/m, rotational_stiffness = [0, 1, 1] MN*m/rad);
            for b in 0..4 {
                body blade[b] in rotor {
                    spatial; section_y [1, 0, 0]; mesh 2 * beam(flat, aluminium);
                    line from [0 m, 0.2 [m] * cos(pi*b/2), 0.2 [m] * sin(pi*b/2)] to [0 m, 2 [m] * cos(pi*b/2), 2 [m] * sin(pi*b/2)];
                }
                joint root[b] = clamp(blade[b].start, rotor);
            }
            output x = rotor.x;
        }
    }
}

use four::Four;
use three::Three;
use two::Two;

/// Blades that flap one after the other tilt the hub round in circles, which it feels at other frequencies than those of the turning
/// axes. The latter are those of Lagrange's equations of the nine freedoms, written and solved by other code.
#[test]
fn blades_that_flap_in_turn_whirl() {
    let model = Three::default();
    let found = modes(&model, &EquilibriumSettings::default()).unwrap();
    let seen: Vec<Inertial> = found.modes[1..4].iter().map(|mode| mode.inertial(found.spin)).collect();
    let expected = [
        Inertial::One(2.72338),
        Inertial::Whirl(2.0 + 2.76412),
        Inertial::Whirl(2.0 - 2.76527),
    ];
    let value = |seen: &Inertial| match *seen {
        Inertial::One(value) | Inertial::Whirl(value) => value,
        Inertial::Two(_) => f64::NAN,
    };
    for (seen, expected) in seen.iter().zip(&expected) {
        assert!(
            std::mem::discriminant(seen) == std::mem::discriminant(expected),
            "{seen:?}"
        );
        assert!(
            (value(seen) - value(expected)).abs() < 1e-5,
            "{seen:?} for {expected:?}"
        );
    }
    assert!(found.is_round);
    // The hub itself, over time: both circles, and nothing at the frequencies of the turning axes.
    let history = run(&model, &RunSettings::default()).unwrap().history;
    let [right, up] = ["right", "up"].map(|name| history.column(history.find(name).unwrap()).collect::<Vec<f64>>());
    let end = history.keys[history.keys.len() - 1];
    let strength = |frequency: f64| {
        let (mut re, mut im) = (0.0, 0.0);
        for ((t, y), z) in history.keys.iter().zip(&right).zip(&up) {
            let window = 1.0 - (std::f64::consts::TAU * t / end).cos();
            let (sin, cos) = (frequency * t).sin_cos();
            re += window * (y * cos + z * sin);
            im += window * (z * cos - y * sin);
        }
        f64::hypot(re, im)
    };
    let [forward, backward] = [value(&seen[1]), value(&seen[2])].map(strength);
    assert!((forward / backward - 1.0).abs() < 0.05, "{forward} {backward}");
    for other in [2.7647, -2.7647, -4.76412, 0.76527] {
        assert!(
            strength(other) < 0.02 * forward,
            "{other}: {} of {forward}",
            strength(other)
        );
    }
}

/// Two blades that flap against each other tilt the hub to and fro about one line of it, which turns.
#[test]
fn blades_that_teeter_are_felt_at_two_frequencies() {
    let found = modes(&Two::default(), &EquilibriumSettings::default()).unwrap();
    let seen: Vec<usize> = found.modes[1..3]
        .iter()
        .map(|mode| mode.inertial_frequencies(found.spin).len())
        .collect();
    // Against each other, and then both to one side.
    assert_eq!(seen, [2, 1]);
    assert!(!found.is_round);
}

/// Of four blades there are for flap and for lag a mode in which all move alike, two that go round, and one of which no bearing feels anything.
#[test]
fn what_balances_is_not_felt() {
    let found = modes(&Four::default(), &EquilibriumSettings::default()).unwrap();
    let seen: Vec<i32> = found.modes[..8]
        .iter()
        .map(|mode| match mode.inertial(found.spin) {
            Inertial::One(_) => 0,
            Inertial::Whirl(velocity) => velocity.signum() as i32,
            Inertial::Two(_) => 2,
        })
        .collect();
    // Lag of all is a turn of the rotor that nothing holds.
    assert_eq!(seen, [0, 1, -1, 0, 0, 1, -1, 0]);
    assert!(found.is_round);
}
