//! What has no influence, and what has.

use super::{SPIN_UP, run};
use crate::elements::Library;
use crate::expand::warnings;

/// Warned words and messages of a model that is right.
fn found(text: &str) -> Vec<(String, String)> {
    assert_eq!(run(text).1.len(), 0, "{:?}", run(text).1);
    let warnings = warnings(text.parse().expect("tokens"), &Library::standard());
    let word = |warning: &crate::errors::Mistake| warning.area.source_text().expect("spans of a text");
    warnings
        .iter()
        .map(|warning| (word(warning), warning.message.clone()))
        .collect()
}

/// A pendulum that is observed, with other items.
fn beside(items: &str) -> Vec<String> {
    let text = format!("model Beside {{ rigid bob {{ mass = 1 kg; }} output x = bob.x; {items} }}");
    found(&text).into_iter().map(|(word, _)| word).collect()
}

/// A rod of steel in the plane, with other items, and other words in its place.
fn rod(items: &str, replace: &[(&str, &str)]) -> Vec<(String, String)> {
    let text = format!(
        "model Rod {{
            material steel {{ density = 7850 kg/m^3; young = 210 GPa; }}
            section wire {{ area = 1 mm^2; second_moment = 0.08 mm^4; }}
            body rod {{ planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(wire, steel); }}
            joint root = clamp(rod.start, inertial);
            output tip = rod.end;
            {items}
        }}"
    );
    found(&replace.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    }))
}

fn words(found: Vec<(String, String)>) -> Vec<String> {
    found.into_iter().map(|(word, _)| word).collect()
}

#[test]
fn what_is_used_is_no_matter() {
    assert_eq!(words(found(SPIN_UP)), [""; 0]);
    assert_eq!(words(rod("", &[])), [""; 0]);
}

#[test]
fn what_nobody_names_is_told_at_its_name() {
    for item in [
        "param gain = 3;",
        "const gain = 3 m;",
        "motion gain(t) = t;",
        "frame gain = moving(origin = [1, 0, 0] m);",
        "material gain { density = 1 kg/m^3; young = 1 Pa; }",
        "section gain { area = 1 m^2; }",
    ] {
        assert_eq!(beside(item), ["gain"], "{item}");
        assert_eq!(beside(&item.replace("gain", "_gain")), [""; 0], "{item}");
    }
    let (_, message) = &rod("param gain = 3;", &[])[0];
    assert_eq!(
        message,
        "nothing uses the param `gain`: leave it out, or call it `_gain`"
    );
    // A chain is told at its end.
    assert_eq!(beside("const a = 1; const b = a; param c = b;"), ["c"]);
    // The run and cautions read.
    assert_eq!(beside("param long = 3 s; run { t_end = long; }"), [""; 0]);
    assert_eq!(beside("param n = 3; caution few = \"few\" if n < 2;"), [""; 0]);
}

#[test]
fn what_is_not_seen_is_told_once_for_all_that_hangs_together() {
    let arm = "rigid arm { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; velocity = [speed, 0, 0]; } param speed = 3 m/s;";
    assert_eq!(beside(arm), ["arm"]);
    assert_eq!(beside(&arm.replace("arm", "_arm")), [""; 0]);
    let tied = format!(
        "{arm} rigid tool {{ mass = 1 kg; }} spring cord = linear(arm, tool, stiffness = 1 N/m, length = 0 m);"
    );
    assert_eq!(beside(&tied), ["arm"]);
    // Gravity and joints to the ground connect nothing.
    let held =
        format!("{tied} joint pivot = revolute(arm, inertial, axis = z); load weight = gravity([0, 0, -1] m/s^2);");
    assert_eq!(beside(&held), ["arm"]);
    // What acts on the observed body is seen, and all that acts on that.
    for tie in [
        "spring more = linear(tool, bob, stiffness = 1 N/m, length = 0 m);",
        "joint more = spherical(tool, bob);",
        "constraint more = tool.x - 2 * bob.x;",
        "load more = force(bob, [1, 0, 0] [N/m] * tool.x);",
        "output more = tool.x;",
        "start more = spinning(arm);",
    ] {
        let is_start = tie.contains("spinning");
        let bodies = "material stuff { density = 1 kg/m^3; young = 1 Pa; } section thin { area = 1 m^2; second_moment = 1 m^4; } \
                      body rope in arm { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 1 * cable(thin, stuff); } \
                      joint hook = clamp(rope.start, arm);";
        let items = format!("{held} {} {tie}", if is_start { bodies } else { "" });
        assert_eq!(beside(&items), [""; 0], "{tie}");
    }
    // But not what only reads it: the force acts on the other one.
    let reads = "rigid tool { mass = 1 kg; } load more = force(tool, [1, 0, 0] [N/m] * bob.x);";
    assert_eq!(beside(reads), ["tool"]);
}

#[test]
fn bodies_act_on_free_frames_and_not_on_prescribed_ones() {
    let stuff =
        "material stuff { density = 1 kg/m^3; young = 1 Pa; } section thin { area = 1 m^2; second_moment = 1 m^4; }";
    let body = |name: &str, frame: &str| {
        format!(
            "body {name} in {frame} {{ planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(thin, stuff); }} \
             joint of_{name} = clamp({name}.start, {frame});"
        )
    };
    let in_place = |frame: &str, seen: &str| {
        let bodies = [body("left", "place"), body("right", "place")].concat();
        beside(&format!(
            "{stuff} frame place = {frame}; {bodies} fixture hub on left.end {{ mass = 1 kg; }} {seen}"
        ))
    };
    let (free, turning) = ("free(plane = xy)", "rotating(axis = z, angle = 1 [rad/s] * t)");
    let core = "fixture core on place { mass = 1 kg; inertia = 1 kg*m^2; }";
    assert_eq!(in_place(free, &format!("{core} output y = left.end.y;")), [""; 0]);
    assert_eq!(in_place(turning, "output y = left.end.y;"), ["right"]);
    // Of a frame with bodies the first body is told.
    assert_eq!(in_place(free, core), ["left"]);
}

#[test]
fn properties_that_no_element_reads_are_told() {
    let with = |from: &str, to: &str| rod("", &[(from, to)]);
    let [young, moment, space] = ["young = 210 GPa;", "second_moment = 0.08 mm^4;", "planar xy;"];
    let poisson = "young = 210 GPa; poisson = 0.3;";
    // A material is a data sheet.
    assert_eq!(with(young, poisson), []);
    let torsion = format!("{moment} torsion_constant = 0.1 mm^4;");
    let (word, message) = &with(moment, &torsion)[0];
    assert_eq!(word, "torsion_constant");
    assert_eq!(
        message,
        "nothing reads the torsion_constant of section `wire`, for `cable` has no torsion: leave it out, or call the section `_wire`"
    );
    assert_eq!(rod("", &[(moment, &torsion), ("wire", "_wire")]), []);
    for field in ["damping = 1 ms;", "yield = 250 MPa;"] {
        assert_eq!(with(young, &format!("{young} {field}")), [], "{field}");
    }
    for (field, in_plane, in_space) in [
        ("torsion_constant = 0.1 mm^4;", 1, 1),
        ("shear_factor = 0.8;", 1, 1),
        ("extent_y = 1 mm;", 0, 0),
        ("extent_z = 1 mm;", 1, 0),
    ] {
        let field = format!("{moment} {field}");
        assert_eq!(with(moment, &field).len(), in_plane, "{field}");
        assert_eq!(
            rod("", &[(moment, &field), (space, "spatial;")]).len(),
            in_space,
            "{field}"
        );
    }
    // The section of a beam is read where it moves.
    let both = "second_moment_y = 1 mm^4; second_moment_z = 1 mm^4; torsion_constant = 1 mm^4; shear_factor = 0.8;";
    let beam = [(moment, both), (young, poisson), ("cable(", "beam(")];
    assert_eq!(words(rod("", &beam)), ["second_moment_y", "torsion_constant"]);
    let in_space = [&beam[..], &[(space, "spatial;")]].concat();
    assert_eq!(rod("", &in_space), []);
    // Nothing damps what does not deform.
    let damped = "young = 210 GPa; damping = 1 ms;";
    for word in ["rigid;", "point;"] {
        assert_eq!(
            words(rod("", &[(young, damped), (space, &format!("{space} {word}"))])),
            ["damping"]
        );
    }
}

/// The bending of a centre line in space is not damped.
#[test]
fn damping_that_leaves_bending_as_it_is_is_told() {
    let (young, space) = ("young = 210 GPa;", "planar xy;");
    let damped = (young, "young = 210 GPa; poisson = 0.3; damping = 1 ms;");
    let told = rod("", &[damped, (space, "spatial;")]);
    assert_eq!(words(told.clone()), ["damping"]);
    assert_eq!(
        told[0].1,
        "this does not damp the bending of `rod`: in space `cable` has no strain of it, whose rate could be damped; take `beam` where that should die away, or call the material `_steel`"
    );
    let no_damping = (young, "young = 210 GPa; damping = 0 s;");
    for cured in [
        &[damped][..],
        &[no_damping, (space, "spatial;")],
        &[damped, (space, "spatial;"), ("steel", "_steel")],
    ] {
        assert_eq!(rod("", cured), [], "{cured:?}");
    }
}

/// A cable in a free frame with what ties the frame to it, and other items.
fn flyer(statement: &str, items: &str) -> Vec<(String, String)> {
    found(&format!(
        "model Flyer {{
            material steel {{ density = 7850 kg/m^3; young = 210 GPa; }}
            section wire {{ area = 1 mm^2; second_moment = 0.08 mm^4; }}
            frame f = free(plane = xy);
            body rod in f {{ planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(wire, steel); {statement} }}
            output tip = rod.end;
            {items}
        }}"
    ))
}

#[test]
fn a_frame_that_turns_with_a_slope_without_inertia_is_told_at_the_joint() {
    let told = flyer("", "joint tie = clamp(rod.start, f);");
    assert_eq!(told.len(), 1, "{told:?}");
    assert_eq!(told[0].0, "tie");
    let text = "`tie` turns `f`, which has no mass of its own, with the slope at an end of `rod`";
    assert!(
        told[0].1.contains(text) && told[0].1.contains("write `chord;` or `mean_axes;` in `rod`"),
        "{}",
        told[0].1
    );
    let hold = "joint foot = pin(rod.start, f); joint turn = hold(rod.end.slope.y);";
    assert_eq!(words(flyer("", hold)), ["turn"]);
    // What has inertia, what follows all of the body, and what is meant.
    for (statement, items) in [
        ("chord;", ""),
        ("mean_axes;", ""),
        ("", "joint foot = pin(rod.start, f); joint line = hold(rod.end.y);"),
        (
            "",
            "joint tie = clamp(rod.start, f); fixture hub on f { mass = 1 kg; inertia = 1 kg*m^2; }",
        ),
        (
            "",
            "joint tie = clamp(rod.start, f); fixture hub on rod.start { mass = 1 kg; gyration = 10 cm; }",
        ),
        ("", "joint _tie = clamp(rod.start, f);"),
        ("modal(2);", "joint tie = clamp(rod.start, f);"),
    ] {
        assert_eq!(words(flyer(statement, items)), [""; 0], "{statement} {items}");
    }
    let weight = "joint tie = clamp(rod.start, f); fixture ball on rod.start { mass = 1 kg; }";
    assert_eq!(words(flyer("", weight)), ["tie"]);
}

#[test]
fn what_is_asked_of_all_sees_all_that_moves() {
    assert_eq!(
        beside("rigid ball { mass = 1 kg; } output p = total.momentum;"),
        [""; 0]
    );
    assert_eq!(beside("rigid ball { mass = 1 kg; } output p = bob.momentum;"), ["ball"]);
}
