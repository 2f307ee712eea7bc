//! Rigid parts on sections: the section below a disc stays what it is at any speed, and whirl, torsion, bending and what
//! sections carry are those of rigid parts.

use rncf::equilibrium::Uniform;
use rncf::modes::{Wanted, modes};
use rncf::prelude::*;
use rncf::steady;

use crate::running::{WAYS, at_rest, build};

rncf::model! {
    /// A steel shaft with two equal discs on bearings that are as stiff in all directions (ROSS 2.3.0, the two-disc example).
    pub model Rotor {
        param speed = 400 rad/s;
        param elements: count = 12;
        material steel { density = 7810 kg/m^3; young = 211 GPa; poisson = 0.29926108; }
        section round = circle(radius = 25 mm);
        frame spin = rotating(axis = x, angle = speed * t);
        body shaft in spin { spatial; line from [0, 0, 0] m to [1.5, 0, 0] m; mesh elements * beam(round, steel); }
        joint axial = hold(shaft.start.x);
        joint motor = hold(shaft.start.twist);
        fixture first on shaft.at(0.5 m) { mass = 32.589728 kg; inertia = [0.32956362, 0.17808928, 0.17808928] kg*m^2; }
        fixture second on shaft.at(1 m) { mass = 32.589728 kg; inertia = [0.32956362, 0.17808928, 0.17808928] kg*m^2; }
        spring left = bushing(shaft.start, inertial.at([0, 0, 0] m), stiffness = [0, 1000, 1000] kN/m);
        spring right = bushing(shaft.end, inertial.at([1.5, 0, 0] m), stiffness = [0, 1000, 1000] kN/m);
        output ey = shaft.at(0.5 m).ey;
        output ez = shaft.at(0.5 m).ez;
    }
}

rncf::model! {
    /// Beams without inertia, each with the same tool at its end, whose centre of mass is beyond it: two in different directions, one that
    /// goes on behind the tool, one with a part on its full clamp, and one in a plane.
    pub model Tools {
        param elements: count = 1;
        param weight = 0 m/s^2;
        material light { density = 20 g/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 10 mm);
        for a in 0..2 {
            body arm[a] {
                spatial;
                line from [0, 0, 0] m to [0.5 m * cos(a * 1 rad), 0.5 m * sin(a * 1 rad), 0];
                mesh elements * beam(round, light);
            }
            joint root[a] = clamp(arm[a].start, inertial);
            fixture tool[a] on arm[a].end { mass = 2 kg; center = [60, 0, 0] mm; inertia = [3000, 5000, 5000] kg*mm^2; }
        }
        body before { spatial; line from [0, 0, 0] m to [0, 0, 0.5] m; mesh elements * beam(round, light); }
        body behind { spatial; line from [0, 0, 0.5] m to [0, 0, 0.7] m; mesh elements * beam(round, light); }
        joint before_root = clamp(before.start, inertial);
        joint one = merge(before.end, behind.start);
        fixture half on before.end { mass = 1 kg; center = [60, 0, 0] mm; inertia = [1500, 2500, 2500] kg*mm^2; }
        fixture other on behind.start { mass = 1 kg; center = [60, 0, 0] mm; inertia = [1500, 2500, 2500] kg*mm^2; }
        body foot { spatial; line from [0, 0, 0] m to [0, 0.5, 0] m; mesh elements * beam(round, light); }
        joint foot_root = clamp_full(foot.start, inertial);
        fixture base on foot.start { mass = 1 kg; center = [10, 20, 30] mm; inertia = [1, 1, 1] g*m^2; }
        fixture first on foot.end { mass = 1 kg; center = [60, 0, 0] mm; inertia = [1500, 2500, 2500] kg*mm^2; }
        fixture second on foot.end { mass = 1 kg; center = [60, 0, 0] mm; inertia = [1500, 2500, 2500] kg*mm^2; }
        body flat { planar zx; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh elements * beam(round, light); }
        joint flat_root = clamp(flat.start, inertial);
        fixture planar_tool on flat.end { mass = 2 kg; center = [60, 0, 0] mm; inertia = 5000 kg*mm^2; }
        load pull = gravity([0 [m/s^2], 0 [m/s^2], -weight]);
        output end = flat.end.z;
        output behind_end = behind.end;
        output foot_end = foot.end;
        output highest = max(a in 0..2, arm[a].end.z);
        output lowest = min(a in 0..2, arm[a].end.z);
    }
}

rncf::model! {
    /// A stiff spoke that turns about z with a part inside of an element, and a planar one.
    pub model Spokes {
        param speed = 20 rad/s;
        param elements: count = 3;
        param offset = 50 mm;
        material stiff { density = 7800 kg/m^3; young = 2e6 GPa; poisson = 0.3; }
        section bar = rectangle(y = 30 mm, z = 20 mm);
        frame hub = rotating(axis = z, angle = speed * t);
        body spoke in hub { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(bar, stiff); }
        joint root = clamp(spoke.start, hub);
        fixture part on spoke.at(0.4 m) { mass = 3 kg; center = [offset, 20 mm, 10 mm]; inertia = [3, 4, 5] g*m^2; }
        body blade in hub { planar xy; line from [0, 0, 0] m to [0, 1, 0] m; mesh elements * beam(bar, stiff); }
        joint blade_root = clamp(blade.start, hub);
        fixture plate on blade.at(0.4 m) { mass = 3 kg; center = [offset, 20 mm, 0]; inertia = 5 g*m^2; }
        output force = root.force;
        output moment = root.moment;
        output axial = spoke.start.axial_force;
        output torque = spoke.start.torque;
        output bending_y = spoke.start.moment_y;
        output bending_z = spoke.start.moment_z;
        output beyond = spoke.at(0.5 m).axial_force;
        output beyond_y = spoke.at(0.5 m).moment_y;
        output beyond_z = spoke.at(0.5 m).moment_z;
        output blade_force = blade_root.force;
        output blade_moment = blade_root.moment.z;
        output blade_axial = blade.start.axial_force;
        output blade_bending = blade.start.moment_z;
        output blade_beyond = blade.at(0.5 m).moment_z;
    }
}

rncf::model! {
    /// A blade that is to start in its relative equilibrium, with a part that keeps its end rigid.
    pub model Started {
        material steel { density = 7800 kg/m^3; young = 200 GPa; poisson = 0.3; }
        section bar = rectangle(y = 30 mm, z = 20 mm);
        frame hub = rotating(axis = z, angle = 20 [rad/s] * t);
        body blade in hub { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * beam(bar, steel); }
        joint root = clamp(blade.start, hub);
        fixture plate on blade.end { mass = 3 kg; inertia = 5 g*m^2; }
        start spun = spinning(hub);
        output tip = blade.end;
    }
}

/// Frequencies in the rotating frame, ascending, and the section's axes below the first disc.
fn spinning(model: &Rotor, way: (Formulation, Joints), count: usize) -> (Vec<f64>, Vec<f64>) {
    let mut scene = build(model, way);
    let at = Uniform::steady(0.0);
    let found = steady(scene.as_mut(), 0.0).unwrap();
    let state = found.state().unwrap();
    let mut row = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&at, state, &mut row);
    assert!(scene.warnings(state).is_empty());
    let found = modes(scene.as_mut(), &at, state, Wanted { count }).unwrap();
    (found.iter().map(|mode| mode.im).collect(), row)
}

/// How far the nearest of the frequencies found is from a frequency in fixed axes, relative to that.
fn off(found: &[f64], wanted: f64, speed: f64, is_forward: bool) -> f64 {
    let seen = if is_forward {
        (wanted - speed).abs()
    } else {
        wanted + speed
    };
    let apart = found.iter().map(|frequency| (frequency - seen).abs());
    apart.fold(f64::INFINITY, f64::min) / wanted
}

/// At nodes, and inside of elements.
#[test]
fn the_section_below_a_disc_keeps_its_shape() {
    for (speed, elements) in [(400.0, 12), (890.0, 12), (890.0, 4)] {
        let (_, row) = spinning(&Rotor { speed, elements }, WAYS[0], 1);
        let (y, z) = (&row[..3], &row[3..6]);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let strains = [dot(y, y) - 1.0, dot(z, z) - 1.0, dot(y, z)];
        println!("{speed} rad/s, {elements} elements: {strains:?}");
        assert!(strains.iter().all(|strain| strain.abs() < 1e-13), "{strains:?}");
    }
}

/// Backward and forward whirl at 400 rad/s, and forward critical speeds, by ROSS.
#[test]
fn whirl_and_critical_speeds_are_those_of_rigid_discs() {
    let whirl = [
        (95.39519, false),
        (97.13544, true),
        (283.1670, false),
        (309.5558, true),
        (696.938, false),
        (826.703, true),
    ];
    for (elements, way) in [(12, WAYS[0]), (12, WAYS[1]), (48, WAYS[0])] {
        let (found, _) = spinning(&Rotor { speed: 400.0, elements }, way, 14);
        let errors = whirl.map(|(wanted, is_forward)| off(&found, wanted, 400.0, is_forward));
        println!("{elements} elements, {way:?}: off by {errors:?}");
        assert!(errors.iter().all(|error| *error < 1e-4), "{errors:?}");
    }
    for speed in [96.49729, 306.5343, 891.1975] {
        let rotor = Rotor { speed, elements: 12 };
        let (found, _) = spinning(&rotor, WAYS[0], 4);
        let error = off(&found, speed, speed, true);
        println!("critical at {speed} rad/s: off by {error:.1e}");
        assert!(error < 1e-4);
    }
}

/// What is left of the angle at the held start when the free end vibrates by one: zero at frequencies of torsion.
fn held_angle(frequency: f64) -> f64 {
    let shear = 211e9 / (2.0 * 1.29926108);
    let wave = frequency * (7810.0_f64 / shear).sqrt();
    let stiffness = shear * std::f64::consts::PI * 0.025_f64.powi(4) / 2.0 * wave;
    let (mut angle, mut torque) = (1.0, 0.0);
    for disc in [0.32956362, 0.32956362, 0.0] {
        let (sin, cos) = (0.5 * wave).sin_cos();
        (angle, torque) = (
            angle * cos - torque / stiffness * sin,
            stiffness * angle * sin + torque * cos,
        );
        torque += frequency * frequency * disc * angle;
    }
    angle
}

#[test]
fn torsion_of_a_shaft_with_two_discs() {
    let crossings = (10..3000).filter(|&at| held_angle(f64::from(at)) * held_angle(f64::from(at + 1)) < 0.0);
    let exact = crossings.map(|at| {
        let (mut low, mut high) = (f64::from(at), f64::from(at + 1));
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if held_angle(low) * held_angle(middle) < 0.0 {
                high = middle;
            } else {
                low = middle;
            }
        }
        low
    });
    let exact: Vec<f64> = exact.collect();
    println!("{exact:.4?} rad/s");
    assert!(exact.len() >= 2);
    for elements in [3, 12, 48] {
        let mut scene = build(&Rotor { speed: 0.0, elements }, WAYS[0]);
        let at = Uniform::at_rest(0.0);
        let state = scene.uniform_guess(&at);
        let found = modes(scene.as_mut(), &at, &state, Wanted { count: 14 }).unwrap();
        for &wanted in &exact[..2] {
            let apart = found.iter().map(|mode| (mode.im / wanted - 1.0).abs());
            let error = apart.fold(f64::INFINITY, f64::min);
            println!("{elements} elements: {wanted:.3} rad/s off by {error:.1e}");
            assert!(error < 1e-6);
        }
    }
}

/// Frequencies of a part of 2 kg whose centre is 60 mm beyond the end of a beam without inertia, rad/s: bending twice, torsion;
/// and how far it sinks at rest by 1 m/s^2, m.
fn tool() -> ([f64; 3], f64) {
    let (young, length, radius): (f64, f64, f64) = (210e9, 0.5, 0.01);
    let shear = young / 2.6;
    let area = std::f64::consts::PI * radius * radius;
    let second = area * radius * radius / 4.0;
    let bending = young * second;
    // Deflection and slope of the end by force and moment there (Timoshenko).
    let sheared = 6.0 * 1.3 / (7.0 + 6.0 * 0.3) * shear * area;
    let flexibility = [
        [
            length.powi(3) / (3.0 * bending) + length / sheared,
            length.powi(2) / (2.0 * bending),
        ],
        [length.powi(2) / (2.0 * bending), length / bending],
    ];
    let (mass, center): (f64, f64) = (2.0, 0.06);
    let inertia = [[mass, mass * center], [mass * center, 5e-3 + mass * center * center]];
    let entry = |i: usize, j: usize| (0..2).map(|k| flexibility[i][k] * inertia[k][j]).sum::<f64>();
    let (half, determinant) = (
        0.5 * (entry(0, 0) + entry(1, 1)),
        entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0),
    );
    let root = (half * half - determinant).sqrt();
    let torsion = (2.0 * shear * second / length / 3e-3).sqrt();
    let frequencies = [(half + root).powf(-0.5), (half - root).powf(-0.5), torsion];
    (frequencies, mass * (flexibility[0][0] + center * flexibility[0][1]))
}

#[test]
fn parts_beyond_the_end_sink_as_rigid_ones() {
    let (weight, exact) = (1e-3, 1e-3 * tool().1);
    for elements in [1, 4, 64] {
        let row = at_rest(&Tools { elements, weight }, WAYS[0]);
        let [end, highest, lowest] = [row[0], row[row.len() - 2], row[row.len() - 1]];
        println!("{elements} elements: {end:e} {highest:e} {lowest:e} instead of {exact:e} m");
        assert!(
            [end, highest, lowest]
                .iter()
                .all(|sunk| (sunk / exact + 1.0).abs() < 1e-6)
        );
    }
}

/// Alike for repeated parts, in all directions, at common ends, for two on one section, beside full clamps and in a plane.
#[test]
fn parts_beyond_the_end_vibrate_as_rigid_ones() {
    let (exact, _) = tool();
    for (elements, way) in [(1, WAYS[0]), (1, WAYS[1]), (1, WAYS[2]), (4, WAYS[3]), (16, WAYS[0])] {
        let mut scene = build(
            &Tools {
                elements,
                ..Tools::default()
            },
            way,
        );
        let at = Uniform::at_rest(0.0);
        let state = scene.uniform_guess(&at);
        let found = modes(scene.as_mut(), &at, &state, Wanted { count: 18 }).unwrap();
        // The slope of a body that goes on is one before and behind the part, where the shear force leaps: of its two modes the
        // error falls with the mesh.
        let on_mesh = 5e-5 / elements as f64;
        // Nine in bending, four in torsion, and as many of the higher ones in bending as are left.
        for (wanted, all, exact) in [(exact[0], 9, 7), (exact[1], 5, 3), (exact[2], 4, 4)] {
            let errors = found.iter().map(|mode| (mode.im / wanted - 1.0).abs());
            let mut near: Vec<f64> = errors.filter(|error| *error < 1e-3).collect();
            near.sort_by(f64::total_cmp);
            println!("{elements} elements, {way:?}: {wanted:.3} rad/s, off by {near:?}");
            assert_eq!(near.len(), all, "{wanted}: {found:?}");
            let (ends, meshed) = near.split_at(exact);
            assert!(ends.iter().all(|error| *error < 3e-6), "{wanted}: {ends:?}");
            assert!(
                meshed.iter().all(|error| *error < 3e-6 + on_mesh),
                "{wanted}: {meshed:?}"
            );
        }
    }
}

/// Force and moment in the root are those of the mass, and those that sections carry leap by what the part does, whether its
/// centre is along the body or beside it.
#[test]
fn sections_carry_what_the_part_does() {
    let (mass, speed, radius) = (3.0, 20.0_f64, 0.4);
    let square = speed * speed;
    let line = 7800.0 * 0.03 * 0.02;
    for offset in [0.05, 0.0] {
        let model = Spokes {
            offset,
            ..Spokes::default()
        };
        for way in [WAYS[0], WAYS[1]] {
            let mut scene = build(&model, way);
            let found = steady(scene.as_mut(), 0.0).unwrap();
            let mut row = vec![0.0; scene.output_columns()];
            scene.uniform_outputs(&Uniform::steady(0.0), found.state().unwrap(), &mut row);
            let [x, y, z] = [radius + offset, 0.02, 0.01];
            let pull = mass * square * x + line * square / 2.0;
            let expected = [
                // Joints pull back what flies away.
                -pull,
                -mass * square * y,
                0.0,
                z * mass * square * y,
                -z * mass * square * x,
                0.0,
            ];
            println!("{way:?}, {offset} m: {row:.4?}");
            for (found, wanted) in row.iter().zip(expected) {
                assert!((found - wanted).abs() < 1e-3 * pull, "{row:?} {expected:?}");
            }
            // The section at the start carries what the joint does.
            let [axial, torque, moment_y, moment_z] = [row[6], row[7], row[8], row[9]];
            assert!((axial + row[0]).abs() < 1e-9 * pull && (torque + row[3]).abs() < 1e-9 * pull);
            assert!((moment_y + row[4]).abs() < 1e-9 * pull && (moment_z + row[5]).abs() < 1e-9 * pull);
            // Beyond the part there is the spoke alone.
            let beyond = line * square * (1.0 - 0.25) / 2.0;
            assert!((row[10] - beyond).abs() < 1e-3 * pull, "{} {beyond}", row[10]);
            assert!(row[11].abs() < 1e-3 * pull && row[12].abs() < 1e-3 * pull, "{row:?}");
            // The blade is along y: its section's y axis along -x.
            let flat = [mass * square * y, -(mass * square * x + line * square / 2.0), 0.0];
            let [force_x, force_y, moment, pulled, bending, bent] =
                [row[13], row[14], row[15], row[16], row[17], row[18]];
            let near = [force_x, force_y, moment].into_iter().zip(flat);
            for (found, wanted) in near {
                assert!((found - wanted).abs() < 1e-3 * pull, "{row:?}");
            }
            assert!(
                (pulled + force_y).abs() < 1e-9 * pull && (bending + moment).abs() < 1e-9 * pull,
                "{row:?}"
            );
            assert!(bent.abs() < 1e-3 * pull, "{row:?}");
        }
    }
}

#[test]
fn a_start_in_equilibrium_knows_no_rigid_sections() {
    let refused = Started::default().build(Formulation::Rncf, Joints::Eliminated);
    let text = refused.err().map(|error| error.to_string()).unwrap_or_default();
    println!("{text}");
    assert!(text.contains("`plate`") && text.contains("section = elastic"), "{text}");
}
