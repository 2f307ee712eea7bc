//! Diagrams of what forces that come from no energy act on: closed forms.

use std::ops::ControlFlow;

use rncf::app::{Campbell, EquilibriumSettings, Range, campbell, equilibria};
use rncf::equilibrium::Kind;

rncf::model! {
    /// A controlled mass on a table that turns; `det K = (5 N/m - m w^2) (a - m w^2) + 12 N^2/m^2` in its axes.
    pub model Controlled {
        param a = 1 N/m;
        param spin = 1 rad/s;
        frame table_top = rotating(axis = z, angle = spin * t);
        rigid p in table_top { plane xy; mass = 1 kg; }
        load control = force(p, [
            -5 [N/m] * p.in(table_top).x + 2 [N/m] * p.in(table_top).y - 3 [N*s/m] * p.in(table_top).velocity.x,
            -6 [N/m] * p.in(table_top).x - a * p.in(table_top).y - 3 [N*s/m] * p.in(table_top).velocity.y,
            0], in = table_top);
        output x = p.in(table_top).x;
    }
}

fn over_a(model: &Controlled, from: f64, to: f64) -> Campbell {
    let settings = EquilibriumSettings {
        range: Some(Range { param: 0, from, to }),
        steps: 7,
        ..EquilibriumSettings::default()
    };
    campbell(model, &settings).unwrap()
}

/// The whole stiffness is singular where a frequency in the turning axes is zero; its symmetric part is elsewhere.
#[test]
fn a_real_root_that_passes_zero_is_found_at_rest_and_on_what_turns() {
    for spin in [0.0, 1.0, 1.5] {
        let square = spin * spin;
        let expected = square - 12.0 / (5.0 - square);
        let model = Controlled {
            spin,
            ..Controlled::default()
        };
        for [from, to] in [[2.0, -5.0], [-5.0, 1.0]] {
            let found = over_a(&model, from, to);
            let values: Vec<f64> = found.critical.iter().map(|critical| critical.value).collect();
            let at: Vec<usize> = (0..values.len()).filter(|&index| found.standing[index]).collect();
            assert_eq!(at.len(), 1, "{spin} {from}: {values:?} {:?}", found.standing);
            assert!((values[at[0]] - expected).abs() < 1e-6, "{spin} {from}: {values:?}");
        }
    }
}

rncf::model! {
    /// Three directions of a mass, one of them a million times as stiff. On the others `K = [1 N/m - a, b; -b, 3 N/m - a]`, of which the values are
    /// `2 N/m - a` plus and minus the root of `1 N^2/m^2 - b^2`.
    pub model Meeting {
        param a = 0 N/m;
        param slope = 0.4;
        let b = 2 [N/m] - slope * a;
        rigid p { mass = 1 kg; }
        load springs = force(p, [
            (a - 1 [N/m]) * p.x - b * p.y,
            b * p.x + (a - 3 [N/m]) * p.y,
            -1 [MN/m] * p.z]);
        output x = p.x;
    }
}

/// A vibration that grows becomes two directions that diverge where its two values meet, below zero: the stiffness is singular nowhere. Where they meet
/// above, one passes zero later.
#[test]
fn values_that_meet_below_zero_are_no_critical_ones() {
    let told = |slope: f64, from: f64, to: f64| -> Vec<(f64, isize)> {
        let model = Meeting {
            slope,
            ..Meeting::default()
        };
        let settings = EquilibriumSettings {
            range: Some(Range { param: 0, from, to }),
            steps: 7,
            ..EquilibriumSettings::default()
        };
        let found = equilibria(&model, Kind::Static, &settings, |_| ControlFlow::Continue(())).unwrap();
        let told = "is unstable: under forces that come from no energy a disturbance grows";
        assert!(
            found.warnings.iter().any(|note| note.contains(told)),
            "{:?}",
            found.warnings
        );
        found
            .critical
            .iter()
            .map(|critical| (critical.value, critical.change))
            .collect()
    };
    assert_eq!(told(0.4, 0.0, 3.5), []);
    assert_eq!(told(0.4, 3.5, 0.0), []);
    // det = 2 a^2 - 8 a + 7, in N/m.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for (from, to) in [(0.0, 3.4), (3.4, 0.0)] {
        let mut found = told(1.0, from, to);
        found.sort_by(|one, other| one.0.total_cmp(&other.0));
        assert_eq!(found.len(), 2, "{found:?}");
        for (found, expected) in found.iter().zip([2.0 - half, 2.0 + half]) {
            assert!(
                (found.0 - expected).abs() < 1e-6 && found.1 == 1,
                "{found:?} {expected}"
            );
        }
    }
}

rncf::model! {
    /// A mass that loads alone hold.
    pub model Carried {
        param a = 1 N/m;
        param b = 2 N/m;
        rigid p { mass = 1 kg; plane xy; }
        load law = force(p, [1 [N] - a * p.x - b * p.y, b * p.x - a * p.y, 0]);
        output x = p.x;
        output y = p.y;
    }
}

/// All parts of these loads hold it at one place, which no way leads to. It was "no equilibrium next to those before, the bodies may buckle" over a
/// range, and was found without one.
#[test]
fn what_loads_alone_hold_has_its_equilibrium() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 1.0,
            to: -1.0,
        }),
        ..EquilibriumSettings::default()
    };
    let found = equilibria(&Carried::default(), Kind::Static, &settings, |_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    // det = a^2 + b^2 is zero nowhere.
    assert_eq!(found.critical, []);
    let last = [0, 1].map(|column| found.history.column(column).last().unwrap());
    assert!(
        (last[0] + 0.2).abs() < 1e-12 && (last[1] - 0.4).abs() < 1e-12,
        "{last:?}"
    );
}

mod damped_inside {
    rncf::model! {
        /// A disc on a shaft with damping that turns, `inside`, and damping that does not; `softens` takes stiffness with the square of the speed.
        pub model Inside {
            param speed = 20 rad/s; param inside = 0.1 N*s/m; param outside = 0.2 N*s/m; param softens = 0 kg; param k = 100 N/m;
            rigid disc { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; }
            constraint turned = disc.angle;
            load shaft = force(disc, [-(k - softens * speed^2) * disc.x, -(k - softens * speed^2) * disc.y, 0]);
            load around = force(disc, [-inside * (disc.velocity.x + speed * disc.y), -inside * (disc.velocity.y - speed * disc.x), 0]);
            load beside = force(disc, [-outside * disc.velocity.x, -outside * disc.velocity.y, 0]);
            output x = disc.x;
            run { t_end = 1 s; every = 0.1 s; }
        }
    }
}
use damped_inside::Inside;

/// The whirl grows beyond `sqrt(k / m) (1 + outside / inside)`, with the frequency `sqrt(k / m)`.
#[test]
fn where_a_whirl_begins_to_grow_is_told() {
    for (from, to) in [(20.0, 41.0), (41.0, 20.0)] {
        let settings = EquilibriumSettings {
            range: Some(Range { param: 0, from, to }),
            ..EquilibriumSettings::default()
        };
        let found = campbell(&Inside::default(), &settings).unwrap();
        assert_eq!(found.onsets.len(), 1, "{:?}", found.onsets);
        let onset = found.onsets[0];
        assert!((onset.key - 30.0).abs() < 1e-5 && onset.within < 1e-5, "{onset:?}");
        assert!(
            (onset.im - 10.0).abs() < 1e-5 && onset.begins == (to > from),
            "{onset:?}"
        );
    }
    // Where the stiffness vanishes, the critical value says it.
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 15.0,
        }),
        ..EquilibriumSettings::default()
    };
    let still = Inside {
        softens: 1.0,
        inside: 0.0,
        ..Inside::default()
    };
    let found = campbell(&still, &settings).unwrap();
    assert!(found.onsets.is_empty(), "{:?}", found.onsets);
    assert!((found.critical[0].value - 10.0).abs() < 1e-4, "{:?}", found.critical);
}

rncf::model! {
    /// A disc on a shaft whose damping turns with it, and on bearings that damp as much.
    pub model Internal {
        param speed = 150 rad/s;
        param damper = 1 N*s/m;
        frame rotor = rotating(axis = z, angle = speed * t);
        rigid disc in rotor { plane xy; mass = 2 kg; inertia = 0.1 kg*m^2; }
        spring shaft = bushing(disc, rotor, stiffness = [20, 20, 0] kN/m, damping = [damper, damper, 0], rotational_stiffness = [0, 0, 1e7] N*m/rad);
        spring outer = bushing(disc, inertial, damping = [damper, damper, 0]);
        output x = disc.x;
    }
}

/// It whirls from twice its frequency on, `w_0 (1 + c_e / c_i)`, at 100 rad/s in space, however light the damping is.
#[test]
fn light_damping_that_turns_destabilises_where_it_does() {
    for damper in [1.0, 1e-2, 1e-3, 1e-4] {
        let settings = EquilibriumSettings {
            range: Some(Range {
                param: 0,
                from: 0.0,
                to: 400.0,
            }),
            ..EquilibriumSettings::default()
        };
        let found = campbell(
            &Internal {
                damper,
                ..Internal::default()
            },
            &settings,
        )
        .unwrap();
        let [onset] = &found.onsets[..] else {
            panic!("{damper}: {:?}", found.onsets)
        };
        assert!(
            (onset.key - 200.0).abs() < 1e-4 && (onset.im - 100.0).abs() < 1e-4,
            "{damper}: {onset:?}"
        );
    }
}
