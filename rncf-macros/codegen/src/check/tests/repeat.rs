//! Loops, shared nodes and values over all repetitions: what they become.

use super::{model, run};
use crate::check::starts::start;
use crate::model::{
    Binary, BodyId, Expr, FrameId, Function, JointKind, Location, Marker, Model, Observable, PointQuantity, Reduction,
    RepeatId, SectionQuantity,
};

/// A ring of wires around a free core, and one in a prescribed frame; models with snippets of it exchanged are wrong
/// in repeat.txt.
pub const SAIL: &str = "
model Sail {
    param tethers: count = 100;
    param elements: count = 16;
    param length = 10 km;
    param hub_radius = 5 m;
    param remote_mass = 1 kg;
    const R = 1 AU;
    const spin = 0.5 deg/s;
    material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
    section wire = circle(radius = 38 um);
    motion phi(t) = 2 [rad/s] * t;
    frame hub = rotating(axis = z, angle = phi(t));
    frame sail = free(origin = [R, 0 m, 0 m], velocity = [0, 30, 0] km/s, angular_velocity = [0, 0, spin]);
    fixture core on sail { mass = 300 kg; }
    rigid arm { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
    for a in 0..tethers {
        /// One of the long wires.
        body main[a] in sail {
            spatial;
            line from [hub_radius * cos(2*pi*a/tethers), hub_radius * sin(2*pi*a/tethers), 0 m]
                to [(hub_radius + length) * cos(2*pi*a/tethers), (hub_radius + length) * sin(2*pi*a/tethers), 0 m];
            mesh elements * tether(wire, aluminium);
        }
        body aux[a] in sail {
            spatial;
            line from [0, 0, 0] m to [2*pi*length/tethers, 0 m, 0 m];
            mesh 1 * tether(wire, aluminium);
            initial position [
                length * cos(2*pi*a/tethers) - x * sin(2*pi*(a + 0.5)/tethers),
                length * sin(2*pi*a/tethers) + x * cos(2*pi*(a + 0.5)/tethers),
                0
            ];
        }
        joint root[a] = clamp(main[a].start, sail);
        joint tip[a] = share(aux[a].start, main[a].end);
        joint knot[a] = share(aux[a].end, main[(a + 1) % tethers].end);
        joint ring[a] = merge(aux[a].end, aux[(a + 1) % tethers].start);
        fixture remote[a] on main[a].end { mass = remote_mass; }
    }
    for i in 0..3 {
        body chain[i] in hub { planar xy; line from [i * 1 m, 0 m, 0] to [(i + 1) * 1 m, 0 m, 0]; mesh 2 * cable(wire, aluminium); }
        body stay[i] in hub { planar xy; line from [i * 1 m, 0 m, 0] to [i * 1 m, 2 m, 0]; mesh 2 * cable(wire, aluminium); }
        joint link[i] = share(chain[i].end, stay[(i + 1) % 3].start);
        joint grip[i] = pin(stay[i].end, hub, at = [i * 1 m, 2 m, 0]);
    }
    body tail in hub { planar xy; line from [3, 0, 0] m to [4, 0, 0] m; mesh 2 * cable(wire, aluminium); }
    joint last = merge(chain[2].end, tail.start);
    joint ball = spherical(arm, main[3].end);
    constraint sun_x = dot(sail.ex, sail.position) / R;
    spring stay_wire = linear(main[0].end, arm, stiffness = 3 N/m, length = 1 m);
    load push = force(main[tethers - 1].end, [0, 0, 3] N);
    output tension = max(a in 0..tethers, main[a].start.axial_force);
    output lowest = min(a in 0..tethers, main[a].end.z);
    output outwards = mean(k in 0..tethers, cos(2*pi*k/tethers) * main[k].end.x + sin(2*pi*k/tethers) * main[k].end.y) - length;
    output way = sum(n in 0..3, norm(chain[n].end.velocity) * 1 s) + max(1 m, chain[0].end.x);
    output one = main[3].end.z;
    output there = main[3].end.in(inertial).x;
}
";

fn instance(at: &Location) -> Expr {
    at.instance().expect("a place on a repetition").clone()
}

/// `index + 1` modulo the number.
fn next(count: Expr) -> Expr {
    let one = Box::new(Expr::Number(1.0));
    let sum = Expr::Binary(Binary::Add, Box::new(Expr::Index), one);
    Expr::Call(Function::Remainder, vec![sum, count])
}

fn count_of(model: &Model, name: &str) -> Expr {
    let at = model.params.iter().position(|param| param.name == name).expect(name);
    Expr::Param(crate::model::ParamId(at))
}

#[test]
fn items_of_loops_stand_once() {
    let model = model(SAIL);
    let tethers = count_of(&model, "tethers");
    let loops: Vec<_> = model
        .repeats
        .iter()
        .map(|repeat| (repeat.index.as_str(), repeat.count.clone()))
        .collect();
    assert_eq!(loops, [("a", tethers.clone())]);
    let bodies: Vec<_> = model
        .bodies
        .iter()
        .map(|body| (body.name.as_str(), body.repeat))
        .collect();
    let first = Some(RepeatId(0));
    assert_eq!(
        bodies,
        [
            ("main", first),
            ("aux", first),
            ("chain[0]", None),
            ("stay[0]", None),
            ("chain[1]", None),
            ("stay[1]", None),
            ("chain[2]", None),
            ("stay[2]", None),
            ("tail", None)
        ]
    );
    assert_eq!(model.bodies[0].doc, "One of the long wires.");
    let initial = model.bodies[1].initial.position.clone().expect("an initial shape");
    assert!(
        initial[..2].iter().all(|component| {
            crate::model::fold::has_index(component) && crate::model::fold::has_arclength(component)
        })
    );
    let remote = &model.fixtures[0];
    assert_eq!(
        (remote.repeat, remote.body, remote.at.place()),
        (first, BodyId(0), &Location::End)
    );
    assert_eq!(instance(&remote.at), Expr::Index);
}

#[test]
fn repeated_joints_have_no_rows() {
    let model = model(SAIL);
    let joints: Vec<_> = model
        .joints
        .iter()
        .map(|joint| {
            (
                joint.name.as_str(),
                joint.kind,
                joint.repeat,
                joint.at.instance().cloned(),
            )
        })
        .collect();
    assert_eq!(
        joints,
        [
            ("root", JointKind::Clamp, Some(RepeatId(0)), Some(Expr::Index)),
            ("grip[0]", JointKind::Pin, None, None),
            ("grip[1]", JointKind::Pin, None, None),
            ("grip[2]", JointKind::Pin, None, None)
        ]
    );
    assert_eq!(model.joints[0].frame, FrameId(2));
    let point = model.joints[3].point.clone().expect("a point");
    assert_eq!(crate::model::fold::constant(&point[0]), Some(2.0));
    let names: Vec<_> = model
        .constraints
        .iter()
        .map(|constraint| constraint.name.as_str())
        .collect();
    assert_eq!(names, ["ball", "sun_x"]);
}

#[test]
fn shared_nodes_are_no_joints() {
    let model = model(SAIL);
    let tethers = count_of(&model, "tethers");
    let shares: Vec<_> = model
        .shares
        .iter()
        .map(|share| (share.name.as_str(), share.repeat.is_some(), share.smooth))
        .collect();
    assert_eq!(
        shares,
        [
            ("tip", true, false),
            ("knot", true, false),
            ("ring", true, true),
            ("link[0]", false, false),
            ("link[1]", false, false),
            ("link[2]", false, false),
            ("last", false, true)
        ]
    );
    let [(first, start), (second, end)] = &model.shares[1].ends;
    assert_eq!((*first, *second), (BodyId(1), BodyId(0)));
    assert_eq!((instance(start), start.place()), (Expr::Index, &Location::End));
    assert_eq!((instance(end), end.place()), (next(tethers), &Location::End));
    let [(chain, _), (tail, own)] = &model.shares[6].ends;
    assert_eq!((*chain, *tail, own), (BodyId(6), BodyId(8), &Location::Start));
    // A ring closes.
    let [(chain, _), (stay, _)] = &model.shares[5].ends;
    assert_eq!((*chain, *stay), (BodyId(6), BodyId(3)));
}

/// A prescribed number is that of one repetition everywhere.
#[test]
fn one_repetition_is_a_place() {
    let model = model(SAIL);
    let tip = |number: Expr| Location::Of {
        instance: Box::new(number),
        place: Box::new(Location::End),
    };
    let third = Marker::BodyPoint {
        body: BodyId(0),
        at: tip(Expr::Number(3.0)),
    };
    assert!(model.markers.contains(&third));
    // In a free frame a load is a force on a marker, whichever repetition it is.
    let tethers = Box::new(count_of(&model, "tethers"));
    let last = Expr::Binary(Binary::Subtract, tethers, Box::new(Expr::Number(1.0)));
    let last = Marker::BodyPoint {
        body: BodyId(0),
        at: tip(last),
    };
    assert!(model.markers.contains(&last));
    let one = &model.outputs[4].components[0].1;
    let want = Observable::Point {
        body: BodyId(0),
        at: tip(Expr::Number(3.0)),
        what: PointQuantity::Position,
        component: 2,
    };
    assert_eq!(one, &Expr::Observed(want));
}

#[test]
fn reductions_take_the_loop_of_the_same_number() {
    let model = model(SAIL);
    let Expr::Observed(Observable::Reduced {
        reduction,
        repeat,
        value,
    }) = &model.outputs[0].components[0].1
    else {
        panic!("a reduction")
    };
    assert_eq!((*reduction, *repeat), (Reduction::Max, RepeatId(0)));
    let want = Observable::Section {
        body: BodyId(0),
        at: Location::Of {
            instance: Box::new(Expr::Index),
            place: Box::new(Location::Start),
        },
        what: SectionQuantity::AxialForce,
    };
    assert_eq!(**value, Expr::Observed(want));
    let units: Vec<_> = model.outputs.iter().map(|output| output.unit.as_str()).collect();
    assert_eq!(units, ["N", "m", "m", "m", "m", "m"]);
    let Expr::Binary(Binary::Add, sum, largest) = &model.outputs[3].components[0].1 else {
        panic!("a sum of two")
    };
    // Of repetitions that are items of their own it is written out, in pairs.
    let Expr::Binary(Binary::Add, pair, _) = &**sum else {
        panic!("a sum of three")
    };
    assert!(matches!(&**pair, Expr::Binary(Binary::Add, ..)));
    assert!(matches!(&**largest, Expr::Call(Function::Max, arguments) if arguments.len() == 2));
}

/// A number of repetitions that no loop has is one of its own.
#[test]
fn a_reduction_may_count_on_its_own() {
    let text = SAIL.replace(
        "max(a in 0..tethers, main[a].start.axial_force)",
        "sum(a in 0..4, a * 1 N)",
    );
    let model = model(&text);
    assert_eq!(model.repeats.len(), 2);
    assert_eq!(
        (model.repeats[1].index.as_str(), &model.repeats[1].count),
        ("a", &Expr::Number(4.0))
    );
}

/// Reading goes on in a loop whatever is wrong in its head or in one of its items.
#[test]
fn all_mistakes_of_a_loop_are_found() {
    let (model, mistakes) = run("model M {
        for a in 1..n {
            body b[a] { planar xy; mesh = 3; }
            joint c[k] = pin(b[a].strt, inertial);
            spring s[a] = linear(b[a].end, b[a].start);
        }
        output x = b[0].end.x;
    }");
    assert!(model.is_none());
    let messages: Vec<_> = mistakes
        .iter()
        .map(|mistake| mistake.area.source_text().unwrap_or_default())
        .collect();
    assert_eq!(messages, ["1", "=", "[k]", "strt"]);
}

/// Nothing but a shared node holds the second rod, and nothing at all both of them.
#[test]
fn shared_nodes_hold_together() {
    let text = |joint: &str| {
        format!(
            "model Rods {{
                material steel {{ density = 7850 kg/m^3; young = 210 GPa; }}
                section thin {{ area = 1 mm^2; second_moment = 1 mm^4; }}
                body left {{ planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(thin, steel); }}
                body right {{ planar xy; line from [1, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); }}
                {joint}
                joint knot = share(left.end, right.start);
                output x = right.end.x;
            }}"
        )
    };
    let held = model(&text("joint foot = pin(left.start, inertial);"));
    assert_eq!((held.joints.len(), held.shares.len()), (1, 1));
    let (_, mistakes) = run(&text(""));
    let floating: Vec<_> = mistakes.iter().map(|mistake| mistake.area.source_text()).collect();
    assert_eq!(floating, [Some("left".into()), Some("right".into())]);
}

/// A frame without mass that joints in loops tie is not counted: how many there are is not known.
#[test]
fn ties_in_loops_are_left_to_the_run() {
    let text = SAIL.replace("fixture core on sail { mass = 300 kg; }", "");
    assert!(run(&text).1.is_empty());
    let single = text.replace("joint root[a] = clamp(main[a].start, sail);", "");
    let messages: Vec<_> = run(&single).1.into_iter().map(|mistake| mistake.message).collect();
    assert!(
        messages.iter().any(|message| message.contains("nothing holds")),
        "{messages:?}"
    );
}

/// Places on a repetition are those of its own line and initial shape.
#[test]
fn repetitions_start_where_they_are() {
    let model = model(SAIL);
    let start = start::Start::new(&model);
    let on = |instance: f64, place: Location| Location::Of {
        instance: Box::new(Expr::Number(instance)),
        place: Box::new(place),
    };
    let (tip, tangent) = start.place(BodyId(0), &on(25.0, Location::End));
    assert!((tip[0]).abs() < 1e-9 && (tip[1] - 10_005.0).abs() < 1e-9, "{tip:?}");
    assert!((tangent[1] - 1.0).abs() < 1e-12);
    let (first, slope) = start.initial_place(BodyId(1), &on(25.0, Location::Start));
    assert!((first[1] - 10_000.0).abs() < 1e-9, "{first:?}");
    let angle = 2.0 * std::f64::consts::PI * 25.5 / 100.0;
    assert!((slope[0] + angle.sin()).abs() < 1e-12 && (slope[1] - angle.cos()).abs() < 1e-12);
}
