//! Bodies that spin freely: what is carried along across the axis, what rolls about an axis without stiffness, and what bends beside it.

use rncf::AnyModel;
use rncf::app::{Campbell, EquilibriumSettings, Modes, Range, campbell, modes};

mod rod {
    rncf::model! {
        /// A rod that turns about a middle axis of its inertia: about its own one nothing is stiff, at any speed.
        pub model Rod {
            param w = 3 rad/s; param n: count = 6;
            section s {
                EA = 20 kN; GA = 8 kN; GJ = 0.7 N*m^2; EIy = 1 N*m^2; EIz = 2 N*m^2;
                mass = 1 kg/m; inertia_y = 1e-3 kg*m; inertia_z = 1e-3 kg*m;
            }
            frame f = free(angular_velocity = [0, 0, 1] * w);
            body rod in f { spatial; line from [-0.5, 0, 0] m to [0.5, 0, 0] m; mesh n * beam(s); mean_axes; }
            output p = rod.end.in(inertial);
            run { t_end = 1 s; }
        }
    }
}
use rod::Rod;

mod hub {
    rncf::model! {
        /// A rigid body that spins about the axis of its largest inertia.
        pub model Hub {
            param w = 2 rad/s;
            rigid hub { mass = 5 kg; inertia = [1, 2, 2.5] kg*m^2; angular_velocity = [0, 0, 1] * w; }
            output p = hub.position;
            run { t_end = 1 s; }
        }
    }
}
use hub::Hub;

fn found(model: &dyn AnyModel) -> Modes {
    modes(model, &EquilibriumSettings::default()).unwrap()
}

/// Three motions without stiffness, three at the angular velocity, of which the two shifts stand still, and the first ones that bend: those of a geometrically
/// exact rod of 80 elements, linearised numerically in turning axes by another program.
#[test]
fn a_free_rod_has_its_six_rigid_motions_and_bends_beside_them() {
    for (w, n, bent) in [
        (0.5, 6, Some(21.840)),
        (3.0, 12, Some(22.401)),
        (3.0, 6, Some(22.401)),
        (10.0, 12, None),
        (30.0, 6, None),
    ] {
        let found = found(&Rod { w, n });
        let still = found.modes.iter().filter(|mode| mode.is_still()).count();
        let carried: Vec<_> = found
            .modes
            .iter()
            .filter(|mode| (mode.im - w).abs() < 1e-9 * w)
            .collect();
        let standing = carried
            .iter()
            .filter(|mode| mode.inertial_frequencies(w) == [0.0])
            .count();
        assert_eq!(
            (found.modes.len(), still, carried.len(), standing),
            (8, 3, 3, 2),
            "{w} {n}: {:?}",
            found.modes
        );
        assert!(
            found.modes.iter().all(|mode| mode.re.abs() < 1e-11),
            "{w} {n}: {:?}",
            found.modes
        );
        let first = found.modes[6].im;
        assert!(
            bent.is_none_or(|bent: f64| (first - bent).abs() < 4e-4 * bent),
            "{w} {n}: {first} for {bent:?}"
        );
    }
}

/// Nothing of it becomes soft; its tilt has the frequency of the spin at every speed.
#[test]
fn the_diagram_of_a_free_rod_has_no_critical_speed() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 0.0,
            to: 6.0,
        }),
        steps: 6,
        ..EquilibriumSettings::default()
    };
    let found: Campbell = campbell(&Rod::default(), &settings).unwrap();
    assert!(
        found.critical.is_empty() && found.crossings.is_empty(),
        "{:?} {:?}",
        found.critical,
        found.crossings
    );
    assert!(found.onsets.is_empty(), "{:?}", found.onsets);
}

/// Of a free top `nu^2 = w^2 (C - A)(C - B) / (A B)`; with its rigid motions it has six.
#[test]
fn a_free_top_wobbles() {
    let w = 2.0;
    let found = found(&Hub { w });
    let wobble = w * (1.5_f64 * 0.5 / 2.0).sqrt();
    let near = found
        .modes
        .iter()
        .filter(|mode| (mode.im - wobble).abs() < 1e-9 * wobble);
    assert_eq!((found.modes.len(), near.count()), (6, 1), "{:?}", found.modes);
}
