//! Mechanisms whose free frames are held by joints and constraints with multipliers.

use super::{model, run};
use crate::model::Fidelity;

const PARTS: &str = "
    material steel { density = 7850 kg/m^3; young = 210 GPa; }
    section thin { area = 1 mm^2; second_moment = 1 mm^4; }
    frame shaft = rotating(axis = z, angle = 150 [rad/s] * t);
    body crank in shaft { spatial; line from [0, 0, 0] m to [0.15, 0, 0] m; mesh 2 * cable(thin, steel); }
    joint root = clamp_full(crank.start, shaft);
    frame f = free(origin = [0.15, 0, 0] m);
    body rod in f { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; mesh 2 * cable(thin, steel); }
    rigid slider { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; origin = [0.45, 0, 0] m; }
    joint guide = prismatic(slider, inertial, axis = x);
    joint end = spherical(rod.end, slider);
    output x = slider.x;
";

/// The messages of the mechanism with these joints.
fn messages(joints: &str) -> Vec<String> {
    let (_, mistakes) = run(&format!("model M {{ {PARTS} {joints} }}"));
    let text = |mistake: &crate::errors::Mistake| {
        let word = mistake.area.source_text().unwrap_or_default();
        format!("{word}: {}", mistake.message)
    };
    mistakes.iter().map(text).collect()
}

#[test]
fn a_cross_axis_is_the_sixth_tie() {
    let clamp = "joint tie = clamp(rod.start, f);";
    for cross in [
        "joint knee = spherical(rod.start, crank.end); constraint level = dot(f.ey, shaft.ez);",
        "joint knee = spherical(rod.start, crank.end); constraint level = f.ez.y;",
        "joint knee = universal(f, slider, axis = z, cross = y);",
        "joint knee = spherical(rod.start, crank.end); joint plane = planar(f, inertial, axis = z);",
    ] {
        assert_eq!(messages(&format!("{clamp} {cross}")), Vec::<String>::new(), "{cross}");
    }
    let loose = "f: nothing holds `rod` against turning about the x axis of its free frame `f`";
    for cross in [
        "joint knee = spherical(rod.start, crank.end);",
        "joint knee = spherical(f, crank.end);",
        "joint knee = spherical(rod.start, crank.end); constraint level = f.ex.z;",
        "joint knee = spherical(rod.start, crank.end); constraint level = rod.end.in(inertial).z;",
    ] {
        let found = messages(&format!("{clamp} {cross}"));
        assert!(found.len() == 1 && found[0].starts_with(loose), "{cross} {found:?}");
    }
}

#[test]
fn single_coordinates_tie() {
    let knee =
        "joint knee = spherical(rod.start, crank.end); joint tie = pin(rod.start, f); constraint level = f.ez.y;";
    let y = "joint y = hold(rod.end.y);";
    let z = "joint z = hold(rod.end.z);";
    assert_eq!(messages(&format!("{knee} {y} {z}")), Vec::<String>::new());
    let found = messages(&format!("{knee} {y}"));
    let loose = "f: nothing holds `rod` against turning about the y axis of its free frame `f`";
    assert!(found.len() == 1 && found[0].starts_with(loose), "{found:?}");
    let found = messages(&format!("{knee} {y} {z} joint s = hold(rod.end.slope.y);"));
    let twice = "s: `f` is held a second time, by the joint `s`";
    assert!(found.len() == 1 && found[0].starts_with(twice), "{found:?}");
}

/// A hinged arm that is clamped to its frame may be driven; without the clamp the drive holds it.
#[test]
fn driven_hinges() {
    let arm = "frame arm = hinged(axis = z);
        body boom in arm { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(thin, steel); }
        joint tie = clamp(rod.start, f);  constraint level = f.ez.y;";
    let drive = "joint motor = drive(arm.angle, 2 [rad/s] * t);";
    assert_eq!(
        messages(&format!("{arm} joint shoulder = clamp(boom.start, arm); {drive}")),
        Vec::<String>::new()
    );
    let found = messages(arm);
    let loose = "arm: nothing holds `boom` against turning about the z axis of its free frame `arm`";
    assert!(found.len() == 1 && found[0].starts_with(loose), "{found:?}");
    assert_eq!(
        messages(&format!("{arm} {drive} joint pivot = pin(boom.start, inertial);")),
        Vec::<String>::new()
    );
}

/// A body whose mass is at one point has no inertia about it.
#[test]
fn points_have_no_inertia_about_themselves() {
    let text = |from: &str, items: &str| {
        format!(
            "model Points {{
                material steel {{ density = 7850 kg/m^3; young = 210 GPa; }}
                section wire {{ area = 1 mm^2; second_moment = 0.08 mm^4; }}
                frame place = free(plane = xy);
                body rod in place {{ planar xy; line from [{from}, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(wire, steel); point; }}
                output tip = rod.end;
                {items}
            }}"
        )
    };
    for from in ["-1", "0"] {
        let (_, mistakes) = run(&text(from, ""));
        let messages: Vec<&str> = mistakes.iter().map(|mistake| mistake.message.as_str()).collect();
        assert!(
            messages.len() == 1 && messages[0].starts_with("`place` has no inertia against turning"),
            "{from}: {messages:?}"
        );
        // Something at another point helps.
        let tool = "fixture tool on place.at([3, 0, 0] m) { mass = 1 kg; }";
        assert_eq!(model(&text(from, tool)).bodies[0].fidelity, Fidelity::Point);
    }
}
