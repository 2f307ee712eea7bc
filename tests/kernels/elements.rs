//! An element with another bending energy is one line of declaration: force and tangent follow.

use std::collections::HashMap;

use rncf_codegen::elements::Library;
use rncf_codegen::errors::Errors;
use rncf_codegen::lower::elastic::kernel;
use rncf_codegen::lower::form::{Form, Quantity};
use rncf_codegen::lower::{Variant, elastic_kernels};
use rncf_codegen::model::{ElementId, Evaluation, Quadrature};
use rncf_codegen::{check, expand, parse};

use crate::jacobians::{Random, assert_close, jacobian};

/// Curvature squared per deformed length: exponent 3 (THEORY 5.1, remark i).
const PER_DEFORMED_LENGTH: &str = "element rope(section, material) {
    domain xi in 0..1;
    vector r0 = r   at 0, shape 1 - 3*xi^2 + 2*xi^3;
    vector s0 = r_x at 0, shape xi - 2*xi^2 + xi^3;
    vector r1 = r   at 1, shape 3*xi^2 - 2*xi^3;
    vector s1 = r_x at 1, shape -xi^2 + xi^3;
    field a = r_x;
    field b = r_xx;
    coefficient EA: N      = material.young * section.area;
    coefficient EI: N m^2  = material.young * section.second_moment;
    coefficient rhoA: kg/m = material.density * section.area;
    inertia r = rhoA;
    strain e = (dot(a, a) - 1)/2;
    strain k in plane = cross(a, b)/dot(a, a)^1.5;
    energy axial_strain = 1/2*EA*e^2;
    energy bending in plane = 1/2*EI*k^2;
    energy bending in space = 1/2*EI*(dot(a, a)*dot(b, b) - dot(a, b)^2)/dot(a, a)^3;
}";

/// The library with the element.
fn with_rope() -> Library {
    let mut errors = Errors::new();
    let tokens = format!("model Ropes {{ {PER_DEFORMED_LENGTH} }}").parse().unwrap();
    let tree = parse::parse(tokens, &mut errors).unwrap();
    let library = check::element::elements(&tree, &Library::standard(), &mut errors);
    assert!(errors.finish().is_empty());
    library
}

#[test]
fn another_exponent_is_one_line() {
    let library = with_rope();
    let mut random = Random(11);
    for dimension in [2, 3] {
        let variant = Variant {
            element: library.find("rope").map(ElementId).unwrap(),
            dimension,
            options: Vec::new(),
            quadrature: Quadrature::Exact,
            evaluation: Evaluation::Automatic,
            damped: false,
            curved: false,
            varying: false,
            material: None,
        };
        let kernels = elastic_kernels(&variant, &library);
        let energy = kernel(&variant, &library, Form::Points, Quantity::Energy).unwrap();
        let names = variant.component_names(&library, "").concat();
        let mut inputs =
            HashMap::from([("length", 0.7), ("EA", 4000.0), ("EI", 130.0)].map(|(k, v)| (k.to_string(), v)));
        for (place, name) in names.iter().enumerate() {
            let straight = if place == 2 * dimension {
                0.7
            } else {
                f64::from(u8::from(place % (2 * dimension) == dimension))
            };
            inputs.insert(name.clone(), straight + 0.2 * random.next());
        }
        // Force = dU/dq by complex steps through the energy.
        let force: Vec<f64> = jacobian(&energy, &inputs, &names)
            .into_iter()
            .map(|column| column[0])
            .collect();
        let values = inputs_of(&kernels.force, &inputs);
        let roots: Vec<_> = kernels.force.outputs.iter().map(|&(_, id)| id).collect();
        if kernels.force.points.is_none() {
            let derived = kernels.force.graph.evaluate(&roots, &values);
            for (a, b) in derived.iter().zip(&force) {
                assert!((a - b).abs() <= 1e-10 * 4000.0, "{a} {b}");
            }
        }
        let unrolled = kernel(&variant, &library, Form::Points, Quantity::Tangent).unwrap();
        let roots: Vec<_> = unrolled.outputs.iter().map(|&(_, id)| id).collect();
        let tangent = unrolled.graph.evaluate(&roots, &inputs_of(&unrolled, &inputs));
        let force = kernel(&variant, &library, Form::Points, Quantity::Force).unwrap();
        assert_close("exponent 3", &tangent, &jacobian(&force, &inputs, &names));
    }
}

fn inputs_of(
    kernel: &rncf_codegen::lower::Kernel,
    inputs: &HashMap<String, f64>,
) -> HashMap<rncf_codegen::symbolic::Id, f64> {
    let roots: Vec<_> = kernel.outputs.iter().map(|&(_, id)| id).collect();
    let graph = &kernel.graph;
    let symbols = graph.reachable(&roots).into_iter();
    let symbols = symbols.filter(|&id| matches!(graph.node(id), rncf_codegen::symbolic::Node::Symbol(_)));
    symbols
        .filter_map(|id| inputs.get(graph.symbol_text(id)).map(|&value| (id, value)))
        .collect()
}

/// The new word is a word of the language at once, and its expansion is Rust.
#[test]
fn the_language_knows_the_new_element() {
    let text = |element: &str| {
        let text = format!(
            "pub model Swing {{
            {element}
            material steel {{ density = 7800 kg/m^3; young = 210 GPa; }}
            section wire {{ area = 1 mm^2; second_moment = 0.08 mm^4; }}
            body swing in inertial {{ spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * rope(wire, steel); }}
            joint top = pin(swing.start, inertial);
            load weight = gravity([0, 0, -9.81] m/s^2);
            output z = swing.end.z;
        }}"
        );
        expand::text(text.parse().unwrap(), &Library::standard())
    };
    let expansion = text(PER_DEFORMED_LENGTH).unwrap();
    assert!(expansion.contains("rope_spatial_elastic_tangent"));
    assert!(text("").is_err());
}
