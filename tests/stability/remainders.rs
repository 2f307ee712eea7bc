//! What Newton's iteration leaves is a jump of the acceleration, and an estimate of errors may follow it.

use rncf::{Formulation, Joints, Method, Model, Options};

use crate::scenes::{outputs, run};

rncf::model! {
    /// A steel rod falls from the horizontal, hung up at its end.
    pub model Hanging {
        param long = 1 m;
        param radius = 10 mm;
        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = radius);
        body rod { spatial; line from [0, 0, 0] m to [long, 0 m, 0 m]; mesh 4 * beam(round, steel); }
        joint top = spherical(rod.start, inertial);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = rod.end;
    }
}

/// Steps until a time, and the place of the end then.
fn fall(rod: &Hanging, until: f64, method: Method, joints: Joints) -> (u64, Vec<f64>) {
    let mut scene = rod.build(Formulation::Rncf, joints).unwrap();
    let start = scene.rest(0.0);
    let (state, statistics) = run(scene.as_mut(), start, until, method, Options::default()).unwrap();
    (statistics.steps, outputs(scene.as_mut(), &state))
}

/// The joint is eliminated, or has multipliers, with which the iteration leaves less: as many steps, and the same motion.
#[test]
fn steps_of_a_hanging_rod_do_not_follow_remainders() {
    let rods = [
        (Hanging::default(), 0.2, 1e-5),
        (
            Hanging {
                long: 0.8,
                radius: 5e-3,
            },
            0.4,
            5e-5,
        ),
    ];
    for (rod, until, near) in rods {
        for method in [Method::Hht { alpha: -0.05 }, Method::GeneralizedAlpha { rho_inf: 0.8 }] {
            let [(eliminated, place), (kept, same)] =
                [Joints::Eliminated, Joints::Multipliers].map(|way| fall(&rod, until, method, way));
            println!("{method:?}: {eliminated} steps, with multipliers {kept}");
            assert!(eliminated < 2 * kept, "{eliminated} {kept}");
            // Half of 9.81 m/s^2 * 3/2 * t^2 and less.
            assert!(place[2] < -0.25);
            assert!(
                place.iter().zip(&same).all(|(a, b)| (a - b).abs() < near),
                "{place:?} {same:?}"
            );
        }
    }
}
