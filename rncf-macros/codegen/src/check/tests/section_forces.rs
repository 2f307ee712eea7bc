//! Springs, loads and bushings on bodies with cross-sections: evaluated on moving sections and
//! compared with formulas written out.

use super::moving_sections::{FIRST, IN_PLANE, Motion, NONE, PLANAR, SCENE, SECOND, near, output};
use super::world::{STEP, Vec3, World, add, cross, dot, first_body, scale, still, times, transposed, with};
use crate::model::{Expr, Force, LoadKind, Location, Marker};

/// Power of the forces on markers.
pub fn power(force: &Force, world: &World) -> f64 {
    let each = force.markers.iter().zip(&force.components);
    each.map(|(marker, force)| {
        let rate = world.rate(*marker);
        dot(force.each_ref().map(|part| world.value(part)), rate)
    })
    .sum()
}

/// Resultant and moment about the origin of the forces on markers.
pub fn resultant(force: &Force, world: &World) -> (Vec3, Vec3) {
    let (mut sum, mut moment) = ([0.0; 3], [0.0; 3]);
    for (marker, components) in force.markers.iter().zip(&force.components) {
        let force = components.each_ref().map(|part| world.value(part));
        let value = world.marker(*marker, world.t);
        match &world.model.markers[marker.0] {
            Marker::Turn { .. } | Marker::SectionTurn { .. } => moment = add(moment, force),
            Marker::Point { .. } | Marker::BodyPoint { .. } => {
                sum = add(sum, force);
                moment = add(moment, cross(value, force));
            }
            _ => moment = add(moment, cross(value, force)),
        }
    }
    (sum, moment)
}

/// Angles of joints of sections count from the start; their springs do the work of their potential, also
/// where sections strain, and have no resultant; drives and slides follow.
#[test]
fn angles_of_sections_and_their_springs() {
    let theta = |t: f64| 0.8 * t * t;
    for is_planar in [false, true] {
        let firsts = if is_planar { IN_PLANE } else { FIRST };
        for (a, first) in firsts.iter().enumerate() {
            for (b, second) in SECOND.iter().enumerate() {
                if a + b == 0 {
                    continue;
                }
                let (scene, kind, more) = if is_planar {
                    (PLANAR, "revolute", "")
                } else {
                    (SCENE, "cylindrical", ", axis = [2, -1, 2]")
                };
                let mut items = format!(
                    "joint j = {kind}({first}, {second}{more});  joint turn = drive(j.angle, 0.5 rad);
                     output angle = j.angle;
                     spring soft = torsional(j, stiffness = 3 [N*m/rad]);
                     spring damper = torsional(j, stiffness = 0 [N*m/rad], damping = 2 [N*m*s/rad]);"
                );
                if !is_planar {
                    items += "joint push = drive(j.slide, 0.25 m * t / 1 s);";
                }
                let model = with(scene, &items);
                let axis = if is_planar {
                    [0.0, 0.0, 1.0]
                } else {
                    scale(1.0 / 3.0, [2.0, -1.0, 2.0])
                };
                let slide = if is_planar { 0.0 } else { 0.4 };
                let (shift, turn) = (|t: f64| scale(slide * t, axis), |t: f64| scale(theta(t), axis));
                let motion = Motion {
                    shift: &shift,
                    turn: &turn,
                    small: NONE,
                    is_planar,
                    strain: if a > 0 && b > 0 { 0.2 } else { 0.0 },
                };
                let what = format!("{first} {second} {is_planar}");
                let angle = |t: f64| motion.world(&model, t, |world| world.value(&output(&model, "angle")));
                motion.world(&model, 0.9, |world| {
                    let t = world.t;
                    let rate = (angle(t + STEP) - angle(t - STEP)) / (2.0 * STEP);
                    let find = |name: &str| model.constraints.iter().find(|other| other.name == name);
                    near(&[angle(t), rate], &[theta(t), 1.6 * t], 1e-8, &what);
                    let driven = world.rows(find("turn").unwrap());
                    near(&driven, &[(theta(t) - 0.5).sin()], 1e-9, &what);
                    if let Some(push) = find("push") {
                        near(&world.rows(push), &[0.4 * t - 0.25 * t], 1e-9, &what);
                    }
                    let spring = &model.forces[0];
                    let energy = world.value(spring.energy.as_ref().unwrap());
                    near(&[energy], &[1.5 * angle(t) * angle(t)], 1e-8, &what);
                    near(&[power(spring, world)], &[-3.0 * angle(t) * rate], 1e-6, &what);
                    near(&[power(&model.forces[1], world)], &[-2.0 * rate * rate], 1e-6, &what);
                    for force in &model.forces {
                        let (sum, moment) = resultant(force, world);
                        near(&sum, &[0.0; 3], 1e-9, &what);
                        near(&moment, &[0.0; 3], 1e-9, &what);
                    }
                });
            }
        }
    }
}

/// A bushing is a potential between the axes of B, takes nothing from the momenta, and damps what
/// moves in these axes.
#[test]
fn bushings_between_all_sorts_of_places() {
    let shift = |t: f64| [0.3 * t, 0.1 - t, 0.2];
    let turn = |t: f64| [0.5 * t, -0.3, 0.2 * t];
    let motion = Motion {
        shift: &shift,
        turn: &turn,
        small: NONE,
        is_planar: false,
        strain: 0.1,
    };
    for (a, b) in [("shaft.end", "b"), ("a", "b.at([1, 2, 3] m)"), ("rod.at(1 m)", "a")] {
        let model = with(
            SCENE,
            &format!(
                "spring s = bushing({a}, {b}, stiffness = [3, 4, 5] N/m);
                 spring d = bushing({a}, {b}, stiffness = [0, 0, 0] N/m, damping = [1, 0, 2] N*s/m);"
            ),
        );
        let potential = |t: f64| motion.world(&model, t, |world| world.value(model.forces[0].energy.as_ref().unwrap()));
        motion.world(&model, 0.9, |world| {
            let rate = (potential(world.t + STEP) - potential(world.t - STEP)) / (2.0 * STEP);
            near(&[power(&model.forces[0], world)], &[-rate], 1e-5, a);
            for force in &model.forces {
                let (sum, moment) = resultant(force, world);
                near(&sum, &[0.0; 3], 1e-9, a);
                near(&moment, &[0.0; 3], 1e-9, a);
            }
            assert!(model.forces[1].energy.is_none());
            let place = |t: f64| -> Vec3 {
                let [from, name, at] = match b {
                    "b" => [a, "b", ""],
                    "a" => [a, "a", ""],
                    _ => [a, "b", "at"],
                };
                let pose = motion.pose(name, t);
                let own = if at.is_empty() { [0.0; 3] } else { [1.0, 2.0, 3.0] };
                let to = add(pose.r, times(pose.a, own));
                let from = match from {
                    "a" => motion.pose("a", t).r,
                    "shaft.end" => motion.section("shaft", t)[0],
                    _ => motion.section("rod", t)[0],
                };
                times(transposed(pose.a), add(from, scale(-1.0, to)))
            };
            let d = place(world.t);
            let want = 0.5 * (3.0 * d[0] * d[0] + 4.0 * d[1] * d[1] + 5.0 * d[2] * d[2]);
            near(&[potential(world.t)], &[want], 1e-9, a);
            let rates = scale(
                0.5 / STEP,
                add(place(world.t + STEP), scale(-1.0, place(world.t - STEP))),
            );
            let lost = rates[0] * rates[0] + 2.0 * rates[2] * rates[2];
            near(&[power(&model.forces[1], world)], &[-lost], 1e-5, a);
        });
    }
}

/// Between a beam and the ground there is one force, on the beam; in a plane two of the axes count.
#[test]
fn bushings_on_the_ground() {
    let model = with(
        PLANAR,
        "spring s = bushing(rod.at(1 m), inertial.at([1, 2, 0] m), stiffness = [3, 4, 5] N/m, damping = [0.5, 0, 0] N*s/m);
         spring on = bushing(a, b, stiffness = [3, 4, 5] N/m);",
    );
    let (shift, turn) = (|t: f64| [t, -0.3 * t, 0.0], |t: f64| [0.0, 0.0, t]);
    let motion = Motion {
        shift: &shift,
        turn: &turn,
        small: NONE,
        is_planar: true,
        strain: 0.0,
    };
    motion.world(&model, 0.6, |world| {
        let force = model.forces[0].components[0].each_ref().map(|part| world.value(part));
        let place = |t: f64| motion.section("rod", t)[0];
        let rate = (place(world.t + STEP)[0] - place(world.t - STEP)[0]) / (2.0 * STEP);
        let [x, y, _] = place(world.t);
        near(
            &force,
            &[-3.0 * (x - 1.0) - 0.5 * rate, -4.0 * (y - 2.0), 0.0],
            1e-7,
            "ground",
        );
        let moves = |marker: &Marker| !matches!(marker, Marker::BodyPoint { .. });
        let acting = model.forces[0].markers.iter().zip(&model.forces[0].components);
        for (marker, components) in acting.filter(|(marker, _)| moves(&model.markers[marker.0])) {
            let zero = components.iter().all(|part| *part == Expr::Number(0.0));
            assert!(zero, "{:?}", model.markers[marker.0]);
        }
        let (sum, moment) = resultant(&model.forces[1], world);
        near(&sum, &[0.0; 3], 1e-9, "between");
        near(&moment, &[0.0; 3], 1e-9, "between");
    });
}

/// Q on r_y, r_z with r_y x Q_y + r_z x Q_z = M, for any section; in a plane on r_y alone.
#[test]
fn moments_turn_sections() {
    let model = with(
        SCENE,
        "load turning = moment(rod.end, [1, -2, 3] N*m, in = a);  load dead = moment(rod.end, [1, 0, 0] N*m);",
    );
    assert!(matches!(model.loads[0].kind, LoadKind::Moment { .. }));
    let sections = |_: &str, _: &Location, _: f64| [[0.0; 3], [1.0, 0.0, 0.0], [0.1, 1.1, 0.2], [-0.2, 0.1, 0.9]];
    let pose = |_: &str, t: f64| first_body(t);
    let world = World {
        model: &model,
        pose: &pose,
        sections: Some(&sections),
        end: &still,
        t: 0.4,
    };
    let (_, moment) = resultant(&model.forces[0], &world);
    near(&moment, &times(first_body(0.4).a, [1.0, -2.0, 3.0]), 1e-12, "moment");
    let flat = with(PLANAR, "load turning = moment(rod.end, [0, 0, 3] N*m, in = a);");
    let motion = Motion {
        shift: &|_| [0.0; 3],
        turn: &|_| [0.0; 3],
        small: NONE,
        is_planar: true,
        strain: 0.3,
    };
    motion.world(&flat, 0.4, |world| {
        let (_, moment) = resultant(&flat.forces[0], world);
        near(&moment, &[0.0, 0.0, 3.0], 1e-12, "in a plane");
    });
}
