//! Forces between two states that conserve energy.
//!
//! Inner products I of an element's vectors q are quadratic, so that at the mean `m = (q0 + q1) / 2` of two states
//! `I'(m) (q1 - q0) = I(q1) - I(q0)` holds exactly. Where the energy U is quadratic in the inner products, so does
//! `dU/dI((I0 + I1) / 2) (I1 - I0) = U1 - U0`. The force
//!
//! ```text
//! F(q0, q1) = S_A((I(q0) + I(q1)) / 2) dI_A/dq(m),   S = dU/dI
//! ```
//!
//! therefore does exactly the work U1 - U0 over the step, at any size of it. Inner products do not change when all
//! vectors turn together, so that F has no moment about the mean positions: angular momentum stays, too (Simo and
//! Tarnow 1992 for St. Venant-Kirchhoff's material; Gonzalez 2000 for the discrete derivative).

use super::{Builder, Form, Quantity};
use crate::elements::{Density, Library};
use crate::lower::invariants::Invariant;
use crate::lower::kernel::Kernel;
use crate::lower::quadratic::field_invariants;
use crate::lower::signature::Signature;
use crate::lower::variant::Variant;
use crate::symbolic::{Graph, Id, linear::Vector};

/// The invariant, or its mean over two states.
pub(super) fn averaged_value(
    invariant: Invariant,
    graph: &mut Graph,
    vectors: &[Vector],
    averaged: Option<&[Vec<Vector>; 2]>,
) -> Id {
    let Some(ends) = averaged else {
        return invariant.value(graph, vectors);
    };
    let [start, end] = [0, 1].map(|at| invariant.value(graph, &ends[at]));
    let (half, sum) = (graph.number(0.5), graph.add(start, end));
    graph.multiply(half, sum)
}

/// Why no forces that conserve energy exist for an element, in words that follow its body's name; `None` where they do.
pub fn conserving_obstacle(variant: &Variant, library: &Library, form: Form) -> Option<String> {
    if variant.damped {
        return Some("is damped".to_string());
    }
    if variant.material.is_some() {
        return Some("has a material that is given by its energy per volume".to_string());
    }
    let element = variant.declaration(library);
    if !is_quadratic(variant, library) {
        let chosen = element.options.iter().zip(&variant.options);
        let chosen: Vec<String> = chosen
            .filter(|&(_, &choice)| choice != 0)
            .map(|(option, &choice)| format!("`{} = {}`", option.name, option.values[choice]))
            .collect();
        return Some(format!(
            "has an energy that is not quadratic in the inner products of its vectors ({})",
            chosen.join(", ")
        ));
    }
    (form == Form::Fields).then(|| {
        format!(
            "is made of the element `{}`, for which such forces are not derived",
            element.names[0]
        )
    })
}

/// Whether the strain energy is quadratic in the inner products of the fields.
fn is_quadratic(variant: &Variant, library: &Library) -> bool {
    let mut graph = Graph::new();
    let element = variant.declaration(library);
    let (fields, symbols) = field_invariants(&mut graph, element, variant.dimension);
    let terms = (element.energy)(&mut graph, &fields, &variant.options);
    let symbols: Vec<Id> = symbols.into_iter().map(|(_, symbol)| symbol).collect();
    terms.iter().all(|term| match term.density {
        Density::Measure(measure) => slopes(&mut graph, measure, &symbols).is_some(),
        Density::Law { .. } => false,
        Density::Energy(energy) => symbols.iter().all(|&symbol| {
            let slope = graph.partial(energy, symbol);
            slopes(&mut graph, slope, &symbols).is_some()
        }),
    })
}

/// Derivatives with respect to the symbols if all are numbers.
fn slopes(graph: &mut Graph, of: Id, symbols: &[Id]) -> Option<Vec<f64>> {
    let slope = |&symbol: &Id| {
        let derivative = graph.partial(of, symbol);
        graph.value(derivative)
    };
    symbols.iter().map(slope).collect()
}

/// Force between two states and its derivative, in a form that has one; `None` where
/// [`conserving_obstacle`] says why.
pub fn conserving_kernels(variant: &Variant, library: &Library, form: Form) -> Option<[Kernel; 2]> {
    if conserving_obstacle(variant, library, form).is_some() {
        return None;
    }
    let kernel = |quantity| {
        let mut builder = Builder::new(variant, library, form, quantity);
        builder.between_states();
        match form {
            Form::Tensor => builder.tensor()?,
            Form::Points | Form::Loop => builder.points(),
            Form::Fields => return None,
        }
        Some(builder.finish_between_states())
    };
    Some([kernel(Quantity::Force)?, kernel(Quantity::Tangent)?])
}

impl Builder<'_> {
    /// Takes the mean of two states for the vectors, and both states for their inner products.
    fn between_states(&mut self) {
        let ends = ["o_", "e_"].map(|prefix| self.relative_vectors(prefix));
        let half = self.graph.number(0.5);
        let pairs = ends[0].iter().zip(&ends[1]);
        self.vectors = pairs
            .map(|(start, end)| {
                let sum = self.graph.add_vectors(start, end);
                self.graph.scale(half, &sum)
            })
            .collect();
        self.averaged = Some(ends.clone());
        self.ends = Some(ends);
    }

    fn finish_between_states(mut self) -> Kernel {
        let outputs = match self.quantity {
            Quantity::Tangent => {
                let stiffness = std::mem::take(&mut self.stiffness);
                self.nodal_blocks(&stiffness, "stiffness")
            }
            _ => self.nodal_force(),
        };
        let signature = Signature {
            variant: self.variant,
            library: self.library,
            references: self.references.len(),
        };
        signature.between_states(self.form, self.quantity, self.graph, self.points, outputs)
    }
}
