//! Bushings with cross terms, angles and coupling: films, pedestals and foundations in closed form, shafts in shafts.

use rncf::app::{EquilibriumSettings, RunSettings, modes, run, static_equilibria};
use rncf::{AnyModel, Options};

rncf::model! {
    /// A disc on a film whose coefficients are a table over the speed, on a pedestal that has a mass.
    pub model Film {
        param speed = 150 rad/s;
        table film {
            at = speed; speed = [0, 100, 200, 400] rad/s;
            k = [1, 2, 5, 9] kN/m; c = [10, 20, 15, 5] N*s/m; cross = [0, 100, 400, 1500] N/m;
        }
        rigid disc { mass = 2 kg; inertia = [0.02, 0.02, 0.03] kg*m^2; }
        rigid foot { mass = 5 kg; }
        spring oil = bushing(disc, foot, stiffness = [[film.k(speed), film.cross(speed), 0], [-film.cross(speed), film.k(speed), 0], [0, 0, film.k(speed)]],
            damping = [film.c(speed), film.c(speed), 0]);
        spring ground = bushing(foot, inertial, stiffness = [30, 30, 30] kN/m);
        output x = disc.x;
        output foot = foot.x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A rigid tower whose foundation resists shifts and turns at once, as soil does at the mudline.
    pub model Tower {
        rigid tower { mass = 600 [t]; inertia = [3e8, 3e8, 1e6] kg*m^2; center = [0, 0, 40] m; }
        spring soil = bushing(tower, inertial, stiffness = [2.57, 2.57, 10] GN/m, rotational_stiffness = [263, 263, 100] GN*m/rad,
            coupling = [[0, -22.5, 0], [22.5, 0, 0], [0, 0, 0]] GN/rad);
        output top = tower.at([0, 0, 80] m).x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A shaft in a hollow one: the bearing between them turns with a section.
    pub model Spools {
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 10 mm);
        section pipe = tube(radius = 30 mm, thickness = 5 mm);
        body low { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 6 * beam(round, steel); }
        body high { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 6 * beam(pipe, steel); }
        joint inner = clamp(low.start, inertial);
        joint outer = clamp(high.start, inertial);
        spring bearing = bushing(low.end, high.end, stiffness = [0, 100, 200] kN/m, rotational_stiffness = [0, 1, 2] kN*m/rad);
        output y = low.end.y;
        output other = high.end.y;
        run { t_end = 0.1 s; every = 1 ms; }
    }
}

/// Rates of growth and frequencies of modes that swing, sorted by frequency.
fn swinging(model: &dyn AnyModel, count: usize) -> Vec<[f64; 2]> {
    let settings = EquilibriumSettings {
        count,
        ..EquilibriumSettings::default()
    };
    let found = modes(model, &settings).unwrap().modes;
    found
        .iter()
        .filter(|mode| mode.im > 0.0)
        .map(|mode| [mode.re, mode.im])
        .collect()
}

fn near(found: f64, want: f64, size: f64, tolerance: f64) {
    assert!((found - want).abs() <= tolerance * size, "{found} for {want}");
}

/// Eigenvalues of the 4 by 4 matrices (numpy): k = 3500 N/m, 250 N/m across, c = 17.5 N s/m at 150 rad/s.
#[test]
fn a_film_between_a_disc_and_a_pedestal() {
    let found = swinging(&Film::default(), 12);
    let want = [
        [-1.9885575, 38.85158601],
        [0.0, 38.90754],
        [-4.31824677, 39.05126648],
        [-3.47934205, 82.8346171],
        [-2.46385367, 83.03429757],
        [0.0, 83.28387],
    ];
    assert_eq!(found.len(), want.len());
    for ([re, im], [growth, frequency]) in found.iter().zip(want) {
        near(*re, growth, frequency, 1e-7);
        near(*im, frequency, frequency, 1e-7);
    }
}

/// `[m, m c; m c, I + m c^2]` and `[k, -K; -K, R]` in closed form.
#[test]
fn a_tower_on_soil() {
    let found = swinging(&Tower::default(), 6);
    let (m, c, inertia): (f64, f64, f64) = (6e5, 40.0, 3e8);
    let (k, coupling, turning) = (2.57e9, -22.5e9, 263e9);
    // det(K - w^2 M) = 0
    let a = m * inertia;
    let b = -(m * turning + k * (inertia + m * c * c) - 2.0 * coupling * m * c);
    let root = f64::sqrt(b * b - 4.0 * a * (k * turning - coupling * coupling));
    let [low, high] = [-1.0, 1.0_f64].map(|sign| ((-b + sign * root) / (2.0 * a)).sqrt());
    for (at, want) in [(0, low), (1, low), (3, high), (4, high)] {
        near(found[at][1], want, want, 1e-9);
        near(found[at][0], 0.0, want, 1e-9);
    }
    near(found[2][1], (10e9_f64 / m).sqrt(), 129.0, 1e-9);
    near(found[5][1], (100e9_f64 / 1e6).sqrt(), 316.0, 1e-9);
}

/// Timoshenko beams of 40 elements (numpy), one plane at a time.
#[test]
fn a_shaft_in_a_hollow_one() {
    let found = swinging(&Spools::default(), 6);
    let want = [260.11587, 275.00316, 421.09768, 441.21320, 766.20883, 892.10185];
    for ([re, im], want) in found.iter().zip(want) {
        near(*im, want, want, 1e-3);
        near(*re, 0.0, want, 1e-9);
    }
}

rncf::model! {
    /// Weights on springs of all kinds, which show what they exert.
    pub model Shown {
        param mass = 2 kg;
        const g = 9.81 m/s^2;
        rigid hung { mass = mass; inertia = [1, 1, 1] g*m^2; origin = [0, 0, -1] m; }
        joint guide = prismatic(inertial, hung, axis = z);
        spring coil = linear(inertial.at([0, 0, 0] m), hung.at([0, 0, 0] m), stiffness = 500 N/m, damping = 3 N*s/m, length = 1 m);
        rigid arm { mass = mass; inertia = [1, 1, 1] g*m^2; origin = [2, 0, 0] m; center = [0.5, 0, 0] m; }
        joint hinge = revolute(inertial.at([2, 0, 0] m), arm, axis = y);
        spring back = torsional(hinge, stiffness = 200 N*m/rad, damping = 2 N*m*s/rad);
        spring curl = torsional_law(hinge, moment = 30 [N*m/rad] * angle^3);
        rigid block { mass = mass; inertia = [1, 1, 1] g*m^2; origin = [4, 0, 0] m; }
        spring mount = bushing(block.at([0.1, 0, 0] m), inertial.at([4.1, 0, 0] m), stiffness = [700, 800, 900] N/m, damping = [7, 8, 9] N*s/m,
            rotational_stiffness = [20, 30, 40] N*m/rad, rotational_damping = [0.2, 0.3, 0.4] N*m*s/rad);
        spring rope = law(inertial.at([6, 0, 1] m), block, force = 0.1 [N/m] * length + 0.2 [N*s/m] * rate);
        load weight = gravity([0, 0, -g]);
        load feedback = force(hung, [0 N, 0 N, 1e-3 * coil.force]);
        output coil_force = coil.force;
        output coil_length = coil.length;
        output momentum_of_hung = hung.momentum.z;
        output back_moment = back.moment + curl.moment;
        output back_angle = back.angle;
        output spin_of_arm = arm.angular_momentum(about = arm.at([0, 0, 0] m)).y;
        output arm_at = arm.center;
        output mount_force = mount.force;
        output mount_moment = mount.moment;
        output mount_up: N = mount.force.z;
        output momentum_of_block = block.momentum;
        output rope_force = rope.force;
        output rope_rate = rope.rate;
        output rope_length = rope.length;
        output block_at = block;
        run { t_end = 0.5 s; every = 1 ms; }
    }
}

/// What springs show balances the momentum that bodies gain, by differences of rows.
#[test]
fn springs_show_what_they_exert() {
    let options = Options {
        rtol: 1e-9,
        ..Options::default()
    };
    let found = run(
        &Shown::default(),
        &RunSettings {
            options,
            ..RunSettings::default()
        },
    )
    .unwrap();
    let column = |name: &str| {
        let index = found.history.columns.iter().position(|column| column.name == name);
        let index = index.unwrap_or_else(|| panic!("{name}: {:?}", found.history.columns));
        found.history.column(index).collect::<Vec<f64>>()
    };
    let h = 1e-3;
    let rate = |values: &[f64], row: usize| {
        (8.0 * (values[row + 1] - values[row - 1]) - (values[row + 2] - values[row - 2])) / (12.0 * h)
    };
    let weight = 2.0 * 9.81;
    let close = |name: &str, found: f64, exact: f64, size: f64| {
        assert!((found - exact).abs() < 2e-5 * size, "{name}: {found} for {exact}");
    };
    let [coil, gained] = ["coil_force", "momentum_of_hung"].map(column);
    let [moment, spin, arm] = ["back_moment", "spin_of_arm", "arm_at.x"].map(column);
    let [pull, length, speed] = ["rope_force", "rope_length", "rope_rate"].map(column);
    let [x, z] = ["block_at.x", "block_at.z"].map(column);
    let [mount, up, block] = ["mount_force.z", "mount_up", "momentum_of_block.z"].map(column);
    assert_eq!(mount, up);
    for row in 2..coil.len() - 2 {
        close("coil", coil[row] * 1.001 - weight, rate(&gained, row), weight);
        // About y what lies ahead turns down.
        close(
            "back",
            -moment[row] + weight * (arm[row] - 2.0),
            rate(&spin, row),
            weight,
        );
        close("rope", pull[row], 0.1 * length[row] + 0.2 * speed[row], 1.0);
        close("rope's rate", speed[row], rate(&length, row), 1.0);
        let along = (1.0 - z[row]) / f64::hypot(6.0 - x[row], 1.0 - z[row]);
        close(
            "mount",
            mount[row] - weight + pull[row] * along,
            rate(&block, row),
            weight,
        );
    }
}

rncf::model! {
    /// An arm on a bearing that resists tilts alike, carried about its axis to an angle and pushed over.
    pub model Opened {
        param opened = 90 deg;
        motion opening(t) = if t < 1 s { opened * (3 * (t / 1 [s])^2 - 2 * (t / 1 [s])^3) } else { opened };
        frame hub = rotating(axis = x, angle = opening(t));
        rigid arm { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
        joint carrier = universal(hub.at([0, 0, 0] m), arm.at([0, 0, 0] m), axis = y, cross = z);
        spring bearing = bushing(arm, inertial.at([0, 0, 0] m), rotational_stiffness = [0, 1000, 1000] N*m/rad,
            rotational_damping = [0, 20, 20] N*m*s/rad);
        load push = moment(arm, [0, 1, 0] N*m);
        output lean: mrad = -arm.ex.z;
        output aside: mrad = arm.ex.y;
        output moment = bearing.moment;
        run { t_end = 3 s; every = 10 ms; }
    }
}

rncf::model! {
    /// A fast rotor in bearings that resist tilts, from a push across its axis.
    pub model Gyroscope {
        param push = 0.5 rad/s;
        rigid rotor { mass = 100 kg; inertia = [2, 3, 3] kg*m^2; angular_velocity = [250 [rad/s], push, 0 [rad/s]]; }
        spring mount = bushing(rotor, inertial.at([0, 0, 0] m), stiffness = [40, 40, 40] MN/m,
            rotational_stiffness = [0, 5, 5] MN*m/rad);
        output axis = rotor.ex;
        output moment = mount.moment;
        run { t_end = 0.1 s; every = 0.1 ms; }
    }
}

/// However far it is opened: 1 N m over 1000 N m/rad, and the moment told is the one that acts.
#[test]
fn a_bearing_resists_tilts_alike_however_far_it_turns() {
    for opened in [0.0, 45.0, 90.0, 170.0f64] {
        let model = Opened {
            opened: opened.to_radians(),
        };
        let found = run(&model, &RunSettings::default()).unwrap();
        let last = |column: usize| found.history.column(column).last().unwrap();
        let lean = 1e3 * 1e-3f64.sin();
        assert!(
            (last(0) - lean).abs() < 1e-6 && last(1).abs() < 1e-6,
            "{opened}: {} {}",
            last(0),
            last(1)
        );
        let moment = [2, 3, 4].map(last);
        assert!(
            (moment[1] + 1.0).abs() < 1e-6 && moment[0].abs() + moment[2].abs() < 1e-6,
            "{opened}: {moment:?}"
        );
    }
}

/// `J z'' - i C w z' + k z = 0` with the tilts about y and z as a complex number; and modes of the same rotor, which whirls on circles.
#[test]
fn a_spinning_rotor_on_a_bearing_that_resists_tilts() {
    let found = run(
        &Gyroscope::default(),
        &RunSettings {
            options: Options {
                rtol: 1e-9,
                ..Options::default()
            },
            ..RunSettings::default()
        },
    )
    .unwrap();
    let [along, across, stiffness, spin] = [2.0, 3.0, 5e6, 250.0f64];
    let root = ((along * spin) * (along * spin) + 4.0 * across * stiffness).sqrt();
    let [fast, slow] = [1.0, -1.0].map(|sign| (along * spin + sign * root) / (2.0 * across));
    let size = 0.5 / (fast - slow);
    let mut error = 0.0f64;
    for (row, t) in found.history.keys.iter().enumerate() {
        let [y, z] = [1, 2].map(|column| found.history.column(column).nth(row).unwrap());
        // z = size (e^(i fast t) - e^(i slow t)) / i, with y' = 0.5 rad/s about y at the start.
        let about_y = size * ((fast * t).sin() - (slow * t).sin());
        let about_z = -size * ((fast * t).cos() - (slow * t).cos());
        error = error.max((y - about_z).hypot(z + about_y) / (2.0 * size));
    }
    println!("{error:.1e} {:?} {:?}", found.warnings, found.agreement);
    assert!(
        error < 1e-3 && found.warnings.is_empty(),
        "{error:.1e} {:?}",
        found.warnings
    );
    let modes = modes(&Gyroscope { push: 0.0 }, &EquilibriumSettings::default()).unwrap();
    let whirls: Vec<f64> = modes
        .modes
        .iter()
        .flat_map(|mode| mode.inertial_frequencies(modes.spin))
        .collect();
    for wanted in [fast, -slow] {
        assert!(
            whirls.iter().any(|own| (own / wanted - 1.0).abs() < 1e-6),
            "{wanted}: {whirls:?}"
        );
    }
}

rncf::model! {
    /// A rotor on a film that is known up to 400 rad/s.
    pub model FilmRotor {
        param speed = 150 rad/s;
        table film { at = speed; speed = [0, 400] rad/s; k = [1, 9] kN/m; }
        let across = film.k(speed);
        frame turning = rotating(axis = z, angle = speed * t);
        rigid rotor in turning { mass = 2 kg; inertia = [0.02, 0.02, 0.03] kg*m^2; }
        spring oil = bushing(rotor, inertial, stiffness = [across, across, 1 [kN/m]], rotational_stiffness = [1, 1, 0] kN*m/rad);
        output x = rotor.x;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// Beyond the rows not the film acts otherwise as the rotor turns.
#[test]
fn a_speed_beyond_the_rows_of_a_table_is_told_as_that() {
    let beyond = |speed: f64| modes(&FilmRotor { speed }, &EquilibriumSettings::default());
    assert!(beyond(400.0).is_ok());
    let told = beyond(500.0).unwrap_err().to_string();
    assert!(told.contains("`oil` is not finite") && told.contains("table"), "{told}");
    // At rest as well.
    let still = Film { speed: 500.0 };
    let told = modes(&still, &EquilibriumSettings::default()).unwrap_err().to_string();
    assert!(told.contains("`oil` is not finite"), "{told}");
}

rncf::model! {
    /// A body on a ball joint, which a coil holds that is as stiff about every axis.
    pub model Round {
        param mx = 0 N*m;
        param my = 0 N*m;
        param mz = 1 N*m;
        rigid ball { mass = 1 kg; inertia = [0.01, 0.01, 0.01] kg*m^2; }
        joint pivot = spherical(ball, inertial);
        spring coil = bushing(ball, inertial, rotational_stiffness = [2, 2, 2] N*m/rad);
        load push = moment(ball, [mx, my, mz]);
        output cosine = (ball.ex.x + ball.ey.y + ball.ez.z - 1) / 2;
        run { t_end = 2 s; every = 10 ms; }
    }
}

const OBLIQUE: [[f64; 3]; 3] = [[0.0, 0.0, 1.0], [0.8, 0.0, 0.6], [0.48, 0.6, -0.64]];

/// `M / k` about every axis, of small turns and large ones.
#[test]
fn equal_stiffness_about_all_axes_is_that_about_any() {
    for axis in OBLIQUE {
        for size in [0.4, 1.0, 4.0] {
            let [mx, my, mz] = axis.map(|part| size * part);
            let found = static_equilibria(&Round { mx, my, mz }, &EquilibriumSettings::default()).unwrap();
            let cosine = found.history.column(0).last().unwrap();
            near(cosine.acos(), 0.5 * size, 0.5 * size, 1e-6);
        }
    }
}

/// Beyond half a turn the rotation vector turns back.
#[test]
fn half_a_turn_about_an_oblique_axis_is_told() {
    for axis in OBLIQUE {
        let [mx, my, mz] = axis.map(|part| 10.0 * part);
        let error = run(&Round { mx, my, mz }, &RunSettings::default())
            .unwrap_err()
            .to_string();
        assert!(error.contains("half a turn") && error.contains("`coil`"), "{error}");
    }
}
