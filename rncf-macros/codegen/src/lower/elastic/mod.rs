//! Elastic kernels of an element: force, tangent, energy and reference values, as a constant tensor
//! or by integration points, unrolled or in a loop.

mod conserving;
mod fields;
mod nodal;
mod particles;
mod points;
mod stress;
mod tensor;

use std::collections::HashMap;

pub use conserving::{Between, BetweenRule, conserving_kernels, conserving_obstacle};
pub use fields::{FieldBlocks, FieldKernels, FieldRule, Groups, field_kernels};

use crate::elements::{Element, Field, Library, NodalVector, Term, field_invariants};
use crate::lower::invariants::Blocks;
use crate::lower::kernel::{Kernel, PointLoop};
use crate::lower::quadratic::{base_vector, is_position};
use crate::lower::signature::Signature;
use crate::lower::variant::Variant;
use crate::model::Quadrature;
use crate::symbolic::{Array, Graph, Id, Invariant, linear::Vector};
use crate::tensors::Sampling;

/// How the strain energy is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Constant tensor, unrolled.
    Tensor,
    /// Integration points, unrolled.
    Points,
    /// Integration points in a loop.
    Loop,
    /// Integration points in a loop of the runtime, unrolled at one point as functions of the fields.
    Fields,
}

/// What a kernel computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Generalised elastic and damping force.
    Force,
    /// Its derivatives with respect to positions and velocities.
    Tangent,
    /// Strain energy.
    Energy,
    /// Values in the stress-free shape that the other kernels subtract.
    Reference,
}

/// The rule of terms that say none, exact or not.
pub fn points(element: &Element, quadrature: Quadrature) -> Sampling {
    Sampling::Gauss(match quadrature {
        Quadrature::Exact => element.default_points,
        Quadrature::Gauss(points) => points,
    })
}

/// The rules that the terms of the energy ask for, each once, in the order of the terms.
pub fn rules(variant: &Variant, element: &Element) -> Vec<Sampling> {
    let default = points(element, variant.quadrature);
    if variant.material.is_some() {
        // Gradients and strains of the axis are in one energy, so that two points are not enough.
        return vec![default];
    }
    let (_, terms) = element.terms_in(variant.dimension, &variant.options);
    let mut rules = Vec::new();
    for term in terms {
        let points = term.points.unwrap_or(default);
        if !rules.contains(&points) {
            rules.push(points);
        }
    }
    rules
}

/// Numbers that every element keeps for one of its points: what counts from the stress-free shape, which stands first, and
/// coefficients that vary. The terms are of a graph with these inner products.
fn kept_at_point(
    (variant, library): (&Variant, &Library),
    terms: &[Term],
    graph: &Graph,
    products: &[Id],
) -> [usize; 2] {
    let counted = terms.iter().map(|term| term.density.counted(graph, products).len());
    let measures = if variant.curved { counted.sum() } else { 0 };
    [measures, variant.varying_coefficients(library).len()]
}

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

/// A stress state: on which invariants, of which vectors, and what it adds up to.
struct State {
    invariants: Vec<Invariant>,
    stress: Vec<Id>,
    stiffness: Vec<Vec<Id>>,
    viscosity: Vec<Vec<Id>>,
    energy: Id,
}

struct Builder<'a> {
    variant: &'a Variant,
    library: &'a Library,
    element: &'a Element,
    /// Nodal vectors and fields in the plane or in space.
    nodal: Vec<&'a NodalVector>,
    declared: Vec<&'a Field>,
    form: Form,
    quantity: Quantity,
    graph: Graph,
    inverse_length: Id,
    length: Id,
    damping: Id,
    coefficients: HashMap<&'static str, Id>,
    /// Relative vectors and their rates.
    vectors: Vec<Vector>,
    rates: Vec<Vector>,
    /// The same vectors at both ends of a step, of a force between two states; `vectors` are then their mean.
    ends: Option<[Vec<Vector>; 2]>,
    /// What the averaged invariants are of: those vectors, or the fields at a point.
    averaged: Option<[Vec<Vector>; 2]>,
    force: Vec<Vector>,
    stiffness: Blocks,
    viscosity: Option<Blocks>,
    energy: Id,
    references: Vec<Id>,
    /// Constant tensors that the kernel reads.
    arrays: Vec<Array>,
    /// The rule whose terms are integrated.
    rule: Sampling,
    /// Measures at the points before.
    passed: usize,
    points: Option<PointLoop>,
}

impl<'a> Builder<'a> {
    fn new(variant: &'a Variant, library: &'a Library, form: Form, quantity: Quantity) -> Self {
        let element = variant.declaration(library);
        let mut graph = Graph::new();
        let length = graph.symbol("length");
        let one = graph.one();
        let inverse_length = graph.divide(one, length);
        graph.name(inverse_length, "inverse_length");
        let damping = graph.symbol("damping");
        let coefficients = element
            .coefficients
            .iter()
            .map(|c| (c.name, graph.input(c.name)))
            .chain([("", one)])
            .collect();
        let mut builder = Self {
            variant,
            library,
            element,
            nodal: variant.vectors(library),
            declared: element.fields_in(variant.dimension).collect(),
            form,
            quantity,
            inverse_length,
            length,
            damping,
            coefficients,
            vectors: Vec::new(),
            rates: Vec::new(),
            ends: None,
            averaged: None,
            force: Vec::new(),
            stiffness: Vec::new(),
            viscosity: None,
            energy: graph.zero(),
            references: Vec::new(),
            arrays: Vec::new(),
            rule: Sampling::Gauss(0),
            passed: 0,
            points: None,
            graph,
        };
        builder.vectors = builder.relative_vectors("");
        if variant.damped && matches!(quantity, Quantity::Force | Quantity::Tangent) {
            builder.rates = builder.relative_vectors("v_");
        }
        builder
    }

    /// Relative vectors from nodal ones: differences of positions over the length, slopes.
    fn relative_vectors(&mut self, prefix: &str) -> Vec<Vector> {
        let names = self.variant.component_names(self.library, prefix);
        let nodal: Vec<Vector> = names
            .iter()
            .map(|list| list.iter().map(|name| self.graph.symbol(name.clone())).collect())
            .collect();
        let base = base_vector(&self.nodal);
        let mut relative = Vec::new();
        for (index, vector) in self.nodal.iter().enumerate() {
            if index == base {
                continue;
            }
            if is_position(vector) {
                let difference = self.graph.subtract_vectors(&nodal[index], &nodal[base]);
                let scaled = self.graph.scale(self.inverse_length, &difference);
                let difference = self.difference(vector);
                for (c, &id) in scaled.iter().enumerate() {
                    self.graph
                        .name(id, format!("{prefix}{difference}_{}", ["x", "y", "z"][c]));
                }
                relative.push(scaled);
            } else {
                relative.push(nodal[index].clone());
            }
        }
        relative
    }

    /// Name of the position of a node relative to that of the base, over the length: `d`, of several `d_r1`.
    fn difference(&self, vector: &NodalVector) -> String {
        match self.nodal.iter().filter(|vector| is_position(vector)).count() {
            0..=2 => "d".to_string(),
            _ => format!("d_{}", vector.name),
        }
    }

    /// Lengths of the relative vectors in a straight, unstretched element.
    fn relative_lengths(&self) -> Vec<f64> {
        let base = base_vector(&self.nodal);
        let start = self.nodal[base].place.to_f64();
        let vectors = self.nodal.iter().enumerate().filter(|&(index, _)| index != base);
        vectors
            .map(|(_, vector)| {
                if is_position(vector) {
                    vector.place.to_f64() - start
                } else {
                    1.0
                }
            })
            .collect()
    }

    /// Names of the relative vectors for documentation and variables.
    fn relative_names(&self) -> Vec<String> {
        let base = base_vector(&self.nodal);
        let vectors = self.nodal.iter().enumerate().filter(|&(index, _)| index != base);
        vectors
            .map(|(_, vector)| {
                if is_position(vector) {
                    self.difference(vector)
                } else {
                    vector.name.to_string()
                }
            })
            .collect()
    }

    fn length_power(&mut self, power: i32) -> Id {
        if power >= 0 {
            self.graph.power(self.length, power)
        } else {
            self.graph.power(self.inverse_length, -power)
        }
    }

    fn reference_symbol(&mut self, index: usize) -> Id {
        while self.references.len() <= index {
            let next = self.references.len();
            let symbol = self.graph.symbol(format!("reference[{next}]"));
            self.references.push(symbol);
        }
        self.references[index]
    }

    /// Has the numbers of the tensors read from their arrays; the lengths of vectors are no such numbers.
    fn read_arrays(&mut self, outputs: &[(String, Id)]) {
        let lengths = self.relative_lengths();
        let products = lengths.iter().flat_map(|a| lengths.iter().map(move |b| a * b));
        let arrays = std::mem::take(&mut self.arrays);
        let roots = outputs.iter().map(|&(_, id)| id);
        self.graph.read_from(roots, arrays, &products.collect::<Vec<f64>>());
    }

    /// Back to nodal vectors, and the function around it.
    fn finish(mut self) -> Kernel {
        let outputs = match self.quantity {
            Quantity::Energy => vec![("*energy".to_string(), self.energy)],
            Quantity::Reference => self
                .references
                .iter()
                .enumerate()
                .map(|(index, &id)| (format!("reference[{index}]"), id))
                .filter(|(name, id)| !self.graph.is_input(*id, name))
                .collect(),
            Quantity::Force => self.nodal_force(),
            Quantity::Tangent => {
                let stiffness = std::mem::take(&mut self.stiffness);
                let mut outputs = self.nodal_blocks(&stiffness, "stiffness");
                if let Some(viscosity) = self.viscosity.take() {
                    outputs.extend(self.nodal_blocks(&viscosity, "damping_matrix"));
                }
                outputs
            }
        };
        self.read_arrays(&outputs);
        let signature = Signature {
            variant: self.variant,
            library: self.library,
            references: self.references.len(),
        };
        signature.elastic(self.form, self.quantity, self.graph, self.points, outputs)
    }
}
