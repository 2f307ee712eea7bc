//! What a scene does not need is not written, and a note says so.

use rncf_codegen::elements::Library;
use rncf_codegen::expand;

const STUFF: &str = "material steel { density = 7850 kg/m^3; young = 210 GPa; }
    section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }";

/// A rod, held at its start, with statements of its own and further items.
fn rod(frame: &str, statements: &str, items: &str) -> String {
    expansion(&format!(
        "{STUFF} body rod in {frame} {{ {statements} line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(wire, steel); }}
        joint root = clamp(rod.start, {frame}); output tip = rod.end; {items}"
    ))
}

fn expansion(items: &str) -> String {
    let tokens = format!("pub model Scene {{ {items} }}").parse().expect("tokens");
    expand::text(tokens, &Library::standard()).expect("a model without mistakes")
}

/// The notes, as they stand in the documentation of the struct.
fn notes(text: &str) -> Vec<&str> {
    let head = text.find("/// # Chosen and left out").expect("a heading");
    let lines = text[head..].lines().map(str::trim_start);
    let lines = lines.take_while(|line| line.starts_with("///"));
    lines.filter_map(|line| line.strip_prefix("/// * ")).collect()
}

/// None of the words is in the code, and one note says each of the sentences.
#[track_caller]
fn leaves_out(text: &str, words: &[&str], sentences: &[&str]) {
    let code: String = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("///"))
        .collect();
    for word in words {
        assert!(!code.contains(word), "{word} is written");
    }
    let notes = notes(text);
    for sentence in sentences {
        let count = notes.iter().filter(|note| note.contains(sentence)).count();
        assert_eq!(count, 1, "{sentence} in {notes:#?}");
        // The notes of a run are the same.
        assert_eq!(text.matches(sentence).count(), 2, "{sentence}");
    }
}

const TURNING: &str = "frame hub = rotating(axis = z, angle = 1 [rad/s] * t);";

#[test]
fn of_planar_scenes() {
    let text = rod("inertial", "planar xy;", "");
    leaves_out(
        &text,
        &["r0_z", "s1_z", "[f64; 12]"],
        &["two components a vector, no motion along the normal"],
    );
    assert!(rod("inertial", "spatial;", "").contains("r0_z"));
}

#[test]
fn of_centre_lines_and_straight_undamped_bodies() {
    let text = rod("inertial", "spatial;", "");
    let words = [
        "SectionY",
        "torsion_constant =",
        "damping_matrix",
        "let damping",
        "reference_rod",
        "_damped",
        "let mut position",
    ];
    let sentences = [
        "no axes of the section, hence no shear, no torsion and no rotary inertia",
        "its material has no damping: no rates of strain and no damping matrix",
        "its axis is straight: no stress-free curvature for each element",
    ];
    leaves_out(&text, &words, &sentences);
    assert!(!text.contains("pub damping:"));
    let damped = expansion(
        "material steel { density = 7850 kg/m^3; young = 210 GPa; damping = 1 ms; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        body rod { planar xy; arc from [0, 0, 0] m direction [1, 0, 0] radius 4 m angle 30 deg; mesh 4 * cable(wire, steel); }
        joint root = clamp(rod.start, inertial); output tip = rod.end;",
    );
    for word in ["pub damping:", "damping_matrix", "reference_rod"] {
        assert!(damped.contains(word), "{word}");
    }
}

#[test]
fn of_beams_in_a_plane() {
    let stuff = "material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; } section bar = circle(radius = 1 cm);";
    let beam = |space: &str| {
        expansion(&format!(
            "{stuff} body bar_1 {{ {space}; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * beam(bar, steel); }}
            joint root = clamp(bar_1.start, inertial); output tip = bar_1.end;"
        ))
    };
    leaves_out(
        &beam("planar xy"),
        &["GJ", "SectionZ", "let torsion_constant"],
        &["there is no torsion in a plane"],
    );
    let spatial = beam("spatial");
    assert!(spatial.contains("GJ") && spatial.contains("SectionZ"));
    // No field of a beam is a second derivative.
    assert!(!spatial.contains("shapes_position_2") && spatial.contains("shapes_section_z_1"));
}

#[test]
fn of_the_inertial_and_of_prescribed_frames() {
    let still = rod("inertial", "planar xy;", "");
    leaves_out(
        &still,
        &[
            "_referenced_",
            "_absolute_velocity",
            "_absolute_jerk",
            "FreeSpec {",
            "fn frame_hub(",
        ],
        &[
            "RNCF and ANCF are the same, no kernels for a moving frame",
            "they do not change with time",
        ],
    );
    let turning = rod("hub", "planar xy;", TURNING);
    leaves_out(
        &turning,
        &[
            "FreeSpec {",
            "_referenced_velocity",
            "jerk[",
            "position[3]",
            "MarkerSpec::",
        ],
        &[
            "no unknowns for the frame",
            "Prescribed motions have two derivatives",
            "eliminated, neither unknowns nor multipliers",
        ],
    );
    // In absolute coordinates the same joint does change with time, and a constraint reads third derivatives.
    assert!(turning.contains("_absolute_jerk"));
    let tied = rod(
        "hub",
        "planar xy;",
        &format!("{TURNING} constraint c = rod.end.in(inertial).x - 1 m * cos(1 [rad/s] * t);"),
    );
    assert!(tied.contains("spin_jerk") || tied.contains("position[3]"));
}

#[test]
fn of_rigid_and_point_bodies() {
    let text = expansion("rigid bob { mass = 1 kg; } fixture ball on bob { mass = 2 kg; } output x = bob.x;");
    leaves_out(
        &text,
        &[
            "fn elastic",
            "fn mass(",
            "fn energy(",
            "fn section(",
            "fn shapes(",
            "fn prepare(",
            "fn bodies(",
            "fn joints(",
            "fn condition",
        ],
        &[
            "a point mass does not turn",
            "Not declared, so that no function is written for it: flexible bodies,",
        ],
    );
    for (word, sentence) in [
        ("rigid;", "does not deform: no unknowns"),
        ("point;", "is its mass at its centre of mass"),
    ] {
        let text = rod("hub", &format!("planar xy; {word}"), TURNING);
        leaves_out(&text, &[], &[sentence]);
        let variant = if word == "rigid;" {
            "Fidelity::Rigid"
        } else {
            "Fidelity::Point"
        };
        assert!(text.contains(variant));
    }
}

#[test]
fn of_constraints_and_forces() {
    let arms = "rigid arm { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; } rigid tool { mass = 1 kg; } output x = arm.x;";
    let linear = expansion(&format!("{arms} joint tie = spherical(arm, tool);"));
    leaves_out(
        &linear,
        &["constraint_hessian_", "constraint_rate_gradient_"],
        &["linear in its vectors, no second derivatives"],
    );
    let distance = expansion(&format!(
        "{arms} joint tie = distance(arm.at([1, 0, 0] m), tool, length = 1 m);"
    ));
    assert!(distance.contains("fn constraint_hessian_"));
    let law = expansion(&format!("{arms} load push = force(arm, [1, 0, 0] N);"));
    assert!(law.contains("fn force_value_push(") && !law.contains("fn force_tangent_push("));
}

#[test]
fn of_what_is_not_declared() {
    let text = rod("inertial", "planar xy;", "");
    let words = [
        "fn loads(",
        "fn load(",
        "fn load_varies(",
        "fn moment(",
        "fn moment_tangent(",
        "fn section_moment(",
        "fn field(",
        "fn densities(",
        "fn density",
        "StartSpec {",
        "ShareSpec {",
        "FixtureSpec {",
        "MarkerSpec::",
        "fn constraints(",
        "fn forces(",
        "kinks(&self.model",
        "fn cautions(",
        "let mut position",
        "fn constraint",
        "fn kind(",
    ];
    let sentence = "free frames and rigid bodies, fixtures, constraints with multipliers, springs and forces on moving \
                    places, gravity and dead loads, dead moments, gravity fields, loads per length, initial shapes, \
                    starts in equilibrium, kinks of motions, cautions.";
    leaves_out(&text, &words, &[sentence]);
    let moment = rod("inertial", "planar xy;", "load twist = moment(rod.end, [0, 0, 2] N*m);");
    assert!(moment.contains("fn moment_tangent(") && moment.contains("fn load("));
}
