//! What springs and loads become: evaluated on moving bodies and compared with formulas written out.

use super::joints::SCENE;
use super::world::{STEP, Vec3, World, add, bent, cross, dot, first_body, scale, second_body, times, unit, with};
use crate::model::LoadKind;

#[test]
fn springs_pull_along_their_line() {
    let model = with(
        SCENE,
        "spring s = linear(a.at([1, 0, 0] m), b, stiffness = k, damping = 0.5 [N*s/m], length = 20 cm);
         spring e = linear(a.at([1, 0, 0] m), b, stiffness = k, length = 20 cm);
         spring l = law(a, beam.end, force = k * (length - 1 m)^3 / 1 [m^2] + 0.1 [kg/s] * rate);
         joint d = distance(a.at([1, 0, 0] m), b, length = 3 m);  joint d0 = distance(a, b);",
    );
    let pose = |name: &str, t: f64| match name {
        "a" => first_body(t),
        _ => second_body(t, [0.3 * t, 1.0, -0.2], [0.0, 0.5 * t, 0.0]),
    };
    let t = 0.7;
    let world = World {
        model: &model,
        pose: &pose,
        sections: None,
        end: &bent,
        t,
    };
    let near = |found: f64, want: f64, what: &str| assert!((found - want).abs() < 1e-7, "{what}: {found} {want}");
    let apart = |t: f64| {
        let first = first_body(t);
        let from = add(first.r, times(first.a, [1.0, 0.0, 0.0]));
        add(pose("b", t).r, scale(-1.0, from))
    };
    let length = |t: f64| dot(apart(t), apart(t)).sqrt();
    let rate = (length(t + STEP) - length(t - STEP)) / (2.0 * STEP);
    let pull = 3.0 * (length(t) - 0.2) + 0.5 * rate;
    let spring = &model.forces[0];
    for i in 0..3 {
        let along = unit(apart(t))[i];
        near(world.value(&spring.components[0][i]), pull * along, "first");
        near(world.value(&spring.components[1][i]), -pull * along, "second");
    }
    near(
        world.value(model.forces[1].energy.as_ref().unwrap()),
        1.5 * (length(t) - 0.2).powi(2),
        "energy",
    );
    let law = &model.forces[2];
    let apart = |t: f64| add(bent(t)[0], scale(-1.0, first_body(t).r));
    let length = |t: f64| dot(apart(t), apart(t)).sqrt();
    let rate = (length(t + STEP) - length(t - STEP)) / (2.0 * STEP);
    let pull = 3.0 * (length(t) - 1.0).powi(3) + 0.1 * rate;
    near(world.value(&law.components[0][1]), pull * unit(apart(t))[1], "law");
    let find = |name: &str| model.constraints.iter().find(|other| other.name == name).unwrap();
    let from = add(first_body(t).r, times(first_body(t).a, [1.0, 0.0, 0.0]));
    let d = add(pose("b", t).r, scale(-1.0, from));
    near(world.rows(find("d"))[0], (dot(d, d) - 9.0) / 6.0, "distance");
    let start = World { t: 0.0, ..world };
    near(start.rows(find("d0"))[0], 0.0, "distance at t = 0");
}

#[test]
fn loads_of_flexible_bodies() {
    let model = with(
        SCENE,
        "load dead = force(beam.end, [1, 0, 0] N, in = hub);  load along = follower(beam.end, 3 N * t / 1 s);
         load drag = force(beam.at(1 m), -2 [kg/s] * beam.at(1 m).velocity);
         load carried = force(beam.end, [0, 2, 0] N, in = b);  load twist = moment(beam.end, [0, 1, 0] N*m, in = b);",
    );
    let loads: Vec<_> = model.loads.iter().map(|load| load.name.as_str()).collect();
    assert_eq!(loads, ["weight", "dead"]);
    assert!(matches!(model.loads[1].kind, LoadKind::Force { .. }));
    let pose = |_: &str, t: f64| first_body(t);
    let t = 0.5;
    let world = World {
        model: &model,
        pose: &pose,
        sections: None,
        end: &bent,
        t,
    };
    let force = |at: usize| model.forces[at].components[0].each_ref().map(|part| world.value(part));
    let near = |found: Vec3, want: Vec3| {
        for i in 0..3 {
            assert!((found[i] - want[i]).abs() < 1e-7, "{found:?} {want:?}");
        }
    };
    near(force(0), scale(3.0 * t, unit(bent(t)[1])));
    near(force(1), scale(-2.0, [-1.0, 1.0, 0.3]));
    near(force(2), times(first_body(t).a, [0.0, 2.0, 0.0]));
    let d = bent(t)[1];
    let m = times(first_body(t).a, [0.0, 1.0, 0.0]);
    near(force(3), scale(1.0 / dot(d, d), cross(m, d)));
}

/// The name `m` makes a unit of the spring's stiffness doubtful, which is told; what the spring shows is no second mistake.
#[test]
fn what_a_doubtful_spring_shows_is_no_mistake() {
    let text = "model Hung { param m = 1 kg; param k = 1 kN/m; rigid ball { mass = m; }
        spring cord = linear(ball, inertial.at([0, 0, 1] m), stiffness = k, length = 1 m); output pull = cord.force; }";
    let (_, mistakes) = super::run(text);
    let messages: Vec<&str> = mistakes.iter().map(|mistake| mistake.message.as_str()).collect();
    assert_eq!(messages.len(), 1, "{messages:?}");
}
