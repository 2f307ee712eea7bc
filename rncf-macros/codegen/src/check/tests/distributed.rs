//! Loads of a flow and gravity of a point: what is read, and what is refused.

use super::run;
use crate::model::{LoadKind, Model, ParticleVector};

const STUFF: &str = "
    param wind = 3 m/s;
    param mu = 4e14 m^3/s^2;
    table polar { at = alpha; alpha = [-180, 0, 180] deg; lift = [0, 1, 0]; }
    table plain { eta = [0, 1]; lift = [0, 1]; chord = [1, 2] m; }
    material foam { density = 200 kg/m^3; young = 3 GPa; poisson = 0.3; }
    section bar = circle(radius = 4 cm);
    body wing { spatial; line from [0, 0, 0] m to [6, 0, 0] m; mesh 6 * beam(bar, foam); }
    body rope { spatial; line from [0, 0, 0] m to [6, 0, 0] m; mesh 6 * cable(bar, foam); }
    body strip { planar xy; line from [0, 0, 0] m to [6, 0, 0] m; mesh 6 * cable(bar, foam); }
    joint a = clamp(wing.start, inertial);
    joint b = clamp(rope.start, inertial);
    joint c = clamp(strip.start, inertial);
    output tip = wing.end;
";

fn with(loads: &str) -> (Option<Model>, Vec<String>) {
    let (model, mistakes) = run(&format!("model M {{ {STUFF} {loads} }}"));
    (model, mistakes.into_iter().map(|mistake| mistake.message).collect())
}

#[track_caller]
fn right(loads: &str) -> Model {
    let (model, mistakes) = with(loads);
    assert_eq!(mistakes, Vec::<String>::new(), "{loads}");
    model.expect("no mistakes")
}

/// What is told of a load that should be told something else.
fn told(loads: &str, part: &str) -> Option<String> {
    let (_, mistakes) = with(loads);
    let is_told = matches!(&mistakes[..], [mistake] if mistake.contains(part));
    (!is_told).then(|| format!("{loads}: {part}: {mistakes:#?}"))
}

#[test]
fn loads_are_functions_of_their_particle() {
    let model = right("load drag = distributed(rope, -2 [kg/(m*s)] * (velocity - [wind, 0, 0]), points = 4);");
    let load = &model.distributed[0];
    assert_eq!((load.points, load.forces.len()), (4, 1));
    let model = right(
        "load air = distributed(wing, [0, q * polar.lift(alpha), 0], flow = [wind, 0, 0] - velocity, q = 1 [Pa] * plain.chord,
            alpha = atan2(dot(flow, section_z), dot(flow, section_y)), moment = [1 N, 0, 0], in = section);",
    );
    let acted: Vec<ParticleVector> = model.distributed[0].forces.iter().map(|&(of, _)| of).collect();
    assert_eq!(
        acted,
        [
            ParticleVector::Position,
            ParticleVector::SectionY,
            ParticleVector::SectionZ
        ]
    );
    right("load jets = distributed(strip, [1, 2, 0] N/m, moment = [0, 0, 2 N * cos(x / (1 m))], in = section);");
    right("load jets = distributed(strip, 3 [N/m] * section_y);");
    let model = right("load earth = gravity(-mu * position / norm(position)^3);");
    assert!(matches!(model.loads[0].kind, LoadKind::Around(_)));
}

#[test]
fn what_is_wrong_is_told() {
    let air = |load: &str| format!("load air = distributed({load});");
    let loads = [
        ("wing", "write e.g. `distributed(beam,"),
        (
            "wing, velocity",
            "a load per length is a force per length (N/m), but this is a velocity",
        ),
        ("wing, [1, 2, 3] N", "a load per length"),
        (
            "wing, 2 [N/m] * tangent, moment = 3 [N/m] * tangent",
            "a moment per length is a force (N), but",
        ),
        (
            "wing, [0, 0, 1] N/m, momment = [1, 0, 0] N",
            "did you mean `moment`?; a definition",
        ),
        (
            "wing, k * tangent, k = 2 [N/m], wind = 3 m/s",
            "`wind` is no argument of `distributed`",
        ),
        ("wing, wind * tangent, wind = 2 [N/m]", "is declared in the model"),
        ("wing, [0, 0, 1] N/m, points = 9", "from 1 to 5"),
        ("wing, [0, 0, 1] N/m, in = inertial", "in = section"),
        (
            "wing, 2 [N/m] * section_y, in = section",
            "the components are written out",
        ),
        ("rope, [0, 0, 1] N/m, in = section", "has a tangent and no section"),
        ("rope, [0, 0, 1] N/m, moment = [1, 0, 0] N", "has no torsion"),
        ("rope, 2 [N/m] * section_y", "unknown name `section_y`"),
        ("strip, [0, 0, 1] N/m", "leaves the xy plane"),
        ("strip, [0, 0, 1] N/m, in = section", "the third component"),
        (
            "strip, [0, 0, 0] N/m, moment = [1, 0, 0] N, in = section",
            "the third component only",
        ),
        ("strip, [0, 0, 0] N/m, moment = [1, 0, 0] N", "has a z component only"),
        ("wing, 2 [N/m] * wing.end.slope", "of nothing at another place"),
        (
            "wing, 1 [N/m] * polar.lift * tangent",
            "say at which place, `polar.lift(..)`",
        ),
        ("wing, 1 [N/m] * polar.lift(2 m) * tangent", "but this is a length"),
        (
            "wing, 1 [N/m] * plain.lift(atan2(velocity.x, wind)) * tangent",
            "give that column a unit",
        ),
        (
            "wing, 1 [N/m] * polar.lift(1 rad, 2 rad) * tangent",
            "looked up at one place",
        ),
        (
            "wing, 1 [N/m] * (if velocity.x < wind { 1 } else { 0 }) * tangent",
            "must not depend on the state",
        ),
    ];
    let others = [
        (
            "frame turning = rotating(axis = z, angle = 1 rad * polar.lift(1 rad * (t / 1 [s])));",
            "which the rows of `polar` do not give",
        ),
        (
            "spring s = law(wing.end, inertial.at([9, 9, 9] m), force = poler.lift(1 rad) * 1 N);",
            "unknown table `poler`: did you mean `polar`?",
        ),
        (
            "load earth = gravity(-mu * position / norm(position)^2);",
            "gravity is an acceleration",
        ),
        (
            "table other { at = alpha; beta = [0, 1] deg; lift = [0, 1]; }",
            "unknown column `alpha`",
        ),
    ];
    let loads = loads.iter().filter_map(|(load, part)| told(&air(load), part));
    let others = others.iter().filter_map(|(item, part)| told(item, part));
    let all: Vec<String> = loads.chain(others).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
}
