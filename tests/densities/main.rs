//! Loads per length and gravity fields as they are emitted: derivatives, self weight, loops, section forces.

mod distributed;
mod flows;

use rncf::model::Configuration;
use rncf::nalgebra::{UnitQuaternion, Vector3};
use rncf::system::{State, Tangent};
use rncf::{Formulation, Joints, Model, Scene};

rncf::model! {
    /// A small sail: tethers in a free frame with thrust, under the sun.
    pub model Sail {
        /// Thrust per length at the start.
        param thrust = 0.3 N/m;
        /// Distance from the sun.
        param distance = 7 m;
        /// Gravity of the sun at the start.
        param pull = 0.4 m/s^2;
        const density = 1200 kg/m^3;
        material rubber { density = density; young = 2 MPa; }
        section cord = circle(radius = 10 mm);
        frame sail = free(origin = [distance, 1 m, 0.5 m], axis = [0.6, 0, 0.8], angle = 0.4 rad, angular_velocity = [0.2, -0.1, 0.5] rad/s);
        fixture core on sail { mass = 0.8 kg; }
        body left in sail { spatial; line from [0, 0, 0] m to [1.2, 0.3, 0] m; mesh 3 * cable(cord, rubber); }
        body right in sail { spatial; line from [0, 0, 0] m to [-0.7, 0.6, 0.4] m; mesh 2 * cable(cord, rubber); }
        joint left_root = clamp(left.start, sail);
        joint right_root = clamp(right.start, sail);
        constraint level = sail.ez.y;
        load sun = gravity(-pull * distance^2 * sail.position / norm(sail.position)^3, on = sail);
        load left_thrust = density(left, thrust * distance * (slope * dot(slope, inertial.in(sail)) - dot(slope, slope) * inertial.in(sail)) / dot(sail.position, sail.position));
        load wind = density(right, thrust * (dot(slope, slope) * left.end.in(sail) / (1 m) + position * slope.x / (1 m)));
        output tip = left.end;
    }
}

rncf::model! {
    /// Two cables in a frame that turns: under gravity, or under their weight per length.
    pub model Weight {
        /// Gravity on all bodies.
        param heavy = 0 m/s^2;
        /// Gravity that the loads per length stand for.
        param loaded = 0 m/s^2;
        const rho = 7800 kg/m^3;
        const area = 3 mm^2;
        material steel { density = rho; young = 210 GPa; }
        section wire { area = area; second_moment = 0.7 mm^4; }
        motion theta(t) = 0.7 [rad/s] * t;
        frame hub = rotating(axis = z, angle = theta(t));
        body rope in hub { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 4 * cable(wire, steel); }
        body strip in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 3 * cable(wire, steel); }
        joint root = clamp(rope.start, hub);
        joint foot = clamp(strip.start, inertial);
        load down = gravity([0, -heavy, 0]);
        load rope_weight = density(rope, -loaded * rho * area * inertial.ey.in(hub));
        load strip_weight = density(strip, [0, -loaded * rho * area, 0]);
        output tip = rope.end;
        output strip_tip = strip.end;
    }
}

rncf::model! {
    /// Spokes on a wheel that moves freely, written in a loop.
    pub model Spokes {
        /// Number of spokes.
        param count: count = 3;
        /// Load per length.
        param push = 0.2 N/m;
        material rubber { density = 1200 kg/m^3; young = 2 MPa; }
        section cord = circle(radius = 10 mm);
        frame hub = free(origin = [1, 0, 0] m, angular_velocity = [0, 0, 0.5] rad/s);
        fixture core on hub { mass = 0.8 kg; inertia = [0.1, 0.1, 0.1] kg*m^2; }
        for a in 0..count {
            body spoke[a] in hub {
                spatial;
                line from [0, 0, 0] m to [1 m * cos(2*pi*a/count), 1 m * sin(2*pi*a/count), 0 m];
                mesh 3 * cable(cord, rubber);
            }
            joint root[a] = clamp(spoke[a].start, hub);
            load wind[a] = density(spoke[a], push * (1 + a) * dot(slope, slope) * inertial.in(hub) / (1 m));
        }
        output tip = spoke[1].end;
    }
}

rncf::model! {
    /// The same, one by one.
    pub model Apart {
        param push = 0.2 N/m;
        material rubber { density = 1200 kg/m^3; young = 2 MPa; }
        section cord = circle(radius = 10 mm);
        frame hub = free(origin = [1, 0, 0] m, angular_velocity = [0, 0, 0.5] rad/s);
        fixture core on hub { mass = 0.8 kg; inertia = [0.1, 0.1, 0.1] kg*m^2; }
        body first in hub { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 3 * cable(cord, rubber); }
        body second in hub { spatial; line from [0, 0, 0] m to [1 m * cos(2*pi/3), 1 m * sin(2*pi/3), 0 m]; mesh 3 * cable(cord, rubber); }
        body third in hub { spatial; line from [0, 0, 0] m to [1 m * cos(4*pi/3), 1 m * sin(4*pi/3), 0 m]; mesh 3 * cable(cord, rubber); }
        joint first_root = clamp(first.start, hub);
        joint second_root = clamp(second.start, hub);
        joint third_root = clamp(third.start, hub);
        load one = density(first, push * dot(slope, slope) * inertial.in(hub) / (1 m));
        load two = density(second, push * 2 * dot(slope, slope) * inertial.in(hub) / (1 m));
        load three = density(third, push * 3 * dot(slope, slope) * inertial.in(hub) / (1 m));
        output tip = second.end;
    }
}

/// Numbers without pattern in [-1, 1].
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// The start at a time, shaken.
fn shaken(scene: &dyn Scene, t: f64, seed: u64) -> State {
    let mut state = scene.rest(t);
    let mut random = Random(seed);
    for i in 0..state.x.len() {
        state.v[i] += 0.3 * random.number();
        state.a[i] += random.number();
        if !scene.turns().iter().any(|&turn| (turn..turn + 3).contains(&i)) {
            state.x[i] += 0.1 * random.number();
        }
    }
    for turn in &mut state.turns {
        *turn *= UnitQuaternion::new(Vector3::new(random.number(), random.number(), random.number()));
    }
    state
}

fn residual(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut out = vec![0.0; scene.unknowns()];
    scene.residual(state, &mut out);
    out
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

/// Derivatives of the residual by x, at theta = 0, against differences.
#[test]
fn tangents_are_differences_of_the_residual() {
    let sail: Box<dyn Scene> = Sail::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let spokes: Box<dyn Scene> = Spokes::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    for mut scene in [sail, spokes] {
        let state = shaken(scene.as_ref(), 0.2, 5);
        let mut tangent = Tangent::default();
        scene.tangent(&state, &mut tangent);
        let pattern = scene.pattern().clone();
        let size = largest(&tangent.stiffness);
        for column in 0..scene.unknowns() {
            let moved = |step: f64| {
                let mut state = state.clone();
                state.x[column] += step;
                state
            };
            let step = 1e-6;
            let (high, low) = (
                residual(scene.as_mut(), &moved(step)),
                residual(scene.as_mut(), &moved(-step)),
            );
            for (row, (high, low)) in high.iter().zip(&low).enumerate() {
                let expected = (high - low) / (2.0 * step);
                let found = pattern.find(row, column).map_or(0.0, |entry| tangent.stiffness[entry]);
                assert!(
                    (found - expected).abs() < 1e-8 * size,
                    "{} by {}: {found} {expected}",
                    scene.describe_unknown(row),
                    scene.describe_unknown(column)
                );
            }
        }
    }
}

/// A load per length of the weight is gravity, in frames that turn and in both formulations.
#[test]
fn self_weight_is_gravity() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let build = |heavy, loaded| {
            let model = Weight { heavy, loaded };
            model.build(formulation, Joints::Eliminated).unwrap()
        };
        let [mut heavy, mut loaded, mut bare] = [build(9.81, 0.0), build(0.0, 9.81), build(0.0, 0.0)];
        let state = shaken(heavy.as_ref(), 0.8, 3);
        let [heavy, loaded, bare] = [&mut heavy, &mut loaded, &mut bare].map(|scene| residual(scene.as_mut(), &state));
        let weight: Vec<f64> = heavy.iter().zip(&bare).map(|(a, b)| a - b).collect();
        let size = largest(&heavy);
        assert!(largest(&weight) > 0.01);
        for (a, b) in heavy.iter().zip(&loaded) {
            assert!((a - b).abs() < 1e-14 * size, "{a} {b}");
        }
    }
}

#[test]
fn loads_in_a_loop_are_those_one_by_one() {
    let mut together = Spokes::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let mut apart = Apart::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let state = shaken(together.as_ref(), 0.2, 9);
    let (a, b) = (residual(together.as_mut(), &state), residual(apart.as_mut(), &state));
    assert_eq!(a.len(), b.len());
    let none = Apart { push: 0.0 }.build(Formulation::Rncf, Joints::Eliminated);
    let bare = residual(none.unwrap().as_mut(), &state);
    let load: Vec<f64> = a.iter().zip(&bare).map(|(a, b)| a - b).collect();
    assert!(largest(&load) > 0.1);
    for (a, b) in a.iter().zip(&b) {
        assert!((a - b).abs() < 1e-13 * largest(&bare), "{a} {b}");
    }
}

/// A shift of the frame feels the field on the whole mass, `m mu r / |r|^3`.
#[test]
fn a_field_is_felt_by_everything_that_the_frame_carries() {
    let build = |pull| {
        let model = Sail {
            pull,
            thrust: 0.0,
            ..Sail::default()
        };
        model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
    };
    let (mut pulled, mut bare) = (build(0.4), build(0.0));
    let state = shaken(pulled.as_ref(), 0.0, 4);
    let (a, b) = (residual(pulled.as_mut(), &state), residual(bare.as_mut(), &state));
    let first = a.len() - 6;
    let mut picture = Configuration::default();
    bare.configuration(&state, &mut picture);
    let r = picture.poses[1].0;
    let distance = r.iter().map(|x| x * x).sum::<f64>().sqrt();
    // Mass of the core and of both tethers.
    let lengths = (1.2_f64 * 1.2 + 0.09).sqrt() + (0.49_f64 + 0.36 + 0.16).sqrt();
    let mass = 0.8 + 1200.0 * std::f64::consts::PI * 1e-4 * lengths;
    for i in 0..3 {
        let (found, expected) = (a[first + i] - b[first + i], mass * 0.4 * 49.0 * r[i] / distance.powi(3));
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    }
}

#[test]
fn absolute_coordinates_are_refused_by_name() {
    let error = Sail::default()
        .build(Formulation::Ancf, Joints::Eliminated)
        .err()
        .expect("refused");
    let text = error.to_string();
    assert!(
        text.contains("`sail`") && text.contains("referenced formulation"),
        "{text}"
    );
}

rncf::model! {
    /// A hanging rope that knows its weight as gravity, or as a load per length.
    pub model Hanging {
        param heavy = 0 m/s^2;
        param loaded = 0 m/s^2;
        const rho = 7800 kg/m^3;
        const area = 3 mm^2;
        material steel { density = rho; young = 210 GPa; }
        section wire { area = area; second_moment = 0.7 mm^4; }
        body rope in inertial { spatial; line from [0, 0, 0] m to [0, 0, -2] m; mesh 2 * cable(wire, steel); }
        joint top = clamp(rope.start, inertial);
        load down = gravity([0, 0, -heavy]);
        load weight = density(rope, [0, 0, -loaded * rho * area]);
        output tension = rope.start.axial_force;
        output quarter = rope.at(0.5 m).axial_force;
    }
}

/// What a section carries is the same, whichever way the weight is given.
#[test]
fn section_forces_know_loads_per_length() {
    let outputs = |heavy, loaded| {
        let model = Hanging { heavy, loaded };
        let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let state = scene.rest(0.0);
        let mut out = [0.0; 2];
        scene.outputs(&state, &mut out);
        out
    };
    let (heavy, loaded) = (outputs(9.81, 0.0), outputs(0.0, 9.81));
    for (a, b) in heavy.iter().zip(loaded) {
        assert!((a - b).abs() < 1e-12, "{heavy:?} {loaded:?}");
    }
    assert!(heavy[0] > 0.1);
}
