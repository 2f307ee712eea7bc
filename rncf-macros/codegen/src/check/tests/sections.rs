//! Sections, materials with an energy, and bodies with cross-sections: what they become.

use std::f64::consts::PI;

use super::{model, run};
use crate::check::starts::start::Start;
use crate::check::starts::ties::{self, Untied};
use crate::check::values::arithmetic::{Vector, cross, dot, norm, subtract};
use crate::elements::Library;
use crate::model::fold::with_defaults;
use crate::model::{BodyId, Expr, FrameId, Line, Location, Marker, MarkerId, Model, SectionShape};

/// Sections of all kinds, a material with an energy, and bodies with cross-sections in space and in a plane.
pub const SECTIONS: &str = r#"
model Shafts {
    param r = 50 mm;  param nu = 0.3;  param c1 = 1 MPa;
    const wall = 2 mm;
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = nu; damping = 1e-5 s; yield = 250 MPa; }
    material rubber { density = 1100 kg/m^3; yield = 20 MPa; energy = c1 * (E.xx^2 + E.yy^2 + E.zz^2 + 2*E.xy^2 + 2*E.xz^2 + 2*E.yz^2) + c1 * E.xx^4; }
    section round = circle(radius = r);
    section pipe = tube(radius = r, thickness = wall);
    section strip = rectangle(y = 20 mm, z = 5 mm);
    section block { area = 3 cm^2; second_moment_y = 1 cm^4; second_moment_z = 2 cm^4; torsion_constant = 1.5 cm^4; shear_factor = 0.8; extent_y = 2 cm; }
    frame f = free(origin = [0, 1, 0] m);
    frame hub = rotating(axis = z, angle = 3 [rad/s] * t);
    body shaft in hub {
        spatial;
        line from [0, 0, 0] m to [1, 0, 0] m;
        section_y [1, 0, 2];
        twist 90 deg;
        mesh 4 * beam(round, steel);
    }
    body ring in f {
        spatial;
        arc from [1, 0, 0] m direction [0, 1, 0] normal [0, 1, 1] radius 2 m angle 90 deg;
        mesh 3 * beam(block, steel, coupling = poisson);
    }
    body leaf in hub { spatial; line from [0, 2, 0] m to [0, 2, 3] m; mesh 2 * beam(pipe, rubber); }
    body wire in hub { spatial; line from [0, 0, 1] m to [2, 0, 1] m; mesh 2 * cable(round, steel); }
    joint root = clamp(shaft.start, hub);
    joint foot = clamp(ring.start, f);
    joint stem = clamp(leaf.start, hub);
    joint left = pin(wire.start, hub);
    output x = shaft.end.x;
}
"#;

/// A body in the plane with a rectangle and with a block of what it needs there.
const PLANAR: &str = r#"
model Flat {
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section strip = rectangle(y = 20 mm, z = 5 mm);
    section block { area = 1 cm^2; second_moment_z = 1 cm^4; shear_factor_y = 0.8; }
    body leaf { planar zx; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(strip, steel); }
    body beam { planar zx; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * beam(block, steel); }
    joint root = clamp(leaf.start, inertial);
    joint foot = clamp(beam.start, inertial);
    output x = leaf.end.x;
}
"#;

fn number(model: &Model, expr: &Expr) -> f64 {
    with_defaults(model, expr, 0.0).expect("a number")
}

fn property(model: &Model, body: usize, name: &str) -> f64 {
    number(model, &model.bodies[body].properties[name])
}

fn near(found: f64, want: f64, tolerance: f64) {
    assert!((found - want).abs() <= tolerance * want.abs(), "{found} {want}");
}

fn vector_near(found: Vector, want: Vector) {
    assert!(norm(subtract(found, want)) < 1e-14, "{found:?} {want:?}");
}

/// The properties of circle and tube are those of integrals over the section.
#[test]
fn round_sections_have_all_properties() {
    let model = model(SECTIONS);
    let (r, inner, nu) = (0.05_f64, 0.048_f64, 0.3);
    let ring = |power: i32| r.powi(power) - inner.powi(power);
    near(property(&model, 0, "area"), PI * r * r, 1e-15);
    near(property(&model, 0, "second_moment_y"), PI * r.powi(4) / 4.0, 1e-15);
    near(property(&model, 0, "torsion_constant"), PI * r.powi(4) / 2.0, 1e-15);
    let factor = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);
    near(property(&model, 0, "shear_factor_y"), factor, 1e-15);
    assert_eq!(
        model.bodies[0].shape,
        SectionShape::Circle {
            radius: Expr::Param(crate::model::ParamId(0))
        }
    );
    let body = &model.bodies[2];
    near(property(&model, 2, "area"), PI * ring(2), 1e-12);
    near(property(&model, 2, "second_moment_z"), PI / 4.0 * ring(4), 1e-12);
    near(property(&model, 2, "torsion_constant"), PI / 2.0 * ring(4), 1e-12);
    near(property(&model, 2, "inner_radius"), inner, 1e-14);
    // Rubber has no Poisson's ratio, and its energy needs no shear factor.
    assert!(!body.properties.contains_key("shear_factor_y") && !body.properties.contains_key("young"));
    assert!(body.strain_energy.is_some() && matches!(body.shape, SectionShape::Tube { .. }));
    near(property(&model, 2, "yield"), 20e6, 0.0);
    // A cable takes what it needs of the same section.
    near(property(&model, 3, "second_moment"), PI * r.powi(4) / 4.0, 1e-15);
}

#[test]
fn thin_tubes_have_the_shear_factor_of_cowper() {
    let text = SECTIONS
        .replace("beam(round, steel)", "beam(pipe, steel)")
        .replace("const wall = 2 mm", "const wall = 1 nm");
    let model = model(&text);
    // 2 (1 + nu) / (4 + 3 nu) without thickness.
    near(property(&model, 0, "shear_factor_z"), 2.0 * 1.3 / 4.9, 1e-7);
}

/// Torsion constants of rectangles against the series, and the limits of thin ones.
#[test]
fn rectangles_have_the_torsion_of_the_series() {
    let series = |a: f64, b: f64| {
        let sum: f64 = (0..4000)
            .map(|k| f64::from(2 * k + 1))
            .map(|n| (n * PI * a / (2.0 * b)).tanh() / n.powi(5))
            .sum();
        a * b.powi(3) * (1.0 / 3.0 - 64.0 / PI.powi(5) * b / a * sum)
    };
    for (y, z) in [(20.0, 5.0), (5.0, 20.0), (7.0, 7.0), (8.0, 7.0), (1000.0, 1.0)] {
        let strip = format!("beam(strip{}", ", steel)");
        let text = SECTIONS
            .replace("beam(round, steel)", &strip)
            .replace("y = 20 mm, z = 5 mm", &format!("y = {y} mm, z = {z} mm"));
        let model = model(&text);
        let (y, z) = (y * 1e-3, z * 1e-3);
        near(
            property(&model, 0, "torsion_constant"),
            series(f64::max(y, z), f64::min(y, z)),
            1e-9,
        );
        near(property(&model, 0, "second_moment_z"), z * y * y * y / 12.0, 1e-14);
        near(property(&model, 0, "second_moment_y"), y * z * z * z / 12.0, 1e-14);
        near(property(&model, 0, "shear_factor_z"), 5.0 / 6.0, 1e-15);
    }
    // Sides that are parameters give an expression that knows which one is longer.
    let text = SECTIONS
        .replace("beam(round, steel)", "beam(strip, steel)")
        .replace("z = 5 mm", "z = 2 * r");
    let model = model(&text);
    near(property(&model, 0, "torsion_constant"), series(0.1, 0.02), 1e-9);
}

#[test]
fn blocks_keep_what_they_give() {
    let model = model(SECTIONS);
    for (name, value) in [
        ("second_moment_y", 1e-8),
        ("second_moment_z", 2e-8),
        ("shear_factor_y", 0.8),
        ("shear_factor_z", 0.8),
        ("extent_y", 0.02),
    ] {
        near(property(&model, 1, name), value, 1e-15);
    }
    let SectionShape::General {
        extent: [Some(y), None],
    } = &model.bodies[1].shape
    else {
        panic!("one extent")
    };
    assert_eq!(y, &Expr::Number(0.02));
    assert_eq!(model.bodies[1].options, [1, 0]);
}

/// In a plane the section's y axis lies in it, and only what acts there is needed.
#[test]
fn planar_bodies_bend_about_the_z_axis() {
    let model = model(PLANAR);
    near(
        property(&model, 0, "second_moment"),
        5e-3 * 20e-3_f64.powi(3) / 12.0,
        1e-14,
    );
    assert!(!model.bodies[1].properties.contains_key("torsion_constant"));
    let start = Start::new(&model);
    let [y, z] = start.initial_section(BodyId(1), &Location::End);
    vector_near(y, [0.0, 0.0, -1.0]);
    vector_near(z, [0.0, 1.0, 0.0]);
}

/// Components of the strain are leaves of the energy.
#[test]
fn energies_are_functions_of_the_strain() {
    let text = SECTIONS.replace("+ c1 * E.xx^4", "+ 1 MPa * (exp(E.xy * E.yz) - 1)");
    let model = model(&text);
    let energy = format!("{:?}", model.bodies[2].strain_energy.as_ref().expect("an energy"));
    assert!((0..6).all(|at| energy.contains(&format!("Strain({at})"))), "{energy}");
}

/// A param of the name of the strain is a param where no component is meant.
#[test]
fn the_name_of_the_strain_stays_free() {
    let text = SECTIONS
        .replace("param c1 = 1 MPa;", "param E = 1 MPa;")
        .replace("+ c1 * E.xx^4", "")
        .replace("c1 * (", "E * (");
    assert!(model(&text).bodies[2].strain_energy.is_some());
}

/// y is made normal to the tangent and turned by the twist, linearly in the arclength.
#[test]
fn straight_sections_twist() {
    let model = model(SECTIONS);
    let start = Start::new(&model);
    let half = (0.5_f64).sqrt();
    for (x, y) in [
        (0.0, [0.0, 0.0, 1.0]),
        (0.5, [0.0, -half, half]),
        (1.0, [0.0, -1.0, 0.0]),
    ] {
        let [found, z] = start.initial_section(BodyId(0), &Location::At(Box::new(Expr::Number(x))));
        vector_near(found, y);
        vector_near(z, cross([1.0, 0.0, 0.0], found));
    }
    // Along z the section's y axis is y, else z x tangent.
    let [y, z] = start.initial_section(BodyId(2), &Location::End);
    vector_near(y, [0.0, 1.0, 0.0]);
    vector_near(z, [-1.0, 0.0, 0.0]);
}

/// On an arc the section turns with the tangent about the normal of the plane.
#[test]
fn sections_turn_along_arcs() {
    let mut model = model(SECTIONS);
    let Line::Arc { normal, .. } = &model.bodies[1].line else {
        panic!("arc")
    };
    assert_eq!(normal, &[0.0, 1.0, 1.0].map(Expr::Number));
    let body = BodyId(1);
    let start = Start::new(&model);
    // The normal is made normal to the direction: the arc turns about z, and y is z x tangent all along.
    let (place, tangent) = start.place(body, &Location::End);
    vector_near(place, [-1.0, 2.0, 0.0]);
    vector_near(tangent, [-1.0, 0.0, 0.0]);
    vector_near(start.initial_section(body, &Location::Start)[0], [-1.0, 0.0, 0.0]);
    let [y, z] = start.initial_section(body, &Location::End);
    vector_near(y, [0.0, -1.0, 0.0]);
    vector_near(z, [0.0, 0.0, 1.0]);
    // Markers of the section in inertial axes, and a direction in its triad.
    let at = || Location::End;
    model.markers.push(Marker::BodySection {
        body,
        at: at(),
        axis: 1,
    });
    model.markers.push(Marker::BodySection {
        body,
        at: at(),
        axis: 2,
    });
    let along = [0.0, 3.0, 4.0].map(Expr::Number);
    model.markers.push(Marker::Direction {
        frame: FrameId(0),
        along,
    });
    model.markers.push(Marker::InSection {
        body,
        at: at(),
        marker: MarkerId(model.markers.len() - 1),
    });
    let first = model.markers.len() - 4;
    let start = Start::new(&model);
    vector_near(start.marker(MarkerId(first)), y);
    vector_near(start.marker(MarkerId(first + 1)), z);
    vector_near(start.marker(MarkerId(first + 3)), [0.0, 0.6, 0.8]);
}

/// An initial shape turns the section by the smallest rotation of the tangent.
#[test]
fn sections_follow_initial_shapes() {
    let text = SECTIONS.replace("twist 90 deg;", "initial position [0, 0, x];");
    let model = model(&text);
    let start = Start::new(&model);
    let [y, z] = start.initial_section(BodyId(0), &Location::End);
    vector_near(y, [-1.0, 0.0, 0.0]);
    vector_near(z, [0.0, -1.0, 0.0]);
    assert!(dot(cross(y, z), [0.0, 0.0, 1.0]) > 1.0 - 1e-14);
}

fn tied(joints: &str) -> Result<(), Untied> {
    let text = SECTIONS.replace("joint foot = clamp(ring.start, f);", joints);
    let (model, mistakes) = run(&text);
    if let Some(mistake) = mistakes.first() {
        return Err(Untied::Loose {
            motions: mistake.message.clone(),
        });
    }
    ties::check(&model.expect("a model"), &Library::standard(), FrameId(1))
}

/// A body with sections ties all six motions of its frame; a straight one, too.
#[test]
fn sections_tie_the_turning_about_the_axis() {
    let straight = "line from [1, 0, 0] m to [2, 0, 0] m;";
    let arc = "arc from [1, 0, 0] m direction [0, 1, 0] normal [0, 1, 1] radius 2 m angle 90 deg;";
    for line in [straight, arc] {
        let swap = |joints: &str| {
            let text = SECTIONS
                .replace(arc, line)
                .replace("joint foot = clamp(ring.start, f);", joints);
            let messages: Vec<String> = run(&text).1.into_iter().map(|mistake| mistake.message).collect();
            messages
        };
        for joints in [
            "joint foot = clamp(ring.start, f);",
            "joint foot = clamp_full(ring.end, f);",
        ] {
            assert_eq!(swap(joints), Vec::<String>::new(), "{line} {joints}");
        }
        let twice = swap("joint foot = clamp(ring.start, f); joint head = pin(ring.end, f);");
        assert!(twice[0].contains("a second time"), "{twice:?}");
        let loose = swap("joint foot = pin(ring.start, f);");
        assert!(loose[0].contains("turning about the x axis"), "{loose:?}");
    }
    assert_eq!(tied("joint foot = clamp(ring.start, f);"), Ok(()));
}

/// A straight rigid body with sections has inertia about its axis.
#[test]
fn rigid_bodies_with_sections_turn_about_their_axes() {
    let arc = "arc from [1, 0, 0] m direction [0, 1, 0] normal [0, 1, 1] radius 2 m angle 90 deg;";
    let rigid = SECTIONS
        .replace("joint foot = clamp(ring.start, f);", "")
        .replace(arc, "line from [1, 0, 0] m to [2, 0, 0] m; rigid;");
    let messages = |text: &str| {
        run(text)
            .1
            .into_iter()
            .map(|mistake| mistake.message)
            .collect::<Vec<_>>()
    };
    assert_eq!(messages(&rigid), Vec::<String>::new());
    let cable = rigid.replace("beam(block, steel, coupling = poisson)", "cable(round, steel)");
    let found = messages(&cable);
    assert!(
        found.len() == 1 && found[0].contains("no inertia against turning about the x axis"),
        "{found:?}"
    );
}
