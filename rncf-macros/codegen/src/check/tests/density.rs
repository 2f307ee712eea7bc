//! Loads per length and gravity fields: what is read, and what is refused.

use super::run;
use crate::model::{Expr, LoadKind, Marker, Observable};

const SAIL: &str = "
    param n: count = 3;
    param thrust = 1e-3 N/m;
    const R = 1.5e11 m;
    const g = 5.93e-3 m/s^2;
    material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
    section wire { area = 4.6e-9 m^2; second_moment = 1.7e-18 m^4; }
    frame sail = free(origin = [R, 0, 0]);
    fixture core on sail { mass = 90 kg; }
    body tether in sail { spatial; line from [0, 0, 0] m to [100, 0, 0] m; mesh 4 * cable(wire, aluminium); }
    joint root = clamp(tether.start, sail);
    constraint level = sail.ez.y;
    output tip = tether.end;
";

fn with(loads: &str) -> (Option<crate::model::Model>, Vec<String>) {
    let (model, mistakes) = run(&format!("model M {{ {SAIL} {loads} }}"));
    (model, mistakes.into_iter().map(|mistake| mistake.message).collect())
}

fn right(loads: &str) -> crate::model::Model {
    let (model, mistakes) = with(loads);
    assert_eq!(mistakes, Vec::<String>::new(), "{loads}");
    model.expect("no mistakes")
}

#[track_caller]
fn wrong(loads: &str, part: &str) {
    let (_, mistakes) = with(loads);
    let [mistake] = &mistakes[..] else {
        panic!("{loads}: {mistakes:?}");
    };
    assert!(mistake.contains(part), "{mistake}");
}

#[test]
fn densities_are_functions_of_the_particle_and_of_markers() {
    let model = right(
        "load push = density(tether, thrust * (slope * dot(slope, inertial.in(sail)) - dot(slope, slope) * inertial.in(sail)) / R);",
    );
    // The components of a vector in a frame's axes take its axes.
    assert_eq!(model.densities.len(), 1);
    assert!(model.loads.is_empty() && model.forces.is_empty());
    let local = |expr: &Expr| format!("{expr:?}").contains("Local { order: 1");
    assert!(model.densities[0].components.iter().all(local));
    let model = right("load weight = density(tether, [0, 0, -3] N/m);");
    assert!(model.densities[0].markers.is_empty());
    assert_eq!(model.densities[0].components[2], Expr::Number(-3.0));
    let model = right("load push = density(tether, thrust * (1 + t/(3 s)) * slope.x * position / (1 m));");
    assert_eq!(model.densities.len(), 1);
    right("load push = density(tether, [0, thrust * if t < 3 s { 0 } else { 1 }, 0]);");
}

#[test]
fn what_is_no_polynomial_is_refused() {
    wrong("load push = density(tether, thrust * slope / norm(slope));", "norm");
    wrong("load push = density(tether, thrust * slope / slope.x);", "a quotient");
    wrong("load push = density(tether, thrust * slope * slope.x^0.5);", "a power");
    wrong("load push = density(tether, thrust * slope * 2^slope.x);", "a power");
    wrong(
        "load push = density(tether, thrust * slope * dot(slope, slope)^2);",
        "degree 5",
    );
    wrong(
        "load push = density(tether, thrust * slope * if slope.x < 1 { 1 } else { 2 });",
        "condition",
    );
}

#[test]
fn dimensions_axes_and_bodies_of_densities() {
    wrong("load push = density(tether, slope);", "N/m");
    wrong("load push = density(tether, thrust);", "vector");
    wrong("load push = density(tether, thrust * sail.position / R);", ".in(sail)");
    wrong("load push = density(tether, [0, slope, 0]);", "vector");
    wrong(
        "load push = density(tether, thrust * inertial.in(sail).velocity / (1 [m/s]));",
        "a density or",
    );
    wrong("load push = density(sail, thrust * slope);", "body");
    wrong("load push = density(tether);", "density(beam, -w*slope)");
    wrong("output u = dot(slope, slope);", "slope");
    wrong("load push = denstiy(tether, thrust * slope);", "density");
}

#[test]
fn a_density_keeps_the_plane() {
    let planar = |load: &str| {
        let text = format!(
            "model M {{ {} load push = density(strip, {load}); }}",
            SAIL.replace("body tether in sail { spatial;", "body strip in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 1 * cable(wire, aluminium); } joint foot = clamp(strip.start, inertial); body tether in sail { spatial;")
        );
        run(&text)
            .1
            .into_iter()
            .map(|mistake| mistake.message)
            .collect::<Vec<_>>()
    };
    assert_eq!(planar("thrust * slope"), Vec::<String>::new());
    assert_eq!(planar("thrust * cross([0, 0, 1], slope)"), Vec::<String>::new());
    let [mistake] = &planar("[0, 0, thrust]")[..] else {
        panic!()
    };
    assert!(mistake.contains("xy plane"), "{mistake}");
    let [mistake] = &planar("thrust * slope.z * slope")[..] else {
        panic!()
    };
    assert!(mistake.contains('z'), "{mistake}");
}

#[test]
fn fields_act_on_what_a_free_frame_carries() {
    let model = right("load sun = gravity(-g * R^2 * sail.position / norm(sail.position)^3, on = sail);");
    let LoadKind::Field {
        frame,
        markers,
        components,
    } = &model.loads[0].kind
    else {
        panic!("{:?}", model.loads);
    };
    assert_eq!(model.frames[frame.0].name, "sail");
    let [marker] = markers[..] else { panic!("{markers:?}") };
    assert!(matches!(&model.markers[marker.0], Marker::Point { frame: of, .. } if of == frame));
    let observed = Expr::Observed(Observable::Marker {
        marker,
        derivative: 0,
        component: 0,
    });
    assert!(format!("{:?}", components[0]).contains(&format!("{observed:?}")));
    right("load weight = gravity([0, 0, -9.81] m/s^2, on = sail);");
    right("load weight = gravity([0, 0, -g * t/(1 s)], on = sail);");
    right("load side = gravity(g * sail.ey, on = sail);");
    wrong("load sun = gravity([0, 0, -g], on = inertial);", "leave out `on`");
    wrong(
        "load sun = gravity(g * tether.end.in(inertial) / R, on = sail);",
        "fixed in `sail`",
    );
    wrong("load sun = gravity(sail.position / R, on = sail);", "m/s^2");
    wrong(
        "load sun = gravity(g * sail.velocity / (1 [m/s]), on = sail);",
        "or a field",
    );
    wrong("load sun = gravity(g, on = sail);", "vector");
}

#[test]
fn densities_stand_in_loops() {
    let repeated = |load: &str| {
        let text = format!(
            "model M {{ {} for a in 0..n {{ {load} }} }}",
            SAIL.replace("body tether in sail {", "for a in 0..n { body main[a] in sail { spatial; line from [0, 0, 0] m to [10*cos(2*pi*a/n), 10*sin(2*pi*a/n), 0] m; mesh 2 * cable(wire, aluminium); } joint grip[a] = clamp(main[a].start, sail); } body tether in sail {").replace("] m to [10*cos(2*pi*a/n), 10*sin(2*pi*a/n), 0] m", "] m to [10 m*cos(2*pi*a/n), 10 m*sin(2*pi*a/n), 0 m]")
        );
        let (model, mistakes) = run(&text);
        (
            model,
            mistakes.into_iter().map(|mistake| mistake.message).collect::<Vec<_>>(),
        )
    };
    let (model, mistakes) = repeated("load push[a] = density(main[a], thrust * (1 + a) * slope);");
    assert_eq!(mistakes, Vec::<String>::new());
    let model = model.expect("no mistakes");
    assert!(model.bodies[model.densities[0].body.0].repeat.is_some());
    assert!(format!("{:?}", model.densities[0].components[0]).contains("Index"));
    let (_, mistakes) = repeated("load push[a] = density(main[0], thrust * slope);");
    assert!(
        mistakes.len() == 1 && mistakes[0].contains("all repetitions"),
        "{mistakes:?}"
    );
    let (_, mistakes) = repeated("load push[a] = density(tether, thrust * slope);");
    assert!(
        mistakes.len() == 1 && mistakes[0].contains("all repetitions"),
        "{mistakes:?}"
    );
}
