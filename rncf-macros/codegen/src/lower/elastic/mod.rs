//! Elastic kernels of an element: force, tangent, energy and reference values, as a constant tensor
//! or by integration points, unrolled or in a loop.

mod builder;
mod conserving;
mod fields;
mod nodal;
mod particles;
mod points;
mod stress;
mod tensor;

pub use conserving::{Between, BetweenRule, conserving_kernels, conserving_obstacle};
pub use fields::field_kernels;

use crate::elements::{Library, field_invariants};
use crate::lower::form::{Form, Quantity, points, rules};
use crate::lower::kernel::Kernel;
use crate::lower::variant::Variant;
use crate::symbolic::{Graph, Id};
use builder::{Builder, kept_at_point};

/// Numbers that every element keeps for all points of all rules, and where the coefficients that vary stand among them: first
/// place and point in [0, 1], one pair for each point. Of a material that is given by its energy the fields are kept.
pub fn kept(variant: &Variant, library: &Library) -> (usize, Vec<(usize, f64)>) {
    let element = variant.declaration(library);
    let default = points(element, variant.quadrature);
    let (mut passed, mut places) = (0, Vec::new());
    for rule in rules(variant, element) {
        let mut graph = Graph::new();
        let (declared, symbols) = field_invariants(&mut graph, element, variant.dimension);
        let mut terms = (element.energy)(&mut graph, &declared, &variant.options);
        terms.retain(|term| term.points.unwrap_or(default) == rule);
        let products: Vec<Id> = symbols.iter().map(|&(_, symbol)| symbol).collect();
        let [measures, coefficients] = kept_at_point((variant, library), &terms, &graph, &products);
        for xi in rule.rule().points {
            places.push((passed + measures, xi));
            passed += measures + coefficients;
        }
    }
    (passed, places)
}

/// The kernel of one quantity in one form; `None` where the form does not exist (a tensor of an
/// energy that is not quadratic; one loop over points of several rules; the form by
/// fields, see [`field_kernels`]).
pub fn kernel(variant: &Variant, library: &Library, form: Form, quantity: Quantity) -> Option<Kernel> {
    // Reference values are computed once, so that nothing is gained by a loop.
    let form = if (form, quantity) == (Form::Loop, Quantity::Reference) {
        Form::Points
    } else {
        form
    };
    if form == Form::Loop && rules(variant, variant.declaration(library)).len() > 1 {
        return None;
    }
    if form == Form::Tensor && variant.varying {
        return None;
    }
    let mut builder = Builder::new(variant, library, form, quantity);
    match form {
        Form::Tensor => builder.tensor()?,
        Form::Points | Form::Loop => builder.points(),
        Form::Fields => return None,
    }
    Some(builder.finish())
}
