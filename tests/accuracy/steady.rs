//! Relative equilibria at constant spin: elongation and root reaction (THEORY 8.1, 9.1).

use rncf::app::{EquilibriumSettings, modes};
use rncf::equilibrium::{self, Spin};
use rncf::space::Vector;
use rncf::{Formulation, Joints, Method, Model, Scene, State, steady};
use rncf_models::{SpinUp, SpinUpSpatial};
use rncf_reference::table::STEADY_ELONGATIONS;
use rncf_test_models::Uniform;

use crate::models::{Held, HeldByArm, HeldByGround, HeldSpatial};
use crate::runs::{WAYS, adaptive, grid, states_at};

const LENGTH: f64 = 8.0;
const AXIAL_STIFFNESS: f64 = 68.95e9 * 0.7299e-4;
const MASS_PER_LENGTH: f64 = 2766.67 * 0.7299e-4;

/// Outputs of the relative equilibrium at `t`, and its nodal vectors in the frame.
fn equilibrium(scene: &mut dyn Scene, t: f64) -> (Vec<f64>, Vec<f64>) {
    let found = steady(scene, t).unwrap();
    let state = found.state().unwrap();
    let mut outputs = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&equilibrium::Uniform::steady(t), state, &mut outputs);
    (outputs, scene.frame_state(state).q)
}

/// Half a unit of the last digit that the table prints.
fn half_digit(spin: f64) -> f64 {
    match spin {
        4.0 | 40.0 | 100.0 => 5.1e-10,
        _ => 5.1e-11,
    }
}

#[test]
fn elongations_of_the_table() {
    for (spin, expected) in STEADY_ELONGATIONS {
        for elements in [1, 2, 6, 24] {
            let flat = SpinUp {
                omega_s: spin,
                elements,
                ..SpinUp::default()
            };
            let space = SpinUpSpatial {
                omega_s: spin,
                elements,
                ..SpinUpSpatial::default()
            };
            for joints in [Joints::Eliminated, Joints::Multipliers] {
                let scenes = [
                    flat.build(Formulation::Rncf, joints).unwrap(),
                    space.build(Formulation::Rncf, joints).unwrap(),
                ];
                for mut scene in scenes {
                    // Behind the run-up, where the spin is constant.
                    let (outputs, _) = equilibrium(scene.as_mut(), 16.0);
                    let u = outputs[0];
                    println!("{spin} rad/s, n = {elements}, {joints:?}: u = {u:.9e}, table {expected:.9e}");
                    // One cubic holds the shape to the third power of the strain.
                    let cubic = if elements == 1 { 5e-8 * expected } else { 0.0 };
                    assert!(
                        (u - expected).abs() < half_digit(spin) + cubic,
                        "{spin} rad/s, {elements}: {u}"
                    );
                    assert!(outputs[1..].iter().all(|v| v.abs() < 1e-14), "{outputs:?}");
                }
            }
        }
    }
}

/// The elongated bar by shooting: `(N)' = -rho A w^2 x`, `N = EA/2 (x'^2 - 1) x'`, `x(0) = 0`, `x'(L) = 1`. Returns the
/// tip's position and the force at the root.
fn bar(spin: f64) -> [f64; 2] {
    let force = |stretch: f64| 0.5 * AXIAL_STIFFNESS * (stretch * stretch - 1.0) * stretch;
    let rate = |[x, stretch]: [f64; 2]| {
        let stiffness = 0.5 * AXIAL_STIFFNESS * (3.0 * stretch * stretch - 1.0);
        [stretch, -MASS_PER_LENGTH * spin * spin * x / stiffness]
    };
    let end = |stretch: f64| {
        let (mut y, steps) = ([0.0, stretch], 2000);
        let h = LENGTH / f64::from(steps);
        let at = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
        for _ in 0..steps {
            let k1 = rate(y);
            let k2 = rate(at(y, k1, h / 2.0));
            let k3 = rate(at(y, k2, h / 2.0));
            let k4 = rate(at(y, k3, h));
            for i in 0..2 {
                y[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
            }
        }
        y
    };
    let (mut low, mut high) = (1.0, 1.1);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if end(middle)[1] < 1.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let stretch = 0.5 * (low + high);
    [end(stretch)[0], force(stretch)]
}

/// `rho A w^2` times the integral of x over the beam, exactly for its cubic shape: what holds the root.
fn centrifugal(spin: f64, q: &[f64], dimension: usize) -> f64 {
    let nodes: Vec<(f64, f64)> = q.chunks(2 * dimension).map(|node| (node[0], node[dimension])).collect();
    let l = LENGTH / (nodes.len() - 1) as f64;
    let integral: f64 = nodes
        .windows(2)
        .map(|pair| l / 2.0 * (pair[0].0 + pair[1].0) + l * l / 12.0 * (pair[0].1 - pair[1].1))
        .sum();
    MASS_PER_LENGTH * spin * spin * integral
}

/// `[u, reactions]` of the beam that turns uniformly, and its nodal vectors.
fn held(spin: f64, elements: usize, dimension: usize, joints: Joints) -> (f64, Vec<f64>, Vec<f64>) {
    let (mut scene, deflections) = if dimension == 2 {
        let model = Held { omega: spin, elements };
        (model.build(Formulation::Rncf, joints).unwrap(), 2)
    } else {
        let model = HeldSpatial { omega: spin, elements };
        (model.build(Formulation::Rncf, joints).unwrap(), 3)
    };
    let (outputs, q) = equilibrium(scene.as_mut(), 0.0);
    (outputs[0], outputs[deflections..].to_vec(), q)
}

#[test]
fn root_holds_the_centrifugal_force() {
    for (spin, _) in STEADY_ELONGATIONS {
        let [tip, root] = bar(spin);
        let rigid = 0.5 * MASS_PER_LENGTH * spin * spin * LENGTH * LENGTH;
        for (dimension, elements) in [(2, 1), (2, 6), (3, 6), (2, 24)] {
            for joints in [Joints::Eliminated, Joints::Multipliers] {
                let (u, reactions, q) = held(spin, elements, dimension, joints);
                let exact = -centrifugal(spin, &q, dimension);
                let errors = [
                    reactions[0] / exact - 1.0,
                    reactions[0] / -root - 1.0,
                    u / (tip - LENGTH) - 1.0,
                ];
                println!(
                    "{spin} rad/s, {dimension}D, n = {elements}, {joints:?}: force {:.6} N; relative to its own shape \
                     {:.1e}, to the bar {:.1e}, of u {:.1e}; rigid beam {:.1e}",
                    reactions[0],
                    errors[0],
                    errors[1],
                    errors[2],
                    reactions[0] / -rigid - 1.0
                );
                // Round-off of the elastic force: EA times the last digit of the strain.
                let round_off = 1e-15 * AXIAL_STIFFNESS / rigid;
                assert!(errors[0].abs() < 1e-12 + 4.0 * round_off, "{errors:?}");
                // The bar's shape is a cubic up to the third power of the strain.
                let cubic = if elements == 1 { 5e-8 } else { 1e-10 };
                assert!(errors[1].abs() < cubic + 4.0 * round_off, "{errors:?}");
                assert!(errors[2].abs() < cubic + 4.0 * round_off, "{errors:?}");
                // To first order the beam is rigid: the rest is the strain.
                let strain = u / LENGTH;
                assert!(
                    (reactions[0] / -rigid - 1.0 - 1.25 * strain).abs() < strain * strain + 1e-12 + 4.0 * round_off
                );
                assert!(reactions[1..].iter().all(|r| r.abs() < 1e-9), "{reactions:?}");
            }
        }
    }
}

#[test]
fn equilibrium_is_at_rest_in_every_formulation() {
    let spin = 40.0;
    let model = Held {
        omega: spin,
        elements: 4,
    };
    let mut referenced = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let found = steady(referenced.as_mut(), 0.0).unwrap();
    let frame = referenced.frame_state(found.state().unwrap());
    let expected = -centrifugal(spin, &frame.q, 2);
    for (formulation, joints) in WAYS {
        let mut scene = model.build(formulation, joints).unwrap();
        let start = scene.state_of_frame(&frame);
        let (states, _) = states_at(scene.as_mut(), start, Method::Radau, adaptive(1e-8), &[0.0, 0.05, 0.1]);
        let mut outputs = vec![0.0; scene.output_columns()];
        for state in &states {
            scene.outputs(state, &mut outputs);
            println!(
                "{formulation:?} {joints:?} t = {:.2}: u {:.9e}, v {:.1e}, force {:.9e} N of {expected:.9e}",
                state.t, outputs[0], outputs[1], outputs[2]
            );
            // RNCF does not move at all; ANCF turns by 4 rad within the tolerance.
            let allowed = match formulation {
                Formulation::Rncf => [1e-13, 1e-12],
                Formulation::Ancf => [8.0 * 1e-8, 1e-6],
            };
            let tip = [outputs[0] - frame.q[frame.q.len() - 4] + LENGTH, outputs[1]];
            assert!(tip.iter().all(|error| error.abs() < allowed[0]), "{tip:?}");
            assert!(
                (outputs[2] / expected - 1.0).abs() < allowed[1],
                "{}",
                outputs[2] / expected - 1.0
            );
        }
    }
}

/// From relative equilibrium nothing moves in the frame, in either formulation; from rest it does.
#[test]
fn a_steady_start_stays_steady() {
    let model = Uniform::default();
    let mut referenced = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let found = steady(referenced.as_mut(), 0.0).unwrap();
    let frame = referenced.frame_state(found.state().unwrap());
    for (formulation, joints) in WAYS {
        let mut scene = model.build(formulation, joints).unwrap();
        let start = scene.state_of_frame(&frame);
        let largest = |scene: &mut dyn Scene, start: State| {
            let (states, _) = states_at(scene, start, Method::Radau, adaptive(1e-8), &grid(0.05, 1.0));
            let mut row = [0.0; 2];
            let far = states.iter().map(|state| {
                scene.outputs(state, &mut row);
                (row[0] - 1.0948018e-2).abs().max(row[1].abs())
            });
            far.fold(0.0, f64::max)
        };
        let moved = largest(scene.as_mut(), start);
        println!("{formulation:?} {joints:?}: moves by {moved:.1e} m");
        // The printed elongation has eight digits; rtol 1e-8 of 8 m.
        assert!(moved < 8e-7, "{formulation:?} {joints:?}: {moved} m");
        let rest = scene.rest(0.0);
        assert!(largest(scene.as_mut(), rest) > 5e-3);
    }
}

/// A joint that keeps a direction in space is refused by name; joints and loads in another frame that
/// turns with the body are not.
#[test]
fn what_does_not_turn_with_the_body_is_refused() {
    let mut scene = HeldByGround::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap();
    let error = steady(scene.as_mut(), 1.0).unwrap_err().to_string();
    assert!(
        error.contains("joint `root` holds the direction of body `beam`"),
        "{error}"
    );
    let mut scene = HeldByArm::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap();
    steady(scene.as_mut(), 1.0).unwrap();
}

mod beside {
    rncf::model! {
        /// A blade on a hub, and beside it a post that stands on the ground.
        pub model Beside {
            section post { EA = 10 MN; EIy = 400 N*m^2; EIz = 100 N*m^2; GAy = 5 MN; GAz = 5 MN; GJ = 100 N*m^2; mass = 3 kg/m; inertia_y = 1e-4 kg*m; inertia_z = 1e-4 kg*m; }
            frame hub = rotating(axis = z, angle = 10 [rad/s] * t);
            body blade in hub { spatial; line from [0, 0, 0] m to [1, 0, 0] m; section_y [0, 1, 0]; mesh 4 * beam(post); }
            joint root = clamp(blade.start, hub);
            body ground { spatial; line from [3, 0, 0] m to [3, 0, 1] m; section_y [0, 1, 0]; mesh 4 * beam(post); }
            joint base = clamp(ground.start, inertial);
            output tips = blade.end - ground.end.in(hub);
            run { t_end = 1 s; }
        }
    }
}

mod standing {
    rncf::model! {
        /// A post that stands on the ground.
        pub model Standing {
            section post { EA = 10 MN; EIy = 400 N*m^2; EIz = 100 N*m^2; GAy = 5 MN; GAz = 5 MN; GJ = 100 N*m^2; mass = 3 kg/m; inertia_y = 1e-4 kg*m; inertia_z = 1e-4 kg*m; }
            body ground { spatial; line from [3, 0, 0] m to [3, 0, 1] m; section_y [0, 1, 0]; mesh 4 * beam(post); }
            joint base = clamp(ground.start, inertial);
            output tip = ground.end;
            run { t_end = 1 s; }
        }
    }
}

/// What stands beside a rotor has one frequency, of Bernoulli's clamped beam; `--spin` of what cannot turn is refused.
#[test]
fn what_stands_does_not_turn_with_the_rest() {
    let found = modes(&beside::Beside::default(), &EquilibriumSettings::default()).unwrap();
    let first = 3.516_015 * (100.0_f64 / 3.0).sqrt();
    let of = |body: &str| {
        let modes = found.modes.iter().zip(&found.compositions);
        let own = modes.filter(move |(_, composition)| {
            composition
                .bodies
                .iter()
                .any(|(name, part)| name == body && *part > 0.99)
        });
        own.map(|(mode, _)| mode.inertial_frequencies(found.spin))
            .collect::<Vec<_>>()
    };
    let standing = of("ground");
    assert!(
        (standing[0][0] - first).abs() < 1e-3 * first,
        "{standing:?} for {first}"
    );
    assert!(standing.iter().all(|seen| seen.len() == 1), "{standing:?}");
    assert!(of("blade").iter().any(|seen| seen.len() == 2), "{:?}", of("blade"));
    let turned = EquilibriumSettings {
        spin: Some(Spin {
            velocity: Vector::new(0.0, 0.0, 10.0),
            point: Vector::zeros(),
        }),
        ..EquilibriumSettings::default()
    };
    let error = modes(&standing::Standing::default(), &turned).unwrap_err().to_string();
    assert!(
        error.contains("nothing turns with the rotation that is given"),
        "{error}"
    );
}
