//! Forces between two states: the work they do, their resultants, their derivative.

use super::model::base;
use super::{Inputs, Random, evaluate, fill, slope};
use crate::elements::Library;
use crate::lower::elastic::{conserving_kernels, conserving_obstacle, kernel};
use crate::lower::form::{Form, Quantity};
use crate::lower::{Kernel, Variant};
use crate::model::Evaluation;

fn variant(dimension: usize, curved: bool) -> Variant {
    let mut variant = Variant::of(&base(), &base().bodies[0], &Library::standard());
    variant.damped = false;
    (variant.dimension, variant.curved) = (dimension, curved);
    variant
}

/// Values of the symbols of a kernel of one state from those of a kernel of two.
fn at(prefix: &str, inputs: &Inputs) -> Inputs {
    let mut own = inputs.clone();
    for (name, value) in inputs {
        if let Some(name) = name.strip_prefix(prefix) {
            own.insert(name.to_string(), *value);
        }
    }
    own
}

fn forces(kernel: &Kernel, inputs: &Inputs, size: usize) -> Vec<f64> {
    let found = evaluate(kernel, inputs);
    (0..size).map(|place| found[&format!("force[{place}]")]).collect()
}

#[test]
fn the_work_is_the_change_of_energy_and_there_is_no_resultant() {
    let library = Library::standard();
    for (dimension, curved) in [(2, false), (3, false), (2, true)] {
        for form in [Form::Tensor, Form::Points] {
            let variant = variant(dimension, curved);
            let names: Vec<String> = variant.component_names(&library, "").concat();
            let [force, tangent] = conserving_kernels(&variant, &library, form, None).unwrap().kernels;
            let one = |quantity| kernel(&variant, &library, form, quantity).unwrap();
            let (elastic, energy) = (one(Quantity::Force), one(Quantity::Energy));
            let (mut inputs, mut random) = (Inputs::new(), Random(7));
            inputs.insert("length".to_string(), 0.8);
            for prefix in ["o_", "e_"] {
                for name in &names {
                    inputs.insert(format!("{prefix}{name}"), random.next());
                }
            }
            for kernel in [&force, &tangent] {
                fill(kernel, &mut inputs, &mut random);
            }
            let found = forces(&force, &inputs, names.len());
            // Work.
            let energies = ["o_", "e_"].map(|prefix| evaluate(&energy, &at(prefix, &inputs))["*energy"]);
            let change = energies[1] - energies[0];
            let value = |prefix: &str, place: usize| inputs[&format!("{prefix}{}", names[place])];
            let work: f64 = (0..names.len())
                .map(|place| found[place] * (value("e_", place) - value("o_", place)))
                .sum();
            assert!(
                (work - change).abs() < 1e-12 * energies[0].abs().max(energies[1].abs()),
                "{dimension} {form:?}: {work} instead of {change}"
            );
            // Sum of the forces on positions, and moment about the mean positions.
            let size = found.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
            for c in 0..dimension {
                let sum = found[c] + found[2 * dimension + c];
                assert!(sum.abs() < 1e-13 * size, "{sum}");
            }
            let mean = |place: usize| 0.5 * (value("o_", place) + value("e_", place));
            for c in 0..if dimension == 2 { 1 } else { 3 } {
                let (k, l) = ((c + dimension - 2) % dimension, (c + dimension - 1) % dimension);
                let moment: f64 = (0..4)
                    .map(|vector| vector * dimension)
                    .map(|first| mean(first + k) * found[first + l] - mean(first + l) * found[first + k])
                    .sum();
                assert!(moment.abs() < 1e-12 * size, "moment {moment}, forces {size}");
            }
            // Without a step it is the elastic force.
            let mut still = inputs.clone();
            for name in &names {
                still.insert(format!("e_{name}"), inputs[&format!("o_{name}")]);
            }
            let usual = forces(&elastic, &at("o_", &still), names.len());
            for (place, (found, usual)) in forces(&force, &still, names.len()).iter().zip(&usual).enumerate() {
                assert!((found - usual).abs() < 1e-12 * size, "{place}: {found} {usual}");
            }
            // The tangent is by the mean at a fixed start: twice that by the end.
            let entries = evaluate(&tangent, &inputs);
            for (column, name) in names.iter().enumerate() {
                let exact = slope(&force, &inputs, &format!("e_{name}"));
                for row in 0..names.len() {
                    let found = entries[&format!("stiffness[{}]", row * names.len() + column)];
                    let wanted = 2.0 * exact[&format!("force[{row}]")];
                    assert!((found - wanted).abs() < 1e-12 * (size + wanted.abs()), "{row} {column}");
                }
            }
        }
    }
}

#[test]
fn where_there_are_no_such_forces_the_reason_is_named() {
    let library = Library::standard();
    let mut exact = variant(3, false);
    exact.options[0] = 1;
    exact.evaluation = Evaluation::Points;
    let mut slack = variant(2, false);
    slack.options[1] = 1;
    let mut damped = variant(3, false);
    damped.damped = true;
    for (variant, what) in [
        (exact, "`bending = exact`"),
        (slack, "`slack = true`"),
        (damped, "damped"),
    ] {
        let text = conserving_obstacle(&variant, &library).unwrap();
        assert!(text.contains(what), "{text}");
        assert!(conserving_kernels(&variant, &library, Form::Points, None).is_none());
    }
}
