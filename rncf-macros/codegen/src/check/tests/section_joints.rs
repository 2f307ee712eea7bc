//! Joints and fixtures on bodies with cross-sections: evaluated on moving sections and
//! compared with formulas written out.

use super::moving_sections::{FIRST, IN_PLANE, Motion, NONE, OTHER, PLANAR, SCENE, SECOND, near, output};
use super::world::{
    Pose, Vec3, World, add, axis_of, dot, first_body, product, rotation, scale, still, times, transposed, with,
};
use crate::check::values::eigen::symmetric;
use crate::model::{Constraint, Expr, JointKind, Location, Marker, Model, Observable, PointQuantity, SectionQuantity};

/// Derivatives of the rows with respect to shift and turn of the second party.
fn jacobian(model: &Model, joint: &Constraint, motion: Motion, t: f64) -> Vec<[f64; 6]> {
    let rows = |k: usize, amount: f64| {
        let small = axis_of(k, amount);
        let moved = Motion { small, ..motion };
        moved.world(model, t, |world| world.rows(joint))
    };
    let columns: Vec<Vec<f64>> = (0..6)
        .map(|k| {
            let (more, less) = (rows(k, 1e-6), rows(k, -1e-6));
            more.iter().zip(less).map(|(a, b)| (a - b) / 2e-6).collect()
        })
        .collect();
    (0..joint.rows.len())
        .map(|row| std::array::from_fn(|k| columns[k][row]))
        .collect()
}

fn rank(rows: &[[f64; 6]]) -> usize {
    let mut gram = [[0.0; 6]; 6];
    for row in rows {
        for i in 0..6 {
            for j in 0..6 {
                gram[i][j] += row[i] * row[j];
            }
        }
    }
    symmetric(gram).0.iter().filter(|value| **value > 1e-6).count()
}

/// Rows vanish for the motions that a kind leaves free, do not for the others, and none depends on
/// others where the second party has moved.
fn leaves(model: &Model, call: &str, is_planar: bool, free: &[usize], rows: usize) {
    let joint = model.constraints.last().expect("a joint");
    assert_eq!(joint.rows.len(), rows, "{call}: {:?}", joint.rows);
    let all: &[usize] = if is_planar { &[0, 1, 5] } else { &[0, 1, 2, 3, 4, 5] };
    for &k in all {
        let (shift, turn) = (|t: f64| axis_of(k, 0.6 * t).0, |t: f64| axis_of(k, 0.6 * t).1);
        let motion = Motion {
            shift: &shift,
            turn: &turn,
            small: NONE,
            is_planar,
            strain: 0.0,
        };
        let found = motion.world(model, 0.9, |world| world.rows(joint));
        let worst = found.iter().fold(0.0, |worst: f64, row| worst.max(row.abs()));
        let is_free = free.contains(&k);
        assert_eq!(worst < 1e-12, is_free, "{call}: motion {k} gives {worst}");
        if is_free {
            let jacobian = jacobian(model, joint, motion, 0.9);
            assert_eq!(
                rank(&jacobian),
                all.len() - free.len(),
                "{call}: motion {k}: {jacobian:?}"
            );
        }
    }
    if free.is_empty() {
        let zero = |_: f64| [0.0; 3];
        let motion = Motion {
            shift: &zero,
            turn: &zero,
            small: NONE,
            is_planar,
            strain: 0.0,
        };
        let jacobian = jacobian(model, joint, motion, 0.9);
        assert_eq!(rank(&jacobian), all.len(), "{call}: {jacobian:?}");
    }
    // Those of the first party stand in front, and none is left out.
    for (at, marker) in joint.markers.iter().enumerate() {
        let own = match &model.markers[marker.0] {
            Marker::Point { frame, .. }
            | Marker::Direction { frame, .. }
            | Marker::Matching { frame, .. }
            | Marker::Normal { frame, .. } => &model.frames[frame.0].name,
            Marker::BodyPoint { body, .. } | Marker::BodySection { body, .. } | Marker::InSection { body, .. } => {
                &model.bodies[body.0].name
            }
            other => panic!("{call}: {other:?}"),
        };
        let is_first = ["a", "shaft"].contains(&own.as_str());
        assert_eq!(is_first, at < joint.first_party, "{call}: {own}");
    }
}

/// Every kind between all sorts of parties leaves exactly its own motions free.
#[test]
fn joints_of_sections_leave_their_motions() {
    for first in FIRST {
        for second in SECOND {
            for (call, free, rows) in [
                (format!("weld({first}, {second})"), &[][..], 6),
                (format!("spherical({first}, {second})"), &[3, 4, 5], 3),
                (format!("revolute({first}, {second}, axis = z)"), &[5], 5),
                (format!("revolute({first}, {second}, axis = [0, 2, 0])"), &[4], 5),
                (format!("cylindrical({first}, {second}, axis = z)"), &[2, 5], 4),
                (format!("prismatic({first}, {second}, axis = x)"), &[0], 5),
                (format!("planar({first}, {second}, axis = z)"), &[0, 1, 5], 3),
                (format!("universal({first}, {second}, axis = x, cross = y)"), &[3, 4], 4),
            ] {
                // The point of b that the first party has it in is named where nothing else names it.
                let model = with(SCENE, &format!("joint j = {call};"));
                leaves(&model, &call, false, free, rows);
            }
        }
    }
}

#[test]
fn joints_of_sections_in_a_plane() {
    for (a, first) in IN_PLANE.iter().enumerate() {
        for (b, second) in SECOND.iter().enumerate() {
            for (call, free) in [
                (format!("weld({first}, {second})"), &[][..]),
                (format!("revolute({first}, {second})"), &[5]),
                (format!("prismatic({first}, {second}, axis = [3, 4, 0])"), &[]),
            ] {
                if call.starts_with("prismatic") && a + b == 0 {
                    continue;
                }
                let model = with(PLANAR, &format!("joint j = {call};"));
                if call.starts_with("prismatic") {
                    slides(&model, &call);
                } else {
                    leaves(&model, &call, true, free, 3 - free.len());
                }
            }
        }
    }
}

/// In a plane along [3, 4, 0] of the first party.
fn slides(model: &Model, call: &str) {
    let joint = model.constraints.last().expect("a joint");
    assert_eq!(joint.rows.len(), 2, "{call}");
    let (along, across) = (|t: f64| [0.6 * t, 0.8 * t, 0.0], |t: f64| [-0.8 * t, 0.6 * t, 0.0]);
    let (still, turning) = (|_: f64| [0.0; 3], |t: f64| [0.0, 0.0, 0.5 * t]);
    let worst = |shift: &dyn Fn(f64) -> Vec3, turn: &dyn Fn(f64) -> Vec3| {
        let motion = Motion {
            shift,
            turn,
            small: NONE,
            is_planar: true,
            strain: 0.0,
        };
        let rows = motion.world(model, 0.9, |world| world.rows(joint));
        rows.iter().fold(0.0, |worst: f64, row| worst.max(row.abs()))
    };
    assert!(worst(&along, &still) < 1e-12, "{call}");
    assert!(worst(&across, &still) > 0.1, "{call}");
    assert!(worst(&still, &turning) > 0.1, "{call}");
}

/// A clamp fixes the rotation of the section, which may strain and shear in its plane; a full one all of both axes. The
/// slope is free.
#[test]
fn clamped_sections_keep_their_axes() {
    let model = with(
        SCENE,
        "joint j = clamp(rod.at(1 m), a);  joint full = clamp_full(rod.end, a);
         joint line = clamp(wire.end, rod.at(0.5 m));",
    );
    let find = |name: &str| model.constraints.iter().find(|other| other.name == name).unwrap();
    let names = |name: &str| -> Vec<&str> { find(name).rows.iter().map(|(row, _)| row.as_str()).collect() };
    assert_eq!(names("j")[3..], ["direction 1", "direction 2", "direction 3"]);
    assert_eq!(names("full")[3..], ["ey x", "ey y", "ey z", "ez x", "ez y", "ez z"]);
    assert_eq!(names("line").len(), 5);
    let pose = |_: &str, _: f64| Pose {
        r: [0.0; 3],
        a: rotation([0.0; 3]),
    };
    let worst = |name: &str, moved: [Vec3; 3]| {
        let sections = |_: &str, _: &Location, t: f64| {
            let change = |v: Vec3, dv: Vec3| add(v, scale(t, dv));
            [
                [1.0, 0.0, 0.0],
                change([1.0, 0.0, 0.0], moved[0]),
                change([0.0, 1.0, 0.0], moved[1]),
                change([0.0, 0.0, 1.0], moved[2]),
            ]
        };
        let world = World {
            model: &model,
            pose: &pose,
            sections: Some(&sections),
            end: &still,
            t: 1.0,
        };
        let rows = world.rows(find(name));
        rows.iter().fold(0.0, |worst: f64, row| worst.max(row.abs()))
    };
    let none = [0.0; 3];
    for (moved, is_free, is_free_in_full) in [
        ([[0.3, 0.2, 0.1], none, none], true, true),
        ([none, [0.0, 0.5, 0.0], none], true, false),
        ([none, none, [0.0, 0.0, 0.5]], true, false),
        ([none, [0.0, 0.0, 0.1], [0.0, 0.1, 0.0]], true, false),
        ([none, [0.0, 0.0, 0.1], [0.0, -0.1, 0.0]], false, false),
        ([none, [0.1, 0.0, 0.0], none], false, false),
        ([none, none, [0.1, 0.0, 0.0]], false, false),
    ] {
        assert_eq!(worst("j", moved) < 1e-12, is_free, "{moved:?}");
        assert_eq!(worst("full", moved) < 1e-12, is_free_in_full, "{moved:?}");
    }
}

/// Constants of a fixture are the moments of its mass: of points with the same mass, centre and inertia.
#[test]
fn fixtures_on_sections() {
    let points: [(f64, Vec3); 4] = [
        (1.0, [0.1, 0.2, 0.3]),
        (2.0, [-0.2, 0.1, 0.4]),
        (0.5, [0.3, -0.3, 0.1]),
        (1.5, [0.2, 0.4, -0.2]),
    ];
    let mass: f64 = points.iter().map(|(m, _)| m).sum();
    let center = points
        .iter()
        .fold([0.0; 3], |sum, (m, x)| add(sum, scale(m / mass, *x)));
    let inertia = |i: usize, j: usize| -> f64 {
        points
            .iter()
            .map(|(m, x)| {
                let x = add(*x, scale(-1.0, center));
                m * (if i == j { dot(x, x) } else { 0.0 } - x[i] * x[j])
            })
            .sum()
    };
    let pairs = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];
    let [xx, yy, zz, xy, xz, yz] = pairs.map(|[i, j]| inertia(i, j));
    let [x, y, z] = center;
    let model = with(
        SCENE,
        &format!(
            "param heavy = {mass} kg;
             fixture disc on rod.at(1 m) {{ mass = heavy; center = [{x}, {y}, {z}] m;
                 inertia = [{xx}, {yy}, {zz}, {xy}, {xz}, {yz}] kg*m^2; }}
             fixture bead on rod.end {{ mass = 2 kg; }}
             fixture ring on wire.end {{ mass = 2 kg; offset = 0.1 m; gyration = 0.2 m; }}"
        ),
    );
    let value = |expr: &Expr| crate::model::fold::with_defaults(&model, expr, 0.0).unwrap();
    let constants = |at: usize| model.fixtures[at].constants.each_ref().map(value);
    let mut want = vec![mass];
    want.extend((0..3).map(|i| points.iter().map(|(m, x)| m * x[i]).sum::<f64>()));
    want.extend(pairs.map(|[i, j]| points.iter().map(|(m, x)| m * x[i] * x[j]).sum::<f64>()));
    near(&constants(0), &want, 1e-12, "disc");
    assert_eq!(constants(1)[0], 2.0);
    assert!(constants(1)[1..].iter().all(|entry| *entry == 0.0));
    near(&constants(2)[..5], &[2.0, 0.2, 0.0, 0.0, 0.1], 1e-12, "ring");
    let flat = with(
        PLANAR,
        "fixture disc on rod.end { mass = 2 kg; center = [0.1, 0.3, 0] m; inertia = 0.4 kg*m^2; }",
    );
    let value = |expr: &Expr| crate::model::fold::with_defaults(&flat, expr, 0.0).unwrap();
    let constants = flat.fixtures[0].constants.each_ref().map(value);
    near(
        &constants,
        &[2.0, 0.2, 0.6, 0.0, 0.2 + 0.02, 0.2 + 0.18, 0.0, 0.06, 0.0, 0.0],
        1e-12,
        "planar",
    );
}

/// Axes of sections are seen like slopes, in any frame; what sections carry is a number.
#[test]
fn sections_are_observed() {
    let model = with(
        SCENE,
        "output plain = shaft.end.ez.x;  output seen = rod.at(1 m).in(inertial).ey;  output in_a = rod.end.in(a).ez.y;
         output n = shaft.end.axial_force;  output q = 2 * shaft.at(1 m).shear_z;  output torque = shaft.end.torque;
         output ratio = shaft.end.moment_y / shaft.end.moment_z;  output wm = wire.end.moment;
         constraint c = dot(rod.end.in(inertial).ey, a.ez);",
    );
    let all = |name: &str| {
        let output = model.outputs.iter().find(|output| output.name == name).unwrap();
        (output.unit.as_str(), output.components.len())
    };
    assert_eq!((all("plain"), all("seen")), (("1", 1), ("1", 3)));
    assert_eq!(
        (all("n"), all("q"), all("torque"), all("ratio")),
        (("N", 1), ("N", 1), ("N m", 1), ("1", 1))
    );
    let Expr::Observed(Observable::Point { what, component, .. }) = output(&model, "plain") else {
        panic!("a component of a point");
    };
    assert_eq!((what, component), (PointQuantity::SectionZ, 0));
    for (name, wanted) in [
        ("n", SectionQuantity::AxialForce),
        ("torque", SectionQuantity::Torque),
        ("wm", SectionQuantity::Moment),
    ] {
        let Expr::Observed(Observable::Section { what, .. }) = output(&model, name) else {
            panic!("{name}");
        };
        assert_eq!(what, wanted);
    }
    let (shift, turn) = (|t: f64| [t, 0.0, 0.0], |t: f64| [0.0, t, 0.3 * t]);
    let motion = Motion {
        shift: &shift,
        turn: &turn,
        small: NONE,
        is_planar: false,
        strain: 0.1,
    };
    motion.world(&model, 0.5, |world| {
        let [_, _, _, z] = motion.section("rod", 0.5);
        let a = first_body(0.5).a;
        // In constraints the axis turns with the section and does not deform.
        let y = times(product(motion.second(0.5).1, rotation(OTHER)), [0.0, 1.0, 0.0]);
        near(
            &[world.value(&output(&model, "in_a"))],
            &[times(transposed(a), z)[1]],
            1e-12,
            "ez",
        );
        let row = world.rows(model.constraints.last().unwrap());
        near(&row, &[dot(y, times(a, [0.0, 0.0, 1.0]))], 1e-12, "constraint");
    });
    let flat = with(PLANAR, "output bending = rod.end.moment_z;  output y = rod.end.ey;");
    let Expr::Observed(Observable::Section { what, .. }) = output(&flat, "bending") else {
        panic!("a moment");
    };
    assert_eq!(what, SectionQuantity::MomentZ);
}

/// Ends in their own or in prescribed frames are eliminated where that is linear; else multipliers.
#[test]
fn ends_with_sections_are_eliminated() {
    let model = with(
        SCENE,
        "rigid f { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
         body own in f { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * beam(thin, steel); }
         joint p = pin(own.start, f);  joint h = hold(own.start.ey.z);  joint g = hold(own.start.ez.x);
         joint s = hold(own.at(0.2 m).twist);  joint hinge = revolute(f, own.end, axis = z);
         joint w = weld(own.end, a);  joint mid = weld(own.at(0.5 m), hub);",
    );
    let kinds: Vec<_> = model.joints[3..].iter().map(|joint| joint.kind).collect();
    assert_eq!(kinds, [JointKind::Pin]);
    let shape: Vec<_> = model
        .constraints
        .iter()
        .map(|other| format!("{} {} {}", other.name, other.absolute.is_some(), other.rows.len()))
        .collect();
    assert_eq!(
        shape,
        [
            "p true 3",
            "h false 1",
            "g false 1",
            "s false 1",
            "hinge false 5",
            "w false 6",
            "mid false 6"
        ]
    );
    assert_eq!(model.constraints[1].rows[0].0, "ey z");
    // What is written first is the first party, also in the body's own frame.
    let hinge = &model.constraints[4];
    assert_eq!(model.markers[hinge.markers[0].0].frame(), model.joints[3].frame.into());
}
