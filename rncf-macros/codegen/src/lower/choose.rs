//! The cheapest form of the elastic kernels by counted operations (THEORY 4.3).

use super::elastic::{field_kernels, kept, kernel};
use super::form::{FieldKernels, Form, Quantity, rules};
use super::kernel::Kernel;
use super::signature::Signature;
use super::variant::Variant;
use crate::elements::Library;
use crate::model::Evaluation;
use crate::symbolic::Cost;

/// Unrolled code beyond this many operations in one function costs more compile time than it saves.
const UNROLL_LIMIT: usize = 3000;

/// A loop over points runs 1.3 times slower than its operations unrolled.
const LOOP_PENALTY: (usize, usize) = (13, 10);

/// The elastic kernels of a variant in the chosen form.
#[derive(Clone, Debug)]
pub struct ElasticKernels {
    /// Chosen form.
    pub form: Form,
    /// Force.
    pub force: Kernel,
    /// Tangent.
    pub tangent: Kernel,
    /// Energy.
    pub energy: Kernel,
    /// The kernels at a point that the others call, in the form by fields.
    pub fields: Option<FieldKernels>,
    /// Values in the stress-free shape, for curved axes.
    pub reference: Option<Kernel>,
    /// Numbers that every element keeps: those values, and coefficients that vary.
    pub kept: usize,
    /// The choice and what it was made from.
    pub choice: String,
}

/// From this many nodal vectors on unrolled elements are too long: loops win.
const FIELDS_FROM: usize = 6;

/// The kernels by fields, which an element of many vectors or with several rules has alone.
fn by_fields(variant: &Variant, library: &Library) -> ElasticKernels {
    let fields = field_kernels(variant, library);
    let reference = variant.curved.then(|| match variant.material {
        Some(_) => Signature::fields_before(variant, library, &fields),
        None => kernel(variant, library, Form::Points, Quantity::Reference).map(|kernel| (0, kernel)),
    });
    let reference = reference.flatten();
    let kept = match &reference {
        Some((count, _)) if variant.material.is_some() => *count,
        _ if variant.has_references() => kept(variant, library).0,
        _ => 0,
    };
    let reference = reference.map(|(_, kernel)| kernel);
    let signature = Signature {
        variant,
        library,
        references: kept,
    };
    let cost = |quantity| operations(fields.cost(quantity, variant.dimension));
    let choice = format!(
        "Form: {} (from {FIELDS_FROM} nodal vectors on; operations of force and tangent: {} and {}).",
        form_name(Form::Fields),
        cost(Quantity::Force),
        cost(Quantity::Tangent),
    );
    ElasticKernels {
        form: Form::Fields,
        force: signature.by_fields(Quantity::Force, &fields),
        tangent: signature.by_fields(Quantity::Tangent, &fields),
        energy: signature.by_fields(Quantity::Energy, &fields),
        fields: Some(fields),
        reference,
        kept,
        choice,
    }
}

/// Derives the kernels in every form and keeps the cheapest, or the one that the user asked for.
pub fn elastic_kernels(variant: &Variant, library: &Library) -> ElasticKernels {
    let element = variant.declaration(library);
    if variant.vectors(library).len() >= FIELDS_FROM || rules(variant, element).len() > 1 {
        return by_fields(variant, library);
    }
    let mut candidates = Vec::new();
    for form in [Form::Tensor, Form::Points, Form::Loop] {
        let force = kernel(variant, library, form, Quantity::Force);
        let tangent = kernel(variant, library, form, Quantity::Tangent);
        if let (Some(force), Some(tangent)) = (force, tangent) {
            candidates.push((form, force, tangent));
        }
    }
    let wanted = match variant.evaluation {
        Evaluation::Automatic => None,
        Evaluation::Tensor => Some(Form::Tensor),
        Evaluation::Points => Some(Form::Points),
        Evaluation::Loop => Some(Form::Loop),
    };
    let counts: Vec<String> = candidates
        .iter()
        .map(|(form, force, tangent)| {
            format!(
                "{}: {} and {}",
                form_name(*form),
                operations(force.cost()),
                operations(tangent.cost())
            )
        })
        .collect();
    let best = (0..candidates.len())
        .min_by_key(|&index| {
            let (form, force, tangent) = &candidates[index];
            let unwanted = wanted.is_some_and(|wanted| wanted != *form);
            let too_long = *form != Form::Loop && tangent.size() > UNROLL_LIMIT;
            let cost = (force.cost() + tangent.cost()).weighted();
            let cost = if *form == Form::Loop {
                cost * LOOP_PENALTY.0 / LOOP_PENALTY.1
            } else {
                cost
            };
            (unwanted, too_long, cost)
        })
        .unwrap_or(0);
    let (form, force, tangent) = candidates.swap_remove(best);
    let reason = match wanted {
        Some(wanted) if wanted == form => "as asked for",
        Some(_) => "the form asked for does not exist for this energy",
        None => "the cheapest",
    };
    let choice = format!(
        "Form: {} ({reason}; operations of force and tangent: {}; a loop counts 1.3 times).",
        form_name(form),
        counts.join("; ")
    );
    let reference = variant
        .curved
        .then(|| kernel(variant, library, form, Quantity::Reference))
        .flatten();
    let kept = match (&reference, form) {
        (Some(kernel), Form::Tensor) => kernel.outputs.len(),
        _ if variant.has_references() => kept(variant, library).0,
        _ => 0,
    };
    let energy = kernel(variant, library, form, Quantity::Energy).expect("a form that has a force has an energy");
    ElasticKernels {
        form,
        force,
        tangent,
        energy,
        fields: None,
        reference,
        kept,
        choice,
    }
}

fn form_name(form: Form) -> &'static str {
    match form {
        Form::Tensor => "constant tensor",
        Form::Points => "points unrolled",
        Form::Loop => "loop over points",
        Form::Fields => "fields at points",
    }
}

fn operations(cost: Cost) -> usize {
    cost.additions + cost.multiplications + cost.divisions + cost.functions
}
