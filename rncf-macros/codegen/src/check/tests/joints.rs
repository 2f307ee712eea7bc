//! What joints, drives and constraints become: evaluated on moving bodies and
//! compared with formulas written out.

use super::world::{
    Pose, STEP, World, add, axis_of, bent, dot, first_body, product, rotation, scale, second_body, still, times,
    transposed, with,
};
use crate::joints::algebra::markers_of;
use crate::model::{Expr, Held, JointKind, Marker, Observable};

/// Two rigid bodies, a beam that both may be tied to, and what a test adds.
pub const SCENE: &str = "
    material steel { density = 7850 kg/m^3; young = 210 GPa; }
    section thin { area = 1 mm^2; second_moment = 1 mm^4; }
    param k = 3 N/m;
    motion phi(t) = 2 [rad/s] * t;
    frame hub = rotating(axis = z, angle = phi(t), origin = [1, 0, 0] m);
    rigid a { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
    rigid b { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; center = [0.1, 0.2, 0.3] m; }
    body beam { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); }
    joint root = clamp(beam.start, inertial);
    load weight = gravity([0, 0, -9.81] m/s^2);
    output first = a.x;
";
const PLANAR: &str = "
    motion phi(t) = 2 [rad/s] * t;
    frame hub = rotating(axis = z, angle = phi(t));
    rigid a { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
    rigid b { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
    output first = a.x;
";

/// Models with one more item than this one are wrong in joints.txt.
pub const JOINTS: &str = "
model Linkage {
    const L = 2 m;
    motion phi(t) = 2 [rad/s] * t;
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section thin { area = 1 mm^2; second_moment = 1 mm^4; }
    frame hub = rotating(axis = z, angle = phi(t));
    rigid arm { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
    rigid rod { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
    rigid disc { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
    rigid cam { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
    rigid bead { mass = 1 kg; }
    body beam { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); }
    body flat { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); }
    joint root = clamp(beam.start, hub);
    joint foot = clamp(flat.start, inertial);
    joint knee = revolute(arm, rod, axis = z);
    joint axle = revolute(disc, cam);
    joint ball = spherical(rod.at([1, 0, 0] m), beam.end);
    constraint same = arm.z - rod.z;
    joint motor = drive(axle.angle, phi(t));
    spring coil = linear(arm, rod.at([1, 0, 0] m), stiffness = 3 [N/m], damping = 1 [N*s/m], length = L);
    spring soft = law(bead, beam.end, force = 3 [N/m] * (length - L) + 1 [kg/s] * rate);
    spring bend = torsional_law(axle, moment = 2 [N*m] * sin(angle));
    load jet = follower(flat.end, [3 N, 1 N]);
    load drag = force(arm, -2 [kg/s] * arm.velocity);
    section block { area = 1 mm^2; second_moment = 1 mm^4; torsion_constant = 1 mm^4; shear_factor = 0.8; }
    body shaft { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * beam(block, steel); }
    body strip { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * beam(block, steel); }
    joint seat = clamp(shaft.start, hub);
    joint wall = clamp(strip.start, inertial);
    output tip = beam.end.in(arm).velocity;
    output way = norm(cross(arm - rod.at([1, 0, 0] m), rod.ex)) + 2 * axle.angle * 1 m;
    output lam = motor.moment.in(disc).z;
    output u = beam.end.x;
}
";

/// Every kind leaves exactly its own motions free: x, y, z, and turning about x, y, z.
#[test]
fn joints_leave_their_motions() {
    for (call, free) in [
        ("weld(a.at([0.5, 0.25, -0.125] m), b)", &[][..]),
        ("spherical(a.at([0.5, 0.25, -0.125] m), b)", &[3, 4, 5]),
        ("pin(a.at([0.5, 0.25, -0.125] m), b)", &[3, 4, 5]),
        ("revolute(a.at([0.5, 0.25, -0.125] m), b, axis = z)", &[5]),
        ("revolute(a, b.at([0.2, -0.3, 0.1] m), axis = [0, 2, 0])", &[4]),
        ("cylindrical(a.at([0.5, 0.25, -0.125] m), b, axis = z)", &[2, 5]),
        ("prismatic(a.at([0.5, 0.25, -0.125] m), b, axis = x)", &[0]),
        ("planar(a.at([0.5, 0.25, -0.125] m), b, axis = z)", &[0, 1, 5]),
        (
            "universal(a.at([0.5, 0.25, -0.125] m), b, axis = x, cross = y)",
            &[3, 4],
        ),
    ] {
        let model = with(SCENE, &format!("joint j = {call};"));
        let joint = model.constraints.last().unwrap();
        assert_eq!(joint.rows.len(), 6 - free.len(), "{call}");
        for motion in 0..6 {
            let amount = |t: f64| 0.6 * t;
            let pose = |name: &str, t: f64| {
                let (shift, turn) = axis_of(motion, amount(t));
                if name == "a" {
                    first_body(t)
                } else {
                    second_body(t, shift, turn)
                }
            };
            let world = World {
                model: &model,
                pose: &pose,
                sections: None,
                end: &still,
                t: 0.9,
            };
            let worst = world
                .rows(joint)
                .iter()
                .fold(0.0, |worst: f64, row| worst.max(row.abs()));
            let is_free = free.contains(&motion);
            assert_eq!(worst < 1e-12, is_free, "{call}: motion {motion} gives {worst}");
        }
        // The first party is the body a.
        for (at, marker) in joint.markers.iter().enumerate() {
            let owner = match &model.markers[marker.0] {
                Marker::Point { frame, .. }
                | Marker::Direction { frame, .. }
                | Marker::Matching { frame, .. }
                | Marker::Normal { frame, .. } => &model.frames[frame.0].name,
                other => panic!("{other:?}"),
            };
            assert_eq!(owner, if at < joint.first_party { "a" } else { "b" }, "{call}");
        }
    }
}

/// Both axes of a universal joint turn: first about that of A, then about that of B.
#[test]
fn a_universal_joint_turns_about_both_axes() {
    let model = with(
        SCENE,
        "joint j = universal(a.at([0.5, 0.25, -0.125] m), b, axis = x, cross = y);",
    );
    let pose = |name: &str, t: f64| {
        let turned = product(rotation([0.8 * t, 0.0, 0.0]), rotation([0.0, 0.5 * t, 0.0]));
        let second = second_body(t, [0.0; 3], [0.0; 3]);
        let a = first_body(t).a;
        match name {
            "a" => first_body(t),
            _ => Pose {
                r: second.r,
                a: product(a, product(turned, product(transposed(a), second.a))),
            },
        }
    };
    let world = World {
        model: &model,
        pose: &pose,
        sections: None,
        end: &still,
        t: 0.9,
    };
    let direction = &world.rows(model.constraints.last().unwrap())[3..];
    assert!(direction[0].abs() < 1e-12, "{direction:?}");
}

#[test]
fn angles_slides_and_their_drives() {
    let model = with(
        SCENE,
        "joint j = cylindrical(a.at([0.5, 0.25, -0.125] m), b, axis = z);
         joint turn = drive(j.angle, 0.5 rad);  joint push = drive(j.slide, 0.25 m * t / 1 s);
         output angle = j.angle;  output slide = j.slide;  output f = j.force;  output m = turn.moment.in(a).z;
         spring back = torsional(j, stiffness = 3 [N*m/rad], damping = 2 [N*m*s/rad], angle = 0.1 rad);
         spring soft = torsional(j, stiffness = 3 [N*m/rad]);",
    );
    let theta = |t: f64| 0.8 * t * t;
    let pose = |name: &str, t: f64| match name {
        "a" => first_body(t),
        _ => second_body(t, [0.0, 0.0, 0.4 * t], [0.0, 0.0, theta(t)]),
    };
    let t = 0.9;
    let world = World {
        model: &model,
        pose: &pose,
        sections: None,
        end: &still,
        t,
    };
    let near = |found: f64, want: f64, what: &str| assert!((found - want).abs() < 1e-8, "{what}: {found} {want}");
    near(world.value(&model.outputs[1].components[0].1), theta(t), "angle");
    near(world.value(&model.outputs[2].components[0].1), 0.4 * t, "slide");
    assert_eq!(
        (model.outputs[1].unit.as_str(), model.outputs[2].unit.as_str()),
        ("rad", "m")
    );
    let find = |name: &str| model.constraints.iter().find(|other| other.name == name).unwrap();
    near(world.rows(find("turn"))[0], (theta(t) - 0.5).sin(), "driven angle");
    near(world.rows(find("push"))[0], 0.4 * t - 0.25 * t, "driven slide");
    let spring = &model.forces[0];
    let moment = 3.0 * (theta(t) - 0.1) + 2.0 * 1.6 * t;
    let axis = times(first_body(t).a, [0.0, 0.0, 1.0]);
    for (at, sign) in [(0, 1.0), (1, -1.0)] {
        assert!(matches!(model.markers[spring.markers[at].0], Marker::Turn { .. }));
        for i in 0..3 {
            near(
                world.value(&spring.components[at][i]),
                sign * moment * axis[i],
                "moment",
            );
        }
    }
    assert!(spring.energy.is_none());
    near(
        world.value(model.forces[1].energy.as_ref().unwrap()),
        1.5 * theta(t) * theta(t),
        "energy",
    );
}

/// Positions and velocities seen in frames are those of the definition, velocities their time
/// derivatives.
#[test]
fn places_are_seen_in_frames() {
    let model = with(
        SCENE,
        "output p = b.center.in(a);  output v = b.center.in(a).velocity;  output q = beam.end.in(hub).velocity.y;
         output r = beam.end.in(hub).y;  output e = b.ez.in(a);  output w = b.angular_velocity;
         output n = norm(b - inertial.at([1, 2, 3] m));  output s = (2 * b.velocity).z;
         output c = cross(a.ex, a.ey);  output d = dot(a.direction([3, 4, 0]), a.ex);  output sl = beam.end.in(hub).slope.x;",
    );
    let pose = |name: &str, t: f64| match name {
        "a" => first_body(t),
        "hub" => Pose {
            r: [1.0, 0.0, 0.0],
            a: rotation([0.0, 0.0, 2.0 * t]),
        },
        _ => second_body(t, [0.3 * t, 1.0, -0.2], [0.2 * t, 0.5 * t, 0.0]),
    };
    let t = 0.7;
    let world = World {
        model: &model,
        pose: &pose,
        sections: None,
        end: &bent,
        t,
    };
    let output = |name: &str| -> Vec<f64> {
        let output = model.outputs.iter().find(|output| output.name == name).unwrap();
        output.components.iter().map(|(_, value)| world.value(value)).collect()
    };
    let near = |found: &[f64], want: &[f64], what: &str| {
        assert_eq!(found.len(), want.len(), "{what}");
        for (found, want) in found.iter().zip(want) {
            assert!((found - want).abs() < 1e-7, "{what}: {found} {want}");
        }
    };
    let center = |t: f64| {
        let (a, b) = (pose("a", t), pose("b", t));
        let at = add(b.r, times(b.a, [0.1, 0.2, 0.3]));
        times(transposed(a.a), add(at, scale(-1.0, a.r)))
    };
    near(&output("p"), &center(t), "position");
    let rate = scale(0.5 / STEP, add(center(t + STEP), scale(-1.0, center(t - STEP))));
    near(&output("v"), &rate, "velocity");
    let end = |t: f64| {
        let hub = pose("hub", t);
        times(transposed(hub.a), add(bent(t)[0], scale(-1.0, hub.r)))[1]
    };
    near(&output("r"), &[end(t)], "end");
    near(
        &output("q"),
        &[(end(t + STEP) - end(t - STEP)) / (2.0 * STEP)],
        "velocity of the end",
    );
    let ez = times(pose("b", t).a, [0.0, 0.0, 1.0]);
    near(&output("e"), &times(transposed(pose("a", t).a), ez), "direction");
    let spin = |h: f64| product(transposed(pose("b", t - h).a), pose("b", t + h).a);
    let w = spin(STEP);
    let own = scale(0.25 / STEP, [w[2][1] - w[1][2], w[0][2] - w[2][0], w[1][0] - w[0][1]]);
    near(&output("w"), &own, "angular velocity");
    let away = add(pose("b", t).r, [-1.0, -2.0, -3.0]);
    near(&output("n"), &[dot(away, away).sqrt()], "norm");
    let v = (pose("b", t + STEP).r[2] - pose("b", t - STEP).r[2]) / STEP;
    near(&output("s"), &[v], "twice the velocity");
    near(&output("c"), &times(first_body(t).a, [0.0, 0.0, 1.0]), "cross");
    near(&output("d"), &[0.6], "dot");
    near(
        &output("sl"),
        &[times(transposed(pose("hub", t).a), bent(t)[1])[0]],
        "slope",
    );
}

/// Flexible ends in free frames: eliminated in their own one, with a stand-in; else with multipliers.
#[test]
fn flexible_ends_and_free_frames() {
    let model = with(
        SCENE,
        "rigid f { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }  body wire in f { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(thin, steel); }
         joint own = clamp(wire.start, f);  joint roll = hold(wire.end.slope.y);
         joint tip = clamp(beam.end, b);  joint full = clamp_full(a, wire.end);  joint far = pin(wire.end, inertial);",
    );
    let kinds: Vec<_> = model
        .joints
        .iter()
        .map(|joint| (joint.name.as_str(), joint.kind))
        .collect();
    assert_eq!(
        kinds,
        [
            ("root", JointKind::Clamp),
            ("own", JointKind::Clamp),
            (
                "roll",
                JointKind::Hold {
                    of: Held::Slope,
                    axis: 1
                }
            )
        ]
    );
    let shape: Vec<_> = model
        .constraints
        .iter()
        .map(|other| {
            let rows: Vec<&str> = other.rows.iter().map(|(row, _)| row.as_str()).collect();
            format!("{} {} {}", other.name, other.absolute.is_some(), rows.join(", "))
        })
        .collect();
    assert_eq!(
        shape,
        [
            "own true position x, position y, position z, direction 1, direction 2",
            "roll true slope y",
            "tip false position x, position y, position z, direction 1, direction 2",
            "full false position x, position y, position z, slope x, slope y, slope z",
            "far false position x, position y, position z",
        ]
    );
    // A clamped end follows its body, and may stretch.
    let moved = |t: f64| product(first_body(t).a, transposed(first_body(0.0).a));
    let pose = |_: &str, t: f64| first_body(t);
    let end = |t: f64| {
        let (start, now) = (first_body(0.0), first_body(t));
        let offset = add([2.0, 0.0, 0.0], scale(-1.0, start.r));
        [
            add(now.r, times(moved(t), offset)),
            scale(1.0 + t, times(moved(t), [1.0, 0.0, 0.0])),
        ]
    };
    let world = World {
        model: &model,
        pose: &pose,
        sections: None,
        end: &end,
        t: 0.8,
    };
    let worst = |name: &str| {
        let joint = model.constraints.iter().find(|other| other.name == name).unwrap();
        world
            .rows(joint)
            .iter()
            .fold(0.0, |worst: f64, row| worst.max(row.abs()))
    };
    assert!(worst("tip") < 1e-12);
    assert!(worst("full") > 0.1);
}

#[test]
fn in_a_plane_rows_are_planar() {
    let model = with(
        PLANAR,
        "joint h = revolute(a.at([1, 0, 0] m), b);  joint w = weld(a, hub);  joint p = prismatic(a, b, axis = x);
         joint d = drive(h.angle, 0.3 rad * t / 1 s);  joint own = drive(a.angle, phi(t));  joint g = revolute(a, hub);
         output rel = h.angle;  output rate = b.speed;  output to_hub = g.angle;  output f = h.force;  output v = b.velocity;
         constraint c = dot(a.ex, b.ey);  output lam = c.multiplier;
         constraint two = b.at([0, 1, 0] m).position - [1, 2, 0] m;  output pair = two.multiplier;
         spring s = torsional_law(h, moment = 2 [N*m] * sin(angle) + 1 [N*m*s] * rate);
         load push = force(a, [1, 0, 0] N, in = b);  load twist = moment(a, [0, 0, 2] N*m);
         load drag = force(a, -0.5 [kg/s] * a.velocity);",
    );
    let rows: Vec<_> = model
        .constraints
        .iter()
        .map(|other| format!("{} {}", other.name, other.rows.len()))
        .collect();
    assert_eq!(rows, ["h 2", "w 3", "p 2", "g 2", "d 1", "own 1", "c 1", "two 2"]);
    let turn = |angle: f64| rotation([0.0, 0.0, angle]);
    let (first, second) = (|t: f64| 0.4 * t, |t: f64| 0.2 + 0.9 * t);
    let pose = |name: &str, t: f64| {
        let (x, angle) = match name {
            "a" => (t, first(t)),
            "b" => (-2.0 * t, second(t)),
            _ => (0.0, 2.0 * t),
        };
        let r = [x, 0.5 * t, 0.0];
        Pose { r, a: turn(angle) }
    };
    let t = 0.6;
    let world = World {
        model: &model,
        pose: &pose,
        sections: None,
        end: &still,
        t,
    };
    let near = |found: f64, want: f64, what: &str| assert!((found - want).abs() < 1e-8, "{what}: {found} {want}");
    let find = |name: &str| model.constraints.iter().find(|other| other.name == name).unwrap();
    let relative = second(t) - first(t);
    near(world.rows(find("d"))[0], relative - 0.3 * t, "driven angle");
    near(world.rows(find("own"))[0], first(t) - 2.0 * t, "driven frame");
    near(world.rows(find("w"))[2], (2.0 * t - first(t)).sin(), "welded");
    near(world.rows(find("c"))[0], -relative.sin(), "constraint");
    near(world.rows(find("p"))[0], (relative - 0.2).sin(), "prismatic");
    let output = |name: &str| {
        let output = model.outputs.iter().find(|output| output.name == name).unwrap();
        (
            output.components.len(),
            output.components[0].1.clone(),
            output.unit.clone(),
        )
    };
    near(world.value(&output("rel").1), relative, "angle");
    near(world.value(&output("rate").1), 0.9, "speed");
    near(world.value(&output("to_hub").1), 2.0 * t - first(t), "angle of the hub");
    assert_eq!((output("f").0, output("v").0, output("pair").0), (2, 2, 2));
    assert_eq!((output("lam").2.as_str(), output("pair").2.as_str()), ("N m", "N"));
    let spring = &model.forces[0];
    let moment = 2.0 * relative.sin() + 0.5;
    near(world.value(&spring.components[0][0]), moment, "first");
    near(world.value(&spring.components[1][0]), -moment, "second");
    let push = &model.forces[1];
    near(world.value(&push.components[0][0]), second(t).cos(), "dead in b");
    near(world.value(&push.components[0][1]), second(t).sin(), "dead in b");
    near(world.value(&model.forces[2].components[0][2]), 2.0, "moment");
    near(world.value(&model.forces[3].components[0][0]), -0.5, "drag");
    assert!(model.loads.is_empty());
    // Every marker that a force is a function of is among its own.
    for force in &model.forces {
        let mut used = Vec::new();
        force
            .components
            .iter()
            .flatten()
            .for_each(|part| markers_of(part, &mut used));
        assert!(
            used.iter().all(|marker| force.markers.contains(marker)),
            "{}",
            force.name
        );
        assert_eq!(force.markers.len(), force.components.len());
    }
}

/// Constraints and forces know markers only.
#[test]
fn rows_and_forces_are_functions_of_markers() {
    let model = with(
        SCENE,
        "constraint c = beam.end.y - b.y + 0 m;  constraint d = dot(beam.end.slope, b.ey.in(inertial));
         load l = force(b, [0, 1 [N/m] * beam.end.x, 0]);",
    );
    let mut count = 0;
    let mut check = |expr: &Expr| {
        expr.each_observable(&mut |observable| {
            count += 1;
            assert!(
                matches!(observable, Observable::Marker { derivative: 0, .. }),
                "{observable:?}"
            );
        });
    };
    model
        .constraints
        .iter()
        .flat_map(|other| &other.rows)
        .for_each(|(_, row)| check(row));
    model
        .forces
        .iter()
        .flat_map(|force| &force.components)
        .flatten()
        .for_each(&mut check);
    assert!(count > 5);
}

/// What acts on the first party is minus what acts on the second; a prescribed first party has no
/// markers of its own.
#[test]
fn drives_report_what_acts_on_their_first_party() {
    let model = with(
        PLANAR,
        "joint h = revolute(hub, a);  joint g = revolute(a, b);
         joint from_hub = drive(h.angle, phi(t));  joint between = drive(g.angle, phi(t));
         output m = from_hub.moment.z;  output n = between.moment.z;",
    );
    let reaction = |name: &str| {
        let output = model.outputs.iter().find(|output| output.name == name).unwrap();
        match output.components[0].1.clone() {
            Expr::Negate(inner) => (-1, *inner),
            other => (1, other),
        }
    };
    for (name, drive, sign, party) in [("m", "from_hub", -1, "a"), ("n", "between", 1, "a")] {
        let at = model.constraints.iter().position(|other| other.name == drive).unwrap();
        let constraint = &model.constraints[at];
        assert_eq!(constraint.first_party, 1, "{drive}");
        let Marker::Angle { frame } = model.markers[constraint.markers[0].0] else {
            panic!("an angle");
        };
        assert_eq!(model.frames[frame.0].name, party);
        let observed = Observable::ConstraintReaction {
            constraint: crate::model::ConstraintId(at),
            moment: true,
            component: 2,
        };
        assert_eq!(reaction(name), (sign, Expr::Observed(observed)));
    }
}

/// In its own frame an end is eliminated, whichever of the two is named first.
#[test]
fn the_own_frame_may_be_named_first() {
    let model = with(
        SCENE,
        "rigid f { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
         body wire in f { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(thin, steel); }
         joint own = weld(f.at([0, 0, 0] m), wire.start);",
    );
    let own = &model.joints[1];
    assert_eq!((own.name.as_str(), own.kind), ("own", JointKind::Clamp));
    assert!(own.point.is_some());
    assert_eq!(model.constraints[0].absolute, Some(own.body));
}
