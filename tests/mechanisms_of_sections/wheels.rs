//! Discs whose tilt is told by nothing but itself: thin ones, unbalanced ones, and rotors that spin freely.

use rncf::app::{EquilibriumSettings, Inertial, Judging, Range, RunSettings, SeenMode, campbell, modes, run, steady};

mod flywheel {
    rncf::model! {
        /// A rigid disc on springs at its centre.
        pub model Flywheel {
            param speed = 10 rad/s;
            param diametral = 0.5 kg*m^2;
            param eccentricity = 0 m;
            rigid disc {
                mass = 10 kg; inertia = [diametral, diametral, 1 [kg*m^2]]; center = [eccentricity, 0, 0];
                angular_velocity = [0, 0, speed];
            }
            spring mount = bushing(disc, inertial, stiffness = [1000, 1000, 4000] N/m, rotational_stiffness = [100, 100, 0] N*m/rad);
            output x = disc.x;
        }
    }
}

use flywheel::Flywheel;

/// Angular velocities of the tilts in axes that stand still, rad/s: `Id w^2 - Ip speed w - k = 0`.
fn tilts(wheel: &Flywheel) -> [f64; 2] {
    let half = 0.5 * wheel.speed / wheel.diametral;
    let root = (half * half + 100.0 / wheel.diametral).sqrt();
    [half + root, half - root]
}

/// Both tilts are among the whirls, and all that whirls does so on circles.
#[track_caller]
fn tilts_as_it_should(wheel: &Flywheel, within: f64) {
    let found = modes(wheel, &EquilibriumSettings::default()).unwrap();
    let whirl = |mode: &SeenMode| match mode.inertial(found.spin) {
        Inertial::Whirl(velocity) => Some(velocity),
        _ => None,
    };
    let seen: Vec<f64> = found.modes.iter().filter_map(whirl).collect();
    for tilt in tilts(wheel) {
        let near = seen.iter().any(|whirl| (whirl / tilt - 1.0).abs() < within);
        assert!(near, "{wheel:?}: {tilt} among {seen:?}");
    }
    assert!(found.is_round, "{wheel:?}");
}

/// Whether an unbalance is one of a micrometre or of a millimetre, a disc is no blade.
#[test]
fn an_unbalance_makes_no_blade_of_a_disc() {
    for (eccentricity, within) in [(0.0, 1e-9), (1e-17, 1e-9), (1e-6, 1e-8), (1e-3, 1e-3)] {
        let wheel = Flywheel {
            speed: 30.0,
            diametral: 0.51,
            eccentricity,
        };
        tilts_as_it_should(&wheel, within);
    }
}

/// Of a disc without thickness both tilts have one frequency in turning axes, and of another one the axial motion meets a whirl.
#[test]
fn modes_that_meet_are_told_apart() {
    for speed in [3.0, 10.0, 25.0] {
        let wheel = Flywheel {
            speed,
            ..Flywheel::default()
        };
        tilts_as_it_should(&wheel, 1e-9);
    }
    let wheel = Flywheel {
        speed: 30.0,
        diametral: 0.51,
        ..Flywheel::default()
    };
    let found = modes(&wheel, &EquilibriumSettings::default()).unwrap();
    // sqrt(k/m) along the axis, and across it in turning axes less the spin.
    let along = found.modes.iter().any(|mode| {
        (mode.im - 20.0).abs() < 1e-7
            && matches!(mode.inertial(found.spin), Inertial::One(im) if (im - 20.0).abs() < 1e-7)
    });
    assert!(along, "{:?}", found.modes);
}

mod wheel {
    rncf::model! {
        /// A heavy wheel in the middle of a short shaft on elastic bearings: a thin disc has no extent along the axis.
        pub model Wheel {
            param speed = 6000 rpm;
            param diametral = 0.02 kg*m^2;
            material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
            section round = circle(radius = 5 mm);
            frame rotor = rotating(axis = x, angle = speed * t);
            body shaft in rotor { spatial; line from [0, 0, 0] m to [0.06, 0, 0] m; mesh 16 * beam(round, steel); }
            joint motor = hold(shaft.start.twist);
            joint thrust = hold(shaft.start.x);
            fixture disc on shaft.at(30 mm) { mass = 5 kg; inertia = [0.04 [kg*m^2], diametral, diametral]; }
            spring left = bushing(shaft.start, inertial.at([0, 0, 0] m), stiffness = [0, 10, 10] MN/m, damping = [0, 500, 500] N*s/m);
            spring right = bushing(shaft.end, inertial.at([0.06, 0, 0] m), stiffness = [0, 10, 10] MN/m, damping = [0, 500, 500] N*s/m);
            output y = shaft.at(30 mm).y;
        }
    }
}

/// Conical whirls and their decay of finite elements of Timoshenko's beam with gyroscopic matrices in axes that stand still.
#[test]
fn a_thin_disc_on_a_light_shaft_whirls() {
    let found = modes(&wheel::Wheel::default(), &EquilibriumSettings::default()).unwrap();
    for (whirl, decay) in [(-300.129, -1.9604), (1556.873, -10.169)] {
        let near = |mode: &&SeenMode| match mode.inertial(found.spin) {
            Inertial::Whirl(velocity) => (velocity / whirl - 1.0).abs() < 3e-4,
            _ => false,
        };
        let mode = found
            .modes
            .iter()
            .find(near)
            .unwrap_or_else(|| panic!("{whirl}: {:?}", found.modes));
        assert!((mode.re / decay - 1.0).abs() < 1e-3, "{mode:?}");
    }
}

mod propeller {
    rncf::model! {
        /// A hub on springs with three blades that spin freely: nothing acts about the axis.
        pub model Propeller {
            param speed = 60 rad/s;
            param elements: count = 4;
            const n = 3;
            section s {
                EA = 5 MN; GAy = 2 MN; GAz = 1 MN; GJ = 500 N*m^2; EIy = 300 N*m^2; EIz = 3000 N*m^2;
                mass = 1.5 kg/m; inertia_y = 2e-4 kg*m; inertia_z = 2e-3 kg*m;
            }
            rigid hub { mass = 20 kg; inertia = [0.3, 0.5, 0.5] kg*m^2; angular_velocity = [speed, 0, 0]; }
            spring mount = bushing(hub, inertial, stiffness = [0.2, 0.2, 0.2] MN/m, rotational_stiffness = [0, 0.1, 0.1] MN*m/rad);
            for i in 0..n {
                body blade[i] in hub {
                    spatial;
                    line from [0 m, 0.1 [m] * cos(2*pi*i/n), 0.1 [m] * sin(2*pi*i/n)]
                        to [0 m, 1 [m] * cos(2*pi*i/n), 1 [m] * sin(2*pi*i/n)];
                    section_y [0, -sin(2*pi*i/n), cos(2*pi*i/n)];
                    mesh elements * beam(s);
                }
                joint root[i] = clamp(blade[i].start, hub);
            }
            output pull = root[0].force;
        }
    }
}

/// Round-off of centrifugal forces is no torque. At the root they are `rho omega^2 (R^2 - r^2) / 2`, but for the strain.
#[test]
fn what_spins_freely_with_equal_blades_has_its_equilibrium() {
    for (speed, elements) in [(30.0, 4), (45.0, 3), (60.0, 4), (60.0, 6)] {
        let propeller = propeller::Propeller { speed, elements };
        let settings = EquilibriumSettings {
            judged: Judging::No,
            ..EquilibriumSettings::default()
        };
        let found = steady(&propeller, &settings).unwrap();
        assert!(
            found.incomplete.is_none(),
            "{speed}, {elements}: {:?}",
            found.incomplete
        );
        let column = found.history.find("pull.y").unwrap();
        let force = found.history.column(column).last().unwrap();
        let rigid = 1.5 * speed * speed * 0.5 * (1.0 - 0.01);
        assert!((force.abs() / rigid - 1.0).abs() < 2e-3, "{force} {rigid}");
    }
}

mod turned {
    rncf::model! {
        /// An unbalanced body in space that is driven evenly.
        pub model Turned {
            param speed = 1000 rad/s;
            rigid r { mass = 1 kg; inertia = [0.02, 0.01, 0.01] kg*m^2; center = [0, 0.001, 0] m; angular_velocity = [speed, 0 [rad/s], 0 [rad/s]]; }
            joint bearing = revolute(inertial.at([0, 0, 0] m), r, axis = x);
            joint motor = drive(bearing.angle, speed * t);
            output ey = r.ey;
            output pull = bearing.force;
            run { t_end = 1 s; every = 0.0137 s; }
        }
    }
}

/// Steps of two radians have a rotation that is no vibration which they lose.
#[test]
fn a_rotation_that_rows_have_is_not_lost() {
    let settings = RunSettings {
        judged: Judging::Affordable,
        ..RunSettings::default()
    };
    let found = run(&turned::Turned::default(), &settings).unwrap();
    let column = found.history.find("ey.y").unwrap();
    let worst = found.history.keys.iter().zip(found.history.column(column));
    let worst = worst.map(|(t, y)| (y - (1000.0 * t).cos()).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst}");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}

mod standing {
    rncf::model! {
        /// A disc on springs that are not alike, in axes that stand still: its spin is the moment that it makes of a tilt.
        pub model Standing {
            param speed = 300 rad/s;
            const polar = 1 kg*m^2;
            rigid disc { mass = 10 kg; inertia = [1, 0.6, 0.6] kg*m^2; }
            spring mount = bushing(disc, inertial, stiffness = [4000, 1000, 2000] N/m, rotational_stiffness = [50, 3000, 8000] N*m/rad);
            load gyro = moment(disc, polar * speed * [0, -disc.angular_velocity.z, disc.angular_velocity.y], in = disc);
            output x = disc.x;
        }
    }
}

/// `Id^2 w^4 - (Id (ky + kz) + (Ip speed)^2) w^2 + ky kz = 0`.
#[test]
fn a_spin_is_a_moment_on_bearings_that_are_not_alike() {
    let found = modes(&standing::Standing::default(), &EquilibriumSettings::default()).unwrap();
    let (inertia, stiff) = (0.6_f64, [3000.0, 8000.0]);
    let half = 0.5 * (inertia * (stiff[0] + stiff[1]) + 300.0_f64.powi(2)) / (inertia * inertia);
    let root = (half * half - stiff[0] * stiff[1] / (inertia * inertia)).sqrt();
    for square in [half + root, half - root] {
        let near = found
            .modes
            .iter()
            .any(|mode| (mode.im / square.sqrt() - 1.0).abs() < 1e-9 && mode.re.abs() < 1e-9);
        assert!(near, "{} among {:?}", square.sqrt(), found.modes);
    }
}

/// Over its speed the frequencies of the same disc meet it: those of its translations and of its twist, and where
/// `(Ip^2 - Id^2) w^4 + Id (ky + kz) w^2 - ky kz = 0` a tilt.
#[test]
fn frequencies_of_a_rotor_that_stands_still_are_compared_with_its_speed() {
    let range = Range {
        param: 0,
        from: 0.0,
        to: 100.0,
    };
    let settings = EquilibriumSettings {
        range: Some(range),
        ..EquilibriumSettings::default()
    };
    let found = campbell(&standing::Standing::default(), &settings).unwrap();
    let (inertia, stiff) = (0.6_f64, [3000.0, 8000.0]);
    let (more, half) = (1.0 - inertia * inertia, 0.5 * inertia * (stiff[0] + stiff[1]));
    let tilt = ((half * half + more * stiff[0] * stiff[1]).sqrt() - half) / more;
    let exact = [50.0, 1000.0 / 10.0, 2000.0 / 10.0, 4000.0 / 10.0, tilt].map(f64::sqrt);
    let mut met: Vec<f64> = found
        .crossings
        .iter()
        .filter(|crossing| crossing.order == 1)
        .map(|crossing| crossing.key)
        .collect();
    met.sort_by(f64::total_cmp);
    assert_eq!(met.len(), exact.len(), "{met:?} {exact:?}");
    for (met, exact) in met.iter().zip(exact) {
        assert!((met / exact - 1.0).abs() < 1e-6, "{met} {exact}");
    }
    assert!(found.spins.iter().all(|&spin| spin == 0.0) && found.excitations == found.keys);
}
