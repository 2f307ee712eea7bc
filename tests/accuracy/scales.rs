//! Scales of tolerances come from the size of a scene: not from units, round-off or the distance from the origin.

use rncf::app::{EquilibriumSettings, modes, static_equilibria};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, SolveError, State, Stop};

const ALL: [Method; 3] = [
    Method::Radau,
    Method::Hht { alpha: -0.05 },
    Method::GeneralizedAlpha { rho_inf: 0.8 },
];

/// A run to the model's end: the last state and the number of steps.
fn run(scene: &mut dyn Scene, method: Method, rtol: f64, end: f64) -> Result<(State, u64), SolveError> {
    let start = scene.rest(0.0);
    let options = Options {
        rtol,
        ..Options::default()
    };
    let mut integrator = Integrator::new(scene, start, end, method, options)?;
    while integrator.step()? != Stop::End {}
    Ok((integrator.state().clone(), integrator.statistics().steps))
}

fn built(model: &impl Model) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

fn outputs(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(state, &mut row);
    row
}

rncf::model! {
    /// A rod with a block on it, and a second block on a spring, in units that are params.
    pub model Units {
        /// Unit of length.
        param long = 1 m;
        /// Unit of time.
        param while_ = 1 s;
        /// Unit of mass.
        param heavy = 1 kg;
        /// Place of the block.
        param place = 0.3;
        /// Angular speed of the start about the origin.
        param turning = 3;
        material soft { density = 8000 * heavy / long^3; young = 1e8 * heavy / (long * while_^2); }
        section square { area = 1e-4 * long^2; second_moment = 1e-9 * long^4; }
        body rod {
            planar xy;
            line from [0.05 * long, 0, 0] to [0.55 * long, 0, 0];
            mesh 3 * cable(square, soft);
            initial velocity [0, turning / while_ * (x - 0 * long), 0];
        }
        joint root = pin(rod.start, inertial);
        rigid block {
            plane xy; mass = 0.2 * heavy; inertia = 0.001 * heavy * long^2; origin = [place * long, 0, 0];
            velocity = [0, turning * (place - 0.05) * long / while_, 0]; speed = turning * 1 rad / while_;
        }
        joint tie = revolute(rod.at(0.25 * long), block);
        rigid other { plane xy; mass = 0.1 * heavy; origin = [0.6 * long, 0, 0]; velocity = [0, 0.5 * turning * long / while_, 0]; }
        spring cord = linear(rod.end, other, stiffness = 40 * heavy / while_^2, length = 0.05 * long);
        output x = block.x;
        output y = rod.end.y;
        output z = other.y;
    }
}

#[test]
fn a_lever_of_round_off_is_none() {
    // 0.05 + 0.25 is 0.30000000000000004: one of the two places leaves a lever of 5.5e-17 m.
    for turning in [0.0, 3.0] {
        for method in ALL {
            let steps = [0.3, 0.3f64.next_up()].map(|place| {
                let model = Units {
                    place,
                    turning,
                    ..Units::default()
                };
                let mut scene = built(&model);
                run(scene.as_mut(), method, 1e-6, 0.2).map(|(_, steps)| steps).unwrap()
            });
            assert_eq!(steps[0], steps[1], "{method:?} at {turning} rad/s");
        }
    }
}

#[test]
fn a_watch_and_a_bridge_take_the_steps_of_the_same_model_in_metres() {
    // Powers of two scale every number exactly; others up to round-off.
    let units = [
        (1.0, 1.0, 1.0),
        ((-20f64).exp2(), (-9f64).exp2(), (-30f64).exp2()),
        (17f64.exp2(), 6f64.exp2(), 20f64.exp2()),
        (1e-3, 1.0, 1.0),
        (1e-4, 1e-3, 1e-9),
        (1e5, 1e2, 1e12),
    ];
    for method in ALL {
        let mut first: Option<(Vec<f64>, u64)> = None;
        for (l, s, m) in units {
            let model = Units {
                long: l,
                while_: s,
                heavy: m,
                place: 0.3f64.next_up(),
                ..Units::default()
            };
            let mut scene = built(&model);
            let (state, steps) = run(scene.as_mut(), method, 1e-6, 0.2 * s).unwrap();
            let row: Vec<f64> = outputs(scene.as_mut(), &state).iter().map(|value| value / l).collect();
            let (wanted, count) = first.get_or_insert((row.clone(), steps));
            assert_eq!(steps, *count, "{method:?} {l} m {s} s {m} kg");
            for (found, wanted) in row.iter().zip(wanted) {
                assert!((found - *wanted).abs() < 1e-9, "{method:?} {l} m: {found} {wanted}");
            }
        }
    }
}

rncf::model! {
    /// A point in an orbit, one on a ring and two satellites that a tether joins, in one field.
    pub model Orbits {
        param r = 6.8e6 m;
        const mu = 3.986004418e14 [m^3/s^2];
        const v = sqrt(mu / 6.8e6 [m]);
        rigid point { mass = 3 kg; origin = [r, 0 m, 0 m]; velocity = [0, 1.1 * v, 0]; }
        rigid ring { mass = 3 kg; origin = [r, 0 m, 0 m]; velocity = [0, v, 0]; }
        constraint held = norm(ring.position) - r;
        load on_point = force(point, -mu * 3 kg * point.position / norm(point.position)^3);
        output x = point.x;
        output y = point.y;
        output way = ring.y;
    }
}
rncf::model! {
    /// A body with a long arm on a ring around a far origin.
    pub model Ring {
        param r = 1e9 m;
        rigid arm { mass = 3 kg; inertia = [1, 1, 1] kg*m^2; origin = [r, 0 m, 0 m]; velocity = [0, 100, 0] m/s; }
        rigid tip { mass = 1 kg; origin = [r, 10 m, 0 m]; velocity = [0, 100, 0] m/s; }
        constraint held = norm(arm.position) - r;
        joint boom = spherical(arm.at([0, 10, 0] m), tip);
        output way = arm.y;
    }
}
rncf::model! {
    /// A mass on a spring without length.
    pub model Coincident {
        param place = 0.3 m;
        rigid bob { mass = 1 kg; origin = [place, 0 m, 0 m]; }
        spring cord = linear(bob, inertial.at([0.3, 0, 0] m), stiffness = 10 N/m, length = 0.1 m);
        output x = bob.x;
    }
}
rncf::model! {
    /// Two satellites that a tether joins, circling each other in the orbit of their centre.
    pub model Tethered {
        param r = 6.8e6 m;
        const v = 7600 m/s;
        rigid a { mass = 3 kg; inertia = [1, 1, 1] kg*m^2; origin = [r, -6 m, 0 m]; velocity = [0.6 [m/s], v, 0]; angular_velocity = [0, 0, 0.1] rad/s; }
        rigid b { mass = 3 kg; inertia = [1, 1, 1] kg*m^2; origin = [r, 6 m, 0 m]; velocity = [-0.6 [m/s], v, 0]; angular_velocity = [0, 0, 0.1] rad/s; }
        joint tether = distance(a.at([0, 1, 0] m), b.at([0, -1, 0] m));
        output apart = norm(a.position - b.position);
        output across = b.x - a.x;
        output pull = norm(tether.force);
    }
}

/// Kepler's orbit from its nearest point at (r, 0) with the speed v across, at time t: x and y.
fn kepler(mu: f64, r: f64, v: f64, t: f64) -> [f64; 2] {
    let long = 1.0 / (2.0 / r - v * v / mu);
    let eccentricity = 1.0 - r / long;
    let mean = (mu / long.powi(3)).sqrt() * t;
    let mut anomaly = mean;
    for _ in 0..50 {
        anomaly -= (anomaly - eccentricity * anomaly.sin() - mean) / (1.0 - eccentricity * anomaly.cos());
    }
    let across = long * (1.0 - eccentricity * eccentricity).sqrt();
    [long * (anomaly.cos() - eccentricity), across * anomaly.sin()]
}

#[test]
fn an_orbit_and_a_ring_far_from_the_origin_keep_their_tolerance() {
    let (mu, r, end) = (3.986004418e14f64, 6.8e6, 3000.0);
    let v = (mu / r).sqrt();
    let [x, y] = kepler(mu, r, 1.1 * v, end);
    for (method, tolerances) in [(ALL[0], &[1e-8, 1e-10][..]), (ALL[1], &[1e-8]), (ALL[2], &[1e-8])] {
        for &rtol in tolerances {
            let mut scene = built(&Orbits::default());
            let (state, _) = run(scene.as_mut(), method, rtol, end).unwrap();
            let found = outputs(scene.as_mut(), &state);
            // Methods of second order err by the power 2/3 of the tolerance.
            let error = if method == ALL[0] {
                10.0 * rtol
            } else {
                10.0 * rtol.powf(2.0 / 3.0)
            };
            let wanted = [x, y, r * (v * end / r).sin()];
            for (found, wanted) in found.iter().zip(wanted) {
                assert!(
                    (found - wanted).abs() < error * r,
                    "{method:?} {rtol}: {found} instead of {wanted}"
                );
            }
        }
    }
}

#[test]
fn a_tolerance_below_round_off_is_named() {
    // Coordinates of 1e9 m have a last bit of 1e-7 m.
    let mut scene = built(&Ring::default());
    let error = run(scene.as_mut(), Method::Radau, 1e-10, 50.0).unwrap_err().to_string();
    for part in ["the tolerance is below round-off", "constraint `held`, value", "origin"] {
        assert!(error.contains(part), "`{part}` is missing in: {error}");
    }
    let (state, _) = run(scene.as_mut(), Method::Radau, 1e-5, 50.0).unwrap();
    let found = outputs(scene.as_mut(), &state);
    assert!((found[0] - 5000.0).abs() < 1e-2, "{found:?}");
}

#[test]
fn a_spring_whose_ends_are_a_round_off_apart_is_refused() {
    let place = 0.05 + 0.25;
    let mut scene = built(&Coincident { place });
    let error = run(scene.as_mut(), Method::Radau, 1e-6, 1.0).unwrap_err().to_string();
    assert!(error.contains("the force of `cord` is not finite"), "{error}");
}

#[test]
fn a_tether_in_orbit_is_as_exact_as_at_the_origin() {
    for method in ALL {
        for rtol in [1e-6, 1e-9] {
            let [near, far] = [0.0, 6.8e6].map(|r| {
                let mut scene = built(&Tethered { r });
                let (state, steps) = run(scene.as_mut(), method, rtol, 20.0).unwrap();
                (outputs(scene.as_mut(), &state), steps)
            });
            // Far away positions count from points that move on with the start: there they change more slowly.
            assert!(
                far.1 <= near.1 + near.1 / 10,
                "{method:?} {rtol}: {} and {}",
                near.1,
                far.1
            );
            // Turned by 2 rad; each end 6 m from the middle.
            let turned = -12.0 * 2f64.sin();
            for (found, exact) in [(&near.0, 1e-9), (&far.0, 2e-8)] {
                assert!((found[0] - 12.0).abs() < exact + 10.0 * rtol, "{found:?}");
                assert!((found[1] - turned).abs() < 120.0 * rtol.powf(2.0 / 3.0), "{found:?}");
                assert!((found[2] - 0.18).abs() < 1e-3, "{found:?}");
            }
        }
    }
}

rncf::model! {
    /// A rod on a hinge; its own frame is tied to the section that the hinge holds.
    pub model Followed {
        /// Unit of length.
        param long = 1 m;
        /// Unit of time.
        param while_ = 1 s;
        /// Unit of mass.
        param heavy = 1 kg;
        material soft { density = 2700 * heavy / long^3; young = 7e8 * heavy / (long * while_^2); poisson = 0.3; damping = 1e-4 * while_; }
        section round = circle(radius = 0.0144 * long);
        frame own = free(origin = [0.1 * long, 0.2 * long, 0], axis = [0, -0.7, -0.7], angle = 0.4 rad);
        body rod in own { spatial; line from [0, 0, 0] to [0.8 * long, 0.4 * long, 0.3 * long]; mesh 2 * beam(round, soft); }
        joint _tie = clamp(rod.start, own);
        joint hinge = revolute(inertial.at([0.1 * long, 0.2 * long, 0]), rod.start, axis = [0.1, 0.6, 0.8]);
        load weight = gravity([0, 0, -9.81 * long / while_^2]);
        output tip = rod.end.in(inertial).position;
    }
}

#[test]
fn a_frame_that_follows_a_section_on_a_hinge_is_regular_in_all_units() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let runs = [
            (1.0, 1.0, 1.0),
            (1.0 / 1024.0, 1.0 / 16.0, 1.0 / 65536.0),
            (1024.0, 16.0, 65536.0),
        ]
        .map(|(long, while_, heavy)| {
            let model = Followed { long, while_, heavy };
            let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
            let (state, steps) = run(scene.as_mut(), Method::Radau, 1e-6, 0.05 * while_).unwrap();
            let tip = outputs(scene.as_mut(), &state)
                .iter()
                .map(|x| x / long)
                .collect::<Vec<_>>();
            (steps, tip)
        });
        for (steps, tip) in &runs[1..] {
            assert_eq!(*steps, runs[0].0, "{formulation:?}");
            assert!(
                tip.iter().zip(&runs[0].1).all(|(a, b)| (a - b).abs() < 1e-7),
                "{tip:?} {:?}",
                runs[0].1
            );
        }
    }
}

rncf::model! {
    /// A cantilever with a body at its tip, an arm on a hinge and a spring, of any size: nothing but `size` has a length.
    pub model Resonator {
        param size = 1;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; damping = size * 1e-5 s; }
        section r = rectangle(y = size * 20 mm, z = size * 10 mm);
        body b { spatial; line from [0, 0, 0] m to [size * 1 m, 0 m, 0 m]; section_y [0, 1, 0]; mesh 3 * beam(r, steel); }
        rigid tip {
            mass = size^3 * 1 kg;
            inertia = [size^5 * 0.01 [kg*m^2], size^5 * 0.02 [kg*m^2], size^5 * 0.02 [kg*m^2]];
            origin = [size * 1.2 m, 0 m, 0 m];
        }
        rigid arm {
            mass = size^3 * 2 kg;
            inertia = [size^5 * 0.01 [kg*m^2], size^5 * 0.02 [kg*m^2], size^5 * 0.02 [kg*m^2]];
            origin = [size * 1.2 m, 0 m, size * 0.3 m];
        }
        joint root = clamp(b.start, inertial);
        joint held = weld(b.end, tip);
        joint hinge = revolute(tip, arm.at([0 m, 0 m, size * -0.3 m]), axis = y);
        spring tie = linear(arm, inertial.at([0 m, size * 0.2 m, size * 0.3 m]), stiffness = size * 10 [kN/m], length = size * 1.25 m,
            damping = size^2 * 10 [N*s/m]);
        load w = force(arm, [0 N, size^2 * 30 N, size^2 * -100 N]);
        output deflection = b.end.y / (size * 1 m);
        run { t_end = size * 0.05 s; every = size * 1 ms; }
    }
}

/// Forces scale with the square of a length, frequencies with its inverse; beside conditions between lengths the stiffness of a small machine in SI is nothing.
#[test]
fn a_machine_of_a_micrometre_is_as_stable_as_a_large_one() {
    let settings = EquilibriumSettings::default();
    let found = [1.0, 1e-3, 1e-6].map(|size| {
        let model = Resonator { size };
        let statics = static_equilibria(&model, &settings).unwrap();
        assert!(statics.critical.is_empty(), "{size}: {:?}", statics.critical);
        assert!(statics.warnings.is_empty(), "{size}: {:?}", statics.warnings);
        let modes = modes(&model, &settings).unwrap();
        let all: Vec<f64> = modes
            .modes
            .iter()
            .flat_map(|mode| [mode.im * size, mode.re * size])
            .collect();
        (statics.history.column(0).last().unwrap(), all)
    });
    println!("{found:?}");
    for (deflection, all) in &found[1..] {
        assert!((deflection / found[0].0 - 1.0).abs() < 1e-8, "{deflection}");
        let apart = all.iter().zip(&found[0].1).map(|(a, b)| (a - b).abs() / found[0].1[0]);
        assert!(apart.fold(0.0, f64::max) < 1e-6, "{all:?}");
    }
}
