//! Sections that turn within elements: what nodes alone do not see is refused.

use rncf::{Formulation, Joints, Model};

rncf::model! {
    /// A blade whose twist swings, and a blade on an arc whose tangent may pass the direction of its sections.
    pub model Turning {
        param n: count = 8;
        param swing = 0 deg;
        param period = 0.25 m;
        param angle = 60 deg;
        param tilt = 0 m;
        section lay { EA = 50 MN; GAy = 20 MN; GAz = 10 MN; GJ = 3 kN*m^2; EIy = 1 kN*m^2; EIz = 18 kN*m^2; mass = 3 kg/m; inertia_y = 0.002 kg*m; inertia_z = 0.01 kg*m; }
        body swung { spatial; line from [0, 0, 0] m to [2, 0, 0] m; section_y [0, 1, 0]; twist swing * sin(2 * pi * x / period); mesh n * beam(lay); }
        body bow { spatial; curve [1 m * sin(s), 1 m * (1 - cos(s)), tilt * s] for s from 0 to angle; section_y [0, 1, 0]; mesh n * beam(lay); }
        joint root = clamp(swung.start, inertial);
        joint other = clamp(bow.start, inertial);
        output y = bow.end.y;
        output of_swung = swung.end.y;
    }
}

/// The twist of a whole period within an element was lost, and a section that turns over within one, too: both ran, the more wrong the finer the mesh.
#[test]
fn sections_that_turn_within_elements_are_refused() {
    let mistake = |model: Turning| {
        model
            .build(Formulation::Rncf, Joints::Eliminated)
            .err()
            .map(|error| error.to_string())
    };
    let whole = Turning::default();
    assert_eq!(mistake(whole.clone()), None);
    let swung = Turning {
        swing: 1.4,
        ..whole.clone()
    };
    let told = mistake(swung.clone()).unwrap();
    assert!(
        told.contains("body `swung`: each of its 8 elements is twisted by 3"),
        "{told}"
    );
    assert_eq!(mistake(Turning { n: 64, ..swung }), None);
    for n in [11, 13, 16, 17, 31, 63] {
        for tilt in [0.0, 1e-4] {
            let told = mistake(Turning {
                n,
                tilt,
                angle: 2.0,
                ..whole.clone()
            })
            .unwrap();
            assert!(
                told.contains("body `bow`: `section_y` [0.0, 1.0, 0.0] has no part across the axis at x = 1.5"),
                "{n}: {told}"
            );
        }
    }
    // Where the tangent passes at a distance, the section turns as fast as that tells.
    let passing = Turning {
        n: 16,
        tilt: 0.05,
        angle: 2.0,
        ..whole.clone()
    };
    assert!(
        mistake(passing.clone())
            .unwrap()
            .contains("body `bow`: each of its 16 elements is twisted by")
    );
    assert_eq!(mistake(Turning { n: 200, ..passing }), None);
}
