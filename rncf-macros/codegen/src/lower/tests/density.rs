//! Loads per length against the printed constants of THEORY 5.1, sums of many points, and complex steps.

use super::{Inputs, Random, assert_tangent, checked, evaluate, fill};
use crate::elements::{Interpolant, Library};
use crate::lower::Variant;
use crate::lower::density::{DensityKernels, density_kernels};
use crate::model::Model;
use crate::tensors::gauss_rule;

/// A model with one body and one density.
fn model(space: &str, element: &str, density: &str) -> Model {
    let text = format!(
        "model Thrust {{
            param p = 1.5 N/m; param rx = 0.3; param ry = -0.5; param rz = 0.8; param stiff = 2 [N/m^2];
            material aluminium {{ density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }}
            section wire = circle(radius = 1 mm);
            body tether in inertial {{ {space}; line from [0, 0, 0] m to [2, 0, 0] m; mesh 3 * {element}(wire, aluminium); }}
            joint root = clamp(tether.start, inertial);
            load push = density(tether, {density});
            output tip = tether.end;
        }}"
    );
    checked(&text)
}

const THRUST: &str = "p * (dot(slope, slope) * [rx, ry, rz] - slope * dot(slope, [rx, ry, rz]))";

/// Random inputs of one element, with the values that belong to them.
fn inputs(kernels: &DensityKernels, seed: u64) -> Inputs {
    let mut inputs = Inputs::new();
    let mut random = Random(seed);
    inputs.insert("length".to_string(), 0.7);
    fill(kernels.value.as_ref().unwrap(), &mut inputs, &mut random);
    for (place, value) in evaluate(kernels.value.as_ref().unwrap(), &inputs) {
        inputs.insert(place, value);
    }
    fill(&kernels.force, &mut inputs, &mut random);
    fill(&kernels.tangent, &mut inputs, &mut random);
    inputs
}

fn names(model: &Model) -> Vec<Vec<String>> {
    let library = Library::standard();
    Variant::of(model, &model.bodies[0], &library).component_names(&library, "")
}

/// `int s_i' s_j' s_m ..`: iota^1..4 as printed, at the length l.
fn iota(l: f64) -> [[[f64; 4]; 4]; 4] {
    let (a, b, c) = (3.0 / (5.0 * l), 1.0 / 70.0, 4.0 / 35.0);
    let (d, e, f) = (43.0 * l / 420.0, 13.0 * l / 420.0, l / 60.0);
    let (g, h, i) = (9.0 / 70.0, l / 140.0, 3.0 * l / 140.0);
    let (j, k, m) = (l * l / 120.0, l * l / 840.0, l * l / 168.0);
    [
        [[a, -b, -a, c], [-b, d, b, -f], [-a, b, a, -c], [c, -f, -c, e]],
        [[g, h, -g, i], [h, j, -h, -k], [-g, -h, g, -i], [i, -k, -i, m]],
        [[a, c, -a, -b], [c, e, -c, -f], [-a, -c, a, b], [-b, -f, b, d]],
        [[-g, -i, g, -h], [-i, -m, i, k], [g, i, -g, h], [-h, k, h, -j]],
    ]
}

/// `Q^i = c iota^{i,jm} [(q_j . q_m) rho - q_j (q_m . rho)]`, and zeta in the sum over positions.
#[test]
fn the_thrust_has_the_printed_tensors() {
    let model = model("spatial", "cable", THRUST);
    let kernels = &density_kernels(&model, &Library::standard())[0];
    let inputs = inputs(kernels, 3);
    let force = evaluate(&kernels.force, &inputs);
    let at = |name: &str| inputs[name];
    let q: Vec<Vec<f64>> = names(&model)
        .iter()
        .map(|names| names.iter().map(|name| at(name)).collect())
        .collect();
    let rho = [at("model.rx"), at("model.ry"), at("model.rz")];
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let l = at("length");
    let (p, iota) = (at("model.p"), iota(l));
    let zeta = [
        [6.0 / (5.0 * l), 0.1, -6.0 / (5.0 * l), 0.1],
        [0.1, 2.0 * l / 15.0, -0.1, -l / 30.0],
        [-6.0 / (5.0 * l), -0.1, 6.0 / (5.0 * l), -0.1],
        [0.1, -l / 30.0, -0.1, 2.0 * l / 15.0],
    ];
    let with = |tensor: &[[f64; 4]; 4], c: usize| -> f64 {
        let pairs = (0..16).map(|pair| (pair / 4, pair % 4));
        let term = |(j, m): (usize, usize)| tensor[j][m] * (dot(&q[j], &q[m]) * rho[c] - q[j][c] * dot(&q[m], &rho));
        p * pairs.map(term).sum::<f64>()
    };
    let mut largest = 0.0_f64;
    for c in 0..3 {
        for (i, tensor) in iota.iter().enumerate() {
            let (found, expected) = (force[&format!("force[{}]", 3 * i + c)], with(tensor, c));
            assert!((found - expected).abs() < 1e-14, "Q^{i}_{c}: {found} {expected}");
            largest = largest.max(expected.abs());
        }
        let whole = force[&format!("force[{c}]")] + force[&format!("force[{}]", 6 + c)];
        assert!((whole - with(&zeta, c)).abs() < 1e-14);
    }
    assert!(largest > 0.1);
}

/// Every element, in plane and space: forces are sums over many points with the element's own shape functions.
#[test]
fn forces_are_sums_over_many_points() {
    let library = Library::standard();
    for (space, element, density) in [
        (
            "spatial",
            "cable",
            "p * dot(slope, slope) * slope - stiff * position * slope.x",
        ),
        (
            "planar xy",
            "cable",
            "p * dot(slope, slope) * slope - stiff * position * slope.x",
        ),
        (
            "spatial",
            "beam",
            "p * dot(slope, slope) * slope - stiff * position * slope.x",
        ),
        (
            "planar zx",
            "beam",
            "p * dot(slope, slope) * slope - stiff * position * slope.x",
        ),
    ] {
        let model = model(space, element, density);
        let kernels = &density_kernels(&model, &library)[0];
        let inputs = inputs(kernels, 5);
        let force = evaluate(&kernels.force, &inputs);
        let body = &model.bodies[0];
        let vectors = Variant::of(&model, body, &library).vectors(&library);
        let (axes, l) = (body.space.axes(), inputs["length"]);
        let d = axes.len();
        let names = names(&model);
        let mut expected = vec![0.0; vectors.len() * d];
        let rule = gauss_rule(10);
        for (&xi, &weight) in rule.points.iter().zip(&rule.weights) {
            let shape = |a: usize, order: usize| {
                let scale = l.powi(vectors[a].order as i32 - order as i32);
                let is_axis = vectors[a].of == Interpolant::Position;
                if is_axis {
                    scale * vectors[a].shape.derivative(order).at(xi)
                } else {
                    0.0
                }
            };
            let at = |order: usize| -> [f64; 3] {
                let mut vector = [0.0; 3];
                for (c, &axis) in axes.iter().enumerate() {
                    vector[axis] = (0..vectors.len())
                        .map(|a| shape(a, order) * inputs.get(&names[a][c]).copied().unwrap_or(0.0))
                        .sum();
                }
                vector
            };
            let (p, s) = (at(0), at(1));
            let square: f64 = s.iter().map(|s| s * s).sum();
            for a in 0..vectors.len() {
                for (c, &axis) in axes.iter().enumerate() {
                    let f = inputs["model.p"] * square * s[axis] - inputs["model.stiff"] * p[axis] * s[0];
                    expected[a * d + c] += l * weight * shape(a, 0) * f;
                }
            }
        }
        let mut largest = 0.0_f64;
        for (place, expected) in expected.into_iter().enumerate() {
            let found = force.get(&format!("force[{place}]")).copied().unwrap_or(0.0);
            assert!(
                (found - expected).abs() < 1e-13,
                "{element} {space} {place}: {found} {expected}"
            );
            largest = largest.max(expected.abs());
        }
        assert!(largest > 0.1, "{element} {space}");
    }
}

#[test]
fn tangents_are_complex_steps() {
    for (space, element, density) in [
        ("spatial", "cable", THRUST),
        (
            "spatial",
            "cable",
            "p * dot(slope, slope)^2 * [rx, ry, rz] - stiff * position",
        ),
        (
            "planar xy",
            "cable",
            "p * dot(slope, slope) * slope - stiff * position * slope.x",
        ),
        (
            "spatial",
            "beam",
            "p * dot(slope, slope) * slope - stiff * position * slope.x",
        ),
    ] {
        let model = model(space, element, density);
        let kernels = &density_kernels(&model, &Library::standard())[0];
        let inputs = inputs(kernels, 7);
        let q = names(&model).concat();
        assert_tangent(&kernels.tangent, "by_q", &kernels.force, "force", &q, &inputs);
        let values: Vec<String> = (0..kernels.values).map(|place| format!("values[{place}]")).collect();
        assert_tangent(&kernels.tangent, "by_values", &kernels.force, "force", &values, &inputs);
    }
}

/// A constant load needs two points of a Hermite element, and its values are the components.
#[test]
fn what_is_the_same_along_the_body_is_a_value() {
    let library = Library::standard();
    let of = |density: &str| density_kernels(&model("spatial", "cable", density), &library)[0].clone();
    let weight = of("[0, -p, 0]");
    assert_eq!(weight.values, 1);
    assert!(
        weight.force.doc[1].contains("by 2 Gauss points"),
        "{:?}",
        weight.force.doc
    );
    let thrust = of(THRUST);
    assert_eq!(thrust.values, 4);
    let [_, integrated, counts] = &thrust.force.doc[..] else {
        panic!("{:?}", thrust.force.doc)
    };
    assert_eq!(integrated, "Integrated exactly by constant tensors.");
    assert!(counts.contains("constant tensors 1896, points 1979"), "{counts}");
    // One array, as nothing is linear in the slope.
    let arrays: Vec<&str> = thrust
        .tangent
        .graph
        .arrays()
        .iter()
        .map(|array| array.name.as_str())
        .collect();
    assert_eq!(arrays, ["CABLE_SPATIAL_DENSITY_IOTA"]);
    assert!(thrust.gradient.is_none());
}
