//! Equilibria that are lost, beside those that only seem to be: forces that come from no energy, and what turns.

use rncf::equilibrium::Spin;
use rncf::space::Vector;

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
    /// A column that flies on a thrust along its end, with its weight against that.
    pub model Rocket {
        param thrust = 50 N;
        section s { EA = 1e6 N; EI = 1 N*m^2; mass = 1 kg/m; }
        frame f = free(plane = xy);
        body b in f { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 8 * cable(s); chord; }
        load push = follower(b.start, [thrust, 0 N]);
        load weight = gravity([-thrust / 1 kg, 0, 0]);
        output x = total.center_of_mass.x;
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

/// A rocket that leans is driven aside, and held by nothing: that value of the stiffness is zero at every thrust, and its round-off made 8 to 19 critical
/// values that moved with the steps. It flutters at 11.12 pi^2 EI/L^2 (Beal 1965, a free column under a thrust at its end).
#[test]
fn what_is_driven_along_a_free_motion_has_no_critical_values() {
    for (from, to, steps) in [(0.0, 130.0, 13), (1.0, 130.0, 13), (100.0, 120.0, 10)] {
        let settings = EquilibriumSettings {
            range: Some(Range { param: 0, from, to }),
            ..over(0, to, steps)
        };
        let found = campbell(&Rocket::default(), &settings).unwrap();
        assert!(found.critical.is_empty(), "{from}: {:?}", found.critical);
        let [onset] = &found.onsets[..] else {
            panic!("{from}: {:?}", found.onsets)
        };
        assert!((onset.key / 109.75 - 1.0).abs() < 2e-3, "{from}: {onset:?}");
    }
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
/// was told as the first. With many unknowns negative directions were not counted: 31 N "became positive again".
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
    for (load, directions) in [(2.0, 0), (60.0, 2)] {
        let model = Pressed { load, n: 120 };
        let found = static_equilibria(&model, &EquilibriumSettings::default()).unwrap();
        assert_eq!(found.critical.len(), directions, "{:?}", found.critical);
        for (critical, odd) in found.critical.iter().zip([1.0, 3.0]) {
            let exact = euler * odd * odd / load;
            assert!(
                (critical.value - exact).abs() < 1e-5 * exact,
                "{critical:?} for {exact}"
            );
            assert_eq!(critical.change, 1);
        }
        let told = found.warnings.iter().any(|note| note.contains("is unstable"));
        assert_eq!(told, directions > 0, "{load}: {:?}", found.warnings);
    }
}

/// The lowest modes of a column under 145 times Euler's load decay or vibrate, and what grows fastest was not among them: "no mode grows of these 1".
#[test]
fn what_grows_is_told_with_few_modes() {
    for n in [4, 8, 40] {
        let grown = |count| {
            let model = Pressed { load: 500.0, n };
            let found = modes(
                &model,
                &EquilibriumSettings {
                    count,
                    ..EquilibriumSettings::default()
                },
            )
            .unwrap();
            found.modes.iter().map(|mode| mode.re).fold(f64::NEG_INFINITY, f64::max)
        };
        let all = grown(24);
        assert!(all > 900.0, "{n}: {all}");
        for count in [1, 2, 8] {
            let few = grown(count);
            assert!((few / all - 1.0).abs() < 1e-9, "{n}, {count}: {few} {all}");
        }
    }
}

rncf::model! {
    /// Two equal masses on springs that are pushed aside as [`Pushed`] is: both stiffnesses are singular at q = k.
    pub model BothPushed {
        param q = 1 N/m;
        for i in 0..2 {
            rigid bob[i] { mass = 1 kg; }
            spring bed[i] = bushing(bob[i], inertial.at([0, 0, 0] m), stiffness = [300, 100, 200] N/m);
            load push[i] = force(bob[i], [-q * bob[i].y, q * bob[i].y, 0]);
            output y[i] = bob[i].y;
        }
    }
}

rncf::model! {
    /// A ring under pressure that stays square to it: it buckles into an ellipse at 3 EI/R^3, in two directions at once.
    pub model Ring {
        param p = 1 N/m;
        const R = 0.7 m;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section wire { area = 80 mm^2; second_moment = 400 mm^4; }
        frame hoop = free(plane = zx);
        body ring in hoop {
            planar zx;
            arc from [0.7, 0, 0] m direction [0, 0, 1] radius R angle -360 deg;
            mesh 32 * cable(wire, steel, bending = exact);
            mean_axes;
        }
        joint close = merge(ring.start, ring.end);
        load press = distributed(ring, [0, -p, 0], in = section);
        output x = ring.at(pi * R / 2).x;
    }
}

/// Of two directions that become critical together the parity tells nothing: "no frequency reaches zero" stood beside an equilibrium that is unstable.
#[test]
fn what_diverges_in_two_directions_at_once_is_found() {
    let one = |found: &[rncf::modes::Critical]| {
        let [critical] = found[..] else { panic!("{found:?}") };
        assert_eq!(critical.change, 2);
        critical.value
    };
    let way = over(0, 150.0, 31);
    let of = [
        campbell(&BothPushed::default(), &way).unwrap().critical,
        static_equilibria(&BothPushed::default(), &way).unwrap().critical,
    ];
    for critical in &of {
        assert!((one(critical) - 100.0).abs() < 1e-4);
    }
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 600.0,
            to: 800.0,
        }),
        steps: 3,
        ..EquilibriumSettings::default()
    };
    let found = static_equilibria(&Ring::default(), &settings).unwrap();
    let exact = 3.0 * 210e9 * 400e-12 / 0.7_f64.powi(3);
    let told = one(&found.critical);
    assert!((told - exact).abs() < 5e-3 * exact, "{told} for {exact}");
}

rncf::model! {
    /// A mast that turns about its foot, under a load on its top along its axis.
    pub model Mast {
        param w = 6 rad/s;
        param top = 300 N;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar = rectangle(y = 10 mm, z = 20 mm);
        frame hub = rotating(axis = z, angle = w * t);
        body mast in hub { spatial; line from [0.2, 0, 0] m to [0.2, 0, 1] m; section_y [1, 0, 0]; mesh 4 * beam(bar, steel); }
        joint foot = clamp(mast.start, hub);
        load push = force(mast.end, [0, 0, -top]);
        output force = foot.force.z;
        output x: mm = mast.end.x - 0.2 m;
    }
}

/// Loads stood along the way from rest as parts of themselves: with the square of the spin.
#[test]
fn loads_are_whole_along_the_spin() {
    let mast = Mast::default();
    let at_end = |w: f64| modes(&Mast { w, ..Mast::default() }, &EquilibriumSettings::default()).unwrap();
    let found = campbell(
        &mast,
        &EquilibriumSettings {
            steps: 4,
            ..EquilibriumSettings::default()
        },
    )
    .unwrap();
    assert_eq!(found.keys, [0.0, 1.5, 3.0, 4.5, 6.0]);
    for (row, &w) in found.keys.iter().enumerate() {
        let lowest = at_end(w).modes[0].im;
        let told = found.row(row).map(|mode| mode.im).fold(f64::INFINITY, f64::min);
        assert!((told / lowest - 1.0).abs() < 1e-9, "{w}: {told} {lowest}");
    }
    let found = steady(&mast, &EquilibriumSettings::default()).unwrap();
    for force in found.history.column(0) {
        assert!((force.abs() - 300.0).abs() < 1e-6, "{force}");
    }
    // A rotation that is given is not that of the hub: its modes stood under another spin.
    let spun = |speed: f64| {
        let spin = Some(Spin {
            velocity: Vector::new(0.0, 0.0, speed),
            point: Vector::zeros(),
        });
        modes(
            &mast,
            &EquilibriumSettings {
                spin,
                ..EquilibriumSettings::default()
            },
        )
    };
    let told = spun(3.0).unwrap_err().to_string();
    assert!(told.contains("frame `hub` turns in a prescribed way, with 6"), "{told}");
    assert!(spun(6.0).is_ok());
}

rncf::model! {
    /// A shaft between two bearings that hold its ends along the axis, too: it stiffens as it bends. Its disc has an unbalance.
    pub model Jeffcott {
        param speed = 150 rad/s;
        param unbalance = 1 mm;
        material steel { density = 7800 kg/m^3; young = 200 GPa; poisson = 0.3; }
        section bar = circle(radius = 10 mm);
        frame rotor = rotating(axis = z, angle = speed * t);
        body shaft in rotor { spatial; line from [0, 0, 0] m to [0, 0, 0.9] m; section_y [0, 1, 0]; mesh 4 * beam(bar, steel); }
        joint a = hold(shaft.start.x);
        joint b = hold(shaft.start.y);
        joint c = hold(shaft.start.z);
        joint d = hold(shaft.start.twist);
        joint e = hold(shaft.end.x);
        joint f = hold(shaft.end.y);
        joint g = hold(shaft.end.z);
        fixture disc on shaft.at(0.45 m) { mass = 12 kg; center = [0 m, unbalance, 0 m]; }
        output deflection: mm = norm(shaft.at(0.45 m).position - [0, 0, 0.45] m);
    }
}

/// Along the spin the deflection grows and grows beyond the critical speed, as on a rope that is swung; beyond it a range begins with the small one.
#[test]
fn an_equilibrium_nearer_to_the_undeformed_shape_is_told() {
    let note = |found: &rncf::app::Equilibria| {
        let notes = found.warnings.iter();
        notes
            .filter(|note| note.contains("is nearer to the undeformed shape"))
            .count()
    };
    let along = steady(&Jeffcott::default(), &EquilibriumSettings::default()).unwrap();
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 130.0,
            to: 150.0,
        }),
        steps: 4,
        ..EquilibriumSettings::default()
    };
    let beyond = steady(&Jeffcott::default(), &settings).unwrap();
    let last = |found: &rncf::app::Equilibria| found.history.column(0).last().unwrap();
    assert!(
        last(&along) > 10.0 * last(&beyond),
        "{} {}",
        last(&along),
        last(&beyond)
    );
    assert_eq!([note(&along), note(&beyond)], [1, 0], "{:?}", along.warnings);
    // A diagram that follows the same way has no critical speed of small vibrations, and says so; one of a smaller unbalance has it.
    let diagram = |unbalance: f64| {
        let settings = EquilibriumSettings {
            range: Some(Range {
                param: 0,
                from: 0.0,
                to: 150.0,
            }),
            steps: 12,
            count: 2,
            judged: Judging::Affordable,
            ..EquilibriumSettings::default()
        };
        let model = Jeffcott {
            unbalance,
            ..Jeffcott::default()
        };
        campbell(&model, &settings).unwrap()
    };
    let [large, none] = [1e-3, 0.0].map(diagram);
    let told = large
        .warnings
        .iter()
        .filter(|note| note.contains("nearer to the undeformed shape"));
    assert_eq!(
        (large.critical.len(), large.is_near, told.count()),
        (0, false, 1),
        "{:?}",
        large.warnings
    );
    assert!(
        !large.warnings.iter().any(|note| note.contains("too coarse")),
        "{:?}",
        large.warnings
    );
    assert!(
        none.is_near && none.critical.len() == 1 && none.warnings.is_empty(),
        "{:?}",
        none.warnings
    );
    // A shaft without mass but for the disc: e w^2 / (k / m - w^2), with its own mass a little more.
    let slow = Jeffcott {
        speed: 50.0,
        ..Jeffcott::default()
    };
    let below = steady(&slow, &EquilibriumSettings::default()).unwrap();
    assert_eq!(note(&below), 0);
}

rncf::model! {
    /// Forty equal bars, hinged at both ends, that stand under their weight: every value of the stiffness is there forty times.
    pub model Bars {
        param pull = 100 m/s^2;
        param count: count = 40;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section rod { area = 1e-4 m^2; second_moment = 1e-9 m^4; }
        for i in 0..count {
            body bar[i] { planar xy; line from [0 m, i * 1 m, 0 m] to [1 m, i * 1 m, 0 m]; mesh 4 * cable(rod, steel); }
            joint foot[i] = pin(bar[i].start, inertial);
            joint guide[i] = hold(bar[i].end.y);
        }
        load weight = gravity([-pull, 0 [m/s^2], 0 [m/s^2]]);
        output shortening: um = bar[0].end.x - 1 m;
    }
}

/// Directions of equal stiffness are counted by the signature, where a search for values did not end: "not known", and 1.5 s a step.
#[test]
fn equal_bars_buckle_together() {
    let settings = EquilibriumSettings {
        steps: 5,
        ..EquilibriumSettings::default()
    };
    // q L^3 = 18.5687 E I (Timoshenko and Gere)
    let buckling = 18.5687 * 210.0 / 0.785;
    for (pull, is_beyond) in [(1000.0, false), (6000.0, true)] {
        let found = static_equilibria(
            &Bars {
                pull,
                ..Bars::default()
            },
            &settings,
        )
        .unwrap();
        let unknown = found.warnings.iter().find(|note| note.contains("not known"));
        assert!(unknown.is_none(), "{unknown:?}");
        assert_eq!(found.critical.len(), usize::from(is_beyond), "{:?}", found.critical);
        for critical in &found.critical {
            assert!((critical.value * pull / buckling - 1.0).abs() < 1e-3, "{critical:?}");
        }
    }
}

rncf::model! {
    /// A rigid blade on hinges with thrust: at rest the thrust turns it upwards, and along the spin it stays there.
    pub model Raised {
        param speed = 30 rad/s;
        frame hub = rotating(axis = z, angle = speed * t);
        rigid knuckle in hub { mass = 0.01 kg; inertia = [1e-5, 1e-5, 1e-5] kg*m^2; origin = [0.3, 0, 0] m; }
        rigid blade in hub { mass = 10 kg; inertia = [0.02, 7.5, 7.52] kg*m^2; center = [1.5, 0, 0] m; origin = [0.3, 0, 0] m; }
        joint flap = revolute(hub.at([0.3, 0, 0] m), knuckle, axis = y);
        joint lag = revolute(knuckle, blade, axis = z);
        spring damper = torsional(lag, damping = 20 N*m*s/rad, stiffness = 0 N*m/rad);
        load lift = force(blade.at([2, 0, 0] m), [0, 0, 200] N, in = hub);
        output z = blade.at([3, 0, 0] m).in(hub).z;
        output f = flap.force.in(hub);
    }
}

/// The blade comes down as the spin grows, and no step is so long that it falls to the other side.
/// Its flap angle `b` has the moments `400 cos b = speed^2 sin b (4.5 + 30 cos b)`.
#[test]
fn a_raised_blade_comes_down_with_the_spin() {
    for steps in [8, 32, 100] {
        let settings = EquilibriumSettings {
            steps,
            ..EquilibriumSettings::default()
        };
        let found = steady(&Raised::default(), &settings).unwrap();
        assert!(found.warnings.is_empty(), "{steps} steps: {:?}", found.warnings);
        for (&spin, z) in found.history.keys.iter().zip(found.history.column(0)) {
            let [sine, cosine] = [z / 3.0, (1.0 - z * z / 9.0).max(0.0).sqrt()];
            let off = 400.0 * cosine - spin * spin * sine * (4.5 + 30.0 * cosine);
            assert!(
                z > 0.0 && off.abs() < 1e-4,
                "{steps} steps, {spin} rad/s: {z} m, {off} N m"
            );
        }
    }
}

/// A component of the reaction that is round-off in both equilibria differs by more parts than what anybody sees. The way begins at the
/// blade that hangs, which is none that it would stay at.
#[test]
fn the_other_equilibrium_is_told_by_what_is_there() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 1.0,
            to: 30.0,
        }),
        ..EquilibriumSettings::default()
    };
    let found = steady(&Raised::default(), &settings).unwrap();
    let note = found
        .warnings
        .iter()
        .find(|note| note.contains("is nearer to the undeformed shape"));
    let note = note.unwrap_or_else(|| panic!("{:?}", found.warnings));
    assert!(note.contains("with `z` = ") || note.contains("with `f.x` = "), "{note}");
}
