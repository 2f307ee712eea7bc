//! Torque, bending and torsional vibrations through every condition on a section, against closed forms, on meshes from
//! one element to 16 a half.

use rncf::equilibrium::Uniform;
use rncf::modes::{Wanted, modes};
use rncf::prelude::*;

use crate::running::{WAYS, at_rest, build};

rncf::model! {
    /// Steel shafts of 1 m, each of two halves that another joint connects, twisted and bent at the end.
    pub model Shafts {
        /// Of a half, and of a whole shaft.
        param elements: count = 1;
        param whole: count = 2;
        param torque = 0 N*m;
        param push = 0 N;
        /// Of the spring between two halves.
        const coil = 1e6 N*m/rad;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 50 mm);
        body weld_1 { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh elements * beam(round, steel); }
        body weld_2 { spatial; line from [0.5, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        joint weld_root = clamp(weld_1.start, inertial);
        joint weld = weld(weld_1.end, weld_2.start);
        body drive_1 { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh elements * beam(round, steel); }
        body drive_2 { spatial; line from [0.5, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        joint drive_root = clamp(drive_1.start, inertial);
        joint drive_hinge = revolute(drive_1.end, drive_2.start, axis = x);
        joint drive = drive(drive_hinge.angle, 0 rad);
        body coil_1 { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh elements * beam(round, steel); }
        body coil_2 { spatial; line from [0.5, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        joint coil_root = clamp(coil_1.start, inertial);
        joint coil_hinge = revolute(coil_1.end, coil_2.start, axis = x);
        spring coil_spring = torsional(coil_hinge, stiffness = coil);
        body slide_1 { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh elements * beam(round, steel); }
        body slide_2 { spatial; line from [0.5, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        joint slide_root = clamp(slide_1.start, inertial);
        joint slide_guide = prismatic(slide_1.end, slide_2.start, axis = x);
        joint slide = drive(slide_guide.slide, 0 m);
        body rigid_1 { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh elements * beam(round, steel); }
        body rigid_2 { spatial; line from [0.5, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        rigid between { mass = 1 g; inertia = [10, 10, 10] g*mm^2; origin = [0.5, 0, 0] m; }
        joint rigid_root = clamp(rigid_1.start, inertial);
        joint rigid_left = weld(rigid_1.end, between);
        joint rigid_right = weld(between, rigid_2.start);
        // The cross of a universal joint carries the torque; its other end lies on supports.
        body cross_1 { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh elements * beam(round, steel); }
        body cross_2 { spatial; line from [0.5, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        joint cross_root = clamp(cross_1.start, inertial);
        joint knuckle = universal(cross_1.end, cross_2.start, axis = y, cross = z);
        joint cross_y = hold(cross_2.end.y);
        joint cross_z = hold(cross_2.end.z);
        // Held by one coordinate of a section at the start, as a motor does.
        body motor { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh whole * beam(round, steel); }
        joint motor_pin = pin(motor.start, inertial);
        joint motor_hold = hold(motor.start.ey.z);
        joint motor_y = hold(motor.end.y);
        joint motor_z = hold(motor.end.z);
        output weld_at = weld_2.end;
        output weld_y = weld_2.end.ey;
        output weld_z = weld_2.end.ez;
        output drive_at = drive_2.end;
        output drive_y = drive_2.end.ey;
        output drive_z = drive_2.end.ez;
        output coil_at = coil_2.end;
        output coil_y = coil_2.end.ey;
        output coil_z = coil_2.end.ez;
        output slide_at = slide_2.end;
        output slide_y = slide_2.end.ey;
        output slide_z = slide_2.end.ez;
        output rigid_at = rigid_2.end;
        output rigid_y = rigid_2.end.ey;
        output rigid_z = rigid_2.end.ez;
        output cross_at = cross_2.end;
        output cross_y = cross_2.end.ey;
        output cross_z = cross_2.end.ez;
        output motor_at = motor.end;
        output motor_y = motor.end.ey;
        output motor_z = motor.end.ez;
        load weld_torque = moment(weld_2.end, [torque, 0, 0]);
        load drive_torque = moment(drive_2.end, [torque, 0, 0]);
        load coil_torque = moment(coil_2.end, [torque, 0, 0]);
        load slide_torque = moment(slide_2.end, [torque, 0, 0]);
        load rigid_torque = moment(rigid_2.end, [torque, 0, 0]);
        load cross_torque = moment(cross_2.end, [torque, 0, 0]);
        load motor_torque = moment(motor.end, [torque, 0, 0]);
        load weld_push = force(weld_2.end, [0, push, push / 2]);
        load drive_push = force(drive_2.end, [0, push, push / 2]);
        load coil_push = force(coil_2.end, [0, push, push / 2]);
        load slide_push = force(slide_2.end, [0, push, push / 2]);
        load rigid_push = force(rigid_2.end, [0, push, push / 2]);
    }
}

rncf::model! {
    /// A steel shaft of 1 m that forces twist beside its axis, one that a spring beside it holds at its start, and one that a place
    /// beside it does.
    pub model Levers {
        param elements: count = 1;
        param torque = 0 N*m;
        const arm = 50 mm;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 50 mm);
        body couple { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        joint couple_root = clamp(couple.start, inertial);
        load up = force(couple.end.beside([0 m, arm, 0 m]), [0 N, 0 N, torque / (2 * arm)]);
        load down = force(couple.end.beside([0 m, -arm, 0 m]), [0 N, 0 N, -torque / (2 * arm)]);
        body spring { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        joint spring_pin = pin(spring.start, inertial);
        joint spring_y = hold(spring.end.y);
        joint spring_z = hold(spring.end.z);
        spring lever = bushing(spring.start.beside([0 m, arm, 0 m]), inertial.at([0 m, arm, 0 m]), stiffness = [0, 0, 1] GN/m);
        load turn = moment(spring.end, [torque, 0 [N*m], 0 [N*m]]);
        body place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(round, steel); }
        joint place_pin = pin(place.start, inertial);
        joint place_y = hold(place.end.y);
        joint place_z = hold(place.end.z);
        constraint place_held = place.start.beside([0 m, arm, 0 m]).z;
        load twist = moment(place.end, [torque, 0 [N*m], 0 [N*m]]);
        output couple_y = couple.end.ey.z;
        output couple_z = -couple.end.ez.y;
        output spring_y = spring.end.ey.z;
        output spring_z = -spring.end.ez.y;
        output place_y = place.end.ey.z;
        output place_z = -place.end.ez.y;
        output around = (couple.end.beside([0 m, arm, 0 m]).z - couple.end.beside([0 m, -arm, 0 m]).z) / (2 * arm);
    }
}

const NAMES: [&str; 7] = ["weld", "drive", "spring", "slide", "rigid", "cross", "motor"];
const RADIUS: f64 = 0.05;
const YOUNG: f64 = 210e9;
const SHEAR: f64 = YOUNG / 2.6;

fn polar() -> f64 {
    std::f64::consts::PI * RADIUS.powi(4) / 2.0
}

/// Twist over the closed form for every connection.
fn twists(elements: usize, way: (Formulation, Joints)) -> Vec<f64> {
    let torque = 1e-4 * SHEAR * polar();
    let row = at_rest(
        &Shafts {
            elements,
            whole: 2 * elements,
            torque,
            ..Shafts::default()
        },
        way,
    );
    let shafts = row.chunks_exact(9).zip(NAMES);
    let twist = |(shaft, name): (&[f64], &str)| {
        let (y, z) = (&shaft[3..6], &shaft[6..9]);
        let angle = (y[2] - z[1]).atan2(y[1] + z[2]);
        let coil = if name == "spring" { torque / 1e6 } else { 0.0 };
        (angle - coil) / 1e-4
    };
    shafts.map(twist).collect()
}

#[test]
fn torque_goes_through_every_condition() {
    for (way, meshes) in [(WAYS[0], &[1, 4, 8, 16][..]), (WAYS[1], &[1, 8])] {
        for &elements in meshes {
            let found = twists(elements, way);
            println!("{way:?}, {elements} elements a half: {found:.7?} of T L/(G J), {NAMES:?}");
            for (twist, name) in found.into_iter().zip(NAMES) {
                assert!((twist - 1.0).abs() < 1e-6, "{name}, {elements} elements: {twist}");
            }
        }
    }
}

/// The end's deflection is that of one Timoshenko beam.
#[test]
fn bending_goes_through_every_condition() {
    let area = std::f64::consts::PI * RADIUS * RADIUS;
    let factor = 6.0 * 1.3 / (7.0 + 6.0 * 0.3);
    let flexibility = 1.0 / (3.0 * YOUNG * polar() / 2.0) + 1.0 / (factor * SHEAR * area);
    let push = 1e-6 / flexibility;
    for elements in [1, 8, 16] {
        let model = Shafts {
            elements,
            whole: 2 * elements,
            push,
            ..Shafts::default()
        };
        let row = at_rest(&model, WAYS[0]);
        for (shaft, name) in row.chunks_exact(9).zip(NAMES).take(5) {
            let errors = [shaft[1] / 1e-6 - 1.0, shaft[2] / 5e-7 - 1.0];
            println!("{name}, {elements} elements a half: {errors:?}");
            assert!(
                errors.iter().all(|error| error.abs() < 1e-6),
                "{name}, {elements}: {errors:?}"
            );
        }
    }
}

/// All but the shaft with a spring vibrate in torsion as one shaft that is clamped at one end.
#[test]
fn torsional_frequencies() {
    let exact = std::f64::consts::FRAC_PI_2 * (SHEAR / 7850.0).sqrt();
    let model = Shafts {
        elements: 5,
        whole: 10,
        ..Shafts::default()
    };
    let mut scene = build(&model, WAYS[0]);
    let at = Uniform::at_rest(0.0);
    let state = scene.uniform_guess(&at);
    let found = modes(scene.as_mut(), &at, &state, Wanted { count: 40 }).unwrap();
    let errors = found.iter().map(|mode| mode.im / exact - 1.0);
    let near: Vec<f64> = errors.filter(|error| error.abs() < 1e-3).collect();
    println!("{exact:.3} rad/s, off by {near:?}");
    assert_eq!(near.iter().filter(|error| error.abs() < 1e-6).count(), 6, "{near:?}");
}

/// Forces, springs and conditions beside the axis twist the section and do not shear it, on any mesh.
#[test]
fn what_acts_beside_the_axis_twists_the_section() {
    let torque = 1e-4 * SHEAR * polar();
    let spring = torque / (1e9 * 0.05 * 0.05) / 1e-4;
    for elements in [1, 8, 32] {
        for way in [WAYS[0], WAYS[1]] {
            let model = Levers { elements, torque };
            let row = at_rest(&model, way);
            let found: Vec<f64> = row.iter().map(|angle| angle / 1e-4).collect();
            println!("{elements} elements: {found:?}");
            let wanted = [1.0, 1.0, 1.0 + spring, 1.0 + spring, 1.0, 1.0, 1.0];
            for (found, wanted) in found.iter().zip(wanted) {
                assert!((found - wanted).abs() < 2e-6, "{elements} {way:?}: {found} {wanted}");
            }
        }
    }
}
