//! Ten-vector beam with a cross-section (THEORY 5.2): axial strain, shear, bending in two planes,
//! torsion, and a section that may deform; seven vectors in the plane.

use super::{
    AXIAL, Coefficient, Density, Element, ElementOption, Field, Inertia, Interpolant, Invariants, NodalVector, Node,
    Term, axial_strain, is_engineering,
};
use crate::symbolic::{Graph, Id};
use crate::tensors::Polynomial;

/// Gauss points of the strains of the axis: two leave spurious zero modes (THEORY 5.2.1).
pub(super) const AXIS_POINTS: usize = 3;

/// Gauss points of the section's gradients: more lock in strong bending, one is singular.
pub(super) const GRADIENT_POINTS: usize = 2;

/// The element behind the word `beam`.
pub const BEAM: Element = Element {
    names: &["beam"],
    kernel: "beam",
    of_stiffness: false,
    doc: "Beam with a cross-section: axial strain, shear, bending, torsion",
    vectors: &[
        position("r0", Node::Start, 0, || Polynomial::whole(&[1, 0, -3, 2])),
        position("r0x", Node::Start, 1, || Polynomial::whole(&[0, 1, -2, 1])),
        director("r0y", Node::Start, Interpolant::SectionY, || {
            Polynomial::whole(&[1, -3, 2])
        }),
        director("r0z", Node::Start, Interpolant::SectionZ, || {
            Polynomial::whole(&[1, -3, 2])
        }),
        director("ry_half", Node::Middle, Interpolant::SectionY, || {
            Polynomial::whole(&[0, 4, -4])
        }),
        director("rz_half", Node::Middle, Interpolant::SectionZ, || {
            Polynomial::whole(&[0, 4, -4])
        }),
        position("r1", Node::End, 0, || Polynomial::whole(&[0, 0, 3, -2])),
        position("r1x", Node::End, 1, || Polynomial::whole(&[0, 0, -1, 1])),
        director("r1y", Node::End, Interpolant::SectionY, || {
            Polynomial::whole(&[0, -1, 2])
        }),
        director("r1z", Node::End, Interpolant::SectionZ, || {
            Polynomial::whole(&[0, -1, 2])
        }),
    ],
    fields: &[
        field("a", Interpolant::Position, 1),
        field("b", Interpolant::SectionY, 0),
        field("c", Interpolant::SectionZ, 0),
        field("db", Interpolant::SectionY, 1),
        field("dc", Interpolant::SectionZ, 1),
    ],
    coefficients: &[
        coefficient("EA", "N", &["young", "area"]),
        coefficient("lambdaA", "N", &["lame", "area"]),
        coefficient("plane_lambdaA", "N", &["plane_lame", "area"]),
        coefficient("twoGA", "N", &["double_shear_modulus", "area"]),
        coefficient("kyGA", "N", &["shear_factor_y", "shear_modulus", "area"]),
        coefficient("kzGA", "N", &["shear_factor_z", "shear_modulus", "area"]),
        coefficient("GA", "N", &["shear_modulus", "area"]),
        coefficient("halfEA", "N", &["half_young", "area"]),
        coefficient("EIz", "N m^2", &["young", "second_moment_z"]),
        coefficient("EIy", "N m^2", &["young", "second_moment_y"]),
        coefficient("GJ", "N m^2", &["shear_modulus", "torsion_constant"]),
        coefficient("GIz", "N m^2", &["shear_modulus", "second_moment_z"]),
        coefficient("GIy", "N m^2", &["shear_modulus", "second_moment_y"]),
        coefficient("GIyz", "N m^2", &["shear_modulus", "quarter_polar_moment"]),
        coefficient("rhoA", "kg/m", &["density", "area"]),
        coefficient("rhoIz", "kg m", &["density", "second_moment_z"]),
        coefficient("rhoIy", "kg m", &["density", "second_moment_y"]),
    ],
    inertia: &[
        Inertia {
            of: Interpolant::Position,
            coefficient: "rhoA",
        },
        Inertia {
            of: Interpolant::SectionY,
            coefficient: "rhoIz",
        },
        Inertia {
            of: Interpolant::SectionZ,
            coefficient: "rhoIy",
        },
    ],
    damping: "damping",
    options: &[
        ElementOption {
            name: "coupling",
            values: &["none", "poisson"],
            doc: "stress on the axis from each strain alone (none), or with lateral contraction (poisson)",
        },
        AXIAL,
    ],
    energy: |graph, fields, options| beam(graph, fields, options[0] == 1, is_engineering(options, 1)),
    default_points: AXIS_POINTS,
    least_points: AXIS_POINTS,
    curved_in_space: None,
    own_rule: true,
};

const fn position(name: &'static str, node: Node, order: usize, shape: fn() -> Polynomial) -> NodalVector {
    NodalVector {
        name,
        meaning: if order == 0 { "position" } else { "slope" },
        node,
        of: Interpolant::Position,
        order,
        shape,
    }
}

const fn director(name: &'static str, node: Node, of: Interpolant, shape: fn() -> Polynomial) -> NodalVector {
    let meaning = match of {
        Interpolant::SectionZ => "section z axis",
        _ => "section y axis",
    };
    NodalVector {
        name,
        meaning,
        node,
        of,
        order: 0,
        shape,
    }
}

const fn field(name: &'static str, of: Interpolant, order: usize) -> Field {
    Field { name, of, order }
}

const fn coefficient(name: &'static str, unit: &'static str, factors: &'static [&'static str]) -> Coefficient {
    Coefficient { name, unit, factors }
}

/// `W = 1/2 A e^T D e` on the strains of the axis `e11 = 1/2 (a.a - 1), .., g12 = a.b, ..`, and on the
/// section's gradients `1/2 [E I_zz kz^2 + E I_yy ky^2 + G J tau^2 + G I_zz t22^2 + G I_yy t33^2 + G (I_yy +
/// I_zz)/4 t23^2]` (THEORY 5.2). D is `diag(E, E, E, ks G, ks G, E/2)`, or couples e11, e22, e33 by
/// `lambda + 2 G delta` and has G on g23; in the plane, where e33 is free, by Lame's constant of plane stress.
/// With these factors of g23 and `t23 = b.c' + c.b'` (its derivative along the axis) a section with `I_yy = I_zz`
/// has no preferred direction: its energy does not depend on where its y axis points. e11 is that of [`axial_strain`].
fn beam(graph: &mut Graph, fields: &Invariants, poisson: bool, engineering: bool) -> Vec<Term> {
    let planar = fields.dimension == 2;
    let dots = &fields.dots;
    let measure = |name, coefficient, measure: Id, points| Term {
        name,
        coefficient,
        density: Density::Measure(measure),
        points: Some(points),
    };
    let half = graph.number(0.5);
    let axes = if planar { 2 } else { 3 };
    let stretches: Vec<Id> = (0..axes)
        .map(|i| axial_strain(graph, dots[i][i], engineering && i == 0))
        .collect();
    let mut terms = Vec::new();
    let names = ["axial strain", "strain along y", "strain along z"];
    let normal = if poisson { "twoGA" } else { "EA" };
    for (name, &stretch) in names.into_iter().zip(&stretches) {
        terms.push(measure(name, normal, stretch, AXIS_POINTS));
    }
    if poisson {
        let volume = graph.sum(&stretches);
        let lambda = if planar { "plane_lambdaA" } else { "lambdaA" };
        terms.push(measure("change of volume", lambda, volume, AXIS_POINTS));
    }
    terms.push(measure("shear along y", "kyGA", dots[0][1], AXIS_POINTS));
    if planar {
        let (a, b, db) = (0, 1, 2);
        terms.push(measure("bending about z", "EIz", dots[a][db], GRADIENT_POINTS));
        terms.push(measure("gradient along y", "GIz", dots[b][db], GRADIENT_POINTS));
        return terms;
    }
    let (a, b, c, db, dc) = (0, 1, 2, 3, 4);
    terms.push(measure("shear along z", "kzGA", dots[a][c], AXIS_POINTS));
    let shear = if poisson { "GA" } else { "halfEA" };
    terms.push(measure("shear of the section", shear, dots[b][c], AXIS_POINTS));
    let difference = graph.subtract(dots[db][c], dots[dc][b]);
    let twist = graph.multiply(half, difference);
    terms.push(measure("bending about z", "EIz", dots[a][db], GRADIENT_POINTS));
    terms.push(measure("bending about y", "EIy", dots[a][dc], GRADIENT_POINTS));
    terms.push(measure("torsion", "GJ", twist, GRADIENT_POINTS));
    terms.push(measure("gradient along y", "GIz", dots[b][db], GRADIENT_POINTS));
    terms.push(measure("gradient along z", "GIy", dots[c][dc], GRADIENT_POINTS));
    let distortion = graph.add(dots[db][c], dots[dc][b]);
    terms.push(measure(
        "gradient of the section's shear",
        "GIyz",
        distortion,
        GRADIENT_POINTS,
    ));
    terms
}
