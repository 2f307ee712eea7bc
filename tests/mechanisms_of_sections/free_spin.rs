//! Bodies that spin freely: what is carried along across the axis, what rolls about an axis without stiffness, and what bends beside it.

use rncf::AnyModel;
use rncf::app::{Campbell, EquilibriumSettings, Modes, Range, campbell, modes};
use rncf::model::Spin;

mod rod {
    rncf::model! {
        /// A rod that turns about a middle axis of its inertia: about its own one nothing is stiff, at any speed.
        pub model Rod {
            param w = 3 rad/s; param n: count = 6;
            section s {
                EA = 20 kN; GA = 8 kN; GJ = 0.7 N*m^2; EIy = 1 N*m^2; EIz = 2 N*m^2;
                mass = 1 kg/m; inertia_y = 1e-3 kg*m; inertia_z = 1e-3 kg*m;
            }
            frame f = free(angular_velocity = [0, 0, 1] * w);
            body rod in f { spatial; line from [-0.5, 0, 0] m to [0.5, 0, 0] m; mesh n * beam(s); mean_axes; }
            output p = rod.end.in(inertial);
            run { t_end = 1 s; }
        }
    }
}
use rod::Rod;

mod hub {
    rncf::model! {
        /// A rigid body that spins about the axis of its largest inertia.
        pub model Hub {
            param w = 2 rad/s;
            rigid hub { mass = 5 kg; inertia = [1, 2, 2.5] kg*m^2; angular_velocity = [0, 0, 1] * w; }
            output p = hub.position;
            run { t_end = 1 s; }
        }
    }
}
use hub::Hub;

fn found(model: &dyn AnyModel) -> Modes {
    modes(model, &EquilibriumSettings::default()).unwrap()
}

/// Three motions without stiffness, three at the angular velocity, of which the two shifts stand still, and the first ones that bend: those of a geometrically
/// exact rod of 80 elements, linearised numerically in turning axes by another program.
#[test]
fn a_free_rod_has_its_six_rigid_motions_and_bends_beside_them() {
    for (w, n, bent) in [
        (0.5, 6, Some(21.840)),
        (3.0, 12, Some(22.401)),
        (3.0, 6, Some(22.401)),
        (10.0, 12, None),
        (30.0, 6, None),
    ] {
        let found = found(&Rod { w, n });
        let still = found.modes.iter().filter(|mode| mode.is_still()).count();
        let carried: Vec<_> = found
            .modes
            .iter()
            .filter(|mode| (mode.im - w).abs() < 1e-9 * w)
            .collect();
        let standing = carried
            .iter()
            .filter(|mode| mode.inertial_frequencies(w) == [0.0])
            .count();
        assert_eq!(
            (found.modes.len(), still, carried.len(), standing),
            (8, 3, 3, 2),
            "{w} {n}: {:?}",
            found.modes
        );
        assert!(
            found.modes.iter().all(|mode| mode.re.abs() < 1e-11),
            "{w} {n}: {:?}",
            found.modes
        );
        let first = found.modes[6].im;
        assert!(
            bent.is_none_or(|bent: f64| (first - bent).abs() < 4e-4 * bent),
            "{w} {n}: {first} for {bent:?}"
        );
    }
}

/// Nothing of it becomes soft; its tilt has the frequency of the spin at every speed.
#[test]
fn the_diagram_of_a_free_rod_has_no_critical_speed() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 6.0,
        }),
        steps: 6,
        ..EquilibriumSettings::default()
    };
    let found: Campbell = campbell(&Rod::default(), &settings).unwrap();
    assert!(
        found.critical.is_empty() && found.crossings.is_empty(),
        "{:?} {:?}",
        found.critical,
        found.crossings
    );
    assert!(found.onsets.is_empty(), "{:?}", found.onsets);
}

/// Of a free top `nu^2 = w^2 (C - A)(C - B) / (A B)`; with its rigid motions it has six.
#[test]
fn a_free_top_wobbles() {
    let w = 2.0;
    let found = found(&Hub { w });
    let wobble = w * (1.5_f64 * 0.5 / 2.0).sqrt();
    let near = found
        .modes
        .iter()
        .filter(|mode| (mode.im - wobble).abs() < 1e-9 * wobble);
    assert_eq!((found.modes.len(), near.count()), (6, 1), "{:?}", found.modes);
}

mod wheel {
    rncf::model! {
        /// A satellite with a momentum wheel on a bearing, each with a start of its own.
        pub model Satellite {
            param w = 500 rad/s; param own = 0 rad/s;
            rigid sat { mass = 50 kg; inertia = [5, 6, 7] kg*m^2; angular_velocity = [1, 0, 0] * own; }
            rigid wheel { mass = 2 kg; inertia = [0.02, 0.01, 0.01] kg*m^2; angular_velocity = [1, 0, 0] * w; }
            joint shaft = revolute(sat.at([0, 0, 0] m), wheel.at([0, 0, 0] m), axis = x);
            output ey = sat.ex.y;
            run { t_end = 1 s; }
        }
    }
}
use wheel::Satellite;

mod boom {
    rncf::model! {
        /// A hub that turns, with a boom whose joint does not let it start at rest.
        pub model Boom {
            rigid hub { mass = 50 kg; inertia = [5, 6, 7] kg*m^2; angular_velocity = [0, 0, 1] rad/s; }
            rigid boom { mass = 2 kg; inertia = [0.02, 1, 1] kg*m^2; origin = [1, 0, 0] m; center = [1, 0, 0] m; }
            joint hinge = revolute(hub.at([1, 0, 0] m), boom.at([0, 0, 0] m), axis = y);
            output z = boom.position.z;
            run { t_end = 1 s; }
        }
    }
}
use boom::Boom;

/// Of bodies that start apart from the rotation it is said that they are taken along: the satellite at rest beside its wheel has another nutation, at
/// `h / sqrt(I_2 I_3)`, than one that turns with the wheel. What joints turn from the start is not named.
#[test]
fn what_is_taken_along_by_a_rotation_is_named() {
    let named = |found: &Modes| {
        found
            .warnings
            .iter()
            .any(|told| told.contains("`sat` does not start in the rotation of 500 rad/s"))
    };
    let satellite = Satellite::default();
    assert!(named(&found(&satellite)));
    assert!(!named(&found(&Satellite {
        own: 500.0,
        ..satellite.clone()
    })));
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 400.0,
            to: 500.0,
        }),
        steps: 2,
        ..EquilibriumSettings::default()
    };
    let told = campbell(&satellite, &settings).unwrap().warnings;
    assert!(
        told.iter()
            .any(|told| told.contains("`sat` does not start in the rotation of 500 rad/s")),
        "{told:?}"
    );
    let told = found(&Boom {}).warnings;
    assert!(!told.iter().any(|told| told.contains("does not start")), "{told:?}");
}

/// A diagram of a machine whose rotor is asked for at rest says what that leaves out, as its modes do.
#[test]
fn a_diagram_at_rest_says_that_gyroscopic_moments_are_left_out() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 500.0,
        }),
        spin: Some(Spin::default()),
        steps: 2,
        ..EquilibriumSettings::default()
    };
    let told = campbell(&Satellite::default(), &settings).unwrap().warnings;
    assert!(
        told.iter()
            .any(|told| told.contains("the 500 rad/s in which it starts are left out")),
        "{told:?}"
    );
}

mod car {
    rncf::model! {
        /// A pendulum in a frame that sets out with an acceleration.
        pub model Car {
            frame car = moving(origin = [2.5 [m/s^2] * t^2, 0 m, 0 m]);
            rigid bob { plane xy; mass = 1 kg; origin = [0, -1, 0] m; inertia = 1 g*m^2; }
            joint hinge = revolute(car.at([0, 0, 0] m), bob.at([0, 1, 0] m), axis = z);
            load weight = gravity([0, -9.81, 0] m/s^2);
            output x = bob.position.x;
            run { t_end = 1 s; }
        }
    }
}
use car::Car;

/// It hangs at an angle, and not upright with the frequency of that.
#[test]
fn a_frame_that_accelerates_from_rest_is_no_frame_at_rest() {
    let settings = EquilibriumSettings {
        at: Some(0.0),
        ..EquilibriumSettings::default()
    };
    let refused = modes(&Car {}, &settings).unwrap_err().to_string();
    assert!(refused.contains("frame `car` shifts without turning"), "{refused}");
}

mod struck {
    rncf::model! {
        /// A bar in a frame that turns, which a blow has struck long ago.
        pub model Struck {
            section s { EA = 1e6 N; EI = 100 N*m^2; mass = 3 kg/m; }
            frame hub = rotating(axis = z, angle = 20 [rad/s] * t);
            body bar in hub { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(s); }
            joint root = clamp(bar.start, hub);
            load blow = force(bar.end, [0 N, if t < 1 ms { 5 N } else { 0 N }, 0 N]);
            load sway = force(bar.end, [0 N, if t < 3 s { 0 N } else { 5 [N] * sin(2000 * pi * t / 1 [s]) }, 0 N]);
            output y = bar.end.y;
            run { t_end = 1 s; }
        }
    }
}
use struck::Struck;

/// A load that has been over for long, or has yet to begin, does not stand in the way of an equilibrium; one that goes on does, whatever its period.
#[test]
fn a_load_that_is_over_does_not_vary() {
    let at = |t: f64| {
        let settings = EquilibriumSettings {
            at: Some(t),
            ..EquilibriumSettings::default()
        };
        modes(&Struck {}, &settings)
    };
    assert!(at(1.0).is_ok());
    for (t, load) in [(0.9995e-3, "blow"), (3.5, "sway")] {
        let refused = at(t).unwrap_err().to_string();
        assert!(
            refused.contains(&format!("load `{load}` varies with time")),
            "{refused}"
        );
    }
}

mod momentum {
    rncf::model! {
        /// The satellite with its wheel as a moment of momentum.
        pub model Momentum {
            param momentum = 10 kg*m^2/s;
            rigid sat { mass = 52 kg; inertia = [5, 6.01, 7.01] kg*m^2; }
            load gyro = moment(sat, momentum * [0, -sat.angular_velocity.z, sat.angular_velocity.y], in = sat);
            output ey = sat.ex.y;
            run { t_end = 1 s; }
        }
    }
}
use momentum::Momentum;

/// At rest it nutates with `h / sqrt(I_2 I_3)`.
#[test]
fn a_wheel_is_a_moment_on_what_carries_it() {
    let found = found(&Momentum::default());
    let nutation = 10.0 / f64::sqrt(6.01 * 7.01);
    let moving: Vec<f64> = found.modes.iter().map(|mode| mode.im).filter(|&im| im > 0.0).collect();
    assert!(
        moving.len() == 1 && (moving[0] / nutation - 1.0).abs() < 1e-9,
        "{moving:?}"
    );
}
