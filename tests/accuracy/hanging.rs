//! Bodies that hang on ball joints and hinges: what nothing holds is told, and equilibria at rest must not depend on how they start.

use rncf::app::{Equilibria, EquilibriumSettings, static_equilibria};

use super::closed_forms::assert_near;

rncf::model! {
    /// A rod on a ball joint, in a wind.
    pub model Rod {
        param a = 30 deg;
        param b = 20 deg;
        param wind = 0 N/m;
        param n: count = 3;
        const length = 0.6 m;
        material rubber { density = 1300 kg/m^3; young = 100 MPa; poisson = 0.3; }
        section flat = rectangle(y = 30 mm, z = 20 mm);
        body rod {
            spatial;
            line from [0, 0, 0] m to [length * cos(a) * cos(b), length * sin(a) * cos(b), length * sin(b)];
            section_y [0.1, 0.9, 0.3];
            mesh n * beam(flat, rubber);
        }
        joint top = spherical(rod.start, inertial.at([0, 0, 0] m));
        load push = density(rod, [wind, 0, 0]);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = rod.end;
        output reaction = top.force;
    }
}

rncf::model! {
    /// Two rods and a rigid bob, ball joint below ball joint.
    pub model Links {
        material rubber { density = 1300 kg/m^3; young = 100 MPa; poisson = 0.3; }
        section flat = rectangle(y = 30 mm, z = 20 mm);
        body upper { spatial; line from [0, 0, 0] m to [0.5, 0.2, 0.1] m; mesh 2 * beam(flat, rubber); }
        body lower { spatial; line from [0.5, 0.2, 0.1] m to [0.5, 0.7, 0.2] m; mesh 2 * beam(flat, rubber); }
        rigid bob { mass = 1 kg; inertia = [1, 2, 2.5] g*m^2; center = [0.1, 0, 0] m; origin = [0.5, 0.7, 0.2] m; }
        joint top = spherical(upper.start, inertial.at([0, 0, 0] m));
        joint middle = spherical(lower.start, upper.end);
        joint last = spherical(bob, lower.end);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output end = lower.end;
        output center = bob.center;
        output reaction = top.force;
    }
}

/// Weight of a metre of the section, N/m, and its axial stiffness, N.
const WEIGHT: f64 = 1300.0 * 6e-4 * 9.81;
const STIFFNESS: f64 = 1e8 * 6e-4;

fn ending(found: &Equilibria) -> Vec<f64> {
    let columns = 0..found.history.columns.len();
    columns
        .map(|column| found.history.column(column).last().unwrap())
        .collect()
}

fn told<'a>(found: &'a Equilibria, words: &str) -> Vec<&'a String> {
    found.warnings.iter().filter(|text| text.contains(words)).collect()
}

#[test]
fn a_rod_hangs_from_a_ball_joint_wherever_it_starts() {
    let starts = [
        (30.0, 20.0, 3),
        (31.0, 20.0, 3),
        (77.0, -10.0, 2),
        (0.0, 0.0, 1),
        (0.0, 0.0, 3),
        (200.0, 45.0, 2),
        (0.0, -90.0, 3),
    ];
    for (a, b, n) in starts {
        for wind in [0.0, 3.0] {
            let rod = Rod {
                a: f64::to_radians(a),
                b: f64::to_radians(b),
                wind,
                n,
            };
            let found = static_equilibria(&rod, &EquilibriumSettings::default())
                .unwrap_or_else(|error| panic!("{a} {b} {n} {wind}: {error}"));
            let [tip, reaction] = [0, 3].map(|first| [0, 1, 2].map(|axis| ending(&found)[first + axis]));
            // It lies along the load, stretched by half of it.
            let load = f64::hypot(WEIGHT, wind);
            let length = 0.6 * (1.0 + 0.5 * 0.6 * load / STIFFNESS);
            assert_near(-tip[2], length * WEIGHT / load, 1e-7);
            assert!(
                (tip[0] - length * wind / load).abs() < 1e-7,
                "{a} {b} {n} {wind}: {tip:?}"
            );
            assert!(tip[1].abs() < 1e-9, "{a} {b} {n} {wind}: {tip:?}");
            assert_near(reaction[2].abs(), 0.6 * WEIGHT, 1e-9);
            assert!(found.critical.is_empty(), "{a} {b} {n} {wind}: {:?}", found.critical);
            assert_eq!(
                told(&found, "nothing holds body `rod` against turning").len(),
                1,
                "{:?}",
                found.warnings
            );
            assert!(told(&found, "unstable").is_empty(), "{:?}", found.warnings);
        }
    }
}

#[test]
fn a_rod_that_stands_on_a_ball_joint_is_told_to_be_unstable() {
    let rod = Rod {
        a: 0.0,
        b: f64::to_radians(90.0),
        ..Rod::default()
    };
    let found = static_equilibria(&rod, &EquilibriumSettings::default()).unwrap();
    assert_near(ending(&found)[2], 0.6 * (1.0 - 0.5 * 0.6 * WEIGHT / STIFFNESS), 1e-7);
    assert_eq!(told(&found, "unstable: 2 directions").len(), 1, "{:?}", found.warnings);
}

#[test]
fn links_and_a_bob_hang_below_each_other() {
    let found = static_equilibria(&Links {}, &EquilibriumSettings::default()).unwrap();
    let at = ending(&found);
    let lengths = [f64::sqrt(0.25 + 0.04 + 0.01), f64::sqrt(0.25 + 0.01)];
    // Each is stretched by half of its weight and by all below.
    let below = [9.81 + lengths[1] * WEIGHT, 9.81];
    let stretched = [0, 1].map(|link| lengths[link] * (1.0 + (below[link] + 0.5 * lengths[link] * WEIGHT) / STIFFNESS));
    assert_near(-at[2], stretched[0] + stretched[1], 1e-6);
    assert_near(-at[5], stretched[0] + stretched[1] + 0.1, 1e-6);
    assert_near(at[8].abs(), 9.81 + (lengths[0] + lengths[1]) * WEIGHT, 1e-9);
    assert!([0, 1, 3, 4].iter().all(|&place| at[place].abs() < 1e-8), "{at:?}");
    assert!(found.critical.is_empty(), "{:?}", found.critical);
    assert_eq!(told(&found, "nothing holds").len(), 3, "{:?}", found.warnings);
}

rncf::model! {
    /// Beck's column: the force on its top follows it.
    model Beck {
        param force = 1 N;
        material steel { density = 7850 kg/m^3; young = 200 GPa; }
        section bar { area = 1 cm^2; second_moment = 10 mm^4; }
        body column { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 8 * cable(bar, steel); }
        joint foot = clamp(column.start, inertial);
        load thrust = follower(column.end, [-force, 0]);
        output y = column.end.y;
    }
}

/// The stiffness of the straight column stays positive, and it flutters from 20.05 EI/L^2 on (Beck 1952).
#[test]
fn a_column_under_a_force_that_follows_is_told_to_flutter() {
    for (force, is_unstable) in [(20.0, false), (20.1, true), (60.0, true)] {
        // EI = 2 N m^2
        let column = Beck { force: 2.0 * force };
        let found = static_equilibria(&column, &EquilibriumSettings::default()).unwrap();
        let told = told(&found, "forces that come from no energy");
        assert_eq!(told.len(), usize::from(is_unstable), "{force}: {:?}", found.warnings);
    }
}

rncf::model! {
    /// A rod in modes on a carrier that hangs on a ball joint.
    model Carried {
        material rubber { density = 1300 kg/m^3; young = 100 MPa; poisson = 0.3; }
        section flat = rectangle(y = 30 mm, z = 20 mm);
        rigid carrier { mass = 0.2 kg; inertia = [1, 1, 1] g*m^2; }
        body rod in carrier { spatial; line from [0, 0, 0] m to [0.5, 0.2, 0.1] m; mesh 2 * beam(flat, rubber); small(4); }
        joint grip = clamp(rod.start, carrier);
        joint top = spherical(carrier.at([0, 0, 0] m), inertial.at([0, 0, 0] m));
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = rod.end.in(inertial);
        output reaction = top.force;
    }
}

#[test]
fn a_body_in_modes_that_nothing_ties_hangs_and_is_told() {
    let found = static_equilibria(&Carried {}, &EquilibriumSettings::default()).unwrap();
    let row = ending(&found);
    let length = (0.25_f64 + 0.04 + 0.01).sqrt();
    // Straight down; its four lowest modes bend it and do not stretch it.
    assert!(row[0].abs().max(row[1].abs()) < 1e-6 * length, "{row:?}");
    assert_near(row[2], -length, 1e-9);
    assert_near(row[5].abs(), length * WEIGHT + 0.2 * 9.81, 1e-9);
    assert_eq!(told(&found, "nothing holds").len(), 1, "{:?}", found.warnings);
    assert!(found.critical.is_empty(), "{:?}", found.critical);
}

rncf::model! {
    /// A stiff panel on a hinge that leans towards x.
    model Door {
        param thick = 20 mm;
        param n: count = 2;
        material wood { density = 600 kg/m^3; young = 10 GPa; poisson = 0.3; }
        section board = rectangle(y = thick, z = 1 m);
        rigid post { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
        joint hinge = revolute(inertial.at([0, 0, 0] m), post, axis = [0.1, 0, 1]);
        body panel { spatial; line from [0, 0, 0] m to [0, 0.8, 0] m; section_y [1, 0, 0]; mesh n * beam(board, wood); }
        joint screws = weld(post, panel.start);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = panel.end;
        output angle = hinge.angle;
    }
}

/// The panel ends where it hangs lowest, and sags there a little: less than F L^3 / 8 E I.
#[test]
fn a_stiff_panel_swings_to_where_its_hinge_leans() {
    for thick in [0.02, 0.06] {
        let weight = 600.0 * 9.81 * thick * 0.8;
        let sag = weight * 0.1 * 0.8_f64.powi(3) / (8.0 * 10e9 * thick.powi(3) / 12.0);
        for n in [1, 2, 4] {
            let found = static_equilibria(&Door { thick, n }, &EquilibriumSettings::default()).unwrap();
            let row = ending(&found);
            assert_near(row[2], -0.08 / 1.01_f64.sqrt(), 1e-6 + 0.2 * sag / 0.08);
            assert!(row[1].abs() < sag, "{thick} {n}: {row:?}");
            assert!(
                (row[3] + std::f64::consts::FRAC_PI_2).abs() < 2.0 * sag,
                "{thick} {n}: {row:?}"
            );
        }
    }
}

rncf::model! {
    /// The same panel on a vertical hinge, which the wind turns.
    model Vane {
        param wind = 10 N/m;
        material wood { density = 600 kg/m^3; young = 10 GPa; poisson = 0.3; }
        section board = rectangle(y = 20 mm, z = 1 m);
        rigid post { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
        joint hinge = revolute(inertial.at([0, 0, 0] m), post, axis = z);
        body panel { spatial; line from [0, 0, 0] m to [0, 0.8, 0] m; section_y [1, 0, 0]; mesh 2 * beam(board, wood); }
        joint screws = weld(post, panel.start);
        load weight = gravity([0, 0, -9.81] m/s^2);
        load blow = density(panel, [wind, 0, 0]);
        output tip = panel.end;
    }
}

#[test]
fn a_panel_on_a_vertical_hinge_lies_in_the_wind() {
    for wind in [10.0, -3.0, 1000.0] {
        let found = static_equilibria(&Vane { wind }, &EquilibriumSettings::default()).unwrap();
        // The wind pulls it longer: q l^2 / 2 E A.
        assert_near(
            ending(&found)[0],
            f64::signum(wind) * (0.8 + wind.abs() * 0.32 / 2e8),
            1e-9,
        );
        assert!(ending(&found)[1].abs() < 1e-9);
        assert!(told(&found, "nothing holds").is_empty(), "{:?}", found.warnings);
    }
    let found = static_equilibria(&Vane { wind: 0.0 }, &EquilibriumSettings::default()).unwrap();
    assert_eq!(
        told(&found, "nothing holds body `panel` against turning").len(),
        1,
        "{:?}",
        found.warnings
    );
}

rncf::model! {
    /// A mooring line that lies straight between two points as far apart as it is long.
    model Moored {
        param weight = 12 kg/m;
        section rope { EA = 2 MN; EI = 300 N*m^2; mass = weight; }
        body line { planar xy; line from [0, 0, 0] m to [100, 0, 0] m; mesh 40 * cable(rope, axial = engineering, bending = exact); }
        joint left = pin(line.start, inertial);
        joint right = pin(line.end, inertial);
        load down = gravity([0, -9.81, 0] m/s^2);
        output middle = line.at(50 m).y;
        output pull = line.start.axial_force;
    }
}

/// Without tension it has next to no stiffness across, so that no step of its load is short enough. The elastic catenary: `H L/EA + 2 H/w asinh(w L/2H)` is
/// the span, `w L^2/8 EA + H/w (sqrt(1 + (w L/2H)^2) - 1)` the sag.
#[test]
fn a_straight_mooring_line_sags() {
    for weight in [1.0, 12.0, 300.0] {
        let found = static_equilibria(&Moored { weight }, &EquilibriumSettings::default()).unwrap();
        let [sag, pull] = [0, 1].map(|column| found.history.column(column).last().unwrap());
        let (w, length, stiff) = (9.81 * weight, 100.0, 2e6);
        let span = |h: f64| h * length / stiff + 2.0 * h / w * (0.5 * w * length / h).asinh();
        let (mut low, mut high) = (1.0, 1e7);
        for _ in 0..200 {
            let middle = f64::sqrt(low * high);
            if span(middle) > length {
                high = middle
            } else {
                low = middle
            }
        }
        let half = 0.5 * w * length;
        let exact = w * length * length / (8.0 * stiff) + low / w * ((1.0 + (half / low).powi(2)).sqrt() - 1.0);
        println!(
            "{weight} kg/m: {sag} for {} m, {pull} for {} N",
            -exact,
            low.hypot(half)
        );
        assert!((sag / -exact - 1.0).abs() < 2e-4, "{sag} for {} m", -exact);
        assert!((pull / low.hypot(half) - 1.0).abs() < 1e-3, "{pull}");
    }
}

rncf::model! {
    /// A chain of 12 m over a span of about 10 m, which hangs in an arc at first.
    pub model Chain {
        section links { EA = 1e7 N; EI = 0.5 N*m^2; mass = 5 kg/m; }
        const al = 1.0267;
        const r = (6 m) / al;
        body chain {
            planar xy;
            line from [0, 0, 0] m to [12, 0, 0] m;
            mesh 16 * cable(links, axial = engineering, bending = exact);
            initial position [r * (sin(al * (x / 6 [m] - 1) * 1 rad) + sin(al * 1 rad)), r * (cos(al * 1 rad) - cos(al * (x / 6 [m] - 1) * 1 rad)), 0];
        }
        joint left = pin(chain.start, inertial);
        joint right = pin(chain.end, inertial, at = [2 * r * sin(al * 1 rad), 0, 0]);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output sag = chain.at(6 m).y;
        output pull = left.force;
    }
}

/// Its shape does not depend on the load: a hundred-thousandth of the sag was half of what it changes by, and the mesh blamed.
#[test]
fn no_mesh_is_blamed_for_what_loads_hardly_change() {
    let settings = EquilibriumSettings {
        judged: rncf::app::Judging::Affordable,
        ..EquilibriumSettings::default()
    };
    let found = static_equilibria(&Chain {}, &settings).unwrap();
    // Half the span is a asinh(s / a), half the length s; the middle hangs sqrt(a^2 + s^2) - a below the ends.
    let (s, half) = (6.0_f64, 6.0 / 1.0267 * 1.0267_f64.sin());
    let (mut low, mut high) = (0.1_f64, 100.0_f64);
    for _ in 0..200 {
        let a = 0.5 * (low + high);
        if a * (s / a).asinh() < half { low = a } else { high = a }
    }
    let sag = (low * low + s * s).sqrt() - low;
    let own = -ending(&found)[0];
    assert!((own / sag - 1.0).abs() < 3e-4, "{own} {sag}");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}
