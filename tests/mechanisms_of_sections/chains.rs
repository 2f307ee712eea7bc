//! A chain of beams on a hub: revolute joint, universal joint, a corner of two flexible ends, a rigid tool at the end.

// Models from one template do not use all of its params.
#![allow(deprecated)]

use crate::running::{WAYS, apart, build, momenta, rows, run, violation};

/// The chain; `$hub` declares the frame `hub` of its first beam and the velocities.
macro_rules! chain {
    ($name:ident, { $($hub:tt)* }) => {
        rncf::model! {
            pub model $name {
                param elements: count = 1;
                param young = 50 MPa;
                material rubber { density = 1000 kg/m^3; young = young; poisson = 0.3; }
                section round = circle(radius = 20 mm);
                $($hub)*
                frame middle = free(origin = [0.5, 0, 0] m, velocity = [v_x, v_y + w_z * 0.5 m, v_z - w_y * 0.5 m], angular_velocity = [w_x, w_y, w_z]);
                frame outer = free(origin = [0.9, 0, 0] m, velocity = [v_x, v_y + w_z * 0.9 m, v_z - w_y * 0.9 m], angular_velocity = [w_x, w_y, w_z]);
                body first in hub { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh elements * beam(round, rubber); }
                body second in middle { spatial; line from [0, 0, 0] m to [0.4, 0, 0] m; mesh elements * beam(round, rubber); }
                body third in outer { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; mesh elements * beam(round, rubber); }
                body fourth in outer { spatial; line from [0.3, 0, 0] m to [0.3, 0.3, 0] m; mesh elements * beam(round, rubber); }
                rigid tool {
                    mass = 0.5 kg; inertia = [1, 2, 3] g*m^2;
                    origin = [1.2, 0.3, 0] m;
                    velocity = [v_x - w_z * 0.3 m, v_y + w_z * 1.2 m, v_z + w_x * 0.3 m - w_y * 1.2 m];
                    angular_velocity = [w_x, w_y, w_z];
                }
                joint _root = clamp(first.start, hub);
                joint _tie_second = clamp(second.start, middle);
                joint _tie_third = clamp(third.start, outer);
                joint elbow = revolute(first.end, second.start, axis = z);
                joint wrist = universal(second.end, third.start, axis = y, cross = z);
                joint corner = weld(third.end, fourth.start);
                joint grip = weld(fourth.end, tool);
                output tool_at = tool.in(inertial);
                output tip = first.end.in(inertial);
                output bend = elbow.angle;
                output pull = grip.force;
                output turn = grip.moment;
            }
        }
    };
}

chain!(Driven, {
    const v_x = 0 m/s;
    const v_y = 0 m/s;
    const v_z = 0 m/s;
    const w_x = 0 rad/s;
    const w_y = 0 rad/s;
    const w_z = 0 rad/s;
    motion theta(t) = 3 [rad/s^3] * t^3;
    frame hub = rotating(axis = z, angle = theta(t));
    load weight = gravity([0, 0, -9.81] m/s^2);
});

chain!(Floating, {
    param v_x = 1 m/s;
    param v_y = 0.2 m/s;
    param v_z = -0.1 m/s;
    param w_x = 1.5 rad/s;
    param w_y = -0.8 rad/s;
    param w_z = 2 rad/s;
    frame hub = free(velocity = [v_x, v_y, v_z], angular_velocity = [w_x, w_y, w_z]);
});

rncf::model! {
    /// The floating chain of rigid bodies.
    pub model Rigid {
        const area = pi * 4e-4 [m^2];
        const second = pi * 4e-8 [m^4];
        const density = 1000 kg/m^3;
        const per_length = density * area;
        // Of a cylinder about its middle, for a length.
        const polar = 2 * density * second;
        const v_x = 1 m/s;
        const v_y = 0.2 m/s;
        const v_z = -0.1 m/s;
        const w_x = 1.5 rad/s;
        const w_y = -0.8 rad/s;
        const w_z = 2 rad/s;
        const a = 0.5 m;
        const b = 0.4 m;
        const c = 0.3 m;
        const across_a = per_length * a^3 / 12 + density * second * a;
        const across_b = per_length * b^3 / 12 + density * second * b;
        const across_c = per_length * c^3 / 12 + density * second * c;
        rigid first {
            mass = per_length * a; center = [a / 2, 0, 0]; inertia = [polar * a, across_a, across_a];
            velocity = [v_x, v_y, v_z]; angular_velocity = [w_x, w_y, w_z];
        }
        rigid second_part {
            mass = per_length * b; center = [b / 2, 0, 0]; inertia = [polar * b, across_b, across_b];
            origin = [0.5, 0, 0] m; velocity = [v_x, v_y + w_z * a, v_z - w_y * a]; angular_velocity = [w_x, w_y, w_z];
        }
        rigid third {
            mass = per_length * c; center = [c / 2, 0, 0]; inertia = [polar * c, across_c, across_c];
            origin = [0.9, 0, 0] m; velocity = [v_x, v_y + w_z * 0.9 m, v_z - w_y * 0.9 m]; angular_velocity = [w_x, w_y, w_z];
        }
        fixture fourth on third.at([0.3, 0.15, 0] m) { mass = per_length * c; inertia = [across_c, polar * c, across_c]; }
        fixture tool on third.at([0.3, 0.3, 0] m) { mass = 0.5 kg; inertia = [1, 2, 3] g*m^2; }
        joint elbow = revolute(first.at([0.5, 0, 0] m), second_part, axis = z);
        joint wrist = universal(second_part.at([0.4, 0, 0] m), third, axis = y, cross = z);
        output tool_at = third.at([0.3, 0.3, 0] m).in(inertial);
        output tip = first.at([0.5, 0, 0] m).in(inertial);
        output bend = elbow.angle;
    }
}

/// All ways give the same motion and the same reactions, and no joint opens.
#[test]
fn driven_chain_in_all_ways() {
    let model = Driven::default();
    let mut first: Option<Vec<Vec<f64>>> = None;
    for way in WAYS {
        let mut scene = build(&model, way);
        let states = run(scene.as_mut(), 0.3, 6, 1e-7);
        let rows = rows(scene.as_mut(), &states);
        let open = states
            .iter()
            .map(|state| violation(scene.as_mut(), state))
            .fold(0.0, f64::max);
        let first = first.get_or_insert_with(|| rows.clone());
        let (place, force) = (apart(first, &rows, 0..7), apart(first, &rows, 7..13));
        println!(
            "{way:?}: places {place:.1e}, reactions {force:.1e}, joints open by {open:.1e}; {:?}",
            rows[6]
        );
        assert!(place < 1e-5 && force < 5e-2 && open < 1e-9);
    }
    let rows = first.unwrap();
    // It really moves, and bends in its joints.
    assert!(apart(&rows[..1], &rows[6..], 0..3) > 0.1, "{rows:?}");
}

#[test]
fn floating_chain_keeps_energy_and_momenta() {
    let model = Floating::default();
    let mut first: Option<Vec<Vec<f64>>> = None;
    for way in WAYS {
        let mut scene = build(&model, way);
        let states = run(scene.as_mut(), 0.25, 5, 1e-7);
        let rows = rows(scene.as_mut(), &states);
        let energies: Vec<f64> = states.iter().map(|state| scene.energy(state).unwrap()).collect();
        let kept: Vec<[f64; 6]> = states.iter().map(|state| momenta(scene.as_mut(), state)).collect();
        let energy = energies
            .iter()
            .fold(0.0, |most: f64, e| most.max((e / energies[0] - 1.0).abs()));
        let mut drift = [0.0f64; 2];
        for now in &kept {
            for k in 0..6 {
                drift[k / 3] = drift[k / 3].max((now[k] - kept[0][k]).abs());
            }
        }
        let open = states
            .iter()
            .map(|state| violation(scene.as_mut(), state))
            .fold(0.0, f64::max);
        let first = first.get_or_insert_with(|| rows.clone());
        let (place, force) = (apart(first, &rows, 0..7), apart(first, &rows, 7..13));
        println!(
            "{way:?}: energy {energy:.1e}, momenta {drift:?} of {:.3?}, places {place:.1e}, reactions {force:.1e}, open {open:.1e}",
            kept[0]
        );
        assert!(energy < 1e-5 && drift[0] < 1e-6 && drift[1] < 1e-6);
        assert!(place < 1e-5 && force < 5e-2 && open < 1e-9);
    }
}

/// What deforms little moves as rigid bodies, and the stiffer it is, the more so.
#[test]
fn stiff_chain_moves_as_rigid_bodies() {
    let mut rigid = build(&Rigid::default(), WAYS[0]);
    let states = run(rigid.as_mut(), 0.3, 6, 1e-9);
    let expected = rows(rigid.as_mut(), &states);
    let mut before = [f64::INFINITY; 2];
    for young in [5e9, 50e9] {
        let model = Floating {
            young,
            ..Floating::default()
        };
        for (k, way) in [WAYS[0], WAYS[2]].into_iter().enumerate() {
            let mut scene = build(&model, way);
            let states = run(scene.as_mut(), 0.3, 6, 1e-7);
            let rows = rows(scene.as_mut(), &states);
            let error = apart(&expected, &rows, 0..7);
            println!("{young:e} Pa, {way:?}: {error:.1e}");
            assert!(k == 1 || error < 0.2 * before[k], "{error}");
            before[k] = error;
        }
    }
    assert!(before[0] < 2e-5 && before[1] < 5e-5, "{before:?}");
}
