//! What a free frame feels: against a sum over nodal vectors written out, and complex steps.

use super::{Inputs, Random, assert_tangent, evaluate, fill};
use crate::elements::Library;
use crate::lower::Variant;
use crate::lower::carried::{CarriedKernels, element_kernels, fixture_kernels, rigid_kernels};
use crate::lower::inertia::inertia_kernels;
use crate::model::{ElementId, Evaluation, Quadrature};

fn variant(element: &str, dimension: usize) -> Variant {
    Variant {
        element: ElementId(Library::standard().find(element).unwrap()),
        dimension,
        options: vec![0],
        quadrature: Quadrature::Exact,
        evaluation: Evaluation::Automatic,
        damped: false,
        curved: false,
        material: None,
    }
}

/// Names of e, w and w'.
fn frame_names(dimension: usize) -> [Vec<String>; 3] {
    let letters = ["x", "y", "z"];
    let vector = |word: &str| -> Vec<String> { letters.iter().map(|letter| format!("{word}_{letter}")).collect() };
    if dimension == 2 {
        return [vector("e")[..2].to_vec(), vec!["w".to_string()], vec!["dw".to_string()]];
    }
    [vector("e"), vector("w"), vector("dw")]
}

/// `F = sum over positions of R_a`, `T = sum q_a x R_a` from the nodal forces.
fn summed(dimension: usize, positions: &[usize], q: &[f64], residual: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0; if dimension == 2 { 3 } else { 6 }];
    for a in 0..q.len() / dimension {
        let (p, f) = (&q[a * dimension..], &residual[a * dimension..]);
        if positions.contains(&a) {
            (0..dimension).for_each(|c| sums[c] += f[c]);
        }
        if dimension == 2 {
            sums[2] += p[0] * f[1] - p[1] * f[0];
        } else {
            (0..3).for_each(|c| sums[3 + c] += p[(c + 1) % 3] * f[(c + 2) % 3] - p[(c + 2) % 3] * f[(c + 1) % 3]);
        }
    }
    sums
}

fn in_order(outputs: &Inputs, name: &str) -> Vec<f64> {
    (0..outputs.len())
        .map(|row| outputs[&format!("{name}[{row}]")])
        .collect()
}

fn check(
    kernels: &CarriedKernels,
    residual: &crate::lower::Kernel,
    dimension: usize,
    positions: &[usize],
    states: [Vec<String>; 3],
    inputs: &Inputs,
) {
    let [q, v, a] = states;
    let values: Vec<f64> = q.iter().map(|name| inputs[name]).collect();
    let nodal = in_order(&evaluate(residual, inputs), "force");
    let found = in_order(&evaluate(&kernels.force, inputs), "out");
    for (found, sum) in found.iter().zip(summed(dimension, positions, &values, &nodal)) {
        assert!(
            (found - sum).abs() <= 1e-13 * (1.0 + sum.abs()),
            "{found} instead of {sum}"
        );
        assert!(sum != 0.0);
    }
    let [e, w, dw] = frame_names(dimension);
    let (force, tangent) = (&kernels.force, &kernels.tangent);
    assert_tangent(tangent, "mass", force, "out", &[e, dw, a].concat(), inputs);
    assert_tangent(tangent, "damping", force, "out", &[w.clone(), v].concat(), inputs);
    assert_tangent(tangent, "stiffness", force, "out", &q, inputs);
    assert_tangent(tangent, "spin", residual, "force", &w, inputs);
}

#[test]
fn elements() {
    let library = Library::standard();
    for (element, dimension, positions) in [
        ("cable", 2, [0, 2]),
        ("cable", 3, [0, 2]),
        ("beam", 2, [0, 4]),
        ("beam", 3, [0, 6]),
    ] {
        let variant = variant(element, dimension);
        let kernels = element_kernels(&variant, &library);
        let inertia = inertia_kernels(&variant, &library);
        let residual = inertia.referenced;
        let mut inputs = Inputs::from([("length".to_string(), 0.7), ("rhoA".to_string(), 1.3)]);
        fill(&residual, &mut inputs, &mut Random(5));
        let states = ["", "v_", "a_"].map(|prefix| variant.component_names(&library, prefix).concat());
        let tangent = &inertia.referenced_tangent;
        assert_tangent(tangent, "stiffness", &residual, "force", &states[0], &inputs);
        assert_tangent(tangent, "damping_matrix", &residual, "force", &states[1], &inputs);
        check(&kernels, &residual, dimension, &positions, states, &inputs);
    }
}

#[test]
fn fixtures() {
    for (dimension, vectors) in [(2, 2), (3, 2), (2, 3), (3, 4)] {
        let kernels = fixture_kernels(dimension, vectors);
        let mut inputs = Inputs::new();
        fill(&kernels.referenced, &mut inputs, &mut Random(6));
        let states = ["", "v_", "a_"].map(|prefix| {
            let names = ["r", "s", "y", "z"][..vectors].iter();
            let names = names.flat_map(|word| ["x", "y", "z"][..dimension].iter().map(move |axis| (word, axis)));
            names
                .map(|(word, axis)| format!("{prefix}{word}_{axis}"))
                .collect::<Vec<_>>()
        });
        let (tangent, residual) = (&kernels.referenced_tangent, &kernels.referenced);
        assert_tangent(tangent, "stiffness", residual, "force", &states[0], &inputs);
        assert_tangent(tangent, "damping_matrix", residual, "force", &states[1], &inputs);
        check(&kernels.carried, residual, dimension, &[0], states, &inputs);
        // At rest the moving frame is the inertial one.
        let [_, w, dw] = frame_names(dimension);
        inputs.extend(w.into_iter().chain(dw).map(|name| (name, 0.0)));
        let (moving, inertial) = (
            evaluate(&kernels.referenced, &inputs),
            evaluate(&kernels.absolute, &inputs),
        );
        assert_eq!(moving, inertial);
    }
}

/// Particles of a fixture at `r + X r_x + Y r_y + Z r_z`: their forces add up to those on the vectors.
#[test]
fn fixtures_are_sums_over_particles() {
    let residual = fixture_kernels(3, 4).absolute;
    let mut random = Random(11);
    let names = ["r", "s", "y", "z"];
    let axes = ["x", "y", "z"];
    let constants = ["m", "m_x", "m_y", "m_z", "p_xx", "p_yy", "p_zz", "p_xy", "p_xz", "p_yz"];
    let places = [[0, 1, 2, 3], [1, 4, 7, 8], [2, 7, 5, 9], [3, 8, 9, 6]];
    let mut inputs = Inputs::from(constants.map(|name| (name.to_string(), 0.0)));
    let accelerations: [[f64; 3]; 4] = std::array::from_fn(|_| std::array::from_fn(|_| random.next()));
    let origin: [f64; 3] = std::array::from_fn(|_| random.next());
    for (name, vector) in names.iter().zip(accelerations) {
        inputs.extend(
            axes.iter()
                .zip(vector)
                .map(|(axis, value)| (format!("a_{name}_{axis}"), value)),
        );
    }
    inputs.extend(
        axes.iter()
            .zip(origin)
            .map(|(axis, value)| (format!("e_{axis}"), value)),
    );
    let mut wanted = [0.0; 12];
    for mass in [1.0, 2.0, 0.5] {
        let weights = [1.0, random.next(), random.next(), random.next()];
        for a in 0..4 {
            for b in a..4 {
                *inputs.get_mut(constants[places[a][b]]).unwrap() += mass * weights[a] * weights[b];
            }
            for c in 0..3 {
                let particle: f64 = (0..4).map(|b| weights[b] * accelerations[b][c]).sum();
                wanted[3 * a + c] += mass * weights[a] * (particle + origin[c]);
            }
        }
    }
    for (found, wanted) in in_order(&evaluate(&residual, &inputs), "force").iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-13, "{found} instead of {wanted}");
    }
}

/// Point masses of a rigid body, each with its own acceleration.
#[test]
fn rigid_parts() {
    let kernels = rigid_kernels();
    let mut random = Random(8);
    let mut vector = || -> [f64; 3] { std::array::from_fn(|_| random.next()) };
    let (e, w, dw) = (vector(), vector(), vector());
    let particles = [1.0, 2.0, 0.5, 0.7].map(|mass| (mass, vector()));
    let cross = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
    };
    let mut inputs = Inputs::new();
    let [origin, spin, rate] = frame_names(3);
    for (names, values) in [(&origin, e), (&spin, w), (&rate, dw)] {
        inputs.extend(names.iter().cloned().zip(values));
    }
    let mut wanted = [0.0; 6];
    let mut add = |name: String, value: f64| *inputs.entry(name).or_default() += value;
    for (mass, p) in particles {
        add("rigid.mass".to_string(), mass);
        let (euler, centrifugal) = (cross(dw, p), cross(w, cross(w, p)));
        let force: [f64; 3] = std::array::from_fn(|i| mass * (e[i] + euler[i] + centrifugal[i]));
        let moment = cross(p, force);
        for i in 0..3 {
            wanted[i] += force[i];
            wanted[3 + i] += moment[i];
            add(format!("rigid.moment[{i}]"), mass * p[i]);
            for j in 0..3 {
                let square = if i == j { p.iter().map(|x| x * x).sum() } else { 0.0 };
                add(format!("rigid.inertia[{i}][{j}]"), mass * (square - p[i] * p[j]));
            }
        }
    }
    for (found, wanted) in in_order(&evaluate(&kernels.force, &inputs), "out").iter().zip(wanted) {
        assert!(
            (found - wanted).abs() < 1e-14 * (1.0 + wanted.abs()),
            "{found} instead of {wanted}"
        );
    }
    let (force, tangent) = (&kernels.force, &kernels.tangent);
    assert_tangent(tangent, "mass", force, "out", &[origin, rate].concat(), &inputs);
    assert_tangent(tangent, "damping", force, "out", &spin, &inputs);
}
