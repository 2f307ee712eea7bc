//! Loops whose number is known, in each other, and components: what they become.

use super::{model, run};
use crate::elements::Library;
use crate::expand;

/// A rotor of components in a loop, with loops in each other; models with snippets of it exchanged are wrong in
/// parts.txt.
pub const ROTOR: &str = "
model Rotor {
    const blades = 3;
    const gaps = blades - 1;
    param many: count = 5;
    param speed = 12 rpm;
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section flat = rectangle(y = 60 mm, z = 8 mm);
    motion theta(t) = speed * t;
    motion pitch(t) = 2 deg * sin(1 [rad/s] * t);
    frame hub = rotating(axis = x, angle = theta(t));
    /// A blade with a mass at its tip.
    component Blade(azimuth: angle, root: frame, length: m = 3 m, parts: count, foot: vector, wave: motion, heavy: kg) {
        const half = length / 2;
        let each = heavy / 2;
        body spar in root {
            spatial;
            line from foot to [0 m, length * cos(azimuth), length * sin(azimuth)];
            mesh parts * beam(flat, steel);
        }
        joint clip = clamp(spar.start, root);
        fixture tip on spar.end { mass = each; }
        rigid probe { mass = heavy; origin = [half, 0 m, 0 m]; }
        frame table = rotating(axis = x, angle = wave(t));
        for i in 0..2 { joint cord[i] = distance(probe, spar.at(length * (i + 1) / 2), length = 1 m); }
        for i in 0..3 { output place[i] = spar.at(length * i / 3).y; }
        output root_moment = clip.moment;
        output turned: deg = wave(t) + probe.at([0, 0, 0] m).in(table).x * 1 [rad/m];
    }
    for b in 0..blades {
        part blade[b] = Blade(
            azimuth = 2*pi*b/blades, root = hub, parts = many, foot = [0 m, b * 1 mm, 0 m], wave = pitch, heavy = 3 kg,
        );
    }
    part last = Blade(azimuth = 30 deg, root = inertial, length = 4 m, parts = 3, foot = [0, 0, 0] m, wave = pitch, heavy = speed * 1 [kg s]);
    for i in 0..blades {
        frame post[i] = moving(origin = [i * 1 m, 0 m, 0 m]);
        for j in 0..i + 1 { rigid ball[i][j] in post[i] { mass = (j + 1) * 1 kg; origin = [j * 1 m, 0 m, 0 m]; } }
        spring rod[i] = linear(ball[i][0], inertial, stiffness = 3 N/m, length = 1 m);
        load push[i] = force(ball[i][i], [0 N, i * 1 N, 0 N]);
    }
    for i in 0..gaps {
        joint bar[i] = distance(ball[i][0], ball[i + 1][0], length = 1 m);
        output pull[i] = bar[i].force.x;
    }
    load weight = gravity([0, 0, -9.81] m/s^2);
    output lowest = min(b in 0..blades, blade[b].spar.end.z);
    output carried = sum(i in 0..gaps, bar[i].force.x) + blade[1].cord[1].force.x;
    output waves = blade[2].heavy * 1 [m/kg] + last.probe.x;
    caution much = \"the rotor is fast\" on pull[1], blade[0].place[2] if speed > 3 rad/s;
}
";

fn names<T>(things: &[T], name: impl Fn(&T) -> &str) -> Vec<&str> {
    things.iter().map(name).collect()
}

#[test]
fn parts_and_repetitions_are_items_of_their_own() {
    let model = model(ROTOR);
    let bodies = names(&model.bodies, |body| &body.name);
    assert_eq!(bodies, ["blade[0].spar", "blade[1].spar", "blade[2].spar", "last.spar"]);
    let frames = names(&model.frames, |frame| &frame.name);
    let balls: Vec<&&str> = frames.iter().filter(|name| name.starts_with("ball")).collect();
    assert_eq!(
        balls,
        [
            &"ball[0][0]",
            &"ball[1][0]",
            &"ball[1][1]",
            &"ball[2][0]",
            &"ball[2][1]",
            &"ball[2][2]"
        ]
    );
    let outputs = names(&model.outputs, |output| &output.name);
    assert_eq!(
        outputs[..6],
        [
            "blade[0].place[0]",
            "blade[0].place[1]",
            "blade[0].place[2]",
            "blade[0].root_moment",
            "blade[0].turned",
            "blade[1].place[0]"
        ]
    );
    assert!(outputs.contains(&"pull[1]") && !outputs.contains(&"pull[2]"));
    assert!(model.repeats.is_empty());
    // What parts are told is resolved where it is told.
    let crate::model::Line::Straight { from, to } = &model.bodies[1].line else {
        panic!("a line")
    };
    assert_eq!(crate::model::fold::constant(&from[1]), Some(1e-3));
    let angle: f64 = 2.0 * std::f64::consts::PI / 3.0;
    let end = crate::model::fold::constant(&to[2]).expect("a constant");
    assert!((end - 3.0 * angle.sin()).abs() < 1e-15);
    assert_eq!(model.cautions.len(), 1);
}

/// A loop, nested, and a part against the same text written out: the same code but for the names.
#[test]
fn loops_and_parts_expand_as_what_is_written_out() {
    let shared = "param l = 0.5 m; const n = 2;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire = circle(radius = 2 mm);";
    let folded = "
        component Arm(foot: frame, reach: m, stiff: N/m) {
            body rod in foot { planar xy; line from [0, 0, 0] m to [reach, 0 m, 0]; mesh 2 * cable(wire, steel); }
            joint root = clamp(rod.start, foot);
            rigid ball { plane xy; mass = 1 kg; }
            spring cord = linear(rod.end, ball, stiffness = stiff, length = reach / 2);
            output tip = rod.end;
        }
        for i in 0..n {
            frame post[i] = moving(origin = [i * l, 0 m, 0]);
            for j in 0..2 { part arm[i][j] = Arm(foot = post[i], reach = l * (j + 1), stiff = 3 N/m); }
        }
        output highest = max(i in 0..n, arm[i][1].rod.end.y) + arm[0][0].root.force.x * 1 [m/N];";
    let arm = |i: usize, j: usize| {
        format!(
            "const arm_{i}_{j}_stiff = 3 N/m;
            body arm_{i}_{j}_rod in post_{i} {{ planar xy; line from [0, 0, 0] m to [l * ({j} + 1), 0 m, 0]; mesh 2 * cable(wire, steel); }}
            joint arm_{i}_{j}_root = clamp(arm_{i}_{j}_rod.start, post_{i});
            rigid arm_{i}_{j}_ball {{ plane xy; mass = 1 kg; }}
            spring arm_{i}_{j}_cord = linear(arm_{i}_{j}_rod.end, arm_{i}_{j}_ball, stiffness = arm_{i}_{j}_stiff, length = l * ({j} + 1) / 2);
            output arm_{i}_{j}_tip = arm_{i}_{j}_rod.end;"
        )
    };
    let post = |i: usize| {
        format!(
            "frame post_{i} = moving(origin = [{i} * l, 0 m, 0]); {}{}",
            arm(i, 0),
            arm(i, 1)
        )
    };
    let written = format!(
        "{}{} output highest = max(arm_0_1_rod.end.y, arm_1_1_rod.end.y) + arm_0_0_root.force.x * 1 [m/N];",
        post(0),
        post(1)
    );
    let expansion = |items: &str| {
        let text = format!("model Arms {{ {shared} {items} }}");
        let text = expand::text(text.parse().expect("tokens"), &Library::standard()).expect("a model");
        let start = text.find("pub struct Equations").expect("equations");
        (text[start..].to_string(), text)
    };
    let ((found, whole), (wanted, _)) = (expansion(folded), expansion(&written));
    let mut found = found;
    for i in 0..2 {
        for j in 0..2 {
            found = found.replace(&format!("arm[{i}][{j}]."), &format!("arm_{i}_{j}_"));
        }
        found = found.replace(&format!("post[{i}]"), &format!("post_{i}"));
    }
    let differs = found.lines().zip(wanted.lines()).find(|(one, other)| one != other);
    assert_eq!(differs, None);
    assert_eq!(found.len(), wanted.len());
    // Equal springs, here of two lengths, have one kernel.
    assert_eq!(whole.matches("pub fn force_value_").count(), 2);
}

/// Of what hangs in a loop or part one that is seen is enough.
#[test]
fn one_warning_stands_for_all_copies() {
    let told = |items: &str| {
        let text = format!("model M {{ {items} rigid seen {{ mass = 1 kg; }} output x = seen.x; }}");
        let warnings = expand::warnings(text.parse().expect("tokens"), &Library::standard());
        let texts = warnings
            .into_iter()
            .map(|mistake| mistake.area.source_text().unwrap_or_default());
        texts.collect::<Vec<_>>()
    };
    assert_eq!(told("for i in 0..3 { rigid ball[i] { mass = 1 kg; } }"), ["ball"]);
    assert!(told("for i in 0..3 { rigid ball[i] { mass = 1 kg; } } output y = ball[1].x;").is_empty());
    assert!(told("const n = 3; for i in 0..n { rigid ball[i] { mass = 1 kg; } } output y = ball[1].x;").is_empty());
    let parts = "component Weight(heavy: kg, spare: m) { rigid ball { mass = heavy; } }
        part a = Weight(heavy = 1 kg, spare = 1 m); part b = Weight(heavy = 2 kg, spare = 1 m); output y = b.ball.x;";
    assert_eq!(told(parts), ["spare"]);
}

/// Mistakes in a component and in a loop stand once, at the word that is wrong.
#[test]
fn a_mistake_in_copies_is_told_once() {
    let (_, mistakes) = run("model M {
        component Ball(heavy: kg) { rigid ball { mass = heavy; centr = [0, 0, 0] m; } }
        for i in 0..5 { part b[i] = Ball(heavy = 1 kg); rigid c[i] { mass = i * 1 m; } }
        output x = b[4].ball.x;
    }");
    let texts: Vec<_> = mistakes
        .iter()
        .map(|mistake| mistake.area.source_text().unwrap_or_default())
        .collect();
    assert_eq!(texts, ["centr", "i * 1 m"]);
}

const LIBRARY: &str = "library weights {
    const heavy = 3 kg; const spare = 2 m;
    component Weight(mass: kg = heavy) { rigid ball { mass = mass; } }
}";

/// What a model takes in from a library is as if it stood there, but that nothing warns about what it leaves.
#[test]
fn libraries_are_taken_in() {
    let text = format!(
        "{LIBRARY} library more {{ component Twice() {{ part a = Weight(); part b = Weight(mass = 2*heavy); }} }}
        model M {{ part two = Twice(); output x = two.b.ball.x; }}"
    );
    let model = model(&text);
    assert_eq!(
        names(&model.frames, |frame| &frame.name),
        ["inertial", "two.a.ball", "two.b.ball"]
    );
    let warnings = expand::warnings(text.parse().expect("tokens"), &Library::standard());
    assert!(warnings.is_empty(), "{warnings:?}");
}

/// A field of the model cannot have the name of a param of a part or of a repetition.
#[test]
fn params_inside_are_refused_and_nothing_else_fails() {
    for inside in [
        "component C(m: kg) { param z = 1; rigid r { mass = m * z; } } part p = C(m = 1 kg);",
        "component C() { param rows: table = file(\"a.csv\"); rigid r { mass = 1 kg; } } part p = C();",
        "for i in 0..2 { param z[i] = 1; rigid r[i] { mass = 1 kg * z[i]; } }",
    ] {
        let text = format!("model M {{ {inside} output x = 3; }}");
        let expanded = expand::expand(text.parse().expect("tokens")).to_string();
        let told: Vec<&str> = expanded.split("compile_error").skip(1).collect();
        let is_told = told[0].contains("params belong") || told[0].contains("stands outside of loops");
        assert!(is_told, "{told:?}");
    }
}

/// `use` becomes a call of the library's macro with the rest.
#[test]
fn a_use_becomes_a_call() {
    let expanded = |text: &str| expand::expand(text.parse().expect("tokens")).to_string();
    let wanted = |text: &str| text.parse::<proc_macro2::TokenStream>().expect("tokens").to_string();
    assert_eq!(
        expanded("use crate::shared::weights; use other::masts; pub model M { output x = 3; }"),
        wanted("crate::shared::weights! { use other::masts; pub model M { output x = 3; } }")
    );
    assert_eq!(
        expanded("library a { } use other::masts; model M { }"),
        wanted("other::masts! { library a { } model M { } }")
    );
    assert!(expanded("use crate::{a, b}; model M { }").contains("compile_error"));
}

/// A library becomes a macro that hands it to a model; its tables are those of its own crate.
#[test]
fn a_library_becomes_a_macro() {
    let text = format!("pub {LIBRARY}").replace("const spare", "table blade = file(\"blade.csv\"); const spare");
    let file = expand::library(text.parse().expect("tokens"));
    syn::parse2::<syn::File>(file.clone()).expect("items");
    let file = file.to_string();
    assert!(
        file.contains("# [macro_export]") && file.contains("pub use __rncf_library_weights as weights"),
        "{file}"
    );
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("blade.csv");
    assert!(file.contains(&format!("{:?}", path.to_string_lossy())), "{file}");
    let private = expand::library(LIBRARY.parse().expect("tokens")).to_string();
    assert!(!private.contains("macro_export"));
}

#[test]
fn wrong_libraries_say_what_would_be_right() {
    let told = |text: &str| {
        let (_, mistakes) = run(text);
        let texts = mistakes.iter().map(|mistake| mistake.message.clone());
        texts.collect::<Vec<String>>().join("; ")
    };
    let model = "model M { part a = Weight(); output x = a.ball.x; }";
    assert!(
        told(&format!("library w {{ rigid b {{ mass = 1 kg; }} }} {LIBRARY} {model}"))
            .contains("a `rigid` belongs to a model: in a library there are `const`, `let`, `table`, `material`, `section`, `element`, `motion` and `component`")
    );
    assert!(told(&format!("{LIBRARY} {LIBRARY} {model}")).contains("the library `weights` is used twice"));
    assert!(
        told(&format!(
            "{LIBRARY} model M {{ const heavy = 2 kg; part a = Weight(); output x = a.ball.x; }}"
        ))
        .contains("`heavy` is already declared")
    );
    let alone = |text: &str| expand::library(text.parse().expect("tokens")).to_string();
    assert!(alone("pub library a { } library b { }").contains("one `library!` declares one library"));
    assert!(alone("use b; library a { }").contains("uses no other one"));
    assert!(alone("pub blades { }").contains("expected `library name"));
    assert!(alone("library a { const c = ; }").contains("compile_error"));
}

/// All that a component may be told, repeated motions, and loops over a param and over a number in parts: what is written is
/// Rust.
#[test]
fn all_kinds_are_told_and_written() {
    let steel = "material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }";
    let all = format!(
        "model M {{
        component Mast(h: m, foot: place, way: vector, s: section, made: material, tie: joint, over: body) {{
            body pole {{ planar xy; line from [0, 0, 0] m to way; mesh 3 * cable(s, made); }}
            joint base = clamp(pole.start, inertial);
            joint link = distance(pole.end, foot, length = h);
            output a = tie.angle;
            output c = over.end.x;
            constraint k = pole.end.x - h;
        }}
        {steel}
        for i in 0..2 {{ section wire[i] = circle(radius = (i + 1) * 1 mm); motion w[i](t) = (i + 1) * sin(1 [rad/s] * t) * 1 rad; }}
        frame hub = rotating(axis = z, angle = w[1](t));
        rigid arm in hub {{ plane xy; mass = 1 kg; inertia = 1 kg*m^2; }}
        joint j = revolute(arm, hub);
        body other in hub {{ planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 3 * cable(wire[0], steel); }}
        joint held = clamp(other.start, hub);
        for i in 0..2 {{ part mast[i] = Mast(h = 1 m, foot = arm.at([1, 0, 0] m), way = [1 m, i * 1 m, 0], s = wire[i], made = steel, tie = j, over = other); }}
        output d = mast[1].pole.end.x + w[0](t) * 1 [m/rad];
    }}"
    );
    let rows = format!(
        "model M {{
        param n: count = 4;
        {steel}
        section wire = circle(radius = 1 mm);
        component Row(n: count, gap: m) {{
            motion turn(t) = gap * t * 1 [rad/m/s];
            for a in 0..n {{
                body rod[a] {{ planar xy; line from [a * gap, 0 m, 0] to [a * gap, 1 m, 0]; mesh 2 * cable(wire, steel); }}
                joint foot[a] = clamp(rod[a].start, inertial);
                fixture tip[a] on rod[a].end {{ mass = 1 kg; }}
            }}
            output most = max(a in 0..n, rod[a].end.x);
        }}
        part left = Row(n = n, gap = 1 m);
        part right = Row(n = 2, gap = 2 m);
        output far = left.rod[1].end.x + max(k in 0..n, left.rod[k].end.y) + max(k in 0..2, right.rod[k].end.y);
        output turned = right.turn(t);
    }}"
    );
    for text in [all, rows] {
        let text = expand::text(text.parse().expect("tokens"), &Library::standard());
        assert!(text.is_ok(), "{:?}", text.err());
    }
}
