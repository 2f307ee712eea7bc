//! Ten-vector beam whose section has a full matrix of stiffness: strains of a geometrically exact rod, written as inner products
//! of r_x, r_y, r_z and their derivatives (docs/theory.md, 5.2.2).

use std::sync::Arc;

use super::{Coefficient, Density, Element, Invariants, Term, axial_strain};
use crate::model::Function;
use crate::symbolic::{Graph, Id};

/// Name in generated code of the one that damps each strain by itself.
pub const VISCOUS: &str = "full_beam_viscous";

/// Gauss points of the strains of the axis, and of the section's gradients; those of the beam with a section.
const AXIS_POINTS: usize = 3;
const GRADIENT_POINTS: usize = 2;

/// The elements behind the word `beam` where the section says its stiffness itself, with the vectors of the beam: without
/// and with a damping of its own for each strain, where the stress of the rates is `sqrt(c_i c_j) K_ij e_j'`.
pub fn full_beam(beam: &Element) -> [Element; 2] {
    [("full_beam", false), (VISCOUS, true)].map(|(kernel, is_viscous)| Element {
        kernel,
        doc: "Beam with a full matrix of stiffness: axial strain, shear, torsion, bending, all coupled".into(),
        of_stiffness: true,
        coefficients: {
            let count = if is_viscous { COEFFICIENTS.len() } else { ELASTIC };
            COEFFICIENTS[..count].iter().map(pivot).collect()
        },
        inertia: Vec::new(),
        options: Vec::new(),
        energy: Arc::new(move |graph: &mut Graph, fields: &Invariants, _: &[usize]| energy(graph, fields, is_viscous)),
        ..beam.clone()
    })
}

/// Coefficients without those of the strains' rates.
const ELASTIC: usize = 25;

/// Pivots and factors of the stiffness, what holds the section, then the factors of the strains' rates.
const COEFFICIENTS: &[(&str, &str)] = &[
    ("D1", "N m^2"),
    ("D2", "N m^2"),
    ("D3", "N m^2"),
    ("D4", "N"),
    ("D5", "N"),
    ("D6", "N"),
    ("L21", "1"),
    ("L31", "1"),
    ("L32", "1"),
    ("L41", "1/m"),
    ("L42", "1/m"),
    ("L43", "1/m"),
    ("L51", "1/m"),
    ("L52", "1/m"),
    ("L53", "1/m"),
    ("L54", "1"),
    ("L61", "1/m"),
    ("L62", "1/m"),
    ("L63", "1/m"),
    ("L64", "1"),
    ("L65", "1"),
    ("held", "N"),
    ("half_held", "N"),
    ("smooth", "N m^2"),
    ("half_smooth", "N m^2"),
    ("V1", "s^(1/2)"),
    ("V2", "s^(1/2)"),
    ("V3", "s^(1/2)"),
    ("V4", "s^(1/2)"),
    ("V5", "s^(1/2)"),
    ("V6", "s^(1/2)"),
    ("W21", "s^(1/2)"),
    ("W31", "s^(1/2)"),
    ("W32", "s^(1/2)"),
    ("W41", "s^(1/2)/m"),
    ("W42", "s^(1/2)/m"),
    ("W43", "s^(1/2)/m"),
    ("W51", "s^(1/2)/m"),
    ("W52", "s^(1/2)/m"),
    ("W53", "s^(1/2)/m"),
    ("W54", "s^(1/2)"),
    ("W61", "s^(1/2)/m"),
    ("W62", "s^(1/2)/m"),
    ("W63", "s^(1/2)/m"),
    ("W64", "s^(1/2)"),
    ("W65", "s^(1/2)"),
];

fn pivot(&(name, unit): &(&'static str, &'static str)) -> Coefficient {
    Coefficient {
        name,
        unit,
        factors: Vec::new(),
        scale: None,
    }
}

/// With the strains of the rod `g1 = n . r_x - 1, g2 = r_y . r_x, g3 = r_z . r_x`, the curvatures `k1 = r_z . r_y', k2 = n . r_z',
/// k3 = -n . r_y'`, n normal to r_y and r_z, and the factorization `L D L^T` of the stiffness in the order k1, k2, k3, g1, g2, g3:
/// `W = 1/2 sum_i D_i (e_i + sum_(j > i) L_ji e_j)^2`. The first three terms are integrated with the points of the
/// gradients, the others with those of the axis, so that each part is positive by itself. What the section does in its own
/// plane has no stiffness of its own in a rod: it is held by further terms, which the strains above do not excite.
fn energy(graph: &mut Graph, fields: &Invariants, is_viscous: bool) -> Vec<Term> {
    let (a, b, c, db, dc) = (0, 1, 2, 3, 4);
    let dots = &fields.dots;
    let [half, one] = [graph.number(0.5), graph.one()];
    let widening = [b, c].map(|axis| axial_strain(graph, dots[axis][axis], false));
    // Of unit vectors r_y and r_z: r_x = (1 + g1) n + g2 r_y + g3 r_z.
    let [y, z] = [dots[a][b], dots[a][c]];
    let squares = [y, z].map(|shear| graph.power(shear, 2));
    let across = graph.add(squares[0], squares[1]);
    let square = graph.subtract(dots[a][a], across);
    let stretch = graph.call(Function::Sqrt, square);
    let axial = graph.subtract(stretch, one);
    let difference = graph.subtract(dots[db][c], dots[dc][b]);
    let turn = graph.multiply(half, difference);
    let narrower = widening.map(|strain| graph.subtract(one, strain));
    let torsion = {
        let both = graph.multiply(narrower[0], narrower[1]);
        graph.multiply(turn, both)
    };
    let mut bending = |along: Id, shear: Id, adds: bool, narrower: Id| {
        let turned = graph.multiply(shear, turn);
        let whole = if adds {
            graph.add(along, turned)
        } else {
            graph.subtract(along, turned)
        };
        let per_stretch = graph.divide(whole, stretch);
        graph.multiply(per_stretch, narrower)
    };
    let about_y = bending(dots[a][dc], y, true, narrower[1]);
    let about_z = bending(dots[a][db], z, false, narrower[0]);
    let about_z = graph.negate(about_z);
    let strains = [torsion, about_y, about_z, axial, y, z];
    let names = [
        ("torsion", "D1"),
        ("bending about y", "D2"),
        ("bending about z", "D3"),
        ("axial strain", "D4"),
        ("shear along y", "D5"),
        ("shear along z", "D6"),
    ];
    let mut terms = Vec::new();
    for (i, (name, coefficient)) in names.into_iter().enumerate() {
        let with = |graph: &mut Graph, mut measure: Id, letter: char| {
            for (j, &strain) in strains.iter().enumerate().skip(i + 1) {
                let factor = graph.input(format!("{letter}{}{}", j + 1, i + 1));
                let part = graph.multiply(factor, strain);
                measure = graph.add(measure, part);
            }
            measure
        };
        let measure = with(graph, strains[i], 'L');
        let points = if i < 3 { GRADIENT_POINTS } else { AXIS_POINTS };
        if !is_viscous {
            terms.push(term(name, coefficient, measure, points));
            continue;
        }
        let own = graph.input(format!("V{}", i + 1));
        let own = graph.multiply(own, strains[i]);
        let rate = with(graph, own, 'W');
        for density in [Density::Undamped(measure), Density::Viscous(rate)] {
            terms.push(Term {
                density,
                ..term(name, coefficient, measure, points)
            });
        }
    }
    for (name, strain) in ["strain along y", "strain along z"].into_iter().zip(widening) {
        terms.push(term(name, "held", strain, AXIS_POINTS));
    }
    terms.push(term("shear of the section", "half_held", dots[b][c], AXIS_POINTS));
    terms.push(term("gradient along y", "smooth", dots[b][db], GRADIENT_POINTS));
    terms.push(term("gradient along z", "smooth", dots[c][dc], GRADIENT_POINTS));
    let distortion = graph.add(dots[db][c], dots[dc][b]);
    let name = "gradient of the section's shear";
    terms.push(term(name, "half_smooth", distortion, GRADIENT_POINTS));
    terms
}

fn term(name: &'static str, coefficient: &'static str, measure: Id, points: usize) -> Term {
    Term {
        name,
        coefficient,
        density: Density::Measure(measure),
        points: Some(points),
    }
}
