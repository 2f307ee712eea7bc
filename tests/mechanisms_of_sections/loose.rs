//! Critical values of what may move freely as a whole, in closed form: motions that nothing holds have no stiffness at any value, and are none.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use rncf::AnyModel;
use rncf::app::{Campbell, EquilibriumSettings, Range, campbell, equilibria, modes};
use rncf::equilibrium::{Kind, Spin};
use rncf::modes::Critical;

rncf::model! {
    /// Two rods on a hinge with a spring, free in a plane, pressed by thrusts along both of them.
    pub model Rods {
        param thrust = 1 N;
        param n = 0;
        rigid a { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; center = [0.5, 0, 0] m; }
        rigid b { plane xy; mass = 2 kg; inertia = 0.2 kg*m^2; center = [0.5, 0, 0] m; origin = [1, 0, 0] m; }
        joint h = revolute(a.at([1, 0, 0] m), b.at([0, 0, 0] m));
        spring s = torsional(h, stiffness = 10 N*m/rad);
        load t0 = force(a.at([0, 0, 0] m), thrust * a.ex);
        load t1 = force(b.at([1, 0, 0] m), -thrust * b.ex - n * thrust * (a.ex - b.ex));
        output y = b.y;
    }
}

rncf::model! {
    /// A free beam pressed by thrusts at both ends that follow it.
    pub model Rolled {
        param thrust = 1 N;
        section bar { EA = 10 MN; EI = 100 N*m^2; mass = 3 kg/m; }
        frame f = free(plane = xy);
        body c in f { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 8 * cable(bar, axial = engineering, bending = exact); chord; }
        load b0 = follower(c.start, thrust);
        load b1 = follower(c.end, -thrust);
        output y = c.at(1 m).y;
    }
}

rncf::model! {
    /// A disc that spins freely on a support.
    pub model Hub {
        param omega = 30 rad/s;
        param c = 400 N*s/m;
        rigid hub { plane xy; mass = 500 kg; inertia = 30 kg*m^2; speed = omega; }
        spring support = bushing(hub, inertial, stiffness = [200, 200, 0] kN/m, damping = [c, c, 0]);
        output x = hub.x;
    }
}

rncf::model! {
    /// An inverted pendulum that a spring holds, on a cart that rolls freely.
    pub model Cart {
        param g = 5 m/s^2;
        rigid cart { plane xy; mass = 3 kg; inertia = 1 kg*m^2; }
        joint rail = prismatic(inertial, cart, axis = x);
        rigid rod { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; center = [0, 1, 0] m; }
        joint pin = revolute(cart.at([0, 0, 0] m), rod.at([0, 0, 0] m));
        spring s = torsional(pin, stiffness = 10 N*m/rad);
        load w = gravity([0, -g, 0]);
        output a: rad = rod.angle;
    }
}

fn along(to: f64, steps: u32) -> EquilibriumSettings {
    EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to,
        }),
        steps,
        ..EquilibriumSettings::default()
    }
}

fn at_rest(model: &dyn AnyModel, to: f64, steps: u32) -> Vec<Critical> {
    let found = equilibria(model, Kind::Static, &along(to, steps), |_| ControlFlow::Continue(())).unwrap();
    found.critical
}

/// They were hundreds, of round-off: where forces follow what bends, to bend is to drift, and values of zero and of the bending are not apart.
#[test]
fn thrusts_that_follow_a_free_body_have_one_critical_value() {
    // Where the trace of M^-1 K is zero: K has one row and column but for motions of the whole.
    for (n, expected) in [(0.0, 290.0 / 7.0), (1.0, 290.0 / 13.0)] {
        let rods = Rods { n, ..Rods::default() };
        for steps in [7, 32, 64] {
            let found = at_rest(&rods, 100.0, steps);
            assert_eq!(found.len(), 1, "{n} {steps} {found:?}");
            let value = found[0].value;
            assert!(
                (value - expected).abs() < 1e-6 * expected,
                "{n} {steps} {value} {expected}"
            );
        }
    }
    let found = at_rest(&Rolled::default(), 1000.0, 32);
    let expected = 4.0 * PI * PI * 100.0 / 4.0;
    assert_eq!(found.len(), 1, "{found:?}");
    assert!((found[0].value / expected - 1.0).abs() < 1e-3, "{found:?} {expected}");
}

fn diagram(model: &dyn AnyModel, to: f64) -> Campbell {
    campbell(model, &along(to, 32)).unwrap()
}

/// `s^2 + (c/m + 2 i w) s + k/m - w^2 + i c w/m` has no root at zero with damping; a second value was told at 20.232 rad/s. Without damping the root is there,
/// and was called one with damping.
#[test]
fn a_rotor_that_spins_freely_is_critical_where_it_is_undamped() {
    for (c, stands) in [(400.0, false), (0.0, true)] {
        let hub = Hub { c, ..Hub::default() };
        let found = diagram(&hub, 40.0);
        let values: Vec<f64> = found.critical.iter().map(|critical| critical.value).collect();
        assert_eq!(
            (values.len(), &found.standing[..]),
            (1, &[stands][..]),
            "{c} {values:?}"
        );
        assert!((values[0] - 20.0).abs() < 1e-5, "{c} {values:?}");
    }
}

/// `static` had it, and the diagram "no critical speed in this range".
#[test]
fn what_rolls_freely_hides_no_critical_value() {
    for values in [
        at_rest(&Cart::default(), 20.0, 32),
        diagram(&Cart::default(), 20.0).critical,
    ] {
        assert_eq!(values.len(), 1, "{values:?}");
        assert!((values[0].value - 10.0).abs() < 1e-5, "{values:?}");
    }
}

rncf::model! {
    /// A missile: a thrust that follows it, and its inertia as a density along its axis.
    pub model Missile {
        param thrust = 100 N;
        section bar { EA = 10 MN; EI = 100 N*m^2; mass = 3 kg/m; }
        frame f = free(plane = xy);
        body c in f { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 12 * cable(bar, axial = engineering, bending = exact); mean_axes; }
        load pushed = force(c.start, [thrust, 0, 0], in = f);
        load carried = density(c, [-thrust / 2 [m], 0, 0]);
        output y = c.end.y;
        output shorter = c.end.x - c.start.x - 2 m;
    }
}

/// Loads that balance each other are not "not balanced" for the round-off of their sum, and a force that is left over is.
#[test]
fn loads_that_balance_each_other_are_balanced() {
    for thrust in [50.0, 100.0, 130.0, 200.0, 1e4] {
        let found = equilibria(
            &Missile { thrust },
            Kind::Static,
            &EquilibriumSettings::default(),
            |_| ControlFlow::Continue(()),
        )
        .unwrap();
        let shorter = found.history.column(1).last().unwrap();
        // The axial force falls along the axis from the thrust to nothing: F L/2 EA.
        assert!(
            (shorter + thrust / 1e7).abs() < 1e-3 * thrust / 1e7,
            "{thrust} {shorter}"
        );
    }
}

rncf::model! {
    /// A platform on springs that carries a rotor on a bearing.
    pub model Gyrostat {
        rigid base { mass = 10 kg; inertia = [1, 1, 1.5] kg*m^2; }
        rigid rotor { mass = 1 kg; inertia = [0.03, 0.03, 0.05] kg*m^2; angular_velocity = [0, 0, 200] rad/s; }
        joint axle = revolute(base.at([0, 0, 0] m), rotor.at([0, 0, 0] m), axis = z);
        spring mount = bushing(base, inertial, stiffness = [1000, 1000, 1000] N/m, rotational_stiffness = [50, 50, 80] N*m/rad);
        output a: rad = base.ez.x;
    }
}

/// Modes of a machine that is stopped say what they leave out.
#[test]
fn modes_of_what_is_stopped_say_so() {
    let settings = EquilibriumSettings {
        spin: Some(Spin::default()),
        ..EquilibriumSettings::default()
    };
    let found = modes(&Gyrostat {}, &settings).unwrap();
    let told = "the 200 rad/s in which it starts are left out";
    assert!(
        found.warnings.iter().any(|note| note.contains(told)),
        "{:?}",
        found.warnings
    );
}

rncf::model! {
    /// A rope with a tool glued to its end, whose centre lies beyond it.
    pub model Glued {
        param offset = 0.2 m;
        section cord { EA = 100 kN; EI = 1 N*m^2; mass = 0.05 kg/m; }
        body rope { planar xy; line from [0, 0, 0] m to [0, -1, 0] m; mesh 8 * cable(cord, axial = engineering, bending = exact); }
        joint hook = clamp(rope.start, inertial);
        fixture tool on rope.end { mass = 50 kg; offset = offset; }
        load g = gravity([0, -9.81, 0] m/s^2);
        output end = rope.end.y;
    }
}

/// The pull of a tool beside the end stretches the slope there by 7 %, and the rope by 0.5 %: it is told, with the cure.
#[test]
fn a_slope_that_a_fixture_stretches_is_told() {
    for (offset, is_told) in [(0.2, true), (0.0, false)] {
        let model = Glued { offset };
        let found = equilibria(&model, Kind::Static, &EquilibriumSettings::default(), |_| {
            ControlFlow::Continue(())
        })
        .unwrap();
        let told = found
            .warnings
            .iter()
            .any(|note| note.contains("sits on the slope of body `rope`"));
        assert_eq!(told, is_told, "{:?}", found.warnings);
    }
}
