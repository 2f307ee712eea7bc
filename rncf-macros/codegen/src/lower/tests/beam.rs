//! Masses, joints and moments of bodies whose nodes carry the axes of a section.

use super::model::{base, number, numbers};
use super::{Inputs, Random, assert_tangent, evaluate, fill};
use crate::elements::Library;
use crate::expand;
use crate::lower::Variant;
use crate::lower::field_forces::field_forces_kernel;
use crate::lower::inertia::unit_mass;
use crate::lower::joints::{JointKernels, joint_kernels};
use crate::lower::loads::section_moment_kernels;
use crate::model::*;

fn beam() -> ElementId {
    ElementId(Library::standard().find("beam").unwrap())
}

fn variant(dimension: usize, damped: bool) -> Variant {
    let mut variant = Variant::of(&base(), &base().bodies[0], &Library::standard());
    (variant.element, variant.dimension, variant.damped) = (beam(), dimension, damped);
    variant
}

/// Of quadratic shape functions with nodes 0, 1/2, 1; nothing between different interpolants.
#[test]
fn masses_of_section_axes() {
    let library = Library::standard();
    for (dimension, axes) in [(2, &[[2, 3, 6]][..]), (3, &[[2, 4, 8], [3, 5, 9]])] {
        let mass = unit_mass(&variant(dimension, false), &library);
        let closed = [
            [2.0 / 15.0, 1.0 / 15.0, -1.0 / 30.0],
            [1.0 / 15.0, 8.0 / 15.0, 1.0 / 15.0],
            [-1.0 / 30.0, 1.0 / 15.0, 2.0 / 15.0],
        ];
        for axis in axes {
            for a in 0..mass.len() {
                for (i, &b) in axis.iter().enumerate() {
                    let wanted = axis.iter().position(|&other| other == a).map_or(0.0, |j| closed[j][i]);
                    assert_eq!(mass[a][b], wanted, "{a} {b}");
                }
            }
        }
        let end = mass.len() - if dimension == 2 { 3 } else { 4 };
        assert_eq!((mass[0][0], mass[0][end]), (13.0 / 35.0, 9.0 / 70.0));
    }
}

/// The joint `root`, at the start of a body with a section, in a frame that turns relative to the body's.
fn joint(kind: JointKind) -> JointKernels {
    let mut model = base();
    model.joints[0].kind = kind;
    model.joints[0].frame = FrameId(1);
    joint_kernels(&model, &model.joints[0], true, false)
}

/// Constants, and q, q', q'' with constant q'' at a time.
fn states(kernels: &JointKernels, t: f64) -> Inputs {
    let mut inputs = Inputs::new();
    let mut random = Random(3);
    for i in 0..9 {
        let [q, v, a] = [(); 3].map(|()| random.next());
        inputs.insert(format!("q[{i}]"), q + v * t + 0.5 * a * t * t);
        inputs.insert(format!("v[{i}]"), v + a * t);
        inputs.insert(format!("a[{i}]"), a);
    }
    inputs.extend([("t".to_string(), t), ("model.gap".to_string(), 0.5)]);
    let levels = kernels.levels.iter().flatten();
    for kernel in levels.chain([&kernels.jacobian, &kernels.prescribed]) {
        fill(kernel, &mut inputs, &mut Random(4));
    }
    inputs
}

/// Rows of a level with the highest derivative of q: `J v` and `J a` are left out of the kernels.
fn whole_rows(kernels: &JointKernels, level: usize, width: usize, t: f64) -> Vec<f64> {
    let inputs = states(kernels, t);
    let rows = kernels.levels[level].as_ref().map(|kernel| evaluate(kernel, &inputs));
    let rows = rows.unwrap_or_default();
    let jacobian = evaluate(&kernels.jacobian, &inputs);
    let word = ["q", "v", "a"].get(level).filter(|_| level > 0);
    // What is not written is zero.
    let at = |values: &std::collections::HashMap<String, f64>, place: &str| values.get(place).copied().unwrap_or(0.0);
    let count = kernels.levels[0].as_ref().map_or(0, |kernel| kernel.outputs.len());
    (0..count)
        .map(|row| {
            let entry = |column: usize| at(&jacobian, &format!("jacobian[{}]", row * width + column));
            let along = word.map_or(0.0, |word| {
                (0..width).map(|c| entry(c) * inputs[&format!("{word}[{c}]")]).sum()
            });
            at(&rows, &format!("rows[{row}]")) + along
        })
        .collect()
}

#[test]
fn levels_of_joints_on_sections() {
    let held = |of| JointKind::Hold { of, axis: 1 };
    for (kind, width, count) in [
        (JointKind::Clamp, 9, 6),
        (JointKind::ClampFull, 9, 9),
        (JointKind::Pin, 9, 3),
        (held(Held::Position), 9, 1),
        (held(Held::Slope), 6, 1),
        (held(Held::SectionY), 9, 1),
        (held(Held::SectionZ), 9, 1),
    ] {
        let kernels = joint(kind);
        let (t, step) = (0.4, 1e-4);
        for level in 0..3 {
            let [up, down] = [t + step, t - step].map(|t| whole_rows(&kernels, level, width, t));
            let rates = whole_rows(&kernels, level + 1, width, t);
            assert_eq!(rates.len(), count, "{kind:?}");
            for ((up, down), rate) in up.iter().zip(&down).zip(rates) {
                let difference = (up - down) / (2.0 * step);
                assert!(
                    (difference - rate).abs() < 1e-6 * (1.0 + rate.abs()),
                    "{kind:?} level {level}: {rate} instead of {difference}"
                );
            }
        }
        let q: Vec<String> = (0..width).map(|i| format!("q[{i}]")).collect();
        let inputs = states(&kernels, t);
        let position = kernels.levels[0].as_ref().unwrap();
        assert_tangent(&kernels.jacobian, "jacobian", position, "rows", &q, &inputs);
    }
}

/// What is prescribed fulfils the conditions where the constants are a triad.
#[test]
fn prescribed_axes_fulfil_the_conditions() {
    for kind in [JointKind::Clamp, JointKind::ClampFull] {
        let kernels = joint(kind);
        let mut inputs = states(&kernels, 0.3);
        let triad = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
        let names = ["data.tangent", "data.normals[0]", "data.normals[1]"];
        let second = ("data.second", triad[2]);
        for (name, vector) in names.into_iter().zip(triad).chain([second]) {
            for (i, value) in vector.into_iter().enumerate() {
                inputs.insert(format!("{name}[{i}]"), value);
            }
        }
        let prescribed = evaluate(&kernels.prescribed, &inputs);
        for (vector, what) in ["position", "slope", "second"].iter().enumerate() {
            for i in 0..3 {
                inputs.insert(
                    format!("q[{}]", 3 * vector + i),
                    prescribed[&format!("prescribed.{what}[0][{i}]")],
                );
            }
        }
        for (row, value) in evaluate(kernels.levels[0].as_ref().unwrap(), &inputs) {
            assert!(value.abs() < 1e-14, "{kind:?} {row}: {value}");
        }
    }
}

/// The axes' forces have the moment, and the virtual work of a section that turns.
#[test]
fn moments_on_sections() {
    let [force, tangent] = section_moment_kernels();
    let mut inputs = Inputs::new();
    fill(&force, &mut inputs, &mut Random(12));
    let of = |inputs: &Inputs, name: &str, from: usize| -> [f64; 3] {
        std::array::from_fn(|i| inputs[&format!("{name}[{}]", from + i)])
    };
    let cross = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
    };
    let found = evaluate(&force, &inputs);
    let parts = [0, 3].map(|from| cross(of(&inputs, "axes", from), of(&found, "force", from)));
    let moment = of(&inputs, "moment", 0);
    for i in 0..3 {
        let sum = parts[0][i] + parts[1][i];
        assert!((sum - moment[i]).abs() < 1e-13, "{sum} instead of {}", moment[i]);
    }
    let axes: Vec<String> = (0..6).map(|i| format!("axes[{i}]")).collect();
    assert_tangent(&tangent, "tangent", &force, "force", &axes, &inputs);
}

/// Uniform strain and curvature of a straight beam: N = EA e11 r_x, and the moment E I_zz kz of the section.
#[test]
fn forces_on_fields() {
    let library = Library::standard();
    let kernel = field_forces_kernel(&variant(2, true), &library);
    let mut inputs = Inputs::from([("damping".to_string(), 0.25)]);
    let set = |inputs: &mut Inputs, name: &str, values: [f64; 6]| {
        inputs.extend((0..6).map(|i| (format!("{name}[{i}]"), values[i])));
    };
    set(&mut inputs, "stress_free", [1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    let (stretch, curvature) = (1.01, 0.02);
    set(&mut inputs, "fields", [stretch, 0.0, 0.0, 1.0, -curvature, 0.0]);
    set(&mut inputs, "rates", [0.4, 0.0, 0.0, 0.0, 0.0, 0.0]);
    fill(&kernel, &mut inputs, &mut Random(2));
    let forces = evaluate(&kernel, &inputs);
    let strain = 0.5 * (stretch * stretch - 1.0) + 0.25 * stretch * 0.4;
    let bending = -stretch * curvature - 0.25 * 0.4 * curvature;
    let moment = inputs["EIz"] * bending;
    let axial = inputs["EA"] * strain * stretch - moment * curvature;
    for (place, wanted) in [(0, axial), (1, 0.0), (3, 0.0), (4, moment * stretch), (5, 0.0)] {
        let found = forces[&format!("forces[{place}]")];
        assert!((found - wanted).abs() < 1e-14, "{place}: {found} instead of {wanted}");
    }
}

#[test]
fn bodies_with_sections_are_written() {
    let mut model = base();
    model.bodies[1].element = beam();
    model.bodies[1].shape = SectionShape::Rectangle {
        sizes: [number(0.01), Expr::Param(ParamId(1))],
    };
    model.bodies[1].properties.insert("second_moment_z", number(1e-9));
    model.bodies[1].properties.insert("shear_factor_y", number(0.8));
    model.bodies[1].properties.insert("yield", number(2e8));
    model.fixtures.push(Fixture {
        repeat: None,
        name: "disc".to_string(),
        doc: String::new(),
        body: BodyId(1),
        at: Location::End,
        constants: std::array::from_fn(|i| number(i as f64)),
        elastic: false,
    });
    model.loads.push(Load {
        name: "twist".to_string(),
        doc: String::new(),
        kind: LoadKind::Moment {
            body: BodyId(1),
            at: Location::End,
            components: numbers([0.0, 0.0, 1.0]),
            frame: INERTIAL,
        },
    });
    let text = expand::format(&expand::written_out(&model, &Library::standard()));
    for there in [
        "let shear_modulus = young / (2.0 * (1.0 + poisson));",
        "SectionShape::Rectangle",
        "Body `strip` has nodal vectors for the section's y axis (r0y, ry_half, r1y)",
        "yield_stress: Some(200000000.0)",
        "stride: 4",
        "name: \"disc\"",
        "fn moment_planar(",
        "fn beam_planar_shapes_section_y_1(",
        "fn beam_planar_field_forces(",
        "(::rncf::emitted::Interpolant::SectionY, 1)",
    ] {
        assert!(text.contains(there), "{there} is missing");
    }
    for absent in [
        "section_moment(",
        "shapes_section_z",
        "let double_shear_modulus",
        "let lame",
    ] {
        assert!(!text.contains(absent), "{absent} should not be there");
    }
}
