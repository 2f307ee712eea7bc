//! What turns is the same machine however its parts are declared, and at whatever angle its motions have arrived.

use rncf::AnyModel;
use rncf::app::{Campbell, EquilibriumSettings, Modes, Range, campbell, modes};

rncf::model! {
    /// A blade with a body at its tip, which is a rigid one that is welded on.
    pub model RigidTip {
        param speed = 10 rad/s;
        section s {
            EA = 2 MN; GAy = 1 MN; GAz = 1 MN; GJ = 100 N*m^2; EIy = 200 N*m^2; EIz = 3 kN*m^2;
            mass = 0.5 kg/m; inertia_y = 0.5 g*m; inertia_z = 0.5 g*m;
        }
        frame hub = rotating(axis = z, angle = speed * t);
        body b in hub { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * beam(s); }
        joint root = clamp(b.start, hub);
        rigid tip in hub { mass = 5 kg; inertia = [0.2, 0.3, 0.4] kg*m^2; origin = [1, 0, 0] m; }
        joint g = weld(b.end, tip);
        output z = b.end.z;
    }
}

rncf::model! {
    /// The same with a fixture.
    pub model FixedTip {
        param speed = 10 rad/s;
        section s {
            EA = 2 MN; GAy = 1 MN; GAz = 1 MN; GJ = 100 N*m^2; EIy = 200 N*m^2; EIz = 3 kN*m^2;
            mass = 0.5 kg/m; inertia_y = 0.5 g*m; inertia_z = 0.5 g*m;
        }
        frame hub = rotating(axis = z, angle = speed * t);
        body b in hub { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * beam(s); }
        joint root = clamp(b.start, hub);
        fixture tip on b.end { mass = 5 kg; inertia = [0.2, 0.3, 0.4] kg*m^2; }
        output z = b.end.z;
    }
}

fn diagram(model: &dyn AnyModel, at: f64) -> Campbell {
    let settings = EquilibriumSettings {
        at: Some(at),
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 40.0,
        }),
        ..EquilibriumSettings::default()
    };
    campbell(model, &settings).unwrap()
}

/// A free body has positions in inertial axes, in which a mode has turned from one speed to the next by any angle.
#[test]
fn modes_of_what_turns_with_a_rigid_body_are_followed_at_any_time() {
    let expected = diagram(&FixedTip::default(), 1.0);
    for at in [0.0, 1.0, 10.0] {
        let found = diagram(&RigidTip::default(), at);
        let pairs = found.crossings.iter().zip(&expected.crossings);
        let apart = pairs.map(|(a, b)| (a.key - b.key).abs().max((a.im - b.im).abs()));
        let apart = apart.fold(0.0, f64::max);
        println!("{at} s: {} crossings, {apart:.1e} apart", found.crossings.len());
        assert_eq!(found.crossings.len(), expected.crossings.len(), "{at} s");
        assert!(apart < 1e-4, "{at} s: {apart:.1e}");
    }
    assert_eq!(expected.crossings.len(), 4);
}

/// What a bearing feels of a mode does not depend on how the tip is declared.
#[test]
fn flap_of_a_rigid_tip_is_flap_in_the_inertial_frame() {
    let of = |found: Modes| -> Vec<f64> {
        found
            .modes
            .iter()
            .flat_map(|mode| mode.inertial_frequencies(found.spin))
            .collect()
    };
    let settings = EquilibriumSettings::default();
    let rigid = of(modes(&RigidTip::default(), &settings).unwrap());
    let fixed = of(modes(&FixedTip::default(), &settings).unwrap());
    assert_eq!(rigid.len(), fixed.len(), "{rigid:?} {fixed:?}");
    for (a, b) in rigid.iter().zip(&fixed) {
        assert!((a - b).abs() < 1e-6 * b, "{a} {b}");
    }
}

rncf::model! {
    /// An anisotropic rotor in air: `det K = (k1 - w^2) (k2 - w^2) + (c w)^2` in its axes, with 1 kg.
    pub model Flat {
        param speed = 100 rad/s;
        param air = 3 N*s/m;
        frame rotor = rotating(axis = x, angle = speed * t);
        rigid disc in rotor { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; center = [0 m, 1 [mm], 0 m]; }
        spring shaft = bushing(disc, rotor, stiffness = [1000, 10, 16] kN/m, damping = [0, 2, 2] N*s/m, rotational_stiffness = [1e6, 1e6, 1e6] N*m/rad);
        spring film = bushing(disc, inertial, stiffness = [0, 0, 0] N/m, damping = [0 [N*s/m], air, air]);
        output y = disc.in(rotor).y;
    }
}

/// Of the values at which the symmetric stiffness and the whole one vanish only the latter are those of a frequency that is zero.
#[test]
fn an_undamped_critical_speed_beside_a_damped_one_is_called_that() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 60.0,
            to: 160.0,
        }),
        ..EquilibriumSettings::default()
    };
    let found = campbell(&Flat::default(), &settings).unwrap();
    // Of `w^4 - (26000 - 9) w^2 + 1.6e8`.
    let (half, whole) = ((26000.0 - 9.0) / 2.0, 1.6e8);
    let root = f64::sqrt(half * half - whole);
    let expected = [(half - root).sqrt(), (half + root).sqrt()];
    let standing = found.critical.iter().zip(&found.standing);
    let standing: Vec<f64> = standing
        .filter(|(_, is)| **is)
        .map(|(critical, _)| critical.value)
        .collect();
    println!("{standing:?} {expected:?} of {:?}", found.critical);
    assert_eq!((standing.len(), found.critical.len()), (2, 4));
    assert!(
        standing.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2e-3),
        "{standing:?} {expected:?}"
    );
}
