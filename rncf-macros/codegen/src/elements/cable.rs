//! Hermite centre-line element (THEORY 5.1): axial strain and bending of a thin beam, cable or
//! tether; no shear, no torsion.

use super::{
    AXIAL, Coefficient, Density, Element, ElementOption, Field, Inertia, Interpolant, Invariants, NodalVector, Node,
    Term, axial_strain, is_engineering,
};
use crate::model::Function;
use crate::symbolic::{Graph, Id};
use crate::tensors::Polynomial;

/// The element behind the words `cable` and `tether`.
pub const CABLE: Element = Element {
    kernel: "cable",
    of_stiffness: false,
    names: &["cable", "tether"],
    doc: "Hermite centre-line element: axial strain and bending, no shear, no torsion",
    vectors: &[
        NodalVector {
            name: "r0",
            meaning: "position",
            node: Node::Start,
            of: Interpolant::Position,
            order: 0,
            shape: || Polynomial::whole(&[1, 0, -3, 2]),
        },
        NodalVector {
            name: "s0",
            meaning: "slope",
            node: Node::Start,
            of: Interpolant::Position,
            order: 1,
            shape: || Polynomial::whole(&[0, 1, -2, 1]),
        },
        NodalVector {
            name: "r1",
            meaning: "position",
            node: Node::End,
            of: Interpolant::Position,
            order: 0,
            shape: || Polynomial::whole(&[0, 0, 3, -2]),
        },
        NodalVector {
            name: "s1",
            meaning: "slope",
            node: Node::End,
            of: Interpolant::Position,
            order: 1,
            shape: || Polynomial::whole(&[0, 0, -1, 1]),
        },
    ],
    fields: &[
        Field {
            name: "a",
            of: Interpolant::Position,
            order: 1,
        },
        Field {
            name: "b",
            of: Interpolant::Position,
            order: 2,
        },
    ],
    coefficients: &[
        Coefficient {
            name: "EA",
            unit: "N",
            factors: &["young", "area"],
        },
        Coefficient {
            name: "EI",
            unit: "N m^2",
            factors: &["young", "second_moment"],
        },
        Coefficient {
            name: "rhoA",
            unit: "kg/m",
            factors: &["density", "area"],
        },
    ],
    inertia: &[Inertia {
        of: Interpolant::Position,
        coefficient: "rhoA",
    }],
    damping: "damping",
    options: &[
        ElementOption {
            name: "bending",
            values: &["polynomial", "exact"],
            doc: "bending energy 1/2 EI |r_x x r_xx|^2 (polynomial), or divided by |r_x|^4 (exact)",
        },
        ElementOption {
            name: "slack",
            values: &["false", "true"],
            doc: "axial force EA e (false), or EA (e + sqrt(e^2 + d^2)) / 2 with d = 1e-6 (true): it pulls only",
        },
        AXIAL,
    ],
    energy: |graph, fields, options| {
        let law = if options.get(1) == Some(&1) {
            Axial::Slack
        } else {
            Axial::Linear
        };
        let strain = axial_strain(graph, fields.dots[0][0], is_engineering(options, 2));
        thin_beam(graph, fields, BENDING_EXPONENTS[options[0]], (strain, law))
    },
    default_points: 5,
    least_points: 3,
    curved_in_space: Some(
        "in space a centre line alone does not know which way it is curved: \
         use the beam with a cross-section, or declare the body planar",
    ),
    own_rule: false,
};

/// Exponent p of `|r_x|^-2p` in the bending energy, for each value of `bending`.
const BENDING_EXPONENTS: [f64; 2] = [0.0, 2.0];

/// Strain over which a slack string takes up its load. Far below the strains that wires work at (1e-4 and
/// more), so that the tension is right to (d/2e)^2, and far above the round-off of a strain (1e-16), which the
/// force at a compression e, EA d^2/(4 |e|), must be told from.
pub const SMOOTHING: f64 = 1e-6;

/// Law of the stress that is conjugate to the axial strain e, N.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axial {
    /// `EA e`.
    Linear,
    /// `EA/2 (e + sqrt(e^2 + d^2))`, which never pushes.
    Slack,
}

/// `W = 1/4 (e (e + s) + d^2 ln((e + s)/d))` and `N = 1/2 (e + s)` with `s = sqrt(e^2 + d^2)`.
///
/// `e + s` is a difference of nearly equal numbers where e < 0; its error is round-off of e, which nothing feels.
fn slack(graph: &mut Graph, strain: Id) -> [Id; 2] {
    let (half, quarter) = (graph.number(0.5), graph.number(0.25));
    let (smoothing, variance) = (graph.number(SMOOTHING), graph.number(SMOOTHING * SMOOTHING));
    let square = graph.power(strain, 2);
    let under = graph.add(square, variance);
    let root = graph.call(Function::Sqrt, under);
    let both = graph.add(strain, root);
    let stress = graph.multiply(half, both);
    let ratio = graph.divide(both, smoothing);
    let logarithm = graph.call(Function::Ln, ratio);
    let (first, second) = (graph.multiply(strain, both), graph.multiply(variance, logarithm));
    let sum = graph.add(first, second);
    [graph.multiply(quarter, sum), stress]
}

/// `1/2 EA eps^2 + 1/2 EI |a x b|^2 (a.a)^-p` with eps of [`axial_strain`].
///
/// In the plane the curvature `k = (a x b) (a.a)^(-p/2)` has a sign, so that an initial curvature
/// can be subtracted and bending damped; in space only the square is a function of inner products.
///
/// With a slack string the axial energy is that of [`Axial::Slack`], at Gauss points: the five of the element integrate
/// the energy of a tight one, of degree 8 in x, exactly, so that both laws agree in tension.
pub fn thin_beam(graph: &mut Graph, fields: &Invariants, p: f64, (strain, law): (Id, Axial)) -> Vec<Term> {
    let half = graph.number(0.5);
    let bending = if fields.dimension == 2 {
        let scale = inverse_power(graph, fields.dots[0][0], p / 2.0);
        Density::Measure(graph.multiply(fields.crosses[0][1], scale))
    } else {
        let product = graph.multiply(fields.dots[0][0], fields.dots[1][1]);
        let square = graph.power(fields.dots[0][1], 2);
        let bend = graph.subtract(product, square);
        let scale = inverse_power(graph, fields.dots[0][0], p);
        let density = graph.multiply(bend, scale);
        Density::Energy(graph.multiply(half, density))
    };
    vec![
        Term {
            name: "axial strain",
            coefficient: "EA",
            density: match law {
                Axial::Linear => Density::Measure(strain),
                Axial::Slack => Density::Law {
                    measure: strain,
                    law: slack,
                },
            },
            points: None,
        },
        Term {
            name: "bending",
            coefficient: "EI",
            density: bending,
            points: None,
        },
    ]
}

fn inverse_power(graph: &mut Graph, base: Id, exponent: f64) -> Id {
    let exponent = graph.number(-exponent);
    graph.general_power(base, exponent)
}
