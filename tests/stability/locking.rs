//! T7 of THEORY 10: Poisson, shear and membrane locking of beams with sections.

use std::f64::consts::PI;

use rncf::Model;
use rncf::equilibrium::{Uniform, follow};
use rncf_models::{Elastica, RollUp};
use rncf_reference::dense::Matrix;
use rncf_reference::section_beam::{Properties, Section};
use rncf_reference::section_chain::{Chain, Hold, Shape, Slot, Supports, straight};
use rncf_reference::section_statics::{Load, Problem};

use crate::scenes::referenced;

/// A load under which displacements are linear.
const SMALL: f64 = 1e-5;
const SLENDER: f64 = 5e-4;

fn section(radius: f64) -> Section {
    Section::circle(radius, 210e9, 0.3, 7850.0)
}

/// Outputs of the static equilibrium of a model.
fn at_rest(model: &impl Model) -> Vec<f64> {
    let (mut scene, at) = (referenced(model), Uniform::at_rest(0.0));
    let found = follow(scene.as_mut(), &at, 0.125, |_, _| ()).unwrap();
    let mut row = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&at, found.state().unwrap(), &mut row);
    row
}

/// Displacement of the tip of a clamped chain, linear in a dead force on it.
fn tip(properties: Properties, elements: usize, shape: impl Fn(f64) -> Shape, force: [f64; 3]) -> [f64; 3] {
    let chain = Chain::along(properties, elements, shape).unwrap();
    let problem = Problem {
        supports: Supports::clamp(&chain, Hold::Direction),
        chain,
        loads: vec![Load::Force(elements, force)],
        spin: [0.0; 3],
    };
    let rest = problem.chain.stress_free();
    let (residual, tangent) = problem.residual(1.0, rest).unwrap();
    let step: Vec<f64> = tangent.solve(&residual).unwrap().iter().map(|x| -x).collect();
    let mut moved = vec![0.0; rest.len()];
    problem.supports.move_by(&step, &mut moved);
    problem
        .chain
        .read(&moved, problem.chain.vector(elements, Slot::Position))
}

/// Deflection over Timoshenko's of a straight cantilever in the runtime.
fn ours(slenderness: f64, elements: usize) -> f64 {
    let model = Elastica {
        alpha: SMALL,
        slenderness,
        elements,
    };
    let shear_factor = 6.0 * 1.3 / (7.0 + 6.0 * 0.3);
    at_rest(&model)[1] / SMALL / (1.0 / 3.0 + 0.25 * slenderness * slenderness * 2.6 / shear_factor)
}

#[test]
fn the_modulus_of_a_body_in_the_bending_terms_locks_at_any_refinement() {
    let section = section(SLENDER);
    let mut full = Properties::coupled(3, 1.0, &section);
    for stiffness in &mut full.gradients[..2] {
        *stiffness *= section.confined() / section.young;
    }
    let exact = 1.0 / (3.0 * section.young * section.i_zz);
    for elements in [1, 8] {
        let locked = tip(full, elements, straight, [0.0, 1.0, 0.0])[1] / exact;
        let held = ours(SLENDER, elements);
        println!("{elements} elements: full 3D law {locked:.4}, ours {held:.6}");
        assert!((locked - 1.3 * 0.4 / 0.7).abs() < 1e-4, "{locked}");
        assert!((held - 1.0).abs() < 1e-6, "{held}");
    }
}

/// Tip deflection over Timoshenko's of a cantilever of length 1 with `EI = 1` and the shear stiffness `s`: elements with
/// straight lines for deflection and rotation, integrated exactly.
fn straight_lines(s: f64, elements: usize) -> f64 {
    let l = 1.0 / elements as f64;
    // Deflection and rotation at both ends; w' and the shear w' - phi at the points of integration.
    let mut matrix = Matrix::zero(2 * elements);
    for element in 0..elements {
        let bending = [0.0, -1.0 / l, 0.0, 1.0 / l];
        let mut terms = vec![(l, bending)];
        for xi in [0.5 - 12f64.powf(-0.5), 0.5 + 12f64.powf(-0.5)] {
            terms.push((0.5 * l * s, [-1.0 / l, xi - 1.0, 1.0 / l, -xi]));
        }
        for (weight, row) in terms {
            for (i, a) in row.iter().enumerate() {
                for (j, b) in row.iter().enumerate() {
                    // The first node is clamped.
                    if let (Some(i), Some(j)) = ((2 * element + i).checked_sub(2), (2 * element + j).checked_sub(2)) {
                        matrix.add(i, j, weight * a * b);
                    }
                }
            }
        }
    }
    let mut load = vec![0.0; 2 * elements];
    load[2 * elements - 2] = 1.0;
    matrix.solve(&load).unwrap()[2 * elements - 2] / (1.0 / 3.0 + 1.0 / s)
}

#[test]
fn straight_lines_lock_in_shear() {
    let shear_factor = 6.0 * 1.3 / (7.0 + 6.0 * 0.3);
    for (slenderness, elements) in [(0.05, 1), (0.005, 1), (0.005, 8), (5e-4, 8)] {
        let s = 4.0 * shear_factor / (2.6 * slenderness * slenderness);
        let (locked, held) = (straight_lines(s, elements), ours(slenderness, elements));
        println!("r/L {slenderness}, {elements} elements: straight lines {locked:.2e}, ours {held:.6}");
        assert!((held - 1.0).abs() < 1e-6 && locked < 0.9);
        assert!(slenderness > 0.01 || elements > 1 || locked < 1e-3);
    }
}

/// Deflection over Bernoulli's of a clamped quarter of a circle of length 1 under a small dead force across its start.
fn quarter(axis_points: usize, gradient_points: usize, elements: usize) -> f64 {
    let section = section(SLENDER);
    let properties = Properties {
        axis_points,
        gradient_points,
        ..Properties::structural(2, 1.0, &section)
    };
    let arc = |x: f64| -> Shape {
        let (s, c) = (0.5 * PI * x).sin_cos();
        let at = [2.0 / PI * s, 2.0 / PI * (1.0 - c), 0.0];
        [at, [c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]
    };
    let exact = BERNOULLI / (section.young * section.i_zz);
    tip(properties, elements, arc, [0.0, 1.0, 0.0])[1] / exact
}

/// `int (x_tip - x)^2 ds = R^3 (3 pi/4 - 2)` with `R = 2/pi`: EI times the deflection under a unit force.
const BERNOULLI: f64 = 8.0 / (PI * PI * PI) * (0.75 * PI - 2.0);

rncf::model! {
    /// The same quarter of a circle.
    pub model Quarter {
        param elements: count = 2;
        const radius = 0.5 mm;
        const young = 210 [GPa];
        material steel { density = 7850 kg/m^3; young = young; poisson = 0.3; }
        section round = circle(radius = radius);
        body beam {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius 2 / pi * 1 [m] angle 90 deg;
            mesh elements * beam(round, steel);
        }
        joint root = clamp(beam.start, inertial);
        load across = force(beam.end, [0 N, 1e-5 * young * pi / 4 * radius^4 / 1 [m^2], 0 N], in = inertial);
        output deflection = (beam.end.y - 2 / pi * 1 [m]) / 1e-5;
    }
}

#[test]
fn full_integration_locks_where_the_axis_curves() {
    for elements in [1, 2, 4] {
        let [full, selective] = [(5, 5), (3, 2)].map(|(axis, gradient)| quarter(axis, gradient, elements));
        let held = at_rest(&Quarter { elements })[0] / BERNOULLI;
        println!(
            "quarter of a circle, {elements} elements: full integration {full:.4}, 3 and 2 points {selective:.4}, ours {held:.4}"
        );
        assert!((held / selective - 1.0).abs() < 1e-3 && (held - 1.0).abs() < 0.07);
        assert!(elements > 2 || full < 0.1);
    }
    // Rolled up to a circle in four elements (THEORY 5.2.1): place of the tip, which the exact solution brings home.
    let section = section(0.005);
    let rolled = |axis_points, gradient_points| {
        let properties = Properties {
            axis_points,
            gradient_points,
            ..Properties::structural(2, 1.0, &section)
        };
        let chain = Chain::along(properties, 4, straight).unwrap();
        let problem = Problem {
            supports: Supports::clamp(&chain, Hold::Fixed),
            chain,
            loads: vec![Load::Moment(4, 2.0 * PI * section.young * section.i_zz)],
            spin: [0.0; 3],
        };
        let place = problem
            .chain
            .read(&problem.solve(20).unwrap(), problem.chain.vector(4, Slot::Position));
        place[0].hypot(place[1])
    };
    let model = RollUp {
        turns: 1.0,
        slenderness: 0.005,
        elements: 4,
    };
    let (full, gap) = (rolled(5, 5), at_rest(&model)[2]);
    println!("rolled up in four elements: gap {full:.4} with full integration, ours {gap:.4}");
    assert!(full > 0.1 && gap < 0.01 && (gap - rolled(3, 2)).abs() < 1e-6);
}
