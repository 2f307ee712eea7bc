//! What is read off the modes of rotors and blades: tables of ROSS 2.3.0 (Timoshenko shaft of 48 elements, rigid discs), rigid
//! hinged blades in closed form.

use rncf::Model;
use rncf::app::{Campbell, Crossing, EquilibriumSettings, Inertial, Judging, Range, SeenMode, campbell, modes, steady};
use rncf::equilibrium::Spin;
use rncf::modes::{Motion, Whirl};
use rncf::space::Vector;

rncf::model! {
    /// Shaft of 1.5 m and 50 mm with discs at its thirds, on elastic bearings (ROSS, rotor_example).
    pub model Shaft {
        param speed = 400 rad/s;
        param elements: count = 6;
        param stiffness = 1e6 N/m;
        param damping = 0 N*s/m;
        /// Of the first disc.
        param eccentricity = 0 m;
        param mass = 32.589728 kg;
        param polar = 0.32956362 kg*m^2;
        param diametral = 0.17808928 kg*m^2;
        material steel { density = 7810 kg/m^3; young = 211 GPa; poisson = 0.29926108; }
        section round = circle(radius = 25 mm);
        frame rotor = rotating(axis = x, angle = speed * t);
        body shaft in rotor { spatial; line from [0, 0, 0] m to [1.5, 0, 0] m; mesh elements * beam(round, steel); }
        joint motor = hold(shaft.start.twist);
        joint thrust = hold(shaft.start.x);
        fixture first on shaft.at(0.5 m) {
            mass = 32.589728 kg; center = [0 m, eccentricity, 0 m];
            inertia = [0.32956362, 0.17808928, 0.17808928] kg*m^2;
        }
        fixture second on shaft.at(1 m) { mass = mass; inertia = [polar, diametral, diametral]; }
        spring left = bushing(shaft.start, inertial.at([0, 0, 0] m),
            stiffness = [0 [N/m], stiffness, stiffness], damping = [0 [N*s/m], damping, damping]);
        spring right = bushing(shaft.end, inertial.at([1.5, 0, 0] m),
            stiffness = [0 [N/m], stiffness, stiffness], damping = [0 [N*s/m], damping, damping]);
        output y = shaft.at(0.5 m).y;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// Two rigid blades of one hub at once, one on a flap hinge, one on a lag hinge; nothing but turning makes them stiff.
    pub model Hinged {
        param speed = 30 rad/s;
        param offset = 0.3 m;
        param length = 5 m;
        param mass = 10 kg;
        frame hub = rotating(axis = z, angle = speed * t);
        rigid flapping in hub {
            mass = mass; origin = [offset, 0 m, 0 m]; center = [length / 2, 0 m, 0 m];
            inertia = [1e-6 * mass * length^2, mass * length^2 / 12, mass * length^2 / 12];
        }
        rigid lagging in hub {
            mass = mass; origin = [offset, 0 m, 0 m]; center = [length / 2, 0 m, 0 m];
            inertia = [1e-6 * mass * length^2, mass * length^2 / 12, mass * length^2 / 12];
        }
        joint flap = revolute(hub.at([offset, 0 m, 0 m]), flapping, axis = y);
        joint lag = revolute(hub.at([offset, 0 m, 0 m]), lagging, axis = z);
        output angle = flap.angle;
        output other_angle = lag.angle;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A slender blade that hangs on a flap hinge, under its weight along the axis: it has no stiffness at rest.
    pub model Blade {
        param speed = 30 rad/s;
        param weight = 9.81 m/s^2;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
        section strip = rectangle(y = 60 mm, z = 8 mm);
        frame hub = rotating(axis = z, angle = speed * t);
        body hinged in hub { spatial; line from [0.3, 0, 0] m to [6, 0, 0] m; mesh 4 * beam(strip, alloy); }
        joint hinge = revolute(hub, hinged.start, axis = y);
        load pull = gravity([0 [m/s^2], 0 [m/s^2], -weight]);
        output tip = hinged.end.z;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A blade that flaps and lags alike at rest.
    pub model Square {
        param speed = 30 rad/s;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
        section square = rectangle(y = 30 mm, z = 30 mm);
        frame hub = rotating(axis = z, angle = speed * t);
        body clamped in hub { spatial; line from [0.3, 0, 0] m to [6, 0, 0] m; mesh 4 * beam(square, alloy); }
        joint root = clamp(clamped.start, hub);
        output tip = clamped.end.z;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// Over the first param, which is the speed.
fn over_speed<M: Model>(model: &M, [from, to]: [f64; 2], steps: u32, count: usize) -> Campbell {
    let range = Some(Range { param: 0, from, to });
    let settings = EquilibriumSettings {
        range,
        steps,
        count,
        ..EquilibriumSettings::default()
    };
    campbell(model, &settings).unwrap()
}

/// Critical speeds and backward critical speeds of ROSS, rad/s.
const FORWARD: [f64; 2] = [96.49729, 306.5343];
const BACKWARD: [f64; 2] = [96.07855, 286.9506];

#[test]
fn critical_speeds_of_a_shaft_balanced_or_not() {
    for (eccentricity, steps) in [(0.0, 9), (50e-6, 18)] {
        let shaft = Shaft {
            eccentricity,
            ..Shaft::default()
        };
        let found = over_speed(&shaft, [5.0, 400.0], steps, 4);
        assert!(found.is_round);
        println!("{:?}", found.critical);
        assert_eq!(found.critical.len(), 2, "{:?}", found.critical);
        for (critical, exact) in found.critical.iter().zip(FORWARD) {
            // The mesh of 6 elements alone is off by 1.3e-4.
            let error = (critical.value - exact).abs();
            assert!(critical.change == 2 && critical.within < 5e-5 * exact, "{critical:?}");
            assert!(error < 1.3e-4 * exact + critical.within, "{critical:?} {exact}");
            assert_eq!(critical.open.is_some(), eccentricity > 0.0);
        }
        let whirls: Vec<(Whirl, f64)> = found
            .crossings
            .iter()
            .filter(|crossing| crossing.order == 1)
            .map(|one| (one.whirl, one.key))
            .collect();
        let backward: Vec<f64> = whirls
            .iter()
            .filter(|(whirl, _)| *whirl == Whirl::Backward)
            .map(|(_, key)| *key)
            .collect();
        assert_eq!(backward.len(), 2, "{whirls:?}");
        for (value, exact) in backward.iter().zip(BACKWARD) {
            assert!((value / exact - 1.0).abs() < 2e-4, "{value} {exact}");
        }
    }
}

rncf::model! {
    /// A clamped column of 1 m under its load.
    pub model Column {
        param load = 0.01 kN;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section strip = rectangle(y = 5 mm, z = 20 mm);
        body column { planar xy; line from [0, 0, 0] m to [0, 1, 0] m; mesh 8 * beam(strip, steel); }
        joint foot = clamp(column.start, inertial);
        load weight = force(column.end, [0 N, -load, 0 N]);
        output x = column.end.x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// Critical values of a param in any unit are compared in that unit: 8 elements are right to 1e-4.
#[test]
fn critical_values_in_units_of_their_own_are_judged() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 200.0,
        }),
        steps: 8,
        count: 4,
        judged: Judging::Affordable,
        ..EquilibriumSettings::default()
    };
    let found = campbell(&Column::default(), &settings).unwrap();
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    let [critical] = found.critical[..] else {
        panic!("{:?}", found.critical)
    };
    // Euler's load, less the shear.
    let bending = 210e9 * 0.02 * 0.005f64.powi(3) / 12.0;
    let euler = (0.5 * std::f64::consts::PI).powi(2) * bending / 1e3;
    let told = found.agreement.expect("compared");
    println!("{} kN for {euler} kN, {told}", critical.value);
    assert!(
        (critical.value / euler - 1.0).abs() < 1e-3 && told.contains("critical values by"),
        "{told}"
    );
}

/// What finer meshes make of critical speeds and frequencies is told: the energy in sections that swell beside discs says nothing of either.
#[test]
fn meshes_of_diagrams_are_judged() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 5.0,
            to: 400.0,
        }),
        steps: 9,
        count: 4,
        judged: Judging::Affordable,
        ..EquilibriumSettings::default()
    };
    let found = campbell(&Shaft::default(), &settings).unwrap();
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    let told = found.agreement.expect("compared");
    let values = told
        .split("critical values by ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next());
    let part: f64 = values
        .and_then(|number| number.parse().ok())
        .unwrap_or_else(|| panic!("{told}"));
    let errors = found
        .critical
        .iter()
        .zip(FORWARD)
        .map(|(own, exact)| own.value / exact - 1.0);
    let error = errors.map(f64::abs).fold(0.0, f64::max);
    println!("{error:.1e}, {told}");
    assert!((0.5..2.0).contains(&(part / error)), "{error:.1e}, {told}");
    // Elements of half a metre.
    let coarse = Shaft {
        elements: 3,
        ..Shaft::default()
    };
    let notes = campbell(&coarse, &settings).unwrap().warnings;
    println!("{notes:?}");
    let is_told = notes
        .iter()
        .any(|note| note.contains("frequencies at speed = 400 rad/s differ by"));
    assert!(is_told, "{notes:?}");
}

#[test]
fn critical_speeds_beyond_800_unknowns() {
    let shaft = Shaft {
        elements: 72,
        ..Shaft::default()
    };
    let found = over_speed(&shaft, [90.0, 100.0], 1, 2);
    assert!(found.unknowns > 800);
    let [critical] = found.critical[..] else {
        panic!("{:?}", found.critical)
    };
    println!("{critical:?}");
    assert!(
        critical.change == 2 && (critical.value / FORWARD[0] - 1.0).abs() < 1e-5,
        "{critical:?}"
    );
}

#[test]
fn a_round_shaft_is_round_though_it_twists() {
    // Case B at 400 rad/s.
    let exact = [
        (95.39519, Whirl::Backward),
        (97.13544, Whirl::Forward),
        (283.1670, Whirl::Backward),
        (309.5558, Whirl::Forward),
        (826.703, Whirl::Forward),
    ];
    let found = modes(&Shaft::default(), &EquilibriumSettings::default()).unwrap();
    assert!(found.is_round);
    for (frequency, whirl) in exact {
        let near = |mode: &&SeenMode| (mode.inertial_frequencies(400.0)[0] / frequency - 1.0).abs() < 5e-4;
        let mode = found.modes.iter().find(near).unwrap();
        assert_eq!(mode.inertial_whirl(400.0), whirl);
    }
    for (mode, composition) in found.modes.iter().zip(&found.compositions) {
        let (motion, part) = composition.motions[0];
        assert!(part > 0.999, "{composition:?}");
        let expected = match mode.inertial(400.0) {
            Inertial::Whirl(_) => Motion::Lateral,
            _ => Motion::Torsion,
        };
        assert_eq!(motion, expected);
    }
}

rncf::model! {
    /// A blade of a hub at 80 rad/s, declared by an axis beside its mass.
    model Beside {
        param y = 0 m;
        param z = 0 m;
        const speed = 80 rad/s;
        section s {
            EA = 1 MN; GAy = 3e5 N; GAz = 2e5 N; GJ = 30 N*m^2; EIy = 50 N*m^2; EIz = 80 N*m^2;
            mass = 0.5 kg/m; inertia_y = 1e-4 kg*m; inertia_z = 3e-4 kg*m;
            tension_y = y; tension_z = z; shear_y = y; shear_z = z; mass_y = y; mass_z = z;
        }
        frame hub = rotating(axis = z, angle = speed * t);
        body blade in hub {
            spatial;
            line from [0.1 m, 0.05 m - y, -0.03 m - z] to [1.6 m, 0.05 m - y, -0.03 m - z];
            section_y [0, 1, 0];
            mesh 12 * beam(s);
        }
        joint root = clamp(blade.start, hub);
        output tip = blade.end.z;
    }
}

/// What moves in a mode is told of the mass: the axis by which a body is declared may lie beside it.
#[test]
fn modes_do_not_depend_on_the_axis_that_a_body_is_declared_by() {
    let [on, beside] =
        [[0.0, 0.0], [0.05, -0.03]].map(|[y, z]| modes(&Beside { y, z }, &EquilibriumSettings::default()).unwrap());
    for number in 0..6 {
        let [one, other] = [&on, &beside].map(|found| (&found.modes[number], &found.compositions[number]));
        let frequencies = [one.0, other.0].map(|mode| mode.inertial_frequencies(80.0));
        println!("{frequencies:?} {:?} {:?}", one.1.motions, other.1.motions);
        assert_eq!(
            frequencies[0].len(),
            frequencies[1].len(),
            "mode {number}: {frequencies:?}"
        );
        for (one, other) in frequencies[0].iter().zip(&frequencies[1]) {
            assert!((one / other - 1.0).abs() < 5e-3, "mode {number}: {frequencies:?}");
        }
        let [(motion, part), (same, equal)] = [one.1, other.1].map(|composition| composition.motions[0]);
        assert!(
            motion == same && (part - equal).abs() < 0.02,
            "mode {number}: {part} and {equal} of {motion:?}"
        );
    }
}

/// By its unbalance of 50 mm the motor's shaft is bent, and a shaft all the same.
#[test]
fn a_bent_shaft_has_no_flap() {
    let found = modes(&rncf_models::Motor::default(), &EquilibriumSettings::default()).unwrap();
    for composition in &found.compositions {
        let own = |motion: &Motion| matches!(motion, Motion::Lateral | Motion::Torsion | Motion::Axial);
        assert!(
            composition.motions.iter().all(|(motion, _)| own(motion)),
            "{composition:?}"
        );
    }
}

/// A blade on a loose hinge has no stiffness at rest, and no critical speed next to it.
#[test]
fn what_turning_makes_stiff_is_not_critical_at_rest() {
    let found = over_speed(&Hinged::default(), [0.0, 20.0], 2, 8);
    assert!(found.critical.is_empty(), "{:?}", found.critical);
}

#[test]
fn decrements_are_those_of_the_inertial_frame() {
    // Case 5.9.5 at 4000 rpm: frequency, real part, logarithmic decrement.
    let exact = [
        (85.96571, -4.08307, 0.298429),
        (88.41460, -4.74172, 0.336970),
        (263.7820, -74.0968, 1.76496),
        (318.2244, -78.8036, 1.55594),
    ];
    let speed = 4000.0 * std::f64::consts::PI / 30.0;
    let shaft = Shaft {
        speed,
        damping: 3000.0,
        mass: 51.525261,
        polar: 0.80508220,
        diametral: 0.42358058,
        ..Shaft::default()
    };
    let found = modes(&shaft, &EquilibriumSettings::default()).unwrap();
    for (frequency, re, decrement) in exact {
        let near = |mode: &&SeenMode| (mode.inertial_frequencies(speed)[0] / frequency - 1.0).abs() < 2e-3;
        let mode = found.modes.iter().find(near).unwrap();
        let told = mode.logarithmic_decrements(speed)[0].unwrap();
        let ratio = mode.inertial_damping_ratios(speed)[0].unwrap();
        println!("{frequency}: {told} {ratio} {:?}", mode.damping_ratio());
        assert!((mode.re / re - 1.0).abs() < 4e-3 && (told / decrement - 1.0).abs() < 4e-3);
        assert!((ratio / -(re / f64::hypot(re, frequency)) - 1.0).abs() < 4e-3);
    }
}

#[test]
fn rigid_blades_on_hinges_are_followed_over_the_speed() {
    for (from, to) in [(20.0, 40.0), (40.0, 20.0)] {
        let found = over_speed(&Hinged::default(), [from, to], 4, 8);
        let stiffening: f64 = 1.5 * 0.3 / 5.0;
        assert_eq!((found.keys.len(), found.tracks.len()), (5, 2));
        for (row, speed) in found.spins.iter().enumerate() {
            let mut seen: Vec<f64> = found.row(row).map(|mode| mode.im).collect();
            seen.sort_by(f64::total_cmp);
            let exact = [stiffening.sqrt() * speed, (1.0 + stiffening).sqrt() * speed];
            for (seen, exact) in seen.iter().zip(exact) {
                // The blades have a millionth of inertia about their axes.
                assert!((seen / exact - 1.0).abs() < 2e-6, "{speed}: {seen} {exact}");
            }
        }
        // The lag hinge is the softer one.
        let mut kinds: Vec<(f64, Motion, String)> = found
            .tracks
            .iter()
            .zip(&found.compositions)
            .map(|(track, moves)| {
                let most = moves.bodies.iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
                (track[0].unwrap().im, moves.motions[0].0, most.0.clone())
            })
            .collect();
        kinds.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert_eq!((kinds[0].1, kinds[0].2.as_str()), (Motion::Lag, "lagging"));
        assert_eq!((kinds[1].1, kinds[1].2.as_str()), (Motion::Flap, "flapping"));
    }
}

#[test]
fn a_hinged_blade_starts_at_the_speed_asked_for() {
    let blade = Blade::default();
    let found = over_speed(&blade, [20.0, 40.0], 4, 8);
    assert!(
        found.warnings.iter().all(|text| !text.contains("no equilibrium")),
        "{:?}",
        found.warnings
    );
    // The root turns freely about y, the strip hardly bends: flap of a rigid uniform blade.
    let stiffening: f64 = 1.5 * 0.3 / 5.7;
    for (row, speed) in found.spins.iter().enumerate() {
        let exact = (1.0 + stiffening).sqrt() * speed;
        let nearest = found
            .row(row)
            .map(|mode| (mode.im / exact - 1.0).abs())
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 2e-3, "{speed} {nearest}");
    }
    // The droop of a string, which a slender blade nearly is: T z' = m g (R - x), T = m w^2 (R^2 - x^2) / 2.
    let result = steady(
        &blade,
        &EquilibriumSettings {
            range: Some(Range {
                param: 0,
                from: 30.0,
                to: 40.0,
            }),
            steps: 2,
            ..EquilibriumSettings::default()
        },
    )
    .unwrap();
    let droop = -2.0 * 9.81 / 900.0 * (12.0_f64 / 6.3).ln();
    let tip = result.history.column(0).next().unwrap();
    assert!((tip / droop - 1.0).abs() < 3e-3, "{tip} {droop}");
    // Without a range, too, and from rest on where it must be.
    let whole = steady(
        &blade,
        &EquilibriumSettings {
            steps: 4,
            ..EquilibriumSettings::default()
        },
    )
    .unwrap();
    assert_eq!(whole.history.keys.last(), Some(&30.0));
    // At rest it hangs down, and swings out with the spin: g cos L / 2 = w^2 sin (e L / 2 + cos L^2 / 3), while the angle is near a right one.
    let (mut seen, keys) = (0, &whole.history.keys);
    for (&spin, z) in keys
        .iter()
        .zip(whole.history.column(0))
        .filter(|(spin, _)| **spin < 1.0)
    {
        let square = spin * spin;
        let cosine: f64 = square * 0.3 / 2.0 / (9.81 / 2.0 - square * 5.7 / 3.0);
        let rigid = -5.7 * (1.0 - cosine * cosine).sqrt();
        // The strip bends a little.
        assert!((z / rigid - 1.0).abs() < 3e-5, "{spin}: {z} {rigid}");
        seen += 1;
    }
    assert!(seen > 2, "{keys:?}");
    assert!((whole.history.column(0).last().unwrap() / droop - 1.0).abs() < 3e-3);
    let from_rest = over_speed(&blade, [0.0, 40.0], 4, 8);
    assert_eq!(from_rest.keys.last(), Some(&40.0));
    assert!(from_rest.critical.is_empty(), "{:?}", from_rest.critical);
    assert!(modes(&blade, &EquilibriumSettings::default()).is_ok());
}

#[test]
fn modes_that_are_equal_at_rest_are_followed_from_there() {
    for steps in [3, 5] {
        let found = over_speed(&Square::default(), [0.0, 40.0], steps, 8);
        assert_eq!(found.tracks.len(), 8);
        for (track, moves) in found.tracks.iter().zip(&found.compositions) {
            assert!(track.iter().all(Option::is_some), "{track:?}");
            assert!(moves.motions[0].1 > 0.999, "{moves:?}");
        }
        assert!(found.crossings.iter().all(|crossing| crossing.within < 1e-4));
        // Southwell: flap^2 - lag^2 = spin^2, for each pair that was one at rest.
        let last = found.keys.len() - 1;
        let of = |motion: Motion, row: usize| -> Vec<f64> {
            let tracks = found.tracks.iter().zip(&found.compositions);
            let own = tracks.filter(|(_, moves)| moves.motions[0].0 == motion);
            let mut values: Vec<f64> = own.map(|(track, _)| track[row].unwrap().im).collect();
            values.sort_by(f64::total_cmp);
            values
        };
        for row in [0, last] {
            let spin = found.spins[row];
            let (flap, lag) = (of(Motion::Flap, row), of(Motion::Lag, row));
            assert_eq!((flap.len(), lag.len()), (4, 4));
            for (flap, lag) in flap.iter().zip(lag) {
                assert!(
                    ((flap * flap - lag * lag) - spin * spin).abs() < 2e-3 * flap * flap,
                    "{flap} {lag}"
                );
            }
        }
    }
}

rncf::model! {
    /// A flexible arm on a hub that turns freely in a bearing.
    pub model Arm {
        param speed = 3 rad/s;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; }
        section wire { area = 1e-4 m^2; second_moment = 1e-10 m^4; }
        rigid hub { plane xy; mass = 10 kg; inertia = 1 kg*m^2; speed = speed; }
        joint bearing = revolute(inertial.at([0, 0, 0] m), hub.at([0, 0, 0] m));
        body arm in hub { planar xy; line from [0.2, 0, 0] m to [1.2, 0, 0] m; mesh 4 * cable(wire, alloy); }
        joint root = clamp(arm.start, hub);
        output tip = arm.end.y;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A hub on equal springs with two blades on lag hinges, all of which turn freely.
    pub model Pair {
        param speed = 1 rad/s;
        rigid hub { plane xy; mass = 8 kg; inertia = 10 kg*m^2; speed = speed; }
        spring soft = bushing(hub, inertial, stiffness = [100, 100, 0] N/m);
        for k in 0..2 {
            rigid blade[k] { plane xy; mass = 1 kg; inertia = 0.05 kg*m^2; center = [1, 0, 0] m; origin = [0.2 m * cos(k * pi), 0 m, 0]; angle = k * pi; speed = speed; velocity = [0 [m/s], 0.2 m * speed * cos(k * pi), 0 [m/s]]; }
            joint lag[k] = revolute(hub.at([0.2 m * cos(k * pi), 0 m, 0]), blade[k].at([0, 0, 0] m));
            spring coil[k] = torsional(lag[k], stiffness = 2 N*m/rad, angle = k * pi);
        }
        output angle = blade[0].angle;
        output x = hub.x;
        run { t_end = 10 s; every = 50 ms; }
    }
}

/// The free turn has no stiffness, and the sign of its round-off is no critical speed. Along the blades nothing but the springs holds 10 kg; across
/// them the hinges yield: `k - (m + 2 m_b) w^2 - 2 (m_b l w^2)^2 / K = 0` with the stiffness `K = 2 N m + m_b l e w^2` of a hinge.
#[test]
fn what_turns_freely_has_no_critical_speeds_of_its_own() {
    for steps in [7, 29] {
        assert!(over_speed(&Arm::default(), [1.0, 30.0], steps, 4).critical.is_empty());
        let found = over_speed(&Pair::default(), [1.0, 8.0], steps, 4).critical;
        let values: Vec<f64> = found.iter().map(|critical| critical.value).collect();
        println!("{values:?}");
        assert!(
            found.len() == 2 && (values[1] - 10_f64.sqrt()).abs() < 1e-6,
            "{values:?}"
        );
        let square = values[0] * values[0];
        let rest = 100.0 - 10.0 * square - 2.0 * square * square / (2.0 + 0.2 * square);
        assert!(rest.abs() < 1e-4, "{rest}");
    }
}

rncf::model! {
    /// A hub with two arms that nothing holds.
    pub model Loose {
        param speed = 25 rad/s;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; }
        section wire { area = 1e-4 m^2; second_moment = 1e-9 m^4; }
        rigid hub { plane xy; mass = 10 kg; inertia = 1 kg*m^2; speed = speed; }
        body right in hub { planar xy; line from [0.2, 0, 0] m to [1.2, 0, 0] m; mesh 4 * cable(wire, alloy); }
        body left in hub { planar xy; line from [-0.2, 0, 0] m to [-1.2, 0, 0] m; mesh 4 * cable(wire, alloy); }
        joint right_root = clamp(right.start, hub);
        joint left_root = clamp(left.start, hub);
        output tip = right.end.y;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A mass that is damped critically along two axes.
    pub model Settling {
        param damping = 2 N*s/m;
        rigid mass { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
        spring turn = torsional(mass, stiffness = 9 N*m/rad);
        spring mount = bushing(mass, inertial, stiffness = [1, 1, 0] N/m, damping = [damping, damping, 0 [N*s/m]]);
        output x = mass.x;
        run { t_end = 10 s; every = 0.1 s; }
    }
}

/// An eigenvalue that is there twice with one motion is as exact as any other: the drift `i w` of what nothing holds, seen from turning axes,
/// and what is damped critically. Round-off decided whether `modes` failed.
#[test]
fn motions_that_are_there_twice_are_found() {
    for speed in [15.84375, 20.0, 25.0, 30.0] {
        let found = modes(&Loose { speed }, &EquilibriumSettings::default()).unwrap().modes;
        let drift = found.iter().filter(|mode| (mode.im - speed).abs() < 1e-6 * speed);
        assert!(drift.count() >= 1, "{found:?}");
        assert!(found.iter().all(|mode| mode.re.abs() < 1e-5), "{found:?}");
    }
    let found = modes(&Settling::default(), &EquilibriumSettings::default())
        .unwrap()
        .modes;
    let settling = found
        .iter()
        .filter(|mode| mode.im == 0.0 && (mode.re + 1.0).abs() < 1e-9);
    assert_eq!(settling.count(), 2, "{found:?}");
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 4.0,
        }),
        steps: 4,
        ..EquilibriumSettings::default()
    };
    assert!(campbell(&Settling::default(), &settings).is_ok());
}

rncf::model! {
    /// A rigid disc on an isotropic bearing.
    pub model DampedDisc {
        param speed = 300 rad/s;
        param damping = 2 kN*s/m;
        param seal = 0 N/m;
        frame rotor = rotating(axis = z, angle = speed * t);
        rigid disc in rotor { plane xy; mass = 20 kg; inertia = 0.2 kg*m^2; }
        spring motor = bushing(disc, rotor, rotational_stiffness = [0, 0, 100] MN*m/rad);
        spring bearing = bushing(disc, inertial, stiffness = [[2 [MN/m], seal, 0 [N/m]], [-seal, 2 [MN/m], 0 [N/m]], [0 [N/m], 0 [N/m], 0 [N/m]]],
            damping = [damping, damping, 0 [N*s/m]]);
        output x = disc.x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// Without damping the forward whirl and the spin meet where the stiffness in the turning frame vanishes, `sqrt(k / m)`. With damping no frequency is zero
/// there: the whirl, at `sqrt(k / m - (c / 2 m)^2)` for an observer who stands, crosses the spin below it.
#[test]
fn damped_rotors_cross_their_spin_below_the_undamped_critical_speed() {
    let undamped = (2e6f64 / 20.0).sqrt();
    for (damping, steps) in [(0.0, 20), (100.0, 20), (2e3, 20), (2e3, 200), (9e3, 20)] {
        let model = DampedDisc {
            damping,
            ..DampedDisc::default()
        };
        let found = over_speed(&model, [100.0, 600.0], steps, 2);
        let part = damping / 40.0 / undamped;
        let [critical] = found.critical[..] else {
            panic!("{damping} {steps}: {:?}", found.critical)
        };
        assert!((critical.value / undamped - 1.0).abs() < 1e-6, "{critical:?}");
        assert_eq!(found.standing, [part < 0.01], "{damping} {steps}");
        let forward = |crossing: &&Crossing| crossing.whirl == Whirl::Forward && crossing.order == 1;
        let crossings: Vec<&Crossing> = found.crossings.iter().filter(forward).collect();
        println!("{damping} {steps}: {crossings:?}");
        if part < 0.01 {
            assert!(crossings.is_empty(), "told twice: {crossings:?}");
            continue;
        }
        let exact = undamped * (1.0 - part * part).sqrt();
        let [crossing] = crossings[..] else {
            panic!("{damping} {steps}: {crossings:?}")
        };
        let away = (crossing.key - exact).abs();
        assert!(
            away < 1e-4 * exact && away <= crossing.within + 1e-6 * exact,
            "{crossing:?}, {exact}"
        );
    }
}

/// Cross-coupled stiffness, as of seals, comes from no energy: at rest the whole stiffness tells where the disc diverges, and that counts at rest alone.
#[test]
fn a_way_that_begins_at_rest_finds_the_same_critical_speeds() {
    let model = DampedDisc {
        seal: 0.05e6,
        ..DampedDisc::default()
    };
    let undamped = (2e6f64 / 20.0).sqrt();
    for range in [[0.0, 600.0], [1.0, 600.0], [600.0, 0.0]] {
        let found = over_speed(&model, range, 10, 2);
        let [critical] = found.critical[..] else {
            panic!("{range:?}: {:?}", found.critical)
        };
        assert!(
            (critical.value / undamped - 1.0).abs() < 1e-6,
            "{range:?}: {critical:?}"
        );
    }
}

rncf::model! {
    /// A disc that a drive turns, with a bar on it.
    pub model DrivenDisc {
        param speed = 50 rad/s;
        param start = 50 rad/s;
        rigid disc { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; speed = start; }
        joint bearing = revolute(inertial, disc);
        joint motor = drive(bearing.angle, speed * t);
        rigid bar { plane xy; mass = 1 kg; inertia = 0.01 kg*m^2; origin = [0.2, 0, 0] m; velocity = [0 [m/s], 0.2 m * start / 1 rad, 0 [m/s]]; speed = start; }
        spring mount = bushing(bar, disc.at([0.2, 0, 0] m), stiffness = [1, 1, 0] MN/m, rotational_stiffness = [0, 0, 1] kN*m/rad);
        output x = bar.in(disc).x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// A drive turns at each speed, and the start at one of them: a table with that one row, "no critical speed in this range", was all that was told.
#[test]
fn a_drive_that_turns_otherwise_than_the_start_is_told() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 10.0,
            to: 50.0,
        }),
        steps: 4,
        count: 2,
        ..EquilibriumSettings::default()
    };
    let told = campbell(&DrivenDisc::default(), &settings).unwrap_err().to_string();
    assert!(
        told.contains("at speed = 10")
            && told.contains("joint `motor` (drive) moves at t = 1 s, and not as the system turns, with 50 rad/s"),
        "{told}"
    );
    assert!(told.contains("start it with the rate of what drives it"), "{told}");
    let fits = modes(&DrivenDisc::default(), &EquilibriumSettings::default()).unwrap();
    assert_eq!(fits.spin, 50.0);
}

rncf::model! {
    /// A platform that flies freely, with a momentum wheel.
    pub model MomentumWheel {
        param speed = 10 rad/s;
        rigid platform { mass = 100 kg; inertia = [30, 40, 50] kg*m^2; }
        rigid wheel { mass = 10 kg; inertia = [20, 10, 10] kg*m^2; angular_velocity = [speed, 0 [rad/s], 0 [rad/s]]; }
        joint bearing = revolute(platform.at([0, 0, 0] m), wheel.at([0, 0, 0] m), axis = x);
        joint motor = drive(bearing.angle, speed * t);
        output rate = platform.angular_velocity;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// At rest the wheel would stand still, too, and its momentum be left out.
#[test]
fn a_wheel_that_a_drive_turns_is_not_left_out_of_modes_at_rest() {
    let settings = EquilibriumSettings {
        spin: Some(Spin {
            velocity: Vector::zeros(),
            point: Vector::zeros(),
        }),
        ..EquilibriumSettings::default()
    };
    let told = modes(&MomentumWheel::default(), &settings).unwrap_err().to_string();
    assert!(
        told.contains("joint `motor` (drive) moves at t = 1 s, and nothing turns with it"),
        "{told}"
    );
    assert!(modes(&MomentumWheel { speed: 0.0 }, &settings).is_ok());
}
