//! Equilibria of what motions have turned or shifted far since the start: the assembly is the one that was led there.

use rncf::app::{EquilibriumSettings, History, RunSettings, modes, run, static_equilibria};

rncf::model! {
    /// A gimbal opened by `phi` about x, which resists tilts.
    pub model Gimbal {
        param phi = 135 deg;
        motion opened(t) = if t < 1 s { phi * (3 * (t / 1 [s])^2 - 2 * (t / 1 [s])^3) } else { phi };
        frame hub = rotating(axis = x, angle = opened(t));
        rigid arm { mass = 1 kg; inertia = [1, 2, 3] kg*m^2; }
        joint cross_piece = universal(hub.at([0, 0, 0] m), arm.at([0, 0, 0] m), axis = y, cross = z);
        spring mount = bushing(arm, inertial.at([0, 0, 0] m), rotational_stiffness = [0, 1000, 1000] N*m/rad, rotational_damping = [0, 20, 20] N*m*s/rad);
        load push = moment(arm, [0, 1, 0] N*m);
        output up = arm.ey.y;
        output tilt: rad = -arm.ex.z;
        run { t_end = 2 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A weight on three springs under a trolley that travels.
    pub model Trolley {
        param way = 30 m;
        motion x(t) = if t < 10 s { way * (3 * (t / 10 [s])^2 - 2 * (t / 10 [s])^3) } else { way };
        frame cart = moving(origin = [x(t), 0, 0]);
        rigid weight { mass = 100 kg; inertia = [1, 1, 1] kg*m^2; origin = [0, 0, -2] m; }
        spring left = linear(weight, cart.at([-1, 0, 0] m), stiffness = 10 kN/m, length = 1.8 m);
        spring right = linear(weight, cart.at([1, 0, 0] m), stiffness = 10 kN/m, length = 1.8 m);
        spring back = linear(weight, cart.at([0, 1, 0] m), stiffness = 10 kN/m, length = 1.8 m);
        load weighs = gravity([0, 0, -9.81] m/s^2);
        output place = weight.position;
        run { t_end = 10 s; every = 1 s; }
    }
}

/// The last equilibrium at rest at a time, s.
fn at_rest(model: &dyn rncf::AnyModel, t: f64) -> Vec<f64> {
    let settings = EquilibriumSettings {
        at: Some(t),
        ..EquilibriumSettings::default()
    };
    let found = static_equilibria(model, &settings).unwrap();
    last(&found.history)
}

fn last(history: &History) -> Vec<f64> {
    history.values[history.values.len() - history.columns.len()..].to_vec()
}

/// The conditions of a universal joint hold half a turn away, too; `run` has the assembly that was led there. A bushing that is free about its
/// axis tilts by M/k wherever it has turned to.
#[test]
fn joints_follow_frames_that_turn_far() {
    for phi in [0.0_f64, 45.0, 90.0, 135.0, 170.0] {
        let turn = phi.to_radians();
        let model = Gimbal { phi: turn };
        let found = at_rest(&model, 2.0);
        assert!((found[0] - turn.cos()).abs() < 1e-5, "{phi}: {found:?}");
        assert!((found[1] - 1e-3).abs() < 1e-8, "{phi}: {found:?}");
        let frequencies = modes(&model, &EquilibriumSettings::default()).unwrap();
        assert_eq!(frequencies.modes.len(), 2, "{phi}");
    }
    let moved = run(&Gimbal::default(), &RunSettings::default()).unwrap();
    assert!((last(&moved.history)[0] - 135_f64.to_radians().cos()).abs() < 1e-4);
}

#[test]
fn what_hangs_on_springs_follows_a_trolley() {
    let [here, there] = [0.0, 10.0].map(|t| at_rest(&Trolley::default(), t));
    let shifted = [here[0] + 30.0, here[1], here[2]];
    for (value, expected) in there.iter().zip(shifted) {
        assert!((value - expected).abs() < 1e-9, "{there:?} {shifted:?}");
    }
}

rncf::model! {
    /// A four-bar whose coupler and rocker are flexible and whose crank turns on and on.
    pub model FourBar {
        material alu { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.33; }
        section bar = rectangle(y = 6 mm, z = 25 mm);
        motion th(t) = if t < 1 s { 10 [rad/s^2] * t^2/2 } else { 10 [rad/s]*t - 5 rad };
        frame crank = rotating(axis = z, angle = th(t));
        frame fc = free(plane = xy, origin = [0.1, 0, 0] m, angle = acos(0.4375));
        body coupler in fc { planar xy; line from [0, 0, 0] m to [0.35, 0, 0] m; mesh 4 * cable(bar, alu); chord; }
        frame fr = free(plane = xy, origin = [0.5, 0, 0] m, angle = pi - acos(0.6171875));
        body rocker in fr { planar xy; line from [0, 0, 0] m to [0.4, 0, 0] m; mesh 4 * cable(bar, alu); chord; }
        joint a = revolute(coupler.start, crank.at([0.1, 0, 0] m));
        joint b = revolute(coupler.end, rocker.end);
        joint c = revolute(rocker.start, inertial.at([0.5, 0, 0] m));
        output p = rocker.end.in(inertial).position;
        run { t_end = 2 s; every = 5 ms; }
    }
}

/// Where the rocker's end is at a crank angle, of the circuit that it starts in.
fn rocker_end(angle: f64) -> [f64; 2] {
    let [crank, coupler, rocker, ground] = [0.1, 0.35, 0.4, 0.5];
    let (x, y) = (crank * f64::cos(angle), crank * f64::sin(angle));
    let diagonal = f64::hypot(ground - x, y);
    let along = (coupler * coupler - rocker * rocker + diagonal * diagonal) / (2.0 * diagonal);
    let across = (coupler * coupler - along * along).sqrt();
    let (c, s) = ((ground - x) / diagonal, -y / diagonal);
    [x + along * c - across * s, y + along * s + across * c]
}

#[test]
fn linkages_follow_their_crank_round_and_round() {
    for t in [0.3_f64, 0.38, 0.5, 0.8, 1.0, 2.0] {
        let angle = if t < 1.0 { 5.0 * t * t } else { 10.0 * t - 5.0 };
        let found = at_rest(&FourBar {}, t);
        let expected = rocker_end(angle);
        println!("{t}: {found:?} {expected:?}");
        assert!(f64::hypot(found[0] - expected[0], found[1] - expected[1]) < 1e-7);
    }
}

rncf::model! {
    /// A bar between a wall and a chuck that turns late.
    pub model Twisted {
        param turns = 1;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 5 mm);
        motion turned(t) = if t < 1.7 s { 0 rad } else { 2*pi * turns * (t - 1.7 s) / 0.3 [s] };
        frame chuck = rotating(axis = x, angle = turned(t));
        body bar { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 8 * beam(round, steel); }
        joint wall = clamp(bar.start, inertial);
        joint grip = weld(bar.end, chuck.at([2, 0, 0] m));
        output torque = wall.moment.x;
        output t_end = bar.end;
        run { t_end = 2 s; every = 0.1 s; }
    }
}

/// Whole turns of what holds a body leave no condition violated.
#[test]
fn a_bar_is_twisted_by_whole_turns() {
    for turns in [0.0, 1.0, 2.0] {
        let found = at_rest(&Twisted { turns }, 2.0);
        let polar = std::f64::consts::PI * 5e-3_f64.powi(4) / 2.0;
        let torque = 210e9 / 2.6 * polar * 2.0 * std::f64::consts::PI * turns / 2.0;
        assert!(
            (found[0].abs() - torque).abs() < 2e-3 * torque + 1e-9,
            "{turns}: {found:?} {torque}"
        );
    }
}
