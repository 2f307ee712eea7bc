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

use super::builder::Builder;
use crate::elements::field_invariants;
use crate::elements::{Density, Library};
use crate::lower::form::{FieldBlocks, FieldKernels, Form, Groups, Quantity, rules};
use crate::lower::kernel::Kernel;
use crate::lower::signature::Signature;
use crate::lower::variant::Variant;
use crate::symbolic::Invariant;
use crate::symbolic::{Graph, Id, linear::Vector};
use crate::tensors::Sampling;

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
pub fn conserving_obstacle(variant: &Variant, library: &Library) -> Option<String> {
    if variant.damped {
        return Some("is damped".to_string());
    }
    if variant.material.is_some() {
        return Some("has a material that is given by its energy per volume".to_string());
    }
    let element = variant.declaration(library);
    if is_quadratic(variant, library) {
        return None;
    }
    let chosen = element.options.iter().zip(&variant.options);
    let chosen: Vec<String> = chosen
        .filter(|&(_, &choice)| choice != 0)
        .map(|(option, &choice)| format!("`{} = {}`", option.name, option.values[choice]))
        .collect();
    let chosen = match chosen.as_slice() {
        [] => String::new(),
        chosen => format!(" ({})", chosen.join(", ")),
    };
    Some(format!(
        "has an energy that is not quadratic in the inner products of its vectors{chosen}"
    ))
}

/// Whether the strain energy is quadratic in the inner products of the fields.
fn is_quadratic(variant: &Variant, library: &Library) -> bool {
    let mut graph = Graph::new();
    let element = variant.declaration(library);
    let (fields, symbols) = field_invariants(&mut graph, element, variant.dimension);
    let terms = (element.energy)(&mut graph, &fields, &variant.options);
    let symbols: Vec<Id> = symbols.into_iter().map(|(_, symbol)| symbol).collect();
    terms.iter().all(|term| match term.density {
        Density::Measure(measure) | Density::Undamped(measure) => slopes(&mut graph, measure, &symbols).is_some(),
        Density::Law { .. } | Density::Viscous(_) => false,
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

/// Force between two states and its derivative.
#[derive(Clone, Debug)]
pub struct Between {
    /// Of an element: force and derivative.
    pub kernels: [Kernel; 2],
    /// What these call at the points, in the form by fields.
    pub rules: Vec<BetweenRule>,
}

/// Kernels at a point of a rule, in the form by fields.
#[derive(Clone, Debug)]
pub struct BetweenRule {
    /// Its points.
    pub points: Sampling,
    /// Force and derivative.
    pub kernels: [Kernel; 2],
    /// Blocks that the derivative writes.
    pub blocks: FieldBlocks,
    /// Values in the stress-free shape at a point.
    pub references: usize,
}

/// Force between two states and its derivative, in the form that the elastic kernels have; `None` where
/// [`conserving_obstacle`] says why. `fields` are the kernels of the form by fields.
pub fn conserving_kernels(
    variant: &Variant,
    library: &Library,
    form: Form,
    fields: Option<&FieldKernels>,
) -> Option<Between> {
    if conserving_obstacle(variant, library).is_some() {
        return None;
    }
    if let Some(fields) = fields {
        let rules: Vec<BetweenRule> = rules(variant, variant.declaration(library))
            .into_iter()
            .map(|points| between_rule(variant, library, &fields.groups, points))
            .collect();
        let kernels = [Quantity::Force, Quantity::Tangent].map(|quantity| {
            let references = rules.iter().map(|rule| rule.references * rule.points.count()).sum();
            let signature = Signature {
                variant,
                library,
                references,
            };
            let mut kernel = signature.between_states(Form::Fields, quantity, Graph::new(), None, Vec::new());
            kernel.bindings = calls(variant, library, quantity, fields, &rules);
            kernel
        });
        return Some(Between { kernels, rules });
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
    Some(Between {
        kernels: [kernel(Quantity::Force)?, kernel(Quantity::Tangent)?],
        rules: Vec::new(),
    })
}

fn between_rule(variant: &Variant, library: &Library, groups: &Groups, points: Sampling) -> BetweenRule {
    let point = |quantity| {
        let mut builder = Builder::new(variant, library, Form::Fields, quantity);
        builder.rule = points;
        builder.point_between_states(groups)
    };
    let ((force, ..), (tangent, blocks, references)) = (point(Quantity::Force), point(Quantity::Tangent));
    BetweenRule {
        points,
        kernels: [force, tangent],
        blocks: blocks.unwrap_or(FieldBlocks {
            pairs: Vec::new(),
            tiles: Vec::new(),
        }),
        references,
    }
}

/// Statements that sum over the points of all rules.
fn calls(
    variant: &Variant,
    library: &Library,
    quantity: Quantity,
    fields: &FieldKernels,
    rules: &[BetweenRule],
) -> Vec<String> {
    let upper = variant.name(library).to_uppercase();
    let is_tangent = quantity == Quantity::Tangent;
    let [dd, ss] = [variant.dimension, fields.groups.size()].map(|size| size * size);
    let mut out: Vec<String> = ["start", "end"]
        .map(|state| format!("let {state} = {upper}_VECTORS.relative(row.length, {state});"))
        .into();
    out.push(if is_tangent {
        format!("let mut tiles = [[[0.0; {ss}]; {dd}]; {}];", fields.tiles(false))
    } else {
        "let mut sums = Default::default();".to_string()
    });
    let mut passed = 0;
    for rule in rules {
        let (at, count) = (rule.points.table_of(&upper), rule.references);
        let reference = if variant.has_references() {
            format!("::rncf::emitted::array(&reference[{passed} + {count} * point..][..{count}]), ")
        } else {
            String::new()
        };
        passed += count * rule.points.count();
        let kernel = &rule.kernels[usize::from(is_tangent)].name;
        out.push(if is_tangent {
            format!(
                "{at}.tangent_between(&start, &end, (&{at}_BETWEEN, &mut tiles), \
                 |point, start, end, stiffness| {kernel}(row, {reference}start, end, stiffness));"
            )
        } else {
            format!(
                "{at}.force(&start, &end, |point, start, end, forces| {kernel}(row, {reference}start, end, forces), \
                 &mut sums);"
            )
        });
    }
    out.push(if is_tangent {
        format!("{upper}_VECTORS.add_general(row.length, &tiles, stiffness);")
    } else {
        format!("{upper}_VECTORS.add_force(row.length, &sums, force);")
    });
    out
}

impl Builder<'_> {
    /// The kernel of one quantity at a point of the rule, its blocks and number of reference values.
    fn point_between_states(mut self, groups: &Groups) -> (Kernel, Option<FieldBlocks>, usize) {
        let [[start_inputs, start], [end_inputs, end]] = ["o_", "e_"].map(|prefix| self.field_symbols(prefix));
        let inputs = self.means(&start_inputs, &end_inputs);
        let fields = self.means(&start, &end);
        self.averaged = Some([start, end]);
        let mut state = self.field_state(&fields, &[], self.length);
        self.on_unit_element(&mut state);
        self.averaged = Some([start_inputs, end_inputs]);
        let on_fields = self.respond(&state, &inputs, &[]);
        let used: Vec<usize> = (0..fields.len())
            .filter(|&field| state.invariants.iter().any(|it| it.i == field || it.j == field))
            .collect();
        let group_of: Vec<usize> = used
            .iter()
            .map(|&field| groups.group(self.declared[field].of))
            .collect();
        let (outputs, blocks, _) = self.field_outputs(&on_fields, &used, (&group_of, groups.of.len()));
        let names: Vec<&str> = used.iter().map(|&field| self.declared[field].name).collect();
        let inputs = ["o_", "e_"].map(|prefix| self.input_names(prefix, &used));
        let references = self.references.len();
        let signature = Signature {
            variant: self.variant,
            library: self.library,
            references,
        };
        let count = blocks.as_ref().map_or(0, |blocks| blocks.pairs.len());
        let (points, quantity, graph) = (self.rule, self.quantity, self.graph);
        let kernel = signature.point_between_states((points, quantity), graph, outputs, (&names, &inputs, count));
        (kernel, blocks, references)
    }

    /// Means of vectors.
    fn means(&mut self, start: &[Vector], end: &[Vector]) -> Vec<Vector> {
        let half = self.graph.number(0.5);
        let pairs = start.iter().zip(end);
        pairs
            .map(|(start, end)| {
                let sum = self.graph.add_vectors(start, end);
                self.graph.scale(half, &sum)
            })
            .collect()
    }

    /// Takes the mean of two states for the vectors, and both states for their inner products.
    fn between_states(&mut self) {
        let ends = ["o_", "e_"].map(|prefix| self.relative_vectors(prefix));
        self.vectors = self.means(&ends[0], &ends[1]);
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
        self.read_arrays(&outputs);
        let signature = Signature {
            variant: self.variant,
            library: self.library,
            references: self.references.len(),
        };
        signature.between_states(self.form, self.quantity, self.graph, self.points, outputs)
    }
}
