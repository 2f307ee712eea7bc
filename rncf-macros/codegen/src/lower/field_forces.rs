//! Forces on the fields of an element at a point of its axis: what section forces follow from.

use std::collections::HashMap;

use super::kernel::Kernel;
use super::quadratic::length_power;
use super::signature::Signature;
use super::variant::Variant;
use crate::elements::{Density, Field, Invariants, Library, at_rest};
use crate::symbolic::{Graph, Id, Product, invariants as all_invariants, linear::Vector};
use crate::tensors::Sampling;

/// Symbols of the fields, one vector each.
fn symbols(graph: &mut Graph, name: &str, count: usize, dimension: usize) -> Vec<Vector> {
    let vector = |graph: &mut Graph, field: usize| {
        (0..dimension)
            .map(|c| graph.symbol(format!("{name}[{}]", field * dimension + c)))
            .collect()
    };
    (0..count).map(|field| vector(graph, field)).collect()
}

/// Inner products of vectors, as an energy takes them.
fn invariants(graph: &mut Graph, fields: &[Vector], dimension: usize) -> Invariants {
    type Product<'a> = dyn Fn(&mut Graph, &[Id], &[Id]) -> Id + 'a;
    let mut table = |product: &Product<'_>| -> Vec<Vec<Id>> {
        let row = |left: &Vector, graph: &mut Graph| fields.iter().map(|right| product(graph, left, right)).collect();
        fields.iter().map(|left| row(left, graph)).collect()
    };
    let dots = table(&|graph, a, b| graph.dot(a, b));
    let crosses = table(&|graph, a, b| {
        if dimension == 3 {
            return graph.zero();
        }
        let (left, right) = (graph.multiply(a[0], b[1]), graph.multiply(a[1], b[0]));
        graph.subtract(left, right)
    });
    Invariants {
        dimension,
        dots,
        crosses,
    }
}

/// Inner products that count from those of the stress-free shape, as an energy of a straight axis takes them.
fn from_stress_free(
    graph: &mut Graph,
    variant: &Variant,
    library: &Library,
    now: &Invariants,
    before: &HashMap<Id, Id>,
) -> Invariants {
    let dimension = variant.dimension;
    let fields: Vec<&Field> = variant.declaration(library).fields_in(dimension).collect();
    let mut products = now.clone();
    for invariant in all_invariants(fields.len(), dimension) {
        let (i, j) = (invariant.i, invariant.j);
        let mut shifted = |product: Id| {
            let reference = graph.substitute(product, before);
            let (change, rest) = (graph.subtract(product, reference), at_rest(invariant, &fields));
            let rest = graph.number(rest);
            graph.add(change, rest)
        };
        match invariant.product {
            Product::Dot => {
                let value = shifted(now.dots[i][j]);
                (products.dots[i][j], products.dots[j][i]) = (value, value);
            }
            Product::Cross => {
                let value = shifted(now.crosses[i][j]);
                (products.crosses[i][j], products.crosses[j][i]) = (value, graph.negate(value));
            }
        }
    }
    products
}

/// The same of a material with an energy: its kernel at a point, which takes derivatives on the unit element.
fn of_material(variant: &Variant, library: &Library) -> Kernel {
    let element = variant.declaration(library);
    let dimension = variant.dimension;
    let powers: Vec<i32> = element.fields_in(dimension).map(length_power).collect();
    let count = powers.len();
    let signature = Signature {
        variant,
        library,
        references: 0,
    };
    let scales: Vec<String> = powers
        .iter()
        .map(|power| format!("row.length.powi({})", -power))
        .collect();
    let mut inputs = vec!["fields"];
    if variant.curved {
        inputs.push("stress_free");
    }
    if variant.damped {
        inputs.push("rates");
    }
    let mut bindings = vec![format!("let scales = [{}];", scales.join(", "))];
    for input in inputs {
        bindings.push(format!(
            "let {input}: [[f64; {dimension}]; {count}] = \
             ::std::array::from_fn(|f| ::std::array::from_fn(|c| scales[f] * {input}[f * {dimension} + c]));"
        ));
    }
    let name = variant.name(library);
    bindings.push(format!("let mut sums = [[0.0; {dimension}]; {count}];"));
    bindings.push(format!(
        "{name}_{}_force(row, {}&fields, {}&mut sums);",
        Sampling::Gauss(element.default_points).word(),
        if variant.curved {
            "::rncf::emitted::array(stress_free.as_flattened()), "
        } else {
            ""
        },
        if variant.damped { "&rates, " } else { "" },
    ));
    bindings.push(format!(
        "for f in 0..{count} {{ for c in 0..{dimension} {{ \
         forces[f * {dimension} + c] = scales[f] * sums[f][c] / row.length; }} }}"
    ));
    let mut arguments = vec![format!("row: &{}", signature.row())];
    for name in ["stress_free", "fields", "rates"] {
        if name != "rates" || variant.damped {
            arguments.push(format!("{name}: &[f64; {}]", count * dimension));
        }
    }
    arguments.push(format!("forces: &mut [f64; {}]", count * dimension));
    Kernel {
        name: format!("{name}_field_forces"),
        doc: vec!["Writes the forces on the fields at a point, dU/d(field) per unit length.".to_string()],
        arguments,
        bindings,
        graph: Graph::new(),
        points: None,
        outputs: Vec::new(),
        assign: true,
    }
}

/// Writes dU/d(field) per unit length, all terms of the energy together.
pub fn field_forces_kernel(variant: &Variant, library: &Library) -> Kernel {
    if variant.material.is_some() {
        return of_material(variant, library);
    }
    let element = variant.declaration(library);
    let dimension = variant.dimension;
    let count = element.fields_in(dimension).count();
    let mut graph = Graph::new();
    let fields = symbols(&mut graph, "fields", count, dimension);
    let rates = symbols(&mut graph, "rates", count, dimension);
    let stress_free = symbols(&mut graph, "stress_free", count, dimension);
    let now = invariants(&mut graph, &fields, dimension);
    let before: Vec<(Id, Id)> = fields.concat().into_iter().zip(stress_free.concat()).collect();
    let before: HashMap<Id, Id> = before.into_iter().collect();
    let rates = fields.concat().into_iter().zip(rates.concat()).collect();
    let damping = graph.symbol("damping");
    let terms = (element.energy)(&mut graph, &now, &variant.options);
    let has_energy = terms.iter().any(|term| matches!(term.density, Density::Energy(_)));
    let counted = (variant.curved && has_energy).then(|| {
        let products = from_stress_free(&mut graph, variant, library, &now, &before);
        (element.energy)(&mut graph, &products, &variant.options)
    });
    let mut forces = vec![graph.zero(); count * dimension];
    for (at, term) in terms.into_iter().enumerate() {
        // What acts at nodes has no density.
        if matches!(term.points, Some(Sampling::Nodes(_))) {
            continue;
        }
        let coefficient = match term.coefficient {
            "" => graph.one(),
            name => graph.input(name),
        };
        let (density, stress) = match term.density {
            Density::Energy(density) => match counted.as_ref().map(|terms| terms[at].density) {
                Some(Density::Energy(density)) => (density, coefficient),
                _ => (density, coefficient),
            },
            Density::Viscous(measure) => {
                if !variant.damped {
                    continue;
                }
                let rate = graph.differentiate(measure, &rates);
                (measure, graph.multiply(coefficient, rate))
            }
            Density::Measure(measure) | Density::Undamped(measure) | Density::Law { measure, .. } => {
                let reference = graph.substitute(measure, &before);
                let change = graph.subtract(measure, reference);
                let rate = variant.damped.then(|| [graph.differentiate(measure, &rates), damping]);
                let stress = term.density.stress(&mut graph, change, rate);
                (measure, graph.multiply(coefficient, stress))
            }
        };
        for (force, &symbol) in forces.iter_mut().zip(fields.concat().iter()) {
            let slope = graph.partial(density, symbol);
            let part = graph.multiply(stress, slope);
            *force = graph.add(*force, part);
        }
    }
    let signature = Signature {
        variant,
        library,
        references: 0,
    };
    let mut arguments = vec![format!("row: &{}", signature.row())];
    let mut bindings = signature.bindings(true, &[]);
    if variant.varying {
        let names: Vec<&str> = variant
            .varying_coefficients(library)
            .iter()
            .map(|one| one.name)
            .collect();
        arguments.push(format!("coefficients: &[f64; {}]", names.len()));
        bindings.push(format!("let [{}] = *coefficients;", names.join(", ")));
    }
    for name in ["stress_free", "fields", "rates"] {
        if name != "rates" || variant.damped {
            arguments.push(format!("{name}: &[f64; {}]", count * dimension));
        }
    }
    arguments.push(format!("forces: &mut [f64; {}]", count * dimension));
    let names: Vec<&str> = element.fields_in(dimension).map(|field| field.name).collect();
    Kernel {
        name: format!("{}_field_forces", variant.name(library)),
        doc: vec![format!(
            "Writes the forces on the fields {} at a point, dU/d(field) per unit length, from their values in the \
             stress-free shape and at present.",
            names.join(", ")
        )],
        arguments,
        bindings,
        outputs: super::kernel::values(&forces, "forces"),
        graph,
        points: None,
        assign: true,
    }
}
