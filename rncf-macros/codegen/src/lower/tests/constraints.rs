//! Constraints and forces of markers against differences in time and complex steps.

use super::model::moving;
use super::{Inputs, Random, assert_tangent, evaluate, fill};
use crate::lower::Kernel;
use crate::lower::constraints::{ConstraintKernels, constraint_kernels};
use crate::lower::forces::force_kernels;

fn names(word: &str, count: usize) -> Vec<String> {
    let places = (0..count).flat_map(|marker| (0..3).map(move |component| (marker, component)));
    places
        .map(|(marker, component)| format!("{word}[{marker}][{component}]"))
        .collect()
}

/// Markers on smooth paths: values and derivatives at a time.
fn path(t: f64) -> Inputs {
    let mut inputs = Inputs::from([("t".to_string(), t), ("model.gap".to_string(), 0.5)]);
    for marker in 0..3 {
        for component in 0..3 {
            let (phase, rate) = (0.7 * marker as f64 + 1.9 * component as f64, 0.8 + 0.2 * marker as f64);
            for derivative in 0..4 {
                let quarter = std::f64::consts::FRAC_PI_2 * derivative as f64;
                let value = rate.powi(derivative) * (rate * t + phase + quarter).sin();
                inputs.insert(format!("z[{marker}][{derivative}][{component}]"), value);
            }
        }
    }
    inputs
}

#[test]
fn levels_are_rates_of_each_other() {
    for kernels in constraint_kernels(&moving()) {
        for level in 0..3 {
            let (t, step) = (0.4, 1e-4);
            let [up, down] = [t + step, t - step].map(|t| evaluate(&kernels.levels[level], &path(t)));
            for (row, rate) in evaluate(&kernels.levels[level + 1], &path(t)) {
                let difference = (up[&row] - down[&row]) / (2.0 * step);
                assert!(
                    (difference - rate).abs() < 1e-6 * (1.0 + rate.abs()),
                    "{} {row}: {rate} instead of {difference}",
                    kernels.levels[level + 1].name
                );
            }
        }
    }
}

/// The rows, or their rates, as functions of `z[k][i]` and `velocity[k][i]`.
fn renamed(kernel: &Kernel) -> Kernel {
    let mut kernel = kernel.clone();
    let mut replacements = std::collections::HashMap::new();
    for marker in 0..3 {
        for component in 0..3 {
            for (derivative, word) in ["z", "velocity"].into_iter().enumerate() {
                let old = format!("z[{marker}][{derivative}][{component}]");
                let found = super::symbols(&kernel)
                    .iter()
                    .find(|(_, text)| *text == old)
                    .map(|&(id, _)| id);
                if let Some(id) = found {
                    let new = kernel.graph.symbol(format!("{word}[{marker}][{component}]"));
                    replacements.insert(id, new);
                }
            }
        }
    }
    for (_, id) in &mut kernel.outputs {
        *id = kernel.graph.substitute(*id, &replacements);
    }
    kernel
}

fn nonlinear(kernels: &[ConstraintKernels]) -> &ConstraintKernels {
    kernels.iter().find(|kernels| kernels.of == [1]).unwrap()
}

#[test]
fn gradients() {
    let model = moving();
    let kernels = constraint_kernels(&model);
    for kernels in &kernels {
        let count = model.constraints[kernels.of[0]].markers.len();
        let [rows, rates] = [0, 1].map(|level| renamed(&kernels.levels[level]));
        let mut inputs = Inputs::new();
        fill(&rates, &mut inputs, &mut Random(2));
        fill(&rows, &mut inputs, &mut Random(3));
        fill(&kernels.gradient, &mut inputs, &mut Random(4));
        assert_tangent(
            &kernels.gradient,
            "gradient",
            &rows,
            "rows",
            &names("z", count),
            &inputs,
        );
        // dC'/dz' = dC/dz
        assert_tangent(
            &kernels.gradient,
            "gradient",
            &rates,
            "rows",
            &names("velocity", count),
            &inputs,
        );
        if let Some(gradient) = &kernels.rate_gradient {
            assert_tangent(gradient, "gradient", &rates, "rows", &names("z", count), &inputs);
        }
    }
    let linear = &kernels[0];
    assert!(linear.rate_gradient.is_none() && linear.hessian.is_none());
    assert!(nonlinear(&kernels).rate_gradient.is_some());
}

#[test]
fn hessians() {
    let model = moving();
    let kernels = constraint_kernels(&model);
    let kernels = nonlinear(&kernels);
    let hessian = kernels.hessian.as_ref().unwrap();
    let (rows, size) = (model.constraints[1].rows.len(), 9);
    let mut inputs = Inputs::new();
    fill(hessian, &mut inputs, &mut Random(12));
    fill(&kernels.gradient, &mut inputs, &mut Random(13));
    inputs.insert("lambda[1]".to_string(), 0.7);
    let found = evaluate(hessian, &inputs);
    let mut largest = 0.0_f64;
    for (column, symbol) in names("z", 3).iter().enumerate() {
        let slopes = super::slope(&kernels.gradient, &inputs, symbol);
        for first in 0..size {
            let terms = (0..rows).map(|row| {
                let slope = slopes.get(&format!("gradient[{}]", row * size + first));
                inputs[&format!("lambda[{row}]")] * slope.copied().unwrap_or(0.0)
            });
            let wanted: f64 = terms.sum();
            let entry = found
                .get(&format!("hessian[{}]", first * size + column))
                .copied()
                .unwrap_or(0.0);
            assert!(
                (entry - wanted).abs() < 1e-12,
                "({first}, {column}): {entry} instead of {wanted}"
            );
            largest = largest.max(wanted.abs());
        }
    }
    assert!(largest > 0.1);
}

#[test]
fn what_differs_only_in_its_markers_is_one_function() {
    let kernels = constraint_kernels(&moving());
    let of: Vec<&[usize]> = kernels.iter().map(|kernels| &kernels.of[..]).collect();
    assert_eq!(of, [&[0, 2][..], &[1]]);
    assert!(kernels[0].levels[0].doc[0].contains("`pin`, `link`"));
}

#[test]
fn forces() {
    let model = moving();
    let kernels = force_kernels(&model);
    let mut random = Random(4);
    for kernels in &kernels[..2] {
        let tangent = kernels.tangent.as_ref().unwrap();
        let count = model.forces[kernels.of[0]].markers.len();
        let mut inputs = Inputs::new();
        fill(&kernels.force, &mut inputs, &mut random);
        fill(tangent, &mut inputs, &mut random);
        assert_tangent(tangent, "by_value", &kernels.force, "out", &names("z", count), &inputs);
        if count == 2 {
            assert_tangent(
                tangent,
                "by_velocity",
                &kernels.force,
                "out",
                &names("velocity", count),
                &inputs,
            );
        }
        if let Some(energy) = &kernels.energy {
            // The force is minus the gradient of its potential.
            let force = evaluate(&kernels.force, &inputs);
            let slope = super::slope(energy, &inputs, "z[0][0]")["*energy"];
            assert!((force["out[0]"] + slope).abs() < 1e-14 && slope != 0.0);
        }
    }
    assert!(kernels[2].tangent.is_none(), "a constant force has no tangent");
}
